// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_LOGISTIC_REGRESSION_H
#define SEGMENTATION_BENCHMARK_LOGISTIC_REGRESSION_H

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <stdexcept>

namespace segmentation_benchmark {

// The probability 1 / (1 + exp(-logit)), whose logit is linear in the factors.
struct Logistic_model
{
  double constant = 0;
  Eigen::VectorXd coefficients;
  double loss = 0; // includes the penalty

  // One for each row of factors.
  Eigen::VectorXd logits(const Eigen::MatrixXd& factors) const
  { return (factors * coefficients).array() + constant; }
};

// The model of least cross entropy with targets in [0, 1], which may be probabilities themselves.
// The squares of the coefficients of standardized factors are penalized; outliers count as factors
// at a largest deviation.
class Logistic_regression
{
  static constexpr double largest_deviation = 5; // in standard deviations
  static constexpr double accuracy = 1e-12;      // relative to the loss
  static constexpr int maximum_number_of_steps = 100;

  typedef Eigen::ArrayXd Array;
  typedef Eigen::VectorXd Vector;

  Array targets_;
  Array means_, deviations_; // one per factor
  Eigen::MatrixXd table_;    // a column of 1, then the standardized factors
  Vector penalties_;         // one per column, on the square of its number

  Array logits(const Vector& numbers) const { return (table_ * numbers).array(); }

  double loss(const Array& weights, const Vector& numbers) const
  {
    const Array s = logits(numbers);
    const Array cross_entropy = s.max(0) + (-s.abs()).exp().log1p() - targets_ * s;
    return (weights * cross_entropy).sum() + penalties_.dot(numbers.cwiseAbs2());
  }

  Logistic_model model(const Array& weights, const Vector& numbers) const
  {
    Logistic_model result;
    result.coefficients = numbers.tail(means_.size()).array() / deviations_;
    result.constant = numbers[0] - result.coefficients.dot(means_.matrix());
    result.loss = loss(weights, numbers);
    return result;
  }

public:
  // An observation is a row of factors and a target.
  Logistic_regression(const Eigen::MatrixXd& factors, const Eigen::VectorXd& targets,
                      double penalty = 1e-3)
    : targets_(targets), means_(factors.colwise().mean()),
      penalties_(Vector::Constant(factors.cols() + 1, penalty))
  {
    Eigen::ArrayXXd z = factors.array().rowwise() - means_.transpose();
    deviations_ = z.square().colwise().mean().sqrt();
    deviations_ = (deviations_ > 0).select(deviations_, 1.);
    z.rowwise() /= deviations_.transpose();
    table_.resize(factors.rows(), factors.cols() + 1);
    table_ << Vector::Ones(factors.rows()),
      z.max(-largest_deviation).min(largest_deviation).matrix();
    penalties_[0] = 0;
  }

  // By Newton's method; one weight for each observation, of which only the ratios matter.
  Logistic_model operator()(const Eigen::VectorXd& given_weights) const
  {
    const Array weights = given_weights / given_weights.sum();
    Vector numbers = Vector::Zero(table_.cols());
    for (int i = 0; i < maximum_number_of_steps; ++i) {
      const Array p = 1 / (1 + (-logits(numbers)).exp());
      const Vector gradient = table_.transpose() * (weights * (p - targets_)).matrix() +
                              2 * penalties_.cwiseProduct(numbers);
      Eigen::MatrixXd hessian =
        table_.transpose() * (weights * p * (1 - p)).matrix().asDiagonal() * table_;
      hessian.diagonal() += 2 * penalties_;
      Vector step = hessian.ldlt().solve(gradient);
      const double expected_gain = gradient.dot(step) / 2;
      if (expected_gain < accuracy)
        return model(weights, numbers - step);
      while (loss(weights, numbers - step) > loss(weights, numbers))
        step /= 2;
      numbers -= step;
    }
    throw std::runtime_error("the fit does not converge");
  }
};

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_LOGISTIC_REGRESSION_H
