// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_REGION_MERGING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_REGION_MERGING_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/Dendrogram.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut_evaluator.h>
#include <CGAL/Spectral_segmentation/internal/surface/submesh.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Merges the regions of an over-segmentation: the two neighbors whose common boundary is the least
// salient become one, until each component of the mesh is whole again. A cut that was needed only
// to reach others is undone on the way.
class Region_merging
{
  typedef std::pair<Index, Index> Pair; // of regions, the smaller number first

  const Execution execution_;
  const Surface& mesh_;
  const Evaluation_context& context_;
  const Part_salience& part_salience_;
  Run_monitor& monitor_;

  std::vector<std::vector<Index> > faces_; // of each region, ascending
  std::vector<Index> region_;              // of each face
  std::vector<Merge> boundaries_;          // of neighbors; regions are known by their first leaves

  Merge evaluated(const Pair& regions) const
  {
    const std::vector<Index>& first = faces_[regions.first];
    const std::vector<Index>& second = faces_[regions.second];
    std::vector<Index> faces;
    std::merge(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(faces));
    Sides side;
    double area[2] = {0, 0};
    for (Index f : faces) {
      side.push_back(region_[f] == regions.first ? 0 : 1);
      area[int(side.back())] += mesh_.areas[f];
    }
    Merge result{{regions.first, regions.second}};
    if (area[0] > area[1])
      std::swap(result.leaves[0], result.leaves[1]);
    normalize_sides(side, area);
    const Surface both = Submesh_extractor(mesh_)(faces);
    std::vector<Index> near;
    result.factors = Cut_evaluator(both, faces, context_)(side, near);
    result.salience = salience_of(part_salience_, result.factors);
    monitor_.cut_evaluated({Evaluated_cut::BOUNDARY, faces, side, result.factors});
    return result;
  }

  // Of equals that of the first regions.
  static bool is_less_salient(const Merge& a, const Merge& b)
  {
    const double of_a = quantized(a.salience), of_b = quantized(b.salience);
    return of_a < of_b || (of_a == of_b && std::minmax({a.leaves[0], a.leaves[1]}) <
                                             std::minmax({b.leaves[0], b.leaves[1]}));
  }

  // Evaluates the boundaries of a region with its neighbors, or of all regions.
  void evaluate_boundaries(const std::vector<Index>& faces)
  {
    std::set<Pair> neighbors;
    for (Index f : faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const auto [a, b] = std::minmax({region_[f], region_[mesh_.neighbor(h)]});
        if (a != b)
          neighbors.insert({a, b});
      }
    const std::vector<Pair> pairs(neighbors.begin(), neighbors.end());
    const std::size_t first = boundaries_.size();
    boundaries_.resize(first + pairs.size());
    for_each_index(execution_, pairs.size(), [&](std::size_t i)
      { boundaries_[first + i] = evaluated(pairs[i]); });
  }

  void merge(Index a, Index b)
  {
    const auto touches = [=](const Merge& m) {
      return m.leaves[0] == a || m.leaves[0] == b || m.leaves[1] == a || m.leaves[1] == b;
    };
    boundaries_.erase(std::remove_if(boundaries_.begin(), boundaries_.end(), touches),
                      boundaries_.end());
    const auto [into, from] = std::minmax(a, b);
    const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(faces_[into].size());
    faces_[into].insert(faces_[into].end(), faces_[from].begin(), faces_[from].end());
    std::inplace_merge(faces_[into].begin(), faces_[into].begin() + size, faces_[into].end());
    for (Index f : faces_[from])
      region_[f] = into;
    faces_[from].clear();
    evaluate_boundaries(faces_[into]);
  }

public:
  Region_merging(Execution execution, const Surface& mesh, const Evaluation_context& context,
                 const Part_salience& part_salience, Run_monitor& monitor)
    : execution_(execution), mesh_(mesh), context_(context), part_salience_(part_salience),
      monitor_(monitor) {}

  // The leaves of `d`, which are numbered by their first faces, and all their merges.
  void operator()(Dendrogram& d)
  {
    number_leaves_by_first_faces(d);
    region_ = d.leaf;
    faces_.resize(d.number_of_leaves());
    for (Index f = 0; f < region_.size(); ++f)
      faces_[region_[f]].push_back(f);
    d.merges.clear();
    d.is_ultrametric = true;
    std::vector<Index> all(region_.size());
    std::iota(all.begin(), all.end(), Index(0));
    evaluate_boundaries(all);
    while (!boundaries_.empty()) {
      Merge m = *std::min_element(boundaries_.begin(), boundaries_.end(), is_less_salient);
      merge(m.leaves[0], m.leaves[1]);
      // A boundary that outlives another is at least as salient.
      if (!d.merges.empty())
        m.salience = (std::max)(m.salience, d.merges.back().salience);
      d.merges.push_back(m);
      monitor_.approach(1. / static_cast<double>(faces_.size()));
    }
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_REGION_MERGING_H
