// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_REGION_MERGING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_REGION_MERGING_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/surface/extract_part.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut_evaluator.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Merges the regions of an over-segmentation. The two neighbors whose common boundary is the least
// salient become one, until each component of the mesh is whole again. A cut that was needed only
// to reach other cuts is undone on the way. The merges in reverse are a hierarchy of cuts.
class Region_merging
{
  typedef std::pair<std::size_t, std::size_t> Pair; // two regions, the lower index first

  // The boundary of two regions as the cut of their union.
  struct Boundary
  {
    double salience;
    Salience_factors factors;
    double area[2]; // the areas of the smaller and the larger region
    bool first_is_smaller;
  };

  struct Merge
  {
    Pair regions; // the two become the first of them
    Boundary boundary;
  };

  const Execution execution_;
  const Surface& mesh_;
  const Evaluation_context& context_;
  const Part_salience& part_salience_;
  Run_monitor& monitor_;

  std::vector<std::vector<Index> > faces_; // one list per region, ascending
  std::vector<std::size_t> region_;        // one per face
  std::vector<Merge> merges_;              // the possible merges of neighbors

  Boundary evaluated(const Pair& regions) const
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
    const bool first_is_smaller = area[0] <= area[1];
    normalize_sides(side, area);
    const Surface both = Part_extractor(mesh_)(faces);
    const Salience_factors factors = Cut_evaluator(both, faces, context_)(side);
    monitor_.control().cut_evaluated({Evaluated_cut::BOUNDARY, faces, side, factors});
    return {salience_of(part_salience_, factors), factors, {area[0], area[1]}, first_is_smaller};
  }

  // Compares saliences. Ties go to the pair with the lower indices.
  static bool is_less_salient(const Merge& a, const Merge& b)
  {
    const double of_a = quantized(a.boundary.salience), of_b = quantized(b.boundary.salience);
    return of_a < of_b || (of_a == of_b && a.regions < b.regions);
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
    const std::size_t first = merges_.size();
    for (const Pair& regions : neighbors)
      merges_.push_back({regions, {}});
    for_each_index(execution_, neighbors.size(), [&](std::size_t i) {
      Merge& m = merges_[first + i];
      m.boundary = evaluated(m.regions);
    });
  }

  void merge(const Pair& regions)
  {
    const auto [into, from] = regions;
    const auto touches = [into = into, from = from](const Merge& m) {
      const auto [first, second] = m.regions;
      return first == into || second == into || first == from || second == from;
    };
    merges_.erase(std::remove_if(merges_.begin(), merges_.end(), touches), merges_.end());
    const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(faces_[into].size());
    faces_[into].insert(faces_[into].end(), faces_[from].begin(), faces_[from].end());
    std::inplace_merge(faces_[into].begin(), faces_[into].begin() + size, faces_[into].end());
    for (Index f : faces_[from])
      region_[f] = into;
    faces_[from].clear();
    evaluate_boundaries(faces_[into]);
  }

  // Merges until no regions are adjacent.
  std::vector<Merge> merge_all()
  {
    std::vector<Index> all(mesh_.number_of_faces());
    std::iota(all.begin(), all.end(), Index(0));
    evaluate_boundaries(all);
    std::vector<Merge> merges;
    while (!merges_.empty()) {
      merges.push_back(*std::min_element(merges_.begin(), merges_.end(), is_less_salient));
      merge(merges.back().regions);
      monitor_.approach(1. / static_cast<double>(faces_.size()));
    }
    return merges;
  }

  // Raises saliences so that a boundary that outlives another is at least as salient.
  static void make_ultrametric(std::vector<Merge>& merges)
  {
    for (std::size_t k = 1; k < merges.size(); ++k)
      merges[k].boundary.salience =
        (std::max)(merges[k].boundary.salience, merges[k - 1].boundary.salience);
  }

public:
  Region_merging(Execution execution, const Surface& mesh, const Evaluation_context& context,
                 const Part_salience& part_salience, Run_monitor& monitor)
    : execution_(execution), mesh_(mesh), context_(context), part_salience_(part_salience),
      monitor_(monitor) {}

  // Returns the hierarchy of all merges. Its leaves are `regions`, the leaves of an
  // over-segmentation.
  Cut_hierarchy operator()(const Cut_hierarchy& regions)
  {
    // Regions are numbered by their first faces.
    std::vector<std::size_t> number(regions.nodes.size(), null_node);
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      std::size_t& region = number[regions.leaf[f]];
      if (region == null_node) {
        region = faces_.size();
        faces_.emplace_back();
      }
      region_.push_back(region);
      faces_[region].push_back(f);
    }
    const std::vector<std::size_t> region_of_face = region_;
    std::vector<Merge> merges = merge_all();
    make_ultrametric(merges);

    Cut_hierarchy result;
    result.is_monotonic = true;
    result.number_of_roots = regions.number_of_roots;
    result.nodes.resize(result.number_of_roots);
    for (std::size_t i = 0; i < result.number_of_roots; ++i)
      result.nodes[i].area = regions.nodes[i].area;
    // A region that was not merged into another is a root. Roots are numbered like components.
    std::vector<std::size_t> node(faces_.size()); // the node of each region and all merged into it
    std::size_t next_root = 0;
    for (std::size_t region = 0; region < faces_.size(); ++region)
      if (!faces_[region].empty())
        node[region] = next_root++;
    CGAL_assertion(next_root == result.number_of_roots);
    for (auto m = merges.rbegin(); m != merges.rend(); ++m) {
      const auto [into, from] = m->regions;
      const std::size_t parent = node[into];
      Cut_node& n = result.nodes[parent];
      n.cut_state = Cut_state::CUT;
      n.salience = m->boundary.salience;
      n.factors = m->boundary.factors;
      result.cut_order.push_back(parent);
      result.cut(parent, m->boundary.area[0], m->boundary.area[1]);
      const std::size_t smaller = result.nodes.size() - 2;
      node[into] = m->boundary.first_is_smaller ? smaller : smaller + 1;
      node[from] = m->boundary.first_is_smaller ? smaller + 1 : smaller;
    }
    for (Cut_node& n : result.nodes)
      if (n.is_leaf())
        n.cut_state = Cut_state::NO_CUT;
    result.leaf.reserve(region_of_face.size());
    for (std::size_t region : region_of_face)
      result.leaf.push_back(static_cast<Index>(node[region]));
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_REGION_MERGING_H
