// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_READ_MESH_H
#define SEGMENT_MESH_READ_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OFF/File_header_OFF.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/utility.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef std::vector<std::size_t> Polygon;
typedef std::array<std::size_t, 3> Triangle;

struct Soup
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;
};

// The triangle mesh of a file, and what its faces were in the file.
struct Input_mesh
{
  Mesh mesh;
  std::vector<std::size_t> polygon_of_face; // in ascending order
  std::vector<Polygon> polygons;            // all that the file has, in its order
};

// A point with a strict order also where a coordinate is not a number. CGAL's reader of STL finds
// equal points through std::map, in which such a point would silently become another one.
struct Stl_point : std::array<double, 3>
{
  friend bool operator<(const Stl_point& p, const Stl_point& q)
  {
    return std::lexicographical_compare(
      p.begin(), p.end(), q.begin(), q.end(),
      [](double a, double b) { return std::isnan(b) ? !std::isnan(a) : a < b; });
  }
};

inline bool read_stl(const std::string& name, Soup& soup)
{
  std::vector<Stl_point> points;
  if (!CGAL::IO::read_STL(name, points, soup.polygons, CGAL::parameters::verbose(false)))
    return false;
  for (const Stl_point& p : points)
    soup.points.emplace_back(p[0], p[1], p[2]);
  return true;
}

// The reader reserves what the header asks for, be it more than any file can hold.
inline bool read_off(const std::string& name, Soup& soup)
{
  std::ifstream in(name, std::ios::binary);
  CGAL::File_header_OFF header(false);
  in >> header;
  const std::size_t size = header.size_of_vertices() + header.size_of_facets();
  return in && size < std::filesystem::file_size(name) &&
         CGAL::IO::read_OFF(name, soup.points, soup.polygons, CGAL::parameters::verbose(false));
}

inline void check_input_name(const std::string& name, const std::string& extension)
{
  if (!std::filesystem::exists(name))
    throw std::runtime_error("there is no file " + name);
  if (!std::filesystem::is_regular_file(name))
    throw std::runtime_error(name + " is not a file");
  if (!std::ifstream(name))
    throw std::runtime_error(name + " cannot be opened");
  if (extension != ".off" && extension != ".obj" && extension != ".ply" && extension != ".stl")
    throw std::runtime_error(name + " must end in .off, .obj, .ply or .stl");
}

inline Soup read_soup(const std::string& name)
{
  const std::string extension =
    boost::algorithm::to_lower_copy(std::filesystem::path(name).extension().string());
  check_input_name(name, extension);
  Soup soup;
  const bool is_read =
    extension == ".stl" ? read_stl(name, soup) :
    extension == ".off" ? read_off(name, soup) :
    CGAL::IO::read_polygon_soup(name, soup.points, soup.polygons, CGAL::parameters::verbose(false));
  if (!is_read)
    throw std::runtime_error(name + " cannot be read: it is empty or damaged, is not a mesh, or "
                             "has coordinates that are not finite");

  if (soup.polygons.empty())
    throw std::runtime_error(name + " has no faces");
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(soup.points[i][k]))
        throw std::runtime_error(name + ": point " + std::to_string(i) +
                                 " has a coordinate that is not finite");
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
    for (std::size_t v : soup.polygons[i])
      if (v >= soup.points.size())
        throw std::runtime_error(name + ": face " + std::to_string(i) +
                                 " has a corner that is not a point of the file");
  return soup;
}

// Whether no point is a corner of two polygons. Then the file says nothing of which are neighbors.
inline bool repeats_points_for_each_polygon(const Soup& soup)
{
  std::vector<char> is_used(soup.points.size(), 0);
  for (Polygon polygon : soup.polygons) {
    std::sort(polygon.begin(), polygon.end());
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    for (std::size_t v : polygon) {
      if (is_used[v])
        return false;
      is_used[v] = 1;
    }
  }
  return true;
}

