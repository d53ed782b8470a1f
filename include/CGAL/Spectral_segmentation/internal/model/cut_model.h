// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_CUT_MODEL_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_CUT_MODEL_H

#include <CGAL/Spectral_segmentation/internal/cut_surface.h>
#include <CGAL/Spectral_segmentation/internal/model/Component_merging.h>
#include <CGAL/Spectral_segmentation/internal/model/component_walls.h>
#include <CGAL/Spectral_segmentation/internal/model/prepare_model.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

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
    Levels l;
    l.shared.push_back(std::move(part.mesh));
    prepare_part(l.shared.front(), of_part);
    make_levels(l, d.options.number_of_searches, of_part);
    return l;
  });
  Merge_tree tree = cut_surface(l, of_part);
  return {std::move(tree), l.shared[0].parent_face};
}

// Returns the features of the components of the mesh, the only level, computed on its last level.
inline Set_features features_of_components(Levels& l, const Face_map& map, const Run_data& d)
{
  if (!has_features(d))
    return {};
  make_levels(l, 1, d);
  if (l.searches.empty()) // the run was stopped
    return {};
  const std::vector<const Level*> levels = l.levels_of(0);
  std::vector<Index> component = composed(callers_faces(levels, levels.size() - 1), map.face);
  for (Index& f : component)
    f = l.mesh().components[f];
  const Face_features& features = l.searches[0].features;
  const Set_features result = features.empty() ? Set_features() :
    Set_features(features, l.searched(0).areas, component, l.mesh().components.number);
  l.shared.resize(1);
  return result;
}

// Cuts the parts of a model one after the other, and merges its components unless they are kept.
inline Merge_tree cut_parts(Levels& l, Assembled_model& m, const Face_map& map, const Run_data& d)
{
  double time = 1;
  for (const Part_of_model& part : m.parts)
    time += Phase_times(d, part.mesh.parent_face.size()).time_after_reading();
  const double rest = // of the run
    1 - d.time_scale * Phase_times(d, map.face.size()).reading;
  Merge_tree tree;
  tree.leaf.resize(l.mesh().number_of_faces());
  for (Part_of_model& part : m.parts) {
    const auto [of_part, callers_face] = cut_part(std::move(part), rest / time, d);
    append(tree, of_part, composed(callers_face, map.face));
  }
  set_areas_of_leaves(tree, l.mesh());
  if (d.options.keep_components_separate) {
    tree = apply_from_top_down(std::move(tree));
    tree.is_monotonic = !d.monitor.is_stopped();
    return tree;
  }
  const Set_features features = features_of_components(l, map, d);
  return Component_merging(std::move(tree), l.mesh(), m.fractions, features,
                           d.options.feature_weight, d.monitor)();
}

// Adds the walls to a tree. Their faces get the leaves of the nearest faces of their outer walls,
// provided that the faces of a wall in each set stay connected.
inline Merge_tree add_walls(Merge_tree tree, const Assembled_model& m, const Face_map& map)
{
  if (m.outer_face.empty())
    return tree;
  std::vector<Index> leaf = composed(composed(m.outer_face, map.face), tree.leaf);
  Wall_labels(m.walls.surface, tree, leaf)();
  for (std::size_t i = 0; i < leaf.size(); ++i) {
    tree.leaf.push_back(leaf[i]);
    tree.leaves[leaf[i]].area += m.walls.surface.areas[i];
  }
  return tree;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_CUT_MODEL_H
