// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_TRANSFERRED_LABELS_H
#define SEGMENT_MESH_TRANSFERRED_LABELS_H

#include "closed_soup.h"

#include <CGAL/Segmented_mesh/transfer_segments.h>

#include <vector>

namespace segment_mesh {

// Returns the label of each triangle of another mesh, from those of the triangles of a mesh.
inline std::vector<Index> transferred_labels(const Input& from, const std::vector<Index>& labels,
                                             const Input& to)
{
  const auto add_ids = [](Mesh& mesh)
  { return mesh.add_property_map<Mesh::Face_index, Index>("f:segment").first; };
  Mesh from_mesh = mesh_of(from), to_mesh = mesh_of(to);
  const auto from_ids = add_ids(from_mesh), to_ids = add_ids(to_mesh);
  for (Mesh::Face_index f : from_mesh.faces())
    from_ids[f] = labels[f];
  CGAL::transfer_segments(from_mesh, from_ids, to_mesh, to_ids);
  return {to_ids.begin(), to_ids.end()};
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_TRANSFERRED_LABELS_H
