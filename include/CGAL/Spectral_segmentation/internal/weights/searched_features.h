// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_SEARCHED_FEATURES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_SEARCHED_FEATURES_H

#include <CGAL/Spectral_segmentation/internal/base/Face_features.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_data.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A matrix in row-major order. Its products are plain loops, because sums of Eigen depend on its
// version and on the processor, and labels must not.
struct Row_matrix
{
  std::size_t number_of_columns = 0;
  std::vector<double> values;

  Row_matrix(std::size_t rows, std::size_t columns)
    : number_of_columns(columns), values(rows * columns, 0) {}

  std::size_t number_of_rows() const
  { return number_of_columns == 0 ? 0 : values.size() / number_of_columns; }
  double* operator[](std::size_t row) { return &values[row * number_of_columns]; }
  const double* operator[](std::size_t row) const { return &values[row * number_of_columns]; }
};

// Returns a * b.
inline Row_matrix product(const Row_matrix& a, const Row_matrix& b)
{
  Row_matrix result(a.number_of_rows(), b.number_of_columns);
  for (std::size_t i = 0; i < a.number_of_rows(); ++i)
    for (std::size_t k = 0; k < a.number_of_columns; ++k)
      for (std::size_t j = 0; j < b.number_of_columns; ++j)
        result[i][j] += a[i][k] * b[k][j];
  return result;
}

// Returns transposed(a) * diagonal(weights) * b.
inline Row_matrix weighted_transposed_product(const Row_matrix& a,
                                              const std::vector<double>& weights,
                                              const Row_matrix& b)
{
  Row_matrix result(a.number_of_columns, b.number_of_columns);
  for (std::size_t i = 0; i < a.number_of_rows(); ++i)
    for (std::size_t k = 0; k < a.number_of_columns; ++k) {
      const double factor = weights[i] * a[i][k];
      for (std::size_t j = 0; j < b.number_of_columns; ++j)
        result[k][j] += factor * b[i][j];
    }
  return result;
}

// Orthonormalizes the columns in order. Columns that depend on earlier ones become 0.
inline void orthonormalize(Row_matrix& m)
{
  const std::size_t rows = m.number_of_rows();
  const auto dot = [&](std::size_t a, std::size_t b) {
    double sum = 0;
    for (std::size_t i = 0; i < rows; ++i)
      sum += m[i][a] * m[i][b];
    return sum;
  };
  for (std::size_t j = 0; j < m.number_of_columns; ++j) {
    const double norm_before = std::sqrt(dot(j, j));
    for (int pass = 0; pass < 2; ++pass) // the second removes what rounding left
      for (std::size_t k = 0; k < j; ++k) {
        const double c = dot(j, k);
        for (std::size_t i = 0; i < rows; ++i)
          m[i][j] -= c * m[i][k];
      }
    const double norm = std::sqrt(dot(j, j));
    const double factor = norm > 1e-10 * norm_before ? 1 / norm : 0;
    for (std::size_t i = 0; i < rows; ++i)
      m[i][j] *= factor;
  }
}

// Returns orthonormal columns that span the directions in which rows of mean 0 differ the most, by
// orthogonal iteration. The directions themselves are not separated. About 500 rows, evenly spaced,
// stand for all, which takes a fraction of the time of reading 200,000 faces.
inline Row_matrix principal_subspace(const Row_matrix& all_rows, std::size_t dimension)
{
  const std::size_t step = all_rows.number_of_rows() / 500 + 1;
  Row_matrix rows((all_rows.number_of_rows() + step - 1) / step, all_rows.number_of_columns);
  for (std::size_t i = 0; i < rows.number_of_rows(); ++i)
    std::copy_n(all_rows[i * step], rows.number_of_columns, rows[i]);

  Row_matrix result(rows.number_of_columns, dimension);
  std::uint32_t state = 1;
  for (double& value : result.values) {
    state = 1664525 * state + 1013904223; // Numerical Recipes
    value = (state >> 31) != 0 ? 1 : -1;
  }
  const std::vector<double> equal_weights(rows.number_of_rows(), 1);
  constexpr int number_of_iterations = 4;
  for (int i = 0; i < number_of_iterations; ++i) {
    orthonormalize(result);
    result = weighted_transposed_product(rows, equal_weights, product(rows, result));
  }
  orthonormalize(result);
  return result;
}

// The area-weighted mean features at the vertices of a surface, and the areas around them.
struct Vertex_features
{
  Row_matrix means;
  std::vector<double> areas;
};

// Adds factor * (a - b) to a sum. Compilers vectorize blocks of a fixed size with -O2.
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

// Computes area-weighted means of features over the faces around each vertex of another surface. If
// the mesh has many more faces than this surface, only large faces and every k-th face are read,
// about 16 at each vertex. Features are relative to the first face, so that a large common offset
// does not cost digits.
class Feature_means
{
  const Feature_source& source_;
  const Surface& mesh_;
  const std::vector<Index>& callers_face_; // the caller's face of each face
  const std::vector<Index>& vertex_;       // the vertex of the other surface, or null_index
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
      const double area = mesh_.areas[f] * static_cast<double>(end - i) / 3;
      result_.areas[v[i]] += area;
      add_difference(area, features_, first_, result_.means[v[i]]);
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
      if (!(std::abs(x) <= 1e150)) // the square must be finite
        throw_for_infinite(source_, callers_face_);
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t i = 0; i < source_.dimension; ++i)
        result_.means[v][i] /= result_.areas[v] > 0 ? result_.areas[v] : 1;
    return std::move(result_);
  }
};

// Subtracts the mean over all vertices, and divides so that the largest number is 1. Rounds, so
// that the order of summation makes no difference. Returns the divisor; 0 if all features are the
// same.
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

// Returns the features of the faces, the means over their corners. At most 16 dimensions are kept.
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
// many of them takes the time of the search. Outliers are clamped.
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

// Makes edges count as concave if features change more across them than across most edges. A nearly
// uniform change, such as from a smooth field or noise, has no effect. A change is `factor` times
// the distance of the features of adjacent faces.
inline void add_feature_steps(const Face_features& features, double factor, double weight,
                              Surface& graph)
{
  if (features.empty())
    return;
  std::vector<float> steps(graph.number_of_halfedges(), 0);
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (!graph.is_border(h))
      steps[h] =
        static_cast<float>(factor * std::sqrt(features.squared_distance(h / 3, graph.neighbor(h))));
  std::vector<float> sorted = steps;
  const auto quartile = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 3 / 4);
  std::nth_element(sorted.begin(), quartile, sorted.end());
  const double usual_step = 1.5 * *quartile;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
    const double step = (std::min)((std::max)(steps[h] - usual_step, 0.), 1.);
    float& concavity = graph.weights[h].concavity;
    concavity = static_cast<float>(
      quantized(1 - (1 - 0.75 * weight_of_features(weight) * step) * (1 - concavity)));
  }
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_SEARCHED_FEATURES_H
