// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_COARSENING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_COARSENING_H

#include <CGAL/Spectral_segmentation/internal/levels/Edge_collapse.h>
#include <CGAL/Spectral_segmentation/internal/surface/reorder_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Coarsens a surface by vertex clustering (Rossignac and Borrel 1993). A cluster is a set of
// vertices in one grid cell that are connected by edges inside the cell, so that nearby sheets stay
// separate. It is contracted to a vertex if this keeps the topology of the surface. A face is kept
// if its corners are in three clusters.
//
// The new vertex minimizes the squared distances to the planes of the faces around the cluster
// (Lindstrom 2000). Clustering takes linear time, a quarter of the time of collapsing edges.
class Vertex_clustering
{
  typedef std::array<std::int64_t, 3> Cell;

  const Surface& mesh_;
  const double width_;                 // the edge length of a cell
  std::vector<Cell> cells_;            // one per vertex
  std::vector<Index> cluster_;         // one per vertex
  std::vector<char> is_contracted_;    // one per cluster
  Level result_;

  // Returns the cell of a point. Mirroring the surface mirrors the cells.
  Cell cell(const Vector& p) const
  {
    return {std::llround(p.x() / width_), std::llround(p.y() / width_),
            std::llround(p.z() / width_)};
  }

  Vector center(const Cell& c) const
  {
    return width_ * Vector(static_cast<double>(c[0]), static_cast<double>(c[1]),
                           static_cast<double>(c[2]));
  }

  // Returns the cluster of each corner of a face.
  Corners clusters(Index f) const
  {
    const Corners& c = mesh_.corners[f];
    return {cluster_[c[0]], cluster_[c[1]], cluster_[c[2]]};
  }

  // Returns whether a face is kept. Clusters that are not contracted keep their vertices.
  bool is_kept(Index f) const
  {
    const auto is_joined = [&](Index a, Index b) { return a == b && is_contracted_[a]; };
    const Corners c = clusters(f);
    return !is_joined(c[0], c[1]) && !is_joined(c[1], c[2]) && !is_joined(c[2], c[0]);
  }

  void set_clusters()
  {
    const Index n = static_cast<Index>(mesh_.points.size());
    for (const Vector& p : mesh_.points)
      cells_.push_back(cell(p));
    Face_components sets(n); // sets of vertices
    for (Index v = 0; v < n; ++v)
      sets.add(v);
    for (Index h = 0; h < mesh_.number_of_halfedges(); ++h) {
      const Index v = mesh_.source_vertex(h), w = mesh_.target_vertex(h);
      if (h <= mesh_.opposite[h] && cells_[v] == cells_[w])
        sets.join(v, w);
    }
    cluster_.reserve(n);
    for (Index v = 0; v < n; ++v)
      cluster_.push_back(sets.representative(v));
  }

