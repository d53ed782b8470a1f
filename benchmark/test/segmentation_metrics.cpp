// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../part_metrics.h"
#include "../princeton_benchmark.h"
#include "test_meshes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(segmentation_metrics)

using namespace segmentation_benchmark;
using test_meshes::mesh_of;
using test_meshes::plate;

namespace tt = boost::test_tools;

namespace {

const double tolerance = 1e-12;

Mesh_facts facts_of_plate(std::size_t nx, std::size_t ny)
{ return mesh_facts(mesh_of(plate(nx, ny))); }

Errors errors_of(const Mesh_facts& facts, const Labels& result, const Labels& reference)
{ return errors(facts, segmentation(facts, result), segmentation(facts, reference)); }

Labels random_labels(std::size_t n, std::size_t number, std::mt19937& random)
{
  std::vector<std::size_t> labels;
  for (std::size_t i = 0; i < n; ++i)
    labels.push_back(random() % number);
  return contiguous(labels);
}

// By the definition: one pair after the other.
double rand_error_of_pairs(const Labels& a, const Labels& b)
{
  double disagree = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      disagree += (a[i] == a[j]) != (b[i] == b[j]);
  return disagree / (double(a.size()) * double((a.size() - 1) / 2));
}

// A strip of four squares of side 1, of two faces each, cut after the first square and after the
// second one: the cuts are the edges x = 1 and x = 2.
const Labels after_1 = {0, 0, 1, 1, 1, 1, 1, 1};
const Labels after_2 = {0, 0, 0, 0, 1, 1, 1, 1};
const Labels after_1_and_2 = {0, 0, 1, 1, 2, 2, 2, 2};
const Labels all_in_one(8, 0);

} // namespace

BOOST_AUTO_TEST_CASE(labels_are_numbered_from_0)
{
  BOOST_TEST(contiguous(std::vector<int>{7, -2, 7, 100}) == (Labels{0, 1, 0, 2}),
             tt::per_element());
  BOOST_TEST(number_of_segments(Labels{0, 1, 0, 2}) == 3u);
  BOOST_TEST(number_of_segments(Labels()) == 0u);
}

BOOST_AUTO_TEST_CASE(facts_of_a_plate)
{
  const Mesh_facts facts = facts_of_plate(4, 1);
  BOOST_TEST(facts.face_areas == std::vector<double>(8, 0.5), tt::per_element());
  BOOST_TEST(facts.interior_edges.size() == 7u); // four diagonals and three between squares
  BOOST_TEST(boost::num_edges(facts.vertex_graph) == 17u);

  // The centers of faces are at (i + 1/3, 2/3) and (i + 2/3, 1/3), the centroid at (2, 1/2).
  double sum = 0;
  for (int i = 0; i < 4; ++i)
    sum += std::hypot(i + 1. / 3 - 2, 1. / 6) + std::hypot(i + 2. / 3 - 2, 1. / 6);
  BOOST_TEST(facts.average_radius == sum / 8, tt::tolerance(tolerance));
}

BOOST_AUTO_TEST_CASE(identical_segmentations_have_no_error)
{
  const Mesh_facts facts = facts_of_plate(4, 1);
  const Labels renumbered = {2, 2, 0, 0, 1, 1, 1, 1};
  const Errors e = errors_of(facts, after_1_and_2, renumbered);
  BOOST_TEST(e.rand_error == 0);
  BOOST_TEST(e.cut_discrepancy == 0);
}

// The benchmark's program counts 8 * 3 pairs. The 2 * 2 and 2 * 4 pairs with a face of the second
// square are judged otherwise.
BOOST_AUTO_TEST_CASE(rand_error_by_hand)
{
  BOOST_TEST(rand_error(after_1, after_2) == (2 * 2 + 2 * 4) / 24., tt::tolerance(tolerance));
  BOOST_TEST(rand_error(all_in_one, after_2) == 4 * 4 / 24., tt::tolerance(tolerance));
  BOOST_TEST(rand_error(Labels{0, 0, 0}, Labels{0, 0, 1}) == 2 / 3., tt::tolerance(tolerance));
}

