// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_SEGMENTATION_HIERARCHY_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_SEGMENTATION_HIERARCHY_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/engine.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/numbers_to_search.h>

#include <utility>

namespace CGAL::Spectral_segmentation::internal {

// Runs the engine. Returns its cuts with the maximum number of segments and the threshold that
// select them.
inline Segmentation_hierarchy
segmentation_hierarchy(Surface triangles, const Options& options, Execution execution,
                       Run_control& control, const Constraints& constraints = Constraints(),
                       const Feature_source& features = Feature_source())
{
  return {segment(std::move(triangles), options, execution, control, constraints, features),
          maximum_number(options), threshold(options)};
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_SEGMENTATION_HIERARCHY_H
