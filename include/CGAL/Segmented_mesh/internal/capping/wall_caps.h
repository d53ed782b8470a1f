// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_WALL_CAPS_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_WALL_CAPS_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/Segmented_solid.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>
#include <CGAL/Segmented_mesh/internal/capping/triangulated_loop.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

// Functions for the caps of segments between two walls of a hollow body.

namespace CGAL::Segmented_mesh::internal {

// Triangulates the strip between two polylines without further points. Edges join their first
// points and their last points; a ring has the same two points there. The algorithm by Fuchs, Kedem
// and Uselton is repeated without the triangles that prove unusable.
class Strip_triangulation
{
  // The step from the edge p[i] q[j] to the next one, along p or along q, makes a triangle.
  struct Step
  {
    std::size_t i, j;
    bool is_along_p;
  };

  enum State : char { UNKNOWN, USABLE, UNUSABLE };

  static constexpr std::size_t largest_number_of_states_ = 20000000;
  static constexpr double infinity_ = (std::numeric_limits<double>::infinity)();

  const std::vector<Vector>& points_;
  std::vector<Index> p_, q_;
  std::vector<State> states_; // one per step along p or q from each edge

  State& state(const Step& s) { return states_[2 * (s.i * q_.size() + s.j) + s.is_along_p]; }

  Corners triangle(const Step& s) const
  {
    return s.is_along_p ? Corners{p_[s.i], p_[s.i + 1], q_[s.j]}
                        : Corners{q_[s.j + 1], q_[s.j], p_[s.i]};
  }

  double cost(const Step& s)
  {
    if (state(s) == UNUSABLE)
      return infinity_;
    const Vector edge = points_[p_[s.i + s.is_along_p]] - points_[q_[s.j + !s.is_along_p]];
    return edge.dot(edge);
  }

