// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_INDEX_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_INDEX_H

#include <cmath>
#include <cstdint>

namespace CGAL::Spectral_segmentation::internal {

// The index of a face (f, g), a halfedge (h), a vertex (v), or another element that the name says.
typedef std::uint32_t Index;
constexpr Index null_index = static_cast<Index>(-1);

// Numbers that decide are rounded to multiples of 2^-20. Sums of such numbers are exact as doubles.
// Therefore the length of a path does not depend on the order of its sum, and numbers that are
// equal on paper are equal in the machine.
constexpr double quantum = 1. / (1 << 20);
inline double quantized(double x) { return std::floor(x / quantum + 0.5) * quantum; }

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_INDEX_H
