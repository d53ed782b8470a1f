// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>
#include <CGAL/Spectral_segmentation/internal/search/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/search/recursion.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(recursion)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

namespace {

typedef Segmentation_hierarchy::Cut_state Cut_state;

const double infinity = std::numeric_limits<double>::infinity();
const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

struct Result
{
  std::size_t number_of_segments;
  Labels labels;
  Segmentation_hierarchy hierarchy;
};

template <class ConcurrencyTag = CGAL::Parallel_if_available_tag>
Result segment(const Mesh& mesh, double threshold, std::size_t maximum = unlimited,
               double minimum_size = 0.005)
{
  Result r;
  r.labels.resize(num_faces(mesh));
  r.number_of_segments = CGAL::segment_spectral_recursive<ConcurrencyTag>(
    mesh, boost::make_iterator_property_map(r.labels.begin(), get(CGAL::face_index, mesh)),
    parameters::zhang_liu_2005().salience_threshold(threshold).maximum_number_of_segments(maximum)
      .minimum_segment_size(minimum_size).hierarchy(r.hierarchy));
  return r;
}

bool is_accepted(const Segmentation_hierarchy& hierarchy, std::size_t i)
{ return hierarchy.node(i).cut_state == Cut_state::CUT; }

} // namespace

// The over-segmentation of the calibrated method.

namespace {

namespace internal = CGAL::Spectral_segmentation::internal;

// Notes the candidates, and which parts were cut.
struct Search_record : internal::Run_control
{
  std::vector<std::size_t> cut;
  std::vector<double> saliences;
  std::size_t number_of_searches = 0;
  std::size_t questions_left = unlimited;

  void before_part(std::size_t, std::size_t) override { ++number_of_searches; }
  void after_cut(std::size_t part, const CGAL::Spectral_segmentation::Salience_factors&,
                 double salience, std::size_t) override
  {
    cut.push_back(part);
    saliences.push_back(salience);
  }
  bool go_further() override { return questions_left > 0 && questions_left-- > 0; }
};

internal::Cut_hierarchy over_segmentation(const Surface& graph,
                                          const CGAL::Spectral_segmentation::Options& options,
                                          std::size_t least_number, Search_record& record)
{
  internal::Run_monitor monitor(record);
  const internal::Calibrated_cut best_cut(graph, options);
  return internal::hierarchy_of(
    internal::Recursion(sequential, graph, best_cut, options, monitor).by_salience(least_number));
}

} // namespace

BOOST_AUTO_TEST_CASE(the_most_salient_of_all_cuts_is_made_next)
{
  Random random(1);
  const Surface graph = graph_with_distances(
    disjoint_union(displaced(dumbbell(16, 12), 0.02, random), moved(torus(2, 0.7, 14, 8), 9, 0, 0)),
    weights_of_calibrated_method);
  CGAL::Spectral_segmentation::Options options;
  options.keep_components_separate = true; // else cuts of the smaller one count less
  options.number_of_searches = 1; // so that parts are numbered from 0 on
  Search_record record;
  const internal::Cut_hierarchy result =
    over_segmentation(graph, options, 9, record);
  BOOST_TEST(result.number_of_roots == 2u);
  BOOST_TEST(result.number_of_segments() == 9u + 1); // one more for the second component
  BOOST_TEST(result.cut_order == record.cut, boost::test_tools::per_element());
  BOOST_TEST(record.number_of_searches > record.cut.size());

  // Each leaf is searched by itself, which shows how salient its cut would be.
  const internal::Calibrated_cut best_cut(graph, options);
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  const internal::Nested_ranges faces(result);
  internal::Part_extractor extract(graph);
  std::vector<double> salience(result.nodes.size(), -infinity);
  for (std::size_t i = 0; i < result.nodes.size(); ++i) {
    std::vector<Index> of_node(faces[i].begin(), faces[i].end());
    std::sort(of_node.begin(), of_node.end());
    const auto cut = best_cut(sequential, {extract(of_node), i, of_node}, monitor);
    if (cut)
      salience[i] = internal::quantized(cut->salience);
    BOOST_TEST((cut.has_value() || result.nodes[i].is_leaf()));
  }
  std::set<std::size_t> leaves = {0, 1};
  for (std::size_t i = 0; i < result.cut_order.size(); ++i) {
    const std::size_t node = result.cut_order[i];
    BOOST_TEST(internal::quantized(record.saliences[i]) == salience[node]);
    BOOST_TEST(leaves.erase(node) == 1u);
    for (std::size_t leaf : leaves)
      BOOST_TEST(salience[leaf] <= salience[node]);
    const auto& children = result.nodes[node].children;
    leaves.insert(children, children + 2);
  }
  for (Index leaf : result.leaf)
    BOOST_TEST(leaves.count(leaf) == 1u);
}

