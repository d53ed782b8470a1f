// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_READ_STL_H
#define SEGMENT_MESH_MESH_FILE_READ_STL_H

#include "Byte_scanner.h"
#include "Point_numbering.h"
#include "Polygon_soup.h"
#include "Text_scanner.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace mesh_file {

// Reads the format of stereolithography, text and binary. A triangle has coordinates, and corners
// at the same place become one point.
class Stl_reader
{
  static constexpr std::size_t size_of_header = 84; // 80 bytes of anything and the number of faces
  static constexpr std::size_t size_of_face = 50;   // normal, three corners, two bytes of anything

  std::string_view file_;
  Polygon_soup soup_;
  Point_numbering number_{soup_.points};

  static std::uint32_t number_of_faces(std::string_view file)
  { return Byte_scanner(file, 80, false).number<std::uint32_t>(); }

  // Returns whether the file is binary. Its size decides, because binary files may begin with
  // "solid", too. In a text the bytes of the number are characters, which would be a number of
  // faces larger than the file. If the number is wrong, a zero before the end of the first face
  // decides, unless it fills up a text.
  bool is_binary() const
  {
    if (file_.size() < size_of_header)
      return false;
    Text_scanner text(file_);
    text.remove_padding();
    const std::size_t size =
      std::clamp(text.all().size(), size_of_header, size_of_header + size_of_face);
    return number_of_faces(file_) == (file_.size() - size_of_header) / size_of_face ||
           file_.substr(0, size).find('\0') != std::string_view::npos;
  }

  void read_binary()
  {
    Byte_scanner bytes(file_, size_of_header, false);
    const std::size_t faces = number_of_faces(file_), room = bytes.remaining() / size_of_face;
    const std::string sizes = "its size fits " + std::to_string(room) +
                              " faces, but its header says " + std::to_string(faces);
    if (faces > room)
      Byte_scanner::fail(80, sizes);
    soup_.coordinate_type = Number_type::FLOAT32;
    soup_.corners.reserve(3 * faces);
    soup_.first_corner.reserve(faces + 1);
    for (std::size_t i = 0; i < faces; ++i) {
      bytes.skip(12, "a normal");
      for (int k = 0; k < 3; ++k)
        soup_.corners.push_back(number_(bytes.point<float>()));
      soup_.end_polygon();
      bytes.skip(2, "the end of a face");
    }
    bytes.finish(faces == room ? "the last face" : "the last face: " + sizes);
  }

  static void expect(Text_scanner& text, const char* keyword)
  {
    text.skip_space();
    if (lower_case(text.peek_word()) != keyword)
      text.fail(std::string("'") + keyword + "'");
    text.skip_word();
  }

  void read_facet(Text_scanner& text)
  {
    expect(text, "normal");
    // Some programs write normals that are not a number, such as -1.#IND.
    for (int i = 0; i < 3 && (text.skip_space(), lower_case(text.peek_word()) != "outer"); ++i)
      text.skip_word();
    expect(text, "outer");
    expect(text, "loop");
    while (text.skip_space(), lower_case(text.peek_word()) == "vertex") {
      text.skip_word();
      const double x = text.number();
      const double y = text.number();
      soup_.corners.push_back(number_({x, y, text.number()}));
    }
    if (soup_.corners.size() < soup_.first_corner.back() + 3)
      text.fail("'vertex'");
    expect(text, "endloop");
    expect(text, "endfacet");
    soup_.end_polygon();
  }

  // Skips the name of a solid, which may be any words.
  static void skip_name(Text_scanner& text)
  {
    const Text_scanner where = text;
    if (lower_case(text.rest_of_line()).find("endfacet") != std::string::npos)
      where.fail_with("faces follow the name of the solid on its line");
  }

  // Reads one solid after the other, of which the last may have no end. Skips words between the
  // faces, such as colors, with a warning.
  void read_text()
  {
    Text_scanner text(file_);
    text.remove_padding();
    expect(text, "solid");
    skip_name(text);
    bool has_end = false;
    while (!text.is_at_end()) {
      const std::string word = lower_case(text.peek_word());
      if (word == "normal" || word == "vertex")
        text.fail("'facet' or 'endsolid'");
      const bool is_known = word == "facet" || word == "solid" || word == "endsolid";
      if (!is_known && soup_.warnings.empty())
        soup_.warnings.push_back(text.contradiction("'facet' or 'endsolid'"));
      text.skip_word();
      if (word == "facet")
        read_facet(text);
      else if (is_known) {
        skip_name(text);
        has_end = word == "endsolid";
      }
    }
    if (!has_end)
      soup_.warnings.push_back(text.contradiction("'endsolid'"));
    if (soup_.number_of_polygons() == 0 && !soup_.warnings.empty())
      throw std::runtime_error(soup_.warnings[0]);
  }

public:
  explicit Stl_reader(std::string_view file) : file_(file) {}

  // Returns whether the contents look like STL.
  bool is_stl() const
  {
    Text_scanner text(file_);
    text.skip_space();
    return is_binary() || lower_case(text.peek_word()) == "solid";
  }

  Polygon_soup operator()()
  {
    if (is_binary())
      read_binary();
    else
      read_text();
    return std::move(soup_);
  }
};

inline bool is_stl(std::string_view file) { return Stl_reader(file).is_stl(); }

inline Polygon_soup read_stl(std::string_view file)
{ return Stl_reader(file)(); }

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_READ_STL_H
