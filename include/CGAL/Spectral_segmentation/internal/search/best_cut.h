// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_BEST_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_BEST_CUT_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_data.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut_evaluator.h>
#include <CGAL/Spectral_segmentation/internal/search/cut_proposals.h>
#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/line_search.h>

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
  Surface graph;
  std::size_t number;       // by which visitors identify it
  std::vector<Index> faces; // their indices in the mesh, ascending
};

inline bool both_sides_are_connected(const Surface& part, const Sides& side)
{ return connected_components(part, side).number == 2; }

// Sorts cuts by salience. Equally salient cuts keep their order.
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

// Finds the most salient cut of a part of a mesh, if there is one (BESTCUT, Figure 2).
class Best_cut
{
  std::size_t number_of_faces_; // the faces of the mesh

  // Returns the orders along which cuts are searched.
  virtual std::vector<Face_order> orders(Execution execution, const Part& part,
                                         const Sample_faces& samples) const = 0;

  // Returns the cuts along some orders that are compared, the most salient first.
  virtual std::vector<Cut> cuts(Execution execution, const Part& part,
                                const std::vector<Face_order>& orders) const = 0;

protected:
  const Options& options_;
  double minimum_area_; // the least area of a side

  Best_cut(const Surface& mesh, const Options& options, double fraction_of_model)
    : number_of_faces_(mesh.number_of_faces()), options_(options),
      minimum_area_(options.minimum_segment_size * total_area(mesh) / fraction_of_model) {}

public:
  virtual ~Best_cut() = default;

  double minimum_area() const { return minimum_area_; }

  // Returns the cuts that are compared, the most salient first. Throws `Run_stopped` if the caller
  // stops the run.
  std::vector<Cut> compared_cuts(Execution execution, const Part& part, Run_monitor& monitor) const
  {
    const Surface& m = part.graph;
    if (m.number_of_faces() < 2 || total_area(m) < 2 * minimum_area_)
      return {};
    // A part is assumed to be half of its fraction of the search. Later parts add the rest.
    const double step = 0.5 * static_cast<double>(m.number_of_faces()) /
                        static_cast<double>(number_of_faces_) /
                        static_cast<double>(options_.number_of_reference_faces + 3) /
                        static_cast<double>(options_.number_of_searches);
    const auto check = [&] {
      monitor.check();
      monitor.approach(step);
    };
    check();
    monitor.before_part(part.number, m.number_of_faces());

    // 1. two sample faces
    const Sample_faces samples = monitor.stage(Stage::SAMPLING, part.number, [&] {
      const Index first = options_.random_seed
        ? random_face(m, *options_.random_seed, part.faces.front())
        : farthest_face_from_center(execution, m);
      return sample_faces(
        execution, shape_contexts(m, first, options_.number_of_reference_faces, check));
    });

    // 2. distances from both; 3. to 5. the order of the faces on the line
    check();
    const std::vector<Face_order> lines = monitor.stage(Stage::EMBEDDING, part.number, [&]
      { return orders(execution, part, samples); });

    // 6. line search
    check();
    std::vector<Cut> found = monitor.stage(Stage::LINE_SEARCH, part.number, [&]
      { return cuts(execution, part, lines); });

    monitor.after_part(part.number);
    return found;
  }

  std::optional<Cut> operator()(Execution execution, const Part& part, Run_monitor& monitor) const
  {
    std::vector<Cut> cuts = compared_cuts(execution, part, monitor);
    return cuts.empty() ? std::nullopt : std::make_optional(std::move(cuts.front()));
  }
};

// Takes the best cut along one order of the faces (Sections 4 and 5).
class Paper_cut : public Best_cut
{
  std::vector<Face_order> orders(Execution execution, const Part& part,
                                 const Sample_faces& samples) const override
  { return {face_order(execution, part.graph, samples)}; }

