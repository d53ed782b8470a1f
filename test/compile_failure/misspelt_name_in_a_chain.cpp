// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Expected: did you mean 'salience_threshold'

#include <CGAL/Spectral_segmentation/parameters.h>

namespace params = CGAL::Spectral_segmentation::parameters;

auto pack = params::random_seed(1).salience_treshold(0.3);
