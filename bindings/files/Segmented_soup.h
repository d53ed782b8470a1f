// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_SEGMENTED_SOUP_H
#define SEGMENT_MESH_MESH_FILE_SEGMENTED_SOUP_H

#include "Polygon_soup.h"
#include "Polygon_triangulation.h"
#include "decimal_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace mesh_file {

typedef std::array<std::uint8_t, 3> Rgb;

// A node of the tree of parts: a segment, or a part that was cut into others.
struct Part
{
  Index parent;  // comes before it in a list of parts, or null_index
  Index segment; // null_index for a part that was cut
  Index number;  // the number of the part, for its name
};

// The mesh that is written: polygons that belong to segments.
struct Segmented_soup
{
  const Polygon_soup& soup;
  const std::vector<Index>& segment; // one per polygon
  const std::vector<Rgb>& colors;    // one per segment
  std::vector<Part> parts = {};  // contain each segment once; empty if there is no tree
  std::vector<Index> faces = {}; // of the input that the polygons are or lie in, or null_index;
                                 // empty if the polygons are the faces of the input
  bool keeps_materials = false;  // writes the materials of the soup instead of the colors

  bool has_materials() const { return keeps_materials && !soup.materials.empty(); }
};

// Returns a number with at least three digits: 000, 001 ... 1000.
inline std::string three_digits(std::size_t number)
{
  const std::string digits = std::to_string(number);
  return std::string(3 - (std::min)(digits.size(), std::size_t(3)), '0') + digits;
}

// Returns the name of a segment: segment_000, segment_001 ... segment_1000.
inline std::string segment_name(std::size_t segment) { return "segment_" + three_digits(segment); }

inline std::string part_name(const Part& part)
{
  return part.segment == null_index ? "part_" + three_digits(part.number)
                                    : segment_name(part.segment);
}

// Returns the segments that have polygons, in ascending order.
inline std::vector<Index> present_segments(const Segmented_soup& mesh)
{
  std::vector<Index> result;
  for (Index s : mesh.segment)
    if (result.empty() || s != result.back())
      result.push_back(s);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Returns the tree of the segments that have polygons. They are all roots if the mesh has no tree.
inline std::vector<Part> present_parts(const Segmented_soup& mesh)
{
  std::vector<Part> result;
  const std::vector<Index> segments = present_segments(mesh);
  if (mesh.parts.empty()) {
    for (Index s : segments)
      result.push_back({null_index, s, s});
    return result;
  }
  std::vector<char> is_present(mesh.parts.size(), 0);
  for (std::size_t i = mesh.parts.size(); i-- > 0;) {
    const Part& p = mesh.parts[i];
    if (std::binary_search(segments.begin(), segments.end(), p.segment))
      is_present[i] = 1;
    if (is_present[i] && p.parent != null_index)
      is_present[p.parent] = 1;
  }
  std::vector<Index> place(mesh.parts.size());
  for (std::size_t i = 0; i < mesh.parts.size(); ++i)
    if (is_present[i]) {
      place[i] = static_cast<Index>(result.size());
      result.push_back(mesh.parts[i]);
      if (result.back().parent != null_index)
        result.back().parent = place[result.back().parent];
    }
  return result;
}

// Returns the polygons sorted by segment, those of one segment in ascending order.
inline std::vector<Index> polygons_sorted_by_segment(const Segmented_soup& mesh)
{
  std::vector<Index> result(mesh.segment.size());
  if (result.empty())
    return result;
  const auto [first, last] = std::minmax_element(mesh.segment.begin(), mesh.segment.end());
  const Index smallest = *first;
  std::vector<Index> next(std::size_t(*last) - smallest + 2, 0);
  for (Index s : mesh.segment)
    ++next[s - smallest + 1];
  for (std::size_t s = 1; s < next.size(); ++s)
    next[s] += next[s - 1];
  for (Index i = 0; i < mesh.segment.size(); ++i)
    result[next[mesh.segment[i] - smallest]++] = i;
  return result;
}

// Returns the material of a polygon; the number of materials stands for none.
inline Index material_of(const Polygon_soup& soup, std::size_t polygon)
{
  const Index result = soup.material_of_polygon[polygon];
  return result == null_index ? static_cast<Index>(soup.materials.size()) : result;
}

// Returns the materials of the polygons as by `material_of()`, in ascending order.
inline std::vector<Index> used_materials(const Polygon_soup& soup)
{
  std::vector<char> is_used(soup.materials.size() + 1, 0);
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i)
    is_used[material_of(soup, i)] = 1;
  std::vector<Index> result;
  for (Index m = 0; m < is_used.size(); ++m)
    if (is_used[m])
      result.push_back(m);
  return result;
}

