// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_READ_PLY_H
#define SEGMENT_MESH_MESH_FILE_READ_PLY_H

#include "Byte_scanner.h"
#include "Ply_header.h"
#include "Polygon_soup.h"
#include "Text_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mesh_file {

// The numbers of a body in text. If they are read by lines, each line has one element, and maybe
// further numbers.
class Ply_text
{
  Text_scanner text_;
  Text_scanner last_; // before the last number
  const bool is_by_lines_;

public:
  Ply_text(const Text_scanner& text, Ply_encoding encoding)
    : text_(text), last_(text), is_by_lines_(encoding == Ply_encoding::TEXT_BY_LINES)
  {
    text_.remove_padding();
    text_.skip_space();
  }

  std::size_t remaining() const { return text_.rest().size(); }

  // Returns the least number of bytes of a number: one digit, because no blank follows the last
  // one.
  static std::size_t smallest_size(Number_type) { return 1; }

  double number(Number_type type)
  {
    if (!is_by_lines_)
      text_.skip_space();
    else if (text_.is_at_end_of_line())
      text_.fail("a number");
    last_ = text_;
    const double result = text_.number();
    if (!has_type(result, type))
      fail("a number of the type of its property");
    return result;
  }

  // Skips the rest of a line, with a warning for the first one that has further numbers.
  void end_element(std::vector<std::string>& warnings)
  {
    if (!is_by_lines_)
      return;
    if (!text_.is_at_end_of_line() && warnings.empty())
      warnings.push_back(text_.contradiction("a number that the header declares"));
    text_.skip_rest_of_line();
    text_.skip_space();
  }

  // Throws that the last number is not `expected`.
  [[noreturn]] void fail(const char* expected) const { last_.fail(expected); }

  [[noreturn]] void fail_with(const std::string& sentence) const { text_.fail_with(sentence); }

  void finish()
  {
    if (!text_.is_at_end())
      text_.fail_with("there is more after the last element");
  }
};

// The numbers of a binary body.
class Ply_binary
{
  Byte_scanner bytes_;
  std::size_t last_ = 0;

public:
  Ply_binary(const Text_scanner& text, Ply_encoding encoding)
    : bytes_(text.all(), text.all().size() - text.rest().size(),
             encoding == Ply_encoding::BIG_ENDIAN_BINARY) {}

  std::size_t remaining() const { return bytes_.remaining(); }

  static std::size_t smallest_size(Number_type type)
  {
    switch (type) {
      case Number_type::INT8: case Number_type::UINT8: return 1;
      case Number_type::INT16: case Number_type::UINT16: return 2;
      case Number_type::FLOAT64: return 8;
      default: return 4;
    }
  }

  double number(Number_type type)
  {
    last_ = bytes_.position();
    switch (type) {
      case Number_type::INT8: return bytes_.number<std::int8_t>();
      case Number_type::UINT8: return bytes_.number<std::uint8_t>();
      case Number_type::INT16: return bytes_.number<std::int16_t>();
      case Number_type::UINT16: return bytes_.number<std::uint16_t>();
      case Number_type::INT32: return bytes_.number<std::int32_t>();
      case Number_type::UINT32: return bytes_.number<std::uint32_t>();
      case Number_type::FLOAT32: return bytes_.number<float>();
      default: return bytes_.number<double>();
    }
  }

  void end_element(std::vector<std::string>&) {}

  [[noreturn]] void fail(const char* expected) const
  { Byte_scanner::fail(last_, std::string("the number here is not ") + expected); }

  [[noreturn]] void fail_with(const std::string& sentence) const
  { Byte_scanner::fail(bytes_.position(), sentence); }

  void finish() const { bytes_.finish("the last element"); }
};

// Reads the points of the element `vertex`, the polygons of `face` and the strips of triangles of
// `tristrips`. Skips other elements and lists.
template <class Body>
class Ply_body_reader
{
  static constexpr std::size_t most = null_index - 1;

  // The destination of a property.
  struct Column
  {
    Ply_property property;
    int coordinate = -1;
    bool is_corners = false;
    std::vector<double>* values = nullptr;
  };

  Body body_;
  const Ply_header& header_;
  const bool keeps_properties_;
  std::size_t number_of_points_ = 0;
  Polygon_soup soup_;

