// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_SEARCHED_FEATURES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_SEARCHED_FEATURES_H

#include <CGAL/Spectral_segmentation/internal/features/Face_features.h>
#include <CGAL/Spectral_segmentation/internal/features/principal_subspace.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The means of features at the vertices of a surface, each with the area that it is the mean of.
struct Vertex_features
{
  Row_matrix means;
  std::vector<double> areas;
};

// Adds factor * (a - b) to a sum. Blocks of a fixed size are what compilers vectorize with -O2.
inline void add_difference(double factor, const std::vector<double>& a,
                           const std::vector<double>& b, double* sum)
{
  constexpr std::size_t block = 8;
  std::size_t i = 0;
  for (; i + block <= a.size(); i += block)
    for (std::size_t j = i; j < i + block; ++j)
      sum[j] += factor * (a[j] - b[j]);
  for (; i < a.size(); ++i)
    sum[i] += factor * (a[i] - b[i]);
}

// Throws `std::invalid_argument`, because a number is not finite or sums of such numbers are not.
[[noreturn]] inline void throw_for_infinite(const Feature_source& source,
                                            const std::vector<Index>& callers_face)
{
  std::vector<double> features(source.dimension);
  for (Index f : callers_face) {
    source.read(f, features.data());
    for (double x : features)
      if (!std::isfinite(x))
        throw std::invalid_argument("segment_spectral_recursive: face_feature_map has a number "
                                    "that is not finite, at face " + std::to_string(f));
  }
  throw std::invalid_argument("segment_spectral_recursive: face_feature_map has numbers that are "
                              "too large: scale them");
}

// Computes means of features over the faces around each vertex of another surface, by area. Of a
// mesh with many more faces than that surface, every k-th face is read, so that 16 faces or so
// count at each vertex; all large faces are. Features are relative to those of the first face, so
// that a large number that they have in common does not cost digits.
class Feature_means
{
  const Feature_source& source_;
  const Surface& mesh_;
  const std::vector<Index>& callers_face_; // whose features each face has
  const std::vector<Index>& vertex_;       // of the other surface, or null_index, for each vertex
  std::vector<double> first_, features_;
  Index last_read_ = null_index;
  Vertex_features result_;

  void read(Index f)
  {
    if (callers_face_[f] != last_read_) // bisected faces follow each other
      source_.read(callers_face_[f], features_.data());
    last_read_ = callers_face_[f];
  }

  Corners vertices(Index f) const
  {
    const Corners& c = mesh_.corners[f];
    return {vertex_[c[0]], vertex_[c[1]], vertex_[c[2]]};
  }

  void add(Index f)
  {
    read(f);
    Corners v = vertices(f);
    std::sort(v.begin(), v.end());
    for (std::size_t i = 0, end = 0; i < 3; i = end) { // equal vertices at once
      while (end < 3 && v[end] == v[i])
        ++end;
      if (v[i] == null_index)
        continue;
      const double share = mesh_.areas[f] * static_cast<double>(end - i) / 3;
      result_.areas[v[i]] += share;
      add_difference(share, features_, first_, result_.means[v[i]]);
    }
  }

  bool touches_unread_vertex(Index f) const
  {
    const Corners c = vertices(f);
    return std::any_of(c.begin(), c.end(), [&](Index v)
      { return v != null_index && !(result_.areas[v] > 0); });
  }

public:
  Feature_means(const Feature_source& source, const Surface& mesh,
                const std::vector<Index>& callers_face, const std::vector<Index>& vertex,
                std::size_t number_of_vertices)
    : source_(source), mesh_(mesh), callers_face_(callers_face), vertex_(vertex),
      first_(source.dimension), features_(source.dimension),
      result_{Row_matrix(number_of_vertices, source.dimension),
              std::vector<double>(number_of_vertices, 0)}
  {}

