// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// The module `_core` of the Python package: runs on arrays, and their hierarchies.

#include "Python_run.h"
#include "arrays.h"
#include "hierarchy_arrays.h"
#include "mesh_files.h"
#include "python_lock.h"
#include "read_parameters.h"

#include <CGAL/Spectral_segmentation/IO/hierarchy_json.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/property_map.h>
#include <CGAL/segment_spectral_recursive.h>
#include <CGAL/tags.h>

#include <files/is_inside_out.h>

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

#ifdef CGAL_LINKED_WITH_TBB
constexpr bool has_threads = true;
#else
constexpr bool has_threads = false;
#endif

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

// Calls f(tag) so that at most this number of threads work on it; all if there is none.
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
                               const Optional_integers& groups, const py::object& salience,
                               const std::optional<int>& threads, const py::object& progress)
{
  Python_run run(progress);
  const segmentation::Options options = read_parameters(parameters, salience, run);
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
                    .hierarchy(result).visitor(std::ref(run));
  bool is_inside_out = false;
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
    is_inside_out = mesh_file::is_inside_out(point_rows, triangle_rows);
  });
  const char* const warning = "the triangles point inwards; turned around, they may have other "
                              "parts, because parts end in concave seams";
  if (is_inside_out && PyErr_WarnEx(PyExc_UserWarning, warning, 2) != 0)
    throw py::error_already_set(); // warnings are errors
  return result;
}

py::ssize_t integer_of(const py::handle& value)
{
  const py::ssize_t result = PyNumber_AsSsize_t(value.ptr(), PyExc_OverflowError);
  if (result == -1 && PyErr_Occurred())
    throw py::error_already_set();
  return result;
}

double real_of(const py::handle& value)
{
  const double result = PyFloat_AsDouble(value.ptr());
  if (result == -1 && PyErr_Occurred())
    throw py::error_already_set();
  return result;
}

std::size_t node_of(const Segmentation_hierarchy& h, const py::handle& value)
{
  const py::ssize_t node = integer_of(value);
  if (node < 0 || static_cast<std::size_t>(node) >= h.number_of_nodes())
    throw std::invalid_argument("there is no node " + std::to_string(node));
  return static_cast<std::size_t>(node);
}

// Returns the nodes of the segments. `n` and `salience_threshold` may be None.
std::vector<std::size_t> chosen_nodes(const Segmentation_hierarchy& h, const py::object& n,
                                      const py::object& threshold)
{
  if (n.is_none())
    return threshold.is_none() ? h.nodes() : h.nodes_above(real_of(threshold));
  const py::ssize_t number = integer_of(n);
  if (number < 1)
    throw std::invalid_argument("n must be at least 1");
  return threshold.is_none() ? h.nodes(static_cast<std::size_t>(number))
                             : h.nodes_above(real_of(threshold), static_cast<std::size_t>(number));
}

py::array_t<py::ssize_t> labels(const Segmentation_hierarchy& h, const py::object& n,
                                const py::object& threshold)
{ return array_of(h.labels(chosen_nodes(h, n, threshold))); }

py::array_t<py::ssize_t> segments(const Segmentation_hierarchy& h, const py::object& n,
                                  const py::object& threshold)
{ return array_of(chosen_nodes(h, n, threshold)); }

py::array_t<py::ssize_t> labels_of_nodes(const Segmentation_hierarchy& h, const py::iterable& given)
{
  std::vector<std::size_t> nodes;
  for (const py::handle node : given)
    nodes.push_back(node_of(h, node));
  return array_of(h.labels(nodes));
}

py::array_t<py::ssize_t> faces(const Segmentation_hierarchy& h, const py::object& node)
{
  const auto range = h.faces(node_of(h, node));
  return array_of(std::vector<std::size_t>(range.begin(), range.end()));
}

std::size_t merge(Segmentation_hierarchy& h, const py::object& a, const py::object& b)
{ return h.merge(node_of(h, a), node_of(h, b)); }

void split_leaf(Segmentation_hierarchy& h, const py::object& leaf,
                const Segmentation_hierarchy& part)
{ h.split_leaf(node_of(h, leaf), part); }

std::string to_json(const Segmentation_hierarchy& h)
{
  std::ostringstream out;
  segmentation::write_hierarchy(out, h);
  return out.str();
}

Segmentation_hierarchy from_json(const std::string& text)
{
  std::istringstream in(text);
  try {
    return segmentation::read_hierarchy(in);
  }
  catch (const std::runtime_error& e) {
    throw py::value_error(e.what());
  }
}

void define_salience_factors(py::module_& m)
{
  py::class_<Factors> factors(
    m, "SalienceFactors",
    "The factors of a cut of a part into two sides, which `part_salience` is called with. `size`, "
    "`cut_strength` and `protrusiveness` are those of the paper; the others are 0 in its method.");
  factors.def_readonly("is_boundary", &Factors::is_boundary,
                       "whether the cut is the boundary of two regions that may be merged; "
                       "`roundness`, `flatness_behind_cut`, `concavity_around_cut`, "
                       "`lower_quartile_of_concavity`, `expansion_before_cut` and "
                       "`number_of_common_neighbors` are 0 for all other cuts");
  for (const Factor& factor : all_factors)
    factors.def_readonly(factor.name, factor.value, factor.documentation);
}

