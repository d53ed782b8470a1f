// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut_evaluator.h>
#include <CGAL/Spectral_segmentation/internal/search/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

BOOST_AUTO_TEST_SUITE(best_cut)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Cut;
using CGAL::Spectral_segmentation::Options;
using internal::Sides;

namespace {

internal::Part whole(const Surface& graph)
{
  std::vector<Index> faces(graph.number_of_faces());
  std::iota(faces.begin(), faces.end(), Index(0));
  return {graph, 0, faces};
}

struct Search_options : Options, internal::Method_constants
{
  Search_options(const Options& o = Options())
    : Options(o), Method_constants(internal::constants_of(o.method)) {}
};

// Returns the search of the method that the options have.
std::unique_ptr<internal::Best_cut> search_of(const Surface& graph, const Search_options& options)
{
  if (options.method == CGAL::Spectral_segmentation::Method::ZHANG_LIU_2005)
    return std::make_unique<internal::Paper_cut>(graph, options);
  return std::make_unique<internal::Calibrated_cut>(graph, options, options);
}

std::vector<Cut> compared_cuts(const Surface& graph, const Search_options& options)
{
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  return search_of(graph, options)->compared_cuts(sequential, whole(graph), monitor);
}

std::optional<Cut> best_cut_of(const Surface& graph, const Search_options& options)
{
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  return (*search_of(graph, options))(sequential, whole(graph), monitor);
}

// The paper's method, and the calibrated one with several constants.
std::vector<Search_options> many_options()
{
  std::vector<Search_options> result(1, Options::zhang_liu_2005());
  for (std::size_t refined : {0, 1, 4}) {
    Search_options o;
    o.number_of_refined_candidates = refined;
    result.push_back(o);
  }
  for (Search_options& o : result)
    o.minimum_segment_size = 0.02;
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(sides_are_connected_if_each_is_one_component_by_itself)
{
  Random random(3);
  std::size_t number_connected = 0;
  for (int i = 0; i < 400; ++i) {
    const Surface graph = surface_of(plate(1 + random() % 3, 1 + random() % 2));
    Sides side(graph.number_of_faces());
    for (char& s : side)
      s = random() % 2;
    bool expected = true;
    for (const Surface& part : internal::split(graph, side, 2))
      expected = expected && internal::connected_components(part).number == 1;
    BOOST_TEST(internal::both_sides_are_connected(graph, side) == expected);
    number_connected += expected;
  }
  BOOST_TEST(number_connected > 50);
  BOOST_TEST(number_connected < 350);
}

BOOST_AUTO_TEST_CASE(every_compared_cut_has_two_connected_sides_that_are_not_too_small)
{
  const Surface graph = graph_with_distances(dumbbell(20, 16), weights_of_calibrated_method);
  const double area = internal::total_area(graph);
  for (const Search_options& options : many_options()) {
    const std::vector<Cut> cuts = compared_cuts(graph, options);
    BOOST_TEST_REQUIRE(!cuts.empty());
    const std::optional<Cut> best = best_cut_of(graph, options);
    BOOST_TEST_REQUIRE(best.has_value());
    BOOST_TEST((best->side == cuts.front().side));
    for (const Cut& cut : cuts) {
      BOOST_TEST(internal::both_sides_are_connected(graph, cut.side));
      BOOST_TEST_REQUIRE(cut.side.size() == graph.number_of_faces());
      double areas[2] = {0, 0};
      for (Index f = 0; f < cut.side.size(); ++f)
        areas[int(cut.side[f])] += graph.areas[f];
      for (int side : {0, 1})
        BOOST_TEST(cut.area[side] == areas[side], boost::test_tools::tolerance(1e-9));
      BOOST_TEST(areas[0] >= 0.02 * area * (1 - 1e-9));
      BOOST_TEST(areas[0] <= areas[1] * (1 + 1e-9));
      BOOST_TEST(cut.factors.size == areas[0] / area, boost::test_tools::tolerance(1e-9));
      BOOST_TEST(std::abs(cut.factors.log_relative_part_area) < 1e-9);
      BOOST_TEST(!cut.factors.is_boundary);
      BOOST_TEST(cut.salience == options.part_salience(cut.factors));
      BOOST_TEST(internal::quantized(cut.salience) <= internal::quantized(best->salience));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_constants_say_how_many_cuts_are_compared)
{
  const Surface graph = graph_with_distances(dumbbell(20, 16), weights_of_calibrated_method);
  for (const Search_options& options : many_options()) {
    const std::size_t number = compared_cuts(graph, options).size();
    BOOST_TEST(number >= 1u);
    if (options.method == CGAL::Spectral_segmentation::Method::ZHANG_LIU_2005)
      BOOST_TEST(number == 1u);
    else // four proposals from each end of the line
      BOOST_TEST(number <= 8 + options.number_of_refined_candidates);
  }
}

BOOST_AUTO_TEST_CASE(the_cut_of_the_paper_is_the_best_along_its_one_order)
{
  const Surface graph = graph_with_distances(dumbbell(20, 16));
  const Options options = Options::zhang_liu_2005();
  const std::optional<Cut> best = best_cut_of(graph, options);
  BOOST_TEST_REQUIRE(best.has_value());
  const internal::Shape_contexts contexts =
    internal::shape_contexts(graph, internal::farthest_face_from_center(sequential, graph),
                             options.number_of_reference_faces, [] {});
  const auto order =
    internal::face_order(sequential, graph, internal::sample_faces(sequential, contexts));
  const std::optional<Cut> expected =
    internal::line_search(sequential, graph, order, options.part_salience,
                          options.minimum_segment_size * internal::total_area(graph));
  BOOST_TEST_REQUIRE(expected.has_value());
  BOOST_TEST((best->side == expected->side));
  BOOST_TEST(best->salience == expected->salience);
}

BOOST_AUTO_TEST_CASE(more_cuts_to_choose_from_are_no_worse)
{
  for (const Soup& soup : {dumbbell(20, 16), torus(3, 1, 30, 20)}) {
    const Surface graph = graph_with_distances(soup, weights_of_calibrated_method);
    const auto salience = [&](std::size_t refined) {
      Search_options o;
      o.number_of_refined_candidates = refined;
      const std::optional<Cut> best = best_cut_of(graph, o);
      BOOST_TEST_REQUIRE(best.has_value());
      return internal::quantized(best->salience);
    };
    BOOST_TEST(salience(4) >= salience(1));
    BOOST_TEST(salience(1) >= salience(0));
  }
}

BOOST_AUTO_TEST_CASE(a_part_without_room_for_two_segments_is_not_searched)
{
  const Surface part = graph_with_distances(dumbbell(12, 8));
  struct Counter : internal::Run_control
  {
    std::size_t number_of_parts = 0;
    void before_part(std::size_t, std::size_t) override { ++number_of_parts; }
  } counter;
  internal::Run_monitor monitor(counter);
  Options options = Options::zhang_liu_2005();
  const auto search = [&](double minimum_fraction_of_part) {
    options.minimum_segment_size = minimum_fraction_of_part;
    return internal::Paper_cut(part, options)(sequential, whole(part), monitor);
  };
  BOOST_TEST(!search(0.501).has_value());
  BOOST_TEST(counter.number_of_parts == 0u);
  BOOST_TEST(search(0.1).has_value());
  BOOST_TEST(counter.number_of_parts == 1u);

  // The minimum is a fraction of the area of the mesh, not of the part.
  Surface mesh = part;
  for (double& area : mesh.areas)
    area *= 5.01;
  options.minimum_segment_size = 0.1;
  const internal::Paper_cut best_cut(mesh, options);
  BOOST_TEST(!best_cut(sequential, whole(part), monitor).has_value());
  BOOST_TEST(counter.number_of_parts == 1u);
}

BOOST_AUTO_TEST_CASE(a_stopped_search_throws)
{
  const Surface graph = graph_with_distances(dumbbell(12, 8));
  struct Stopper : internal::Run_control
  {
    int left = 0;
    bool go_further() override { return left-- > 0; }
  } stopper;
  const Options options = Options::zhang_liu_2005();
  const internal::Paper_cut best_cut(graph, options);
  for (int questions : {0, 1, 4}) {
    stopper.left = questions;
    internal::Run_monitor monitor(stopper);
    BOOST_CHECK_THROW(best_cut(sequential, whole(graph), monitor), internal::Run_stopped);
  }
}

BOOST_AUTO_TEST_SUITE_END()
