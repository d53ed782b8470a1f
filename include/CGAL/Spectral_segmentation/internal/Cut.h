// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_H

#include <CGAL/Spectral_segmentation/Part_salience.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The side of each face: 0 for Q, of smaller area, 1 for the rest.
typedef std::vector<char> Sides;

// A two-way cut of a part.
struct Cut
{
  Sides side;
  double area[2];
  Salience_factors factors;
  double salience;
};

inline void put_smaller_side_first(Sides& side, double (&area)[2])
{
  if (area[0] <= area[1])
    return;
  for (char& s : side)
    s = 1 - s;
  std::swap(area[0], area[1]);
}

// Hears of cuts, and does nothing.
struct No_observer
{
  template <class... Arguments>
  void operator()(const Arguments&...) const {}
};

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_H
