// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_CLOSE_SEGMENTS_H
#define CGAL_SEGMENTED_MESH_CLOSE_SEGMENTS_H

#include <CGAL/Segmented_mesh/Closed_segment.h>
#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/closed_solid.h>
#include <CGAL/Segmented_mesh/internal/read_segments.h>
#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSpectralSegmentationRef

appends triangles that close each segment of a range of triangles. They close its boundaries to
other segments, and the borders of the surface that it holds.

The border of a segment consists of the edges that an odd number of its triangles have. It is
divided into loops, and each loop gets a cap. The holes of the surface are closed first, then the
segments, in ascending order of their area. The cap of a segment, turned over, also goes to the
segment on its other side. If there are several such segments, each gets the sector of the cap
between its edges and a chord or a new point, provided these edges are at least a tenth of the loop,
and other segments begin at most 50 times around it. Therefore the closed segments fit together,
even where three of them meet, and the sum of their volumes is the volume of the closed surface.

<b>Hollow bodies.</b> The surface may have several components. A component that is oriented inward
and lies in another one bounds a cavity. If one segment has all of its triangles and surrounds it,
it stays a cavity of that closed segment. If several segments have triangles of it, as in a hollow
body whose inner wall has the segments of the outer wall, each is closed between the walls. A loop
on the outer wall and one that lies opposite of it on the inner wall get a ring of triangles as
their common cap. Other segments begin at edges that lead from wall to wall, and a loop that passes
such edges gets a strip from wall to wall. This holds for a hole through one component, too, such as
the hole of a pipe. A loop without an opposite loop gets a cap of its own.

Several caps are tried in this order. The first one that lies inside the surface, and intersects
neither it nor other caps, is taken:
-# for a loop on an outer wall with one neighbor, or with several loops opposite of it: a Delaunay
   triangulation in the projection to a plane, with these loops as holes;
-# for two such loops, or one that passes from wall to wall: triangles between the vertices of both
   sides for which the sum of the squared lengths of edges from side to side is least;
-# for a loop with several neighbors, flat sectors that meet in a point, if there are any;
-# for one loop, triangles between its vertices: a Delaunay triangulation in the projection to a
   plane if the loop deviates from it by at most a tenth of the diagonal of its bounding box,
   otherwise a surface that bends little and has a small area;
-# a fan around a new point in the middle of the loop;
-# a strip that leads from the loop to the inside of the surface, for half an edge, two edges, or a
   tenth of an edge, and such triangles inside;
-# for all loops of the segment together, a shell: a copy of its triangles that is moved inwards.

If none does, the first cap of one loop whose edges have no further triangles stays. Then two other
orders are tried: the segments that intersect themselves first, with sectors that chords cut off,
and the largest first. The result with most solids is taken. The surface may intersect itself, or
have tunnels and walls that are much thinner than an edge. The result states for each segment
whether it bounds a solid, and if not, why. Segments of a surface that is inside out are not turned.

The time is O(*n* log *n*) for *n* triangles, plus O(*l*^2) for each loop of *l* edges that gets a
fan or a ring, plus the time of `CGAL::Polygon_mesh_processing::triangulate_hole_polyline()` for
each loop that is not flat. Segments with cavities take O(*n*) for each component.

\tparam PointRange a sequence container of points that can be made from three `double`, with the
  coordinates `p[0]`, `p[1]` and `p[2]`, such as `CGAL::Point_3` and `std::array<double, 3>`
\tparam TriangleRange a sequence container of ranges of three integers, such as
  `std::array<std::size_t, 3>` and `std::vector<std::size_t>`
\tparam SegmentIdRange a sequence container of integers

\param points the points; new points are appended
\param triangles the indices of the three corner points of each triangle; the triangles of caps are
  appended
\param segment_ids the id of the segment of each triangle: any integers; the ids of caps are
  appended

\return the properties of each closed segment, in ascending order of the ids, as
  `CGAL::Segmented_mesh::Closed_segment`

\throws std::invalid_argument if a triangle does not have three corners, a corner is not the index
  of a point, a coordinate of a corner is not finite, or the number of ids is not the number of
  triangles
\throws std::overflow_error if there are more points than the type of the corners can number

If the input causes an exception, nothing has been changed.
*/
template <class PointRange, class TriangleRange, class SegmentIdRange>
#ifdef DOXYGEN_RUNNING
std::vector<Segmented_mesh::Closed_segment<Id> >
#else
std::vector<Segmented_mesh::Closed_segment<typename SegmentIdRange::value_type> >
#endif
close_segments(PointRange& points, TriangleRange& triangles, SegmentIdRange& segment_ids)
{
  namespace internal = Segmented_mesh::internal;
  typedef typename PointRange::value_type Point;
  typedef typename TriangleRange::value_type Triangle;
  typedef internal::Element<Triangle> Corner;

  const internal::Surface soup =
    internal::read_triangle_soup(points, triangles, "close_segments");
  std::vector<internal::Index> labels;
  const auto ids =
    internal::read_segments(soup.corners.size(), segment_ids, labels, "close_segments");
  auto closed = internal::closed_solid(soup.points, soup.corners, labels, ids, false);
  const std::vector<internal::Vector> new_points = closed.solid->new_points();
  if (!new_points.empty() && points.size() + new_points.size() - 1 >
                               static_cast<std::size_t>((std::numeric_limits<Corner>::max)()))
    throw std::overflow_error("close_segments: the type of the corners is too small for the number "
                              "of points");
  const internal::Labeled_triangles& caps = closed.solid->caps();
  for (const internal::Vector& p : new_points)
    points.push_back(Point{p.x(), p.y(), p.z()});
  for (const internal::Corners& t : caps.triangles)
    triangles.push_back(Triangle{Corner(t[0]), Corner(t[1]), Corner(t[2])});
  for (internal::Index label : caps.segments)
    segment_ids.push_back(ids[label]);
  return std::move(closed.segments);
}

} // namespace CGAL

#endif // CGAL_SEGMENTED_MESH_CLOSE_SEGMENTS_H
