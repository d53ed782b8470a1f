// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_SUPPORT_POINTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_SUPPORT_POINTS_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A vector in single precision, which is half the memory and exact enough for depths.
struct Vector_of_floats
{
  float x, y, z;

  Vector_of_floats(float x, float y, float z) : x(x), y(y), z(z) {}
  explicit Vector_of_floats(const Vector& v)
    : x(static_cast<float>(v.x())), y(static_cast<float>(v.y())), z(static_cast<float>(v.z())) {}

  Vector_of_floats operator-(const Vector_of_floats& v) const
  { return {x - v.x, y - v.y, z - v.z}; }
  float dot(const Vector_of_floats& v) const { return x * v.x + (y * v.y + z * v.z); }
};

// Directions that are spread over the sphere: a Fibonacci lattice, which descends in z.
namespace directions {

constexpr int number = 96;
constexpr int number_of_neighbors = 10;
typedef std::array<int, number_of_neighbors> Neighbors; // the direction itself is the first
typedef std::array<float, number> Distances;            // along each direction

struct Coordinates
{
  Distances x, y, z;

  Vector_of_floats operator[](int d) const { return {x[d], y[d], z[d]}; }
};

inline const Coordinates& coordinates()
{
  static const Coordinates result = [] {
    const double golden_angle = CGAL_PI * (3 - std::sqrt(5.));
    Coordinates c;
    for (int i = 0; i < number; ++i) {
      const double z = 1 - (2 * i + 1.) / number, r = std::sqrt(1 - z * z);
      c.x[i] = static_cast<float>(r * std::cos(i * golden_angle));
      c.y[i] = static_cast<float>(r * std::sin(i * golden_angle));
      c.z[i] = static_cast<float>(z);
    }
    return c;
  }();
  return result;
}

inline const std::vector<Neighbors>& neighbors()
{
  static const std::vector<Neighbors> result = [] {
    const Coordinates& c = coordinates();
    std::vector<Neighbors> n(number);
    std::vector<int> all(number);
    for (int i = 0; i < number; ++i) {
      std::iota(all.begin(), all.end(), 0);
      std::partial_sort_copy(all.begin(), all.end(), n[i].begin(), n[i].end(), [&](int a, int b)
                             { return c[i].dot(c[a]) > c[i].dot(c[b]); });
    }
    return n;
  }();
  return result;
}

// Returns the direction nearest to a unit vector. It was observed to be at most 11 positions from
// the position of the vector's own z.
inline int nearest(const Vector_of_floats& v)
{
  const Coordinates& c = coordinates();
  const int middle = static_cast<int>((1 - v.z) * number / 2);
  const int reach = number / 8;
  const int first = (std::max)(middle - reach, 0), end = (std::min)(middle + reach + 1, number);
  int best = first;
  for (int d = first + 1; d < end; ++d)
    if (v.dot(c[d]) > v.dot(c[best]))
      best = d;
  return best;
}

} // namespace directions

// The points of some faces that are farthest in each direction.
struct Support_set
{
  directions::Distances distances;
  std::array<Index, directions::number> points;

  Support_set()
  {
    distances.fill(-std::numeric_limits<float>::infinity());
    points.fill(0); // the point of faces without a finite distance
  }

  // Adds points, one for each direction. The loops have no branches, so that they are vectorized.
  template <class PointAt>
  void add(const directions::Distances& others, const PointAt& point_at)
  {
    int number_of_farther = 0;
    for (int d = 0; d < directions::number; ++d)
      number_of_farther += others[d] > distances[d];
    if (number_of_farther == 0) // this is the case two times out of three
      return;
    for (int d = 0; d < directions::number; ++d) {
      const Index point = points[d];
      points[d] = others[d] > distances[d] ? point_at(d) : point;
    }
    for (int d = 0; d < directions::number; ++d)
      distances[d] = (std::max)(distances[d], others[d]);
  }

  void add(Index point, const Vector_of_floats& at)
  {
    const directions::Coordinates& c = directions::coordinates();
    directions::Distances others;
    for (int d = 0; d < directions::number; ++d)
      others[d] = c.x[d] * at.x + c.y[d] * at.y + c.z[d] * at.z;
    add(others, [point](int) { return point; });
  }

  void add(const Support_set& other)
  { add(other.distances, [&](int d) { return other.points[d]; }); }
};

// The plane of a face.
struct Face_plane
{
  Vector_of_floats center, normal;
  std::uint8_t direction; // the direction next to the normal
};

// Finds the support points of sets of faces of a mesh. It keeps the support points of blocks of
// successive faces, which are near each other in a mesh in order of locality. Therefore it visits
// only the faces of blocks that a set contains partially.
class Support_points
{
  static constexpr Index faces_per_block = 32;

  std::vector<Vector_of_floats> points_;
  std::vector<Corners> corners_;
  std::vector<Face_plane> planes_;
  std::vector<Index> size_of_block_;
  std::vector<Support_set> block_extremes_;

  static Index block(Index f) { return f / faces_per_block; }

  void set_planes(const Surface& mesh)
  {
    planes_.reserve(mesh.number_of_faces());
    for (Index f = 0; f < mesh.number_of_faces(); ++f) {
      const Vector_of_floats normal(mesh.normal(f).normalized());
      planes_.push_back({Vector_of_floats(mesh.centroid(f)), normal,
                         static_cast<std::uint8_t>(directions::nearest(normal))});
    }
  }

  void set_blocks()
  {
    const std::size_t number = (corners_.size() + faces_per_block - 1) / faces_per_block;
    size_of_block_.resize(number, 0);
    block_extremes_.resize(number);
    for (Index f = 0; f < corners_.size(); ++f) {
      ++size_of_block_[block(f)];
      for (Index v : corners_[f])
        block_extremes_[block(f)].add(v, points_[v]);
    }
  }

public:
  explicit Support_points(const Surface& mesh) : corners_(mesh.corners)
  {
    points_.reserve(mesh.points.size());
    for (const Vector& p : mesh.points)
      points_.emplace_back(p);
    set_planes(mesh);
    set_blocks();
  }

  const Vector_of_floats& point(Index v) const { return points_[v]; }
  const Face_plane& plane(Index f) const { return planes_[f]; }

  // Returns the support points of faces without repetition.
  Support_set operator()(const std::vector<Index>& faces) const
  {
    std::vector<Index> number(block_extremes_.size(), 0); // the number of the faces in each block
    for (Index f : faces)
      ++number[block(f)];
    Support_set result;
    for (std::size_t b = 0; b < number.size(); ++b)
      if (number[b] == size_of_block_[b])
        result.add(block_extremes_[b]);
    std::vector<char> is_met(points_.size(), 0);
    for (Index f : faces)
      if (number[block(f)] < size_of_block_[block(f)])
        for (Index v : corners_[f])
          if (!is_met[v]) {
            is_met[v] = 1;
            result.add(v, points_[v]);
          }
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_SUPPORT_POINTS_H
