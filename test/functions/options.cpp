// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/segment_spectral_recursive.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

BOOST_AUTO_TEST_SUITE(options)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Calibrated_part_salience;
using CGAL::Spectral_segmentation::Method;
using CGAL::Spectral_segmentation::Option_description;
using CGAL::Spectral_segmentation::Options;
using CGAL::Spectral_segmentation::Salience_factors;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using CGAL::Spectral_segmentation::Weighted_part_salience;

namespace {

const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

Labels labels_of_options(const Options& o, const Mesh& mesh = mesh_of(doll()))
{ return labels_of(mesh, parameters::options(o)); }

template <class NamedParameters>
void check_equal(const Options& o, const NamedParameters& np)
{
  BOOST_TEST(labels_of_options(o) == labels_of(mesh_of(doll()), np),
             boost::test_tools::per_element());
}

// `change` puts a field out of its range, and the message names the option.
template <class Change>
void check_refused(const std::string& name, const Change& change, Options o = Options())
{
  const auto names_it = [&](const std::invalid_argument& e)
  { return std::string(e.what()).find(name + " must be ") != std::string::npos; };
  BOOST_TEST_CONTEXT(name) {
    BOOST_CHECK_NO_THROW(check(o));
    change(o);
    BOOST_CHECK_EXCEPTION(check(o), std::invalid_argument, names_it);
    BOOST_CHECK_EXCEPTION(labels_of_options(o), std::invalid_argument, names_it);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(presets_are_the_methods)
{
  check_equal(Options(), parameters::default_values());
  check_equal(Options::zhang_liu_2005(), parameters::zhang_liu_2005());
}

BOOST_AUTO_TEST_CASE(the_defaults_are_those_that_are_documented)
{
  const Options o;
  const Options paper = Options::zhang_liu_2005();
  for (const Options& both : {o, paper}) {
    BOOST_TEST(!both.number_of_segments);
    BOOST_TEST(both.maximum_number_of_segments == (std::numeric_limits<std::size_t>::max)());
    BOOST_TEST(!both.salience_threshold);
    BOOST_TEST(both.feature_weight == 0.5);
    BOOST_TEST(both.number_of_smoothing_iterations == 0u);
    BOOST_TEST(both.concave_angle_weight == 1);
    BOOST_TEST(both.convex_angle_weight == 0.1);
    BOOST_TEST(!both.random_seed);
  }
  BOOST_TEST(threshold_of(o) == 0.4);
  BOOST_TEST(!o.keep_components_separate);
  BOOST_TEST(o.minimum_segment_size == 0.003);
  BOOST_TEST((o.part_salience.target<Calibrated_part_salience>() != nullptr));
  BOOST_TEST(o.number_of_coarse_faces == 3400u);
  BOOST_TEST(o.number_of_searches == 5u);
  BOOST_TEST(o.number_of_reference_faces == 3u);
  BOOST_TEST(o.geodesic_weight == 0.03);
  BOOST_TEST(threshold_of(paper) == 0.54);
  BOOST_TEST(paper.keep_components_separate);
  BOOST_TEST(paper.minimum_segment_size == 0.005);
  BOOST_TEST(paper.number_of_coarse_faces == 0u);
  BOOST_TEST(paper.number_of_searches == 1u);
  BOOST_TEST(paper.number_of_reference_faces == 10u);
  BOOST_TEST(paper.geodesic_weight == 0.01);
  const auto* weights = paper.part_salience.target<Weighted_part_salience>();
  BOOST_TEST_REQUIRE(weights);
  BOOST_TEST(weights->alpha == 0.1);
  BOOST_TEST(weights->beta == 0.6);
  BOOST_TEST(weights->gamma == 0.3);
}

BOOST_AUTO_TEST_CASE(fields_have_the_effects_of_named_parameters)
{
  Options o;
  o.number_of_segments = 9;
  o.random_seed = 5;
  check_equal(o, parameters::number_of_segments(9).random_seed(5));

  o = Options();
  o.maximum_number_of_segments = 6;
  o.salience_threshold = -infinity;
  o.minimum_segment_size = 0.02;
  o.keep_components_separate = true;
  o.number_of_coarse_faces = 300;
  o.number_of_searches = 2;
  o.number_of_smoothing_iterations = 2;
  check_equal(o, parameters::maximum_number_of_segments(6).salience_threshold(-infinity)
                   .minimum_segment_size(0.02).keep_components_separate(true)
                   .number_of_coarse_faces(300).number_of_searches(2)
                   .number_of_smoothing_iterations(2));

  o = Options::zhang_liu_2005();
  o.part_salience = Weighted_part_salience{0.2, 0.3, 0.5};
  o.geodesic_weight = 0.05;
  o.concave_angle_weight = 2;
  o.convex_angle_weight = 0.5;
  o.number_of_reference_faces = 4;
  check_equal(o, parameters::zhang_liu_2005().salience_weights(0.2, 0.3, 0.5)
                   .distance_weights(0.05, 2, 0.5).number_of_reference_faces(4));
}

BOOST_AUTO_TEST_CASE(each_number_has_an_effect)
{
  for (Options o : {Options(), Options::zhang_liu_2005()}) {
    o.salience_threshold = -infinity; // differences do not depend on the default
    o.maximum_number_of_segments = 12;
    const Labels before = labels_of_options(o);
    const auto has_effect = [&](const auto& change) {
      Options changed = o;
      change(changed);
      return labels_of_options(changed) != before;
    };
    BOOST_TEST(has_effect([](Options& c) {
      c.part_salience = [](const Salience_factors& f) { return -f.size; };
    }));
    BOOST_TEST(has_effect([](Options& c)
      { c.part_salience = Weighted_part_salience{0.8, 0.1, 0.1}; }));
    BOOST_TEST(has_effect([](Options& c) { c.minimum_segment_size = 0.3; }));
    BOOST_TEST(has_effect([](Options& c) { c.geodesic_weight = 1; }));
    BOOST_TEST(has_effect([](Options& c)
      { c.concave_angle_weight = 0, c.convex_angle_weight = 1; }));
    BOOST_TEST(has_effect([](Options& c) { c.convex_angle_weight = 5; }));
    BOOST_TEST(has_effect([](Options& c) { c.number_of_reference_faces = 1; }));
    BOOST_TEST(has_effect([](Options& c) { c.number_of_coarse_faces = 100; }));
    BOOST_TEST(has_effect([](Options& c) { c.number_of_smoothing_iterations = 5; }));
    BOOST_TEST(has_effect([](Options& c) { c.salience_threshold = 0.9; }));
    BOOST_TEST(has_effect([](Options& c) { c.maximum_number_of_segments = 1; }));
    if (o.method == Method::CALIBRATED)
      BOOST_TEST(has_effect([](Options& c) {
        c = Options::zhang_liu_2005();
        c.salience_threshold = -infinity;
        c.maximum_number_of_segments = 12;
      }));
  }
}

BOOST_AUTO_TEST_CASE(the_threshold_follows_the_salience)
{
  for (Options o : {Options(), Options::zhang_liu_2005()}) {
    const auto threshold = [&] {
      const double result = threshold_of(o);
      BOOST_TEST(hierarchy_of(mesh_of(doll()), parameters::options(o)).salience_threshold() ==
                 result);
      return result;
    };
    o.part_salience = Weighted_part_salience{0.2, 0.3, 0.5};
    BOOST_TEST(threshold() == 0.54);
    o.part_salience = Calibrated_part_salience();
    BOOST_TEST(threshold() == 0.4);
    o.part_salience = [](const Salience_factors& f) { return f.size; };
    BOOST_TEST(threshold() == 0.4);
    o.salience_threshold = 0.7;
    BOOST_TEST(threshold() == 0.7);
  }
}

BOOST_AUTO_TEST_CASE(only_the_ratio_of_the_angle_weights_matters)
{
  for (Options o : {Options(), Options::zhang_liu_2005()}) {
    o.concave_angle_weight = 8;
    o.convex_angle_weight = 0.5;
    const Labels expected = labels_of_options(o);
    o.concave_angle_weight = 1;
    o.convex_angle_weight = 0.0625;
    BOOST_TEST(labels_of_options(o) == expected, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(named_parameters_change_the_options_that_are_given)
{
  Options o = Options::zhang_liu_2005();
  o.minimum_segment_size = 0.1;
  o.salience_threshold = 0.2;
  BOOST_TEST(labels_of(mesh_of(doll()), parameters::options(o).minimum_segment_size(0.005)
                                          .salience_threshold(0.54)) ==
             labels_of(mesh_of(doll()), parameters::zhang_liu_2005().salience_threshold(0.54)),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(an_exact_number_does_not_use_the_other_limits)
{
  Options o;
  o.number_of_segments = 7;
  o.maximum_number_of_segments = 2;
  o.salience_threshold = infinity;
  BOOST_TEST(number_of(labels_of_options(o)) == 7u);
}

BOOST_AUTO_TEST_CASE(values_out_of_range_are_refused_by_name)
{
  check_refused("number_of_segments", [](Options& o) { o.number_of_segments = 0; });
  check_refused("maximum_number_of_segments", [](Options& o) { o.maximum_number_of_segments = 0; });
  for (double bad : {-0.001, 1.001, not_a_number})
    check_refused("salience_threshold", [&](Options& o) { o.salience_threshold = bad; });
  check_refused("keep_components_separate", [](Options& o) { o.keep_components_separate = false; },
                Options::zhang_liu_2005());
  check_refused("number_of_searches", [](Options& o) { o.number_of_searches = 0; });
  check_refused("number_of_searches", [](Options& o) { o.number_of_searches = 101; });
  check_refused("number_of_searches", [](Options& o) { o.number_of_searches = 2; },
                Options::zhang_liu_2005());
  for (double bad : {-0.001, 0.501, not_a_number})
    check_refused("minimum_segment_size", [&](Options& o) { o.minimum_segment_size = bad; });
  check_refused("part_salience", [](Options& o) { o.part_salience = nullptr; });
  for (double bad : {-0.001, 1.001, not_a_number})
    check_refused("feature_weight", [&](Options& o) { o.feature_weight = bad; });
  const Weighted_part_salience bad_weights[] = {
    {0.1, 0.6, 0.4}, {0, 0, 0}, {-0.1, 0.6, 0.5}, {1.5, -0.5, 0}, {0.5, 0.75, -0.25},
    {not_a_number, 0.5, 0.5}, {infinity, 0, 0}};
  for (const Weighted_part_salience& bad : bad_weights)
    check_refused("salience_weights", [&](Options& o) { o.part_salience = bad; });
  for (double bad : {-0.01, 1.5, infinity, not_a_number})
    check_refused("the first of distance_weights", [&](Options& o) { o.geodesic_weight = bad; });
  for (double bad : {-1., infinity, not_a_number}) {
    check_refused("the second and third of distance_weights",
                  [&](Options& o) { o.concave_angle_weight = bad; });
    check_refused("the second and third of distance_weights",
                  [&](Options& o) { o.convex_angle_weight = bad; });
  }
  check_refused("number_of_reference_faces", [](Options& o) { o.number_of_reference_faces = 0; });
  check_refused("number_of_reference_faces",
                [](Options& o) { o.number_of_reference_faces = 1001; });
  check_refused("number_of_smoothing_iterations",
                [](Options& o) { o.number_of_smoothing_iterations = 100001; });
}

BOOST_AUTO_TEST_CASE(the_ends_of_the_ranges_are_taken)
{
  const auto is_taken = [](const auto& change) {
    Options o;
    change(o);
    BOOST_CHECK_NO_THROW(check(o));
  };
  for (std::size_t least : {0, 1})
    is_taken([&](Options& o) {
      o.number_of_segments = o.maximum_number_of_segments = o.number_of_reference_faces = 1;
      o.number_of_coarse_faces = o.number_of_smoothing_iterations = least;
      o.feature_weight = o.geodesic_weight = double(least);
      o.minimum_segment_size = 0.5 * double(least);
      o.concave_angle_weight = o.convex_angle_weight = least == 0 ? 0 : 1e300;
    });
  is_taken([](Options& o) { o.number_of_reference_faces = 1000; });
  is_taken([](Options& o) { o.number_of_searches = 1; });
  is_taken([](Options& o) { o.number_of_searches = 100; });
  is_taken([](Options& o) { o.number_of_smoothing_iterations = 100000; });
  const Weighted_part_salience weights[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Weighted_part_salience& w : weights)
    is_taken([&](Options& o) { o.part_salience = w; });
}

BOOST_AUTO_TEST_CASE(extreme_values_do_no_harm)
{
  const auto check_segments = [](const auto& change) {
    Options o;
    o.maximum_number_of_segments = 6;
    change(o);
    const Mesh mesh = mesh_of(doll());
    BOOST_TEST(check_labels(mesh, labels_of_options(o, mesh)) <= 6);
  };
  for (double size : {0., 0.5})
    check_segments([&](Options& o)
      { o.salience_threshold = -infinity, o.minimum_segment_size = size; });
  for (double w : {0., 1e-300, 1e300})
    check_segments([&](Options& o) { o.concave_angle_weight = o.convex_angle_weight = w; });
  for (double w : {0., 1.})
    check_segments([&](Options& o) { o.geodesic_weight = w; });
  const Mesh small = mesh_of(dumbbell(8, 6));
  Options o;
  o.number_of_reference_faces = num_faces(small);
  const Labels expected = labels_of_options(o, small);
  ++o.number_of_reference_faces;
  BOOST_TEST(labels_of_options(o, small) == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(thresholds_of_saliences_that_are_no_probabilities_may_be_any_number)
{
  Options custom;
  custom.part_salience = [](const Salience_factors&) { return 3.; };
  for (Options o : {Options::zhang_liu_2005(), custom}) {
    o.salience_threshold = -2;
    BOOST_CHECK_NO_THROW(check(o));
  }
  Options o;
  for (double threshold : {-infinity, 0., 1., infinity}) {
    o.salience_threshold = threshold;
    BOOST_CHECK_NO_THROW(check(o));
  }
}

BOOST_AUTO_TEST_CASE(each_option_has_its_name_kind_and_range)
{
  Options o;
  std::map<std::string, std::string> kinds;
  for_each_option(o, [&](const Option_description& option, auto& value) {
    kinds[option.name] = option.kind;
    BOOST_TEST_CONTEXT(option.name) {
      if (option.name == std::string("minimum_segment_size")) {
        BOOST_TEST((option.least == 0 && option.greatest == 0.5));
        BOOST_CHECK_THROW(option.set(value, 0.6), std::invalid_argument);
        option.set(value, 0.25);
      }
      else if (option.name == std::string("number_of_segments")) {
        BOOST_CHECK_THROW(option.set(value, -1), std::invalid_argument);
        option.set(value, 7);
      }
    }
  });
  BOOST_TEST(o.minimum_segment_size == 0.25);
  BOOST_TEST((o.number_of_segments == 7u));
  BOOST_TEST(kinds.size() == 10u);
  BOOST_TEST(kinds["keep_components_separate"] == "boolean");
  BOOST_TEST(kinds["number_of_reference_faces"] == "integer");
  BOOST_TEST(kinds["feature_weight"] == "number");
}

BOOST_AUTO_TEST_CASE(the_method_of_the_paper_has_no_constraints)
{
  const Mesh mesh = mesh_of(doll());
  const auto seeds = boost::make_function_property_map<Mesh::Face_index, int>(
    [](Mesh::Face_index f) { return f == Mesh::Face_index(0) ? 1 : -1; });
  test_meshes::check_refused(
    mesh, parameters::options(Options::zhang_liu_2005()).face_seed_map(seeds));
}

BOOST_AUTO_TEST_SUITE_END()
