// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_HALVING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_HALVING_H

#include <CGAL/Spectral_segmentation/internal/dendrogram/Dendrogram.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Cuts leaves further, where the search found fewer cuts than are asked for: the largest leaf in
// two, between its components if it has several, otherwise in halves of about the same area. Groups
// of faces, each in one leaf, stay whole.
class Leaf_halving
{
  typedef std::pair<double, std::ptrdiff_t> Key; // of a leaf: its area, minus its number

  const Surface& mesh_;
  Dendrogram& d_;
  std::vector<std::vector<Index> > faces_; // of each leaf
  std::vector<char> is_waiting_;           // each face: of the leaf at hand, and not reached yet
  std::vector<Index> next_in_group_;       // of each face, in a circle
  std::priority_queue<Key> queue_;

  template <class Visit>
  void for_each_in_group(Index first, const Visit& visit) const
  {
    visit(first);
    for (Index f = next_in_group_[first]; f != first; f = next_in_group_[f])
      visit(f);
  }

  void enqueue(Index leaf)
  {
    std::size_t size_of_group = 0;
    for_each_in_group(faces_[leaf].front(), [&](Index) { ++size_of_group; });
    if (faces_[leaf].size() > size_of_group)
      queue_.push({quantized(d_.areas[leaf]), -static_cast<std::ptrdiff_t>(leaf)});
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
      is_waiting_[f] = 0;
      reached.push_back(f);
    });
  }

  // The waiting faces that are connected with one, by a breadth-first search, until they have this
  // area.
  std::vector<Index> reached_from(Index first, double area)
  {
    std::vector<Index> result;
    double sum = area_of_group(first);
    reach_group(first, result);
    for (std::size_t i = 0; i < result.size(); ++i)
      for (Index h = 3 * result[i]; h < 3 * result[i] + 3; ++h) {
        const Index f = mesh_.neighbor(h);
        if (!is_waiting_[f])
          continue;
        const double of_group = area_of_group(f);
        if (sum + of_group > area)
          return result;
        sum += of_group;
        reach_group(f, result);
      }
    return result;
  }

  void wait(const std::vector<Index>& faces, bool value = true)
  {
    for (Index f : faces)
      is_waiting_[f] = value;
  }

  // Of the faces of a leaf those on one side, neither none nor all. If the leaf is connected, so
  // are both sides.
  std::vector<Index> side(Index leaf)
  {
    const std::vector<Index>& faces = faces_[leaf];
    const double all = d_.areas[leaf] * 2 + 1; // more than there is
    wait(faces);
    const std::vector<Index> component = reached_from(faces.front(), all);
    if (component.size() < faces.size())
      return component;
    // From the face reached last, which is at an end; what it separates from the largest rest
    // goes with it.
    wait(faces);
    std::vector<Index> result = reached_from(component.back(), d_.areas[leaf] / 2);
    if (result.size() == faces.size()) { // without area
      wait(faces);
      result.clear();
      reach_group(component.back(), result);
    }
    std::vector<std::vector<Index> > rests;
    for (Index f : faces)
      if (is_waiting_[f])
        rests.push_back(reached_from(f, all));
    const auto largest = std::max_element(rests.begin(), rests.end(),
      [](const auto& a, const auto& b) { return a.size() < b.size(); });
    for (auto rest = rests.begin(); rest != rests.end(); ++rest)
      if (rest != largest)
        result.insert(result.end(), rest->begin(), rest->end());
    return result;
  }

  // Gives one side to a new leaf, which is returned.
  Index cut(Index leaf)
  {
    std::vector<Index> moved = side(leaf), rest;
    wait(faces_[leaf], false);
    const Index other = static_cast<Index>(d_.number_of_leaves());
    double area = 0;
    for (Index f : moved) {
      area += mesh_.areas[f];
      d_.leaf[f] = other;
    }
    std::copy_if(faces_[leaf].begin(), faces_[leaf].end(), std::back_inserter(rest),
                 [&](Index f) { return d_.leaf[f] == leaf; });
    std::sort(moved.begin(), moved.end());
    faces_[leaf] = std::move(rest);
    faces_.push_back(std::move(moved));
    d_.areas[leaf] = (std::max)(d_.areas[leaf] - area, 0.);
    d_.areas.push_back(area);
    return other;
  }

public:
  // `group` is that of each face, or null_index; empty without groups.
  Leaf_halving(const Surface& mesh, Dendrogram& d, const std::vector<Index>& group = {})
    : mesh_(mesh), d_(d), faces_(d.number_of_leaves()), is_waiting_(d.leaf.size(), 0),
      next_in_group_(d.leaf.size())
  {
    std::iota(next_in_group_.begin(), next_in_group_.end(), Index(0));
    std::vector<Index> last(group.size(), null_index); // face of each group
    for (Index f = 0; f < d.leaf.size(); ++f) {
      faces_[d.leaf[f]].push_back(f);
      if (group.empty() || group[f] == null_index)
        continue;
      if (last[group[f]] != null_index)
        std::swap(next_in_group_[f], next_in_group_[last[group[f]]]);
      last[group[f]] = f;
    }
  }

  // Until there are this many segments, or every leaf is a face or a group.
  void operator()(std::size_t number_of_segments)
  {
    double salience = 0; // no larger than that of any cut
    std::size_t number = d_.number_of_leaves();
    for (const Merge& m : d_.merges)
      if (m.is_cut())
        salience = (std::min)(salience, m.salience);
    for (Index leaf = 0; leaf < number; ++leaf)
      enqueue(leaf);
    std::vector<Merge> halves;
    std::vector<char> is_cut(number, 0);
    for (; number < number_of_segments && !queue_.empty(); ++number) {
      const Index leaf = static_cast<Index>(-queue_.top().second);
      queue_.pop();
      const Index other = cut(leaf);
      halves.emplace_back();
      halves.back().leaves[0] = leaf;
      halves.back().leaves[1] = other;
      halves.back().salience = salience;
      is_cut.resize(number + 1, 1);
      is_cut[leaf] = 1;
      enqueue(leaf);
      enqueue(other);
    }
    // What the paper's method decided of a part that is cut now
    const auto is_obsolete = [&](const Merge& m) { return !m.is_cut() && is_cut[m.leaves[0]]; };
    std::vector<Merge> merges;
    for (Index leaf = 0; leaf < number && !d_.is_ultrametric; ++leaf)
      if (is_cut[leaf]) {
        merges.emplace_back();
        merges.back().leaves[0] = merges.back().leaves[1] = leaf;
        merges.back().state = Cut_state::NO_CUT;
      }
    merges.insert(merges.end(), halves.rbegin(), halves.rend());
    std::remove_copy_if(d_.merges.begin(), d_.merges.end(), std::back_inserter(merges),
                        is_obsolete);
    d_.merges = std::move(merges);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_HALVING_H
