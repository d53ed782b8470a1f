// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_SURFACE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_SURFACE_H

#include <CGAL/Spectral_segmentation/internal/levels/agreement.h>
#include <CGAL/Spectral_segmentation/internal/levels/make_levels.h>
#include <CGAL/Spectral_segmentation/internal/search/symmetric_cuts.h>
#include <CGAL/Spectral_segmentation/internal/search/recursion.h>
#include <CGAL/Spectral_segmentation/internal/search/region_merging.h>
#include <CGAL/Spectral_segmentation/internal/surface/symmetries.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Calls f(), which carries cuts back to the mesh, as a stage, unless there is too little work.
template <class Function>
Merge_tree project(const Levels& l, const Run_data& d, const Function& f)
{
  d.start_phase(Phase_times(d, l.mesh().number_of_faces()).projection);
  const auto has_coarse_level = [](const Searched_levels& search)
  { return !search.levels.empty() && !search.levels[0].is_subdivision; };
  const bool is_coarse = l.shared.size() > 1 ||
                         std::any_of(l.searches.begin(), l.searches.end(), has_coarse_level);
  return is_coarse ? d.monitor.stage(Stage::PROJECTION, Segmentation_visitor::whole_mesh, f) : f();
}

// Cuts the only surface that is searched by the method of the paper (Sections 2 to 6): the largest
// part next, until no part has a salient cut. The surface is moved, unless a later stage needs it.
inline Merge_tree search_paper(Levels& l, const Run_data& d, double number_of_components)
{
  Surface& surface = l.searched(0);
  const Paper_cut best_cut(surface, d.options);
  const bool is_needed = &surface != &l.mesh() || d.options.number_of_segments;
  Merge_tree tree = Recursion(d.execution, is_needed ? surface : std::move(surface), best_cut,
                              d.options, d.monitor).by_area(number_of_components);
  return project(l, d, [&] { return carry_to_mesh(std::move(tree), l, 0, d); });
}

// A search by the calibrated method: divides a surface into regions, and merges them again, the
// least salient boundary first.
class Calibrated_search
{
  const Surface& surface_;
  const Run_data& d_;
  const std::size_t search_; // its position among the searches
  const Calibrated_cut best_cut_;
  Merge_tree tree_; // once regions are merged, cuts are applied from the top down

  Merge_tree merged(const std::vector<Index>& regions) const
  {
    return apply_from_top_down(
      Region_merging(d_.execution, surface_, best_cut_.context(), d_.options.part_salience,
                     d_.monitor)(regions));
  }

public:
  Calibrated_search(const Levels& l, std::size_t search, const Run_data& d)
    : surface_(l.searched(search)), d_(d), search_(search),
      best_cut_(surface_, d.options, d.method, l.searches[search].features, d.fraction_of_model) {}

  const Merge_tree& tree() const { return tree_; }

  void find_regions()
  {
    tree_ = Recursion(d_.execution, surface_, best_cut_, d_.options, d_.monitor, search_)
      .by_salience(d_.method.number_of_regions);
  }

  // Merges the regions. Treats the images of cuts under symmetries of the surface like the cuts.
  void merge_regions(const std::vector<Rigid_motion>& symmetries)
  {
    tree_ = merged(tree_.leaf);
    if (symmetries.empty())
      return;
    const Symmetry_search search(surface_);
    std::vector<std::vector<Index> > images;
    for (const Rigid_motion& motion : symmetries)
      images.push_back(search.images(d_.execution, motion));
    const std::vector<Index> divided =
      Symmetric_cuts(surface_, tree_, images).divided_leaves(best_cut_.minimum_area());
    if (divided != tree_.leaf && d_.monitor.go_further())
      tree_ = merged(divided);
    Symmetric_cuts cuts(surface_, tree_, images);
    const std::vector<Partner> partner = cuts.partners();
    tree_.leaf = cuts.moved_leaves(partner, best_cut_.minimum_area());
    set_areas_of_leaves(tree_, surface_);
    tree_ = apply_from_top_down(merge_symmetrically(surface_, std::move(tree_), partner));
  }
};

// Searches by the calibrated method, and carries back to the mesh the cuts of the search whose
// segments agree best with those of the others; of the first if the run is stopped meanwhile. They
// are the segments above the default threshold, so that a hierarchy gives the labels of all runs.
inline Merge_tree search_calibrated(const Levels& l, const Run_data& d)
{
  const std::size_t n = l.searches.size();
  std::vector<std::unique_ptr<Calibrated_search> > searches;
  for (std::size_t i = 0; i < n; ++i)
    searches.push_back(std::make_unique<Calibrated_search>(l, i, d));
  for_each_index(d.execution, n, [&](std::size_t i) { searches[i]->find_regions(); });
  d.monitor.stage(Stage::MERGING, Segmentation_visitor::whole_mesh, [&] {
    std::vector<Rigid_motion> symmetries;
    if (l.mesh().components.number == 1 && !d.monitor.is_stopped() &&
        d.options.part_salience.target<Calibrated_part_salience>())
      symmetries = Symmetry_search(l.searched(0)).symmetries();
    for_each_index(d.execution, n, [&](std::size_t i) { searches[i]->merge_regions(symmetries); });
    return true;
  });
  const Surface& common = l.shared.back().surface;
  Options options = d.options;
  options.number_of_segments.reset();
  if (options.part_salience.target<Calibrated_part_salience>()) // else the caller knows the scale
    options.salience_threshold.reset();
  return project(l, d, [&] {
    std::size_t chosen = 0;
    if (n > 1 && !d.monitor.is_stopped()) {
      std::vector<std::vector<Index> > segments(n);
      for_each_index(d.execution, n, [&](std::size_t i) {
        segments[i] = segments_of_finer_faces(
          common, l.searched(i), segments_above(searches[i]->tree(), threshold_of(options)),
          last_vertices(l.levels_of(i), l.shared.size() - 1));
      });
      chosen = most_agreed(segments, common.areas);
    }
    return carry_to_mesh(searches[chosen]->tree(), l, chosen, d);
  });
}

// Searches cuts, and carries them back to the mesh. A convex mesh has no cuts, and neither has a
// mesh whose run was stopped before. The method of the paper may ask for the effective number of
// components.
inline Merge_tree cut_surface(Levels& l, const Run_data& d, double number_of_components = 1)
{
  d.start_phase(Phase_times(d, l.mesh().number_of_faces()).search);
  if (l.search != Search::NEEDED) {
    const bool is_stopped = l.search == Search::STOPPED;
    Merge_tree tree = uncut_tree(l.mesh(), is_stopped ? Cut_state::NOT_SEARCHED
                                                      : Cut_state::NO_CUT);
    tree.is_monotonic = !is_stopped;
    return tree;
  }
  return d.options.method == Method::ZHANG_LIU_2005 ? search_paper(l, d, number_of_components)
                                                    : search_calibrated(l, d);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_SURFACE_H
