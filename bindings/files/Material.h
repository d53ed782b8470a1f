// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_MATERIAL_H
#define SEGMENT_MESH_MESH_FILE_MATERIAL_H

#include <cctype>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace mesh_file {

// A picture, whose bytes nobody decodes.
struct Image
{
  std::string name;                         // in the file that uses it
  std::shared_ptr<const std::string> bytes; // of its own file; null if this is missing
};

// Returns the type in the form of a MIME type, "image/" + type, and of the ending of a name.
inline std::string type_of(const Image& image)
{
  const std::string start = image.bytes ? image.bytes->substr(0, 4) : "";
  if (start == "\x89PNG")
    return "png";
  if (start.substr(0, 3) == "\xFF\xD8\xFF")
    return "jpeg";
  std::string result;
  for (std::size_t i = image.name.rfind('.') + 1; i > 0 && i < image.name.size(); ++i)
    if (std::isalnum(static_cast<unsigned char>(image.name[i])) && result.size() < 8)
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(image.name[i])));
  return result.empty() ? "unknown" : result;
}

// The appearance of a surface.
struct Material
{
  static constexpr std::size_t no_image = static_cast<std::size_t>(-1);

  // A line of MTL, such as "Kd 1 0 0". The name of the image follows it, if there is one.
  struct Statement
  {
    std::string text;
    std::size_t image = no_image;
  };

  std::string name;
  std::vector<Statement> statements;
  std::string gltf; // the same as JSON; its textures have images as "index", and their "sampler"
};

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_MATERIAL_H
