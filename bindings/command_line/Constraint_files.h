// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_CONSTRAINT_FILES_H
#define SEGMENT_MESH_CONSTRAINT_FILES_H

#include "../meshes/Failure.h"
#include "../meshes/read_input.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

// The conditions on the segments that the user gives in files.
class Constraint_files
{
  struct Edge
  {
    bool must_be_cut;
    std::size_t line;
    bool is_found = false;
  };

  typedef std::pair<Point, Point> Ends; // the smaller first, as borders may repeat points

  const Input& input_;
  std::vector<std::int64_t> seeds_; // one per polygon, or empty
  std::map<Ends, Edge> edges_;

  [[noreturn]] static void fail(const std::string& name, std::size_t line, const std::string& what)
  { throw Failure(Status::USAGE, name + ", line " + std::to_string(line) + ": " + what); }

  template <class Read>
  static std::size_t read_lines(const std::string& name, const Read& read)
  {
    std::ifstream in(name);
    if (!in)
      throw Failure(Status::INPUT, name + " cannot be read");
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      read(words, ++number);
      std::string rest;
      if (words >> rest)
        fail(name, number, "there is more than the constraint: " + rest);
    }
    return number;
  }

  Ends ends(Index v, Index w) const
  {
    const auto [p, q] = std::minmax(input_.soup.points[v], input_.soup.points[w]);
    return {p, q};
  }

public:
  explicit Constraint_files(const Input& input) : input_(input) {}

  bool has_seeds() const { return !seeds_.empty(); }
  bool has_edges() const { return !edges_.empty(); }

  // Reads the seed of each polygon, one per line; a negative number is none.
  void read_seeds(const std::string& name)
  {
    const std::size_t number = read_lines(name, [&](std::istream& words, std::size_t line) {
      std::int64_t seed = 0;
      if (!(words >> seed))
        fail(name, line, "a seed is a whole number, or -1 for none");
      seeds_.push_back(seed);
    });
    if (number != input_.soup.number_of_polygons())
      throw Failure(Status::USAGE, name + " has " + std::to_string(number) + " lines, but the mesh "
                                   "has " + std::to_string(input_.soup.number_of_polygons()) +
                                   " faces");
  }

  // Reads edges, one per line: the indices of two points, from 0, and `cut` or `keep`.
  void read_edges(const std::string& name)
  {
    read_lines(name, [&](std::istream& words, std::size_t line) {
      const std::size_t n = input_.soup.points.size();
      std::size_t v = n, w = n;
      std::string kind;
      if (!(words >> v >> w >> kind) || v >= n || w >= n || (kind != "cut" && kind != "keep"))
        fail(name, line, "an edge is two indices of points, from 0 to " + std::to_string(n - 1) +
                           ", and 'cut' or 'keep'");
      edges_.insert({ends(static_cast<Index>(v), static_cast<Index>(w)), {kind == "cut", line}});
    });
    for (const mesh_file::Triangle& t : input_.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (const auto e = edges_.find(ends(t[i], t[(i + 1) % 3])); e != edges_.end())
          e->second.is_found = true;
    for (const auto& e : edges_)
      if (!e.second.is_found)
        fail(name, e.second.line, "the mesh has no edge between these points");
  }

  std::int64_t seed(std::size_t triangle) const
  { return seeds_.empty() ? -1 : seeds_[input_.polygon_of_triangle[triangle]]; }

  // Returns whether a file says that the edge between two points must be cut, or must not.
  bool is_given(const std::pair<std::size_t, std::size_t>& edge, bool must_be_cut) const
  {
    const auto e = edges_.find(ends(static_cast<Index>(edge.first),
                                    static_cast<Index>(edge.second)));
    return e != edges_.end() && e->second.must_be_cut == must_be_cut;
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_CONSTRAINT_FILES_H
