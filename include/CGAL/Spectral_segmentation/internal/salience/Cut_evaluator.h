// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_EVALUATOR_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_EVALUATOR_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/features/Face_features.h>
#include <CGAL/Spectral_segmentation/internal/features/feature_factors.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut.h>
#include <CGAL/Spectral_segmentation/internal/salience/Support_points.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/salience/Convexity_defect.h>
#include <CGAL/Spectral_segmentation/internal/salience/Boundary_statistics.h>
#include <CGAL/Spectral_segmentation/internal/salience/faces_near_cut.h>
#include <CGAL/Spectral_segmentation/internal/surface/surface_integrals.h>
#include <CGAL/Spectral_segmentation/internal/base/constants.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The data of the whole mesh that the factors of a cut need.
struct Evaluation_context
{
  double area;
  Support_points support_points;
  Face_features features; // of the mesh
  double feature_weight;

  explicit Evaluation_context(const Surface& mesh, Face_features face_features = Face_features(),
                              double weight = 0)
    : area(total_area(mesh)), support_points(mesh), features(std::move(face_features)),
      feature_weight(weight) {}
};

// Computes all factors of cuts of a part, including the factors beyond the paper (Section 6 and
// `Salience_factors`). A cut is given by the side of each face: 0 for Q, which has the smaller
// area, 1 for the rest.
class Cut_evaluator
{
  const Surface& part_;
  const std::vector<Index>& faces_; // of the part, by their indices in the mesh
  const Evaluation_context& mesh_;
  Convexity_defect convexity_defect_;
  double defect_of_part_;

  // Sets size, cut strength by length and protrusiveness; returns the length of the cut.
  double set_cut_factors(const std::vector<Index>& faces_of_q, const std::vector<Index>& cut,
                         Salience_factors& factors) const
  {
    Boundary_statistics q(part_);
    for (Index f : faces_of_q)
      q.add(f);
    factors = q.factors();
    double length = 0, concavity = 0;
    for (Index h : cut) {
      const double l = part_.length(h);
      length += l;
      concavity += l * part_.weights[h].concavity;
    }
    factors.cut_strength = length > 0 ? concavity / length : 0;
    return length;
  }

  // Returns the ratio of the second and the first standard deviation of the points of a cut.
  double roundness(const std::vector<Index>& cut, double length) const
  {
    Vector sum;
    const Vector origin = part_.points[part_.source_vertex(cut.front())];
    Symmetric_matrix squares;
    for (Index h : cut) {
      const Vector a = part_.points[part_.source_vertex(h)] - origin,
                   b = part_.points[part_.target_vertex(h)] - origin, middle = (a + b) / 2;
      const double share = part_.length(h) / length;
      sum += share * middle;
      squares += share / 6 * (Symmetric_matrix::square(a) + Symmetric_matrix::square(b) +
                              4 * Symmetric_matrix::square(middle)); // Simpson's rule is exact
    }
    const Symmetric_matrix covariance = squares - Symmetric_matrix::square(sum);
    const double first = Eigen_solver(covariance).largest_eigenvalue();
    const double product = product_of_largest_eigenvalues(covariance);
    return first > 0 ? (std::min)(std::sqrt(product) / first, 1.) : 0;
  }

  // Returns the concavity below which a quarter of the length of a cut lies.
  double lower_quartile_of_concavity(const std::vector<Index>& cut, double length) const
  {
    std::vector<std::pair<float, double> > edges; // concavity and length
    for (Index h : cut)
      edges.emplace_back(part_.weights[h].concavity, part_.length(h));
    std::sort(edges.begin(), edges.end());
    double rest = length / 4;
    for (const auto& [concavity, l] : edges)
      if ((rest -= l) <= 0)
        return concavity;
    return edges.back().first;
  }

  typedef std::vector<Face_at_distance> Near_faces;

  // Returns the mean concavity, by length, of the edges of faces.
  double mean_concavity(Near_faces::const_iterator first, Near_faces::const_iterator end) const
  {
    double length = 0, concavity = 0;
    for (; first != end; ++first)
      for (Index h = 3 * first->face; h < 3 * first->face + 3; ++h)
        if (!part_.is_border(h)) {
          const double l = part_.length(h);
          length += l;
          concavity += l * part_.weights[h].concavity;
        }
    return length > 0 ? concavity / length : 0;
  }

  // Returns the area of the faces of one side relative to a strip along the cut.
  double expansion(Near_faces::const_iterator first, Near_faces::const_iterator end,
                   const Sides& side, char s, double area_of_strip) const
  {
    double area = 0;
    for (; first != end; ++first)
      if (side[first->face] == s)
        area += part_.areas[first->face];
    return area_of_strip > 0 ? (std::min)(area / area_of_strip, constants::largest_expansion)
                             : constants::largest_expansion;
  }

