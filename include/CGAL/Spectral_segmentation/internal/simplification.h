// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SIMPLIFICATION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SIMPLIFICATION_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/Principal_frame.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>

#include <CGAL/Iterator_range.h>

#include <boost/container/small_vector.hpp>
#include <boost/iterator/counting_iterator.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// A mesh of the same shape and topology with fewer faces, all of about the same size.
struct Simplified_mesh
{
  Face_dual_graph graph;       // its sizes are set, its face distances are left open
  std::vector<Index> faces;    // of the mesh, ascending: what is left of them are the graph's
  std::vector<Index> vertices; // of the graph: which one each vertex of the mesh became
};

// Edges by length, the shortest first. All but those of about the shortest length wait in buckets,
// as one heap of all edges would be slow to reach in memory.
class Edges_by_length
{
public:
  typedef std::pair<std::uint64_t, Index> Edge; // its key, which begins with the length; half-edge

private:
  // Of lengths that are equal in their exponent and the first bits of their mantissa.
  static constexpr int bits_of_bucket = 13;
  typedef std::priority_queue<Edge, std::vector<Edge>, std::greater<Edge> > Queue;

  std::vector<std::vector<Edge> > buckets_;
  std::size_t current_ = 0;
  Queue queue_; // of the current bucket and those before

  // Without the sign, which is 0.
  static std::size_t bucket(std::uint64_t key) { return key >> (63 - bits_of_bucket); }

public:
  Edges_by_length() : buckets_(std::size_t(1) << bits_of_bucket) {}

  // The squared length decides, then the other number.
  static std::uint64_t key(float squared_length, std::uint32_t other)
  {
    std::uint32_t bits; // of a float that is not negative, in the order of the floats
    std::memcpy(&bits, &squared_length, sizeof(bits));
    return (std::uint64_t(bits) << 32) | other;
  }

  void push(const Edge& edge)
  {
    if (bucket(edge.first) <= current_)
      queue_.push(edge);
    else
      buckets_[bucket(edge.first)].push_back(edge);
  }

  // The shortest edge leaves; none if there are no more.
  std::optional<Edge> pop()
  {
    while (queue_.empty()) {
      if (++current_ >= buckets_.size())
        return std::nullopt;
      queue_ = Queue(std::greater<Edge>(), std::exchange(buckets_[current_], {}));
    }
    const Edge result = queue_.top();
    queue_.pop();
    return result;
  }
};

// Collapses edges, the shortest first, until few faces are left. The vertex that is left goes where
// it keeps the planes of the faces around, weighted by their squared areas, as Lindstrom and Turk
// (1998) keep the volume. CGAL's edge_collapse() does as much for any mesh, in ten times the time.
//
// The faces of a large mesh are first dealt with in compact domains, where vertices that domains
// have in common stay: in parallel, and because memory likes it.
//
// It works in the principal frame, with coordinates on a grid, and breaks ties by a hash of them,
// so that the result moves with the mesh and does not depend on the numbers of its vertices and
// faces.
template <class ConcurrencyTag>
class Edge_collapse
{
  typedef boost::container::small_vector<Index, 16> Some;

  std::vector<std::array<Index, 3> > corners_; // null_index for faces that are gone
  std::vector<Index> opposite_;                // of each half-edge; null_index on the border
  std::vector<Vector> points_;
  std::vector<Index> became_;                  // what each vertex was joined to, or itself
  std::vector<char> is_fixed_;                 // vertices that stay as they are
  std::vector<char> is_on_seam_;               // of domains; empty without domains

  static constexpr std::size_t faces_per_domain = 1 << 13;

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index source(Index h) const { return corners_[h / 3][h % 3]; }
  Index target(Index h) const { return source(next(h)); }
  bool is_gone(Index f) const { return corners_[f][0] == null_index; }
  bool is_on_seam(Index v) const { return !is_on_seam_.empty() && is_on_seam_[v]; }
  bool must_stay(Index v) const { return is_fixed_[v] || is_on_seam(v); }

