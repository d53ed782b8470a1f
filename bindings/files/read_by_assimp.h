// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_READ_BY_ASSIMP_H
#define SEGMENT_MESH_READ_BY_ASSIMP_H

#include "Input_folder.h"
#include "Scene.h"
#include "Point_numbering.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#if defined(SEGMENT_MESH_WITH_ASSIMP) && (defined(__unix__) || defined(__APPLE__))
#define SEGMENT_MESH_READS_BY_ASSIMP
#endif

#ifdef SEGMENT_MESH_READS_BY_ASSIMP
#include "read_scene_in_child.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Exceptional.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/scene.h>
#endif

namespace segment_mesh {

#ifdef SEGMENT_MESH_READS_BY_ASSIMP

// Lists the polygons of a scene, in the child process. Points and lines are no polygons. The
// vertices of a mesh that differ only in a normal or the like become one point.
class Scene_flattening : public Flat_scene
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
  explicit Scene_flattening(const aiScene& scene) : scene_(scene)
  {
    soup.coordinate_type = mesh_file::Number_type::FLOAT32;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      local_points_.push_back(local_points(*scene.mMeshes[i]));
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

// The file that the user has named, and the files in its folder. Other files are not there for
// Assimp.
class Files_of_folder : public Assimp::DefaultIOSystem
{
  const std::string name_;
  const Input_folder folder_;
  mutable std::string refused_;

  bool is_allowed(const std::string& name) const
  {
    std::error_code error;
    const std::filesystem::path file = std::filesystem::canonical(name, error);
    if (name == name_ || error || folder_.is_readable(file)) // what is not there cannot be opened
      return true;
    if (refused_.empty())
      refused_ = name;
    return false;
  }

public:
  explicit Files_of_folder(const std::string& name)
    : name_(name), folder_(name, false) {}

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
inline void send_by_assimp(const std::string& name, bool allows_external_files, Child_output output)
{
  Assimp::Importer importer;
  Files_of_folder* const files = allows_external_files ? nullptr : new Files_of_folder(name);
  importer.SetIOHandler(files); // which owns them; without, any file may be read
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* const scene = importer.ReadFile(name, 0);
  if (files && !files->error().empty())
    return send_error(files->error(), output);
  if (!scene)
    return send_error(error_sentence(importer), output);
  try {
    send_scene(Scene_flattening(*scene), output);
  }
  catch (const std::runtime_error& e) {
    send_error(e.what(), output);
  }
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
  return read_scene_in_child(name, limits, [&](Child_output output)
    { send_by_assimp(name, limits.allows_external_files, output); });
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
