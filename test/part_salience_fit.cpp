// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../benchmark/Boundary_network_fit.h"
#include "../benchmark/part_salience_fit.h"
#include "../benchmark/tree_errors.h"
#include "test_meshes.h"

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/iterator.h>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(part_salience_fit)

using namespace segmentation_benchmark;
using test_meshes::Random;

namespace tt = boost::test_tools;

namespace {

const double tolerance = 1e-12;

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, Random& random)
{
  std::uniform_real_distribution<double> number(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return number(random); });
}

Eigen::ArrayXd probabilities(const Eigen::ArrayXd& logits) { return 1 / (1 + (-logits).exp()); }

Cut_group group_of_size(Evaluated_cut::Kind kind, double share_of_area)
{
  Cut_sample cut{{}, 0};
  cut.factors.log_relative_part_area = std::log(share_of_area);
  return {kind, {cut}};
}

Calibrated_part_salience zero_salience()
{ return {0, 0, 0, 0, 0, 0, 0, 0, 0}; }

// A mesh that one person cuts, at its neck.
Benchmark_mesh dumbbell()
{
  Benchmark_mesh result{7, {}, {{}}};
  CGAL::copy_face_graph(test_meshes::mesh_of(test_meshes::dumbbell(24, 12)), result.mesh);
  for (Mesh::Face_index f : result.mesh.faces()) {
    double z = 0;
    for (Mesh::Vertex_index v : CGAL::vertices_around_face(result.mesh.halfedge(f), result.mesh))
      z += result.mesh.point(v).z();
    result.people.front().push_back(z < 0 ? 0 : 1);
  }
  return result;
}

} // namespace

// The part of faces 2 to 7 is cut after its second face.
BOOST_AUTO_TEST_CASE(agreement_by_hand)
{
  const std::vector<CGAL::Spectral_segmentation::internal::Index> faces = {2, 3, 4, 5, 6, 7};
  const std::vector<char> side = {0, 0, 1, 1, 1, 1};
  const Salience_factors factors;
  const Evaluated_cut cut{Evaluated_cut::CANDIDATE, faces, side, factors};
  const Labels along_the_cut = {0, 0, 1, 1, 2, 2, 2, 2}, nowhere_else = {0, 0, 0, 0, 1, 1, 1, 1},
               everywhere = {0, 1, 2, 3, 4, 5, 6, 7}, whole(8, 0),
               one_face_early = {0, 0, 1, 2, 2, 2, 2, 2}, one_face_late = {0, 0, 0, 0, 0, 1, 1, 1};
  for (const Labels& person : {along_the_cut, nowhere_else, everywhere})
    BOOST_TEST(agreement(cut, person) == 1);
  BOOST_TEST(agreement(cut, whole) == 0);
  BOOST_TEST(agreement(cut, one_face_early) == 0.5, tt::tolerance(tolerance)); // face 3, of two
  BOOST_TEST(agreement(cut, one_face_late) == 0.5, tt::tolerance(tolerance));  // face 4
  BOOST_TEST(mean_agreement(cut, {whole, one_face_early}) == 0.25, tt::tolerance(tolerance));
}

BOOST_AUTO_TEST_CASE(evaluated_cuts_of_a_dumbbell)
{
  const Benchmark_mesh input = dumbbell();
  const Mesh_cuts cuts =
    evaluated_cuts(input, CGAL::Spectral_segmentation::Options());
  BOOST_TEST(cuts.id == 7);

  std::size_t number[2] = {0, 0};
  for (const Cut_group& group : cuts.groups) {
    ++number[group.kind];
    BOOST_TEST_REQUIRE(!group.cuts.empty());
    if (group.kind == Evaluated_cut::BOUNDARY)
      BOOST_TEST(group.cuts.size() == 1u);
    for (const Cut_sample& cut : group.cuts)
      BOOST_TEST(std::abs(cut.factors.log_relative_part_area -
                          group.cuts.front().factors.log_relative_part_area) < tolerance);
  }
  // To p pieces there are p - 1 cuts, so at most 2 p - 1 parts that are searched, and p - 1 merges.
  const Segmentation_hierarchy tree = hierarchy(input.mesh, params::default_values());
  BOOST_TEST(number[Evaluated_cut::CANDIDATE] >= tree.number_of_segments() - 1);
  BOOST_TEST(number[Evaluated_cut::CANDIDATE] <= 2 * tree.number_of_segments() - 1);
  BOOST_TEST(number[Evaluated_cut::BOUNDARY] >= tree.number_of_segments() - 1);

  const Cut_group& first = cuts.groups.front();
  BOOST_TEST(std::abs(first.cuts.front().factors.log_relative_part_area) < tolerance);
  const auto best = std::max_element(
    first.cuts.begin(), first.cuts.end(), [](const Cut_sample& a, const Cut_sample& b)
    { return Calibrated_part_salience()(a.factors) < Calibrated_part_salience()(b.factors); });
  BOOST_TEST(best->agreement == 1);
}

