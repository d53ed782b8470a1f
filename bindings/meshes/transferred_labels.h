// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_TRANSFERRED_LABELS_H
#define SEGMENT_MESH_TRANSFERRED_LABELS_H

#include "closed_soup.h"

#include <CGAL/Segmented_mesh/transfer_segments.h>
#include <CGAL/property_map.h>

#include <boost/property_map/compose_property_map.hpp>

#include <vector>

namespace segment_mesh {

// Returns the label of each triangle of another mesh, from those of the triangles of a mesh.
inline std::vector<Index> transferred_labels(const Input& from, std::vector<Index> labels,
                                             const Input& to)
{
  std::vector<Index> result(to.triangles.size());
  const Mesh from_mesh = mesh_of(from), to_mesh = mesh_of(to);
  const auto id_map = [](const Mesh& mesh, std::vector<Index>& ids) {
    return boost::make_compose_property_map(CGAL::make_property_map(ids),
                                            get(CGAL::face_index, mesh));
  };
  CGAL::transfer_segments(from_mesh, id_map(from_mesh, labels), to_mesh, id_map(to_mesh, result));
  return result;
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_TRANSFERRED_LABELS_H
