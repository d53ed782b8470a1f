// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/Run_control.h>
#include <CGAL/Spectral_segmentation/internal/bipartition/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut_evaluator.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

BOOST_AUTO_TEST_SUITE(best_cut)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using CGAL::Spectral_segmentation::Segmentation_visitor;
using internal::Cut;
using internal::Options;
using internal::Sides;

namespace {

internal::Part whole(const Face_graph& graph)
{
  std::vector<Index> faces(graph.number_of_faces());
  std::iota(faces.begin(), faces.end(), Index(0));
  return {graph, 0, faces};
}

std::vector<Cut> judged_cuts(const Face_graph& graph, const Options& options,
                             std::optional<Cut>& best)
{
  Segmentation_visitor visitor;
  internal::Monitor<Segmentation_visitor> monitor(visitor);
  std::vector<Cut> cuts;
  best = internal::best_cut(sequential, whole(graph), internal::judged_mesh(graph, options), options, monitor,
    [&](const Cut& cut) { cuts.push_back(cut); });
  return cuts;
}

// All values of the options that best_cut() looks at.
std::vector<Options> many_options()
{
  std::vector<Options> result;
  for (bool single_source : {false, true})
    for (std::size_t candidates : {0, 5})
      for (std::size_t refined : {0, 1, 3}) {
        Options o;
        o.minimum_segment_size = 0.02;
        o.single_source_orderings = single_source;
        o.number_of_candidates = candidates;
        o.number_of_refined_candidates = refined;
        result.push_back(o);
      }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(sides_are_connected_if_each_is_one_component_by_itself)
{
  Random random(3);
  std::size_t number_connected = 0;
  for (int i = 0; i < 400; ++i) {
    const Face_graph graph = face_graph_of(plate(1 + random() % 3, 1 + random() % 2));
    Sides side(graph.number_of_faces());
    for (char& s : side)
      s = random() % 2;
    bool expected = true;
    for (const Face_graph& part : internal::split(graph, side, 2)) {
      std::size_t number;
      internal::connected_components(part, number);
      expected = expected && number == 1;
    }
    BOOST_TEST(internal::both_sides_are_connected(graph, side) == expected);
    number_connected += expected;
  }
  BOOST_TEST(number_connected > 50);
  BOOST_TEST(number_connected < 350);
}

BOOST_AUTO_TEST_CASE(every_judged_cut_has_two_connected_sides_that_are_not_too_small)
{
  const Face_graph graph =
    graph_with_distances(dumbbell(20, 16), weights_of_calibrated_method);
  const double area = internal::total_area(graph);
  for (const Options& options : many_options()) {
    std::optional<Cut> best;
    const std::vector<Cut> cuts = judged_cuts(graph, options, best);
    BOOST_TEST_REQUIRE(best.has_value());
    for (const Cut& cut : cuts) {
      BOOST_TEST(internal::both_sides_are_connected(graph, cut.side));
      BOOST_TEST(cut.area[0] >= 0.02 * area);
      BOOST_TEST(cut.area[0] <= cut.area[1]);
      BOOST_TEST(cut.area[0] + cut.area[1] == area, boost::test_tools::tolerance(1e-9));
      BOOST_TEST(cut.salience == options.part_salience(cut.factors));
      BOOST_TEST(internal::quantized(cut.salience) <= internal::quantized(best->salience));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_options_say_how_many_cuts_are_judged)
{
  const Face_graph graph =
    graph_with_distances(dumbbell(20, 16), weights_of_calibrated_method);
  for (const Options& options : many_options()) {
    std::optional<Cut> best;
    const std::size_t number = judged_cuts(graph, options, best).size();
    const std::size_t lines = options.single_source_orderings
      ? 1 + 2 + options.number_of_reference_faces : 1;
    const std::size_t unrefined =
      options.number_of_candidates > 0 ? options.number_of_candidates : lines;
    BOOST_TEST(number >= 1);
    BOOST_TEST(number <= unrefined + options.number_of_refined_candidates);
    if (!options.single_source_orderings && options.number_of_candidates == 0 &&
        options.number_of_refined_candidates == 0)
      BOOST_TEST(number == 1); // the paper
  }
}

BOOST_AUTO_TEST_CASE(more_cuts_to_choose_from_are_no_worse)
{
  for (const Soup& soup : {dumbbell(20, 16), torus(3, 1, 30, 20)}) {
    const Face_graph graph = graph_with_distances(soup, weights_of_calibrated_method);
    const auto salience = [&](bool single_source, std::size_t refined) {
      Options o;
      o.single_source_orderings = single_source;
      o.number_of_refined_candidates = refined;
      std::optional<Cut> best;
      judged_cuts(graph, o, best);
      BOOST_TEST_REQUIRE(best.has_value());
      return internal::quantized(best->salience);
    };
    BOOST_TEST(salience(true, 0) >= salience(false, 0));
    BOOST_TEST(salience(false, 4) >= salience(false, 0));
    BOOST_TEST(salience(true, 4) >= salience(true, 0));
  }
}

BOOST_AUTO_TEST_CASE(a_part_without_room_for_two_segments_is_not_searched)
{
  const Face_graph graph = graph_with_distances(dumbbell(12, 8));
  struct Counter : Segmentation_visitor
  {
    std::size_t number_of_parts = 0;
    void start_part(std::size_t, std::size_t) { ++number_of_parts; }
  } visitor;
  internal::Monitor<Counter> monitor(visitor);
  Options options;
  options.minimum_segment_size = 0.1;
  const auto search = [&](double area_of_mesh) {
    return internal::best_cut(sequential, whole(graph), {area_of_mesh, {}}, options, monitor);
  };
  const double area = internal::total_area(graph);
  BOOST_TEST(!search(5.01 * area).has_value());
  BOOST_TEST(visitor.number_of_parts == 0);
  BOOST_TEST(search(area).has_value());
  BOOST_TEST(visitor.number_of_parts == 1);
}

BOOST_AUTO_TEST_SUITE_END()
