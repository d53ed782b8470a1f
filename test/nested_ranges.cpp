// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Spectral_segmentation/internal/search/Cut_hierarchy.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(nested_ranges)

namespace tt = boost::test_tools;
using namespace CGAL::Spectral_segmentation::internal;

namespace {

typedef std::vector<Index> Elements;

Elements elements(const Nested_ranges& ranges, std::size_t node)
{ return Elements(ranges[node].begin(), ranges[node].end()); }

// A random forest with the elements of each node, one by one: those of a leaf ascend, those of
// another node are those of its first child, then those of its second.
struct Forest
{
  Cut_hierarchy hierarchy;
  std::vector<Elements> of_node;

  Forest(std::size_t roots, std::size_t number_of_elements, std::size_t cuts, std::mt19937& random)
  {
    std::vector<Index> component(number_of_elements);
    for (Index& c : component)
      c = Index(random() % roots); // some roots may have no element
    hierarchy = uncut_hierarchy(component, std::vector<double>(roots, 0));
    for (; cuts > 0; --cuts) {
      std::size_t node = random() % hierarchy.nodes.size();
      while (!hierarchy.nodes[node].is_leaf())
        node = hierarchy.nodes[node].children[random() % 2];
      hierarchy.cut(node, 0, 0);
      for (Index& leaf : hierarchy.leaf)
        if (leaf == node)
          leaf = Index(hierarchy.nodes[node].children[random() % 2]);
    }
    of_node.resize(hierarchy.nodes.size());
    for (Index e = 0; e < number_of_elements; ++e)
      of_node[hierarchy.leaf[e]].push_back(e);
    for (std::size_t i = of_node.size(); i-- > 0;)
      if (!hierarchy.nodes[i].is_leaf())
        for (std::size_t child : hierarchy.nodes[i].children)
          of_node[i].insert(of_node[i].end(), of_node[child].begin(), of_node[child].end());
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(ranges_are_the_elements_of_the_nodes_of_a_random_forest)
{
  for (unsigned seed = 1; seed <= 60; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      std::mt19937 random(seed);
      const Forest forest(1 + random() % 5, random() % 200, random() % 40, random);
      const Nested_ranges ranges(forest.hierarchy, forest.hierarchy.leaf);
      BOOST_TEST(ranges.size() == forest.hierarchy.leaf.size());
      for (std::size_t i = 0; i < forest.of_node.size(); ++i) {
        BOOST_TEST(ranges.size(i) == forest.of_node[i].size());
        BOOST_TEST(elements(ranges, i) == forest.of_node[i], tt::per_element());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(cuts_keep_the_order_of_the_elements_and_nest)
{
  for (unsigned seed = 1; seed <= 60; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      std::mt19937 random(seed);
      const std::size_t roots = 1 + random() % 4, n = 1 + random() % 150;
      std::vector<Index> component(n);
      for (Index& c : component)
        c = Index(random() % roots);
      Cut_hierarchy hierarchy = uncut_hierarchy(component, std::vector<double>(roots, 0));
      Nested_ranges ranges(hierarchy, hierarchy.leaf);
      std::vector<Elements> of_leaf(roots); // one per node; empty once it was cut
      for (Index e = 0; e < n; ++e)
        of_leaf[component[e]].push_back(e);
      for (int i = 0; i < 20; ++i) {
        std::size_t node = random() % hierarchy.nodes.size();
        while (!hierarchy.nodes[node].is_leaf())
          node = hierarchy.nodes[node].children[random() % 2];
        std::vector<char> side(of_leaf[node].size());
        Elements sides[2];
        for (std::size_t k = 0; k < side.size(); ++k) {
          side[k] = char(random() % 2);
          sides[int(side[k])].push_back(of_leaf[node][k]);
        }
        hierarchy.cut(node, 0, 0);
        ranges.cut(node, side);
        of_leaf[node].clear();
        of_leaf.insert(of_leaf.end(), {sides[0], sides[1]});
      }
      BOOST_TEST(ranges.size() == n);
      for (std::size_t i = hierarchy.nodes.size(); i-- > 0;) {
        if (hierarchy.nodes[i].is_leaf()) {
          BOOST_TEST(elements(ranges, i) == of_leaf[i], tt::per_element());
          continue;
        }
        const auto [first, second] = hierarchy.nodes[i].children;
        BOOST_TEST((ranges[i].begin() == ranges[first].begin()));
        BOOST_TEST((ranges[first].end() == ranges[second].begin()));
        BOOST_TEST((ranges[i].end() == ranges[second].end()));
      }
      for (std::size_t root = 0; root < roots; ++root) {
        Elements all = elements(ranges, root), expected;
        std::sort(all.begin(), all.end());
        for (Index e = 0; e < n; ++e)
          if (component[e] == root)
            expected.push_back(e);
        BOOST_TEST(all == expected, tt::per_element());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(without_elements_all_ranges_are_empty)
{
  Cut_hierarchy hierarchy = uncut_hierarchy({}, {1, 2});
  hierarchy.cut(1, 1, 1);
  const Nested_ranges ranges(hierarchy, hierarchy.leaf);
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(ranges[i].empty());
  BOOST_TEST(Nested_ranges().size() == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
