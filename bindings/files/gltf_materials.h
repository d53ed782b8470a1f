// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_GLTF_MATERIALS_H
#define SEGMENT_MESH_MESH_FILE_GLTF_MATERIALS_H

#include "Material.h"
#include "Text_scanner.h"
#include "decimal_numbers.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mesh_file {

// Returns the linear intensity of a channel of sRGB from 0 to 1, by IEC 61966-2-1.
inline double linear_intensity(double c)
{ return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

// Returns the channel of sRGB with a linear intensity: the inverse of `linear_intensity()`.
inline double srgb_channel(double c)
{ return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; }

inline double fraction(double number) { return number > 0 ? (std::min)(number, 1.) : 0; }

// Calls a function with each texture of a material of glTF.
template <class Visitor>
void for_each_texture(nlohmann::json& json, const Visitor& visit)
{
  if (!json.is_object())
    return;
  for (const auto& [key, value] : json.items()) {
    const bool is_texture = key.size() > 7 && key.compare(key.size() - 7, 7, "Texture") == 0;
    if (is_texture && value.is_object() && value.contains("index"))
      visit(value);
    else
      for_each_texture(value, visit);
  }
}

// The statements of a material of MTL by their keywords in lower case. The last statement of a
// keyword counts.
class Mtl_values
{
  const Material& material_;

  const Material::Statement* find(std::string_view keyword) const
  {
    const auto found = std::find_if(
      material_.statements.rbegin(), material_.statements.rend(), [&](const auto& statement)
      { return lower_case(Text_scanner(statement.text).peek_word()) == keyword; });
    return found == material_.statements.rend() ? nullptr : &*found;
  }

public:
  explicit Mtl_values(const Material& material) : material_(material) {}

  // Returns the numbers of a statement up to the first other word; none if it is missing.
  std::vector<double> numbers(std::string_view keyword) const
  {
    std::vector<double> result;
    if (const Material::Statement* statement = find(keyword))
      try {
        Text_scanner text(statement->text);
        for (text.skip_word(); !text.is_at_end_of_line();)
          result.push_back(text.number());
      }
      catch (const std::runtime_error&) { // for example, the name of a spectral curve
      }
    return result;
  }

  double number(std::string_view keyword, double otherwise) const
  {
    const std::vector<double> all = numbers(keyword);
    return all.empty() ? otherwise : all[0];
  }

  // Returns the linear intensities of a color, whose channels are `otherwise` if it is missing.
  std::vector<double> color(std::string_view keyword, double otherwise) const
  {
    std::vector<double> result = numbers(keyword);
    if (result.empty())
      result = {otherwise};
    result.resize(3, result[0]);
    for (double& c : result)
      c = linear_intensity(fraction(c));
    return result;
  }

  std::size_t image(std::string_view keyword) const
  {
    const Material::Statement* const statement = find(keyword);
    return statement ? statement->image : Material::no_image;
  }
};

// Returns a material in the form of glTF, from its statements. What glTF does not have, such as
// bump maps, is left out.
inline std::string gltf_of_mtl(const Material& material)
{
  using nlohmann::json;
  const Mtl_values values(material);
  json result{{"doubleSided", true}};
  const auto put_texture = [&](const char* pointer, std::size_t image) {
    if (image != Material::no_image)
      result[json::json_pointer(pointer)] = {{"index", image}};
    return image != Material::no_image;
  };
  const bool has_texture = put_texture("/pbrMetallicRoughness/baseColorTexture",
                                       values.image("map_kd"));
  const bool has_surface = values.image("map_pm") == values.image("map_pr") &&
    put_texture("/pbrMetallicRoughness/metallicRoughnessTexture", values.image("map_pm"));
  const bool is_emissive = put_texture("/emissiveTexture", values.image("map_ke"));
  put_texture("/normalTexture", values.image("norm"));

  std::vector<double> color = values.color("kd", has_texture ? 1 : 0.8);
  color.resize(3);
  color.push_back(fraction(values.number("d", 1 - values.number("tr", 0))));
  if (color[3] < 1 || values.image("map_d") != Material::no_image)
    result["alphaMode"] = "BLEND";
  const std::vector<double> emission = values.color("ke", is_emissive ? 1 : 0);
  result["emissiveFactor"] = {emission[0], emission[1], emission[2]};
  json& surface = result["pbrMetallicRoughness"];
  surface["baseColorFactor"] = color;
  surface["metallicFactor"] = fraction(values.number("pm", has_surface ? 1 : 0));
  // The width of the highlight of Blinn and Phong, if there is one.
  const double exponent = values.color("ks", 0) == std::vector<double>(3, 0.)
                            ? 0 : (std::max)(values.number("ns", 0), 0.);
  surface["roughnessFactor"] =
    fraction(values.number("pr", has_surface ? 1 : std::sqrt(2 / (exponent + 2))));
  return result.dump();
}

// Returns the statements of MTL for a material of glTF, with the numbers of its images as far as
// MTL has these textures.
inline std::vector<Material::Statement> mtl_of_gltf(const nlohmann::json& material)
{
  typedef nlohmann::json::json_pointer Pointer;
  std::vector<Material::Statement> result;
  const auto with_numbers = [](std::string text, const std::vector<double>& numbers) {
    for (double x : numbers) {
      char digits[32];
      text.append(" ").append(digits, print_decimal(digits, static_cast<float>(x)));
    }
    return text;
  };
  const auto put = [&](const char* keyword, const std::vector<double>& numbers)
  { result.push_back({with_numbers(keyword, numbers)}); };
  const auto put_map = [&](std::string statement, const char* pointer) {
    const nlohmann::json texture = material.value(Pointer(pointer), nlohmann::json());
    if (texture.is_null())
      return;
    const Pointer extension("/extensions/KHR_texture_transform");
    const nlohmann::json transform = texture.value(extension, nlohmann::json());
    if (!transform.is_null()) { // without its rotation, which MTL has not
      const auto offset = transform.at("offset").get<std::vector<double> >();
      const auto scale = transform.at("scale").get<std::vector<double> >();
      statement = with_numbers(statement + " -o", {offset.at(0), 1 - scale.at(1) - offset.at(1)});
      statement = with_numbers(statement + " -s", {scale.at(0), scale.at(1)});
    }
    result.push_back({statement, texture.at("index").get<std::size_t>()});
  };
  const auto color = material.value(Pointer("/pbrMetallicRoughness/baseColorFactor"),
                                    std::vector<double>(4, 1.));
  put("Kd", {srgb_channel(color.at(0)), srgb_channel(color.at(1)), srgb_channel(color.at(2))});
  if (color.at(3) < 1)
    put("d", {color[3]});
  put("Pm", {material.value(Pointer("/pbrMetallicRoughness/metallicFactor"), 1.)});
  put("Pr", {material.value(Pointer("/pbrMetallicRoughness/roughnessFactor"), 1.)});
  const auto emission = material.value(Pointer("/emissiveFactor"), std::vector<double>(3, 0.));
  if (emission != std::vector<double>(3, 0.))
    put("Ke", {srgb_channel(emission.at(0)), srgb_channel(emission.at(1)),
               srgb_channel(emission.at(2))});
  put_map("map_Kd", "/pbrMetallicRoughness/baseColorTexture");
  put_map("map_Pm", "/pbrMetallicRoughness/metallicRoughnessTexture");
  put_map("map_Pr", "/pbrMetallicRoughness/metallicRoughnessTexture");
  put_map("norm", "/normalTexture");
  put_map("map_Ke", "/emissiveTexture");
  put_map("map_Ka", "/occlusionTexture");
  return result;
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_GLTF_MATERIALS_H
