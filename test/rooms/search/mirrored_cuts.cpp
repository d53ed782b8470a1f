// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/search/mirrored_cuts.h>

#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(mirrored_cuts)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Merge_tree;
using internal::Mirrored_cuts;
using internal::null_node;

namespace {

// A strip of ten squares, which the reflection in its middle maps to itself. Its parts are sets of
// successive squares.
struct Strip
{
  Surface surface = surface_of(plate(10, 1));
  std::vector<Index> image;

  Strip()
  {
    for (Index f = 0; f < 20; ++f)
      image.push_back(2 * (9 - f / 2) + f % 2);
  }

  // Returns a tree whose leaves begin at some squares. Its merges join leaves.
  Merge_tree tree(const std::vector<Index>& first_squares,
                  const std::vector<std::pair<Index, Index> >& merges,
                  const std::vector<double>& saliences) const
  {
    Merge_tree result;
    result.leaves.resize(first_squares.size());
    for (Index f = 0; f < 20; ++f) {
      Index leaf = 0;
      while (leaf + 1 < first_squares.size() && first_squares[leaf + 1] <= f / 2)
        ++leaf;
      result.leaf.push_back(leaf);
    }
    internal::set_areas_of_leaves(result, surface);
    for (std::size_t i = 0; i < merges.size(); ++i)
      result.merges.push_back({{merges[i].first, merges[i].second}, saliences[i], {}});
    return result;
  }
};

std::vector<Index> of_squares(const std::vector<Index>& leaf)
{
  std::vector<Index> result;
  for (std::size_t f = 0; f < leaf.size(); f += 2) {
    BOOST_TEST(leaf[f] == leaf[f + 1]);
    result.push_back(leaf[f]);
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(both_ends_are_partners)
{
  const Strip strip;
  // two squares | five | three: the image of the first two is most of the last three
  const Merge_tree tree = strip.tree({0, 2, 7}, {{1, 2}, {0, 1}}, {0.3, 0.8});
  BOOST_TEST(Mirrored_cuts(strip.surface, tree, strip.image).partners() ==
             (std::vector<std::size_t>{1, 0}), tt::per_element());
}

// The last part is the larger side of the cut of the rest.
BOOST_AUTO_TEST_CASE(a_larger_side_may_be_the_partner)
{
  const Strip strip;
  const Merge_tree tree = strip.tree({0, 4, 6}, {{1, 2}, {0, 1}}, {0.3, 0.8});
  BOOST_TEST(Mirrored_cuts(strip.surface, tree, strip.image).partners() ==
             (std::vector<std::size_t>{1, 0}), tt::per_element());
}

// The last four squares are cut off, and then divided. The division is no partner of the first cut.
BOOST_AUTO_TEST_CASE(a_cut_within_the_image_is_no_partner)
{
  const Strip strip;
  const Merge_tree tree = strip.tree({0, 4, 6, 9}, {{2, 3}, {1, 2}, {0, 1}}, {0.1, 0.3, 0.8});
  BOOST_TEST(Mirrored_cuts(strip.surface, tree, strip.image).partners() ==
             (std::vector<std::size_t>{null_node, 2, 1}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(a_side_in_the_middle_has_no_partner)
{
  const Strip strip;
  const Merge_tree tree = strip.tree({0, 3, 6}, {{1, 0}, {0, 2}}, {0.3, 0.8});
  BOOST_TEST(Mirrored_cuts(strip.surface, tree, strip.image).partners() ==
             (std::vector<std::size_t>{null_node, null_node}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(the_region_at_the_other_end_is_divided)
{
  const Strip strip;
  const auto divided = [&](double salience, double minimum_area) {
    const Merge_tree tree = strip.tree({0, 2}, {{0, 1}}, {salience});
    const double area_of_square = 2 * strip.surface.areas[0];
    return of_squares(Mirrored_cuts(strip.surface, tree, strip.image)
                        .divided_leaves(minimum_area * area_of_square));
  };
  const std::vector<Index> before = {0, 0, 1, 1, 1, 1, 1, 1, 1, 1},
                           after = {0, 0, 1, 1, 1, 1, 1, 1, 2, 2};
  BOOST_TEST(divided(0.9, 0) == after, tt::per_element());
  BOOST_TEST(divided(0.9, 2) == after, tt::per_element());
  BOOST_TEST(divided(0.9, 2.1) == before, tt::per_element()); // the new region is too small
  BOOST_TEST(divided(0.1, 0) == before, tt::per_element());   // the cut is hardly made
}

// A third square is cut off at the other end: this may be meant to be the partner.
BOOST_AUTO_TEST_CASE(a_region_with_a_similar_cut_stays)
{
  const Strip strip;
  const Merge_tree tree = strip.tree({0, 2, 7}, {{1, 2}, {0, 1}}, {0.3, 0.8});
  BOOST_TEST(Mirrored_cuts(strip.surface, tree, strip.image).divided_leaves(0) == tree.leaf,
             tt::per_element());
}

BOOST_AUTO_TEST_CASE(the_seam_of_the_less_salient_partner_moves)
{
  const Strip strip;
  const auto moved = [&](const Merge_tree& tree, double minimum_area = 0) {
    const double area_of_square = 2 * strip.surface.areas[0];
    Mirrored_cuts cuts(strip.surface, tree, strip.image);
    return of_squares(cuts.mirrored_leaves(cuts.partners(), minimum_area * area_of_square));
  };
  const Merge_tree tree = strip.tree({0, 2, 7}, {{1, 2}, {0, 1}}, {0.3, 0.8});
  const std::vector<Index> before = {0, 0, 1, 1, 1, 1, 1, 2, 2, 2},
                           after = {0, 0, 1, 1, 1, 1, 1, 1, 2, 2};
  BOOST_TEST(moved(tree) == after, tt::per_element());
  BOOST_TEST(moved(tree, 2) == after, tt::per_element());
  BOOST_TEST(moved(tree, 2.1) == before, tt::per_element()); // the last part is too small

  const Merge_tree other = strip.tree({0, 3, 8}, {{1, 2}, {0, 1}}, {0.3, 0.8});
  BOOST_TEST(moved(other) == (std::vector<Index>{0, 0, 0, 1, 1, 1, 1, 2, 2, 2}),
             tt::per_element());

  // the part that begins at square 7 would lose its only square
  const Merge_tree divided = strip.tree({0, 2, 7, 8}, {{2, 3}, {1, 2}, {0, 1}}, {0.1, 0.3, 0.8});
  BOOST_TEST(moved(divided) == (std::vector<Index>{0, 0, 1, 1, 1, 1, 1, 2, 3, 3}),
             tt::per_element());
}

BOOST_AUTO_TEST_CASE(partners_get_the_mean_salience)
{
  const Strip strip;
  Merge_tree tree = strip.tree({0, 2, 8}, {{1, 2}, {0, 1}}, {0.25, 0.75});
  tree = internal::average_partners(std::move(tree), {1, 0});
  BOOST_TEST(tree.merges[0].salience == 0.5);
  BOOST_TEST(tree.merges[1].salience == 0.5);
  tree.merges[1].salience = 0.75;
  tree = internal::average_partners(std::move(tree), {null_node, null_node});
  BOOST_TEST(tree.merges[0].salience == 0.5);
  BOOST_TEST(tree.merges[1].salience == 0.75);
}

// The first four squares are divided by a cut that would not be made without the cut above it.
BOOST_AUTO_TEST_CASE(a_partner_keeps_the_salience_of_the_cuts_below_it)
{
  const Strip strip;
  Merge_tree tree =
    strip.tree({0, 2, 4, 8}, {{0, 1}, {2, 3}, {1, 2}}, {0.6, 0.25, 0.75});
  tree = internal::average_partners(std::move(tree), {null_node, 2, 1});
  BOOST_TEST(tree.merges[0].salience == 0.6);
  BOOST_TEST(tree.merges[1].salience == 0.5);
  BOOST_TEST(tree.merges[2].salience == 0.6);
}

BOOST_AUTO_TEST_SUITE_END()
