// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_ASSIMP_MATERIALS_H
#define SEGMENT_MESH_ASSIMP_MATERIALS_H

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

// Describes a material of Assimp as JSON: one of glTF, or {"mtl": [...]} with the statements of
// MTL, which are strings, or pairs of a string and an image. Images have names: embedded ones are
// *0, *1 ...
class Assimp_material
{
  typedef nlohmann::json Json;

  // A texture, or a number, and its place in glTF.
  struct Texture_place { aiTextureType type; unsigned index; const char* place; };
  struct Number_place { const char* key; unsigned type, index; const char* place; };

  const aiScene& scene_;
  const aiMaterial& material_;
  std::vector<int> coordinates_; // the sets of texture coordinates in use

  // Returns the number of a set among those in use.
  std::size_t number_of_set(int set)
  {
    const auto found = std::find(coordinates_.begin(), coordinates_.end(), set);
    const std::size_t result = static_cast<std::size_t>(found - coordinates_.begin());
    if (found == coordinates_.end())
      coordinates_.push_back(set);
    return result;
  }

  template <class Value>
  bool get(const char* key, unsigned type, unsigned index, Value& value) const
  { return material_.Get(key, type, index, value) == AI_SUCCESS; }

  // Returns the name of the image of a texture; null if there is no such texture.
  Json image(aiTextureType type, unsigned index) const
  {
    aiString name;
    if (material_.GetTexture(type, index, &name) != AI_SUCCESS || name.length == 0)
      return {};
    const int number = scene_.GetEmbeddedTextureAndIndex(name.C_Str()).second;
    return number >= 0 ? "*" + std::to_string(number) : std::string(name.C_Str());
  }

  // Returns the transformation of glTF, whose v points downwards and which rotates around the
  // origin. Assimp rotates around the middle of the image.
  static Json transformation(const aiUVTransform& t)
  {
    const double angle = -t.mRotation, u = t.mScaling.x / 2, v = t.mScaling.y / 2;
    const double x = t.mTranslation.x - u * (1 - std::cos(angle) + std::sin(angle));
    const double y = v * (std::sin(angle) + std::cos(angle) - 1) + 1 - 2 * v - t.mTranslation.y;
    return {{"offset", {x, y}}, {"rotation", angle}, {"scale", {2 * u, 2 * v}}};
  }

  static int wrapping(int mode)
  {
    return mode == aiTextureMapMode_Wrap ? 10497
                                         : mode == aiTextureMapMode_Mirror ? 33648 : 33071;
  }

  // Returns a texture in the form of glTF; null if there is no such texture, or if it needs a third
  // set of texture coordinates.
  Json texture(aiTextureType type, unsigned index)
  {
    Json result{{"index", image(type, index)}};
    int set = 0;
    get(AI_MATKEY_UVWSRC(type, index), set);
    if (result["index"].is_null() || number_of_set(set) > 1)
      return {};
    result["texCoord"] = number_of_set(set);
    aiUVTransform transform;
    if (get(AI_MATKEY_UVTRANSFORM(type, index), transform) &&
        (transform.mRotation != 0 || transform.mTranslation != aiVector2D() ||
         transform.mScaling != aiVector2D(1, 1)))
      result["extensions"]["KHR_texture_transform"] = transformation(transform);
    int number;
    if (get(AI_MATKEY_MAPPINGMODE_U(type, index), number))
      result["sampler"]["wrapS"] = wrapping(number);
    if (get(AI_MATKEY_MAPPINGMODE_V(type, index), number))
      result["sampler"]["wrapT"] = wrapping(number);
    if (get(AI_MATKEY_GLTF_MAPPINGFILTER_MAG(type, index), number) && number > 0)
      result["sampler"]["magFilter"] = number;
    if (get(AI_MATKEY_GLTF_MAPPINGFILTER_MIN(type, index), number) && number > 0)
      result["sampler"]["minFilter"] = number;
    ai_real strength;
    if (get(AI_MATKEY_GLTF_TEXTURE_SCALE(type, index), strength))
      result["scale"] = strength;
    if (get(AI_MATKEY_GLTF_TEXTURE_STRENGTH(type, index), strength))
      result["strength"] = strength;
    return result;
  }

