// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CUT_TRANSFER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CUT_TRANSFER_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/search/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/search/cut_proposals.h>
#include <CGAL/Spectral_segmentation/internal/surface/Longest_edge_bisection.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The leaves of a hierarchy that each element touches, with its fraction in each leaf.
class Leaf_fractions
{
public:
  struct Fraction
  {
    Index leaf;
    float fraction;
  };

private:
  std::vector<Fraction> fractions_; // grouped by element
  std::vector<Index> first_ = {0};  // one per element, and the end

  const Fraction* begin(std::size_t element) const { return fractions_.data() + first_[element]; }

public:
  // Adds an element without fractions.
  void add_element() { first_.push_back(first_.back()); }

  // Adds to the fraction of the last element in a leaf.
  void add(Index leaf, float fraction)
  {
    const auto first = fractions_.begin() + static_cast<std::ptrdiff_t>(first_[first_.size() - 2]);
    const auto found = std::find_if(first, fractions_.end(),
                                    [leaf](const Fraction& f) { return f.leaf == leaf; });
    if (found != fractions_.end())
      found->fraction += fraction;
    else {
      fractions_.push_back({leaf, fraction});
      ++first_.back();
    }
  }

  std::size_t number_of_elements() const { return first_.size() - 1; }

  // Returns whether each element touches only one leaf.
  bool are_undivided() const { return fractions_.size() == number_of_elements(); }

  Iterator_range<const Fraction*> operator[](std::size_t element) const
  { return make_range(begin(element), begin(element + 1)); }
};

// Returns the fractions of the vertices of a coarse surface in the leaves of the faces around them.
inline Leaf_fractions vertex_fractions(const Surface& coarse, const std::vector<Index>& leaf)
{
  std::vector<Packed_graph::Ends> corners;
  corners.reserve(3 * leaf.size());
  for (Index f = 0; f < leaf.size(); ++f)
    for (Index v : coarse.corners[f])
      corners.emplace_back(v, leaf[f]);
  std::vector<Index> position;
  const Packed_graph leaves(coarse.points.size(), corners, position);
  Leaf_fractions result;
  for (Index v = 0; v < coarse.points.size(); ++v) {
    result.add_element();
    const Index first = leaves.first_arc[v], end = leaves.first_arc[v + 1];
    for (Index i = first; i < end; ++i)
      result.add(leaves.targets[i], 1 / static_cast<float>(end - first));
  }
  return result;
}

// Returns the fractions, as areas, of the faces of a mesh in the leaves of its refined surface.
inline Leaf_fractions face_fractions(const Refined_mesh& refined, const std::vector<Index>& leaf)
{
  Leaf_fractions result;
  for (Index f = 0; f < leaf.size(); ++f) {
    while (result.number_of_elements() <= refined.faces[f])
      result.add_element();
    result.add(leaf[f], static_cast<float>(refined.graph.areas[f]));
  }
  return result;
}

// The cells of a mesh, which no cut divides: the single faces of the bands, followed by the cores.
// The bands are the faces that may border a cut, and the faces next to these. A core is a connected
// component of the other faces.
class Band_cells
{
  std::vector<Index> faces_of_bands_;
  std::vector<Index> cell_;       // the cell of each face
  std::vector<Index> first_face_; // one per cell
  std::vector<double> areas_;     // one per cell
  std::optional<Packed_graph> graph_;

  void find_bands(const Surface& mesh, const std::vector<char>& may_border_cut)
  {
    cell_.assign(mesh.number_of_faces(), null_index);
    for (Index f = 0; f < mesh.number_of_faces(); ++f) {
      bool is_needed = may_border_cut[f];
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        is_needed = is_needed || may_border_cut[mesh.neighbor(h)];
      if (is_needed) {
        cell_[f] = static_cast<Index>(faces_of_bands_.size());
        faces_of_bands_.push_back(f);
      }
    }
  }

