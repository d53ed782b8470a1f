// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_CONGRUENT_PARTS_H
#define SEGMENTATION_BENCHMARK_CONGRUENT_PARTS_H

#include "segmentation_metrics.h"

#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

// Whether a segmentation treats parts of one shape alike: the four legs of a horse, say, that a
// person has cut off.
namespace segmentation_benchmark {

// Integrals over a piece of surface: of 1, x and x x^T.
struct Moments
{
  double area = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  Moments& operator+=(const Moments& other)
  {
    area += other.area;
    first += other.first;
    second += other.second;
    return *this;
  }
};

// Returns the moments of each face of a CGAL::Surface_mesh without removed elements.
template <class SurfaceMesh>
std::vector<Moments> face_moments(const SurfaceMesh& mesh, const std::vector<double>& face_areas)
{
  std::vector<Moments> result;
  for (const auto f : mesh.faces()) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d sum_of_squares = Eigen::Matrix3d::Zero();
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
      const Eigen::Vector3d p(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
      sum += p;
      sum_of_squares += p * p.transpose();
    }
    const double area = face_areas[f];
    result.push_back({area, area / 3 * sum, area / 12 * (sum_of_squares + sum * sum.transpose())});
  }
  return result;
}

// The properties of a part that do not depend on its place.
struct Part_shape
{
  double area;
  Eigen::Vector3d deviations; // standard ones along the principal axes, the smallest first
};

inline Part_shape part_shape(const Moments& moments)
{
  if (!(moments.area > 0))
    return {0, Eigen::Vector3d::Zero()};
  const Eigen::Vector3d center = moments.first / moments.area;
  const Eigen::Matrix3d covariance = moments.second / moments.area - center * center.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return {moments.area, solver.eigenvalues().cwiseMax(0).cwiseSqrt()};
}

inline std::vector<Part_shape> part_shapes(const std::vector<Moments>& face_moments,
                                           const Labels& labels)
{
  std::vector<Moments> moments(number_of_segments(labels));
  for (std::size_t f = 0; f < labels.size(); ++f)
    moments[labels[f]] += face_moments[f];
  std::vector<Part_shape> result;
  for (const Moments& m : moments)
    result.push_back(part_shape(m));
  return result;
}

inline bool are_congruent(const Part_shape& a, const Part_shape& b)
{
  const auto are_near = [](double x, double y)
  { return std::abs(x - y) <= 0.1 * (std::max)(x, y); };
  return are_near(a.area, b.area) && are_near(a.deviations[0], b.deviations[0]) &&
         are_near(a.deviations[1], b.deviations[1]) && are_near(a.deviations[2], b.deviations[2]);
}

// The labels of parts that are all congruent with each other, two at least.
typedef std::vector<std::size_t> Congruent_parts;

// Large parts come first.
inline std::vector<Congruent_parts> congruent_parts(const std::vector<Part_shape>& parts)
{
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b)
                   { return parts[a].area > parts[b].area; });
  std::vector<Congruent_parts> classes = CGAL::Spectral_segmentation::internal::first_fit_classes(
    order, [&](std::size_t a, std::size_t b) { return are_congruent(parts[a], parts[b]); });
  classes.erase(std::remove_if(classes.begin(), classes.end(), [](const Congruent_parts& parts)
                               { return parts.size() < 2; }), classes.end());
  return classes;
}

// Returns for each part, a row of the areas in common, the overlap with the segment that is most
// like it: the area of the intersection over the area of the union.
inline std::vector<double> best_overlaps(const Eigen::ArrayXXd& area)
{
  const Eigen::ArrayXd of_parts = area.rowwise().sum();
  const Eigen::ArrayXd of_segments = area.colwise().sum();
  std::vector<double> result;
  for (Eigen::Index p = 0; p < area.rows(); ++p) {
    double best = 0;
    for (Eigen::Index s = 0; s < area.cols(); ++s)
      if (area(p, s) > 0)
        best = (std::max)(best, area(p, s) / (of_parts[p] + of_segments[s] - area(p, s)));
    result.push_back(best);
  }
  return result;
}

// Congruent parts are treated alike if their best overlaps differ by at most this: a leg that is
// cut off at the hip and one at the knee are not, four legs that are left on the body are.
constexpr double overlap_of_alike = 0.25;

// The share of the classes, of the parts in the rows, that the segments in the columns treat alike;
// undefined if there is no class.
inline double share_treated_alike(const std::vector<Congruent_parts>& classes,
                                  const Eigen::ArrayXXd& area)
{
  const std::vector<double> overlaps = best_overlaps(area);
  Mean share;
  for (const Congruent_parts& parts : classes) {
    const auto [least, largest] =
      std::minmax_element(parts.begin(), parts.end(), [&](std::size_t a, std::size_t b)
                          { return overlaps[a] < overlaps[b]; });
    share.add(overlaps[*largest] - overlaps[*least] <= overlap_of_alike);
  }
  return share();
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_CONGRUENT_PARTS_H
