// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_READ_INPUT_H
#define SEGMENT_MESH_READ_INPUT_H

#include "Failure.h"
#include "../files/Polygon_soup.h"
#include "../files/Polygon_triangulation.h"
#include "../files/read_materials.h"
#include "../files/read_mesh_file.h"
#include "../files/remove_faces_between_tetrahedra.h"
#include "../files/stitch_borders.h"
#include "../files/read_by_assimp.h"
#include "../files/read_by_lib3mf.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace segment_mesh {

using mesh_file::Index;
using mesh_file::Point;
using mesh_file::Polygon;
using mesh_file::Polygon_soup;
using mesh_file::Triangle;

// Returns whether the bytes of an input can be read only once.
inline bool is_stream(const std::string& name)
{
  std::error_code error;
  return name == "-" || std::filesystem::is_fifo(name, error);
}

// Returns the bytes of a file, or of standard input if the name is "-".
inline std::string read_bytes(const std::string& name)
{
  if (name == "-")
    return std::string(std::istreambuf_iterator<char>(std::cin), {});
  std::ifstream in(name, std::ios::binary);
  if (is_stream(name))
    return std::string(std::istreambuf_iterator<char>(in), {});
  std::string result(std::filesystem::file_size(name), '\0');
  in.read(result.data(), static_cast<std::streamsize>(result.size()));
  if (in.bad())
    throw std::runtime_error("the system cannot read it");
  result.resize(static_cast<std::size_t>(in.gcount()));
  return result;
}

// Returns the size of a file in bytes; 0 if it is not known beforehand.
inline double size_of_file(const std::string& name)
{
  std::error_code error;
  const std::uintmax_t result = std::filesystem::file_size(name, error);
  return error ? 0 : static_cast<double>(result);
}

inline void check_is_file(const std::string& name)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(name, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw Failure(Status::INPUT, "there is no file " + name);
  if (error)
    throw Failure(Status::INPUT, name + " cannot be opened: " + error.message());
  if (!std::filesystem::is_regular_file(status))
    throw Failure(Status::INPUT, name + " is not a file");
  errno = 0;
  if (!std::ifstream(name)) {
    if (errno == ENOMEM)
      throw std::bad_alloc();
    throw Failure(Status::INPUT, name + " cannot be opened");
  }
}

// Returns the first warning as the end of a message about a useless mesh; empty without a warning.
inline std::string first_warning(const Polygon_soup& soup)
{ return soup.warnings.empty() ? "" : "; " + soup.warnings[0]; }

// Reads a file in a format that libraries read.
inline Scene read_by_libraries(const std::string& name, const std::string& extension,
                               const Reading_limits& limits)
{
  if (!reads_by_lib3mf || extension != ".3mf")
    return read_by_assimp(name, limits);
  try {
    return read_by_lib3mf(name, limits);
  }
  catch (const std::runtime_error&) {
    Scene scene;
    try {
      scene = read_by_assimp(name, limits);
    }
    catch (const std::runtime_error&) {
    }
    if (scene.soup.number_of_polygons() == 0)
      throw; // what lib3mf says
    return scene;
  }
}

// Returns whether a name has the ending of a format that this build reads. XML seldom is a mesh.
inline bool has_mesh_ending(const std::filesystem::path& name)
{
  const std::string extension = mesh_file::lower_case(name.extension().string());
  return mesh_file::format_of_extension(extension) != mesh_file::Format::UNKNOWN ||
         (reads_by_lib3mf && extension == ".3mf") ||
         (extension != ".xml" && assimp_reads(extension));
}

