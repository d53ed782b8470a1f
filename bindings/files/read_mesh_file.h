// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_READ_MESH_FILE_H
#define SEGMENT_MESH_MESH_FILE_READ_MESH_FILE_H

#include "Byte_scanner.h"
#include "Polygon_soup.h"
#include "Text_scanner.h"
#include "read_obj.h"
#include "read_off.h"
#include "read_ply.h"
#include "read_stl.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mesh_file {

enum class Format { OFF, OBJ, PLY, STL, UNKNOWN };

inline Format format_of_extension(const std::string& extension)
{
  const std::string name = lower_case(extension);
  return name == ".off" ? Format::OFF :
         name == ".obj" ? Format::OBJ :
         name == ".ply" ? Format::PLY :
         name == ".stl" ? Format::STL : Format::UNKNOWN;
}

// Returns the format of which the contents have a mark, or that of binary STL if the size is right
// to the byte; else UNKNOWN. OBJ has no mark but its first statement.
inline Format marked_format(std::string_view file)
{
  const std::size_t header = 84, face = 50; // of binary STL, which may begin with any word
  if (file.size() >= header && (file.size() - header) % face == 0 &&
      Byte_scanner(file, 80, false).number<std::uint32_t>() == (file.size() - header) / face)
    return Format::STL;
  Text_scanner text(file);
  text.skip_space();
  const std::string_view word = text.peek_word();
  return lower_case(word) == "ply" ? Format::PLY :
         Off_header().parse(word) ? Format::OFF :
         lower_case(word) == "solid" ? Format::STL :
         word == "v" || word == "o" || word == "g" || word == "mtllib" ? Format::OBJ :
         Format::UNKNOWN;
}

// Returns the format of contents without a name.
inline Format format_of_contents(std::string_view file)
{
  const Format marked = marked_format(file);
  return marked != Format::UNKNOWN ? marked : is_stl(file) ? Format::STL : Format::OBJ;
}

// Returns what else a file is, and what helps: for files that no program reads as they are, and on
// demand for formats that libraries read by the name of the file. Returns an empty text if nothing
// is known.
inline std::string other_contents(std::string_view file, bool tells_formats_of_libraries)
{
  const char* const cad = "export a mesh, such as STL";
  const char* const vtk =
    "ParaView, or the command pyvista convert IN.vtp OUT.ply, makes PLY of it";
  const struct { std::string_view begin; const char *what, *remedy; } known[] = {
    {"version https://git-lfs", "a Git LFS pointer", "git lfs pull fetches the file"},
    {"\x1F\x8B", "compressed by gzip", "unpack it"}, {"pk\3\4", "a ZIP archive", "unpack it"},
    {"<!doctype html", "an HTML page", "download the mesh itself"},
    {"<html", "an HTML page", "download the mesh itself"},
    {"iso-10303-21", "CAD in STEP", cad}, {"dbrep_drawableshape", "CAD in BREP", cad},
    {"**abcdefghij", "CAD in Parasolid", cad}, {"\xD0\xCF\x11\xE0", "a document, as of CAD", cad},
    {"meshversionformatted", "Medit", "the command meshio convert IN.mesh OUT.ply makes PLY of it"},
    {"$meshformat", "Gmsh", "the command meshio convert IN.msh OUT.ply makes PLY of it"},
    {"# vtk datafile", "VTK", vtk}, {"<vtkfile", "VTK", vtk},
    {"#vrml", "VRML", "MeshLab makes PLY of it"},
    {"\xFF\xFE", "UTF-16", "save it as UTF-8"}, {"\xFE\xFF", "UTF-16", "save it as UTF-8"},
    {"pk\3\4", "3MF", ".3mf"}, {"gltf", "binary glTF", ".glb"}, {"{", "JSON, as of glTF", ".gltf"},
    {"kaydara", "FBX", ".fbx"}, {"; fbx", "FBX", ".fbx"}, {"<?xml", "XML, as of Collada", ".dae"}};
  std::size_t first = (std::min)(file.find_first_not_of(" \t\r\n"), file.size());
  const std::size_t element = file.substr(first, 200).find("<VTKFile"); // after "<?xml"
  if (element != std::string_view::npos)
    first += element;
  const std::string begin = lower_case(file.substr(first, 40));
  for (const auto& k : known) {
    const bool is_of_library = k.remedy[0] == '.';
    if (begin.compare(0, k.begin.size(), k.begin) == 0 &&
        (tells_formats_of_libraries || !is_of_library) && // 3MF is an archive with models
        (k.begin[0] != 'p' || is_of_library == (file.find(".model") != std::string_view::npos)))
      return std::string("it is ") + k.what + (is_of_library ?
             ", which is read only from a file with the ending " : "; ") + k.remedy;
  }
  if (file.size() > 80 && file[72] == 'S' && file.substr(73, 7).find_first_not_of(" 0") == 6)
    return std::string("it is CAD in IGES; ") + cad;
  return "";
}

// Reads the contents of a file, of the format of their mark if they have one. Properties besides
// points and polygons are kept on demand. Throws `std::runtime_error` with the line or byte and the
// word at fault if the contents contradict the format, or with what they are instead. Asks for no
// more memory than a small multiple of the size of the file. Points that no polygon uses need not
// be finite.
inline Polygon_soup read_mesh_file(std::string_view file, Format format, bool keeps_properties)
{
  const Format marked = marked_format(file);
  const std::string other = marked == Format::UNKNOWN ? other_contents(file, true) : "";
  if (!other.empty())
    throw std::runtime_error(other);
  Polygon_soup result;
  switch (marked == Format::UNKNOWN ? format : marked) {
    case Format::OFF: result = read_off(file, keeps_properties); break;
    case Format::OBJ: result = read_obj(file, keeps_properties); break;
    case Format::PLY: result = read_ply(file, keeps_properties); break;
    case Format::STL: result = read_stl(file); break;
    default: throw std::runtime_error("the format is unknown");
  }
  remove_infinite_corners(result);
  return result;
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_READ_MESH_FILE_H
