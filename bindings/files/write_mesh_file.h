// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_WRITE_MESH_FILE_H
#define SEGMENT_MESH_MESH_FILE_WRITE_MESH_FILE_H

#include "Segmented_soup.h"
#include "Text_scanner.h"
#include "write_glb.h"
#include "write_obj.h"
#include "write_off.h"
#include "write_ply.h"
#include "write_stl.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace mesh_file {

// Returns the extension of a name in lower case.
inline std::string output_extension(const std::filesystem::path& name)
{ return lower_case(name.extension().string()); }

// Throws if the name ends in no extension that can be written. STL has no segments: it is only for
// parts, which are meshes of one segment. `further` is an extension that the caller writes by other
// means, or empty.
inline void check_output_format(const std::filesystem::path& name, bool is_part,
                                const std::string& further = "")
{
  std::vector<std::string> known = {".ply", ".obj", ".off", ".glb"};
  if (is_part)
    known.push_back(".stl");
  if (!further.empty())
    known.push_back(further);
  if (std::find(known.begin(), known.end(), output_extension(name)) != known.end())
    return;
  std::string list = known[0];
  for (std::size_t i = 1; i < known.size(); ++i)
    list += (i + 1 < known.size() ? ", " : " or ") + known[i];
  throw std::runtime_error("cannot write " + name.string() + ": the name must end in " + list);
}

// Returns the name of the file of materials that belongs to a file of OBJ.
inline std::filesystem::path name_of_materials(std::filesystem::path name)
{ return name.replace_extension(".mtl"); }

// Writes a mesh in the format of an extension that `output_extension()` returned and
// `check_output_format()` accepted. `materials` is the name of their file for OBJ, if there is one.
inline void write_mesh_file(std::ostream& out, const std::string& extension,
                            const Segmented_soup& mesh, const std::string& materials = "")
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
