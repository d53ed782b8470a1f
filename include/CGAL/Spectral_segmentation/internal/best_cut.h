// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BEST_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BEST_CUT_H

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/internal/Cut.h>
#include <CGAL/Spectral_segmentation/internal/Cut_judge.h>
#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/Meta_patch.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/cut_candidates.h>
#include <CGAL/Spectral_segmentation/internal/line_search.h>
#include <CGAL/Spectral_segmentation/internal/minimum_cut.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/internal/orderings.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>
#include <CGAL/Spectral_segmentation/internal/sampling.h>

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
  std::size_t node;         // in the segment tree
  std::vector<Index> faces; // their numbers in the mesh, ascending
};

template <class ConcurrencyTag, class Monitor>
Shape_contexts shape_contexts(const Part& part, const Options& options, Monitor& monitor)
{
  const Index first = options.random_seed
    ? random_face(part.graph, *options.random_seed, part.faces.front())
    : farthest_face_from_center<ConcurrencyTag>(part.graph);
  return shape_contexts<ConcurrencyTag>(part.graph, first, options.number_of_reference_faces,
                                        [&] { monitor.check(); });
}

inline bool both_sides_are_connected(const Face_dual_graph& part, const Sides& side)
{
  std::size_t number;
  connected_components(part, number, [&](Index f, Index g) { return side[f] == side[g]; });
  return number == 2;
}

// Judges whole cuts of a part: by all factors if the run takes candidates, else by those of the
// paper, which are known at every step of a line.
class Judge_of_part
{
  const Face_dual_graph& part_;
  const Part_salience& part_salience_;
  double minimum_area_;
  std::optional<Cut_judge> by_all_factors_;

  Salience_factors factors(const Sides& side) const
  {
    if (by_all_factors_)
      return (*by_all_factors_)(side);
    Meta_patch q(part_);
    for (Index f = 0; f < side.size(); ++f)
      if (side[f] == 0)
        q.add(f);
    return q.factors();
  }

public:
  Judge_of_part(const Part& part, const Judged_mesh& mesh, const Options& options)
    : part_(part.graph), part_salience_(options.part_salience),
      minimum_area_(options.minimum_segment_size * mesh.area)
  {
    if (options.number_of_candidates > 0)
      by_all_factors_.emplace(part.graph, part.faces, mesh);
  }

  double minimum_area() const { return minimum_area_; } // of a side

  // None if a side is too small.
  std::optional<Cut> operator()(Sides side) const
  {
    Cut cut{std::move(side), {0, 0}, {}, 0};
    for (Index f = 0; f < cut.side.size(); ++f)
      cut.area[int(cut.side[f])] += part_.areas[f];
    put_smaller_side_first(cut.side, cut.area);
    if (cut.area[0] < minimum_area_ || !(cut.area[0] > 0))
      return std::nullopt;
    cut.factors = factors(cut.side);
    cut.salience = part_salience_(cut.factors);
    return cut;
  }
};

inline void append(std::vector<std::optional<Cut> >& more, std::vector<Cut>& cuts)
{
  for (std::optional<Cut>& cut : more)
    if (cut)
      cuts.push_back(std::move(*cut));
}

// The candidates along the lines, or the best cut of each line.
template <class ConcurrencyTag>
std::vector<Cut> cuts_along(const Face_dual_graph& part, const std::vector<Line>& lines,
                            const Options& options, const Judge_of_part& judge)
{
  std::vector<std::optional<Cut> > cuts;
  if (options.number_of_candidates > 0) {
    std::vector<Sides> sides =
      cut_candidates<ConcurrencyTag>(part, lines, judge.minimum_area(),
                                     options.number_of_candidates);
    cuts.resize(sides.size());
    for_each_index<ConcurrencyTag>(sides.size(), [&](std::size_t i)
      { cuts[i] = judge(std::move(sides[i])); });
  }
  else {
    cuts.resize(lines.size());
    for_each_index<ConcurrencyTag>(lines.size(), [&](std::size_t i) {
      cuts[i] = line_search<ConcurrencyTag>(part, lines[i], options.part_salience,
                                            judge.minimum_area());
    });
  }
  std::vector<Cut> result;
  append(cuts, result);
  return result;
}

inline void put_most_salient_first(std::vector<Cut>& cuts)
{
  std::stable_sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b)
                   { return on_grid(a.salience) > on_grid(b.salience); });
}

// Adds the minimum cuts around the most salient of the cuts, and puts the most salient first.
template <class ConcurrencyTag>
void refine(const Face_dual_graph& part, std::size_t number, const Judge_of_part& judge,
            std::vector<Cut>& cuts)
{
  put_most_salient_first(cuts);
  std::vector<std::optional<Cut> > refined((std::min)(number, cuts.size()));
  for_each_index<ConcurrencyTag>(refined.size(), [&](std::size_t i) {
    Sides sides = minimum_cut_around(part, cuts[i].side, cuts[i].area[0]);
    if (sides != cuts[i].side && both_sides_are_connected(part, sides))
      refined[i] = judge(std::move(sides));
  });
  append(refined, cuts);
  put_most_salient_first(cuts);
}

// BESTCUT (Figure 2), with more lines and more than one cut of them if the options ask for it: the
// most salient cut of a part, if there is one. `observe(cut)` hears of each cut that is judged.
// Throws `Run_stopped` if the visitor stops the run.
template <class ConcurrencyTag, class Monitor, class Observer = No_observer>
std::optional<Cut> best_cut(const Part& part, const Judged_mesh& mesh, const Options& options,
                            Monitor& monitor, const Observer& observe = Observer())
{
  const Face_dual_graph& m = part.graph;
  if (m.number_of_faces() < 2 || total_area(m) < 2 * options.minimum_segment_size * mesh.area)
    return std::nullopt;
  monitor.check();
  monitor.start_part(part.node, m.number_of_faces());

  // 1. two sample faces
  Shape_contexts contexts;
  const Sample_faces samples = monitor.stage(Stage::SAMPLING, part.node, [&] {
    contexts = shape_contexts<ConcurrencyTag>(part, options, monitor);
    return sample_faces<ConcurrencyTag>(contexts);
  });

  // 2. distances from both; 3. to 5. the order of the faces on the line, for which neither kernel
  // nor eigenvectors are needed; and other lines
  monitor.check();
  const std::vector<Line> lines = monitor.stage(Stage::EMBEDDING, part.node, [&]
    { return orderings<ConcurrencyTag>(m, contexts.references, samples, options); });

  // 6. line search
  monitor.check();
  std::vector<Cut> cuts = monitor.stage(Stage::LINE_SEARCH, part.node, [&] {
    const Judge_of_part judge(part, mesh, options);
    std::vector<Cut> result = cuts_along<ConcurrencyTag>(m, lines, options, judge);
    refine<ConcurrencyTag>(m, options.number_of_refined_candidates, judge, result);
    return result;
  });

  monitor.end_part(part.node);
  for (const Cut& cut : cuts)
    observe(cut);
  if (cuts.empty())
    return std::nullopt;
  return std::move(cuts.front());
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BEST_CUT_H
