// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RUN_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RUN_H

#include <CGAL/Spectral_segmentation/internal/engine.h>
#include <CGAL/Spectral_segmentation/internal/levels/make_levels.h>
#include <CGAL/Spectral_segmentation/internal/levels/prepare_mesh.h>
#include <CGAL/Spectral_segmentation/internal/search/mirrored_cuts.h>
#include <CGAL/Spectral_segmentation/internal/search/region_merging.h>
#include <CGAL/Spectral_segmentation/internal/surface/mirror_symmetry.h>
#include <CGAL/Spectral_segmentation/internal/tree/Component_merging.h>
#include <CGAL/Spectral_segmentation/internal/tree/Constrained_merging.h>
#include <CGAL/Spectral_segmentation/internal/tree/Constraint_groups.h>
#include <CGAL/Spectral_segmentation/internal/tree/congruent_cuts.h>
#include <CGAL/Spectral_segmentation/internal/tree/further_cuts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Cuts the last level by the method of the paper (Sections 2 to 6): the largest part next, until no
// part has a salient cut. Its surface is moved, unless a later stage needs it.
inline Merge_tree search_paper(Levels& l, const Run_data& d)
{
  Surface& surface = l.levels.back().surface;
  const Paper_cut best_cut(surface, d.options);
  const bool is_needed = l.levels.size() > 1 || d.options.number_of_segments;
  return Recursion(d.execution, is_needed ? surface : std::move(surface), best_cut, d.options,
                   d.monitor).by_area();
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
      apply_from_top_down(tree);
      const std::vector<Index> divided =
        Mirrored_cuts(surface, tree, image).divided_leaves(best_cut.minimum_area());
      if (divided != tree.leaf && d.monitor.go_further())
        tree = merged(divided);
    }
    apply_from_top_down(tree);
    std::vector<std::size_t> partner(tree.merges.size(), null_node);
    if (!image.empty()) {
      Mirrored_cuts cuts(surface, tree, image);
      partner = cuts.partners();
      tree.leaf = cuts.mirrored_leaves(partner, best_cut.minimum_area());
      set_areas_of_leaves(tree, surface);
      average_partners(tree, partner);
    }
    average_saliences(surface, tree, partner);
    apply_from_top_down(tree);
    return tree;
  });
}

// Searches the cuts of the last level, and carries them back to the mesh. A convex mesh has no
// cuts, and neither has a mesh whose run was stopped before.
inline Merge_tree cut_mesh(Levels& l, const Run_data& d)
{
  const Phase_times times(d, l.mesh().number_of_faces());
  d.start_phase(times.search);
  if (l.last().weights.empty()) {
    const bool is_stopped = d.monitor.is_stopped();
    Merge_tree tree = uncut_tree(l.mesh(), is_stopped ? Cut_state::NOT_SEARCHED
                                                      : Cut_state::NO_CUT);
    tree.is_monotonic = !is_stopped;
    return tree;
  }
  Merge_tree tree = d.options.method == Method::ZHANG_LIU_2005
    ? search_paper(l, d) : search_calibrated(l, d);
  d.start_phase(times.projection);
  const auto carry_back_to_mesh = [&] {
    while (l.levels.size() > 1)
      tree = carry_back(tree, l, d);
    return std::move(tree);
  };
  const bool is_searched_copy = l.levels.size() == 2 && l.levels.back().is_subdivision;
  if (l.levels.size() == 1 || is_searched_copy) // too little work for a stage
    return carry_back_to_mesh();
  return d.monitor.stage(Stage::PROJECTION, Segmentation_visitor::whole_mesh, carry_back_to_mesh);
}

// Returns the cuts of a part of a model, and the caller's face for each of its faces. The part may
// be searched at the scale of the model, of whose area it has a fraction.
inline std::pair<Merge_tree, std::vector<Index> >
cut_part(Part_of_model part, double time_scale, const Run_data& d)
{
  Options options = d.options;
  Method_constants method = d.method;
  if (part.fraction_of_model != 1) { // else any number of coarse faces stays, however large
    method.concavity_radius /= std::sqrt(part.fraction_of_model);
    options.number_of_coarse_faces = static_cast<std::size_t>(std::ceil(
      static_cast<double>(options.number_of_coarse_faces) * part.fraction_of_model));
  }
  const Run_data of_part{options, method, d.constraints, d.features, d.execution, d.monitor,
                         time_scale, part.fraction_of_model};
  Levels l = d.monitor.stage(Stage::INITIALIZATION, Segmentation_visitor::whole_mesh, [&] {
    prepare_part(part.mesh, of_part);
    return make_levels(std::move(part.mesh), of_part);
  });
  Merge_tree tree = cut_mesh(l, of_part);
  return {std::move(tree), l.callers_faces(0)};
}

