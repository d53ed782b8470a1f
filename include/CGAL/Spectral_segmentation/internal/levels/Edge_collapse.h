// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_EDGE_COLLAPSE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_EDGE_COLLAPSE_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A sum of squared distances to planes, weighted by the squared lengths of their normals.
class Planes
{
  Symmetric_matrix matrix_;
  Vector right_;

public:
  // Adds the plane through a point.
  void add(const Vector& normal, const Vector& at)
  {
    matrix_ += Symmetric_matrix::square(normal);
    right_ += normal.dot(at) * normal;
  }

  // Returns the step from a point to the minimizer of the sum; NaN without planes. Regularization,
  // relative to the trace, keeps it short in directions that the planes leave free.
  Vector step_from(const Vector& point, double regularization) const
  {
    const double diagonal = regularization * matrix_.trace() + 1e-300;
    const Symmetric_matrix matrix = matrix_ + Symmetric_matrix{diagonal, diagonal, diagonal};
    return matrix.inverse() * (right_ - matrix_ * point);
  }
};

// Collapses edges, the shortest first, until few faces are left. The remaining vertex minimizes the
// squared distances to the planes of the faces around it, weighted by their squared areas,
// similarly to the volume optimization of Lindstrom and Turk (1998). CGAL's edge_collapse() takes
// ten times as long (row `coarsening` of benchmark/performance at commit 5ffb392).
//
// Each vertex has two positions. The coarsely rounded one determines the order of the edges, so
// that little noise in the points does not change it. The precise one is used for everything else,
// because faces with coarsely rounded corners would be bumpy. A hash breaks ties.
// Therefore the result does not depend on the indices of vertices and faces.
class Edge_collapse : private Surface
{
  typedef boost::container::small_vector<Index, 16> Index_list;

  Run_monitor& monitor_;
  std::vector<Vector> rounded_;  // the positions for the order; midpoints after collapses
  std::vector<Index> became_;    // the vertex that each vertex was merged into, or itself
  std::vector<char> is_fixed_;   // one per vertex: its edges are not collapsed

  static constexpr std::size_t tries_between_checks = 1 << 12; // a few milliseconds
  // The most faces around both ends of an edge that is collapsed. Hubs of thousands of faces, such
  // as polygons of random corners have, would take quadratic time.
  static constexpr std::size_t most_faces_around = 256;
  static constexpr double smallest_cosine = 0.3; // between a normal before and after a collapse

  // The squared length of an edge between rounded positions, a hash of its place (Knuth 1973), its
  // place between the precise positions, and a halfedge. Coordinates have few digits, so that all
  // are exact, whichever multiplications the compiler fuses with additions.
  typedef std::tuple<double, std::uint64_t, double, Index> Edge;
  typedef std::priority_queue<Edge, std::vector<Edge>, std::greater<Edge> > Edge_queue;

  // Returns whether a face was removed.
  bool is_gone(Index f) const { return corners[f][0] == null_index; }

  // Returns the halfedges that leave the source of h, one for each face around it. If there are
  // more than `most_faces_around`, some are missing.
  Index_list around_source(Index h) const
  {
    Index_list result;
    for (Index g = h;;) {
      result.push_back(g);
      if (is_border(previous(g)) || result.size() > most_faces_around)
        break;
      g = opposite[previous(g)];
      if (g == h)
        return result;
    }
    for (Index g = h; !is_border(g) && result.size() <= most_faces_around;) {
      g = next(opposite[g]);
      result.push_back(g);
    }
    return result;
  }

  // Returns whether there are at most three faces around the source of h, and no border.
  bool has_few_faces_around(Index h) const
  {
    Index g = h;
    for (int i = 0; i < 3; ++i) {
      if (is_border(previous(g)))
        return false;
      g = opposite[previous(g)];
      if (g == h)
        return true;
    }
    return false;
  }

  bool are_at_border(const Index_list& around) const
  {
    return std::any_of(around.begin(), around.end(), [&](Index h)
      { return is_border(h) || is_border(previous(h)); });
  }

