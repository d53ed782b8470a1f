// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_BORDERS_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_BORDERS_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_sides.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Two vertices, the smaller first.
typedef std::pair<Index, Index> Vertex_pair;

inline Vertex_pair vertex_pair(Index v, Index w) { return {(std::min)(v, w), (std::max)(v, w)}; }

struct Border_edge
{
  int direction; // positive if its triangles pass it from its smaller to its larger vertex
  Index apex;    // the third corner of one of its triangles
};

// The edges that an odd number of triangles of a set have.
typedef std::map<Vertex_pair, Border_edge> Border;

typedef std::vector<Index> Loop;

// Splits a border into loops that pass no vertex twice, against the direction of most of the
// triangles at them. Loops contain all border edges, however the triangles meet and are oriented,
// because an even number of border edges meets at each vertex.
inline std::vector<Loop> split_into_loops(const Border& border)
{
  struct Step
  {
    Index vertex;
    int direction; // the direction of the border edge to it, or from it
  };
  std::map<Index, std::vector<Step> > unused; // the other ends of the edges at each vertex
  for (const auto& [vertices, edge] : border) {
    unused[vertices.first].push_back({vertices.second, edge.direction});
    unused[vertices.second].push_back({vertices.first, -edge.direction});
  }
  const auto use = [&unused](Index v, Index w) {
    std::vector<Step>& steps = unused[v];
    steps.erase(std::find_if(steps.begin(), steps.end(),
                             [w](const Step& s) { return s.vertex == w; }));
  };
  std::vector<Loop> result;
  std::vector<Step> path;
  std::unordered_map<Index, std::size_t> place; // the index of each vertex in the path
  for (const auto& [vertices, edge] : border) {
    // Walks until no edge is left at the vertex where the walk began.
    for (Index v = vertices.first; !unused[v].empty();) {
      const std::vector<Step>& steps = unused[v];
      const auto along =
        std::find_if(steps.begin(), steps.end(), [](const Step& s) { return s.direction < 0; });
      const Step next = along == steps.end() ? steps.front() : *along;
      use(v, next.vertex);
      use(next.vertex, v);
      place[v] = path.size();
      path.push_back({v, next.direction});
      v = next.vertex;
      const auto passed = place.find(v);
      if (passed == place.end())
        continue;
      const std::size_t first = passed->second;
      Loop loop;
      int direction = 0;
      for (std::size_t i = first; i < path.size(); ++i) {
        loop.push_back(path[i].vertex);
        direction += path[i].direction > 0 ? 1 : -1;
        place.erase(path[i].vertex);
      }
      path.resize(first);
      if (direction > 0)
        std::reverse(loop.begin(), loop.end());
      result.push_back(std::move(loop));
    }
    CGAL_assertion(path.empty());
  }
  return result;
}

// A range of edges of a loop that have the same segment on their other side.
struct Arc
{
  Index segment;
  std::size_t begin, end;
  double length;
};

// Splits a loop where another segment begins, by the segment of each edge.
inline std::vector<Arc> split_into_arcs(const std::vector<Vector>& points, Loop& loop,
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

// The border of each segment: the edges that an odd number of its triangles have.
class Segment_borders
{
  std::vector<Border> border_;                             // one per segment
  std::map<Vertex_pair, std::vector<Index> > segments_at_; // segments with this border edge

  void add_edge(Index segment, const Vertex_pair& vertices, const Border_edge& edge)
  {
    border_[segment].emplace(vertices, edge);
    segments_at_[vertices].push_back(segment);
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

  // Returns the border of the surface: the border edges of an odd number of segments.
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
  // tenth of the loop go to the longer arc beside them, because their sectors would be slivers. A
  // loop with more than 50 arcs, few of which can be long, goes to the segment with most of it.
  std::vector<Arc> long_arcs(const std::vector<Vector>& points, Loop& loop, Index other_than) const
  {
    std::vector<Index> segments;
    for (std::size_t i = 0; i < loop.size(); ++i)
      segments.push_back(segment_at(loop[i], loop[(i + 1) % loop.size()], other_than));
    for (;;) {
      const std::vector<Arc> result = split_into_arcs(points, loop, segments);
      std::map<Index, double> lengths;
      double length = 0;
      for (const Arc& a : result) {
        lengths[a.segment] += a.length;
        length += a.length;
      }
      const auto is_shorter = [](const auto& a, const auto& b) { return a.second < b.second; };
      const auto i = std::min_element(result.begin(), result.end(), [](const Arc& a, const Arc& b)
                                      { return a.length < b.length; });
      if (result.size() == 1 || i->length >= length / 10)
        return result;
      if (result.size() > 50) {
        segments.assign(loop.size(),
                        std::max_element(lengths.begin(), lengths.end(), is_shorter)->first);
        continue;
      }
      const Arc &before = i == result.begin() ? result.back() : *(i - 1),
                &after = i == result.end() - 1 ? result.front() : *(i + 1);
      for (std::size_t e = i->begin; e < i->end; ++e)
        segments[e] = (before.length < after.length ? after : before).segment;
    }
  }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_BORDERS_H