// Reads a file. Throws `Failure` if it has no mesh. The contents determine the format of a stream,
// and of a file whose ending belongs to another format or to none. Formats that Assimp reads have
// names of nodes and meshes.
inline Scene read_scene(const std::string& name, bool keeps_properties,
                        const Reading_limits& limits = {})
{
  const bool is_file = !is_stream(name);
  if (is_file)
    check_is_file(name);
  const std::string extension =
    mesh_file::lower_case(std::filesystem::path(name).extension().string());
  const mesh_file::Format format = mesh_file::format_of_extension(extension);
  bool is_of_libraries = is_file && format == mesh_file::Format::UNKNOWN;
  Scene scene;
  try {
    if (is_of_libraries) {
      try {
        scene = read_by_libraries(name, extension, limits);
      }
      catch (const std::runtime_error&) {
        const std::string bytes = read_bytes(name);
        const std::string other = mesh_file::other_contents(bytes, false);
        if (mesh_file::marked_format(bytes) == mesh_file::Format::UNKNOWN && other.empty())
          throw;
        is_of_libraries = false;
        scene.soup = mesh_file::read_mesh_file(bytes, format, keeps_properties);
      }
    }
    else {
      const std::string bytes = read_bytes(name);
      scene.soup = mesh_file::read_mesh_file(
        bytes, format == mesh_file::Format::UNKNOWN ? mesh_file::format_of_contents(bytes) : format,
        keeps_properties);
    }
    if (limits.reads_materials) {
      const Input_folder folder(name, limits.allows_external_files);
      Material_reader reader(folder, scene.soup);
      if (is_of_libraries)
        reader.read_descriptions();
      else
        reader.read_material_files();
      scene.missing_files = reader.missing_files();
    }
  }
  catch (const std::runtime_error& e) {
    throw Failure(Status::MESH, name + " cannot be read: " + e.what());
  }
  if (scene.soup.number_of_polygons() == 0)
    throw Failure(Status::MESH, name + " has no faces" + first_warning(scene.soup));
  return scene;
}

// The triangles of all polygons of a file, which are segmented.
struct Input
{
  Polygon_soup soup;
  std::vector<std::string> node_names, mesh_names, missing_files;
  std::vector<Triangle> triangles;
  std::vector<Index> polygon_of_triangle; // ascends
  bool has_tetrahedra = false; // the polygons between two of them have no triangles
};

// Adds the triangles of all polygons.
inline void triangulate(const Polygon_soup& soup, std::vector<Triangle>& triangles,
                        std::vector<Index>& polygon_of_triangle)
{
  mesh_file::Polygon_triangulation triangulate_polygon(soup.points);
  triangles.reserve(soup.number_of_polygons());
  polygon_of_triangle.reserve(soup.number_of_polygons());
  for (Index i = 0; i < soup.number_of_polygons(); ++i) {
    triangulate_polygon(soup.polygon(i), triangles);
    polygon_of_triangle.resize(triangles.size(), i);
  }
}

// Finds the triangles, and joins their borders where the points are repeated.
inline Input triangulated(Scene scene)
{
  Input input;
  input.node_names = std::move(scene.node_names);
  input.mesh_names = std::move(scene.mesh_names);
  input.missing_files = std::move(scene.missing_files);
  input.soup = std::move(scene.soup);
  triangulate(input.soup, input.triangles, input.polygon_of_triangle);
  mesh_file::Border_stitching(input.soup.points, input.triangles)();
  input.has_tetrahedra = mesh_file::remove_faces_between_tetrahedra(input.soup, input.triangles,
                                                                    input.polygon_of_triangle);
  return input;
}

// Returns the input of arrays, whose polygons have three corners or more. Corners at points that
// are not finite are left out as in files. If all polygons are triangles, those that keep three
// corners stay as they are. Throws `std::invalid_argument` if a corner is no point, or no polygon
// keeps three corners.
inline Input input_of_arrays(Polygon_soup soup)
{
  Input input;
  const bool has_triangles_only = soup.corners.size() == 3 * soup.number_of_polygons();
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i)
    for (Index v : soup.polygon(i))
      if (v >= soup.points.size())
        throw std::invalid_argument("triangle " + std::to_string(i) +
                                    " has a corner that is no index of a point");
  remove_infinite_corners(soup);
  if (!has_triangles_only)
    triangulate(soup, input.triangles, input.polygon_of_triangle);
  else
    for (Index i = 0; i < soup.number_of_polygons(); ++i)
      if (const Polygon t = soup.polygon(i); t.size() == 3) {
        input.triangles.push_back({t[0], t[1], t[2]});
        input.polygon_of_triangle.push_back(i);
      }
  if (input.triangles.empty() && !soup.warnings.empty())
    throw std::invalid_argument("the mesh has no face with three corners" + first_warning(soup));
  input.has_tetrahedra =
    mesh_file::remove_faces_between_tetrahedra(soup, input.triangles, input.polygon_of_triangle);
  input.soup = std::move(soup);
  return input;
}