  // Returns the cheapest steps from the first to the last edge; none if that needs unusable ones.
  std::vector<Step> best_steps()
  {
    const std::size_t n = p_.size(), m = q_.size();
    std::vector<char> comes_along_p(n * m, 0);
    std::vector<double> costs(m, infinity_); // one per edge from p[i]
    costs[0] = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j) {
        if (i > 0) {
          costs[j] += cost({i - 1, j, true});
          comes_along_p[i * m + j] = 1;
        }
        if (j > 0) {
          const double along_q = costs[j - 1] + cost({i, j - 1, false});
          if (i == 0 || along_q < costs[j]) {
            costs[j] = along_q;
            comes_along_p[i * m + j] = 0;
          }
        }
      }
    std::vector<Step> result;
    if (!(costs[m - 1] < infinity_))
      return result;
    for (std::size_t i = n - 1, j = m - 1; i + j > 0;) {
      const bool is_along_p = comes_along_p[i * m + j] != 0;
      (is_along_p ? i : j) -= 1;
      result.push_back({i, j, is_along_p});
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

public:
  // The triangles pass p in its direction, and q against it.
  Strip_triangulation(const std::vector<Vector>& points, std::vector<Index> p,
                      std::vector<Index> q)
    : points_(points), p_(std::move(p)), q_(std::move(q)) {}

  // Returns usable triangles; none if it finds none.
  template <class Is_usable>
  std::vector<Corners> operator()(const Is_usable& is_usable)
  {
    if (p_.size() > largest_number_of_states_ / 2 / q_.size())
      return {};
    states_.assign(2 * p_.size() * q_.size(), UNKNOWN);
    for (int round = 0; round < 50; ++round) {
      const std::vector<Step> steps = best_steps();
      std::vector<Corners> result;
      bool are_usable = true;
      for (const Step& s : steps) {
        result.push_back(triangle(s));
        if (state(s) == UNKNOWN)
          state(s) = is_usable(result.back()) ? USABLE : UNUSABLE;
        are_usable = are_usable && state(s) == USABLE;
      }
      if (steps.empty() || are_usable)
        return result;
    }
    return {};
  }
};

// Returns a cap of an opening. A triangle at an edge of a loop goes to the other segment there, any
// other to the first such segment.
inline Cap cap_of(const Segmented_solid& solid, const Opening& opening,
                  const std::vector<Corners>& triangles)
{
  const auto neighbor_at = [&](const Vertex_pair& edge)
  { return solid.borders().segment_at(edge.first, edge.second, opening.segment); };
  Cap result;
  for (const Corners& t : triangles) {
    Index neighbor = neighbor_at(*opening.edges.begin());
    for (int i = 0; i < 3; ++i)
      if (opening.edges.count(vertex_pair(t[i], t[(i + 1) % 3])) > 0)
        neighbor = neighbor_at(vertex_pair(t[i], t[(i + 1) % 3]));
    result.add(t, neighbor);
  }
  return result;
}

// Returns the mean distance of the vertices of the smaller loop from the nearest vertices of the
// larger one.
inline double distance(const std::vector<Vector>& points, const Loop& a, const Loop& b)
{
  if (a.size() > b.size())
    return distance(points, b, a);
  double result = 0;
  for (Index v : a) {
    double smallest = (std::numeric_limits<double>::infinity)();
    for (Index w : b)
      smallest = (std::min)(smallest, (points[v] - points[w]).norm());
    result += smallest / static_cast<double>(a.size());
  }
  return result;
}

// The edges of caps that lead from one wall to another.
typedef std::set<Vertex_pair> Crossings;

// Returns a cap between two sides, which belong to the loops of an opening and run in parallel; it
// is empty if none fits. Adds the new edges to the crossings.
inline Cap strip(Segmented_solid& solid, const Loop& p, const Loop& q, const Opening& opening,
                 Crossings& crossings)
{
  const std::vector<Corners> triangles = Strip_triangulation(solid.points(), p, q)(
    [&](const Corners& t) { return solid.fit({t}, opening); });
  bool fit = solid.fit(triangles, opening); // together
  for_each_edge(sorted_sides(triangles), [&](std::size_t, std::size_t n) { fit = fit && n <= 2; });
  if (!fit)
    return {};
  for (const Corners& t : triangles)
    for (int i = 0; i < 3; ++i)
      if (opening.edges.count(vertex_pair(t[i], t[(i + 1) % 3])) == 0)
        crossings.insert(vertex_pair(t[i], t[(i + 1) % 3]));
  return cap_of(solid, opening, triangles);
}

// Returns a cap between two walls for a loop that crosses from one to the other and back, along
// edges of other such caps.
inline Cap strip(Segmented_solid& solid, const Opening& opening, Crossings& crossings)
{
  const Loop& loop = opening.loops[0];
  const std::size_t n = loop.size();
  const auto is_crossing = [&](std::size_t i)
  { return crossings.count(vertex_pair(loop[i % n], loop[(i + 1) % n])) > 0; };
  std::vector<std::size_t> middles; // one per sequence of crossing edges
  for (std::size_t i = 0; i < n; ++i)
    if (is_crossing(i) && !is_crossing(i + n - 1)) {
      std::size_t end = i;
      while (end < i + n && is_crossing(end))
        ++end;
      middles.push_back((i + end - 1) / 2);
    }
  if (middles.size() != 2)
    return {};
  Loop p, q;
  for (std::size_t i = middles[0] + 1; i <= middles[1]; ++i)
    p.push_back(loop[i % n]);
  for (std::size_t i = middles[0] + n; i > middles[1]; --i)
    q.push_back(loop[i % n]);
  return strip(solid, p, q, opening, crossings);
}

// Returns a ring between the two loops of an opening, from their nearest vertices on.
inline Cap ring(Segmented_solid& solid, const Opening& opening, Crossings& crossings)
{
  Loop p = opening.loops[0], q = opening.loops[1];
  std::size_t i = 0, j = 0;
  double smallest = (std::numeric_limits<double>::infinity)();
  for (std::size_t a = 0; a < p.size(); ++a)
    for (std::size_t b = 0; b < q.size(); ++b) {
      const double distance = (solid.points()[p[a]] - solid.points()[q[b]]).norm();
      if (distance < smallest) {
        smallest = distance;
        i = a;
        j = b;
      }
    }
  std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(i), p.end());
  std::rotate(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(j), q.end());
  p.push_back(p[0]);
  q.push_back(q[0]);
  std::reverse(q.begin(), q.end());
  return strip(solid, p, q, opening, crossings);
}

// Returns a flat cap of a loop with holes; it is empty if it would intersect something.
inline Cap flat_ring(Segmented_solid& solid, const Opening& opening)
{
  std::vector<std::vector<Vector> > points;
  Loop all;
  for (const Loop& loop : opening.loops) {
    points.emplace_back();
    for (Index v : loop)
      points.back().push_back(solid.points()[v]);
    all.insert(all.end(), loop.begin(), loop.end());
  }
  std::vector<Corners> triangles = flat_triangulation(points);
  for (Corners& t : triangles)
    t = {all[t[0]], all[t[1]], all[t[2]]};
  return solid.fit(triangles, opening) ? cap_of(solid, opening, triangles) : Cap();
}

// A loop that may be a border of a ring.
struct Wall_loop
{
  Loop loop;
  Vector middle, normal;
  double radius = 0; // the largest distance of a vertex from the middle
  std::set<Index> neighbors;
  double convergence = 0; // the mean cosine between `inward` and the direction to the middle

