// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_HIERARCHY_ARRAYS_H
#define SPECTRAL_SEGMENTATION_PYTHON_HIERARCHY_ARRAYS_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>

#include <pybind11/numpy.h>

#include <cstddef>
#include <string>
#include <vector>

namespace python {

namespace py = pybind11;

typedef CGAL::Spectral_segmentation::Salience_factors Factors;

struct Factor
{
  const char* name;
  double Factors::*value;
  const char* documentation;
};

// All factors that are numbers. Those from the roundness on are 0 but for boundaries.
constexpr Factor all_factors[] = {
  {"size", &Factors::size, "share of the part's area, in [0, 1/2]"},
  {"cut_strength", &Factors::cut_strength, "concavity of the cut, in [0, 1]"},
  {"protrusiveness", &Factors::protrusiveness, "at most 1"},
  {"log_relative_part_area", &Factors::log_relative_part_area,
   "logarithm of the part's share of the area of the mesh, at most 0"},
  {"concavity_near_cut", &Factors::concavity_near_cut, "in [0, 1]"},
  {"convexity_gain", &Factors::convexity_gain,
   "how much closer to convex the sides are than the part"},
  {"relative_convexity_gain", &Factors::relative_convexity_gain,
   "logarithm of the ratio of convexity defects"},
  {"expansion_behind_cut", &Factors::expansion_behind_cut,
   "how fast the rest widens behind the cut, about 1 on a cylinder, at most 4"},
  {"roundness", &Factors::roundness, "1 for a circle, 0 for a straight line"},
  {"flatness_behind_cut", &Factors::flatness_behind_cut,
   "1 if the rest is flat near the boundary, at least 0"},
  {"concavity_around_cut", &Factors::concavity_around_cut,
   "`concavity_near_cut` within twice the distance"},
  {"lower_quartile_of_concavity", &Factors::lower_quartile_of_concavity,
   "concavity that three quarters of the boundary reach, in [0, 1]"},
  {"expansion_before_cut", &Factors::expansion_before_cut,
   "`expansion_behind_cut` of the smaller side, within twice the distance"},
  {"number_of_common_neighbors", &Factors::number_of_common_neighbors,
   "how many other regions touch both"}};

// One number of each node, as an array.
template <class Number, class Function>
py::array_t<Number> array_of_nodes(const CGAL::Spectral_segmentation::Segmentation_hierarchy& h,
                                   const Function& number_of_node)
{
  py::array_t<Number> result(static_cast<py::ssize_t>(h.number_of_nodes()));
  auto numbers = result.template mutable_unchecked<1>();
  for (std::size_t i = 0; i < h.number_of_nodes(); ++i)
    numbers(static_cast<py::ssize_t>(i)) = static_cast<Number>(number_of_node(i));
  return result;
}

inline py::array_t<py::ssize_t>
children_of_nodes(const CGAL::Spectral_segmentation::Segmentation_hierarchy& h)
{
  py::array_t<py::ssize_t> result({static_cast<py::ssize_t>(h.number_of_nodes()), py::ssize_t(2)});
  auto children = result.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < children.shape(0); ++i)
    for (py::ssize_t k = 0; k < 2; ++k) // that of a leaf becomes -1
      children(i, k) = static_cast<py::ssize_t>(h.node(static_cast<std::size_t>(i)).children[k]);
  return result;
}

inline py::array_t<double>
saliences_of_nodes(const CGAL::Spectral_segmentation::Segmentation_hierarchy& h)
{ return array_of_nodes<double>(h, [&](std::size_t i) { return h.node(i).salience; }); }

inline py::dict factors_of_nodes(const CGAL::Spectral_segmentation::Segmentation_hierarchy& h)
{
  py::dict result;
  for (const Factor& factor : all_factors)
    result[factor.name] =
      array_of_nodes<double>(h, [&](std::size_t i) { return h.node(i).factors.*factor.value; });
  return result;
}

// A structured array: a row for each node.
inline py::object
table_of_nodes(const CGAL::Spectral_segmentation::Segmentation_hierarchy& h)
{
  py::list names, columns, types;
  const auto add = [&](const char* name, const py::array& column) {
    names.append(name);
    columns.append(column);
    types.append(py::make_tuple(name, column.dtype()));
  };
  const auto node = [&](std::size_t i) -> const auto& { return h.node(i); };
  add("parent", array_of_nodes<py::ssize_t>(h, [&](std::size_t i) { return node(i).parent; }));
  add("first_child",
      array_of_nodes<py::ssize_t>(h, [&](std::size_t i) { return node(i).children[0]; }));
  add("second_child",
      array_of_nodes<py::ssize_t>(h, [&](std::size_t i) { return node(i).children[1]; }));
  add("number_of_faces",
      array_of_nodes<py::ssize_t>(h, [&](std::size_t i) { return h.number_of_faces(i); }));
  add("area", array_of_nodes<double>(h, [&](std::size_t i) { return node(i).area; }));
  add("cut_state",
      array_of_nodes<signed char>(h, [&](std::size_t i) { return node(i).cut_state; }));
  add("salience", saliences_of_nodes(h));
  for (const auto& [name, column] : factors_of_nodes(h))
    add(name.cast<std::string>().c_str(), column.cast<py::array>());

  const py::object table = py::module_::import("numpy").attr("empty")(h.number_of_nodes(), types);
  for (std::size_t k = 0; k < names.size(); ++k)
    table[names[k]] = columns[k];
  return table;
}

} // namespace python

#endif // SPECTRAL_SEGMENTATION_PYTHON_HIERARCHY_ARRAYS_H
