// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CELLS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CELLS_H

#include <CGAL/Spectral_segmentation/internal/base/arrays.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The faces of a surface in cells that cuts do not divide: the faces of the bands, which are those
// between the sides of any cut and next to them, one by one, and after them the cores, which are
// what is connected beyond the bands.
class Cells
{
  std::vector<Index> cell_;       // of each face
  std::vector<Index> first_face_; // of each cell
  std::vector<double> areas_;     // of each cell
  Index number_in_bands_ = 0;
  std::vector<Index> to_;         // of each arc between cells
  std::optional<Rows> arcs_;      // of each cell

  void add_bands(const Surface& surface, const std::vector<char>& is_between)
  {
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      if (is_between[f] || is_between[surface.neighbor(3 * f)] ||
          is_between[surface.neighbor(3 * f + 1)] || is_between[surface.neighbor(3 * f + 2)]) {
        cell_[f] = static_cast<Index>(first_face_.size());
        first_face_.push_back(f);
      }
    number_in_bands_ = static_cast<Index>(first_face_.size());
  }

  void add_cores(const Surface& surface)
  {
    const Components components = connected_components(surface, [this](Index f)
      { return cell_[f] == null_index; });
    std::vector<Index> core(components.number, null_index);
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

  void add_arcs(const Surface& surface)
  {
    std::vector<Index> from;
    const auto add = [&](Index a, Index b) {
      from.push_back(a);
      to_.push_back(b);
    };
    for (Index cell = 0; cell < number_in_bands_; ++cell)
      for (Index h = 3 * first_face_[cell]; h < 3 * first_face_[cell] + 3; ++h) {
        const Index neighbor = cell_[surface.neighbor(h)];
        add(cell, neighbor);
        if (is_core(neighbor))
          add(neighbor, cell);
      }
    arcs_.emplace(number(), from.size(), [&](Index arc) { return from[arc]; });
  }

public:
  // `is_between` tells of each face whether it may be between the sides of a cut.
  Cells(const Surface& surface, const std::vector<char>& is_between)
    : cell_(surface.number_of_faces(), null_index)
  {
    add_bands(surface, is_between);
    add_cores(surface);
    areas_.assign(number(), 0);
    for (Index f = 0; f < cell_.size(); ++f)
      areas_[cell_[f]] += surface.areas[f];
    add_arcs(surface);
  }

  std::size_t number() const { return first_face_.size(); }
  Index number_in_bands() const { return number_in_bands_; }
  bool is_core(Index cell) const { return cell >= number_in_bands_; }
  Index of_face(Index f) const { return cell_[f]; }
  Index first_face(Index cell) const { return first_face_[cell]; } // ascend in the bands
  double area(Index cell) const { return areas_[cell]; }

  // Calls visit(neighbor) for the neighbors of a cell.
  template <class Visit>
  void for_each_neighbor(Index cell, const Visit& visit) const
  {
    for (Index arc : (*arcs_)[cell])
      visit(to_[arc]);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_CELLS_H
