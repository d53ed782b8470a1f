// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_MESH_CHANGES_H
#define SEGMENTATION_BENCHMARK_MESH_CHANGES_H

#include "princeton_benchmark.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/point_generators_3.h>
#include <CGAL/version.h>
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

// Changes of a mesh that should change its segmentation little or not at all.
namespace segmentation_benchmark {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> AABB_primitive;
#if CGAL_VERSION_MAJOR >= 6
typedef CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, AABB_primitive> > AABB_tree;
#else
typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, AABB_primitive> > AABB_tree;
#endif

struct Changed_mesh
{
  Mesh mesh;
  std::vector<std::size_t> original_faces; // the face with which each face is compared
};

struct Mesh_change
{
  std::string name;
  Changed_mesh (*apply)(const Mesh&, CGAL::Random&);
};

inline Changed_mesh with_same_faces(const Mesh& mesh)
{
  Changed_mesh result{mesh, std::vector<std::size_t>(mesh.number_of_faces())};
  std::iota(result.original_faces.begin(), result.original_faces.end(), std::size_t(0));
  return result;
}

inline Kernel::Vector_3 random_direction(CGAL::Random& random)
{
  CGAL::Random_points_on_sphere_3<Kernel::Point_3> points(1, random);
  return *points - CGAL::ORIGIN;
}

inline double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

// Returns the mesh after a random rotation, and a translation by the diagonal of the bounding box.
inline Changed_mesh moved_rigidly(const Mesh& mesh, CGAL::Random& random)
{
  const Kernel::Vector_3 axis = random_direction(random);
  const Eigen::Matrix3d r =
    Eigen::AngleAxisd(random.get_double(0, 2 * CGAL_PI),
                      Eigen::Vector3d(axis.x(), axis.y(), axis.z()).normalized())
      .toRotationMatrix();
  const Kernel::Vector_3 t = diagonal(mesh) * random_direction(random);
  Changed_mesh result = with_same_faces(mesh);
  CGAL::Polygon_mesh_processing::transform(
    CGAL::Aff_transformation_3<Kernel>(r(0, 0), r(0, 1), r(0, 2), t.x(),
                                       r(1, 0), r(1, 1), r(1, 2), t.y(),
                                       r(2, 0), r(2, 1), r(2, 2), t.z()), result.mesh);
  return result;
}

// Returns the mesh with `function(p)` in place of each point p.
template <class Function>
Changed_mesh with_points(const Mesh& mesh, const Function& function)
{
  Changed_mesh result = with_same_faces(mesh);
  for (Mesh::Vertex_index v : mesh.vertices())
    result.mesh.point(v) = function(mesh.point(v));
  return result;
}

inline Changed_mesh scaled(const Mesh& mesh, double factor)
{
  return with_points(mesh, [factor](const Kernel::Point_3& p)
    { return Kernel::Point_3(factor * p.x(), factor * p.y(), factor * p.z()); });
}

inline Changed_mesh shifted(const Mesh& mesh, CGAL::Random&)
{
  const Kernel::Vector_3 shift = diagonal(mesh) * Kernel::Vector_3(3.7, -1.3, 0.77);
  return with_points(mesh, [&](const Kernel::Point_3& p) { return p + shift; });
}

inline Changed_mesh with_exchanged_axes(const Mesh& mesh, CGAL::Random&)
{
  return with_points(mesh, [](const Kernel::Point_3& p)
    { return Kernel::Point_3(p.y(), p.z(), p.x()); });
}

inline Changed_mesh mirrored(const Mesh& mesh, CGAL::Random&)
{
  Changed_mesh result = with_points(mesh, [](const Kernel::Point_3& p)
    { return Kernel::Point_3(-p.x(), p.y(), p.z()); });
  CGAL::Polygon_mesh_processing::reverse_face_orientations(result.mesh);
  return result;
}

inline Changed_mesh in_single_precision(const Mesh& mesh, CGAL::Random&)
{
  return with_points(mesh, [](const Kernel::Point_3& p) {
    return Kernel::Point_3(static_cast<float>(p.x()), static_cast<float>(p.y()),
                           static_cast<float>(p.z()));
  });
}

inline std::vector<std::size_t> random_order(std::size_t n, CGAL::Random& random)
{
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t i = n; i > 1; --i)
    std::swap(order[i - 1], order[random.get_int(0, static_cast<int>(i))]);
  return order;
}

