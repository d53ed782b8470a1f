// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_READ_OFF_H
#define SEGMENT_MESH_MESH_FILE_READ_OFF_H

#include "Byte_scanner.h"
#include "Polygon_soup.h"
#include "Text_scanner.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mesh_file {

// The meaning of the keyword: each letter before OFF adds numbers to each point.
struct Off_header
{
  bool has_texture = false;    // ST
  bool has_colors = false;     // C
  bool has_normals = false;    // N
  bool is_homogeneous = false; // 4
  bool has_dimension = false;  // n

  // Reads a keyword. Returns false if the word is none.
  bool parse(std::string_view word)
  {
    const auto take = [&](std::string_view prefix) {
      const bool result = word.substr(0, prefix.size()) == prefix;
      word.remove_prefix(result ? prefix.size() : 0);
      return result;
    };
    has_texture = take("ST");
    has_colors = take("C");
    has_normals = take("N");
    is_homogeneous = take("4");
    has_dimension = take("n");
    if (word.substr(0, 3) == "OFF" && word.find_first_not_of("0123456789", 3) == word.npos)
      return true; // also if the number of points follows without a space
    *this = Off_header();
    return false;
  }
};

// Reads the format of Geomview, text and binary. Keeps the colors of a text on demand. Skips other
// colors, normals and texture coordinates.
class Off_reader
{
  static constexpr long long most = null_index - 1;

  Text_scanner text_;
  const bool keeps_colors_;
  Off_header header_;
  Polygon_soup soup_;

  // Reserves memory. Throws if the file is too short for so many points and polygons.
  void reserve(long long points, long long polygons, std::size_t bytes_per_item)
  {
    const std::size_t room = text_.rest().size() / bytes_per_item;
    if (static_cast<unsigned long long>(points) > room ||
        static_cast<unsigned long long>(polygons) > room)
      text_.fail_with("the file is too short for " + std::to_string(points) + " points and " +
                      std::to_string(polygons) + " faces");
    soup_.points.reserve(static_cast<std::size_t>(points));
    soup_.first_corner.reserve(static_cast<std::size_t>(polygons) + 1);
    soup_.corners.reserve(3 * static_cast<std::size_t>(polygons));
  }

  void check_dimension(long long dimension) const
  {
    if (header_.is_homogeneous || dimension != 3)
      text_.fail_with("the points do not have three coordinates");
  }

  // Reads the numbers on the rest of the line, which only their place marks. Three that follow the
  // first `skipped` ones are a color.
  void read_color(std::size_t skipped, std::vector<double>& colors)
  {
    const std::vector<double> numbers = text_.numbers_on_line();
    if (keeps_colors_ && numbers.size() >= skipped + 3) {
      const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(skipped);
      colors.insert(colors.end(), first, first + 3);
    }
  }

  long long number_of_corners()
  {
    text_.skip_space();
    const Text_scanner where = text_;
    const long long result = text_.integer(0, most, "a number of corners");
    if (static_cast<unsigned long long>(result) > text_.rest().size() / 2)
      where.fail("a number of corners that the file has room for");
    return result;
  }

  void read_text()
  {
    text_.remove_padding();
    check_dimension(header_.has_dimension ? text_.integer(1, most, "a number of dimensions") : 3);
    const long long points = text_.integer(0, most, "a number of points");
    const long long polygons = text_.integer(0, most, "a number of faces");
    skip_number_of_edges();
    reserve(points, polygons, 2);
    std::vector<double> colors_of_points, colors_of_polygons;
    const std::size_t before_color = !header_.has_colors ? most : header_.has_normals ? 3 : 0;
    for (long long i = 0; i < points; ++i) {
      const double x = text_.number();
      const double y = text_.number();
      soup_.points.push_back({x, y, text_.number()});
      read_color(before_color, colors_of_points);
    }
    for (long long i = 0; i < polygons; ++i) {
      for (long long n = number_of_corners(); n > 0; --n)
        soup_.corners.push_back(
          static_cast<Index>(text_.integer(0, points - 1, "the number of a point")));
      if (soup_.corners.size() > most)
        text_.fail_with("there are too many corners");
      soup_.end_polygon();
      read_color(0, colors_of_polygons);
    }
    add_colors(std::move(colors_of_points), soup_.points.size(), soup_.point_properties);
    add_colors(std::move(colors_of_polygons), soup_.number_of_polygons(),
               soup_.polygon_properties);
    if (!text_.is_at_end())
      text_.fail_with("there is more after the last face");
  }

  // Skips the number of edges, which some files leave out.
  void skip_number_of_edges()
  {
    if (!text_.is_at_end_of_line()) {
      text_.integer(-most, most, "a number of edges");
      if (!text_.is_at_end_of_line())
        text_.fail("the end of the line");
      return;
    }
    Text_scanner ahead = text_;
    ahead.skip_space();
    ahead.skip_word();
    if (ahead.is_at_end_of_line() && !ahead.is_at_end())
      text_.integer(-most, most, "a number of edges");
  }

  static long long count(Byte_scanner& bytes, const char* what, long long largest)
  {
    const std::size_t at = bytes.position();
    const std::int32_t result = bytes.number<std::int32_t>(what);
    if (result < 0 || result > largest)
      Byte_scanner::fail(at, std::to_string(result) + " is not " + what);
    return result;
  }

  void read_binary()
  {
    text_.rest_of_line();
    Byte_scanner bytes(text_.all(), text_.all().size() - text_.rest().size(), true);
    check_dimension(header_.has_dimension ? count(bytes, "a number of dimensions", most) : 3);
    const long long points = count(bytes, "a number of points", most);
    const long long polygons = count(bytes, "a number of faces", most);
    bytes.number<std::int32_t>("a number of edges");
    reserve(points, polygons, 8);
    soup_.coordinate_type = Number_type::FLOAT32;
    const std::size_t more = 4 * ((header_.has_normals ? 3u : 0u) + (header_.has_colors ? 4u : 0u) +
                                  (header_.has_texture ? 2u : 0u));
    for (long long i = 0; i < points; ++i) {
      soup_.points.push_back(bytes.point<float>());
      bytes.skip(more, "a point");
    }
    for (long long i = 0; i < polygons; ++i) {
      const long long size = count(bytes, "a number of corners", most);
      bytes.require(4 * static_cast<std::size_t>(size), "the corners of a face");
      for (long long k = 0; k < size; ++k)
        soup_.corners.push_back(
          static_cast<Index>(count(bytes, "the number of a point", points - 1)));
      soup_.end_polygon();
      const std::size_t colors =
        static_cast<std::size_t>(count(bytes, "a number of color components", 4));
      bytes.skip(4 * colors, "a color");
    }
    bytes.finish("the last face");
  }

public:
  Off_reader(std::string_view file, bool keeps_colors)
    : text_(file), keeps_colors_(keeps_colors) {}

  Polygon_soup operator()()
  {
    text_.skip_space();
    // The keyword may be left out.
    if (header_.parse(text_.peek_word()))
      for (std::size_t n = text_.peek_word().find("OFF") + 3; n > 0; --n)
        text_.skip(text_.rest()[0]);
    else if (text_.peek_word().find_first_not_of("0123456789") != std::string_view::npos)
      text_.fail("OFF");
    text_.skip_blanks();
    if (text_.peek_word() == "BINARY")
      read_binary();
    else
      read_text();
    return std::move(soup_);
  }
};

inline Polygon_soup read_off(std::string_view file, bool keeps_colors)
{ return Off_reader(file, keeps_colors)(); }

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_READ_OFF_H
