// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_files.h"

#include "arrays.h"
#include "python_lock.h"

#include <files/Polygon_soup.h>
#include <files/Polygon_triangulation.h>
#include <files/Segmented_soup.h>
#include <files/face_colors.h>
#include <files/read_mesh_file.h>
#include <files/stitch_borders.h>
#include <files/write_mesh_file.h>
#include <files/segment_colors.h>
#include <meshes/read_input.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace python {

using mesh_file::Index;
using mesh_file::Point;
using mesh_file::Polygon_soup;
using mesh_file::Rgb;
using mesh_file::Triangle;
using segment_mesh::Input;

// Removes the points that triangles had before their borders were stitched, but no longer have.
static void remove_joined_points(std::vector<Point>& points, const std::vector<char>& was_used,
                                 std::vector<Triangle>& triangles)
{
  std::vector<char> is_used(points.size(), 0);
  for (const Triangle& t : triangles)
    for (Index v : t)
      is_used[v] = 1;
  std::vector<Index> number(points.size(), mesh_file::null_index);
  Index size = 0;
  for (Index v = 0; v < points.size(); ++v)
    if (is_used[v] || !was_used[v]) {
      number[v] = size;
      points[size++] = points[v];
    }
  points.resize(size);
  for (Triangle& t : triangles)
    for (Index& v : t)
      v = number[v];
}

// Returns a number for each polygon: its segment, if PLY has that property, or else the object and
// group that it has in OBJ; nothing if there are none.
static std::vector<double> segments_of(const Polygon_soup& soup)
{
  for (const mesh_file::Property& p : soup.polygon_properties)
    if (p.name == "segment")
      return p.values;
  return {soup.group_of_polygon.begin(), soup.group_of_polygon.end()};
}

// Returns the points, the triangles, the polygon, the segment and the color of each triangle, and
// the warnings.
static py::tuple parse_mesh(const py::bytes& bytes, const std::string& extension)
{
  const std::string_view contents = bytes;
  Polygon_soup soup;
  std::vector<Triangle> triangles;
  std::vector<Index> polygon_of_triangle;
  std::vector<double> segments, colors;
  std::size_t number_of_polygons = 0;
  try {
    const No_python_lock no_python_lock;
    const mesh_file::Format format = mesh_file::format_of_extension(extension);
    soup = mesh_file::read_mesh_file(contents, format, true);
    number_of_polygons = soup.number_of_polygons();
    segment_mesh::triangulate(soup, triangles, polygon_of_triangle);
    std::vector<char> is_used(soup.points.size(), 0);
    for (const Triangle& t : triangles)
      for (Index v : t)
        is_used[v] = 1;
    mesh_file::Border_stitching(soup.points, triangles)();
    remove_joined_points(soup.points, is_used, triangles);
    const std::vector<double> segment_of_polygon = segments_of(soup);
    if (!segment_of_polygon.empty())
      for (Index i : polygon_of_triangle)
        segments.push_back(segment_of_polygon[i]);
    if (mesh_file::has_colors(soup)) {
      const std::vector<double> color_of_polygon = mesh_file::face_colors(soup);
      for (Index i : polygon_of_triangle)
        colors.insert(colors.end(), &color_of_polygon[3 * i], &color_of_polygon[3 * i] + 3);
    }
  }
  catch (const std::runtime_error& e) {
    throw py::value_error(e.what());
  }
  const auto number_of_points = static_cast<py::ssize_t>(soup.points.size());
  const auto number_of_triangles = static_cast<py::ssize_t>(triangles.size());
  const auto number_of_segments = static_cast<py::ssize_t>(segments.size());
  const auto number_of_colors = static_cast<py::ssize_t>(colors.size() / 3);
  return py::make_tuple(
    array_of<double>(std::move(soup.points), {number_of_points, 3}),
    array_of_indices(std::move(triangles), {number_of_triangles, 3},
                     static_cast<std::size_t>(number_of_points)),
    array_of_indices(std::move(polygon_of_triangle), {number_of_triangles}, number_of_polygons),
    array_of<double>(std::move(segments), {number_of_segments}),
    array_of<double>(std::move(colors), {number_of_colors, 3}), soup.warnings);
}

// Returns the polygons of arrays, and their triangles.
static Input polygons_of(const Contiguous<double>& points, bool has_float_points,
                         const Contiguous<std::uint32_t>& corners,
                         const Contiguous<std::uint32_t>& sizes)
{
  Polygon_soup soup;
  soup.points = vector_of<Point>(points);
  soup.coordinate_type =
    has_float_points ? mesh_file::Number_type::FLOAT32 : mesh_file::Number_type::FLOAT64;
  soup.corners = vector_of<Index>(corners);
  for (Index size : vector_of<Index>(sizes))
    soup.first_corner.push_back(soup.first_corner.back() + size);
  return segment_mesh::input_of_arrays(std::move(soup));
}

static py::array_t<std::int32_t> triangles_of(const Input& input)
{
  return array_of_indices(input.triangles, {static_cast<py::ssize_t>(input.triangles.size()), 3},
                          input.soup.points.size());
}

static py::array_t<std::int32_t> polygons_of_triangles(const Input& input)
{
  return array_of_indices(input.polygon_of_triangle,
                          {static_cast<py::ssize_t>(input.polygon_of_triangle.size())},
                          input.soup.number_of_polygons());
}

static py::array_t<py::ssize_t> labels_of_polygons(const Input& input,
                                                   const Contiguous<std::uint32_t>& labels)
{
  const std::vector<Index> result =
    segment_mesh::labels_of_polygons(input, vector_of<Index>(labels));
  return array_of(std::vector<std::size_t>(result.begin(), result.end()));
}

// Returns the contents of the file, and of the file of its materials. The module's own Python has
// checked the arguments.
static py::tuple format_mesh(const Input& input, const std::string& extension,
                             const Contiguous<std::uint32_t>& labels,
                             const Contiguous<std::uint8_t>& colors, const std::string& materials)
{
  const std::vector<Index> label_of_polygon = vector_of<Index>(labels);
  const std::vector<Rgb> color_of_segment = vector_of<Rgb>(colors);
  const mesh_file::Segmented_soup mesh{input.soup, label_of_polygon, color_of_segment};
  std::ostringstream out, out_of_materials;
  try {
    const No_python_lock no_python_lock;
    mesh_file::write_mesh_file(out, extension, mesh, materials);
    if (!materials.empty())
      mesh_file::write_mtl(out_of_materials, mesh);
  }
  catch (const std::runtime_error& e) {
    throw py::value_error(e.what());
  }
  return py::make_tuple(py::bytes(out.str()), py::bytes(out_of_materials.str()));
}

static Contiguous<std::uint8_t>
segment_colors(const std::vector<std::vector<std::size_t> >& neighbors)
{
  const auto size = static_cast<py::ssize_t>(neighbors.size());
  return array_of<std::uint8_t>(segment_mesh::segment_colors(neighbors), {size, 3});
}

void define_mesh_files(py::module_& m)
{
  py::class_<Input>(m, "Polygons")
    .def(py::init(&polygons_of))
    .def_property_readonly("warnings", [](const Input& input) { return input.soup.warnings; })
    .def_property_readonly("inward_warning", segment_mesh::inward_warning)
    .def_property_readonly("triangles", triangles_of)
    .def_property_readonly("polygon_of_triangle", polygons_of_triangles)
    .def("labels", labels_of_polygons)
    .def("format", format_mesh);
  m.def("parse_mesh", parse_mesh);
  m.def("segment_colors", segment_colors);
}

} // namespace python
