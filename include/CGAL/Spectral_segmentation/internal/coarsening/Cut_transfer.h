// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_CUT_TRANSFER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_CUT_TRANSFER_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Nested_ranges.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Transfers the cuts of another mesh to elements of a mesh (faces, or cells of faces), one by one
// from the root. The derived class decides on the sides of a cut.
class Cut_transfer
{
protected:
  enum Side : char { Q, REST, BETWEEN, OUTSIDE }; // the last two are for the derived classes

  typedef Nested_ranges::Range Elements; // the elements of a node
  const Cut_hierarchy& cuts_; // the cuts of the other mesh
  Run_monitor& monitor_;

  Cut_transfer(const Cut_hierarchy& cuts, Run_monitor& monitor) : cuts_(cuts), monitor_(monitor) {}
  ~Cut_transfer() = default;

  // Returns the sides of the elements of a part that is cut like a node of the other mesh: Q or
  // REST, and both of them if possible.
  virtual Sides sides(std::size_t node, const Elements& elements) = 0;

  virtual double area(Index element) const = 0;

private:
  // Cuts a leaf of the result like a node of the other mesh, and sets the nodes of the result for
  // the children. Returns whether there was something to cut.
  bool cut_as(std::size_t other_node, std::size_t node, Cut_hierarchy& result,
              Nested_ranges& elements, std::vector<std::size_t>& node_of)
  {
    const auto& children = cuts_.nodes[other_node].children;
    Sides side = sides(other_node, elements[node]);
    double area_of[2] = {0, 0};
    std::size_t number[2] = {0, 0};
    for (std::size_t i = 0; i < side.size(); ++i) {
      area_of[int(side[i])] += area(elements[node].begin()[static_cast<std::ptrdiff_t>(i)]);
      ++number[int(side[i])];
    }
    if (number[0] == 0 || number[1] == 0) {
      node_of[children[number[0] == 0 ? 1 : 0]] = node;
      return false;
    }
    const bool is_swapped = area_of[0] > area_of[1];
    normalize_sides(side, area_of);
    result.cut(node, area_of[0], area_of[1]);
    elements.cut(node, side);
    for (int s = 0; s < 2; ++s)
      node_of[children[s]] = result.nodes[node].children[is_swapped ? 1 - s : s];
    return true;
  }

protected:
  // Cuts the roots of the result, whose `leaf` is indexed by element. `node_of` has the root of the
  // result for each root of the other mesh.
  Cut_hierarchy transfer(Cut_hierarchy result, std::vector<std::size_t> node_of)
  {
    result.is_monotonic = cuts_.is_monotonic;
    result.has_all_cuts = cuts_.has_all_cuts;
    Nested_ranges elements(result, result.leaf);
    node_of.resize(cuts_.nodes.size(), null_node);
    const double step = 1 / static_cast<double>(cuts_.nodes.size());
    for (std::size_t i = cuts_.number_of_roots; i < cuts_.nodes.size(); i += 2) {
      const std::size_t other_node = cuts_.nodes[i].parent;
      if (node_of[other_node] != null_node &&
          !cut_as(other_node, node_of[other_node], result, elements, node_of))
        result.has_all_cuts = false;
      monitor_.advance(2 * step);
    }
    std::vector<std::size_t> last_of(result.nodes.size()); // per node: the last that became it
    for (std::size_t i = 0; i < cuts_.nodes.size(); ++i)
      if (node_of[i] != null_node) {
        Cut_node& n = result.nodes[node_of[i]];
        last_of[node_of[i]] = i;
        n.cut_state = cuts_.nodes[i].cut_state;
        n.salience = cuts_.nodes[i].salience;
        n.factors = cuts_.nodes[i].factors;
      }
    for (std::size_t turn : cuts_.cut_order)
      if (node_of[turn] != null_node && last_of[node_of[turn]] == turn)
        result.cut_order.push_back(node_of[turn]);

    for (std::size_t i = 0; i < result.nodes.size(); ++i)
      if (result.nodes[i].is_leaf())
        for (Index element : elements[i])
          result.leaf[element] = static_cast<Index>(i);
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_CUT_TRANSFER_H
