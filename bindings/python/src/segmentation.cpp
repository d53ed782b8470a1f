// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// The module `_core` of the Python package: runs on arrays, and their hierarchies.

#include "Python_run.h"
#include "arrays.h"
#include "hierarchy_arrays.h"
#include "mesh_files.h"
#include "message_of_python.h"
#include "page.h"
#include "python_lock.h"
#include "read_parameters.h"

#include <meshes/hierarchy_json.h>

#include <CGAL/assertions_behaviour.h>
#include <CGAL/property_map.h>
#include <CGAL/segment_spectral_recursive.h>
#include <CGAL/tags.h>

#include <files/Face_vectors.h>

#include <boost/property_map/function_property_map.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace python;
using segmentation::Segmentation_hierarchy;

namespace {

typedef std::optional<py::array_t<std::int64_t> > Optional_integers;

typedef std::pair<std::size_t, std::size_t> Edge;

// Returns edges in ascending order, each given by its two points, the smaller first.
std::vector<Edge> read_edges(const Optional_integers& given)
{
  std::vector<Edge> result;
  if (given) {
    const auto edge = given->unchecked<2>();
    for (py::ssize_t i = 0; i < edge.shape(0); ++i)
      result.emplace_back(edge(i, 0), edge(i, 1));
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Returns a property map of edges: whether an edge is among those given, which must outlive it.
auto edge_map(const std::vector<Edge>& edges)
{
  return boost::make_function_property_map<Edge>(
    [&edges](const Edge& e) { return std::binary_search(edges.begin(), edges.end(), e); });
}

// Returns a property map of triangles, whose values are -1 if no numbers are given.
auto triangle_map(const Optional_integers& given)
{
  return boost::make_function_property_map<std::size_t>([&given](std::size_t t) -> std::int64_t
    { return given ? *given->data(static_cast<py::ssize_t>(t)) : -1; });
}

typedef std::optional<py::array_t<float, py::array::c_style> > Optional_features;

// Returns a property map of triangles to rows of the features, which must outlive it.
auto feature_map(const Optional_features& features)
{
  const float* const data = features ? features->data() : nullptr;
  const std::size_t dimension = features ? static_cast<std::size_t>(features->shape(1)) : 1;
  static const float none = 0;
  return boost::make_function_property_map<std::size_t>([=](std::size_t t) {
    const float* const first = data ? data + t * dimension : &none;
    return mesh_file::Face_vectors::Row{first, first + dimension};
  });
}

// Calls f(tag) so that at most this number of threads work on it; all threads if it is not given.
template <class Function>
void with_threads([[maybe_unused]] const std::optional<int>& number, const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (!number)
    f(CGAL::Parallel_tag());
  else if (*number > 1) // TBB would print a warning for more than there are
    tbb::task_arena(std::min(*number, tbb::this_task_arena::max_concurrency()))
      .execute([&] { f(CGAL::Parallel_tag()); });
  else
#endif
    f(CGAL::Sequential_tag());
}

Segmentation_hierarchy segment(const py::array& points, const py::array& triangles,
                               const py::dict& parameters, const Optional_integers& seams,
                               const Optional_integers& uncuttable, const Optional_integers& seeds,
                               const Optional_integers& groups,
                               const Optional_features& features, const py::object& salience,
                               const std::optional<int>& threads, const py::object& progress)
{
  Python_run run(progress);
  segmentation::Options options = read_parameters(parameters, salience, run);
  if (!features)
    options.feature_weight = 0;
  const Rows<double> point_rows = rows_of<double, float, double>(points);
  const Rows<std::int64_t> triangle_rows =
    rows_of<std::int64_t, std::int32_t, std::int64_t, std::uint32_t, std::uint64_t>(triangles);
  const std::vector<Edge> seam_edges = read_edges(seams);
  const std::vector<Edge> uncuttable_edges = read_edges(uncuttable);
  Segmentation_hierarchy result;
  const auto np = segmentation::parameters::options(options)
                    .edge_is_constrained_map(edge_map(seam_edges))
                    .edge_is_uncuttable_map(edge_map(uncuttable_edges))
                    .face_seed_map(triangle_map(seeds))
                    .face_group_map(triangle_map(groups))
                    .face_feature_map(feature_map(features))
                    .hierarchy(result).visitor(std::ref(run));
  run([&] {
    // Python would make a state of this thread for each call of the salience.
    std::optional<Python_lock> state;
    std::optional<No_python_lock> no_python_lock;
    if (!salience.is_none()) {
      state.emplace();
      no_python_lock.emplace();
    }
    std::vector<std::size_t> ids(triangle_rows.size());
    with_threads(threads, [&](auto tag) {
      CGAL::segment_spectral_recursive<decltype(tag)>(point_rows, triangle_rows,
                                                      CGAL::make_property_map(ids), np);
    });
  });
  return result;
}

// Returns the nodes of the segments.
std::vector<std::size_t> chosen_nodes(const Segmentation_hierarchy& h,
                                      const std::optional<std::size_t>& n,
                                      const std::optional<double>& threshold)
{
  if (!threshold)
    return n ? h.nodes(*n) : h.nodes();
  return n ? h.nodes_above(*threshold, *n) : h.nodes_above(*threshold);
}

std::string to_json(const Segmentation_hierarchy& h)
{
  std::ostringstream out;
  segment_mesh::write_json(out, h, segment_mesh::json_of_hierarchy(h));
  return out.str();
}

Segmentation_hierarchy from_json(const std::string& text)
{
  std::istringstream in(text);
  try {
    return segment_mesh::read_hierarchy_json(in);
  }
  catch (const std::runtime_error& e) {
    throw py::value_error(message_of_python(e));
  }
}

// Defines the class Hierarchy. The module's own Python checks the types of all arguments, and that
// nodes exist.
void define_hierarchy(py::module_& m)
{
  typedef Segmentation_hierarchy H;
  typedef std::vector<std::size_t> Nodes;
  py::class_<H>(m, "Hierarchy")
    .def_property_readonly("number_of_faces", [](const H& h) { return h.number_of_faces(); })
    .def_property_readonly("number_of_nodes", &H::number_of_nodes)
    .def_property_readonly("number_of_roots", &H::number_of_roots)
    .def_property_readonly("number_of_segments", &H::number_of_segments)
    .def_property_readonly("salience_threshold", &H::salience_threshold)
    .def_property_readonly("nodes", table_of_nodes)
    .def_property_readonly("children", children_of_nodes)
    .def_property_readonly("saliences", saliences_of_nodes)
    .def_property_readonly("factors", factors_of_nodes)
    .def("segments", [](const H& h, const std::optional<std::size_t>& n,
                        const std::optional<double>& threshold)
                     { return array_of(chosen_nodes(h, n, threshold)); })
    .def("labels_of_nodes", [](const H& h, const Nodes& nodes)
                            { return array_of(h.labels(nodes)); })
    .def("faces", [](const H& h, std::size_t node) {
      const auto range = h.faces(node);
      return array_of(Nodes(range.begin(), range.end()));
    })
    .def("merge", &H::merge)
    .def("split_leaf", &H::split_leaf)
    .def("to_json", to_json)
    .def_static("from_json", from_json)
    .def("copy", [](const H& h) { return H(h); });
}

} // namespace

PYBIND11_MODULE(_core, m)
{
  // Keeps CGAL from printing its exceptions before it throws them.
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      std::rethrow_exception(error);
    }
    catch (const std::invalid_argument& e) {
      PyErr_SetString(PyExc_ValueError, message_of_python(e).c_str());
    }
    catch (const std::out_of_range& e) { // pybind11 takes it for an exception of a container
      PyErr_SetString(PyExc_ValueError, message_of_python(e).c_str());
    }
  });

  m.attr("__version__") = CGAL_SPECTRAL_SEGMENTATION_VERSION;
  define_hierarchy(m);
  define_mesh_files(m);
  define_parts(m);
  define_page(m);
  m.def("option_kinds", option_kinds);
  m.def("segment", segment);
  py::module_::import("atexit").attr("register")(py::cpp_function(Python_run::end_all));
}
