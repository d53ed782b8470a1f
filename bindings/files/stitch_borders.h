// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_STITCH_BORDERS_H
#define SEGMENT_MESH_MESH_FILE_STITCH_BORDERS_H

#include "Point_numbering.h"
#include "Polygon_soup.h"
#include "Polygon_triangulation.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace mesh_file {

// Joins the points that a file repeats along seams, for each texture, or for each face: border
// edges at the same place become one edge. Other points at the same place stay different.
class Border_stitching
{
  // The places of the ends of an edge, the smaller place first, and the points there.
  typedef std::tuple<Index, Index, Index, Index> Edge;

  const std::vector<Point>& points_;
  std::vector<Triangle>& triangles_;
  std::vector<Index> place_; // one per point, by number

  // Sets the places of the points. Returns whether several points have one place.
  bool set_places()
  {
    std::vector<Point> places;
    Point_numbering number(places);
    place_.reserve(points_.size());
    for (const Point& p : points_)
      place_.push_back(number(p));
    return places.size() < points_.size();
  }

  // Returns the edges with an end whose place other points have, too, sorted.
  std::vector<Edge> edges() const
  {
    std::vector<char> is_used(points_.size(), 0), is_shared(points_.size(), 0);
    for (Index place : place_)
      (is_used[place] ? is_shared : is_used)[place] = 1;
    std::vector<Edge> result;
    for (const Triangle& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i) {
        Index a = t[i], b = t[(i + 1) % 3];
        if (!is_shared[place_[a]] && !is_shared[place_[b]])
          continue;
        if (std::make_pair(place_[a], a) > std::make_pair(place_[b], b))
          std::swap(a, b);
        result.emplace_back(place_[a], place_[b], a, b);
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  // Calls `visit` with the begin and the end of each range of edges with the same key.
  template <class Iterator, class Key, class Visit>
  static void for_each_group(Iterator begin, Iterator end, const Key& key, const Visit& visit)
  {
    while (begin != end) {
      const Iterator last = std::find_if(begin, end, [&](const Edge& e)
                                         { return key(e) != key(*begin); });
      visit(begin, last);
      begin = last;
    }
  }

  // Returns whether each point is an end of a border edge at whose place there is another one.
  std::vector<char> stitched_points() const
  {
    typedef std::vector<Edge>::const_iterator Iterator;
    std::vector<char> result(points_.size(), 0);
    const std::vector<Edge> all = edges();
    std::vector<Edge> border;
    const auto places = [](const Edge& e)
    { return std::make_pair(std::get<0>(e), std::get<1>(e)); };
    for_each_group(all.begin(), all.end(), [](const Edge& e) { return e; },
                   [&](Iterator begin, Iterator end) {
                     if (end - begin == 1 && std::get<0>(*begin) != std::get<1>(*begin))
                       border.push_back(*begin);
                   });
    const std::vector<Edge>& edges_of_border = border;
    for_each_group(edges_of_border.begin(), edges_of_border.end(), places,
                   [&](Iterator begin, Iterator end) {
                     for (Iterator e = begin; end - begin > 1 && e != end; ++e)
                       result[std::get<2>(*e)] = result[std::get<3>(*e)] = 1;
                   });
    return result;
  }

public:
  Border_stitching(const std::vector<Point>& points, std::vector<Triangle>& triangles)
    : points_(points), triangles_(triangles) {}

  void operator()()
  {
    if (!set_places())
      return;
    const std::vector<char> is_stitched = stitched_points();
    std::vector<Index> first(points_.size(), null_index); // one per place
    for (Index v = 0; v < points_.size(); ++v)
      if (is_stitched[v] && first[place_[v]] == null_index)
        first[place_[v]] = v;
    for (Triangle& t : triangles_)
      for (Index& v : t)
        if (is_stitched[v])
          v = first[place_[v]];
  }
};

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_STITCH_BORDERS_H
