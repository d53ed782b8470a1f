// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_CLOSED_SEGMENT_H
#define CGAL_SEGMENTED_MESH_CLOSED_SEGMENT_H

#include <cstddef>

namespace CGAL {
namespace Segmented_mesh {

/// \ingroup PkgSpectralSegmentationRef
/// The properties of a segment with its caps, as `CGAL::close_segments()` and
/// `CGAL::split_into_segments()` return them.
template <class Id = std::size_t>
struct Closed_segment
{
  Id id = 0; ///< the id of the segment

  /// whether each edge has exactly two triangles, which pass it in opposite directions
  bool is_closed = false;

  /// whether it is closed, and the triangles at each vertex are one fan
  bool is_manifold = false;

  /// whether it is closed, its signed volume is positive, and its components are nested like the
  /// borders of a solid: those oriented outward lie outside of the others or in cavities, and those
  /// oriented inward are cavities. If it intersects or touches itself, only the volume counts.
  bool is_outward_oriented = false;

  /// whether triangles meet elsewhere than in common vertices and edges, or one is degenerate
  bool has_self_intersections = true;

  /// the signed volume, in the cube of the unit of the coordinates; 0 if the segment is not closed
  double volume = 0;

  /// returns whether the segment bounds a solid, as 3D printing and Boolean operations require
  bool is_solid() const
  { return is_closed && is_manifold && is_outward_oriented && !has_self_intersections; }
};

} // namespace Segmented_mesh
} // namespace CGAL

#endif // CGAL_SEGMENTED_MESH_CLOSED_SEGMENT_H
