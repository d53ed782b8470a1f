// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SEGMENT_BY_SDF_H
#define SEGMENTATION_BENCHMARK_SEGMENT_BY_SDF_H

#include "princeton_benchmark.h"

#include <CGAL/mesh_segmentation.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace segmentation_benchmark {

// The labels of CGAL's segmentation by shape diameter, by its defaults.
inline Labels segment_by_sdf(const Mesh& mesh)
{
  std::vector<double> values(mesh.number_of_faces());
  std::vector<std::size_t> ids(values.size());
  const auto index = get(CGAL::face_index, mesh);
  const auto value_map = boost::make_iterator_property_map(values.begin(), index);
  CGAL::sdf_values(mesh, value_map);
  CGAL::segmentation_from_sdf_values(mesh, value_map,
                                     boost::make_iterator_property_map(ids.begin(), index));
  return contiguous(ids);
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SEGMENT_BY_SDF_H
