// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_SURROUNDING_COMPONENTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_SURROUNDING_COMPONENTS_H

#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/is_convex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The areas of the components of a model, relative to their total area. The surroundings of the
// others, such as the water under a ship, are excluded from the total.
struct Component_fractions
{
  std::vector<double> fraction;    // one per component
  std::vector<char> is_surrounding;

  // Returns the effective number of components: the inverse of the sum of squared fractions; 1
  // without components.
  double effective_number() const
  {
    double squares = 0;
    for (Index c = 0; c < fraction.size(); ++c)
      squares += is_surrounding[c] ? 0 : fraction[c] * fraction[c];
    return squares > 0 ? 1 / squares : 1;
  }
};

// Returns whether a convex solid has a ball around others inside, whose radius is twice their
// largest standard deviation.
inline bool is_around(const Surface& surface, Index component, const Moments& others)
{
  const double radius = 2 * others.deviations()[2];
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    if (surface.components[f] == component &&
        surface.normal(f).stably_normalized().dot(surface.points[surface.corners[f][0]] -
                                                  others.centroid()) < radius)
      return false;
  return true;
}

// Returns whether a component, which may have a border, surrounds others: it has more area, and it
// is a flat sheet or slab of twice their length, or a convex solid around them.
inline bool surrounds(const Surface& surface, Index component, bool is_open, const Moments& m,
                      const Moments& others)
{
  constexpr double flatness_of_sheet = 0.1, flatness_of_slab = 0.4;
  if (!(others.area > 0) || quantized(m.area) <= quantized(others.area))
    return false;
  const std::array<double, 3> extents = m.deviations();
  const bool is_flat = extents[2] >= 2 * others.deviations()[2] &&
    extents[0] <= (is_open ? flatness_of_sheet : flatness_of_slab) * extents[1];
  return is_open ? is_flat : is_convex(surface, component) &&
                               (is_flat || is_around(surface, component, others));
}

// Returns the fractions of the components of a surface, whose faces have areas and point outward.
// The largest component may surround the others, then the next one the rest, such as a floor in a
// room.
inline Component_fractions component_fractions(const Surface& surface)
{
  const std::size_t n = surface.components.number;
  std::vector<Moments> moments(n);
  std::vector<char> is_open(n, 0);
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    moments[surface.components[f]].add(surface, f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (surface.is_border(h))
        is_open[surface.components[f]] = 1;
  }
  std::vector<Index> by_area = first_indices(n);
  std::stable_sort(by_area.begin(), by_area.end(), [&](Index a, Index b)
    { return quantized(moments[a].area) < quantized(moments[b].area); });
  std::vector<Moments> sums(1); // of the first components in this order
  for (Index c : by_area) {
    sums.push_back(sums.back());
    sums.back() += moments[c];
  }

  Component_fractions result{std::vector<double>(n, 0), std::vector<char>(n, 0)};
  std::size_t number = n; // of the components that surround nothing
  for (; number > 1; --number) {
    const Index c = by_area[number - 1];
    if (!surrounds(surface, c, is_open[c] != 0, moments[c], sums[number - 1]))
      break;
    result.is_surrounding[c] = 1;
  }
  for (Index c = 0; c < n; ++c)
    if (sums[number].area > 0)
      result.fraction[c] = moments[c].area / sums[number].area;
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_SURROUNDING_COMPONENTS_H
