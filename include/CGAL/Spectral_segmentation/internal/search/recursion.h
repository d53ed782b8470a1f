// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_RECURSION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_RECURSION_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>
#include <CGAL/Spectral_segmentation/internal/search/best_cut.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the number of regions of the over-segmentation of a connected mesh, given the least
// number. An exact number beyond ten times as many is reached by cuts without a search.
inline std::size_t number_of_regions(const Options& o, std::size_t least)
{
  if (maximum_number(o) == unlimited)
    return least;
  const std::size_t most = o.number_of_segments ? 10 * least : unlimited;
  return (std::max)(least, (std::min)(maximum_number(o), most));
}

// Cuts a mesh recursively in two (Section 2). Each connected component is a part from the start.
class Recursion
{
  struct Pending_part
  {
    Part part;
    Index leaf = null_index;
    bool is_searched = false;
    std::optional<Cut> cut;
  };

  // Minus the priority of a part, then its node. The part of highest priority is the first.
  typedef std::pair<double, std::size_t> Key;

  const Execution execution_;
  const Options& options_;
  Run_monitor& monitor_;
  const Best_cut& best_cut_;

  const std::size_t search_;          // of the `number_of_searches` of a run
  const std::size_t number_of_roots_;
  std::size_t maximum_ = 0;           // number of segments of the recursion by area
  Merge_tree tree_;                   // its merges are in the order of the cuts
  std::vector<Pending_part> pending_; // one per node; without faces if the node is not pending
  std::set<Key> queue_;               // the pending parts

  // Returns the maximum number of segments of the recursion by area.
  std::size_t maximum_number_by_area(double number_of_components) const
  {
    if (!has_default_end(options_))
      return maximum_number(options_);
    const double cuts =
      std::round(quantized(number_of_components) * (default_number_of_parts - 1.));
    return number_of_roots_ + static_cast<std::size_t>(cuts);
  }

  std::size_t node_of(const Pending_part& pending) const
  { return static_cast<std::size_t>(&pending - pending_.data()); }

  std::size_t number_of_segments() const { return tree_.leaves.size(); }

  void add(Index leaf, Surface graph, std::vector<Index> faces)
  {
    for (Index f : faces)
      tree_.leaf[f] = leaf;
    const std::size_t number = pending_.size() * options_.number_of_searches + search_;
    pending_.push_back({Part{std::move(graph), number, std::move(faces)}, leaf, false, {}});
  }

  void search(const std::vector<Pending_part*>& parts)
  {
    for_each_index(execution_, parts.size(), [&](std::size_t i) {
      Pending_part& p = *parts[i];
      p.cut = best_cut_(execution_, p.part, monitor_);
      p.is_searched = true;
    });
  }

  Pending_part take_first()
  {
    const std::size_t node = queue_.begin()->second;
    queue_.erase(queue_.begin());
    return std::exchange(pending_[node], Pending_part());
  }

  // Replaces a part that has a cut by its two sides: in the tree, where the larger side keeps the
  // leaf, and among the pending parts, with their surfaces unless this is the last cut.
  void cut(Pending_part pending, bool is_last)
  {
    const Cut& cut = *pending.cut;
    const Index leaves[2] = {static_cast<Index>(tree_.leaves.size()), pending.leaf};
    tree_.leaves.push_back({0, Cut_state::NOT_SEARCHED});
    tree_.merges.push_back({{leaves[0], leaves[1]}, cut.salience, cut.factors});
    std::vector<Index> faces[2];
    for (std::size_t i = 0; i < cut.side.size(); ++i)
      faces[int(cut.side[i])].push_back(pending.part.faces[i]);
    std::vector<Surface> sides(2);
    if (!is_last)
      sides = split(std::move(pending.part.graph), cut.side, 2);
    for (int i = 0; i < 2; ++i) {
      tree_.leaves[leaves[i]].area = cut.area[i];
      add(leaves[i], std::move(sides[i]), std::move(faces[i]));
    }
    monitor_.after_cut(pending.part.number, cut.factors, cut.salience, number_of_segments());
  }

