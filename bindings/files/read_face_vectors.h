// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_READ_FACE_VECTORS_H
#define SEGMENT_MESH_MESH_FILE_READ_FACE_VECTORS_H

#include "Face_vectors.h"
#include "Text_scanner.h"
#include "decimal_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace mesh_file {

// Returns a vector for each face, from numbers, or from labels if they are single whole numbers.
inline Face_vectors face_vectors_of(std::size_t dimension, std::vector<double> values,
                                    bool are_whole)
{
  if (!are_whole || dimension > 1)
    return face_vectors(dimension, std::move(values));
  std::vector<std::int64_t> labels;
  labels.reserve(values.size());
  for (double x : values)
    labels.push_back(static_cast<std::int64_t>(x));
  return face_vectors_of_labels(labels);
}

// Reads an array of NumPy's format (NPY 1 to 3): of shape (m,) or (m, d), of numbers, in the byte
// order of this machine. All functions throw `std::runtime_error`. There is no library for the
// format in Debian that a header could be taken from, and the rest of NPY is not needed.
class Npy_reader
{
  std::string_view file_;

  [[noreturn]] static void fail(const std::string& what)
  { throw std::runtime_error("the NPY file " + what); }

  // Returns what follows a key of the header, a dictionary of Python.
  static std::string_view value_of(std::string_view header, std::string_view key)
  {
    const std::size_t position = header.find("'" + std::string(key) + "':");
    if (position == std::string_view::npos)
      fail("has no " + std::string(key));
    header.remove_prefix(position + key.size() + 3);
    header.remove_prefix((std::min)(header.find_first_not_of(' '), header.size()));
    return header;
  }

  static std::vector<std::size_t> shape(std::string_view header)
  {
    std::string_view text = value_of(header, "shape");
    text = text.substr(0, text.find(')'));
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < text.size();) {
      std::size_t number = 0;
      const auto [end, error] = std::from_chars(text.data() + i, text.data() + text.size(), number);
      if (error == std::errc())
        result.push_back(number);
      i = error == std::errc() ? static_cast<std::size_t>(end - text.data()) : i + 1;
    }
    return result;
  }

  template <class Number>
  static std::vector<double> numbers(std::string_view bytes, std::size_t n)
  {
    if (n > bytes.size() / sizeof(Number))
      fail("is too short");
    std::vector<double> result;
    result.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      Number number;
      std::memcpy(&number, bytes.data() + i * sizeof number, sizeof number);
      result.push_back(static_cast<double>(number));
    }
    return result;
  }

  static std::vector<double> numbers_of_type(std::string_view type, std::string_view bytes,
                                             std::size_t n)
  {
    type = type.substr(1, type.find('\'', 1) - 1);
    if (!type.empty() && type[0] == '>' && type.substr(2) != "1")
      fail("has the byte order of other machines: save array.astype('<f4')");
    if (!type.empty())
      type.remove_prefix(1);
    if (type == "f4") return numbers<float>(bytes, n);
    if (type == "f8") return numbers<double>(bytes, n);
    if (type == "i1") return numbers<std::int8_t>(bytes, n);
    if (type == "i2") return numbers<std::int16_t>(bytes, n);
    if (type == "i4") return numbers<std::int32_t>(bytes, n);
    if (type == "i8") return numbers<std::int64_t>(bytes, n);
    if (type == "u1" || type == "b1") return numbers<std::uint8_t>(bytes, n);
    if (type == "u2") return numbers<std::uint16_t>(bytes, n);
    if (type == "u4") return numbers<std::uint32_t>(bytes, n);
    if (type == "u8") return numbers<std::uint64_t>(bytes, n);
    fail("has numbers of the type " + in_quotes(type) + ": save array.astype('f4')");
  }

