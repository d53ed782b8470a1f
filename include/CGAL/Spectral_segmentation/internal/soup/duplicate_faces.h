// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SOUP_DUPLICATE_FACES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SOUP_DUPLICATE_FACES_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/surface/face_groups.h>
#include <CGAL/Spectral_segmentation/internal/soup/connect_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <tuple>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Finds duplicate faces, which have the same three points in any order, by a hash table of the
// faces. A face two of whose points coincide is no duplicate. The hash has a random key, against
// points that were chosen to collide in the table; the result does not depend on the key.
class Duplicate_faces
{
  const Surface& surface_;
  std::vector<std::uint64_t> hash_; // one per vertex

  const std::uint64_t key_ = std::uint64_t(std::random_device()()) << 32 | std::random_device()();

  std::uint64_t hash(const Vector& p) const
  {
    std::uint64_t h = key_;
    for (int i = 0; i < 3; ++i) {
      const double coordinate = p[i] + 0.; // no negative zero
      std::uint64_t bits;
      std::memcpy(&bits, &coordinate, sizeof bits);
      h = (h ^ bits) * 0x9e3779b97f4a7c15;
      h ^= h >> 29;
    }
    return h;
  }

  std::array<Vector, 3> sorted_points(Index f) const
  {
    const Corners& c = surface_.corners[f];
    std::array<Vector, 3> result = {surface_.points[c[0]], surface_.points[c[1]],
                                    surface_.points[c[2]]};
    std::sort(result.begin(), result.end(), [](const Vector& p, const Vector& q)
      { return std::make_tuple(p.x(), p.y(), p.z()) < std::make_tuple(q.x(), q.y(), q.z()); });
    return result;
  }

public:
  explicit Duplicate_faces(const Surface& surface) : surface_(surface)
  {
    hash_.reserve(surface.points.size());
    for (const Vector& p : surface.points)
      hash_.push_back(hash(p));
  }

  // Returns the first face with the same points for each face, which may be the face itself.
  std::vector<Index> operator()() const
  {
    const std::size_t n = surface_.corners.size();
    std::size_t size = 1;
    while (size < 2 * n)
      size *= 2;
    std::vector<Index> table(size, null_index), result;
    result.reserve(n);
    const auto face_hash = [&](Index f) {
      const Corners& c = surface_.corners[f];
      const std::uint64_t h = (hash_[c[0]] + hash_[c[1]] + hash_[c[2]]) * 0xbf58476d1ce4e5b9;
      return static_cast<std::size_t>(h ^ (h >> 31));
    };
    for (Index f = 0; f < n; ++f) {
      const std::array<Vector, 3> points = sorted_points(f);
      if (points[0] == points[1] || points[1] == points[2]) {
        result.push_back(f);
        continue;
      }
      std::size_t place = face_hash(f) & (size - 1);
      while (table[place] != null_index && !(sorted_points(table[place]) == points))
        place = (place + 1) & (size - 1);
      if (table[place] == null_index)
        table[place] = f;
      result.push_back(table[place]);
    }
    return result;
  }
};

// Returns the faces that `first_duplicate` maps to themselves, connected as a soup whose coincident
// points of one group are merged. This can make one surface of faces that duplicate faces had
// separated.
inline Surface distinct_faces(const Surface& surface, const std::vector<Index>& first_duplicate)
{
  Surface result;
  result.points = surface.points;
  const std::vector<Index> group = groups_of_vertices(surface);
  const auto coordinates = [&](Index v) {
    const Vector& p = surface.points[v];
    return std::make_tuple(p.x(), p.y(), p.z(), group[v]);
  };
  std::vector<Index> order(surface.points.size()), number(order.size());
  for (Index v = 0; v < order.size(); ++v)
    order[v] = v;
  std::sort(order.begin(), order.end(), [&](Index v, Index w)
    { return std::make_pair(coordinates(v), v) < std::make_pair(coordinates(w), w); });
  for (std::size_t i = 0; i < order.size(); ++i)
    number[order[i]] = i > 0 && coordinates(order[i - 1]) == coordinates(order[i])
      ? number[order[i - 1]] : order[i];
  for (Index f = 0; f < first_duplicate.size(); ++f)
    if (first_duplicate[f] == f) {
      const Corners& c = surface.corners[f];
      result.corners.push_back({number[c[0]], number[c[1]], number[c[2]]});
      if (!surface.groups.empty())
        result.groups.push_back(surface.groups[f]);
    }
  connect_triangles(result);
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SOUP_DUPLICATE_FACES_H
