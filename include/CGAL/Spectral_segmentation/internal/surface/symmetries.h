// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SYMMETRIES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SYMMETRIES_H

#include <CGAL/Spectral_segmentation/internal/surface/Face_tree.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The reflection in a plane, or the rotation about a line. The axis is the unit normal of the plane
// or the direction of the line.
class Rigid_motion
{
  Vector axis_;
  double scale_, turn_, along_; // the factors of v, of axis x v, and of (axis . v) axis
  Vector shift_;

  Rigid_motion(const Vector& axis, double scale, double turn, double along)
    : axis_(axis), scale_(scale), turn_(turn), along_(along) {}

public:
  // Returns the reflection in the plane at a distance from the origin.
  static Rigid_motion reflection(const Vector& normal, double distance)
  {
    Rigid_motion result(normal, 1, 0, -2);
    result.shift_ = 2 * distance * normal;
    return result;
  }

  // Returns the rotation about a line through a point, by a fraction of a full turn.
  static Rigid_motion rotation(const Vector& axis, const Vector& point, double fraction)
  {
    const double angle = 2 * CGAL_PI * fraction, c = std::cos(angle);
    Rigid_motion result(axis, c, std::sin(angle), 1 - c);
    result.shift_ = point - result.direction(point);
    return result;
  }

  const Vector& axis() const { return axis_; }
  Vector direction(const Vector& v) const
  { return scale_ * v + turn_ * axis_.cross(v) + along_ * axis_.dot(v) * axis_; }
  Vector operator()(const Vector& p) const { return direction(p) + shift_; }
};

// Searches reflections and rotations that map a surface, but for details, to itself. The surface is
// in its frame, so that planes of reflection are nearly normal to its axes, and nearly through the
// center.
class Symmetry_search
{
  static constexpr double least_fraction = 0.85;   // of the faces that have images
  static constexpr double largest_distance = 0.02; // of these images, for the area 1
  static constexpr double search_distance = 0.08;  // of images by which a plane is refined
  static constexpr double image_distance = 0.04;   // of the images that are returned
  static constexpr std::size_t few_faces = 60, many_faces = 300;
  static constexpr int largest_order = 24;         // of a rotation

  const Surface& surface_;
  const std::vector<Triangle> triangles_;
  const Face_tree tree_;

  struct Image
  {
    Index face; // the nearest
    double squared_distance;

    bool is_within(double distance) const { return squared_distance <= distance * distance; }
  };

  Image image(const Rigid_motion& motion, Index f) const
  {
    const Vector p = motion(surface_.centroid(f));
    const Vector normal = motion.direction(surface_.normal(f));
    const Index g = tree_.nearest(p, normal, largest_distance * largest_distance);
    return {g, squared_distance_to_triangle(p, triangles_[g])};
  }

  // Calls f(face, image) for about `number` faces that are spread evenly over the faces.
  template <class Function>
  void for_each_sample(const Rigid_motion& motion, std::size_t number, const Function& f) const
  {
    const std::size_t step = surface_.number_of_faces() / number + 1;
    for (std::size_t i = step / 2; i < surface_.number_of_faces(); i += step)
      f(static_cast<Index>(i), image(motion, static_cast<Index>(i)));
  }

  // Returns the fraction of some faces that have images.
  double fraction(const Rigid_motion& motion, std::size_t number) const
  {
    double all = 0, found = 0;
    for_each_sample(motion, number, [&](Index, const Image& i) {
      ++all;
      found += i.is_within(largest_distance);
    });
    return all > 0 ? found / all : 0;
  }

  // Returns the reflection in the plane in the middle between faces and their images.
  Rigid_motion refined(const Rigid_motion& reflection) const
  {
    Vector sum;
    std::vector<Vector> middles;
    for_each_sample(reflection, few_faces, [&](Index f, const Image& i) {
      if (!i.is_within(search_distance))
        return;
      const Vector p = surface_.centroid(f), q = surface_.centroid(i.face), v = q - p;
      sum += v.dot(reflection.axis()) < 0 ? -v : v;
      middles.push_back((p + q) / 2);
    });
    if (!(sum.norm() > 0))
      return reflection;
    const Vector normal = sum.normalized();
    double distance = 0;
    for (const Vector& middle : middles)
      distance += normal.dot(middle) / static_cast<double>(middles.size());
    return Rigid_motion::reflection(normal, distance);
  }

