// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_READ_BY_ASSIMP_H
#define SEGMENT_MESH_READ_BY_ASSIMP_H

#include "mesh_file/Point_numbering.h"
#include "mesh_file/Polygon_soup.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#if defined(SEGMENT_MESH_WITH_ASSIMP) && (defined(__unix__) || defined(__APPLE__))
#define SEGMENT_MESH_READS_BY_ASSIMP
#endif

#ifdef SEGMENT_MESH_READS_BY_ASSIMP
#include "read_in_child_process.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Exceptional.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>
#endif

namespace segment_mesh {

// The meshes of a file at all nodes that show them. Each polygon has the number of its node and of
// its mesh, as the polygon properties "node" and "mesh".
struct Scene
{
  mesh_file::Polygon_soup soup;
  std::vector<std::string> node_names, mesh_names; // as in the file, but without control characters
};

// What a file may make the program do.
struct Reading_limits
{
  double seconds = std::numeric_limits<double>::infinity();
  bool allows_external_files = false; // files outside of its folder, which it names
};

#ifdef SEGMENT_MESH_READS_BY_ASSIMP

// The polygons of one mesh at one node; they come after those of the instance before.
struct Mesh_instance
{
  mesh_file::Index node, mesh, end_of_polygons;
};

// Lists the polygons of a scene, in the child process. Points and lines are no polygons. The
// vertices of a mesh that differ only in a normal or the like become one point.
class Scene_flattening
{
  typedef mesh_file::Index Index;
  typedef aiMatrix4x4t<double> Transformation;

  // The points of one mesh.
  struct Local_points
  {
    std::vector<mesh_file::Point> points;
    std::vector<Index> point_of_vertex; // null_index if no polygon uses it
  };

  static bool is_polygon(const aiFace& face) { return face.mNumIndices >= 3; }

  static Local_points local_points(const aiMesh& mesh)
  {
    Local_points result;
    result.point_of_vertex.assign(mesh.mNumVertices, mesh_file::null_index);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f)
      if (is_polygon(mesh.mFaces[f]))
        for (unsigned i = 0; i < mesh.mFaces[f].mNumIndices; ++i) {
          if (mesh.mFaces[f].mIndices[i] >= mesh.mNumVertices)
            throw std::runtime_error("a face has a corner that is no point");
          result.point_of_vertex[mesh.mFaces[f].mIndices[i]] = 0;
        }
    mesh_file::Point_numbering number(result.points);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      if (result.point_of_vertex[v] != mesh_file::null_index) {
        const aiVector3D& p = mesh.mVertices[v];
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
          throw std::runtime_error("a coordinate is not finite");
        result.point_of_vertex[v] = number({p.x, p.y, p.z});
      }
    return result;
  }

  const aiScene& scene_;
  std::vector<Local_points> local_points_; // one per mesh

  void add_points(const std::vector<mesh_file::Point>& points, const Transformation& transformation)
  {
    for (const mesh_file::Point& p : points) {
      const aiVector3t<double> q = transformation * aiVector3t<double>(p[0], p[1], p[2]);
      soup.points.push_back({q.x, q.y, q.z});
    }
    if (soup.points.size() >= mesh_file::null_index)
      throw std::runtime_error("there are too many points");
  }

  void add_instance(const Transformation& transformation, Index node, Index mesh)
  {
    if (mesh >= scene_.mNumMeshes)
      throw std::runtime_error("a node has a mesh that is not there");
    const Index first_point = static_cast<Index>(soup.points.size());
    add_points(local_points_[mesh].points, transformation);
    const bool is_mirrored = transformation.Determinant() < 0;
    for (unsigned f = 0; f < scene_.mMeshes[mesh]->mNumFaces; ++f) {
      const aiFace& face = scene_.mMeshes[mesh]->mFaces[f];
      if (!is_polygon(face))
        continue;
      for (unsigned i = 0; i < face.mNumIndices; ++i)
        soup.corners.push_back(first_point + local_points_[mesh].point_of_vertex[face.mIndices[i]]);
      if (is_mirrored)
        std::reverse(soup.corners.end() - face.mNumIndices, soup.corners.end());
      if (soup.corners.size() >= mesh_file::null_index)
        throw std::runtime_error("there are too many corners");
      soup.end_polygon();
    }
    instances.push_back({node, mesh, static_cast<Index>(soup.number_of_polygons())});
  }

  // A node before its children.
  void add_node(const aiNode& node, const Transformation& transformation_of_parent)
  {
    const Transformation transformation =
      transformation_of_parent * static_cast<Transformation>(node.mTransformation);
    const Index number = number_of_nodes_++;
    append_name(node.mName, node_names);
    if (node.mNumMeshes > 0 && transformation != Transformation())
      soup.coordinate_type = mesh_file::Number_type::FLOAT64;
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      add_instance(transformation, number, node.mMeshes[i]);
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      if (!node.mChildren[i])
        throw std::runtime_error("a node is not there");
      add_node(*node.mChildren[i], transformation);
    }
  }

  static void append_name(const aiString& name, std::vector<char>& names)
  {
    const std::string_view text = name.C_Str();
    names.insert(names.end(), text.begin(), text.end());
    names.push_back('\0');
  }

  Index number_of_nodes_ = 0;

