// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

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

typedef std::vector<std::size_t> Labels;
typedef Segmentation_hierarchy::Cut_state Cut_state;

const double infinity = std::numeric_limits<double>::infinity();
const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

struct Result
{
  std::size_t number_of_segments;
  Labels labels;
  Segmentation_hierarchy tree;
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
      .minimum_segment_size(minimum_size).hierarchy(r.tree));
  return r;
}

bool is_accepted(const Segmentation_hierarchy& tree, std::size_t i)
{ return tree.node(i).cut_state == Cut_state::ACCEPTED; }

// Triangles far from each other.
Soup many_components(std::size_t n)
{
  Soup soup;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = 10. * double(i);
    soup.points.insert(soup.points.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1 + double(i % 7), 0}});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

} // namespace

BOOST_AUTO_TEST_CASE(parts_are_cut_in_the_order_of_their_area)
{
  for (const char* name : {"elephant.off", "hand.off", "bones.off", "head.off"}) {
    BOOST_TEST_CONTEXT(name) {
      const Segmentation_hierarchy tree = segment(mesh_of(read(name)), 0.4, 20).tree;
      std::set<std::size_t> leaves;
      for (std::size_t i = 0; i < tree.number_of_roots(); ++i)
        leaves.insert(i);
      for (std::size_t child = tree.number_of_roots(); child < tree.number_of_nodes(); child += 2) {
        const std::size_t cut = tree.node(child).parent;
        BOOST_TEST(leaves.erase(cut) == 1);
        for (std::size_t leaf : leaves)
          if (tree.node(leaf).area > tree.node(cut).area)
            BOOST_TEST((tree.node(leaf).cut_state == Cut_state::NO_CUT ||
                        tree.node(leaf).cut_state == Cut_state::REJECTED));
        leaves.insert({child, child + 1});
      }
      BOOST_TEST(leaves.size() == tree.number_of_segments());
    }
  }
}

BOOST_AUTO_TEST_CASE(the_threshold_decides)
{
  const Mesh mesh = mesh_of(read("elephant.off"));
  for (double threshold : {-infinity, 0.3, 0.5, 0.7, infinity}) {
    BOOST_TEST_CONTEXT("threshold " << threshold) {
      const Segmentation_hierarchy tree = segment(mesh, threshold).tree;
      for (std::size_t i = 0; i < tree.number_of_nodes(); ++i) {
        const Segmentation_hierarchy::Node& n = tree.node(i);
        BOOST_TEST(n.is_leaf() == !is_accepted(tree, i));
        BOOST_TEST((n.cut_state != Cut_state::NOT_SEARCHED));
        if (n.cut_state == Cut_state::ACCEPTED)
          BOOST_TEST(n.salience >= threshold);
        if (n.cut_state == Cut_state::REJECTED)
          BOOST_TEST(n.salience < threshold);
      }
      if (threshold == infinity)
        BOOST_TEST(tree.number_of_segments() == 1);
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
    BOOST_TEST(r.number_of_segments == r.tree.number_of_segments());
    BOOST_TEST(r.number_of_segments == 1 + *std::max_element(r.labels.begin(), r.labels.end()));
  }
}

BOOST_AUTO_TEST_CASE(components_are_parts_from_the_start)
{
  const Mesh mesh = mesh_of(disjoint_union(many_components(300), dumbbell(16, 12)));
  Labels expected(num_faces(mesh));
  const std::size_t n = CGAL::Polygon_mesh_processing::connected_components(
    mesh, boost::make_iterator_property_map(expected.begin(), get(CGAL::face_index, mesh)));
  BOOST_TEST(n == 301);

  for (std::size_t maximum : {std::size_t(1), std::size_t(5), n}) {
    const Result r = segment(mesh, -infinity, maximum);
    BOOST_TEST(r.number_of_segments == n);
    BOOST_TEST(r.tree.number_of_roots() == n);
    BOOST_TEST(r.labels == expected, boost::test_tools::per_element());
  }

  const Result r = segment(mesh, -infinity, n + 1);
  BOOST_TEST(r.number_of_segments == n + 1);
  BOOST_TEST(is_accepted(r.tree, n - 1));
}

BOOST_AUTO_TEST_CASE(no_part_is_smaller_than_the_minimum)
{
  const Mesh mesh = mesh_of(read("elephant.off"));
  std::size_t number_before = num_faces(mesh);
  for (double minimum : {0.001, 0.01, 0.1, 0.5}) {
    const Segmentation_hierarchy tree = segment(mesh, -infinity, unlimited, minimum).tree;
    BOOST_TEST(tree.number_of_segments() < number_before);
    number_before = tree.number_of_segments();
    for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
      BOOST_TEST(tree.node(i).area >= minimum * (1 - 1e-9) * tree.node(0).area);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(the_number_of_threads_changes_nothing)
{
  const Soup several = disjoint_union(dumbbell(20, 16), disjoint_union(read("pig.off"),
                                                                       many_components(20)));
  for (const Mesh& mesh : {mesh_of(read("elephant.off")), mesh_of(read("dino.off")),
                           mesh_of(several)})
    for (std::size_t maximum : {std::size_t(7), unlimited}) {
      const Result expected = segment<CGAL::Sequential_tag>(mesh, 0.4, maximum);
      for (int threads : {1, 2, 4}) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        tbb::task_arena arena(threads); // more threads than cores, too
        const Result r = arena.execute([&]
          { return segment<CGAL::Parallel_tag>(mesh, 0.4, maximum); });
        BOOST_TEST(r.labels == expected.labels, boost::test_tools::per_element());
        BOOST_TEST_REQUIRE(r.tree.number_of_nodes() == expected.tree.number_of_nodes());
        for (std::size_t i = 0; i < r.tree.number_of_nodes(); ++i) {
          BOOST_TEST(r.tree.node(i).salience == expected.tree.node(i).salience);
          BOOST_TEST((r.tree.node(i).cut_state == expected.tree.node(i).cut_state));
        }
      }
    }
}
#endif

BOOST_AUTO_TEST_SUITE_END()
