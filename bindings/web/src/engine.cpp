// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiles the engine, like the CMake target Spectral_segmentation::compiled.
#include <CGAL/Spectral_segmentation/compiled.h>
