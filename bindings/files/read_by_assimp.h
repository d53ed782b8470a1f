// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_READ_BY_ASSIMP_H
#define SEGMENT_MESH_READ_BY_ASSIMP_H

#include "Input_folder.h"
#include "Point_numbering.h"
#include "Scene.h"
#include "Text_scanner.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#if defined(SEGMENT_MESH_WITH_ASSIMP) && (defined(__unix__) || defined(__APPLE__))
#define SEGMENT_MESH_READS_BY_ASSIMP
#endif

#ifdef SEGMENT_MESH_READS_BY_ASSIMP
#include "Plain_gltf.h"
#include "read_scene_in_child.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Exceptional.h>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/scene.h>

#include "assimp_materials.h"
#endif

namespace segment_mesh {

#ifdef SEGMENT_MESH_READS_BY_ASSIMP

// Lists the polygons of a scene, in the child process. Points and lines are no polygons. The
// vertices of a mesh that differ only in a normal or the like become one point.
class Scene_flattening : public Flat_scene
{
  typedef mesh_file::Index Index;
  typedef aiMatrix4x4t<double> Transformation;

  // The points of one mesh, and the texture coordinates in the order of its vertices.
  struct Local_points
  {
    std::vector<mesh_file::Point> points;
    std::vector<Index> point_of_vertex; // null_index if no polygon uses it
    Index first_texture = mesh_file::null_index; // in the soup, if it has any
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
        result.point_of_vertex[v] = number({p.x, p.y, p.z});
      }
    return result;
  }

  const aiScene& scene_;
  const bool reads_materials_;
  std::vector<Local_points> local_points_; // one per mesh
  std::vector<std::vector<int> > coordinates_of_material_;

  void check_size() const
  {
    if ((std::max)({soup.points.size(), soup.corners.size(), soup.normals.size(),
                    soup.texture_coordinates.size()}) >= mesh_file::null_index)
      throw std::runtime_error("there are too many points or corners");
  }

  // Adds the two sets of texture coordinates that the material uses first.
  void add_textures(const aiMesh& mesh, Local_points& local)
  {
    std::vector<int> sets = coordinates_of_material_.at(mesh.mMaterialIndex);
    if (sets.empty())
      sets = {0};
    sets.resize(2, AI_MAX_NUMBER_OF_TEXTURECOORDS); // which no mesh has
    const auto has_set = [&](std::size_t i)
    { return mesh.HasTextureCoords(static_cast<unsigned>(sets[i])); };
    if (!has_set(0))
      return;
    local.first_texture = static_cast<Index>(soup.texture_coordinates.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      mesh_file::Texture_point t{};
      for (std::size_t i = 0; i < 2; ++i)
        if (has_set(i)) {
          t[2 * i] = mesh.mTextureCoords[sets[i]][v].x;
          t[2 * i + 1] = mesh.mTextureCoords[sets[i]][v].y;
        }
      soup.texture_coordinates.push_back(t);
    }
    check_size();
  }