BOOST_AUTO_TEST_CASE(rand_error_equals_a_count_of_all_pairs)
{
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    const std::size_t n = 3 + random() % 40;
    const Labels a = random_labels(n, 1 + random() % 6, random);
    const Labels b = random_labels(n, 1 + random() % 6, random);
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    BOOST_TEST(rand_error(a, b) == rand_error_of_pairs(a, b), tt::tolerance(tolerance));
  }
}

// The parts of after_2 have two squares each. The first one has 1 of 2 squares in common with the
// first part of after_1; the second one has 2 of 3 in common with the other part.
BOOST_AUTO_TEST_CASE(overlap_ratios_by_hand)
{
  const std::vector<double> areas(8, 0.5);
  const Eigen::ArrayXXd same = overlap_ratios(overlap(after_2, after_2, areas));
  BOOST_TEST((same == Eigen::ArrayXXd(Eigen::MatrixXd::Identity(2, 2))).all());
  const Eigen::ArrayXXd shifted = overlap_ratios(overlap(after_1, after_2, areas));
  BOOST_TEST_REQUIRE(shifted.rows() == 2);
  BOOST_TEST_REQUIRE(shifted.cols() == 2);
  BOOST_TEST(shifted(0, 0) == 1 / 2., tt::tolerance(tolerance));
  BOOST_TEST(shifted(0, 1) == 0);
  BOOST_TEST(shifted(1, 0) == 1 / 4., tt::tolerance(tolerance));
  BOOST_TEST(shifted(1, 1) == 2 / 3., tt::tolerance(tolerance));
}

// The first of the three segments of after_1_and_2 is half of the first part of after_2, and the
// last is its second part. Only the match of the last is above 1/2.
BOOST_AUTO_TEST_CASE(part_agreement_by_hand)
{
  const Part_agreement one = part_agreement({overlap(after_1_and_2, after_2)});
  BOOST_TEST(one.panoptic_quality == 1 / 2.5, tt::tolerance(tolerance));
  BOOST_TEST(one.mean_overlap == (1 / 2. + 1) / 2, tt::tolerance(tolerance));
  BOOST_TEST(one.made == 1);
  BOOST_TEST(one.false_segments == 0);
  BOOST_TEST(one.scraps == 0);

  // A person without cuts makes none of them, but half of after_2 is still made by another one.
  const Part_agreement two =
    part_agreement({overlap(after_1_and_2, after_2), overlap(after_1_and_2, all_in_one)});
  BOOST_TEST(two.panoptic_quality == (1 / 2.5 + 0) / 2, tt::tolerance(tolerance));
  BOOST_TEST(two.mean_overlap == (3 / 4. + 1 / 2.) / 2, tt::tolerance(tolerance));
  BOOST_TEST(two.made == 1);

  const Labels other = {0, 1, 2, 2, 1, 0, 0, 0};
  const Part_agreement none = part_agreement({overlap(after_1_and_2, other)});
  BOOST_TEST(none.made == 2 / 3., tt::tolerance(tolerance));
  BOOST_TEST(none.false_segments == 1);
}

// A segment of one face in 200 that no person made is a scrap, of one in 50 it is none.
BOOST_AUTO_TEST_CASE(scraps_are_small_false_segments)
{
  Labels labels(200, 0);
  labels.back() = 1;
  const Labels person(200, 0);
  BOOST_TEST(part_agreement({overlap(labels, person)}).scraps == 1);
  std::fill(labels.end() - 4, labels.end(), std::size_t(1));
  const Part_agreement larger = part_agreement({overlap(labels, person)});
  BOOST_TEST(larger.false_segments == 1);
  BOOST_TEST(larger.scraps == 0);
  BOOST_TEST(part_agreement({overlap(labels, labels)}).false_segments == 0);
}

BOOST_AUTO_TEST_CASE(errors_are_symmetric)
{
  const Mesh_facts facts = mesh_facts(mesh_of(test_meshes::sphere(1)));
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const Labels a = random_labels(80, 5, random), b = random_labels(80, 3, random);
    const Errors ab = errors_of(facts, a, b), ba = errors_of(facts, b, a);
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    BOOST_TEST(ab.rand_error == ba.rand_error, tt::tolerance(tolerance));
    BOOST_TEST(ab.cut_discrepancy == ba.cut_discrepancy, tt::tolerance(tolerance));
  }
}

