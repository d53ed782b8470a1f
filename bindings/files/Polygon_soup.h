// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_POLYGON_SOUP_H
#define SEGMENT_MESH_MESH_FILE_POLYGON_SOUP_H

#include "Material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

// Files of meshes, read and written. Only convex_hull.h and limited_hull.h use CGAL, so that this
// folder serves any program.
namespace mesh_file {

typedef std::array<double, 3> Point;
typedef std::array<double, 4> Texture_point; // two pairs of texture coordinates; v points upwards
typedef std::uint32_t Index;

constexpr Index null_index = (std::numeric_limits<Index>::max)();

inline bool is_finite(const Point& p)
{ return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

// The points of one polygon, as indices.
class Polygon
{
  const Index* begin_;
  const Index* end_;

public:
  Polygon(const Index* begin, const Index* end) : begin_(begin), end_(end) {}

  const Index* begin() const { return begin_; }
  const Index* end() const { return end_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  Index operator[](std::size_t i) const { return begin_[i]; }
};

// The number types of PLY. All their values are exact as `double`.
enum class Number_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

// Returns whether a value of that type can be this number.
inline bool has_type(double value, Number_type type)
{
  static const struct { double smallest, largest; } ranges[] = {
    {-128., 127.}, {0., 255.}, {-32768., 32767.}, {0., 65535.}, {-2147483648., 2147483647.},
    {0., 4294967295.}};
  if (type == Number_type::FLOAT64 || (type == Number_type::FLOAT32 && !std::isfinite(value)))
    return true;
  if (type == Number_type::FLOAT32)
    return std::abs(value) <= static_cast<double>((std::numeric_limits<float>::max)());
  const auto range = ranges[static_cast<std::size_t>(type)];
  return value >= range.smallest && value <= range.largest && value == std::floor(value);
}

// One number of each point, or of each polygon, by the name that PLY has for it.
struct Property
{
  std::string name;
  Number_type type;
  std::vector<double> values;
};

// Adds three properties, the colors of all elements, if there are as many colors as elements.
inline void add_colors(std::vector<double>&& colors, std::size_t number_of_elements,
                       std::vector<Property>& properties)
{
  if (colors.empty() || colors.size() != 3 * number_of_elements)
    return;
  const char* const names[] = {"red", "green", "blue"};
  for (std::size_t i = 0; i < 3; ++i) {
    properties.push_back({names[i], Number_type::FLOAT64, {}});
    for (std::size_t k = i; k < colors.size(); k += 3)
      properties.back().values.push_back(colors[k]);
  }
}

// Points and polygons in the order of a file. A polygon may have any number of corners, also none.
// The points are finite, if a polygon uses them, and the corners are points.
struct Polygon_soup
{
  std::vector<Point> points;
  Number_type coordinate_type = Number_type::FLOAT64; // FLOAT32 if the file has no better
  std::vector<Index> corners;         // the corners of one polygon after the other
  std::vector<Index> first_corner{0}; // one per polygon, then the number of corners

  std::vector<Index> group_of_polygon; // by the objects and groups of a file; empty if it has none
  // The further properties of a file, if they are requested
  std::vector<Property> point_properties, polygon_properties;
  // The texture coordinates and normals, and the index of one of them, or null_index, for each
  // corner; all are empty if there are none
  std::vector<Texture_point> texture_coordinates;
  std::vector<Index> texture_of_corner;
  std::vector<Point> normals;
  std::vector<Index> normal_of_corner;
  // The materials, and the index of one of them, or null_index, for each polygon; both are empty if
  // there are none
  std::vector<Material> materials;
  std::vector<Index> material_of_polygon;
  std::vector<Image> images; // of the materials
  std::vector<std::string> material_files; // of the materials of OBJ, as it names them
  std::vector<std::string> warnings; // a message for each kind of data that was left out

  std::size_t number_of_polygons() const { return first_corner.size() - 1; }

  Polygon polygon(std::size_t i) const
  { return {corners.data() + first_corner[i], corners.data() + first_corner[i + 1]}; }

  // Ends the polygon that has the last corners.
  void end_polygon() { first_corner.push_back(static_cast<Index>(corners.size())); }
};

// Leaves out the corners at points that are not finite, with a warning. What is left of a polygon
// may be an edge, a point or nothing.
inline void remove_infinite_corners(Polygon_soup& soup)
{
  const std::size_t polygons = soup.number_of_polygons(), corners = soup.corners.size();
  std::size_t first_changed = polygons;
  Index size = 0; // of the corners that stay
  for (std::size_t i = 0, c = 0; i < polygons; ++i) {
    for (; c < soup.first_corner[i + 1]; ++c)
      if (is_finite(soup.points[soup.corners[c]])) {
        for (auto* list : {&soup.corners, &soup.texture_of_corner, &soup.normal_of_corner})
          if (!list->empty())
            (*list)[size] = (*list)[c];
        ++size;
      }
    soup.first_corner[i + 1] = size;
    if (c != size)
      first_changed = (std::min)(first_changed, i);
  }
  for (auto* list : {&soup.corners, &soup.texture_of_corner, &soup.normal_of_corner})
    list->resize((std::min)(list->size(), std::size_t(size)));
  if (first_changed < polygons)
    soup.warnings.push_back("face " + std::to_string(first_changed) + " uses a point that is not "
                            "finite; corners left out: " + std::to_string(corners - size));
}

// Multiplies all coordinates, including infinite ones.
inline void scale(Polygon_soup& soup, double factor)
{
  for (Point& p : soup.points)
    for (double& c : p)
      c *= factor;
  soup.coordinate_type = Number_type::FLOAT64;
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_POLYGON_SOUP_H
