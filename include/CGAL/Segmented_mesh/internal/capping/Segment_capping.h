// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H

#include <CGAL/Segmented_mesh/internal/capping/Wall_capping.h>
#include <CGAL/Segmented_mesh/internal/capping/most_visible_normal.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>
#include <CGAL/Segmented_mesh/internal/capping/triangulated_loop.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Closes segments one after the other, the smallest first. Each border loop of a segment gets a
// cap, or loops on two walls of a hollow body get a ring. Their triangles, turned over, go to the
// segments on the other side, so that all segments fit together, even where three of them meet.
class Segment_capping : public Wall_capping
{
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

  // Returns the cap of a loop with the first shape that intersects nothing; it is empty if there is
  // none. Without `must_be_free` it may intersect.
  Cap disc(Loop loop, Index segment, const Border& border, bool must_be_free)
  {
    const std::vector<Arc> arcs = borders_.long_arcs(points_, loop, segment);
    const std::set<Vertex_pair> edges = edges_of({loop});
    const std::size_t n = points_.size();
    for (const Shape& shape : shapes_) {
      Cap cap = make_cap(loop, arcs, shape);
      if (!cap.empty() && !takes_an_edge_twice(cap, edges) &&
          (!must_be_free || (leads_inwards(cap, segment, border) && is_free(cap))))
        return cap;
      points_.resize(n);
    }
    return must_be_free ? Cap() : make_cap(loop, arcs, shapes_[1]);
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

  // Closes a segment. Each edge of its border has another segment, because the surface is closed.
  // With `null_index` it closes the surface.
  void close(Index segment)
  {
    const bool has_inside = segment != null_index;
    const Border border = has_inside ? borders_.border(segment) : borders_.border_of_surface();
    const Border_loops loops(border);
    const std::size_t number_of_points = points_.size(), number_in_tree = tree_.size();
    std::vector<Cap> caps;
    std::vector<Loop> open = loops(); // those without a cap that intersects nothing
    const auto remove_closed = [&](auto make_cap) {
      open.erase(std::remove_if(open.begin(), open.end(), [&](const Loop& loop)
        { return add_cap(make_cap(loop), caps); }), open.end());
    };
    if (has_inside) {
      remove_closed([&](const Loop& loop) { return strip_in(loop, segment, border); });
      add_rings(open, segment, border, caps);
    }
    remove_closed([&](const Loop& loop) { return disc(loop, segment, border, true); });
    if (!open.empty() && has_inside && are_disjoint(loops()) &&
        !has_degenerate_triangle(segment)) {
      const std::vector<Vector> new_points(
        points_.begin() + static_cast<std::ptrdiff_t>(number_of_points), points_.end());
      give_back(caps, number_in_tree);
      points_.resize(number_of_points);
      std::vector<Cap> shells;
      for (double depth : {0.3, 0.1, 0.03}) {
        const Cap cap = shell(segment, loops(), depth);
        if (is_free(cap) && add_cap(cap, shells))
          break;
        points_.resize(number_of_points);
      }
      if (shells.empty()) {
        points_.insert(points_.end(), new_points.begin(), new_points.end());
        for (const Cap& cap : caps)
          take(cap);
      }
      else {
        caps = shells;
        open.clear();
      }
    }
    for (const Loop& loop : open)
      add_cap(disc(loop, segment, border, false), caps);
    for (const Cap& cap : caps)
      add(cap, segment);
    if (has_inside)
      is_done_[segment] = 1;
  }

public:
  // `segment` holds the segment of each triangle, from 0 to n - 1.
  Segment_capping(const std::vector<Vector>& points, const std::vector<Corners>& triangles,
                  const std::vector<Index>& segment, std::size_t n)
    : Wall_capping(points, triangles, segment, n)
  {
    close(null_index);
    orientation_ = signed_volume() < 0 ? -1 : 1;
    for (Index s : order())
      close(s);
    for (std::size_t v = points.size(); v < points_.size(); ++v)
      result_.points.push_back(points_[v] * unit());
  }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H
