// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_KEEPER_H
#define CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_KEEPER_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/refinement/Boundary_band.h>
#include <CGAL/Segmented_mesh/internal/refinement/Boundary_curves.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Keeps segments from vanishing and from falling apart, by freezing the faces of segments that
// would.
class Segment_keeper
{
  static constexpr double smallest_rest = 0.5; // the fraction of the area of a segment

  const Surface& graph_;
  const std::vector<Index>& labels_; // one per face
  const Boundary_band& band_;
  std::vector<double> areas_;        // the area of each segment before
  std::vector<std::size_t> numbers_; // the number of components of each segment before

  // Counts the components of each segment, by the labels of the halves of the edges of faces.
  template <class Label>
  std::vector<std::size_t> numbers_of_components(const Label& label) const
  {
    // The part of a face with one label has the index of a corner in it.
    const auto part = [&](Index f, Index l) {
      Index half = 0;
      while (label(3 * f + half / 2, half % 2) != l)
        ++half;
      return 3 * f + (half + 1) / 2 % 3;
    };
    Face_components components(graph_.number_of_halfedges());
    std::vector<Index> label_of_part(graph_.number_of_halfedges(), null_index);
    for (Index h = 0; h < graph_.number_of_halfedges(); ++h)
      for (int half : {0, 1}) {
        const Index l = label(h, half);
        Index& of_part = label_of_part[part(h / 3, l)];
        if (of_part == null_index)
          components.add(part(h / 3, l));
        of_part = l;
      }
    for (Index h = 0; h < graph_.number_of_halfedges(); ++h) {
      if (h / 3 >= graph_.neighbor(h))
        continue;
      const Index o = graph_.opposite[h];
      for (int half : {0, 1}) {
        const Index l = label(h, half);
        if (l == label(o, 1 - half))
          components.join(part(h / 3, l), part(o / 3, l));
      }
    }
    std::vector<std::size_t> numbers(areas_.size(), 0);
    for (Index p = 0; p < label_of_part.size(); ++p)
      if (label_of_part[p] != null_index)
        numbers[label_of_part[p]] += components.representative(p) == p;
    return numbers;
  }

  std::vector<double> areas(const Boundary_curves& curves) const
  {
    std::vector<double> result = areas_;
    for (Index f : band_.faces) {
      result[labels_[f]] -= graph_.areas[f];
      // The boundaries in the face meet in its apex.
      const auto apex = curves.apex(f);
      for (Index i = 0; i < 3; ++i) {
        const Index h = 3 * f + i;
        const double area = apex[(i + 2) % 3] * graph_.areas[f], t = curves.position(h);
        result[curves.label(h, 0)] += t * area;
        result[curves.label(h, 1)] += (1 - t) * area;
      }
    }
    return result;
  }

public:
  Segment_keeper(const Surface& graph, const std::vector<Index>& labels,
                 std::size_t number_of_segments, const Boundary_band& band)
    : graph_(graph), labels_(labels), band_(band), areas_(number_of_segments, 0)
  {
    for (Index f = 0; f < graph.number_of_faces(); ++f)
      areas_[labels[f]] += graph.areas[f];
    numbers_ = numbers_of_components([&](Index h, int) { return labels[h / 3]; });
  }

  // Freezes faces until no segment is bad. At worst all faces are frozen.
  void operator()(Boundary_curves& curves) const
  {
    const auto label = [&](Index h, int half) { return curves.label(h, half); };
    for (;;) {
      const std::vector<double> new_areas = areas(curves);
      const std::vector<std::size_t> new_numbers = numbers_of_components(label);
      std::vector<char> is_bad(areas_.size(), 0);
      for (std::size_t s = 0; s < is_bad.size(); ++s)
        is_bad[s] = new_areas[s] < smallest_rest * areas_[s] || new_numbers[s] == 0 ||
                    new_numbers[s] > numbers_[s];
      if (std::find(is_bad.begin(), is_bad.end(), 1) == is_bad.end())
        return;
      for (Index f : band_.faces) {
        bool is_to_freeze = is_bad[labels_[f]];
        for (Index half = 0; half < 6; ++half)
          is_to_freeze |= is_bad[label(3 * f + half / 2, half % 2)] != 0;
        if (is_to_freeze)
          curves.freeze(f);
      }
    }
  }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_KEEPER_H
