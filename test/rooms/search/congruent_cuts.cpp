// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "tree_of_hierarchy.h"

#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>
#include <CGAL/Spectral_segmentation/internal/search/congruent_cuts.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(congruent_cuts)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Cut_hierarchy;
using internal::Cut_node;

namespace {

typedef std::vector<Index> Faces;
typedef std::function<bool(Index)> Face_set;

Faces faces_of(const Cut_hierarchy& hierarchy, std::size_t node)
{
  const internal::Nested_ranges ranges(hierarchy);
  Faces result(ranges[node].begin(), ranges[node].end());
  std::sort(result.begin(), result.end());
  return result;
}

// Cuts a leaf between the faces that a function takes and the others.
void cut(const Surface& graph, Cut_hierarchy& hierarchy, std::size_t node, double salience,
         const Face_set& is_taken)
{
  Faces sides[2];
  double area[2] = {0, 0};
  for (Index f : faces_of(hierarchy, node)) {
    const int side = is_taken(f) ? 0 : 1;
    sides[side].push_back(f);
    area[side] += graph.areas[f];
  }
  const int smaller = area[0] <= area[1] ? 0 : 1;
  hierarchy.cut_order.push_back(node);
  hierarchy.cut(node, area[smaller], area[1 - smaller]);
  hierarchy.nodes[node].salience = salience;
  for (int side = 0; side < 2; ++side)
    for (Index f : sides[side])
      hierarchy.leaf[f] =
        static_cast<Index>(hierarchy.nodes[node].children[side == smaller ? 0 : 1]);
}

// A body with a left, a right and a lower arm of one shape, and a longer arm at the top.
struct Figure
{
  Soup soup;
  Surface graph;

  // The top arm may be thick, and far from the middle.
  explicit Figure(bool is_symmetric = true)
  {
    Cells cells;
    add_box(cells, {-6, -1, -2}, {6, 1, 2});
    add_box(cells, {-10, 0, 0}, {-6, 1, 1});
    add_box(cells, {6, 0, 0}, {10, 1, 1});
    if (is_symmetric)
      add_box(cells, {0, 0, 2}, {1, 1, 9});
    else
      add_box(cells, {-5, -1, 2}, {-3, 1, 9});
    add_box(cells, {0, 0, -6}, {1, 1, -2});
    soup = boundary_of(cells);
    graph = surface_of(soup);
  }

  Face_set left() const { return [this](Index f) { return centroid(soup, f).x() < -6; }; }
  Face_set right() const { return [this](Index f) { return centroid(soup, f).x() > 6; }; }
  Face_set top() const { return [this](Index f) { return centroid(soup, f).z() > 2; }; }
  Face_set bottom() const { return [this](Index f) { return centroid(soup, f).z() < -2; }; }
  Face_set left_end() const { return [this](Index f) { return centroid(soup, f).x() < -3; }; }
};

const Figure& figure()
{
  static const Figure result;
  return result;
}

// The saliences of the cuts in their order.
std::vector<double> saliences(const Cut_hierarchy& hierarchy)
{
  std::vector<double> result;
  for (std::size_t node : hierarchy.cut_order)
    result.push_back(hierarchy.nodes[node].salience);
  return result;
}

// Checks the properties of every hierarchy of merges, and the properties of the cuts that stay.
void check(const Cut_hierarchy& before, const Cut_hierarchy& after)
{
  BOOST_TEST(after.number_of_roots == before.number_of_roots);
  BOOST_TEST_REQUIRE(after.nodes.size() == before.nodes.size());
  BOOST_TEST_REQUIRE(after.cut_order.size() == before.cut_order.size());
  for (std::size_t i = 0; i < after.cut_order.size(); ++i) {
    const Cut_node& n = after.nodes[after.cut_order[i]];
    for (std::size_t k = 0; k < 2; ++k) {
      BOOST_TEST(n.children[k] == after.number_of_roots + 2 * i + k);
      BOOST_TEST(after.nodes[n.children[k]].parent == after.cut_order[i]);
    }
    BOOST_TEST(after.cut_order[i] < n.children[0]);
    BOOST_TEST(after.nodes[n.children[0]].area <= after.nodes[n.children[1]].area);
    if (i > 0)
      BOOST_TEST(n.salience <= after.nodes[after.cut_order[i - 1]].salience);
  }
  std::map<Faces, double> areas;
  for (std::size_t node = 0; node < before.nodes.size(); ++node)
    areas[faces_of(before, node)] = before.nodes[node].area;
  for (std::size_t node = 0; node < after.nodes.size(); ++node) {
    const auto part = areas.find(faces_of(after, node));
    BOOST_REQUIRE((part != areas.end()));
    BOOST_TEST(after.nodes[node].area == part->second, tt::tolerance(1e-12));
    areas.erase(part);
  }
}

Cut_hierarchy checked_cuts(const Surface& graph, const Cut_hierarchy& hierarchy)
{
  internal::Merge_tree tree = internal::apply_from_top_down(tree_of(hierarchy));
  const std::vector<std::size_t> no_partners(tree.merges.size(), internal::null_node);
  tree = internal::average_saliences(std::move(tree), graph, no_partners);
  const Cut_hierarchy result =
    internal::hierarchy_of(internal::apply_from_top_down(std::move(tree)));
  BOOST_TEST(result.is_monotonic);
  check(hierarchy, result);
  return result;
}

// Cuts off the left end, which becomes node 1, and then its arm, and two arms of the rest.
Cut_hierarchy cuts_of_both_ends(double of_left, double of_top, double of_bottom)
{
  const Figure& f = figure();
  Cut_hierarchy cuts = uncut_hierarchy(f.graph);
  cut(f.graph, cuts, 0, 0.75, f.left_end());
  BOOST_TEST(f.left_end()(faces_of(cuts, 1).front()));
  cut(f.graph, cuts, 1, of_left, f.left());
  cut(f.graph, cuts, 2, of_top, f.top());
  cut(f.graph, cuts, 6, of_bottom, f.bottom());
  return cuts;
}

} // namespace

