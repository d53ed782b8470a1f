// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_READ_PARAMETERS_H
#define SPECTRAL_SEGMENTATION_PYTHON_READ_PARAMETERS_H

#include "Python_run.h"

#include <CGAL/Spectral_segmentation/internal/door/read_options.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>

namespace python {

namespace segmentation = CGAL::Spectral_segmentation;
namespace internal = CGAL::Spectral_segmentation::internal;
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
    const py::gil_scoped_acquire python_lock;
    try {
      return (*function_)(factors).cast<double>();
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

// The parameters that the caller gave, as checked for their types by the module's own Python.
class Parameters
{
  const py::dict& given_;

public:
  explicit Parameters(const py::dict& given) : given_(given) {}

  template <class T>
  std::optional<T> get(const char* name) const
  {
    return given_.contains(name) ? std::optional<T>(given_[name].cast<T>()) : std::nullopt;
  }

  template <class T>
  T get(const char* name, const T& value) const { return get<T>(name).value_or(value); }
};

// The options of the library, which checks their ranges. `salience` is a callable or None.
inline internal::Options read_parameters(const Parameters& given, const py::object& salience,
                                         Python_run& run)
{
  namespace parameters = segmentation::parameters;
  typedef long long Count;
  typedef std::array<double, 3> Weights;

  const bool is_of_paper = given.get<bool>("is_of_paper", false);
  const internal::Options defaults =
    is_of_paper ? internal::zhang_liu_2005_options() : internal::calibrated_options();
  const auto count = [&](const char* name, std::size_t value)
  { return given.get<Count>(name, static_cast<Count>(value)); };
  const Weights distance_weights = given.get<Weights>(
    "distance_weights",
    {defaults.geodesic_weight, defaults.concave_angle_weight, defaults.convex_angle_weight});
  const auto number = given.get<Count>("number_of_segments");
  const auto maximum = given.get<Count>("maximum_number_of_segments");
  const auto threshold = given.get<double>("threshold");
  const auto salience_weights = given.get<Weights>("salience_weights");

  // Named parameters are types: so each set of those that may be left out is one.
  const auto read = [&](const auto& np) {
    return is_of_paper ? internal::read_options(np.zhang_liu_2005().cgal_parameters())
                       : internal::read_options(np.cgal_parameters());
  };
  const auto read_with_threshold = [&](const auto& np)
  { return threshold ? read(np.salience_threshold(*threshold)) : read(np); };
  const auto read_with_number = [&](const auto& np) {
    return number ? read(np.number_of_segments(*number)) :
           maximum ? read_with_threshold(np.maximum_number_of_segments(*maximum)) :
           read_with_threshold(np);
  };
  const auto read_with_salience = [&](const auto& np) {
    if (!salience.is_none())
      return read_with_number(np.part_salience(
        internal::Part_salience(Python_salience(salience, run))));
    if (salience_weights)
      return read_with_number(np.salience_weights((*salience_weights)[0], (*salience_weights)[1],
                                                  (*salience_weights)[2]));
    return read_with_number(np);
  };

  internal::Options result = read_with_salience(
    parameters::minimum_segment_size(
      given.get<double>("minimum_segment_size", defaults.minimum_segment_size))
      .components_apart(given.get<bool>("components_apart", defaults.components_apart))
      .boundary_smoothing(given.get<bool>("boundary_smoothing", false))
      .distance_weights(distance_weights[0], distance_weights[1], distance_weights[2])
      .number_of_reference_faces(
        count("number_of_reference_faces", defaults.number_of_reference_faces))
      .number_of_searched_faces(
        count("number_of_searched_faces", defaults.number_of_searched_faces))
      .number_of_smoothing_iterations(count("number_of_smoothing_iterations", 0)));
  result.random_seed = given.get<std::uint64_t>("random_seed");
  return result;
}

} // namespace python

#endif // SPECTRAL_SEGMENTATION_PYTHON_READ_PARAMETERS_H
