// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_SYMMETRIC_CUTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_SYMMETRIC_CUTS_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/salience/Patch.h>
#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The more salient partner of a cut.
struct Partner
{
  std::size_t cut = null_node; // none
  std::size_t motion = 0;      // that maps the cut to its partner
  std::size_t side = 0;        // of the cut; it is mapped to the smaller side of the partner
};

// The cuts of a tree in a surface that some motions map, but for details, to itself. The partner of
// a cut has a side that is the image of the smaller side of the cut. The search finds cuts one by
// one, so that the cut of one horn may be among the regions, and its partner not.
class Symmetric_cuts
{
  // The intersection over union of an image with a side of its partner, and with a side of a cut
  // that is similar to a partner
  static constexpr double least_overlap = 0.5, least_overlap_of_similar = 0.4;
  // A cut within the image is no partner: both its sides together overlap as much.
  static constexpr double largest_overlap_of_both = 0.8; // relative to that of one
  static constexpr double largest_common = 0.3;    // fraction of a side that is its own image
  static constexpr double least_new_region = 0.25; // relative to the image

  const Surface& surface_;
  const Merge_tree& tree_;
  // For each motion the face to which each face is mapped, or null_index
  const std::vector<std::vector<Index> >& images_;
  const Merged_sets sets_;
  std::vector<Index> leaf_;         // of each face: that of the tree, until seams are moved
  std::vector<char> is_image_;      // the faces of the image of the current side
  double area_ = 0;                 // its area
  std::vector<double> area_before_; // of it in the leaves before each position

  bool is_in(const Merged_set& set, Index f) const
  { return set.contains(sets_.position[leaf_[f]]); }

