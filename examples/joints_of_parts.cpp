// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Segmented_mesh/segment_boundaries.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <Eigen/Eigenvalues>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
using nlohmann::json;

Eigen::Vector3d point(const Mesh& mesh, Mesh::Vertex_index v)
{ return {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}; }

json as_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// The centroid of pieces with a size, which is the length of an edge or the area of a face.
struct Center
{
  double size = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();

  void add(double piece, const Eigen::Vector3d& p)
  {
    size += piece;
    sum += piece * p;
  }

  Eigen::Vector3d point() const { return size > 0 ? Eigen::Vector3d(sum / size) : sum; }
};

// Returns the joint in a boundary. Its axis is the normal of the plane that fits the boundary best.
// It points from the part with the smaller id to the part with the larger id.
json joint(const Mesh& mesh, const CGAL::Segmented_mesh::Segment_boundary<Mesh>& boundary,
           const std::vector<Center>& parts)
{
  Center center;
  for (Mesh::Halfedge_index h : boundary.halfedges) {
    const Eigen::Vector3d p = point(mesh, source(h, mesh)), q = point(mesh, target(h, mesh));
    center.add((q - p).norm(), (p + q) / 2);
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double radius = 0; // the mean distance from the center
  for (Mesh::Halfedge_index h : boundary.halfedges) {
    const Eigen::Vector3d p = point(mesh, source(h, mesh)) - center.point();
    const Eigen::Vector3d q = point(mesh, target(h, mesh)) - center.point();
    const double fraction = (q - p).norm() / center.size / 2; // of each end of the edge
    covariance += fraction * (p * p.transpose() + q * q.transpose());
    radius += fraction * (p.norm() + q.norm());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
  const auto& [smaller, larger] = boundary.segments;
  const Eigen::Vector3d direction = parts[larger].point() - parts[smaller].point();
  Eigen::Vector3d axis = axes.eigenvectors().col(0);
  if (axes.eigenvalues()[1] < 1e-9 * axes.eigenvalues()[2]) // a straight line has many planes
    axis = axes.eigenvectors().col(2).cross(direction).cross(axes.eigenvectors().col(2))
             .normalized();
  if (axis.dot(direction) < 0)
    axis = -axis;
  const bool is_loop =
    source(boundary.halfedges.front(), mesh) == target(boundary.halfedges.back(), mesh);
  return {{"parts", boundary.segments}, {"center", as_json(center.point())},
          {"axis", as_json(axis)}, {"radius", radius}, {"length", center.size},
          {"is_loop", is_loop}};
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto segment_ids = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids);

  std::vector<Center> parts(n);
  for (Mesh::Face_index f : faces(mesh)) {
    const Mesh::Halfedge_index h = halfedge(f, mesh);
    const Eigen::Vector3d a = point(mesh, source(h, mesh)), b = point(mesh, target(h, mesh)),
                          c = point(mesh, target(next(h, mesh), mesh));
    parts[segment_ids[f]].add((b - a).cross(c - a).norm() / 2, (a + b + c) / 3);
  }

  json result = {{"parts", json::array()}, {"joints", json::array()}};
  for (std::size_t i = 0; i < n; ++i)
    result["parts"].push_back(
      {{"id", i}, {"center", as_json(parts[i].point())}, {"area", parts[i].size}});
  for (const auto& boundary : CGAL::segment_boundaries(mesh, segment_ids))
    result["joints"].push_back(joint(mesh, boundary, parts));
  std::cout << n << " parts, " << result["joints"].size() << " joints" << std::endl;
  std::ofstream out("joints.json");
  out << result.dump(1) << '\n';
  return out.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
