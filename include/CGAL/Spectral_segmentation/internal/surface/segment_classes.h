// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SEGMENT_CLASSES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SEGMENT_CLASSES_H

#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Groups elements into classes whose members are all alike, although being alike is not transitive.
// One after the other, each element joins the first class all of whose members it is like.
template <class AreAlike>
std::vector<std::vector<std::size_t> >
first_fit_classes(const std::vector<std::size_t>& elements, const AreAlike& are_alike)
{
  std::vector<std::vector<std::size_t> > classes;
  for (std::size_t e : elements) {
    const auto fits = [&](const std::vector<std::size_t>& members) {
      return std::all_of(members.begin(), members.end(),
                         [&](std::size_t member) { return are_alike(e, member); });
    };
    const auto found = std::find_if(classes.begin(), classes.end(), fits);
    if (found != classes.end())
      found->push_back(e);
    else
      classes.push_back({e});
  }
  return classes;
}

// Returns the moments of each segment, about a corner of the first triangle, in a unit that all
// coordinates are below. Points and triangles are arrays of three; labels are below `number`.
template <class Points, class Triangles, class Labels>
std::vector<Moments> segment_moments(const Points& points, const Triangles& triangles,
                                     const Labels& labels, std::size_t number)
{
  double unit = 0;
  for (const auto& triangle : triangles)
    for (auto v : triangle)
      for (int k = 0; k < 3; ++k)
        unit = (std::max)(unit, std::abs(static_cast<double>(points[v][k])));
  const auto vector = [&](std::size_t t, std::size_t i) {
    const auto& p = points[triangles[t][i]];
    return unit > 0 ? Vector(p[0] / unit, p[1] / unit, p[2] / unit) : Vector();
  };
  std::vector<Moments> result(number);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Vector origin = vector(0, 0);
    const std::array<Vector, 3> corners = {vector(t, 0) - origin, vector(t, 1) - origin,
                                           vector(t, 2) - origin};
    result[labels[t]].add((corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2,
                          corners);
  }
  return result;
}

// Returns a class for each set of faces, numbered by their first members. The members of a class
// are congruent to the largest one.
inline std::vector<std::size_t> congruence_classes(const std::vector<Moments>& moments)
{
  std::vector<Shape> shapes;
  for (const Moments& m : moments)
    shapes.push_back(m.area > 0 ? Shape{m.area, m.deviations()} : Shape());
  std::vector<std::size_t> by_size(shapes.size());
  std::iota(by_size.begin(), by_size.end(), std::size_t(0));
  std::stable_sort(by_size.begin(), by_size.end(), [&](std::size_t a, std::size_t b)
                   { return shapes[a].area > shapes[b].area; });
  std::vector<std::size_t> largest; // of each class, the largest first
  std::vector<std::size_t> class_of(shapes.size());
  std::size_t first = 0;            // whose members may be large enough
  for (std::size_t i : by_size) {
    while (first < largest.size() &&
           !Shape::are_near(shapes[largest[first]].area, shapes[i].area))
      ++first;
    const auto found = std::find_if(
      largest.begin() + static_cast<std::ptrdiff_t>(first), largest.end(),
      [&](std::size_t other)
      { return are_congruent(shapes[other], shapes[i], 0.01 * std::sqrt(shapes[other].area)); });
    class_of[i] = static_cast<std::size_t>(found - largest.begin());
    if (found == largest.end())
      largest.push_back(i);
  }
  std::vector<std::size_t> number(largest.size(), shapes.size());
  std::size_t next = 0;
  for (std::size_t& c : class_of) {
    if (number[c] == shapes.size())
      number[c] = next++;
    c = number[c];
  }
  return class_of;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SEGMENT_CLASSES_H
