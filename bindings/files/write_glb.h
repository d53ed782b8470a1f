// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_WRITE_GLB_H
#define SEGMENT_MESH_MESH_FILE_WRITE_GLB_H

#include "Segmented_soup.h"
#include "gltf_materials.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mesh_file {

// Throws if a file of glTF cannot have so many bytes.
inline void check_size_of_glb(std::uint64_t size)
{
  if (size > (std::numeric_limits<std::uint32_t>::max)())
    throw std::runtime_error("the mesh is too large for GLB, which has 4 GB at most");
}

// Writes the binary form of glTF 2.0: a root node, and below it the tree of parts. Each segment
// that has polygons is a node with a mesh. Its material is its color, without normals, for which
// programs have to shade each triangle by itself; or the mesh has a primitive for each of its
// materials, with texture coordinates and normals as far as the soup has them.
//
// The description, which comes first, needs the sizes: so the segments are taken out twice.
class Glb_writer
{
  typedef nlohmann::json Json; // its references stay valid, unlike those of ordered_json

  enum Component_type { UNSIGNED_INT = 5125, FLOAT = 5126 };
  enum Target { ARRAY_BUFFER = 34962, ELEMENT_ARRAY_BUFFER = 34963 };

  const Segmented_soup& mesh_;
  Block_output out_;
  Segment_extraction extract_;
  Renumbering materials_, images_;
  Json json_;
  std::set<std::string> extensions_; // in use
  std::uint64_t size_of_data_ = 0;

  // The part of a mesh with one material. The corners of the soup are vertices, each of which has
  // one of the texture coordinates and normals.
  struct Primitive
  {
    Index material; // or the segment for its color
    Polygon_soup soup;
    std::vector<Triangle> triangles;
    std::vector<Texture_point> textures; // one per vertex, or none
    std::vector<Point> normals;          // one per vertex, or none
  };

  // Splits the points that have different texture coordinates or normals.
  static void split_vertices(Primitive& primitive)
  {
    typedef std::array<Index, 3> Vertex; // a point, its texture coordinates and normal
    Polygon_soup& soup = primitive.soup;
    std::vector<Vertex> corners;
    for (std::size_t c = 0; c < soup.corners.size(); ++c)
      corners.push_back({soup.corners[c],
                         soup.texture_of_corner.empty() ? null_index : soup.texture_of_corner[c],
                         soup.normal_of_corner.empty() ? null_index : soup.normal_of_corner[c]});
    std::vector<Vertex> vertices = corners;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (std::size_t c = 0; c < corners.size(); ++c)
      soup.corners[c] = static_cast<Index>(
        std::lower_bound(vertices.begin(), vertices.end(), corners[c]) - vertices.begin());

    bool has_textures = false, has_normals = true;
    std::vector<Point> points;
    for (const auto& [point, texture, normal] : vertices) {
      points.push_back(soup.points[point]);
      primitive.textures.push_back(texture == null_index ? Texture_point{}
                                                         : soup.texture_coordinates[texture]);
      primitive.normals.push_back(unit_vector(normal == null_index ? Point{}
                                                                   : soup.normals[normal]));
      has_textures |= texture != null_index;
      has_normals &= primitive.normals.back() != Point{};
    }
    soup.points = std::move(points);
    if (!has_textures)
      primitive.textures.clear();
    if (!has_normals)
      primitive.normals.clear();
  }

  // Returns a vector of length 1, or 0 if there is no direction.
  static Point unit_vector(const Point& v)
  {
    const double length = std::hypot(v[0], v[1], v[2]);
    return length > 0 && std::isfinite(length) ? Point{v[0] / length, v[1] / length, v[2] / length}
                                               : Point{};
  }

