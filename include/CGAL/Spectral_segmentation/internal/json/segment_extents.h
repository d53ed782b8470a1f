// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_SEGMENT_EXTENTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_SEGMENT_EXTENTS_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <CGAL/Spectral_segmentation/internal/surface/segment_classes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The extent of a segment, its neighbors, and the class of its copies.
struct Segment_extent
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::array<double, 3> smallest{infinity, infinity, infinity};
  std::array<double, 3> largest{-infinity, -infinity, -infinity};
  std::vector<std::size_t> neighbors; // the segments with which it shares an edge, ascending
  std::size_t segment_class = 0;      // segments of one class may be copies or mirror images
};

// Returns the extent of each segment. Points and triangles are arrays of three; labels are below
// `number`.
template <class Points, class Triangles, class Labels>
std::vector<Segment_extent> segment_extents(const Points& points, const Triangles& triangles,
                                            const Labels& labels, std::size_t number)
{
  std::vector<Segment_extent> result(number);
  constexpr std::size_t several = static_cast<std::size_t>(-2), none = several + 1;
  std::vector<std::size_t> segment_at(points.size(), none);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Segment_extent& extent = result[labels[t]];
    for (auto v : triangles[t]) {
      for (int k = 0; k < 3; ++k) {
        extent.smallest[k] = (std::min)(extent.smallest[k], points[v][k]);
        extent.largest[k] = (std::max)(extent.largest[k], points[v][k]);
      }
      if (segment_at[v] == none)
        segment_at[v] = labels[t];
      else if (segment_at[v] != labels[t])
        segment_at[v] = several;
    }
  }

  // The edges at a boundary, with the segments of their triangles.
  typedef std::pair<std::array<std::size_t, 2>, std::size_t> Edge;
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::size_t v = triangles[t][k], w = triangles[t][(k + 1) % 3];
      if (segment_at[v] == several && segment_at[w] == several)
        edges.push_back({{(std::min)(v, w), (std::max)(v, w)}, labels[t]});
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size() && edges[j].first == edges[i].first; ++j) {
      result[edges[i].second].neighbors.push_back(edges[j].second);
      result[edges[j].second].neighbors.push_back(edges[i].second);
    }
  for (Segment_extent& extent : result) {
    std::vector<std::size_t>& list = extent.neighbors;
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  const std::vector<std::size_t> classes =
    congruence_classes(segment_moments(points, triangles, labels, number));
  for (std::size_t i = 0; i < number; ++i)
    result[i].segment_class = classes[i];
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_SEGMENT_EXTENTS_H
