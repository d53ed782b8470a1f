// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CUT_TRANSFER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CUT_TRANSFER_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/bipartition/min_cut_refinement.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/distances/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/levels/Cells.h>
#include <CGAL/Spectral_segmentation/internal/levels/Level.h>
#include <CGAL/Spectral_segmentation/internal/surface/submesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Brings the cuts of a level back to the surface from which it was made, one by one from the root: a
// cell goes to the side in which it has the larger share.
//
// If the level has the same shape, cells with shares in both sides are a band around the cut, which
// is split by a minimum cut, and all but the largest piece of a side goes to the other side. If not,
// a piece that a side has of a component goes to the other side if it is small: a boundary is
// expected where a component ends.
class Cut_transfer
{
  enum Side : char { Q, REST, UNDECIDED, NOT_IN_PART };

  struct Leaf_share
  {
    Index leaf; // its place
    double share;
  };

  static constexpr Index several = null_index - 1;

  const Execution execution_;
  const Level& level_;
  const Surface& mesh_; // the finer surface
  const Distance_weights& weights_;
  Run_monitor& monitor_;

  Cut_hierarchy tree_;   // whose elements are the leaves of the dendrogram
  Nested_ranges leaves_; // of each node
  std::vector<Index> place_; // of each leaf, in the order in which those of each node follow each
                             // other
  std::function<Shares(Index)> shares_of_face_;
  std::vector<Index> only_leaf_; // of each face: the place of its leaf, or `several`
  Cells cells_;
  std::vector<Leaf_share> shares_;       // of the cells of the bands, one after the other
  std::vector<std::size_t> first_share_; // of each of these cells, and the end
  Surface bands_;

  std::vector<Index> elements_; // the cells, those of each node side by side
  std::vector<std::array<std::size_t, 2> > range_; // of each node, in these
  Sides side_, larger_side_;    // of each cell, by the cut at hand
  std::vector<Index> reached_;  // cells, by the floods of a cut
  std::vector<char> is_reached_;

  static Cut_hierarchy tree(Dendrogram d)
  {
    d.leaf.resize(d.number_of_leaves());
    std::iota(d.leaf.begin(), d.leaf.end(), Index(0));
    return cut_hierarchy(d);
  }

  std::vector<Index> places_of_leaves() const
  {
    std::vector<Index> result(tree_.leaf.size());
    Index next = 0;
    for (std::size_t root = 0; root < tree_.number_of_roots; ++root)
      for (Index leaf : leaves_[root])
        result[leaf] = next++;
    return result;
  }

  std::function<Shares(Index)> shares_of_faces(const Dendrogram& d) const
  {
    std::vector<Index> place_of_face;
    for (Index leaf : d.leaf)
      place_of_face.push_back(place_[leaf]);
    return level_.shares(place_of_face);
  }

  std::vector<Index> only_leaves() const
  {
    std::vector<Index> result(mesh_.number_of_faces());
    for_each_index(execution_, result.size(), [&](std::size_t f) {
      const Shares of_face = shares_of_face_(static_cast<Index>(f));
      result[f] = of_face.size() == 1 ? of_face.begin()->leaf : several;
    });
    return result;
  }

  // Whether a face may be between the sides of a cut, or a cut may run along one of its edges. All
  // may if there might be more cuts: a cut must not depend on those after it.
  std::vector<char> are_between() const
  {
    std::vector<char> result(mesh_.number_of_faces(), 1);
    if (tree_.is_ultrametric)
      for_each_index(execution_, result.size(), [&](std::size_t f) {
        const Index leaf = only_leaf_[f];
        result[f] = leaf == several;
        for (Index h = static_cast<Index>(3 * f); h < 3 * f + 3; ++h) {
          const Index other = only_leaf_[mesh_.neighbor(h)];
          result[f] = result[f] || (other != leaf && other != several);
        }
      });
    return result;
  }

  void set_shares()
  {
    const auto shares = [this](std::size_t cell)
    { return shares_of_face_(cells_.first_face(static_cast<Index>(cell))); };
    const std::size_t n = cells_.number_in_bands();
    first_share_.resize(n + 1, 0);
    for_each_index(execution_, n, [&](std::size_t cell)
      { first_share_[cell + 1] = shares(cell).size(); });
    std::partial_sum(first_share_.begin(), first_share_.end(), first_share_.begin());
    shares_.resize(first_share_.back());
    for_each_index(execution_, n, [&](std::size_t cell) {
      std::size_t i = first_share_[cell];
      for (const auto& [leaf, share] : shares(cell))
        shares_[i++] = {leaf, share};
    });
  }

  void set_bands()
  {
    std::vector<Index> faces;
    for (Index cell = 0; cell < cells_.number_in_bands(); ++cell)
      faces.push_back(cells_.first_face(cell));
    bands_ = Submesh_extractor(mesh_)(faces);
    Distance_weights weights = weights_;
    const double area = total_area(bands_); // to which the radius is relative
    weights.concavity_radius *= area > 0 ? std::sqrt(total_area(mesh_) / area) : 0;
    set_face_distances(execution_, bands_, bands_.points,
                       face_normals(execution_, bands_, bands_.points), weights);
  }

