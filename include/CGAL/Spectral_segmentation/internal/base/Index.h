// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_INDEX_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_INDEX_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The index of a face (f, g), a halfedge (h), a vertex (v), or the element that the name states.
typedef std::uint32_t Index;
constexpr Index null_index = static_cast<Index>(-1);

// Returns the indices below n in their order.
inline std::vector<Index> first_indices(std::size_t n)
{
  std::vector<Index> result(n);
  std::iota(result.begin(), result.end(), Index(0));
  return result;
}

// Returns the indices of the values, the smallest value first; `is_first(i, j)` breaks ties. No
// value may be NaN.
template <class Value, class IsFirst = std::less<Index> >
std::vector<Index> sorted_indices(const std::vector<Value>& values,
                                  const IsFirst& is_first = IsFirst())
{
  std::vector<Index> result = first_indices(values.size());
  std::sort(result.begin(), result.end(), [&](Index i, Index j)
    { return values[i] < values[j] || (values[i] == values[j] && is_first(i, j)); });
  return result;
}

// Numbers that decisions depend on are rounded to multiples of 2^-20. Sums of such numbers are
// exact as doubles. Therefore the length of a path does not depend on the order of summation, and
// mathematically equal numbers are equal in floating point.
constexpr double quantum = 1. / (1 << 20);
inline double quantized(double x) { return std::floor(x / quantum + 0.5) * quantum; }

// The constants on which, besides `Options`, the factors of cuts and therefore the fit of
// `Calibrated_part_salience` depend. They were chosen by trials on a prototype of the method. If
// one of them changes, the salience has to be fitted again (benchmark/fit_part_salience.py).
namespace constants {

// The radius of the neighborhood of a cut, in which factors are measured and minimum cuts are
// searched, relative to the square root of the area of the smaller side.
constexpr double neighborhood_radius = 0.35;

// The constant that is added to convexity defects before their ratio is taken. Defects well below
// it, relative to the square root of the area of the mesh, make no difference.
constexpr double smallest_convexity_defect = 0.005;

// The largest value of the factor `expansion_behind_cut`.
constexpr double largest_expansion = 4;

// The cost of an edge of the strongest concavity for a minimum cut, relative to a flat edge.
constexpr double cost_of_concave_edge = 0.05;

// The second proposal of an order differs from the first by this fraction of the smaller area.
constexpr double distance_of_proposals = 0.25;

// Two proposals are alike if the faces on which they differ are less than this percentage of the
// smallest side.
constexpr std::size_t percent_of_alike_proposals = 15;

// Proposals are taken while Q has at most this many times the area of the rest, because other
// orders start at the other end.
constexpr double largest_ratio_to_rest = 3;

// The curvature is averaged over a radius of at most the root of this number of mean face areas,
// about 9 faces, because the bands around the cuts of a coarsened mesh are not wider.
constexpr double largest_number_of_averaged_faces = 80;

} // namespace constants

// An immutable directed graph in compressed sparse row format. BGL's compressed_sparse_row_graph
// takes four times the memory for an arc, and a second to compile.
struct Packed_graph
{
  typedef std::pair<Index, Index> Ends; // the source and the target of an arc

  std::vector<Index> first_arc; // one per node, then the number of arcs
  std::vector<Index> targets;   // one per arc

  // Packs the arcs; the arcs of a node keep their order. Sets `position` to the index of each arc.
  Packed_graph(std::size_t number_of_nodes, const std::vector<Ends>& arcs,
               std::vector<Index>& position)
    : first_arc(number_of_nodes + 1, 0), targets(arcs.size())
  {
    position.resize(arcs.size());
    for (const Ends& ends : arcs)
      ++first_arc[ends.first + 1];
    std::partial_sum(first_arc.begin(), first_arc.end(), first_arc.begin());
    std::vector<Index> next = first_arc;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      position[i] = next[arcs[i].first]++;
      targets[position[i]] = arcs[i].second;
    }
  }

  Index number_of_nodes() const { return static_cast<Index>(first_arc.size() - 1); }
  Index number_of_arcs() const { return static_cast<Index>(targets.size()); }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_INDEX_H
