// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_K_MEANS_H
#define SEGMENTATION_BENCHMARK_K_MEANS_H

#include "random_numbers.h"
#include "segmentation_metrics.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace segmentation_benchmark {

// Clusters of points by k-means: Lloyd's iterations from centers by k-means++ (Arthur and
// Vassilvitskii, SODA 2007). Points are the rows of a matrix.
class K_means
{
  static constexpr int most_iterations = 100;

  const Eigen::MatrixXd& points_;
  Eigen::Index k_;
  Random_engine& random_;

  // Returns a row, with a probability in proportion to its weight.
  Eigen::Index random_row(const Eigen::VectorXd& weights)
  {
    double rest = uniform_random(random_) * weights.sum();
    Eigen::Index row = 0;
    while (row + 1 < weights.size() && rest >= weights[row])
      rest -= weights[row++];
    return row;
  }

  Eigen::VectorXd squared_distances(const Eigen::MatrixXd& centers, Eigen::Index center) const
  { return (points_.rowwise() - centers.row(center)).rowwise().squaredNorm(); }

  Eigen::MatrixXd first_centers()
  {
    Eigen::MatrixXd centers(k_, points_.cols());
    Eigen::VectorXd to_nearest = Eigen::VectorXd::Ones(points_.rows());
    for (Eigen::Index c = 0; c < k_; ++c) {
      centers.row(c) = points_.row(random_row(to_nearest));
      const Eigen::VectorXd distances = squared_distances(centers, c);
      to_nearest = c == 0 ? distances : to_nearest.cwiseMin(distances).eval();
    }
    return centers;
  }

  // Finds the nearest center of each point, and the sum of the squared distances.
  double assign(const Eigen::MatrixXd& centers, Labels& labels) const
  {
    Eigen::MatrixXd distances(points_.rows(), k_);
    for (Eigen::Index c = 0; c < k_; ++c)
      distances.col(c) = squared_distances(centers, c);
    double sum = 0;
    for (Eigen::Index i = 0; i < points_.rows(); ++i) {
      Eigen::Index nearest;
      sum += distances.row(i).minCoeff(&nearest);
      labels[static_cast<std::size_t>(i)] = static_cast<std::size_t>(nearest);
    }
    return sum;
  }

  // Moves centers to means. A cluster that has lost all points keeps its center.
  void move_to_means(const Labels& labels, Eigen::MatrixXd& centers) const
  {
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(k_, points_.cols());
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(k_);
    for (Eigen::Index i = 0; i < points_.rows(); ++i) {
      const Eigen::Index c = static_cast<Eigen::Index>(labels[static_cast<std::size_t>(i)]);
      sums.row(c) += points_.row(i);
      ++counts[c];
    }
    for (Eigen::Index c = 0; c < k_; ++c)
      if (counts[c] > 0)
        centers.row(c) = sums.row(c) / counts[c];
  }

public:
  K_means(const Eigen::MatrixXd& points, std::size_t k, Random_engine& random)
    : points_(points), k_(static_cast<Eigen::Index>(k)), random_(random) {}

  // Returns the labels of the run with the smallest sum of squared distances from the centers.
  Labels operator()(int number_of_runs)
  {
    Labels best;
    double smallest = std::numeric_limits<double>::infinity();
    for (int run = 0; run < number_of_runs; ++run) {
      Eigen::MatrixXd centers = first_centers();
      Labels labels(static_cast<std::size_t>(points_.rows()));
      double sum = assign(centers, labels);
      for (int i = 0; i < most_iterations; ++i) {
        const Labels before = labels;
        move_to_means(labels, centers);
        sum = assign(centers, labels);
        if (labels == before)
          break;
      }
      if (sum < smallest) {
        smallest = sum;
        best = std::move(labels);
      }
    }
    return best;
  }
};

// Returns the clusters of the best of five runs, numbered from 0.
inline Labels k_means(const Eigen::MatrixXd& points, std::size_t k, Random_engine& random)
{ return contiguous(K_means(points, k, random)(5)); }

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_K_MEANS_H
