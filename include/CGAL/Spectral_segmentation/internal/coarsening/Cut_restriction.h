// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_CUT_RESTRICTION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_CUT_RESTRICTION_H

#include <CGAL/Spectral_segmentation/internal/coarsening/Connected_cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/Longest_edge_bisection.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Restricts the cuts of a refined mesh to the mesh that was refined. A face has the side of all
// refined faces that it holds. The faces that a cut crosses have no sure side.
class Cut_restriction : private Connected_cut_transfer
{
  const Refined_mesh& refined_;
  std::vector<std::array<double, 2> > areas_; // the area of each face on both sides; 0 between cuts
  Sides larger_side_;                         // one per cell, by the current cut

  // Returns whether a cut may cross each face or run along one of its edges. It may do so
  // everywhere if there might be more cuts, because a cut must not depend on later cuts.
  static std::vector<char> are_between(const Cut_hierarchy& cuts, const Refined_mesh& refined,
                                       const Surface& mesh)
  {
    std::vector<char> result(mesh.number_of_faces(), 1);
    if (!cuts.is_monotonic)
      return result;
    std::vector<Index> leaf(mesh.number_of_faces(), null_index);
    for (Index f = 0; f < refined.faces.size(); ++f)
      add_leaf(cuts.leaf[f], leaf[refined.faces[f]]);
    for (Index f = 0; f < leaf.size(); ++f) {
      result[f] = leaf[f] == several;
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        result[f] = result[f] || leaf[mesh.neighbor(h)] != leaf[f];
    }
    return result;
  }

  bool set_sure_sides(std::size_t node, const Cells& cells) override
  {
    const auto& children = cuts_.nodes[node].children;
    for (int side : {0, 1})
      for (Index f : other_faces_[children[side]])
        areas_[refined_.faces[f]][side] += refined_.graph.areas[f];
    bool has_sure[2] = {false, false};
    for (Index cell : cells) {
      const auto [of_q, of_rest] = areas_[cells_.first_face(cell)];
      larger_side_[cell] = of_rest > of_q ? REST : Q;
      const bool is_crossed = !cells_.is_core(cell) && of_q > 0 && of_rest > 0;
      side_[cell] = is_crossed ? static_cast<char>(BETWEEN) : larger_side_[cell];
      if (!is_crossed)
        has_sure[int(side_[cell])] = true;
    }
    for (int side : {0, 1})
      for (Index f : other_faces_[children[side]])
        areas_[refined_.faces[f]] = {0, 0};
    return has_sure[0] && has_sure[1];
  }

  void set_other_sides(std::size_t, const Cells& cells) override
  {
    for (Index cell : cells)
      side_[cell] = larger_side_[cell];
  }

  Index face_of(Index refined_face) const override { return refined_.faces[refined_face]; }

public:
  Cut_restriction(Execution execution, const Cut_hierarchy& cuts, const Refined_mesh& refined,
                  const Surface& mesh, const Distance_weights& weights, Run_monitor& monitor)
    : Connected_cut_transfer(execution, cuts, mesh, are_between(cuts, refined, mesh), weights,
                             monitor),
      refined_(refined), areas_(mesh.number_of_faces()), larger_side_(cells_.number())
  {}

  using Connected_cut_transfer::operator();
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_CUT_RESTRICTION_H