  std::vector<Primitive> primitives_of(Index segment)
  {
    std::vector<Primitive> result;
    Polygon_soup soup = extract_(segment);
    if (mesh_.has_materials()) {
      std::vector<Index> materials(soup.number_of_polygons());
      for (std::size_t i = 0; i < materials.size(); ++i)
        materials[i] = material_of(soup, i);
      const Segmented_soup by_material{soup, materials, mesh_.colors};
      Segment_extraction extract(by_material);
      for (Index m : present_segments(by_material)) {
        result.push_back({m, extract(m), {}, {}, {}});
        split_vertices(result.back());
      }
    }
    else
      result.push_back({segment, std::move(soup), {}, {}, {}});
    for (Primitive& p : result)
      p.triangles = triangles_of(p.soup);
    result.erase(std::remove_if(result.begin(), result.end(), [](const Primitive& p)
                                { return p.triangles.empty(); }), result.end());
    return result;
  }

  // Adds an accessor to the next data, and returns its index.
  std::size_t add_accessor(std::size_t count, std::size_t components, Component_type type,
                           Target target)
  {
    static const char* const types[] = {"SCALAR", "VEC2", "VEC3"};
    Json& accessors = json_["accessors"];
    const std::size_t view = add_view(std::uint64_t(4) * components * count);
    json_["bufferViews"][view]["target"] = target;
    accessors.push_back(Json{{"bufferView", view}, {"componentType", type},
                             {"count", count}, {"type", types[components - 1]}});
    return accessors.size() - 1;
  }

  // Adds a view of the next data, and returns its index. It begins at a multiple of 4 bytes.
  std::size_t add_view(std::uint64_t size)
  {
    Json& views = json_["bufferViews"];
    views.push_back(Json{{"buffer", 0}, {"byteOffset", size_of_data_}, {"byteLength", size}});
    size_of_data_ += size + padding(size);
    return views.size() - 1;
  }

  static std::size_t padding(std::uint64_t size) { return static_cast<std::size_t>(-size % 4); }

