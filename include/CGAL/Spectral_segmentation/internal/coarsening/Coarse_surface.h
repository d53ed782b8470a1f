// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSE_SURFACE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSE_SURFACE_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/Longest_edge_bisection.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A surface of the same shape and topology as another one, with fewer faces.
struct Coarse_surface
{
  Surface graph;               // has no weights
  std::vector<Index> faces;    // the face of the finer surface that each face is left from
  std::vector<Index> vertices; // the vertex of the graph for each vertex of the finer surface
};

// The leaves of a hierarchy that each of some elements touches, with its share in each leaf.
class Leaf_shares
{
public:
  struct Share
  {
    Index leaf;
    float share;
  };

private:
  std::vector<Share> shares_;      // of one element after the other
  std::vector<Index> first_ = {0}; // one per element, and the end

  const Share* begin(std::size_t element) const { return shares_.data() + first_[element]; }

public:
  // Adds an element without shares.
  void add_element() { first_.push_back(first_.back()); }

  // Adds to the share of the last element in a leaf.
  void add(Index leaf, float share)
  {
    const auto first = shares_.begin() + static_cast<std::ptrdiff_t>(first_[first_.size() - 2]);
    const auto found = std::find_if(first, shares_.end(),
                                    [leaf](const Share& s) { return s.leaf == leaf; });
    if (found != shares_.end())
      found->share += share;
    else {
      shares_.push_back({leaf, share});
      ++first_.back();
    }
  }

  std::size_t number_of_elements() const { return first_.size() - 1; }

  // Returns whether each element touches one leaf.
  bool are_whole() const { return shares_.size() == number_of_elements(); }

  Iterator_range<const Share*> operator[](std::size_t element) const
  { return make_range(begin(element), begin(element + 1)); }
};

// Returns the shares of the vertices of a coarse surface in the leaves of the faces around them.
inline Leaf_shares shares_of_vertices(const Surface& coarse, const std::vector<Index>& leaf)
{
  std::vector<Packed_graph::Ends> corners;
  corners.reserve(3 * leaf.size());
  for (Index f = 0; f < leaf.size(); ++f)
    for (Index v : coarse.corners[f])
      corners.emplace_back(v, leaf[f]);
  std::vector<Index> place;
  const Packed_graph leaves(coarse.points.size(), corners, place);
  Leaf_shares result;
  for (Index v = 0; v < coarse.points.size(); ++v) {
    result.add_element();
    const Index first = leaves.first_arc[v], end = leaves.first_arc[v + 1];
    for (Index i = first; i < end; ++i)
      result.add(leaves.targets[i], 1 / static_cast<float>(end - first));
  }
  return result;
}

// Returns the shares, by area, of the faces of a mesh in the leaves of its refined surface.
inline Leaf_shares shares_of_faces(const Refined_mesh& refined, const std::vector<Index>& leaf)
{
  Leaf_shares result;
  for (Index f = 0; f < leaf.size(); ++f) {
    while (result.number_of_elements() <= refined.faces[f])
      result.add_element();
    result.add(leaf[f], static_cast<float>(refined.graph.areas[f]));
  }
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSE_SURFACE_H
