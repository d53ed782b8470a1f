// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_BORDER_LOOPS_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_BORDER_LOOPS_H

#include <CGAL/Spectral_segmentation/internal/base/arrays.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/assertions.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Two vertices, the smaller first.
typedef std::pair<Index, Index> Vertex_pair;

inline Vertex_pair vertex_pair(Index v, Index w) { return {(std::min)(v, w), (std::max)(v, w)}; }

// The edges that an odd number of triangles of a set have. The number is positive if these pass the
// edge from its smaller to its larger vertex, negative if back.
typedef std::map<Vertex_pair, int> Border;

// Takes a border apart into loops that pass no vertex twice, against the direction of most of the
// triangles at them. As an even number of border edges meets at each vertex, loops have them all,
// however the triangles meet and are oriented.
class Border_loops
{
  struct Step
  {
    Index vertex;
    int direction; // of the border edge behind it
  };

  std::map<Index, std::vector<std::pair<Index, int> > > unused_; // other ends and directions
  std::vector<Step> path_;
  std::unordered_map<Index, std::size_t> place_; // of each vertex of the path
  std::vector<std::vector<Index> > loops_;

  // Takes the edge to w from v.
  void use(Index v, Index w)
  {
    auto& edges = unused_[v];
    edges.erase(std::find_if(edges.begin(), edges.end(), [w](const auto& e)
                             { return e.first == w; }));
  }

  // Takes the end of the path, from its `first` vertex on.
  void add_loop(std::size_t first)
  {
    std::vector<Index> loop;
    int direction = 0;
    for (std::size_t i = first; i < path_.size(); ++i) {
      loop.push_back(path_[i].vertex);
      direction += path_[i].direction > 0 ? 1 : -1;
      place_.erase(path_[i].vertex);
    }
    path_.resize(first);
    if (direction > 0)
      std::reverse(loop.begin(), loop.end());
    loops_.push_back(std::move(loop));
  }

  // Until no edge is left at v, which then is the vertex where it began.
  void walk(Index v)
  {
    while (!unused_[v].empty()) {
      const auto& edges = unused_[v];
      const auto along = std::find_if(edges.begin(), edges.end(), [](const auto& e)
                                      { return e.second < 0; });
      const auto [w, direction] = along == edges.end() ? edges.front() : *along;
      use(v, w);
      use(w, v);
      place_[v] = path_.size();
      path_.push_back({v, direction});
      v = w;
      const auto passed = place_.find(v);
      if (passed != place_.end())
        add_loop(passed->second);
    }
    CGAL_assertion(path_.empty());
  }

public:
  explicit Border_loops(const Border& border)
  {
    for (const auto& [edge, direction] : border) {
      unused_[edge.first].emplace_back(edge.second, direction);
      unused_[edge.second].emplace_back(edge.first, -direction);
    }
    for (const auto& [edge, direction] : border)
      walk(edge.first);
  }

  const std::vector<std::vector<Index> >& operator()() const { return loops_; }
};

inline double length(const std::vector<Vector>& loop)
{
  double result = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    result += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  return result;
}

// Whether a loop is nearer than a distance to the plane through its middle with the mean normal of
// its triangles there.
inline bool is_flat(const std::vector<Vector>& loop, double distance)
{
  Vector middle, normal;
  for (const Vector& p : loop)
    middle += p / static_cast<double>(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i)
    normal += (loop[i] - middle).cross(loop[(i + 1) % loop.size()] - middle);
  return std::all_of(loop.begin(), loop.end(), [&](const Vector& p) {
    return std::abs((p - middle).dot(normal)) <= distance * normal.norm();
  });
}

// A triangulation of a loop of points, whose triangles are given by places in it, in its direction:
// Delaunay in the plane of the loop if that is nearly flat, else a surface that bends little and
// has a small area. Empty if CGAL finds none, or would take minutes.
inline std::vector<Corners> triangulated_loop(std::vector<Vector> loop)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  normalize(loop);
  const Bounding_box box(loop);
  const double diagonal = (box.largest - box.smallest).norm();
  if (!is_flat(loop, 0.1 * diagonal) && length(loop) > 50 * diagonal)
    return {}; // it fills space, where CGAL's search among tetrahedra is slow
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  for (const Vector& p : loop)
    points.emplace_back(p.x(), p.y(), p.z());
  std::vector<CGAL::Triple<int, int, int> > triangles;
  PMP::triangulate_hole_polyline(
    points, std::back_inserter(triangles),
    CGAL::parameters::use_2d_constrained_delaunay_triangulation(true)
      .threshold_distance(0.1 * diagonal)
      .do_not_use_cubic_algorithm(true));
  std::vector<Corners> result;
  if (triangles.size() + 2 == loop.size())
    for (const auto& t : triangles) {
      result.push_back({Index(t.first), Index(t.second), Index(t.third)});
      std::sort(result.back().begin(), result.back().end());
    }
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_BORDER_LOOPS_H
