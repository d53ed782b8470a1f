// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SURFACE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SURFACE_H

#include <CGAL/Spectral_segmentation/internal/base/Vector.h>
#include <CGAL/Spectral_segmentation/internal/base/arrays.h>
#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The vertices of a face.
typedef std::array<Index, 3> Corners;

// What the search knows of an edge (Section 3).
struct Edge_weights
{
  float geodesic = 0;  // G, normalized
  float angle = 0;     // H, equalized
  float combined = 0;  // d, Equation 1
  float concavity = 0; // the part of H that is due to concave bending
  float centroids = 0; // the straight distance of the centroids of the two faces
};

// The connected components of a surface, numbered by their first faces.
struct Components
{
  std::size_t number = 1;
  std::vector<Index> of_face; // empty if there is one component

  Index operator[](std::size_t f) const { return of_face.empty() ? 0 : of_face[f]; }
};

// A triangulated surface as arrays: the mesh of all stages, from the door to the parts of the
// search.
//
// Half-edge 3f+i belongs to face f and runs from its corner i to its corner (i+1)%3. A half-edge on
// the border is its own opposite, so the face across it is its own face, of which no search takes
// notice. No two half-edges of one face are opposite.
struct Surface
{
  std::vector<Corners> corners;      // of each face
  std::vector<Index> opposite;       // of each half-edge
  std::vector<Vector> points;        // of each vertex, finite
  std::vector<double> areas;         // of each face
  std::vector<Edge_weights> weights; // of each half-edge; empty where no cut is searched
  Components components;             // a part of the search has one

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  std::size_t number_of_faces() const { return corners.size(); }
  Index number_of_halfedges() const { return static_cast<Index>(opposite.size()); }

  Index source(Index h) const { return corners[h / 3][h % 3]; }
  Index target(Index h) const { return corners[h / 3][(h + 1) % 3]; }
  bool is_border(Index h) const { return opposite[h] == h; }
  Index neighbor(Index h) const { return opposite[h] / 3; } // the face across

  double length(Index h) const { return (points[target(h)] - points[source(h)]).norm(); }

  Vector centroid(Index f) const { return centroid(f, points); }

  // The same with the vertices at other points.
  Vector centroid(Index f, const std::vector<Vector>& other_points) const
  {
    const Corners& c = corners[f];
    return (other_points[c[0]] + other_points[c[1]] + other_points[c[2]]) / 3;
  }

  // Twice the area, along the normal.
  Vector area_vector(Index f) const
  {
    const Corners& c = corners[f];
    return (points[c[1]] - points[c[0]]).cross(points[c[2]] - points[c[0]]);
  }
};

inline void set_areas(Execution execution, Surface& surface)
{
  surface.areas.resize(surface.number_of_faces());
  for_each_index(execution, surface.number_of_faces(), [&](std::size_t f)
    { surface.areas[f] = surface.area_vector(static_cast<Index>(f)).norm() / 2; });
}

inline double total_area(const Surface& surface)
{ return std::accumulate(surface.areas.begin(), surface.areas.end(), 0.); }

// Moves the points into [-1, 1]^3 and returns the length of 1 in the old unit, a power of two, so
// that scaling rounds nothing.
inline double normalize(std::vector<Vector>& points)
{
  const Bounding_box box(points);
  const Vector center = box.smallest / 2 + box.largest / 2;
  const double half_extent = (box.largest / 2 - box.smallest / 2).largest_coordinate();
  const double unit =
    half_extent > 0 ? std::ldexp(1., (std::min)(std::ilogb(half_extent) + 1, 1023)) : 1;
  for (Vector& p : points)
    p = (p - center) / unit;
  return unit;
}

// Renumbers half-edges one to one: h becomes `place(h)`. Of arrays by half-edges there is `opposite`
// alone.
template <class Place>
void renumber_halfedges(Surface& surface, const Place& place)
{
  std::vector<Index> opposite(surface.opposite.size());
  for (Index h = 0; h < opposite.size(); ++h)
    opposite[place(h)] = place(surface.opposite[h]);
  surface.opposite = std::move(opposite);
}

// Lets each face start at its smallest vertex, so that all models of a mesh give the same arrays.
inline void start_at_smallest_vertices(Surface& surface)
{
  std::vector<unsigned char> first;
  first.reserve(surface.number_of_faces());
  for (Corners& c : surface.corners) {
    const auto smallest = std::min_element(c.begin(), c.end());
    first.push_back(static_cast<unsigned char>(smallest - c.begin()));
    std::rotate(c.begin(), smallest, c.end());
  }
  renumber_halfedges(surface, [&](Index h) { return h - h % 3 + (h % 3 + 3 - first[h / 3]) % 3; });
}

// The points after some steps of uniform Laplacian smoothing (Section 2): each moves half the way
// to the mean of its neighbors; vertices on the border of the mesh stay. Ends early if
// `go_further()`, asked before each step, is false.
template <class GoFurther>
std::vector<Vector> smoothed_points(const Surface& graph, std::size_t iterations,
                                    const GoFurther& go_further)
{
  std::vector<Vector> points = graph.points;
  if (iterations == 0)
    return points;
  std::vector<char> is_fixed(points.size(), 0);
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (graph.is_border(h))
      is_fixed[graph.source(h)] = is_fixed[graph.target(h)] = 1;

  std::vector<Vector> sum(points.size());
  std::vector<unsigned> degree(points.size());
  for (; iterations > 0 && go_further(); --iterations) {
    std::fill(sum.begin(), sum.end(), Vector());
    std::fill(degree.begin(), degree.end(), 0u);
    // One half-edge of each edge starts at an inner vertex, so the mean is unweighted.
    for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
      sum[graph.source(h)] += points[graph.target(h)];
      ++degree[graph.source(h)];
    }
    for (std::size_t v = 0; v < points.size(); ++v)
      if (!is_fixed[v] && degree[v] > 0)
        points[v] = (points[v] + sum[v] / degree[v]) / 2;
  }
  return points;
}

inline std::vector<Vector> smoothed_points(const Surface& graph, std::size_t iterations)
{ return smoothed_points(graph, iterations, [] { return true; }); }

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SURFACE_H
