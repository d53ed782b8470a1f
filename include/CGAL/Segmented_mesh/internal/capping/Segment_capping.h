// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H

#include <CGAL/Segmented_mesh/Closed_segment.h>
#include <CGAL/Segmented_mesh/internal/capping/Segmented_solid.h>
#include <CGAL/Segmented_mesh/internal/capping/Wall_capping.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>
#include <CGAL/Segmented_mesh/internal/capping/triangle_sides.h>
#include <CGAL/Segmented_mesh/internal/capping/triangulated_loop.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Closes segments one after the other, the smallest first. Each border loop of a segment gets a
// cap, or loops on two walls of a hollow body get a ring. Their triangles, reversed, go to the
// segments on the other side, so that all segments fit together, even where three of them meet.
class Segment_capping : public Wall_capping
{
  // The shape of a cap, whose rim leads inwards for `depth` edges of the loop.
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

  // Returns a cap with a piece for each arc of a loop; several are sectors around a new point in
  // the middle. It is empty if there is no such cap.
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
      std::vector<Vector> normals; // one per triangle of the segment
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
    std::vector<Loop> open = loops(); // loops without a cap that intersects nothing
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

// Returns the solid angle that a triangle subtends at a point, positive from behind.
inline double solid_angle(const Vector& from, const Vector& p, const Vector& q, const Vector& r)
{
  const Vector a = (p - from).normalized(), b = (q - from).normalized(),
               c = (r - from).normalized();
  return 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

// Returns whether the components of a closed manifold that does not intersect itself bound a
// solid, which is inside of components that are oriented outward, and outside of cavities, which
// are oriented inward. Therefore no other components, or one more outward than inward, are around
// a component.
inline bool bounds_solid(const std::vector<Vector>& points, const std::vector<Corners>& triangles,
                         const std::vector<Triangle_side>& sides)
{
  struct Component
  {
    std::vector<Corners> triangles;
    std::vector<Vector> points; // the corners of the triangles
    double volume = 0;
  };
  Face_components sets(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    sets.add(static_cast<Index>(t));
  for_each_edge(sides, [&](std::size_t i, std::size_t)
    { sets.join(sides[i].triangle(), sides[i + 1].triangle()); });
  std::map<Index, std::size_t> number; // the component of each representative
  std::vector<Component> components;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [found, is_new] =
      number.emplace(sets.representative(static_cast<Index>(t)), components.size());
    if (is_new)
      components.emplace_back();
    Component& c = components[found->second];
    c.triangles.push_back(triangles[t]);
    for (Index v : triangles[t])
      c.points.push_back(points[v]);
    const std::size_t n = c.points.size();
    c.volume += tetrahedron_volume(c.points[0], c.points[n - 3], c.points[n - 2], c.points[n - 1]);
  }
  std::vector<Bounding_box> boxes;
  for (const Component& c : components)
    boxes.emplace_back(c.points);

  for (const Component& c : components) {
    const Vector& p = c.points[0];
    double angle = 0;
    for (std::size_t i = 0; i < components.size(); ++i) {
      bool is_in_box = &components[i] != &c;
      for (std::size_t k = 0; k < 3; ++k)
        is_in_box = is_in_box && boxes[i].smallest[k] < p[k] && p[k] < boxes[i].largest[k];
      if (is_in_box)
        for (const Corners& t : components[i].triangles)
          angle += solid_angle(p, points[t[0]], points[t[1]], points[t[2]]);
    }
    const double number_around = std::round(angle / 12.566370614359172); // the full solid angle
    if (c.volume == 0 || number_around != (c.volume > 0 ? 0 : 1))
      return false;
  }
  return true;
}

// Returns the properties of a closed segment, except its id.
template <class Id>
Closed_segment<Id> check_segment(const std::vector<Vector>& points,
                                 const std::vector<Corners>& triangles)
{
  Closed_segment<Id> result;
  const std::vector<Triangle_side> sides = sorted_sides(triangles);
  result.is_closed = is_closed(sides);
  result.is_manifold = result.is_closed && is_manifold(triangles, sides);
  if (result.is_closed && !triangles.empty()) {
    const Vector origin = points[triangles[0][0]];
    for (const Corners& t : triangles)
      result.volume += tetrahedron_volume(origin, points[t[0]], points[t[1]], points[t[2]]);
  }
  result.has_self_intersections =
    std::any_of(triangles.begin(), triangles.end(),
                [&](const Corners& t) { return is_degenerate(points, t); }) ||
    do_self_intersect(points, triangles);
  result.is_outward_oriented =
    result.volume > 0 && (!result.is_manifold || result.has_self_intersections ||
                          bounds_solid(points, triangles, sides));
  return result;
}

// Returns the properties of each segment, in the order of their ids. The triangles of each segment
// with its caps are given.
template <class Id>
std::vector<Closed_segment<Id> >
closed_segments(const Segment_capping& capping,
                const std::vector<std::vector<Corners> >& triangles, const std::vector<Id>& ids)
{
  std::vector<Closed_segment<Id> > result;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    result.push_back(check_segment<Id>(capping.points(), triangles[i]));
    result.back().id = ids[i];
    result.back().volume *= capping.unit() * capping.unit() * capping.unit();
  }
  return result;
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_SEGMENT_CAPPING_H