  // Returns the mean distance of images, each clamped to the largest one of an image.
  double mean_distance(const Rigid_motion& motion) const
  {
    double sum = 0, number = 0;
    for_each_sample(motion, many_faces, [&](Index, const Image& i) {
      sum += (std::min)(std::sqrt(i.squared_distance), image_distance);
      ++number;
    });
    return sum / number;
  }

  // Returns the principal axis around which the two variances are nearly equal, if there is one.
  static std::optional<Vector> axis_of_rotation(const Moments& moments)
  {
    constexpr double largest_difference = 0.15; // of the two variances, relative to the larger
    if (!(moments.area > 0))
      return {};
    const Eigen_decomposition variances = moments.variances();
    const double a = variances.eigenvalue(0), b = variances.eigenvalue(1),
                 c = variances.eigenvalue(2);
    const bool is_least = c - b < b - a; // the variance along the axis
    if (is_least ? b < (1 - largest_difference) * c : a < (1 - largest_difference) * b)
      return {};
    Vector least, middle;
    variances.set_eigenvectors(least, middle);
    return is_least ? least : least.cross(middle);
  }

  // Returns the rotations by multiples of 1/n turn for the largest n that maps faces near others,
  // if there is one of at least 3. A surface of revolution has no such rotations: half the angle
  // maps faces as near.
  std::vector<Rigid_motion> rotations() const
  {
    constexpr double largest_ratio = 0.35;   // of the mean distances for both angles
    constexpr double least_distance = 0.002; // for half the angle
    constexpr double noise = 0.0005; // of mean distances; they may double for a multiple of n
    Moments moments;
    for (Index f = 0; f < surface_.number_of_faces(); ++f)
      moments.add(surface_, f);
    std::vector<Rigid_motion> result;
    const std::optional<Vector> axis = axis_of_rotation(moments);
    if (!axis)
      return result;
    const auto rotation = [&, center = moments.centroid()](double fraction)
    { return Rigid_motion::rotation(*axis, center, fraction); };
    double distances[largest_order + 1]; // by n
    int best = 3;
    for (int n = 3; n <= largest_order; ++n) {
      distances[n] = mean_distance(rotation(1. / n));
      best = distances[n] < distances[best] ? n : best;
    }
    int order = best;
    for (int n = best; n <= largest_order; n += best)
      if (distances[n] <= 2 * (std::max)(distances[best], noise))
        order = n;
    const double distance = mean_distance(rotation(0.5 / order));
    if (distance >= least_distance && distances[order] <= largest_ratio * distance &&
        fraction(rotation(1. / order), many_faces) >= least_fraction)
      for (int i = 1; i < order; ++i)
        result.push_back(rotation(static_cast<double>(i) / order));
    return result;
  }

public:
  explicit Symmetry_search(const Surface& surface)
    : surface_(surface), triangles_(triangles_of(surface)), tree_(triangles_) {}

  // Returns the reflection that maps the most faces near others, if these are enough. Ties go to
  // the axis of larger variance: each face of a plate is near its image on the other side.
  std::optional<Rigid_motion> reflection() const
  {
    std::optional<Rigid_motion> result;
    double best = least_fraction;
    for (int axis = 0; axis < 3; ++axis) {
      Rigid_motion motion =
        Rigid_motion::reflection(Vector(axis == 0, axis == 1, axis == 2), 0);
      for (int step = 0; step < 3 && fraction(motion, few_faces) >= least_fraction / 2; ++step)
        motion = refined(motion);
      if (fraction(motion, few_faces) < 0.9 * least_fraction)
        continue; // many faces are hardly enough, either
      if (const double found = fraction(motion, many_faces); found >= best) {
        best = found;
        result = motion;
      }
    }
    return result;
  }

  // Returns motions that map the surface to itself, and with each its inverse: rotations about one
  // axis, or else a reflection, if there are any.
  std::vector<Rigid_motion> symmetries() const
  {
    std::vector<Rigid_motion> result = rotations();
    if (result.empty())
      if (const std::optional<Rigid_motion> motion = reflection())
        result.push_back(*motion);
    return result;
  }

  // Returns the face to which a motion maps each face, or null_index if there is none near.
  std::vector<Index> images(Execution execution, const Rigid_motion& motion) const
  {
    std::vector<Index> result(surface_.number_of_faces());
    for_each_index(execution, result.size(), [&](std::size_t f) {
      const Image i = image(motion, static_cast<Index>(f));
      result[f] = i.is_within(image_distance) ? i.face : null_index;
    });
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SYMMETRIES_H
