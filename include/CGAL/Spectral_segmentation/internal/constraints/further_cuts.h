// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_FURTHER_CUTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_FURTHER_CUTS_H

#include <CGAL/Spectral_segmentation/internal/constraints/Constraint_groups.h>
#include <CGAL/Spectral_segmentation/internal/salience/Patch.h>
#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>

#include <algorithm>
#include <cstddef>
#include <queue>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Cuts leaves of a tree further, if the search found fewer cuts than were asked for. It cuts
// the largest leaf in two, between its components if it has several, otherwise in halves of about
// the same area. The new cuts are no more salient than any other cut. Groups of faces, each
// connected and in one leaf, are not cut.
class Further_cuts
{
  typedef std::pair<double, Index> Key; // the area of a leaf, and the leaf

  const Surface& mesh_;
  Merge_tree tree_;
  std::vector<std::vector<Index> > faces_; // one list per leaf, ascending
  double salience_ = 0;                    // of the new cuts
  std::vector<Merge> cuts_;                // in their order
  std::vector<char> is_in_leaf_; // one per face: in the current leaf, but not reached yet
  std::priority_queue<Key> queue_;
  std::vector<Index> next_in_group_; // one per face, a circular list; empty if there are no groups

  template <class Visit>
  void for_each_in_group(Index first, const Visit& visit) const
  {
    visit(first);
    if (!next_in_group_.empty())
      for (Index f = next_in_group_[first]; f != first; f = next_in_group_[f])
        visit(f);
  }

  void enqueue(Index leaf)
  {
    std::size_t size_of_group = 0;
    for_each_in_group(faces_[leaf].front(), [&](Index) { ++size_of_group; });
    if (faces_[leaf].size() > size_of_group)
      queue_.push({quantized(tree_.leaves[leaf].area), leaf});
  }

  double area_of_group(Index first) const
  {
    double area = 0;
    for_each_in_group(first, [&](Index f) { area += mesh_.areas[f]; });
    return area;
  }

  void reach_group(Index first, std::vector<Index>& reached)
  {
    for_each_in_group(first, [&](Index f) {
      is_in_leaf_[f] = 0;
      reached.push_back(f);
    });
  }

  // Reaches and returns faces of the leaf that are connected with one face, by a breadth-first
  // search, until they have this area.
  std::vector<Index> reached_from(Index first, double area)
  {
    std::vector<Index> result;
    double sum = area_of_group(first);
    reach_group(first, result);
    for (std::size_t i = 0; i < result.size(); ++i)
      for (Index h = 3 * result[i]; h < 3 * result[i] + 3; ++h) {
        const Index f = mesh_.neighbor(h);
        if (!is_in_leaf_[f])
          continue;
        const double group_area = area_of_group(f);
        if (sum + group_area > area)
          return result;
        sum += group_area;
        reach_group(f, result);
      }
    return result;
  }

  void set_in_leaf(const std::vector<Index>& faces, bool value)
  {
    for (Index f : faces)
      is_in_leaf_[f] = value;
  }

  // Returns the faces on one side of the cut of a leaf, neither none nor all. If the leaf is
  // connected, both sides are connected.
  std::vector<Index> side(Index leaf)
  {
    const std::vector<Index>& faces = faces_[leaf];
    const double all = tree_.leaves[leaf].area * 2 + 1; // more than there is
    set_in_leaf(faces, true);
    const std::vector<Index> component = reached_from(faces.front(), all);
    if (component.size() < faces.size()) {
      set_in_leaf(faces, false);
      return component;
    }
    // The side starts at the face reached last, which is at an end. Faces that it separates from
    // the largest rest join it.
    set_in_leaf(faces, true);
    std::vector<Index> result = reached_from(component.back(), tree_.leaves[leaf].area / 2);
    if (result.size() == faces.size()) { // the leaf has no area
      set_in_leaf(faces, true);
      result.clear();
      reach_group(component.back(), result);
    }
    std::vector<std::vector<Index> > rests;
    for (Index f : faces)
      if (is_in_leaf_[f])
        rests.push_back(reached_from(f, all));
    const auto largest = std::max_element(rests.begin(), rests.end(),
      [](const auto& a, const auto& b) { return a.size() < b.size(); });
    for (auto rest = rests.begin(); rest != rests.end(); ++rest)
      if (rest != largest)
        result.insert(result.end(), rest->begin(), rest->end());
    set_in_leaf(faces, false);
    return result;
  }

