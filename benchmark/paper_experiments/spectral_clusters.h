// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_SPECTRAL_CLUSTERS_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_SPECTRAL_CLUSTERS_H

#include "../k_means.h"
#include "face_samples.h"
#include "parts.h"

#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/nystrom_embedding.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

// Spectral clustering by k-means (Liu and Zhang, Pacific Graphics 2004).
namespace segmentation_benchmark {

// Returns the rows of the k leading eigenvectors, scaled to unit length. The matrix is whole in a
// part with at most m faces, else approximated from the rows of m faces that are far apart. Scaling
// cancels the row sums of the other faces. Extrapolation needs the leading eigenvalues only: the
// affinities are not positive definite, so that the one-shot method would divide by eigenvalues
// near 0.
inline Eigen::MatrixXd spectral_coordinates(const Surface& part, std::size_t k,
                                            std::size_t m, Random_engine& random)
{
  const std::vector<Index> samples = m >= part.number_of_faces()
    ? all_faces(part)
    : samples_by_paths<&Edge_weights::combined>(part, m, random);
  const CGAL::Spectral_segmentation::internal::Eigenpairs e = face_eigenpairs(part, samples);
  const Eigen::Index dimensions =
    (std::min)(static_cast<Eigen::Index>(k), e.vectors.cols());
  return e.vectors.leftCols(dimensions).rowwise().normalized();
}

// Divides the faces into k clusters at once.
inline Labels k_way_clusters(const Surface& mesh, std::size_t k, std::size_t m,
                             Random_engine& random)
{ return k_means(spectral_coordinates(mesh, k, m, random), k, random); }

// Divides the part of the largest area into two clusters until there are k parts.
inline Labels recursive_two_means(const Surface& mesh, std::size_t k, std::size_t m,
                                  Random_engine& random)
{
  return recursive_cuts(mesh, k, [&](const Part& part) -> std::optional<Sides> {
    if (part.graph.number_of_faces() < 2)
      return std::nullopt;
    const Labels cluster = k_means(spectral_coordinates(part.graph, 2, m, random), 2, random);
    if (number_of_segments(cluster) < 2)
      return std::nullopt;
    return Sides(cluster.begin(), cluster.end());
  });
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_SPECTRAL_CLUSTERS_H
