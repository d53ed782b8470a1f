// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_LEVEL_FIGURES_H
#define MANUAL_FIGURES_LEVEL_FIGURES_H

#include "Picture_book.h"
#include "segmentations.h"

#include <CGAL/Spectral_segmentation/internal/levels/make_levels.h>
#include <CGAL/Spectral_segmentation/internal/levels/prepare_surface.h>
#include <CGAL/Spectral_segmentation/internal/search/recursion.h>
#include <CGAL/Spectral_segmentation/internal/search/region_merging.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace manual_figures {

// Returns the faces of a surface, each with vertices of its own: a level need not be a manifold.
inline Mesh mesh_of(const CGAL::Spectral_segmentation::internal::Surface& surface)
{
  Mesh result;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    Mesh::Vertex_index v[3];
    for (unsigned i = 0; i < 3; ++i) {
      const auto& p = surface.points[surface.source_vertex(static_cast<unsigned>(3 * f + i))];
      v[i] = result.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
    }
    result.add_face(v[0], v[1], v[2]);
  }
  return result;
}

// Returns a color for each leaf of a tree: the most frequent among those of the faces of the next
// level whose parents are in the leaf.
inline std::vector<Rgb>
most_frequent_colors(const CGAL::Spectral_segmentation::internal::Merge_tree& tree,
                     const std::vector<unsigned>& parent, const std::vector<Rgb>& colors)
{
  std::vector<std::map<Rgb, std::size_t> > number(tree.leaves.size());
  for (std::size_t f = 0; f < parent.size(); ++f)
    ++number[tree.leaf[parent[f]]][colors[f]];
  std::vector<Rgb> result;
  for (const std::map<Rgb, std::size_t>& of_leaf : number)
    result.push_back(std::max_element(of_leaf.begin(), of_leaf.end(), [](auto& a, auto& b)
      { return a.second < b.second; })->first);
  return result;
}

// Draws the levels of the first search of a run, the last first, each with the leaves of its tree.
inline void draw_levels(Picture_book& book, const Named_mesh& shape)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  const Engine_options options;
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  const internal::Constraints constraints;
  const internal::Feature_source features;
  const internal::Run_data d{options, options, constraints, features, Execution::PARALLEL, monitor,
                             0};
  internal::Levels l;
  l.shared.push_back(internal::first_level(segmentation_benchmark::triangles_of(shape.mesh)));
  internal::prepare_surface(l.shared.front(), d);
  internal::make_levels(l, 1, d);
  const std::vector<const internal::Level*> levels = l.levels_of(0);

  const Surface& searched = levels.back()->surface;
  const internal::Calibrated_cut best_cut(searched, options, options);
  const std::vector<internal::Index> regions =
    internal::Recursion(d.execution, searched, best_cut, options, monitor)
      .by_salience(options.number_of_regions).leaf;
  internal::Merge_tree tree = internal::Region_merging(
    d.execution, searched, best_cut.context(), options.part_salience, monitor)(regions);

  std::vector<Rgb> color(tree.leaves.size());
  segment_mesh::Color_sequence sequence;
  for (Rgb& c : color)
    c = sequence().rgb;
  for (std::size_t i = levels.size(); i-- > 0;) {
    std::vector<Rgb> colors;
    for (internal::Index leaf : tree.leaf)
      colors.push_back(color[leaf]);
    const std::string caption = "level " + std::to_string(i) + ": " +
                                count(tree.leaf.size(), "faces");
    book.add("levels",
             {{shape.name + " in its frame", mesh_of(levels[i]->surface)}, caption, colors});
    if (i == 0)
      return;
    tree = internal::carry_back(tree, *levels[i], levels[i - 1]->surface,
                                [](const std::vector<internal::Index>&, Surface&) {}, d);
    color = most_frequent_colors(tree, levels[i]->parent_face, colors);
  }
}

} // namespace manual_figures

#endif // MANUAL_FIGURES_LEVEL_FIGURES_H
