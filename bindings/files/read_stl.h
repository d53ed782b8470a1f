// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_READ_STL_H
#define SEGMENT_MESH_MESH_FILE_READ_STL_H

#include "Byte_scanner.h"
#include "Point_numbering.h"
#include "Polygon_soup.h"
#include "Text_scanner.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace mesh_file {

// The format of stereolithography, text and binary. It has no points but corners: those at the same
// place are one point.
class Stl_reader
{
  static constexpr std::size_t size_of_header = 84; // 80 bytes of anything and the number of faces
  static constexpr std::size_t size_of_face = 50;   // normal, three corners, two bytes of anything

  std::string_view file_;
  Polygon_soup soup_;
  Point_numbering number_{soup_.points};

  static std::uint32_t number_of_faces(std::string_view file)
  { return Byte_scanner(file, 80, false).number<std::uint32_t>(); }

  // The size tells, as also binary files begin with "solid". In a text the bytes of the number are
  // characters, which would be a number of faces larger than the file.
  bool is_binary() const
  {
    if (file_.size() < size_of_header)
      return false;
    return number_of_faces(file_) == (file_.size() - size_of_header) / size_of_face ||
           file_.substr(0, size_of_header).find('\0') != std::string_view::npos;
  }

  void read_binary()
  {
    const std::size_t faces = number_of_faces(file_);
    Byte_scanner bytes(file_, size_of_header, false);
    if (faces > bytes.remaining() / size_of_face)
      Byte_scanner::fail(80, "the file is too short for " + std::to_string(faces) + " faces");
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
    bytes.finish("the last face");
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

  // One solid after the other. Their names may be any words, or none.
  void read_text()
  {
    Text_scanner text(file_);
    while (!text.is_at_end()) {
      expect(text, "solid");
      text.rest_of_line();
      while (text.skip_space(), lower_case(text.peek_word()) == "facet") {
        text.skip_word();
        read_facet(text);
      }
      expect(text, "endsolid");
      const Text_scanner where = text;
      if (lower_case(text.rest_of_line()).find("endfacet") != std::string::npos)
        where.fail("the end of the line, or the name of the solid alone");
    }
  }

public:
  explicit Stl_reader(std::string_view file) : file_(file) {}

  // Whether the contents look like one.
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
