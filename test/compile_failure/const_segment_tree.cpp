// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Expected: segment_tree takes a CGAL::Spectral_segmentation::Segment_tree, not const

#include <CGAL/Spectral_segmentation/parameters.h>

namespace params = CGAL::Spectral_segmentation::parameters;

auto pack(const CGAL::Spectral_segmentation::Segment_tree& tree)
{ return params::segment_tree(tree); }
