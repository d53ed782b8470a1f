// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_PATCH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_PATCH_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The side of each face: 0 for Q, of smaller area, 1 for the rest.
typedef std::vector<char> Sides;

// A two-way cut of a part.
struct Cut
{
  Sides side;
  double area[2];
  Salience_factors factors;
  double salience;
  std::vector<Index> near_cut = {}; // the faces near it, nearest first; calibrated method only
};

// Makes side 0 the side of smaller area.
inline void normalize_sides(Sides& side, double (&area)[2])
{
  if (area[0] <= area[1])
    return;
  for (char& s : side)
    s = 1 - s;
  std::swap(area[0], area[1]);
}

// Returns the salience. NaN counts as the least, because saliences are compared.
template <class PartSalience>
double salience_of(const PartSalience& part_salience, const Salience_factors& factors)
{
  const double salience = part_salience(factors);
  return std::isnan(salience) ? -std::numeric_limits<double>::infinity() : salience;
}

// The patch Q of the line search (Section 5.3), to which faces are added one by one, and the
// factors of the salience of the cut between Q and the rest (Section 6). Adding a face and
// computing the factors take constant time.
class Patch
{
  const Surface& part_;
  double area_of_part_;
  double largest_angle_ = 0; // over the inner edges of the part
  Vector origin_;            // near the points, so that their squares keep their digits

  std::vector<char> has_face_;
  double area_ = 0;

  std::size_t number_of_edges_ = 0; // the edges of the cut
  double concavity_ = 0;            // sum of H over its concave edges; exact because H is on a grid

  std::vector<Index> valence_;         // the number of edges in the cut at each vertex
  std::size_t number_of_vertices_ = 0; // along the cut, and the moments of their positions
  Vector sum_;
  Symmetric_matrix sum_of_squares_;

  void add_vertex(Index v)
  {
    if (valence_[v]++ > 0)
      return;
    const Vector p = part_.points[v] - origin_;
    ++number_of_vertices_;
    sum_ += p;
    sum_of_squares_ += Symmetric_matrix::square(p);
  }

  void remove_vertex(Index v)
  {
    if (--valence_[v] > 0)
      return;
    const Vector p = part_.points[v] - origin_;
    --number_of_vertices_;
    sum_ -= p;
    sum_of_squares_ -= Symmetric_matrix::square(p);
  }

public:
  explicit Patch(const Surface& part)
    : part_(part), area_of_part_(total_area(part)), origin_(part.centroid(0)),
      has_face_(part.number_of_faces(), 0), valence_(part.points.size(), 0)
  {
    float largest = 0;
    for (Index f = 0; f < part.number_of_faces(); ++f)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        largest = (std::max)(largest, part.is_border(h) ? 0 : part.weights[h].angle);
    largest_angle_ = largest;
  }

  // Adds a face. Calls `visit(h, sign)` for each of its edges that joins the cut (1) or leaves it
  // (-1).
  template <class Visit>
  void add(Index f, const Visit& visit)
  {
    has_face_[f] = 1;
    area_ += part_.areas[f];
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (part_.is_border(h))
        continue;
      const float concavity = part_.weights[h].concavity;
      if (has_face_[part_.neighbor(h)]) {
        --number_of_edges_;
        concavity_ -= concavity;
        remove_vertex(part_.source_vertex(h));
        remove_vertex(part_.target_vertex(h));
        visit(h, -1);
      }
      else {
        ++number_of_edges_;
        concavity_ += concavity;
        add_vertex(part_.source_vertex(h));
        add_vertex(part_.target_vertex(h));
        visit(h, 1);
      }
    }
  }

  void add(Index f)
  { add(f, [](Index, int) {}); }

  // Prefetches a face that will be added.
  void prefetch_face(Index f) const
  {
    prefetch(&part_.areas[f]);
    prefetch(&part_.corners[f]);
    prefetch(&part_.opposite[3 * f]);
    prefetch(&part_.weights[3 * f]);
    prefetch(&part_.weights[3 * f + 2]);
  }

  double area() const { return area_; }
  double area_of_part() const { return area_of_part_; }
  double area_of_rest() const { return area_of_part_ - area_; }
  double smaller_area() const { return (std::min)(area(), area_of_rest()); }

  // Returns the factors, which are defined while both sides have an area and the cut has an edge.
  Salience_factors factors() const
  {
    Salience_factors result;
    result.size = smaller_area() / area_of_part_;
    if (largest_angle_ > 0)
      result.cut_strength = concavity_ / (static_cast<double>(number_of_edges_) * largest_angle_);

    const double n = static_cast<double>(number_of_vertices_);
    const Symmetric_matrix covariance = sum_of_squares_ / n - Symmetric_matrix::square(sum_ / n);
    result.protrusiveness =
      1 - 4 * std::sqrt(product_of_largest_eigenvalues(covariance)) / smaller_area();
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_PATCH_H
