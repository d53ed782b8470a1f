// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_FACE_ORDERS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_FACE_ORDERS_H

#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/weights/searched_features.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Sampling based on shape context (Section 4).

// Returns the first reference face. The paper takes a random face. The face farthest from the
// center of the part is as good, is at the end of a limb, and does not depend on face indices.
inline Index farthest_face_from_center(Execution execution, const Surface& graph)
{
  const double area = total_area(graph);
  const Vector center = area > 0 ? center_of(execution, graph, area) : Vector();
  std::vector<double> distance(graph.number_of_faces());
  for_each_index(execution, distance.size(), [&](std::size_t f)
    { distance[f] = (graph.centroid(static_cast<Index>(f)) - center).squared_norm(); });
  const double largest = *std::max_element(distance.begin(), distance.end());
  // This is the first of the farthest faces, up to rounding.
  return static_cast<Index>(
    std::find_if(distance.begin(), distance.end(),
                 [&](double d) { return d >= (1 - 1e-9) * largest; }) - distance.begin());
}

// Returns a random face. The smallest face identifies the part, so that the choice depends neither
// on the order in which parts are searched nor on the thread. The engine is the same on every
// platform.
inline Index random_face(const Surface& graph, std::uint64_t seed, Index smallest_face)
{
  std::seed_seq seeds{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                      smallest_face, static_cast<Index>(graph.number_of_faces())};
  std::mt19937_64 engine(seeds);
  return static_cast<Index>(engine() % graph.number_of_faces());
}

struct Shape_contexts
{
  std::vector<Index> references;
  Eigen::MatrixXf values; // a row for each face, a column for each reference
};

// Chooses k reference faces, or all if there are fewer, by farthest-point sampling in geodesic
// distance, and sums the angle distances along the shortest geodesic paths to each. Calls
// `before_search()` before each search for paths.
template <class BeforeSearch>
Shape_contexts shape_contexts(const Surface& graph, Index first_reference, std::size_t k,
                              const BeforeSearch& before_search)
{
  const std::size_t n = graph.number_of_faces();
  k = (std::min)(k, n);
  Shape_contexts contexts;
  contexts.values.resize(n, k);
  std::vector<double> to_nearest(n, infinite_distance);
  Index reference = first_reference;
  for (std::size_t j = 0; j < k; ++j) {
    before_search();
    contexts.references.push_back(reference);
    const Geodesic_paths paths = geodesic_paths(graph, reference);
    for (Index f = 0; f < n; ++f) {
      contexts.values(f, j) = paths.angles[f];
      to_nearest[f] = (std::min)(to_nearest[f], paths.lengths[f]);
    }
    const auto farthest = std::max_element(to_nearest.begin(), to_nearest.end());
    reference = static_cast<Index>(farthest - to_nearest.begin());
  }
  return contexts;
}

struct Sample_faces
{
  Index s; // the face whose context has the largest norm
  Index t; // the face whose context differs most from the context of s
};

// Returns the two samples (Section 4.2) of a part with two or more faces. Ties go to the first.
inline Sample_faces sample_faces(Execution execution, const Shape_contexts& contexts)
{
  const auto farthest = [&](Index from) { // null_index: from 0
    std::vector<double> squared(contexts.values.rows(), 0);
    for_each_index(execution, squared.size(), [&](std::size_t f) {
      for (Eigen::Index j = 0; j < contexts.values.cols(); ++j) {
        const double difference = double(contexts.values(static_cast<Eigen::Index>(f), j)) -
                                  (from == null_index ? 0 : contexts.values(from, j));
        squared[f] += difference * difference;
      }
    });
    if (from != null_index)
      squared[from] = -1;
    return static_cast<Index>(std::max_element(squared.begin(), squared.end()) - squared.begin());
  };
  Sample_faces samples;
  samples.s = farthest(null_index);
  samples.t = farthest(samples.s);
  return samples;
}

// The faces of a part in an order along which cuts are searched: a cut is between the faces up to
// one of them and the rest.
typedef std::vector<Index> Face_order;

// Returns the order of the 1-D spectral embedding, from s to t, by the distances from both
// (Section 5.3).
//
// The embedding of a face is the ratio e2 / e1 of the eigenvectors that Nystrom's method gives for
// two samples. Both are linear in the affinities x and y of a face to s and t, so the ratio is a
// monotone function of x / y, that is, of the distance from s minus the distance from t. Sorting by
// this difference needs no kernel and does not underflow. Ties, for example along a limb off the
// path from s to t, go to the face nearer to s.
inline Face_order spectral_order(const std::vector<double>& from_s,
                                 const std::vector<double>& from_t)
{
  std::vector<double> difference(from_s.size());
  for (std::size_t f = 0; f < difference.size(); ++f)
    difference[f] = from_s[f] - from_t[f];
  return sorted_indices(difference, [&](Index f, Index g)
    { return from_s[f] < from_s[g] || (from_s[f] == from_s[g] && f < g); });
}

// Returns the distances of the faces of a part from both samples.
inline std::array<std::vector<double>, 2>
distances_from_samples(Execution execution, const Surface& part, const Sample_faces& samples)
{
  std::array<std::vector<double>, 2> result;
  call_all(execution,
    [&] { result[0] = shortest_paths(part, &Edge_weights::combined, samples.s); },
    [&] { result[1] = shortest_paths(part, &Edge_weights::combined, samples.t); });
  return result;
}

// Returns the order of the paper.
inline Face_order face_order(Execution execution, const Surface& part, const Sample_faces& samples)
{
  const auto [from_s, from_t] = distances_from_samples(execution, part, samples);
  return spectral_order(from_s, from_t);
}

// Returns the faces of a part ordered along the direction of largest variance of their features.
// `faces` are their indices in the mesh.
inline std::vector<Index> feature_order(const Face_features& features,
                                        const std::vector<double>& areas,
                                        const std::vector<Index>& faces)
{
  const std::size_t d = features.dimension;
  std::vector<double> mean(d, 0);
  double area = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    area += areas[f];
    for (std::size_t i = 0; i < d; ++i)
      mean[i] += areas[f] * features[faces[f]][i];
  }
  Row_matrix rows(faces.size(), d);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < d; ++i)
      rows[f][i] = features[faces[f]][i] - (area > 0 ? mean[i] / area : 0);
  Row_matrix covariance = weighted_transposed_product(rows, areas, rows);
  std::size_t longest = 0;
  for (std::size_t i = 1; i < d; ++i)
    if (covariance[i][i] > covariance[longest][longest])
      longest = i;
  Row_matrix direction(d, 1);
  for (std::size_t i = 0; i < d; ++i)
    direction[i][0] = covariance[i][longest];
  for (int i = 0; i < 20; ++i) {
    orthonormalize(direction);
    direction = product(covariance, direction);
  }
  orthonormalize(direction);
  return sorted_indices(product(rows, direction).values);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_FACE_ORDERS_H
