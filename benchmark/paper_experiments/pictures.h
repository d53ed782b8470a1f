// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_PICTURES_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_PICTURES_H

#include "experiment.h"

#include <CGAL/IO/Color.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace segmentation_benchmark {

typedef nlohmann::ordered_json Json;

// A folder of what scripts/render.py (meshes) and scripts/plot_lines.py (plots) draw. Files have
// the names that are given, with _ for spaces, and an ending.
class Pictures
{
  std::filesystem::path folder_;

  std::filesystem::path path(std::string name, const char* ending) const;

public:
  explicit Pictures(const std::string& folder);

  // One color a face.
  void write_mesh(const std::string& name, Mesh mesh,
                  const std::vector<CGAL::IO::Color>& colors) const;

  void write_plot(const std::string& name, const Json& plot) const;
};

// The color of each face.
std::vector<CGAL::IO::Color> segment_colors(Mesh mesh, const Labels& labels);
std::vector<CGAL::IO::Color> pale(std::vector<CGAL::IO::Color> colors);

// Gives the faces within a small distance of a sample one color.
void mark_sample(const Surface& graph, Index sample, const CGAL::IO::Color& color,
                 std::vector<CGAL::IO::Color>& colors);

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_PICTURES_H