  // Adds the normals of a mesh at a node.
  void add_normals(const aiMesh& mesh, const Transformation& transformation)
  {
    const aiMatrix3x3t<double> turn =
      aiMatrix3x3t<double>(transformation).Inverse().Transpose();
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& m = mesh.mNormals[v];
      const aiVector3t<double> n = turn * aiVector3t<double>(m.x, m.y, m.z);
      const double length = n.Length();
      if (length > 0 && std::isfinite(length))
        soup.normals.push_back({n.x / length, n.y / length, n.z / length});
      else
        soup.normals.push_back({}); // no corner has it
    }
    check_size();
  }

  void add_materials()
  {
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i) {
      Assimp_material describe(scene_, *scene_.mMaterials[i]);
      append_name(describe(), materials);
      append_name(scene_.mMaterials[i]->GetName().C_Str(), material_names);
      coordinates_of_material_.push_back(describe.coordinates());
    }
    for (unsigned i = 0; i < scene_.mNumTextures; ++i) {
      const aiTexture& t = *scene_.mTextures[i];
      const char* const bytes = reinterpret_cast<const char*>(t.pcData);
      if (t.mHeight == 0 && bytes) // no file otherwise
        images.insert(images.end(), bytes, bytes + t.mWidth);
      ends_of_images.push_back(images.size());
    }
  }

  void add_points(const std::vector<mesh_file::Point>& points, const Transformation& transformation)
  {
    for (const mesh_file::Point& p : points) {
      const aiVector3t<double> q = transformation * aiVector3t<double>(p[0], p[1], p[2]);
      soup.points.push_back({q.x, q.y, q.z});
    }
    check_size();
  }

  void add_instance(const Transformation& transformation, Index node, Index mesh)
  {
    if (mesh >= scene_.mNumMeshes)
      throw std::runtime_error("a node has a mesh that is not there");
    const Index first_point = static_cast<Index>(soup.points.size());
    add_points(local_points_[mesh].points, transformation);
    const Index first_texture = local_points_[mesh].first_texture;
    const Index first_normal = static_cast<Index>(soup.normals.size());
    const bool has_normals = reads_materials_ && scene_.mMeshes[mesh]->HasNormals();
    if (has_normals)
      add_normals(*scene_.mMeshes[mesh], transformation);
    const bool is_mirrored = transformation.Determinant() < 0;
    for (unsigned f = 0; f < scene_.mMeshes[mesh]->mNumFaces; ++f) {
      const aiFace& face = scene_.mMeshes[mesh]->mFaces[f];
      if (!is_polygon(face))
        continue;
      for (unsigned i = 0; i < face.mNumIndices; ++i) {
        const unsigned v = face.mIndices[is_mirrored ? face.mNumIndices - 1 - i : i];
        soup.corners.push_back(first_point + local_points_[mesh].point_of_vertex[v]);
        if (!reads_materials_)
          continue;
        soup.texture_of_corner.push_back(
          first_texture == mesh_file::null_index ? first_texture : first_texture + v);
        soup.normal_of_corner.push_back(
          has_normals && soup.normals[first_normal + v] != mesh_file::Point{}
            ? first_normal + v : mesh_file::null_index);
      }
      check_size();
      soup.end_polygon();
      if (reads_materials_)
        soup.material_of_polygon.push_back(scene_.mMeshes[mesh]->mMaterialIndex);
    }
    instances.push_back({node, mesh, static_cast<Index>(soup.number_of_polygons())});
  }

  // Adds a node, and then its children.
  void add_node(const aiNode& node, const Transformation& transformation_of_parent)
  {
    const Transformation transformation =
      transformation_of_parent * static_cast<Transformation>(node.mTransformation);
    const Index number = number_of_nodes_++;
    append_name(node.mName.C_Str(), node_names);
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

  Index number_of_nodes_ = 0;

public:
  Scene_flattening(const aiScene& scene, bool reads_materials)
    : scene_(scene), reads_materials_(reads_materials && scene.mNumMaterials > 0)
  {
    if (reads_materials_)
      add_materials();
    soup.coordinate_type = mesh_file::Number_type::FLOAT32;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      local_points_.push_back(local_points(*scene.mMeshes[i]));
      if (reads_materials_)
        add_textures(*scene.mMeshes[i], local_points_.back());
      append_name(scene.mMeshes[i]->mName.C_Str(), mesh_names);
    }
    if (scene.mRootNode)
      add_node(*scene.mRootNode, Transformation());
  }
};

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

// The files that Assimp may open: the one that the user has named, those in its folder, or any if
// external files are allowed; and contents in memory with the names of files.
class Input_files : public Assimp::DefaultIOSystem
{
  const std::string name_;
  const Input_folder folder_;
  const bool allows_external_files_;
  std::map<std::string, std::string> contents_;
  mutable std::string refused_;

  bool is_allowed(const std::string& name) const
  {
    std::error_code error;
    const std::filesystem::path file = std::filesystem::canonical(name, error);
    if (allows_external_files_ || name == name_ || error || // what is not there cannot be opened
        folder_.is_readable(file))
      return true;
    if (refused_.empty())
      refused_ = name;
    return false;
  }

public:
  Input_files(const std::string& name, bool allows_external_files)
    : name_(name), folder_(name, false), allows_external_files_(allows_external_files) {}

  void put(const std::string& name, std::string content) { contents_[name] = std::move(content); }

  bool Exists(const char* name) const override
  { return contents_.count(name) > 0 || (is_allowed(name) && DefaultIOSystem::Exists(name)); }

