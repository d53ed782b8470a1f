// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_CONGRUENT_CUTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_CONGRUENT_CUTS_H

#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The logarithms of the root of the area of the smaller side of a cut, of the length of the cut,
// and of the standard deviations of that side.
typedef std::array<double, 5> Cut_shape;

// Returns the root mean square difference of two shapes.
inline double difference(const Cut_shape& a, const Cut_shape& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

// The difference up to which cuts are congruent. With 0.05, 24 pairs of equal limbs in the odd half
// of the Princeton benchmark are cut differently, and with 0.1 three. From 0.15 on errors grow.
constexpr double difference_of_congruent_cuts = 0.1;

// Returns the shape of the cut that each merge is in reverse.
inline std::vector<Cut_shape> cut_shapes(const Surface& mesh, const Merge_tree& tree)
{
  const double least_length = 1e-4 * std::sqrt(total_area(mesh));
  const Merged_sets sets(tree);
  std::vector<Packed_graph::Ends> ends; // the position of the leaf of each face, and the face
  for (Index f = 0; f < tree.leaf.size(); ++f)
    ends.emplace_back(sets.position[tree.leaf[f]], f);
  std::vector<Index> unused;
  const Packed_graph faces(tree.leaves.size(), ends, unused);
  std::vector<std::size_t> cut_with_larger_side(mesh.number_of_faces(), null_node);
  std::vector<Cut_shape> result;
  for (std::size_t cut = 0; cut < tree.merges.size(); ++cut) {
    const auto& [smaller, larger] = sets.sides[cut];
    for (Index i = faces.first_arc[larger.first]; i < faces.first_arc[larger.end]; ++i)
      cut_with_larger_side[faces.targets[i]] = cut;
    double length = 0;
    Moments moments;
    for (Index i = faces.first_arc[smaller.first]; i < faces.first_arc[smaller.end]; ++i) {
      const Index f = faces.targets[i];
      moments.add(mesh, f);
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (cut_with_larger_side[mesh.neighbor(h)] == cut)
          length += mesh.length(h);
    }
    const std::array<double, 3> deviations = moments.deviations();
    Cut_shape shape = {std::sqrt(moments.area), length, deviations[0], deviations[1],
                       deviations[2]};
    for (double& x : shape) // the order of arguments matters: the area may be 0, and x NaN
      x = quantized(std::log((std::max)(least_length, x)));
    result.push_back(shape);
  }
  return result;
}

// Gives congruent cuts, such as the cuts of the legs of a horse in a pose, the mean of their
// saliences. Cuts that have a partner in place get none. The merges ascend in salience.
inline Merge_tree average_saliences(Merge_tree tree, const Surface& mesh,
                                    const std::vector<std::size_t>& partner)
{
  const std::vector<Cut_shape> shapes = cut_shapes(mesh, tree);
  std::vector<std::size_t> all;
  for (std::size_t i = shapes.size(); i-- > 0;)
    if (partner[i] == null_node)
      all.push_back(i);
  for (const std::vector<std::size_t>& congruent : first_fit_classes(all,
         [&](std::size_t i, std::size_t j)
         { return difference(shapes[i], shapes[j]) <= difference_of_congruent_cuts; })) {
    const double largest = tree.merges[congruent.front()].salience,
                 least = tree.merges[congruent.back()].salience;
    double mean = 0; // NaN if saliences are infinite with both signs
    for (std::size_t i : congruent)
      mean += tree.merges[i].salience / static_cast<double>(congruent.size());
    mean = mean > least ? (std::min)(mean, largest) : least;
    for (std::size_t i : congruent)
      tree.merges[i].salience = mean;
  }
  return tree;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_CONGRUENT_CUTS_H
