// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_EDGE_COLLAPSE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_EDGE_COLLAPSE_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/surface/Principal_frame.h>
#include <CGAL/Spectral_segmentation/internal/base/Symmetric_matrix.h>
#include <CGAL/Spectral_segmentation/internal/surface/surface_integrals.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/Edge_queue.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/domains.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A mesh of the same shape and topology with fewer faces, all of about the same size.
struct Coarse_mesh
{
  Surface graph;            // has no weights
  std::vector<Index> faces;    // the faces of the mesh that remain as those of the graph, ascending
  std::vector<Index> vertices; // the vertex of the graph that each vertex became
};

// Collapses edges, the shortest first, until few faces are left. The vertex that is left goes where
// it keeps the planes of the faces around it, weighted by their squared areas, in the way in which
// Lindstrom and Turk (1998) keep the volume. CGAL's edge_collapse() takes ten times as long
// (benchmark/performance, coarsening).
//
// A large mesh is first divided into compact domains, which threads take one by one. Edges with an
// end on the seam, whose vertices belong to several domains, stay. Therefore all faces around both
// ends of an edge that collapses are in one domain. A collapse reads and writes the corners of
// these faces. It does the same with `opposite` of their halfedges and of the halfedges across
// edges at the two ends, which belong to these faces too. It writes the point of one end. It also
// reads points of neighboring vertices, which are in this domain, or on the seam, where no thread
// moves them. It does not walk around a third vertex that is on the seam. Therefore no thread reads
// data that another thread writes.
//
// Coordinates are whole numbers, in the principal frame and in a unit that depends on the area, and
// a hash of them breaks ties. Therefore the result moves and grows with the mesh and does not
// depend on the indices of its vertices and faces.
class Edge_collapse : private Surface
{
  typedef boost::container::small_vector<Index, 16> Index_list;

  const Execution execution_;
  Run_monitor& monitor_;
  const double progress_per_face_;

  std::vector<Index> became_;    // the vertex that each vertex was joined to, or itself
  std::vector<char> is_fixed_;   // vertices that stay as they are
  std::vector<char> is_on_seam_; // vertices of several domains; empty without domains

  static constexpr std::size_t faces_per_domain = 1 << 13;
  static constexpr std::size_t tries_between_checks = 1 << 12; // a few milliseconds

  // A face that is gone has no corners.
  bool is_gone(Index f) const { return corners[f][0] == null_index; }

