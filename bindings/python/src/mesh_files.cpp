// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_files.h"

#include "arrays.h"
#include "python_lock.h"

#include <files/Polygon_soup.h>
#include <files/Polygon_triangulation.h>
#include <files/Segmented_mesh.h>
#include <files/read_mesh_file.h>
#include <files/stitch_borders.h>
#include <files/write_mesh_file.h>
#include <files/segment_colors.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
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

// Indices are below 2^32 - 1 and, in files of less than 8 GB, below 2^31.
template <class Element>
py::array_t<std::int32_t> array_of_indices(std::vector<Element> elements,
                                           const std::vector<py::ssize_t>& shape,
                                           std::size_t largest)
{
  if (largest > 0x7fffffff)
    throw py::value_error("there are too many points or polygons");
  return array_of<std::int32_t>(std::move(elements), shape);
}

// The points, the triangles, and the polygon of each triangle.
static py::tuple parse_mesh(const py::bytes& bytes, const std::string& extension)
{
  const std::string_view contents = bytes;
  Polygon_soup soup;
  std::vector<Triangle> triangles;
  std::vector<Index> polygon_of_triangle;
  try {
    const No_python_lock no_python_lock;
    soup = mesh_file::read_mesh_file(contents, mesh_file::format_of_extension(extension), false);
    mesh_file::Polygon_triangulation triangulate(soup.points);
    triangles.reserve(soup.number_of_polygons());
    polygon_of_triangle.reserve(soup.number_of_polygons());
    for (Index i = 0; i < soup.number_of_polygons(); ++i) {
      triangulate(soup.polygon(i), triangles);
      polygon_of_triangle.resize(triangles.size(), i);
    }
    mesh_file::Border_stitching(soup.points, triangles)();
  }
  catch (const std::runtime_error& e) {
    throw py::value_error(e.what());
  }
  const auto number_of_points = static_cast<py::ssize_t>(soup.points.size());
  const auto number_of_triangles = static_cast<py::ssize_t>(triangles.size());
  return py::make_tuple(
    array_of<double>(std::move(soup.points), {number_of_points, 3}),
    array_of_indices(std::move(triangles), {number_of_triangles, 3},
                     static_cast<std::size_t>(number_of_points)),
    array_of_indices(std::move(polygon_of_triangle), {number_of_triangles},
                     soup.number_of_polygons()));
}

// Elements of which each is some numbers of a contiguous array.
template <class Element, class Array>
std::vector<Element> vector_of(const Array& array)
{
  std::vector<Element> result(static_cast<std::size_t>(array.shape(0)));
  if (!result.empty())
    std::memcpy(result.data(), array.data(), result.size() * sizeof(Element));
  return result;
}

template <class Number>
using Contiguous = py::array_t<Number, py::array::c_style>;

// The contents of the file, and of that of its materials. The module's own Python has checked the
// arguments.
static py::tuple format_mesh(const std::string& extension, const Contiguous<double>& points,
                             bool has_float_points, const Contiguous<std::uint32_t>& triangles,
                             const Contiguous<std::uint32_t>& labels,
                             const Contiguous<std::uint8_t>& colors, const std::string& materials)
{
  Polygon_soup soup;
  soup.points = vector_of<Point>(points);
  soup.coordinate_type =
    has_float_points ? mesh_file::Number_type::FLOAT32 : mesh_file::Number_type::FLOAT64;
  for (const Triangle& t : vector_of<Triangle>(triangles)) {
    soup.corners.insert(soup.corners.end(), t.begin(), t.end());
    soup.end_polygon();
  }
  const std::vector<Index> label_of_triangle = vector_of<Index>(labels);
  const std::vector<Rgb> color_of_segment = vector_of<Rgb>(colors);
  const mesh_file::Segmented_mesh mesh{soup, label_of_triangle, color_of_segment};
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
  m.def("parse_mesh", parse_mesh);
  m.def("format_mesh", format_mesh);
  m.def("segment_colors", segment_colors);
}

} // namespace python