  // Finds the clusters that can be contracted: the vertices, edges and faces inside are connected
  // and have no hole, and at most one arc of the border runs through.
  void check_topology()
  {
    const std::size_t n = mesh_.points.size();
    std::vector<int> euler(n, 0), number_of_arcs(n, 0); // one per cluster
    std::vector<char> is_on_border(n, 0);
    for (Index h = 0; h < mesh_.number_of_halfedges(); ++h) {
      const Index v = mesh_.source_vertex(h), w = mesh_.target_vertex(h);
      if (mesh_.is_border(h))
        is_on_border[v] = is_on_border[w] = 1;
      if (cluster_[v] != cluster_[w] || h > mesh_.opposite[h])
        continue;
      --euler[cluster_[v]];
      if (mesh_.is_border(h))
        --number_of_arcs[cluster_[v]];
    }
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      const Corners c = clusters(f);
      if (c[0] == c[1] && c[1] == c[2])
        ++euler[c[0]];
    }
    for (Index v = 0; v < n; ++v) {
      ++euler[cluster_[v]];
      number_of_arcs[cluster_[v]] += is_on_border[v];
    }
    is_contracted_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      is_contracted_[i] = euler[i] == 1 && number_of_arcs[i] <= 1;
  }

  // Excludes the vertices of a component from contraction if it would lose all its faces.
  void keep_components()
  {
    std::vector<char> has_face(mesh_.components.number, 0);
    for (Index f = 0; f < mesh_.number_of_faces(); ++f)
      if (!has_face[mesh_.components[f]])
        has_face[mesh_.components[f]] = is_kept(f);
    if (std::all_of(has_face.begin(), has_face.end(), [](char has) { return has != 0; }))
      return;
    for (Index f = 0; f < mesh_.number_of_faces(); ++f)
      if (!has_face[mesh_.components[f]])
        for (Index cluster : clusters(f))
          is_contracted_[cluster] = 0;
  }

  void number_vertices()
  {
    std::vector<Index> number(mesh_.points.size(), null_index); // one per contracted cluster
    Index next = 0;
    for (Index v = 0; v < mesh_.points.size(); ++v) {
      const bool is_contracted = is_contracted_[cluster_[v]];
      if (!is_contracted || number[cluster_[v]] == null_index)
        number[cluster_[v]] = next++;
      result_.vertex.push_back(number[cluster_[v]]);
    }
    result_.surface.points.resize(next);
  }

  // The surroundings of a vertex of the result. Lengths are measured from the center of the cell.
  struct Surroundings
  {
    Planes planes; // the planes of the faces
    Vector sum;    // the points, weighted by the areas of the faces around them
    double weight = 0;
    Index vertex = null_index; // the last vertex
    bool is_single = true;
  };

  // Adds the plane through a border edge, orthogonal to its face, which keeps the border in place.
  void add_border(Index h, const Vector& unit_normal, std::vector<Surroundings>& around,
                  const std::vector<Cell>& cell) const
  {
    const Vector &p = mesh_.points[mesh_.source_vertex(h)],
                 &q = mesh_.points[mesh_.target_vertex(h)];
    const Index first = result_.vertex[mesh_.source_vertex(h)],
                second = result_.vertex[mesh_.target_vertex(h)];
    const Vector normal = (q - p).norm() * (q - p).cross(unit_normal);
    around[first].planes.add(normal, p - center(cell[first]));
    if (second != first)
      around[second].planes.add(normal, p - center(cell[second]));
  }

  Vector best_point(const Surroundings& around, const Vector& center) const
  {
    const Vector mean = around.sum / around.weight;
    const Vector step = around.planes.step_from(mean, 0.01);
    const bool is_near = step.squared_norm() <= width_ * width_; // false for NaN
    return quantized(center + (is_near ? mean + step : mean));
  }

  void set_points()
  {
    std::vector<Surroundings> around(result_.surface.points.size());
    std::vector<Cell> cell(around.size());
    for (Index v = 0; v < mesh_.points.size(); ++v) {
      const Index i = result_.vertex[v];
      around[i].is_single = around[i].vertex == null_index;
      around[i].vertex = v;
      cell[i] = cells_[v];
    }
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      const Corners& c = mesh_.corners[f];
      const Vector normal = mesh_.normal(f);
      for (int k = 0; k < 3; ++k) {
        const Index i = result_.vertex[c[k]];
        Surroundings& p = around[i];
        if (p.is_single)
          continue;
        const Vector at = mesh_.points[c[k]] - center(cell[i]);
        p.sum += mesh_.areas[f] * at;
        p.weight += mesh_.areas[f];
        if ((k > 0 && result_.vertex[c[0]] == i) || (k > 1 && result_.vertex[c[1]] == i))
          continue; // the plane counts once
        p.planes.add(normal, at);
      }
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (mesh_.is_border(h))
          add_border(h, normal.stably_normalized(), around, cell);
    }
    for (Index i = 0; i < around.size(); ++i)
      result_.surface.points[i] = around[i].is_single || !(around[i].weight > 0)
        ? mesh_.points[around[i].vertex] : best_point(around[i], center(cell[i]));
  }

  // Returns the halfedge of a kept face across h, or h if there is none. A removed face between
  // them has two edges between different vertices of the result.
  Index opposite(Index h) const
  {
    Index g = h;
    while (!mesh_.is_border(g)) {
      g = mesh_.opposite[g];
      if (is_kept(g / 3))
        return g;
      const auto is_between = [&](Index e) {
        return result_.vertex[mesh_.source_vertex(e)] != result_.vertex[mesh_.target_vertex(e)];
      };
      g = is_between(Surface::next(g)) ? Surface::next(g) : Surface::previous(g);
    }
    return h;
  }

  void set_faces()
  {
    Surface& graph = result_.surface;
    std::vector<Index> number(mesh_.number_of_faces(), null_index);
    for (Index f = 0; f < number.size(); ++f)
      if (is_kept(f)) {
        number[f] = static_cast<Index>(result_.parent_face.size());
        result_.parent_face.push_back(f);
      }
    for (Index f : result_.parent_face) {
      const Corners& c = mesh_.corners[f];
      graph.corners.push_back({result_.vertex[c[0]], result_.vertex[c[1]],
                               result_.vertex[c[2]]});
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index o = opposite(h);
        graph.opposite.push_back(3 * number[o / 3] + o % 3);
      }
      if (mesh_.components.number > 1)
        graph.components.labels.push_back(mesh_.components[f]);
    }
    graph.components.number = mesh_.components.number;
  }

