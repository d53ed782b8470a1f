// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/model/Component_merging.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(component_merging)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Component_fractions;
using internal::Merge_tree;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Box
{
  Cell low, high;
};

Surface surface_of_boxes(const std::vector<Box>& boxes)
{
  Soup result;
  for (const Box& box : boxes) {
    Cells cells;
    add_box(cells, box.low, box.high);
    result = disjoint_union(std::move(result), boundary_of(cells));
  }
  return surface_of(result);
}

// Returns fractions of a model without surroundings.
Component_fractions fractions_of(const Surface& mesh)
{
  Component_fractions result;
  result.fraction = internal::component_areas(mesh, mesh.components);
  double total = 0;
  for (double area : result.fraction)
    total += area;
  for (double& fraction : result.fraction)
    fraction /= total;
  result.is_surrounding.assign(result.fraction.size(), 0);
  return result;
}

Merge_tree merged(const Surface& mesh, Merge_tree tree)
{
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  const Component_fractions fractions = fractions_of(mesh);
  return internal::Component_merging(std::move(tree), mesh, fractions, {}, 0, monitor)();
}

Merge_tree merged(const Surface& mesh)
{ return merged(mesh, internal::uncut_tree(mesh, internal::Cut_state::NO_CUT)); }

typedef std::set<Index> Faces;

// Returns the faces of the union that each merge makes, and the salience.
std::vector<std::pair<Faces, double> > unions(const Merge_tree& tree)
{
  std::vector<Faces> faces(tree.leaves.size());
  for (Index f = 0; f < tree.leaf.size(); ++f)
    faces[tree.leaf[f]].insert(f);
  std::vector<std::pair<Faces, double> > result;
  for (const internal::Merge& m : tree.merges) {
    Faces all = faces[m.leaves[0]];
    all.insert(faces[m.leaves[1]].begin(), faces[m.leaves[1]].end());
    for (Index f : all)
      faces[tree.leaf[f]] = all;
    result.emplace_back(all, m.salience);
  }
  return result;
}

// Merges the components of a mesh in the slowest way: adds up all contacts for each merge.
std::vector<std::pair<Faces, double> > slowly_merged(const Surface& mesh)
{
  const auto contacts = internal::set_contacts(
    mesh, mesh.components.face_labels(mesh.number_of_faces()), [](std::size_t) {});
  std::vector<double> area = fractions_of(mesh).fraction;
  double largest = 0;
  for (double a : area)
    largest = (std::max)(largest, a);
  std::vector<std::set<Index> > sets; // of components
  for (Index c = 0; c < area.size(); ++c)
    sets.push_back({c});
  std::vector<char> is_isolated(sets.size(), 0);
  const auto contact = [&](std::size_t a, std::size_t b) {
    std::pair<double, double> result(-1, 0); // the area, and minus the gap; -1: no contact
    double gap = infinity;
    for (const internal::Set_contact& c : contacts)
      for (int i : {0, 1})
        if (sets[a].count(c.sets[i]) && sets[b].count(c.sets[1 - i])) {
          result.first = (std::max)(result.first, 0.) + double(c.area);
          gap = (std::min)(gap, c.squared_gap);
        }
    result.second = -gap;
    return result;
  };
  std::vector<std::pair<Faces, double> > result;
  for (std::size_t n = sets.size(); n > 1;) {
    bool are_all_isolated = true;
    for (std::size_t i = 0; i < sets.size(); ++i)
      are_all_isolated = are_all_isolated && (sets[i].empty() || is_isolated[i]);
    std::size_t a = sets.size();
    for (std::size_t i = 0; i < sets.size(); ++i)
      if (!sets[i].empty() && (are_all_isolated || !is_isolated[i]) &&
          (a == sets.size() || area[i] < area[a]))
        a = i;
    std::size_t b = sets.size();
    for (std::size_t i = 0; i < sets.size(); ++i)
      if (i != a && !sets[i].empty() && contact(a, i).first >= 0 &&
          (b == sets.size() || contact(a, i) > contact(a, b)))
        b = i;
    BOOST_TEST_REQUIRE(b < sets.size());
    if (!are_all_isolated && contact(a, b).first == 0 &&
        area[a] >= internal::fraction_at_threshold * largest) {
      is_isolated[a] = 1;
      continue;
    }
    const double salience =
      are_all_isolated ? infinity : internal::salience_of_component(area[a], 0);
    sets[b].insert(sets[a].begin(), sets[a].end());
    sets[a].clear();
    area[b] += area[a];
    is_isolated[b] = are_all_isolated;
    --n;
    Faces faces;
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      if (sets[b].count(mesh.components[f]))
        faces.insert(f);
    result.emplace_back(std::move(faces), salience);
  }
  return result;
}

} // namespace

