// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_TRIANGULATIONS_H
#define SEGMENTATION_BENCHMARK_TRIANGULATIONS_H

#include "mesh_changes.h"
#include "random_numbers.h"
#include "sized_mesh.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The same shape in other triangles, and the labels carried back. People have segmented the
// original faces, so results are compared on these, whatever was segmented.
namespace segmentation_benchmark {

// Returns the names of the triangulations, of which the first leaves the mesh as it is.
inline const std::vector<std::string>& triangulation_names()
{
  static const std::vector<std::string> names = {"as_is", "decimated", "remeshed", "subdivided"};
  return names;
}

inline bool is_as_is(const std::string& triangulation)
{ return triangulation == triangulation_names().front(); }

// The number of faces of a mesh with few faces, which are large where the surface is flat.
constexpr std::size_t faces_of_decimated = 1500;

inline Mesh decimated_mesh(Mesh mesh)
{
  collapse_edges(mesh, faces_of_decimated);
  return mesh;
}

// The approximate number of faces of a mesh with nearly equilateral faces of one size.
constexpr double faces_of_remeshed = 8000;
constexpr double sharp_angle = 60;

// Returns a mesh of nearly equilateral faces of one size. It keeps sharp edges, but not their
// vertices: if these were protected, short edges would stay along them. The remesher leaves edges
// that are a little shorter than its target. All faces belong to one patch: patches that sharp
// edges enclose vanish when they are smaller than a face, which the remesher of CGAL 5.5 does not
// expect.
inline Mesh remeshed_mesh(Mesh mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const double area_of_face = PMP::area(mesh) / faces_of_remeshed;
  const double length = 1.09 * std::sqrt(4 / std::sqrt(3.) * area_of_face);
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  PMP::detect_sharp_edges(mesh, sharp_angle, is_sharp);
  PMP::isotropic_remeshing(
    mesh.faces(), length, mesh,
    CGAL::parameters::edge_is_constrained_map(is_sharp).number_of_iterations(5)
      .face_patch_map(CGAL::Constant_property_map<Mesh::Face_index, std::size_t>(0)));
  mesh.remove_property_map(is_sharp);
  mesh.collect_garbage();
  return mesh;
}

inline Mesh triangulated_as(const std::string& triangulation, const Mesh& mesh)
{
  if (triangulation == "decimated")
    return decimated_mesh(mesh);
  if (triangulation == "remeshed")
    return remeshed_mesh(mesh);
  if (triangulation == "subdivided")
    return subdivided(mesh).mesh;
  return mesh;
}

struct Retriangulated_mesh
{
  Mesh mesh;
  std::vector<std::vector<std::size_t> > faces_on; // each original face; not empty
};

inline Kernel::Point_3 random_point(const Mesh& mesh, Mesh::Face_index f, Random_engine& random)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  const Kernel::Point_3& p = mesh.point(mesh.source(h));
  double s = uniform_random(random), t = uniform_random(random);
  if (s + t > 1) {
    s = 1 - s;
    t = 1 - t;
  }
  return p + s * (mesh.point(mesh.target(h)) - p) +
         t * (mesh.point(mesh.target(mesh.next(h))) - p);
}

constexpr std::size_t points_on_face = 9;

// Returns for each face of a mesh the faces of another mesh that are nearest to some random points
// on it, among those with an area, because the others have no plane to measure the distance from.
inline std::vector<std::vector<std::size_t> > nearest_faces(const Mesh& mesh, const Mesh& other)
{
  std::vector<Mesh::Face_index> faces;
  for (Mesh::Face_index f : other.faces())
    if (!CGAL::Polygon_mesh_processing::is_degenerate_triangle_face(f, other))
      faces.push_back(f);
  const AABB_tree tree(faces.begin(), faces.end(), other);
  Random_engine random(1);
  std::vector<std::vector<std::size_t> > result;
  for (Mesh::Face_index f : mesh.faces()) {
    std::vector<std::size_t> nearest;
    for (std::size_t i = 0; i < points_on_face; ++i)
      nearest.push_back(tree.closest_point_and_primitive(random_point(mesh, f, random)).second);
    result.push_back(nearest);
  }
  return result;
}

// Relates a triangulation that has been made to the original. Subdivision returns the parents of
// its faces; in others the faces are compared by their place.
inline Retriangulated_mesh retriangulated(const std::string& triangulation, const Mesh& original,
                                          Mesh mesh)
{
  Retriangulated_mesh result{std::move(mesh), {}};
  if (is_as_is(triangulation) || triangulation == "subdivided") {
    result.faces_on.resize(original.number_of_faces());
    const std::size_t children = is_as_is(triangulation) ? 1 : 4;
    for (Mesh::Face_index f : result.mesh.faces())
      result.faces_on.at(f / children).push_back(f);
  }
  else
    result.faces_on = nearest_faces(original, result.mesh);
  return result;
}

inline Retriangulated_mesh retriangulated(const std::string& triangulation, const Mesh& mesh)
{ return retriangulated(triangulation, mesh, triangulated_as(triangulation, mesh)); }

// Relates a triangulation to the original, by a file in the folder `cache`, so that all runs see
// the same mesh. A missing file is written first, and read again. Subdivision has no file.
inline Retriangulated_mesh retriangulated(const std::string& triangulation, const Mesh& mesh,
                                          const std::filesystem::path& cache,
                                          const std::string& name)
{
  if (cache.empty() || is_as_is(triangulation) || triangulation == "subdivided")
    return retriangulated(triangulation, mesh);
  const std::filesystem::path folder = cache / triangulation, file = folder / (name + ".off");
  if (!std::filesystem::exists(file)) {
    std::filesystem::create_directories(folder);
    const std::filesystem::path unfinished = folder / (name + ".unfinished.off");
    Mesh changed = triangulated_as(triangulation, mesh);
    if (!CGAL::IO::write_polygon_mesh(unfinished.string(), changed,
                                      CGAL::parameters::stream_precision(17)))
      throw std::runtime_error("cannot write " + unfinished.string());
    std::filesystem::rename(unfinished, file); // a run that is stopped leaves no half of a mesh
  }
  return retriangulated(triangulation, mesh, read_mesh(file));
}

// Returns for each original face the label that most of the faces on it have, the first of several.
inline Labels carried_back(const Retriangulated_mesh& from, const Labels& labels)
{
  Labels result;
  for (const std::vector<std::size_t>& faces : from.faces_on) {
    const auto votes = [&](std::size_t face) {
      return std::count_if(faces.begin(), faces.end(), [&](std::size_t other)
                           { return labels[other] == labels[face]; });
    };
    result.push_back(labels[*std::max_element(faces.begin(), faces.end(),
      [&](std::size_t a, std::size_t b) { return votes(a) < votes(b); })]);
  }
  return contiguous(result);
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_TRIANGULATIONS_H
