// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_CUT_RESTRICTION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_CUT_RESTRICTION_H

#include <CGAL/Spectral_segmentation/internal/multilevel/Cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/multilevel/Longest_edge_bisection.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Restricts the cuts of a refined mesh to the mesh that was refined: a face that a cut crosses gets
// the side that has most of it.
class Cut_restriction : private Cut_transfer
{
  const Refined_mesh& refined_;
  std::vector<std::array<double, 2> > areas_; // of each face, on both sides; 0 between cuts

  void set_sides(std::size_t node, const Cells& cells) override
  {
    for (int side : {0, 1})
      for (Index f : other_faces_[cuts_.nodes[node].children[side]])
        areas_[refined_.faces[f]][side] += refined_.graph.areas[f];
    for (Index cell : cells) {
      const std::array<double, 2>& areas = areas_[cells_.first_face(cell)];
      side_[cell] = areas[1] > areas[0] ? REST : Q;
    }
    for (int side : {0, 1})
      for (Index f : other_faces_[cuts_.nodes[node].children[side]])
        areas_[refined_.faces[f]] = {0, 0};
  }

  Index face_of(Index refined_face) const override { return refined_.faces[refined_face]; }

public:
  Cut_restriction(Execution execution, const Cut_hierarchy& cuts, const Refined_mesh& refined,
                  const Face_graph& mesh, Run_monitor& monitor)
    : Cut_transfer(execution, cuts, mesh, std::vector<char>(mesh.number_of_faces(), 1), monitor),
      refined_(refined), areas_(mesh.number_of_faces())
  {}

  Cut_hierarchy operator()() { return transfer([] {}); }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_CUT_RESTRICTION_H
