// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_ARRAYS_H
#define SPECTRAL_SEGMENTATION_PYTHON_ARRAYS_H

#include <pybind11/numpy.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

namespace python {

namespace py = pybind11;

// The rows of an array of three columns, read where they are. It has to outlive this range.
template <class Number>
class Rows
{
  const char* data_;
  py::ssize_t size_, row_stride_, column_stride_; // the strides in bytes

public:
  class Iterator
  {
    const Rows* rows_;
    py::ssize_t i_;

  public:
    Iterator(const Rows* rows, py::ssize_t i) : rows_(rows), i_(i) {}

    std::array<Number, 3> operator*() const
    {
      std::array<Number, 3> result;
      const char* const row = rows_->data_ + i_ * rows_->row_stride_;
      for (int k = 0; k < 3; ++k)
        std::memcpy(&result[k], row + k * rows_->column_stride_, sizeof(Number));
      return result;
    }

    Iterator& operator++()
    {
      ++i_;
      return *this;
    }

    bool operator!=(const Iterator& other) const { return i_ != other.i_; }
  };

  explicit Rows(const py::array& array)
    : data_(static_cast<const char*>(array.data())), size_(array.shape(0)),
      row_stride_(array.strides(0)), column_stride_(array.strides(1)) {}

  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, size_}; }
};

template <class Number>
bool has_type(const py::array& array)
{ return py::isinstance<py::array_t<Number> >(array); }

// Calls f(rows) with the rows of an array of one of these types.
template <class Number, class... Numbers, class Function>
auto with_rows(const py::array& array, const Function& f)
{
  if constexpr (sizeof...(Numbers) > 0) {
    if (!has_type<Number>(array))
      return with_rows<Numbers...>(array, f);
  }
  else if (!has_type<Number>(array))
    throw std::invalid_argument("an array has another type than it should");
  return f(Rows<Number>(array));
}

// An array of `shape` that takes over a vector, whose elements consist of numbers of that type.
template <class Number, class Element>
py::array_t<Number> array_of(std::vector<Element> elements, std::vector<py::ssize_t> shape)
{
  auto* const kept = new std::vector<Element>(std::move(elements));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<Element>*>(p); });
  return py::array_t<Number>(std::move(shape), reinterpret_cast<const Number*>(kept->data()),
                             owner);
}

// Returns an array of labels or nodes, which are signed in Python.
inline py::array_t<py::ssize_t> array_of(std::vector<std::size_t> numbers)
{
  const auto size = static_cast<py::ssize_t>(numbers.size());
  return array_of<py::ssize_t>(std::move(numbers), {size});
}

} // namespace python

#endif // SPECTRAL_SEGMENTATION_PYTHON_ARRAYS_H