  // Returns the halfedges that leave the source of h, one for each face around it.
  Index_list around_source(Index h) const
  {
    Index_list result;
    for (Index g = h;;) {
      result.push_back(g);
      if (is_border(previous(g)))
        break;
      g = opposite[previous(g)];
      if (g == h)
        return result;
    }
    for (Index g = h; !is_border(g);) {
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

  bool is_on_seam(Index v) const { return !is_on_seam_.empty() && is_on_seam_[v]; }
  bool must_stay(Index v) const { return is_fixed_[v] || is_on_seam(v); }

  static constexpr double smallest_cosine = 0.3; // between a normal before and after a collapse

  const double steps_per_unit_; // the resolution of the grid on which the points are

  static double steps_per_unit(double area)
  { return (1 << 24) / (std::max)(std::sqrt(area), 1e-6); }

  // Moves a point to the grid. Midpoints of grid points stay clear of where the last bit decides.
  static Vector on_grid(const Vector& p)
  { return Vector(std::floor(p.x() + 0.25), std::floor(p.y() + 0.25), std::floor(p.z() + 0.25)); }

  // Returns the hash of a point on the grid by the finalizer of SplitMix64 (Steele, Lea, Flood
  // 2014). It is the same on every machine, unlike the hashes of libraries.
  static std::uint32_t hash(const Vector& p)
  {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) {
      h += static_cast<std::uint64_t>(static_cast<std::int64_t>(p[i])) +
           0x9e3779b97f4a7c15;
      h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9;
      h = (h ^ (h >> 27)) * 0x94d049bb133111eb;
      h ^= h >> 31;
    }
    return static_cast<std::uint32_t>(h);
  }

  std::uint64_t key(Index h) const
  {
    const Vector &p = points[source_vertex(h)], &q = points[target_vertex(h)];
    return Edge_queue::key(static_cast<float>((q - p).squared_norm()), hash(p + q));
  }

  // Returns the normal of the face of h if the source of h moves to a point.
  Vector normal(Index h, const Vector& point) const
  { return (points[target_vertex(h)] - point).cross(points[source_vertex(previous(h))] - point); }

  static void add_plane(const Vector& normal, const Vector& offset, Symmetric_matrix& matrix,
                        Vector& right)
  {
    matrix += Symmetric_matrix::square(normal);
    right += normal * normal.dot(offset);
  }

  // Returns the point nearest to the planes around the two ends of an edge, not far from its
  // middle.
  Vector best_point(Index h, const Index_list& around_u, const Index_list& around_v) const
  {
    const Vector &p = points[source_vertex(h)], &q = points[target_vertex(h)], middle = (p + q) / 2;
    Symmetric_matrix matrix;
    Vector right;
    for (const Index_list* around : {&around_u, &around_v})
      for (Index g : *around) {
        const Vector &at = points[source_vertex(g)], n = normal(g, at);
        add_plane(n, at - middle, matrix, right);
        // Planes along the border keep the border where it is.
        for (Index e : {g, previous(g)})
          if (is_border(e))
            add_plane((points[target_vertex(e)] - points[source_vertex(e)])
                        .cross(n.stably_normalized()) * (q - p).norm(),
                      at - middle, matrix, right);
      }
    // The regularization keeps the point near the middle along planes that are parallel.
    const double share = 1e-3 * matrix.trace() + 1e-300;
    matrix += {share, share, share};
    const Vector step = matrix.inverse() * right;
    const bool is_near = step.squared_norm() <= (q - p).squared_norm(); // false for NaN
    return is_near ? on_grid(middle + step) : on_grid(middle);
  }

  // Returns whether the link condition (Dey et al. 1999) holds and no face turns over; sets
  // `point`.
  bool can_collapse(Index h, const Index_list& around_u, const Index_list& around_v,
                    Vector& point) const
  {
    const Index u = source_vertex(h), v = target_vertex(h), o = opposite[h];
    const bool u_on_border = are_at_border(around_u), v_on_border = are_at_border(around_v);
    if (u_on_border && v_on_border && o != h)
      return false;
    const Index_list of_u = neighbors(around_u), of_v = neighbors(around_v);
    Index_list common;
    std::set_intersection(of_u.begin(), of_u.end(), of_v.begin(), of_v.end(),
                          std::back_inserter(common));
    if (common.size() != (o == h ? 1 : 2))
      return false;
    for (Index e : {h, o}) {
      if (is_border(next(e)) && is_border(previous(e)))
        return false;
      // A vertex on a seam is skipped, because it has more faces, where other threads may be at
      // work.
      if (is_on_seam(source_vertex(previous(e))))
        continue;
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
        const Vector before = normal(g, points[source_vertex(g)]), after = normal(g, point);
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
    became_[v] = u;
    remove_face(h);
    if (o != h)
      remove_face(o);
    for (const Index_list* around : {&around_u, &around_v})
      for (Index g : *around)
        if (!is_gone(g / 3)) {
          edges.push({key(g), g});
          if (is_border(previous(g)))
            edges.push({key(previous(g)), previous(g)});
        }
  }

  // Collapses edges of `faces` until at most `number` of these, or no candidate edge, is left.
  void collapse_edges(const std::vector<Index>& faces, std::size_t number)
  {
    Edge_queue edges; // an edge that changed since is there again
    std::size_t left = 0, tries = 0, reported = 0;
    for (Index f : faces) {
      if (is_gone(f))
        continue;
      ++left;
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (h <= opposite[h])
          edges.push({key(h), h});
    }
    reported = left;
    while (left > number) {
      if (++tries % tries_between_checks == 0) {
        monitor_.check();
        monitor_.advance(progress_per_face_ * static_cast<double>(reported - left));
        reported = left;
      }
      const std::optional<Edge_queue::Edge> shortest = edges.pop();
      if (!shortest)
        return;
      const auto [old_key, h] = *shortest;
      if (is_gone(h / 3) || key(h) != old_key || must_stay(source_vertex(h)) ||
          must_stay(target_vertex(h)))
        continue;
      const Index_list around_u = around_source(h), around_v = around_source(next(h));
      Vector point;
      if (can_collapse(h, around_u, around_v, point)) {
        left -= is_border(h) ? 1 : 2;
        collapse(h, around_u, around_v, point, edges);
      }
    }
  }

  void collapse_edges_by_domains(std::size_t number)
  {
    const std::vector<std::vector<Index> > faces = domains(corners, points, faces_per_domain);
    std::vector<double> areas(faces.size(), 0);
    for_each_index(execution_, faces.size(), [&](std::size_t d) {
      for (Index f : faces[d])
        areas[d] += normal(3 * f, points[source_vertex(3 * f)]).norm();
    });
    std::vector<Index> domain(points.size(), null_index);
    is_on_seam_.assign(points.size(), 0);
    for (Index d = 0; d < faces.size(); ++d)
      for (Index f : faces[d])
        for (Index v : corners[f]) {
          is_on_seam_[v] = is_on_seam_[v] || (domain[v] != null_index && domain[v] != d);
          domain[v] = d;
        }
    const double faces_per_area = shared_by_area(static_cast<double>(number), faces, areas);
    for_each_index(execution_, faces.size(), [&](std::size_t d) {
      // Faces with an edge on a seam are left in addition.
      const auto at_seam = std::count_if(faces[d].begin(), faces[d].end(), [&](Index f) {
        const Corners& c = corners[f];
        return is_on_seam_[c[0]] + is_on_seam_[c[1]] + is_on_seam_[c[2]] >= 2;
      });
      const double all = static_cast<double>(faces[d].size());
      collapse_edges(faces[d], static_cast<std::size_t>(
        (std::min)(faces_per_area * areas[d] + static_cast<double>(at_seam), all)));
    });
    is_on_seam_.clear();
  }

public:
  // Takes a mesh; `progress_per_face` is the fraction of the phase for each removed face.
  Edge_collapse(Execution execution, const Surface& mesh, Run_monitor& monitor,
                double progress_per_face)
    : Surface{mesh.corners, mesh.opposite, std::vector<Vector>(mesh.points.size()), {}, {},
              mesh.components},
      execution_(execution), monitor_(monitor), progress_per_face_(progress_per_face),
      became_(mesh.points.size()), is_fixed_(mesh.points.size(), 0),
      steps_per_unit_(steps_per_unit(total_area(mesh)))
  {
    const Principal_frame frame(execution, mesh);
    for_each_index(execution_, points.size(), [&](std::size_t v)
      { points[v] = on_grid(steps_per_unit_ * frame.point(mesh.points[v])); });
    std::iota(became_.begin(), became_.end(), Index(0));

    std::vector<Index> outgoing(points.size(), null_index);
    std::vector<Index> number_of_faces_around(points.size(), 0);
    for (Index h = 0; h < opposite.size(); ++h) {
      outgoing[source_vertex(h)] = h;
      ++number_of_faces_around[source_vertex(h)];
    }
    // A vertex where several fans of faces meet is fixed, because each fan knows nothing of the
    // others.
    for_each_index(execution_, outgoing.size(), [&](std::size_t v) {
      is_fixed_[v] = outgoing[v] == null_index ||
                     around_source(outgoing[v]).size() != number_of_faces_around[v];
    });
  }

  // Collapses edges until at most `number_of_faces` faces, or no candidate edge, is left. If more
  // will do, the faces at the seams of domains may be left as well.
  void collapse_edges(std::size_t number_of_faces, bool more_will_do)
  {
    const bool is_large = corners.size() >= 4 * faces_per_domain;
    if (is_large)
      collapse_edges_by_domains(number_of_faces);
    if (is_large && more_will_do)
      return;
    std::vector<Index> all(corners.size());
    std::iota(all.begin(), all.end(), Index(0));
    collapse_edges(all, number_of_faces);
  }

  Coarse_mesh result()
  {
    Coarse_mesh result;
    Surface& graph = result.graph;
    std::vector<Index> new_vertex(points.size(), null_index), new_face(corners.size());
    for (Index f = 0; f < corners.size(); ++f) {
      if (is_gone(f))
        continue;
      new_face[f] = static_cast<Index>(result.faces.size());
      result.faces.push_back(f);
      if (components.number > 1)
        graph.components.of_face.push_back(components[f]);
      for (Index v : corners[f])
        if (new_vertex[v] == null_index) {
          new_vertex[v] = static_cast<Index>(graph.points.size());
          graph.points.push_back(points[v] / steps_per_unit_);
        }
    }
    graph.corners.resize(result.faces.size());
    graph.opposite.resize(3 * result.faces.size());
    for_each_index(execution_, result.faces.size(), [&](std::size_t i) {
      const Index f = result.faces[i];
      for (Index j = 0; j < 3; ++j) {
        const Index o = opposite[3 * f + j];
        graph.corners[i][j] = new_vertex[corners[f][j]];
        graph.opposite[3 * i + j] = 3 * new_face[o / 3] + o % 3;
      }
    });
    graph.components.number = components.number;
    set_areas(execution_, graph);
    // Follows the chain of the vertices that each vertex was joined to.
    result.vertices.resize(points.size());
    for (Index v = 0; v < became_.size(); ++v) {
      Index last = v;
      while (became_[last] != last)
        last = became_[last] = became_[became_[last]];
      result.vertices[v] = new_vertex[last];
    }
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_EDGE_COLLAPSE_H