  // Returns the number of sets of texture coordinates that are written.
  std::size_t number_of_sets(const Primitive& p) const
  {
    const std::vector<Material>& materials = mesh_.soup.materials;
    const bool uses_second = p.material < materials.size() &&
      materials[p.material].gltf.find("\"texCoord\":1") != std::string::npos;
    return p.textures.empty() ? 0 : uses_second ? 2 : 1;
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

  static Json plain_material(const std::string& name, const Rgb& color)
  {
    return {{"name", name},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {linear_intensity(color[0] / 255.),
                                   linear_intensity(color[1] / 255.),
                                   linear_intensity(color[2] / 255.), 1.}},
              {"metallicFactor", 0.}}},
            {"doubleSided", true}};
  }

  // Adds the textures of a material, each with its own sampler if it has one, and returns its
  // description.
  Json kept_material(const Material& material)
  {
    Json result = Json::parse(material.gltf, nullptr, false);
    if (!result.is_object())
      result = Json::object();
    result["name"] = material.name;
    for_each_texture(result, [&](Json& texture) {
      Json& textures = json_["textures"];
      textures.push_back(
        Json{{"source", images_(static_cast<Index>(texture["index"].get<std::size_t>()))}});
      if (texture.contains("sampler")) {
        textures.back()["sampler"] = json_["samplers"].size();
        json_["samplers"].push_back(texture["sampler"]);
        texture.erase("sampler");
      }
      texture["index"] = textures.size() - 1;
    });
    add_extensions(result);
    return result;
  }

  // Lists the extensions that a material uses.
  void add_extensions(const Json& json)
  {
    if (!json.is_object())
      return;
    for (const auto& [key, value] : json.items()) {
      if (key == "extensions")
        for (const auto& extension : value.items())
          extensions_.insert(extension.key());
      add_extensions(value);
    }
  }

  // Returns the index of the material in the file.
  Index add_material(Index material)
  {
    const Index result = materials_(material);
    if (result < json_["materials"].size())
      return result;
    const std::size_t n = mesh_.soup.materials.size();
    json_["materials"].push_back(
      !mesh_.has_materials()
        ? plain_material(segment_name(material), mesh_.colors[material])
        : material == n ? plain_material("plain", {204, 204, 204})
                        : kept_material(mesh_.soup.materials[material]));
    return result;
  }

  // Adds the images of all materials, which must have been added before.
  void add_images()
  {
    for (Index i : images_.elements()) {
      const Image& image = mesh_.soup.images[i];
      Json json = Json::object();
      if (image.name[0] != '*') // which those in the file of the input have
        json["name"] = image.name;
      if (image.bytes) {
        json["bufferView"] = add_view(image.bytes->size());
        json["mimeType"] = "image/" + type_of(image);
      }
      else
        json["uri"] = image.name;
      json_["images"].push_back(json);
    }
  }

  // Adds a mesh to a node, unless the segment has no triangles: a mesh may not be empty.
  void add_mesh(Index segment, Json& node)
  {
    Json primitives = Json::array();
    for (const Primitive& p : primitives_of(segment)) {
      Json attributes{{"POSITION", add_points(p.soup.points)}};
      for (std::size_t set = 0; set < number_of_sets(p); ++set)
        attributes["TEXCOORD_" + std::to_string(set)] =
          add_accessor(p.textures.size(), 2, FLOAT, ARRAY_BUFFER);
      if (!p.normals.empty())
        attributes["NORMAL"] = add_accessor(p.normals.size(), 3, FLOAT, ARRAY_BUFFER);
      const std::size_t corners =
        add_accessor(3 * p.triangles.size(), 1, UNSIGNED_INT, ELEMENT_ARRAY_BUFFER);
      primitives.push_back(Json{{"attributes", attributes}, {"indices", corners},
                                {"material", add_material(p.material)}});
    }
    if (primitives.empty())
      return;
    Json& meshes = json_["meshes"];
    node["mesh"] = meshes.size();
    meshes.push_back(Json{{"name", segment_name(segment)}, {"primitives", primitives}});
  }

  // Adds the i-th part as the node i + 1.
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
    for (const Primitive& p : primitives_of(segment)) {
      for (const Point& q : p.soup.points)
        out_.binary(float_point(q, "GLB"));
      for (std::size_t set = 0; set < number_of_sets(p); ++set)
        for (const Texture_point& t : p.textures) { // v points downwards
          out_.binary(texture_number(t[2 * set]));
          out_.binary(texture_number(1 - t[2 * set + 1]));
        }
      for (const Point& n : p.normals)
        out_.binary(float_point(n, "GLB"));
      for (const Triangle& t : p.triangles)
        out_.binary(t);
    }
  }

  static float texture_number(double number)
  {
    const bool is_number = std::abs(number) <= (std::numeric_limits<float>::max)();
    return is_number ? static_cast<float>(number) : 0;
  }

  void put_images()
  {
    for (Index i : images_.elements())
      if (const auto& bytes = mesh_.soup.images[i].bytes) {
        out_.text(*bytes);
        out_.text(std::string(padding(bytes->size()), '\0'));
      }
  }

  void put_start_of_chunk(std::uint64_t size, std::string_view type)
  {
    out_.binary(static_cast<std::uint32_t>(size));
    out_.text(type);
  }

public:
  Glb_writer(std::ostream& out, const Segmented_soup& mesh)
    : mesh_(mesh), out_(out), extract_(mesh),
      materials_((std::max)(mesh.soup.materials.size() + 1, mesh.colors.size())),
      images_(mesh.soup.images.size()) {}

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
    add_images();
    if (!extensions_.empty())
      json_["extensionsUsed"] = extensions_;
    if (size_of_data_ > 0)
      json_["buffers"] = Json::array({{{"byteLength", size_of_data_}}});
    // Names may be in any encoding.
    std::string description = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
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
    put_images();
    out_.flush();
  }
};

// Writes binary glTF. Throws if the coordinates or the mesh are too large for the format.
inline void write_glb(std::ostream& out, const Segmented_soup& mesh) { Glb_writer(out, mesh)(); }

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_WRITE_GLB_H
