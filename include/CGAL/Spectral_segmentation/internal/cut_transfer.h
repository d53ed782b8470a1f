// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_TRANSFER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_TRANSFER_H

#include <CGAL/Spectral_segmentation/Segment_tree.h>
#include <CGAL/Spectral_segmentation/internal/Cut.h>
#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/initialization.h>
#include <CGAL/Spectral_segmentation/internal/minimum_cut.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>
#include <CGAL/Spectral_segmentation/internal/simplification.h>

#include <CGAL/Iterator_range.h>

#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// Carries the cuts of a simplified mesh over to the mesh itself. A face is on the side on which all
// faces around its three vertices are, as the simplified mesh has them. Those between, which are a
// band around the cut, are divided by the minimum cut, or if nothing is sure, by what is nearer.
// Where a side is not connected then, the smaller pieces go to the other side.
//
// The faces that may be between the sides of any cut, and those next to them, are the bands. What
// is connected beyond them is divided by no cut. So cuts divide cells: the faces of the bands, and
// after them such cores.
class Cut_transfer
{
  enum Side : char { Q, REST, BETWEEN, OUTSIDE }; // OUTSIDE: not in the part that is cut

  typedef Iterator_range<std::vector<Index>::const_iterator> Cells; // of a node
  typedef boost::no_property None;
  typedef boost::compressed_sparse_row_graph<boost::directedS, None, None, None, Index, Index>
    Cell_graph;

  const Segment_tree& cuts_;
  const Simplified_mesh& simplified_;
  const Face_dual_graph& mesh_;

  std::vector<Index> faces_of_bands_;
  Face_dual_graph bands_;

  std::vector<Index> cell_;       // of each face
  std::vector<Index> first_face_; // of each cell
  std::vector<double> areas_;     // of each cell
  Cell_graph neighbors_;

  Sides side_;                 // of each cell
  std::vector<Index> reached_; // by the present flood
  std::vector<Index> flood_;   // the last one that reached each cell
  Index number_of_floods_ = 0;

  bool is_core(Index cell) const { return cell >= faces_of_bands_.size(); }

  std::array<Index, 3> values_at(const std::vector<Index>& of_vertex, Index f) const
  {
    const std::array<Index, 3>& c = mesh_.corners[f];
    const std::vector<Index>& vertices = simplified_.vertices;
    return {of_vertex[vertices[c[0]]], of_vertex[vertices[c[1]]], of_vertex[vertices[c[2]]]};
  }

  // Whether a face may be between the sides of any cut. All may if there might be more cuts: a cut
  // must not depend on those after it.
  template <class ConcurrencyTag>
  std::vector<char> are_between() const
  {
    std::vector<char> result(mesh_.number_of_faces(), 1);
    if (!cuts_.is_whole_)
      return result;
    constexpr Index several = null_index - 1;
    const std::vector<Index> leaf = leaves(cuts_);
    std::vector<Index> of_vertex(simplified_.graph.points.size(), null_index);
    for (Index f = 0; f < leaf.size(); ++f)
      for (Index v : simplified_.graph.corners[f])
        of_vertex[v] = of_vertex[v] == null_index || of_vertex[v] == leaf[f] ? leaf[f] : several;
    for_each_index<ConcurrencyTag>(result.size(), [&](std::size_t f) {
      const auto [a, b, c] = values_at(of_vertex, static_cast<Index>(f));
      result[f] = a == several || a != b || a != c;
    });
    return result;
  }

