// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_FACE_DISTANCES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_FACE_DISTANCES_H

#include <CGAL/Spectral_segmentation/internal/base/Run_data.h>
#include <CGAL/Spectral_segmentation/internal/weights/curvature_angles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Distances between adjacent faces (Section 3).

// Returns the length of the shortest path from the centroid `f` over the edge `ab` to the centroid
// `g`, when the two faces are unfolded into one plane. The path stays inside the edge.
inline double geodesic_distance(const Vector& a, const Vector& b, const Vector& f, const Vector& g)
{
  const double length = (b - a).norm();
  if (length == 0)
    return (f - a).norm() + (g - a).norm();
  const Vector edge = (b - a) / length;
  const double x_f = (f - a).dot(edge), x_g = (g - a).dot(edge);
  const double y_f = (f - a - x_f * edge).norm(), y_g = (g - a - x_g * edge).norm();
  double x = y_f + y_g > 0 ? x_f + (x_g - x_f) * (y_f / (y_f + y_g)) : x_f;
  x = (std::min)((std::max)(x, 0.), length);
  return std::hypot(x - x_f, y_f) + std::hypot(x - x_g, y_g);
}

struct Dihedral
{
  double one_minus_cosine; // 1 - cos of the angle between the normals
  bool is_concave;
};

// Returns a dihedral; `edge` runs in the direction of the face of normal `f`.
inline Dihedral dihedral(const Vector& f, const Vector& g, const Vector& edge)
{
  // Half the squared chord keeps its digits where the cosine is near 1.
  const double one_minus_cosine = (f - g).squared_norm() / 2;
  // An edge below 1e-6 rad, which is rounding, is flat.
  if (one_minus_cosine < 5e-13)
    return {0, false};
  return {one_minus_cosine, f.cross(g).dot(edge) < 0};
}

// Returns unit normals. A face without area takes the normal of the neighbor across its longest
// edge, so that it does not hide the angle between the faces on its two sides. Its normal is (0, 0,
// 0) if that fails.
inline std::vector<Vector> face_normals(Execution execution, const Surface& graph,
                                        const std::vector<Vector>& points)
{
  std::vector<Vector> normals(graph.number_of_faces());
  const auto edge_vector = [&](Index h) -> Vector
  { return points[graph.target_vertex(h)] - points[graph.source_vertex(h)]; };
  const auto longest_edge = [&](Index f) {
    Index longest = 3 * f;
    for (Index h = 3 * f + 1; h < 3 * f + 3; ++h)
      if (edge_vector(h).squared_norm() > edge_vector(longest).squared_norm())
        longest = h;
    return longest;
  };
  for_each_index(execution, normals.size(), [&](Index f) {
    const Vector cross = edge_vector(3 * f).cross(edge_vector(3 * f + 1));
    if (cross.norm() > 1e-12 * edge_vector(longest_edge(f)).squared_norm())
      normals[f] = cross.normalized();
  });
  // A neighbor may have no area either: follow the longest edges to the first face with a normal.
  std::vector<char> is_visited(normals.size(), 0);
  std::vector<Index> path;
  for (Index first = 0; first < normals.size(); ++first) {
    Index f = first;
    path.clear();
    for (; normals[f].is_zero() && !is_visited[f]; f = graph.neighbor(longest_edge(f))) {
      is_visited[f] = 1;
      path.push_back(f);
    }
    for (Index g : path)
      normals[g] = normals[f];
  }
  return normals;
}

// Equalizes the histogram: maps values to equally spaced values in [0, 1] by their rank. Equal
// values get the mean of their ranks.
inline std::vector<double> equalize(const std::vector<float>& values)
{
  const std::vector<Index> order = sorted_indices(values);
  std::vector<double> result(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last + 1 < order.size() && values[order[last + 1]] == values[order[first]])
      ++last;
    const double rank =
      order.size() > 1 ? (first + last) / 2. / static_cast<double>(order.size() - 1) : 0.5;
    for (; first <= last; ++first)
      result[order[first]] = rank;
  }
  return result;
}

