// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PART_SALIENCE_FIT_H
#define SEGMENTATION_BENCHMARK_PART_SALIENCE_FIT_H

#include "Logistic_regression.h"
#include "evaluated_cuts.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// The calibrated salience as a logistic regression of people's agreement with cuts.
namespace segmentation_benchmark {

using spectral::Calibrated_part_salience;
using spectral::Salience_factors;

// A factor of the calibrated salience, and its coefficient.
struct Fitted_factor
{
  const char* name;
  double Salience_factors::*factor;
  double Calibrated_part_salience::*coefficient;
};

constexpr std::array<Fitted_factor, 8> fitted_factors = {{
  {"log_relative_part_area", &Salience_factors::log_relative_part_area,
   &Calibrated_part_salience::log_relative_part_area},
  {"size", &Salience_factors::size, &Calibrated_part_salience::size},
  {"cut_strength", &Salience_factors::cut_strength, &Calibrated_part_salience::cut_strength},
  {"concavity_near_cut", &Salience_factors::concavity_near_cut,
   &Calibrated_part_salience::concavity_near_cut},
  {"protrusiveness", &Salience_factors::protrusiveness, &Calibrated_part_salience::protrusiveness},
  {"convexity_gain", &Salience_factors::convexity_gain, &Calibrated_part_salience::convexity_gain},
  {"relative_convexity_gain", &Salience_factors::relative_convexity_gain,
   &Calibrated_part_salience::relative_convexity_gain},
  {"expansion_behind_cut", &Salience_factors::expansion_behind_cut,
   &Calibrated_part_salience::expansion_behind_cut},
}};

// How much each group counts: the square root of its part's share of the area of the mesh, then
// each mesh as much as any other, then boundaries as much as candidates.
inline std::vector<double> group_weights(const std::vector<Mesh_cuts>& meshes)
{
  std::vector<double> weights;
  double total[2] = {0, 0};
  for (const Mesh_cuts& mesh : meshes) {
    std::vector<double> lengths;
    double sum = 0;
    for (const Cut_group& group : mesh.groups) {
      lengths.push_back(std::exp(group.cuts.front().factors.log_relative_part_area / 2));
      sum += lengths.back();
    }
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      weights.push_back(lengths[i] / sum);
      total[mesh.groups[i].kind] += weights.back();
    }
  }
  std::size_t group_number = 0;
  for (const Mesh_cuts& mesh : meshes)
    for (const Cut_group& group : mesh.groups) {
      if (group.kind == Evaluated_cut::BOUNDARY)
        weights[group_number] *= total[Evaluated_cut::CANDIDATE] / total[Evaluated_cut::BOUNDARY];
      ++group_number;
    }
  return weights;
}

// How much each cut of a group counts: the more the higher its logit, as the choice falls among the
// highest; all the same if the logits are.
inline Eigen::ArrayXd shares_of_cuts(const Eigen::ArrayXd& logits)
{
  const Eigen::ArrayXd odds = (2 * (logits - logits.maxCoeff())).exp();
  return 0.9 * odds / odds.sum() + 0.1 / static_cast<double>(logits.size());
}

// The cuts of all meshes, a row each; those of a group follow each other.
struct Observations
{
  Eigen::MatrixXd factors;
  Eigen::VectorXd agreement;
  std::vector<Eigen::Index> group_sizes;
};

inline Observations observations(const std::vector<Mesh_cuts>& meshes)
{
  Observations result;
  result.factors.resize(number_of_cuts(meshes), fitted_factors.size());
  result.agreement.resize(result.factors.rows());
  Eigen::Index row = 0;
  for (const Mesh_cuts& mesh : meshes)
    for (const Cut_group& group : mesh.groups) {
      result.group_sizes.push_back(static_cast<Eigen::Index>(group.cuts.size()));
      for (const Cut_sample& cut : group.cuts) {
        for (std::size_t i = 0; i < fitted_factors.size(); ++i)
          result.factors(row, i) = cut.factors.*fitted_factors[i].factor;
        result.agreement[row++] = cut.agreement;
      }
    }
  return result;
}

struct Part_salience_fit
{
  Calibrated_part_salience salience; // rounded, as it stands in the source
  double loss;                       // before rounding
};

inline Part_salience_fit part_salience_fit(const Logistic_model& model)
{
  const auto rounded = [](double number) { return std::round(1000 * number) / 1000; };
  Part_salience_fit result{{}, model.loss};
  result.salience.constant = rounded(model.constant);
  for (std::size_t i = 0; i < fitted_factors.size(); ++i)
    result.salience.*fitted_factors[i].coefficient = rounded(model.coefficients[i]);
  return result;
}

// After a first fit, some rounds in which the fit minds the cuts that the last one holds for the
// most salient.
inline Part_salience_fit fit_part_salience(const std::vector<Mesh_cuts>& meshes,
                                           std::size_t rounds)
{
  const Observations cuts = observations(meshes);
  const Logistic_regression regression(cuts.factors, cuts.agreement);
  const std::vector<double> weights_of_groups = group_weights(meshes);
  Logistic_model model;
  Eigen::VectorXd logits = Eigen::VectorXd::Zero(cuts.factors.rows());
  Eigen::VectorXd weights(logits.size());
  for (std::size_t round = 0; round <= rounds; ++round) {
    Eigen::Index row = 0;
    for (std::size_t group = 0; group < weights_of_groups.size(); ++group) {
      const Eigen::Index size = cuts.group_sizes[group];
      weights.segment(row, size) =
        weights_of_groups[group] * shares_of_cuts(logits.segment(row, size));
      row += size;
    }
    model = regression(weights);
    logits = model.logits(cuts.factors);
  }
  return part_salience_fit(model);
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PART_SALIENCE_FIT_H