// Returns the number of points of the triangles.
inline std::size_t number_of_vertices(const Input& input)
{
  std::vector<char> is_used(input.soup.points.size(), 0);
  for (const Triangle& t : input.triangles)
    for (Index v : t)
      is_used[v] = 1;
  return static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), 1));
}

// Returns the normal of a triangle, twice as long as its area.
inline Point normal(const Input& input, std::size_t triangle)
{
  const Triangle& t = input.triangles[triangle];
  const Point &p = input.soup.points[t[0]], &q = input.soup.points[t[1]],
              &r = input.soup.points[t[2]];
  Point a;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    a[k] = (q[l] - p[l]) * (r[m] - p[m]) - (q[m] - p[m]) * (r[l] - p[l]);
  }
  return a;
}

// Returns twice the area of a triangle.
inline double area(const Input& input, std::size_t triangle)
{
  const Point n = normal(input, triangle);
  return std::hypot(n[0], n[1], n[2]);
}

// Returns whether an edge has only one triangle.
inline bool has_border(const Input& input)
{
  // The larger ends of the edges, sorted by the smaller ends, which takes a third of the time of
  // sorting pairs
  std::vector<std::size_t> first(input.soup.points.size() + 1, 0);
  const auto for_each_edge = [&](const auto& visit) {
    for (const Triangle& t : input.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        visit(std::minmax<Index>(t[k], t[(k + 1) % 3]));
  };
  for_each_edge([&](const auto& edge) { ++first[edge.first + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Index> larger(first.back());
  std::vector<std::size_t> next(first);
  for_each_edge([&](const auto& edge) { larger[next[edge.first]++] = edge.second; });
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    const auto end = larger.begin() + static_cast<std::ptrdiff_t>(first[v + 1]);
    auto i = larger.begin() + static_cast<std::ptrdiff_t>(first[v]);
    std::sort(i, end);
    for (auto same = i; i != end; i = same) {
      same = std::upper_bound(i, end, *i);
      if (same - i == 1)
        return true;
    }
  }
  return false;
}

// Returns a warning if the faces of an open surface with small holes clearly point inward.
inline std::string inward_warning(const Input& input)
{
  if (input.triangles.empty())
    return "";
  const Point& origin = input.soup.points[input.triangles[0][0]];
  double twice_area = 0, volume = 0; // six times the volume of the cones with the tip `middle`
  Point sum = {0, 0, 0}, middle = {0, 0, 0};
  for (std::size_t t = 0; t < input.triangles.size(); ++t) {
    const Point n = normal(input, t), &p = input.soup.points[input.triangles[t][0]];
    const double length = std::hypot(n[0], n[1], n[2]); // twice the area
    twice_area += length;
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += n[k];
      middle[k] += length * (p[k] - origin[k]);
      volume += n[k] * (p[k] - origin[k]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
    volume -= sum[k] * middle[k] / twice_area;
  const double open = std::hypot(sum[0], sum[1], sum[2]) / twice_area;
  return open < 0.19 && volume / 6 < -0.02 * std::pow(twice_area / 2, 1.5) && has_border(input)
    ? "the faces seem to point inward, and are turned around for the search" : "";
}

// Returns the label with the largest area among the triangles of one polygon.
inline Index largest_label(const Input& input, const std::vector<Index>& label_of_triangle,
                           std::size_t begin, std::size_t end)
{
  std::vector<std::pair<Index, double> > areas;
  for (std::size_t t = begin; t < end; ++t) {
    const auto found = std::find_if(areas.begin(), areas.end(), [&](const auto& a)
                                    { return a.first == label_of_triangle[t]; });
    if (found == areas.end())
      areas.emplace_back(label_of_triangle[t], area(input, t));
    else
      found->second += area(input, t);
  }
  return std::max_element(areas.begin(), areas.end(), [](const auto& a, const auto& b)
                          { return a.second < b.second; })->first;
}

// Returns the label of the neighbor with the longest common edge, for each polygon without a label
// that has neighbors with a label; of several neighbors at an edge, that of the first.
inline std::map<std::size_t, Index> labels_across_edges(const Polygon_soup& soup,
                                                        const std::vector<Index>& labels)
{
  std::map<std::pair<Index, Index>, Index> label_of_edge; // of polygons without a label
  const auto for_each_edge = [&](std::size_t i, const auto& visit) {
    const Polygon polygon = soup.polygon(i);
    for (std::size_t k = 0; k < polygon.size(); ++k)
      visit(std::minmax({polygon[k], polygon[(k + 1) % polygon.size()]}));
  };
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == mesh_file::null_index)
      for_each_edge(i, [&](const auto& e) { label_of_edge.emplace(e, mesh_file::null_index); });
  for (std::size_t i = labels.size(); i-- > 0;)
    if (labels[i] != mesh_file::null_index)
      for_each_edge(i, [&](const auto& e) {
        if (const auto found = label_of_edge.find(e); found != label_of_edge.end())
          found->second = labels[i];
      });
  std::map<std::size_t, Index> result;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    double longest = -1;
    if (labels[i] == mesh_file::null_index)
      for_each_edge(i, [&](const auto& e) {
        const Point &p = soup.points[e.first], &q = soup.points[e.second];
        const double length = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        const Index label = label_of_edge.at(e);
        if (label != mesh_file::null_index && length > longest) {
          longest = length;
          result[i] = label;
        }
      });
  }
  return result;
}

// Gives each polygon without a triangle the label of the neighbor with the longest common edge,
// else of a polygon that it touches, else of the first polygon with a triangle, else 0.
inline void borrow_labels(const Polygon_soup& soup, std::vector<Index>& labels)
{
  if (std::find(labels.begin(), labels.end(), mesh_file::null_index) == labels.end())
    return;
  const auto first = std::find_if(labels.begin(), labels.end(),
                                  [](Index label) { return label != mesh_file::null_index; });
  const Index label_of_others = first == labels.end() ? 0 : *first;
  for (const auto& [polygon, label] : labels_across_edges(soup, labels))
    labels[polygon] = label;
  std::vector<Index> label_of_point(soup.points.size(), mesh_file::null_index);
  for (std::size_t i = labels.size(); i-- > 0;) // the first polygon at a point counts
    if (labels[i] != mesh_file::null_index)
      for (Index v : soup.polygon(i))
        label_of_point[v] = labels[i];
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == mesh_file::null_index) {
      const Polygon polygon = soup.polygon(i);
      const Index* const v = std::find_if(polygon.begin(), polygon.end(), [&](Index p)
                                          { return label_of_point[p] != mesh_file::null_index; });
      labels[i] = v == polygon.end() ? label_of_others : label_of_point[*v];
    }
}

// Returns the label of each polygon: the one with the largest area among its triangles.
inline std::vector<Index> labels_of_polygons(const Input& input,
                                             const std::vector<Index>& label_of_triangle)
{
  const std::vector<Index>& polygons = input.polygon_of_triangle;
  std::vector<Index> result(input.soup.number_of_polygons(), mesh_file::null_index);
  for (std::size_t begin = 0, end; begin < polygons.size(); begin = end) {
    for (end = begin + 1; end < polygons.size() && polygons[end] == polygons[begin];)
      ++end;
    result[polygons[begin]] = end - begin == 1
      ? label_of_triangle[begin] : largest_label(input, label_of_triangle, begin, end);
  }
  borrow_labels(input.soup, result);
  return result;
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_READ_INPUT_H
