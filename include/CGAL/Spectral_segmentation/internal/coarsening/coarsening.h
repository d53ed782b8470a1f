// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSENING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSENING_H

#include <CGAL/Spectral_segmentation/internal/coarsening/Edge_collapse.h>

#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Coarsens a mesh to at most `number_of_faces` faces, if the topology allows it. If more will do,
// the faces at the seams of domains may be left as well. `progress_per_face` is the fraction of the
// phase for each removed face.
inline Coarse_mesh coarsen(Execution execution, const Surface& mesh,
                           std::size_t number_of_faces, bool more_will_do, Run_monitor& monitor,
                           double progress_per_face)
{
  Edge_collapse collapse(execution, mesh, monitor, progress_per_face);
  collapse.collapse_edges(number_of_faces, more_will_do);
  return collapse.result();
}

// Returns coarser and coarser meshes, the first of the mesh, each other one of the mesh before.
// Each step leaves about a sixteenth of the faces, so that the bands between the sides of cuts stay
// small parts of each mesh. The bands are as wide as the larger faces.
inline std::vector<Coarse_mesh> coarsen_in_steps(Execution execution, const Surface& mesh,
                                                 std::size_t number_of_faces,
                                                 Run_monitor& monitor)
{
  constexpr std::size_t step = 16;
  std::vector<std::size_t> numbers(1, number_of_faces);
  while (numbers.back() < mesh.number_of_faces() / (2 * step))
    numbers.push_back(step * numbers.back());
  const double progress_per_face =
    1 / static_cast<double>(mesh.number_of_faces() - number_of_faces);
  std::vector<Coarse_mesh> result;
  for (; !numbers.empty(); numbers.pop_back())
    result.push_back(coarsen(execution, result.empty() ? mesh : result.back().graph,
                             numbers.back(), numbers.size() > 1, monitor, progress_per_face));
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_COARSENING_H
