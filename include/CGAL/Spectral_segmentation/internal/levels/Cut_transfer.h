// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CUT_TRANSFER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CUT_TRANSFER_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/levels/Band_cells.h>
#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>
#include <CGAL/Spectral_segmentation/internal/search/minimum_cut.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Transfers the cuts of another surface of the same shape to a mesh, one by one from the root. A
// cut assigns each cell to the side that has the larger fraction of it. The cells with fractions on
// both sides are a band around the cut, which a minimum cut splits. Finally, the sides are made
// connected: all pieces of a side except the largest go to the other side. A cut with a side below
// the minimum area is lost.
class Cut_transfer
{
  enum Side : char { Q, REST, OUTSIDE };
  typedef std::vector<Index> Cells;

  const Execution execution_;
  const Merge_tree& tree_; // of the other surface
  const Surface& mesh_;
  const double minimum_area_;
  Run_monitor& monitor_;

  const Merged_sets sets_;
  const Band_cells cells_;
  const Leaf_fractions fractions_; // one element per cell
  Surface bands_;                  // has weights if minimum cuts are made
  Sides side_; // one per cell, by the current cut; all are OUTSIDE between cuts

  // The parts of the mesh: the roots, then two for each cut.
  std::vector<Cells> cells_of_part_;     // empty once the part is cut
  std::vector<Index> larger_side_;       // of each part; null_index if it is not cut
  // The part that each set became, by the first position of the set. A leaf is lost if its set
  // became no part; then this is the part that it was in.
  std::vector<Index> part_;
  std::vector<char> is_lost_;
  std::vector<Index> leaf_of_part_;      // the leaf of the result; of a part that is cut, one in it

  std::vector<Index> reached_; // the cells that floods reached since start_flood()
  std::vector<Index> flood_;   // the last start at which each cell was reached
  Index number_of_floods_ = 0;

  // Returns the fractions of the cells. Their leaves are positions in the order of `sets`.
  static Leaf_fractions cell_fractions(const Band_cells& cells, const Merged_sets& sets,
                                       const Face_fractions& fractions, Run_monitor& monitor)
  {
    Leaf_fractions result;
    for (Index cell = 0; cell < cells.number(); ++cell) {
      result.add_element();
      fractions.for_each(cells.first_face(cell), [&](Index leaf, float fraction)
        { result.add(sets.position[leaf], fraction); });
      const std::size_t number = result[cell].size();
      monitor.count_steps(number * number);
    }
    return result;
  }

  // Returns whether each face may border a cut. All may if further cuts might follow, because a cut
  // must not depend on later cuts.
  static std::vector<char> may_border_cut(Execution execution, const Merge_tree& tree,
                                          const Surface& mesh, const Face_fractions& fractions)
  {
    std::vector<char> result(mesh.number_of_faces(), 1);
    if (!tree.is_monotonic)
      return result;
    constexpr Index several = null_index - 1;
    std::vector<Index> leaf(mesh.number_of_faces(), null_index);
    for_each_index(execution, leaf.size(), [&](std::size_t f) {
      fractions.for_each(static_cast<Index>(f), [&, f](Index other, float)
        { leaf[f] = leaf[f] == null_index || leaf[f] == other ? other : several; });
    });
    for_each_index(execution, leaf.size(), [&](std::size_t f) {
      const auto differs = [&](std::size_t i) {
        const Index other = leaf[mesh.neighbor(static_cast<Index>(3 * f + i))];
        return other != several && other != leaf[f];
      };
      result[f] = leaf[f] == several || differs(0) || differs(1) || differs(2);
    });
    return result;
  }

  template <class Edit_weights>
  void set_bands(Distance_weights weights, const Edit_weights& edit_weights)
  {
    const std::vector<Index> faces = cells_.faces_of_bands();
    bands_ = Part_extractor(mesh_)(faces);
    const double area = total_area(bands_); // the radius is relative to it
    weights.concavity_radius *= area > 0 ? std::sqrt(total_area(mesh_) / area) : 0;
    set_face_distances(execution_, bands_, bands_.points,
                       face_normals(execution_, bands_, bands_.points), weights);
    edit_weights(faces, bands_);
  }

  float fraction_in(const Merged_set& set, Index cell) const
  {
    float result = 0;
    for (const auto& [leaf, fraction] : fractions_[cell])
      if (set.contains(leaf))
        result += fraction;
    return result;
  }

  // Assigns each cell of a part to the side of its larger fraction in a cut. Splits the cells with
  // fractions on both sides by the minimum cut, if both sides have other cells.
  void set_sides(std::size_t cut, const Cells& cells)
  {
    std::vector<Index> band;
    bool has_certain_cell[2] = {false, false};
    for (Index cell : cells) {
      const float q = fraction_in(sets_.sides[cut][0], cell);
      const float rest = fraction_in(sets_.sides[cut][1], cell);
      side_[cell] = rest > 1.00001f * q ? REST : Q; // tolerates rounding
      if (q > 0 && rest > 0 && !cells_.is_core(cell))
        band.push_back(cell);
      else if (q > 0 || rest > 0) // not moved here by an earlier cut
        has_certain_cell[int(side_[cell])] = true;
    }
    if (bands_.weights.empty() || !has_certain_cell[0] || !has_certain_cell[1])
      return;
    const Sides side = minimum_cut_within(bands_, band, side_);
    for (Index cell : band)
      side_[cell] = side[cell];
  }

