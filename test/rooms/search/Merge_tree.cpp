// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"
#include "tree_of_hierarchy.h"

#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(merge_tree)

namespace tt = boost::test_tools;
using namespace test_meshes;
using namespace CGAL::Spectral_segmentation::internal;

namespace {

typedef std::set<Index> Faces;

// Random cuts of roots, from the top down, with the faces of each part. Face f has the area f + 1.
struct Random_cuts
{
  struct Cut
  {
    Faces sides[2];
    double salience;
  };

  std::vector<Cut> cuts; // in their order
  std::vector<Faces> roots, parts; // the parts that remain, by the leaves of the tree
  Merge_tree tree;

  Random_cuts(std::size_t number_of_roots, std::size_t number_of_faces, int tries, Random& random)
    : roots(number_of_roots)
  {
    for (Index f = 0; f < number_of_faces; ++f)
      roots[f < number_of_roots ? f : random() % number_of_roots].insert(f);
    parts = roots;
    for (int i = 0; i < tries; ++i) {
      const std::size_t leaf = random() % parts.size();
      Cut cut{{}, double(random() % 8)};
      for (Index f : parts[leaf])
        cut.sides[random() % 2].insert(f);
      if (cut.sides[0].empty() || cut.sides[1].empty())
        continue;
      parts[leaf] = cut.sides[0];
      tree.merges.push_back({{Index(leaf), Index(parts.size())}, cut.salience, {}});
      parts.push_back(cut.sides[1]);
      cuts.push_back(cut);
    }
    std::reverse(tree.merges.begin(), tree.merges.end());
    tree.leaf.resize(number_of_faces);
    for (Index leaf = 0; leaf < parts.size(); ++leaf) {
      tree.leaves.emplace_back();
      for (Index f : parts[leaf]) {
        tree.leaf[f] = leaf;
        tree.leaves[leaf].area += f + 1;
      }
    }
  }
};

Faces faces_of(const Cut_hierarchy& hierarchy, std::size_t node)
{
  const Nested_ranges ranges(hierarchy);
  return Faces(ranges[node].begin(), ranges[node].end());
}

double area(const Faces& faces)
{
  double sum = 0;
  for (Index f : faces)
    sum += f + 1;
  return sum;
}

template <class Function>
void for_each_random_cuts(const Function& f)
{
  for (unsigned seed = 1; seed <= 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const std::size_t number_of_roots = 1 + random() % 4;
      f(Random_cuts(number_of_roots, number_of_roots + random() % 60, 30, random), random);
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(all_leaves_are_roots_without_merges)
{
  Surface surface = surface_of(disjoint_union(plate(2, 1), plate(1, 1)));
  for (Cut_state state : {Cut_state::NOT_SEARCHED, Cut_state::NO_CUT}) {
    const Merge_tree tree = uncut_tree(surface, state);
    BOOST_TEST(tree.number_of_roots() == 2u);
    const Cut_hierarchy hierarchy = hierarchy_of(tree);
    BOOST_TEST(hierarchy.number_of_segments() == 2u);
    BOOST_TEST(hierarchy.leaf == std::vector<Index>({0, 0, 0, 0, 1, 1}), tt::per_element());
    for (std::size_t i = 0; i < 2; ++i) {
      BOOST_TEST(hierarchy.nodes[i].is_leaf());
      BOOST_TEST(hierarchy.nodes[i].parent == null_node);
      BOOST_TEST(hierarchy.nodes[i].area == 2 * hierarchy.nodes[1].area / (1 + double(i)),
                 tt::tolerance(1e-12));
      BOOST_TEST((hierarchy.nodes[i].cut_state == state));
    }
  }
  BOOST_TEST(hierarchy_of(Merge_tree()).number_of_segments() == 0u);
}

BOOST_AUTO_TEST_CASE(a_hierarchy_has_the_cuts_in_their_order)
{
  for_each_random_cuts([](const Random_cuts& expected, Random&) {
    const Cut_hierarchy h = hierarchy_of(expected.tree);
    const std::size_t roots = expected.roots.size(), n = expected.cuts.size();
    BOOST_TEST(expected.tree.number_of_roots() == roots);
    BOOST_TEST_REQUIRE(h.number_of_roots == roots);
    BOOST_TEST_REQUIRE(h.nodes.size() == roots + 2 * n);
    BOOST_TEST_REQUIRE(h.cut_order.size() == n);
    for (std::size_t i = 0; i < roots; ++i)
      BOOST_TEST((faces_of(h, i) == expected.roots[i]));
    for (std::size_t i = 0; i < n; ++i) {
      const auto& sides = expected.cuts[i].sides;
      const int smaller = area(sides[0]) <= area(sides[1]) ? 0 : 1;
      const Cut_node& cut = h.nodes[h.cut_order[i]];
      BOOST_TEST((cut.cut_state == Cut_state::CUT));
      BOOST_TEST(cut.salience == expected.cuts[i].salience);
      for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t child = roots + 2 * i + k;
        BOOST_TEST(cut.children[k] == child);
        BOOST_TEST(h.nodes[child].parent == h.cut_order[i]);
        BOOST_TEST(area(faces_of(h, child)) == area(sides[k == 0 ? smaller : 1 - smaller]));
        BOOST_TEST((faces_of(h, child) == sides[0] || faces_of(h, child) == sides[1]));
      }
    }
    for (std::size_t i = 0; i < h.nodes.size(); ++i) {
      BOOST_TEST(h.nodes[i].area == area(faces_of(h, i)));
      if (h.nodes[i].is_leaf())
        BOOST_TEST((h.nodes[i].cut_state == Cut_state::NO_CUT));
    }
  });
}

BOOST_AUTO_TEST_CASE(decisions_on_leaves_stand_between_the_cuts)
{
  for_each_random_cuts([](Random_cuts cuts, Random& random) {
    std::map<std::size_t, Index> decided; // by salience, which distinguishes them
    for (Index leaf = 0; leaf < cuts.tree.leaves.size(); ++leaf)
      if (random() % 2 == 0) {
        // A leaf is decided on after the cut that makes it.
        std::size_t earliest = 0;
        for (std::size_t i = 0; i < cuts.cuts.size(); ++i)
          for (const Faces& side : cuts.cuts[i].sides)
            if (side == cuts.parts[leaf])
              earliest = i + 1;
        Leaf& l = cuts.tree.leaves[leaf];
        l.cut_state = Cut_state::REJECTED;
        l.number_of_earlier_cuts = earliest + random() % (cuts.cuts.size() + 1 - earliest);
        l.salience = -1. - leaf;
        decided[leaf + 1] = leaf;
      }
    const Cut_hierarchy h = hierarchy_of(cuts.tree);
    std::size_t number_of_cuts = 0;
    for (std::size_t node : h.cut_order) {
      const Cut_node& n = h.nodes[node];
      if (n.cut_state == Cut_state::CUT) {
        BOOST_TEST(n.salience == cuts.cuts[number_of_cuts++].salience);
        continue;
      }
      BOOST_TEST_REQUIRE(decided.count(std::size_t(-n.salience)) == 1u);
      const Index leaf = decided[std::size_t(-n.salience)];
      BOOST_TEST(cuts.tree.leaves[leaf].number_of_earlier_cuts == number_of_cuts);
      BOOST_TEST((faces_of(h, node) == cuts.parts[leaf]));
      decided.erase(std::size_t(-n.salience));
    }
    BOOST_TEST(number_of_cuts == cuts.cuts.size());
    BOOST_TEST(decided.empty());
  });
}

BOOST_AUTO_TEST_CASE(merged_sets_are_ranges)
{
  for_each_random_cuts([](const Random_cuts& cuts, Random&) {
    const Merged_sets sets(cuts.tree);
    const auto faces_in = [&](const Merged_set& set) {
      Faces result;
      for (Index leaf = 0; leaf < cuts.parts.size(); ++leaf)
        if (sets.position[leaf] >= set.first && sets.position[leaf] < set.end)
          result.insert(cuts.parts[leaf].begin(), cuts.parts[leaf].end());
      return result;
    };
    BOOST_TEST_REQUIRE(sets.roots.size() == cuts.roots.size());
    for (std::size_t i = 0; i < cuts.roots.size(); ++i)
      BOOST_TEST((faces_in(sets.roots[i]) == cuts.roots[i]));
    for (std::size_t i = 0; i < cuts.cuts.size(); ++i) {
      const auto& sides = cuts.cuts[cuts.cuts.size() - 1 - i].sides;
      const auto& [a, b] = sets.sides[i];
      BOOST_TEST(a.end == b.first);
      BOOST_TEST(a.area <= b.area);
      BOOST_TEST(((faces_in(a) == sides[0] && faces_in(b) == sides[1]) ||
                  (faces_in(a) == sides[1] && faces_in(b) == sides[0])));
      for (const Merged_set& set : {a, b}) {
        BOOST_TEST((sets.position[set.leaf] >= set.first && sets.position[set.leaf] < set.end));
        if (set.merge == null_index)
          BOOST_TEST(set.size() == 1u);
        else
          BOOST_TEST((faces_in(sets.sides[set.merge][0]).size() +
                      faces_in(sets.sides[set.merge][1]).size() == faces_in(set).size()));
      }
    }
  });
}

// The cut to make next is looked up among all cuts of the parts that remain.
BOOST_AUTO_TEST_CASE(the_most_salient_cut_that_can_be_made_comes_next)
{
  for_each_random_cuts([](const Random_cuts& cuts, Random&) {
    const Merge_tree tree = apply_from_top_down(cuts.tree);
    BOOST_TEST(tree.is_monotonic);
    const Cut_hierarchy before = hierarchy_of(cuts.tree), after = hierarchy_of(tree);
    BOOST_TEST_REQUIRE(after.cut_order.size() == before.cut_order.size());
    std::set<Faces> parts(cuts.roots.begin(), cuts.roots.end());
    double least = 8;
    for (std::size_t node : after.cut_order) {
      double largest = -1;
      std::set<Faces> of_largest;
      for (std::size_t i : before.cut_order)
        if (parts.count(faces_of(before, i)) > 0 && before.nodes[i].salience >= largest) {
          if (before.nodes[i].salience > largest)
            of_largest.clear();
          largest = before.nodes[i].salience;
          of_largest.insert(faces_of(before, i));
        }
      least = std::min(least, largest);
      BOOST_TEST(of_largest.count(faces_of(after, node)) == 1u);
      BOOST_TEST(after.nodes[node].salience == least);
      parts.erase(faces_of(after, node));
      for (std::size_t child : after.nodes[node].children)
        parts.insert(faces_of(after, child));
    }
  });
}

BOOST_AUTO_TEST_CASE(appended_trees_stay_apart)
{
  Random random(3);
  const Random_cuts a(1, 20, 10, random), b(2, 15, 10, random);
  Merge_tree all;
  all.leaf.resize(35);
  std::vector<Index> faces_of_a, faces_of_b; // odd and even, then the rest
  for (Index f = 0; f < 35; ++f)
    (f % 2 == 0 && faces_of_b.size() < 15 ? faces_of_b : faces_of_a).push_back(f);
  append(all, a.tree, faces_of_a);
  append(all, b.tree, faces_of_b);
  BOOST_TEST(all.number_of_roots() == 3u);
  BOOST_TEST(all.merges.size() == a.cuts.size() + b.cuts.size());
  std::set<Faces> sides;
  const Cut_hierarchy h = hierarchy_of(all);
  for (std::size_t i = 0; i < h.nodes.size(); ++i)
    sides.insert(faces_of(h, i));
  const auto check = [&](const Random_cuts& cuts, const std::vector<Index>& faces) {
    for (const auto& cut : cuts.cuts)
      for (const Faces& side : cut.sides) {
        Faces in_all;
        for (Index f : side)
          in_all.insert(faces[f]);
        BOOST_TEST(sides.count(in_all) == 1u);
      }
  };
  check(a, faces_of_a);
  check(b, faces_of_b);
}

BOOST_AUTO_TEST_SUITE_END()