// Equalizes the histogram by weighted ranks. An edge then counts by its length and not by the
// number of edges into which the triangulation cuts it.
inline std::vector<double> equalize(const std::vector<float>& values,
                                    const std::vector<double>& weights)
{
  const std::vector<Index> order = sorted_indices(values);
  const double total = std::accumulate(weights.begin(), weights.end(), 0.);
  std::vector<double> result(values.size(), 0.5);
  double below = 0;
  for (std::size_t first = 0; total > 0 && first < order.size();) {
    std::size_t end = first;
    double equal = 0;
    for (; end < order.size() && values[order[end]] == values[order[first]]; ++end)
      equal += weights[order[end]];
    for (; first < end; ++first)
      result[order[first]] = (below + equal / 2) / total;
    below += equal;
  }
  return result;
}

// Divides by the mean.
inline void normalize_by_mean(std::vector<double>& values)
{
  const double sum = std::accumulate(values.begin(), values.end(), 0.);
  if (sum > 0)
    for (double& value : values)
      value *= static_cast<double>(values.size()) / sum;
}

struct Distance_weights
{
  double geodesic; // delta
  double concave;  // eta at concave edges
  double convex;   // eta at convex edges
  double concavity_radius = 0; // if > 0, averaged curvature replaces the dihedral angle
};

inline Distance_weights distance_weights(const Options& o, const Method_constants& method)
{
  return {o.geodesic_weight, o.concave_angle_weight, o.convex_angle_weight,
          method.concavity_radius};
}

// Divides both angle weights by the larger one, because only their ratio matters and sums must not
// overflow.
inline Distance_weights with_relative_angle_weights(Distance_weights weights)
{
  const double largest = (std::max)(weights.concave, weights.convex);
  if (largest > 0) {
    weights.concave /= largest;
    weights.convex /= largest;
  }
  return weights;
}

// The angles after equalization, one per edge.
struct Equalized_angles
{
  std::vector<double> total;   // H
  std::vector<double> concave; // the part of H that is due to concave edges
};

// Equalizes dihedral angles; `edges` has one halfedge per edge. Faces without a normal have flat
// edges.
inline Equalized_angles equalized_dihedrals(Execution execution, const Surface& graph,
                                            const std::vector<Vector>& points,
                                            const std::vector<Vector>& normals,
                                            const Distance_weights& weights,
                                            const std::vector<Index>& edges)
{
  std::vector<double> angles(edges.size(), 0);
  std::vector<char> is_concave(edges.size(), 0);
  for_each_index(execution, edges.size(), [&](std::size_t e) {
    const Index h = edges[e], f = h / 3, g = graph.neighbor(h);
    if (normals[f].is_zero() || normals[g].is_zero())
      return;
    const Dihedral d = dihedral(normals[f], normals[g],
                                points[graph.target_vertex(h)] - points[graph.source_vertex(h)]);
    is_concave[e] = d.is_concave;
    angles[e] = (d.is_concave ? weights.concave : weights.convex) * d.one_minus_cosine;
  });
  normalize_by_mean(angles);
  // In single precision, angles that differ only by rounding tie.
  const std::vector<float> rounded(angles.begin(), angles.end());
  Equalized_angles result{equalize(rounded), std::vector<double>(edges.size(), 0)};
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (is_concave[e])
      result.concave[e] = result.total[e];
  return result;
}

// Equalizes the curvature at the scale of the shape, which does not depend on the triangulation.
inline Equalized_angles equalized_bending(Execution execution, const Surface& graph,
                                          const std::vector<Vector>& points,
                                          const std::vector<Vector>& normals,
                                          const Distance_weights& weights,
                                          const std::vector<Index>& edges)
{
  const std::vector<double> bending =
    curvature_angles(execution, graph, points, normals, weights.concavity_radius);
  std::vector<double> lengths(edges.size());
  std::vector<float> distances(edges.size());
  for_each_index(execution, edges.size(), [&](std::size_t e) {
    const Index h = edges[e];
    lengths[e] = (points[graph.target_vertex(h)] - points[graph.source_vertex(h)]).norm();
    // This form of 1 - cos of the angle keeps its digits if it is small.
    const double sine = std::sin(bending[h] / 2);
    distances[e] = static_cast<float>((bending[h] < 0 ? weights.concave : weights.convex) *
                                      (2 * sine * sine));
  });
  Equalized_angles result{equalize(distances, lengths),
                          std::vector<double>(edges.size(), 0)};
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (bending[edges[e]] < 0)
      result.concave[e] = result.total[e];
  return result;
}

