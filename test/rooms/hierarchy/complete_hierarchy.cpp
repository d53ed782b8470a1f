// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Spectral_segmentation/internal/hierarchy/complete_hierarchy.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(complete_hierarchy)

namespace internal = CGAL::Spectral_segmentation::internal;

namespace {

// Node 0 is cut into 1 and 2, and 2 into 3 and 4. The five faces lie in a row.
internal::Cut_hierarchy two_cuts()
{
  internal::Cut_hierarchy result;
  result.number_of_roots = 1;
  result.nodes.resize(1);
  result.nodes[0].area = 5;
  result.cut(0, 2, 3);
  result.cut(2, 1, 2);
  for (std::size_t i : {0, 2})
    result.nodes[i].cut_state = internal::Cut_state::CUT;
  result.cut_order = {0, 2, 1};
  result.leaf = {1, 1, 3, 4, 4};
  return result;
}

// Returns the hierarchy as a file has it, without parents.
internal::Cut_hierarchy without_parents(internal::Cut_hierarchy cuts)
{
  for (internal::Cut_node& node : cuts.nodes)
    node.parent = internal::null_node;
  return cuts;
}

template <class Change>
std::string error_of(const Change& change)
{
  internal::Cut_hierarchy cuts = without_parents(two_cuts());
  change(cuts);
  try {
    internal::complete_hierarchy(cuts);
  }
  catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(parents_are_set)
{
  internal::Cut_hierarchy cuts = without_parents(two_cuts());
  internal::complete_hierarchy(cuts);
  for (std::size_t i = 0; i < cuts.nodes.size(); ++i)
    BOOST_TEST(cuts.nodes[i].parent == two_cuts().nodes[i].parent);
  internal::Cut_hierarchy empty;
  BOOST_CHECK_NO_THROW(internal::complete_hierarchy(empty));
}

BOOST_AUTO_TEST_CASE(each_contradiction_is_named)
{
  typedef internal::Cut_hierarchy& C;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto check = [](const std::string& error, const char* part)
    { BOOST_TEST(error.find(part) != std::string::npos, error << " has not: " << part); };
  BOOST_TEST(error_of([](C) {}) == "");
  check(error_of([](C c) { c.number_of_roots = 6; }), "more roots");
  check(error_of([](C c) { c.number_of_roots = 2; }), "a root");
  check(error_of([](C c) { c.number_of_roots = 0; }), "not below a root");
  check(error_of([](C c) { c.nodes[0].area = -1; }), "an area is");
  check(error_of([&](C c) { c.nodes[0].area = nan; }), "an area is");
  check(error_of([&](C c) { c.nodes[0].salience = nan; }), "a salience is");
  check(error_of([](C c) { c.nodes[0].cut_state = internal::Cut_state::NO_CUT; }), "if it is cut");
  check(error_of([](C c) { c.nodes[1].cut_state = internal::Cut_state::CUT; }), "if it is cut");
  check(error_of([](C c) { c.nodes[2].children[1] = 1; }), "of two nodes");
  check(error_of([](C c) { c.nodes[2].children[0] = 4; }), "of two nodes");
  check(error_of([](C c) { c.nodes[2].children[1] = 5; }), "not exist");
  check(error_of([](C c) { c.nodes[2].children[1] = internal::null_node; }), "not exist");
  check(error_of([](C c) { std::swap(c.nodes[2].children[0], c.nodes[2].children[1]); }), "larger");
  check(error_of([](C c) { c.nodes[2].children[0] = 2; }), "of two nodes");
  check(error_of([](C c) { // a cycle that no root reaches
    c.nodes[0].children[1] = 3;
    c.nodes[0].children[0] = 1;
    c.nodes[1].area = 0;
    c.nodes[2].children[0] = 2;
    c.nodes[2].area = 0;
  }), "not below a root");
  check(error_of([](C c) { c.cut_order = {2, 0}; }), "before its parent");
  check(error_of([](C c) { c.cut_order = {0, 2, 2}; }), "twice");
  check(error_of([](C c) { c.cut_order = {0, 2, 5}; }), "order of cuts");
  check(error_of([](C c) { c.cut_order = {0}; }), "missing");
  check(error_of([](C c) { c.leaf[0] = 2; }), "in no leaf");
  check(error_of([](C c) { c.leaf[0] = 5; }), "in no leaf");
  check(error_of([](C c) { c.leaf[2] = 4; }), "has no face");
}

BOOST_AUTO_TEST_SUITE_END()
