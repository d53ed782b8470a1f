// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_EDGE_COLLAPSE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_EDGE_COLLAPSE_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/base/Vector.h>
#include <CGAL/Spectral_segmentation/internal/base/arrays.h>
#include <CGAL/Spectral_segmentation/internal/levels/Edge_queue.h>
#include <CGAL/Spectral_segmentation/internal/surface/Principal_frame.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns compact sets of about so many faces: those in each cell of a grid. No set is empty.
inline std::vector<std::vector<Index> > domains(const std::vector<Corners>& corners,
                                                const std::vector<Vector>& points,
                                                std::size_t faces_per_domain)
{
  // A surface meets about as many cells as there are in two layers of the grid.
  const double width = std::ceil(
    std::sqrt(static_cast<double>(corners.size()) / static_cast<double>(2 * faces_per_domain)));
  const Bounding_box box(points);
  const double extent = (box.largest - box.smallest).largest_coordinate();
  const double cells_per_length = extent > 0 ? width / extent : 0;
  const Index n = static_cast<Index>(width);
  std::vector<std::vector<Index> > result(n * n * n);
  for (Index f = 0; f < corners.size(); ++f) {
    const Corners& c = corners[f];
    const Vector place =
      ((points[c[0]] + points[c[1]] + points[c[2]]) / 3 - box.smallest) * cells_per_length;
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

// Returns the face density at which the domains together keep `number` faces, each at most what it
// has.
inline double shared_by_area(double number, const std::vector<std::vector<Index> >& faces,
                             const std::vector<double>& areas)
{
  std::vector<double> density(faces.size(), 0); // the faces per area that a domain has
  double area = 0;
  for (std::size_t d = 0; d < faces.size(); ++d)
    if (areas[d] > 0) {
      density[d] = static_cast<double>(faces[d].size()) / areas[d];
      area += areas[d];
    }
  for (Index d : sorted_indices(density)) {
    if (density[d] == 0)
      continue;
    if (density[d] * area >= number)
      return number / area;
    number -= static_cast<double>(faces[d].size());
    area -= areas[d];
  }
  return std::numeric_limits<double>::max();
}

// Collapses edges, the shortest first, until few faces are left. The vertex that is left goes where
// it keeps the planes of the faces around, weighted by their squared areas, as Lindstrom and Turk
// (1998) keep the volume. CGAL's edge_collapse() takes ten times as long (benchmark/performance,
// coarsening).
//
// A large mesh is first divided into compact domains, which threads take one by one; edges with an
// end on the seam, which are vertices of several domains, stay. So all faces around both ends of an
// edge that collapses are of one domain. A collapse reads and writes the corners of these faces,
// and `opposite` of their half-edges and of those across edges at the two ends, which are of these
// faces too; it writes the point of one end. It also reads points of neighboring vertices: of this
// domain, or on the seam, which no thread moves. It does not walk around a third vertex that is on
// the seam. So no thread reads what another one writes.
//
// Coordinates are whole numbers, in the principal frame and in a unit that depends on the area, and
// ties are broken by a hash of them: the result moves and grows with the mesh and does not depend
// on the numbers of its vertices and faces.
class Edge_collapse
{
  typedef boost::container::small_vector<Index, 16> Index_list;

  static constexpr std::size_t faces_per_domain = 1 << 13;
  static constexpr std::size_t tries_between_checks = 1 << 12; // a few milliseconds

  const Execution execution_;
  const Surface& mesh_;
  Run_monitor& monitor_;
  const double progress_per_face_;
  const double steps_per_unit_; // of the grid on which the points are

  std::vector<Corners> corners_; // of each face; null_index first if it is gone
  std::vector<Index> opposite_;  // of each half-edge
  std::vector<Vector> points_;   // of each vertex
  std::vector<Index> became_;    // what each vertex was joined to, or itself
  std::vector<char> is_fixed_;   // vertices that stay as they are
  std::vector<char> is_on_seam_; // of domains; empty without domains

  static Index next(Index h) { return Surface::next(h); }
  static Index previous(Index h) { return Surface::previous(h); }
  Index across(Index h) const { return opposite_[h] == h ? null_index : opposite_[h]; }
  Index source(Index h) const { return corners_[h / 3][h % 3]; }
  Index target(Index h) const { return source(next(h)); }
  bool is_gone(Index f) const { return corners_[f][0] == null_index; }

  // The half-edges that leave the source of h, one for each face around it.
  Index_list around_source(Index h) const
  {
    Index_list result;
    Index g = h;
    do {
      result.push_back(g);
      g = across(previous(g));
    } while (g != null_index && g != h);
    if (g == null_index)
      for (g = h; across(g) != null_index;) {
        g = next(across(g));
        result.push_back(g);
      }
    return result;
  }

  // Whether there are at most three faces around the source of h, and no border.
  bool has_few_faces_around(Index h) const
  {
    Index g = h;
    for (int i = 0; i < 3; ++i) {
      g = across(previous(g));
      if (g == null_index || g == h)
        return g == h;
    }
    return false;
  }

  bool is_on_border(const Index_list& around) const
  {
    return std::any_of(around.begin(), around.end(), [&](Index h)
      { return across(h) == null_index || across(previous(h)) == null_index; });
  }

  Index_list neighbors(const Index_list& around) const
  {
    Index_list result;
    for (Index h : around) {
      result.push_back(target(h));
      result.push_back(source(previous(h)));
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  bool is_on_seam(Index v) const { return !is_on_seam_.empty() && is_on_seam_[v]; }
  bool must_stay(Index v) const { return is_fixed_[v] || is_on_seam(v); }

  static double steps_per_unit(double area)
  { return (1 << 24) / (std::max)(std::sqrt(area), 1e-6); }

  // Midpoints of points on the grid stay clear of where the last bit of a number decides.
  static Vector on_grid(const Vector& p)
  { return Vector(std::floor(p.x() + 0.25), std::floor(p.y() + 0.25), std::floor(p.z() + 0.25)); }

  // Of a point on the grid. The same on every machine, unlike the hashes of libraries: the
  // finalizer of SplitMix64 (Steele, Lea, Flood 2014).
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
    const Vector &p = points_[source(h)], &q = points_[target(h)];
    return Edge_queue::key(static_cast<float>((q - p).squared_norm()), hash(p + q));
  }

  // Of the face of h if the source of h moves.
  Vector normal(Index h, const Vector& point) const
  { return (points_[target(h)] - point).cross(points_[source(previous(h))] - point); }

  static void add_plane(const Vector& normal, const Vector& offset, Symmetric_matrix& matrix,
                        Vector& right)
  {
    matrix += Symmetric_matrix::square(normal);
    right += normal * normal.dot(offset);
  }

  // The point nearest to the planes around the two ends of an edge, and not far from its middle.
  Vector best_point(Index h, const Index_list& around_u, const Index_list& around_v) const
  {
    const Vector &p = points_[source(h)], &q = points_[target(h)], middle = (p + q) / 2;
    Symmetric_matrix matrix;
    Vector right;
    for (const Index_list* around : {&around_u, &around_v})
      for (Index g : *around) {
        const Vector &at = points_[source(g)], n = normal(g, at);
        add_plane(n, at - middle, matrix, right);
        // Planes along the border keep it where it is.
        for (Index e : {g, previous(g)})
          if (across(e) == null_index)
            add_plane((points_[target(e)] - points_[source(e)]).cross(n.stably_normalized()) *
                        (q - p).norm(), at - middle, matrix, right);
      }
    // Regularized, so that the point stays near the middle along planes that are parallel.
    const double share = 1e-3 * matrix.trace() + 1e-300;
    matrix += {share, share, share};
    const Vector step = matrix.inverse() * right;
    const bool is_near = step.squared_norm() <= (q - p).squared_norm(); // also if it is a number
    return is_near ? on_grid(middle + step) : on_grid(middle);
  }

  static constexpr double smallest_cosine = 0.3; // between a normal before and after a collapse

  // The link condition (Dey et al. 1999), and no face must turn over.
  bool can_collapse(Index h, const Index_list& around_u, const Index_list& around_v,
                    Vector& point) const
  {
    const Index u = source(h), v = target(h), o = across(h);
    const bool u_on_border = is_on_border(around_u), v_on_border = is_on_border(around_v);
    if (u_on_border && v_on_border && o != null_index)
      return false;
    const Index_list of_u = neighbors(around_u), of_v = neighbors(around_v);
    Index_list common;
    std::set_intersection(of_u.begin(), of_u.end(), of_v.begin(), of_v.end(),
                          std::back_inserter(common));
    if (common.size() != (o == null_index ? 1 : 2))
      return false;
    for (Index e : {h, o}) {
      if (e == null_index)
        continue;
      if (across(next(e)) == null_index && across(previous(e)) == null_index)
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
    for (const Index_list* around : {&around_u, &around_v})
      for (Index g : *around) {
        if (g / 3 == h / 3 || (o != null_index && g / 3 == o / 3))
          continue;
        const Vector before = normal(g, points_[source(g)]), after = normal(g, point);
        if (!before.is_zero() &&
            !(after.dot(before) > smallest_cosine * after.norm() * before.norm()))
          return false;
      }
    return true;
  }

  // Joins the two outer edges of the face of e, which goes.
  void remove_face(Index e)
  {
    const Index a = across(next(e)), b = across(previous(e));
    if (a != null_index)
      opposite_[a] = b == null_index ? a : b;
    if (b != null_index)
      opposite_[b] = a == null_index ? b : a;
    corners_[e / 3][0] = null_index;
  }

  void collapse(Index h, const Index_list& around_u, const Index_list& around_v,
                const Vector& point, Edge_queue& edges)
  {
    const Index u = source(h), v = target(h), o = across(h);
    for (Index g : around_v)
      corners_[g / 3][g % 3] = u;
    points_[u] = point;
    became_[v] = u;
    remove_face(h);
    if (o != null_index)
      remove_face(o);
    for (const Index_list* around : {&around_u, &around_v})
      for (Index g : *around)
        if (!is_gone(g / 3)) {
          edges.push({key(g), g});
          if (across(previous(g)) == null_index)
            edges.push({key(previous(g)), previous(g)});
        }
  }

  // Of some faces, until at most `number` of them are left or no edge is left to try.
  void collapse_edges(const std::vector<Index>& faces, std::size_t number)
  {
    Edge_queue edges; // those that changed since are there again
    std::size_t left = 0, tries = 0, reported = 0;
    for (Index f : faces) {
      if (is_gone(f))
        continue;
      ++left;
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (across(h) == null_index || h < across(h))
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
      if (is_gone(h / 3) || key(h) != old_key || must_stay(source(h)) || must_stay(target(h)))
        continue;
      const Index_list around_u = around_source(h), around_v = around_source(next(h));
      Vector point;
      if (can_collapse(h, around_u, around_v, point)) {
        left -= across(h) == null_index ? 1 : 2;
        collapse(h, around_u, around_v, point, edges);
      }
    }
  }

  void collapse_edges_by_domains(std::size_t number)
  {
    const std::vector<std::vector<Index> > faces = domains(corners_, points_, faces_per_domain);
    std::vector<double> areas(faces.size(), 0);
    for_each_index(execution_, faces.size(), [&](std::size_t d) {
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
    for_each_index(execution_, faces.size(), [&](std::size_t d) {
      // Those with an edge on a seam are left besides.
      const auto at_seam = std::count_if(faces[d].begin(), faces[d].end(), [&](Index f) {
        const Corners& c = corners_[f];
        return is_on_seam_[c[0]] + is_on_seam_[c[1]] + is_on_seam_[c[2]] >= 2;
      });
      const double all = static_cast<double>(faces[d].size());
      collapse_edges(faces[d], static_cast<std::size_t>(
        (std::min)(faces_per_area * areas[d] + static_cast<double>(at_seam), all)));
    });
    is_on_seam_.clear();
  }

public:
  // `progress_per_face` is the share of the phase that one face less is.
  Edge_collapse(Execution execution, const Surface& mesh, Run_monitor& monitor,
                double progress_per_face)
    : execution_(execution), mesh_(mesh), monitor_(monitor), progress_per_face_(progress_per_face),
      steps_per_unit_(steps_per_unit(total_area(mesh))), corners_(mesh.corners),
      opposite_(mesh.opposite), points_(mesh.points.size()), became_(mesh.points.size()),
      is_fixed_(mesh.points.size(), 0)
  {
    const Principal_frame frame(execution, mesh);
    for_each_index(execution_, points_.size(), [&](std::size_t v)
      { points_[v] = on_grid(steps_per_unit_ * frame.point(mesh.points[v])); });
    std::iota(became_.begin(), became_.end(), Index(0));

    std::vector<Index> outgoing(points_.size(), null_index);
    std::vector<Index> number_of_faces_around(points_.size(), 0);
    for (Index h = 0; h < opposite_.size(); ++h) {
      outgoing[source(h)] = h;
      ++number_of_faces_around[source(h)];
    }
    // Non-manifold vertices are fixed: a fan of faces cannot see the others there.
    for_each_index(execution_, outgoing.size(), [&](std::size_t v) {
      is_fixed_[v] = outgoing[v] == null_index ||
                     around_source(outgoing[v]).size() != number_of_faces_around[v];
    });
  }

  // Until at most `number_of_faces` are left, or no edge is left to try; or, if some more will do,
  // those that are left at the seams of domains as well.
  void operator()(std::size_t number_of_faces, bool more_will_do)
  {
    const bool is_large = corners_.size() >= 4 * faces_per_domain;
    if (is_large)
      collapse_edges_by_domains(number_of_faces);
    if (is_large && more_will_do)
      return;
    std::vector<Index> all(corners_.size());
    std::iota(all.begin(), all.end(), Index(0));
    collapse_edges(all, number_of_faces);
  }

  // Makes a surface of what is left. `vertex` becomes what each vertex of the mesh became.
  Surface surface(std::vector<Index>& vertex)
  {
    Surface result;
    std::vector<Index> new_face(corners_.size(), null_index), new_vertex(points_.size(), null_index);
    result.components.number = mesh_.components.number;
    for (Index f = 0; f < corners_.size(); ++f) {
      if (is_gone(f))
        continue;
      new_face[f] = static_cast<Index>(result.corners.size());
      result.corners.push_back(corners_[f]);
      if (result.components.number > 1)
        result.components.of_face.push_back(mesh_.components[f]);
      for (Index& v : result.corners.back()) {
        if (new_vertex[v] == null_index) {
          new_vertex[v] = static_cast<Index>(result.points.size());
          result.points.push_back(points_[v] / steps_per_unit_);
        }
        v = new_vertex[v];
      }
    }
    result.opposite.reserve(3 * result.corners.size());
    for (Index h = 0; h < opposite_.size(); ++h)
      if (!is_gone(h / 3))
        result.opposite.push_back(3 * new_face[opposite_[h] / 3] + opposite_[h] % 3);
    set_areas(execution_, result);
    // A vertex became one of those before which it was joined, and so on.
    vertex.resize(points_.size());
    for (Index v = 0; v < became_.size(); ++v) {
      Index last = v;
      while (became_[last] != last)
        last = became_[last] = became_[became_[last]];
      vertex[v] = new_vertex[last];
    }
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_EDGE_COLLAPSE_H
