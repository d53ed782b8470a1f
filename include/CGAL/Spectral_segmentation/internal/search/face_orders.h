// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_FACE_ORDERS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_FACE_ORDERS_H

#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <boost/graph/visitors.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
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

// The Nystrom approximation of the eigenvectors of a symmetric n x n matrix of affinities, of which
// only the m rows of some samples are known (Section 5.2; Fowlkes et al., PAMI 26(2), 2004).
//
// `rows` is the m x n block of these rows; row i belongs to element `samples[i]`.

struct Eigenpairs
{
  Eigen::VectorXd values;  // descending
  Eigen::MatrixXd vectors; // n x m, one a column
};

inline Eigen::MatrixXd sampled_block(const Eigen::MatrixXd& rows, const std::vector<Index>& samples)
{
  Eigen::MatrixXd block(rows.rows(), rows.rows());
  for (std::size_t j = 0; j < samples.size(); ++j)
    block.col(static_cast<Eigen::Index>(j)) = rows.col(samples[j]);
  return block;
}

inline Eigenpairs descending_eigenpairs(const Eigen::MatrixXd& symmetric)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  return {solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse()};
}

// Returns f(eigenvalue), or 0 if the eigenvalue is 0 up to rounding, like a pseudo-inverse.
template <class Function>
Eigen::VectorXd on_nonzero(const Eigen::VectorXd& values, Function f)
{
  const double smallest = 1e-12 * values.cwiseAbs().maxCoeff();
  return values.unaryExpr([&](double v) { return std::abs(v) > smallest ? f(v) : 0.; });
}

// Returns the normalized rows D^-1/2 A D^-1/2. The row sums D of elements that are not samples come
// from the approximation of A.
inline Eigen::MatrixXd normalized_rows(const Eigen::MatrixXd& rows,
                                       const std::vector<Index>& samples)
{
  const Eigenpairs block = descending_eigenpairs(sampled_block(rows, samples));
  const Eigen::MatrixXd inverse = block.vectors *
    on_nonzero(block.values, [](double v) { return 1 / v; }).asDiagonal() *
    block.vectors.transpose();
  const Eigen::VectorXd row_sums = rows.transpose() * (inverse * rows.rowwise().sum());
  // An approximated sum may be negative. Any positive value serves, because it cancels out in the
  // ratio of two eigenvectors.
  const Eigen::VectorXd scale = row_sums.unaryExpr(
    [](double sum) { return 1 / std::sqrt((std::max)(std::abs(sum), 1e-300)); });
  Eigen::VectorXd scale_of_samples(rows.rows());
  for (std::size_t i = 0; i < samples.size(); ++i)
    scale_of_samples[static_cast<Eigen::Index>(i)] = scale[samples[i]];
  return scale_of_samples.asDiagonal() * rows * scale.asDiagonal();
}

// Returns the eigenvectors of the sampled block, extrapolated to all elements (Section 5.2):
// [U; Y^T U Lambda^-1]. They reproduce the sampled rows, but are not orthogonal.
inline Eigenpairs nystrom_extrapolation(const Eigen::MatrixXd& rows,
                                        const std::vector<Index>& samples)
{
  const Eigenpairs block = descending_eigenpairs(sampled_block(rows, samples));
  return {block.values, rows.transpose() * block.vectors *
    on_nonzero(block.values, [](double v) { return 1 / v; }).asDiagonal()};
}

// The spectral embedding of the faces of a part (Section 5). The search needs only the order of the
// embedding for two samples, which `spectral_order()` finds without it.

// Returns the combined distances of all faces from some samples, one row per sample.
inline Eigen::MatrixXd distances_from(const Surface& part, const std::vector<Index>& samples)
{
  Eigen::MatrixXd rows(samples.size(), part.number_of_faces());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::vector<double> distance =
      shortest_paths(part, &Edge_weights::combined, samples[i]);
    rows.row(static_cast<Eigen::Index>(i)) =
      Eigen::Map<const Eigen::VectorXd>(distance.data(), rows.cols());
  }
  return rows;
}

// Returns the affinities by the paper's kernel, whose width is the mean of all given distances.
// Faces of different components, at infinite distance, have the affinity 0.
inline Eigen::MatrixXd affinities(const Eigen::MatrixXd& distances)
{
  const auto is_finite = distances.array().isFinite();
  const double sum = is_finite.select(distances.array(), 0).sum();
  const double sigma = sum > 0 ? sum / static_cast<double>(is_finite.count()) : 1;
  return (-distances.array() / (sigma * sigma)).exp().matrix();
}