  void start_flood()
  {
    reached_.clear();
    ++number_of_floods_;
  }

  bool is_reached(Index cell) const { return flood_[cell] == number_of_floods_; }

  // Visits the cells that are connected to `first` on its side. Returns their area.
  double flood(Index first)
  {
    std::size_t next = reached_.size();
    reached_.push_back(first);
    flood_[first] = number_of_floods_;
    double area = 0;
    for (; next < reached_.size(); ++next) {
      area += cells_.area(reached_[next]);
      for (Index cell : cells_.neighbors(reached_[next]))
        if (!is_reached(cell) && side_[cell] == side_[first]) {
          flood_[cell] = number_of_floods_;
          reached_.push_back(cell);
        }
    }
    return area;
  }

  void change_sides(std::size_t first, std::size_t end)
  {
    for (std::size_t i = first; i < end; ++i)
      side_[reached_[i]] = side_[reached_[i]] == Q ? REST : Q;
  }

  // Moves all pieces of a side of a connected part, except the largest, to the other side.
  void keep_largest(const Cells& cells, Side given)
  {
    start_flood();
    std::vector<std::size_t> first_of_piece; // positions in reached_
    std::vector<double> areas;
    for (Index cell : cells)
      if (side_[cell] == given && !is_reached(cell)) {
        first_of_piece.push_back(reached_.size());
        areas.push_back(flood(cell));
      }
    if (areas.size() < 2)
      return;
    const std::size_t largest = std::max_element(areas.begin(), areas.end()) - areas.begin();
    first_of_piece.push_back(reached_.size());
    change_sides(0, first_of_piece[largest]);
    change_sides(first_of_piece[largest + 1], reached_.size());
  }

  // Moves to an empty side the cell with the largest fraction there, and the cells that only this
  // one connects with the rest. The position of the cell breaks ties.
  void keep_both_sides(std::size_t cut, const Cells& cells)
  {
    const char only = side_[*cells.begin()], other = only == Q ? REST : Q;
    if (cells.size() < 2 ||
        std::any_of(cells.begin(), cells.end(), [&](Index c) { return side_[c] != only; }))
      return;
    const auto key = [&](Index cell) {
      const double fraction = fraction_in(sets_.sides[cut][int(other)], cell);
      const double all = fraction_in(sets_.union_of(cut), cell);
      const Vector position = quantized(mesh_.centroid(cells_.first_face(cell)));
      return std::make_tuple(all > 0 ? quantized(fraction / all) : 0, position.x(), position.y(),
                             position.z());
    };
    side_[*std::max_element(cells.begin(), cells.end(), [&](Index a, Index b)
                            { return key(a) < key(b); })] = other;
    keep_largest(cells, Side(only));
  }

  // Returns the sides of the cells of a part, by a cut of the other surface. Both are connected,
  // and neither is empty if the part has two cells.
  Sides sides(std::size_t cut, const Cells& cells)
  {
    set_sides(cut, cells);
    keep_largest(cells, Q);
    keep_largest(cells, REST);
    keep_both_sides(cut, cells);
    Sides result;
    result.reserve(cells.size());
    for (Index cell : cells)
      result.push_back(std::exchange(side_[cell], char(OUTSIDE)));
    return result;
  }

