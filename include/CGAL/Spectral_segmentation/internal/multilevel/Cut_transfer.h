// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_CUT_TRANSFER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_CUT_TRANSFER_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Nested_ranges.h>
#include <CGAL/Spectral_segmentation/internal/mesh/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/multilevel/Band_cells.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut.h>
#include <CGAL/Spectral_segmentation/internal/utility/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/utility/concurrency.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Carries the cuts of another mesh of the same surface over to a mesh, one by one from the root.
// What decides on the sides of a cut is up to the derived class; here they are made connected: all
// but the largest part of a side goes to the other side.
class Cut_transfer
{
protected:
  enum Side : char { Q, REST, BETWEEN, OUTSIDE }; // OUTSIDE: not in the part that is cut

  typedef Nested_ranges::Range Cells; // of a node
  const Execution execution_;
  const Cut_hierarchy& cuts_; // of the other mesh
  const Face_graph& mesh_;
  Run_monitor& monitor_;
  const Nested_ranges other_faces_; // of the nodes of the other mesh

  const Band_cells cells_;
  Sides side_; // of each cell, by the cut at hand. Between cuts all cells are OUTSIDE.

  Cut_transfer(Execution execution, const Cut_hierarchy& cuts, const Face_graph& mesh,
               const std::vector<char>& are_between, Run_monitor& monitor)
    : execution_(execution), cuts_(cuts), mesh_(mesh), monitor_(monitor),
      other_faces_(cuts, cuts.leaf), cells_(mesh, are_between), side_(cells_.number(), OUTSIDE),
      flood_(cells_.number(), 0) {}

  ~Cut_transfer() = default;

  // Gives each cell of a part that is cut as a node of the other mesh the side Q or REST.
  virtual void set_sides(std::size_t node, const Cells& cells) = 0;

  // The face of the mesh that has something of a face of the other mesh.
  virtual Index face_of(Index other_face) const = 0;

private:
  std::vector<Index> reached_; // by the present flood
  std::vector<Index> flood_;   // the last one that reached each cell
  Index number_of_floods_ = 0;

  // Adds the cells of one side that are connected with a cell, to those that this flood reached.
  void flood(Index first)
  {
    std::size_t next = reached_.size();
    reached_.push_back(first);
    flood_[first] = number_of_floods_;
    for (; next < reached_.size(); ++next)
      for (Index cell : cells_.neighbors(reached_[next]))
        if (side_[cell] == side_[first] && flood_[cell] != number_of_floods_) {
          flood_[cell] = number_of_floods_;
          reached_.push_back(cell);
        }
  }

  void start_flood()
  {
    reached_.clear();
    ++number_of_floods_;
  }

  // The connected sets of cells on a side of a connected part, but for the largest, go to the other
  // side.
  void keep_largest(const Cells& cells, Side given)
  {
    start_flood();
    std::vector<std::size_t> first_of_set; // in reached_
    std::vector<double> areas;
    for (Index cell : cells) {
      if (side_[cell] != given || flood_[cell] == number_of_floods_)
        continue;
      first_of_set.push_back(reached_.size());
      flood(cell);
      areas.push_back(0);
      for (std::size_t i = first_of_set.back(); i < reached_.size(); ++i)
        areas.back() += cells_.area(reached_[i]);
    }
    if (areas.size() < 2)
      return;
    const std::size_t largest = std::max_element(areas.begin(), areas.end()) - areas.begin();
    first_of_set.push_back(reached_.size());
    for (std::size_t i = 0; i < reached_.size(); ++i)
      if (i < first_of_set[largest] || i >= first_of_set[largest + 1])
        side_[reached_[i]] = given == Q ? REST : Q;
  }

  // A side on which no cell is gets one, without which the part is still connected.
  void keep_both_sides(const Cells& cells)
  {
    const Side first = static_cast<Side>(side_[*cells.begin()]);
    if (std::any_of(cells.begin(), cells.end(), [&](Index c) { return side_[c] != first; }))
      return;
    start_flood();
    flood(*cells.begin());
    side_[reached_.back()] = first == Q ? REST : Q;
  }

