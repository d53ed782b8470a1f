// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_WALL_CAPPING_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_WALL_CAPPING_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/Segmented_solid.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>
#include <CGAL/Segmented_mesh/internal/capping/triangulated_loop.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// The cost that a strip minimizes: the sum of the squared lengths of its edges from side to side,
// or the area.
enum class Strip_cost { LENGTHS, AREA };

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
  Strip_cost cost_;
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
    if (cost_ == Strip_cost::AREA)
      return normal(points_, triangle(s)).norm();
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

  // Marks the triangle with the longer perimeter of any two that intersect, and triangles that
  // repeat an edge, for example where a ring has an entire side at one corner. Returns whether
  // there are any.
  bool mark_conflicts(const std::vector<Step>& steps, const std::vector<Corners>& triangles)
  {
    bool result = false;
    std::set<std::pair<Index, Index> > edges;
    for (const Step& s : steps)
      if (!edges.emplace(p_[s.i], q_[s.j]).second) {
        state(s) = UNUSABLE;
        result = true;
      }
    for_intersecting_pairs(points_, triangles, [&](Index a, Index b) {
      if (a > b)
        std::swap(a, b);
      state(steps[perimeter(triangles[a]) > perimeter(triangles[b]) ? a : b]) = UNUSABLE;
      result = true;
    });
    return result;
  }

  double perimeter(const Corners& t) const
  {
    return (points_[t[1]] - points_[t[0]]).norm() + (points_[t[2]] - points_[t[1]]).norm() +
           (points_[t[0]] - points_[t[2]]).norm();
  }

public:
  // The triangles pass p in its direction, and q against it.
  Strip_triangulation(const std::vector<Vector>& points, std::vector<Index> p,
                      std::vector<Index> q, Strip_cost cost)
    : points_(points), p_(std::move(p)), q_(std::move(q)), cost_(cost) {}

  // Returns usable triangles that do not intersect each other; none if it finds none.
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
      if (steps.empty() || (are_usable && !mark_conflicts(steps, result)))
        return result;
    }
    return {};
  }
};

// Makes the caps of segments between two walls of a hollow body.
class Wall_capping : public Segmented_solid
{
  std::set<Vertex_pair> crossings_; // the edges of caps that lead from one wall to another

  typedef std::map<Vertex_pair, Index> Neighbors; // one segment per edge of a loop

  Neighbors neighbors_at(const std::vector<Loop>& loops, Index segment) const
  {
    Neighbors result;
    for (const Vertex_pair& edge : edges_of(loops))
      result[edge] = borders_.segment_at(edge.first, edge.second, segment);
    return result;
  }

  // Returns the pieces of a cap. A triangle at an edge of a loop goes to the neighbor there, any
  // other to the first neighbor.
  static Cap pieces(const std::vector<Corners>& triangles, const Neighbors& neighbors)
  {
    std::map<Index, std::vector<Corners> > piece_of;
    for (const Corners& t : triangles) {
      Index neighbor = neighbors.begin()->second;
      for (int i = 0; i < 3; ++i) {
        const auto found = neighbors.find(vertex_pair(t[i], t[(i + 1) % 3]));
        if (found != neighbors.end())
          neighbor = found->second;
      }
      piece_of[neighbor].push_back(t);
    }
    Cap result;
    for (auto& [neighbor, piece] : piece_of)
      result.push_back({neighbor, std::move(piece)});
    return result;
  }

  // Returns copies of the vertices of two sides, moved into the solid by a fraction of the distance
  // to the nearest adjacent vertex of the side or vertex of the other side.
  std::unordered_map<Index, Index> copies_inwards(const Loop& p, const Loop& q, double fraction)
  {
    std::unordered_map<Index, Index> result;
    for (const auto& [side, other] : {std::pair(&p, &q), std::pair(&q, &p)})
      for (std::size_t i = 0; i < side->size(); ++i) {
        const Index v = (*side)[i];
        if (result.count(v) > 0)
          continue;
        double smallest = distance({v}, *other);
        for (std::size_t j : {i - 1, i + 1})
          if (j < side->size())
            smallest = (std::min)(smallest, (points_[v] - points_[(*side)[j]]).norm());
        result[v] = add_point(points_[v] + fraction * smallest * inward(v));
      }
    return result;
  }