BOOST_AUTO_TEST_CASE(a_maximum_asks_for_as_many_regions)
{
  const Surface graph = graph_with_distances(dumbbell(16, 12), weights_of_calibrated_method);
  CGAL::Spectral_segmentation::Options options;
  for (std::size_t maximum : {1, 3, 4, 7}) {
    options.maximum_number_of_segments = maximum;
    Search_record record;
    BOOST_TEST(over_segmentation(graph, options, 4, record).number_of_segments() ==
               std::max<std::size_t>(maximum, 4));
  }
}

BOOST_AUTO_TEST_CASE(a_stopped_search_leaves_the_cuts_that_were_made)
{
  const Surface graph = graph_with_distances(dumbbell(16, 12), weights_of_calibrated_method);
  const CGAL::Spectral_segmentation::Options options;
  Search_record all;
  over_segmentation(graph, options, 6, all);
  std::size_t last = 0;
  for (std::size_t questions : {0, 1, 20, 60, 100}) {
    Search_record record;
    record.questions_left = questions;
    const internal::Cut_hierarchy result =
      over_segmentation(graph, options, 6, record);
    BOOST_TEST(result.number_of_segments() == 1 + record.cut.size());
    BOOST_TEST_REQUIRE(record.cut.size() <= all.cut.size());
    BOOST_TEST(std::equal(record.cut.begin(), record.cut.end(), all.cut.begin()));
    BOOST_TEST(record.cut.size() >= last);
    last = record.cut.size();
  }
  BOOST_TEST(last > 0u);
}

// The recursion of the paper, by its run.

BOOST_AUTO_TEST_CASE(parts_are_cut_in_the_order_of_their_area)
{
  for (const char* name : {"elephant.off", "hand.off", "bones.off", "head.off"}) {
    BOOST_TEST_CONTEXT(name) {
      const Segmentation_hierarchy hierarchy = segment(mesh_of(read(name)), 0.4, 20).hierarchy;
      std::set<std::size_t> leaves;
      for (std::size_t i = 0; i < hierarchy.number_of_roots(); ++i)
        leaves.insert(i);
      for (std::size_t child = hierarchy.number_of_roots(); child < hierarchy.number_of_nodes();
           child += 2) {
        const std::size_t cut = hierarchy.node(child).parent;
        BOOST_TEST(leaves.erase(cut) == 1);
        for (std::size_t leaf : leaves)
          if (hierarchy.node(leaf).area > hierarchy.node(cut).area)
            BOOST_TEST((hierarchy.node(leaf).cut_state == Cut_state::NO_CUT ||
                        hierarchy.node(leaf).cut_state == Cut_state::REJECTED));
        leaves.insert({child, child + 1});
      }
      BOOST_TEST(leaves.size() == hierarchy.number_of_segments());
    }
  }
}

