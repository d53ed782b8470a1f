// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_SCENE_H
#define SEGMENT_MESH_SCENE_H

#include "Polygon_soup.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace segment_mesh {

// The meshes of a file at all nodes that show them. Each polygon has the number of its node and of
// its mesh, as the polygon properties "node" and "mesh".
struct Scene
{
  mesh_file::Polygon_soup soup;
  std::vector<std::string> node_names, mesh_names; // as in the file, but without control characters
  std::vector<std::string> missing_files; // of materials and textures
};

// The limits on what a file may make the program do.
struct Reading_limits
{
  double seconds = std::numeric_limits<double>::infinity();
  std::size_t number_of_jobs = 1; // which use the memory of one machine
  bool allows_external_files = false; // files outside of its folder, which it names
  bool reads_materials = false; // and the images of materials
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_SCENE_H