  // Returns a cap between two sides, which belong to loops of the border of a segment and run in
  // parallel; it is empty if every candidate intersects something. The first candidate has no
  // further points, and the others begin with strips inwards from the loops.
  Cap strip(const Loop& p, const Loop& q, const std::vector<Loop>& loops, Index segment,
            const Border& border)
  {
    const std::set<Vertex_pair> edges = edges_of(loops);
    const std::size_t n = points_.size();
    for (double fraction : {0., 0.3, 0.1, 0.03}) {
      Neighbors neighbors = neighbors_at(loops, segment);
      std::vector<Corners> rims;
      Loop inner_p = p, inner_q = q;
      if (fraction > 0) {
        if (!are_disjoint(loops))
          break; // both would have the same copy of a vertex
        const auto copies = copies_inwards(p, q, fraction);
        const auto copy = [&copies](Index v) { return copies.at(v); };
        for (const Loop& loop : loops) {
          Loop rim(loop.size());
          std::transform(loop.begin(), loop.end(), rim.begin(), copy);
          add_strip(loop, rim, 0, loop.size(), rims);
        }
        std::transform(p.begin(), p.end(), inner_p.begin(), copy);
        std::transform(q.begin(), q.end(), inner_q.begin(), copy);
        for (const Vertex_pair& edge : edges)
          neighbors[vertex_pair(copy(edge.first), copy(edge.second))] = neighbors[edge];
      }
      const auto is_usable = [&](const std::vector<Corners>& triangles) {
        const Cap cap = {{segment, triangles}};
        return !takes_an_edge_twice(cap, edges) && leads_inwards(cap, segment, border) &&
               is_free(cap);
      };
      if (is_usable(rims))
        for (Strip_cost cost : {Strip_cost::LENGTHS, Strip_cost::AREA}) {
          std::vector<Corners> triangles = Strip_triangulation(points_, inner_p, inner_q, cost)(
            [&](const Corners& t) { return is_usable({t}); });
          if (triangles.empty())
            continue;
          triangles.insert(triangles.end(), rims.begin(), rims.end());
          if (!rims.empty() && do_self_intersect(points_, triangles))
            continue;
          for (const Corners& t : triangles)
            for (int i = 0; i < 3; ++i)
              if (edges.count(vertex_pair(t[i], t[(i + 1) % 3])) == 0)
                crossings_.insert(vertex_pair(t[i], t[(i + 1) % 3]));
          return pieces(triangles, neighbors);
        }
      points_.resize(n);
    }
    return {};
  }

  // Returns a ring between two loops, from their nearest vertices on.
  Cap ring(const Loop& outer, const Loop& inner, Index segment, const Border& border)
  {
    std::size_t i = 0, j = 0;
    double smallest = (std::numeric_limits<double>::infinity)();
    for (std::size_t a = 0; a < outer.size(); ++a)
      for (std::size_t b = 0; b < inner.size(); ++b) {
        const double distance = (points_[outer[a]] - points_[inner[b]]).norm();
        if (distance < smallest) {
          smallest = distance;
          i = a;
          j = b;
        }
      }
    Loop p = outer, q = inner;
    std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(i), p.end());
    std::rotate(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(j), q.end());
    p.push_back(p[0]);
    q.push_back(q[0]);
    std::reverse(q.begin(), q.end());
    return strip(p, q, {outer, inner}, segment, border);
  }

  // Returns a flat cap of a loop with holes; it is empty if it would intersect something.
  Cap flat_ring(const std::vector<Loop>& loops, Index segment, const Border& border)
  {
    std::vector<std::vector<Vector> > points;
    Loop all;
    for (const Loop& loop : loops) {
      points.emplace_back();
      for (Index v : loop)
        points.back().push_back(points_[v]);
      all.insert(all.end(), loop.begin(), loop.end());
    }
    std::vector<Corners> triangles = flat_triangulation(points);
    for (Corners& t : triangles)
      t = {all[t[0]], all[t[1]], all[t[2]]};
    Cap result = pieces(triangles, neighbors_at(loops, segment));
    if (takes_an_edge_twice(result, edges_of(loops)) ||
        !leads_inwards(result, segment, border) || !is_free(result))
      result.clear();
    return result;
  }

  // A loop that may be a border of a ring.
  struct Open_loop
  {
    Loop loop;
    Vector middle, normal;
    double radius; // the largest distance of a vertex from the middle
    std::vector<Index> neighbors;
    double convergence; // the mean cosine between `inward` and the direction to the middle

    // Returns whether this loop may be on the outer wall, and another one opposite.
    bool is_around(const Open_loop& other) const
    {
      return convergence > -0.05 && other.convergence < 0.05 &&
             convergence >= other.convergence && normal.dot(other.normal) < 0 &&
             (middle - other.middle).norm() < radius + other.radius &&
             std::find_first_of(neighbors.begin(), neighbors.end(), other.neighbors.begin(),
                                other.neighbors.end()) != neighbors.end();
    }
  };

  Open_loop open_loop(const Loop& loop, Index segment) const
  {
    Open_loop result{loop, {}, {}, 0, {}, 0};
    const double n = static_cast<double>(loop.size());
    Vector& middle = result.middle;
    for (Index v : loop)
      middle += points_[v] / n;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index v = loop[i], w = loop[(i + 1) % loop.size()];
      result.radius = (std::max)(result.radius, (points_[v] - middle).norm());
      result.normal += (points_[v] - middle).cross(points_[w] - middle);
      result.neighbors.push_back(borders_.segment_at(v, w, segment));
      result.convergence += (middle - points_[v]).normalized().dot(inward(v)) / n;
    }
    std::sort(result.neighbors.begin(), result.neighbors.end());
    result.neighbors.erase(std::unique(result.neighbors.begin(), result.neighbors.end()),
                           result.neighbors.end());
    return result;
  }

  // Returns the mean distance of the vertices of the smaller loop from the nearest vertices of the
  // larger one.
  double distance(const Loop& a, const Loop& b) const
  {
    if (a.size() > b.size())
      return distance(b, a);
    double result = 0;
    for (Index v : a) {
      double smallest = (std::numeric_limits<double>::infinity)();
      for (Index w : b)
        smallest = (std::min)(smallest, (points_[v] - points_[w]).norm());
      result += smallest / static_cast<double>(a.size());
    }
    return result;
  }

