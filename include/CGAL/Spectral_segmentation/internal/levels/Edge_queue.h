// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_EDGE_QUEUE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_EDGE_QUEUE_H

#include <CGAL/Spectral_segmentation/internal/base/arrays.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Edges by length, the shortest first. All but those of about the shortest length wait in buckets,
// as one heap of all edges would be slow to reach in memory.
class Edge_queue
{
public:
  typedef std::pair<std::uint64_t, Index> Edge; // its key, which begins with the length; half-edge

private:
  // Of lengths that are equal in their exponent and the first bits of their mantissa.
  static constexpr int bits_of_bucket = 13;
  typedef std::priority_queue<Edge, std::vector<Edge>, std::greater<Edge> > Queue;

  std::vector<std::vector<Edge> > buckets_;
  std::size_t current_ = 0;
  Queue queue_; // of the current bucket and those before

  // Without the sign, which is 0.
  static std::size_t bucket(std::uint64_t key) { return key >> (63 - bits_of_bucket); }

public:
  Edge_queue() : buckets_(std::size_t(1) << bits_of_bucket) {}

  // The squared length decides, then the other number.
  static std::uint64_t key(float squared_length, std::uint32_t other)
  {
    std::uint32_t bits; // of a float that is not negative, in the order of the floats
    std::memcpy(&bits, &squared_length, sizeof(bits));
    return (std::uint64_t(bits) << 32) | other;
  }

  void push(const Edge& edge)
  {
    if (bucket(edge.first) <= current_)
      queue_.push(edge);
    else
      buckets_[bucket(edge.first)].push_back(edge);
  }

  // The shortest edge leaves; none if there are no more.
  std::optional<Edge> pop()
  {
    while (queue_.empty()) {
      if (++current_ >= buckets_.size())
        return std::nullopt;
      queue_ = Queue(std::greater<Edge>(), std::exchange(buckets_[current_], {}));
    }
    const Edge result = queue_.top();
    queue_.pop();
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_EDGE_QUEUE_H
