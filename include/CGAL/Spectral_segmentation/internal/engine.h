// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ENGINE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ENGINE_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_data.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>

#include <cstddef>
#include <utility>

// The engine is linked if CGAL_SPECTRAL_SEGMENTATION_COMPILED is defined, which the CMake target
// `compiled` does, and one file includes compiled.h; otherwise it is included here.
#ifdef CGAL_SPECTRAL_SEGMENTATION_COMPILED
#define CGAL_SPECTRAL_SEGMENTATION_INLINE
#else
#define CGAL_SPECTRAL_SEGMENTATION_INLINE inline
#endif

namespace CGAL::Spectral_segmentation::internal {

// Runs the engine, which is no template because nothing in it depends on the caller. It takes
// arrays and returns a hierarchy of cuts, whose faces are the triangles. Only ablations and
// pictures change the constants of the method. Throws `std::invalid_argument` if constraints
// contradict each other or the number of segments.
CGAL_SPECTRAL_SEGMENTATION_INLINE
Cut_hierarchy segment(Surface surface, const Options& options, const Method_constants& method,
                      Execution execution, Run_control& control, const Constraints& constraints,
                      const Feature_source& features);

// Returns the cuts of a run with the maximum number of segments and the threshold that select them.
inline Segmentation_hierarchy with_selection(Cut_hierarchy cuts, const Options& options)
{
  const std::size_t maximum =
    has_default_end(options) ? cuts.number_of_segments() : maximum_number(options);
  return {std::move(cuts), maximum, threshold_of(options)};
}

// Runs the engine.
inline Segmentation_hierarchy
segmentation_hierarchy(Surface triangles, const Options& options, Execution execution,
                       Run_control& control, const Constraints& constraints = Constraints(),
                       const Feature_source& features = Feature_source())
{
  return with_selection(segment(std::move(triangles), options, constants_of(options.method),
                                execution, control, constraints, features), options);
}

// Makes a surface of the triangles of a soup: finds their neighbors, orients them, and separates
// what meets at a point only.
CGAL_SPECTRAL_SEGMENTATION_INLINE
void connect(Surface& soup);

} // namespace CGAL::Spectral_segmentation::internal

#ifndef CGAL_SPECTRAL_SEGMENTATION_COMPILED
#include <CGAL/Spectral_segmentation/internal/run.h>
#endif

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ENGINE_H
