// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_BOUNDARY_BAND_H
#define CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_BOUNDARY_BAND_H

#include <CGAL/Segmented_mesh/internal/base.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// The splits of the faces of a mesh, with which smooth curves separate its segments.
//
// A point on an edge cuts the edge into two halves. The side of a face along its edge i is the
// halves 2i, at corner i, and 2i+1, at the next corner. If there is no point, both have one label.
struct Refinement
{
  struct Edge_point
  {
    Index halfedge;  // 3f+i is the i-th edge of face f
    double position; // 0 at its source, 1 at its target
  };

  // The new faces are triangles with a common apex.
  struct Split_face
  {
    Index face;
    std::array<Index, 3> points; // one per edge; `null_index` if it has none
    int apex;                    // the edge whose point it is, or `centroid`
    std::array<Index, 6> labels; // one per half, and so per new face along it
  };

  static constexpr int centroid = 3; // a new vertex there

  std::vector<Edge_point> points;
  std::vector<Split_face> split_faces;
  std::vector<std::pair<Index, Index> > other_labels; // faces that are not split, with their labels
};

// The neighborhood of the boundaries between segments, in which they may move.
class Boundary_band
{
  static constexpr int width = 3;             // rings of vertices around the boundary
  static constexpr double smooth_turn = 0.25; // the largest at a vertex where a boundary is smooth
  static constexpr int number_of_spreads = 3; // each by an edge, from vertices that are not smooth
  static constexpr double cosine_of_crease = 0.77; // 40 degrees between the normals
  static constexpr double long_crease = 3;         // times the mean edge length

  std::vector<Index> boundary_; // one halfedge per edge
  std::vector<char> is_inside_; // one per vertex
  std::vector<char> is_fixed_;  // one per vertex

  // Marks the vertices around marked vertices.
  void grow(const Surface& graph, std::vector<char>& is_near) const
  {
    const std::vector<char> was_near = is_near;
    for (const Corners& c : graph.corners)
      if (was_near[c[0]] || was_near[c[1]] || was_near[c[2]])
        is_near[c[0]] = is_near[c[1]] = is_near[c[2]] = 1;
  }

  // Fixes the smooth vertices. A boundary that ends at a border goes on smoothly.
  void fix_smooth_vertices(const Surface& graph)
  {
    const std::size_t n = graph.points.size();
    std::vector<Index> degree(n, 0);
    std::vector<Vector> directions(n); // each the sum of the directions to boundary neighbors
    for (Index h : boundary_) {
      const Index v = graph.source_vertex(h), w = graph.target_vertex(h);
      const Vector direction = (graph.points[w] - graph.points[v]).normalized();
      directions[v] += direction;
      directions[w] -= direction;
      ++degree[v];
      ++degree[w];
    }
    is_fixed_.assign(n, 0);
    for (Index v = 0; v < n; ++v)
      is_fixed_[v] = degree[v] == 1 || (degree[v] == 2 && directions[v].norm() <= smooth_turn);
    for (int i = 0; i < number_of_spreads; ++i) {
      const std::vector<char> was_smooth = is_fixed_;
      for (Index h : boundary_) {
        const Index v = graph.source_vertex(h), w = graph.target_vertex(h);
        is_fixed_[v] &= was_smooth[w];
        is_fixed_[w] &= was_smooth[v];
      }
    }
  }

  // Returns whether the surface has a sharp concave crease at the edge of a halfedge.
  static bool is_crease(const Surface& graph, Index h)
  {
    const Index f = h / 3, g = graph.neighbor(h);
    const Vector n = graph.normal(f).normalized();
    return n.dot(graph.normal(g).normalized()) < cosine_of_crease &&
           n.dot(graph.centroid(g) - graph.centroid(f)) > 0;
  }

  // Fixes the vertices at which all edges of the boundary are creases, and the ends of long
  // creases. The faces along creases between fixed vertices keep their labels.
  void fix_creases(const Surface& graph)
  {
    const std::size_t n = graph.points.size();
    double mean_length = 0;
    for (Index h = 0; h < graph.number_of_halfedges(); ++h)
      mean_length += graph.length(h) / graph.number_of_halfedges();
    std::vector<Index> creases; // one halfedge per edge
    std::vector<char> is_end(n, 0), has_other_edge(n, 0);
    for (Index h : boundary_) {
      const bool is_in_crease = is_crease(graph, h);
      if (is_in_crease)
        creases.push_back(h);
      for (Index v : {graph.source_vertex(h), graph.target_vertex(h)}) {
        (is_in_crease ? is_end : has_other_edge)[v] = 1;
        is_fixed_[v] |= is_in_crease && graph.length(h) > long_crease * mean_length;
      }
    }
    for (Index v = 0; v < n; ++v)
      is_fixed_[v] |= is_end[v] && !has_other_edge[v];
    for (Index h : creases)
      if (is_fixed(graph.source_vertex(h)) && is_fixed(graph.target_vertex(h))) {
        kept_faces.push_back(h / 3);
        kept_faces.push_back(graph.neighbor(h));
      }
  }

  // Fixes the ends of an edge with more than two faces: some of its sides have no neighbor, and
  // would not be cut at the same point.
  void fix_crowded_edges(const Surface& graph)
  {
    typedef std::pair<Index, Index> Ends;
    const auto ends = [&](Index h)
    { return Ends(std::minmax({graph.source_vertex(h), graph.target_vertex(h)})); };
    std::vector<Ends> borders;
    for (Index h = 0; h < graph.number_of_halfedges(); ++h)
      if (graph.is_border(h))
        borders.push_back(ends(h));
    std::sort(borders.begin(), borders.end());
    for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
      const auto [first, last] = std::equal_range(borders.begin(), borders.end(), ends(h));
      if (last - first > (graph.is_border(h) ? 1 : 0))
        is_fixed_[first->first] = is_fixed_[first->second] = 1;
    }
  }

public:
  std::vector<Index> faces;      // faces with a vertex inside
  std::vector<Index> kept_faces; // faces that keep their labels

  Boundary_band(const Surface& graph, const std::vector<Index>& labels)
  {
    for (Index h = 0; h < graph.number_of_halfedges(); ++h)
      if (labels[h / 3] < labels[graph.neighbor(h)])
        boundary_.push_back(h);
    fix_smooth_vertices(graph);
    fix_creases(graph);
    fix_crowded_edges(graph);
    is_inside_.assign(graph.points.size(), 0);
    for (Index h : boundary_)
      is_inside_[graph.source_vertex(h)] = is_inside_[graph.target_vertex(h)] = 1;
    for (int ring = 1; ring < width; ++ring)
      grow(graph, is_inside_);
    for (Index f = 0; f < graph.number_of_faces(); ++f) {
      const Corners& c = graph.corners[f];
      if (is_inside_[c[0]] || is_inside_[c[1]] || is_inside_[c[2]])
        faces.push_back(f);
    }
  }

  bool is_inside(Index v) const { return is_inside_[v] != 0; }

  // Returns whether the boundary stays at the vertex, because it lies in a sharp concave crease, or
  // is smooth for some edges in both directions.
  bool is_fixed(Index v) const { return is_fixed_[v] != 0; }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_BOUNDARY_BAND_H