// The points of the polygons, in the order of the soup. The other points need not be finite.
struct Used_points
{
  std::vector<Index> number; // one per point: its index among the used points, or null_index
  std::size_t size = 0;

  explicit Used_points(const Polygon_soup& soup) : number(soup.points.size(), null_index)
  {
    for (Index v : soup.corners)
      number[v] = 0;
    for (Index& n : number)
      if (n != null_index)
        n = static_cast<Index>(size++);
  }
};

inline std::vector<Triangle> triangles_of(const Polygon_soup& soup)
{
  std::vector<Triangle> result;
  result.reserve(soup.number_of_polygons());
  Polygon_triangulation triangulate(soup.points);
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i)
    triangulate(soup.polygon(i), result);
  return result;
}

// Returns a point in float, for formats without better numbers. Throws if a coordinate is too
// large.
inline std::array<float, 3> float_point(const Point& point, const char* format)
{
  std::array<float, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(point[k]) > (std::numeric_limits<float>::max)())
      throw std::runtime_error(std::string("a coordinate is too large for the numbers of ") +
                               format);
    result[k] = static_cast<float>(point[k]);
  }
  return result;
}

// Gives a stream large blocks, because a call for each number would take most of the time.
class Block_output
{
  static constexpr std::size_t size_of_block = 1 << 16;

  std::ostream& out_;
  std::string block_;

public:
  explicit Block_output(std::ostream& out) : out_(out) {}

  // Writes the current block. The caller must do so at the end.
  void flush()
  {
    out_.write(block_.data(), static_cast<std::streamsize>(block_.size()));
    block_.clear();
  }

  void text(std::string_view text)
  {
    block_ += text;
    if (block_.size() >= size_of_block)
      flush();
  }

  // Writes as few digits as distinguish the number from all others of its type.
  template <class Number>
  void decimal(Number number)
  {
    char digits[32];
    const char* const end = print_decimal(digits, number);
    text({digits, static_cast<std::size_t>(end - digits)});
  }

  // Writes the coordinates of a point with spaces between them.
  void decimal(const Point& point, Number_type type)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      if (k > 0)
        text(" ");
      if (type == Number_type::FLOAT32)
        decimal(static_cast<float>(point[k]));
      else
        decimal(point[k]);
    }
  }

  // Writes the bytes of a number, the lowest byte first.
  template <class Number>
  void binary(Number number)
  {
    typedef std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t> Bits;
    Bits bits;
    if constexpr (std::is_floating_point_v<Number>)
      std::memcpy(&bits, &number, sizeof bits);
    else
      bits = static_cast<Bits>(number);
    char bytes[sizeof(Number)];
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      bytes[i] = static_cast<char>(bits >> 8 * i);
    text({bytes, sizeof(Number)});
  }

  template <class Number>
  void binary(const std::array<Number, 3>& numbers)
  {
    for (Number n : numbers)
      binary(n);
  }
};

// Numbers elements in the order in which they are asked for.
class Renumbering
{
  std::vector<Index> number_; // one per element, or null_index
  std::vector<Index> elements_;

public:
  explicit Renumbering(std::size_t number_of_elements)
    : number_(number_of_elements, null_index) {}