  // The side of each cell of a part. Both are connected; both have a cell if the part has two.
  Sides sides(std::size_t node, const Cells& cells)
  {
    set_sides(node, cells);
    keep_largest(cells, Q);
    keep_largest(cells, REST);
    keep_both_sides(cells);
    Sides result;
    result.reserve(cells.size());
    for (Index cell : cells) {
      CGAL_assertion(side_[cell] == Q || side_[cell] == REST);
      result.push_back(side_[cell]);
      side_[cell] = OUTSIDE;
    }
    return result;
  }

  // Cuts a leaf of the result as a node of the other mesh is cut, and sets for the children which
  // nodes of the result they are. Tells whether there was something to cut.
  bool cut_as(std::size_t other_node, std::size_t node, Cut_hierarchy& result,
              Nested_ranges& cells, std::vector<std::size_t>& node_of)
  {
    const auto& children = cuts_.nodes[other_node].children;
    Sides side = sides(other_node, cells[node]);
    double area[2] = {0, 0};
    std::size_t number[2] = {0, 0};
    for (std::size_t i = 0; i < side.size(); ++i) {
      area[int(side[i])] += cells_.area(cells[node].begin()[static_cast<std::ptrdiff_t>(i)]);
      ++number[int(side[i])];
    }
    if (number[0] == 0 || number[1] == 0) { // of one cell
      node_of[children[number[0] == 0 ? 1 : 0]] = node;
      return false;
    }
    const bool is_swapped = area[0] > area[1];
    normalize_sides(side, area);
    result.cut(node, area[0], area[1]);
    cells.cut(node, side);
    for (int s = 0; s < 2; ++s)
      node_of[children[s]] = result.nodes[node].children[is_swapped ? 1 - s : s];
    return true;
  }

protected:
  // The hierarchy on the mesh. First calls what prepares the derived class.
  template <class Prepare>
  Cut_hierarchy transfer(const Prepare& prepare)
  {
    std::size_t number_of_components;
    std::vector<Index> component;
    call_all(execution_, prepare, [&]
             { component = connected_components(mesh_, number_of_components); });
    std::vector<Index> component_of_cell;
    for (Index cell = 0; cell < cells_.number(); ++cell)
      component_of_cell.push_back(component[cells_.first_face(cell)]);
    Cut_hierarchy result = uncut_hierarchy(
      std::move(component_of_cell), component_areas(mesh_, component, number_of_components));
    result.is_ultrametric = cuts_.is_ultrametric;
    result.is_complete = cuts_.is_complete;
    Nested_ranges cells(result, result.leaf);

    std::vector<std::size_t> node_of(cuts_.nodes.size(), null_node); // in the result
    for (std::size_t i = 0; i < cuts_.number_of_roots; ++i)
      node_of[i] = component[face_of(*other_faces_[i].begin())];
    const double step = 1 / static_cast<double>(cuts_.nodes.size());
    for (std::size_t i = cuts_.number_of_roots; i < cuts_.nodes.size(); i += 2) {
      const std::size_t other_node = cuts_.nodes[i].parent;
      if (node_of[other_node] != null_node &&
          !cut_as(other_node, node_of[other_node], result, cells, node_of))
        result.is_complete = false;
      monitor_.advance(2 * step);
    }
    std::vector<std::size_t> last_of(result.nodes.size()); // of the other nodes that became one
    for (std::size_t i = 0; i < cuts_.nodes.size(); ++i)
      if (node_of[i] != null_node) {
        Cut_node& n = result.nodes[node_of[i]];
        last_of[node_of[i]] = i;
        n.cut_state = cuts_.nodes[i].cut_state;
        n.salience = cuts_.nodes[i].salience;
        n.factors = cuts_.nodes[i].factors;
      }
    for (std::size_t turn : cuts_.turns)
      if (node_of[turn] != null_node && last_of[node_of[turn]] == turn)
        result.turns.push_back(node_of[turn]);

    for (std::size_t i = 0; i < result.nodes.size(); ++i)
      if (result.nodes[i].is_leaf())
        for (Index cell : cells[i])
          result.leaf[cell] = static_cast<Index>(i);
    std::vector<Index> leaf(mesh_.number_of_faces());
    for_each_index(execution_, leaf.size(), [&](std::size_t f)
      { leaf[f] = result.leaf[cells_.of_face(static_cast<Index>(f))]; });
    result.leaf = std::move(leaf);
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_CUT_TRANSFER_H
