// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_BOUNDARY_NETWORK_FIT_H
#define SEGMENTATION_BENCHMARK_BOUNDARY_NETWORK_FIT_H

#include "Uniform_random.h"
#include "evaluated_cuts.h"

#include <CGAL/Spectral_segmentation/internal/salience/Boundary_network.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace segmentation_benchmark {

using spectral::internal::Boundary_network;

// The boundaries of meshes, a row each.
struct Boundary_rows
{
  std::vector<spectral::Salience_factors> factors;
  Eigen::ArrayXd agreement;
  Eigen::ArrayXd weights; // the sum is 1
};

// Returns all boundaries. One with the areas A and B on its sides counts as sqrt(A B), and each
// mesh as much as any other.
inline Boundary_rows boundary_rows(const std::vector<Mesh_cuts>& meshes)
{
  Boundary_rows result;
  std::vector<double> agreement, weights;
  for (const Mesh_cuts& mesh : meshes) {
    const std::size_t first = weights.size();
    double sum = 0;
    for (const Cut_group& group : mesh.groups)
      if (group.kind == Evaluated_cut::BOUNDARY) {
        const Cut_sample& cut = group.cuts.front();
        result.factors.push_back(cut.factors);
        agreement.push_back(cut.agreement);
        weights.push_back(std::exp(cut.factors.log_relative_part_area) *
                          std::sqrt(cut.factors.size * (1 - cut.factors.size)));
        sum += weights.back();
      }
    for (std::size_t i = first; i < weights.size(); ++i)
      weights[i] /= sum;
  }
  const Eigen::Index n = static_cast<Eigen::Index>(weights.size());
  result.agreement = Eigen::Map<const Eigen::ArrayXd>(agreement.data(), n);
  result.weights = Eigen::Map<const Eigen::ArrayXd>(weights.data(), n);
  result.weights /= result.weights.sum();
  return result;
}

// Fits a network to the boundaries of meshes: the least cross entropy with people's agreement, by
// the method of Levenberg and Marquardt. The squares of all weights are penalized.
class Boundary_network_fit
{
  static constexpr double penalty = 1.5e-3;
  static constexpr double accuracy = 1e-7; // relative to the loss
  static constexpr int maximum_number_of_steps = 300;

  typedef Eigen::Index Index;
  typedef Eigen::ArrayXd Array;
  typedef Eigen::VectorXd Vector;

  static constexpr Index number_of_inputs = std::tuple_size<Boundary_network::Inputs>::value;
  static constexpr Index number_of_units =
    std::tuple_size<decltype(Boundary_network::units)>::value;
  static constexpr Index size_of_unit = number_of_inputs + 2; // constant, weights, output

  const Boundary_rows& rows_;
  Boundary_network result_{};
  Eigen::MatrixXd inputs_; // a column of 1, then the standardized factors
  Vector numbers_;         // the linear part, then the units

  static Index first_number(Index unit) { return 1 + number_of_inputs + unit * size_of_unit; }

  void standardize()
  {
    const Index n = static_cast<Index>(rows_.factors.size());
    if (n == 0)
      throw std::invalid_argument("no boundary was evaluated");
    inputs_.resize(n, number_of_inputs + 1);
    inputs_.col(0).setOnes();
    for (Index j = 0; j < number_of_inputs; ++j) {
      Array values(n);
      for (Index i = 0; i < n; ++i)
        values[i] = rows_.factors[i].*spectral::internal::named_factors[j].value;
      const double mean = values.mean(), deviation = std::sqrt((values - mean).square().mean());
      result_.means[j] = rounded(mean);
      result_.deviations[j] = deviation > 0 ? deviation : 1;
    }
    for (double& d : result_.deviations)
      d = (std::max)(rounded(d), 1e-5);
    for (Index i = 0; i < n; ++i) {
      const Boundary_network::Inputs x = result_.inputs(rows_.factors[i]);
      for (Index j = 0; j < number_of_inputs; ++j)
        inputs_(i, j + 1) = x[j];
    }
  }

  static double rounded(double number) { return std::round(1e5 * number) / 1e5 + 0.; } // no -0

  // Adds small units at random to a linear function.
  Vector with_units(Vector linear, std::uint64_t seed) const
  {
    Uniform_random random(seed);
    for (Index i = first_number(0); i < linear.size(); ++i)
      linear[i] = random() - 0.5;
    return linear;
  }

