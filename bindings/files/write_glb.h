// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_WRITE_GLB_H
#define SEGMENT_MESH_MESH_FILE_WRITE_GLB_H

#include "Segmented_mesh.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mesh_file {

// Returns the linear intensity of a channel of sRGB, by IEC 61966-2-1.
inline double linear_intensity(std::uint8_t channel)
{
  const double c = channel / 255.;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// Throws if a file of glTF cannot have so many bytes.
inline void check_size_of_glb(std::uint64_t size)
{
  if (size > (std::numeric_limits<std::uint32_t>::max)())
    throw std::runtime_error("the mesh is too large for GLB, which has 4 GB at most");
}

// Writes the binary form of glTF 2.0: a root node, and below it the tree of parts. Each segment
// that has polygons is a node with a mesh and a material. There are no normals, for which programs
// have to shade each triangle by itself.
//
// The description, which comes first, needs the sizes: so the segments are taken out twice.
class Glb_writer
{
  typedef nlohmann::json Json; // its references stay valid, unlike those of ordered_json

  enum Component_type { UNSIGNED_INT = 5125, FLOAT = 5126 };
  enum Target { ARRAY_BUFFER = 34962, ELEMENT_ARRAY_BUFFER = 34963 };

  const Segmented_mesh& mesh_;
  Block_output out_;
  Segment_extraction extract_;
  Json json_;
  std::uint64_t size_of_data_ = 0;

  // Its data come next. Returns its number.
  std::size_t add_accessor(std::size_t count, std::size_t components, Component_type type,
                           Target target)
  {
    Json& views = json_["bufferViews"];
    Json& accessors = json_["accessors"];
    const std::uint64_t size = std::uint64_t(4) * components * count;
    accessors.push_back(Json{{"bufferView", views.size()}, {"componentType", type},
                             {"count", count}, {"type", components == 3 ? "VEC3" : "SCALAR"}});
    views.push_back(Json{{"buffer", 0}, {"byteOffset", size_of_data_}, {"byteLength", size},
                         {"target", target}});
    size_of_data_ += size;
    return accessors.size() - 1;
  }

  std::size_t add_points(const std::vector<Point>& points)
  {
    std::array<float, 3> smallest = float_point(points[0], "GLB"), largest = smallest;
    for (const Point& p : points) {
      const std::array<float, 3> q = float_point(p, "GLB");
      for (std::size_t k = 0; k < 3; ++k) {
        smallest[k] = (std::min)(smallest[k], q[k]);
        largest[k] = (std::max)(largest[k], q[k]);
      }
    }
    const std::size_t result = add_accessor(points.size(), 3, FLOAT, ARRAY_BUFFER);
    json_["accessors"][result]["min"] = smallest;
    json_["accessors"][result]["max"] = largest;
    return result;
  }

  void add_material(Index segment)
  {
    const Rgb& color = mesh_.colors[segment];
    json_["materials"].push_back(
      Json{{"name", segment_name(segment)},
           {"pbrMetallicRoughness",
            {{"baseColorFactor", {linear_intensity(color[0]), linear_intensity(color[1]),
                                  linear_intensity(color[2]), 1.}},
             {"metallicFactor", 0.}}},
           {"doubleSided", true}});
  }

  // A segment without triangles has no mesh, as that may not be empty.
  void add_mesh(Index segment, Json& node)
  {
    const Polygon_soup soup = extract_(segment);
    const std::vector<Triangle> triangles = triangles_of(soup);
    if (triangles.empty())
      return;
    Json& meshes = json_["meshes"];
    node["mesh"] = meshes.size();
    const std::size_t points = add_points(soup.points);
    const std::size_t corners =
      add_accessor(3 * triangles.size(), 1, UNSIGNED_INT, ELEMENT_ARRAY_BUFFER);
    Json primitive{{"attributes", {{"POSITION", points}}}, {"indices", corners},
                   {"material", meshes.size()}};
    add_material(segment);
    meshes.push_back(
      Json{{"name", segment_name(segment)}, {"primitives", Json::array({primitive})}});
  }

  // The i-th part is the node i + 1.
  void add_part(const Part& part)
  {
    Json node{{"name", part_name(part)}};
    if (part.segment != null_index)
      add_mesh(part.segment, node);
    Json& nodes = json_["nodes"];
    const std::size_t parent = part.parent == null_index ? 0 : std::size_t(part.parent) + 1;
    nodes[parent]["children"].push_back(nodes.size());
    nodes.push_back(node);
  }

  void put_mesh(Index segment)
  {
    const Polygon_soup soup = extract_(segment);
    const std::vector<Triangle> triangles = triangles_of(soup);
    if (triangles.empty())
      return;
    for (const Point& p : soup.points)
      out_.binary(float_point(p, "GLB"));
    for (const Triangle& t : triangles)
      out_.binary(t);
  }

  void put_start_of_chunk(std::uint64_t size, std::string_view type)
  {
    out_.binary(static_cast<std::uint32_t>(size));
    out_.text(type);
  }

public:
  Glb_writer(std::ostream& out, const Segmented_mesh& mesh)
    : mesh_(mesh), out_(out), extract_(mesh) {}

  void operator()()
  {
    using std::string_view_literals::operator""sv;
    const std::vector<Part> parts = present_parts(mesh_);
    json_ = {{"asset", {{"version", "2.0"}, {"generator", "segment_mesh"}}},
             {"scene", 0},
             {"scenes", Json::array({{{"nodes", {0}}}})},
             {"nodes", Json::array({{{"name", "segments"}}})}};
    for (const Part& p : parts)
      add_part(p);
    if (size_of_data_ > 0)
      json_["buffers"] = Json::array({{{"byteLength", size_of_data_}}});
    std::string description = json_.dump();
    description.resize((description.size() + 3) / 4 * 4, ' ');
    const std::uint64_t size =
      12 + 8 + description.size() + (size_of_data_ > 0 ? 8 + size_of_data_ : 0);
    check_size_of_glb(size);

    out_.text("glTF\2\0\0\0"sv);
    out_.binary(static_cast<std::uint32_t>(size));
    put_start_of_chunk(description.size(), "JSON"sv);
    out_.text(description);
    if (size_of_data_ > 0)
      put_start_of_chunk(size_of_data_, "BIN\0"sv);
    for (const Part& p : parts)
      if (p.segment != null_index)
        put_mesh(p.segment);
    out_.flush();
  }
};

// Throws if the coordinates or the mesh are too large for the format.
inline void write_glb(std::ostream& out, const Segmented_mesh& mesh) { Glb_writer(out, mesh)(); }

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_WRITE_GLB_H
