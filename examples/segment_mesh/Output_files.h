// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_OUTPUT_FILES_H
#define SEGMENT_MESH_OUTPUT_FILES_H

#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace segment_mesh {

// Throws `std::runtime_error` if no file of this name can be made or replaced.
inline void check_output_name(const std::filesystem::path& name)
{
  const std::filesystem::path directory = name.has_parent_path() ? name.parent_path() : ".";
  if (!std::filesystem::is_directory(directory))
    throw std::runtime_error("cannot write " + name.string() + ": there is no directory " +
                             directory.string());
  if (std::filesystem::exists(name) && !std::filesystem::is_regular_file(name))
    throw std::runtime_error("cannot write " + name.string() + ": it is not a file");
}

// The files that a run leaves. Each is written under a temporary name next to its own; all get
// their names in `commit()`, when they are complete. What was not committed is removed.
class Output_files
{
  typedef std::filesystem::path Path;

  std::string suffix_;
  std::vector<std::pair<Path, Path> > files_; // temporary and final name
  std::vector<Path> new_directories_;

  static std::string random_suffix()
  {
    std::random_device random;
    return "." + std::to_string(random()) + ".tmp";
  }

public:
  Output_files() : suffix_(random_suffix()) {}
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;

  ~Output_files()
  {
    std::error_code ignored;
    for (const auto& file : files_)
      std::filesystem::remove(file.first, ignored);
    for (const Path& directory : new_directories_)
      std::filesystem::remove(directory, ignored);
  }

  void make_directory(const Path& name)
  {
    if (std::filesystem::is_directory(name))
      return;
    std::error_code error;
    if (!std::filesystem::create_directory(name, error))
      throw std::runtime_error("cannot make the directory " + name.string());
    new_directories_.push_back(name);
  }

  // `writer` writes the content to a stream.
  template <class Writer>
  void write(const Path& name, const Writer& writer)
  {
    check_output_name(name);
    const Path target = std::filesystem::weakly_canonical(name); // the file behind a link
    Path temporary = target;
    temporary += suffix_;
    std::ofstream out(temporary, std::ios::binary);
    if (out)
      files_.emplace_back(temporary, target);
    writer(out);
    out.close();
    if (!out)
      throw std::runtime_error("cannot write " + name.string());
  }

  void commit()
  {
    while (!files_.empty()) {
      std::error_code error;
      std::filesystem::rename(files_.back().first, files_.back().second, error);
      if (error)
        throw std::runtime_error("cannot write " + files_.back().second.string());
      files_.pop_back();
    }
    new_directories_.clear();
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_OUTPUT_FILES_H
