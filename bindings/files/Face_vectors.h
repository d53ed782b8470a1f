// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_FACE_VECTORS_H
#define SEGMENT_MESH_MESH_FILE_FACE_VECTORS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace mesh_file {

// A vector for each face, all of one length, whatever the features are that a user gives. If there
// are none, each face has the vector (0).
class Face_vectors
{
  std::size_t dimension_ = 0;
  std::vector<float> values_;

public:
  // The numbers of one face.
  struct Row
  {
    const float* first;
    const float* last;

    const float* begin() const { return first; }
    const float* end() const { return last; }
  };

  Face_vectors() = default;

  Face_vectors(std::size_t dimension, std::vector<float> values)
    : dimension_(dimension), values_(std::move(values)) {}

  bool empty() const { return values_.empty(); }
  std::size_t number_of_faces() const { return empty() ? 0 : values_.size() / dimension_; }

  Row operator[](std::size_t face) const
  {
    static const float zero = 0;
    if (empty())
      return {&zero, &zero + 1};
    const float* const first = values_.data() + face * dimension_;
    return {first, first + dimension_};
  }
};

// Returns vectors of numbers less the first finite vector, as a fraction of the largest difference:
// the differences may be small against the numbers. Numbers that are not finite stay so.
inline Face_vectors face_vectors(std::size_t dimension, std::vector<double> values)
{
  std::vector<double> first(dimension, 0.);
  for (auto v = values.begin(); v != values.end(); v += static_cast<std::ptrdiff_t>(dimension))
    if (std::all_of(v, v + static_cast<std::ptrdiff_t>(dimension),
                    [](double x) { return std::isfinite(x); })) {
      std::copy_n(v, dimension, first.begin());
      break;
    }
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] -= first[i % dimension];
    if (std::isfinite(values[i]))
      largest = (std::max)(largest, std::abs(values[i]));
  }
  std::vector<float> result;
  result.reserve(values.size());
  for (double x : values)
    result.push_back(static_cast<float>(largest > 0 ? x / largest : x));
  return {dimension, std::move(result)};
}

// Returns a vector for each label. Any two labels have about the same distance: each is a
// coordinate of its own, or, if there are many, a row of random signs.
inline Face_vectors face_vectors_of_labels(const std::vector<std::int64_t>& labels)
{
  constexpr std::size_t largest_dimension = 64;
  std::map<std::int64_t, std::size_t> number;
  for (std::int64_t label : labels)
    number.emplace(label, number.size());
  const std::size_t dimension = (std::min)(number.size(), largest_dimension);
  std::vector<float> codes;
  std::mt19937 random;
  for (std::size_t i = 0; i < number.size(); ++i)
    for (std::size_t j = 0; j < dimension; ++j)
      codes.push_back(number.size() > dimension ? (random() % 2 == 0 ? 1.f : -1.f)
                                                : (i == j ? 1.f : 0.f));
  std::vector<float> result;
  result.reserve(labels.size() * dimension);
  for (std::int64_t label : labels) {
    const auto code = codes.begin() + static_cast<std::ptrdiff_t>(number[label] * dimension);
    result.insert(result.end(), code, code + static_cast<std::ptrdiff_t>(dimension));
  }
  return {dimension, std::move(result)};
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_FACE_VECTORS_H
