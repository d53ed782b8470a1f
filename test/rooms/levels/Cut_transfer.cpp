// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/levels/Cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/levels/coarsening.h>
#include <CGAL/Spectral_segmentation/internal/search/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/search/recursion.h>
#include <CGAL/Spectral_segmentation/internal/search/region_merging.h>
#include <CGAL/Spectral_segmentation/internal/surface/Longest_edge_bisection.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/segment_spectral_recursive.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(cut_transfer)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using CGAL::Spectral_segmentation::Segmentation_visitor;
using CGAL::Spectral_segmentation::Stage;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

// A run, step by step.
struct Run
{
  Surface mesh;
  std::vector<internal::Level> levels;
  Segmentation_hierarchy searched, whole;

  // Once the search is done, the caller may stop the run.
  Run(const Soup& soup, std::size_t number_of_coarse_faces, bool is_stopped = false)
    : mesh(surface_of(soup))
  {
    const CGAL::Spectral_segmentation::Options options;
    internal::Run_control control;
    internal::Run_monitor monitor(control);
    internal::move_to_frame(sequential, mesh);
    levels = internal::coarsened(sequential, mesh, number_of_coarse_faces, monitor);
    Surface coarsest = levels.back().surface;
    set_face_distances(coarsest, weights_of_calibrated_method);
    const internal::Calibrated_cut best_cut(coarsest, options);
    const internal::Merge_tree regions =
      internal::Recursion(sequential, coarsest, best_cut, options, monitor).by_salience(20);
    internal::Merge_tree tree = internal::Region_merging(
      sequential, coarsest, best_cut.context(), options.part_salience, monitor)(regions.leaf);
    searched = Segmentation_hierarchy(internal::hierarchy_of(tree),
                                      CGAL::Spectral_segmentation::unlimited,
                                      threshold_of(options));

    struct Stopping_control : internal::Run_control
    {
      bool go_further() override { return false; }
    } stopping_control;
    internal::Run_monitor stopped_monitor(stopping_control);
    stopped_monitor.go_further();
    for (std::size_t i = levels.size(); i-- > 0;) {
      const Surface& finer = i > 0 ? levels[i - 1].surface : mesh;
      const internal::Face_fractions fractions(finer, levels[i], tree.leaf);
      const double minimum_area = 0; // no cut is lost
      tree = internal::Cut_transfer(sequential, tree, finer, minimum_area, fractions,
                                    weights_of_calibrated_method, [](const auto&, Surface&) {},
                                    is_stopped ? stopped_monitor : monitor)();
    }
    whole = Segmentation_hierarchy(internal::hierarchy_of(tree),
                                   CGAL::Spectral_segmentation::unlimited,
                                   threshold_of(options));
  }
};

std::vector<std::size_t> leaves(const Segmentation_hierarchy& hierarchy)
{
  std::vector<std::size_t> result(hierarchy.number_of_faces());
  for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i)
    if (hierarchy.node(i).is_leaf())
      for (std::size_t f : hierarchy.faces(i))
        result[f] = i;
  return result;
}

Soup fine_dumbbell() { return dumbbell(80, 60); }

double length_of_boundaries(const Soup& soup, const Labels& labels)
{
  const Mesh mesh = mesh_of(soup);
  double length = 0;
  for (Mesh::Edge_index e : mesh.edges()) {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    if (!mesh.is_border(e) && labels[mesh.face(h)] != labels[mesh.face(mesh.opposite(h))])
      length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)),
                                                 mesh.point(mesh.target(h))));
  }
  return length;
}

} // namespace

