// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_CUT_HIERARCHY_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_CUT_HIERARCHY_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>
#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {

/// \cond SKIP_IN_MANUAL
namespace internal {

enum class Cut_state { NOT_SEARCHED, NO_CUT, REJECTED, CUT };

constexpr std::size_t null_node = static_cast<std::size_t>(-1);

// A set of faces: a connected component of the mesh, or one side of the cut of its parent.
struct Cut_node
{
  std::size_t parent = null_node;
  std::size_t children[2] = {null_node, null_node}; // the child of smaller area first
  double area = 0;
  Cut_state cut_state = Cut_state::NOT_SEARCHED;
  double salience = 0;
  Salience_factors factors;

  bool is_leaf() const { return children[0] == null_node; }
};

// The cuts of a run, which the engine makes. Until cuts are edited by hand, the children of the
// i-th cut are the nodes number_of_roots + 2 i and the next one.
struct Cut_hierarchy
{
  std::size_t number_of_roots = 0;   // one for each connected component, by their first faces
  std::vector<Cut_node> nodes;
  std::vector<Index> leaf;           // the node without children that holds each face
  std::vector<std::size_t> cut_order;    // the nodes in the order in which the run decided on them
  bool is_monotonic = false;       // no cut is less salient than any later cut
  bool has_all_cuts = true;        // false if cuts are lost because a side became too small

  std::size_t number_of_segments() const
  { return number_of_roots + (nodes.size() - number_of_roots) / 2; }

  // Cuts a leaf. Its faces still have the cut node in `leaf`.
  void cut(std::size_t i, double area_of_smaller, double area_of_larger)
  {
    CGAL_precondition(nodes[i].is_leaf());
    CGAL_precondition(area_of_smaller <= area_of_larger);
    for (int k = 0; k < 2; ++k) {
      nodes[i].children[k] = nodes.size();
      Cut_node child;
      child.parent = i;
      child.area = k == 0 ? area_of_smaller : area_of_larger;
      nodes.push_back(child);
    }
  }
};

// Returns all nodes, the roots first, and parents before their children.
inline std::vector<std::size_t> parents_first(const Cut_hierarchy& hierarchy)
{
  std::vector<std::size_t> result(hierarchy.number_of_roots);
  std::iota(result.begin(), result.end(), std::size_t(0));
  result.reserve(hierarchy.nodes.size());
  for (std::size_t k = 0; k < result.size(); ++k) {
    const Cut_node& n = hierarchy.nodes[result[k]];
    if (!n.is_leaf())
      result.insert(result.end(), n.children, n.children + 2);
  }
  return result;
}

// The faces of each node of a hierarchy: ranges of one permutation of all faces. The range of a
// node is the range of its first child, then of its second child.
class Nested_ranges
{
  std::vector<Index> faces_;
  std::vector<std::size_t> first_, end_; // the range of each node in faces_

public:
  typedef Iterator_range<std::vector<Index>::const_iterator> Range;

  Nested_ranges() = default;

  // Makes the ranges. The faces of a leaf ascend.
  explicit Nested_ranges(const Cut_hierarchy& hierarchy)
    : faces_(hierarchy.leaf.size()), first_(hierarchy.nodes.size(), 0),
      end_(hierarchy.nodes.size(), 0)
  {
    const std::vector<Cut_node>& nodes = hierarchy.nodes;
    std::vector<std::size_t> size(nodes.size(), 0);
    for (Index node : hierarchy.leaf)
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
    for (Index f = 0; f < faces_.size(); ++f)
      faces_[next[hierarchy.leaf[f]]++] = f;
  }

  std::size_t size() const { return faces_.size(); }
  std::size_t size(std::size_t node) const { return end_[node] - first_[node]; }

  Range operator[](std::size_t node) const
  {
    const auto begin = faces_.begin();
    return make_range(begin + static_cast<std::ptrdiff_t>(first_[node]),
                      begin + static_cast<std::ptrdiff_t>(end_[node]));
  }
};

} // namespace internal
/// \endcond

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_CUT_HIERARCHY_H
