// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MODEL_COMPONENTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MODEL_COMPONENTS_H

#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Sets the areas of the faces. Returns the volume that each component encloses, negative if its
// faces point inward; 0 for a component with a border, and for a volume below rounding errors.
inline std::vector<double> set_areas_and_volumes(Surface& surface)
{
  const std::size_t number = surface.components.number;
  std::vector<double> volume(number, 0), area(number, 0);
  std::vector<char> is_closed(number, 1);
  for (Index h = 0; h < surface.number_of_halfedges(); ++h)
    if (surface.is_border(h))
      is_closed[surface.components[h / 3]] = 0;
  surface.areas.resize(surface.number_of_faces());
  std::vector<Index> first(number, null_index); // the local origin of each component
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    const Index c = surface.components[f], v = surface.corners[f][0];
    first[c] = first[c] == null_index ? v : first[c];
    const Vector normal = surface.normal(f);
    surface.areas[f] = normal.norm() / 2;
    volume[c] += normal.dot(surface.points[v] - surface.points[first[c]]) / 6;
    area[c] += surface.areas[f];
  }
  for (std::size_t c = 0; c < number; ++c)
    if (!is_closed[c] || std::abs(volume[c]) <= quantum * area[c] * std::sqrt(area[c]))
      volume[c] = 0;
  return volume;
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

// Sets the areas of the faces, and reverses each closed component whose faces point inward. Returns
// the enclosed volumes, negative for components whose orientation disagreed with most of the
// volume.
inline std::vector<double> orient_outward(Surface& surface)
{
  std::vector<double> volumes = set_areas_and_volumes(surface);
  std::vector<char> is_reversed;
  for (double volume : volumes)
    is_reversed.push_back(volume < 0);
  if (std::find(is_reversed.begin(), is_reversed.end(), char(1)) == is_reversed.end())
    return volumes;
  reverse_orientation(surface, is_reversed);
  if (std::accumulate(volumes.begin(), volumes.end(), 0.) < 0)
    for (double& volume : volumes)
      volume = -volume;
  return volumes;
}

// Returns a surface of some faces, which ascend, with other points. Faces and vertices keep their
// order.
inline Surface submesh(const Surface& surface, const std::vector<Vector>& points,
                       const std::vector<Index>& faces)
{
  Surface result;
  std::vector<Index> vertex(points.size(), null_index);
  for (Index f : faces)
    for (Index v : surface.corners[f])
      vertex[v] = 0;
  for (Index v = 0; v < vertex.size(); ++v)
    if (vertex[v] != null_index) {
      vertex[v] = static_cast<Index>(result.points.size());
      result.points.push_back(points[v]);
    }
  std::vector<Index> face(surface.number_of_faces(), null_index);
  for (Index i = 0; i < faces.size(); ++i)
    face[faces[i]] = i;
  for (Index i = 0; i < faces.size(); ++i) {
    const Corners& c = surface.corners[faces[i]];
    result.corners.push_back({vertex[c[0]], vertex[c[1]], vertex[c[2]]});
    for (Index k = 0; k < 3; ++k) {
      const Index across = surface.opposite[3 * faces[i] + k], neighbor = face[across / 3];
      result.opposite.push_back(neighbor == null_index ? 3 * i + k : 3 * neighbor + across % 3);
    }
  }
  result.components = connected_components(result);
  return result;
}

// The areas of the components of a model, relative to their total area. A sheet under them, such as
// the water under a ship, is excluded from the total.
struct Component_fractions
{
  std::vector<double> fraction; // one per component
  Index sheet = null_index;     // a component, or null_index

  // Returns the effective number of components: the inverse of the sum of squared fractions.
  double effective_number() const
  {
    double squares = 0;
    for (Index c = 0; c < fraction.size(); ++c)
      squares += c == sheet ? 0 : fraction[c] * fraction[c];
    return squares > 0 ? 1 / squares : 1;
  }
};

// Returns the fractions of the components, whose faces have areas. The sheet is the largest
// component, if it is flat and at least twice as long as all others together.
inline Component_fractions component_fractions(const Surface& surface)
{
  std::vector<Moments> moments(surface.components.number);
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    moments[surface.components[f]].add(surface, f);
  const Index largest = static_cast<Index>(
    std::max_element(moments.begin(), moments.end(),
                     [](const Moments& a, const Moments& b) { return a.area < b.area; }) -
    moments.begin());
  Moments others;
  for (Index c = 0; c < moments.size(); ++c)
    if (c != largest)
      others += moments[c];
  Component_fractions result;
  double area = others.area;
  if (others.area > 0) {
    const std::array<double, 3> extents = moments[largest].deviations();
    if (extents[0] <= 0.02 * extents[1] && extents[2] >= 2 * others.deviations()[2])
      result.sheet = largest;
  }
  if (result.sheet == null_index)
    area += moments[largest].area;
  for (const Moments& m : moments)
    result.fraction.push_back(area > 0 ? m.area / area : 0);
  return result;
}

// Returns whether a connected surface in its frame, with area 1, bounds a convex solid: it is
// closed, it encloses a volume, and no face rises above the plane of a neighbor by more than
// rounding errors.
inline bool is_convex(const Surface& surface)
{
  constexpr double largest_height = 1e-5; // points are rounded to 1e-6
  double volume = 0;
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    const Vector normal = surface.normal(f);
    volume += normal.dot(surface.centroid(f)) / 6;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Vector apex =
        surface.points[surface.target_vertex(Surface::next(surface.opposite[h]))];
      const double height = normal.dot(apex - surface.points[surface.source_vertex(h)]);
      if (surface.is_border(h) || height > largest_height * normal.norm())
        return false;
    }
  }
  return volume > largest_height;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MODEL_COMPONENTS_H