public:
  mesh_file::Polygon_soup soup;
  std::vector<Mesh_instance> instances;
  std::vector<char> node_names, mesh_names; // each ends with a zero

  explicit Scene_flattening(const aiScene& scene) : scene_(scene)
  {
    soup.coordinate_type = mesh_file::Number_type::FLOAT32;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      local_points_.push_back(local_points(*scene.mMeshes[i]));
      append_name(scene.mMeshes[i]->mName, mesh_names);
    }
    if (scene.mRootNode)
      add_node(*scene.mRootNode, Transformation());
  }
};

inline bool is_clear_sentence(std::string_view text)
{
  return !text.empty() && text.size() < 300 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

// Returns the message of Assimp about a file that it does not read, in one line, if it is in clear
// words.
inline std::string error_sentence(const Assimp::Importer& importer)
{
  const std::string own_sentence = "it is not a valid file of its format";
  try {
    if (importer.GetException())
      std::rethrow_exception(importer.GetException());
  }
  catch (const DeadlyErrorBase&) {
  }
  catch (...) { // words of the standard library
    return own_sentence;
  }
  std::string result = importer.GetErrorString();
  std::replace_if(result.begin(), result.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  result.erase(result.find_last_not_of(' ') + 1);
  return is_clear_sentence(result) ? result : own_sentence;
}

// The file that the user has named, and the files in its folder, also behind links: the file names
// them, and who has made it may not be trusted. Other files are not there for Assimp.
class Files_of_folder : public Assimp::DefaultIOSystem
{
  const std::string name_;
  const std::filesystem::path folder_;
  mutable std::string refused_;

  bool is_allowed(const std::string& name) const
  {
    std::error_code error;
    const std::filesystem::path file = std::filesystem::canonical(name, error);
    if (name == name_ || error) // what does not exist cannot be opened
      return true;
    const bool is_inside =
      std::mismatch(folder_.begin(), folder_.end(), file.begin(), file.end()).first ==
      folder_.end();
    if (is_inside && is_regular_file(file))
      return true;
    if (refused_.empty())
      refused_ = name;
    return false;
  }

public:
  explicit Files_of_folder(const std::string& name)
    : name_(name), folder_(std::filesystem::canonical(name).parent_path()) {}

  bool Exists(const char* name) const override
  { return is_allowed(name) && DefaultIOSystem::Exists(name); }

  Assimp::IOStream* Open(const char* name, const char* mode) override
  { return is_allowed(name) ? DefaultIOSystem::Open(name, mode) : nullptr; }

  // Returns a sentence about a file that was not opened, or an empty one.
  std::string error() const
  {
    if (refused_.empty())
      return "";
    std::string name = refused_.substr(0, 100);
    std::replace_if(name.begin(), name.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return "it names " + name + ", which is no file in its folder; --allow-external-files reads it";
  }
};

// In the child process: sends an error sentence, which may be empty, and the scene.
inline void send_scene(const std::string& name, bool allows_external_files, Child_output output)
{
  Assimp::Importer importer;
  Files_of_folder* const files = allows_external_files ? nullptr : new Files_of_folder(name);
  importer.SetIOHandler(files); // which owns them; without, any file may be read
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const auto send_error = [&](const std::string& sentence)
  { output.send(std::vector<char>(sentence.begin(), sentence.end())); };
  const aiScene* const scene = importer.ReadFile(name, 0);
  if (files && !files->error().empty())
    return send_error(files->error());
  if (!scene)
    return send_error(error_sentence(importer));
  try {
    const Scene_flattening flattening(*scene);
    send_error("");
    output.send(std::vector<mesh_file::Number_type>{flattening.soup.coordinate_type});
    output.send(flattening.soup.points);
    output.send(flattening.soup.corners);
    output.send(flattening.soup.first_corner);
    output.send(flattening.instances);
    output.send(flattening.node_names);
    output.send(flattening.mesh_names);
  }
  catch (const std::runtime_error& e) {
    send_error(e.what());
  }
}

// Takes the scene from the child process, and believes nothing.
class Scene_receiver
{
  typedef mesh_file::Index Index;

  Child_process& child_;

  static void check(bool condition)
  {
    if (!condition)
      throw std::runtime_error("the reader of this format crashed");
  }

  std::vector<std::string> receive_names()
  {
    std::vector<std::string> result;
    const std::vector<char> names = child_.receive<char>();
    for (auto i = names.begin(); i != names.end();) {
      const auto end = std::find(i, names.end(), '\0');
      check(end != names.end());
      result.emplace_back(i, end);
      std::replace_if(result.back().begin(), result.back().end(),
                      [](char c) { return (c >= 0 && c < ' ') || c == 127; }, '?');
      i = end + 1;
    }
    return result;
  }

  mesh_file::Polygon_soup receive_soup()
  {
    mesh_file::Polygon_soup soup;
    const std::vector<mesh_file::Number_type> type = child_.receive<mesh_file::Number_type>();
    check(type.size() == 1);
    soup.coordinate_type = type[0] == mesh_file::Number_type::FLOAT32
      ? mesh_file::Number_type::FLOAT32 : mesh_file::Number_type::FLOAT64;
    soup.points = child_.receive<mesh_file::Point>();
    for (const mesh_file::Point& p : soup.points)
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
        throw std::runtime_error("a coordinate is not finite"); // a transformation may do this
    soup.corners = child_.receive<Index>();
    check(std::all_of(soup.corners.begin(), soup.corners.end(),
                      [&](Index v) { return v < soup.points.size(); }));
    soup.first_corner = child_.receive<Index>();
    check(!soup.first_corner.empty() && soup.first_corner.front() == 0 &&
          soup.first_corner.back() == soup.corners.size() &&
          std::is_sorted(soup.first_corner.begin(), soup.first_corner.end()));
    return soup;
  }

  static void add_properties(const std::vector<Mesh_instance>& instances, Scene& scene)
  {
    std::vector<double> nodes, meshes;
    nodes.reserve(scene.soup.number_of_polygons());
    meshes.reserve(scene.soup.number_of_polygons());
    for (const Mesh_instance& i : instances) {
      check(i.node < scene.node_names.size() && i.mesh < scene.mesh_names.size() &&
            nodes.size() <= i.end_of_polygons &&
            i.end_of_polygons <= scene.soup.number_of_polygons());
      nodes.resize(i.end_of_polygons, i.node);
      meshes.resize(i.end_of_polygons, i.mesh);
    }
    check(nodes.size() == scene.soup.number_of_polygons());
    scene.soup.group_of_polygon.assign(nodes.begin(), nodes.end());
    scene.soup.polygon_properties = {{"node", mesh_file::Number_type::INT32, std::move(nodes)},
                                     {"mesh", mesh_file::Number_type::INT32, std::move(meshes)}};
  }

public:
  explicit Scene_receiver(Child_process& child) : child_(child) {}

  Scene operator()()
  {
    const std::vector<char> bytes = child_.receive<char>();
    const std::string error(bytes.begin(), bytes.end());
    if (!error.empty()) {
      check(is_clear_sentence(error));
      throw std::runtime_error(error);
    }
    Scene scene;
    scene.soup = receive_soup();
    const std::vector<Mesh_instance> instances = child_.receive<Mesh_instance>();
    scene.node_names = receive_names();
    scene.mesh_names = receive_names();
    add_properties(instances, scene);
    return scene;
  }
};

// For a file of this size. A file may name others, which also need memory.
inline Child_limits limits_of_assimp(double size_of_file, double seconds)
{
  const double physical_memory =
    static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  const double memory = (std::min)(4e9 + 64 * size_of_file, physical_memory);
  return {static_cast<std::size_t>(memory), (std::min)(60 + size_of_file / 1e6, seconds)};
}

// The extension has its dot; its case does not matter.
inline bool assimp_reads(const std::string& extension)
{ return Assimp::Importer().IsExtensionSupported(extension); }

// Reads glTF, FBX, Collada and all else that Assimp reads, with all transformations applied; a
// mirrored mesh keeps its outside. Throws `std::runtime_error`, with a sentence.
inline Scene read_by_assimp(const std::string& name, const Reading_limits& limits = {})
{
  if (!assimp_reads(std::filesystem::path(name).extension().string()))
    throw std::runtime_error("the formats are OFF, OBJ, PLY, STL and those of Assimp, such as "
                             "glTF, FBX and Collada");
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(name, error);
  Child_process child(limits_of_assimp(error ? 0 : static_cast<double>(size), limits.seconds),
                      [&](Child_output output)
                      { send_scene(name, limits.allows_external_files, output); });
  return Scene_receiver(child)();
}

#else

inline bool assimp_reads(const std::string&) { return false; }

inline Scene read_by_assimp(const std::string&, const Reading_limits& = {})
{
#ifdef SEGMENT_MESH_WITH_ASSIMP
  throw std::runtime_error("the formats are OFF, OBJ, PLY and STL; glTF, FBX and more need a POSIX "
                           "system");
#else
  throw std::runtime_error("the formats are OFF, OBJ, PLY and STL; glTF, FBX and more need Assimp "
                           "at build time");
#endif
}

#endif

} // namespace segment_mesh

#endif // SEGMENT_MESH_READ_BY_ASSIMP_H