  // Makes the roots parts, by their first faces.
  void add_roots()
  {
    std::vector<Index> root(part_.size()); // one per position of a leaf: where its root begins
    for (const Merged_set& r : sets_.roots)
      std::fill(root.begin() + r.first, root.begin() + r.end, r.first);
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      const Index cell = cells_.cell_of_face(f);
      Index& part = part_[root[fractions_[cell].begin()->leaf]];
      if (part == null_index)
        part = add_part({});
    }
    for (Index cell = 0; cell < cells_.number(); ++cell)
      cells_of_part_[part_[root[fractions_[cell].begin()->leaf]]].push_back(cell);
  }

  Index add_part(Cells cells)
  {
    cells_of_part_.push_back(std::move(cells));
    larger_side_.push_back(null_index);
    return static_cast<Index>(cells_of_part_.size() - 1);
  }

  // Makes a cut of the other surface, if its part is not lost. Returns its smaller and its larger
  // side, and null_index twice if it is not made because one side would be empty or too small.
  std::pair<Index, Index> cut(std::size_t i)
  {
    const Index first[2] = {sets_.sides[i][0].first, sets_.sides[i][1].first};
    if (is_lost_[first[0]])
      return {null_index, null_index};
    const Index part = part_[first[0]];
    const Cells all = std::move(cells_of_part_[part]);
    const Sides side = sides(i, all);
    Cells cells[2];
    double area[2] = {0, 0};
    for (std::size_t k = 0; k < side.size(); ++k) {
      cells[int(side[k])].push_back(all[k]);
      area[int(side[k])] += cells_.area(all[k]);
    }
    const int smaller = !cells[0].empty() && (cells[1].empty() || area[1] < area[0]) ? 1 : 0;
    if (cells[smaller].empty() || area[smaller] < minimum_area_) {
      const Merged_set& set = sets_.sides[i][smaller];
      std::fill(is_lost_.begin() + set.first, is_lost_.begin() + set.end, char(1));
      std::fill(part_.begin() + set.first, part_.begin() + set.end, part);
      part_[first[1 - smaller]] = part;
      cells_of_part_[part] = all;
      return {null_index, null_index};
    }
    const Index parts[2] = {add_part(std::move(cells[smaller])),
                            add_part(std::move(cells[1 - smaller]))};
    part_[first[smaller]] = parts[0];
    part_[first[1 - smaller]] = larger_side_[part] = parts[1];
    return {parts[0], parts[1]};
  }

  // Numbers the parts that are not cut as leaves, and sets the leaves of the faces.
  void set_leaves(Merge_tree& result)
  {
    std::vector<Index> leaf_of_cell(cells_.number());
    Index number = 0;
    leaf_of_part_.assign(larger_side_.size(), null_index);
    for (std::size_t i = 0; i < leaf_of_part_.size(); ++i)
      if (larger_side_[i] == null_index) {
        result.leaves.emplace_back();
        for (Index cell : cells_of_part_[i]) {
          leaf_of_cell[cell] = number;
          result.leaves.back().area += cells_.area(cell);
        }
        leaf_of_part_[i] = number++;
      }
    for (std::size_t i = leaf_of_part_.size(); i-- > 0;)
      if (larger_side_[i] != null_index)
        leaf_of_part_[i] = leaf_of_part_[larger_side_[i]];
    result.leaf.resize(mesh_.number_of_faces());
    for_each_index(execution_, result.leaf.size(), [&](std::size_t f)
      { result.leaf[f] = leaf_of_cell[cells_.cell_of_face(static_cast<Index>(f))]; });
  }

public:
  // Takes the cuts of another surface, which has the same components, and the least area of a side.
  // Once the caller has stopped the run, no minimum cuts are made. `edit_weights(faces, bands)` may
  // change the weights of these faces of the mesh, among which minimum cuts are searched.
  template <class Edit_weights>
  Cut_transfer(Execution execution, const Merge_tree& tree, const Surface& mesh,
               double minimum_area, const Face_fractions& fractions,
               const Distance_weights& weights, const Edit_weights& edit_weights,
               Run_monitor& monitor)
    : execution_(execution), tree_(tree), mesh_(mesh), minimum_area_(minimum_area),
      monitor_(monitor), sets_(tree),
      cells_(mesh, may_border_cut(execution, tree, mesh, fractions)),
      fractions_(cell_fractions(cells_, sets_, fractions, monitor)),
      side_(cells_.number(), OUTSIDE), part_(tree.leaves.size(), null_index),
      is_lost_(tree.leaves.size(), 0), flood_(cells_.number(), 0)
  {
    if (!fractions_.are_undivided() && !monitor.is_stopped())
      set_bands(weights, edit_weights);
  }

  Merge_tree operator()()
  {
    Merge_tree result;
    result.is_monotonic = tree_.is_monotonic;
    result.has_all_cuts = tree_.has_all_cuts;
    add_roots();
    const double step = 1 / static_cast<double>(sets_.roots.size() + 2 * tree_.merges.size());
    std::vector<std::size_t> number_of_cuts(1, 0); // after each cut of the other surface
    for (std::size_t i = tree_.merges.size(); i-- > 0;) {
      const auto [smaller, larger] = cut(i);
      if (larger != null_index)
        result.merges.push_back({{smaller, larger}, tree_.merges[i].salience,
                                 tree_.merges[i].factors});
      number_of_cuts.push_back(result.merges.size());
      monitor_.advance(2 * step);
      monitor_.go_further(); // may throw
    }
    set_leaves(result);
    std::reverse(result.merges.begin(), result.merges.end());
    for (Merge& m : result.merges)
      for (Index& leaf : m.leaves)
        leaf = leaf_of_part_[leaf];
    result.has_all_cuts = result.has_all_cuts && result.merges.size() == tree_.merges.size();
    for (std::size_t i = 0; i < tree_.leaves.size(); ++i)
      if (const Index position = sets_.position[i]; !is_lost_[position]) {
        Leaf& leaf = result.leaves[leaf_of_part_[part_[position]]];
        const double area = leaf.area;
        leaf = tree_.leaves[i];
        leaf.area = area;
        if (leaf.number_of_earlier_cuts != null_node)
          leaf.number_of_earlier_cuts = number_of_cuts[leaf.number_of_earlier_cuts];
      }
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CUT_TRANSFER_H
