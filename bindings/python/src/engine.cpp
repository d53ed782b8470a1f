// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The engine, for builds without CMake, whose target Spectral_segmentation::compiled is the same.
#include <CGAL/Spectral_segmentation/compiled.h>
