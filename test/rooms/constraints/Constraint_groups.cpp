// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/constraints/Constraint_groups.h>

#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(constraint_groups)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Constraint_groups;
using internal::null_index;

namespace {

// Groups of single faces, the first two of which must be in one segment.
Constraint_groups groups_of(const Surface& mesh, const std::vector<Index>& faces)
{
  Constraint_groups result;
  result.group.assign(mesh.number_of_faces(), null_index);
  result.is_seam.assign(mesh.number_of_halfedges(), 0);
  result.sets = internal::Separated_sets(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    result.group[faces[i]] = Index(i);
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    if (result.group[f] != null_index)
      result.faces.push_back(f);
  result.sets.merge(0, 1);
  return result;
}

Constraint_groups joined(const Surface& mesh, const std::vector<Index>& leaf,
                         std::size_t number_of_leaves, const Constraint_groups& groups)
{
  std::vector<Index> callers_face(mesh.number_of_faces());
  std::iota(callers_face.begin(), callers_face.end(), Index(0));
  return internal::Group_connection(mesh, leaf, number_of_leaves, groups)(callers_face);
}

// The cost of the cheapest path between two faces over allowed faces (Bellman and Ford): a step
// costs 1, and one into another leaf 1000.
double cheapest(const Surface& mesh, const std::vector<Index>& leaf,
                const std::vector<char>& is_allowed, Index from, Index to)
{
  std::vector<double> cost(mesh.number_of_faces(), std::numeric_limits<double>::infinity());
  cost[from] = 0;
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h) {
      const Index f = h / 3, g = mesh.neighbor(h);
      const double via_f = cost[f] + (leaf[f] == leaf[g] ? 1 : 1000);
      if (is_allowed[f] && is_allowed[g] && via_f < cost[g]) {
        cost[g] = via_f;
        has_changed = true;
      }
    }
  }
  return cost[to];
}

} // namespace

BOOST_AUTO_TEST_CASE(a_set_is_joined_by_the_path_over_the_fewest_leaves_then_the_fewest_faces)
{
  const Surface mesh = surface_of(plate(9, 7));
  const Index n = Index(mesh.number_of_faces());
  for (unsigned seed = 0; seed < 40; ++seed) {
    Random random(seed);
    std::vector<Index> leaf(n);
    for (Index& l : leaf)
      l = Index(random_number(random, 0, 3));
    const Index from = Index(random_number(random, 0, n - 1)), to = (from + n / 2) % n;
    const Constraint_groups groups = joined(mesh, leaf, 4, groups_of(mesh, {from, to}));
    std::vector<char> is_in_group(n), all(n, 1);
    for (Index f = 0; f < n; ++f)
      is_in_group[f] = groups.group[f] != null_index;
    BOOST_TEST(groups.set(from) == groups.set(to));
    BOOST_TEST(cheapest(mesh, leaf, is_in_group, from, to) ==
               cheapest(mesh, leaf, all, from, to));
  }
}

BOOST_AUTO_TEST_CASE(a_path_avoids_sets_that_are_separated_from_its_own)
{
  const Surface mesh = surface_of(plate(9, 1)); // a strip of 18 faces, which faces 1 and 16 end
  const std::vector<Index> leaf(18, 0);
  Constraint_groups groups = groups_of(mesh, {0, 17, 8});
  BOOST_TEST(joined(mesh, leaf, 1, groups).faces.size() == 16u); // it absorbs the third group
  groups.sets.separate(0, 2);
  BOOST_CHECK_THROW(joined(mesh, leaf, 1, groups), std::invalid_argument);

  const Surface wide = surface_of(plate(9, 2));
  Constraint_groups around = groups_of(wide, {0, 17, 8});
  around.sets.separate(0, 2);
  const Constraint_groups result = joined(wide, std::vector<Index>(36, 0), 1, around);
  BOOST_TEST(result.group[8] == 2u);
  BOOST_TEST(result.set(0) == result.set(17));
}

BOOST_AUTO_TEST_SUITE_END()