BOOST_AUTO_TEST_CASE(the_threshold_decides)
{
  const Mesh mesh = mesh_of(read("elephant.off"));
  for (double threshold : {-infinity, 0.3, 0.5, 0.7, infinity}) {
    BOOST_TEST_CONTEXT("threshold " << threshold) {
      const Segmentation_hierarchy hierarchy = segment(mesh, threshold).hierarchy;
      for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
        const Segmentation_hierarchy::Node& n = hierarchy.node(i);
        BOOST_TEST(n.is_leaf() == !is_accepted(hierarchy, i));
        BOOST_TEST((n.cut_state != Cut_state::NOT_SEARCHED));
        if (n.cut_state == Cut_state::CUT)
          BOOST_TEST(n.salience >= threshold);
        if (n.cut_state == Cut_state::REJECTED)
          BOOST_TEST(n.salience < threshold);
      }
      if (threshold == infinity)
        BOOST_TEST(hierarchy.number_of_segments() == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_maximum_number_of_segments_is_met_but_not_exceeded)
{
  const Mesh mesh = mesh_of(read("hand.off"));
  const std::size_t all = segment(mesh, 0.4).number_of_segments;
  BOOST_TEST(all > 3);
  for (std::size_t n = 1; n <= all + 2; ++n) {
    const Result r = segment(mesh, 0.4, n);
    BOOST_TEST(r.number_of_segments == (std::min)(n, all));
    BOOST_TEST(r.number_of_segments == r.hierarchy.number_of_segments());
    BOOST_TEST(r.number_of_segments == 1 + *std::max_element(r.labels.begin(), r.labels.end()));
  }
}

BOOST_AUTO_TEST_CASE(components_are_parts_from_the_start)
{
  const Mesh mesh = mesh_of(disjoint_union(separate_triangles(300), dumbbell(16, 12)));
  Labels expected(num_faces(mesh));
  const std::size_t n = CGAL::Polygon_mesh_processing::connected_components(
    mesh, boost::make_iterator_property_map(expected.begin(), get(CGAL::face_index, mesh)));
  BOOST_TEST(n == 301);

  for (std::size_t maximum : {std::size_t(1), std::size_t(5), n}) {
    const Result r = segment(mesh, -infinity, maximum);
    BOOST_TEST(r.number_of_segments == n);
    BOOST_TEST(r.hierarchy.number_of_roots() == n);
    BOOST_TEST(r.labels == expected, boost::test_tools::per_element());
  }

  const Result r = segment(mesh, -infinity, n + 1);
  BOOST_TEST(r.number_of_segments == n + 1);
  BOOST_TEST(is_accepted(r.hierarchy, n - 1));
}

BOOST_AUTO_TEST_CASE(no_part_is_smaller_than_the_minimum)
{
  const Mesh mesh = mesh_of(read("elephant.off"));
  std::size_t number_before = num_faces(mesh);
  for (double minimum : {0.001, 0.01, 0.1, 0.5}) {
    const Segmentation_hierarchy hierarchy = segment(mesh, -infinity, unlimited, minimum).hierarchy;
    BOOST_TEST(hierarchy.number_of_segments() < number_before);
    number_before = hierarchy.number_of_segments();
    for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i)
      BOOST_TEST(hierarchy.node(i).area >= minimum * (1 - 1e-9) * hierarchy.node(0).area);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(the_number_of_threads_changes_nothing)
{
  const Soup several = disjoint_union(dumbbell(20, 16), disjoint_union(read("pig.off"),
                                                                       separate_triangles(20)));
  for (const Mesh& mesh : {mesh_of(read("hand.off")), mesh_of(several)})
    for (std::size_t maximum : {std::size_t(7), unlimited}) {
      const Result expected = segment<CGAL::Sequential_tag>(mesh, 0.4, maximum);
      for (int threads : {2, 4}) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        tbb::task_arena arena(threads); // more threads than cores, too
        const Result r = arena.execute([&]
          { return segment<CGAL::Parallel_tag>(mesh, 0.4, maximum); });
        BOOST_TEST(r.labels == expected.labels, boost::test_tools::per_element());
        BOOST_TEST_REQUIRE(r.hierarchy.number_of_nodes() == expected.hierarchy.number_of_nodes());
        for (std::size_t i = 0; i < r.hierarchy.number_of_nodes(); ++i) {
          BOOST_TEST(r.hierarchy.node(i).salience == expected.hierarchy.node(i).salience);
          BOOST_TEST((r.hierarchy.node(i).cut_state == expected.hierarchy.node(i).cut_state));
        }
      }
    }
}
#endif

BOOST_AUTO_TEST_SUITE_END()
