// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_DISC_CAPS_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_DISC_CAPS_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/capping/Segmented_solid.h>
#include <CGAL/Segmented_mesh/internal/capping/triangulated_loop.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Appends a strip between a range of edges of a loop and of its copy.
inline void add_strip(const Loop& loop, const Loop& copy, std::size_t begin, std::size_t end,
                      std::vector<Corners>& triangles)
{
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t j = (i + 1) % loop.size();
    triangles.push_back({loop[i], loop[j], copy[j]});
    triangles.push_back({loop[i], copy[j], copy[i]});
  }
}

// The shape of a disc, whose rim leads inwards for `depth` edges of the loop.
struct Disc_shape
{
  double depth;
  bool is_fan; // around a new point in the middle
};

// The shapes in ascending order of effort. All but the first two are for loops whose caps would
// leave the solid near the loop, because its vertices zigzag or lie in a concave fold.
constexpr Disc_shape disc_shapes[] = {{0, false}, {0, true}, {.5, false}, {2, false}, {.1, false}};

inline Vector middle(const std::vector<Vector>& points, const Loop& loop)
{
  Vector result;
  for (Index v : loop)
    result += points[v] / static_cast<double>(loop.size());
  return result;
}

inline std::vector<Corners> fan(Segmented_solid& solid, const Loop& loop)
{
  const Index middle = solid.add_point(internal::middle(solid.points(), loop));
  std::vector<Corners> result;
  for (std::size_t i = 0; i < loop.size(); ++i)
    result.push_back({loop[i], loop[(i + 1) % loop.size()], middle});
  return result;
}

// Returns triangles between the vertices of a loop; none if CGAL finds none.
inline std::vector<Corners> triangles_in(const Segmented_solid& solid, const Loop& loop)
{
  std::vector<Vector> points;
  for (Index v : loop)
    points.push_back(solid.points()[v]);
  std::vector<Corners> triangles = triangulated_loop(std::move(points));
  for (Corners& t : triangles)
    t = {loop[t[0]], loop[t[1]], loop[t[2]]};
  return triangles;
}

// Returns a copy of a loop that lies inside the solid, `depth` edges deep, and is smoother.
inline Loop moved_inwards(Segmented_solid& solid, const Loop& loop, double depth)
{
  const std::size_t n = loop.size();
  const auto before = [n](std::size_t i) { return (i + n - 1) % n; };
  const auto after = [n](std::size_t i) { return (i + 1) % n; };
  std::vector<Vector> moved(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector &p = solid.points()[loop[before(i)]], &q = solid.points()[loop[i]],
                 &r = solid.points()[loop[after(i)]];
    moved[i] = q + depth / 2 * ((p - q).norm() + (r - q).norm()) * solid.inward(loop[i]);
  }
  for (int round = 0; round < 3; ++round) {
    const std::vector<Vector> given = moved;
    for (std::size_t i = 0; i < n; ++i)
      moved[i] = (given[before(i)] + 2 * given[i] + given[after(i)]) / 4;
  }
  Loop result;
  for (const Vector& p : moved)
    result.push_back(solid.add_point(p));
  return result;
}

// Returns the point in the planes of all arcs of a loop, for example the corner where three planes
// meet, if there is one. The middle of the loop is projected to one plane after the other.
inline std::optional<Vector> corner_of(const std::vector<Vector>& points, const Loop& loop,
                                       const std::vector<Arc>& arcs)
{
  Vector result = middle(points, loop);
  double distance = 0; // the largest one to a plane in the last round
  for (int round = 0; round < 20; ++round) {
    distance = 0;
    for (const Arc& a : arcs) {
      const Vector& start = points[loop[a.begin]];
      Vector normal;
      for (std::size_t i = a.begin; i < a.end; ++i)
        normal += (points[loop[i]] - start).cross(points[loop[(i + 1) % loop.size()]] - start);
      const Vector step = (result - start).dot(normal.normalized()) * normal.normalized();
      distance = (std::max)(distance, step.norm());
      result -= step;
    }
  }
  if (distance > 1e-3 * (points[loop[0]] - result).norm())
    return std::nullopt;
  return result;
}

// Appends the sector of a cap that a loop bounds, and returns whether there are such triangles.
inline bool add_sector(const Segmented_solid& solid, const Loop& loop, Index segment, Cap& cap)
{
  const std::vector<Corners> triangles = triangles_in(solid, loop);
  cap.add(triangles, segment);
  return !triangles.empty();
}

// Returns a cap without further points. Chords cut off all arcs but those of one segment, which
// gets the rest of the loop. It is empty if there is no such cap.
inline Cap disc_with_chords(const Segmented_solid& solid, const Loop& loop,
                            const std::vector<Arc>& arcs, Index segment_of_rest)
{
  Cap result;
  Loop rest;
  for (const Arc& a : arcs) {
    Loop sector;
    for (std::size_t i = a.begin; i <= a.end; ++i)
      sector.push_back(loop[i % loop.size()]);
    const bool is_cut_off = a.segment != segment_of_rest && sector.size() > 2;
    if (is_cut_off && !add_sector(solid, sector, a.segment, result))
      return {};
    rest.insert(rest.end(), sector.begin(), is_cut_off ? sector.begin() + 1 : sector.end() - 1);
  }
  if (rest.size() > 2 && !add_sector(solid, rest, segment_of_rest, result))
    return {};
  return result;
}

