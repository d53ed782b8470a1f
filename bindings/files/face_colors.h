// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_FACE_COLORS_H
#define SEGMENT_MESH_MESH_FILE_FACE_COLORS_H

#include "Polygon_soup.h"
#include "Text_scanner.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mesh_file {

typedef std::array<const Property*, 3> Color_properties;

// Returns the properties red, green and blue, if all are there.
inline std::optional<Color_properties> color_properties(const std::vector<Property>& properties)
{
  Color_properties result = {};
  const std::array<const char*, 3> names = {"red", "green", "blue"};
  for (const Property& p : properties)
    for (std::size_t i = 0; i < 3; ++i)
      if (p.name == names[i])
        result[i] = &p;
  if (result[0] == nullptr || result[1] == nullptr || result[2] == nullptr)
    return std::nullopt;
  return result;
}

// Returns the diffuse color of a material. Throws `std::runtime_error` if an image has it.
inline std::optional<std::array<double, 3> > diffuse_color(const Material& material)
{
  std::optional<std::array<double, 3> > result;
  for (const Material::Statement& s : material.statements) {
    if (s.text.substr(0, 6) == "map_Kd")
      throw std::runtime_error("the colors are in an image of the material \"" + material.name +
                               "\", and images are not read: give each face its color in a file "
                               "of --features");
    if (s.text.substr(0, 3) == "Kd ") {
      Text_scanner numbers(std::string_view(s.text).substr(3));
      const double red = numbers.number(), green = numbers.number();
      result = {red, green, numbers.number()};
    }
  }
  return result;
}

// Returns whether the polygons or the points have colors.
inline bool has_colors(const Polygon_soup& soup)
{ return color_properties(soup.polygon_properties) || color_properties(soup.point_properties); }

// Returns red, green and blue of each polygon, in the unit of the file: its own color, else the
// mean color of its points, else the color of its material. Throws `std::runtime_error` if there
// are no colors, or only in images.
inline std::vector<double> face_colors(const Polygon_soup& soup)
{
  std::vector<double> result;
  const auto add = [&result](const auto& color) {
    for (std::size_t i = 0; i < 3; ++i)
      result.push_back(color(i));
  };
  const std::size_t n = soup.number_of_polygons();
  if (const auto of_polygons = color_properties(soup.polygon_properties))
    for (std::size_t f = 0; f < n; ++f)
      add([&](std::size_t i) { return (*of_polygons)[i]->values[f]; });
  else if (const auto of_points = color_properties(soup.point_properties))
    for (std::size_t f = 0; f < n; ++f)
      add([&](std::size_t i) {
        double sum = 0;
        for (Index v : soup.polygon(f))
          sum += (*of_points)[i]->values[v];
        return soup.polygon(f).size() > 0 ? sum / static_cast<double>(soup.polygon(f).size()) : 0;
      });
  else {
    std::vector<std::optional<std::array<double, 3> > > of_materials;
    for (const Material& m : soup.materials)
      of_materials.push_back(diffuse_color(m));
    if (std::none_of(of_materials.begin(), of_materials.end(), [](const auto& c) { return c; }))
      throw std::runtime_error("there are no colors of faces, points or materials");
    for (std::size_t f = 0; f < n; ++f) {
      const Index m = soup.material_of_polygon[f];
      const auto color = m == null_index ? std::nullopt : of_materials[m];
      add([&](std::size_t i) { return color.value_or(std::array<double, 3>{.8, .8, .8})[i]; });
    }
  }
  return result;
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_FACE_COLORS_H
