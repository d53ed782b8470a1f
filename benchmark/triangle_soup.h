// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_TRIANGLE_SOUP_H
#define SEGMENTATION_BENCHMARK_TRIANGLE_SOUP_H

#include "princeton_benchmark.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace segmentation_benchmark {

// Triangles that need not form a manifold.
struct Triangle_soup
{
  std::vector<Mesh::Point> points;
  std::vector<std::vector<std::size_t> > triangles; // three points each
};

// Returns the vertices and faces of a mesh, in their order.
inline Triangle_soup triangle_soup(const Mesh& mesh)
{
  Triangle_soup soup;
  CGAL::Polygon_mesh_processing::polygon_mesh_to_polygon_soup(mesh, soup.points, soup.triangles);
  return soup;
}

inline Triangle_soup read_triangle_soup(const std::filesystem::path& path)
{
  Triangle_soup soup;
  if (!CGAL::IO::read_polygon_soup(path.string(), soup.points, soup.triangles))
    throw std::runtime_error("cannot read " + path.string());
  if (soup.triangles.empty())
    throw std::runtime_error(path.string() + " has no triangle");
  for (const std::vector<std::size_t>& corners : soup.triangles)
    if (corners.size() != 3)
      throw std::runtime_error(path.string() + " has a face that is no triangle");
  return soup;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_TRIANGLE_SOUP_H
