// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_READ_OBJ_H
#define SEGMENT_MESH_MESH_FILE_READ_OBJ_H

#include "Polygon_soup.h"
#include "Text_scanner.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mesh_file {

// Reads the format of Wavefront: points, faces, objects, groups and names of materials. Skips
// lines, points, curves, settings and commands, and with a warning all unknown statements.
class Obj_reader
{
  static constexpr long long most = null_index - 1;

  Text_scanner text_;
  const bool keeps_properties_;
  Polygon_soup soup_;
  std::vector<double> colors_; // of the points
  // The largest corner and its place: points may follow the faces that use them.
  long long largest_corner_ = 0;
  Text_scanner largest_at_;
  std::string object_, group_; // the current names
  std::map<std::pair<std::string, std::string>, Index> groups_{{{}, 0}};
  Index number_of_group_ = 0;
  std::map<std::string, Index, std::less<> > materials_;
  Index number_of_material_ = null_index;
  static constexpr std::size_t most_unknown = 8;
  std::set<std::string> unknown_; // the first kinds of statements that are not known
  bool has_bad_numbers_ = false;  // in normals or texture coordinates

  static bool is_skipped(std::string_view statement)
  {
    static const std::string_view known[] = {
      "vp", "deg", "bmat", "step", "cstype", "p", "l", "curv", "curv2", "surf", "parm", "trim",
      "hole", "scrv", "sp", "end", "con", "s", "mg", "bevel", "c_interp", "d_interp",
      "lod", "shadow_obj", "trace_obj", "ctech", "stech",
      "maplib", "usemap", "bsp", "bzp", "cdc", "cdp", "res", "csh"};
    return std::find(std::begin(known), std::end(known), statement) != std::end(known);
  }

  double number()
  {
    if (text_.is_at_end_of_line())
      text_.fail("a number");
    return text_.number();
  }

  Point point()
  {
    const double x = number();
    const double y = number();
    return {x, y, number()};
  }

  // Returns a number of a normal or of texture coordinates; NaN if it is missing or no number,
  // because nothing may need it.
  double number_or_nan()
  {
    std::optional<double> result;
    if (!text_.is_at_end_of_line())
      result = text_.find_number();
    if (!result) {
      if (!has_bad_numbers_)
        soup_.warnings.push_back(text_.contradiction("a number") + ", in a normal or texture");
      has_bad_numbers_ = true;
      text_.skip_word();
    }
    return result.value_or(std::numeric_limits<double>::quiet_NaN());
  }

  // Reads the rest of a point: a color, or a weight, which is skipped.
  void read_color()
  {
    const std::vector<double> numbers = text_.numbers_on_line();
    if (keeps_properties_ && numbers.size() >= 3)
      colors_.insert(colors_.end(), numbers.begin(), numbers.begin() + 3);
  }

  void read_texture_coordinates()
  {
    const double u = number_or_nan();
    const double v = text_.is_at_end_of_line() ? 0 : number_or_nan();
    if (keeps_properties_)
      soup_.texture_coordinates.push_back({u, v, 0, 0});
  }

  void read_normal()
  {
    const double x = number_or_nan();
    const double y = number_or_nan();
    const Point normal{x, y, number_or_nan()};
    if (keeps_properties_)
      soup_.normals.push_back(normal);
  }

  // Returns the number of an element, counted from 1. A negative number counts back from the last
  // element that was read; the result is 0 if that leads too far.
  long long absolute_number(std::size_t number_of_elements)
  {
    const long long number = text_.digits(-most, most, "the corner of a face");
    return (std::max)(number < 0 ? static_cast<long long>(number_of_elements) + 1 + number : number,
                      0LL);
  }

  // Reads a corner: point, point/texture, point//normal or point/texture/normal.
  void read_corner()
  {
    const Text_scanner where = text_;
    long long texture = 0, normal = 0;
    const long long point = absolute_number(soup_.points.size());
    if (text_.skip('/')) {
      if (!text_.is_at('/') && !text_.is_after_word())
        texture = absolute_number(soup_.texture_coordinates.size());
      if (text_.skip('/') && !text_.is_after_word())
        normal = absolute_number(soup_.normals.size());
    }
    if (point == 0 || !text_.is_after_word())
      where.fail("the corner of a face");
    if (point > largest_corner_) {
      largest_corner_ = point;
      largest_at_ = where;
    }
    soup_.corners.push_back(static_cast<Index>(point - 1));
    if (keeps_properties_) {
      soup_.texture_of_corner.push_back(static_cast<Index>(texture - 1));
      soup_.normal_of_corner.push_back(static_cast<Index>(normal - 1));
    }
  }

