// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SURFACE_INTEGRALS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SURFACE_INTEGRALS_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>

namespace CGAL::Spectral_segmentation::internal {

// Returns the mean of a function of the points of the surface, taken at the centroids of the faces.
// `area` is the area of the graph, and not 0.
template <class Value, class Function>
Value mean_over_surface(Execution execution, const Surface& graph, double area,
                        const Function& of_point)
{
  return sum_of(execution, graph.number_of_faces(), Value(), [&](std::size_t f)
    { return Value(graph.areas[f] / area * of_point(graph.centroid(static_cast<Index>(f)))); });
}

inline Vector center_of(Execution execution, const Surface& graph, double area)
{ return mean_over_surface<Vector>(execution, graph, area, [](const Vector& p) { return p; }); }

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SURFACE_INTEGRALS_H
