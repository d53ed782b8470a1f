// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_PROJECTION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_PROJECTION_H

#include <CGAL/Spectral_segmentation/internal/bipartition/min_cut_refinement.h>
#include <CGAL/Spectral_segmentation/internal/distances/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/mesh/extract_part.h>
#include <CGAL/Spectral_segmentation/internal/mesh/surface_integrals.h>
#include <CGAL/Spectral_segmentation/internal/multilevel/Cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/multilevel/coarsening.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Projects the cuts of a coarse mesh onto the mesh that was coarsened. A face gets the side shared
// by all coarse faces around the images of its vertices. The faces between, which have no unique
// side, are a band around the cut; it is split by a minimum cut or, if no face of a side is sure,
// by region growing from the faces that survived the coarsening.
class Cut_projection : private Cut_transfer
{
  const Coarse_mesh& coarse_;
  const Distance_weights& weights_;
  Face_graph bands_;
  std::vector<char> sides_around_; // of each coarse vertex, as bits; 0 between cuts

  // What the images of the corners have.
  template <class Value>
  static std::array<Value, 3> values_at(const std::vector<Value>& of_vertex,
                                        const Coarse_mesh& coarse, const Corners& corners)
  {
    const auto value = [&](Index v) { return of_vertex[coarse.vertices[v]]; };
    return {value(corners[0]), value(corners[1]), value(corners[2])};
  }

  // Whether a face may be between the sides of any cut. All may if there might be more cuts: a cut
  // must not depend on those after it.
  static std::vector<char> are_between(Execution execution, const Cut_hierarchy& cuts,
                                       const Coarse_mesh& coarse, const Face_graph& mesh)
  {
    std::vector<char> result(mesh.number_of_faces(), 1);
    if (!cuts.is_ultrametric)
      return result;
    constexpr Index several = null_index - 1;
    const std::vector<Index>& leaf = cuts.leaf;
    std::vector<Index> of_vertex(coarse.graph.points.size(), null_index);
    for (Index f = 0; f < leaf.size(); ++f)
      for (Index v : coarse.graph.corners[f])
        of_vertex[v] = of_vertex[v] == null_index || of_vertex[v] == leaf[f] ? leaf[f] : several;
    for_each_index(execution, result.size(), [&](std::size_t f) {
      const auto [a, b, c] = values_at(of_vertex, coarse, mesh.corners[f]);
      result[f] = a == several || a != b || a != c;
    });
    return result;
  }

  void set_bands()
  {
    bands_ = Part_extractor(mesh_)(cells_.faces_of_bands());
    if (monitor_.is_stopped()) // sides grow then, for which no distances are needed
      return;
    Distance_weights weights = weights_;
    const double area = total_area(bands_); // to which the radius is relative
    weights.concavity_radius *= area > 0 ? std::sqrt(total_area(mesh_) / area) : 0;
    set_face_distances(execution_, bands_, bands_.points,
                       face_normals(execution_, bands_, bands_.points), weights);
  }

  // Gives each cell of a part its side or BETWEEN. Tells whether there are sure cells on either
  // side.
  bool set_sure_sides(std::size_t node, const Cells& cells)
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

  // Splits what is BETWEEN by the minimum cut. Needs sure cells on both sides.
  void divide_band(const Cells& cells)
  {
    const std::size_t number = cells_.faces_of_bands().size();
    Sides side(side_.begin(), side_.begin() + static_cast<std::ptrdiff_t>(number));
    std::vector<Index> band;
    for (Index cell : cells)
      if (side_[cell] == BETWEEN) {
        CGAL_assertion(!cells_.is_core(cell));
        side[cell] = Q;
        band.push_back(cell);
      }
    side = minimum_cut_within(bands_, band, side);
    for (Index cell : band)
      side_[cell] = side[cell];
  }

  // Splits what is BETWEEN by region growing, from the sure cells and from the faces that survived
  // the coarsening, which have the side of what is left of them.
  void grow_sides(std::size_t node, const Cells& cells)
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

  void set_sides(std::size_t node, const Cells& cells) override
  {
    if (set_sure_sides(node, cells) && !bands_.weights.empty())
      divide_band(cells);
    else
      grow_sides(node, cells);
  }

  Index face_of(Index coarse_face) const override { return coarse_.faces[coarse_face]; }

public:
  Cut_projection(Execution execution, const Cut_hierarchy& cuts, const Coarse_mesh& coarse,
                 const Face_graph& mesh, const Distance_weights& weights, Run_monitor& monitor)
    : Cut_transfer(execution, cuts, mesh, are_between(execution, cuts, coarse, mesh), monitor),
      coarse_(coarse), weights_(weights), sides_around_(coarse.graph.points.size(), 0)
  {}

  // The hierarchy on the mesh. Once the caller has stopped the run, sides grow in place of minimum
  // cuts.
  Cut_hierarchy operator()() { return transfer([this] { set_bands(); }); }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_PROJECTION_H
