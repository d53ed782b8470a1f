// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_POINT_NUMBERING_H
#define SEGMENT_MESH_MESH_FILE_POINT_NUMBERING_H

#include "Polygon_soup.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace mesh_file {

// Numbers points in the order in which they come; points at the same place have one number,
// and so have those that are not finite.
//
// A hash table with open addressing: it asks for 8 bytes a point, where std::unordered_map takes
// over 50 and several times as long. The hash has a random key, against files whose points would
// all meet in one slot.
class Point_numbering
{
  std::vector<Point>& points_;
  std::vector<Index> slots_;

  const std::uint64_t key_ = std::uint64_t(std::random_device()()) << 32 | std::random_device()();

  std::uint64_t hash(const Point& p) const
  {
    std::uint64_t result = key_;
    for (double c : p) {
      const double number = c + 0.; // there are two zeros
      std::uint64_t bits;
      std::memcpy(&bits, &number, sizeof bits);
      result = (result ^ bits) * 0x9E3779B97F4A7C15u;
      result ^= result >> 32;
    }
    return result;
  }

  Index& slot_of(const Point& p)
  {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash(p) & mask;
    while (slots_[i] != null_index && points_[slots_[i]] != p)
      i = (i + 1) & mask;
    return slots_[i];
  }

  void grow()
  {
    slots_.assign((std::max)(2 * slots_.size(), std::size_t(1024)), null_index);
    for (std::size_t i = 0; i < points_.size(); ++i)
      slot_of(points_[i]) = static_cast<Index>(i);
  }

public:
  // Takes an empty vector, to which new points are appended.
  explicit Point_numbering(std::vector<Point>& points) : points_(points) {}

  Index operator()(Point p)
  {
    if (!is_finite(p))
      p.fill(std::numeric_limits<double>::infinity()); // NaN does not equal itself
    if (2 * (points_.size() + 1) > slots_.size())
      grow();
    Index& slot = slot_of(p);
    if (slot == null_index) {
      slot = static_cast<Index>(points_.size());
      points_.push_back(p);
      if (points_.size() >= null_index)
        throw std::runtime_error("there are too many points");
    }
    return slot;
  }
};

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_POINT_NUMBERING_H
