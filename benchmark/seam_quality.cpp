// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// What `refine_segment_boundaries()` does to the seams between the segments of meshes: their mean
/// turning angle, from one edge to the next, the sum of these angles, and their length, before and
/// after; the smallest new face in mean areas of the faces of the mesh, but for those within faces
/// smaller than a hundredth of it; and the time. The edges of a closed seam turn by 360 degrees or
/// more in all, so the sum cannot come to nothing.

#include "princeton_benchmark.h"
#include "program.h"
#include "segmentation_metrics.h"
#include "timed.h"

#include <CGAL/Segmented_mesh/refine_segment_boundaries.h>
#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

using namespace segmentation_benchmark;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef Mesh::Property_map<Mesh::Face_index, std::size_t> Segment_map;

struct Options
{
  std::vector<std::string> files;
  std::optional<unsigned> iterations;
  bool smooth_boundaries = false;
};

struct Seams
{
  double length = 0;
  double turning = 0;      // the sum of the angles, in degrees
  std::size_t corners = 0; // between two edges of a seam

  double mean_turning() const
  { return corners == 0 ? 0 : turning / static_cast<double>(corners); }
};

Seams seams_of(const Mesh& mesh, const Segment_map& segment)
{
  Seams result;
  std::vector<std::vector<Mesh::Vertex_index> > neighbors(mesh.number_of_vertices());
  for (Mesh::Edge_index e : mesh.edges()) {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    if (mesh.is_border(e) || segment[mesh.face(h)] == segment[mesh.face(mesh.opposite(h))])
      continue;
    result.length += PMP::edge_length(h, mesh);
    neighbors[mesh.source(h)].push_back(mesh.target(h));
    neighbors[mesh.target(h)].push_back(mesh.source(h));
  }
  for (Mesh::Vertex_index v : mesh.vertices()) {
    if (neighbors[v].size() != 2)
      continue;
    const auto before = mesh.point(v) - mesh.point(neighbors[v][0]);
    const auto after = mesh.point(neighbors[v][1]) - mesh.point(v);
    const double x = before * after;
    const double y = std::sqrt(CGAL::cross_product(before, after).squared_length());
    result.turning += std::atan2(y, x) * 180 / CGAL_PI;
    ++result.corners;
  }
  return result;
}

CGAL::Exact_predicates_inexact_constructions_kernel::Triangle_3 triangle(const Mesh& mesh,
                                                                       Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
          mesh.point(mesh.target(mesh.next(h)))};
}

// The smallest area of a face that is no face of the old mesh, nor in a face of it smaller than a
// hundredth of the mean area; in mean areas.
double smallest_new_area(const Mesh& old_mesh, const Mesh& mesh)
{
  const double mean = PMP::area(old_mesh) / static_cast<double>(old_mesh.number_of_faces());
  std::vector<Mesh::Face_index> small;
  for (Mesh::Face_index f : old_mesh.faces())
    if (PMP::face_area(f, old_mesh) < 1e-2 * mean)
      small.push_back(f);
  const auto is_in_small_face = [&](Mesh::Face_index f) {
    const auto t = triangle(mesh, f);
    return std::any_of(small.begin(), small.end(), [&](Mesh::Face_index g) {
      const auto parent = triangle(old_mesh, g);
      for (int i = 0; i < 3; ++i)
        if (CGAL::squared_distance(t[i], parent) > 1e-16 * mean)
          return false;
      return true;
    });
  };
  double smallest = std::numeric_limits<double>::infinity();
  for (Mesh::Face_index f : mesh.faces()) {
    const double area = PMP::face_area(f, mesh) / mean;
    if (area >= smallest || (area < 1e-3 && is_in_small_face(f)))
      continue;
    if (old_mesh.has_valid_index(f) &&
        std::abs(PMP::face_area(f, old_mesh) / mean - area) <= 1e-9 * area)
      continue;
    smallest = area;
  }
  return smallest;
}

struct Sums
{
  std::size_t meshes = 0;
  double turning_before = 0, turning_after = 0, length_ratio = 0, seconds = 0;
  double sum_before = 0, sum_after = 0; // sums of all angles
  double worst_turning_ratio = 0, smallest_area = std::numeric_limits<double>::infinity();
};

void measure(const std::string& file, const Options& o, Sums& sums)
{
  Mesh mesh = read_mesh(file);
  if (!CGAL::is_triangle_mesh(mesh))
    return;
  const Segment_map segment = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:s").first;
  const std::size_t n = CGAL::segment_spectral_recursive(
    mesh, segment,
    CGAL::Spectral_segmentation::parameters::smooth_boundaries(o.smooth_boundaries));
  if (n < 2)
    return;
  const Mesh old_mesh = mesh;
  const Seams before = seams_of(mesh, segment);
  if (before.corners == 0) // connected components
    return;
  const auto [number, time] = timed([&] {
    return o.iterations
             ? CGAL::refine_segment_boundaries(
                 mesh, segment, CGAL::parameters::number_of_iterations(*o.iterations))
             : CGAL::refine_segment_boundaries(mesh, segment);
  });
  const Seams after = seams_of(mesh, segment);
  const double smallest = smallest_new_area(old_mesh, mesh);
  std::printf("%-28s %8zu %4zu %7zu %7.1f %6.1f %9.4g %9.4g %9.2g %8.1f\n",
              std::filesystem::path(file).stem().string().c_str(),
              static_cast<std::size_t>(old_mesh.number_of_faces()), n, number,
              before.mean_turning(), after.mean_turning(), before.length, after.length, smallest,
              1000 * time.thread);
  ++sums.meshes;
  sums.turning_before += before.mean_turning();
  sums.turning_after += after.mean_turning();
  sums.sum_before += before.turning;
  sums.sum_after += after.turning;
  sums.length_ratio += after.length / before.length;
  sums.seconds += time.thread;
  sums.worst_turning_ratio =
    (std::max)(sums.worst_turning_ratio, after.mean_turning() / before.mean_turning());
  sums.smallest_area = (std::min)(sums.smallest_area, smallest);
}

void add_options(CLI::App& app, Options& o)
{
  app.add_option("MESH", o.files, "files with triangle meshes")->required();
  app.add_option("--iterations", o.iterations, "number_of_iterations [that of the function]");
  app.add_flag("--smooth-boundaries", o.smooth_boundaries, "of the segmentation");
}

void run(const Options& o)
{
  std::printf("%-28s %8s %4s %7s %7s %6s %9s %9s %9s %8s\n", "mesh", "faces", "segm", "split",
              "angle", "after", "length", "after", "smallest", "ms");
  Sums sums;
  for (const std::string& file : o.files) {
    try {
      measure(file, o, sums);
    }
    catch (const std::exception& e) {
      std::printf("%-28s left out: %s\n", std::filesystem::path(file).stem().string().c_str(),
                  e.what());
    }
  }
  const double n = static_cast<double>(sums.meshes);
  std::printf("%zu meshes: mean angle %.1f, after %.1f degrees, at most %.2f of that before; "
              "sum of all angles after %.2f, "
              "length after %.3f of that before; smallest new face %.2g; %.1f ms\n",
              sums.meshes, sums.turning_before / n, sums.turning_after / n,
              sums.worst_turning_ratio, sums.sum_after / sums.sum_before, sums.length_ratio / n,
              sums.smallest_area, 1000 * sums.seconds / n);
}

int main(int argc, char** argv)
{
  return run_program("seam_quality", "Seams before and after their refinement.", add_options, run,
                     argc, argv);
}