// The cut of each side has two vertices, at distance 1 from those of the other.
BOOST_AUTO_TEST_CASE(cut_discrepancy_by_hand)
{
  const Mesh_facts facts = facts_of_plate(4, 1);
  BOOST_TEST(errors_of(facts, after_1, after_2).cut_discrepancy == 1 / facts.average_radius,
             tt::tolerance(tolerance));

  // Only the two of the 2 + 4 vertices at x = 1 are away from the other side's cut.
  BOOST_TEST(errors_of(facts, after_2, after_1_and_2).cut_discrepancy ==
               2. / 6 / facts.average_radius, tt::tolerance(tolerance));
}

BOOST_AUTO_TEST_CASE(cut_discrepancy_needs_cuts_on_both_sides)
{
  const Mesh_facts facts = facts_of_plate(4, 1);
  BOOST_TEST(std::isnan(errors_of(facts, all_in_one, after_1).cut_discrepancy));
  BOOST_TEST(std::isnan(errors_of(facts, after_1, all_in_one).cut_discrepancy));

  // Cuts in two components that do not reach each other
  const Mesh_facts two =
    mesh_facts(mesh_of(test_meshes::disjoint_union(plate(2, 1), plate(2, 1))));
  BOOST_TEST(std::isnan(errors_of(two, {0, 0, 1, 1, 1, 1, 1, 1},
                                  {0, 0, 0, 0, 0, 0, 1, 1}).cut_discrepancy));
}

// A face is cut off at the corner (0, 0) of a plate, below the diagonal from there to (1, 1).
BOOST_AUTO_TEST_CASE(distances_from_cuts_are_along_edges)
{
  const Mesh_facts facts = facts_of_plate(4, 3);
  Labels labels(24, 0);
  labels[0] = 1;
  const std::vector<double> d = distances_from_cuts(facts, labels);
  for (std::size_t v : {0, 1, 6})
    BOOST_TEST(d[v] == 0);
  BOOST_TEST(d[5] == 1, tt::tolerance(tolerance));
  BOOST_TEST(d[19] == 1 + 2 * std::sqrt(2.), tt::tolerance(tolerance));
  BOOST_TEST(distances_from_cuts(facts, Labels(24, 0)) ==
               std::vector<double>(20, std::numeric_limits<double>::infinity()),
             tt::per_element());
}

BOOST_AUTO_TEST_CASE(means_leave_out_undefined_values)
{
  Errors a{}, b{};
  a.rand_error = 1;
  a.cut_discrepancy = undefined;
  b.cut_discrepancy = 3;
  const Errors mean = mean_errors(std::vector<Errors>{a, b});
  BOOST_TEST(mean.rand_error == 0.5);
  BOOST_TEST(mean.cut_discrepancy == 3);
  BOOST_TEST(std::isnan(mean_errors(std::vector<Errors>{a}).cut_discrepancy));
}

BOOST_AUTO_TEST_CASE(usual_number_is_the_smaller_of_ties)
{
  const Labels two = {0, 0, 1, 1}, three = {0, 1, 2, 2}, four = {0, 1, 2, 3};
  BOOST_TEST(usual_number_of_segments({four, three, two, three}) == 3u);
  BOOST_TEST(usual_number_of_segments({four, two, three, four, two}) == 2u);
}

BOOST_AUTO_TEST_CASE(ids_of_the_benchmark)
{
  BOOST_TEST(parse_ids("all").size() == 380u); // 20 springs are not cut
  BOOST_TEST(parse_ids("odd").size() == 190u);
  BOOST_TEST(parse_ids("33,1-3,259-282,399-500") == (std::vector<int>{1, 2, 3, 33, 259, 260, 281,
                                                                      282, 399, 400}),
             tt::per_element());
  for (const char* text : {"", "270", "0", "a", "1-", "1-b", "1 2", "3-1"})
    BOOST_CHECK_THROW(parse_ids(text), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