BOOST_AUTO_TEST_CASE(fractions_add_up)
{
  // A fan of three faces in two leaves around vertex 0.
  Surface fan;
  fan.corners = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  fan.points.resize(4);
  const internal::Leaf_fractions vertices = internal::vertex_fractions(fan, {7, 8, 7});
  BOOST_TEST_REQUIRE(vertices.number_of_elements() == 4);
  BOOST_TEST(vertices[0].begin()[0].leaf == 7);
  BOOST_TEST(vertices[0].begin()[0].fraction == 2 / 3.f);
  BOOST_TEST(vertices[0].begin()[1].leaf == 8);
  BOOST_TEST(vertices[0].begin()[1].fraction == 1 / 3.f);
  BOOST_TEST(vertices[1].size() == 1);
  BOOST_TEST(vertices[1].begin()[0].fraction == 1);

  const Surface mesh = surface_of(plate(2, 1));
  const internal::Level refined =
    internal::Longest_edge_bisection(mesh, 0.2)(sequential);
  std::vector<Index> leaf(refined.parent_face.size());
  for (Index f = 0; f < leaf.size(); ++f)
    leaf[f] = f % 3;
  const internal::Leaf_fractions faces =
    internal::face_fractions(refined, leaf, mesh.number_of_faces());
  BOOST_TEST_REQUIRE(faces.number_of_elements() == mesh.number_of_faces());
  BOOST_TEST(!faces.are_undivided());
  for (Index f = 0; f < mesh.number_of_faces(); ++f) {
    double sum = 0;
    for (const auto& part : faces[f])
      sum += part.fraction;
    BOOST_TEST(sum == mesh.areas[f], boost::test_tools::tolerance(1e-5));
  }
}

BOOST_AUTO_TEST_CASE(the_cuts_equal_the_cuts_of_the_coarse_mesh)
{
  for (const Soup& soup :
       {fine_dumbbell(), disjoint_union(sphere(4), moved(dumbbell(60, 40), 5, 0, 0))}) {
    const Run run(soup, 1500);
    const Segmentation_hierarchy &few = run.searched, &all = run.whole;
    BOOST_TEST(all.number_of_faces() == soup.triangles.size());
    BOOST_TEST(all.number_of_roots() == few.number_of_roots());
    BOOST_TEST_REQUIRE(all.number_of_nodes() == few.number_of_nodes());
    double area = 0;
    for (std::size_t root = 0; root < all.number_of_roots(); ++root)
      area += all.node(root).area;
    for (std::size_t i = few.number_of_roots(); i < few.number_of_nodes(); i += 2) {
      const Segmentation_hierarchy::Node &cut = few.node(few.node(i).parent),
                               &same = all.node(all.node(i).parent);
      BOOST_TEST(cut.salience == same.salience);
      BOOST_TEST(same.factors.cut_strength == cut.factors.cut_strength);
      BOOST_TEST(all.node(same.children[0]).area <= all.node(same.children[1]).area);
      // The coarse mesh has nearly the same areas.
      BOOST_TEST(std::abs(same.area - cut.area) < 0.05 * area);
    }
  }
}

BOOST_AUTO_TEST_CASE(faces_far_from_all_cuts_are_where_the_coarse_mesh_has_them)
{
  const Run run(fine_dumbbell(), 1500);
  const internal::Level &clusters = run.levels.front(), &coarse = run.levels.back();
  const std::vector<std::size_t> few = leaves(run.searched), all = leaves(run.whole);
  std::vector<std::set<std::size_t> > of_vertex(coarse.surface.points.size());
  for (std::size_t f = 0; f < few.size(); ++f)
    for (Index v : coarse.surface.corners[f])
      of_vertex[v].insert(few[f]);
  // A leaf of one hierarchy is one leaf of the other, whatever their order, but for loose pieces.
  std::map<std::size_t, std::map<std::size_t, std::size_t> > number_of_faces;
  std::size_t number_of_far = 0;
  for (std::size_t f = 0; f < all.size(); ++f) {
    std::set<std::size_t> around;
    for (Index v : run.mesh.corners[f]) {
      const Index coarse_vertex = coarse.coarse_vertex[clusters.coarse_vertex[v]];
      const std::set<std::size_t>& leaves = of_vertex[coarse_vertex];
      around.insert(leaves.begin(), leaves.end());
    }
    if (around.size() == 1) {
      ++number_of_far;
      ++number_of_faces[*around.begin()][all[f]];
    }
  }
  BOOST_TEST(number_of_far > all.size() / 4);
  std::set<std::size_t> matches;
  std::size_t number_of_matched = 0;
  for (const auto& [leaf, numbers] : number_of_faces) {
    const auto match = std::max_element(numbers.begin(), numbers.end(),
      [](const auto& a, const auto& b) { return a.second < b.second; });
    if (match->second > all.size() / 50)
      BOOST_TEST(matches.insert(match->first).second);
    number_of_matched += match->second;
  }
  BOOST_TEST(double(number_of_matched) > 0.97 * double(number_of_far));
}

