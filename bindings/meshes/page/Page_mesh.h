// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_PAGE_PAGE_MESH_H
#define SEGMENT_MESH_PAGE_PAGE_MESH_H

#include "../../files/Polygon_soup.h"
#include "../../files/Polygon_triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace segment_mesh {

using mesh_file::Index;
using mesh_file::Point;
using mesh_file::Triangle;

// Triangles to be shown, and the piece of each.
struct Page_mesh
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<Index> pieces;
};

// The cube around the points of triangles. Its members are a quarter of the coordinates, so that
// differences are finite.
struct Page_cube
{
  Point corner;
  double edge = 0;

  explicit Page_cube(const Page_mesh& mesh)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    corner = {infinity, infinity, infinity};
    Point opposite = {-infinity, -infinity, -infinity};
    for (const Triangle& t : mesh.triangles)
      for (Index v : t)
        for (std::size_t k = 0; k < 3; ++k) {
          corner[k] = (std::min)(corner[k], mesh.points[v][k] / 4);
          opposite[k] = (std::max)(opposite[k], mesh.points[v][k] / 4);
        }
    for (std::size_t k = 0; k < 3; ++k)
      edge = (std::max)(edge, opposite[k] - corner[k]);
  }

  // Returns the place of a point in the cube in multiples of the n-th part of the edge, from 0 to
  // n.
  std::array<double, 3> position(const Point& p, double n) const
  {
    std::array<double, 3> result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = edge > 0 ? (p[k] / 4 - corner[k]) / edge * n : 0;
    return result;
  }
};

// Returns the mesh with all points of a cell of a grid, which has `n` cells along an edge of the
// cube, joined to their mean. Leaves out triangles that lose a corner, and repeated triangles.
inline Page_mesh clustered(const Page_mesh& mesh, const Page_cube& cube, double n)
{
  std::vector<std::pair<std::uint64_t, Index> > cells; // each with its point
  for (Index v = 0; v < mesh.points.size(); ++v) {
    std::uint64_t cell = 0;
    for (double x : cube.position(mesh.points[v], n))
      cell = cell << 21 | static_cast<std::uint64_t>((std::min)(x, n - 1));
    cells.emplace_back(cell, v);
  }
  std::sort(cells.begin(), cells.end());

  Page_mesh result;
  std::vector<Index> joined(mesh.points.size());
  for (std::size_t begin = 0, end; begin < cells.size(); begin = end) {
    Point mean = {0, 0, 0};
    for (end = begin; end < cells.size() && cells[end].first == cells[begin].first; ++end)
      joined[cells[end].second] = static_cast<Index>(result.points.size());
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        mean[k] += mesh.points[cells[i].second][k] / static_cast<double>(end - begin);
    result.points.push_back(mean);
  }

  std::vector<std::pair<Triangle, Index> > corners; // in their order, with the triangles
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    Triangle c;
    for (std::size_t k = 0; k < 3; ++k)
      c[k] = joined[mesh.triangles[t][k]];
    std::sort(c.begin(), c.end());
    if (c[0] != c[1] && c[1] != c[2])
      corners.emplace_back(c, t);
  }
  std::sort(corners.begin(), corners.end());
  const auto last = std::unique(corners.begin(), corners.end(), [](const auto& a, const auto& b)
                                { return a.first == b.first; });
  std::vector<Index> kept;
  for (auto c = corners.begin(); c != last; ++c)
    kept.push_back(c->second);
  std::sort(kept.begin(), kept.end());
  for (Index t : kept) {
    const Triangle& c = mesh.triangles[t];
    result.triangles.push_back({joined[c[0]], joined[c[1]], joined[c[2]]});
    result.pieces.push_back(mesh.pieces[t]);
  }
  return result;
}

// Returns the mesh with its points in the order in which the triangles use them, without others.
inline Page_mesh with_points_in_order(const Page_mesh& mesh)
{
  Page_mesh result;
  result.pieces = mesh.pieces;
  std::vector<Index> number(mesh.points.size(), mesh_file::null_index);
  for (const Triangle& t : mesh.triangles) {
    Triangle renumbered;
    for (std::size_t k = 0; k < 3; ++k) {
      if (number[t[k]] == mesh_file::null_index) {
        number[t[k]] = static_cast<Index>(result.points.size());
        result.points.push_back(mesh.points[t[k]]);
      }
      renumbered[k] = number[t[k]];
    }
    result.triangles.push_back(renumbered);
  }
  return result;
}

// Returns a mesh of at most so many triangles, and not much fewer.
inline Page_mesh simplified(const Page_mesh& mesh, std::size_t most)
{
  const Page_mesh used = with_points_in_order(mesh);
  if (mesh.triangles.size() <= most)
    return used;
  const Page_cube cube(used);
  double n = std::sqrt(static_cast<double>(most));
  Page_mesh result = clustered(used, cube, n);
  for (int attempt = 0; n > 1 && (result.triangles.size() > most ||
                                  (2 * result.triangles.size() < most && attempt < 4)); ++attempt) {
    const double share = static_cast<double>((std::max)(result.triangles.size(), most / 16)) /
                         static_cast<double>(most);
    n = (std::min)((std::max)(1., n * std::sqrt(0.9 / share)), 1048576.);
    result = clustered(used, cube, n);
  }
  return with_points_in_order(result);
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_PAGE_PAGE_MESH_H
