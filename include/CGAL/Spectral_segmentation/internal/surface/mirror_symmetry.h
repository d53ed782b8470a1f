// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MIRROR_SYMMETRY_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MIRROR_SYMMETRY_H

#include <CGAL/Spectral_segmentation/internal/surface/Face_tree.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The reflection in a plane.
struct Reflection
{
  Vector normal; // of length 1
  double offset; // of the plane, along its normal

  Vector direction(const Vector& v) const { return v - 2 * normal.dot(v) * normal; }
  Vector operator()(const Vector& p) const { return p - 2 * (normal.dot(p) - offset) * normal; }
};

// Searches a plane in which a surface is, but for details, its own mirror image. The surface is in
// its frame, so that such a plane is nearly normal to an axis, and nearly through the center.
class Mirror_symmetry
{
  static constexpr double least_fraction = 0.85;   // of the faces that have mirror images
  static constexpr double largest_distance = 0.02; // of these images, for the area 1
  static constexpr double search_distance = 0.08;  // of images by which a plane is refined
  static constexpr double image_distance = 0.04;   // of the images that are returned
  static constexpr std::size_t few_faces = 60, many_faces = 300;

  const Surface& surface_;
  const std::vector<Triangle> triangles_;
  const Face_tree tree_;

  struct Image
  {
    Index face; // the nearest
    double squared_distance;

    bool is_within(double distance) const { return squared_distance <= distance * distance; }
  };

  Image image(const Reflection& reflection, Index f) const
  {
    const Vector p = reflection(surface_.centroid(f));
    const Vector normal = reflection.direction(surface_.normal(f));
    const Index g = tree_.nearest(p, normal, largest_distance * largest_distance);
    return {g, squared_distance_to_triangle(p, triangles_[g])};
  }

  // Calls f(face, image) for about `number` faces that are spread evenly over the faces.
  template <class Function>
  void for_each_sample(const Reflection& reflection, std::size_t number, const Function& f) const
  {
    const std::size_t step = surface_.number_of_faces() / number + 1;
    for (std::size_t i = step / 2; i < surface_.number_of_faces(); i += step)
      f(static_cast<Index>(i), image(reflection, static_cast<Index>(i)));
  }

  // Returns the fraction of some faces that have mirror images.
  double fraction(const Reflection& reflection, std::size_t number) const
  {
    double all = 0, found = 0;
    for_each_sample(reflection, number, [&](Index, const Image& i) {
      ++all;
      found += i.is_within(largest_distance);
    });
    return all > 0 ? found / all : 0;
  }

  // Returns the reflection in the plane in the middle between faces and their images.
  Reflection refined(const Reflection& reflection) const
  {
    Vector sum;
    std::vector<Vector> middles;
    for_each_sample(reflection, few_faces, [&](Index f, const Image& i) {
      if (!i.is_within(search_distance))
        return;
      const Vector p = surface_.centroid(f), q = surface_.centroid(i.face), v = q - p;
      sum += v.dot(reflection.normal) < 0 ? -v : v;
      middles.push_back((p + q) / 2);
    });
    if (!(sum.norm() > 0))
      return reflection;
    Reflection result{sum.normalized(), 0};
    for (const Vector& middle : middles)
      result.offset += result.normal.dot(middle) / static_cast<double>(middles.size());
    return result;
  }

public:
  explicit Mirror_symmetry(const Surface& surface)
    : surface_(surface), triangles_(triangles_of(surface)), tree_(triangles_) {}

  // Returns the reflection that maps the most faces near others, if these are enough. Ties go to
  // the axis of larger variance: each face of a plate is near its image on the other side.
  std::optional<Reflection> operator()() const
  {
    std::optional<Reflection> result;
    double best = least_fraction;
    for (int axis = 0; axis < 3; ++axis) {
      Reflection reflection{Vector(axis == 0, axis == 1, axis == 2), 0};
      for (int step = 0; step < 3 && fraction(reflection, few_faces) >= least_fraction / 2; ++step)
        reflection = refined(reflection);
      if (fraction(reflection, few_faces) < 0.9 * least_fraction)
        continue; // many faces are hardly enough, either
      if (const double found = fraction(reflection, many_faces); found >= best) {
        best = found;
        result = reflection;
      }
    }
    return result;
  }

  // Returns the face to which a reflection maps each face, or null_index if there is none near.
  std::vector<Index> images(Execution execution, const Reflection& reflection) const
  {
    std::vector<Index> result(surface_.number_of_faces());
    for_each_index(execution, result.size(), [&](std::size_t f) {
      const Image i = image(reflection, static_cast<Index>(f));
      result[f] = i.is_within(image_distance) ? i.face : null_index;
    });
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_MIRROR_SYMMETRY_H
