// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RUN_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RUN_H

#include <CGAL/Spectral_segmentation/internal/constraints/Constrained_merging.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Constraint_groups.h>
#include <CGAL/Spectral_segmentation/internal/constraints/further_cuts.h>
#include <CGAL/Spectral_segmentation/internal/cut_surface.h>
#include <CGAL/Spectral_segmentation/internal/engine.h>
#include <CGAL/Spectral_segmentation/internal/model/cut_model.h>
#include <CGAL/Spectral_segmentation/internal/model/prepare_model.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Spectral_segmentation::internal {

// Returns the hierarchy of a tree in the indices and the unit of the caller. The square of the unit
// may be infinite even if an area is not.
inline Cut_hierarchy hierarchy_of_caller(Merge_tree tree, const Face_map& map)
{
  tree.leaf = composed(map.face, tree.leaf);
  Cut_hierarchy result = hierarchy_of(tree);
  for (Cut_node& node : result.nodes)
    node.area = node.area * map.unit * map.unit;
  return result;
}

// Returns the hierarchy of a mesh. A connected mesh is cut as a whole, and so is any mesh by the
// method of the paper. Other meshes are cut in parts.
inline Cut_hierarchy run(Surface input, const Run_data& d)
{
  Face_map map;
  Assembled_model m; // stays empty if the mesh is connected
  Constraint_groups groups;
  Levels l = d.monitor.stage(Stage::INITIALIZATION, Segmentation_visitor::whole_mesh, [&] {
    d.start_phase(Phase_times(d, input.number_of_faces()).reading);
    Levels l;
    l.shared.push_back(first_level(std::move(input)));
    Level& mesh = l.shared.front();
    if (mesh.surface.components.number > 1)
      m = prepare_model(mesh, map, d);
    else
      map = prepare_surface(mesh, d);
    if (!d.constraints.empty())
      groups = Constraint_grouping(d.constraints, map.face,
                                   mesh.surface)(d.options.keep_components_separate);
    if (m.parts.empty())
      make_levels(l, d.options.number_of_searches, d);
    return l;
  });
  Merge_tree tree = m.parts.empty() ? cut_surface(l, d, m.fractions.effective_number())
                                    : cut_parts(l, m, map, d);
  tree = enforce_constraints(std::move(tree), groups, l.shared.front(), d);
  tree = cut_further(std::move(tree), groups, l.mesh(), d);
  tree = add_walls(std::move(tree), m, map);
  d.monitor.finish();
  return hierarchy_of_caller(std::move(tree), map);
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
  separate_fans(soup);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RUN_H