void define_hierarchy(py::module_& m)
{
  typedef Segmentation_hierarchy H;
  py::class_<H>(m, "Hierarchy",
                "The cuts of a run, as a forest of binary trees of nodes, which are numbered from "
                "0. `segment_hierarchy()` makes one.\n\n"
                "It can be pickled and copied. Methods of one hierarchy wait for each other.")
    .def_property_readonly("number_of_faces", [](const H& h) { return h.number_of_faces(); },
                           "the number of triangles of the mesh")
    .def_property_readonly("number_of_nodes", &H::number_of_nodes,
                           "the number of nodes, leaves too")
    .def_property_readonly("number_of_roots", &H::number_of_roots,
                           "The roots are the nodes from 0 to `number_of_roots - 1`.")
    .def_property_readonly("number_of_segments", &H::number_of_segments,
                           "the number of leaves: the most segments that can be asked for")
    .def_property_readonly("salience_threshold", &H::salience_threshold,
                           "the salience threshold of the run")
    .def_property_readonly("nodes", table_of_nodes,
                           "A structured array with a row for each node: `parent`, `first_child` "
                           "(the side of smaller area, to which the factors belong), "
                           "`second_child`, all -1 for none; `number_of_faces`; `area`, in the "
                           "square of the unit of the points; `cut_state`, an index of "
                           "`CUT_STATES`; `salience` of its best cut, 0 if there is none; and the "
                           "factors of that cut, named as in `SalienceFactors`. pandas makes a "
                           "table of it.")
    .def_property_readonly("children", children_of_nodes,
                           "shape (number_of_nodes, 2), -1 for a leaf")
    .def_property_readonly("saliences", saliences_of_nodes,
                           "of the best cut of each node, shape (number_of_nodes,)")
    .def_property_readonly("factors", factors_of_nodes,
                           "of the best cut of each node, by name: a dict of arrays of shape "
                           "(number_of_nodes,)")
    .def("labels", labels, py::arg("n") = py::none(), py::kw_only(),
         py::arg("salience_threshold") = py::none(),
         "labels(n=None, *, salience_threshold=None) -> array of int, shape (number_of_faces,)\n\n"
         "The label of each triangle. Without arguments those of the run; with `n` exactly `n` "
         "segments, or as near to it as there are roots and leaves; with `salience_threshold` "
         "those of a run with this threshold, and with both at most `n`. Nothing is searched "
         "again.\n\n"
         "Raises ValueError if a cut is needed that the run did not search, `n` is below 1, or "
         "`salience_threshold` is not a number.")
    .def("segments", segments, py::arg("n") = py::none(), py::kw_only(),
         py::arg("salience_threshold") = py::none(),
         "segments(n=None, *, salience_threshold=None) -> array of int\n\n"
         "The node of each segment of `labels()` with the same arguments.")
    .def("labels_of_nodes", labels_of_nodes, py::arg("nodes"),
         "labels_of_nodes(nodes) -> array of int, shape (number_of_faces,)\n\n"
         "The label of each triangle if the segments are these nodes.\n\n"
         "Raises ValueError if the nodes do not contain each triangle exactly once.")
    .def("faces", faces, py::arg("node"),
         "faces(node) -> array of int\n\n"
         "The triangles of a node. Raises ValueError if there is no such node.")
    .def("merge", merge, py::arg("a"), py::arg("b"),
         "merge(a, b) -> node\n\n"
         "Makes two nodes the children of one, and returns that. Of two that are no siblings, `b` "
         "is moved to the place of `a`. No other node gets another number.\n\n"
         "Raises ValueError if one contains the other, or they have different roots.")
    .def("split_leaf", split_leaf, py::arg("leaf"), py::arg("part"),
         "split_leaf(leaf, part)\n\n"
         "Cuts a leaf as `part`, the hierarchy of a run on `triangles[hierarchy.faces(leaf)]`.\n\n"
         "Raises ValueError if `leaf` is no leaf, or `part` has another number of triangles or "
         "several roots.")
    .def("to_json", to_json, "to_json() -> str\n\nThe hierarchy as JSON, which the C++ library and "
                             "its tool write and read too.")
    .def_static("from_json", from_json, py::arg("text"),
                "from_json(text) -> Hierarchy\n\n"
                "Reads what `to_json()`, the C++ library or `segment_mesh --hierarchy` has "
                "written. Any text gives a hierarchy or a ValueError.")
    .def(py::pickle([](const H& h) { return py::bytes(to_json(h)); },
                    [](const py::bytes& text) { return from_json(text); }))
    .def("__copy__", [](const H& h) { return H(h); })
    .def("__deepcopy__", [](const H& h, const py::dict&) { return H(h); })
    .def("__repr__", [](const H& h) {
      return "<Hierarchy of " + std::to_string(h.number_of_faces()) + " faces, " +
             std::to_string(h.number_of_nodes()) + " nodes>";
    });
}

} // namespace

PYBIND11_MODULE(_core, m)
{
  // CGAL prints what it throws.
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      std::rethrow_exception(error);
    }
    catch (const std::out_of_range& e) { // pybind11 takes it for that of a container
      PyErr_SetString(PyExc_ValueError, e.what());
    }
  });

  py::options options;
  options.disable_function_signatures(); // the docstrings have better ones
  m.attr("__version__") = CGAL_SPECTRAL_SEGMENTATION_VERSION;
  m.attr("HAS_THREADS") = has_threads;
  define_salience_factors(m);
  define_hierarchy(m);
  define_mesh_files(m);
  m.def("segment", segment);
  py::module_::import("atexit").attr("register")(py::cpp_function(Python_run::end_all));
}
