// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_MADE_FEATURES_H
#define SEGMENTATION_BENCHMARK_MADE_FEATURES_H

#include "princeton_benchmark.h"

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <Eigen/Core>

#include <cstddef>
#include <random>
#include <vector>

// Features of faces whose worth is known, made from the parts of a person.
namespace segmentation_benchmark {

// A row for each face
typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Feature_matrix;
typedef std::mt19937 Feature_random;

// Returns the faces that have an edge in common with each face.
inline std::vector<std::vector<std::size_t> > neighbors_of_faces(const Mesh& mesh)
{
  std::vector<std::vector<std::size_t> > result(mesh.number_of_faces());
  for (const auto e : mesh.edges())
    if (!mesh.is_border(e)) {
      const auto f = mesh.face(mesh.halfedge(e)), g = mesh.face(mesh.opposite(mesh.halfedge(e)));
      result[f].push_back(g);
      result[g].push_back(f);
    }
  return result;
}

// Returns normally distributed numbers of variance 1.
inline Feature_matrix normal_noise(std::size_t rows, std::size_t columns, Feature_random& random)
{
  std::normal_distribution<double> normal;
  return Feature_matrix::NullaryExpr(static_cast<Eigen::Index>(rows),
                                     static_cast<Eigen::Index>(columns),
                                     [&] { return normal(random); });
}

// Returns features after so many steps, each of which takes the mean with the neighbors.
inline Feature_matrix blurred(Feature_matrix features, const Mesh& mesh, int iterations)
{
  const auto neighbors = neighbors_of_faces(mesh);
  for (int i = 0; i < iterations; ++i) {
    Feature_matrix next = features;
    for (std::size_t f = 0; f < neighbors.size(); ++f) {
      for (std::size_t g : neighbors[f])
        next.row(f) += features.row(g);
      next.row(f) /= 1. + static_cast<double>(neighbors[f].size());
    }
    features = next;
  }
  return features;
}

// Returns a coordinate for each label, which is 1 at its faces.
inline Feature_matrix indicators(const Labels& labels)
{
  Feature_matrix result = Feature_matrix::Zero(labels.size(), number_of_segments(labels));
  for (std::size_t f = 0; f < labels.size(); ++f)
    result(f, labels[f]) = 1;
  return result;
}

// Returns the blurred parts of a person with noise on each face.
inline Feature_matrix noisy_parts(const Mesh& mesh, const Labels& person, double noise,
                                  Feature_random& random)
{
  const Feature_matrix parts = blurred(indicators(person), mesh, 10);
  return parts + noise * normal_noise(parts.rows(), parts.cols(), random);
}

// Returns sums of waves whose length is about the size of the mesh.
inline Feature_matrix smooth_features(const Mesh& mesh, std::size_t dimension,
                                      Feature_random& random)
{
  Eigen::MatrixXd centers(mesh.number_of_faces(), 3);
  for (const auto f : mesh.faces()) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      sum += Eigen::RowVector3d(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    centers.row(f) = sum / 3;
  }
  centers.rowwise() -= centers.colwise().mean().eval();
  centers /= centers.array().abs().maxCoeff();
  Feature_matrix result = Feature_matrix::Zero(centers.rows(), dimension);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, 6.283);
  for (std::size_t i = 0; i < dimension; ++i)
    for (int wave = 0; wave < 4; ++wave) {
      const Eigen::Vector3d k = 3 * Eigen::Vector3d(normal(random), normal(random), normal(random));
      const double shift = phase(random);
      result.col(i) += ((centers * k).array() + shift).cos().matrix();
    }
  return result;
}

// Returns labels of which a fraction is wrong, in patches of a hundredth of the area.
inline Labels noisy_labels(const Mesh& mesh, const Labels& person, double fraction,
                           Feature_random& random)
{
  const auto neighbors = neighbors_of_faces(mesh);
  const std::size_t n = person.size(), k = number_of_segments(person);
  std::vector<double> areas;
  double all = 0;
  for (const auto f : mesh.faces()) {
    areas.push_back(CGAL::Polygon_mesh_processing::face_area(f, mesh));
    all += areas.back();
  }
  Labels result = person;
  std::vector<char> is_wrong(n, 0);
  std::size_t number_of_wrong = 0;
  for (int tries = 0; tries < 10000 && number_of_wrong < fraction * n && k > 1; ++tries) {
    const std::size_t seed = random() % n;
    if (is_wrong[seed])
      continue;
    const std::size_t wrong = random() % k;
    std::vector<std::size_t> patch = {seed};
    std::vector<char> is_reached(n, 0);
    is_reached[seed] = 1;
    double area = 0;
    for (std::size_t i = 0; i < patch.size() && area < all / 100; ++i) {
      const std::size_t f = patch[i];
      area += areas[f];
      if (wrong != person[f] && !is_wrong[f]) {
        result[f] = wrong;
        is_wrong[f] = 1;
        ++number_of_wrong;
      }
      for (std::size_t g : neighbors[f])
        if (!is_reached[g]) {
          is_reached[g] = 1;
          patch.push_back(g);
        }
    }
  }
  return result;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_MADE_FEATURES_H
