// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SPLIT_TRIANGLES_H
#define CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SPLIT_TRIANGLES_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/refinement/Refinement.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <array>

namespace CGAL::Segmented_mesh::internal {

// Splits the faces of a surface. Calls add_point(f, weights) for each new vertex, which lies in
// face f at the mean of its corners with these weights, and add_triangle(f, corners, label) for
// each part of face f. New vertices have numbers from the number of vertices on.
template <class AddPoint, class AddTriangle>
void split_triangles(const Surface& surface, const Refinement& refinement,
                     const AddPoint& add_point, const AddTriangle& add_triangle)
{
  typedef std::array<double, 3> Weights;
  const Index first = static_cast<Index>(surface.points.size());
  for (const Refinement::Edge_point& p : refinement.points) {
    Weights weights = {0, 0, 0};
    weights[p.halfedge % 3] = 1 - p.position;
    weights[(p.halfedge + 1) % 3] = p.position;
    add_point(p.halfedge / 3, weights);
  }
  Index next_centroid = first + static_cast<Index>(refinement.points.size());
  for (const Refinement::Split_face& s : refinement.split_faces) {
    const Corners& c = surface.corners[s.face];
    const Index apex =
      s.apex == Refinement::centroid ? next_centroid++ : first + s.points[s.apex];
    if (s.apex == Refinement::centroid)
      add_point(s.face, Weights{1. / 3, 1. / 3, 1. / 3});
    for (int i = 0; i < 3; ++i) {
      const bool has_point = s.points[i] != null_index;
      const Index source = c[i], target = c[(i + 1) % 3];
      const Index middle = has_point ? first + s.points[i] : target;
      if (source != apex && middle != apex)
        add_triangle(s.face, Corners{source, middle, apex}, s.labels[2 * i]);
      if (has_point && middle != apex)
        add_triangle(s.face, Corners{middle, target, apex}, s.labels[2 * i + 1]);
    }
  }
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SPLIT_TRIANGLES_H
