// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_ARRAYS_H
#define SPECTRAL_SEGMENTATION_PYTHON_ARRAYS_H

#include <pybind11/numpy.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

namespace python {

namespace py = pybind11;

// The rows of an array of three columns, whose numbers are read where they are, as `Number`. The
// array has to outlive this range.
template <class Number>
class Rows
{
public:
  typedef Number (*Read)(const char*);

private:
  const char* data_;
  py::ssize_t size_, row_stride_, column_stride_; // the strides in bytes
  Read read_;

public:
  class Iterator
  {
    const Rows* rows_;
    py::ssize_t i_;

  public:
    Iterator(const Rows* rows, py::ssize_t i) : rows_(rows), i_(i) {}

    std::array<Number, 3> operator*() const { return (*rows_)[i_]; }

    Iterator& operator++()
    {
      ++i_;
      return *this;
    }

    bool operator!=(const Iterator& other) const { return i_ != other.i_; }
  };

  Rows(const py::array& array, Read read)
    : data_(static_cast<const char*>(array.data())), size_(array.shape(0)),
      row_stride_(array.strides(0)), column_stride_(array.strides(1)), read_(read) {}

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return static_cast<std::size_t>(size_); }
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, size_}; }

  std::array<Number, 3> operator[](py::ssize_t i) const
  {
    const char* const row = data_ + i * row_stride_;
    return {read_(row), read_(row + column_stride_), read_(row + 2 * column_stride_)};
  }
};

// Returns a number of another type that is at an address.
template <class Number, class Stored>
Number read_as(const char* address)
{
  Stored result;
  std::memcpy(&result, address, sizeof result);
  return static_cast<Number>(result);
}

// Returns the rows of an array of one of the types `Stored`.
template <class Number, class... Stored>
Rows<Number> rows_of(const py::array& array)
{
  typename Rows<Number>::Read read = nullptr;
  ((read = py::isinstance<py::array_t<Stored> >(array) ? &read_as<Number, Stored> : read), ...);
  if (!read)
    throw std::invalid_argument("an array has another type than it should");
  return Rows<Number>(array, read);
}

// Returns an array of `shape` that takes over a vector, whose elements consist of such numbers.
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

// Returns an array of indices, which are below 2^32 - 1 and, for files of less than 8 GB, below
// 2^31.
template <class Element>
py::array_t<std::int32_t> array_of_indices(std::vector<Element> elements,
                                           const std::vector<py::ssize_t>& shape,
                                           std::size_t largest)
{
  if (largest > 0x7fffffff)
    throw py::value_error("there are too many points or polygons");
  return array_of<std::int32_t>(std::move(elements), shape);
}

// Returns elements, each made of some numbers of a contiguous array.
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

} // namespace python

#endif // SPECTRAL_SEGMENTATION_PYTHON_ARRAYS_H
