// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_READ_TRIANGLE_SOUP_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_READ_TRIANGLE_SOUP_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

template <class Range>
using Element = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;

// Whether a type is a range of ranges of integers, but not of strings.
template <class Range, class = void>
struct is_triangle_range : std::false_type {};

template <class Range>
struct is_triangle_range<Range, std::void_t<Element<Element<Range> > > >
  : std::bool_constant<std::is_integral<Element<Element<Range> > >::value &&
                       !std::is_same<Element<Element<Range> >, char>::value> {};

// Reads points with the coordinates `p[0]`, `p[1]` and `p[2]`, and triangles of indices of points.
// Does not find the neighbors of triangles. Points that no triangle uses may have any coordinates.
//
// Throws `std::invalid_argument` if a triangle does not have three corners, a corner is not the
// index of a point, or a coordinate that is used is not finite. The message begins with `function`,
// the name of the function that the caller called.
template <class PointRange, class TriangleRange>
Surface read_triangle_soup(const PointRange& points, const TriangleRange& triangles,
                             const std::string& function = "segment_spectral_recursive")
{
  Surface result;
  for (const auto& p : points) {
    if (result.points.size() + 1 >= null_index)
      throw std::invalid_argument(function + ": there are too many points");
    result.points.push_back(
      Vector(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])));
  }
  const std::size_t number_of_points = result.points.size();
  std::vector<char> is_used(number_of_points, 0);
  for (const auto& triangle : triangles) {
    const std::size_t f = result.corners.size();
    const auto fail = [&](const char* what) {
      throw std::invalid_argument(function + ": triangle " + std::to_string(f) + what);
    };
    if (f + 1 >= null_index / 3)
      throw std::invalid_argument(function + ": there are too many triangles");
    Corners corners;
    std::size_t size = 0;
    for (auto corner : triangle) {
      if (size == 3)
        fail(" has more than three corners");
      if (corner < 0 || static_cast<std::size_t>(corner) >= number_of_points)
        fail(" has a corner that is no index of a point");
      corners[size++] = static_cast<Index>(corner);
    }
    if (size < 3)
      fail(" has fewer than three corners");
    for (Index v : corners) {
      if (!result.points[v].is_finite())
        fail(" has a corner with a coordinate that is not finite");
      is_used[v] = 1;
    }
    result.corners.push_back(corners);
  }
  for (std::size_t v = 0; v < number_of_points; ++v)
    if (!is_used[v])
      result.points[v] = Vector();
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_READ_TRIANGLE_SOUP_H
