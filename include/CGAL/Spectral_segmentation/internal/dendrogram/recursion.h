// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_RECURSION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_RECURSION_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/bipartition/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/Dendrogram.h>
#include <CGAL/Spectral_segmentation/internal/surface/submesh.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Recursive two-way cuts of a mesh (Section 2). Each connected component is a part from the start.
class Recursion
{
  struct Pending_part
  {
    Part part;
    bool is_searched = false;
    std::optional<Cut> cut{};
  };

  // Of a part: minus its priority, then its number; the part of highest priority is the first.
  typedef std::pair<double, std::size_t> Key;

  const Execution execution_;
  const Options& options_;
  Run_monitor& monitor_;
  const Best_cut& best_cut_;

  Dendrogram result_;                 // its merges are the cuts, in their order, until the end
  std::vector<Pending_part> pending_; // of each number of a part; without faces if it is not pending
  std::vector<Index> leaf_;           // of each part, while it is not cut
  std::set<Key> queue_;               // of pending parts

  std::size_t number_of_segments() const { return result_.number_of_leaves(); }
  double area(std::size_t part) const { return result_.areas[leaf_[part]]; }

  void add(Surface surface, std::vector<Index> faces, Index leaf)
  {
    for (Index f : faces)
      result_.leaf[f] = leaf;
    pending_.push_back({Part{std::move(surface), pending_.size(), std::move(faces)}});
    leaf_.push_back(leaf);
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
    const std::size_t part = queue_.begin()->second;
    queue_.erase(queue_.begin());
    return std::exchange(pending_[part], Pending_part());
  }

  // Replaces a part, which has a cut, by its two sides, in the dendrogram and if they are to be cut
  // in turn among the pending parts.
  void cut(Pending_part pending, bool is_last)
  {
    const Cut& cut = *pending.cut;
    const std::size_t part = pending.part.number;
    const Index leaves[2] = {static_cast<Index>(number_of_segments()), leaf_[part]};
    result_.areas[leaves[1]] = cut.area[1];
    result_.areas.push_back(cut.area[0]);
    result_.merges.push_back({{leaves[0], leaves[1]}, cut.salience, cut.factors});
    std::vector<Index> faces[2];
    for (std::size_t i = 0; i < cut.side.size(); ++i)
      faces[int(cut.side[i])].push_back(pending.part.faces[i]);
    std::vector<Surface> sides(2);
    if (!is_last)
      sides = split(std::move(pending.part.surface), cut.side, 2);
    for (int i = 0; i < 2; ++i)
      add(std::move(sides[i]), std::move(faces[i]), leaves[i]);
    monitor_.part_cut(part, cut.factors, cut.salience, number_of_segments());
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
        queue_.insert({-quantized(p->cut->salience), p->part.number});
  }

  // Searches the largest part, and where threads can share the work the next ones with it: all that
  // will come to their turn, unless the maximum number of segments is reached before.
  void search_largest()
  {
    if (pending_[queue_.begin()->second].is_searched)
      return;
    const std::size_t most = execution_ == Execution::SEQUENTIAL
      ? 1 : options_.maximum() - number_of_segments();
    std::vector<Pending_part*> parts;
    for (auto key = queue_.begin(); key != queue_.end() && parts.size() < most; ++key)
      if (!pending_[key->second].is_searched)
        parts.push_back(&pending_[key->second]);
    search(parts);
  }

  void cut_largest()
  {
    Pending_part pending = take_first();
    const Index leaf = leaf_[pending.part.number];
    if (!pending.cut || pending.cut->salience < options_.threshold()) {
      result_.merges.push_back({{leaf, leaf}});
      Merge& decision = result_.merges.back();
      decision.state = pending.cut ? Cut_state::REJECTED : Cut_state::NO_CUT;
      if (pending.cut) {
        decision.salience = pending.cut->salience;
        decision.factors = pending.cut->factors;
      }
      return;
    }
    const std::size_t maximum = options_.maximum();
    const bool is_last = number_of_segments() + 1 >= maximum;
    cut(std::move(pending), is_last);
    if (!is_last)
      for (std::size_t child : {pending_.size() - 2, pending_.size() - 1})
        queue_.insert({-area(child), child});
    if (maximum != unlimited)
      monitor_.advance_to(static_cast<double>(number_of_segments()) /
                          static_cast<double>(maximum));
  }

  Dendrogram result()
  {
    std::reverse(result_.merges.begin(), result_.merges.end());
    return std::move(result_);
  }

public:
  Recursion(Execution execution, Surface mesh, const Best_cut& best_cut, const Options& options,
            Run_monitor& monitor)
    : execution_(execution), options_(options), monitor_(monitor), best_cut_(best_cut),
      result_(uncut_dendrogram(mesh))
  {
    const std::size_t number = number_of_segments();
    std::vector<std::vector<Index> > faces(number);
    for (Index f = 0; f < result_.leaf.size(); ++f)
      faces[result_.leaf[f]].push_back(f);
    std::vector<Surface> parts = split(std::move(mesh), result_.leaf, number);
    for (Index i = 0; i < number; ++i)
      add(std::move(parts[i]), std::move(faces[i]), i);
  }

  // The paper's: the largest part is cut next, until no part has a salient cut or the maximum
  // number of segments is reached.
  Dendrogram by_area()
  {
    try {
      for (std::size_t root = 0; root < pending_.size(); ++root)
        queue_.insert({-area(root), root});
      while (!queue_.empty() && number_of_segments() < options_.maximum()) {
        search_largest();
        cut_largest();
      }
    }
    catch (const Run_stopped&) {
      // The dendrogram holds the cuts that were made.
    }
    return result();
  }

  // An over-segmentation: the part with the most salient cut is cut next, until there are
  // `options.regions()` regions, and one more for each further component.
  Dendrogram by_salience()
  {
    const std::size_t number_of_regions = options_.regions();
    const std::size_t further = number_of_segments() == 0 ? 0 : number_of_segments() - 1;
    const auto has_enough = [&] {
      return number_of_segments() - further >= options_.number_of_regions &&
             number_of_segments() >= number_of_regions;
    };
    try {
      while (!has_enough()) {
        search_all();
        if (queue_.empty())
          break;
        cut(take_first(), false);
        monitor_.advance_to(static_cast<double>(number_of_segments() - further) /
                            static_cast<double>(number_of_regions));
      }
    }
    catch (const Run_stopped&) {
      // The regions are those of the cuts that were made.
    }
    return result();
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_RECURSION_H
