// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_MERGING_NETWORK_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_MERGING_NETWORK_H

#include <CGAL/Spectral_segmentation/internal/salience/Boundary_network.h>

namespace CGAL::Spectral_segmentation::internal {

// Gives the order in which regions are merged. It is fitted to how many people cut along the
// boundaries that merging meets, on the odd half of the Princeton Segmentation Benchmark. With the
// network that judges what cuts cost in its place, held-out errors are higher: of the benchmark by
// 0.002 to 0.004, of bodies by 0.007 to 0.010.
constexpr Boundary_network<14, 4> merging_network = {
  // means and standard deviations of the factors
    {{0.21336, 0.70022, 0.85370, -1.67707, 0.24431, 0.02623, 0.59976,
     1.00025, 0.49833, 0.63817, 0.18633, 0.56190, 0.88892, 1.30254}},
    {{0.14998, 0.25838, 0.15907, 1.12187, 0.17657, 0.03525, 0.48852,
     0.37288, 0.31335, 0.32249, 0.15165, 0.38353, 0.57472, 1.20563}},
  // the linear part
  -0.70444,
    {{0.12968, 0.61061, 0.09242, 0.15175, -0.00929, -0.14024, 0.37894,
     0.04596, 0.18135, 0.07062, -0.40865, -0.06607, 0.01838, -0.14043}},
  // the units
  {{
  {-0.78728,
    {{0.01470, -0.39033, -0.02296, 0.19011, -0.10062, -0.36581, -0.35285,
     -0.24220, -0.07869, -0.13714, 0.11078, 0.09934, -0.19449, 0.09166}},
   -0.80637},
  {1.53453,
    {{0.04754, 0.10526, 0.14616, 0.15616, 0.12465, 0.11522, -0.16393,
     0.16981, -0.25497, 0.50791, 0.14037, -0.15788, 0.10289, 0.44001}},
   0.79193},
  {-0.33294,
    {{0.36000, -0.53527, -0.08665, -0.20190, -0.06143, -0.17493, -0.50712,
     -0.06475, -0.10308, 0.00674, 0.25960, 0.03016, -0.10635, 0.31068}},
   -0.96316},
  {1.40023,
    {{-0.04596, -0.06817, -0.39054, -0.35757, 0.15635, -0.22579, 0.32006,
     -0.29442, -0.15574, -0.01911, 0.06099, 0.18247, 0.10023, 0.24117}},
   -0.82572},
  }}};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_MERGING_NETWORK_H