  void search_all()
  {
    std::vector<Pending_part*> parts;
    for (Pending_part& pending : pending_)
      if (!pending.part.faces.empty() && !pending.is_searched)
        parts.push_back(&pending);
    search(parts);
    for (const Pending_part* p : parts)
      if (p->cut)
        queue_.insert({-quantized(p->cut->salience), node_of(*p)});
  }

  void enqueue_by_area(const Pending_part& pending)
  { queue_.insert({-tree_.leaves[pending.leaf].area, node_of(pending)}); }

  // Searches the largest part and, if threads work in parallel, the next parts. All of these will
  // be needed, unless the maximum number of segments is reached before.
  void search_largest()
  {
    if (pending_[queue_.begin()->second].is_searched)
      return;
    const std::size_t most = execution_ == Execution::SEQUENTIAL
      ? 1 : maximum_ - number_of_segments();
    std::vector<Pending_part*> parts;
    for (auto key = queue_.begin(); key != queue_.end() && parts.size() < most; ++key)
      if (!pending_[key->second].is_searched)
        parts.push_back(&pending_[key->second]);
    search(parts);
  }

  void cut_largest()
  {
    Pending_part pending = take_first();
    if (!pending.cut || pending.cut->salience < threshold_of(options_)) {
      Leaf& leaf = tree_.leaves[pending.leaf];
      leaf.cut_state = pending.cut ? Cut_state::REJECTED : Cut_state::NO_CUT;
      leaf.number_of_earlier_cuts = tree_.merges.size();
      if (pending.cut) {
        leaf.salience = pending.cut->salience;
        leaf.factors = pending.cut->factors;
      }
      return;
    }
    const bool is_last = number_of_segments() + 1 >= maximum_;
    cut(std::move(pending), is_last);
    if (!is_last)
      for (std::size_t child = pending_.size() - 2; child < pending_.size(); ++child)
        enqueue_by_area(pending_[child]);
    if (maximum_ != unlimited)
      monitor_.advance_to(static_cast<double>(number_of_segments()) /
                          static_cast<double>(maximum_));
  }

  Merge_tree result()
  {
    std::reverse(tree_.merges.begin(), tree_.merges.end());
    return std::move(tree_);
  }

public:
  Recursion(Execution execution, Surface mesh, const Best_cut& best_cut, const Options& options,
            Run_monitor& monitor, std::size_t search = 0)
    : execution_(execution), options_(options), monitor_(monitor), best_cut_(best_cut),
      search_(search), number_of_roots_(mesh.components.number),
      tree_(uncut_tree(mesh, Cut_state::NOT_SEARCHED))
  {
    const std::vector<Index> component = tree_.leaf;
    std::vector<std::vector<Index> > faces(number_of_roots_);
    for (Index f = 0; f < component.size(); ++f)
      faces[component[f]].push_back(f);
    std::vector<Surface> graphs = split(std::move(mesh), component, number_of_roots_);
    for (Index i = 0; i < number_of_roots_; ++i)
      add(i, std::move(graphs[i]), std::move(faces[i]));
  }

  // Cuts in the order of the paper, the largest part next, until no part has a salient cut or the
  // maximum number of segments is reached, which may depend on the effective number of components.
  Merge_tree by_area(double number_of_components)
  {
    maximum_ = maximum_number_by_area(number_of_components);
    try {
      for (const Pending_part& root : pending_)
        enqueue_by_area(root);
      while (!queue_.empty() && number_of_segments() < maximum_) {
        search_largest();
        cut_largest();
      }
    }
    catch (const Run_stopped&) {
      // The tree has the cuts that were made.
    }
    return result();
  }

  // Makes an over-segmentation. It cuts the part with the most salient cut next, until there are
  // `number_of_regions()` regions, and at least `least` plus one for each further component.
  Merge_tree by_salience(std::size_t least)
  {
    const std::size_t number = number_of_regions(options_, least);
    const std::size_t further = number_of_roots_ == 0 ? 0 : number_of_roots_ - 1;
    const auto has_enough = [&] {
      const std::size_t regions = number_of_segments();
      return regions - further >= least && regions >= number;
    };
    try {
      while (!has_enough()) {
        search_all();
        if (queue_.empty())
          break;
        cut(take_first(), false);
      }
    }
    catch (const Run_stopped&) {
      // The regions result from the cuts that were made.
    }
    return result();
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_RECURSION_H
