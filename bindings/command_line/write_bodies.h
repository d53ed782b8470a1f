// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_WRITE_BODIES_H
#define SEGMENT_MESH_WRITE_BODIES_H

#include "../meshes/read_input.h"
#include "../files/Moments.h"
#include "../files/Segmented_soup.h"
#include "../files/convex_hull.h"
#include "../files/decimal_numbers.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

// A segment as a rigid body, in meters and kilograms.
struct Body
{
  Index segment;
  std::string visual, hull; // files, relative to the file that names them
  mesh_file::Rgb color;
  double mass;
  Eigen::Vector3d center;
  Eigen::Matrix3d inertia; // around the center
  bool has_mesh;           // or is shown by its hull, because it is flat and no solid
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); // of the frame of the body, in that of the mesh
  std::size_t parent = 0; // comes before; that of the first is the first
};

// The place where two segments touch: the length of the common edges, and the integral over them.
struct Contact
{
  double length = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
};

typedef std::map<std::pair<Index, Index>, Contact> Contacts; // by the segments, the smaller first

inline Contacts contacts(const Input& input, const std::vector<Index>& segment_of_polygon)
{
  std::vector<std::array<Index, 3> > edges; // the ends, and a segment beside
  for (std::size_t t = 0; t < input.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(input.triangles[t][k], input.triangles[t][(k + 1) % 3]);
      edges.push_back({a, b, segment_of_polygon[input.polygon_of_triangle[t]]});
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  Contacts result;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i; j-- > 0 && edges[j][0] == edges[i][0] && edges[j][1] == edges[i][1];) {
      const Point &p = input.soup.points[edges[i][0]], &q = input.soup.points[edges[i][1]];
      const double length = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      Contact& contact = result[{edges[j][2], edges[i][2]}];
      contact.length += length;
      contact.sum += length / 2 * (Eigen::Vector3d(p[0], p[1], p[2]) +
                                   Eigen::Vector3d(q[0], q[1], q[2]));
    }
  return result;
}

// Sorts the bodies into a tree. The heaviest one is first. Each of the others is joined to the one
// before with which it has the longest contact, and gets its origin in the middle of the contact. A
// body without contacts is joined to the first one at its own center.
inline std::vector<Body> body_tree(const std::vector<Body>& bodies, const Contacts& contacts,
                                   double meters)
{
  std::map<Index, const Body*> left; // by their segments
  for (const Body& b : bodies)
    left[b.segment] = &b;
  std::map<Index, std::size_t> place; // in the result
  std::vector<Body> result;
  while (!left.empty()) {
    const auto is_lighter = [](const auto& a, const auto& b)
    { return a.second->mass < b.second->mass; };
    Body next = *std::max_element(left.begin(), left.end(), is_lighter)->second;
    if (!result.empty())
      next.origin = next.center;
    double length = 0;
    for (const auto& [segments, contact] : contacts)
      for (const auto& [a, b] : {segments, std::pair(segments.second, segments.first)})
        if (place.count(a) > 0 && left.count(b) > 0 && contact.length > length) {
          length = contact.length;
          next = *left[b];
          next.parent = place[a];
          next.origin = meters / length * contact.sum;
        }
    place[next.segment] = result.size();
    left.erase(next.segment);
    result.push_back(std::move(next));
  }
  return result;
}

// Returns the segments as bodies with the moments of their closed meshes, if these bound a solid,
// otherwise of their hulls, with a warning.
inline std::vector<Body> bodies_of(const mesh_file::Segmented_soup& closed_mesh,
                                   const std::vector<mesh_file::Convex_hull>& hulls,
                                   const std::vector<double>& volumes_of_solids, double meters,
                                   double density, std::vector<std::string>& warnings)
{
  mesh_file::Segment_extraction extract(closed_mesh);
  std::vector<Body> result;
  std::string no_solids;
  std::size_t number = 0;
  for (std::size_t s = 0; s < hulls.size(); ++s) {
    if (hulls[s].points.empty()) // the segment is missing
      continue;
    const bool is_solid = !std::isnan(volumes_of_solids[s]);
    const Polygon_soup part = is_solid ? extract(s) : Polygon_soup();
    const mesh_file::Moments m = is_solid
      ? mesh_file::Moments(part.points, mesh_file::triangles_of(part))
      : mesh_file::Moments(hulls[s].points, hulls[s].triangles);
    if (!is_solid && ++number <= 10)
      no_solids += (number > 1 ? ", " : "") + std::to_string(s);
    const double cube = meters * meters * meters;
    result.push_back({static_cast<Index>(s), "", "", closed_mesh.colors[s],
                      density * cube * m.volume(), meters * m.center(),
                      density * cube * meters * meters * m.inertia(),
                      is_solid || hulls[s].thickness == 0});
  }
  if (number > 0)
    warnings.push_back("segments that bound no solid have the mass and inertia of their hulls: " +
                       no_solids + (number > 10 ? " ..." : ""));
  return result;
}

// Sets the names of the meshes as a file has them.
inline void name_meshes(std::vector<Body>& bodies, const std::string& file,
                        const std::string& part_directory, const std::string& hull_directory,
                        const std::string& extension)
{
  namespace fs = std::filesystem;
  for (Body& b : bodies) {
    const auto name = [&](const std::string& directory) {
      const fs::path path = fs::proximate(directory, fs::absolute(file).parent_path());
      return (path / (mesh_file::segment_name(b.segment) + extension)).generic_string();
    };
    b.hull = name(hull_directory);
    b.visual = b.has_mesh ? name(part_directory) : b.hull;
  }
}

