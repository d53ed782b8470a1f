// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_POINT_H
#define RANDOM_POINT_H

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/base/Vector.h>

namespace test_meshes {

// Returns a point of the unit cube.
inline CGAL::Spectral_segmentation::internal::Vector random_point(Random& random)
{
  const double x = double(random() % 1000), y = double(random() % 1000);
  return CGAL::Spectral_segmentation::internal::Vector(x, y, double(random() % 1000)) / 1000;
}

} // namespace test_meshes

#endif // RANDOM_POINT_H
