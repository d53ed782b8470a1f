// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_NESTED_RANGES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_NESTED_RANGES_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {

/// \cond SKIP_IN_MANUAL
namespace internal {

// The elements (faces, or cells of faces) of each node of a hierarchy, as ranges of one permutation
// of all elements. The range of a node is the range of its first child and then of its second
// child.
class Nested_ranges
{
  std::vector<Index> elements_;
  std::vector<std::size_t> first_, end_; // the range of each node in elements_

public:
  typedef Iterator_range<std::vector<Index>::const_iterator> Range;

  Nested_ranges() = default;

  // Makes the ranges from the node of each element. The elements of a leaf ascend.
  Nested_ranges(const Cut_hierarchy& hierarchy, const std::vector<Index>& leaf)
    : elements_(leaf.size()), first_(hierarchy.nodes.size(), 0), end_(hierarchy.nodes.size(), 0)
  {
    const std::vector<Cut_node>& nodes = hierarchy.nodes;
    std::vector<std::size_t> size(nodes.size(), 0);
    for (Index node : leaf)
      ++size[node];
    const std::vector<std::size_t> order = parents_first(hierarchy);
    for (std::size_t k = order.size(); k-- > hierarchy.number_of_roots;)
      size[nodes[order[k]].parent] += size[order[k]];
    std::size_t end = 0;
    for (std::size_t i : order) {
      if (i < hierarchy.number_of_roots)
        first_[i] = end;
      else if (i == nodes[nodes[i].parent].children[0])
        first_[i] = first_[nodes[i].parent];
      else
        first_[i] = end_[nodes[nodes[i].parent].children[0]];
      end_[i] = first_[i] + size[i];
      end = (std::max)(end, end_[i]);
    }
    std::vector<std::size_t> next(first_);
    for (Index e = 0; e < leaf.size(); ++e)
      elements_[next[leaf[e]]++] = e;
  }

  std::size_t size() const { return elements_.size(); }
  std::size_t size(std::size_t node) const { return end_[node] - first_[node]; }
  std::size_t first(std::size_t node) const { return first_[node]; } // its place in the permutation

  Range operator[](std::size_t node) const
  {
    const auto begin = elements_.begin();
    return make_range(begin + static_cast<std::ptrdiff_t>(first_[node]),
                      begin + static_cast<std::ptrdiff_t>(end_[node]));
  }

  // Cuts a leaf whose children are the next two nodes: `side[i]` is the child of the i-th element
  // of its range. Elements keep their order.
  void cut(std::size_t node, const std::vector<char>& side)
  {
    CGAL_precondition(side.size() == size(node));
    const auto first = elements_.begin() + static_cast<std::ptrdiff_t>(first_[node]);
    std::vector<Index> rest;
    auto out = first;
    for (std::size_t i = 0; i < side.size(); ++i) {
      const Index element = elements_[first_[node] + i];
      if (side[i] == 0)
        *out++ = element;
      else
        rest.push_back(element);
    }
    std::copy(rest.begin(), rest.end(), out);
    const std::size_t middle = end_[node] - rest.size();
    first_.insert(first_.end(), {first_[node], middle});
    end_.insert(end_.end(), {middle, end_[node]});
  }
};

// Returns ranges with the leaves as elements, so that the leaves of each node follow each other.
// `first(leaf)` is the place of a leaf.
inline Nested_ranges ranges_of_leaves(const Cut_hierarchy& hierarchy)
{
  std::vector<Index> leaves;
  for (Index i = 0; i < hierarchy.nodes.size(); ++i)
    if (hierarchy.nodes[i].is_leaf())
      leaves.push_back(i);
  return Nested_ranges(hierarchy, leaves);
}

// Returns the root of each leaf, by the places of the leaves in these ranges.
inline std::vector<std::size_t> roots_of_leaves(const Cut_hierarchy& hierarchy,
                                                const Nested_ranges& leaves)
{
  std::vector<std::size_t> result;
  for (std::size_t root = 0; root < hierarchy.number_of_roots; ++root)
    result.insert(result.end(), leaves.size(root), root);
  return result;
}

} // namespace internal
/// \endcond

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_NESTED_RANGES_H
