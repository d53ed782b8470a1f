// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_SURROUNDING_COMPONENTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_SURROUNDING_COMPONENTS_H

#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/is_convex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
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

// Finds the surroundings of a model, whose faces have areas and point outward: a sheet or a flat
// convex solid that is at least twice as long as all others together, or a convex solid with all
// others inside, such as the dome of a sky, a room, or a convex hull. There may be several, such as
// a floor in a room. Candidates are the component of largest area, and the one of largest extent.
class Surrounding_components
{
  static constexpr double flatness_of_sheet = 0.02, flatness_of_slab = 0.2;
  static constexpr int most_rounds = 8, number_of_directions = 100;

  const Surface& surface_;
  std::vector<Moments> moments_; // one per component
  std::vector<char> is_surrounding_;

  // Returns the points of the others that are farthest in directions that are spread over a sphere.
  std::vector<Vector> extreme_points_of_others(Index component) const
  {
    std::vector<Vector> directions, result;
    for (int i = 0; i < number_of_directions; ++i) { // on a spiral
      const double z = 1 - (2 * i + 1.) / number_of_directions, angle = 2.399963229728653 * i;
      const double r = std::sqrt(1 - z * z);
      directions.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
    std::vector<double> farthest(directions.size(), -std::numeric_limits<double>::infinity());
    result.resize(directions.size());
    std::vector<char> is_seen(surface_.points.size(), 0);
    for (Index f = 0; f < surface_.number_of_faces(); ++f) {
      if (const Index c = surface_.components[f]; c == component || is_surrounding_[c])
        continue;
      for (Index v : surface_.corners[f])
        if (!std::exchange(is_seen[v], char(1)))
          for (std::size_t i = 0; i < directions.size(); ++i)
            if (const double x = directions[i].dot(surface_.points[v]); x > farthest[i]) {
              farthest[i] = x;
              result[i] = surface_.points[v];
            }
    }
    return result;
  }

  // Returns whether the others are inside a convex component. If they touch it all around, they are
  // not much smaller: the details of a block are not in it as in a room.
  bool are_others_inside(Index component, double area_of_others) const
  {
    const double tolerance = 1e-3 * std::sqrt(moments_[component].area);
    const std::vector<Vector> points = extreme_points_of_others(component);
    std::vector<double> depths(points.size(), std::numeric_limits<double>::infinity());
    for (Index f = 0; f < surface_.number_of_faces(); ++f)
      if (surface_.components[f] == component) {
        const Vector normal = surface_.normal(f).stably_normalized();
        const double height = normal.dot(surface_.points[surface_.corners[f][0]]);
        for (std::size_t i = 0; i < points.size(); ++i)
          depths[i] = (std::min)(depths[i], height - normal.dot(points[i]));
      }
    std::sort(depths.begin(), depths.end());
    return depths.front() >= -tolerance &&
           (depths[depths.size() / 2] > 10 * tolerance ||
            area_of_others > 0.3 * moments_[component].area);
  }

  bool surrounds(Index component, bool has_largest_area) const
  {
    Moments others;
    for (Index c = 0; c < moments_.size(); ++c)
      if (c != component && !is_surrounding_[c])
        others += moments_[c];
    if (!(others.area > 0))
      return false;
    const std::array<double, 3> extents = moments_[component].deviations();
    const bool is_long = has_largest_area && extents[2] >= 2 * others.deviations()[2];
    if (is_long && extents[0] <= flatness_of_sheet * extents[1])
      return true;
    return is_convex(surface_, component) &&
           ((is_long && extents[0] <= flatness_of_slab * extents[1]) ||
            are_others_inside(component, others.area));
  }

  // Returns the component of largest value among those that are not surroundings.
  template <class Value>
  Index largest(const Value& value) const
  {
    Index result = null_index;
    double best = -1;
    for (Index c = 0; c < moments_.size(); ++c)
      if (const double x = is_surrounding_[c] ? -1 : quantized(value(moments_[c])); x > best) {
        best = x;
        result = c;
      }
    return result;
  }

  // Marks a component if it surrounds the others. Returns whether it does.
  bool mark(Index component, bool has_largest_area)
  {
    if (component == null_index || !surrounds(component, has_largest_area))
      return false;
    is_surrounding_[component] = 1;
    return true;
  }

public:
  explicit Surrounding_components(const Surface& surface)
    : surface_(surface), moments_(surface.components.number),
      is_surrounding_(surface.components.number, 0)
  {
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      moments_[surface.components[f]].add(surface, f);
  }

  Component_fractions operator()()
  {
    const auto area = [](const Moments& m) { return m.area; };
    const auto extent = [](const Moments& m) { return m.deviations()[2]; };
    for (int round = 0; round < most_rounds; ++round) {
      const Index by_area = largest(area), by_extent = largest(extent);
      if (!mark(by_area, true) && (by_extent == by_area || !mark(by_extent, false)))
        break;
    }
    double total = 0;
    for (Index c = 0; c < moments_.size(); ++c)
      total += is_surrounding_[c] ? 0 : moments_[c].area;
    Component_fractions result;
    for (const Moments& m : moments_)
      result.fraction.push_back(total > 0 ? m.area / total : 0);
    result.is_surrounding = is_surrounding_;
    return result;
  }
};

inline Component_fractions component_fractions(const Surface& surface)
{ return Surrounding_components(surface)(); }

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_SURROUNDING_COMPONENTS_H
