// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_ORIENT_OUTWARD_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_ORIENT_OUTWARD_H

#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A component: its area, the volume that it encloses, negative if its faces point inward, and
// whether it has no border. The volume of an open component is closed by cones to its center.
struct Extent
{
  double area = 0, volume = 0;
  Vector sum_of_normals; // each is as long as the area of its face
  bool is_closed = true;

  bool has_volume() const { return std::abs(volume) > quantum * area * std::sqrt(area); }

  // Returns whether the faces clearly point inward: the component is closed, or has small holes.
  bool points_inward() const
  {
    if (is_closed)
      return has_volume() && volume < 0;
    return sum_of_normals.norm() < 0.19 * area && volume < -0.02 * area * std::sqrt(area);
  }
};

// Sets the areas of the faces, and returns the extents of the components.
inline std::vector<Extent> set_areas_and_extents(Surface& surface)
{
  const std::vector<char> is_closed = closed_components(surface);
  std::vector<Extent> result(surface.components.number);
  std::vector<Vector> origin(result.size()), first_moment(result.size()); // relative to the origin
  surface.areas.resize(surface.number_of_faces());
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    const Index c = surface.components[f];
    Extent& e = result[c];
    if (e.area == 0)
      origin[c] = surface.points[surface.corners[f][0]];
    const Vector normal = surface.normal(f) / 2;
    const Vector p = surface.points[surface.corners[f][0]] - origin[c];
    surface.areas[f] = normal.norm();
    e.area += surface.areas[f];
    e.volume += normal.dot(p) / 3;
    e.sum_of_normals += normal;
    first_moment[c] += surface.areas[f] * (surface.centroid(f) - origin[c]);
  }
  for (std::size_t c = 0; c < result.size(); ++c) {
    result[c].is_closed = is_closed[c] != 0;
    if (!is_closed[c] && result[c].area > 0)
      result[c].volume -= result[c].sum_of_normals.dot(first_moment[c] / result[c].area) / 3;
  }
  return result;
}

// Reverses the faces of some components.
inline void reverse_orientation(Surface& surface, const std::vector<char>& is_reversed)
{
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    if (is_reversed[surface.components[f]])
      std::swap(surface.corners[f][1], surface.corners[f][2]);
  renumber_halfedges(surface, [&](Index h)
    { return is_reversed[surface.components[h / 3]] ? h - h % 3 + (2 - h % 3) : h; });
}

// Sets the areas of the faces, and reverses each component whose faces point inward. Returns the
// volumes that closed components enclose, negative for those that are reversed; 0 for a component
// with a border, and for a volume below rounding errors.
inline std::vector<double> orient_outward(Surface& surface)
{
  std::vector<double> volumes;
  std::vector<char> is_reversed;
  for (const Extent& e : set_areas_and_extents(surface)) {
    volumes.push_back(e.is_closed && e.has_volume() ? e.volume : 0);
    is_reversed.push_back(e.points_inward());
  }
  if (std::find(is_reversed.begin(), is_reversed.end(), char(1)) == is_reversed.end())
    return volumes;
  reverse_orientation(surface, is_reversed);
  return volumes;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_ORIENT_OUTWARD_H
