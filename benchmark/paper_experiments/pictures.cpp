// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures.h"

#include "../colored_mesh.h"
#include "experiment.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>

namespace segmentation_benchmark {

Pictures::Pictures(const std::string& folder) : folder_(folder)
{ std::filesystem::create_directories(folder_); }

std::filesystem::path Pictures::path(std::string name, const char* ending) const
{
  std::replace(name.begin(), name.end(), ' ', '_');
  return folder_ / (name + ending);
}

void Pictures::write_mesh(const std::string& name, Mesh mesh,
                          const std::vector<CGAL::IO::Color>& colors) const
{
  const auto color = mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for (Mesh::Face_index f : mesh.faces())
    color[f] = colors[f];
  std::ofstream out(path(name, ".ply"), std::ios::binary);
  write_ply(out, mesh);
  if (!out.flush())
    throw std::runtime_error("cannot write into " + folder_.string());
}

void Pictures::write_plot(const std::string& name, const Json& plot) const
{
  if (!(std::ofstream(path(name, ".json")) << plot.dump(1) << std::endl))
    throw std::runtime_error("cannot write into " + folder_.string());
}

std::vector<CGAL::IO::Color> segment_colors(Mesh mesh, const Labels& labels)
{
  const auto ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  for (Mesh::Face_index f : mesh.faces())
    ids[f] = static_cast<int>(labels[f]);
  color_segments(mesh, ids, number_of_segments(labels));
  const auto color =
    mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  std::vector<CGAL::IO::Color> result;
  for (Mesh::Face_index f : mesh.faces())
    result.push_back(color[f]);
  return result;
}

std::vector<CGAL::IO::Color> pale(std::vector<CGAL::IO::Color> colors)
{
  const auto paler = [](int channel)
  { return static_cast<unsigned char>((channel + 2 * 255) / 3); };
  for (CGAL::IO::Color& c : colors)
    c = CGAL::IO::Color(paler(c.red()), paler(c.green()), paler(c.blue()));
  return colors;
}

void mark_sample(const Surface& graph, Index sample, const CGAL::IO::Color& color,
                 std::vector<CGAL::IO::Color>& colors)
{
  const double radius = 0.03 * std::sqrt(CGAL::Spectral_segmentation::internal::total_area(graph));
  for (Index f = 0; f < colors.size(); ++f)
    if ((graph.centroid(f) - graph.centroid(sample)).norm() < radius)
      colors[f] = color;
}

} // namespace segmentation_benchmark