  // Cuts a leaf. The larger side keeps the leaf.
  void cut(Index leaf)
  {
    const std::vector<Index> q = side(leaf), faces = std::exchange(faces_[leaf], {});
    set_in_leaf(q, true);
    Sides sides;
    double area[2] = {0, 0};
    for (Index f : faces) {
      sides.push_back(is_in_leaf_[f] == 0);
      area[0] += is_in_leaf_[f] ? mesh_.areas[f] : 0;
    }
    set_in_leaf(q, false);
    area[1] = (std::max)(tree_.leaves[leaf].area - area[0], 0.);
    normalize_sides(sides, area);
    const Index leaves[2] = {static_cast<Index>(tree_.leaves.size()), leaf};
    tree_.leaves.push_back({area[0]});
    tree_.leaves[leaf] = {area[1]};
    faces_.emplace_back();
    cuts_.push_back({{leaves[0], leaves[1]}, salience_, {}});
    for (std::size_t i = 0; i < faces.size(); ++i) {
      tree_.leaf[faces[i]] = leaves[int(sides[i])];
      faces_[tree_.leaf[faces[i]]].push_back(faces[i]);
    }
    enqueue(leaves[0]);
    enqueue(leaf);
  }

public:
  // Takes the group of each face, or null_index; `group` is empty if there are no groups.
  Further_cuts(Merge_tree tree, const Surface& mesh, const std::vector<Index>& group = {})
    : mesh_(mesh), tree_(std::move(tree)), faces_(tree_.leaves.size()),
      is_in_leaf_(mesh.number_of_faces(), 0), next_in_group_(first_indices(group.size()))
  {
    for (Index f = 0; f < tree_.leaf.size(); ++f)
      faces_[tree_.leaf[f]].push_back(f);
    for (const Merge& m : tree_.merges)
      salience_ = (std::min)(salience_, m.salience);
    std::vector<Index> last(group.size(), null_index); // face of each group
    for (Index f = 0; f < group.size(); ++f)
      if (group[f] != null_index) {
        if (last[group[f]] != null_index)
          std::swap(next_in_group_[f], next_in_group_[last[group[f]]]);
        last[group[f]] = f;
      }
  }

  // Cuts until there are this many leaves, or every leaf is a face or a group.
  Merge_tree operator()(std::size_t number_of_segments)
  {
    for (Index i = 0; i < tree_.leaves.size(); ++i) {
      tree_.leaves[i].number_of_earlier_cuts = null_node; // the decision of the search is not final
      enqueue(i);
    }
    while (tree_.leaves.size() < number_of_segments && !queue_.empty()) {
      const Index leaf = queue_.top().second;
      queue_.pop();
      cut(leaf);
    }
    tree_.merges.insert(tree_.merges.begin(), cuts_.rbegin(), cuts_.rend());
    number_leaves(tree_);
    return std::move(tree_);
  }
};

// Cuts leaves until there are as many segments as were asked for. No cut divides a set of groups.
inline Merge_tree cut_further(Merge_tree tree, const Constraint_groups& groups,
                              const Surface& mesh, const Run_data& d)
{
  if (!d.options.number_of_segments || d.monitor.is_stopped())
    return tree;
  const std::size_t number = *d.options.number_of_segments;
  std::vector<Index> sets;
  for (Index f = 0; f < groups.group.size(); ++f)
    sets.push_back(groups.set(f));
  tree = Further_cuts(std::move(tree), mesh, sets)(number);
  if (tree.leaves.size() < number)
    throw std::invalid_argument(
      "segment_spectral_recursive: number_of_segments is " + std::to_string(number) +
      ", but the edges that must not be cut and the seeds leave at most " +
      std::to_string(tree.leaves.size()) + " segments");
  return tree;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_FURTHER_CUTS_H
