// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RECURSION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RECURSION_H

#include <CGAL/Spectral_segmentation/Segment_tree.h>
#include <CGAL/Spectral_segmentation/internal/Cut.h>
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
template <class ConcurrencyTag, class Monitor>
class Recursion
{
  struct Candidate
  {
    Part part;
    bool is_searched = false;
    std::optional<Cut> cut;
  };

  const Options& options_;
  Monitor& monitor_;
  const Judged_mesh mesh_;

  Segment_tree tree_;
  Segment_tree::Queue queue_;
  std::unordered_map<std::size_t, Candidate> candidates_; // by node

  void add_candidate(std::size_t node, Face_dual_graph graph)
  {
    Candidate& c = candidates_[node];
    const auto faces = tree_.faces(node);
    c.part = Part{std::move(graph), node, {faces.begin(), faces.end()}};
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
      c.cut = best_cut<ConcurrencyTag>(c.part, mesh_, options_, monitor_);
      c.is_searched = true;
    });
  }

  void cut_largest()
  {
    const std::size_t node = *queue_.begin();
    queue_.erase(queue_.begin());
    Candidate candidate = std::move(candidates_[node]);
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
    if (tree_.number_of_segments() < options_.maximum_number_of_segments) {
      std::vector<Face_dual_graph> sides = split(std::move(candidate.part.graph), cut.side, 2);
      for (int i = 0; i < 2; ++i)
        add_candidate(tree_.node(node).children[i], std::move(sides[i]));
    }
    monitor_.part_cut(node, cut.factors, cut.salience, tree_.number_of_segments());
  }

public:
  // Each connected component is a root of the tree.
  Recursion(Face_dual_graph mesh, const Options& options, Monitor& monitor)
    : options_(options), monitor_(monitor), mesh_(judged_mesh(mesh, options)),
      queue_(tree_.empty_queue())
  {
    std::size_t number_of_components;
    const std::vector<Index> component = connected_components(mesh, number_of_components);
    tree_ = Segment_tree(component, component_areas(mesh, component, number_of_components),
                         mesh.unit, options);
    std::vector<Face_dual_graph> parts = split(std::move(mesh), component, number_of_components);
    for (std::size_t i = 0; i < parts.size(); ++i)
      add_candidate(i, std::move(parts[i]));
  }

  Recursion(const Recursion&) = delete; // the queue looks into the tree
  Recursion& operator=(const Recursion&) = delete;

  Segment_tree operator()()
  {
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
    queue_.clear();
    return std::move(tree_);
  }
};

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RECURSION_H
