// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_CONNECTED_CUT_TRANSFER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_CONNECTED_CUT_TRANSFER_H

#include <CGAL/Spectral_segmentation/internal/bipartition/min_cut_refinement.h>
#include <CGAL/Spectral_segmentation/internal/distances/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/surface/extract_part.h>
#include <CGAL/Spectral_segmentation/internal/surface/surface_integrals.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/Band_cells.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/Cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Transfers the cuts of another mesh of the same surface to a mesh with the same components. The
// derived class gives cells their sides if these are sure. The other cells are a band around the
// cut, which a minimum cut splits. The sides are made connected: all but the largest part of a side
// goes to the other side.
class Connected_cut_transfer : protected Cut_transfer
{
protected:
  typedef Elements Cells;
  const Execution execution_;
  const Surface& mesh_;
  const Nested_ranges other_faces_; // the faces of the nodes of the other mesh

  const Band_cells cells_;
  Sides side_; // one per cell, by the current cut; all are OUTSIDE between cuts

  Connected_cut_transfer(Execution execution, const Cut_hierarchy& cuts, const Surface& mesh,
                         const std::vector<char>& are_between, const Distance_weights& weights,
                         Run_monitor& monitor)
    : Cut_transfer(cuts, monitor), execution_(execution), mesh_(mesh),
      other_faces_(cuts, cuts.leaf), cells_(mesh, are_between), side_(cells_.number(), OUTSIDE),
      weights_(weights), flood_(cells_.number(), 0) {}

  ~Connected_cut_transfer() = default;

  // An element that belongs to more than one leaf of the other mesh has `several` for a leaf.
  static constexpr Index several = null_index - 1;
  static void add_leaf(Index leaf, Index& of_element)
  { of_element = of_element == null_index || of_element == leaf ? leaf : several; }

  // Gives each cell its side or BETWEEN, in a part that is cut like a node of the other mesh.
  // Returns whether there are sure cells on both sides.
  virtual bool set_sure_sides(std::size_t node, const Cells& cells) = 0;

  // Gives the cells that are BETWEEN a side if there is no minimum cut.
  virtual void set_other_sides(std::size_t node, const Cells& cells) = 0;

  // Returns the face of the mesh that corresponds to a face of the other mesh.
  virtual Index face_of(Index other_face) const = 0;

private:
  const Distance_weights& weights_;
  Surface bands_;
  std::vector<Index> reached_; // the cells that the current flood reached
  std::vector<Index> flood_;   // the last flood that reached each cell
  Index number_of_floods_ = 0;

  void set_bands()
  {
    bands_ = Part_extractor(mesh_)(cells_.faces_of_bands());
    if (monitor_.is_stopped()) // sides grow then and need no distances
      return;
    Distance_weights weights = weights_;
    const double area = total_area(bands_); // the radius is relative to it
    weights.concavity_radius *= area > 0 ? std::sqrt(total_area(mesh_) / area) : 0;
    set_face_distances(execution_, bands_, bands_.points,
                       face_normals(execution_, bands_, bands_.points), weights);
  }

  // Splits the cells that are BETWEEN by the minimum cut. Needs sure cells on both sides.
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

  // Adds the cells connected with a cell on its side to the cells that this flood reached.
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

  // Moves the connected sets of cells on a side of a connected part, but for the largest, to the
  // other side.
  void keep_largest(const Cells& cells, Side given)
  {
    start_flood();
    std::vector<std::size_t> first_of_set; // positions in reached_
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

  // Gives a side without cells a cell without which the part is still connected.
  void keep_both_sides(const Cells& cells)
  {
    const Side first = static_cast<Side>(side_[*cells.begin()]);
    if (std::any_of(cells.begin(), cells.end(), [&](Index c) { return side_[c] != first; }))
      return;
    start_flood();
    flood(*cells.begin());
    side_[reached_.back()] = first == Q ? REST : Q;
  }

  double area(Index cell) const override { return cells_.area(cell); }

  // Returns connected sides; both have a cell if the part has two.
  Sides sides(std::size_t node, const Cells& cells) override
  {
    if (set_sure_sides(node, cells) && !bands_.weights.empty())
      divide_band(cells);
    else
      set_other_sides(node, cells);
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

public:
  // Returns the hierarchy on the mesh. It makes no minimum cuts once the caller has stopped the
  // run.
  Cut_hierarchy operator()()
  {
    set_bands();
    std::vector<Index> component_of_cell;
    for (Index cell = 0; cell < cells_.number(); ++cell)
      component_of_cell.push_back(mesh_.components[cells_.first_face(cell)]);
    std::vector<std::size_t> root_of; // one per component of the other mesh
    for (std::size_t i = 0; i < cuts_.number_of_roots; ++i)
      root_of.push_back(mesh_.components[face_of(*other_faces_[i].begin())]);
    const std::vector<double> areas = component_areas(mesh_, mesh_.components);
    Cut_hierarchy result =
      Cut_transfer::transfer(uncut_hierarchy(std::move(component_of_cell), areas), root_of);
    std::vector<Index> leaf(mesh_.number_of_faces());
    for_each_index(execution_, leaf.size(), [&](std::size_t f)
      { leaf[f] = result.leaf[cells_.of_face(static_cast<Index>(f))]; });
    result.leaf = std::move(leaf);
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_CONNECTED_CUT_TRANSFER_H
