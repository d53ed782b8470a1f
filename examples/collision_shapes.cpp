// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/segment_spectral_recursive.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
namespace PMP = CGAL::Polygon_mesh_processing;

constexpr double density = 1000; // of water, with coordinates in meters

// The integrals of 1, x and x x^T over the inside of closed meshes.
struct Moments
{
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  // Sums over the tetrahedra between the origin and the triangles.
  void add(const Mesh& mesh)
  {
    for (Mesh::Face_index f : faces(mesh)) {
      Eigen::Matrix3d corners;
      int i = 0;
      for (Mesh::Vertex_index v : vertices_around_face(halfedge(f, mesh), mesh)) {
        const Point& p = mesh.point(v);
        corners.col(i++) << p.x(), p.y(), p.z();
      }
      const double det = corners.determinant();
      const Eigen::Vector3d sum = corners.rowwise().sum();
      volume += det / 6;
      first += det / 24 * sum;
      second += det / 120 * (corners * corners.transpose() + sum * sum.transpose());
    }
  }

  Eigen::Vector3d center() const { return first / volume; }
  double mass() const { return density * std::abs(volume); }

  // Returns the inertia tensor around the center.
  Eigen::Matrix3d inertia() const
  {
    const Eigen::Matrix3d s = mass() * (second / volume - center() * center().transpose());
    return s.trace() * Eigen::Matrix3d::Identity() - s;
  }
};

// Writes the shape as one link of a robot. The paths of the meshes are relative to the file.
bool write_urdf(const Moments& moments, const std::string& visual,
                const std::vector<std::string>& hulls)
{
  const Eigen::Vector3d c = moments.center();
  const Eigen::Matrix3d i = moments.inertia();
  const auto mesh = [](const std::string& file)
  { return "<geometry><mesh filename=\"" + file + "\"/></geometry>"; };
  std::ofstream out("collision_shapes.urdf");
  out.precision(9);
  out << "<?xml version=\"1.0\"?>\n<robot name=\"shape\">\n  <link name=\"shape\">\n"
      << "    <inertial>\n      <origin xyz=\"" << c.transpose() << "\" rpy=\"0 0 0\"/>\n"
      << "      <mass value=\"" << moments.mass() << "\"/>\n"
      << "      <inertia ixx=\"" << i(0, 0) << "\" ixy=\"" << i(0, 1) << "\" ixz=\"" << i(0, 2)
      << "\" iyy=\"" << i(1, 1) << "\" iyz=\"" << i(1, 2) << "\" izz=\"" << i(2, 2)
      << "\"/>\n    </inertial>\n    <visual>" << mesh(visual) << "</visual>\n";
  for (const std::string& hull : hulls)
    out << "    <collision>" << mesh(hull) << "</collision>\n";
  out << "  </link>\n</robot>\n";
  return bool(out.flush());
}

// Writes the shape as one free body for MuJoCo.
bool write_mjcf(const Moments& moments, const std::vector<std::string>& hulls)
{
  const Eigen::Vector3d c = moments.center();
  const Eigen::Matrix3d i = moments.inertia();
  std::ofstream out("collision_shapes.xml");
  out.precision(9);
  out << "<mujoco model=\"shape\">\n  <asset>\n";
  for (std::size_t h = 0; h < hulls.size(); ++h)
    out << "    <mesh name=\"hull_" << h << "\" file=\"" << hulls[h] << "\"/>\n";
  out << "  </asset>\n  <worldbody>\n    <body name=\"shape\">\n      <freejoint/>\n"
      << "      <inertial pos=\"" << c.transpose() << "\" mass=\"" << moments.mass()
      << "\" fullinertia=\"" << i(0, 0) << ' ' << i(1, 1) << ' ' << i(2, 2) << ' ' << i(0, 1)
      << ' ' << i(0, 2) << ' ' << i(1, 2) << "\"/>\n";
  for (std::size_t h = 0; h < hulls.size(); ++h)
    out << "      <geom type=\"mesh\" mesh=\"hull_" << h << "\"/>\n";
  out << "    </body>\n  </worldbody>\n</mujoco>\n";
  return bool(out.flush());
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

  std::vector<std::vector<Point> > points(n);
  for (Mesh::Face_index f : faces(mesh))
    for (Mesh::Vertex_index v : vertices_around_face(halfedge(f, mesh), mesh))
      points[segment_ids[f]].push_back(mesh.point(v));

  std::vector<std::string> files;
  Moments of_hulls, of_mesh;
  std::size_t number_of_faces = 0;
  for (const std::vector<Point>& points_of_segment : points) {
    Mesh hull;
    CGAL::convex_hull_3(points_of_segment.begin(), points_of_segment.end(), hull);
    if (!CGAL::is_closed(hull) || !CGAL::is_triangle_mesh(hull) || PMP::volume(hull) <= 0)
      continue; // simulators reject flat shapes
    files.push_back("hull_" + std::to_string(files.size()) + ".stl");
    if (!CGAL::IO::write_STL(files.back(), hull))
      return EXIT_FAILURE;
    of_hulls.add(hull);
    number_of_faces += num_faces(hull);
  }
  if (files.empty()) {
    std::cerr << "All parts of " << filename << " are flat" << std::endl;
    return EXIT_FAILURE;
  }
  // An open mesh has no inside: its mass is that of the hulls, which counts overlaps twice.
  if (CGAL::is_closed(mesh))
    of_mesh.add(mesh);
  const bool has_volume = of_mesh.volume != 0;
  const Moments& moments = has_volume ? of_mesh : of_hulls;

  Mesh hull_of_mesh;
  CGAL::convex_hull_3(mesh.points().begin(), mesh.points().end(), hull_of_mesh);
  std::cout << files.size() << " convex shapes with " << number_of_faces << " faces in place of "
            << num_faces(mesh) << "; they take "
            << 100 * of_hulls.volume / PMP::volume(hull_of_mesh)
            << " % of the space of one shape around all; " << moments.mass() << " kg by the "
            << (has_volume ? "mesh" : "hulls") << std::endl;
  const bool is_written = CGAL::IO::write_STL("shape.stl", mesh) &&
                          write_urdf(moments, "shape.stl", files) && write_mjcf(moments, files);
  return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