  Assimp::IOStream* Open(const char* name, const char* mode) override
  {
    const auto found = contents_.find(name);
    if (found != contents_.end())
      return new Assimp::MemoryIOStream(
        reinterpret_cast<const std::uint8_t*>(found->second.data()), found->second.size());
    return is_allowed(name) ? DefaultIOSystem::Open(name, mode) : nullptr;
  }

  // Returns the bytes of a file; none if it cannot be read.
  std::string read(const std::string& name)
  {
    const std::unique_ptr<Assimp::IOStream> stream(Open(name.c_str(), "rb"));
    std::string result(stream ? stream->FileSize() : 0, '\0');
    if (!result.empty())
      result.resize(stream->Read(result.data(), 1, result.size()));
    return result;
  }

  // Returns a message about a file that was not opened, or an empty one.
  std::string error() const
  {
    if (refused_.empty())
      return "";
    std::string name = refused_.substr(0, 100);
    std::replace_if(name.begin(), name.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return "it names " + name + ", which is no file in its folder; --allow-external-files reads it";
  }
};

// Puts the plain form of a file of glTF 2 into the files, which Assimp reads in its place. Returns
// its name.
inline std::string put_plain_gltf(const std::string& name, Input_files& files)
{
  const std::string folder = name.substr(0, name.find_last_of("/\\") + 1);
  const std::string file = files.read(name);
  const Plain_gltf gltf(file, [&](const std::string& address) {
    std::string bytes = files.read(folder + address);
    if (bytes.empty())
      throw std::runtime_error("it names " + mesh_file::in_quotes(address, 100) +
                               ", which cannot be read");
    return bytes;
  });
  if (!gltf.is_version_2())
    return name;
  const std::string result = name + ".gltf";
  files.put(result, gltf.description());
  files.put(folder + Plain_gltf::binary_address(), std::string(gltf.binary()));
  files.put(folder + Plain_gltf::data_address(), gltf.data());
  return result;
}

// Puts Collada without white space before its texts into the files, because Assimp finds no number
// in a color that begins with a blank.
inline void put_plain_collada(const std::string& name, Input_files& files)
{
  std::string text = files.read(name);
  bool is_after_tag = false;
  const auto is_left_out = [&](char c) {
    const bool result = is_after_tag && std::isspace(static_cast<unsigned char>(c));
    is_after_tag = c == '>' || result;
    return result;
  };
  text.erase(std::remove_if(text.begin(), text.end(), std::ref(is_left_out)), text.end());
  files.put(name, std::move(text));
}

// Sends the scene or an error message, which may be empty. Runs in the child process.
inline void send_by_assimp(const std::string& name, const Reading_limits& limits,
                           Child_output output)
{
  Assimp::Importer importer;
  Input_files* const files = new Input_files(name, limits.allows_external_files);
  importer.SetIOHandler(files); // which owns them
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const std::string extension =
    mesh_file::lower_case(std::filesystem::path(name).extension().string());
  std::string error;
  try {
    const bool is_gltf = extension == ".gltf" || extension == ".glb";
    if (extension == ".dae")
      put_plain_collada(name, *files);
    const aiScene* const scene =
      importer.ReadFile(is_gltf ? put_plain_gltf(name, *files) : name, 0);
    if (scene && files->error().empty())
      return send_scene(Scene_flattening(*scene, limits.reads_materials), output);
    error = error_sentence(importer);
  }
  catch (const std::runtime_error& e) {
    error = e.what();
  }
  send_error(files->error().empty() ? error : files->error(), output);
}

// Returns whether Assimp reads files with an extension, which begins with a dot, in any case.
inline bool assimp_reads(const std::string& extension)
{ return Assimp::Importer().IsExtensionSupported(extension); }

// Reads glTF, FBX, Collada and all else that Assimp reads, with all transformations applied; a
// mirrored mesh keeps its outside. Throws `std::runtime_error`.
inline Scene read_by_assimp(const std::string& name, const Reading_limits& limits = {})
{
  if (!assimp_reads(std::filesystem::path(name).extension().string()))
    throw std::runtime_error("the formats are OFF, OBJ, PLY, STL and those of Assimp, such as "
                             "glTF, FBX and Collada");
  return read_scene_in_child(name, limits, [&](Child_output output)
    { send_by_assimp(name, limits, output); });
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
