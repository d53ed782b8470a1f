// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_SURFACE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_SURFACE_H

#include <CGAL/Spectral_segmentation/internal/levels/make_levels.h>
#include <CGAL/Spectral_segmentation/internal/search/congruent_cuts.h>
#include <CGAL/Spectral_segmentation/internal/search/mirrored_cuts.h>
#include <CGAL/Spectral_segmentation/internal/search/recursion.h>
#include <CGAL/Spectral_segmentation/internal/search/region_merging.h>
#include <CGAL/Spectral_segmentation/internal/surface/mirror_symmetry.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Cuts the last level by the method of the paper (Sections 2 to 6): the largest part next, until no
// part has a salient cut. Its surface is moved, unless a later stage needs it.
inline Merge_tree search_paper(Levels& l, const Run_data& d, double number_of_components)
{
  Surface& surface = l.levels.back().surface;
  const Paper_cut best_cut(surface, d.options);
  const bool is_needed = l.levels.size() > 1 || d.options.number_of_segments;
  return Recursion(d.execution, is_needed ? surface : std::move(surface), best_cut, d.options,
                   d.monitor).by_area(number_of_components);
}

// Cuts the last level by the calibrated method: divides it into regions, merges them again, the
// least salient boundary first.
inline Merge_tree search_calibrated(const Levels& l, const Run_data& d)
{
  const Surface& surface = l.last();
  const Calibrated_cut best_cut(surface, d.options, d.method, l.features, d.fraction_of_model);
  const std::vector<Index> regions =
    Recursion(d.execution, surface, best_cut, d.options, d.monitor)
      .by_salience(d.method.number_of_regions).leaf;
  return d.monitor.stage(Stage::MERGING, Segmentation_visitor::whole_mesh, [&] {
    const auto merged = [&](const std::vector<Index>& regions_of_faces) {
      return Region_merging(d.execution, surface, best_cut.context(), d.options.part_salience,
                            d.monitor)(regions_of_faces);
    };
    Merge_tree tree = merged(regions);
    std::vector<Index> image; // of each face, if the surface is its own mirror image
    if (surface.components.number == 1 && d.monitor.go_further() &&
        d.options.part_salience.target<Calibrated_part_salience>()) {
      const Mirror_symmetry symmetry(surface);
      if (const auto reflection = symmetry())
        image = symmetry.images(d.execution, *reflection);
    }
    if (!image.empty()) {
      tree = apply_from_top_down(std::move(tree));
      const std::vector<Index> divided =
        Mirrored_cuts(surface, tree, image).divided_leaves(best_cut.minimum_area());
      if (divided != tree.leaf && d.monitor.go_further())
        tree = merged(divided);
    }
    tree = apply_from_top_down(std::move(tree));
    std::vector<std::size_t> partner(tree.merges.size(), null_node);
    if (!image.empty()) {
      Mirrored_cuts cuts(surface, tree, image);
      partner = cuts.partners();
      tree.leaf = cuts.mirrored_leaves(partner, best_cut.minimum_area());
      set_areas_of_leaves(tree, surface);
      tree = average_partners(std::move(tree), partner);
    }
    return apply_from_top_down(average_saliences(std::move(tree), surface, partner));
  });
}

// Searches the cuts of the last level, and carries them back to the mesh. A convex mesh has no
// cuts, and neither has a mesh whose run was stopped before. The method of the paper may ask for
// the effective number of components.
inline Merge_tree cut_surface(Levels& l, const Run_data& d, double number_of_components = 1)
{
  const Phase_times times(d, l.mesh().number_of_faces());
  d.start_phase(times.search);
  if (l.search != Search::NEEDED) {
    const bool is_stopped = l.search == Search::STOPPED;
    Merge_tree tree = uncut_tree(l.mesh(), is_stopped ? Cut_state::NOT_SEARCHED
                                                      : Cut_state::NO_CUT);
    tree.is_monotonic = !is_stopped;
    return tree;
  }
  Merge_tree tree = d.options.method == Method::ZHANG_LIU_2005
    ? search_paper(l, d, number_of_components) : search_calibrated(l, d);
  d.start_phase(times.projection);
  const auto carry_back_to_mesh = [&] {
    while (l.levels.size() > 1)
      tree = carry_back(std::move(tree), l, d);
    return std::move(tree);
  };
  const bool is_searched_copy = l.levels.size() == 2 && l.levels.back().is_subdivision;
  if (l.levels.size() == 1 || is_searched_copy) // too little work for a stage
    return carry_back_to_mesh();
  return d.monitor.stage(Stage::PROJECTION, Segmentation_visitor::whole_mesh, carry_back_to_mesh);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_SURFACE_H