  // Returns the length of the mean normal of the faces of the rest.
  double flatness_of_rest(Near_faces::const_iterator first, Near_faces::const_iterator end,
                          const Sides& side) const
  {
    double area = 0;
    Vector sum;
    for (; first != end; ++first)
      if (side[first->face] == 1) {
        sum += part_.normal(first->face) / 2;
        area += part_.areas[first->face];
      }
    return area > 0 ? (std::min)(sum.norm() / area, 1.) : 1;
  }

  void set_factors_of_features(Near_faces::const_iterator first,
                               Near_faces::const_iterator end_of_near, const Sides& side,
                               Salience_factors& factors) const
  {
    Feature_variance sides(mesh_.features), near_cut(mesh_.features);
    for (Index f = 0; f < side.size(); ++f)
      sides.add(faces_[f], part_.areas[f], side[f]);
    for (; first != end_of_near; ++first)
      near_cut.add(faces_[first->face], part_.areas[first->face], side[first->face]);
    set_feature_factors(sides, near_cut, mesh_.area, factors);
    factors.feature_weight = mesh_.feature_weight;
  }

  void set_neighborhood_factors(const Sides& side, const std::vector<Index>& cut,
                                double area_of_q, double length, Salience_factors& factors) const
  {
    const double radius = constants::neighborhood_radius * std::sqrt(area_of_q);
    const Near_faces faces =
      faces_near_cut(part_, side, cut, factors.is_boundary ? 2 * radius : radius);
    const auto first = faces.begin(), end = faces.end();
    const auto end_of_near = std::partition_point(first, end, [=](const Face_at_distance& f)
                                                  { return f.distance <= radius; });
    factors.concavity_near_cut = mean_concavity(first, end_of_near);
    if (!mesh_.features.empty())
      set_factors_of_features(first, end_of_near, side, factors);
    factors.expansion_behind_cut = expansion(first, end_of_near, side, 1, radius * length);
    if (!factors.is_boundary)
      return;
    factors.flatness_behind_cut = flatness_of_rest(first, end_of_near, side);
    factors.concavity_around_cut = mean_concavity(first, end);
    factors.expansion_before_cut = expansion(first, end, side, 0, 2 * radius * length);
  }

  void set_convexity_factors(const std::vector<Index> (&faces)[2], const double (&area)[2],
                             Salience_factors& factors) const
  {
    const double unit = std::sqrt(mesh_.area), whole = defect_of_part_ / unit;
    const double sides =
      (area[0] * convexity_defect_(faces[0]) + area[1] * convexity_defect_(faces[1])) /
      ((area[0] + area[1]) * unit);
    const double offset = constants::smallest_convexity_defect;
    factors.convexity_gain = whole - sides;
    factors.relative_convexity_gain = std::log((whole + offset) / (sides + offset));
  }

public:
  // Takes a part; `faces` are its faces, by their indices in the mesh.
  Cut_evaluator(const Surface& part, const std::vector<Index>& faces,
                const Evaluation_context& mesh)
    : part_(part), faces_(faces), mesh_(mesh), convexity_defect_(mesh.support_points, part, faces),
      defect_of_part_(convexity_defect_.of_part())
  {}

  // Returns the factors of a candidate, or of the boundary of two regions. Both sides must have an
  // area.
  Salience_factors operator()(const Sides& side,
                              Evaluated_cut::Kind kind = Evaluated_cut::CANDIDATE) const
  {
    std::vector<Index> faces[2];
    for (std::vector<Index>& f : faces)
      f.reserve(side.size());
    double area[2] = {0, 0};
    for (Index f = 0; f < side.size(); ++f) {
      faces[int(side[f])].push_back(f);
      area[int(side[f])] += part_.areas[f];
    }

    Salience_factors factors;
    const std::vector<Index> cut = halfedges_of_cut(part_, side);
    const double length = set_cut_factors(faces[0], cut, factors);
    factors.is_boundary = kind == Evaluated_cut::BOUNDARY;
    if (factors.is_boundary && length > 0) {
      factors.roundness = roundness(cut, length);
      factors.lower_quartile_of_concavity = lower_quartile_of_concavity(cut, length);
    }
    set_neighborhood_factors(side, cut, area[0], length, factors);
    set_convexity_factors(faces, area, factors);
    factors.log_relative_part_area = std::log((area[0] + area[1]) / mesh_.area);
    return factors;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_EVALUATOR_H
