// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Expected: number_of_regions takes an integer

#include <CGAL/Spectral_segmentation/parameters.h>

namespace params = CGAL::Spectral_segmentation::parameters;

auto pack = params::number_of_regions(0.5);
