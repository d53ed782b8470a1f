// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_files.h"

#include "arrays.h"
#include "python_lock.h"

#include <CGAL/Segmented_mesh/refine_segment_boundaries.h>

#include <files/limited_hull.h>
#include <meshes/closed_soup.h>
#include <meshes/transferred_labels.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace python {

using mesh_file::Index;
using mesh_file::Point;
using segment_mesh::Input;

typedef Contiguous<std::uint32_t> Labels; // one per triangle

// The arrays of a mesh, which are changed and then given to Python.
struct Part_arrays
{
  std::vector<Point> points;
  std::vector<mesh_file::Triangle> triangles;
  std::vector<Index> labels; // one per triangle

  py::tuple tuple()
  {
    const py::ssize_t n = points.size(), m = triangles.size(), l = labels.size();
    return py::make_tuple(array_of<double>(std::move(points), {n, 3}),
                          array_of_indices(std::move(triangles), {m, 3}, std::size_t(n)),
                          array_of_indices(std::move(labels), {l}, 0));
  }
};

// Returns the arrays of closed segments, the report of the tool as JSON, and its warning.
static py::tuple closed(const Input& input, const Labels& labels)
{
  Part_arrays arrays{input.soup.points, input.triangles, vector_of<Index>(labels)};
  segment_mesh::Closed_segments segments;
  {
    const No_python_lock no_python_lock;
    mesh_file::Border_stitching(arrays.points, arrays.triangles)();
    segments = CGAL::close_segments(arrays.points, arrays.triangles, arrays.labels);
  }
  return py::make_tuple(arrays.tuple(), segment_mesh::closed_report(segments).dump(),
                        segment_mesh::closed_warning(segments));
}

// Returns the arrays with smooth boundaries, and the polygon of each triangle.
static py::tuple refined(const Input& input, const Labels& labels)
{
  Part_arrays arrays{input.soup.points, input.triangles, vector_of<Index>(labels)};
  std::vector<Index> polygons = input.polygon_of_triangle;
  {
    const No_python_lock no_python_lock;
    for (std::size_t t : CGAL::refine_segment_boundaries(arrays.points, arrays.triangles,
                                                         arrays.labels).triangles)
      polygons.push_back(input.polygon_of_triangle[t]);
  }
  const auto size = static_cast<py::ssize_t>(polygons.size());
  return py::make_tuple(arrays.tuple(), array_of_indices(std::move(polygons), {size},
                                                         input.soup.number_of_polygons()));
}

// Returns a label for each triangle of another mesh.
static py::array_t<std::int32_t> transferred(const Input& from, const Labels& labels,
                                             const Input& to)
{
  const std::vector<Index> from_labels = vector_of<Index>(labels);
  std::vector<Index> result;
  {
    const No_python_lock no_python_lock;
    result = segment_mesh::transferred_labels(from, from_labels, to);
  }
  const auto size = static_cast<py::ssize_t>(result.size());
  return array_of_indices(std::move(result), {size}, 0);
}

// Returns the points and triangles of a convex hull, its thickness if it is flat, and its volume.
static py::tuple hull(const Contiguous<double>& points, double extent,
                      std::size_t maximum_number_of_vertices)
{
  mesh_file::Convex_hull result = mesh_file::limited_hull(
    mesh_file::convex_hull(vector_of<Point>(points), extent), maximum_number_of_vertices);
  const double volume = mesh_file::volume(result);
  Part_arrays arrays{std::move(result.points), std::move(result.triangles), {}};
  return py::make_tuple(arrays.tuple(), result.thickness, volume);
}

void define_parts(py::module_& m)
{
  m.def("closed", closed);
  m.def("refined", refined);
  m.def("transferred", transferred);
  m.def("hull", hull);
  m.def("extent", [](const Contiguous<double>& points)
                  { return mesh_file::extent_of(vector_of<Point>(points)); });
}

} // namespace python
