// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_READ_MESH_FILE_H
#define SEGMENT_MESH_MESH_FILE_READ_MESH_FILE_H

#include "Polygon_soup.h"
#include "Text_scanner.h"
#include "read_obj.h"
#include "read_off.h"
#include "read_ply.h"
#include "read_stl.h"

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

// For what has no name. OBJ has no mark of its own.
inline Format format_of_contents(std::string_view file)
{
  Text_scanner text(file);
  text.skip_space();
  const std::string_view word = text.peek_word();
  return lower_case(word) == "ply" ? Format::PLY : Off_header().parse(word) ? Format::OFF :
         is_stl(file) ? Format::STL : Format::OBJ;
}

// Reads the contents of a file. Properties besides points and polygons are kept on demand. Throws
// `std::runtime_error` with the line or byte and the word at fault if the contents contradict the
// format. Asks for no more memory than a small multiple of the size of the file. Points that no
// polygon uses need not be finite.
inline Polygon_soup read_mesh_file(std::string_view file, Format format, bool keeps_properties)
{
  Polygon_soup result;
  switch (format) {
    case Format::OFF: result = read_off(file); break;
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
