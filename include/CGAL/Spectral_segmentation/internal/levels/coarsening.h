// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_COARSENING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_COARSENING_H

#include <CGAL/Spectral_segmentation/internal/levels/Edge_collapse.h>
#include <CGAL/Spectral_segmentation/internal/surface/reorder_faces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
  const Surface& mesh_;
  const double width_;                 // the edge length of a cell
  std::vector<Index> cluster_;         // one per vertex
  std::vector<char> is_contracted_;    // one per cluster
  Level result_;

  // Returns the nearest integer. The reversed number has the reversed integer, therefore mirroring
  // the surface mirrors the cells.
  static std::int64_t nearest_integer(double x)
  { return static_cast<std::int64_t>(x + std::copysign(0.5, x)); }

  // Returns the cell of a point: the last 21 bits of each coordinate, as edges are shorter than
  // 2^21 cells.
  std::uint64_t cell(const Vector& p) const
  {
    std::uint64_t result = 0;
    for (int i = 0; i < 3; ++i)
      result = result << 21 | (nearest_integer(p[i] / width_) & 0x1fffff);
    return result;
  }

  // Returns the center of the cell of a point.
  Vector center(const Vector& p) const
  {
    const auto coordinate = [this](double x)
    { return width_ * static_cast<double>(nearest_integer(x / width_)); };
    return {coordinate(p.x()), coordinate(p.y()), coordinate(p.z())};
  }

  // Returns the first edge of a face that is contracted, or 3. Clusters that are not contracted
  // keep their vertices.
  Index contracted_edge(Index f) const
  {
    const Corners& c = mesh_.corners[f];
    Index i = 0;
    while (i < 3 && !(cluster_[c[i]] == cluster_[c[(i + 1) % 3]] && is_contracted_[cluster_[c[i]]]))
      ++i;
    return i;
  }

  bool is_kept(Index f) const { return contracted_edge(f) == 3; }

  // Sets the clusters, and finds those that can be contracted: the vertices, edges and faces inside
  // are connected and have no hole, and at most one arc of the border runs through.
  void set_clusters(Execution execution)
  {
    const Index n = static_cast<Index>(mesh_.points.size());
    std::vector<std::uint64_t> cells(n); // one per vertex
    for_each_index(execution, n, [&](std::size_t v) { cells[v] = cell(mesh_.points[v]); });
    Disjoint_sets sets(n); // sets of vertices
    // These are summed for each vertex, then for its cluster. The ends of an edge are in one
    // cluster if they are in one cell.
    std::vector<int> euler(n, 1), number_of_arcs(n, 0);
    std::vector<char> is_on_border(n, 0);
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      const Corners& c = mesh_.corners[f];
      const std::uint64_t cell[3] = {cells[c[0]], cells[c[1]], cells[c[2]]};
      for (Index i = 0; i < 3; ++i) {
        const Index h = 3 * f + i, v = c[i], w = c[(i + 1) % 3];
        const bool is_inside = cell[i] == cell[(i + 1) % 3] && h <= mesh_.opposite[h];
        if (is_inside) {
          sets.join(v, w);
          --euler[v];
        }
        if (mesh_.is_border(h)) {
          is_on_border[v] = is_on_border[w] = 1;
          number_of_arcs[v] -= is_inside;
        }
      }
      if (cell[0] == cell[1] && cell[1] == cell[2])
        ++euler[c[0]];
    }
    cluster_.reserve(n);
    for (Index v = 0; v < n; ++v) {
      const Index first = sets.representative(v);
      cluster_.push_back(first);
      number_of_arcs[v] += is_on_border[v];
      if (first != v) {
        euler[first] += euler[v];
        number_of_arcs[first] += number_of_arcs[v];
      }
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
        for (Index v : mesh_.corners[f])
          is_contracted_[cluster_[v]] = 0;
  }

  void number_vertices()
  {
    std::vector<Index> number(mesh_.points.size(), null_index); // one per contracted cluster
    Index next = 0;
    for (Index v = 0; v < mesh_.points.size(); ++v) {
      const bool is_contracted = is_contracted_[cluster_[v]];
      if (!is_contracted || number[cluster_[v]] == null_index)
        number[cluster_[v]] = next++;
      result_.coarse_vertex.push_back(number[cluster_[v]]);
    }
    result_.surface.points.resize(next);
  }

  // The surroundings of a vertex of the result. Lengths are measured from the center of the cell.
  struct Surroundings
  {
    Vector center;
    Planes planes; // the planes of the faces
    Vector sum;    // the points, weighted by the areas of the faces around them
    double weight = 0;
    Index vertex = null_index; // the last vertex
    bool is_single = true;
  };

  // Adds the plane through a border edge, orthogonal to its face, which keeps the border in place.
  void add_border(Index h, const Vector& unit_normal, std::vector<Surroundings>& around) const
  {
    const Vector &p = mesh_.points[mesh_.source_vertex(h)],
                 &q = mesh_.points[mesh_.target_vertex(h)];
    const Index first = result_.coarse_vertex[mesh_.source_vertex(h)],
                second = result_.coarse_vertex[mesh_.target_vertex(h)];
    const Vector normal = (q - p).norm() * (q - p).cross(unit_normal);
    around[first].planes.add(normal, p - around[first].center);
    if (second != first)
      around[second].planes.add(normal, p - around[second].center);
  }

  Vector best_point(const Surroundings& around) const
  {
    const Vector mean = around.sum / around.weight;
    const Vector step = around.planes.step_from(mean, 0.01);
    const bool is_near = step.squared_norm() <= width_ * width_; // false for NaN
    return quantized(around.center + (is_near ? mean + step : mean));
  }

  void set_points()
  {
    std::vector<Surroundings> around(result_.surface.points.size());
    for (Index v = 0; v < mesh_.points.size(); ++v) {
      Surroundings& a = around[result_.coarse_vertex[v]];
      a.is_single = a.vertex == null_index;
      a.vertex = v;
    }
    for (Surroundings& a : around)
      a.center = center(mesh_.points[a.vertex]);
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      const Corners& c = mesh_.corners[f];
      const Corners vertex = {result_.coarse_vertex[c[0]], result_.coarse_vertex[c[1]],
                              result_.coarse_vertex[c[2]]};
      const Vector &p = mesh_.points[c[0]], &q = mesh_.points[c[1]], &r = mesh_.points[c[2]];
      const Vector normal = (q - p).cross(r - p);
      const auto add_corner = [&](const Vector& point, Index i, bool is_new) {
        Surroundings& a = around[i];
        if (a.is_single)
          return;
        const Vector at = point - a.center;
        a.sum += mesh_.areas[f] * at;
        a.weight += mesh_.areas[f];
        if (is_new) // the plane counts once
          a.planes.add(normal, at);
      };
      add_corner(p, vertex[0], true);
      add_corner(q, vertex[1], vertex[1] != vertex[0]);
      add_corner(r, vertex[2], vertex[2] != vertex[0] && vertex[2] != vertex[1]);
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (mesh_.is_border(h))
          add_border(h, normal.stably_normalized(), around);
    }
    for (Index i = 0; i < around.size(); ++i)
      result_.surface.points[i] = around[i].is_single || !(around[i].weight > 0)
        ? mesh_.points[around[i].vertex] : best_point(around[i]);
  }

  // Returns the opposite halfedges of the kept faces. A path leads from each of their edges over
  // removed faces, which have one contracted edge each, to another kept face or to the border. All
  // paths advance by one face at a time: one after the other would wait for memory at each face.
  std::vector<Index> opposite_halfedges(const std::vector<unsigned char>& contracted) const
  {
    std::vector<Index> ends; // a halfedge per path
    for (Index f : result_.parent_face)
      ends.insert(ends.end(), {3 * f, 3 * f + 1, 3 * f + 2});
    const std::vector<Index> starts = ends;
    for (std::vector<Index> paths = first_indices(ends.size()); !paths.empty();) {
      std::size_t number_of_paths = 0;
      for (Index h : paths) {
        Index& g = ends[h];
        if (mesh_.is_border(g)) {
          g = starts[h];
          continue;
        }
        g = mesh_.opposite[g];
        if (const Index edge = contracted[g / 3]; edge != 3) {
          g = g - g % 3 + (3 - g % 3 - edge);
          paths[number_of_paths++] = h;
        }
      }
      paths.resize(number_of_paths);
    }
    return ends;
  }

  void set_faces()
  {
    Surface& graph = result_.surface;
    std::vector<unsigned char> contracted(mesh_.number_of_faces()); // one edge per face
    std::vector<Index> number(mesh_.number_of_faces()); // of the kept faces
    for (Index f = 0; f < number.size(); ++f) {
      contracted[f] = static_cast<unsigned char>(contracted_edge(f));
      if (contracted[f] == 3) {
        number[f] = static_cast<Index>(result_.parent_face.size());
        result_.parent_face.push_back(f);
      }
    }
    for (Index h : opposite_halfedges(contracted))
      graph.opposite.push_back(3 * number[h / 3] + h % 3);
    for (Index f : result_.parent_face) {
      const Corners& c = mesh_.corners[f];
      graph.corners.push_back({result_.coarse_vertex[c[0]], result_.coarse_vertex[c[1]],
                               result_.coarse_vertex[c[2]]});
      if (mesh_.components.number > 1)
        graph.components.labels.push_back(mesh_.components[f]);
    }
    graph.components.number = mesh_.components.number;
  }

