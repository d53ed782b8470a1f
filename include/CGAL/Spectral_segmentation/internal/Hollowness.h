// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HOLLOWNESS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HOLLOWNESS_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// How far sets of faces of a part are from convex: the mean depth, by area, of their faces below
// their own convex hull, each along its normal. The hull is that of the extreme points in some
// directions; which point supports it along a normal is found among those of the directions next to
// the normal.
class Hollowness
{
  typedef Eigen::Matrix<float, Eigen::Dynamic, 3> Directions;
  static constexpr int number_of_directions = 96;
  static constexpr int number_of_neighbors = 10;
  typedef std::array<int, number_of_neighbors> Neighbors; // the direction itself is the first

  const Face_dual_graph& part_;
  std::vector<Eigen::Vector3f> normal_;
  std::vector<int> direction_; // next to the normal of each face

  // Evenly spread over the sphere: a Fibonacci lattice, which descends in z.
  static const Directions& directions()
  {
    static const Directions result = [] {
      constexpr int n = number_of_directions;
      const double golden_angle = CGAL_PI * (3 - std::sqrt(5.));
      Directions d(n, 3);
      for (int i = 0; i < n; ++i) {
        const double z = 1 - (2 * i + 1.) / n, r = std::sqrt(1 - z * z);
        d.row(i) = Eigen::RowVector3d(r * std::cos(i * golden_angle),
                                      r * std::sin(i * golden_angle), z).cast<float>();
      }
      return d;
    }();
    return result;
  }

  static const std::vector<Neighbors>& neighbors()
  {
    static const std::vector<Neighbors> result = [] {
      std::vector<Neighbors> n(number_of_directions);
      const Eigen::MatrixXf cosines = directions() * directions().transpose();
      std::vector<int> all(number_of_directions);
      for (int i = 0; i < number_of_directions; ++i) {
        std::iota(all.begin(), all.end(), 0);
        std::partial_sort_copy(all.begin(), all.end(), n[i].begin(), n[i].end(),
                               [&](int a, int b) { return cosines(i, a) > cosines(i, b); });
      }
      return n;
    }();
    return result;
  }

  // The next direction is at most 11 places from the place of the normal's own z; as observed.
  static int next_direction(const Eigen::Vector3f& normal)
  {
    const int middle = static_cast<int>((1 - normal.z()) * number_of_directions / 2);
    const int reach = number_of_directions / 8;
    const int first = (std::max)(middle - reach, 0);
    const int end = (std::min)(middle + reach + 1, number_of_directions);
    int best;
    (directions().middleRows(first, end - first) * normal).maxCoeff(&best);
    return first + best;
  }

  Eigen::Matrix3Xf points(const std::vector<Index>& faces) const
  {
    std::vector<char> is_met(part_.points.size(), 0);
    Eigen::Matrix3Xf result(3, part_.points.size());
    Eigen::Index number = 0;
    for (Index f : faces)
      for (Index v : part_.corners[f])
        if (!is_met[v]) {
          is_met[v] = 1;
          result.col(number++) = part_.points[v].cast<float>();
        }
    result.conservativeResize(3, number);
    return result;
  }

  // The extreme point in each direction, found in blocks that stay in the cache.
  static Eigen::Matrix3Xf extreme_points(const Eigen::Matrix3Xf& points)
  {
    const auto block = [&](Eigen::Index first)
    { return points.middleCols(first, (std::min)(Eigen::Index(256), points.cols() - first)); };
    Eigen::VectorXf support = Eigen::VectorXf::Constant(
      number_of_directions, -std::numeric_limits<float>::infinity());
    std::vector<Eigen::Index> best_block(number_of_directions, 0);
    for (Eigen::Index first = 0; first < points.cols(); first += 256) {
      const Eigen::VectorXf s = (directions() * block(first)).rowwise().maxCoeff();
      for (int d = 0; d < number_of_directions; ++d)
        if (s[d] > support[d]) {
          support[d] = s[d];
          best_block[d] = first;
        }
    }
    Eigen::Matrix3Xf result(3, number_of_directions);
    for (int d = 0; d < number_of_directions; ++d) {
      Eigen::Index best;
      (directions().row(d) * block(best_block[d])).maxCoeff(&best);
      result.col(d) = points.col(best_block[d] + best);
    }
    return result;
  }

public:
  explicit Hollowness(const Face_dual_graph& part)
    : part_(part), direction_(part.number_of_faces())
  {
    for (Index f = 0; f < direction_.size(); ++f) {
      const std::array<Index, 3>& c = part.corners[f];
      normal_.push_back((part.points[c[1]] - part.points[c[0]])
                          .cross(part.points[c[2]] - part.points[c[0]]).normalized().cast<float>());
      direction_[f] = next_direction(normal_[f]);
    }
  }

  // 0 for faces without area.
  double operator()(const std::vector<Index>& faces) const
  {
    if (faces.empty())
      return 0;
    const Eigen::Matrix3Xf extreme = extreme_points(points(faces));
    double sum = 0, area = 0;
    for (Index f : faces) {
      const Eigen::Vector3f center = part_.centroid(f).cast<float>();
      float depth = 0;
      for (int d : neighbors()[direction_[f]])
        depth = (std::max)(depth, normal_[f].dot(extreme.col(d) - center));
      sum += part_.areas[f] * depth;
      area += part_.areas[f];
    }
    return area > 0 ? sum / area : 0;
  }
};

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HOLLOWNESS_H
