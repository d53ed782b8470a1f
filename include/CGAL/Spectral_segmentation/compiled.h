// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_COMPILED_H
#define CGAL_SPECTRAL_SEGMENTATION_COMPILED_H

/// \file
/// Compiles the engine once, for programs that are built without the CMake target
/// `Spectral_segmentation::compiled`, which does the same. One file of the program includes this
/// header, and all files are compiled with `-DCGAL_SPECTRAL_SEGMENTATION_COMPILED`. With
/// `-ffp-contract=off` for this file the labels do not depend on whether the processor has fused
/// multiplications.

#ifndef CGAL_SPECTRAL_SEGMENTATION_COMPILED
#error "All files of a program with a compiled engine need -DCGAL_SPECTRAL_SEGMENTATION_COMPILED"
#endif

#include <CGAL/Spectral_segmentation/internal/run.h>

#endif // CGAL_SPECTRAL_SEGMENTATION_COMPILED_H
