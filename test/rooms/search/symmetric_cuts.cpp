// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/search/symmetric_cuts.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(symmetric_cuts)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Merge_tree;
using internal::null_node;
using internal::Partner;
using internal::Symmetric_cuts;

namespace {

// A strip or a closed band of squares.
struct Squares
{
  Surface surface;
  std::vector<std::vector<Index> > images;

  // Adds a motion that maps squares to squares.
  template <class Map>
  void add_motion(const Map& map)
  {
    images.emplace_back();
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      images.back().push_back(2 * map(f / 2) + f % 2);
  }

  // Returns a tree with a leaf for each square. Its merges join leaves.
  Merge_tree tree_of(const std::vector<Index>& leaf_of_square,
                     const std::vector<std::pair<Index, Index> >& merges,
                     const std::vector<double>& saliences) const
  {
    Merge_tree result;
    result.leaves.resize(merges.size() + 1);
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      result.leaf.push_back(leaf_of_square[f / 2]);
    internal::set_areas_of_leaves(result, surface);
    for (std::size_t i = 0; i < merges.size(); ++i)
      result.merges.push_back({{merges[i].first, merges[i].second}, saliences[i], {}});
    return result;
  }

  // Returns a tree whose leaves are sets of successive squares, which begin at some squares.
  Merge_tree tree(const std::vector<Index>& first_squares,
                  const std::vector<std::pair<Index, Index> >& merges,
                  const std::vector<double>& saliences) const
  {
    std::vector<Index> leaf;
    for (Index square = 0; 2 * square < surface.number_of_faces(); ++square)
      leaf.push_back(static_cast<Index>(
        std::upper_bound(first_squares.begin(), first_squares.end(), square) -
        first_squares.begin() - 1));
    return tree_of(leaf, merges, saliences);
  }
};

// Returns squares in a row, which the reflection in its middle maps to itself.
Squares make_strip(Index n = 10)
{
  Squares result{surface_of(plate(n, 1)), {}};
  result.add_motion([n](Index square) { return n - 1 - square; });
  return result;
}

// Returns a band of twelve squares around an axis, and at each another one, which is the next by
// number. Thirds of a turn map them to themselves.
Squares make_gear()
{
  Squares result{surface_of(twisted_band(12, 2, 0)), {}};
  result.add_motion([](Index square) { return (square + 8) % 24; });
  result.add_motion([](Index square) { return (square + 16) % 24; });
  return result;
}

std::vector<std::size_t> cuts_of(const std::vector<Partner>& partners)
{
  std::vector<std::size_t> result;
  for (const Partner& partner : partners)
    result.push_back(partner.cut);
  return result;
}

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
  const Squares strip = make_strip();
  // two squares | five | three: the image of the first two is most of the last three
  const Merge_tree tree = strip.tree({0, 2, 7}, {{1, 2}, {0, 1}}, {0.3, 0.8});
  BOOST_TEST(cuts_of(Symmetric_cuts(strip.surface, tree, strip.images).partners()) ==
             (std::vector<std::size_t>{1, null_node}), tt::per_element());
}

// The last part is the larger side of the cut of the rest.
BOOST_AUTO_TEST_CASE(a_larger_side_may_be_the_partner)
{
  const Squares strip = make_strip();
  const Merge_tree tree = strip.tree({0, 4, 6}, {{1, 2}, {0, 1}}, {0.3, 0.8});
  BOOST_TEST(cuts_of(Symmetric_cuts(strip.surface, tree, strip.images).partners()) ==
             (std::vector<std::size_t>{1, null_node}), tt::per_element());
}

