// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Spectral_segmentation/internal/search/Cut_hierarchy.h>

#include <cstddef>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(cut_hierarchy)

namespace tt = boost::test_tools;
using namespace CGAL::Spectral_segmentation::internal;

BOOST_AUTO_TEST_CASE(without_cuts_there_are_only_roots)
{
  const std::vector<Index> component = {0, 1, 0, 2, 1};
  const Cut_hierarchy hierarchy = uncut_hierarchy(component, {4, 1, 9});
  BOOST_TEST(hierarchy.number_of_roots == 3u);
  BOOST_TEST(hierarchy.number_of_segments() == 3u);
  BOOST_TEST(hierarchy.leaf == component, tt::per_element());
  BOOST_TEST_REQUIRE(hierarchy.nodes.size() == 3u);
  const double areas[] = {4, 1, 9};
  for (std::size_t i = 0; i < 3; ++i) {
    const Cut_node& n = hierarchy.nodes[i];
    BOOST_TEST(n.is_leaf());
    BOOST_TEST(n.parent == null_node);
    BOOST_TEST(n.area == areas[i]);
    BOOST_TEST((n.cut_state == Cut_state::NOT_SEARCHED));
  }
  BOOST_TEST(uncut_hierarchy({}, {}).number_of_segments() == 0u);
}

// The parent and the areas of the i-th cut are kept beside the hierarchy.
BOOST_AUTO_TEST_CASE(the_children_of_the_ith_cut_follow_the_roots_in_pairs)
{
  struct Naive_cut
  {
    std::size_t parent;
    double smaller, larger;
  };
  for (unsigned seed = 1; seed <= 20; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      std::mt19937 random(seed);
      const std::size_t roots = 1 + random() % 4;
      Cut_hierarchy hierarchy = uncut_hierarchy({}, std::vector<double>(roots, 1));
      std::vector<std::size_t> leaves(roots);
      for (std::size_t i = 0; i < roots; ++i)
        leaves[i] = i;
      std::vector<Naive_cut> cuts;
      for (int i = 0; i < 30; ++i) {
        std::swap(leaves[random() % leaves.size()], leaves.back());
        const std::size_t parent = leaves.back();
        leaves.pop_back();
        const double smaller = double(random() % 100), larger = smaller + double(random() % 100);
        hierarchy.cut(parent, smaller, larger);
        cuts.push_back({parent, smaller, larger});
        leaves.insert(leaves.end(), {hierarchy.nodes.size() - 2, hierarchy.nodes.size() - 1});
        BOOST_TEST(hierarchy.number_of_segments() == leaves.size());
      }
      BOOST_TEST_REQUIRE(hierarchy.nodes.size() == roots + 2 * cuts.size());
      std::vector<bool> is_cut(hierarchy.nodes.size(), false);
      for (std::size_t i = 0; i < cuts.size(); ++i) {
        const std::size_t first = roots + 2 * i;
        is_cut[cuts[i].parent] = true;
        BOOST_TEST(hierarchy.nodes[cuts[i].parent].children[0] == first);
        BOOST_TEST(hierarchy.nodes[cuts[i].parent].children[1] == first + 1);
        for (std::size_t child : {first, first + 1})
          BOOST_TEST(hierarchy.nodes[child].parent == cuts[i].parent);
        BOOST_TEST(hierarchy.nodes[first].area == cuts[i].smaller);
        BOOST_TEST(hierarchy.nodes[first + 1].area == cuts[i].larger);
      }
      for (std::size_t i = 0; i < is_cut.size(); ++i)
        BOOST_TEST(hierarchy.nodes[i].is_leaf() == !is_cut[i]);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
