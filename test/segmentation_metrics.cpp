// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../benchmark/consensus_floor.h"
#include "../benchmark/segmentation_metrics.h"
#include "test_meshes.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
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

// The same for all partitions of the faces, each once; labels in order of appearance.
void for_each_partition(std::size_t n, const std::function<void(const Labels&)>& f,
                        Labels labels = {}, std::size_t number = 0)
{
  if (labels.size() == n)
    return f(labels);
  for (std::size_t label = 0; label <= number; ++label) {
    labels.push_back(label);
    for_each_partition(n, f, labels, std::max(number, label + 1));
    labels.pop_back();
  }
}

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
  for (double error : errors_of(facts, after_1_and_2, renumbered))
    BOOST_TEST(error == 0);
}

// The benchmark's program counts 8 * 3 pairs. The 2 * 2 and 2 * 4 pairs with a face of the second
// square are judged otherwise.
BOOST_AUTO_TEST_CASE(rand_error_by_hand)
{
  BOOST_TEST(rand_error(after_1, after_2) == (2 * 2 + 2 * 4) / 24., tt::tolerance(tolerance));
  BOOST_TEST(rand_error(all_in_one, after_2) == 4 * 4 / 24., tt::tolerance(tolerance));
  BOOST_TEST(rand_error(Labels{0, 0, 0}, Labels{0, 0, 1}) == 2 / 3., tt::tolerance(tolerance));
}

BOOST_AUTO_TEST_CASE(rand_error_is_that_of_all_pairs)
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

// Parts of the reference lie in: the first square in part 0 of after_1, the rest in 1. What after_1
// misses is the second square's area 1 of 4; so is what it adds to the second part.
BOOST_AUTO_TEST_CASE(hamming_distance_by_hand)
{
  const Mesh_facts facts = facts_of_plate(4, 1);
  const Errors shifted = errors_of(facts, after_1, after_2);
  BOOST_TEST(shifted[MISSING_RATE] == 0.25, tt::tolerance(tolerance));
  BOOST_TEST(shifted[FALSE_ALARM_RATE] == 0.25, tt::tolerance(tolerance));
  BOOST_TEST(shifted[HAMMING] == 0.25, tt::tolerance(tolerance));

  // One part in all misses nothing, and adds all but the largest part of the reference.
  const Errors coarse = errors_of(facts, all_in_one, after_1_and_2);
  BOOST_TEST(coarse[MISSING_RATE] == 0);
  BOOST_TEST(coarse[FALSE_ALARM_RATE] == 0.5, tt::tolerance(tolerance));
  BOOST_TEST(coarse[HAMMING] == 0.25, tt::tolerance(tolerance));
}

// The parts of after_2 have two squares each. The first one has 1 of 2 squares in common with the
// first part of after_1; the second one has 2 of 3 in common with the other part.
BOOST_AUTO_TEST_CASE(greatest_overlaps_by_hand)
{
  const std::vector<double> areas(8, 0.5);
  const Eigen::ArrayXd same = greatest_overlaps(overlap(after_2, after_2, areas));
  BOOST_TEST_REQUIRE(same.size() == 2);
  BOOST_TEST(same(0) == 1);
  BOOST_TEST(same(1) == 1);
  const Eigen::ArrayXd shifted = greatest_overlaps(overlap(after_1, after_2, areas));
  BOOST_TEST_REQUIRE(shifted.size() == 2);
  BOOST_TEST(shifted(0) == 1 / 2., tt::tolerance(tolerance));
  BOOST_TEST(shifted(1) == 2 / 3., tt::tolerance(tolerance));
}