// Returns the features of the components of the mesh, computed on its last level. `face` holds the
// face of the mesh for each of the caller's faces.
inline Set_features features_of_components(Model& m, const std::vector<Index>& face,
                                           const Run_data& d)
{
  if (!has_features(d))
    return {};
  Levels l = make_levels(std::move(m.mesh), d);
  std::vector<Index> component = composed(l.callers_faces(l.levels.size() - 1), face);
  for (Index& f : component)
    f = l.mesh().components[f];
  const Set_features result = l.features.empty() ? Set_features() :
    Set_features(l.features, l.last().areas, component, l.mesh().components.number);
  m.mesh = std::move(l.levels.front());
  return result;
}

// Cuts the parts of a model one after the other, and merges its components unless they are kept.
inline Merge_tree cut_parts(Model& m, const Run_data& d)
{
  double time = 1;
  for (const Part_of_model& part : m.parts)
    time += Phase_times(d, part.mesh.parent_face.size()).time_after_reading();
  const std::vector<Index> face = m.faces();
  Merge_tree tree;
  tree.leaf.resize(m.mesh.parent_face.size());
  const double rest = 1 - d.time_scale * Phase_times(d, face.size()).reading; // of the run
  for (Part_of_model& part : m.parts) {
    const auto [of_part, callers_face] = cut_part(std::move(part), rest / time, d);
    append(tree, of_part, composed(callers_face, face));
  }
  set_areas_of_leaves(tree, m.mesh.surface);
  if (d.options.keep_components_separate) {
    apply_from_top_down(tree);
    tree.is_monotonic = !d.monitor.is_stopped();
    return tree;
  }
  const Set_features features = features_of_components(m, face, d);
  return Component_merging(std::move(tree), m.mesh.surface, m.fractions, features,
                           d.options.feature_weight, d.monitor)();
}

// Adds the walls to a tree. Their faces get the leaves of the nearest faces of their outer walls,
// provided that the faces of a wall in each set stay connected.
inline void add_walls(Merge_tree& tree, const Model& m)
{
  if (m.outer_face.empty())
    return;
  std::vector<Index> leaf = composed(composed(m.outer_face, m.faces()), tree.leaf);
  Wall_labels(m.walls.surface, tree, leaf)();
  for (std::size_t i = 0; i < leaf.size(); ++i) {
    tree.leaf.push_back(leaf[i]);
    tree.leaves[leaf[i]].area += m.walls.surface.areas[i];
  }
}

// Returns the hierarchy of a tree in the indices and the unit of the caller. The square of the unit
// may be infinite even if an area is not.
inline Cut_hierarchy hierarchy_of_caller(Merge_tree tree, Model m)
{
  tree.leaf = composed(m.faces(), tree.leaf);
  Cut_hierarchy result = hierarchy_of(tree);
  for (Cut_node& node : result.nodes)
    node.area = node.area * m.unit * m.unit;
  result.neighbors = std::move(m.neighbors);
  return result;
}

// Returns the hierarchy of a mesh. A connected mesh is cut as a whole, and so is any mesh by the
// method of the paper. Other meshes are cut in parts.
inline Cut_hierarchy run(Surface input, const Run_data& d)
{
  Model m;
  Constraint_groups groups;
  Levels l = d.monitor.stage(Stage::INITIALIZATION, Segmentation_visitor::whole_mesh, [&] {
    m = prepare_model(std::move(input), d);
    if (!d.constraints.empty())
      groups = Constraint_grouping(d.constraints, m.faces(),
                                   m.mesh.surface)(d.options.keep_components_separate);
    return m.parts.empty() ? make_levels(std::move(m.mesh), d) : Levels();
  });
  Merge_tree tree;
  if (m.parts.empty()) {
    tree = cut_mesh(l, d);
    m.mesh = std::move(l.levels.front());
  }
  else
    tree = cut_parts(m, d);
  enforce_constraints(tree, groups, m.mesh, d);
  cut_further(tree, groups, m.mesh.surface, d);
  add_walls(tree, m);
  d.monitor.finish();
  return hierarchy_of_caller(std::move(tree), std::move(m));
}

CGAL_SPECTRAL_SEGMENTATION_INLINE
Cut_hierarchy segment(Surface surface, const Options& options, const Method_constants& method,
                      Execution execution, Run_control& control, const Constraints& constraints,
                      const Feature_source& features)
{
  const bool is_paper = options.method == Method::ZHANG_LIU_2005;
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument("segment_spectral_recursive: the method of the paper takes no " +
                                what + ": use the calibrated method with them");
  };
  if (is_paper && !constraints.empty())
    refuse("constraints");
  if (is_paper && features.dimension > 0 && options.feature_weight > 0)
    refuse("features");
  Cut_hierarchy result;
  call_isolated([&] {
    Run_monitor monitor(control);
    Run_data d{options, method, constraints, features, execution, monitor, 0};
    const Phase_times times(d, surface.number_of_faces());
    d.time_scale = 1 / (std::max)(times.reading + times.time_after_reading(), 1.);
    result = run(std::move(surface), d);
  });
  return result;
}

CGAL_SPECTRAL_SEGMENTATION_INLINE
void connect(Surface& soup)
{
  separate_groups(soup);
  connect_triangles(soup);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RUN_H
