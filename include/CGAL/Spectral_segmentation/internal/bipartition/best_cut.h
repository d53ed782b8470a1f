// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_BEST_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_BEST_CUT_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/internal/bipartition/cut_proposals.h>
#include <CGAL/Spectral_segmentation/internal/bipartition/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/bipartition/line_search.h>
#include <CGAL/Spectral_segmentation/internal/bipartition/min_cut_refinement.h>
#include <CGAL/Spectral_segmentation/internal/bipartition/shape_context_sampling.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut_evaluator.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/base/arrays.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A connected part of the mesh that may be cut.
struct Part
{
  Surface surface;
  std::size_t number;       // by the order in which parts are found
  std::vector<Index> faces; // their numbers in the mesh, ascending
};

// Of equally salient cuts the first stays the first.
inline std::vector<Cut> most_salient_first(std::vector<Cut> cuts)
{
  std::vector<double> keys;
  for (const Cut& cut : cuts)
    keys.push_back(-quantized(cut.salience));
  std::vector<Cut> result;
  for (Index i : sorted_indices(keys))
    result.push_back(std::move(cuts[i]));
  return result;
}

// BESTCUT (Figure 2): finds the most salient cut of a part of a mesh, if there is one. In the
// paper's method that is the best cut along one order of the faces. In the calibrated method cuts
// are proposed along several orders, evaluated by all factors, and the best are moved to the
// minimum cuts near them.
class Best_cut
{
  const Options& options_;
  std::optional<Evaluation_context> context_;
  std::size_t number_of_faces_; // of the mesh
  double minimum_area_;         // of a side

  // Along which cuts are searched.
  std::vector<Face_order> orders(Execution execution, const Surface& part,
                                 const std::vector<Index>& references,
                                 const Sample_faces& samples) const
  {
    if (options_.method == Method::ZHANG_LIU_2005)
      return {face_order(execution, part, samples)};
    return face_orders(execution, part, references, samples, options_.single_source_orders);
  }

  // None if a side is too small.
  std::optional<Cut> evaluated(const Surface& part, const Cut_evaluator& evaluator,
                               Sides side) const
  {
    Cut cut{std::move(side), {0, 0}, {}, 0, {}};
    for (Index f = 0; f < cut.side.size(); ++f)
      cut.area[int(cut.side[f])] += part.areas[f];
    normalize_sides(cut.side, cut.area);
    if (cut.area[0] < minimum_area_ || !(cut.area[0] > 0))
      return std::nullopt;
    cut.factors = evaluator(cut.side, cut.near);
    cut.salience = salience_of(options_.part_salience, cut.factors);
    return cut;
  }

  // f(i) for each i < n, without those that are no cut.
  template <class Function>
  static void append(Execution execution, std::size_t n, const Function& f, std::vector<Cut>& cuts)
  {
    std::vector<std::optional<Cut> > more(n);
    for_each_index(execution, n, [&](std::size_t i) { more[i] = f(i); });
    for (std::optional<Cut>& cut : more)
      if (cut)
        cuts.push_back(std::move(*cut));
  }

  // The most salient first.
  std::vector<Cut> calibrated_cuts(Execution execution, const Part& part,
                                   const std::vector<Face_order>& orders) const
  {
    const Surface& surface = part.surface;
    const Cut_evaluator evaluator(surface, part.faces, *context_);
    std::vector<Sides> proposals = cut_proposals(execution, surface, orders, minimum_area_,
                                                 options_.number_of_candidates);
    std::vector<Cut> cuts;
    append(execution, proposals.size(), [&](std::size_t i)
      { return evaluated(surface, evaluator, std::move(proposals[i])); }, cuts);
    cuts = most_salient_first(std::move(cuts));
    std::vector<Cut> refined;
    append(execution, (std::min)(options_.number_of_refined_candidates, cuts.size()),
           [&](std::size_t i) -> std::optional<Cut> {
             Sides sides = minimum_cut_within(surface, cuts[i].near, cuts[i].side);
             if (sides == cuts[i].side || !are_both_connected(surface, sides))
               return std::nullopt;
             return evaluated(surface, evaluator, std::move(sides));
           }, refined);
    std::move(refined.begin(), refined.end(), std::back_inserter(cuts));
    return most_salient_first(std::move(cuts));
  }

  std::vector<Cut> cuts(Execution execution, const Part& part,
                        const std::vector<Face_order>& orders) const
  {
    if (options_.method == Method::CALIBRATED)
      return calibrated_cuts(execution, part, orders);
    std::vector<Cut> result;
    append(execution, 1, [&](std::size_t)
      { return line_search(execution, part.surface, orders.front(), options_.part_salience,
                           minimum_area_); }, result);
    return result;
  }

public:
  Best_cut(Execution execution, const Surface& mesh, const Options& options)
    : options_(options), number_of_faces_(mesh.number_of_faces()),
      minimum_area_(options.minimum_segment_size * total_area(mesh))
  {
    if (options.method == Method::CALIBRATED)
      context_.emplace(execution, mesh);
  }

  // Only the calibrated method has one.
  const Evaluation_context& context() const { return *context_; }

  // Throws `Run_stopped` if the caller stops the run.
  std::optional<Cut> operator()(Execution execution, const Part& part, Run_monitor& monitor) const
  {
    const Surface& m = part.surface;
    if (m.number_of_faces() < 2 || total_area(m) < 2 * minimum_area_)
      return std::nullopt;
    // A part is a guessed half of its share of the search, to which later parts add.
    const double step = 0.5 * static_cast<double>(m.number_of_faces()) /
                        static_cast<double>(number_of_faces_) /
                        static_cast<double>(2 * options_.number_of_reference_faces + 1);
    const auto check = [&] {
      monitor.check();
      monitor.approach(step);
    };
    check();
    monitor.start_part(part.number, m.number_of_faces());

    // 1. two sample faces
    Shape_contexts contexts;
    const Sample_faces samples = monitor.stage(Stage::SAMPLING, part.number, [&] {
      const Index first = options_.random_seed
        ? random_face(m, *options_.random_seed, part.faces.front())
        : farthest_face_from_center(execution, m);
      contexts = shape_contexts(execution, m, first, options_.number_of_reference_faces, check);
      return sample_faces(execution, contexts);
    });

    // 2. distances from both; 3. to 5. the order of the faces on the line
    check();
    const std::vector<Face_order> lines = monitor.stage(Stage::EMBEDDING, part.number, [&]
      { return orders(execution, m, contexts.references, samples); });

    // 6. line search
    check();
    std::vector<Cut> found = monitor.stage(Stage::LINE_SEARCH, part.number, [&]
      { return cuts(execution, part, lines); });

    monitor.end_part(part.number);
    for (const Cut& cut : found)
      monitor.cut_evaluated({Evaluated_cut::CANDIDATE, part.faces, cut.side,
                                       cut.factors});
    if (found.empty())
      return std::nullopt;
    return std::move(found.front());
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_BEST_CUT_H
