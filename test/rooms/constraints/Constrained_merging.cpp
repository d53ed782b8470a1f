// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/constraints/Constrained_merging.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(constrained_merging)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Constraint_groups;
using internal::Merge_tree;
using internal::null_index;

namespace {

typedef std::vector<std::vector<Index> > Groups; // the faces of each

// Returns a tree, given the leaf of each face.
Merge_tree tree_of(const Surface& mesh, const std::vector<Index>& leaf,
                   std::vector<internal::Merge> merges)
{
  Merge_tree result;
  result.leaf = leaf;
  result.leaves.resize(1 + *std::max_element(leaf.begin(), leaf.end()));
  internal::set_areas_of_leaves(result, mesh);
  result.merges = std::move(merges);
  return result;
}

Constraint_groups groups_of(const Surface& mesh, const Groups& groups)
{
  Constraint_groups result;
  result.group.assign(mesh.number_of_faces(), null_index);
  result.is_seam.assign(mesh.number_of_halfedges(), 0);
  result.sets = internal::Separated_sets(groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i)
    for (Index f : groups[i])
      result.group[f] = Index(i);
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    if (result.group[f] != null_index)
      result.faces.push_back(f);
  return result;
}

Merge_tree merged(const Surface& mesh, const Constraint_groups& groups, const Merge_tree& tree)
{
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  return internal::Constrained_merging(tree, mesh, groups, 0, monitor)();
}

// Returns the leaf of each face of squares side by side, given the first square of each leaf.
std::vector<Index> leaves_of_squares(Index number, const std::vector<Index>& first_squares)
{
  std::vector<Index> result;
  for (Index f = 0; f < 2 * number; ++f) {
    Index leaf = 0;
    while (leaf + 1 < first_squares.size() && first_squares[leaf + 1] <= f / 2)
      ++leaf;
    result.push_back(leaf);
  }
  return result;
}

// Returns the number of faces from each face to the nearest of some faces.
std::vector<int> distances_to(const Surface& mesh, const std::vector<Index>& faces)
{
  std::vector<int> result(mesh.number_of_faces(), -1);
  std::vector<Index> reached = faces;
  for (Index f : faces)
    result[f] = 0;
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h)
      if (const Index g = mesh.neighbor(h); result[g] < 0) {
        result[g] = result[reached[i]] + 1;
        reached.push_back(g);
      }
  return result;
}

bool is_connected(const Surface& mesh, const std::vector<Index>& leaf, Index value)
{
  std::vector<Index> reached;
  std::vector<char> is_reached(leaf.size(), 0);
  std::size_t size = 0;
  for (Index f = 0; f < leaf.size(); ++f)
    if (leaf[f] == value && size++ == 0) {
      reached.push_back(f);
      is_reached[f] = 1;
    }
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h)
      if (const Index g = mesh.neighbor(h); leaf[g] == value && !std::exchange(is_reached[g], 1))
        reached.push_back(g);
  return reached.size() == size;
}

} // namespace

BOOST_AUTO_TEST_CASE(faces_join_the_seed_that_is_fewer_faces_away)
{
  const Surface mesh = surface_of(plate(7, 6));
  const Index n = Index(mesh.number_of_faces());
  const Merge_tree tree = tree_of(mesh, std::vector<Index>(n, 0), {});
  for (unsigned seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const Index a = Index(random_number(random, 0, n - 1)),
                b = Index((a + random_number(random, 1, n - 1)) % n);
    Constraint_groups groups = groups_of(mesh, {{a}, {b}});
    groups.sets.set_seed(0, 3);
    groups.sets.set_seed(1, 5);
    const Merge_tree result = merged(mesh, groups, tree);
    BOOST_TEST(result.merges.empty());
    BOOST_TEST_REQUIRE(result.leaves.size() == 2u);
    const std::vector<int> to_a = distances_to(mesh, {a}), to_b = distances_to(mesh, {b});
    for (Index f = 0; f < n; ++f)
      BOOST_TEST((result.leaf[f] == result.leaf[a] ? to_a[f] <= to_b[f] : to_b[f] <= to_a[f]));
    BOOST_TEST(is_connected(mesh, result.leaf, 0));
    BOOST_TEST(is_connected(mesh, result.leaf, 1));
  }
}

// Two leaves of five squares. An edge that must be cut divides the first after two squares, and the
// rest stays with the other leaf, with the salience of the cut between the leaves.
BOOST_AUTO_TEST_CASE(a_leaf_is_divided_where_an_edge_must_be_cut)
{
  const Surface mesh = surface_of(plate(10, 1));
  const Merge_tree tree =
    tree_of(mesh, leaves_of_squares(10, {0, 5}), {{{0, 1}, 0.7, {}}});
  Index seam = 0;
  while (seam / 6 != 1 || mesh.neighbor(seam) / 2 != 2)
    ++seam;
  Constraint_groups groups = groups_of(mesh, {{seam / 3}, {mesh.neighbor(seam)}});
  groups.sets.separate(0, 1);
  groups.is_seam[seam] = groups.is_seam[mesh.opposite[seam]] = 1;
  const Merge_tree result = merged(mesh, groups, tree);
  const std::vector<Index> expected = leaves_of_squares(10, {0, 2, 5});
  for (Index f = 0; f < 20; ++f)
    for (Index g = 0; g < 20; ++g)
      BOOST_TEST((result.leaf[f] == result.leaf[g]) == (expected[f] == expected[g]));
  BOOST_TEST_REQUIRE(result.merges.size() == 1u);
  BOOST_TEST(result.merges[0].salience == 0.7);
  const std::set<Index> joined(result.merges[0].leaves, result.merges[0].leaves + 2);
  BOOST_TEST((joined == std::set<Index>{result.leaf[6], result.leaf[19]}));
}

// A group of faces in two leaves joins them. The cut between them is lost, the other one stays.
BOOST_AUTO_TEST_CASE(leaves_of_a_group_are_one)
{
  const Surface mesh = surface_of(plate(10, 1));
  const Merge_tree tree = tree_of(mesh, leaves_of_squares(10, {0, 3, 6}),
                                  {{{0, 1}, 0.3, {}}, {{1, 2}, 0.8, {}}});
  const Merge_tree result = merged(mesh, groups_of(mesh, {{4, 5, 6, 7}}), tree);
  BOOST_TEST(result.leaf == leaves_of_squares(10, {0, 6}), tt::per_element());
  BOOST_TEST_REQUIRE(result.merges.size() == 1u);
  BOOST_TEST(result.merges[0].salience == 0.8);
}

// The outer leaves have different seeds. The leaf between them is merged again.
BOOST_AUTO_TEST_CASE(only_cuts_between_different_seeds_stay)
{
  const Surface mesh = surface_of(plate(9, 1));
  const Merge_tree tree = tree_of(mesh, leaves_of_squares(9, {0, 3, 6}),
                                  {{{1, 2}, 0.2, {}}, {{0, 1}, 0.6, {}}});
  Constraint_groups groups = groups_of(mesh, {{0}, {17}});
  groups.sets.set_seed(0, 1);
  groups.sets.set_seed(1, 2);
  const Merge_tree result = merged(mesh, groups, tree);
  BOOST_TEST(result.leaves.size() == 3u);
  BOOST_TEST_REQUIRE(result.merges.size() == 1u);
  BOOST_TEST(result.merges[0].salience == 0.2);
}

BOOST_AUTO_TEST_SUITE_END()
