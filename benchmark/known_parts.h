// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_KNOWN_PARTS_H
#define SEGMENTATION_BENCHMARK_KNOWN_PARTS_H

#include "princeton_benchmark.h"
#include "triangle_soup.h"

#include <CGAL/Spectral_segmentation/internal/base/Index.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Meshes whose parts are known for each triangle: made ones, and files.
namespace segmentation_benchmark {

// A part with a smaller share of the area of the mesh is hardly seen.
constexpr double least_share_of_area = 0.005;

struct Known_parts
{
  std::string name;
  Triangle_soup soup;
  Labels truth;             // per triangle
  std::optional<Mesh> mesh; // the same triangles, if the mesh was made as one
};

inline Known_parts parts_of_mesh(std::string name, Mesh mesh, Labels truth)
{
  Triangle_soup soup = triangle_soup(mesh);
  return {std::move(name), std::move(soup), std::move(truth), std::move(mesh)};
}

// Reads NAME.off, and the parts from NAME.truth beside it, which has one integer for each triangle.
inline Known_parts read_known_parts(const std::filesystem::path& off_file)
{
  Triangle_soup soup = read_triangle_soup(off_file);
  Labels truth = read_labels(std::filesystem::path(off_file).replace_extension(".truth"),
                             soup.triangles.size());
  return {off_file.stem().string(), std::move(soup), std::move(truth), {}};
}

// Returns the .off files of a folder, sorted by name.
inline std::vector<std::filesystem::path> off_files(const std::filesystem::path& folder)
{
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".off")
      files.insert(entry.path());
  if (files.empty())
    throw std::runtime_error(folder.string() + " has no .off file");
  return {files.begin(), files.end()};
}

inline std::vector<double> triangle_areas(const Triangle_soup& soup)
{
  std::vector<double> areas;
  for (const auto& t : soup.triangles)
    areas.push_back(std::sqrt(CGAL::squared_area(soup.points[t[0]], soup.points[t[1]],
                                                 soup.points[t[2]])));
  return areas;
}

// Returns the component of each triangle. All triangles at an edge are connected.
inline Labels components(const Triangle_soup& soup)
{
  using CGAL::Spectral_segmentation::internal::Index;
  const Index n = static_cast<Index>(soup.triangles.size());
  CGAL::Spectral_segmentation::internal::Face_components sets(n);
  std::map<std::pair<std::size_t, std::size_t>, Index> first_at_edge;
  for (Index f = 0; f < n; ++f) {
    sets.add(f);
    const auto& corners = soup.triangles[f];
    for (std::size_t i = 0; i < 3; ++i)
      sets.join(f, first_at_edge.emplace(std::minmax(corners[i], corners[(i + 1) % 3]), f)
                     .first->second);
  }
  std::vector<Index> representatives;
  for (Index f = 0; f < n; ++f)
    representatives.push_back(sets.representative(f));
  return contiguous(representatives);
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_KNOWN_PARTS_H
