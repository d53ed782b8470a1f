// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_STRIP_TRIANGULATION_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_STRIP_TRIANGULATION_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// The cost that a strip minimizes: the sum of the squared lengths of its edges from side to side,
// or the area.
enum class Strip_cost { LENGTHS, AREA };

// Triangulates the strip between two polylines without further points. Edges join their first
// points and their last points; a ring has the same two points there. The algorithm is that of
// Fuchs, Kedem and Uselton, repeated without the triangles that turn out to be not usable.
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
  std::vector<State> states_; // of the steps along p and q from each edge

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

  // Returns the steps of least cost from the first to the last edge; none if there are none.
  std::vector<Step> best_steps()
  {
    const std::size_t n = p_.size(), m = q_.size();
    std::vector<char> comes_along_p(n * m, 0);
    std::vector<double> costs(m, infinity_); // of the edges from p[i]
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

  // Marks the longer one of any two triangles that intersect each other, and triangles that repeat
  // an edge, as at a corner of a ring that has all of one side. Returns whether there are some.
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

  // Returns triangles that intersect each other nowhere, and of which each is usable; none if it
  // finds none.
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

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_STRIP_TRIANGULATION_H
