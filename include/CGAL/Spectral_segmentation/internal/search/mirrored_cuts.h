// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_MIRRORED_CUTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_MIRRORED_CUTS_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/salience/Patch.h>
#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The cuts of a tree in a surface that is, but for details, its own mirror image. The partner of a
// cut has a side that is the mirror image of the smaller side of the cut. The search finds cuts one
// by one, so that the cut of one horn may be among the regions, and its partner not.
class Mirrored_cuts
{
  // The intersection over union of a mirror image with a side of its partner, and with a side of a
  // cut that is similar to a partner
  static constexpr double least_overlap = 0.5, least_overlap_of_similar = 0.4;
  // A cut within the mirror image is no partner: both its sides together overlap as much.
  static constexpr double largest_overlap_of_both = 0.8; // relative to that of one
  static constexpr double largest_common = 0.3;   // fraction of a side that is its own mirror image
  static constexpr double least_inside = 0.7;     // fraction of the image in the divided region
  static constexpr double least_new_region = 0.25; // relative to the image

  const Surface& surface_;
  const Merge_tree& tree_;
  const std::vector<Index>& image_; // the face to which each face is mapped, or null_index
  const Merged_sets sets_;
  std::vector<Index> leaf_;         // of each face: that of the tree, until seams are moved
  std::vector<char> is_mirrored_;   // the faces of the mirror image of the current side
  double area_ = 0;                 // its area
  std::vector<double> area_before_; // of it in the leaves before each position

  bool is_in(const Merged_set& set, Index f) const
  {
    const Index position = sets_.position[leaf_[f]];
    return position >= set.first && position < set.end;
  }

  // Sets the mirror image of the smaller side of a cut. Returns whether it is elsewhere.
  bool set_image(std::size_t cut)
  {
    const Merged_set& side = sets_.sides[cut][0];
    std::vector<double> areas(tree_.leaves.size(), 0); // by position
    area_ = 0;
    for (Index f = 0; f < image_.size(); ++f) {
      is_mirrored_[f] = image_[f] != null_index && is_in(side, image_[f]);
      if (is_mirrored_[f]) {
        areas[sets_.position[leaf_[f]]] += surface_.areas[f];
        area_ += surface_.areas[f];
      }
    }
    area_before_.assign(1, 0);
    for (double area : areas)
      area_before_.push_back(area_before_.back() + area);
    return area_in(side) <= largest_common * side.area;
  }

  double area_in(const Merged_set& set) const
  { return area_before_[set.end] - area_before_[set.first]; }

  double overlap_with(const Merged_set& set) const
  {
    const double common = area_in(set);
    return common / (area_ + set.area - common);
  }

  // Returns the cut that separates the mirror image from other faces; null_node if there is none.
  std::size_t cut_of_image(double least) const
  {
    std::size_t result = null_node;
    double best = least;
    for (std::size_t i = 0; i < sets_.sides.size(); ++i) {
      const auto& [smaller, larger] = sets_.sides[i];
      const double overlap = quantized((std::max)(overlap_with(smaller), overlap_with(larger)));
      if (overlap > best &&
          overlap_with(sets_.union_of(i)) < largest_overlap_of_both * overlap) {
        best = overlap;
        result = i;
      }
    }
    return result;
  }

  // Moves all pieces of side 1 or 2 but the largest to the other of these sides. Side 0 has the
  // faces outside of the region.
  void keep_largest(Sides& sides, char side) const
  {
    const Components pieces = connected_components(surface_, sides);
    std::vector<double> areas = component_areas(surface_, pieces);
    for (Index f = 0; f < sides.size(); ++f)
      if (sides[f] != side)
        areas[pieces[f]] = -1;
    const std::size_t largest = static_cast<std::size_t>(
      std::max_element(areas.begin(), areas.end()) - areas.begin());
    for (Index f = 0; f < sides.size(); ++f)
      if (sides[f] == side && pieces[f] != largest)
        sides[f] = static_cast<char>(3 - side);
  }

  // Divides the region with most of the mirror image along the boundary of the image. Both pieces
  // are connected; if one is too small, the region stays.
  void divide(std::vector<Index>& regions, Index& number, double minimum_area) const
  {
    std::vector<double> inside(number, 0);
    for (Index f = 0; f < regions.size(); ++f)
      inside[regions[f]] += is_mirrored_[f] ? surface_.areas[f] : 0;
    const auto largest = std::max_element(inside.begin(), inside.end());
    if (*largest < least_inside * area_)
      return;
    const Index region = static_cast<Index>(largest - inside.begin());
    Sides sides;
    for (Index f = 0; f < regions.size(); ++f)
      sides.push_back(static_cast<char>(regions[f] != region ? 0 : is_mirrored_[f] ? 1 : 2));
    keep_largest(sides, 1);
    keep_largest(sides, 2);
    double areas[3] = {0, 0, 0};
    for (Index f = 0; f < regions.size(); ++f)
      areas[int(sides[f])] += surface_.areas[f];
    const double smaller = (std::min)(areas[1], areas[2]);
    if (!(smaller > 0) || smaller < (std::max)(minimum_area, least_new_region * area_))
      return;
    for (Index f = 0; f < regions.size(); ++f)
      if (sides[f] == 1)
        regions[f] = number;
    ++number;
  }

  // Returns the sides of a cut whose seam is the boundary of the mirror image that is set: 0 or 1,
  // and 2 outside of the region. Faces without mirror image stay.
  Sides mirrored_sides(std::size_t cut) const
  {
    const auto& [smaller, larger] = sets_.sides[cut];
    const bool is_smaller = overlap_with(smaller) >= overlap_with(larger);
    Sides result(leaf_.size(), 2);
    for (Index f = 0; f < result.size(); ++f)
      if (is_in(sets_.union_of(cut), f))
        result[f] = image_[f] == null_index ? is_in(larger, f) : is_mirrored_[f] != is_smaller;
    return result;
  }

