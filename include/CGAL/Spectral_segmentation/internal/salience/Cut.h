// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

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

// Makes side 0 the side of smaller area.
inline void normalize_sides(Sides& side, double (&area)[2])
{
  if (area[0] <= area[1])
    return;
  for (char& s : side)
    s = 1 - s;
  std::swap(area[0], area[1]);
}

// Returns the salience. NaN counts as the least, because saliences are compared.
template <class PartSalience>
double salience_of(const PartSalience& part_salience, const Salience_factors& factors)
{
  const double salience = part_salience(factors);
  return std::isnan(salience) ? -std::numeric_limits<double>::infinity() : salience;
}

// A cut whose factors were computed: a candidate for the best cut of a part, or the boundary of two
// regions as the cut of their union.
struct Evaluated_cut
{
  enum Kind { CANDIDATE, BOUNDARY };

  Kind kind;
  const std::vector<Index>& faces; // the faces of the part, by their indices in the mesh
  const Sides& side;               // one per face
  const Salience_factors& factors;
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_H