inline std::vector<double> normalized_geodesic_distances(Execution execution,
                                                         const Surface& graph,
                                                         const std::vector<Vector>& points,
                                                         const std::vector<Index>& edges)
{
  std::vector<double> result(edges.size());
  for_each_index(execution, edges.size(), [&](std::size_t e) {
    const Index h = edges[e];
    result[e] = geodesic_distance(
      points[graph.source_vertex(h)], points[graph.target_vertex(h)], graph.centroid(h / 3, points),
      graph.centroid(graph.neighbor(h), points));
  });
  normalize_by_mean(result);
  return result;
}

// Fills in the distances of adjacent faces, computed from `points` instead of the graph's own
// points, and from the normals of the faces at them.
inline void set_face_distances(Execution execution, Surface& graph,
                               const std::vector<Vector>& points,
                               const std::vector<Vector>& normals,
                               const Distance_weights& given_weights)
{
  const Distance_weights weights = with_relative_angle_weights(given_weights);
  std::vector<Index> edges; // one halfedge each
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (h < graph.opposite[h])
      edges.push_back(h);

  std::vector<double> geodesic;
  Equalized_angles equalized;
  call_all(execution,
    [&] { geodesic = normalized_geodesic_distances(execution, graph, points, edges); },
    [&] {
      equalized = weights.concavity_radius > 0
        ? equalized_bending(execution, graph, points, normals, weights, edges)
        : equalized_dihedrals(execution, graph, points, normals, weights, edges);
    });

  graph.weights.assign(graph.number_of_halfedges(), Edge_weights());
  for_each_index(execution, edges.size(), [&](std::size_t e) {
    const Index h = edges[e];
    Edge_weights& w = graph.weights[h];
    w.geodesic = static_cast<float>(quantized(geodesic[e]));
    w.angle = static_cast<float>(quantized(equalized.total[e]));
    w.concavity = static_cast<float>(quantized(equalized.concave[e]));
    w.combined = static_cast<float>(
      quantized((1 - weights.geodesic) * equalized.total[e] + weights.geodesic * geodesic[e]));
    w.centroids = static_cast<float>(
      (graph.centroid(graph.neighbor(h)) - graph.centroid(h / 3)).norm());
    graph.weights[graph.opposite[h]] = w;
  });
}

// Returns the points after some steps of uniform Laplacian smoothing (Section 2). Each step moves a
// point halfway to the mean of its neighbors; vertices on the border of the mesh stay. Ends early
// if `go_further()`, asked before each step, is false.
template <class GoFurther>
std::vector<Vector> smoothed_points(const Surface& graph, std::size_t iterations,
                                    const GoFurther& go_further)
{
  std::vector<Vector> points = graph.points;
  if (iterations == 0)
    return points;
  std::vector<char> is_fixed(points.size(), 0);
  for (Index h = 0; h < graph.opposite.size(); ++h)
    if (graph.is_border(h))
      is_fixed[graph.source_vertex(h)] = is_fixed[graph.target_vertex(h)] = 1;

  std::vector<Vector> sum(points.size());
  std::vector<unsigned> degree(points.size());
  for (; iterations > 0 && go_further(); --iterations) {
    std::fill(sum.begin(), sum.end(), Vector());
    std::fill(degree.begin(), degree.end(), 0u);
    // One halfedge of each edge starts at an inner vertex. Therefore the mean is unweighted.
    for (Index h = 0; h < graph.opposite.size(); ++h) {
      sum[graph.source_vertex(h)] += points[graph.target_vertex(h)];
      ++degree[graph.source_vertex(h)];
    }
    for (std::size_t v = 0; v < points.size(); ++v)
      if (!is_fixed[v] && degree[v] > 0)
        points[v] = (points[v] + sum[v] / degree[v]) / 2;
  }
  return points;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_FACE_DISTANCES_H