  Json gltf()
  {
    static const Texture_place textures[] = {
      {aiTextureType_BASE_COLOR, 0, "/pbrMetallicRoughness/baseColorTexture"},
      {AI_MATKEY_GLTF_PBRMETALLICROUGHNESS_METALLICROUGHNESS_TEXTURE,
       "/pbrMetallicRoughness/metallicRoughnessTexture"},
      {aiTextureType_NORMALS, 0, "/normalTexture"},
      {aiTextureType_LIGHTMAP, 0, "/occlusionTexture"},
      {aiTextureType_EMISSIVE, 0, "/emissiveTexture"},
      {AI_MATKEY_CLEARCOAT_TEXTURE, "/extensions/KHR_materials_clearcoat/clearcoatTexture"},
      {AI_MATKEY_CLEARCOAT_ROUGHNESS_TEXTURE,
       "/extensions/KHR_materials_clearcoat/clearcoatRoughnessTexture"},
      {AI_MATKEY_CLEARCOAT_NORMAL_TEXTURE,
       "/extensions/KHR_materials_clearcoat/clearcoatNormalTexture"},
      {AI_MATKEY_SHEEN_COLOR_TEXTURE, "/extensions/KHR_materials_sheen/sheenColorTexture"},
      {AI_MATKEY_SHEEN_ROUGHNESS_TEXTURE, "/extensions/KHR_materials_sheen/sheenRoughnessTexture"},
      {AI_MATKEY_TRANSMISSION_TEXTURE,
       "/extensions/KHR_materials_transmission/transmissionTexture"}};
    static const Number_place numbers[] = {
      {AI_MATKEY_METALLIC_FACTOR, "/pbrMetallicRoughness/metallicFactor"},
      {AI_MATKEY_ROUGHNESS_FACTOR, "/pbrMetallicRoughness/roughnessFactor"},
      {AI_MATKEY_GLTF_ALPHACUTOFF, "/alphaCutoff"},
      {AI_MATKEY_CLEARCOAT_FACTOR, "/extensions/KHR_materials_clearcoat/clearcoatFactor"},
      {AI_MATKEY_CLEARCOAT_ROUGHNESS_FACTOR,
       "/extensions/KHR_materials_clearcoat/clearcoatRoughnessFactor"},
      {AI_MATKEY_SHEEN_ROUGHNESS_FACTOR, "/extensions/KHR_materials_sheen/sheenRoughnessFactor"},
      {AI_MATKEY_TRANSMISSION_FACTOR,
       "/extensions/KHR_materials_transmission/transmissionFactor"}};
    Json result;
    for (const Texture_place& t : textures) {
      const Json json = texture(t.type, t.index);
      if (!json.is_null())
        result[Json::json_pointer(t.place)] = json;
    }
    ai_real number;
    for (const Number_place& n : numbers)
      if (get(n.key, n.type, n.index, number))
        result[Json::json_pointer(n.place)] = number;
    aiColor4D color;
    if (get(AI_MATKEY_BASE_COLOR, color))
      result["pbrMetallicRoughness"]["baseColorFactor"] = {color.r, color.g, color.b, color.a};
    if (get(AI_MATKEY_COLOR_EMISSIVE, color))
      result["emissiveFactor"] = {color.r, color.g, color.b};
    if (get(AI_MATKEY_SHEEN_COLOR_FACTOR, color))
      result["extensions"]["KHR_materials_sheen"]["sheenColorFactor"] = {color.r, color.g, color.b};
    aiString mode;
    if (get(AI_MATKEY_GLTF_ALPHAMODE, mode))
      result["alphaMode"] = mode.C_Str();
    if (result.value("alphaMode", "") != "MASK")
      result.erase("alphaCutoff");
    int is_true;
    result["doubleSided"] = get(AI_MATKEY_TWOSIDED, is_true) && is_true != 0;
    if (get(AI_MATKEY_SHADING_MODEL, is_true) && is_true == aiShadingMode_NoShading)
      result["extensions"]["KHR_materials_unlit"] = Json::object();
    return result;
  }

  Json mtl()
  {
    static const Texture_place textures[] = {
      {aiTextureType_DIFFUSE, 0, "map_Kd"}, {aiTextureType_SPECULAR, 0, "map_Ks"},
      {aiTextureType_AMBIENT, 0, "map_Ka"}, {aiTextureType_EMISSIVE, 0, "map_Ke"},
      {aiTextureType_SHININESS, 0, "map_Ns"}, {aiTextureType_OPACITY, 0, "map_d"},
      {aiTextureType_HEIGHT, 0, "map_Bump"}, {aiTextureType_NORMALS, 0, "norm"},
      {aiTextureType_METALNESS, 0, "map_Pm"}, {aiTextureType_DIFFUSE_ROUGHNESS, 0, "map_Pr"}};
    static const Number_place colors[] = {{AI_MATKEY_COLOR_DIFFUSE, "Kd "},
                                          {AI_MATKEY_COLOR_SPECULAR, "Ks "},
                                          {AI_MATKEY_COLOR_EMISSIVE, "Ke "}};
    static const Number_place numbers[] = {{AI_MATKEY_SHININESS, "Ns "}, {AI_MATKEY_OPACITY, "d "}};
    Json result = Json::array();
    aiColor3D color;
    for (const Number_place& c : colors)
      if (get(c.key, c.type, c.index, color))
        result.push_back(c.place + Json(color.r).dump() + ' ' + Json(color.g).dump() + ' ' +
                         Json(color.b).dump());
    ai_real number;
    for (const Number_place& n : numbers)
      if (get(n.key, n.type, n.index, number))
        result.push_back(n.place + Json(number).dump());
    for (const Texture_place& t : textures) {
      const Json json = texture(t.type, t.index);
      if (!json.is_null())
        result.push_back({t.place, json["index"]});
    }
    return {{"mtl", result}};
  }

public:
  Assimp_material(const aiScene& scene, const aiMaterial& material)
    : scene_(scene), material_(material) {}

  // Returns the description. Materials that have glossiness but no texture of a base color become
  // MTL, because programs have given up the extension of glTF for them.
  std::string operator()()
  {
    float number;
    const bool is_gltf = get(AI_MATKEY_METALLIC_FACTOR, number) &&
                         (!get(AI_MATKEY_GLOSSINESS_FACTOR, number) ||
                          !image(AI_MATKEY_BASE_COLOR_TEXTURE).is_null());
    return (is_gltf ? gltf() : mtl()).dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  // Returns the sets of texture coordinates that the description numbers.
  const std::vector<int>& coordinates() const { return coordinates_; }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_ASSIMP_MATERIALS_H
