// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/Border_loops.h>
#include <CGAL/Segmented_mesh/internal/capping/triangulated_loop.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Triangles that close segments.
struct Caps
{
  std::vector<Vector> points;     // new points, which are numbered after the others
  std::vector<Corners> triangles;
  std::vector<Index> segment;     // one per triangle
};

// Closes segments one after the other, the smallest first. Each border loop of a segment gets a
// cap. Its triangles, turned over, go to the segments on its other side, so that all segments fit
// together, even where three of them meet.
class Segment_capping
{
  typedef std::vector<Index> Loop;

  // A part of a loop, as a range of its edges.
  struct Arc
  {
    Index segment;
    std::size_t begin, end;
    double length;
  };

  struct Cap
  {
    Index segment; // the segment on its other side
    std::vector<Corners> triangles;
  };

  const std::vector<Vector>& points_;
  std::vector<Border> border_;                               // one per segment
  std::map<Vertex_pair, std::vector<Index> > segments_at_;   // the segments whose border it is in
  std::set<Vertex_pair> taken_; // edges of triangles and caps, where one more triangle is too many
  Caps result_;

  void add_border_edge(Index segment, const Vertex_pair& edge, int direction)
  {
    border_[segment].emplace(edge, direction);
    segments_at_[edge].push_back(segment);
  }

  // Adds a triangle. A second triangle at an edge removes the edge from the border.
  void add_triangle(Index segment, const Corners& t)
  {
    result_.triangles.push_back(t);
    result_.segment.push_back(segment);
    for (int i = 0; i < 3; ++i) {
      const Index v = t[i], w = t[(i + 1) % 3];
      const Vertex_pair edge = vertex_pair(v, w);
      if (border_[segment].erase(edge) == 0) {
        add_border_edge(segment, edge, v < w ? 1 : -1);
        continue;
      }
      std::vector<Index>& segments = segments_at_[edge];
      segments.erase(std::find(segments.begin(), segments.end(), segment));
    }
  }

  // Finds the edges that an odd number of triangles of a segment have.
  void find_borders(const std::vector<Corners>& triangles, const std::vector<Index>& segment)
  {
    struct Edge
    {
      Index segment;
      Vertex_pair vertices;
      int direction;
      bool operator<(const Edge& e) const
      { return std::tie(segment, vertices) < std::tie(e.segment, e.vertices); }
    };
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    for (std::size_t f = 0; f < triangles.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        const Index v = triangles[f][i], w = triangles[f][(i + 1) % 3];
        if (v != w)
          edges.push_back({segment[f], vertex_pair(v, w), v < w ? 1 : -1});
      }
    std::sort(edges.begin(), edges.end());
    for (auto begin = edges.begin(), end = begin; begin != edges.end(); begin = end) {
      int direction = 0;
      for (; end != edges.end() && !(*begin < *end); ++end)
        direction += end->direction;
      if ((end - begin) % 2 == 1)
        add_border_edge(begin->segment, begin->vertices, direction);
    }
  }

  // Takes the edges between vertices of borders, because other edges cannot be edges of a cap.
  void take_edges(const std::vector<Corners>& triangles)
  {
    std::vector<char> is_at_border(points_.size(), 0);
    for (const auto& [edge, segments] : segments_at_)
      is_at_border[edge.first] = is_at_border[edge.second] = 1;
    for (const Corners& t : triangles)
      for (int i = 0; i < 3; ++i) {
        const Index v = t[i], w = t[(i + 1) % 3];
        if (is_at_border[v] && is_at_border[w])
          taken_.insert(vertex_pair(v, w));
      }
  }

  const Vector& point(Index v) const
  { return v < points_.size() ? points_[v] : result_.points[v - points_.size()]; }

  Index add_middle(const Loop& loop)
  {
    Vector middle;
    for (Index v : loop)
      middle += point(v) / static_cast<double>(loop.size());
    result_.points.push_back(middle);
    return static_cast<Index>(points_.size() + result_.points.size() - 1);
  }

  std::vector<Corners> fan(const Loop& loop)
  {
    const Index middle = add_middle(loop);
    std::vector<Corners> result;
    for (std::size_t i = 0; i < loop.size(); ++i)
      result.push_back({loop[i], loop[(i + 1) % loop.size()], middle});
    return result;
  }

