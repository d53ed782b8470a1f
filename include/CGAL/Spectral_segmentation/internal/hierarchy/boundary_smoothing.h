// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_BOUNDARY_SMOOTHING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_BOUNDARY_SMOOTHING_H

#include <CGAL/Spectral_segmentation/internal/mesh/Triangles.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Morphological smoothing of the boundaries between segments (Section 2, post-smoothing).
//
// Each segment is opened with the ball of radius two of the dual graph: eroded by two steps and
// dilated again by two. What the opening removes are teeth, which go to the segments that they
// stick into. A segment too narrow for the erosion stays whole, and so does a piece that holds its
// segment together: no segment is emptied or disconnected.
class Boundary_smoothing
{
  static constexpr int radius = 2;

  const std::vector<Index>& neighbors_; // of each half-edge
  std::vector<std::size_t>& labels_;
  std::vector<char> is_tooth_;

  std::size_t size() const { return labels_.size(); }

  Neighbors neighbors(Index f) const
  { return {neighbors_[3 * f], neighbors_[3 * f + 1], neighbors_[3 * f + 2]}; }

  // Calls `reach(f)` once for each face within `radius` steps of `front`, without leaving the
  // segments of its faces.
  template <class Reach>
  void dilate(std::vector<Index> front, Reach reach) const
  {
    std::vector<char> is_reached(size(), 0);
    for (Index f : front) {
      is_reached[f] = 1;
      reach(f);
    }
    for (int step = 0; step < radius; ++step) {
      std::vector<Index> next;
      for (Index f : front)
        for (Index g : neighbors(f))
          if (!is_reached[g] && labels_[g] == labels_[f]) {
            is_reached[g] = 1;
            reach(g);
            next.push_back(g);
          }
      front.swap(next);
    }
  }

  // What the opening of its segment removes.
  void find_teeth()
  {
    std::vector<char> is_eroded(size(), 0);
    std::vector<Index> boundary;
    for (Index f = 0; f < size(); ++f)
      for (Index g : neighbors(f))
        if (labels_[g] != labels_[f] && !is_eroded[f]) {
          is_eroded[f] = 1;
          boundary.push_back(f);
        }
    // Faces at the boundary are one step from the other segment already.
    for (int step = 1; step < radius; ++step) {
      std::vector<Index> next;
      for (Index f : boundary)
        for (Index g : neighbors(f))
          if (!is_eroded[g]) {
            is_eroded[g] = 1;
            next.push_back(g);
          }
      boundary.swap(next);
    }
    std::vector<Index> core;
    for (Index f = 0; f < size(); ++f)
      if (!is_eroded[f])
        core.push_back(f);
    is_tooth_.assign(size(), 1);
    dilate(core, [this](Index f) { is_tooth_[f] = 0; });
  }

  // The connected piece of removed faces around f.
  std::vector<Index> tooth_of(Index f, std::vector<char>& is_listed) const
  {
    std::vector<Index> tooth(1, f);
    is_listed[f] = 1;
    for (std::size_t i = 0; i < tooth.size(); ++i)
      for (Index g : neighbors(tooth[i]))
        if (is_tooth_[g] && !is_listed[g] && labels_[g] == labels_[f]) {
          is_listed[g] = 1;
          tooth.push_back(g);
        }
    return tooth;
  }

  // Whether the faces of the segment that touch the tooth stay connected without it. The search
  // stops when it has met them all, which is soon unless the tooth is an isthmus; it gives up when
  // it has gone far, so that all searches together take linear time.
  bool can_lose(const std::vector<Index>& tooth, std::vector<Index>& mark, Index stamp) const
  {
    const std::size_t label = labels_[tooth.front()];
    std::vector<Index> rim;
    for (Index f : tooth)
      mark[f] = stamp;
    for (Index f : tooth)
      for (Index g : neighbors(f))
        if (labels_[g] == label && mark[g] != stamp && mark[g] != stamp + 1) {
          mark[g] = stamp + 1;
          rim.push_back(g);
        }
    if (rim.empty()) // the whole segment
      return false;
    std::vector<Index> found(1, rim.front());
    mark[rim.front()] = stamp + 2;
    std::size_t missing = rim.size() - 1;
    const std::size_t far = 1000 + 64 * tooth.size();
    for (std::size_t i = 0; i < found.size() && i < far && missing > 0; ++i)
      for (Index g : neighbors(found[i]))
        if (labels_[g] == label && mark[g] != stamp && mark[g] != stamp + 2) {
          missing -= mark[g] == stamp + 1;
          mark[g] = stamp + 2;
          found.push_back(g);
        }
    return missing == 0;
  }

  // The other segments grow into the tooth, layer by layer from all sides at once, each face taking
  // the label that most of its neighbors outside had before the layer, of equals the smallest.
  void give_away(const std::vector<Index>& tooth)
  {
    const std::size_t old_label = labels_[tooth.front()];
    std::vector<Index> rest = tooth;
    for (bool changed = true; changed && !rest.empty();) {
      std::vector<std::pair<Index, std::size_t> > layer;
      std::vector<Index> next;
      for (Index f : rest) {
        std::size_t best = old_label;
        int most = 0;
        for (Index g : neighbors(f)) {
          int count = 0;
          for (Index k : neighbors(f))
            count += labels_[k] == labels_[g];
          if (labels_[g] != old_label &&
              (count > most || (count == most && labels_[g] < best))) {
            most = count;
            best = labels_[g];
          }
        }
        if (best != old_label)
          layer.emplace_back(f, best);
        else
          next.push_back(f);
      }
      changed = !layer.empty();
      for (const auto& [f, label] : layer)
        labels_[f] = label;
      rest.swap(next);
    }
  }

public:
  Boundary_smoothing(const std::vector<Index>& neighbors, std::vector<std::size_t>& labels)
    : neighbors_(neighbors), labels_(labels) {}

  void operator()()
  {
    find_teeth();
    std::vector<char> is_listed(size(), 0);
    std::vector<Index> mark(size(), 0);
    Index stamp = 1;
    for (Index f = 0; f < size(); ++f) {
      if (!is_tooth_[f] || is_listed[f])
        continue;
      const std::vector<Index> tooth = tooth_of(f, is_listed);
      if (can_lose(tooth, mark, stamp))
        give_away(tooth);
      stamp += 3;
    }
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_BOUNDARY_SMOOTHING_H