  Vertex_features operator()()
  {
    const std::size_t n = result_.areas.size(), number_of_faces = mesh_.number_of_faces();
    const std::size_t stride = (std::max)(number_of_faces / (16 * n), std::size_t(1));
    const double large_area = total_area(mesh_) / static_cast<double>(4 * n);
    source_.read(callers_face_.front(), first_.data());
    const auto is_sample = [&](Index f) { return f % stride == 0 || mesh_.areas[f] > large_area; };
    for (Index f = 0; f < number_of_faces; ++f)
      if (is_sample(f))
        add(f);
    for (Index f = 0; f < number_of_faces; ++f)
      if (!is_sample(f) && touches_unread_vertex(f))
        add(f);
    for (double x : result_.means.values)
      if (!(std::abs(x) <= 1e150)) // whose square is finite
        throw_for_infinite(source_, callers_face_);
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t i = 0; i < source_.dimension; ++i)
        result_.means[v][i] /= result_.areas[v] > 0 ? result_.areas[v] : 1;
    return std::move(result_);
  }
};

// Subtracts the mean over all vertices, and divides so that the largest number is 1. Rounds, so
// that the order in which sums were taken makes no difference. Returns the divisor; 0 if all
// features are the same.
inline double standardize(Vertex_features& features)
{
  const std::size_t n = features.areas.size(), d = features.means.number_of_columns;
  std::vector<double> mean(d, 0);
  double area = 0;
  for (std::size_t v = 0; v < n; ++v) {
    area += features.areas[v];
    for (std::size_t i = 0; i < d; ++i)
      mean[i] += features.areas[v] * features.means[v][i];
  }
  double largest = 0;
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t i = 0; i < d; ++i) {
      double& x = features.means[v][i];
      x = features.areas[v] > 0 ? x - mean[i] / area : 0;
      largest = (std::max)(largest, std::abs(x));
    }
  if (!(largest > 0))
    return 0;
  constexpr double digits = 1 << 24;
  for (double& x : features.means.values)
    x = std::round(x / largest * digits) / digits;
  return largest;
}

// Returns the features of the faces, each the mean of those of its corners. At most 16 dimensions
// are kept.
inline Face_features searched_features(const Surface& searched, Vertex_features vertices)
{
  constexpr std::size_t largest_dimension = 16;
  const double divisor = standardize(vertices);
  if (!(divisor > 0))
    return {};
  if (vertices.means.number_of_columns > largest_dimension)
    vertices.means =
      product(vertices.means, principal_subspace(vertices.means, largest_dimension));
  const std::size_t d = vertices.means.number_of_columns;
  Row_matrix faces(searched.number_of_faces(), d);
  std::vector<double> mean(d, 0);
  double area = 0;
  for (std::size_t f = 0; f < searched.number_of_faces(); ++f) {
    area += searched.areas[f];
    for (std::size_t i = 0; i < d; ++i) {
      for (Index v : searched.corners[f])
        faces[f][i] += vertices.means[v][i] / 3;
      mean[i] += searched.areas[f] * faces[f][i];
    }
  }
  double variance = 0;
  for (std::size_t f = 0; f < searched.number_of_faces(); ++f)
    for (std::size_t i = 0; i < d; ++i) {
      faces[f][i] -= area > 0 ? mean[i] / area : 0;
      variance += searched.areas[f] * faces[f][i] * faces[f][i];
    }
  if (!(variance > 0))
    return {};
  const double deviation = std::sqrt(variance / area);
  Face_features result{d, {}, divisor * deviation};
  result.values.reserve(faces.values.size());
  for (double x : faces.values)
    result.values.push_back(static_cast<float>(x / deviation));
  return result;
}

// Returns the features of single faces of the caller; none if the vectors are long, because reading
// many of them takes the time of the search. Outliers are cut off.
inline Face_features features_of_faces(const Feature_source& source, double unit,
                                       const std::vector<Index>& callers_face)
{
  constexpr std::size_t largest_dimension = 64;
  constexpr double largest = 1e6;
  if (source.dimension > largest_dimension || callers_face.empty())
    return {};
  Face_features result{source.dimension, {}, unit};
  std::vector<double> first(source.dimension), features(source.dimension);
  source.read(callers_face.front(), first.data());
  for (Index f : callers_face) {
    source.read(f, features.data());
    for (std::size_t i = 0; i < features.size(); ++i)
      result.values.push_back(static_cast<float>(
        (std::min)((std::max)((features[i] - first[i]) / unit, -largest), largest)));
  }
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_FEATURES_SEARCHED_FEATURES_H
