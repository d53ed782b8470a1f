// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BEST_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BEST_CUT_H

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/Cut_judge.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/cut_candidates.h>
#include <CGAL/Spectral_segmentation/internal/embedding.h>
#include <CGAL/Spectral_segmentation/internal/line_search.h>
#include <CGAL/Spectral_segmentation/internal/minimum_cut.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/internal/orderings.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>
#include <CGAL/Spectral_segmentation/internal/sampling.h>
#include <CGAL/Spectral_segmentation/internal/shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// A connected part of the mesh that may be cut.
struct Part
{
  Face_dual_graph graph;
  std::size_t node;    // in the segment tree
  Index smallest_face; // its number in the mesh
};

template <class Monitor>
Shape_contexts shape_contexts(const Part& part, const Options& options, Monitor& monitor)
{
  const Index first = options.random_seed
    ? random_face(part.graph, *options.random_seed, part.smallest_face)
    : farthest_face_from_center(part.graph);
  return shape_contexts(part.graph, first, options.number_of_reference_faces,
                        [&] { monitor.check(); });
}

// BESTCUT (Figure 2): the most salient cut of a part, if there is one.
// Throws `Run_stopped` if the visitor stops the run.
template <class ConcurrencyTag, class PartSalience, class Monitor>
std::optional<Cut> best_cut(const Part& part, const Options& options,
                            const PartSalience& part_salience, double minimum_area,
                            Monitor& monitor)
{
  const Face_dual_graph& m = part.graph;
  if (m.number_of_faces() < 2)
    return std::nullopt;
  monitor.check();
  monitor.start_part(part.node, m.number_of_faces());

  // 1. two sample faces
  const Sample_faces samples = monitor.stage(Stage::SAMPLING, part.node, [&]
    { return sample_faces(shape_contexts(part, options, monitor)); });

  // 2. distances from both; 3. to 5. the order of the faces on the line, for which neither kernel nor
  // eigenvectors are needed
  monitor.check();
  const std::vector<Index> line = monitor.stage(Stage::EMBEDDING, part.node, [&] {
    std::vector<double> from_s, from_t;
    const Weighting combined = &Face_dual_graph::Halfedge::combined;
    do_both<ConcurrencyTag>([&] { from_s = shortest_paths(m, samples.s, combined); },
                            [&] { from_t = shortest_paths(m, samples.t, combined); });
    return spectral_order(from_s, from_t);
  });

  // 6. line search
  monitor.check();
  std::optional<Cut> cut = monitor.stage(Stage::LINE_SEARCH, part.node, [&]
    { return line_search(m, line, part_salience, minimum_area); });

  monitor.end_part(part.node);
  return cut;
}

inline bool both_sides_are_connected(const Face_dual_graph& part, const Sides& side)
{
  std::vector<Face_dual_graph> sides = split(part, side, 2);
  for (const Face_dual_graph& s : sides) {
    std::size_t number_of_components;
    connected_components(s, number_of_components);
    if (number_of_components != 1)
      return false;
  }
  return true;
}

// The best cut of a part by a salience that is judged on whole cuts: of the candidates along
// several lines, and of the minimum cuts around the best of them.
template <class ConcurrencyTag, class PartSalience, class Monitor>
std::optional<Cut> best_judged_cut(const Part& part, double area_of_mesh, const Options& options,
                                   const PartSalience& part_salience, Monitor& monitor)
{
  const Face_dual_graph& m = part.graph;
  const double minimum_area = options.minimum_segment_size * area_of_mesh;
  if (m.number_of_faces() < 2 || total_area(m) < 2 * minimum_area)
    return std::nullopt;
  monitor.check();
  monitor.start_part(part.node, m.number_of_faces());

  Shape_contexts contexts;
  const Sample_faces samples = monitor.stage(Stage::SAMPLING, part.node, [&] {
    contexts = shape_contexts(part, options, monitor);
    return sample_faces(contexts);
  });

  monitor.check();
  const std::vector<Line> lines = monitor.stage(Stage::EMBEDDING, part.node, [&]
    { return orderings<ConcurrencyTag>(m, contexts.references, samples, options); });

  monitor.check();
  std::vector<Cut> cuts = monitor.stage(Stage::LINE_SEARCH, part.node, [&] {
    Cut_judge judge(m, area_of_mesh);
    std::vector<Cut> result;
    const auto add = [&](Sides side) {
      Cut cut{std::move(side), {0, 0}, {}, 0};
      for (Index f = 0; f < cut.side.size(); ++f)
        cut.area[int(cut.side[f])] += m.areas[f];
      put_smaller_side_first(cut.side, cut.area);
      if (cut.area[0] < minimum_area || !(cut.area[0] > 0))
        return;
      cut.factors = judge(cut.side);
      cut.salience = part_salience(cut.factors);
      result.push_back(std::move(cut));
    };
    for (Sides& side : cut_candidates<ConcurrencyTag>(m, lines, minimum_area,
                                                      options.number_of_candidates))
      add(std::move(side));
    const auto more_salient = [](const Cut& a, const Cut& b)
    { return on_grid(a.salience) > on_grid(b.salience); };
    std::stable_sort(result.begin(), result.end(), more_salient);
    const std::size_t number_refined =
      (std::min)(result.size(), options.number_of_refined_candidates);
    for (std::size_t i = 0; i < number_refined; ++i) {
      Sides refined = minimum_cut_around(m, result[i].side, result[i].area[0]);
      if (refined != result[i].side && both_sides_are_connected(m, refined))
        add(std::move(refined));
    }
    std::stable_sort(result.begin(), result.end(), more_salient);
    return result;
  });

  monitor.end_part(part.node);
  if (cuts.empty())
    return std::nullopt;
  return std::move(cuts.front());
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BEST_CUT_H