  template <class ConcurrencyTag>
  void find_bands()
  {
    const std::vector<char> is_between = are_between<ConcurrencyTag>();
    cell_.assign(mesh_.number_of_faces(), null_index);
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      bool is_needed = is_between[f];
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        is_needed = is_needed || is_between[mesh_.halfedges[h].neighbor];
      if (is_needed) {
        cell_[f] = static_cast<Index>(faces_of_bands_.size());
        faces_of_bands_.push_back(f);
      }
    }
  }

  template <class ConcurrencyTag>
  void set_bands(const Options& options)
  {
    bands_ = Part_copier(mesh_)(faces_of_bands_);
    Distance_weights weights = distance_weights(options);
    const double area = total_area(bands_); // to which the radius is relative
    weights.concavity_radius *= area > 0 ? std::sqrt(total_area(mesh_) / area) : 0;
    set_face_distances<ConcurrencyTag>(bands_, bands_.points,
                                       face_normals<ConcurrencyTag>(bands_, bands_.points),
                                       weights);
  }

  void set_cells()
  {
    std::size_t number;
    const std::vector<Index> component = connected_components(mesh_, number, [&](Index f, Index g)
      { return cell_[f] == null_index && cell_[g] == null_index; });
    std::vector<Index> core(number, null_index); // of each component
    first_face_ = faces_of_bands_;
    for (Index f = 0; f < cell_.size(); ++f) {
      if (cell_[f] != null_index)
        continue;
      Index& cell = core[component[f]];
      if (cell == null_index) {
        cell = static_cast<Index>(first_face_.size());
        first_face_.push_back(f);
      }
      cell_[f] = cell;
    }
    areas_.assign(first_face_.size(), 0);
    for (Index f = 0; f < cell_.size(); ++f)
      areas_[cell_[f]] += mesh_.areas[f];
    side_.assign(first_face_.size(), OUTSIDE);
    flood_.assign(first_face_.size(), 0);

    std::vector<std::pair<Index, Index> > arcs;
    for (Index cell = 0; cell < faces_of_bands_.size(); ++cell)
      for (Index h = 3 * first_face_[cell]; h < 3 * first_face_[cell] + 3; ++h) {
        const Index neighbor = cell_[mesh_.halfedges[h].neighbor];
        arcs.emplace_back(cell, neighbor);
        if (is_core(neighbor))
          arcs.emplace_back(neighbor, cell);
      }
    neighbors_ = Cell_graph(boost::edges_are_unsorted_multi_pass, arcs.begin(), arcs.end(),
                            static_cast<Index>(first_face_.size()));
  }

  // Tells whether there are cells on either side.
  bool set_sure_sides(std::size_t node, const Cells& cells)
  {
    std::vector<Index> of_vertex(simplified_.graph.points.size(), 0); // the sides, as bits
    for (Index s : {Q, REST})
      for (Index f : cuts_.faces(cuts_.node(node).children[s]))
        for (Index v : simplified_.graph.corners[f])
          of_vertex[v] |= Index(1) << s;
    Index all = 0;
    for (Index cell : cells) {
      const auto [a, b, c] = values_at(of_vertex, first_face_[cell]);
      const Index sides = a | b | c;
      // Cells that came here to keep a part connected have no side; that will take care of them.
      side_[cell] = sides == 3 ? BETWEEN : sides == 2 ? REST : Q;
      if (sides != 3)
        all |= sides;
    }
    return all == 3;
  }

  void divide_band(const Cells& cells)
  {
    Sides side(side_.begin(), side_.begin() + static_cast<std::ptrdiff_t>(faces_of_bands_.size()));
    std::vector<Index> band;
    for (Index cell : cells)
      if (side_[cell] == BETWEEN) {
        side[cell] = Q;
        band.push_back(cell);
      }
    side = minimum_cut_within(bands_, band, side);
    for (Index cell : band)
      side_[cell] = side[cell];
  }

  // Where a side is so thin that all of it is between: the faces that are left in the simplified
  // mesh have their sides, and the others between follow them, step by step.
  void grow_sides(std::size_t node, const Cells& cells)
  {
    std::vector<Index> reached;
    for (Index cell : cells)
      if (side_[cell] != BETWEEN)
        reached.push_back(cell);
    for (char s : {Q, REST})
      for (Index f : cuts_.faces(cuts_.node(node).children[int(s)])) {
        const Index left = cell_[simplified_.faces[f]];
        if (side_[left] == BETWEEN) {
          side_[left] = s;
          reached.push_back(left);
        }
      }
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const char side = side_[reached[i]];
      for (Index cell : make_range(boost::adjacent_vertices(reached[i], neighbors_)))
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
      for (Index cell : make_range(boost::adjacent_vertices(reached_[next], neighbors_)))
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
        areas.back() += areas_[reached_[i]];
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

  Sides sides(std::size_t node, const Cells& cells)
  {
    if (set_sure_sides(node, cells))
      divide_band(cells);
    else
      grow_sides(node, cells);
    keep_largest(cells, Q);
    keep_largest(cells, REST);
    keep_both_sides(cells);
    Sides result;
    result.reserve(cells.size());
    for (Index cell : cells) {
      result.push_back(side_[cell]);
      side_[cell] = OUTSIDE;
    }
    return result;
  }

  // Cuts a leaf of the tree as a node of the simplified mesh is cut. Puts down for its children
  // which nodes of the tree they are. Tells whether there was something to cut.
  bool cut_as(std::size_t given, std::size_t node, Segment_tree& tree,
              std::vector<std::size_t>& same)
  {
    const auto& children = cuts_.node(given).children;
    Sides side = sides(given, tree.faces(node));
    double area[2] = {0, 0};
    std::size_t number[2] = {0, 0};
    for (std::size_t i = 0; i < side.size(); ++i) {
      area[int(side[i])] += areas_[tree.faces(node).begin()[i]];
      ++number[int(side[i])];
    }
    if (number[0] == 0 || number[1] == 0) { // of one cell
      same[children[number[0] == 0 ? 1 : 0]] = node;
      return false;
    }
    const bool is_swapped = area[0] > area[1];
    put_smaller_side_first(side, area);
    tree.cut(node, side, area);
    for (int s = 0; s < 2; ++s)
      same[children[s]] = tree.node(node).children[is_swapped ? 1 - s : s];
    return true;
  }

  // With cells in place of faces.
  Segment_tree tree_of_cells(const std::vector<Index>& component, std::size_t number_of_components,
                             const Options& options)
  {
    std::vector<Index> component_of_cell;
    for (Index f : first_face_)
      component_of_cell.push_back(component[f]);
    Segment_tree tree(component_of_cell, component_areas(mesh_, component, number_of_components),
                      mesh_.unit, options);
    tree.is_whole_ = cuts_.is_whole_;

    std::vector<std::size_t> same(cuts_.number_of_nodes(), Segment_tree::null_node); // in the tree
    bool is_complete = true;
    for (std::size_t i = 0; i < cuts_.number_of_roots(); ++i)
      same[i] = component[simplified_.faces[*cuts_.faces(i).begin()]];
    for (std::size_t i = cuts_.number_of_roots(); i < cuts_.number_of_nodes(); i += 2) {
      const std::size_t given = cuts_.node(i).parent;
      if (same[given] != Segment_tree::null_node && !cut_as(given, same[given], tree, same))
        is_complete = false;
    }
    for (std::size_t i = 0; i < cuts_.number_of_nodes(); ++i)
      if (same[i] != Segment_tree::null_node) {
        tree.set_cut(same[i], cuts_.node(i).cut_state, cuts_.node(i).salience,
                     cuts_.node(i).factors);
        tree.areas_[same[i]] = cuts_.areas_[i]; // by which the run chose what to cut next
      }
    if (!is_complete) // no more segments than there are can be asked for
      tree.maximum_number_of_segments_ =
        (std::min)(tree.maximum_number_of_segments_, tree.number_of_segments());
    return tree;
  }

public:
  Cut_transfer(const Segment_tree& cuts, const Simplified_mesh& simplified,
               const Face_dual_graph& mesh)
    : cuts_(cuts), simplified_(simplified), mesh_(mesh)
  {}

  template <class ConcurrencyTag>
  Segment_tree operator()(const Options& options)
  {
    find_bands<ConcurrencyTag>();
    std::size_t number_of_components;
    std::vector<Index> component;
    for_each_index<ConcurrencyTag>(3, [&](std::size_t task) {
      if (task == 0)
        set_bands<ConcurrencyTag>(options);
      else if (task == 1)
        set_cells();
      else
        component = connected_components(mesh_, number_of_components);
    });
    Segment_tree tree = tree_of_cells(component, number_of_components, options);
    const std::vector<Index> leaf_of_cell = leaves(tree);
    std::vector<Index> leaf(mesh_.number_of_faces());
    for (Index f = 0; f < leaf.size(); ++f)
      leaf[f] = leaf_of_cell[cell_[f]];
    tree.set_faces(leaf);
    return tree;
  }
};

// From the mesh on which they were searched to the whole mesh.
template <class ConcurrencyTag>
Segment_tree transfer_cuts(Segment_tree tree, const Initial_mesh& mesh, const Options& options)
{
  for (std::size_t i = mesh.simplified.size(); i-- > 0;)
    tree = Cut_transfer(tree, mesh.simplified[i],
                        i > 0 ? mesh.simplified[i - 1].graph : mesh.graph)
             .template operator()<ConcurrencyTag>(options);
  return tree;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_TRANSFER_H
