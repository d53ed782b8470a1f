// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Expected: this pack holds a CGAL named parameter that the package does not use

#include <CGAL/Spectral_segmentation/parameters.h>

namespace params = CGAL::Spectral_segmentation::parameters;

auto pack = params::from(CGAL::parameters::number_of_iterations(3));
