// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MOMENTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MOMENTS_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Spectral_segmentation::internal {

// Returns the mean of a function on the surface, sampled at the centroids of the faces. `area` is
// the area of the graph, and not 0.
template <class Value, class Function>
Value mean_over_surface(Execution execution, const Surface& graph, double area,
                        const Function& function)
{
  return sum_of(execution, graph.number_of_faces(), Value(), [&](std::size_t f)
    { return Value(graph.areas[f] / area * function(graph.centroid(static_cast<Index>(f)))); });
}

inline Vector center_of(Execution execution, const Surface& graph, double area)
{ return mean_over_surface<Vector>(execution, graph, area, [](const Vector& p) { return p; }); }

// The integrals of 1, p and p p^T over the points p of a set of faces. They are additive.
struct Moments
{
  double area = 0;
  Vector first;
  Symmetric_matrix second;

  void add(const Surface& surface, Index f)
  {
    Vector sum;
    Symmetric_matrix squares;
    for (Index v : surface.corners[f]) {
      sum += surface.points[v];
      squares += Symmetric_matrix::square(surface.points[v]);
    }
    area += surface.areas[f];
    first += surface.areas[f] / 3 * sum;
    second += surface.areas[f] / 12 * (squares + Symmetric_matrix::square(sum));
  }

  Moments& operator+=(const Moments& other)
  {
    area += other.area;
    first += other.first;
    second += other.second;
    return *this;
  }

  Vector centroid() const { return first / area; }

  // Returns the variances of the points along the principal axes.
  Eigen_decomposition variances() const
  { return Eigen_decomposition(second / area - Symmetric_matrix::square(centroid())); }

  // Returns the standard deviations of the points along the principal axes, in ascending order.
  std::array<double, 3> deviations() const
  {
    const Eigen_decomposition variances = this->variances();
    std::array<double, 3> result;
    for (int i = 0; i < 3; ++i)
      result[static_cast<std::size_t>(i)] = std::sqrt((std::max)(variances.eigenvalue(i), 0.));
    return result;
  }
};

// A coordinate frame that moves with a surface whose area is not 0: its center and its principal
// axes, the least variance first. If two variances are nearly equal, the principal axes are
// unstable under noise, and the frame takes the axes of the input. Each axis points to the side on
// which the points are spread farther. Therefore the frame of a mirrored surface is mirrored. If
// both sides are nearly alike, noise would decide, and the axis points along one of the input.
class Principal_frame
{
  static constexpr double nearly_equal = 0.95; // the ratio of two variances
  static constexpr double least_skewness = 1e-3;

  Vector center_;
  Vector axes_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

  void set_axes(const Symmetric_matrix& covariance)
  {
    const Eigen_decomposition solver(covariance);
    if (solver.eigenvalue(0) < nearly_equal * solver.eigenvalue(1) &&
        solver.eigenvalue(1) < nearly_equal * solver.eigenvalue(2)) {
      solver.set_eigenvectors(axes_[0], axes_[1]);
      axes_[2] = axes_[0].cross(axes_[1]);
      return;
    }
    // The order of the variances does not depend on rounding, nor on the names of the axes.
    const double step = quantum * covariance.trace();
    std::stable_sort(axes_, axes_ + 3, [&](const Vector& a, const Vector& b) {
      return std::floor((covariance * a).dot(a) / step) <
             std::floor((covariance * b).dot(b) / step);
    });
  }

  void set_directions(const Symmetric_matrix& covariance, const Vector& third_moments)
  {
    for (int i = 0; i < 3; ++i) {
      Vector& axis = axes_[i];
      const double variance = (covariance * axis).dot(axis);
      const double skewness = third_moments[i] / (variance * std::sqrt(variance)); // maybe NaN
      const double largest = (std::max)({std::abs(axis.x()), std::abs(axis.y()),
                                         std::abs(axis.z())});
      const bool is_reversed = std::abs(skewness) >= least_skewness
        ? skewness < 0 : largest > axis.largest_coordinate();
      if (is_reversed)
        axis = -axis;
    }
  }

public:
  Principal_frame(Execution execution, const Surface& surface)
  {
    const double area = total_area(surface);
    center_ = center_of(execution, surface, area);
    const Symmetric_matrix covariance =
      mean_over_surface<Symmetric_matrix>(execution, surface, area, [&](const Vector& p)
        { return Symmetric_matrix::square(p - center_); });
    set_axes(covariance);
    set_directions(covariance,
      mean_over_surface<Vector>(execution, surface, area, [&](const Vector& p) {
        const Vector q = point(p);
        return Vector(q.x() * q.x() * q.x(), q.y() * q.y() * q.y(), q.z() * q.z() * q.z());
      }));
  }

  bool is_left_handed() const { return axes_[0].cross(axes_[1]).dot(axes_[2]) < 0; }

  Vector point(const Vector& p) const
  {
    const Vector v = p - center_;
    return {axes_[0].dot(v), axes_[1].dot(v), axes_[2].dot(v)};
  }
};

// Moves a surface into its frame, scales it to area 1, and rounds its points to quanta. Therefore
// later results depend neither on the position, the unit and the handedness of the surface, nor on
// the last bits of its points. Returns the length of 1 in the old unit. A surface without area
// stays unchanged.
inline double move_to_frame(Execution execution, Surface& surface)
{
  const double area = total_area(surface), unit = std::sqrt(area);
  if (!(area > 0))
    return 1;
  const Principal_frame frame(execution, surface);
  for_each_index(execution, surface.points.size(), [&](std::size_t v)
    { surface.points[v] = quantized(frame.point(surface.points[v]) / unit); });
  for (double& face_area : surface.areas)
    face_area /= area;
  if (frame.is_left_handed())
    reverse_orientation(surface);
  return unit;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MOMENTS_H