  bool is_below(Index leaf, std::size_t node) const
  { return leaf - leaves_.first(node) < leaves_.size(node); } // also if it wraps around

  double share(Index cell, std::size_t node) const
  {
    if (cells_.is_core(cell))
      return is_below(only_leaf_[cells_.first_face(cell)], node) ? 1 : 0;
    double result = 0;
    for (std::size_t i = first_share_[cell]; i < first_share_[cell + 1]; ++i)
      if (is_below(shares_[i].leaf, node))
        result += shares_[i].share;
    return result;
  }

  // Puts the cells into the roots of their components; or if the level has others, into those of
  // which they have most.
  void set_roots(const Dendrogram& d)
  {
    std::vector<Index> root_of_place, root_of_component(level_.surface().components.number);
    for (std::size_t root = 0; root < tree_.number_of_roots; ++root)
      root_of_place.insert(root_of_place.end(), leaves_.size(root), static_cast<Index>(root));
    for (std::size_t f = 0; f < d.leaf.size(); ++f)
      root_of_component[level_.surface().components[f]] = root_of_place[place_[d.leaf[f]]];
    const auto root_of = [&](Index cell) {
      if (level_.has_same_shape())
        return root_of_component[mesh_.components[cells_.first_face(cell)]];
      if (cells_.is_core(cell))
        return root_of_place[only_leaf_[cells_.first_face(cell)]];
      const auto begin = shares_.begin();
      return root_of_place[
        std::max_element(begin + static_cast<std::ptrdiff_t>(first_share_[cell]),
                         begin + static_cast<std::ptrdiff_t>(first_share_[cell + 1]),
                         [](const Leaf_share& a, const Leaf_share& b)
                         { return a.share < b.share; })->leaf];
    };
    const Rows cells(tree_.number_of_roots, cells_.number(), root_of);
    for (Index root = 0; root < cells.number(); ++root) {
      range_[root] = {elements_.size(), elements_.size() + cells[root].size()};
      elements_.insert(elements_.end(), cells[root].begin(), cells[root].end());
    }
  }

  // Gives each cell of a part a side, as far as it is decided. Returns whether some are on either.
  bool set_sides_by_shares(std::size_t node, const std::vector<Index>& part)
  {
    bool is_decided[2] = {false, false};
    for (Index cell : part) {
      const double q = share(cell, tree_.nodes[node].children[0]);
      const double rest = share(cell, tree_.nodes[node].children[1]);
      larger_side_[cell] = rest > q ? REST : Q;
      const bool has_both = level_.has_same_shape() && q > 0 && rest > 0;
      side_[cell] = has_both ? static_cast<char>(UNDECIDED) : larger_side_[cell];
      if (!has_both)
        is_decided[int(side_[cell])] = true;
    }
    return is_decided[0] && is_decided[1];
  }

  // Splits what is undecided by the minimum cut.
  void divide_band(const std::vector<Index>& part)
  {
    Sides side(side_.begin(), side_.begin() + cells_.number_in_bands());
    std::vector<Index> band;
    for (Index cell : part)
      if (side_[cell] == UNDECIDED) {
        CGAL_assertion(!cells_.is_core(cell));
        side[cell] = Q;
        band.push_back(cell);
      }
    side = minimum_cut_within(bands_, band, side);
    for (Index cell : band)
      side_[cell] = side[cell];
  }

  // Adds the cells that are connected with one, and of which f(cell) is true, to those that were
  // reached, and returns their area.
  template <class Function>
  double flood(Index first, const Function& f)
  {
    std::size_t next = reached_.size();
    reached_.push_back(first);
    is_reached_[first] = 1;
    double area = 0;
    for (; next < reached_.size(); ++next) {
      area += cells_.area(reached_[next]);
      cells_.for_each_neighbor(reached_[next], [&](Index cell) {
        if (!is_reached_[cell] && side_[cell] != NOT_IN_PART && f(cell)) {
          is_reached_[cell] = 1;
          reached_.push_back(cell);
        }
      });
    }
    return area;
  }

  void forget_floods()
  {
    for (Index cell : reached_)
      is_reached_[cell] = 0;
    reached_.clear();
  }

  // What is connected on one side among some cells, with its place in `reached_`.
  struct Piece
  {
    std::size_t begin, end;
    double area;
    char side;
  };

  template <class Cell_range>
  std::vector<Piece> pieces(const Cell_range& cells)
  {
    std::vector<Piece> result;
    for (Index seed : cells)
      if (!is_reached_[seed]) {
        const std::size_t begin = reached_.size();
        const double area = flood(seed, [&](Index cell) { return side_[cell] == side_[seed]; });
        result.push_back({begin, reached_.size(), area, side_[seed]});
      }
    return result;
  }

