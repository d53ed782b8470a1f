// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Expected: hierarchy takes a CGAL::Spectral_segmentation::Segmentation_hierarchy, not const

#include <CGAL/Spectral_segmentation/parameters.h>

namespace params = CGAL::Spectral_segmentation::parameters;

auto pack(const CGAL::Spectral_segmentation::Segmentation_hierarchy& tree)
{ return params::hierarchy(tree); }
