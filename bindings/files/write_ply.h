// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_WRITE_PLY_H
#define SEGMENT_MESH_MESH_FILE_WRITE_PLY_H

#include "Segmented_soup.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace mesh_file {

// Writes a mesh in binary PLY. Programs that show colors look for those of the points, so a point
// at which segments meet is written once for each. The polygons come in their order, each with its
// `segment` and its color. Further properties of points and polygons follow, except those whose
// name is in use.
class Ply_writer
{
  typedef std::vector<const Property*> Properties;

  const Segmented_soup& mesh_;
  Block_output out_;
  const Used_points used_;
  std::vector<Index> segment_;                   // the first segment of each point, or null_index
  std::vector<std::pair<Index, Index> > copies_; // further segments of points, sorted

  static std::string declaration(Number_type type, const std::string& name)
  {
    static const char* const types[] = {"char", "uchar", "short", "ushort",
                                        "int",  "uint",  "float", "double"};
    return std::string(types[static_cast<int>(type)]) + " " + name;
  }

  static std::string property(Number_type type, const std::string& name)
  { return "property " + declaration(type, name) + "\n"; }

  static std::string properties(Number_type type, const std::vector<std::string>& names)
  {
    std::string result;
    for (const std::string& name : names)
      result += property(type, name);
    return result;
  }

  static std::string properties(const Properties& properties)
  {
    std::string result;
    for (const Property* p : properties)
      result += property(p->type, p->name);
    return result;
  }

  // Returns the properties whose name is not in use. The opacity is left out with the colors that
  // are replaced.
  static Properties further(const std::vector<Property>& properties,
                            std::set<std::string> taken)
  {
    taken.insert({"red", "green", "blue", "alpha"});
    Properties result;
    for (const Property& p : properties)
      if (taken.insert(p.name).second)
        result.push_back(&p);
    return result;
  }

  void put(Number_type type, double value)
  {
    switch (type) {
      case Number_type::INT8: out_.binary(static_cast<std::int8_t>(value)); break;
      case Number_type::UINT8: out_.binary(static_cast<std::uint8_t>(value)); break;
      case Number_type::INT16: out_.binary(static_cast<std::int16_t>(value)); break;
      case Number_type::UINT16: out_.binary(static_cast<std::uint16_t>(value)); break;
      case Number_type::INT32: out_.binary(static_cast<std::int32_t>(value)); break;
      case Number_type::UINT32: out_.binary(static_cast<std::uint32_t>(value)); break;
      case Number_type::FLOAT32: out_.binary(static_cast<float>(value)); break;
      default: out_.binary(value);
    }
  }

  void put(const Properties& properties, std::size_t element)
  {
    for (const Property* p : properties)
      put(p->type, p->values[element]);
  }

  void put_point(Index v, Index segment, const Properties& properties)
  {
    for (double c : mesh_.soup.points[v])
      put(mesh_.soup.coordinate_type, c);
    out_.binary(mesh_.colors[segment]);
    put(properties, v);
  }

  void split_points()
  {
    const Polygon_soup& soup = mesh_.soup;
    segment_.assign(soup.points.size(), null_index);
    for (std::size_t i = 0; i < soup.number_of_polygons(); ++i)
      for (Index v : soup.polygon(i))
        if (segment_[v] == null_index)
          segment_[v] = mesh_.segment[i];
        else if (segment_[v] != mesh_.segment[i])
          copies_.emplace_back(v, mesh_.segment[i]);
    std::sort(copies_.begin(), copies_.end());
    copies_.erase(std::unique(copies_.begin(), copies_.end()), copies_.end());
  }

  Index number(Index point, Index segment) const
  {
    if (segment_[point] == segment)
      return used_.number[point];
    const auto copy =
      std::lower_bound(copies_.begin(), copies_.end(), std::make_pair(point, segment));
    return static_cast<Index>(used_.size + static_cast<std::size_t>(copy - copies_.begin()));
  }

  // Returns the type of the number of corners of a polygon.
  Number_type size_type() const
  {
    std::size_t largest = 0;
    for (std::size_t i = 0; i < mesh_.soup.number_of_polygons(); ++i)
      largest = (std::max)(largest, mesh_.soup.polygon(i).size());
    return largest < 256 ? Number_type::UINT8 : Number_type::UINT32;
  }

public:
  Ply_writer(std::ostream& out, const Segmented_soup& mesh)
    : mesh_(mesh), out_(out), used_(mesh.soup) { split_points(); }

  void operator()()
  {
    const Polygon_soup& soup = mesh_.soup;
    const Number_type size = size_type();
    const Properties of_points = further(soup.point_properties, {"x", "y", "z"});
    const Properties of_polygons = further(soup.polygon_properties, {"vertex_indices", "segment"});
    const std::string colors = properties(Number_type::UINT8, {"red", "green", "blue"});

    out_.text("ply\nformat binary_little_endian 1.0\nelement vertex " +
              std::to_string(used_.size + copies_.size()) + "\n" +
              properties(soup.coordinate_type, {"x", "y", "z"}) + colors + properties(of_points) +
              "element face " + std::to_string(soup.number_of_polygons()) + "\nproperty list " +
              declaration(size, "int vertex_indices\n") +
              property(Number_type::INT32, "segment") + colors + properties(of_polygons) +
              "end_header\n");
    for (Index v = 0; v < soup.points.size(); ++v)
      if (segment_[v] != null_index)
        put_point(v, segment_[v], of_points);
    for (const auto& [v, segment] : copies_)
      put_point(v, segment, of_points);
    for (std::size_t i = 0; i < soup.number_of_polygons(); ++i) {
      const Polygon polygon = soup.polygon(i);
      put(size, static_cast<double>(polygon.size()));
      for (Index v : polygon)
        out_.binary(number(v, mesh_.segment[i]));
      out_.binary(mesh_.segment[i]);
      out_.binary(mesh_.colors[mesh_.segment[i]]);
      put(of_polygons, i);
    }
    out_.flush();
  }
};

inline void write_ply(std::ostream& out, const Segmented_soup& mesh) { Ply_writer(out, mesh)(); }

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_WRITE_PLY_H