// Returns D^-1/2 A D^-1/2 for a complete matrix A of affinities.
inline Eigen::MatrixXd normalized(const Eigen::MatrixXd& affinities)
{
  const Eigen::VectorXd scale = affinities.rowwise().sum().cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * affinities * scale.asDiagonal();
}

// Returns the eigenvectors of the normalized affinities, approximated from the distances of some
// samples (Section 5.2), or exact if all faces are samples, in ascending order.
inline Eigenpairs affinity_eigenpairs(const Eigen::MatrixXd& distances,
                                      const std::vector<Index>& samples)
{
  const Eigen::MatrixXd rows = affinities(distances);
  return rows.rows() == rows.cols() && std::is_sorted(samples.begin(), samples.end())
    ? descending_eigenpairs(normalized(rows))
    : nystrom_extrapolation(normalized_rows(rows, samples), samples);
}

inline Eigenpairs face_eigenpairs(const Surface& part, const std::vector<Index>& samples)
{ return affinity_eigenpairs(distances_from(part, samples), samples); }

// Returns the coordinate of each face on the spectral line: the ratio of the second eigenvector to
// the first (Section 5.3). The first sample does not lie above the last one.
inline Eigen::VectorXd spectral_coordinates(const Eigenpairs& e, const std::vector<Index>& samples)
{
  const Eigen::VectorXd z = e.vectors.col(1).cwiseQuotient(e.vectors.col(0));
  return z[samples.front()] <= z[samples.back()] ? z : Eigen::VectorXd(-z);
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
inline Face_order spectral_order(Execution execution, const std::vector<double>& from_s,
                                 const std::vector<double>& from_t)
{
  std::vector<double> difference(from_s.size());
  for (std::size_t f = 0; f < difference.size(); ++f)
    difference[f] = from_s[f] - from_t[f];
  return sorted_indices(execution, difference, [&](Index f, Index g)
    { return from_s[f] < from_s[g] || (from_s[f] == from_s[g] && f < g); });
}

// Returns the distances of the faces of a connected part from a source. Sets their order by
// distance; ties go to the first.
inline std::vector<double> distances_and_order(const Surface& part, Index source, Face_order& order)
{
  order.reserve(part.number_of_faces());
  const std::vector<double> distance = shortest_paths(
    part, &Edge_weights::combined, source,
    boost::make_dijkstra_visitor(boost::write_property(
      boost::typed_identity_property_map<Index>(), std::back_inserter(order),
      boost::on_examine_vertex())));
  for (auto first = order.begin(), end = first; first != order.end(); first = end) {
    end = std::find_if(first, order.end(), [&](Index f) { return distance[f] > distance[*first]; });
    std::sort(first, end);
  }
  return distance;
}

// Returns the orders of the calibrated method: the spectral order from both ends, and if requested
// the orders by distance from each sample and each reference face. These grow a single limb where
// the pair of samples grows several at once.
inline std::vector<Face_order> face_orders(Execution execution, const Surface& part,
                                           const std::vector<Index>& references,
                                           const Sample_faces& samples, bool from_single_sources)
{
  std::vector<Index> sources = {samples.s, samples.t};
  if (from_single_sources)
    for (Index reference : references)
      if (reference != samples.s && reference != samples.t)
        sources.push_back(reference);
  std::vector<std::vector<double> > distances(sources.size());
  std::vector<Face_order> by_distance(sources.size());
  for_each_index(execution, sources.size(), [&](std::size_t i)
    { distances[i] = distances_and_order(part, sources[i], by_distance[i]); });

  std::vector<Face_order> orders = {spectral_order(execution, distances[0], distances[1]),
                                    spectral_order(execution, distances[1], distances[0])};
  if (from_single_sources)
    std::move(by_distance.begin(), by_distance.end(), std::back_inserter(orders));
  return orders;
}

// Returns the order of the paper.
inline Face_order face_order(Execution execution, const Surface& part,
                             const Sample_faces& samples)
{
  std::vector<double> from_s, from_t;
  call_all(execution,
    [&] { from_s = shortest_paths(part, &Edge_weights::combined, samples.s); },
    [&] { from_t = shortest_paths(part, &Edge_weights::combined, samples.t); });
  return spectral_order(execution, from_s, from_t);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_FACE_ORDERS_H