// People's labels follow the faces that are left.
BOOST_AUTO_TEST_CASE(evaluated_cuts_on_a_coarse_mesh)
{
  const Benchmark_mesh input = dumbbell();
  Engine_options options = CGAL::Spectral_segmentation::Options();
  options.number_of_coarse_faces = 300;
  BOOST_TEST_REQUIRE(input.mesh.number_of_faces() > 300u);
  const Mesh_cuts cuts = evaluated_cuts(input, options);
  double best = 0;
  for (const Cut_sample& cut : cuts.groups.front().cuts)
    best = (std::max)(best, cut.agreement);
  BOOST_TEST(best > 0.9);
}

BOOST_AUTO_TEST_CASE(regression_without_penalty_recovers_the_model)
{
  Random random(1);
  const Eigen::MatrixXd factors = 3 * random_matrix(200, 4, random);
  Eigen::VectorXd coefficients(4);
  coefficients << 2, -0.5, 0, 7;
  const Eigen::VectorXd targets = probabilities((factors * coefficients).array() - 1.5);
  const Eigen::VectorXd weights = random_matrix(200, 1, random).array().abs();
  const Logistic_model model = Logistic_regression(factors, targets, 0)(weights);
  BOOST_TEST(model.constant == -1.5, tt::tolerance(1e-6));
  BOOST_TEST((model.coefficients - coefficients).norm() < 1e-6);
  BOOST_TEST((probabilities(model.logits(factors)) - targets.array()).abs().maxCoeff() < 1e-6);
}

