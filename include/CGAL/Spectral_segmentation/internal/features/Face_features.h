// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FACE_FEATURES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FACE_FEATURES_H

#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The feature vectors of the caller's faces. They are read one by one, so that no copy of all is
// needed.
struct Feature_source
{
  std::size_t dimension = 0; // 0: there are no features
  std::function<void(Index face, double* vector)> read;
};

// The feature vectors of the faces of a surface, in units of their standard deviation on the mesh.
struct Face_features
{
  std::size_t dimension = 0; // 0: there are no features, or all faces have the same
  std::vector<float> values; // one vector per face
  double unit = 1;           // in numbers of the caller

  bool empty() const { return dimension == 0; }
  const float* operator[](std::size_t f) const { return &values[f * dimension]; }

  double squared_distance(std::size_t f, std::size_t g) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < dimension; ++i) {
      const double difference = double((*this)[f][i]) - (*this)[g][i];
      sum += difference * difference;
    }
    return sum;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_FACE_FEATURES_H