  static bool is_corner_list(const Ply_property& p)
  { return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index"); }

  // Returns whether a list of faces may have the corners under another name.
  static bool may_be_corner_list(const Ply_property& p)
  {
    static const std::string_view others[] = {"texcoord", "texture", "color", "normal", "neighbor",
                                              "adjacent", "flag"};
    return p.is_list && p.type < Number_type::FLOAT32 &&
           std::none_of(std::begin(others), std::end(others), [&](std::string_view word)
                        { return p.name.find(word) != p.name.npos; });
  }

  // Returns the list of the corners of faces or strips. If no list of the faces has a usual name,
  // it is the only one that may have the corners.
  const Ply_property& corner_list(const Ply_element& element) const
  {
    const auto& all = element.properties;
    auto is_right = is_corner_list;
    if (element.name == "face" && std::none_of(all.begin(), all.end(), is_right))
      is_right = may_be_corner_list;
    const auto number = std::count_if(all.begin(), all.end(), is_right);
    if (number != 1)
      body_.fail_with("the elements " + in_quotes(element.name) +
                      (number == 0 || is_right != is_corner_list ? " have no list 'vertex_indices'"
                                                                 : " have two lists of corners"));
    return *std::find_if(all.begin(), all.end(), is_right);
  }

  static int coordinate(const Ply_property& p)
  { return p.is_list || p.name.size() != 1 || p.name < "x" || p.name > "z" ? -1 : p.name[0] - 'x'; }

  std::vector<Column> columns(const Ply_element& element)
  {
    const bool is_of_points = element.name == "vertex";
    std::vector<Property>& kept = is_of_points ? soup_.point_properties : soup_.polygon_properties;
    kept.reserve(element.properties.size()); // columns point into it
    std::vector<Column> result;
    const Ply_property* const corners =
      is_of_points || !is_read(element) ? nullptr : &corner_list(element);
    for (const Ply_property& p : element.properties) {
      Column column{p};
      column.is_corners = &p == corners;
      if (is_of_points)
        column.coordinate = coordinate(p);
      if (keeps_properties_ && !p.is_list && column.coordinate < 0 &&
          (is_of_points || element.name == "face")) {
        kept.push_back({p.name, p.type, {}});
        column.values = &kept.back().values;
      }
      result.push_back(column);
    }
    return result;
  }

  static bool is_read(const Ply_element& e)
  { return e.name == "vertex" || e.name == "face" || e.name == "tristrips"; }

  static std::size_t smallest_size(const Ply_element& element)
  {
    std::size_t result = 0;
    for (const Ply_property& p : element.properties)
      result += Body::smallest_size(p.is_list ? p.size_type : p.type);
    return result;
  }

  // Reads an integer, whose type may be float.
  double integer(Number_type type, double smallest, double end, const char* expected)
  {
    const double result = body_.number(type);
    if (!(result >= smallest && result < end) || result != std::floor(result))
      body_.fail(expected);
    return result;
  }

  std::size_t size_of_list(const Ply_property& p)
  {
    const std::size_t largest = body_.remaining() / Body::smallest_size(p.type);
    return static_cast<std::size_t>(integer(p.size_type, 0, static_cast<double>(largest) + 1,
                                            "the size of a list that the file has room for"));
  }

  double corner(Number_type type, double smallest)
  {
    return integer(type, smallest, static_cast<double>(number_of_points_),
                   "the number of a point");
  }

  void read_polygon(const Ply_property& p)
  {
    for (std::size_t n = size_of_list(p); n > 0; --n)
      soup_.corners.push_back(static_cast<Index>(corner(p.type, 0)));
    end_polygon();
  }

  void end_polygon()
  {
    if (soup_.corners.size() > most)
      body_.fail_with("there are too many corners");
    soup_.end_polygon();
  }

  // Reads strips of triangles: each point makes a triangle with the two before it, every other one
  // is turned, and -1 starts a new strip.
  void read_strips(const Ply_property& p)
  {
    std::vector<Index> strip;
    for (std::size_t n = size_of_list(p); n > 0; --n) {
      const double point = corner(p.type, -1);
      if (point < 0) {
        strip.clear();
        continue;
      }
      strip.push_back(static_cast<Index>(point));
      const std::size_t i = strip.size();
      if (i < 3)
        continue;
      const bool is_turned = i % 2 == 0;
      soup_.corners.insert(soup_.corners.end(),
                           {strip[i - (is_turned ? 2 : 3)], strip[i - (is_turned ? 3 : 2)],
                            strip[i - 1]});
      end_polygon();
    }
  }

  void read_value(const Column& column, Point& point)
  {
    const double value = body_.number(column.property.type);
    if (column.coordinate >= 0)
      point[static_cast<std::size_t>(column.coordinate)] = value;
    if (column.values)
      column.values->push_back(value);
  }

  void read_list(const Ply_element& element, const Column& column)
  {
    if (column.is_corners && element.name == "face")
      read_polygon(column.property);
    else if (column.is_corners)
      read_strips(column.property);
    else
      for (std::size_t n = size_of_list(column.property); n > 0; --n)
        body_.number(column.property.type);
  }

  void check(const Ply_element& element) const
  {
    const std::size_t room = body_.remaining() / smallest_size(element);
    if (element.size > room || (is_read(element) && element.size > most))
      body_.fail_with("the file is too short for " + std::to_string(element.size) +
                      " elements " + in_quotes(element.name));
    if (element.name == "vertex" &&
        std::count_if(element.properties.begin(), element.properties.end(),
                      [](const Ply_property& p) { return coordinate(p) >= 0; }) != 3)
      body_.fail_with("the points have no properties x, y and z");
  }

  void read(const Ply_element& element)
  {
    if (element.properties.empty() || element.size == 0)
      return; // no byte in the body
    check(element);
    if (element.name == "face") {
      soup_.first_corner.reserve(element.size + 1);
      soup_.corners.reserve(3 * element.size);
    }
    const std::vector<Column> all = columns(element);
    if (element.name == "vertex")
      soup_.points.reserve(element.size);
    for (std::size_t i = 0; i < element.size; ++i) {
      Point point;
      for (const Column& column : all)
        if (column.property.is_list)
          read_list(element, column);
        else
          read_value(column, point);
      if (element.name == "vertex")
        soup_.points.push_back(point);
      body_.end_element(soup_.warnings);
    }
  }

  // Returns FLOAT32 if all coordinates have this type, else FLOAT64.
  Number_type coordinate_type(const Ply_element& points) const
  {
    const bool is_double = std::any_of(
      points.properties.begin(), points.properties.end(), [](const Ply_property& p) {
        return coordinate(p) >= 0 && p.type != Number_type::FLOAT32;
      });
    return is_double ? Number_type::FLOAT64 : Number_type::FLOAT32;
  }

public:
  Ply_body_reader(const Text_scanner& text, const Ply_header& header, bool keeps_properties)
    : body_(text, header.encoding), header_(header), keeps_properties_(keeps_properties)
  {
    for (const Ply_element& e : header.elements)
      if (e.name == "vertex" && !e.properties.empty()) {
        number_of_points_ = (std::min)(e.size, most);
        soup_.coordinate_type = coordinate_type(e);
      }
  }

  Polygon_soup operator()()
  {
    for (const Ply_element& element : header_.elements)
      read(element);
    body_.finish();
    if (!soup_.polygon_properties.empty() &&
        soup_.polygon_properties[0].values.size() != soup_.number_of_polygons())
      soup_.polygon_properties.clear(); // triangles of strips have none
    return std::move(soup_);
  }
};

// Reads the format of Stanford, text and binary. Reads a text by lines only if its numbers alone do
// not fit the header.
inline Polygon_soup read_ply(std::string_view file, bool keeps_properties)
{
  Text_scanner text(file);
  Ply_header header = Ply_header_reader(text)();
  Polygon_soup result;
  try {
    if (header.encoding == Ply_encoding::TEXT)
      result = Ply_body_reader<Ply_text>(text, header, keeps_properties)();
    else
      result = Ply_body_reader<Ply_binary>(text, header, keeps_properties)();
  }
  catch (const std::runtime_error& error) {
    if (header.encoding != Ply_encoding::TEXT)
      throw;
    header.encoding = Ply_encoding::TEXT_BY_LINES;
    try {
      result = Ply_body_reader<Ply_text>(text, header, keeps_properties)();
    }
    catch (const std::runtime_error&) {
      throw std::runtime_error(error);
    }
  }
  result.warnings.insert(result.warnings.begin(), header.warnings.begin(), header.warnings.end());
  return result;
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_READ_PLY_H
