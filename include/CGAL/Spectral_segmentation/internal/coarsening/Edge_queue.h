// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_EDGE_QUEUE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_EDGE_QUEUE_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A queue of edges, the shortest first. All but the edges of about the shortest length wait in
// buckets, because one heap of all edges would be slow to reach in memory.
class Edge_queue
{
public:
  typedef std::pair<std::uint64_t, Index> Edge; // key, which begins with the length; halfedge

private:
  // A bucket holds lengths that are equal in their exponent and the first bits of their mantissa.
  static constexpr int bits_of_bucket = 13;
  typedef std::priority_queue<Edge, std::vector<Edge>, std::greater<Edge> > Queue;

  std::vector<std::vector<Edge> > buckets_;
  std::size_t current_ = 0;
  Queue queue_; // the edges of the current bucket and of earlier ones

  // Returns the bucket of a key, without the sign, which is 0.
  static std::size_t bucket(std::uint64_t key) { return key >> (63 - bits_of_bucket); }

public:
  Edge_queue() : buckets_(std::size_t(1) << bits_of_bucket) {}

  // Returns a key: the squared length decides, then the other number.
  static std::uint64_t key(float squared_length, std::uint32_t other)
  {
    std::uint32_t bits; // bits of nonnegative floats are in the order of the floats
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

  // Removes and returns the shortest edge; none if there are no more.
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

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_EDGE_QUEUE_H
