// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_SURFACE_INTEGRALS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_SURFACE_INTEGRALS_H

#include <CGAL/Spectral_segmentation/internal/mesh/Face_graph.h>
#include <CGAL/Spectral_segmentation/internal/utility/concurrency.h>

#include <numeric>

namespace CGAL::Spectral_segmentation::internal {

inline double total_area(const Face_graph& graph)
{ return std::accumulate(graph.areas.begin(), graph.areas.end(), 0.); }

// Returns the mean of a function of the points of the surface, taken at the centroids of the faces.
// `area` is the area of the graph, and not 0.
template <class Value, class Function>
Value mean_over_surface(Execution execution, const Face_graph& graph, double area,
                        const Function& of_point)
{
  return sum_of(execution, graph.number_of_faces(), Value(), [&](std::size_t f)
    { return Value(graph.areas[f] / area * of_point(graph.centroid(static_cast<Index>(f)))); });
}

inline Vector center_of(Execution execution, const Face_graph& graph, double area)
{ return mean_over_surface<Vector>(execution, graph, area, [](const Vector& p) { return p; }); }

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MESH_SURFACE_INTEGRALS_H
