// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PARTNER_CUTS_H
#define SEGMENTATION_BENCHMARK_PARTNER_CUTS_H

#include "run_engine.h"
#include "tree_of_hierarchy.h"

#include <CGAL/Spectral_segmentation/internal/tree/congruent_cuts.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace segmentation_benchmark {

// The largest difference of two partners.
constexpr double difference_of_partners = 0.1;

// Returns the partners among some cuts, as pairs of indices. Two cuts are partners if each is the
// nearest to the other, and if they do not differ by more.
inline std::vector<std::pair<std::size_t, std::size_t> >
partners(const std::vector<CGAL::Spectral_segmentation::internal::Cut_shape>& shapes)
{
  using CGAL::Spectral_segmentation::internal::difference;
  const std::size_t n = shapes.size();
  std::vector<std::size_t> nearest(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (j != i && (nearest[i] == n || difference(shapes[i], shapes[j]) <
                                        difference(shapes[i], shapes[nearest[i]])))
        nearest[i] = j;
  std::vector<std::pair<std::size_t, std::size_t> > result;
  for (std::size_t i = 0; i < n; ++i)
    if (const std::size_t j = nearest[i];
        j < n && i < j && nearest[j] == i &&
        difference(shapes[i], shapes[j]) <= difference_of_partners)
      result.emplace_back(i, j);
  return result;
}

// Numbers of pairs of partners.
struct Partner_counts
{
  double made = 0, made_unlike = 0; // with at least one cut made, with one
};

// Counts the partners of the cuts of a tree. The labels are those of segments of the tree.
inline Partner_counts
partner_counts(const Mesh& mesh, const CGAL::Spectral_segmentation::Segmentation_hierarchy& tree,
               const Labels& labels)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  internal::Surface surface = triangles_of(mesh);
  internal::normalize(surface.points);
  set_areas(Execution::SEQUENTIAL, surface);
  const internal::Merge_tree merges = tree_of(internal::Hierarchy_access::cuts(tree));
  std::vector<std::size_t> label(merges.leaves.size());
  for (std::size_t f = 0; f < labels.size(); ++f)
    label[merges.leaf[f]] = labels[f];
  const auto is_made = [&](std::size_t i) {
    const auto [a, b] = merges.merges[i].leaves;
    return label[a] != label[b];
  };
  Partner_counts result;
  for (const auto& [i, j] : partners(cut_shapes(surface, merges))) {
    result.made += is_made(i) || is_made(j);
    result.made_unlike += is_made(i) != is_made(j);
  }
  return result;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PARTNER_CUTS_H
