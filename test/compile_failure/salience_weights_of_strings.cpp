// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Expected: salience_weights takes three numbers: alpha, beta, gamma

#include <CGAL/Spectral_segmentation/parameters.h>

namespace params = CGAL::Spectral_segmentation::parameters;

auto pack = params::salience_weights("0.1", "0.6", "0.3");
