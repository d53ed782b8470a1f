// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_INPUT_FOLDER_H
#define SEGMENT_MESH_INPUT_FOLDER_H

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

namespace segment_mesh {

// The folder of an input that names further files. The input may come from a stranger: unless
// external files are allowed, only files in the folder or below it are read, also behind links.
class Input_folder
{
  std::filesystem::path folder_; // empty if there is none
  bool allows_external_files_;

  // Returns an address with escapes such as %20 replaced by their characters.
  static std::string without_escapes(const std::string& address)
  {
    std::string result;
    for (std::size_t i = 0; i < address.size(); ++i) {
      unsigned char byte = 0;
      const char* const digits = address.data() + i + 1;
      if (address[i] == '%' && i + 2 < address.size() &&
          std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
        result += static_cast<char>(byte);
        i += 2;
      }
      else
        result += address[i];
    }
    return result;
  }

public:
  Input_folder(const std::string& input, bool allows_external_files)
    : allows_external_files_(allows_external_files)
  {
    std::error_code error;
    folder_ = std::filesystem::canonical(input, error).parent_path();
  }

  // Returns whether a file may be read. Its path must not have links.
  bool is_readable(const std::filesystem::path& file) const
  {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error) &&
           (allows_external_files_ ||
            std::mismatch(folder_.begin(), folder_.end(), file.begin(), file.end()).first ==
              folder_.end());
  }

  // Returns the bytes of a file by its name in the input, which may be of another system or an
  // address; or null. If the path leads nowhere, a file of this name in the folder counts.
  std::shared_ptr<const std::string> read(std::string name) const
  {
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path path(name), decoded(without_escapes(name));
    for (const std::filesystem::path& p : {path, decoded, decoded.filename()}) {
      std::error_code error;
      const std::filesystem::path file = std::filesystem::canonical(folder_ / p, error);
      if (error || folder_.empty() || !is_readable(file))
        continue;
      const std::uintmax_t size = std::filesystem::file_size(file, error);
      std::ifstream in(file, std::ios::binary);
      if (error || !in)
        continue;
      std::string bytes(static_cast<std::size_t>(size), '\0');
      in.read(bytes.data(), static_cast<std::streamsize>(size));
      bytes.resize(static_cast<std::size_t>(in.gcount()));
      return std::make_shared<const std::string>(std::move(bytes));
    }
    return nullptr;
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_INPUT_FOLDER_H