  std::vector<Cut> cuts(Execution execution, const Part& part,
                        const std::vector<Face_order>& orders) const override
  {
    std::optional<Cut> cut = line_search(execution, part.graph, orders.front(),
                                         options_.part_salience, minimum_area_);
    return cut ? std::vector<Cut>{std::move(*cut)} : std::vector<Cut>();
  }

public:
  Paper_cut(const Surface& mesh, const Options& options) : Best_cut(mesh, options, 1) {}
};

// Proposes cuts along several orders, evaluates them by all factors, and moves the best to the
// minimum cuts near them.
class Calibrated_cut : public Best_cut
{
  const Method_constants constants_;
  Evaluation_context context_;

  // Returns the spectral order from both ends, and the order of the features, if there are any.
  std::vector<Face_order> orders(Execution execution, const Part& part,
                                 const Sample_faces& samples) const override
  {
    const auto [from_s, from_t] = distances_from_samples(execution, part.graph, samples);
    std::vector<Face_order> result = {spectral_order(from_s, from_t),
                                      spectral_order(from_t, from_s)};
    if (!context_.features.empty())
      result.push_back(feature_order(context_.features, part.graph.areas, part.faces));
    return result;
  }

  // Returns the cut with its factors; none if a side is too small.
  std::optional<Cut> evaluate(const Surface& part, const Cut_evaluator& evaluator,
                              Sides side) const
  {
    Cut cut{std::move(side), {0, 0}, {}, 0};
    for (Index f = 0; f < cut.side.size(); ++f)
      cut.area[int(cut.side[f])] += part.areas[f];
    normalize_sides(cut.side, cut.area);
    if (cut.area[0] < minimum_area_ || !(cut.area[0] > 0))
      return std::nullopt;
    cut.factors = evaluator(cut.side, false, &cut.near_cut);
    cut.salience = salience_of(options_.part_salience, cut.factors);
    return cut;
  }

  // Appends f(i) for each i < n, if it is a cut.
  template <class Function>
  static void append(Execution execution, std::size_t n, const Function& f, std::vector<Cut>& cuts)
  {
    std::vector<std::optional<Cut> > more(n);
    for_each_index(execution, n, [&](std::size_t i) { more[i] = f(i); });
    for (std::optional<Cut>& cut : more)
      if (cut)
        cuts.push_back(std::move(*cut));
  }

  std::vector<Cut> cuts(Execution execution, const Part& part,
                        const std::vector<Face_order>& orders) const override
  {
    const Surface& graph = part.graph;
    const Cut_evaluator evaluator(graph, part.faces, context_);
    std::vector<Sides> proposals = cut_proposals(execution, graph, orders, minimum_area_);
    std::vector<Cut> cuts;
    append(execution, proposals.size(), [&](std::size_t i)
      { return evaluate(graph, evaluator, std::move(proposals[i])); }, cuts);
    cuts = most_salient_first(std::move(cuts));
    std::vector<Cut> refined;
    append(execution, (std::min)(constants_.number_of_refined_candidates, cuts.size()),
           [&](std::size_t i) -> std::optional<Cut> {
             Sides sides = minimum_cut_within(graph, cuts[i].near_cut, cuts[i].side);
             if (sides == cuts[i].side || !both_sides_are_connected(graph, sides))
               return std::nullopt;
             return evaluate(graph, evaluator, std::move(sides));
           }, refined);
    std::move(refined.begin(), refined.end(), std::back_inserter(cuts));
    return most_salient_first(std::move(cuts));
  }

public:
  // Takes the features of the faces of the mesh. The mesh may be a fraction of the area of a model,
  // to which the areas of parts are relative.
  Calibrated_cut(const Surface& mesh, const Options& options,
                 const Method_constants& constants = Method_constants(),
                 Face_features features = Face_features(), double fraction_of_model = 1)
    : Best_cut(mesh, options, fraction_of_model), constants_(constants),
      context_(mesh, std::move(features), options.feature_weight)
  { context_.area_of_model /= fraction_of_model; }

  const Evaluation_context& context() const { return context_; }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_BEST_CUT_H
