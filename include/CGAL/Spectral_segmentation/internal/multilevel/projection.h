// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_PROJECTION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_PROJECTION_H

#include <CGAL/Spectral_segmentation/internal/bipartition/min_cut_refinement.h>
#include <CGAL/Spectral_segmentation/internal/distances/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Nested_ranges.h>
#include <CGAL/Spectral_segmentation/internal/mesh/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/mesh/extract_part.h>
#include <CGAL/Spectral_segmentation/internal/mesh/surface_integrals.h>
#include <CGAL/Spectral_segmentation/internal/multilevel/Band_cells.h>
#include <CGAL/Spectral_segmentation/internal/multilevel/coarsening.h>
#include <CGAL/Spectral_segmentation/internal/utility/Run_monitor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Projects the cuts of a coarse mesh onto the mesh that was coarsened. A face gets the side shared
// by all coarse faces around the images of its vertices. The faces between, which have no unique
// side, are a band around the cut; it is split by a minimum cut or, if no face of a side is sure,
// by region growing from the faces that survived the coarsening. Where a side is not connected
// then, all but its largest part goes to the other side.
class Cut_projection
{
  enum Side : char { Q, REST, BETWEEN, OUTSIDE }; // OUTSIDE: not in the part that is cut

  typedef Nested_ranges::Range Cells; // of a node
  const Execution execution_;
  const Cut_hierarchy& cuts_; // of the coarse mesh
  const Coarse_mesh& coarse_;
  const Face_graph& mesh_;
  const Distance_weights& weights_;
  Run_monitor& monitor_;
  const Nested_ranges coarse_faces_;

  const Band_cells cells_;
  Face_graph bands_;

  // Of the cut at hand. Between cuts all cells are OUTSIDE.
  Sides side_;                    // of each cell
  std::vector<Index> reached_;    // by the present flood
  std::vector<Index> flood_;      // the last one that reached each cell
  Index number_of_floods_ = 0;
  std::vector<char> sides_around_; // of each coarse vertex, as bits; 0 between cuts

  template <class Value>
  std::array<Value, 3> values_at(const std::vector<Value>& of_vertex, Index f) const
  {
    const Corners& c = mesh_.corners[f];
    const std::vector<Index>& vertices = coarse_.vertices;
    return {of_vertex[vertices[c[0]]], of_vertex[vertices[c[1]]], of_vertex[vertices[c[2]]]};
  }

  // Whether a face may be between the sides of any cut. All may if there might be more cuts: a cut
  // must not depend on those after it.
  std::vector<char> are_between() const
  {
    std::vector<char> result(mesh_.number_of_faces(), 1);
    if (!cuts_.is_ultrametric)
      return result;
    constexpr Index several = null_index - 1;
    const std::vector<Index>& leaf = cuts_.leaf;
    std::vector<Index> of_vertex(coarse_.graph.points.size(), null_index);
    for (Index f = 0; f < leaf.size(); ++f)
      for (Index v : coarse_.graph.corners[f])
        of_vertex[v] = of_vertex[v] == null_index || of_vertex[v] == leaf[f] ? leaf[f] : several;
    for_each_index(execution_, result.size(), [&](std::size_t f) {
      const auto [a, b, c] = values_at(of_vertex, static_cast<Index>(f));
      result[f] = a == several || a != b || a != c;
    });
    return result;
  }

  void set_bands()
  {
    bands_ = Part_extractor(mesh_)(cells_.faces_of_bands());
    if (monitor_.is_stopped()) // sides grow then, for which no distances are needed
      return;
    Distance_weights weights = weights_;
    const double area = total_area(bands_); // to which the radius is relative
    weights.concavity_radius *= area > 0 ? std::sqrt(total_area(mesh_) / area) : 0;
    set_face_distances(execution_, bands_, bands_.points,
                       face_normals(execution_, bands_, bands_.points), weights);
  }

