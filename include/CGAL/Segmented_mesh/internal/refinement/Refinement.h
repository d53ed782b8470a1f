// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_REFINEMENT_H
#define CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_REFINEMENT_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// The splits of the faces of a mesh, with which smooth curves separate its segments.
//
// A point on an edge cuts the edge into two halves. The side of a face along its edge i is the
// halves 2i, at corner i, and 2i+1, at the next corner. If there is no point, both have one label.
struct Refinement
{
  struct Edge_point
  {
    Index halfedge;  // 3f+i is the i-th edge of face f
    double position; // 0 at its source, 1 at its target
  };

  // The new faces are triangles with a common apex.
  struct Split_face
  {
    Index face;
    std::array<Index, 3> points; // one per edge; `null_index` if it has none
    int apex;                    // the edge whose point it is, or `centroid`
    std::array<Index, 6> labels; // one per half, and so per new face along it
  };

  static constexpr int centroid = 3; // a new vertex there

  std::vector<Edge_point> points;
  std::vector<Split_face> split_faces;
  std::vector<std::pair<Index, Index> > other_labels; // faces that are not split, with their labels
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_REFINEMENT_H
