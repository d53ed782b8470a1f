// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_PLY_HEADER_H
#define SEGMENT_MESH_MESH_FILE_PLY_HEADER_H

#include "Polygon_soup.h"
#include "Text_scanner.h"

#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mesh_file {

struct Ply_property
{
  std::string name;
  Number_type type;
  bool is_list = false;
  Number_type size_type = Number_type::UINT8; // the type of the size of a list
};

struct Ply_element
{
  std::string name;
  std::size_t size;
  std::vector<Ply_property> properties;
};

enum class Ply_encoding { TEXT, TEXT_BY_LINES, LITTLE_ENDIAN_BINARY, BIG_ENDIAN_BINARY };

struct Ply_header
{
  Ply_encoding encoding = Ply_encoding::TEXT;
  std::vector<Ply_element> elements;
  std::vector<std::string> warnings;
};

class Ply_header_reader
{
  Text_scanner& text_;
  Ply_header header_;
  std::set<std::string> element_names_, property_names_; // so far; the latter of the last element

  // Reads a word on this line.
  std::string_view word(const char* expected)
  {
    if (text_.is_at_end_of_line())
      text_.fail(expected);
    return text_.word();
  }

  void read_format()
  {
    text_.skip_blanks();
    const Text_scanner where = text_;
    const std::string_view format = word("a format");
    if (format == "ascii")
      header_.encoding = Ply_encoding::TEXT;
    else if (format == "binary_little_endian")
      header_.encoding = Ply_encoding::LITTLE_ENDIAN_BINARY;
    else if (format == "binary_big_endian")
      header_.encoding = Ply_encoding::BIG_ENDIAN_BINARY;
    else
      where.fail("a format of PLY");
    word("a version");
  }

  void read_element()
  {
    const std::string name(word("the name of an element"));
    if (!element_names_.insert(name).second)
      text_.fail_with("there is an element " + in_quotes(name) + " already");
    property_names_.clear();
    const long long size =
      text_.integer(0, (std::numeric_limits<long long>::max)(), "a number of elements");
    header_.elements.push_back({name, static_cast<std::size_t>(size), {}});
  }

  Number_type number_type()
  {
    text_.skip_blanks();
    const std::string_view name = text_.peek_word();
    static const struct { std::string_view names[2]; Number_type type; } types[] = {
      {{"char", "int8"}, Number_type::INT8},      {{"uchar", "uint8"}, Number_type::UINT8},
      {{"short", "int16"}, Number_type::INT16},   {{"ushort", "uint16"}, Number_type::UINT16},
      {{"int", "int32"}, Number_type::INT32},     {{"uint", "uint32"}, Number_type::UINT32},
      {{"float", "float32"}, Number_type::FLOAT32}, {{"double", "float64"}, Number_type::FLOAT64}};
    for (const auto& t : types)
      if (name == t.names[0] || name == t.names[1]) {
        text_.skip_word();
        return t.type;
      }
    text_.fail("a number type of PLY");
  }

  void read_property()
  {
    if (header_.elements.empty())
      text_.fail_with("a property comes before the first element");
    Ply_property property;
    text_.skip_blanks();
    property.is_list = text_.peek_word() == "list";
    if (property.is_list) {
      text_.skip_word();
      property.size_type = number_type();
    }
    property.type = number_type();
    property.name = word("the name of a property");
    if (!property_names_.insert(property.name).second)
      text_.fail_with("there is a property " + in_quotes(property.name) + " already");
    header_.elements.back().properties.push_back(property);
  }

  void end_line()
  {
    if (!text_.is_at_end_of_line())
      text_.fail("the end of the line");
    text_.rest_of_line();
  }

public:
  explicit Ply_header_reader(Text_scanner& text) : text_(text) {}

  // Reads the header, and leaves the text at the begin of the body.
  Ply_header operator()()
  {
    if (lower_case(text_.peek_word()) != "ply")
      text_.fail("'ply'");
    text_.skip_word();
    end_line();
    bool has_format = false;
    while (true) {
      text_.skip_space();
      const Text_scanner where = text_;
      const std::string_view keyword = text_.word();
      if (keyword == "comment" || keyword == "obj_info")
        text_.rest_of_line();
      else if (keyword == "end_header") {
        end_line();
        break;
      }
      else if (keyword.empty())
        where.fail("a line of a PLY header");
      else {
        if (keyword == "format" && !has_format) {
          read_format();
          has_format = true;
        }
        else if (keyword == "element")
          read_element();
        else if (keyword == "property")
          read_property();
        else {
          if (header_.warnings.empty())
            header_.warnings.push_back(where.contradiction("a line of a PLY header"));
          text_.skip_rest_of_line();
        }
        end_line();
      }
    }
    if (!has_format)
      text_.fail_with("the header does not name its format");
    return std::move(header_);
  }
};

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_PLY_HEADER_H