// Returns a cap of a loop; several arcs get sectors around a corner, by default a point in the
// middle. It is empty if there is no such cap.
inline Cap disc(Segmented_solid& solid, const Loop& loop, const std::vector<Arc>& arcs,
                const Disc_shape& shape, const std::optional<Vector>& corner = std::nullopt)
{
  const Loop rim = shape.depth > 0 ? moved_inwards(solid, loop, shape.depth) : loop;
  const bool has_sectors = arcs.size() > 1;
  const Index v =
    has_sectors ? solid.add_point(corner.value_or(middle(solid.points(), rim))) : null_index;
  Cap result;
  for (const Arc& a : arcs) {
    Loop sector;
    if (has_sectors)
      sector.push_back(v);
    for (std::size_t i = a.begin; i < a.end + has_sectors; ++i)
      sector.push_back(rim[i % rim.size()]);
    std::vector<Corners> triangles =
      shape.is_fan ? fan(solid, sector) : triangles_in(solid, sector);
    if (triangles.empty())
      return {};
    if (shape.depth > 0)
      add_strip(loop, rim, a.begin, a.end, triangles);
    result.add(triangles, a.segment);
  }
  return result;
}

// Returns the first cap of the only loop of an opening that fits; it is empty if none does. Without
// `must_be_free` the cap may intersect something.
inline Cap disc(Segmented_solid& solid, const Opening& opening, bool must_be_free)
{
  Loop loop = opening.loops[0];
  const std::vector<Arc> arcs =
    solid.borders().long_arcs(solid.points(), loop, opening.segment);
  const std::size_t n = solid.points().size();
  Cap result;
  const auto accept = [&](Cap cap) {
    if (!cap.empty() && (must_be_free ? solid.fit(cap.triangles, opening)
                                      : !solid.take_an_edge_twice(cap.triangles, opening)))
      result = std::move(cap);
    else
      solid.resize_points(n);
    return !result.empty();
  };
  if (arcs.size() > 1 && must_be_free && solid.sectors() != Sectors::NONE) {
    const std::optional<Vector> corner = corner_of(solid.points(), loop, arcs);
    if (corner && accept(disc(solid, loop, arcs, disc_shapes[0], corner)))
      return result;
    for (const Arc& a : arcs)
      if (solid.sectors() == Sectors::FLAT_OR_WITH_CHORDS &&
          accept(disc_with_chords(solid, loop, arcs, a.segment)))
        return result;
  }
  for (const Disc_shape& shape : disc_shapes)
    if (accept(disc(solid, loop, arcs, shape)))
      return result;
  return must_be_free ? Cap() : disc(solid, loop, arcs, disc_shapes[1]);
}

// Returns a cap of all loops of a segment, which makes a shell of the segment: a copy of its
// triangles, moved inwards for a fraction of their edges. The segment on its other side is the one
// that has most of the border.
inline Cap shell(Segmented_solid& solid, const Opening& opening, double depth)
{
  struct Vertex
  {
    std::vector<Vector> normals; // one per triangle of the segment
    double shortest_edge = (std::numeric_limits<double>::infinity)();
    Index copy = null_index;
  };
  std::map<Index, Vertex> vertices;
  const std::vector<Corners>& triangles = solid.triangles()[opening.segment];
  for (const Corners& t : triangles)
    for (Index v : t) {
      vertices[v].normals.push_back(normal(solid.points(), t).normalized());
      for (Index w : t)
        if (w != v)
          vertices[v].shortest_edge = (std::min)(vertices[v].shortest_edge,
                                                 (solid.points()[w] - solid.points()[v]).norm());
    }
  const auto copy = [&](Index v, bool is_at_border) {
    Vertex& vertex = vertices[v];
    if (vertex.copy == null_index) {
      const Vector inward = is_at_border ? solid.inward(v) : solid.inward(vertex.normals);
      vertex.copy = solid.add_point(solid.points()[v] + depth * vertex.shortest_edge * inward);
    }
    return vertex.copy;
  };

  double longest = -1;
  Index segment = null_index;
  std::vector<Corners> result;
  for (Loop loop : opening.loops) {
    for (const Arc& a : solid.borders().long_arcs(solid.points(), loop, opening.segment))
      if (a.length > longest) {
        longest = a.length;
        segment = a.segment;
      }
    Loop copies;
    for (Index v : loop)
      copies.push_back(copy(v, true));
    add_strip(loop, copies, 0, loop.size(), result);
  }
  for (const Corners& t : triangles)
    result.push_back({copy(t[0], false), copy(t[2], false), copy(t[1], false)});
  Cap cap;
  cap.add(result, segment);
  return cap;
}

// Returns the deepest shell that intersects nothing; it is empty if none does.
inline Cap shell(Segmented_solid& solid, const Opening& opening)
{
  const std::size_t n = solid.points().size();
  for (double depth : {0.3, 0.1, 0.03}) {
    Cap cap = shell(solid, opening, depth);
    if (solid.are_free(cap.triangles))
      return cap;
    solid.resize_points(n);
  }
  return {};
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_DISC_CAPS_H
