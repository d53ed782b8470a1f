// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_TABLE_H
#define SEGMENT_MESH_MESH_TABLE_H

#include "Output_files.h"
#include "report.h"

#include <cstddef>
#include <fstream>
#include <ostream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace segment_mesh {

// The file with a line of JSON for each mesh of several runs. A line is added when its run has
// ended, so that the table is right whenever the program is killed: the last line for a mesh
// counts, and one that is not whole does not.
class Mesh_table
{
  const Path name_;
  std::vector<Json> rows_;                               // in the order in which meshes came first
  std::unordered_map<std::string, std::size_t> row_of_;  // by the name of the input
  std::ofstream out_;

  void set(Json row)
  {
    const auto [place, is_new] = row_of_.emplace(row.at("input").get<std::string>(), rows_.size());
    if (is_new)
      rows_.emplace_back();
    rows_[place->second] = std::move(row);
  }

  static std::string line(const Json& row)
  { return row.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

public:
  explicit Mesh_table(const Path& name) : name_(name)
  {
    std::ifstream in(name);
    for (std::string text; std::getline(in, text);)
      try {
        set(Json::parse(text));
      }
      catch (const Json::exception&) {
      }
    write(); // without a line that is not whole
    out_.open(name, std::ios::binary | std::ios::app);
  }

  // Null if there is none.
  const Json* row(const std::string& input) const
  {
    const auto found = row_of_.find(input);
    return found == row_of_.end() ? nullptr : &rows_[found->second];
  }

  void add(const Json& row)
  {
    if (!(out_ << line(row) << std::flush))
      throw_cannot_write(name_);
    set(row);
  }

  // One line a mesh.
  void write() const
  {
    Output_files files;
    files.write(name_, [&](std::ostream& out) {
      for (const Json& row : rows_)
        out << line(row);
    });
    files.commit();
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_MESH_TABLE_H