protected:
  using Segmented_solid::Segmented_solid;

  static bool are_disjoint(const std::vector<Loop>& loops)
  {
    std::set<Index> vertices;
    std::size_t n = 0;
    for (const Loop& loop : loops) {
      vertices.insert(loop.begin(), loop.end());
      n += loop.size();
    }
    return vertices.size() == n;
  }

  // Appends a strip between a range of edges of a loop and of its copy.
  static void add_strip(const Loop& loop, const Loop& copy, std::size_t begin, std::size_t end,
                        std::vector<Corners>& triangles)
  {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t j = (i + 1) % loop.size();
      triangles.push_back({loop[i], loop[j], copy[j]});
      triangles.push_back({loop[i], copy[j], copy[i]});
    }
  }

  // Appends a cap unless it is empty, and returns whether it did.
  bool add_cap(const Cap& cap, std::vector<Cap>& caps)
  {
    if (cap.empty())
      return false;
    take(cap);
    caps.push_back(cap);
    return true;
  }

  // Returns a cap between two walls for a loop that crosses from one to the other and back, along
  // edges of other such caps.
  Cap strip_in(const Loop& loop, Index segment, const Border& border)
  {
    const std::size_t n = loop.size();
    const auto is_crossing = [&](std::size_t i)
    { return crossings_.count(vertex_pair(loop[i % n], loop[(i + 1) % n])) > 0; };
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
    return strip(p, q, {loop}, segment, border);
  }

  // Appends the caps between opposite loops, and removes these loops. A segment between two walls
  // has, for each neighbor, one loop on the outer wall and one or more on the inner wall.
  void add_rings(std::vector<Loop>& loops, Index segment, const Border& border,
                 std::vector<Cap>& caps)
  {
    std::vector<Open_loop> open;
    for (const Loop& loop : loops)
      open.push_back(open_loop(loop, segment));
    std::stable_sort(open.begin(), open.end(), [](const Open_loop& a, const Open_loop& b)
                     { return a.normal.norm() > b.normal.norm(); });
    const std::size_t n = open.size();
    std::vector<char> is_closed(n, 0);
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
          pairs.push_back({distance(open[a].loop, open[b].loop), a, b});
        }
      const bool has_sectors = with_holes.size() == 2 && open[a].neighbors.size() > 1;
      if (with_holes.size() > 1 && !has_sectors &&
          add_cap(flat_ring(with_holes, segment, border), caps))
        for (std::size_t i : numbers)
          is_closed[i] = 1;
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b)
                     { return a.distance < b.distance; });
    std::vector<int> number_of_tries(n, 0);
    for (const Pair& pair : pairs)
      if (!is_closed[pair.outer] && !is_closed[pair.inner] && number_of_tries[pair.outer]++ < 3 &&
          number_of_tries[pair.inner]++ < 3 &&
          add_cap(ring(open[pair.outer].loop, open[pair.inner].loop, segment, border), caps))
        is_closed[pair.outer] = is_closed[pair.inner] = 1;
    loops.clear();
    for (std::size_t i = 0; i < n; ++i)
      if (!is_closed[i])
        loops.push_back(open[i].loop);
  }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_WALL_CAPPING_H