// An arm is an open box of 4 x 1 x 1, whose sides have the area 16 and whose end has the area 1.
BOOST_AUTO_TEST_CASE(the_shape_of_a_cut_equals_the_shape_of_a_box)
{
  const Figure& f = figure();
  Cut_hierarchy cuts = uncut_hierarchy(f.graph);
  cut(f.graph, cuts, 0, 1, f.left());
  const double across = (8 * 0.25 + 9 / 12.) / 17, mean = (16 * 2. + 4) / 17,
               along = (16 * 16 / 3. + 16) / 17 - mean * mean;
  const std::vector<internal::Cut_shape> shapes = internal::cut_shapes(f.graph, tree_of(cuts));
  BOOST_TEST_REQUIRE(shapes.size() == 1u);
  const double expected[] = {17, 4 * 4, across, across, along}; // squares; the unit is arbitrary
  for (std::size_t i = 0; i < 5; ++i)
    BOOST_TEST(std::abs(shapes[0][i] - shapes[0][1] - std::log(expected[i] / expected[1]) / 2) <
               1e-5);
  BOOST_TEST(internal::difference({0, 1, 2, 3, 4}, {1, 1, 0, 3, 4}) == 1); // the root of 5 / 5
}

BOOST_AUTO_TEST_CASE(arms_of_one_shape_get_the_mean_of_their_saliences)
{
  const Figure& f = figure();
  Cut_hierarchy cuts = uncut_hierarchy(f.graph);
  cut(f.graph, cuts, 0, 0.875, f.top());
  cut(f.graph, cuts, 2, 0.75, f.bottom());
  cut(f.graph, cuts, 4, 0.5, f.left());
  cut(f.graph, cuts, 6, 0.25, f.right());
  BOOST_TEST(saliences(checked_cuts(f.graph, cuts)) ==
             std::vector<double>({0.875, 0.5, 0.5, 0.5}),
             tt::tolerance(1e-12) << tt::per_element());
}

