// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RECURSION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RECURSION_H

#include <CGAL/Spectral_segmentation/Segment_tree.h>
#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/Monitor.h>
#include <CGAL/Spectral_segmentation/internal/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/line_search.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The recursive two-way cut of Section 2: a queue of parts by area, the largest of which is cut
// until no part has a salient cut or the maximum number of segments is reached.
template <class ConcurrencyTag, class PartSalience, class Monitor>
class Recursion
{
  struct Candidate
  {
    Part part;
    bool is_searched = false;
    std::optional<Cut> cut;
  };

  const Options& options_;
  const PartSalience& part_salience_;
  Monitor& monitor_;
  Segment_tree& tree_;
  double minimum_area_;

  Segment_tree::Queue queue_;
  std::unordered_map<std::size_t, Candidate> candidates_; // by node

  void add_candidate(std::size_t node, Face_dual_graph graph)
  {
    Candidate& c = candidates_[node];
    c.part = Part{std::move(graph), node, tree_.smallest_face(node)};
    queue_.insert(node);
  }

  // Searches the largest part, and where threads can share the work the next ones with it: all that
  // will come to their turn, unless the maximum number of segments is reached before.
  void search_ahead()
  {
    if (candidates_[*queue_.begin()].is_searched)
      return;
    std::size_t most = options_.maximum_number_of_segments - tree_.number_of_segments();
    if (!is_parallel<ConcurrencyTag>)
      most = 1;
    std::vector<Candidate*> batch;
    for (auto node = queue_.begin(); node != queue_.end() && batch.size() < most; ++node)
      if (!candidates_[*node].is_searched)
        batch.push_back(&candidates_[*node]);
    for_each_index<ConcurrencyTag>(batch.size(), [&](std::size_t i) {
      Candidate& c = *batch[i];
      c.cut = best_cut<ConcurrencyTag>(c.part, options_, part_salience_, minimum_area_, monitor_);
      c.is_searched = true;
    });
  }

  void cut_largest()
  {
    const std::size_t node = *queue_.begin();
    queue_.erase(queue_.begin());
    const Candidate candidate = std::move(candidates_[node]);
    candidates_.erase(node);
    if (!candidate.cut) {
      tree_.set_cut(node, Segment_tree::Cut_state::NO_CUT, 0, Salience_factors());
      return;
    }
    const Cut& cut = *candidate.cut;
    if (cut.salience < options_.salience_threshold) {
      tree_.set_cut(node, Segment_tree::Cut_state::REJECTED, cut.salience, cut.factors);
      return;
    }
    tree_.set_cut(node, Segment_tree::Cut_state::ACCEPTED, cut.salience, cut.factors);
    tree_.cut(node, cut.side, cut.area);
    std::vector<Face_dual_graph> sides = split(candidate.part.graph, cut.side, 2);
    for (int i = 0; i < 2; ++i)
      add_candidate(tree_.node(node).children[i], std::move(sides[i]));
    monitor_.part_cut(node, cut.factors, cut.salience, tree_.number_of_segments());
  }

public:
  Recursion(const Options& options, const PartSalience& part_salience, Monitor& monitor,
            Segment_tree& tree, double minimum_area)
    : options_(options), part_salience_(part_salience), monitor_(monitor), tree_(tree),
      minimum_area_(minimum_area), queue_(tree.empty_queue())
  {}

  // `components` are the parts of the roots of the tree.
  void operator()(std::vector<Face_dual_graph> components)
  {
    for (std::size_t i = 0; i < components.size(); ++i)
      add_candidate(i, std::move(components[i]));
    try {
      while (!queue_.empty() &&
             tree_.number_of_segments() < options_.maximum_number_of_segments) {
        search_ahead();
        cut_largest();
      }
    }
    catch (const Run_stopped&) {
      // The tree holds the cuts that were made.
    }
  }
};

// All cuts of a mesh; each connected component is a root of the tree. A run that its visitor stops
// returns the cuts made so far.
template <class ConcurrencyTag, class PartSalience, class Monitor>
Segment_tree cut_recursively(Face_dual_graph mesh, const Options& options,
                             const PartSalience& part_salience, Monitor& monitor)
{
  std::size_t number_of_components;
  const std::vector<Index> component = connected_components(mesh, number_of_components);
  std::vector<double> areas(number_of_components, 0);
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    areas[component[f]] += mesh.areas[f];
  Segment_tree tree(component, areas, mesh.unit * mesh.unit, options);
  if (options.boundary_smoothing)
    tree.smooth_boundaries_with(neighbors(mesh));

  const double minimum_area = options.minimum_segment_size * total_area(mesh);
  std::vector<Face_dual_graph> components;
  if (number_of_components == 1)
    components.push_back(std::move(mesh));
  else
    components = split(mesh, component, number_of_components);
  Recursion<ConcurrencyTag, PartSalience, Monitor>(
    options, part_salience, monitor, tree, minimum_area)(std::move(components));
  return tree;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RECURSION_H
