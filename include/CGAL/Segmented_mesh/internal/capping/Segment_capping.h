// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H

#include <CGAL/Segmented_mesh/internal/capping/Segment_borders.h>
#include <CGAL/Segmented_mesh/internal/capping/Triangle_tree.h>
#include <CGAL/Segmented_mesh/internal/capping/most_visible_normal.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>
#include <CGAL/Segmented_mesh/internal/capping/triangulated_loop.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <set>
#include <unordered_map>
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
  // A piece of a cap, with the segment on its other side.
  struct Piece
  {
    Index segment;
    std::vector<Corners> triangles;
  };

  typedef std::vector<Piece> Cap;

  // A way to make a cap: its rim leads inwards for `depth` edges of the loop.
  struct Shape
  {
    double depth;
    bool is_fan; // around a new point in the middle
  };

  // The shapes in ascending order of effort. All but the first two are for loops whose caps would
  // leave the solid near the loop, because its vertices zigzag or lie in a concave fold.
  static constexpr Shape shapes_[] = {
    {0, false}, {0, true}, {0.5, false}, {2, false}, {0.1, false}};

  std::size_t number_of_given_points_;
  double unit_;                 // a power of 2, so that to divide by it rounds nothing
  std::vector<Vector> points_;  // in this unit, so that no volume overflows; with the new points
  std::vector<std::vector<Corners> > triangles_; // of each segment, with its caps
  Segment_borders borders_;
  std::vector<char> is_done_; // one per segment, whether it is closed
  Triangle_tree tree_;
  std::set<Vertex_pair> taken_; // edges of triangles and caps, where one more triangle is too many
  double orientation_ = 1;      // -1 if the surface is inside out

  // The segments and the normals of the triangles at each vertex of a border, or of a cap.
  std::unordered_map<Index, std::vector<std::pair<Index, Vector> > > normals_;
  Caps result_;

  static std::vector<std::vector<Corners> >
  triangles_of_segments(const std::vector<Corners>& triangles, const std::vector<Index>& segment,
                        std::size_t n)
  {
    std::vector<std::vector<Corners> > result(n);
    for (std::size_t f = 0; f < triangles.size(); ++f)
      result[segment[f]].push_back(triangles[f]);
    return result;
  }

  // Takes the normals of triangles at the borders, and the edges between vertices of borders,
  // because other edges cannot be edges of a cap.
  void take(const std::vector<Corners>& triangles, const std::vector<Index>& segment)
  {
    const std::vector<char> is_at_border = borders_.vertices(points_.size());
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const Corners& t = triangles[f];
      for (int i = 0; i < 3; ++i) {
        const Index v = t[i], w = t[(i + 1) % 3];
        if (!is_at_border[v])
          continue;
        normals_[v].emplace_back(segment[f], normal(points_, t).normalized());
        if (is_at_border[w])
          taken_.insert(vertex_pair(v, w));
      }
    }
  }

  void add_triangle(Index segment, const Corners& t)
  {
    result_.triangles.push_back(t);
    result_.segment.push_back(segment);
    triangles_[segment].push_back(t);
    borders_.add_triangle(segment, t);
    for (Index v : t)
      normals_[v].emplace_back(segment, normal(points_, t).normalized());
  }

  Index add_point(const Vector& p)
  {
    points_.push_back(p);
    return static_cast<Index>(points_.size() - 1);
  }

  Index add_middle(const Loop& loop)
  {
    Vector middle;
    for (Index v : loop)
      middle += points_[v] / static_cast<double>(loop.size());
    return add_point(middle);
  }

  std::vector<Corners> fan(const Loop& loop)
  {
    const Index middle = add_middle(loop);
    std::vector<Corners> result;
    for (std::size_t i = 0; i < loop.size(); ++i)
      result.push_back({loop[i], loop[(i + 1) % loop.size()], middle});
    return result;
  }

  // Returns triangles between the vertices of a loop; none if CGAL finds none.
  std::vector<Corners> triangles_in(const Loop& loop) const
  {
    std::vector<Vector> points;
    for (Index v : loop)
      points.push_back(points_[v]);
    std::vector<Corners> triangles = triangulated_loop(std::move(points));
    for (Corners& t : triangles)
      t = {loop[t[0]], loop[t[1]], loop[t[2]]};
    return triangles;
  }

  // Returns a direction at a vertex of a border that leads into the solid that is left, which
  // consists of the segments that are not closed yet.
  Vector inward(Index v) const
  {
    std::vector<Vector> normals;
    for (const auto& [segment, n] : normals_.at(v))
      if (!is_done_[segment])
        normals.push_back(n);
    return -orientation_ * most_visible_normal(normals);
  }

  // Returns the copy of a loop that lies inside the solid, `depth` edges deep, and is smoother.
  Loop moved_inwards(const Loop& loop, double depth)
  {
    const std::size_t n = loop.size();
    const auto before = [n](std::size_t i) { return (i + n - 1) % n; };
    const auto after = [n](std::size_t i) { return (i + 1) % n; };
    std::vector<Vector> moved(n);
    for (std::size_t i = 0; i < n; ++i) {
      const Vector &p = points_[loop[before(i)]], &q = points_[loop[i]],
                   &r = points_[loop[after(i)]];
      moved[i] = q + depth / 2 * ((p - q).norm() + (r - q).norm()) * inward(loop[i]);
    }
    for (int round = 0; round < 3; ++round) {
      const std::vector<Vector> given = moved;
      for (std::size_t i = 0; i < n; ++i)
        moved[i] = (given[before(i)] + 2 * given[i] + given[after(i)]) / 4;
    }
    Loop result;
    for (const Vector& p : moved)
      result.push_back(add_point(p));
    return result;
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

  // Returns a cap with a piece for each arc of a loop; more than one are sectors around a new point
  // in the middle. It is empty if there is no such cap.
  Cap make_cap(const Loop& loop, const std::vector<Arc>& arcs, const Shape& shape)
  {
    const Loop rim = shape.depth > 0 ? moved_inwards(loop, shape.depth) : loop;
    const bool has_sectors = arcs.size() > 1;
    const Index middle = has_sectors ? add_middle(rim) : null_index;
    Cap result;
    for (const Arc& a : arcs) {
      Loop sector;
      if (has_sectors)
        sector.push_back(middle);
      for (std::size_t i = a.begin; i < a.end + has_sectors; ++i)
        sector.push_back(rim[i % rim.size()]);
      Piece piece{a.segment, shape.is_fan ? fan(sector) : triangles_in(sector)};
      if (piece.triangles.empty())
        return {};
      if (shape.depth > 0)
        add_strip(loop, rim, a.begin, a.end, piece.triangles);
      result.push_back(std::move(piece));
    }
    return result;
  }

  // Returns whether an edge of a cap of a loop, except those of the loop, is already an edge of
  // others.
  bool takes_an_edge_twice(const Cap& cap, const Loop& loop) const
  {
    std::set<Vertex_pair> edges;
    for (std::size_t i = 0; i < loop.size(); ++i)
      edges.insert(vertex_pair(loop[i], loop[(i + 1) % loop.size()]));
    for (const Piece& piece : cap)
      for (const Corners& t : piece.triangles)
        for (int i = 0; i < 3; ++i) {
          const Vertex_pair edge = vertex_pair(t[i], t[(i + 1) % 3]);
          if (taken_.count(edge) > 0 && edges.count(edge) == 0)
            return true;
        }
    return false;
  }

  // Returns whether a triangle (v, w, x) of a cap leaves the border edge (v, w) to the inside of
  // the solid, or along its surface. The surface has the triangles (w, v, a) and (v, w, b) there.
  bool leads_inwards(const Corners& t, Index a, Index b) const
  {
    const auto v = exact_point(points_[t[0]]), w = exact_point(points_[t[1]]),
               x = exact_point(points_[t[2]]);
    const auto p = exact_point(points_[a]), q = exact_point(points_[b]);
    const auto outside = orientation_ > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
    const bool is_convex = CGAL::orientation(w, v, p, q) == -outside;
    const bool is_before_a = CGAL::orientation(w, v, p, x) != outside,
               is_before_b = CGAL::orientation(v, w, q, x) != outside;
    return is_convex ? is_before_a && is_before_b : is_before_a || is_before_b;
  }

  // Returns whether a cap of a segment leaves the border of the segment to the inside of the solid.
  bool leads_inwards(const Cap& cap, Index segment, const Border& border) const
  {
    for (const Piece& piece : cap)
      for (const Corners& t : piece.triangles)
        for (int i = 0; i < 3; ++i) {
          const Index v = t[i], w = t[(i + 1) % 3];
          const auto edge = border.find(vertex_pair(v, w));
          if (edge == border.end())
            continue;
          const Index other = borders_.segment_at(v, w, segment);
          if (!leads_inwards({v, w, t[(i + 2) % 3]}, edge->second.apex,
                             borders_.border(other).at(edge->first).apex))
            return false;
        }
    return true;
  }

  // Returns whether a cap intersects neither itself nor the surface and its caps.
  bool is_free(const Cap& cap)
  {
    std::vector<Corners> triangles;
    for (const Piece& piece : cap)
      triangles.insert(triangles.end(), piece.triangles.begin(), piece.triangles.end());
    return std::none_of(triangles.begin(), triangles.end(), [this](const Corners& t)
                        { return is_degenerate(points_, t) || tree_.intersects(t); }) &&
           !do_self_intersect(points_, triangles);
  }

  // Returns the cap of a loop with the first shape that intersects nothing. If there is none, the
  // shape is that of least effort, and `all_free` becomes false.
  Cap best_cap(Loop loop, Index segment, const Border& border, bool& all_free)
  {
    const std::vector<Arc> arcs = borders_.long_arcs(points_, loop, segment);
    const std::size_t n = points_.size();
    const Shape* first = nullptr;
    for (const Shape& shape : shapes_) {
      Cap cap = make_cap(loop, arcs, shape);
      if (!cap.empty() && !takes_an_edge_twice(cap, loop)) {
        if ((segment == null_index || leads_inwards(cap, segment, border)) && is_free(cap))
          return cap;
        first = first ? first : &shape;
      }
      points_.resize(n);
    }
    all_free = false;
    return make_cap(loop, arcs, first ? *first : shapes_[1]);
  }

  // Returns a cap of all loops of a segment, which makes a shell of the segment: a copy of its
  // triangles, moved inwards for a fraction of their edges. The segment on its other side is the
  // one that has most of the border.
  Cap shell(Index segment, const std::vector<Loop>& loops, double depth)
  {
    struct Vertex
    {
      std::vector<Vector> normals; // of the triangles of the segment at it
      Vector inward;
      double shortest_edge = (std::numeric_limits<double>::infinity)();
      Index copy = null_index;
    };
    std::unordered_map<Index, Vertex> vertices;
    const std::vector<Corners>& triangles = triangles_[segment];
    for (const Corners& t : triangles) {
      for (int i = 0; i < 3; ++i) {
        Vertex& v = vertices[t[i]];
        v.normals.push_back(normal(points_, t).normalized());
        for (Index w : t)
          if (w != t[i])
            v.shortest_edge =
              (std::min)(v.shortest_edge, (points_[w] - points_[t[i]]).norm());
      }
    }
    for (auto& [v, vertex] : vertices)
      vertex.inward = -orientation_ * most_visible_normal(vertex.normals);
    for (const Loop& loop : loops)
      for (Index v : loop)
        vertices[v].inward = inward(v);

    Cap result(1);
    const auto copy = [&](Index v) {
      Vertex& vertex = vertices[v];
      if (vertex.copy == null_index)
        vertex.copy = add_point(points_[v] + depth * vertex.shortest_edge * vertex.inward);
      return vertex.copy;
    };
    for (const Corners& t : triangles)
      result[0].triangles.push_back({copy(t[0]), copy(t[2]), copy(t[1])});
    double longest = -1;
    for (Loop loop : loops) {
      for (const Arc& a : borders_.long_arcs(points_, loop, segment))
        if (a.length > longest) {
          longest = a.length;
          result[0].segment = a.segment;
        }
      Loop copies;
      for (Index v : loop)
        copies.push_back(copy(v));
      add_strip(loop, copies, 0, loop.size(), result[0].triangles);
    }
    return result;
  }

  // Adds a cap to the segments on both of its sides.
  void add(const Cap& cap, Index segment)
  {
    for (const Piece& piece : cap)
      for (const Corners& t : piece.triangles) {
        if (segment != null_index)
          add_triangle(segment, t);
        add_triangle(piece.segment, segment == null_index ? t : Corners{t[0], t[2], t[1]});
        for (int i = 0; i < 3; ++i)
          taken_.insert(vertex_pair(t[i], t[(i + 1) % 3]));
      }
  }

  // Closes a segment. Each edge of its border has another segment, because the surface is closed.
  // With `null_index` it closes the surface.
  void close(Index segment)
  {
    const Border border =
      segment == null_index ? borders_.border_of_surface() : borders_.border(segment);
    const Border_loops loops(border);
    const std::size_t number_of_points = points_.size(), number_in_tree = tree_.size();
    bool all_free = true;
    std::vector<Cap> caps;
    for (const Loop& loop : loops()) {
      caps.push_back(best_cap(loop, segment, border, all_free));
      for (const Piece& piece : caps.back())
        tree_.insert(piece.triangles);
      tree_.update();
    }
    if (!all_free && segment != null_index && !has_degenerate_triangle(segment)) {
      const std::vector<Vector> new_points(
        points_.begin() + static_cast<std::ptrdiff_t>(number_of_points), points_.end());
      tree_.resize(number_in_tree);
      points_.resize(number_of_points);
      for (double depth : {0.3, 0.1, 0.03}) {
        const Cap cap = shell(segment, loops(), depth);
        if (!is_free(cap)) {
          points_.resize(number_of_points);
          continue;
        }
        caps = {cap};
        all_free = true;
        break;
      }
      if (!all_free)
        points_.insert(points_.end(), new_points.begin(), new_points.end());
      for (const Cap& cap : caps)
        for (const Piece& piece : cap)
          tree_.insert(piece.triangles);
    }
    for (const Cap& cap : caps)
      add(cap, segment);
    if (segment != null_index)
      is_done_[segment] = 1;
    tree_.update();
  }

  bool has_degenerate_triangle(Index segment) const
  {
    return std::any_of(triangles_[segment].begin(), triangles_[segment].end(),
                       [this](const Corners& t) { return is_degenerate(points_, t); });
  }

  // Returns the signed volume of the closed surface. It is summed around a point of the surface,
  // because far from it the terms would cancel each other.
  double signed_volume() const
  {
    double result = 0;
    const Vector* origin = nullptr;
    for (const std::vector<Corners>& triangles : triangles_)
      for (const Corners& t : triangles) {
        origin = origin ? origin : &points_[t[0]];
        result += tetrahedron_volume(*origin, points_[t[0]], points_[t[1]], points_[t[2]]);
      }
    return result;
  }

  static std::vector<Vector> divided(std::vector<Vector> points, double unit)
  {
    for (Vector& p : points)
      p = p / unit;
    return points;
  }

  // Returns the unit in which the largest coordinate is about 1.
  static double unit_of(const std::vector<Vector>& points)
  {
    double largest = 0;
    for (const Vector& p : points)
      largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    return largest > 0 ? std::ldexp(1., std::clamp(std::ilogb(largest), -1022, 1023)) : 1;
  }

  // Returns the segments in ascending order of their areas.
  std::vector<Index> order() const
  {
    std::vector<double> area;
    for (const std::vector<Corners>& triangles : triangles_) {
      area.push_back(0);
      for (const Corners& t : triangles)
        area.back() += normal(points_, t).norm();
    }
    std::vector<Index> result(area.size());
    std::iota(result.begin(), result.end(), Index(0));
    std::stable_sort(result.begin(), result.end(),
                     [&area](Index a, Index b) { return area[a] < area[b]; });
    return result;
  }

public:
  // `segment` holds the segment of each triangle, from 0 to n - 1.
  Segment_capping(const std::vector<Vector>& points, const std::vector<Corners>& triangles,
                  const std::vector<Index>& segment, std::size_t n)
    : number_of_given_points_(points.size()), unit_(unit_of(points)),
      points_(divided(points, unit_)), triangles_(triangles_of_segments(triangles, segment, n)),
      borders_(triangles_), is_done_(n, 0), tree_(points_, triangles)
  {
    take(triangles, segment);
    close(null_index);
    orientation_ = signed_volume() < 0 ? -1 : 1;
    for (Index s : order())
      close(s);
    for (std::size_t v = number_of_given_points_; v < points_.size(); ++v)
      result_.points.push_back(points_[v] * unit_);
  }

  Segment_capping(const Segment_capping&) = delete;
  Segment_capping& operator=(const Segment_capping&) = delete;

  const Caps& caps() const { return result_; }
  bool is_inside_out() const { return orientation_ < 0; }

  // Returns all points, in the unit, and the triangles of each segment with its caps.
  double unit() const { return unit_; }
  const std::vector<Vector>& points() const { return points_; }
  const std::vector<std::vector<Corners> >& triangles() const { return triangles_; }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H
