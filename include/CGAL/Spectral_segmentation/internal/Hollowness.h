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
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// How far sets of faces of a part are from convex: the mean depth, by area, of their faces below
// their own convex hull. The hull is known by its support function in some directions; the depth of
// a face is measured along the one next to its normal.
class Hollowness
{
  typedef Eigen::Matrix<float, Eigen::Dynamic, 3> Directions;

  const Face_dual_graph& part_;
  std::vector<Eigen::Index> direction_; // of each face
  std::vector<std::size_t> last_set_;   // of each vertex: the set that was last to meet it
  std::size_t number_of_sets_ = 0;
  Eigen::Matrix3Xf points_;             // of the set at hand

  // Evenly spread over the sphere: a Fibonacci lattice.
  static const Directions& directions()
  {
    static const Directions result = [] {
      constexpr int n = 162;
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

  // In blocks that stay in the cache.
  Eigen::VectorXf support(Eigen::Index number_of_points) const
  {
    constexpr Eigen::Index block = 256;
    Eigen::VectorXf result = Eigen::VectorXf::Constant(
      directions().rows(), -std::numeric_limits<float>::infinity());
    for (Eigen::Index i = 0; i < number_of_points; i += block)
      result = result.cwiseMax(
        (directions() * points_.middleCols(i, (std::min)(block, number_of_points - i)))
          .rowwise().maxCoeff());
    return result;
  }

public:
  explicit Hollowness(const Face_dual_graph& part)
    : part_(part), direction_(part.number_of_faces(), 0), last_set_(part.points.size(), 0),
      points_(3, part.points.size())
  {
    for (Index f = 0; f < direction_.size(); ++f) {
      const std::array<Index, 3>& c = part.corners[f];
      const Vector normal = (part.points[c[1]] - part.points[c[0]])
                              .cross(part.points[c[2]] - part.points[c[0]]).normalized();
      (directions() * normal.cast<float>()).maxCoeff(&direction_[f]);
    }
  }

  // 0 for faces without area.
  double operator()(const std::vector<Index>& faces)
  {
    ++number_of_sets_;
    Eigen::Index number_of_points = 0;
    for (Index f : faces)
      for (Index v : part_.corners[f])
        if (last_set_[v] != number_of_sets_) {
          last_set_[v] = number_of_sets_;
          points_.col(number_of_points++) = part_.points[v].cast<float>();
        }
    const Eigen::VectorXf h = support(number_of_points);
    double sum = 0, area = 0;
    for (Index f : faces) {
      const Vector direction = directions().row(direction_[f]).transpose().cast<double>();
      sum += part_.areas[f] * (h[direction_[f]] - direction.dot(part_.centroid(f)));
      area += part_.areas[f];
    }
    return area > 0 ? sum / area : 0;
  }
};

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HOLLOWNESS_H