  // Sets the image of the smaller side of a cut: the faces that a motion maps there. Returns
  // whether it is elsewhere.
  bool set_image(std::size_t cut, std::size_t motion)
  {
    const Merged_set& side = sets_.sides[cut][0];
    const std::vector<Index>& image = images_[motion];
    std::vector<double> areas(tree_.leaves.size(), 0); // by position
    area_ = 0;
    for (Index f = 0; f < image.size(); ++f) {
      is_image_[f] = image[f] != null_index && is_in(side, image[f]);
      if (is_image_[f]) {
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

  // Returns the cut that separates the image from other faces; null_node if there is none.
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

  // Divides the regions with large pieces of the image along its boundary. Both pieces are
  // connected; if one is too small, the region stays.
  void divide(std::vector<Index>& regions, Index& number, double minimum_area) const
  {
    const double least = (std::max)(minimum_area, least_new_region * area_);
    std::vector<double> inside(number, 0);
    for (Index f = 0; f < regions.size(); ++f)
      inside[regions[f]] += is_image_[f] ? surface_.areas[f] : 0;
    for (Index region = 0; region < inside.size(); ++region) {
      if (!(inside[region] > 0) || inside[region] < least)
        continue;
      Sides sides;
      for (Index f = 0; f < regions.size(); ++f)
        sides.push_back(static_cast<char>(regions[f] != region ? 0 : is_image_[f] ? 1 : 2));
      keep_largest(sides, 1);
      keep_largest(sides, 2);
      double areas[3] = {0, 0, 0};
      for (Index f = 0; f < regions.size(); ++f)
        areas[int(sides[f])] += surface_.areas[f];
      const double smaller = (std::min)(areas[1], areas[2]);
      if (!(smaller > 0) || smaller < least)
        continue;
      for (Index f = 0; f < regions.size(); ++f)
        if (sides[f] == 1)
          regions[f] = number;
      ++number;
    }
  }

  // Returns the sides of a cut whose seam is the boundary of the image that is set: 0 or 1, and 2
  // outside of the region. Faces without image stay.
  Sides sides_of_image(std::size_t cut, const Partner& partner) const
  {
    const std::vector<Index>& image = images_[partner.motion];
    const bool is_smaller = partner.side == 0;
    Sides result(leaf_.size(), 2);
    for (Index f = 0; f < result.size(); ++f)
      if (is_in(sets_.union_of(cut), f))
        result[f] = image[f] == null_index ? is_in(sets_.sides[cut][1], f)
                                           : is_image_[f] != is_smaller;
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
  Symmetric_cuts(const Surface& surface, const Merge_tree& tree,
                 const std::vector<std::vector<Index> >& images)
    : surface_(surface), tree_(tree), images_(images), sets_(tree), leaf_(tree.leaf),
      is_image_(surface.number_of_faces(), 0) {}

  // Returns the more salient partner of each cut, which has none itself.
  std::vector<Partner> partners()
  {
    std::vector<Partner> result(tree_.merges.size());
    std::vector<char> has_follower(result.size(), 0);
    for (std::size_t i = result.size(); i-- > 0;)
      for (std::size_t m = 0; m < images_.size() && result[i].cut == null_node; ++m)
        if (set_image(i, m))
          if (const std::size_t j = cut_of_image(least_overlap);
              j < i && result[j].cut == null_node && !has_follower[j]) {
            const auto& [smaller, larger] = sets_.sides[j];
            result[j] = {i, m, std::size_t(overlap_with(larger) > overlap_with(smaller))};
            has_follower[i] = 1;
          }
    return result;
  }

  // Returns the leaves of the tree, divided along the images of the cuts that are made, or nearly,
  // and have no partner. No new region is below the minimum area.
  std::vector<Index> divided_leaves(double minimum_area)
  {
    std::vector<Index> result = tree_.leaf;
    Index number = static_cast<Index>(tree_.leaves.size());
    for (std::size_t i = tree_.merges.size(); i-- > 0;) {
      if (tree_.merges[i].salience < default_probability_threshold / 2)
        continue;
      for (std::size_t m = 0; m < images_.size(); ++m)
        if (set_image(i, m) && cut_of_image(least_overlap_of_similar) == null_node)
          divide(result, number, minimum_area);
    }
    return result;
  }

  // Returns the leaves after the seams of cuts are moved to the images of the seams of their more
  // salient partners. A seam stays if else a leaf were not connected or too small.
  std::vector<Index> moved_leaves(const std::vector<Partner>& partner, double minimum_area)
  {
    for (std::size_t i = partner.size(); i-- > 0;) {
      if (partner[i].cut == null_node || !set_image(partner[i].cut, partner[i].motion))
        continue;
      const Sides sides = sides_of_image(i, partner[i]);
      std::vector<Index> leaf = leaf_;
      for (Index f = 0; f < leaf.size(); ++f)
        if (sides[f] != 2 && is_in(sets_.sides[i][1], f) != (sides[f] == 1))
          leaf[f] = null_index;
      if (fill(leaf, sides) && are_large(leaf, minimum_area) &&
          connected_components(surface_, leaf).number == tree_.leaves.size())
        leaf_ = leaf;
    }
    return leaf_;
  }
};

// Gives partners the mean of their saliences.
inline void average_partners(Merge_tree& tree, const std::vector<Partner>& partner)
{
  const std::size_t n = partner.size();
  const auto first = [&](std::size_t i)
  { return partner[i].cut == null_node ? i : partner[i].cut; };
  std::vector<double> sum(n, 0), number(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    sum[first(i)] += tree.merges[i].salience;
    ++number[first(i)];
  }
  for (std::size_t i = 0; i < n; ++i)
    tree.merges[i].salience = sum[first(i)] / number[first(i)];
}

// Averages the saliences of partners, and merges the leaves again, the least salient boundary
// first. A boundary between two leaves is as salient as the most salient cut of which one side has
// only one of them: the side that is an image of that of the partner, or else the smaller one.
inline Merge_tree merge_symmetrically(const Surface& surface, Merge_tree tree,
                                      const std::vector<Partner>& partner)
{
  const Merged_sets sets(tree);
  average_partners(tree, partner);
  std::set<std::pair<Index, Index> > pairs;
  for (Index h = 0; h < surface.number_of_halfedges(); ++h)
    if (const Index a = tree.leaf[h / 3], b = tree.leaf[surface.neighbor(h)]; a < b)
      pairs.insert({a, b});
  std::vector<std::tuple<double, std::size_t, Index, Index> > boundaries;
  for (const auto& [a, b] : pairs) {
    std::pair<double, std::size_t> most_salient(-1, 0);
    for (std::size_t i = 0; i < partner.size(); ++i) {
      const Merged_set& side = sets.sides[i][partner[i].side];
      if (side.contains(sets.position[a]) != side.contains(sets.position[b]))
        most_salient = (std::max)(most_salient, {tree.merges[i].salience, i});
    }
    boundaries.push_back({most_salient.first, most_salient.second, a, b});
  }
  std::sort(boundaries.begin(), boundaries.end());
  Disjoint_sets merged(tree.leaves.size());
  std::vector<Merge> merges;
  for (const auto& [salience, i, a, b] : boundaries)
    if (merged.representative(a) != merged.representative(b)) {
      merges.push_back({{a, b}, salience, tree.merges[i].factors});
      merged.join(a, b);
    }
  tree.merges = std::move(merges);
  return tree;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_SYMMETRIC_CUTS_H