public:
  explicit Npy_reader(std::string_view file) : file_(file) {}

  static bool is_npy(std::string_view file) { return file.substr(0, 6) == "\x93NUMPY"; }

  Face_vectors operator()() const
  {
    const std::size_t size_of_length = file_.size() > 6 && file_[6] == 1 ? 2 : 4;
    std::size_t start = 8 + size_of_length, length = 0;
    if (file_.size() < start)
      fail("ends in its header");
    for (std::size_t i = 0; i < size_of_length; ++i)
      length |= std::size_t(static_cast<unsigned char>(file_[8 + i])) << (8 * i);
    if (length > file_.size() - start)
      fail("ends in its header");
    const std::string_view header = file_.substr(start, length);
    const std::vector<std::size_t> s = shape(header);
    if (s.empty() || s.size() > 2)
      fail("has not the shape (m,) or (m, d)");
    const std::size_t m = s[0], d = s.size() == 2 ? s[1] : 1;
    if (d == 0 || m > (std::numeric_limits<std::size_t>::max)() / d)
      fail("has no numbers");
    const std::string_view type = value_of(header, "descr");
    std::vector<double> values = numbers_of_type(type, file_.substr(start + length), m * d);
    if (value_of(header, "fortran_order").substr(0, 4) == "True" && d > 1) {
      std::vector<double> rows(values.size());
      for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < d; ++j)
          rows[i * d + j] = values[j * m + i];
      values = std::move(rows);
    }
    const bool are_whole = s.size() == 1 && type.substr(0, 4).find('f') == std::string_view::npos;
    return face_vectors_of(d, std::move(values), are_whole);
  }
};

// Reads lines of numbers, which commas, semicolons or blanks separate, one line a face. A first
// line without a number is a heading. Throws `std::runtime_error`.
inline Face_vectors read_csv_of_faces(std::string_view file)
{
  std::vector<double> values;
  std::size_t dimension = 0, line_number = 0, rows = 0;
  bool are_whole = true;
  const auto fail = [&](const std::string& what)
  { throw std::runtime_error("line " + std::to_string(line_number) + " " + what); };
  while (!file.empty()) {
    const std::size_t end = file.find('\n');
    std::string_view line = file.substr(0, end);
    file.remove_prefix(end == std::string_view::npos ? file.size() : end + 1);
    ++line_number;
    const std::string_view blanks = " \t\r,;";
    std::size_t n = 0;
    while (line.find_first_not_of(blanks) != std::string_view::npos) {
      line.remove_prefix(line.find_first_not_of(blanks));
      const std::string_view word = line.substr(0, line.find_first_of(blanks));
      double number = 0;
      const auto [stop, error] = parse_decimal(word.data(), word.data() + word.size(), number);
      const bool is_number = error == std::errc() && stop == word.data() + word.size();
      if (!is_number && line_number == 1)
        break; // a heading
      if (!is_number)
        fail("has " + in_quotes(word) + ", which is no number");
      are_whole = are_whole && word.find_first_not_of("+-0123456789") == std::string_view::npos &&
                  std::abs(number) < 9e15;
      values.push_back(number);
      line.remove_prefix(word.size());
      ++n;
    }
    if (n == 0 && (line_number == 1 || file.empty()))
      continue;
    if (rows > 0 && n != dimension)
      fail("has " + std::to_string(n) + " numbers, but those before have " +
           std::to_string(dimension));
    if (n == 0)
      fail("has no number");
    dimension = n;
    ++rows;
  }
  return values.empty() ? Face_vectors()
                        : face_vectors_of(dimension, std::move(values), are_whole);
}

// Reads the vectors, or the labels, of faces from a file of NumPy's format or a text of numbers.
// Throws `std::runtime_error`.
inline Face_vectors read_face_vectors(const std::string& name)
{
  std::ifstream in(name, std::ios::binary);
  if (!in)
    throw std::runtime_error("cannot be read");
  const std::string file{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  return Npy_reader::is_npy(file) ? Npy_reader(file)() : read_csv_of_faces(file);
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_READ_FACE_VECTORS_H