  void find_cores(const Surface& mesh)
  {
    std::vector<char> is_in_band(cell_.size());
    for (Index f = 0; f < cell_.size(); ++f)
      is_in_band[f] = cell_[f] != null_index;
    const Components components = connected_components(mesh, is_in_band);
    std::vector<Index> core(components.number, null_index); // the core of each component
    first_face_ = faces_of_bands_;
    for (Index f = 0; f < cell_.size(); ++f) {
      if (cell_[f] != null_index)
        continue;
      Index& cell = core[components[f]];
      if (cell == null_index) {
        cell = static_cast<Index>(first_face_.size());
        first_face_.push_back(f);
      }
      cell_[f] = cell;
    }
  }

public:
  // Makes the cells; `may_border_cut` has a flag for each face.
  Band_cells(const Surface& mesh, const std::vector<char>& may_border_cut)
  {
    find_bands(mesh, may_border_cut);
    find_cores(mesh);
    areas_.assign(first_face_.size(), 0);
    for (Index f = 0; f < cell_.size(); ++f)
      areas_[cell_[f]] += mesh.areas[f];

    std::vector<Packed_graph::Ends> arcs;
    for (Index cell = 0; cell < faces_of_bands_.size(); ++cell)
      for (Index h = 3 * first_face_[cell]; h < 3 * first_face_[cell] + 3; ++h) {
        const Index neighbor = cell_[mesh.neighbor(h)];
        arcs.emplace_back(cell, neighbor);
        if (is_core(neighbor))
          arcs.emplace_back(neighbor, cell);
      }
    std::vector<Index> position;
    graph_.emplace(number(), arcs, position);
  }

  std::size_t number() const { return first_face_.size(); }
  const std::vector<Index>& faces_of_bands() const { return faces_of_bands_; } // ascending
  bool is_core(Index cell) const { return cell >= faces_of_bands_.size(); }
  Index cell_of_face(Index f) const { return cell_[f]; }
  Index first_face(Index cell) const { return first_face_[cell]; }
  double area(Index cell) const { return areas_[cell]; }

  Iterator_range<const Index*> neighbors(Index cell) const
  {
    const Index* targets = graph_->targets.data();
    return make_range(targets + graph_->first_arc[cell], targets + graph_->first_arc[cell + 1]);
  }
};

// Transfers the cuts of another surface of the same shape to a mesh, one by one from the root. A
// cut assigns each cell to the side that has the larger fraction of it. The cells with fractions on
// both sides are a band around the cut, which a minimum cut splits. Finally, the sides are made
// connected: all pieces of a side except the largest go to the other side.
class Cut_transfer
{
  enum Side : char { Q, REST, OUTSIDE };
  typedef Nested_ranges::Range Cells;

  const Execution execution_;
  const Cut_hierarchy& cuts_; // the cuts of the other surface
  const Surface& mesh_;
  Run_monitor& monitor_;

  const Nested_ranges leaves_; // the leaves of each node of the other surface
  const Band_cells cells_;
  const Leaf_fractions fractions_; // one element per cell
  Surface bands_;                  // has weights if minimum cuts are made
  Sides side_; // one per cell, by the current cut; all are OUTSIDE between cuts
  std::vector<std::size_t> node_of_; // the node of the result for each node of the other surface

  std::vector<Index> reached_; // the cells that floods reached since start_flood()
  std::vector<Index> flood_;   // the last start at which each cell was reached
  Index number_of_floods_ = 0;

  // Returns the fractions of the cells. Their leaves are positions in `leaves`.
  template <class For_each_fraction>
  static Leaf_fractions cell_fractions(const Band_cells& cells, const Nested_ranges& leaves,
                                       const For_each_fraction& for_each_fraction,
                                       Run_monitor& monitor)
  {
    Leaf_fractions result;
    for (Index cell = 0; cell < cells.number(); ++cell) {
      result.add_element();
      for_each_fraction(cells.first_face(cell), [&](Index leaf, float fraction)
        { result.add(static_cast<Index>(leaves.first(leaf)), fraction); });
      const std::size_t number = result[cell].size();
      monitor.count_steps(number * number);
    }
    return result;
  }