// In after_1 the second square, in a part of 3, is without the 2 squares behind it, which
// themselves are without 1: (0 + 2/3 + 1/3 + 1/3) / 4. In after_2 each of the first two squares is
// without the other: (1/2 + 1/2) / 4. The smaller error of each square: 0, 1/2, 0, 0.
BOOST_AUTO_TEST_CASE(consistency_errors_by_hand)
{
  const Errors e = errors_of(facts_of_plate(4, 1), after_1, after_2);
  for (Metric metric : {GCE, GCE_FACES})
    BOOST_TEST(e[metric] == 0.25, tt::tolerance(tolerance));
  for (Metric metric : {LCE, LCE_FACES})
    BOOST_TEST(e[metric] == 0.125, tt::tolerance(tolerance));
}

// A refinement is consistent, and so is a trivial segmentation.
BOOST_AUTO_TEST_CASE(refinements_are_consistent)
{
  const Mesh_facts facts = facts_of_plate(4, 1);
  const Labels one_a_face = {0, 1, 2, 3, 4, 5, 6, 7};
  for (const Labels& fine : {after_1_and_2, one_a_face})
    for (const Labels& coarse : {after_2, all_in_one}) {
      const Errors e = errors_of(facts, fine, coarse);
      for (Metric metric : {GCE, LCE, GCE_FACES, LCE_FACES})
        BOOST_TEST(e[metric] == 0);
    }
}

// Two large faces and four of a quarter of their size: the labels differ in a large and a small
// face by number alike, by area not.
BOOST_AUTO_TEST_CASE(areas_weigh_where_the_benchmark_says_so)
{
  Mesh_facts facts;
  facts.face_areas = {4, 4, 1, 1, 1, 1};
  facts.average_radius = 1;
  const Labels reference = {0, 0, 1, 1, 1, 1};
  const Errors large = errors_of(facts, {0, 1, 1, 1, 1, 1}, reference);
  const Errors small = errors_of(facts, {0, 0, 0, 1, 1, 1}, reference);

  // Pairs that are judged otherwise: of the moved face with its old and with its new part.
  BOOST_TEST(large[RAND_ERROR] == (1 + 4) / 12., tt::tolerance(tolerance));
  BOOST_TEST(small[RAND_ERROR] == (3 + 2) / 12., tt::tolerance(tolerance));
  BOOST_TEST(large[MISSING_RATE] == 4 / 12., tt::tolerance(tolerance));
  BOOST_TEST(small[MISSING_RATE] == 1 / 12., tt::tolerance(tolerance));

  // small, by face, by area: in the reference the moved face lacks 3/4 of its part, three others
  // 1/4; in the result, it lacks 8/9 and two others 1/9.
  BOOST_TEST(small[GCE] == (8 / 9. + 2 / 9.) / 6, tt::tolerance(tolerance));
  BOOST_TEST(small[LCE] == (3 / 4.) / 6, tt::tolerance(tolerance));
  // By number, 2/3 and two times 1/3, against the same 3/4 and three times 1/4.
  BOOST_TEST(small[GCE_FACES] == (2 / 3. + 2 / 3.) / 6, tt::tolerance(tolerance));
  BOOST_TEST(small[LCE_FACES] == (2 / 3.) / 6, tt::tolerance(tolerance));
}

BOOST_AUTO_TEST_CASE(all_but_the_rates_are_symmetric)
{
  const Mesh_facts facts = mesh_facts(mesh_of(test_meshes::sphere(1)));
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const Labels a = random_labels(80, 5, random), b = random_labels(80, 3, random);
    const Errors ab = errors_of(facts, a, b), ba = errors_of(facts, b, a);
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    for (Metric metric : {RAND_ERROR, HAMMING, GCE, LCE, GCE_FACES, LCE_FACES, CUT_DISCREPANCY})
      BOOST_TEST(ab[metric] == ba[metric], tt::tolerance(tolerance));
    BOOST_TEST(ab[MISSING_RATE] == ba[FALSE_ALARM_RATE], tt::tolerance(tolerance));
    BOOST_TEST(ab[LCE] <= ab[GCE]);
    BOOST_TEST(ab[LCE_FACES] <= ab[GCE_FACES]);
  }
}