  std::vector<Corners> triangles_in(const Loop& loop)
  {
    std::vector<Vector> points;
    for (Index v : loop)
      points.push_back(point(v));
    std::vector<Corners> triangles = triangulated_loop(std::move(points));
    std::vector<Vertex_pair> inner_edges;
    const auto n = static_cast<Index>(loop.size());
    for (Corners& t : triangles) {
      for (const auto& [i, j] : {Vertex_pair(t[0], t[1]), {t[1], t[2]}, {t[0], t[2]}})
        if (j - i > 1 && j - i < n - 1)
          inner_edges.push_back(vertex_pair(loop[i], loop[j]));
      t = {loop[t[0]], loop[t[1]], loop[t[2]]};
    }
    if (triangles.empty() || std::any_of(inner_edges.begin(), inner_edges.end(), [&](const auto& e)
                                         { return taken_.count(e) > 0; }))
      return fan(loop);
    taken_.insert(inner_edges.begin(), inner_edges.end());
    return triangles;
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

  // Splits a loop where another segment begins, by the segment of each edge.
  std::vector<Arc> arcs(Loop& loop, std::vector<Index>& segments) const
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
      result.back().length += (point(loop[(i + 1) % loop.size()]) - point(loop[i])).norm();
    }
    return result;
  }

  // Gives a loop to the segment that has most of it if it has more arcs than can be long.
  void unite_many_arcs(Loop& loop, std::vector<Index>& segments) const
  {
    const std::vector<Arc> all = arcs(loop, segments);
    if (all.size() <= 50)
      return;
    std::map<Index, double> lengths;
    for (const Arc& a : all)
      lengths[a.segment] += a.length;
    const Index longest = std::max_element(lengths.begin(), lengths.end(), [](auto& a, auto& b)
                                           { return a.second < b.second; })->first;
    std::fill(segments.begin(), segments.end(), longest);
  }

  // Returns the arcs of a loop, by the segments at it except `other_than`. Arcs of less than a
  // tenth of the loop go to the longer arc beside them, because their sectors would be splinters.
  std::vector<Arc> long_arcs(Loop& loop, Index other_than) const
  {
    std::vector<Index> segments;
    for (std::size_t i = 0; i < loop.size(); ++i)
      segments.push_back(segment_at(loop[i], loop[(i + 1) % loop.size()], other_than));
    unite_many_arcs(loop, segments);
    for (;;) {
      const std::vector<Arc> result = arcs(loop, segments);
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

  // Makes a cap for each of the segments that hold the edges of a loop, except `other_than`. The
  // caps are one piece, or sectors around a new point in the middle.
  std::vector<Cap> caps(Loop loop, Index other_than)
  {
    const std::vector<Arc> arcs_of_loop = long_arcs(loop, other_than);
    if (arcs_of_loop.size() == 1)
      return {{arcs_of_loop[0].segment, triangles_in(loop)}};
    const Index middle = add_middle(loop);
    std::vector<Cap> result;
    for (const Arc& a : arcs_of_loop) {
      Loop sector = {middle};
      for (std::size_t i = a.begin; i <= a.end; ++i)
        sector.push_back(loop[i % loop.size()]);
      result.push_back({a.segment, triangles_in(sector)});
    }
    return result;
  }

  // Closes a segment. Each edge of its border has another segment, because the surface is closed.
  void close(Index segment)
  {
    const Border_loops loops(border_[segment]);
    for (const Loop& loop : loops())
      for (const Cap& cap : caps(loop, segment))
        for (const Corners& t : cap.triangles) {
          add_triangle(segment, t);
          add_triangle(cap.segment, {t[0], t[2], t[1]});
        }
  }

  void close_surface()
  {
    Border border;
    for (const auto& [edge, segments] : segments_at_)
      if (segments.size() % 2 == 1)
        border.emplace(edge, border_[segments[0]].at(edge));
    const Border_loops loops(border);
    for (const Loop& loop : loops())
      for (const Cap& cap : caps(loop, null_index))
        for (const Corners& t : cap.triangles)
          add_triangle(cap.segment, t);
  }

  static std::vector<double> areas(const std::vector<Vector>& points,
                                   const std::vector<Corners>& triangles,
                                   const std::vector<Index>& segment, std::size_t n)
  {
    std::vector<double> result(n, 0);
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const Corners& t = triangles[f];
      result[segment[f]] +=
        (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm();
    }
    return result;
  }

public:
  explicit Segment_capping(const std::vector<Vector>& points) : points_(points) {}

  // Closes segments; `segment` holds the segment of each triangle, from 0 to n - 1. Call this once.
  Caps operator()(const std::vector<Corners>& triangles, const std::vector<Index>& segment,
                  std::size_t n)
  {
    border_.resize(n);
    find_borders(triangles, segment);
    take_edges(triangles);
    close_surface();
    const std::vector<double> area = areas(points_, triangles, segment, n);
    std::vector<Index> order(n);
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
                     [&area](Index a, Index b) { return area[a] < area[b]; });
    for (Index s : order)
      close(s);
    return std::move(result_);
  }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H