  // Returns whether each face may border a cut. All may if further cuts might follow, because a cut
  // must not depend on later cuts.
  template <class For_each_fraction>
  static std::vector<char> may_border_cut(Execution execution, const Cut_hierarchy& cuts,
                                          const Surface& mesh,
                                          const For_each_fraction& for_each_fraction)
  {
    std::vector<char> result(mesh.number_of_faces(), 1);
    if (!cuts.is_monotonic)
      return result;
    constexpr Index several = null_index - 1;
    std::vector<Index> leaf(mesh.number_of_faces(), null_index);
    for_each_index(execution, leaf.size(), [&](std::size_t f) {
      for_each_fraction(static_cast<Index>(f), [&, f](Index other, float)
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

  float fraction_in(std::size_t node, Index cell) const
  {
    const std::size_t first = leaves_.first(node), end = first + leaves_.size(node);
    float result = 0;
    for (const auto& [leaf, fraction] : fractions_[cell])
      if (leaf >= first && leaf < end)
        result += fraction;
    return result;
  }

  // Assigns each cell of a part to the side of its larger fraction in the cut of a node. Splits the
  // cells with fractions on both sides by the minimum cut, if both sides have other cells.
  void set_sides(std::size_t node, const Cells& cells)
  {
    std::vector<Index> band;
    bool has_certain_cell[2] = {false, false};
    for (Index cell : cells) {
      const float q = fraction_in(cuts_.nodes[node].children[0], cell);
      const float rest = fraction_in(cuts_.nodes[node].children[1], cell);
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
  void keep_both_sides(std::size_t node, const Cells& cells)
  {
    const char only = side_[*cells.begin()], other = only == Q ? REST : Q;
    if (cells.size() < 2 ||
        std::any_of(cells.begin(), cells.end(), [&](Index c) { return side_[c] != only; }))
      return;
    const auto key = [&](Index cell) {
      const double fraction = fraction_in(cuts_.nodes[node].children[int(other)], cell);
      const double all = fraction_in(node, cell);
      const Vector position = quantized(mesh_.centroid(cells_.first_face(cell)));
      return std::make_tuple(all > 0 ? quantized(fraction / all) : 0, position.x(), position.y(),
                             position.z());
    };
    side_[*std::max_element(cells.begin(), cells.end(), [&](Index a, Index b)
                            { return key(a) < key(b); })] = other;
    keep_largest(cells, Side(only));
  }

  // Returns the sides of the cells of a part that is cut like a node of the other surface. Both are
  // connected, and neither is empty if the part has two cells.
  Sides sides(std::size_t node, const Cells& cells)
  {
    set_sides(node, cells);
    keep_largest(cells, Q);
    keep_largest(cells, REST);
    keep_both_sides(node, cells);
    Sides result;
    result.reserve(cells.size());
    for (Index cell : cells)
      result.push_back(std::exchange(side_[cell], char(OUTSIDE)));
    return result;
  }

  // Cuts a leaf of the result like a node of the other surface, and sets the nodes of the result
  // for the children. Returns false if one side is empty.
  bool cut_as(std::size_t other_node, std::size_t node, Cut_hierarchy& result,
              Nested_ranges& cells)
  {
    const auto& children = cuts_.nodes[other_node].children;
    Sides side = sides(other_node, cells[node]);
    double area_of[2] = {0, 0};
    std::size_t number[2] = {0, 0};
    for (std::size_t i = 0; i < side.size(); ++i) {
      area_of[int(side[i])] += cells_.area(cells[node].begin()[static_cast<std::ptrdiff_t>(i)]);
      ++number[int(side[i])];
    }
    if (number[0] == 0 || number[1] == 0) {
      node_of_[children[number[0] == 0 ? 1 : 0]] = node;
      return false;
    }
    const bool is_swapped = area_of[0] > area_of[1];
    normalize_sides(side, area_of);
    result.cut(node, area_of[0], area_of[1]);
    cells.cut(node, side);
    for (int s = 0; s < 2; ++s)
      node_of_[children[s]] = result.nodes[node].children[is_swapped ? 1 - s : s];
    return true;
  }

  // Returns a hierarchy of the mesh whose leaves are cells. Its roots are numbered by their first
  // faces. Sets `node_of_` for the roots.
  Cut_hierarchy roots()
  {
    const std::vector<std::size_t> root_of_leaf = roots_of_leaves(cuts_, leaves_);
    std::vector<Index> root_of_cell(cells_.number());
    std::vector<double> areas;
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      const Index cell = cells_.cell_of_face(f);
      std::size_t& root = node_of_[root_of_leaf[fractions_[cell].begin()->leaf]];
      if (root == null_node) {
        root = areas.size();
        areas.push_back(0);
      }
      root_of_cell[cell] = static_cast<Index>(root);
      areas[root] += mesh_.areas[f];
    }
    return uncut_hierarchy(std::move(root_of_cell), areas);
  }

public:
  // Takes the cuts of another surface, which has the same components. `for_each_fraction(f, add)`
  // calls add(leaf, fraction) for each leaf of the cuts that the face f of the mesh touches,
  // possibly repeatedly. Once the caller has stopped the run, no minimum cuts are made.
  // `edit_weights(faces, bands)` may change the weights of these faces of the mesh, among which
  // minimum cuts are searched.
  template <class For_each_fraction, class Edit_weights>
  Cut_transfer(Execution execution, const Cut_hierarchy& cuts, const Surface& mesh,
               const For_each_fraction& for_each_fraction, const Distance_weights& weights,
               const Edit_weights& edit_weights, Run_monitor& monitor)
    : execution_(execution), cuts_(cuts), mesh_(mesh), monitor_(monitor),
      leaves_(ranges_of_leaves(cuts)),
      cells_(mesh, may_border_cut(execution, cuts, mesh, for_each_fraction)),
      fractions_(cell_fractions(cells_, leaves_, for_each_fraction, monitor)),
      side_(cells_.number(), OUTSIDE), node_of_(cuts.nodes.size(), null_node),
      flood_(cells_.number(), 0)
  {
    if (!fractions_.are_undivided() && !monitor.is_stopped())
      set_bands(weights, edit_weights);
  }

  Cut_hierarchy operator()()
  {
    Cut_hierarchy result = roots();
    result.is_monotonic = cuts_.is_monotonic;
    result.has_all_cuts = cuts_.has_all_cuts;
    Nested_ranges cells(result, result.leaf);
    const double step = 1 / static_cast<double>(cuts_.nodes.size());
    for (std::size_t i = cuts_.number_of_roots; i < cuts_.nodes.size(); i += 2) {
      const std::size_t other_node = cuts_.nodes[i].parent;
      if (node_of_[other_node] != null_node &&
          !cut_as(other_node, node_of_[other_node], result, cells))
        result.has_all_cuts = false;
      monitor_.advance(2 * step);
      monitor_.go_further(); // may throw
    }
    std::vector<std::size_t> last_of(result.nodes.size()); // one per node: the last that became it
    for (std::size_t i = 0; i < cuts_.nodes.size(); ++i)
      if (node_of_[i] != null_node) {
        Cut_node& n = result.nodes[node_of_[i]];
        last_of[node_of_[i]] = i;
        n.cut_state = cuts_.nodes[i].cut_state;
        n.salience = cuts_.nodes[i].salience;
        n.factors = cuts_.nodes[i].factors;
      }
    for (std::size_t cut : cuts_.cut_order)
      if (node_of_[cut] != null_node && last_of[node_of_[cut]] == cut)
        result.cut_order.push_back(node_of_[cut]);

    std::vector<Index> leaf_of_cell(cells_.number());
    for (std::size_t i = 0; i < result.nodes.size(); ++i)
      if (result.nodes[i].is_leaf())
        for (Index cell : cells[i])
          leaf_of_cell[cell] = static_cast<Index>(i);
    result.leaf.resize(mesh_.number_of_faces());
    for_each_index(execution_, result.leaf.size(), [&](std::size_t f)
      { result.leaf[f] = leaf_of_cell[cells_.cell_of_face(static_cast<Index>(f))]; });
    return result;
  }

  // Returns a leaf of the result within the node that a leaf of the other surface became.
  Index leaf_of(Index other, const Cut_hierarchy& result) const
  {
    std::size_t i = other;
    while (node_of_[i] == null_node)
      i = cuts_.nodes[i].parent;
    for (i = node_of_[i]; !result.nodes[i].is_leaf();)
      i = result.nodes[i].children[1];
    return static_cast<Index>(i);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CUT_TRANSFER_H
