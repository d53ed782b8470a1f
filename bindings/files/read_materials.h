// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_READ_MATERIALS_H
#define SEGMENT_MESH_READ_MATERIALS_H

#include "Input_folder.h"
#include "Polygon_soup.h"
#include "Text_scanner.h"
#include "gltf_materials.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace segment_mesh {

// Reads the materials of a soup, and their images, from the files that it names. What is missing
// is no error.
class Material_reader
{
  typedef mesh_file::Material Material;

  const Input_folder& folder_;
  mesh_file::Polygon_soup& soup_;
  std::map<std::string, std::size_t> images_; // their numbers by their names
  std::vector<std::string> missing_files_;

  std::shared_ptr<const std::string> read(const std::string& name)
  {
    std::shared_ptr<const std::string> result = folder_.read(name);
    if (!result)
      missing_files_.push_back(name);
    return result;
  }

  // Returns the index of an image by its name.
  std::size_t image(std::string name)
  {
    const auto [place, is_new] = images_.emplace(name, soup_.images.size());
    if (is_new) {
      std::shared_ptr<const std::string> bytes = read(name);
      soup_.images.push_back({in_one_line(std::move(name)), std::move(bytes)});
    }
    return place->second;
  }

  static std::string in_one_line(std::string text)
  {
    std::replace_if(text.begin(), text.end(), [](char c) { return c >= 0 && c < ' '; }, '?');
    return text;
  }

  static bool is_map(const std::string& statement)
  {
    static const std::string_view others[] = {"bump", "norm", "disp", "decal", "refl"};
    return statement.compare(0, 4, "map_") == 0 ||
           std::find(std::begin(others), std::end(others), statement) != std::end(others);
  }

  // Returns a text without its first word and the blanks after it.
  static std::string_view without_word(std::string_view text)
  {
    const std::size_t end = (std::min)(text.find_first_of(" \t"), text.size());
    return text.substr((std::min)(text.find_first_not_of(" \t", end), text.size()));
  }

  // Returns the name of an image without the options before it.
  static std::string_view without_options(std::string_view text)
  {
    const auto is_number = [](std::string_view words) {
      const std::string word(words.substr(0, words.find_first_of(" \t")));
      char* end;
      std::strtod(word.c_str(), &end);
      return !word.empty() && *end == '\0';
    };
    std::string_view result = text;
    while (!result.empty() && result[0] == '-') {
      const std::string_view option = result.substr(0, result.find_first_of(" \t"));
      const int most = option == "-o" || option == "-s" || option == "-t" ? 3
                                                                          : option == "-mm" ? 2 : 1;
      result = without_word(without_word(result));
      for (int i = 1; i < most && is_number(result); ++i)
        result = without_word(result);
    }
    return result.empty() ? text : result;
  }

  static std::string joined(std::string_view statement, std::string_view arguments)
  { return std::string(statement) + (arguments.empty() ? "" : " ") + std::string(arguments); }

public:
  Material_reader(const Input_folder& folder, mesh_file::Polygon_soup& soup)
    : folder_(folder), soup_(soup)
  {
    for (const mesh_file::Image& i : soup_.images)
      images_.emplace(i.name, images_.size());
  }

  // Reads the statements of the materials in a file, and removes these materials from the map: the
  // first one of a name counts.
  void read_mtl(std::string_view file, std::map<std::string, Material*, std::less<> >& materials)
  {
    Material* material = nullptr;
    for (mesh_file::Text_scanner text(file); !text.is_at_end(); text.rest_of_line()) {
      const std::string_view statement = text.peek_word();
      text.skip_word();
      const std::string_view arguments = text.peek_rest_of_line();
      if (statement == "newmtl") {
        const auto found = materials.find(arguments);
        material = found == materials.end() ? nullptr : found->second;
        if (material)
          materials.erase(found);
      }
      else if (material && !arguments.empty() && is_map(mesh_file::lower_case(statement))) {
        const std::string_view name = without_options(arguments);
        const std::size_t size_of_options = arguments.size() - name.size();
        std::string_view options = arguments.substr(0, size_of_options);
        options = options.substr(0, options.find_last_not_of(" \t") + 1);
        material->statements.push_back({joined(statement, options), image(std::string(name))});
      }
      else if (material)
        material->statements.push_back({joined(statement, arguments), Material::no_image});
    }
  }

  // Reads the files that the soup names. A line with a name in it may have several.
  void read_material_files()
  {
    std::map<std::string, Material*, std::less<> > materials;
    for (Material& m : soup_.materials)
      materials.emplace(m.name, &m);
    for (const std::string& names : soup_.material_files) {
      const std::shared_ptr<const std::string> file = folder_.read(names);
      if (file)
        read_mtl(*file, materials);
      for (std::string_view rest = names; !file && !rest.empty(); rest = without_word(rest))
        if (const auto part = read(std::string(rest.substr(0, rest.find_first_of(" \t")))))
          read_mtl(*part, materials);
    }
    for (Material& m : soup_.materials)
      m.gltf = mesh_file::gltf_of_mtl(m);
  }

  // Replaces the description that `Assimp_material` made by the material.
  void read_description(Material& material)
  {
    const std::string description = std::move(material.gltf);
    material.gltf.clear();
    try {
      nlohmann::json json = nlohmann::json::parse(description);
      if (json.contains("mtl")) {
        for (const nlohmann::json& s : json["mtl"])
          if (s.is_array())
            material.statements.push_back({in_one_line(s.at(0)), image(s.at(1))});
          else
            material.statements.push_back({in_one_line(s), Material::no_image});
        material.gltf = mesh_file::gltf_of_mtl(material);
        return;
      }
      mesh_file::for_each_texture(json, [&](nlohmann::json& texture)
                                  { texture["index"] = image(texture.at("index")); });
      material.statements = mesh_file::mtl_of_gltf(json);
      material.gltf = json.dump();
    }
    catch (const nlohmann::json::exception&) { // a broken child may send anything
    }
    catch (const std::out_of_range&) {
    }
  }

  // Reads the materials from the descriptions in the soup.
  void read_descriptions()
  {
    for (Material& m : soup_.materials)
      read_description(m);
  }

  // Returns the names of the files that were not found, or not allowed.
  const std::vector<std::string>& missing_files() const { return missing_files_; }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_READ_MATERIALS_H
