// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_LEAF_CUTTER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_LEAF_CUTTER_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Nested_ranges.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Cuts leaves of a hierarchy further. The cuts get a salience that is no larger than that of any
// cut.
class Leaf_cutter
{
  const Surface& mesh_;
  Cut_hierarchy& cuts_;
  Nested_ranges faces_; // of each node
  double salience_ = 0;

public:
  Leaf_cutter(const Surface& mesh, Cut_hierarchy& cuts)
    : mesh_(mesh), cuts_(cuts), faces_(cuts, cuts.leaf)
  {
    for (const Cut_node& n : cuts.nodes)
      if (!n.is_leaf())
        salience_ = (std::min)(salience_, n.salience);
  }

  std::vector<Index> faces(std::size_t leaf) const
  { return std::vector<Index>(faces_[leaf].begin(), faces_[leaf].end()); }

  std::size_t number_of_faces(std::size_t leaf) const { return faces_.size(leaf); }
  Index first_face(std::size_t leaf) const { return *faces_[leaf].begin(); }

  // Cuts a leaf, whose faces have these sides.
  void cut(std::size_t leaf, Sides side)
  {
    double area[2] = {0, 0};
    std::size_t i = 0;
    for (Index f : faces_[leaf])
      area[0] += side[i++] == 0 ? mesh_.areas[f] : 0;
    area[1] = (std::max)(cuts_.nodes[leaf].area - area[0], 0.);
    normalize_sides(side, area);
    cuts_.cut(leaf, area[0], area[1]);
    faces_.cut(leaf, side);
    Cut_node& n = cuts_.nodes[leaf];
    n.cut_state = Cut_state::CUT;
    n.salience = salience_;
    cuts_.cut_order.push_back(leaf);
    for (std::size_t child : n.children) {
      cuts_.nodes[child].cut_state = Cut_state::NO_CUT;
      for (Index f : faces_[child])
        cuts_.leaf[f] = static_cast<Index>(child);
    }
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_LEAF_CUTTER_H
