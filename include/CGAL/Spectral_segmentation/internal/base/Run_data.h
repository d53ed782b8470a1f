// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_DATA_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_DATA_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

typedef std::array<Index, 2> Face_pair;

// The constraints of the caller, in terms of the indices of the caller's faces. A constraint on an
// edge is stored as its two faces.
struct Constraints
{
  std::vector<Face_pair> cannot_link; // the two faces belong to different segments
  std::vector<Face_pair> must_link;   // the two faces belong to the same segment
  std::vector<std::pair<Index, std::int64_t> > seeds; // faces ascend, seeds are not negative

  bool empty() const { return cannot_link.empty() && must_link.empty() && seeds.empty(); }
};

// The feature vectors of the caller's faces. They are read one by one, so that no copy of all is
// needed.
struct Feature_source
{
  std::size_t dimension = 0; // 0: there are no features
  std::function<void(Index face, double* vector)> read;
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_DATA_H