public:
  // Takes a surface with areas, and the width of the cells.
  Vertex_clustering(const Surface& mesh, double width) : mesh_(mesh), width_(width) {}

  // Returns the coarse surface, without areas.
  Level operator()(Execution execution)
  {
    set_clusters(execution);
    keep_components();
    number_vertices();
    call_all(execution, [&] { set_points(); }, [&] { set_faces(); });
    return std::move(result_);
  }
};

// Returns the width of the cells of clusters, about 0.4 of the edge length of an even mesh with
// this number of faces. It has few digits, so that its multiples are exact.
inline double width_of_cells(double area, double number_of_faces)
{
  int exponent;
  const double fraction = std::frexp(0.6 * std::sqrt(area / number_of_faces), &exponent);
  return std::ldexp(std::round(32 * fraction), exponent - 5);
}

// Returns a surface after vertex clustering, with areas.
inline Level clustered(Execution execution, const Surface& mesh, double width)
{
  Level result = Vertex_clustering(mesh, width)(execution);
  set_areas(execution, result.surface);
  return result;
}

// Sorts the faces of a coarse surface into geometric order.
inline void order_by_points(Level& coarse)
{
  const std::vector<Index> order = geometric_order(coarse.surface);
  const std::vector<Index> number = reorder_faces(coarse.surface, order);
  coarse.parent_face = composed(order, coarse.parent_face);
  for (Index& v : coarse.coarse_vertex)
    if (v != null_index)
      v = number[v];
}

// Returns the successive surfaces down to at most `number_of_faces` faces: vertex clustering makes
// the first, edge collapses the second. If the mesh has no more faces, the only surface has all.
// The points of the last surface are rounded to a twelfth of a cell, so that noise in the given
// points rarely gets through.
inline std::vector<Level> coarsened(Execution execution, const Surface& mesh,
                                    std::size_t number_of_faces, Run_monitor& monitor)
{
  const double area = total_area(mesh);
  const double width = width_of_cells(area > 0 ? area : 1, static_cast<double>(number_of_faces));
  std::vector<Level> result;
  if (mesh.number_of_faces() > number_of_faces) {
    result.push_back(clustered(execution, mesh, width));
    monitor.check();
    Edge_collapse collapse(result.back().surface, width / 4, monitor);
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
