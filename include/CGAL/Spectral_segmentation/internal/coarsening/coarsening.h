// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSENING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSENING_H

#include <CGAL/Spectral_segmentation/internal/coarsening/Edge_collapse.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/Vertex_clustering.h>
#include <CGAL/Spectral_segmentation/internal/surface/geometric_order.h>
#include <CGAL/Spectral_segmentation/internal/surface/reorder_faces.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the width of the cells of clusters, about half the length of the edges of an even mesh
// with this number of faces. It has few digits, so that multiples of it are exact. Wider cells
// make the surface steadier under noise, but the parts worse.
inline double width_of_cells(double area, std::size_t number_of_faces)
{ return 0.75 * std::exp2(std::floor(std::log2(area / static_cast<double>(number_of_faces)) / 2)); }

// Puts the faces of a coarse surface in their geometric order.
inline void order_by_points(Coarse_surface& coarse)
{
  const std::vector<Index> order = geometric_order(coarse.graph);
  const std::vector<Index> number = reorder_faces(coarse.graph, order);
  std::vector<Index> faces;
  for (Index f : order)
    faces.push_back(coarse.faces[f]);
  coarse.faces = std::move(faces);
  for (Index& v : coarse.vertices)
    if (v != null_index)
      v = number[v];
}

// Returns the surface itself as a coarse surface.
inline Coarse_surface not_coarsened(const Surface& mesh)
{
  Coarse_surface result{mesh, std::vector<Index>(mesh.number_of_faces()),
                        std::vector<Index>(mesh.points.size())};
  std::iota(result.faces.begin(), result.faces.end(), Index(0));
  std::iota(result.vertices.begin(), result.vertices.end(), Index(0));
  return result;
}

// Returns the surfaces on the way to at most `number_of_faces` faces, each made from the last one:
// by clusters, then by collapses of edges. If there are not more faces, the only surface has all.
// Cuts are carried back over both, so that the bands around cuts in the given surface are narrow.
// Points of the last surface are rounded to a twelfth of the cells, so that noise in the points of
// the given surface rarely gets through.
inline std::vector<Coarse_surface> coarsened(Execution execution, const Surface& mesh,
                                             std::size_t number_of_faces, Run_monitor& monitor)
{
  const double area = total_area(mesh);
  const double width = width_of_cells(area > 0 ? area : 1, number_of_faces);
  std::vector<Coarse_surface> result;
  if (mesh.number_of_faces() > number_of_faces) {
    result.push_back(Vertex_clustering(mesh, width)());
    set_areas(execution, result.back().graph);
    monitor.advance(0.5);
    monitor.check();
    Edge_collapse collapse(result.back().graph, width / 3, monitor);
    collapse.collapse_edges(number_of_faces);
    result.push_back(collapse.result());
  }
  else
    result.push_back(not_coarsened(mesh));
  order_by_points(result.back()); // before points become equal
  for (Vector& p : result.back().graph.points)
    p = rounded(p, width / 12);
  set_areas(execution, result.back().graph);
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSENING_H
