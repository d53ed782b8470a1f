// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_ARRAYS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_ARRAYS_H

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Of a face (f, g), a half-edge (h), a vertex (v), or what else the name says.
typedef std::uint32_t Index;
constexpr Index null_index = static_cast<Index>(-1);

// Numbers that decide are rounded to multiples of 2^-20. Sums of such numbers are exact as doubles,
// so that the length of a path does not depend on the order of its sum, and numbers that are equal
// on paper are equal in the machine.
constexpr double quantum = 1. / (1 << 20);
inline double quantized(double x) { return std::floor(x / quantum + 0.5) * quantum; }

// Asks for memory that will be read soon, where the compiler can. Without it, loops over faces in an
// order of their own wait for memory half of the time.
inline void prefetch(const void* address)
{
#ifdef __GNUC__
  __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}

// Returns the indices of the values, the smallest value first; of equal values that first of which
// `is_first(i, j)` is true. No value may be NaN.
template <class Value, class IsFirst = std::less<Index> >
std::vector<Index> sorted_indices(const std::vector<Value>& values,
                                  const IsFirst& is_first = IsFirst())
{
  std::vector<std::pair<Value, Index> > entries; // a value beside its index is in the cache
  entries.reserve(values.size());
  for (Index i = 0; i < values.size(); ++i)
    entries.emplace_back(values[i], i);
  std::sort(entries.begin(), entries.end(), [&](const auto& a, const auto& b)
    { return a.first < b.first || (a.first == b.first && is_first(a.second, b.second)); });
  std::vector<Index> result;
  result.reserve(entries.size());
  for (const auto& entry : entries)
    result.push_back(entry.second);
  return result;
}

// Elements in rows, side by side in memory, by a counting sort. As adjacency lists, a quarter of
// the memory of BGL's.
class Rows
{
  std::vector<Index> first_;    // of each row in the elements; and their number
  std::vector<Index> elements_;

public:
  typedef Iterator_range<const Index*> Row;

  // Puts each element i < `number_of_elements` into the row `row(i)`, in which elements ascend;
  // into none if that is null_index.
  template <class Row_of_element>
  Rows(std::size_t number_of_rows, std::size_t number_of_elements, const Row_of_element& row)
    : first_(number_of_rows + 1, 0)
  {
    for (Index i = 0; i < number_of_elements; ++i)
      if (const Index r = row(i); r != null_index)
        ++first_[r + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    elements_.resize(first_.back());
    std::vector<Index> next = first_;
    for (Index i = 0; i < number_of_elements; ++i)
      if (const Index r = row(i); r != null_index)
        elements_[next[r]++] = i;
  }

  Index number() const { return static_cast<Index>(first_.size() - 1); }

  Row operator[](Index row) const
  { return {elements_.data() + first_[row], elements_.data() + first_[row + 1]}; }

  // The place of the first element of a row among all elements.
  Index first(Index row) const { return first_[row]; }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_ARRAYS_H
