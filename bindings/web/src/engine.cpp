// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The engine, as the CMake target Spectral_segmentation::compiled has it.
#include <CGAL/Spectral_segmentation/compiled.h>