  // Reads the name of an object, or the names of a group.
  void read_group(std::string& name)
  {
    name.clear();
    while (!text_.is_at_end_of_line())
      name.append(text_.word()) += ' ';
    number_of_group_ = groups_.emplace(std::make_pair(object_, group_),
                                       static_cast<Index>(groups_.size())).first->second;
  }

  void read_material()
  {
    const std::string_view name = text_.peek_rest_of_line();
    const auto found = materials_.find(name);
    number_of_material_ = found == materials_.end()
      ? materials_.emplace(name, static_cast<Index>(materials_.size())).first->second
      : found->second;
    if (number_of_material_ == soup_.materials.size())
      soup_.materials.push_back({std::string(name), {}, {}});
  }

  void read_face()
  {
    while (!text_.is_at_end_of_line())
      read_corner();
    if (soup_.corners.size() > most)
      text_.fail_with("there are too many corners");
    soup_.end_polygon();
    soup_.group_of_polygon.push_back(number_of_group_);
    soup_.material_of_polygon.push_back(number_of_material_);
  }

  void warn_of_unknown(const Text_scanner& where, std::string_view statement)
  {
    if (unknown_.size() < most_unknown && unknown_.emplace(statement).second)
      soup_.warnings.push_back(where.contradiction("a statement of OBJ"));
  }

  void read_statement()
  {
    const Text_scanner where = text_;
    const std::string_view statement = text_.word();
    if (statement == "v") {
      soup_.points.push_back(point());
      read_color();
    }
    else if (statement == "vn")
      read_normal();
    else if (statement == "vt")
      read_texture_coordinates();
    else if (statement == "f" || statement == "fo")
      read_face();
    else if (statement == "g" || statement == "o")
      read_group(statement == "o" ? object_ : group_);
    else if (statement == "usemtl")
      read_material();
    else if (statement == "mtllib")
      soup_.material_files.emplace_back(text_.peek_rest_of_line());
    else if (statement == "call")
      where.fail_with("other files are not read");
    else if (!is_skipped(statement))
      warn_of_unknown(where, statement);
    text_.skip_rest_of_line();
  }

  // Sets indices of missing elements to null_index, and removes all indices if no other is left.
  static void clean(std::vector<Index>& of_corner, std::size_t number_of_elements)
  {
    for (Index& i : of_corner)
      if (i >= number_of_elements)
        i = null_index;
    if (std::all_of(of_corner.begin(), of_corner.end(), [](Index i) { return i == null_index; }))
      of_corner.clear();
  }

public:
  Obj_reader(std::string_view file, bool keeps_properties)
    : text_(file), keeps_properties_(keeps_properties), largest_at_(file) {}

  Polygon_soup operator()()
  {
    text_.remove_padding();
    while (!text_.is_at_end())
      read_statement();
    if (!soup_.warnings.empty() && soup_.points.empty() && soup_.number_of_polygons() == 0)
      throw std::runtime_error(soup_.warnings[0]); // this is no OBJ
    if (groups_.size() == 1)
      soup_.group_of_polygon.clear();
    if (!keeps_properties_) {
      soup_.materials.clear();
      soup_.material_files.clear();
    }
    if (soup_.materials.empty())
      soup_.material_of_polygon.clear();
    if (soup_.points.size() > static_cast<std::size_t>(most))
      throw std::runtime_error("there are too many points");
    add_colors(std::move(colors_), soup_.points.size(), soup_.point_properties);
    if (largest_corner_ > static_cast<long long>(soup_.points.size()))
      largest_at_.fail("a corner: there are " + std::to_string(soup_.points.size()) + " points");
    clean(soup_.texture_of_corner, soup_.texture_coordinates.size());
    clean(soup_.normal_of_corner, soup_.normals.size());
    return std::move(soup_);
  }
};

inline Polygon_soup read_obj(std::string_view file, bool keeps_properties)
{ return Obj_reader(file, keeps_properties)(); }

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_READ_OBJ_H