BOOST_AUTO_TEST_CASE(the_neck_is_cut_along_its_shortest_ring)
{
  const Soup soup = fine_dumbbell();
  const Mesh mesh = mesh_of(soup);
  Labels labels;
  BOOST_TEST(CGAL::segment_spectral_recursive(mesh, map_to(labels, mesh),
                                              parameters::maximum_number_of_segments(2)
                                                .number_of_coarse_faces(3000)) == 2);
  // The ring at z = 0 of radius 0.2 is a polygon of 80 sides.
  BOOST_TEST(length_of_boundaries(soup, labels) == 2 * 80 * 0.2 * std::sin(pi / 80),
             boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(segments_are_connected_for_every_number)
{
  for (const Soup& soup : {fine_dumbbell(), torus(2, 0.5, 120, 40), plate(60, 50),
                           connected_sum(sphere(4), moved(sphere(4), 2, 0.1, 0))}) {
    const Run run(soup, 1000);
    const Mesh mesh = mesh_of(soup);
    for (std::size_t n = 1; n <= run.whole.number_of_segments(); ++n) {
      const Labels labels = labels_above(run.whole, -infinity, n);
      BOOST_TEST(number_of_connected_pieces(mesh, labels) == n);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_very_coarse_surface_ends_at_the_same_neck)
{
  const Soup soup = fine_dumbbell(); // 19040 faces
  const Run run(soup, 300);
  const Labels labels = labels_above(run.whole, -infinity, 2);
  BOOST_TEST(length_of_boundaries(soup, labels) < 1.1 * 2 * pi * 0.2);
}

BOOST_AUTO_TEST_CASE(larger_fractions_replace_minimum_cuts_once_the_run_is_stopped)
{
  const Soup soup = fine_dumbbell();
  const Mesh mesh = mesh_of(soup);
  for (std::size_t number_of_coarse_faces : {300, 1500}) {
    const Run run(soup, number_of_coarse_faces, true);
    BOOST_TEST(run.whole.number_of_nodes() == run.searched.number_of_nodes());
    for (std::size_t n = 1; n <= run.whole.number_of_segments(); ++n)
      BOOST_TEST(number_of_connected_pieces(mesh, labels_above(run.whole, -infinity, n)) == n);
    BOOST_TEST(run.whole.node(1).area > 0.45 * run.whole.node(0).area); // the first cut is the neck
  }
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(the_number_of_threads_changes_nothing)
{
  Random random(11);
  const Mesh mesh = mesh_of(displaced(fine_dumbbell(), 0.002, random));
  for (std::size_t number_of_coarse_faces : {300, 1500}) {
    const auto np = parameters::number_of_coarse_faces(number_of_coarse_faces)
                      .salience_threshold(-infinity);
    const auto run = [&](auto concurrency_tag, Segmentation_hierarchy& hierarchy) {
      return labels_of<decltype(concurrency_tag)>(mesh, np.hierarchy(hierarchy));
    };
    Segmentation_hierarchy expected;
    const Labels expected_labels = run(CGAL::Sequential_tag(), expected);
    for (int threads : {1, 2, 8}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      tbb::task_arena arena(threads); // more threads than cores, too
      Segmentation_hierarchy hierarchy;
      Labels labels;
      arena.execute([&] { labels = run(CGAL::Parallel_tag(), hierarchy); });
      BOOST_TEST(labels == expected_labels, boost::test_tools::per_element());
      BOOST_TEST_REQUIRE(hierarchy.number_of_nodes() == expected.number_of_nodes());
      for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
        BOOST_TEST(hierarchy.node(i).salience == expected.node(i).salience);
        BOOST_TEST(hierarchy.node(i).area == expected.node(i).area);
        BOOST_TEST((hierarchy.node(i).cut_state == expected.node(i).cut_state));
      }
    }
  }
}
#endif

BOOST_AUTO_TEST_CASE(small_meshes_are_searched_themselves_by_the_method_of_the_paper)
{
  struct Stages : Segmentation_visitor
  {
    std::set<Stage> stages;
    void before_stage(Stage stage, std::size_t) { stages.insert(stage); }
  };
  const Mesh mesh = mesh_of(dumbbell(20, 16));
  const std::size_t n = num_faces(mesh);
  for (std::size_t number : {std::size_t(0), n, n - 1}) {
    Stages stages;
    Labels labels;
    CGAL::segment_spectral_recursive(
      mesh, map_to(labels, mesh),
      parameters::number_of_coarse_faces(number).zhang_liu_2005().visitor(std::ref(stages)));
    BOOST_TEST((stages.stages.count(Stage::PROJECTION) == 1) == (number == n - 1));
  }
}

BOOST_AUTO_TEST_CASE(the_method_of_the_paper_can_be_searched_on_fewer_faces_too)
{
  const Soup soup = fine_dumbbell();
  const Mesh mesh = mesh_of(soup);
  Labels labels;
  CGAL::segment_spectral_recursive(
    mesh, map_to(labels, mesh),
    parameters::zhang_liu_2005().number_of_coarse_faces(4000).maximum_number_of_segments(2));
  BOOST_TEST(number_of_connected_pieces(mesh, labels) == 2);
  BOOST_TEST(length_of_boundaries(soup, labels) < 1.2 * 2 * pi * 0.2);
}

BOOST_AUTO_TEST_CASE(a_hierarchy_of_the_paper_is_read_off_in_the_order_of_its_run)
{
  Random random(7);
  const Soup soup = displaced(torus(2, 0.5, 120, 40), 0.02, random);
  const Mesh mesh = mesh_of(soup);
  const auto np = parameters::zhang_liu_2005().number_of_coarse_faces(1000)
                    .salience_threshold(-infinity);
  Segmentation_hierarchy hierarchy;
  Labels labels;
  CGAL::segment_spectral_recursive(
    mesh, map_to(labels, mesh), np.maximum_number_of_segments(12).hierarchy(hierarchy));
  for (std::size_t n = 1; n <= 12; ++n) {
    CGAL::segment_spectral_recursive(mesh, map_to(labels, mesh), np.maximum_number_of_segments(n));
    BOOST_TEST(labels_above(hierarchy, -infinity, n) == labels, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(parts_of_a_few_searched_faces_are_neither_lost_nor_torn)
{
  const std::size_t limits[] = {12, 40, 80};
  for (unsigned seed = 1; seed <= 12; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Soup soup = displaced(seed % 2 == 0 ? torus(2, 0.7, 24, 12) : sphere(3), 0.05, random);
      const Mesh mesh = mesh_of(soup);
      const auto np = parameters::minimum_segment_size(0).number_of_coarse_faces(
        limits[seed % 3]).salience_threshold(-infinity);
      const auto check = [&](const auto& method) {
        Segmentation_hierarchy hierarchy;
        Labels labels;
        const std::size_t n =
          CGAL::segment_spectral_recursive(mesh, map_to(labels, mesh), method.hierarchy(hierarchy));
        BOOST_TEST(number_of_connected_pieces(mesh, labels) == n);
        for (std::size_t i = 1; i <= n; ++i)
          BOOST_TEST(number_of_connected_pieces(mesh, labels_above(hierarchy, -infinity, i)) == i);
      };
      check(np);
      check(np.zhang_liu_2005().maximum_number_of_segments(8));
    }
}

BOOST_AUTO_TEST_SUITE_END()
