// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_NODE_CLASSES_H
#define CGAL_SPECTRAL_SEGMENTATION_NODE_CLASSES_H

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/read/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {

/*!
\ingroup PkgSpectralSegmentationRef

Experimental: returns a class for each node of a hierarchy, numbered from 0 in the order of their
first nodes.

Nodes of one class may be copies or mirror images of each other: their areas, and the standard
deviations of their points along the principal axes, differ by at most 15 % from the
largest. Therefore any segments that are chosen from the hierarchy have their classes, without a
look at the mesh. `segment_adjacency_graph()` has the classes of the segments of a mesh.

The time is O(*n* + *m k*) for *n* triangles, *m* nodes and *k* classes.

\tparam PointRange a range of points `p` with coordinates `p[0]`, `p[1]` and `p[2]`
\tparam TriangleRange a range of ranges of three integers

\param hierarchy the hierarchy, which may have been changed by hand
\param points the points of the run
\param triangles the indices of the three corner points of each triangle of the run

\throws std::invalid_argument if there is another number of triangles than the hierarchy has faces,
  a triangle does not have three corners, a corner is not the index of a point, or a coordinate of a
  corner is not finite
*/
template <class PointRange, class TriangleRange>
std::vector<std::size_t> node_classes(const Segmentation_hierarchy& hierarchy,
                                      const PointRange& points, const TriangleRange& triangles)
{
  const internal::Surface soup = internal::read_triangle_soup(points, triangles, "node_classes");
  internal::check_number_of_faces(soup.corners.size(), hierarchy.number_of_faces());
  const internal::Cut_hierarchy& cuts = internal::Hierarchy_access::cuts(hierarchy);
  std::vector<internal::Moments> moments = internal::segment_moments(
    soup.points, soup.corners, cuts.leaf, hierarchy.number_of_nodes());
  const std::vector<std::size_t> order = internal::parents_first(cuts);
  for (std::size_t k = order.size(); k-- > hierarchy.number_of_roots();)
    moments[hierarchy.node(order[k]).parent] += moments[order[k]];
  return internal::congruence_classes(moments);
}

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_NODE_CLASSES_H
