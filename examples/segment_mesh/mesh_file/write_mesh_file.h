// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_WRITE_MESH_FILE_H
#define SEGMENT_MESH_MESH_FILE_WRITE_MESH_FILE_H

#include "Segmented_mesh.h"
#include "Text_scanner.h"
#include "write_glb.h"
#include "write_obj.h"
#include "write_off.h"
#include "write_ply.h"
#include "write_stl.h"

#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>

namespace mesh_file {

// In lower case.
inline std::string output_extension(const std::filesystem::path& name)
{ return lower_case(name.extension().string()); }

// STL has no segments, so it serves for parts only, which are meshes of one segment.
inline void check_output_format(const std::filesystem::path& name, bool is_part)
{
  const std::string extension = output_extension(name);
  for (const char* known : {".ply", ".obj", ".off", ".glb"})
    if (extension == known)
      return;
  if (is_part && extension == ".stl")
    return;
  throw std::runtime_error("cannot write " + name.string() + ": the name must end in .ply, .obj, " +
                           (is_part ? ".off, .glb or .stl" : ".off or .glb"));
}

// The file for `write_mtl()` that goes with a file of OBJ.
inline std::filesystem::path name_of_materials(std::filesystem::path name)
{ return name.replace_extension(".mtl"); }

// Writes a mesh in the format of an extension that `output_extension()` gave and
// `check_output_format()` let pass. `materials` is the name of their file for OBJ, if there is one.
inline void write_mesh_file(std::ostream& out, const std::string& extension,
                            const Segmented_mesh& mesh, const std::string& materials = "")
{
  if (extension == ".obj")
    write_obj(out, mesh, materials);
  else if (extension == ".off")
    write_off(out, mesh);
  else if (extension == ".glb")
    write_glb(out, mesh);
  else if (extension == ".stl")
    write_stl(out, mesh);
  else
    write_ply(out, mesh);
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_WRITE_MESH_FILE_H
