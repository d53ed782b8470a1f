// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_TABLE_H
#define SEGMENT_MESH_MESH_TABLE_H

#include "../meshes/Failure.h"
#include "Output_files.h"
#include "report.h"

#include <cstddef>
#include <fstream>
#include <ostream>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace segment_mesh {

// The file with a line of JSON for each mesh of several runs. A line is added when its run has
// ended, so that the table is right whenever the program is killed: the last line for a mesh
// counts, and one that is not whole does not. No line stays in memory, as each run of a batch has
// a copy of the memory of the batch.
class Mesh_table
{
  const Path name_;
  std::ofstream out_;

  static std::string text(const Json& json)
  { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

public:
  explicit Mesh_table(const Path& name) : name_(name) {}

  // Returns the name as the table has it. If it is no UTF-8, its bytes beyond ASCII are %80 to %FF.
  static std::string name_in_table(const std::string& input)
  {
    if (Json::parse(text(input)) == Json(input))
      return input;
    std::string result;
    for (char c : input)
      if (static_cast<signed char>(c) >= 0)
        result += c;
      else {
        const char* const digits = "0123456789ABCDEF";
        const unsigned byte = static_cast<unsigned char>(c);
        result += {'%', digits[byte / 16], digits[byte % 16]};
      }
    return result;
  }

  void add(const Json& row)
  {
    if (!out_.is_open())
      out_.open(name_, std::ios::binary | std::ios::app);
    if (!(out_ << text(row) << '\n' << std::flush))
      throw_cannot_write(name_);
  }

  // Removes all but the last line of each mesh, and returns the meshes whose runs succeeded.
  std::unordered_set<std::string> tidy()
  {
    out_.close();
    std::unordered_map<std::string, std::size_t> line_of; // the number of the last, from 1
    std::unordered_set<std::string> succeeded;
    std::size_t number = 0;
    const auto for_each_line = [&](const auto& function) {
      std::ifstream in(name_);
      number = 0;
      for (std::string line; std::getline(in, line);) {
        ++number;
        function(line);
      }
    };
    for_each_line([&](const std::string& line) {
      try {
        const Json row = Json::parse(line);
        const std::string input = row.at("input").get<std::string>();
        line_of[input] = number;
        if (row.value("status", "") == name_of(Status::OK))
          succeeded.insert(input);
        else
          succeeded.erase(input);
      }
      catch (const Json::exception&) {
      }
    });
    std::vector<bool> is_last(number + 1);
    for (const auto& line : line_of)
      is_last[line.second] = true;
    Output_files files;
    files.write(name_, [&](std::ostream& out) {
      for_each_line([&](const std::string& line) {
        if (is_last[number])
          out << line << '\n';
      });
    });
    files.commit();
    return succeeded;
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_MESH_TABLE_H
