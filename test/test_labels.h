// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_LABELS_H
#define SPECTRAL_SEGMENTATION_TEST_LABELS_H

#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

// Labels of the faces of a mesh, by the index of the face.
namespace test_meshes {

typedef std::vector<std::size_t> Labels;

inline auto map_to(Labels& labels, const Mesh& mesh)
{
  labels.resize(num_faces(mesh));
  return boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh));
}

inline std::size_t number_of_connected_pieces(const Mesh& mesh, const Labels& labels)
{
  const auto is_between_segments = [&](Mesh::Edge_index e) {
    const Mesh::Halfedge_index h = halfedge(e, mesh);
    return is_border(e, mesh) ||
           labels[face(h, mesh)] != labels[face(opposite(h, mesh), mesh)];
  };
  Labels pieces;
  return CGAL::Polygon_mesh_processing::connected_components(
    mesh, map_to(pieces, mesh),
    CGAL::parameters::edge_is_constrained_map(
      boost::make_function_property_map<Mesh::Edge_index, bool>(is_between_segments)));
}

} // namespace test_meshes

#endif // SPECTRAL_SEGMENTATION_TEST_LABELS_H