// Triangles with the orientation of the polygon; fewer where it meets a point twice.
inline std::vector<Triangle> triangulate(const Polygon& polygon, const std::vector<Point>& points)
{
  typedef CGAL::Triple<int, int, int> Corners;
  const int n = static_cast<int>(polygon.size());
  std::vector<Corners> corners;
  if (n > 3) {
    std::vector<Point> boundary;
    for (std::size_t v : polygon)
      boundary.push_back(points[v]);
    // The variant in the plane crashes on some polygons without area.
    PMP::triangulate_hole_polyline(
      boundary, std::back_inserter(corners),
      CGAL::parameters::use_2d_constrained_delaunay_triangulation(false));
  }
  if (static_cast<int>(corners.size()) != n - 2) {
    corners.clear();
    for (int i = 2; i < n; ++i)
      corners.emplace_back(0, i - 1, i);
  }

  std::vector<Triangle> result;
  for (const Corners& c : corners) {
    std::array<int, 3> order{c.first, c.second, c.third};
    std::sort(order.begin(), order.end());
    const Triangle t{polygon[order[0]], polygon[order[1]], polygon[order[2]]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      result.push_back(t);
  }
  return result;
}

// Notes for each face whether its orientation was reversed.
struct Reversal_visitor : PMP::Default_orientation_visitor
{
  std::vector<char>* is_reversed;

  explicit Reversal_visitor(std::vector<char>& reversed) : is_reversed(&reversed) {}
  void polygon_orientation_reversed(std::size_t face) { (*is_reversed)[face] ^= 1; }
};

// CGAL orients each component like one of its faces. This takes the side that most of its faces are
// on in the file, for the method tells concave from convex.
inline void orient_like_most_faces(Mesh& mesh, const std::vector<char>& is_reversed)
{
  if (std::count(is_reversed.begin(), is_reversed.end(), 0) ==
      static_cast<std::ptrdiff_t>(is_reversed.size()))
    return;
  const auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  std::vector<std::ptrdiff_t> surplus(PMP::connected_components(mesh, component), 0);
  for (Mesh::Face_index f : mesh.faces())
    surplus[component[f]] += is_reversed[f] ? 1 : -1;
  std::vector<Mesh::Face_index> wrong;
  for (Mesh::Face_index f : mesh.faces())
    if (surplus[component[f]] > 0)
      wrong.push_back(f);
  PMP::reverse_face_orientations(wrong, mesh);
  auto to_remove = component;
  mesh.remove_property_map(to_remove);
}

// A manifold mesh of the triangles, the i-th of which becomes the i-th face.
inline Mesh mesh_of_triangles(std::vector<Point> points, std::vector<Triangle> triangles)
{
  std::vector<char> is_reversed(triangles.size(), 0);
  PMP::orient_polygon_soup(points, triangles,
                           CGAL::parameters::visitor(Reversal_visitor(is_reversed)));
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  if (mesh.number_of_faces() != triangles.size())
    throw std::runtime_error("the faces of the input cannot be joined to a mesh");
  orient_like_most_faces(mesh, is_reversed);
  PMP::stitch_borders(mesh);
  mesh.collect_garbage(); // removes vertices, so that faces keep their numbers
  return mesh;
}

// Reads any file of polygons. Throws `std::runtime_error`, with a sentence, if it has no mesh.
inline Input_mesh read_mesh(const std::string& name)
{
  Soup soup = read_soup(name);
  if (repeats_points_for_each_polygon(soup))
    PMP::merge_duplicate_points_in_polygon_soup(soup.points, soup.polygons);

  Input_mesh input;
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
    for (const Triangle& t : triangulate(soup.polygons[i], soup.points)) {
      triangles.push_back(t);
      input.polygon_of_face.push_back(i);
    }
  if (triangles.empty())
    throw std::runtime_error(name + " has no face with three different corners");
  input.mesh = mesh_of_triangles(std::move(soup.points), std::move(triangles));
  input.polygons = std::move(soup.polygons);
  return input;
}

// The label of each face of the file: of its triangles' labels the one with the largest area. A
// face that could not be in the mesh takes the label of one that it touches, else 0.
template <class LabelMap>
std::vector<int> labels_of_polygons(const Input_mesh& input, const LabelMap& label_of_face)
{
  const int none = -1;
  std::vector<std::map<int, double> > areas(input.polygons.size());
  for (Mesh::Face_index f : input.mesh.faces())
    areas[input.polygon_of_face[f]][label_of_face[f]] += PMP::face_area(f, input.mesh);

  std::vector<int> result;
  std::map<std::size_t, int> label_of_point;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const auto largest = std::max_element(
      areas[i].begin(), areas[i].end(),
      [](const auto& a, const auto& b) { return a.second < b.second; });
    result.push_back(largest == areas[i].end() ? none : largest->first);
    if (result.back() != none)
      for (std::size_t v : input.polygons[i])
        label_of_point.emplace(v, result.back());
  }
  for (std::size_t i = 0; i < result.size(); ++i)
    if (result[i] == none) {
      result[i] = 0;
      for (std::size_t v : input.polygons[i])
        if (label_of_point.count(v) > 0) {
          result[i] = label_of_point[v];
          break;
        }
    }
  return result;
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_READ_MESH_H
