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

// A folder of what scripts/render.py (meshes) and scripts/plot_lines.py (plots) draw. Names are
// without the endings of the files.
class Pictures
{
  std::filesystem::path folder_;

  void write_mesh(const std::string& name, const Mesh& mesh) const;

public:
  explicit Pictures(const std::string& folder);

  void write_segments(const std::string& name, Mesh mesh, const Labels& labels) const;

  // Of each face.
  void write_colors(const std::string& name, Mesh mesh,
                    const std::vector<CGAL::IO::Color>& colors) const;

  void write_plot(const std::string& name, const Json& plot) const;
};

// Gives the faces within a small distance of a sample one color.
void mark_sample(const Face_dual_graph& graph, Index sample, const CGAL::IO::Color& color,
                 std::vector<CGAL::IO::Color>& colors);

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_PICTURES_H