BOOST_AUTO_TEST_CASE(a_cut_is_at_most_as_salient_as_the_cut_above_it)
{
  const Figure& f = figure();
  Cut_hierarchy cuts = uncut_hierarchy(f.graph);
  cut(f.graph, cuts, 0, 0.875, f.left());
  cut(f.graph, cuts, 2, 0.75, f.top());
  cut(f.graph, cuts, 4, 0.5, f.right());
  cut(f.graph, cuts, 6, 0.125, f.bottom());
  BOOST_TEST(saliences(checked_cuts(f.graph, cuts)) ==
             std::vector<double>({0.5, 0.5, 0.5, 0.5}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(the_mean_is_taken_of_saliences_that_cuts_above_have_limited)
{
  const Cut_hierarchy cuts = cuts_of_both_ends(0.625, 0.25, 0.875);
  BOOST_TEST(saliences(checked_cuts(figure().graph, cuts)) ==
             std::vector<double>({0.75, 0.4375, 0.25, 0.25}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(cuts_change_their_order_with_their_saliences)
{
  const Cut_hierarchy cuts = cuts_of_both_ends(0.625, 0.5, 0.125);
  const Cut_hierarchy result = checked_cuts(figure().graph, cuts);
  BOOST_TEST(saliences(result) == std::vector<double>({0.75, 0.5, 0.375, 0.375}),
             tt::per_element());
  BOOST_TEST(result.cut_order == std::vector<std::size_t>({0, 2, 1, 4}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(saliences_may_be_of_any_scale)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double largest = std::numeric_limits<double>::max();
  const Figure& f = figure();
  const auto of_arms = [&](double left, double right) {
    Cut_hierarchy cuts = uncut_hierarchy(f.graph);
    cut(f.graph, cuts, 0, left, f.left());
    cut(f.graph, cuts, 2, right, f.right());
    const std::vector<double> result = saliences(checked_cuts(f.graph, cuts));
    BOOST_TEST(result[0] == result[1]);
    return result[0];
  };
  BOOST_TEST(of_arms(0.1, 0.1) == 0.1);
  BOOST_TEST(of_arms(-2, -4) == -3);
  BOOST_TEST(of_arms(largest, largest) == largest);
  BOOST_TEST(of_arms(infinity, 1) == infinity);
  BOOST_TEST(of_arms(1, -infinity) == -infinity);
  BOOST_TEST(of_arms(infinity, -infinity) == -infinity);
}

BOOST_AUTO_TEST_CASE(the_mean_of_three_equal_saliences_is_the_same)
{
  const Figure& f = figure();
  for (double salience : {0.1, 0.3, std::numeric_limits<double>::max()}) {
    Cut_hierarchy cuts = uncut_hierarchy(f.graph);
    cut(f.graph, cuts, 0, salience, f.left());
    cut(f.graph, cuts, 2, salience, f.right());
    cut(f.graph, cuts, 4, salience, f.bottom());
    BOOST_TEST(saliences(checked_cuts(f.graph, cuts)) ==
               std::vector<double>(3, salience), tt::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_side_without_area_has_a_shape)
{
  Surface flat = surface_of(plate(2, 2));
  for (Index f = 0; f < 2; ++f)
    flat.areas[f] = 0;
  Cut_hierarchy cuts = uncut_hierarchy(flat);
  cut(flat, cuts, 0, 1, [](Index f) { return f < 2; });
  const std::vector<internal::Cut_shape> shapes = internal::cut_shapes(flat, tree_of(cuts));
  for (double x : shapes.front())
    BOOST_TEST(std::isfinite(x));
}

BOOST_AUTO_TEST_CASE(random_hierarchies_stay_in_order)
{
  std::size_t changed = 0;
  for (unsigned seed = 1; seed <= 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Surface graph = seed % 2 == 0
        ? figure().graph
        : surface_of(disjoint_union(plate(6, 5), displaced(torus(2, 0.7, 12, 7), 0.01, random)));
      Cut_hierarchy cuts = uncut_hierarchy(graph);
      double salience = 1;
      for (int tries = 0; tries < 60; ++tries) { // by random planes across the axes
        const std::size_t node = random() % cuts.nodes.size();
        const Faces faces = faces_of(cuts, node);
        const int axis = int(random() % 3);
        const double x = graph.centroid(faces[random() % faces.size()])[axis];
        const Face_set is_taken = [&](Index f) { return graph.centroid(f)[axis] < x; };
        if (!cuts.nodes[node].is_leaf() || faces.size() < 8 ||
            std::none_of(faces.begin(), faces.end(), is_taken))
          continue;
        salience -= double(random() % 3) / 64;
        cut(graph, cuts, node, salience, is_taken);
      }
      const Cut_hierarchy result = checked_cuts(graph, cuts);
      BOOST_TEST(result.nodes[result.cut_order.front()].salience <= 1);
      BOOST_TEST(result.nodes[result.cut_order.back()].salience >= salience);
      changed += saliences(result) != saliences(cuts);
      const std::vector<double> in_order = saliences(result);
      BOOST_TEST(std::is_sorted(in_order.rbegin(), in_order.rend()));
      std::set<std::size_t> cut_before;
      for (std::size_t node : result.cut_order) { // parents come first
        BOOST_TEST((node < result.number_of_roots ||
                    cut_before.count(result.nodes[node].parent) == 1));
        cut_before.insert(node);
      }
      std::map<Index, Index> leaf; // the same sets of faces
      for (std::size_t f = 0; f < cuts.leaf.size(); ++f)
        BOOST_TEST(leaf.emplace(cuts.leaf[f], result.leaf[f]).first->second == result.leaf[f]);
    }
  BOOST_TEST(changed >= 5u);
}

namespace {

// Runs the whole search. Checks that, whatever the threshold, either all these arms are parts or
// none is.
void check_arms(const Figure& f, const std::vector<Face_set>& arms)
{
  const auto hierarchy =
    hierarchy_of(mesh_of(f.soup), CGAL::Spectral_segmentation::parameters::default_values());
  const auto has_part = [](const std::vector<std::size_t>& labels, const Face_set& arm) {
    std::set<std::size_t> inside, outside;
    for (Index face = 0; face < labels.size(); ++face)
      (arm(face) ? inside : outside).insert(labels[face]);
    return inside.size() == 1 && outside.count(*inside.begin()) == 0;
  };
  bool is_ever_cut = false;
  for (int percent = 0; percent <= 100; percent += 2)
    BOOST_TEST_CONTEXT("threshold " << percent << " %") {
      const std::vector<std::size_t> labels = labels_above(hierarchy, percent / 100., 100);
      for (const Face_set& arm : arms)
        BOOST_TEST(has_part(labels, arm) == has_part(labels, arms.front()));
      is_ever_cut |= has_part(labels, arms.front());
    }
  BOOST_TEST(is_ever_cut);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_threshold_cuts_off_mirror_images_or_none)
{
  const Figure& f = figure();
  check_arms(f, {f.left(), f.right()});
}

BOOST_AUTO_TEST_CASE(a_threshold_cuts_off_all_arms_of_one_shape_or_none)
{
  const Figure f(false);
  check_arms(f, {f.left(), f.right(), f.bottom()});
}

BOOST_AUTO_TEST_SUITE_END()