// A box of two cubes lies on a larger one with two squares, and beside another with one.
BOOST_AUTO_TEST_CASE(the_smallest_component_joins_the_one_that_it_touches_most)
{
  const Surface mesh = surface_of_boxes({{{0, 0, 0}, {4, 4, 4}},    // area 96
                                         {{0, 0, 4}, {2, 2, 6}},    // area 24
                                         {{2, 0, 4}, {4, 1, 5}}});  // area 10
  const Merge_tree tree = merged(mesh);
  BOOST_TEST_REQUIRE(tree.merges.size() == 2u);
  const auto result = unions(tree);
  BOOST_TEST(result[0].first.size() == 192u + 20u);
  BOOST_TEST(result[0].second == internal::salience_of_component(10 / 130., 0),
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(result[1].second == internal::salience_of_component(24 / 130., 0),
             boost::test_tools::tolerance(1e-6));
}

// The formula, at the default threshold: a component of a hundredth of the area.
BOOST_AUTO_TEST_CASE(a_hundredth_of_the_area_is_at_the_threshold)
{
  BOOST_TEST(internal::salience_of_component(0.01, 0) ==
             CGAL::Spectral_segmentation::default_probability_threshold,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(components_are_merged_as_in_the_slowest_way)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    Random random(seed);
    std::vector<Box> boxes;
    const std::size_t n = random_number(random, 2, 9);
    while (boxes.size() < n) { // disjoint boxes, some of which touch
      Box box;
      for (int i = 0; i < 3; ++i) {
        box.low[i] = int(random_number(random, 0, 7));
        box.high[i] = box.low[i] + int(random_number(random, 1, 4));
      }
      bool is_disjoint = true;
      for (const Box& other : boxes) {
        bool overlaps = true;
        for (int i = 0; i < 3; ++i)
          overlaps = overlaps && box.low[i] < other.high[i] && other.low[i] < box.high[i];
        is_disjoint = is_disjoint && !overlaps;
      }
      if (is_disjoint)
        boxes.push_back(box);
    }
    const Surface mesh = surface_of_boxes(boxes);
    BOOST_TEST_REQUIRE(mesh.components.number == n);
    auto expected = slowly_merged(mesh);
    std::stable_sort(expected.begin(), expected.end(),
                     [](const auto& a, const auto& b) { return a.second < b.second; });
    const auto result = unions(merged(mesh));
    BOOST_TEST_REQUIRE(result.size() == expected.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
      if (std::isinf(expected[i].second))
        BOOST_TEST(std::isinf(result[i].second));
      else
        BOOST_TEST(result[i].second == expected[i].second, boost::test_tools::tolerance(1e-6));
    }
    BOOST_TEST((result.back().first.size() == mesh.number_of_faces()));
  }
}

// Two equal components need the evidence 2.5. The evidence of a cut is the excess of its logit over
// that of the threshold 0.4. The cuts of a component without enough fall to half of the threshold.
BOOST_AUTO_TEST_CASE(a_component_with_little_evidence_is_not_cut)
{
  const Surface mesh = surface_of_boxes({{{0, 0, 0}, {4, 4, 4}}, {{9, 0, 0}, {13, 4, 4}}});
  for (const auto& [given, expected] : {std::make_pair(0.6, 0.2), std::make_pair(0.95, 0.95)}) {
    Merge_tree tree = internal::uncut_tree(mesh, internal::Cut_state::NO_CUT);
    tree.leaves.push_back({});
    for (Index f = 0; f < 10; ++f)
      tree.leaf[f] = 2;
    internal::set_areas_of_leaves(tree, mesh);
    tree.merges.push_back({{2, 0}, given, {}});
    const Merge_tree result = merged(mesh, std::move(tree));
    BOOST_TEST(result.merges[0].salience == expected, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_SUITE_END()
