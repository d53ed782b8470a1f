// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_HIERARCHY_ARRAYS_H
#define SPECTRAL_SEGMENTATION_PYTHON_HIERARCHY_ARRAYS_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>

#include <pybind11/numpy.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace python {

namespace py = pybind11;

using CGAL::Spectral_segmentation::Salience_factors;
using CGAL::Spectral_segmentation::named_factors;

// Returns all factors, in the order of the fields of Python's `SalienceFactors`.
inline py::tuple tuple_of(const Salience_factors& factors)
{
  constexpr std::size_t number = std::size(named_factors);
  py::tuple result(number + 1);
  for (std::size_t i = 0; i < number; ++i)
    result[i] = py::float_(factors.*named_factors[i].value);
  result[number] = py::bool_(factors.is_boundary);
  return result;
}

// Returns an array of one number for each node.
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
    for (py::ssize_t k = 0; k < 2; ++k) // the child of a leaf becomes -1
      children(i, k) = static_cast<py::ssize_t>(h.node(static_cast<std::size_t>(i)).children[k]);
  return result;
}

inline py::array_t<double>
saliences_of_nodes(const CGAL::Spectral_segmentation::Segmentation_hierarchy& h)
{ return array_of_nodes<double>(h, [&](std::size_t i) { return h.node(i).salience; }); }

inline py::dict factors_of_nodes(const CGAL::Spectral_segmentation::Segmentation_hierarchy& h)
{
  py::dict result;
  for (const auto& factor : named_factors)
    result[factor.name] =
      array_of_nodes<double>(h, [&](std::size_t i) { return h.node(i).factors.*factor.value; });
  return result;
}

// Returns a structured array with a row for each node.
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
