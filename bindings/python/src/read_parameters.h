// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_READ_PARAMETERS_H
#define SPECTRAL_SEGMENTATION_PYTHON_READ_PARAMETERS_H

#include "Python_run.h"
#include "hierarchy_arrays.h"
#include "python_lock.h"

#include <CGAL/Spectral_segmentation/Options.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <exception>
#include <type_traits>

namespace python {

namespace segmentation = CGAL::Spectral_segmentation;
namespace py = pybind11;

// Calls a salience of Python's. Copies are made without Python's lock, so they own nothing.
class Python_salience
{
  const py::object* function_;
  Python_run* run_;

public:
  Python_salience(const py::object& function, Python_run& run) : function_(&function), run_(&run) {}

  double operator()(const segmentation::Salience_factors& factors) const
  {
    const Python_lock python_lock;
    try {
      const auto result = call(*function_, tuple_of(factors)).cast<double>();
      if (!std::isnan(result))
        return result;
      run_->abandon(std::make_exception_ptr(py::value_error("part_salience returned NaN")));
    }
    catch (py::cast_error&) {
      run_->abandon(std::make_exception_ptr(py::type_error("part_salience must return a number")));
    }
    catch (...) {
      run_->abandon(std::current_exception());
    }
    throw Python_run::Abandoned();
  }
};

// Returns the kind of each option that is a number or a truth value, by its name.
inline py::dict option_kinds()
{
  py::dict result;
  const segmentation::Options defaults;
  for_each_option(defaults, [&](const segmentation::Option_description& option, const auto&)
    { result[option.name] = option.kind; });
  return result;
}

// Returns the options that the module's own Python gave, which has checked their types. `salience`
// is a callable or None. Throws `std::invalid_argument` if a value is out of its range.
inline segmentation::Options read_parameters(const py::dict& given, const py::object& salience,
                                             Python_run& run)
{
  typedef std::array<double, 3> Weights;
  const auto read = [&](const char* name, auto& value) {
    if (given.contains(name))
      value = given[name].cast<std::decay_t<decltype(value)> >();
  };

  bool uses_paper_method = false;
  read("uses_paper_method", uses_paper_method);
  segmentation::Options o =
    uses_paper_method ? segmentation::Options::zhang_liu_2005() : segmentation::Options();
  if (!salience.is_none())
    o.part_salience = Python_salience(salience, run);
  else if (given.contains("salience_weights")) {
    const Weights w = given["salience_weights"].cast<Weights>();
    o.part_salience = segmentation::Weighted_part_salience{w[0], w[1], w[2]};
  }
  Weights distance_weights = {o.geodesic_weight, o.concave_angle_weight, o.convex_angle_weight};
  read("distance_weights", distance_weights);
  o.geodesic_weight = distance_weights[0];
  o.concave_angle_weight = distance_weights[1];
  o.convex_angle_weight = distance_weights[2];
  for_each_option(o, [&](const segmentation::Option_description& option, auto& field) {
    if (given.contains(option.name))
      option.set(field, given[option.name].cast<double>());
  });
  read("random_seed", o.random_seed);
  check(o);
  return o;
}

} // namespace python

#endif // SPECTRAL_SEGMENTATION_PYTHON_READ_PARAMETERS_H
