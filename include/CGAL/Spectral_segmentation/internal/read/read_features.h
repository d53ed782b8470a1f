// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_FEATURES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_FEATURES_H

#include <CGAL/Spectral_segmentation/internal/base/Run_data.h>
#include <CGAL/Spectral_segmentation/internal/read/read_constraints.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns vectors for labels, any two at about the same distance: a coordinate for each label, or,
// if there are many, random signs.
inline Feature_source features_of_labels(std::vector<Index> labels, std::size_t number)
{
  constexpr std::size_t largest_dimension = 64;
  const std::size_t dimension = (std::min)(number, largest_dimension);
  return {dimension, [labels = std::move(labels), number, dimension](Index face, double* vector) {
    std::uint64_t state = labels[face] + 1;
    for (std::size_t i = 0; i < dimension; ++i) {
      state = 6364136223846793005 * state + 1442695040888963407; // Knuth's MMIX
      vector[i] = number > dimension ? ((state >> 63) != 0 ? 1 : -1) : labels[face] == i;
    }
  }};
}

// Returns the features of faces, or of the positions of triangles. They refer to `faces`.
template <class FaceDescriptor, class CGALNamedParameters>
Feature_source read_features(const std::vector<FaceDescriptor>& faces,
                             const CGALNamedParameters& np)
{
  if constexpr (has_map<FaceDescriptor, internal_np::face_feature_map_t, CGALNamedParameters>()) {
    using boost::get; // finds the overload for pointers
    const auto map = CGAL::parameters::get_parameter(np, internal_np::face_feature_map);
    typedef typename boost::property_traits<std::decay_t<decltype(map)> >::value_type Value;
    if (faces.empty())
      return {};
    if constexpr (std::is_integral<Value>::value) {
      std::map<Value, Index> number;
      std::vector<Index> labels;
      labels.reserve(faces.size());
      for (const FaceDescriptor& f : faces)
        labels.push_back(number.try_emplace(get(map, f), static_cast<Index>(number.size()))
                           .first->second);
      return features_of_labels(std::move(labels), number.size());
    }
    else if constexpr (std::is_floating_point<Value>::value) {
      return {1, [&faces, map](Index f, double* vector)
        { *vector = static_cast<double>(get(map, faces[f])); }};
    }
    else {
      const auto size = [](const Value& v)
      { return static_cast<std::size_t>(std::distance(std::begin(v), std::end(v))); };
      const std::size_t dimension = size(get(map, faces.front()));
      if (dimension == 0)
        throw std::invalid_argument("segment_spectral_recursive: the vectors of face_feature_map "
                                    "have no numbers");
      return {dimension, [&faces, map, size, dimension](Index f, double* vector) {
        const Value& value = get(map, faces[f]);
        if (size(value) != dimension)
          throw std::invalid_argument(
            "segment_spectral_recursive: the vectors of face_feature_map have " +
            std::to_string(dimension) + " numbers at face 0, but " + std::to_string(size(value)) +
            " at face " + std::to_string(f));
        std::transform(std::begin(value), std::end(value), vector,
                       [](const auto& x) { return static_cast<double>(x); });
      }};
    }
  }
  else {
    return {};
  }
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_READ_FEATURES_H
