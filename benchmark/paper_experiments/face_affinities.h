// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_FACE_AFFINITIES_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_FACE_AFFINITIES_H

#include "experiment.h"

#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

// Affinities of faces and the eigenvectors of their matrix, whole or approximated (Section 5).
namespace segmentation_benchmark {

using CGAL::Spectral_segmentation::internal::Eigenpairs;
using CGAL::Spectral_segmentation::internal::affinities;
using CGAL::Spectral_segmentation::internal::distances_from;
using CGAL::Spectral_segmentation::internal::face_eigenpairs;

inline std::vector<Index> all_faces(const Surface& part)
{
  std::vector<Index> faces(part.number_of_faces());
  std::iota(faces.begin(), faces.end(), Index(0));
  return faces;
}

// The distance between two vectors after scaling to unit length and choice of the sign: from 0, for
// the same direction, to the square root of 2.
inline double direction_error(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
  const Eigen::VectorXd u = a.normalized(), v = b.normalized();
  return (std::min)((u - v).norm(), (u + v).norm());
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_FACE_AFFINITIES_H
