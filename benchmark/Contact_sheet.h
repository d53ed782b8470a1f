// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_CONTACT_SHEET_H
#define SEGMENTATION_BENCHMARK_CONTACT_SHEET_H

#include "colored_mesh.h"
#include "princeton_benchmark.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace segmentation_benchmark {

// One picture of many meshes with colored segments, ten in a line, in the order of their captions.
// Meshes are kept in a temporary folder until scripts/render.py has drawn them.
class Contact_sheet
{
  std::filesystem::path folder_;

  static std::string quoted(const std::string& text)
  {
    std::string result = "'";
    for (char c : text)
      result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
  }

public:
  Contact_sheet()
  {
    std::string name = (std::filesystem::temp_directory_path() / "contact_sheet_XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw std::runtime_error("cannot make a temporary folder");
    folder_ = name;
  }

  ~Contact_sheet()
  {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  Contact_sheet(const Contact_sheet&) = delete;
  Contact_sheet& operator=(const Contact_sheet&) = delete;

  // Captions differ. Several threads may add meshes.
  void add(const std::string& caption, Mesh mesh, const Labels& labels)
  {
    const auto ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
    for (Mesh::Face_index f : mesh.faces())
      ids[f] = static_cast<int>(labels[f]);
    color_segments(mesh, ids, number_of_segments(labels));
    std::ofstream out(folder_ / (caption + ".ply"), std::ios::binary);
    write_ply(out, mesh);
    if (!out.flush())
      throw std::runtime_error("cannot write into " + folder_.string());
  }

  void write(const std::string& file) const
  {
    const std::string command =
      "cd " + quoted(folder_.string()) + " && " + quoted(SPECTRAL_SEGMENTATION_RENDER_SCRIPT) +
      " ./*.ply --sheet --columns 10 --size 320 240 -o " +
      quoted(std::filesystem::absolute(file).string());
    if (std::system(command.c_str()) != 0)
      throw std::runtime_error("cannot draw " + file);
  }
};

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_CONTACT_SHEET_H