  void turn(const Piece& piece)
  {
    for (std::size_t i = piece.begin; i < piece.end; ++i)
      side_[reached_[i]] = piece.side == Q ? REST : Q;
  }

  // Of a side of a connected part all but the largest piece goes to the other side.
  void keep_largest(const std::vector<Index>& part, Side side)
  {
    std::vector<Piece> all = pieces(part);
    all.erase(std::remove_if(all.begin(), all.end(),
                             [side](const Piece& p) { return p.side != side; }), all.end());
    const auto largest = std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b)
                                          { return a.area < b.area; });
    for (auto piece = all.begin(); piece != all.end(); ++piece)
      if (piece != largest)
        turn(*piece);
    forget_floods();
  }

  // A side without cells gets one, without which the part is still connected.
  void keep_both_sides(const std::vector<Index>& part)
  {
    const std::vector<Piece> all = pieces(part);
    if (all.size() == 1)
      side_[reached_.back()] = all.front().side == Q ? REST : Q;
    forget_floods();
  }

  // A piece is small if it is less than this share of what the part has of its component, and of its
  // side.
  static constexpr double share_of_small_piece = 0.3;

  void turn_small_pieces(const std::vector<Index>& part)
  {
    double area_of_side[2] = {0, 0};
    for (Index cell : part)
      area_of_side[int(side_[cell])] += cells_.area(cell);
    std::vector<char> is_done(side_.size(), 0);
    for (Index first : part) {
      if (is_done[first])
        continue;
      const double area = flood(first, [](Index) { return true; });
      const std::vector<Index> component = reached_;
      forget_floods();
      for (const Piece& piece : pieces(component))
        if (piece.area < share_of_small_piece * area &&
            piece.area < share_of_small_piece * area_of_side[int(piece.side)])
          turn(piece);
      forget_floods();
      for (Index cell : component)
        is_done[cell] = 1;
    }
  }

  void cut(std::size_t node)
  {
    const auto [first, end] = range_[node];
    const std::vector<Index> part(elements_.begin() + static_cast<std::ptrdiff_t>(first),
                                  elements_.begin() + static_cast<std::ptrdiff_t>(end));
    if (set_sides_by_shares(node, part) && !bands_.weights.empty())
      divide_band(part);
    for (Index cell : part)
      if (side_[cell] == UNDECIDED)
        side_[cell] = larger_side_[cell];
    if (!level_.has_same_shape())
      turn_small_pieces(part);
    else {
      keep_largest(part, Q);
      keep_largest(part, REST);
      keep_both_sides(part);
    }
    auto out = elements_.begin() + static_cast<std::ptrdiff_t>(first);
    for (Side side : {Q, REST}) {
      const std::size_t begin = static_cast<std::size_t>(out - elements_.begin());
      out = std::copy_if(part.begin(), part.end(), out,
                         [&](Index cell) { return side_[cell] == side; });
      range_[tree_.nodes[node].children[int(side)]] = {
        begin, static_cast<std::size_t>(out - elements_.begin())};
    }
    for (Index cell : part)
      side_[cell] = NOT_IN_PART;
  }

public:
  // `d` is that of the level.
  Cut_transfer(Execution execution, const Level& level, const Dendrogram& d,
               const Distance_weights& weights, Run_monitor& monitor)
    : execution_(execution), level_(level), mesh_(level.finer()), weights_(weights),
      monitor_(monitor), tree_(tree(d)), leaves_(tree_), place_(places_of_leaves()),
      shares_of_face_(shares_of_faces(d)), only_leaf_(only_leaves()),
      cells_(mesh_, are_between()), range_(tree_.nodes.size()),
      side_(cells_.number(), NOT_IN_PART), larger_side_(cells_.number()),
      is_reached_(cells_.number(), 0)
  {
    set_shares();
    set_roots(d);
  }

  // The leaf of each face of the finer surface, which may leave some without faces. Once the caller
  // has stopped the run, there are no minimum cuts.
  std::vector<Index> operator()()
  {
    if (level_.has_same_shape() && !monitor_.is_stopped())
      set_bands();
    for (std::size_t node : tree_.order)
      if (!tree_.nodes[node].is_leaf()) {
        cut(node);
        monitor_.advance(2 / static_cast<double>(tree_.nodes.size()));
      }
    std::vector<Index> leaf_of_cell(cells_.number());
    for (Index leaf = 0; leaf < tree_.leaf.size(); ++leaf)
      for (auto [i, end] = range_[tree_.leaf[leaf]]; i < end; ++i)
        leaf_of_cell[elements_[i]] = leaf;
    std::vector<Index> result(mesh_.number_of_faces());
    for_each_index(execution_, result.size(), [&](std::size_t f)
      { result[f] = leaf_of_cell[cells_.of_face(static_cast<Index>(f))]; });
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CUT_TRANSFER_H