  Array activations(const Vector& numbers, Index unit) const
  {
    return (inputs_ * numbers.segment(first_number(unit), number_of_inputs + 1)).array().tanh();
  }

  Array logits(const Vector& numbers) const
  {
    Array result = (inputs_ * numbers.head(number_of_inputs + 1)).array();
    for (Index u = 0; u < number_of_units; ++u)
      result += numbers[first_number(u) + size_of_unit - 1] * activations(numbers, u);
    return result;
  }

  // The derivatives of the logits, a row for each boundary.
  Eigen::MatrixXd jacobian(const Vector& numbers) const
  {
    Eigen::MatrixXd result(inputs_.rows(), numbers.size());
    result.leftCols(number_of_inputs + 1) = inputs_;
    for (Index u = 0; u < number_of_units; ++u) {
      const Array a = activations(numbers, u);
      const double output = numbers[first_number(u) + size_of_unit - 1];
      result.middleCols(first_number(u), number_of_inputs + 1) =
        inputs_.array().colwise() * (output * (1 - a.square()));
      result.col(first_number(u) + size_of_unit - 1) = a.matrix();
    }
    return result;
  }

  // Constants cost nothing.
  Vector penalties() const
  {
    Vector result = Vector::Constant(numbers_.size(), penalty);
    result[0] = 0;
    for (Index u = 0; u < number_of_units; ++u)
      result[first_number(u)] = 0;
    return result;
  }

  double loss(const Vector& numbers) const
  {
    const Array s = logits(numbers);
    const Array cross_entropy = s.max(0) + (-s.abs()).exp().log1p() - rows_.agreement * s;
    return (rows_.weights * cross_entropy).sum() + penalties().dot(numbers.cwiseAbs2());
  }

  double minimize()
  {
    double current = loss(numbers_), damping = 1e-2;
    for (int step = 0; step < maximum_number_of_steps && damping < 1e8; ++step) {
      const Array p = 1 / (1 + (-logits(numbers_)).exp());
      const Eigen::MatrixXd j = jacobian(numbers_);
      const Vector gradient = j.transpose() * (rows_.weights * (p - rows_.agreement)).matrix() +
                              2 * penalties().cwiseProduct(numbers_);
      const Eigen::MatrixXd scaled =
        j.array().colwise() * (rows_.weights * p * (1 - p)).sqrt();
      Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(j.cols(), j.cols());
      hessian.selfadjointView<Eigen::Lower>().rankUpdate(scaled.transpose());
      hessian.diagonal() += 2 * penalties();
      double gain = 0;
      for (; damping < 1e8; damping *= 4) {
        Eigen::MatrixXd damped = hessian;
        damped.diagonal() *= 1 + damping;
        damped.diagonal().array() += 1e-9;
        const Vector next =
          numbers_ - damped.selfadjointView<Eigen::Lower>().ldlt().solve(gradient);
        const double value = loss(next);
        if (!(value < current))
          continue;
        gain = current - value;
        current = value;
        numbers_ = next;
        damping /= 8;
        break;
      }
      if (gain < accuracy * current)
        break;
    }
    return current;
  }

public:
  explicit Boundary_network_fit(const Boundary_rows& rows) : rows_(rows) { standardize(); }

  // Returns the best network of several starts, rounded as it stands in the source, and its loss.
  std::pair<Boundary_network, double> operator()(std::size_t number_of_starts = 4)
  {
    double least = std::numeric_limits<double>::infinity();
    Vector best;
    numbers_ = Vector::Zero(first_number(number_of_units));
    minimize(); // the units stay 0
    const Vector linear = numbers_;
    for (std::size_t start = 0; start < number_of_starts; ++start) {
      numbers_ = with_units(linear, start + 1);
      const double value = minimize();
      if (value < least) {
        least = value;
        best = numbers_;
      }
    }
    if (best.size() == 0)
      throw std::runtime_error("the fit does not converge");
    const auto number = [&best](Index i) { return rounded(best[i]); };
    result_.constant = number(0);
    for (Index i = 0; i < number_of_inputs; ++i)
      result_.weights[i] = number(1 + i);
    for (Index u = 0; u < number_of_units; ++u) {
      Boundary_network::Unit& unit = result_.units[u];
      unit.constant = number(first_number(u));
      for (Index i = 0; i < number_of_inputs; ++i)
        unit.weights[i] = number(first_number(u) + 1 + i);
      unit.output = number(first_number(u) + size_of_unit - 1);
    }
    return {result_, least};
  }
};

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_BOUNDARY_NETWORK_FIT_H