  Index operator()(Index element)
  {
    if (element == null_index)
      return null_index;
    if (number_[element] == null_index) {
      number_[element] = static_cast<Index>(elements_.size());
      elements_.push_back(element);
    }
    return number_[element];
  }

  const std::vector<Index>& elements() const { return elements_; }

  // Removes all elements, in a time that depends only on their number.
  void clear()
  {
    for (Index i : elements_)
      number_[i] = null_index;
    elements_.clear();
  }
};

// Takes segments out of a mesh, one after the other, as meshes of their own.
class Segment_extraction
{
  const Segmented_soup mesh_;
  const std::vector<Index> sorted_; // the polygons
  Renumbering points_, textures_, normals_;

  template <class T>
  static std::vector<T> taken(const std::vector<T>& values, const std::vector<Index>& elements)
  {
    std::vector<T> result;
    result.reserve(elements.size());
    for (Index i : elements)
      result.push_back(values[i]);
    return result;
  }

  static void append_taken(const std::vector<Property>& properties,
                           const std::vector<Index>& elements, std::vector<Property>& result)
  {
    for (const Property& p : properties)
      result.push_back({p.name, p.type, taken(p.values, elements)});
  }

  std::vector<Index> polygons_of(std::size_t segment) const
  {
    const auto is_before = [this](Index i, std::size_t s) { return mesh_.segment[i] < s; };
    const auto begin = std::lower_bound(sorted_.begin(), sorted_.end(), segment, is_before);
    return {begin, std::lower_bound(begin, sorted_.end(), segment + 1, is_before)};
  }

public:
  explicit Segment_extraction(const Segmented_soup& mesh)
    : mesh_(mesh), sorted_(polygons_sorted_by_segment(mesh)), points_(mesh.soup.points.size()),
      textures_(mesh.soup.texture_coordinates.size()), normals_(mesh.soup.normals.size()) {}

  std::size_t number_of_segments() const { return mesh_.colors.size(); }

  // Returns a segment as a mesh, whose polygons have the further property `face`: their indices in
  // the input, or -1 for new ones.
  Polygon_soup operator()(std::size_t segment)
  {
    const Polygon_soup& soup = mesh_.soup;
    const std::vector<Index> polygons = polygons_of(segment);
    Polygon_soup result;
    result.coordinate_type = soup.coordinate_type;
    for (Index i : polygons) {
      for (std::size_t c = soup.first_corner[i]; c < soup.first_corner[i + 1]; ++c) {
        result.corners.push_back(points_(soup.corners[c]));
        if (!soup.texture_of_corner.empty())
          result.texture_of_corner.push_back(textures_(soup.texture_of_corner[c]));
        if (!soup.normal_of_corner.empty())
          result.normal_of_corner.push_back(normals_(soup.normal_of_corner[c]));
      }
      result.end_polygon();
    }
    result.points = taken(soup.points, points_.elements());
    result.texture_coordinates = taken(soup.texture_coordinates, textures_.elements());
    result.normals = taken(soup.normals, normals_.elements());
    append_taken(soup.point_properties, points_.elements(), result.point_properties);
    // If two properties have one name, the first is written.
    result.polygon_properties.push_back({"face", Number_type::INT32, {}});
    for (Index i : polygons) {
      const Index face = mesh_.faces.empty() ? i : mesh_.faces[i];
      result.polygon_properties[0].values.push_back(face == null_index ? -1. : double(face));
    }
    append_taken(soup.polygon_properties, polygons, result.polygon_properties);
    result.materials = soup.materials;
    result.images = soup.images;
    if (!soup.material_of_polygon.empty())
      result.material_of_polygon = taken(soup.material_of_polygon, polygons);
    for (Renumbering* r : {&points_, &textures_, &normals_})
      r->clear();
    return result;
  }
};

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_SEGMENTED_SOUP_H