  Index_list neighbors(const Index_list& around) const
  {
    Index_list result;
    for (Index h : around) {
      result.push_back(target_vertex(h));
      result.push_back(source_vertex(previous(h)));
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  Edge edge(Index h) const
  {
    const Vector direction(0.5377f, 0.6211f, 0.5701f); // in which shapes have no symmetry
    const Index v = source_vertex(h), w = target_vertex(h);
    const double place = direction.dot(rounded_[v] + rounded_[w]) + 0.; // no negative zero
    std::uint64_t bits;
    std::memcpy(&bits, &place, sizeof(bits));
    return {(rounded_[v] - rounded_[w]).squared_norm(), bits * 0x9e3779b97f4a7c15,
            direction.dot(points[v] + points[w]), h};
  }

  // Returns the normal of the face of h if the source of h moves to a point.
  Vector normal_at(Index h, const Vector& point) const
  { return (points[target_vertex(h)] - point).cross(points[source_vertex(previous(h))] - point); }

  // Returns the point nearest to the planes around the two ends of an edge, not far from its
  // middle.
  Vector best_point(Index h, const Index_list& around_u, const Index_list& around_v) const
  {
    const Vector &p = points[source_vertex(h)], &q = points[target_vertex(h)], middle = (p + q) / 2;
    Planes planes;
    for (const Index_list* around : {&around_u, &around_v})
      for (Index g : *around) {
        const Vector &at = points[source_vertex(g)], n = normal_at(g, at);
        planes.add(n, at - middle);
        // Planes along the border keep the border in place.
        for (Index e : {g, previous(g)})
          if (is_border(e))
            planes.add((points[target_vertex(e)] - points[source_vertex(e)])
                         .cross(n.stably_normalized()) * (q - p).norm(), at - middle);
      }
    const Vector step = planes.step_from(Vector(), 1e-3);
    const bool is_near = step.squared_norm() <= (q - p).squared_norm(); // false for NaN
    return quantized(is_near ? middle + step : middle);
  }

  // Returns whether the link condition (Dey et al. 1999) holds and no face flips; sets `point`.
  bool can_collapse(Index h, const Index_list& around_u, const Index_list& around_v,
                    Vector& point) const
  {
    const Index u = source_vertex(h), v = target_vertex(h), o = opposite[h];
    const bool u_on_border = are_at_border(around_u), v_on_border = are_at_border(around_v);
    if (u_on_border && v_on_border && o != h)
      return false;
    const Index_list neighbors_u = neighbors(around_u), neighbors_v = neighbors(around_v);
    Index_list common;
    std::set_intersection(neighbors_u.begin(), neighbors_u.end(),
                          neighbors_v.begin(), neighbors_v.end(), std::back_inserter(common));
    if (common.size() != (o == h ? 1 : 2))
      return false;
    for (Index e : {h, o}) {
      if (is_border(next(e)) && is_border(previous(e)))
        return false;
      if (has_few_faces_around(previous(e)))
        return false;
    }
    if (o != h && (u_on_border || v_on_border))
      point = points[u_on_border ? u : v];
    else
      point = best_point(h, around_u, around_v);
    for (const Index_list* around : {&around_u, &around_v})
      for (Index g : *around) {
        if (g / 3 == h / 3 || g / 3 == o / 3)
          continue;
        const Vector before = normal_at(g, points[source_vertex(g)]), after = normal_at(g, point);
        if (!before.is_zero() &&
            !(after.dot(before) > smallest_cosine * after.norm() * before.norm()))
          return false;
      }
    return true;
  }

  // Removes the face of e by joining its two outer edges.
  void remove_face(Index e)
  {
    const Index a = opposite[next(e)], b = opposite[previous(e)];
    const bool a_is_border = is_border(next(e)), b_is_border = is_border(previous(e));
    if (!a_is_border)
      opposite[a] = b_is_border ? a : b;
    if (!b_is_border)
      opposite[b] = a_is_border ? b : a;
    corners[e / 3][0] = null_index;
  }

  void collapse(Index h, const Index_list& around_u, const Index_list& around_v,
                const Vector& point, Edge_queue& edges)
  {
    const Index u = source_vertex(h), v = target_vertex(h), o = opposite[h];
    for (Index g : around_v)
      corners[g / 3][g % 3] = u;
    points[u] = point;
    rounded_[u] = (rounded_[u] + rounded_[v]) / 2;
    became_[v] = u;
    remove_face(h);
    if (o != h)
      remove_face(o);
    for (const Index_list* around : {&around_u, &around_v})
      for (Index g : *around)
        if (!is_gone(g / 3)) {
          edges.push(edge(g));
          if (is_border(previous(g)))
            edges.push(edge(previous(g)));
        }
  }

public:
  // Takes the step to which positions are rounded for the order, which has few binary digits.
  Edge_collapse(const Surface& mesh, double step_of_rounding, Run_monitor& monitor)
    : Surface(mesh), monitor_(monitor), became_(first_indices(points.size())),
      is_fixed_(points.size(), 0)
  {
    for (const Vector& p : points)
      rounded_.push_back(rounded(p, step_of_rounding));
    std::vector<Index> outgoing(points.size(), null_index);
    std::vector<Index> number_of_faces_around(points.size(), 0);
    for (Index h = 0; h < opposite.size(); ++h) {
      outgoing[source_vertex(h)] = h;
      ++number_of_faces_around[source_vertex(h)];
    }
    // A vertex where several fans of faces meet is fixed, because around_source() visits one fan,
    // and so is a vertex with too many faces.
    for (Index v = 0; v < points.size(); ++v)
      is_fixed_[v] = outgoing[v] == null_index ||
                     around_source(outgoing[v]).size() != number_of_faces_around[v];
  }

  // Collapses edges until at most `number` faces, or no candidate edge, is left.
  void collapse_edges(std::size_t number)
  {
    std::vector<Edge> all;
    all.reserve(number_of_halfedges()); // twice as many as there are edges
    for (Index h = 0; h < number_of_halfedges(); ++h)
      if (h <= opposite[h])
        all.push_back(edge(h));
    Edge_queue edges(std::greater<Edge>(), std::move(all)); // stale entries are skipped
    std::size_t left = number_of_faces(), tries = 0;
    while (left > number && !edges.empty()) {
      if (++tries % tries_between_checks == 0)
        monitor_.check();
      const Edge shortest = edges.top();
      edges.pop();
      const Index h = std::get<Index>(shortest);
      if (is_gone(h / 3) || edge(h) != shortest || is_fixed_[source_vertex(h)] ||
          is_fixed_[target_vertex(h)])
        continue;
      const Index_list around_u = around_source(h), around_v = around_source(next(h));
      Vector point;
      if (around_u.size() + around_v.size() <= most_faces_around &&
          can_collapse(h, around_u, around_v, point)) {
        left -= is_border(h) ? 1 : 2;
        collapse(h, around_u, around_v, point, edges);
      }
    }
  }

  // Returns the surface of the remaining faces.
  Level result()
  {
    Level result;
    Surface& graph = result.surface;
    std::vector<Index> new_vertex(points.size(), null_index), new_face(number_of_faces());
    for (Index f = 0; f < number_of_faces(); ++f) {
      if (is_gone(f))
        continue;
      new_face[f] = static_cast<Index>(result.parent_face.size());
      result.parent_face.push_back(f);
      if (components.number > 1)
        graph.components.labels.push_back(components[f]);
      for (Index v : corners[f])
        if (new_vertex[v] == null_index) {
          new_vertex[v] = static_cast<Index>(graph.points.size());
          graph.points.push_back(points[v]);
        }
    }
    graph.components.number = components.number;
    for (Index f : result.parent_face) {
      const Corners& c = corners[f];
      graph.corners.push_back({new_vertex[c[0]], new_vertex[c[1]], new_vertex[c[2]]});
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        graph.opposite.push_back(3 * new_face[neighbor(h)] + opposite[h] % 3);
    }
    // Follows the chain of merges of each vertex.
    for (Index v = 0; v < became_.size(); ++v) {
      Index last = v;
      while (became_[last] != last)
        last = became_[last] = became_[became_[last]];
      result.coarse_vertex.push_back(new_vertex[last]);
    }
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_EDGE_COLLAPSE_H
