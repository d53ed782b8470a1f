// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SEGMENT_BY_SDF_H
#define SEGMENTATION_BENCHMARK_SEGMENT_BY_SDF_H

#include "princeton_benchmark.h"

#include <CGAL/mesh_segmentation.h>

#include <cstddef>
#include <vector>

namespace segmentation_benchmark {

// The labels of CGAL's segmentation by shape diameter, by its defaults.
inline Labels segment_by_sdf(const Mesh& mesh)
{
  Mesh with_values(mesh);
  const auto sdf = with_values.add_property_map<Mesh::Face_index, double>("f:sdf").first;
  const auto ids = with_values.add_property_map<Mesh::Face_index, std::size_t>("f:sdf_id").first;
  CGAL::sdf_values(with_values, sdf);
  CGAL::segmentation_from_sdf_values(with_values, sdf, ids);
  return contiguous(std::vector<std::size_t>(ids.begin(), ids.end()));
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SEGMENT_BY_SDF_H