// Returns a text for an attribute of XML.
inline std::string xml_text(const std::string& text)
{
  std::string result;
  for (char c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

// Returns numbers with as many digits as they need, with blanks between them.
template <class Numbers>
std::string number_list(const Numbers& numbers)
{
  std::string result;
  for (double x : numbers) {
    char digits[32];
    result += (result.empty() ? "" : " ") +
              std::string(digits, mesh_file::print_decimal(digits, x + 0.)); // without -0
  }
  return result;
}

inline std::string vector_text(const Eigen::Vector3d& v)
{ return number_list(std::array<double, 3>{v.x(), v.y(), v.z()}); }

inline std::string color_text(const mesh_file::Rgb& color)
{ return number_list(std::array<double, 4>{color[0] / 255., color[1] / 255., color[2] / 255., 1}); }

// Returns the scale of meshes as an attribute, if there is one.
inline std::string scale_text(double meters)
{
  return meters == 1 ? std::string()
                     : " scale=\"" + vector_text(Eigen::Vector3d::Constant(meters)) + '"';
}

// Writes a link for each body, and fixed joints. A mesh has `meters` as its unit.
inline void write_urdf(std::ostream& out, const std::string& name, const std::vector<Body>& bodies,
                       double meters)
{
  out << "<?xml version=\"1.0\"?>\n<robot name=\"" << xml_text(name) << "\">\n";
  for (const Body& b : bodies) {
    const std::string link = mesh_file::segment_name(b.segment);
    const auto mesh = [&](const std::string& file) {
      return "      <origin xyz=\"" + vector_text(-b.origin) + "\" rpy=\"0 0 0\"/>\n" +
             "      <geometry><mesh filename=\"" + xml_text(file) + '"' + scale_text(meters) +
             "/></geometry>\n";
    };
    const auto moment = [&](const char* attribute, int i, int j)
    { return std::string(attribute) + number_list(std::array<double, 1>{b.inertia(i, j)}) + '"'; };
    out << "  <link name=\"" << link << "\">\n    <inertial>\n      <origin xyz=\""
        << vector_text(b.center - b.origin) << "\" rpy=\"0 0 0\"/>\n      <mass value=\""
        << number_list(std::array<double, 1>{b.mass}) << "\"/>\n      <inertia"
        << moment(" ixx=\"", 0, 0) << moment(" ixy=\"", 0, 1) << moment(" ixz=\"", 0, 2)
        << moment(" iyy=\"", 1, 1) << moment(" iyz=\"", 1, 2) << moment(" izz=\"", 2, 2)
        << "/>\n    </inertial>\n    <visual>\n" << mesh(b.visual) << "      <material name=\""
        << link << "\"><color rgba=\"" << color_text(b.color) << "\"/></material>\n"
        << "    </visual>\n    <collision>\n" << mesh(b.hull) << "    </collision>\n  </link>\n";
  }
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const Body &b = bodies[i], &parent = bodies[b.parent];
    const std::string link = mesh_file::segment_name(b.segment);
    out << "  <joint name=\"joint_" << link << "\" type=\"fixed\">\n    <parent link=\""
        << mesh_file::segment_name(parent.segment) << "\"/>\n    <child link=\"" << link
        << "\"/>\n    <origin xyz=\"" << vector_text(b.origin - parent.origin)
        << "\" rpy=\"0 0 0\"/>\n  </joint>\n";
  }
  out << "</robot>\n";
}

// Writes a body of MuJoCo with the bodies that are joined to it inside. It is free if it is the
// first one. Only hulls collide; the viewer hides their group.
inline void write_mjcf_body(std::ostream& out, const std::vector<Body>& bodies, std::size_t i,
                            const std::string& indent)
{
  const Body& b = bodies[i];
  const std::string name = mesh_file::segment_name(b.segment);
  const Eigen::Matrix3d& m = b.inertia;
  const std::string pos = "\" pos=\"" + vector_text(-b.origin) + '"';
  out << indent << "<body name=\"" << name << "\" pos=\""
      << vector_text(b.origin - bodies[b.parent].origin) << "\">\n";
  if (i == 0)
    out << indent << "  <freejoint/>\n";
  out << indent << "  <inertial pos=\"" << vector_text(b.center - b.origin) << "\" mass=\""
      << number_list(std::array<double, 1>{b.mass}) << "\" fullinertia=\""
      << number_list(std::array<double, 6>{m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)})
      << "\"/>\n" << indent << "  <geom type=\"mesh\" mesh=\"" << name << pos
      << " contype=\"0\" conaffinity=\"0\" group=\"2\" rgba=\"" << color_text(b.color) << "\"/>\n"
      << indent << "  <geom type=\"mesh\" mesh=\"" << name << "_hull" << pos << " group=\"3\"/>\n";
  for (std::size_t j = i + 1; j < bodies.size(); ++j)
    if (bodies[j].parent == i)
      write_mjcf_body(out, bodies, j, indent + "  ");
  out << indent << "</body>\n";
}

inline void write_mjcf(std::ostream& out, const std::string& name, const std::vector<Body>& bodies,
                       double meters)
{
  out << "<mujoco model=\"" << xml_text(name) << "\">\n  <asset>\n";
  for (const Body& b : bodies)
    for (const auto& [end, file] : {std::pair("", b.visual), std::pair("_hull", b.hull)})
      out << "    <mesh name=\"" << mesh_file::segment_name(b.segment) << end << "\" file=\""
          << xml_text(file) << '"' << scale_text(meters) << "/>\n";
  out << "  </asset>\n  <worldbody>\n";
  if (!bodies.empty())
    write_mjcf_body(out, bodies, 0, "    ");
  out << "  </worldbody>\n</mujoco>\n";
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_WRITE_BODIES_H
