// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WISHES_WISHES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WISHES_WISHES_H

#include <CGAL/Spectral_segmentation/internal/utility/Index.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

typedef std::array<Index, 2> Face_pair;

// What the caller wishes of the segments, by the numbers that he gives the faces. An edge is named
// by its two faces, as a wish for an edge is one for these.
struct Wishes
{
  std::vector<Face_pair> seams;      // whose faces are of different segments
  std::vector<Face_pair> uncuttable; // whose faces are of one segment
  std::vector<std::pair<Index, std::int64_t> > seeds; // of faces, which ascend; not negative

  bool empty() const { return seams.empty() && uncuttable.empty() && seeds.empty(); }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WISHES_WISHES_H
