// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>

#include <cstddef>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(cut_hierarchy)

namespace tt = boost::test_tools;
using namespace CGAL::Spectral_segmentation::internal;

namespace {

typedef std::vector<Index> Faces;

Faces faces(const Nested_ranges& ranges, std::size_t node)
{ return Faces(ranges[node].begin(), ranges[node].end()); }

// A random forest with the faces of each node, one by one. The faces of a leaf ascend; another node
// has the faces of its first child, then the faces of its second.
struct Forest
{
  Cut_hierarchy hierarchy;
  std::vector<Faces> of_node;

  Forest(std::size_t roots, std::size_t number_of_faces, std::size_t cuts, std::mt19937& random)
  {
    std::vector<Index> component(number_of_faces);
    for (Index& c : component)
      c = Index(random() % roots); // some roots may have no face
    hierarchy.number_of_roots = roots;
    hierarchy.nodes.resize(roots);
    hierarchy.leaf = component;
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
    for (Index e = 0; e < number_of_faces; ++e)
      of_node[hierarchy.leaf[e]].push_back(e);
    for (std::size_t i = of_node.size(); i-- > 0;)
      if (!hierarchy.nodes[i].is_leaf())
        for (std::size_t child : hierarchy.nodes[i].children)
          of_node[i].insert(of_node[i].end(), of_node[child].begin(), of_node[child].end());
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(ranges_are_the_faces_of_the_nodes_of_a_random_forest)
{
  for (unsigned seed = 1; seed <= 60; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      std::mt19937 random(seed);
      const Forest forest(1 + random() % 5, random() % 200, random() % 40, random);
      const Nested_ranges ranges(forest.hierarchy);
      BOOST_TEST(ranges.size() == forest.hierarchy.leaf.size());
      for (std::size_t i = 0; i < forest.of_node.size(); ++i) {
        BOOST_TEST(ranges.size(i) == forest.of_node[i].size());
        BOOST_TEST(faces(ranges, i) == forest.of_node[i], tt::per_element());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(all_ranges_are_empty_without_faces)
{
  Cut_hierarchy hierarchy;
  hierarchy.number_of_roots = 2;
  hierarchy.nodes.resize(2);
  hierarchy.cut(1, 1, 1);
  const Nested_ranges ranges(hierarchy);
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(ranges[i].empty());
  BOOST_TEST(Nested_ranges().size() == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