public:
  // Takes a surface with areas, and the width of the cells.
  Vertex_clustering(const Surface& mesh, double width) : mesh_(mesh), width_(width) {}

  // Returns the coarse surface, without areas.
  Level operator()()
  {
    set_clusters();
    check_topology();
    keep_components();
    number_vertices();
    set_points();
    set_faces();
    return std::move(result_);
  }
};

// Returns the width of the cells of clusters, about half the edge length of a uniform mesh with
// this number of faces. It has few digits, so that its multiples are exact. Wider cells make the
// surface more robust to noise, but the parts worse.
inline double width_of_cells(double area, std::size_t number_of_faces)
{ return 0.75 * std::exp2(std::floor(std::log2(area / static_cast<double>(number_of_faces)) / 2)); }

// Sorts the faces of a coarse surface into geometric order.
inline void order_by_points(Level& coarse)
{
  const std::vector<Index> order = geometric_order(coarse.surface);
  const std::vector<Index> number = reorder_faces(coarse.surface, order);
  coarse.parent_face = composed(order, coarse.parent_face);
  for (Index& v : coarse.vertex)
    if (v != null_index)
      v = number[v];
}

// Returns the successive surfaces down to at most `number_of_faces` faces: vertex clustering makes
// the first, edge collapses the second. If the mesh has no more faces, the only surface has all.
// Cuts are projected through both, so that the bands around cuts in the given surface are narrow.
// The points of the last surface are rounded to a twelfth of a cell, so that noise in the given
// points rarely gets through.
inline std::vector<Level> coarsened(Execution execution, const Surface& mesh,
                                    std::size_t number_of_faces, Run_monitor& monitor)
{
  const double area = total_area(mesh);
  const double width = width_of_cells(area > 0 ? area : 1, number_of_faces);
  std::vector<Level> result;
  if (mesh.number_of_faces() > number_of_faces) {
    result.push_back(Vertex_clustering(mesh, width)());
    set_areas(execution, result.back().surface);
    monitor.advance(0.5);
    monitor.check();
    Edge_collapse collapse(result.back().surface, width / 3, monitor);
    collapse.collapse_edges(number_of_faces);
    result.push_back(collapse.result());
  }
  else
    result.push_back({mesh, first_indices(mesh.number_of_faces()),
                      first_indices(mesh.points.size()), true});
  order_by_points(result.back()); // before points become equal
  for (Vector& p : result.back().surface.points)
    p = rounded(p, width / 12);
  set_areas(execution, result.back().surface);
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_COARSENING_H
