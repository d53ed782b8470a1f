// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_PROJECTION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_PROJECTION_H

#include <CGAL/Spectral_segmentation/internal/coarsening/Connected_cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/coarsening.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Projects the cuts of a coarse mesh onto the mesh that was coarsened. A face gets the side shared
// by all coarse faces around the images of its vertices; other faces have no sure side.
class Cut_projection : private Connected_cut_transfer
{
  const Coarse_surface& coarse_;
  std::vector<char> sides_around_; // as bits, one per coarse vertex; 0 between cuts

  // Returns the values of the images of the corners.
  template <class Value>
  static std::array<Value, 3> values_at(const std::vector<Value>& of_vertex,
                                        const Coarse_surface& coarse, const Corners& corners)
  {
    const auto value = [&](Index v) { return of_vertex[coarse.vertices[v]]; };
    return {value(corners[0]), value(corners[1]), value(corners[2])};
  }

  // Returns whether each face may be between the sides of any cut. All may if there might be more
  // cuts, because a cut must not depend on later cuts.
  static std::vector<char> are_between(Execution execution, const Cut_hierarchy& cuts,
                                       const Coarse_surface& coarse, const Surface& mesh)
  {
    std::vector<char> result(mesh.number_of_faces(), 1);
    if (!cuts.is_monotonic)
      return result;
    std::vector<Index> of_vertex(coarse.graph.points.size(), null_index);
    for (Index f = 0; f < cuts.leaf.size(); ++f)
      for (Index v : coarse.graph.corners[f])
        add_leaf(cuts.leaf[f], of_vertex[v]);
    for_each_index(execution, result.size(), [&](std::size_t f) {
      const auto [a, b, c] = values_at(of_vertex, coarse, mesh.corners[f]);
      result[f] = a == several || a != b || a != c;
    });
    return result;
  }

  bool set_sure_sides(std::size_t node, const Cells& cells) override
  {
    const auto add_sides = [&](bool are_set) {
      for (Index s : {Q, REST})
        for (Index f : other_faces_[cuts_.nodes[node].children[s]])
          for (Index v : coarse_.graph.corners[f])
            sides_around_[v] = are_set ? static_cast<char>(sides_around_[v] | (1 << s)) : 0;
    };
    add_sides(true);
    int all = 0;
    for (Index cell : cells) {
      const Corners& corners = mesh_.corners[cells_.first_face(cell)];
      const auto [a, b, c] = values_at(sides_around_, coarse_, corners);
      const int sides = a | b | c;
      // A cell that an earlier cut moved to keep a part connected may touch no coarse face of this
      // node (0). Any side will do: keep_largest() corrects it.
      side_[cell] = sides == 3 ? BETWEEN : sides == 2 ? REST : Q;
      if (sides != 3)
        all |= sides;
    }
    add_sides(false);
    return all == 3;
  }

  // Grows regions from the sure cells and from the faces that survived the coarsening, which have
  // the side of their coarse faces.
  void set_other_sides(std::size_t node, const Cells& cells) override
  {
    std::vector<Index> reached;
    for (Index cell : cells)
      if (side_[cell] != BETWEEN)
        reached.push_back(cell);
    for (char s : {Q, REST})
      for (Index f : other_faces_[cuts_.nodes[node].children[int(s)]]) {
        const Index left = cells_.of_face(coarse_.faces[f]);
        if (side_[left] == BETWEEN) {
          side_[left] = s;
          reached.push_back(left);
        }
      }
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const char side = side_[reached[i]];
      for (Index cell : cells_.neighbors(reached[i]))
        if (side_[cell] == BETWEEN) {
          side_[cell] = side;
          reached.push_back(cell);
        }
    }
    for (Index cell : cells)
      if (side_[cell] == BETWEEN) // nothing was reached
        side_[cell] = REST;
  }

  Index face_of(Index coarse_face) const override { return coarse_.faces[coarse_face]; }

public:
  Cut_projection(Execution execution, const Cut_hierarchy& cuts, const Coarse_surface& coarse,
                 const Surface& mesh, const Distance_weights& weights, Run_monitor& monitor)
    : Connected_cut_transfer(execution, cuts, mesh, are_between(execution, cuts, coarse, mesh),
                             weights, monitor),
      coarse_(coarse), sides_around_(coarse.graph.points.size(), 0)
  {}

  using Connected_cut_transfer::operator();
};

// Returns the cuts of a surface that has the same faces in another order.
inline Cut_hierarchy reordered(const Cut_hierarchy& cuts, const Coarse_surface& other,
                               const Surface& mesh)
{
  std::vector<std::size_t> number(cuts.nodes.size()); // the new index of each node
  std::iota(number.begin(), number.end(), std::size_t(0));
  for (Index f = 0; f < other.faces.size(); ++f)
    number[other.graph.components[f]] = mesh.components[other.faces[f]];
  Cut_hierarchy result = renumbered(cuts, number);
  const std::vector<Index> leaf = result.leaf; // one per face of the other surface
  for (Index f = 0; f < other.faces.size(); ++f)
    result.leaf[other.faces[f]] = leaf[f];
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_PROJECTION_H
