// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_BAND_CELLS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_BAND_CELLS_H

#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/base/Packed_graph.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The cells of a mesh that cuts divide: the faces of the bands, and after them the cores. The bands
// are the faces that may be between the sides of any cut, and the faces next to these. A core is a
// connected component beyond the bands, which no cut divides.
class Band_cells
{
  std::vector<Index> faces_of_bands_;
  std::vector<Index> cell_;       // the cell of each face
  std::vector<Index> first_face_; // one per cell
  std::vector<double> areas_;     // one per cell
  std::optional<Packed_graph> graph_;

  void find_bands(const Surface& mesh, const std::vector<char>& is_between)
  {
    cell_.assign(mesh.number_of_faces(), null_index);
    for (Index f = 0; f < mesh.number_of_faces(); ++f) {
      bool is_needed = is_between[f];
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        is_needed = is_needed || is_between[mesh.neighbor(h)];
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
  // Makes the cells; `is_between` says whether each face may be between the sides of a cut.
  Band_cells(const Surface& mesh, const std::vector<char>& is_between)
  {
    find_bands(mesh, is_between);
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
    std::vector<Index> place;
    graph_.emplace(number(), arcs, place);
  }

  std::size_t number() const { return first_face_.size(); }
  const std::vector<Index>& faces_of_bands() const { return faces_of_bands_; } // ascending
  bool is_core(Index cell) const { return cell >= faces_of_bands_.size(); }
  Index of_face(Index f) const { return cell_[f]; }
  Index first_face(Index cell) const { return first_face_[cell]; }
  double area(Index cell) const { return areas_[cell]; }

  Iterator_range<const Index*> neighbors(Index cell) const
  {
    const Index* targets = graph_->targets.data();
    return make_range(targets + graph_->first_arc[cell], targets + graph_->first_arc[cell + 1]);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_BAND_CELLS_H