  // Gives each face without leaf that of a neighbor on its side. Returns whether all have one.
  bool fill(std::vector<Index>& leaf, const Sides& sides) const
  {
    bool is_full = false;
    for (bool is_changed = true; is_changed && !is_full;) {
      is_changed = false;
      is_full = true;
      for (Index f = 0; f < leaf.size(); ++f) {
        for (Index h = 3 * f; h < 3 * f + 3 && leaf[f] == null_index; ++h)
          if (const Index g = surface_.neighbor(h); sides[g] == sides[f] && leaf[g] != null_index) {
            leaf[f] = leaf[g];
            is_changed = true;
          }
        is_full = is_full && leaf[f] != null_index;
      }
    }
    return is_full;
  }

  // Returns whether these leaves, and all sets of the tree, are connected.
  bool are_connected(const std::vector<Index>& leaf) const
  {
    if (connected_components(surface_, leaf).number != tree_.leaves.size())
      return false;
    std::vector<char> do_sides_touch(sets_.sides.size(), 0);
    for (Index h = 0; h < surface_.number_of_halfedges(); ++h) {
      const Index p = sets_.position[leaf[h / 3]], q = sets_.position[leaf[surface_.neighbor(h)]];
      for (std::size_t i = 0; p < q && i < sets_.sides.size(); ++i)
        if (const auto& [a, b] = sets_.sides[i];
            a.first <= p && p < a.end && b.first <= q && q < b.end)
          do_sides_touch[i] = 1;
    }
    return std::count(do_sides_touch.begin(), do_sides_touch.end(), char(0)) == 0;
  }

  // Returns whether no leaf has become smaller than the minimum area.
  bool are_large(const std::vector<Index>& leaf, double minimum_area) const
  {
    std::vector<double> areas(tree_.leaves.size(), 0);
    for (Index f = 0; f < leaf.size(); ++f)
      areas[leaf[f]] += surface_.areas[f];
    for (std::size_t i = 0; i < areas.size(); ++i)
      if (areas[i] < (std::min)(minimum_area, (1 - 1e-9) * tree_.leaves[i].area))
        return false;
    return true;
  }

public:
  Mirrored_cuts(const Surface& surface, const Merge_tree& tree, const std::vector<Index>& image)
    : surface_(surface), tree_(tree), image_(image), sets_(tree), leaf_(tree.leaf),
      is_mirrored_(surface.number_of_faces(), 0) {}

  // Returns the partner of each cut, null_node if it has none. A cut is the partner of at most one.
  std::vector<std::size_t> partners()
  {
    std::vector<std::size_t> result(tree_.merges.size(), null_node);
    for (std::size_t i = result.size(); i-- > 0;)
      if (result[i] == null_node && set_image(i))
        if (const std::size_t j = cut_of_image(least_overlap);
            j != null_node && j != i && result[j] == null_node) {
          result[i] = j;
          result[j] = i;
        }
    return result;
  }

  // Returns the leaves of the tree, divided along the mirror images of the cuts that are made, or
  // nearly, and have no partner. No new region is below the minimum area.
  std::vector<Index> divided_leaves(double minimum_area)
  {
    std::vector<Index> result = tree_.leaf;
    Index number = static_cast<Index>(tree_.leaves.size());
    for (std::size_t i = tree_.merges.size(); i-- > 0;)
      if (tree_.merges[i].salience >= default_probability_threshold / 2 && set_image(i) &&
          cut_of_image(least_overlap_of_similar) == null_node)
        divide(result, number, minimum_area);
    return result;
  }

  // Returns the leaves after the seams of cuts are moved to the mirror images of the seams of their
  // more salient partners. A seam stays if else a set were not connected or a leaf were too small.
  std::vector<Index> mirrored_leaves(const std::vector<std::size_t>& partner, double minimum_area)
  {
    for (std::size_t i = partner.size(); i-- > 0;) {
      const std::size_t j = partner[i];
      if (j == null_node || j < i || !set_image(j)) // the one that is cut first is more salient
        continue;
      const Sides sides = mirrored_sides(i);
      std::vector<Index> leaf = leaf_;
      for (Index f = 0; f < leaf.size(); ++f)
        if (sides[f] != 2 && is_in(sets_.sides[i][1], f) != (sides[f] == 1))
          leaf[f] = null_index;
      if (fill(leaf, sides) && are_connected(leaf) && are_large(leaf, minimum_area))
        leaf_ = leaf;
    }
    return leaf_;
  }
};

// Gives two partners the mean of their saliences. A cut keeps at least the salience of the cuts of
// its sides, which would not be made without it.
inline Merge_tree average_partners(Merge_tree tree, const std::vector<std::size_t>& partner)
{
  const Merged_sets sets(tree);
  std::vector<double> result;
  for (std::size_t i = 0; i < partner.size(); ++i) {
    const double salience = tree.merges[i].salience;
    result.push_back(salience);
    if (partner[i] == null_node)
      continue;
    double least = 0;
    for (const Merged_set& side : sets.sides[i])
      if (side.merge != null_index)
        least = (std::max)(least, result[side.merge]);
    result[i] = (std::max)((std::min)(salience, least),
                           (salience + tree.merges[partner[i]].salience) / 2);
  }
  for (std::size_t i = 0; i < partner.size(); ++i)
    tree.merges[i].salience = result[i];
  return tree;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_MIRRORED_CUTS_H
