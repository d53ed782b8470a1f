// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_SEAM_SIDES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_SEAM_SIDES_H

#include <CGAL/Spectral_segmentation/internal/Wishes.h>
#include <CGAL/Spectral_segmentation/internal/mesh/Face_graph.h>
#include <CGAL/Spectral_segmentation/internal/mesh/connected_components.h>

#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The two sides of seams whose edges follow each other: at a vertex with several of them, the two
// faces between which no seam comes in are on one side. So one cut serves a whole stroke.
class Seam_sides
{
  std::vector<Index> slot_; // of each half-edge: 2 i or 2 i + 1 for the i-th seam, else null_index
  std::vector<Index> side_of_slot_;
  std::vector<std::vector<Index> > faces_; // of each side

  // From a half-edge of a seam around its target, through its face, to the next seam or border.
  Index next_at_vertex(const Face_graph& mesh, Index h) const
  {
    for (;;) {
      const Index next = h % 3 == 2 ? h - 2 : h + 1;
      if (slot_[next] != null_index || mesh.is_border(next))
        return next;
      h = mesh.opposite(next);
    }
  }

public:
  Seam_sides(const Face_graph& mesh, const std::vector<Face_pair>& seams)
    : slot_(mesh.number_of_halfedges(), null_index), faces_(2 * seams.size())
  {
    for (Index i = 0; i < seams.size(); ++i)
      for (Index k : {0, 1})
        for (Index h = 3 * seams[i][k]; h < 3 * seams[i][k] + 3; ++h)
          if (mesh.neighbors[h] == seams[i][1 - k])
            slot_[h] = 2 * i + k;
    Face_components sides(2 * seams.size());
    for (Index slot = 0; slot < 2 * seams.size(); ++slot)
      sides.add(slot);
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if (slot_[h] != null_index) {
        const Index next = next_at_vertex(mesh, h);
        if (slot_[next] != null_index && slot_[next] / 2 != slot_[h] / 2)
          sides.join(slot_[h], slot_[next]);
      }
    for (Index slot = 0; slot < 2 * seams.size(); ++slot) {
      side_of_slot_.push_back(sides.representative(slot));
      faces_[side_of_slot_.back()].push_back(seams[slot / 2][slot % 2]);
    }
  }

  bool is_seam(Index h) const { return slot_[h] != null_index; }

  // The faces on the side of the k-th face of a seam.
  const std::vector<Index>& faces(Index seam, Index k) const
  { return faces_[side_of_slot_[2 * seam + k]]; }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_SEAM_SIDES_H
