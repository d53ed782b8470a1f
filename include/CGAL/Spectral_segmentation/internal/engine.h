// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ENGINE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ENGINE_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Constraints.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/Dendrogram.h>

// With CGAL_SPECTRAL_SEGMENTATION_COMPILED, which the CMake target `compiled` defines, the engine
// is linked; otherwise it is included here.
#ifdef CGAL_SPECTRAL_SEGMENTATION_COMPILED
#define CGAL_SPECTRAL_SEGMENTATION_INLINE
#else
#define CGAL_SPECTRAL_SEGMENTATION_INLINE inline
#endif

namespace CGAL::Spectral_segmentation::internal {

// The engine: no template, as nothing in it depends on the caller. Takes corners, opposites and
// points; returns a dendrogram of the same faces. Throws `std::invalid_argument` if constraints
// contradict each other or the number of segments.
CGAL_SPECTRAL_SEGMENTATION_INLINE
Dendrogram segment(Surface surface, const Options& options, Execution execution,
                   Segmentation_visitor& visitor, const Constraints& constraints = Constraints());

// Finds the opposites of the half-edges of a soup, and orients its triangles.
CGAL_SPECTRAL_SEGMENTATION_INLINE
void connect(Surface& soup);

} // namespace CGAL::Spectral_segmentation::internal

#ifndef CGAL_SPECTRAL_SEGMENTATION_COMPILED
#include <CGAL/Spectral_segmentation/internal/run.h>
#endif

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ENGINE_H