  // Gives each cell of a part its side or BETWEEN. Tells whether there are sure cells on either
  // side.
  bool set_sure_sides(std::size_t node, const Cells& cells)
  {
    const auto add_sides = [&](bool are_set) {
      for (Index s : {Q, REST})
        for (Index f : coarse_faces_[cuts_.nodes[node].children[s]])
          for (Index v : coarse_.graph.corners[f])
            sides_around_[v] = are_set ? static_cast<char>(sides_around_[v] | (1 << s)) : 0;
    };
    add_sides(true);
    int all = 0;
    for (Index cell : cells) {
      const auto [a, b, c] = values_at(sides_around_, cells_.first_face(cell));
      const int sides = a | b | c;
      // A cell that an earlier cut moved to keep a part connected may touch no coarse face of this
      // node (0). Any side will do: keep_largest() corrects it.
      side_[cell] = sides == 3 ? BETWEEN : sides == 2 ? REST : Q;
      if (sides != 3)
        all |= sides;
    }
    add_sides(false);
    return all == 3;
  }

  // Splits what is BETWEEN by the minimum cut. Needs sure cells on both sides.
  void divide_band(const Cells& cells)
  {
    const std::size_t number = cells_.faces_of_bands().size();
    Sides side(side_.begin(), side_.begin() + static_cast<std::ptrdiff_t>(number));
    std::vector<Index> band;
    for (Index cell : cells)
      if (side_[cell] == BETWEEN) {
        CGAL_assertion(!cells_.is_core(cell));
        side[cell] = Q;
        band.push_back(cell);
      }
    side = minimum_cut_within(bands_, band, side);
    for (Index cell : band)
      side_[cell] = side[cell];
  }

  // Splits what is BETWEEN by region growing, from the sure cells and from the faces that survived
  // the coarsening, which have the side of what is left of them.
  void grow_sides(std::size_t node, const Cells& cells)
  {
    std::vector<Index> reached;
    for (Index cell : cells)
      if (side_[cell] != BETWEEN)
        reached.push_back(cell);
    for (char s : {Q, REST})
      for (Index f : coarse_faces_[cuts_.nodes[node].children[int(s)]]) {
        const Index left = cells_.of_face(coarse_.faces[f]);
        if (side_[left] == BETWEEN) {
          side_[left] = s;
          reached.push_back(left);
        }
      }
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const char side = side_[reached[i]];
      for (Index cell : cells_.neighbors(reached[i]))
        if (side_[cell] == BETWEEN) {
          side_[cell] = side;
          reached.push_back(cell);
        }
    }
    for (Index cell : cells)
      if (side_[cell] == BETWEEN) // nothing was reached
        side_[cell] = REST;
  }

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
    if (set_sure_sides(node, cells) && !bands_.weights.empty())
      divide_band(cells);
    else
      grow_sides(node, cells);
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

  // Cuts a leaf of the result as a node of the coarse mesh is cut, and sets for the children which
  // nodes of the result they are. Tells whether there was something to cut.
  bool cut_as(std::size_t coarse_node, std::size_t node, Cut_hierarchy& result,
              Nested_ranges& cells, std::vector<std::size_t>& node_of)
  {
    const auto& children = cuts_.nodes[coarse_node].children;
    Sides side = sides(coarse_node, cells[node]);
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

public:
  Cut_projection(Execution execution, const Cut_hierarchy& cuts, const Coarse_mesh& coarse,
                 const Face_graph& mesh, const Distance_weights& weights, Run_monitor& monitor)
    : execution_(execution), cuts_(cuts), coarse_(coarse), mesh_(mesh), weights_(weights),
      monitor_(monitor), coarse_faces_(cuts, cuts.leaf),
      cells_(mesh, are_between()), side_(cells_.number(), OUTSIDE),
      flood_(cells_.number(), 0), sides_around_(coarse.graph.points.size(), 0)
  {}

  // The hierarchy on the mesh. Once the caller has stopped the run, sides grow in place of minimum
  // cuts.
  Cut_hierarchy operator()()
  {
    std::size_t number_of_components;
    std::vector<Index> component;
    call_all(execution_,
      [&] { set_bands(); },
      [&] { component = connected_components(mesh_, number_of_components); });

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
      node_of[i] = component[coarse_.faces[*coarse_faces_[i].begin()]];
    const double step = 1 / static_cast<double>(cuts_.nodes.size());
    for (std::size_t i = cuts_.number_of_roots; i < cuts_.nodes.size(); i += 2) {
      const std::size_t coarse_node = cuts_.nodes[i].parent;
      if (node_of[coarse_node] != null_node &&
          !cut_as(coarse_node, node_of[coarse_node], result, cells, node_of))
        result.is_complete = false;
      monitor_.advance(2 * step);
    }
    std::vector<std::size_t> last_of(result.nodes.size()); // of the coarse nodes that became one
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

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_PROJECTION_H