inline Changed_mesh renumbered(const Mesh& mesh, CGAL::Random& random)
{
  Changed_mesh result;
  std::vector<Mesh::Vertex_index> new_vertex(mesh.number_of_vertices());
  for (std::size_t v : random_order(mesh.number_of_vertices(), random))
    new_vertex[v] = result.mesh.add_vertex(mesh.point(Mesh::Vertex_index(v)));
  result.original_faces = random_order(mesh.number_of_faces(), random);
  for (std::size_t f : result.original_faces) {
    std::vector<Mesh::Vertex_index> vertices;
    for (Mesh::Vertex_index v :
         CGAL::vertices_around_face(mesh.halfedge(Mesh::Face_index(f)), mesh))
      vertices.push_back(new_vertex[v]);
    std::rotate(vertices.begin(), vertices.begin() + random.get_int(0, 3), vertices.end());
    result.mesh.add_face(vertices);
  }
  return result;
}

// Moves each vertex by `fraction` of the diagonal of the bounding box, along a random direction.
inline Changed_mesh with_noise(const Mesh& mesh, CGAL::Random& random, double fraction)
{
  Changed_mesh result = with_same_faces(mesh);
  const double distance = fraction * diagonal(mesh);
  for (Mesh::Vertex_index v : mesh.vertices())
    result.mesh.point(v) += distance * random_direction(random);
  return result;
}

// Returns the mesh with each face divided into four, at the midpoints of its edges.
inline Changed_mesh subdivided(const Mesh& mesh)
{
  Changed_mesh result;
  for (Mesh::Vertex_index v : mesh.vertices())
    result.mesh.add_vertex(mesh.point(v));
  std::vector<Mesh::Vertex_index> midpoint;
  for (Mesh::Edge_index e : mesh.edges())
    midpoint.push_back(result.mesh.add_vertex(
      CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)))));
  for (Mesh::Face_index f : mesh.faces()) {
    std::vector<Mesh::Vertex_index> middle;
    for (Mesh::Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
      const Mesh::Vertex_index before = midpoint[mesh.edge(h)],
                               after = midpoint[mesh.edge(mesh.next(h))];
      result.mesh.add_face(before, mesh.target(h), after);
      middle.push_back(before);
    }
    result.mesh.add_face(middle);
    result.original_faces.insert(result.original_faces.end(), 4, f);
  }
  return result;
}

inline Kernel::Point_3 centroid(const Mesh& mesh, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                        mesh.point(mesh.target(mesh.next(h))));
}

// Collapses edges until so many are left. The original of a face is the face nearest to its
// centroid.
inline Changed_mesh decimated(const Mesh& mesh, std::size_t number_of_edges)
{
  Changed_mesh result{mesh, {}};
  CGAL::Surface_mesh_simplification::edge_collapse(
    result.mesh, [number_of_edges](const auto&, const auto&, std::size_t, std::size_t current)
    { return current <= number_of_edges; });
  result.mesh.collect_garbage();

  const AABB_tree tree(mesh.faces().begin(), mesh.faces().end(), mesh);
  for (Mesh::Face_index f : result.mesh.faces())
    result.original_faces.push_back(
      tree.closest_point_and_primitive(centroid(result.mesh, f)).second);
  return result;
}

inline const std::vector<Mesh_change>& mesh_changes()
{
  static const std::vector<Mesh_change> changes = {
    {"unit x 25.4", [](const Mesh& m, CGAL::Random&) { return scaled(m, 25.4); }},
    {"unit x 0.001", [](const Mesh& m, CGAL::Random&) { return scaled(m, 0.001); }},
    {"shifted", shifted},
    {"axes exchanged", with_exchanged_axes},
    {"renumbered", renumbered},
    {"mirrored", mirrored},
    {"moved rigidly", moved_rigidly},
    {"float32", in_single_precision},
    {"noise 1e-7", [](const Mesh& m, CGAL::Random& r) { return with_noise(m, r, 1e-7); }},
    {"noise 1e-5", [](const Mesh& m, CGAL::Random& r) { return with_noise(m, r, 1e-5); }},
    {"noise 0.1 %", [](const Mesh& m, CGAL::Random& r) { return with_noise(m, r, 0.001); }},
    {"noise 0.5 %", [](const Mesh& m, CGAL::Random& r) { return with_noise(m, r, 0.005); }},
    {"subdivided", [](const Mesh& m, CGAL::Random&) { return subdivided(m); }},
    {"decimated",
     [](const Mesh& m, CGAL::Random&) { return decimated(m, m.number_of_edges() / 2); }},
  };
  return changes;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_MESH_CHANGES_H
