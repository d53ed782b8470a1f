// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SURFACE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SURFACE_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>
#include <CGAL/Spectral_segmentation/internal/base/Vector.h>
#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The vertices of a face.
typedef std::array<Index, 3> Corners;

// The weights of an edge for the search (Section 3).
struct Edge_weights
{
  float geodesic = 0;  // G, normalized
  float angle = 0;     // H, equalized
  float combined = 0;  // d, Equation 1
  float concavity = 0; // the part of H that is due to concave edges
  float centroids = 0; // the straight distance between the centroids of the two faces
};

// The connected components of a surface, numbered by their first faces.
struct Components
{
  std::size_t number = 1;
  std::vector<Index> labels; // one per face; empty if there is one component

  Index operator[](std::size_t f) const { return labels.empty() ? 0 : labels[f]; }

  // Returns the component of each of n faces.
  std::vector<Index> face_labels(std::size_t n) const
  {
    std::vector<Index> result = labels;
    result.resize(n, 0);
    return result;
  }
};

// A triangulated surface as arrays, or a part of one: the only mesh inside the engine. It is a
// directed model of BGL's `VertexListGraph` and `IncidenceGraph`: the vertices are the faces, and
// the edges are the halfedges, which lead from their face to the face across.
//
// Halfedge 3f+i belongs to face f and runs from its corner i to its corner (i+1)%3. A halfedge on
// the border is its own opposite. Therefore the face across it is its own face, and the edge is a
// loop. No two halfedges of one face are opposite.
struct Surface
{
  std::vector<Corners> corners;      // one per face
  std::vector<Index> opposite;       // one per halfedge
  std::vector<Vector> points;        // one per vertex, finite
  std::vector<Index> groups;         // one per face; empty if no faces are kept separate
  std::vector<double> areas;         // one per face
  std::vector<Edge_weights> weights; // one per halfedge; empty if no cut is searched
  Components components;             // a part that is searched has one

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  std::size_t number_of_faces() const { return corners.size(); }
  Index number_of_halfedges() const { return static_cast<Index>(opposite.size()); }

  Index source_vertex(Index h) const { return corners[h / 3][h % 3]; }
  Index target_vertex(Index h) const { return corners[h / 3][(h + 1) % 3]; }
  bool is_border(Index h) const { return opposite[h] == h; }
  Index neighbor(Index h) const { return opposite[h] / 3; } // the face across

  double length(Index h) const
  { return (points[target_vertex(h)] - points[source_vertex(h)]).norm(); }

  Vector centroid(Index f) const { return centroid(f, points); }

  // Returns the centroid of a face whose vertices are at other points.
  Vector centroid(Index f, const std::vector<Vector>& other_points) const
  {
    const Corners& c = corners[f];
    return (other_points[c[0]] + other_points[c[1]] + other_points[c[2]]) / 3;
  }

  // Returns the normal of a face; its length is twice the area.
  Vector normal(Index f) const
  {
    const Corners& c = corners[f];
    return (points[c[1]] - points[c[0]]).cross(points[c[2]] - points[c[0]]);
  }

  // BGL
  typedef Index vertex_descriptor;
  typedef Index edge_descriptor;
  typedef boost::directed_tag directed_category;
  typedef boost::allow_parallel_edge_tag edge_parallel_category;
  struct traversal_category : boost::vertex_list_graph_tag, boost::incidence_graph_tag {};
  typedef boost::counting_iterator<Index> vertex_iterator;
  typedef boost::counting_iterator<Index> out_edge_iterator;
  typedef Index vertices_size_type;
  typedef Index edges_size_type;
  typedef Index degree_size_type;
  static vertex_descriptor null_vertex() { return null_index; }
};

// A surface of a run. Each one after the first is made from the one before: its faces are bisected,
// its vertices clustered, its edges collapsed, or it is copied.
struct Level
{
  Surface surface;
  std::vector<Index> parent_face;   // of the level before, for each face; first: the caller's
  std::vector<Index> coarse_vertex; // for each vertex of the level before, or null_index
  bool is_subdivision = false;      // each face of the level before is the union of faces
};

// Returns values[i] for each index i.
inline std::vector<Index> composed(const std::vector<Index>& indices,
                                   const std::vector<Index>& values)
{
  std::vector<Index> result;
  result.reserve(indices.size());
  for (Index i : indices)
    result.push_back(values[i]);
  return result;
}

inline void set_areas(Execution execution, Surface& surface)
{
  surface.areas.resize(surface.number_of_faces());
  for_each_index(execution, surface.number_of_faces(), [&](std::size_t f)
    { surface.areas[f] = surface.normal(static_cast<Index>(f)).norm() / 2; });
}

inline double total_area(const Surface& surface)
{ return std::accumulate(surface.areas.begin(), surface.areas.end(), 0.); }

// Moves the points into [-1, 1]^3 and returns the length of 1 in the old unit. It is a power of
// two, so that scaling is exact.
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

// Renumbers the halfedges one to one: h becomes `new_index(h)`.
template <class New_index>
void renumber_halfedges(Surface& surface, const New_index& new_index)
{
  std::vector<Index> opposite(surface.opposite.size());
  for (Index h = 0; h < opposite.size(); ++h)
    opposite[new_index(h)] = new_index(surface.opposite[h]);
  surface.opposite = std::move(opposite);
}

// Reverses all faces.
inline void reverse_orientation(Surface& surface)
{
  for (Corners& c : surface.corners)
    std::swap(c[1], c[2]);
  renumber_halfedges(surface, [](Index h) { return h - h % 3 + (2 - h % 3); });
}

// Rotates each face to start at its smallest vertex in an order, so that all models of a mesh give
// equal arrays.
template <class IsLess = std::less<Index> >
void start_at_smallest_vertices(Surface& surface, const IsLess& is_less = IsLess())
{
  std::vector<unsigned char> shift;
  shift.reserve(surface.number_of_faces());
  for (Corners& c : surface.corners) {
    const auto smallest = std::min_element(c.begin(), c.end(), is_less);
    shift.push_back(static_cast<unsigned char>(c.end() - smallest));
    std::rotate(c.begin(), smallest, c.end());
  }
  renumber_halfedges(surface, [&](Index h) { return h - h % 3 + (h % 3 + shift[h / 3]) % 3; });
}

// BGL

inline Index num_vertices(const Surface& s) { return static_cast<Index>(s.number_of_faces()); }

inline std::pair<Surface::vertex_iterator, Surface::vertex_iterator> vertices(const Surface& s)
{ return {Surface::vertex_iterator(0), Surface::vertex_iterator(num_vertices(s))}; }

inline std::pair<Surface::out_edge_iterator, Surface::out_edge_iterator>
out_edges(Index f, const Surface&)
{ return {Surface::out_edge_iterator(3 * f), Surface::out_edge_iterator(3 * f + 3)}; }

inline Index out_degree(Index, const Surface&) { return 3; }
inline Index source(Index h, const Surface&) { return h / 3; }
inline Index target(Index h, const Surface& s) { return s.neighbor(h); }

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SURFACE_H
