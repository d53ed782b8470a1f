// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_BORDERS_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_BORDERS_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/Border_loops.h>
#include <CGAL/Segmented_mesh/internal/triangle_sides.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

typedef std::vector<Index> Loop;

// A part of a loop that one segment has on its other side, as a range of its edges.
struct Arc
{
  Index segment;
  std::size_t begin, end;
  double length;
};

// Knows the border of each segment: the edges that an odd number of its triangles have.
class Segment_borders
{
  std::vector<Border> border_;                             // one per segment
  std::map<Vertex_pair, std::vector<Index> > segments_at_; // the segments whose border it is in

  void add_edge(Index segment, const Vertex_pair& vertices, const Border_edge& edge)
  {
    border_[segment].emplace(vertices, edge);
    segments_at_[vertices].push_back(segment);
  }

  // Splits a loop where another segment begins, by the segment of each edge.
  static std::vector<Arc> arcs(const std::vector<Vector>& points, Loop& loop,
                               std::vector<Index>& segments)
  {
    const auto change = std::adjacent_find(segments.begin(), segments.end(),
                                           std::not_equal_to<Index>());
    const auto first = change == segments.end() ? 0 : change + 1 - segments.begin();
    std::rotate(segments.begin(), segments.begin() + first, segments.end());
    std::rotate(loop.begin(), loop.begin() + first, loop.end());
    std::vector<Arc> result;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (i == 0 || segments[i] != segments[i - 1])
        result.push_back({segments[i], i, i, 0});
      ++result.back().end;
      result.back().length += (points[loop[(i + 1) % loop.size()]] - points[loop[i]]).norm();
    }
    return result;
  }

  // Gives a loop to the segment that has most of it if it has more arcs than can be long.
  static void unite_many_arcs(const std::vector<Vector>& points, Loop& loop,
                               std::vector<Index>& segments)
  {
    const std::vector<Arc> all = arcs(points, loop, segments);
    if (all.size() <= 50)
      return;
    std::map<Index, double> lengths;
    for (const Arc& a : all)
      lengths[a.segment] += a.length;
    const Index longest = std::max_element(lengths.begin(), lengths.end(), [](auto& a, auto& b)
                                           { return a.second < b.second; })->first;
    std::fill(segments.begin(), segments.end(), longest);
  }

public:
  // Finds the borders of segments, whose triangles are given.
  explicit Segment_borders(const std::vector<std::vector<Corners> >& triangles)
    : border_(triangles.size())
  {
    for (Index s = 0; s < triangles.size(); ++s) {
      const std::vector<Triangle_side> sides = sorted_sides(triangles[s]);
      for_each_edge(sides, [&](std::size_t first, std::size_t n) {
        const Triangle_side& side = sides[first];
        if (n % 2 == 0 || side.vertices.first == side.vertices.second)
          return;
        int direction = 0;
        for (std::size_t i = first; i < first + n; ++i)
          direction += sides[i].is_forward ? 1 : -1;
        add_edge(s, side.vertices, {direction, triangles[s][side.triangle()][side.apex()]});
      });
    }
  }

  const Border& border(Index segment) const { return border_[segment]; }

  // Returns the border of the surface: the edges that an odd number of segments have in theirs.
  Border border_of_surface() const
  {
    Border result;
    for (const auto& [edge, segments] : segments_at_)
      if (segments.size() % 2 == 1)
        result.emplace(edge, border_[segments[0]].at(edge));
    return result;
  }

  // Returns whether each vertex is at a border, for vertices 0 to n - 1.
  std::vector<char> vertices(std::size_t n) const
  {
    std::vector<char> result(n, 0);
    for (const auto& [edge, segments] : segments_at_)
      result[edge.first] = result[edge.second] = 1;
    return result;
  }

  // Returns the first segment at a border edge, except `other_than`.
  Index segment_at(Index v, Index w, Index other_than) const
  {
    for (Index s : segments_at_.at(vertex_pair(v, w)))
      if (s != other_than)
        return s;
    CGAL_assertion_msg(false, "a border edge of one segment only");
    return null_index;
  }

  // Adds a triangle. A second triangle at an edge removes the edge from the border.
  void add_triangle(Index segment, const Corners& t)
  {
    for (int i = 0; i < 3; ++i) {
      const Index v = t[i], w = t[(i + 1) % 3];
      const Vertex_pair edge = vertex_pair(v, w);
      if (border_[segment].erase(edge) == 0) {
        add_edge(segment, edge, {v < w ? 1 : -1, t[(i + 2) % 3]});
        continue;
      }
      std::vector<Index>& segments = segments_at_[edge];
      segments.erase(std::find(segments.begin(), segments.end(), segment));
    }
  }

  // Returns the arcs of a loop, by the segments at it except `other_than`. Arcs of less than a
  // tenth of the loop go to the longer arc beside them, because their sectors would be splinters.
  std::vector<Arc> long_arcs(const std::vector<Vector>& points, Loop& loop, Index other_than) const
  {
    std::vector<Index> segments;
    for (std::size_t i = 0; i < loop.size(); ++i)
      segments.push_back(segment_at(loop[i], loop[(i + 1) % loop.size()], other_than));
    unite_many_arcs(points, loop, segments);
    for (;;) {
      const std::vector<Arc> result = arcs(points, loop, segments);
      double length = 0;
      for (const Arc& a : result)
        length += a.length;
      const auto i = std::min_element(result.begin(), result.end(), [](const Arc& a, const Arc& b)
                                      { return a.length < b.length; });
      if (result.size() == 1 || i->length >= length / 10)
        return result;
      const Arc &before = i == result.begin() ? result.back() : *(i - 1),
                &after = i == result.end() - 1 ? result.front() : *(i + 1);
      for (std::size_t e = i->begin; e < i->end; ++e)
        segments[e] = (before.length < after.length ? after : before).segment;
    }
  }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_BORDERS_H