  static constexpr double steps_per_unit = 1 << 30; // of the grid of coordinates

  static Vector on_fine_grid(const Vector& p)
  {
    return ((p.array() * steps_per_unit + 0.5).floor() / steps_per_unit).matrix();
  }

  // The half-edges that leave the source of h, one for each face around it.
  Some around_source(Index h) const
  {
    Some result;
    Index g = h;
    do {
      result.push_back(g);
      g = opposite_[previous(g)];
    } while (g != null_index && g != h);
    if (g == null_index)
      for (g = h; opposite_[g] != null_index;) {
        g = next(opposite_[g]);
        result.push_back(g);
      }
    return result;
  }

  // Whether there are at most three faces around the source of h, and no border.
  bool has_few_faces_around(Index h) const
  {
    Index g = h;
    for (int i = 0; i < 3; ++i) {
      g = opposite_[previous(g)];
      if (g == null_index || g == h)
        return g == h;
    }
    return false;
  }

  bool is_on_border(const Some& around) const
  {
    return std::any_of(around.begin(), around.end(), [&](Index h)
      { return opposite_[h] == null_index || opposite_[previous(h)] == null_index; });
  }

  Some neighbors(const Some& around) const
  {
    Some result;
    for (Index h : around) {
      result.push_back(target(h));
      result.push_back(source(previous(h)));
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Of a point on the grid. The same on every machine, unlike the hashes of libraries: the finalizer
  // of SplitMix64 (Steele, Lea, Flood 2014).
  static std::uint32_t hash(const Vector& p)
  {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) {
      h += static_cast<std::uint64_t>(static_cast<std::int64_t>(p[i] * steps_per_unit)) +
           0x9e3779b97f4a7c15;
      h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9;
      h = (h ^ (h >> 27)) * 0x94d049bb133111eb;
      h ^= h >> 31;
    }
    return static_cast<std::uint32_t>(h);
  }

  std::uint64_t key(Index h) const
  {
    const Vector &p = points_[source(h)], &q = points_[target(h)];
    return Edges_by_length::key(static_cast<float>((q - p).squaredNorm()), hash(p + q));
  }

  // Of the face of h if the source of h moves.
  Vector normal(Index h, const Vector& point) const
  { return (points_[target(h)] - point).cross(points_[source(previous(h))] - point); }

  static void add_plane(const Vector& normal, const Vector& offset, Eigen::Matrix3d& matrix,
                        Vector& right)
  {
    matrix += normal * normal.transpose();
    right += normal * normal.dot(offset);
  }

  // The point nearest to the planes around the two ends of an edge, and not far from its middle.
  Vector best_point(Index h, const Some& around_u, const Some& around_v) const
  {
    const Vector &p = points_[source(h)], &q = points_[target(h)], middle = (p + q) / 2;
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Vector right = Vector::Zero();
    for (const Some* around : {&around_u, &around_v})
      for (Index g : *around) {
        const Vector &at = points_[source(g)], n = normal(g, at);
        add_plane(n, at - middle, matrix, right);
        // Planes along the border keep it where it is.
        for (Index e : {g, previous(g)})
          if (opposite_[e] == null_index)
            add_plane((points_[target(e)] - points_[source(e)]).cross(n.stableNormalized()) *
                        (q - p).norm(), at - middle, matrix, right);
      }
    matrix.diagonal().array() += 1e-3 * matrix.trace() + 1e-300;
    const Vector step = matrix.inverse() * right;
    const bool is_near = step.allFinite() && step.squaredNorm() <= (q - p).squaredNorm();
    return is_near ? on_fine_grid(middle + step) : on_fine_grid(middle);
  }

  // The link condition (Dey et al. 1999), and no face must turn over.
  bool can_collapse(Index h, const Some& around_u, const Some& around_v, Vector& point) const
  {
    const Index u = source(h), v = target(h), o = opposite_[h];
    const bool u_on_border = is_on_border(around_u), v_on_border = is_on_border(around_v);
    if (u_on_border && v_on_border && o != null_index)
      return false;
    const Some of_u = neighbors(around_u), of_v = neighbors(around_v);
    Some common;
    std::set_intersection(of_u.begin(), of_u.end(), of_v.begin(), of_v.end(),
                          std::back_inserter(common));
    if (common.size() != (o == null_index ? 1 : 2))
      return false;
    for (Index e : {h, o}) {
      if (e == null_index)
        continue;
      if (opposite_[next(e)] == null_index && opposite_[previous(e)] == null_index)
        return false;
      // Not around a vertex on a seam: it has more faces, and other threads may be at work there.
      if (is_on_seam(source(previous(e))))
        continue;
      if (has_few_faces_around(previous(e)))
        return false;
    }
    if (o != null_index && (u_on_border || v_on_border))
      point = points_[u_on_border ? u : v];
    else
      point = best_point(h, around_u, around_v);
    for (const Some* around : {&around_u, &around_v})
      for (Index g : *around) {
        if (g / 3 == h / 3 || (o != null_index && g / 3 == o / 3))
          continue;
        const Vector before = normal(g, points_[source(g)]), after = normal(g, point);
        if (!before.isZero(0) && !(after.dot(before) > 0.3 * after.norm() * before.norm()))
          return false;
      }
    return true;
  }

  // Joins the two outer edges of the face of e, which goes.
  void remove_face(Index e)
  {
    const Index a = opposite_[next(e)], b = opposite_[previous(e)];
    if (a != null_index)
      opposite_[a] = b;
    if (b != null_index)
      opposite_[b] = a;
    corners_[e / 3][0] = null_index;
  }

  void collapse(Index h, const Some& around_u, const Some& around_v, const Vector& point,
                Edges_by_length& edges)
  {
    const Index u = source(h), v = target(h), o = opposite_[h];
    for (Index g : around_v)
      corners_[g / 3][g % 3] = u;
    points_[u] = point;
    became_[v] = u;
    remove_face(h);
    if (o != null_index)
      remove_face(o);
    for (const Some* around : {&around_u, &around_v})
      for (Index g : *around)
        if (!is_gone(g / 3)) {
          edges.push({key(g), g});
          if (opposite_[previous(g)] == null_index)
            edges.push({key(previous(g)), previous(g)});
        }
  }

  // Of some faces, until at most `number` of them are left or no edge is left to try.
  template <class Faces>
  void collapse_edges(const Faces& faces, std::size_t number)
  {
    Edges_by_length edges; // those that changed since are there again
    std::size_t left = 0;
    for (Index f : faces) {
      if (is_gone(f))
        continue;
      ++left;
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (opposite_[h] == null_index || h < opposite_[h])
          edges.push({key(h), h});
    }
    while (left > number) {
      const std::optional<Edges_by_length::Edge> shortest = edges.pop();
      if (!shortest)
        return;
      const auto [old_key, h] = *shortest;
      if (is_gone(h / 3) || key(h) != old_key || must_stay(source(h)) || must_stay(target(h)))
        continue;
      const Some around_u = around_source(h), around_v = around_source(next(h));
      Vector point;
      if (can_collapse(h, around_u, around_v, point)) {
        left -= opposite_[h] == null_index ? 1 : 2;
        collapse(h, around_u, around_v, point, edges);
      }
    }
  }

  // The faces in each cell of a grid, but for cells without a face, which are most of a large grid.
  std::vector<std::vector<Index> > domains() const
  {
    // A surface meets about as many cells as there are in two layers of the grid.
    const double width = std::ceil(
      std::sqrt(static_cast<double>(corners_.size()) / static_cast<double>(2 * faces_per_domain)));
    Vector smallest = points_.front(), largest = smallest;
    for (const Vector& p : points_) {
      smallest = smallest.cwiseMin(p);
      largest = largest.cwiseMax(p);
    }
    const double extent = (largest - smallest).maxCoeff();
    const double cells_per_length = extent > 0 ? width / extent : 0;
    const Index n = static_cast<Index>(width);
    std::vector<std::vector<Index> > result(n * n * n);
    for (Index f = 0; f < corners_.size(); ++f) {
      const std::array<Index, 3>& c = corners_[f];
      const Vector place =
        ((points_[c[0]] + points_[c[1]] + points_[c[2]]) / 3 - smallest) * cells_per_length;
      Index cell = 0;
      for (int i = 0; i < 3; ++i)
        cell = n * cell + (std::min)(static_cast<Index>((std::max)(place[i], 0.)), n - 1);
      result[cell].push_back(f);
    }
    result.erase(std::remove_if(result.begin(), result.end(),
                                [](const std::vector<Index>& faces) { return faces.empty(); }),
                 result.end());
    return result;
  }

  // How many faces there are for a unit of area if so many are shared by all domains, of which none
  // takes more than it has.
  static double shared_by_area(double number, const std::vector<std::vector<Index> >& faces,
                               const std::vector<double>& areas)
  {
    std::vector<std::pair<double, std::size_t> > full_at; // the faces per area that a domain has
    double area = 0;
    for (std::size_t d = 0; d < faces.size(); ++d)
      if (areas[d] > 0) {
        full_at.push_back({static_cast<double>(faces[d].size()) / areas[d], d});
        area += areas[d];
      }
    std::sort(full_at.begin(), full_at.end());
    for (const auto& [density, d] : full_at) {
      if (density * area >= number)
        return number / area;
      number -= static_cast<double>(faces[d].size());
      area -= areas[d];
    }
    return std::numeric_limits<double>::max();
  }

  void collapse_edges_by_domains(std::size_t number)
  {
    const std::vector<std::vector<Index> > faces = domains();
    std::vector<double> areas(faces.size(), 0);
    for_each_index<ConcurrencyTag>(faces.size(), [&](std::size_t d) {
      for (Index f : faces[d])
        areas[d] += normal(3 * f, points_[source(3 * f)]).norm();
    });
    std::vector<Index> domain(points_.size(), null_index);
    is_on_seam_.assign(points_.size(), 0);
    for (Index d = 0; d < faces.size(); ++d)
      for (Index f : faces[d])
        for (Index v : corners_[f]) {
          is_on_seam_[v] = is_on_seam_[v] || (domain[v] != null_index && domain[v] != d);
          domain[v] = d;
        }
    const double faces_per_area = shared_by_area(static_cast<double>(number), faces, areas);
    for_each_index<ConcurrencyTag>(faces.size(), [&](std::size_t d) {
      // Those with an edge on a seam are left besides.
      const auto at_seam = std::count_if(faces[d].begin(), faces[d].end(), [&](Index f) {
        const std::array<Index, 3>& c = corners_[f];
        return is_on_seam_[c[0]] + is_on_seam_[c[1]] + is_on_seam_[c[2]] >= 2;
      });
      const double all = static_cast<double>(faces[d].size());
      collapse_edges(faces[d], static_cast<std::size_t>(
        (std::min)(faces_per_area * areas[d] + static_cast<double>(at_seam), all)));
    });
    is_on_seam_.clear();
  }

public:
  explicit Edge_collapse(const Face_dual_graph& mesh)
    : corners_(mesh.corners), opposite_(mesh.halfedges.size(), null_index),
      points_(mesh.points.size()), became_(mesh.points.size()), is_fixed_(mesh.points.size(), 0)
  {
    const Principal_frame frame(mesh, ConcurrencyTag());
    for_each_index<ConcurrencyTag>(points_.size(), [&](std::size_t v)
      { points_[v] = on_fine_grid(frame.point(mesh.points[v])); });
    std::iota(became_.begin(), became_.end(), Index(0));
    for_each_index<ConcurrencyTag>(opposite_.size(), [&](Index h) {
      if (!mesh.is_border(h))
        opposite_[h] = mesh.opposite(h);
    });

    std::vector<Index> outgoing(points_.size(), null_index);
    std::vector<Index> number_of_faces_around(points_.size(), 0);
    for (Index h = 0; h < opposite_.size(); ++h) {
      outgoing[source(h)] = h;
      ++number_of_faces_around[source(h)];
    }
    // Where several fans of faces meet in a vertex, each knows nothing of the others.
    for_each_index<ConcurrencyTag>(outgoing.size(), [&](std::size_t v) {
      is_fixed_[v] = outgoing[v] == null_index ||
                     around_source(outgoing[v]).size() != number_of_faces_around[v];
    });
  }

  // Until at most `number_of_faces` are left, or no edge is left to try; or, if some more will do,
  // those that are left at the seams of domains besides.
  void collapse_edges(std::size_t number_of_faces, bool more_will_do)
  {
    const bool is_large = corners_.size() >= 4 * faces_per_domain;
    if (is_large)
      collapse_edges_by_domains(number_of_faces);
    if (!is_large || !more_will_do)
      collapse_edges(make_range(boost::counting_iterator<Index>(0),
                                boost::counting_iterator<Index>(Index(corners_.size()))),
                     number_of_faces);
  }

  Simplified_mesh result(double unit)
  {
    Simplified_mesh result;
    Face_dual_graph& graph = result.graph;
    graph.unit = unit;
    std::vector<Index> new_vertex(points_.size(), null_index), new_face(corners_.size());
    for (Index f = 0; f < corners_.size(); ++f) {
      if (is_gone(f))
        continue;
      new_face[f] = static_cast<Index>(result.faces.size());
      result.faces.push_back(f);
      for (Index v : corners_[f])
        if (new_vertex[v] == null_index) {
          new_vertex[v] = static_cast<Index>(graph.points.size());
          graph.points.push_back(points_[v]);
        }
    }
    graph.corners.resize(result.faces.size());
    graph.halfedges.resize(3 * result.faces.size());
    for_each_index<ConcurrencyTag>(result.faces.size(), [&](std::size_t i) {
      const Index f = result.faces[i];
      for (Index j = 0; j < 3; ++j) {
        const Index o = opposite_[3 * f + j];
        graph.corners[i][j] = new_vertex[corners_[f][j]];
        graph.halfedges[3 * i + j].neighbor = new_face[o == null_index ? f : o / 3];
      }
    });
    set_sizes<ConcurrencyTag>(graph);
    // A vertex became one of those before which it was joined, and so on.
    result.vertices.resize(points_.size());
    for (Index v = 0; v < became_.size(); ++v) {
      Index last = v;
      while (became_[last] != last)
        last = became_[last] = became_[became_[last]];
      result.vertices[v] = new_vertex[last];
    }
    return result;
  }
};

template <class ConcurrencyTag>
Simplified_mesh simplify(const Face_dual_graph& mesh, std::size_t number_of_faces,
                         bool more_will_do = false)
{
  Edge_collapse<ConcurrencyTag> collapse(mesh);
  collapse.collapse_edges(number_of_faces, more_will_do);
  return collapse.result(mesh.unit);
}

// Each the simplification of the one before, the first that of the mesh, in steps that leave about
// a sixteenth, so that the bands between the sides of cuts, which are as wide as the larger faces,
// stay small parts of each.
template <class ConcurrencyTag>
std::vector<Simplified_mesh> simplify_in_steps(const Face_dual_graph& mesh,
                                               std::size_t number_of_faces)
{
  constexpr std::size_t step = 16;
  std::vector<std::size_t> numbers(1, number_of_faces);
  while (numbers.back() < mesh.number_of_faces() / (2 * step))
    numbers.push_back(step * numbers.back());
  std::vector<Simplified_mesh> result;
  for (; !numbers.empty(); numbers.pop_back())
    result.push_back(simplify<ConcurrencyTag>(result.empty() ? mesh : result.back().graph,
                                              numbers.back(), numbers.size() > 1));
  return result;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SIMPLIFICATION_H