  // Returns whether this loop may be on the outer wall, and another one opposite.
  bool is_around(const Wall_loop& other) const
  {
    return convergence > -0.05 && other.convergence < 0.05 &&
           convergence >= other.convergence && normal.dot(other.normal) < 0 &&
           (middle - other.middle).norm() < radius + other.radius &&
           std::any_of(neighbors.begin(), neighbors.end(),
                       [&other](Index s) { return other.neighbors.count(s) > 0; });
  }
};

inline Wall_loop wall_loop(const Segmented_solid& solid, const Loop& loop, Index segment)
{
  Wall_loop result;
  result.loop = loop;
  const std::vector<Vector>& points = solid.points();
  const double n = static_cast<double>(loop.size());
  Vector& middle = result.middle;
  for (Index v : loop)
    middle += points[v] / n;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Index v = loop[i], w = loop[(i + 1) % loop.size()];
    result.radius = (std::max)(result.radius, (points[v] - middle).norm());
    result.normal += (points[v] - middle).cross(points[w] - middle);
    result.neighbors.insert(solid.borders().segment_at(v, w, segment));
    result.convergence += (middle - points[v]).normalized().dot(solid.inward(v)) / n;
  }
  return result;
}

// Returns the caps between opposite loops of a segment, and removes these loops. Reserves the caps.
// A segment between two walls has, for each neighbor, one loop on the outer wall and one or more on
// the inner wall.
inline std::vector<Cap> rings(Segmented_solid& solid, std::vector<Loop>& loops, Index segment,
                              const Border& border, Crossings& crossings)
{
  std::vector<Wall_loop> open;
  for (const Loop& loop : loops)
    open.push_back(wall_loop(solid, loop, segment));
  std::stable_sort(open.begin(), open.end(), [](const Wall_loop& a, const Wall_loop& b)
                   { return a.normal.norm() > b.normal.norm(); });
  const std::size_t n = open.size();
  std::vector<Cap> result;
  std::vector<char> is_closed(n, 0);
  const auto add = [&](const Cap& cap, const std::vector<std::size_t>& closed_loops) {
    if (cap.empty())
      return;
    solid.reserve(cap);
    result.push_back(cap);
    for (std::size_t i : closed_loops)
      is_closed[i] = 1;
  };
  struct Pair
  {
    double distance;
    std::size_t outer, inner;
  };
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < n; ++a) {
    if (is_closed[a])
      continue;
    std::vector<std::size_t> numbers(1, a);
    std::vector<Loop> with_holes(1, open[a].loop);
    for (std::size_t b = 0; b < n; ++b)
      if (!is_closed[b] && open[a].is_around(open[b])) {
        numbers.push_back(b);
        with_holes.push_back(open[b].loop);
        pairs.push_back({distance(solid.points(), open[a].loop, open[b].loop), a, b});
      }
    const bool has_sectors = with_holes.size() == 2 && open[a].neighbors.size() > 1;
    if (with_holes.size() > 1 && !has_sectors)
      add(flat_ring(solid, {segment, border, with_holes}), numbers);
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b)
                   { return a.distance < b.distance; });
  std::vector<int> number_of_tries(n, 0);
  for (const auto& [distance, outer, inner] : pairs)
    if (!is_closed[outer] && !is_closed[inner] && number_of_tries[outer]++ < 3 &&
        number_of_tries[inner]++ < 3)
      add(ring(solid, {segment, border, {open[outer].loop, open[inner].loop}}, crossings),
          {outer, inner});
  loops.clear();
  for (std::size_t i = 0; i < n; ++i)
    if (!is_closed[i])
      loops.push_back(open[i].loop);
  return result;
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_WALL_CAPS_H