// The cut of each side has two vertices, at distance 1 from those of the other.
BOOST_AUTO_TEST_CASE(cut_discrepancy_by_hand)
{
  const Mesh_facts facts = facts_of_plate(4, 1);
  BOOST_TEST(errors_of(facts, after_1, after_2)[CUT_DISCREPANCY] == 1 / facts.average_radius,
             tt::tolerance(tolerance));

  // Only the two of the 2 + 4 vertices at x = 1 are away from the other side's cut.
  BOOST_TEST(errors_of(facts, after_2, after_1_and_2)[CUT_DISCREPANCY] ==
               2. / 6 / facts.average_radius, tt::tolerance(tolerance));
}

BOOST_AUTO_TEST_CASE(cut_discrepancy_needs_cuts_on_both_sides)
{
  const Mesh_facts facts = facts_of_plate(4, 1);
  BOOST_TEST(std::isnan(errors_of(facts, all_in_one, after_1)[CUT_DISCREPANCY]));
  BOOST_TEST(std::isnan(errors_of(facts, after_1, all_in_one)[CUT_DISCREPANCY]));

  // Cuts in two components that do not reach each other
  const Mesh_facts two =
    mesh_facts(mesh_of(test_meshes::disjoint_union(plate(2, 1), plate(2, 1))));
  BOOST_TEST(std::isnan(errors_of(two, {0, 0, 1, 1, 1, 1, 1, 1},
                                  {0, 0, 0, 0, 0, 0, 1, 1})[CUT_DISCREPANCY]));
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

BOOST_AUTO_TEST_CASE(means_leave_out_what_is_undefined)
{
  Errors a{}, b{};
  a[RAND_ERROR] = 1;
  a[CUT_DISCREPANCY] = undefined;
  b[CUT_DISCREPANCY] = 3;
  const Errors mean = mean_errors(std::vector<Errors>{a, b});
  BOOST_TEST(mean[RAND_ERROR] == 0.5);
  BOOST_TEST(mean[CUT_DISCREPANCY] == 3);
  BOOST_TEST(std::isnan(mean_errors(std::vector<Errors>{a})[CUT_DISCREPANCY]));
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

BOOST_AUTO_TEST_CASE(people_who_agree_leave_no_floor)
{
  BOOST_TEST(consensus_floor({after_2, after_2, after_2}) == 0);
}

// The bound is never below the floor, which is found by trying all partitions, and nearly always
// on it.
BOOST_AUTO_TEST_CASE(consensus_floor_is_an_upper_bound)
{
  int number_reached = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::vector<Labels> people;
    for (int person = 0; person < 5; ++person)
      people.push_back(random_labels(7, 3, random));
    double least = 1;
    for_each_partition(7, [&](const Labels& labels)
                       { least = std::min(least, mean_rand_error(labels, people)); });
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    const double floor = consensus_floor(people);
    BOOST_TEST(floor > least - tolerance);
    number_reached += floor < least + tolerance;
    for (const Labels& person : people)
      BOOST_TEST(floor <= mean_rand_error(person, people));
  }
  BOOST_TEST(number_reached >= 18);
}

// Whole segments of people remain the atoms if only few may be kept.
BOOST_AUTO_TEST_CASE(small_atoms_join_the_atom_they_are_most_like)
{
  Atoms atoms = all_atoms({{0, 0, 0, 0, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 0}});
  BOOST_TEST(atoms.atom_of_face == (Labels{0, 0, 0, 0, 1, 1, 2}), tt::per_element());
  BOOST_TEST(atoms.sizes == (std::vector<double>{4, 2, 1}), tt::per_element());
  absorb_small_atoms(atoms, 2);
  BOOST_TEST(atoms.atom_of_face == (Labels{0, 0, 0, 0, 1, 1, 0}), tt::per_element());
  BOOST_TEST(atoms.sizes == (std::vector<double>{5, 2}), tt::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
