// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_LEVEL_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_LEVEL_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// What a face has of the leaves of a dendrogram on another surface. The shares of a face are
// positive or all 0, and compare with each other alone.
class Shares
{
  struct Share
  {
    Index leaf;
    double share;
  };

  boost::container::small_vector<Share, 4> shares_;

public:
  void add(Index leaf, double share)
  {
    const auto found = std::find_if(shares_.begin(), shares_.end(),
                                    [leaf](const Share& s) { return s.leaf == leaf; });
    if (found == shares_.end())
      shares_.push_back({leaf, share});
    else
      found->share += share;
  }

  auto begin() const { return shares_.begin(); }
  auto end() const { return shares_.end(); }
  std::size_t size() const { return shares_.size(); }
};

// A surface that was made from another one for the search, and what is needed to bring its cuts
// back.
class Level
{
protected:
  const Surface& finer_; // from which it was made
  Surface surface_;

public:
  explicit Level(const Surface& finer) : finer_(finer) {}
  virtual ~Level() = default;

  const Surface& finer() const { return finer_; }
  const Surface& surface() const { return surface_; }

  // Whether the surface has the shape and the components of the finer one, so that the sides of
  // cuts can be connected, and minimum cuts decide where a face has both.
  virtual bool has_same_shape() const { return true; }

  // The shares of each face of the finer surface in the leaves of the faces of this one.
  virtual std::function<Shares(Index face)> shares(const std::vector<Index>& leaf) const = 0;
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_LEVEL_H