// The last four squares are cut off, and then divided. The division is no partner of the first cut.
BOOST_AUTO_TEST_CASE(a_cut_within_the_image_is_no_partner)
{
  const Squares strip = make_strip();
  const Merge_tree tree = strip.tree({0, 4, 6, 9}, {{2, 3}, {1, 2}, {0, 1}}, {0.1, 0.3, 0.8});
  BOOST_TEST(cuts_of(Symmetric_cuts(strip.surface, tree, strip.images).partners()) ==
             (std::vector<std::size_t>{null_node, 2, null_node}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(a_side_in_the_middle_has_no_partner)
{
  const Squares strip = make_strip();
  const Merge_tree tree = strip.tree({0, 3, 6}, {{1, 0}, {0, 2}}, {0.3, 0.8});
  BOOST_TEST(cuts_of(Symmetric_cuts(strip.surface, tree, strip.images).partners()) ==
             (std::vector<std::size_t>{null_node, null_node}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(the_region_at_the_other_end_is_divided)
{
  const Squares strip = make_strip();
  const auto divided = [&](double salience, double minimum_area) {
    const Merge_tree tree = strip.tree({0, 2}, {{0, 1}}, {salience});
    const double area_of_square = 2 * strip.surface.areas[0];
    return of_squares(Symmetric_cuts(strip.surface, tree, strip.images)
                        .divided_leaves(minimum_area * area_of_square));
  };
  const std::vector<Index> before = {0, 0, 1, 1, 1, 1, 1, 1, 1, 1},
                           after = {0, 0, 1, 1, 1, 1, 1, 1, 2, 2};
  BOOST_TEST(divided(0.9, 0) == after, tt::per_element());
  BOOST_TEST(divided(0.9, 2) == after, tt::per_element());
  BOOST_TEST(divided(0.9, 2.1) == before, tt::per_element()); // the new region is too small
  BOOST_TEST(divided(0.1, 0) == before, tt::per_element());   // the cut is hardly made
}

BOOST_AUTO_TEST_CASE(a_region_whose_cut_is_a_partner_stays)
{
  const Squares strip = make_strip();
  const Merge_tree tree = strip.tree({0, 2, 7}, {{1, 2}, {0, 1}}, {0.3, 0.8});
  BOOST_TEST(Symmetric_cuts(strip.surface, tree, strip.images).divided_leaves(0) == tree.leaf,
             tt::per_element());
}

// The image is the last three squares. One of them is a region already.
BOOST_AUTO_TEST_CASE(an_image_divides_each_region_that_it_does_not_fill)
{
  const Squares strip = make_strip(20);
  const Merge_tree tree =
    strip.tree({0, 3, 10, 19}, {{2, 3}, {1, 2}, {0, 1}}, {0.1, 0.1, 0.8});
  std::vector<Index> expected = of_squares(tree.leaf);
  expected[17] = expected[18] = 4;
  BOOST_TEST(of_squares(Symmetric_cuts(strip.surface, tree, strip.images).divided_leaves(0)) ==
             expected, tt::per_element());
}

// The last three of the seven squares of the image are cut off: they may be meant as the partner.
BOOST_AUTO_TEST_CASE(a_region_with_a_similar_cut_stays)
{
  const Squares strip = make_strip(40);
  const Merge_tree tree = strip.tree({0, 7, 37}, {{1, 2}, {0, 1}}, {0.1, 0.8});
  const Merge_tree other = strip.tree({0, 7, 38}, {{1, 2}, {0, 1}}, {0.1, 0.8});
  BOOST_TEST(Symmetric_cuts(strip.surface, other, strip.images).divided_leaves(0) != other.leaf);
  BOOST_TEST(Symmetric_cuts(strip.surface, tree, strip.images).divided_leaves(0) == tree.leaf,
             tt::per_element());
}

// A tooth of two squares is cut off.
BOOST_AUTO_TEST_CASE(images_under_rotations_become_regions)
{
  const Squares gear = make_gear();
  std::vector<Index> leaf(24, 0);
  leaf[1] = leaf[3] = 1;
  const Merge_tree tree = gear.tree_of(leaf, {{0, 1}}, {0.8});
  const std::vector<Index> regions =
    of_squares(Symmetric_cuts(gear.surface, tree, gear.images).divided_leaves(0));
  leaf[9] = leaf[11] = regions[9];
  leaf[17] = leaf[19] = regions[17];
  BOOST_TEST(regions == leaf, tt::per_element());
  BOOST_TEST(regions[9] + regions[17] == 5u); // the regions 2 and 3
}

// Three teeth of two squares are cut off, and a square elsewhere.
BOOST_AUTO_TEST_CASE(images_under_rotations_are_partners)
{
  const Squares gear = make_gear();
  std::vector<Index> leaf(24, 0);
  for (Index i : {0, 1, 2})
    leaf[8 * i + 1] = leaf[8 * i + 3] = i + 1;
  leaf[5] = 4;
  const Merge_tree tree =
    gear.tree_of(leaf, {{0, 3}, {0, 4}, {0, 1}, {0, 2}}, {0.1, 0.3, 0.5, 0.8});
  const std::vector<Partner> partners =
    Symmetric_cuts(gear.surface, tree, gear.images).partners();
  BOOST_TEST(cuts_of(partners) == (std::vector<std::size_t>{3, null_node, 3, null_node}),
             tt::per_element());
  BOOST_TEST(partners[0].motion != partners[2].motion);
}

BOOST_AUTO_TEST_CASE(the_seam_of_the_less_salient_partner_moves)
{
  const Squares strip = make_strip();
  const auto moved = [&](const Merge_tree& tree, double minimum_area = 0) {
    const double area_of_square = 2 * strip.surface.areas[0];
    Symmetric_cuts cuts(strip.surface, tree, strip.images);
    return of_squares(cuts.moved_leaves(cuts.partners(), minimum_area * area_of_square));
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
  const Squares strip = make_strip();
  const Merge_tree tree = strip.tree({0, 2, 8}, {{1, 2}, {0, 1}}, {0.25, 0.75});
  const auto saliences = [&](const std::vector<Partner>& partners) {
    std::vector<double> result;
    for (const internal::Merge& m :
         internal::merge_symmetrically(strip.surface, tree, partners).merges)
      result.push_back(m.salience);
    return result;
  };
  BOOST_TEST(saliences({{1, 0, 0}, {}}) == (std::vector<double>{0.5, 0.5}), tt::per_element());
  BOOST_TEST(saliences({{}, {}}) == (std::vector<double>{0.25, 0.75}), tt::per_element());
}

// The last two squares hang on one half of the rest. They stay apart when both halves are merged.
BOOST_AUTO_TEST_CASE(a_partner_below_a_weak_cut_is_cut)
{
  const Squares strip = make_strip();
  Merge_tree tree =
    strip.tree({0, 2, 5, 8}, {{2, 3}, {1, 2}, {0, 1}}, {0.1, 0.1, 0.8});
  tree = internal::merge_symmetrically(strip.surface, std::move(tree), {{2, 0, 0}, {}, {}});
  BOOST_TEST_REQUIRE(tree.merges.size() == 3);
  BOOST_TEST(tree.merges[0].salience == 0.1);
  BOOST_TEST(tree.merges[0].leaves[0] == 1);
  BOOST_TEST(tree.merges[0].leaves[1] == 2);
  BOOST_TEST(tree.merges[1].salience == 0.45, tt::tolerance(1e-12));
  BOOST_TEST(tree.merges[2].salience == 0.45, tt::tolerance(1e-12));
}

// The first two squares are cut off the first four, whose boundary becomes less salient.
BOOST_AUTO_TEST_CASE(a_cut_stays_if_the_cut_above_it_becomes_less_salient)
{
  const Squares strip = make_strip();
  Merge_tree tree =
    strip.tree({0, 2, 4, 8}, {{0, 1}, {2, 3}, {1, 2}}, {0.6, 0.25, 0.75});
  tree = internal::merge_symmetrically(strip.surface, std::move(tree), {{}, {2, 0, 0}, {}});
  BOOST_TEST_REQUIRE(tree.merges.size() == 3);
  BOOST_TEST(tree.merges[0].salience == 0.5);
  BOOST_TEST(tree.merges[1].salience == 0.5);
  BOOST_TEST(tree.merges[2].salience == 0.6);
  BOOST_TEST(tree.merges[2].leaves[0] == 0);
  BOOST_TEST(tree.merges[2].leaves[1] == 1);
}

BOOST_AUTO_TEST_SUITE_END()