// The slopes of the loss are written out here with one observation after the other.
BOOST_AUTO_TEST_CASE(regression_ends_where_the_loss_has_no_slope)
{
  Random random(2);
  const Eigen::Index n = 300, m = 3;
  Eigen::MatrixXd factors = random_matrix(n, m, random);
  factors(17, 1) = 100; // an outlier
  const Eigen::VectorXd targets = random_matrix(n, 1, random).array().abs();
  const Eigen::VectorXd weights = random_matrix(n, 1, random).array().abs();
  const double penalty = 1e-3;
  const Logistic_model model = Logistic_regression(factors, targets)(weights);

  std::vector<double> mean(m, 0), deviation(m, 0);
  for (Eigen::Index j = 0; j < m; ++j) {
    for (Eigen::Index i = 0; i < n; ++i)
      mean[j] += factors(i, j) / double(n);
    for (Eigen::Index i = 0; i < n; ++i)
      deviation[j] += std::pow(factors(i, j) - mean[j], 2) / double(n);
    deviation[j] = std::sqrt(deviation[j]);
  }
  const auto standardized = [&](Eigen::Index i, Eigen::Index j)
  { return std::max(-5., std::min(5., (factors(i, j) - mean[j]) / deviation[j])); };
  BOOST_TEST(standardized(17, 1) == 5);

  double loss = 0, slope_of_constant = 0;
  std::vector<double> slopes(m, 0);
  for (Eigen::Index i = 0; i < n; ++i) {
    double logit = model.constant;
    for (Eigen::Index j = 0; j < m; ++j)
      logit += model.coefficients[j] * (mean[j] + deviation[j] * standardized(i, j));
    const double p = 1 / (1 + std::exp(-logit)), w = weights[i] / weights.sum();
    loss -= w * (targets[i] * std::log(p) + (1 - targets[i]) * std::log(1 - p));
    slope_of_constant += w * (p - targets[i]);
    for (Eigen::Index j = 0; j < m; ++j)
      slopes[j] += w * (p - targets[i]) * standardized(i, j);
  }
  BOOST_TEST(std::abs(slope_of_constant) < 1e-9);
  for (Eigen::Index j = 0; j < m; ++j) {
    const double number = model.coefficients[j] * deviation[j];
    loss += penalty * number * number;
    BOOST_TEST(std::abs(slopes[j] + 2 * penalty * number) < 1e-9);
  }
  BOOST_TEST(model.loss == loss, tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_factor_that_is_always_the_same_tells_nothing)
{
  Random random(3);
  Eigen::MatrixXd factors = random_matrix(50, 2, random);
  factors.col(1).setConstant(4);
  const Eigen::VectorXd targets = probabilities(2 * factors.col(0).array());
  const Logistic_model model = Logistic_regression(factors, targets)(Eigen::VectorXd::Ones(50));
  BOOST_TEST(model.coefficients[0] > 1);
  BOOST_TEST(model.coefficients[1] == 0);
}

BOOST_AUTO_TEST_CASE(regression_of_no_numbers_is_refused)
{
  Eigen::MatrixXd factors = Eigen::MatrixXd::Identity(4, 2);
  factors(2, 0) = std::numeric_limits<double>::quiet_NaN();
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(4);
  BOOST_CHECK_THROW(Logistic_regression(factors, ones / 2)(ones), std::runtime_error);
}

// Roots of areas: 1, 1/2, 1/2 of the first mesh, 1, 1 of the second. With 1 a mesh, candidates have
// 3/4 and 1/2, boundaries 1/4 and 1/2, to be multiplied by 5/3.
BOOST_AUTO_TEST_CASE(weights_of_groups_by_hand)
{
  const std::vector<double> weights = group_weights(
    {{1, {group_of_size(Evaluated_cut::CANDIDATE, 1), group_of_size(Evaluated_cut::CANDIDATE, 0.25),
          group_of_size(Evaluated_cut::BOUNDARY, 0.25)}},
     {2, {group_of_size(Evaluated_cut::CANDIDATE, 1), group_of_size(Evaluated_cut::BOUNDARY, 1)}}});
  BOOST_TEST(weights == (std::vector<double>{1. / 2, 1. / 4, 5. / 12, 1. / 2, 5. / 6}),
             tt::tolerance(tolerance) << tt::per_element());
}

BOOST_AUTO_TEST_CASE(shares_of_cuts_by_hand)
{
  const Eigen::ArrayXd shares = shares_of_cuts(Eigen::Array2d(0, std::log(3.))); // odds 1 : 9
  BOOST_TEST(shares[0] == 0.9 * 0.1 + 0.05, tt::tolerance(tolerance));
  BOOST_TEST(shares[1] == 0.9 * 0.9 + 0.05, tt::tolerance(tolerance));
  const Eigen::ArrayXd far = shares_of_cuts(Eigen::Array2d(-1000, 1000));
  BOOST_TEST(far[0] == 0.05, tt::tolerance(tolerance));
  BOOST_TEST(far[1] == 0.95, tt::tolerance(tolerance));
  for (double share : shares_of_cuts(Eigen::Array3d::Constant(7)))
    BOOST_TEST(share == 1. / 3, tt::tolerance(tolerance));
  BOOST_TEST(shares_of_cuts(Eigen::ArrayXd::Constant(1, -7))[0] == 1, tt::tolerance(tolerance));
}

// The salience of the library is asked which coefficient belongs to which factor.
BOOST_AUTO_TEST_CASE(each_coefficient_is_found)
{
  Random random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  std::set<std::string> names;
  for (const Fitted_factor& fitted : fitted_factors) {
    names.insert(fitted.name);
    Calibrated_part_salience truth = zero_salience();
    truth.*fitted.coefficient = 3;
    Mesh_cuts mesh{1, {}};
    for (int i = 0; i < 500; ++i) {
      Cut_sample cut;
      for (const Fitted_factor& f : fitted_factors)
        cut.factors.*f.factor = number(random);
      cut.agreement = truth(cut.factors);
      mesh.groups.push_back(
        {i % 2 == 0 ? Evaluated_cut::CANDIDATE : Evaluated_cut::BOUNDARY, {cut}});
    }
    const Calibrated_part_salience found = fit_part_salience({mesh}, 1).salience;
    BOOST_TEST_INFO_SCOPE(fitted.name);
    for (const Fitted_factor& f : fitted_factors) {
      const double expected = truth.*f.coefficient, coefficient = found.*f.coefficient;
      BOOST_TEST(std::abs(coefficient - expected) < 0.1);
      BOOST_TEST(coefficient == std::round(1000 * coefficient) / 1000);
    }
    BOOST_TEST(std::abs(found.constant) < 0.1);
  }
  BOOST_TEST(names.size() == fitted_factors.size());
}

// No line fits all three cuts of each part; later rounds mind the one that would be chosen.
BOOST_AUTO_TEST_CASE(later_rounds_mind_the_chosen_cut)
{
  Cut_group group{Evaluated_cut::CANDIDATE, {}};
  for (double agreement : {0.3, 0., 0.8}) {
    Cut_sample cut{{}, agreement};
    cut.factors.cut_strength = static_cast<double>(group.cuts.size());
    group.cuts.push_back(cut);
  }
  const auto error_at_chosen = [&](std::size_t rounds) {
    const Calibrated_part_salience salience = fit_part_salience({{1, {group}}}, rounds).salience;
    return std::abs(salience(group.cuts[2].factors) - 0.8);
  };
  BOOST_TEST(error_at_chosen(0) > 0.1);
  BOOST_TEST(error_at_chosen(3) < error_at_chosen(0) / 3);
}

// Two factors of a network with one unit, the second an outlier.
BOOST_AUTO_TEST_CASE(logit_of_a_network_by_hand)
{
  Boundary_network network{};
  network.deviations.fill(1);
  network.means[0] = 0.1; // of size
  network.deviations[0] = 0.2;
  network.constant = 0.5;
  network.weights[0] = 3;
  network.units[2].constant = -1;
  network.units[2].weights[0] = 0.5;
  network.units[2].weights[8] = 0.25; // of roundness
  network.units[2].output = 2;
  Salience_factors factors;
  factors.size = 0.4;
  factors.roundness = 7; // counts as 4
  BOOST_TEST(network.logit(factors) == 0.5 + 3 * 1.5 + 2 * std::tanh(-1 + 0.5 * 1.5 + 0.25 * 4),
             tt::tolerance(tolerance));
  factors.is_boundary = true;
  Calibrated_part_salience salience;
  salience.boundary_network = network;
  BOOST_TEST(salience(factors) == 1 / (1 + std::exp(-network.logit(factors))),
             tt::tolerance(tolerance));
}

// Areas of 1/2 and 1/2, 1/4 and 3/4 of a mesh, and 1/10 and 1/10 of another.
BOOST_AUTO_TEST_CASE(weights_of_boundaries_by_hand)
{
  const auto boundary = [](double area, double size, double agreement) {
    Cut_sample cut{{}, agreement};
    cut.factors.log_relative_part_area = std::log(area);
    cut.factors.size = size;
    return Cut_group{Evaluated_cut::BOUNDARY, {cut}};
  };
  const Boundary_rows rows = boundary_rows(
    {{1, {boundary(1, 0.5, 0.3), group_of_size(Evaluated_cut::CANDIDATE, 1),
          boundary(1, 0.25, 0.6)}},
     {2, {boundary(0.2, 0.5, 0.9)}}});
  BOOST_TEST_REQUIRE(rows.factors.size() == 3u);
  const double first = 0.5, second = std::sqrt(3.) / 4;
  BOOST_TEST(rows.weights[0] == first / (first + second) / 2, tt::tolerance(tolerance));
  BOOST_TEST(rows.weights[1] == second / (first + second) / 2, tt::tolerance(tolerance));
  BOOST_TEST(rows.weights[2] == 0.5, tt::tolerance(tolerance));
  BOOST_TEST(rows.agreement[1] == 0.6);
  BOOST_TEST(rows.factors[2].log_relative_part_area == std::log(0.2));
}

// People cut if one of two factors is large, but not both: no linear function knows that.
BOOST_AUTO_TEST_CASE(a_network_learns_what_no_linear_function_can)
{
  Random random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  Boundary_rows rows;
  rows.agreement.resize(2000);
  rows.weights = Eigen::ArrayXd::Constant(2000, 1. / 2000);
  double error_of_mean = 0, error = 0;
  for (double& agreement : rows.agreement) {
    Salience_factors factors;
    factors.roundness = number(random);
    factors.cut_strength = number(random);
    agreement = factors.roundness * factors.cut_strength < 0 ? 0.9 : 0.1;
    rows.factors.push_back(factors);
    error_of_mean += std::abs(agreement - 0.5) / 2000;
  }
  const auto [network, loss] = Boundary_network_fit(rows)();
  for (std::size_t i = 0; i < 2000; ++i)
    error += std::abs(1 / (1 + std::exp(-network.logit(rows.factors[i]))) -
                      rows.agreement[static_cast<Eigen::Index>(i)]) / 2000;
  BOOST_TEST(error < error_of_mean / 3);
  BOOST_TEST(loss < 0.6); // ln 2 without the factors, 0.325 at best
}

BOOST_AUTO_TEST_CASE(a_network_without_boundaries_is_refused)
{
  const Boundary_rows rows;
  BOOST_CHECK_THROW(Boundary_network_fit{rows}, std::invalid_argument);
}

// One person cuts at the neck, as the tree does first, the other not at all.
BOOST_AUTO_TEST_CASE(errors_of_a_dumbbell)
{
  Benchmark_mesh input = dumbbell();
  const Labels halves = input.people.front(), whole(halves.size(), 0);
  input.people.push_back(whole);
  const double error = rand_error(halves, whole);
  const Tree_errors errors = tree_errors(input, tree_methods().front());
  BOOST_TEST(errors.id == 7);
  BOOST_TEST(errors.people == error, tt::tolerance(tolerance));
  BOOST_TEST(errors.best == error / 2, tt::tolerance(tolerance));
  BOOST_TEST(errors.k == error / 2, tt::tolerance(tolerance));
  const std::vector<double>& thresholds = tried_thresholds();
  BOOST_TEST_REQUIRE(errors.automatic.size() == thresholds.size());
  BOOST_TEST(thresholds.front() == 0.3);
  BOOST_TEST(thresholds.back() == 0.7);
  for (std::size_t t = 0; t < thresholds.size(); ++t) {
    const Segmentation_hierarchy tree =
      hierarchy(input.mesh, params::salience_threshold(thresholds[t]));
    BOOST_TEST(errors.automatic[t] == mean_rand_error(labels_of_run(tree), input.people),
               tt::tolerance(tolerance));
  }

  input.people = {halves, halves};
  const Tree_errors agreed = tree_errors(input, tree_methods().front());
  BOOST_TEST(agreed.people == 0);
  BOOST_TEST(agreed.k == 0);
  BOOST_TEST(agreed.best == 0);
  const Tree_errors mean = mean_tree_errors({errors, agreed});
  BOOST_TEST(mean.people == error / 2, tt::tolerance(tolerance));
  BOOST_TEST(mean.k == error / 4, tt::tolerance(tolerance));
  BOOST_TEST(mean.best == error / 4, tt::tolerance(tolerance));
  BOOST_TEST(mean.automatic.front() == (errors.automatic.front() + agreed.automatic.front()) / 2,
             tt::tolerance(tolerance));
}

BOOST_AUTO_TEST_CASE(best_threshold_is_that_of_least_error)
{
  Tree_errors errors;
  errors.automatic = {0.3, 0.1, 0.2, 0.1};
  BOOST_TEST(best_threshold(errors) == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
