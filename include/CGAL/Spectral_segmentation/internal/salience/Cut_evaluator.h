// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_EVALUATOR_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_EVALUATOR_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
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
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The data of the whole mesh that the factors of a cut need.
struct Evaluation_context
{
  double area;
  Support_points support_points;

  explicit Evaluation_context(const Surface& mesh)
    : area(total_area(mesh)), support_points(mesh) {}
};

// Computes all factors of cuts of a part, including the factors beyond the paper (Section 6 and
// `Salience_factors`). A cut is given by the side of each face: 0 for Q, which has the smaller
// area, 1 for the rest.
class Cut_evaluator
{
  const Surface& part_;
  double area_of_mesh_;
  Convexity_defect convexity_defect_;
  double defect_of_part_;

  // Sets size, cut strength by length and protrusiveness; returns the length of the cut.
  double set_boundary_factors(const std::vector<Index>& faces_of_q, const std::vector<Index>& cut,
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

  void set_neighborhood_factors(const Sides& side, const std::vector<Index>& cut,
                                double area_of_q, double length, Salience_factors& factors) const
  {
    const double radius = constants::neighborhood_radius * std::sqrt(area_of_q);
    double area_of_near_rest = 0, length_of_edges = 0, concavity = 0;
    for (const Face_at_distance& f : faces_near_cut(part_, side, cut, radius)) {
      if (side[f.face] == 1)
        area_of_near_rest += part_.areas[f.face];
      for (Index h = 3 * f.face; h < 3 * f.face + 3; ++h)
        if (!part_.is_border(h)) {
          const double l = part_.length(h);
          length_of_edges += l;
          concavity += l * part_.weights[h].concavity;
        }
    }
    factors.concavity_near_cut = length_of_edges > 0 ? concavity / length_of_edges : 0;
    factors.expansion_behind_cut =
      length > 0 ? (std::min)(area_of_near_rest / (radius * length), constants::largest_expansion)
                 : constants::largest_expansion;
  }

  void set_convexity_factors(const std::vector<Index> (&faces)[2], const double (&area)[2],
                             Salience_factors& factors) const
  {
    const double unit = std::sqrt(area_of_mesh_), whole = defect_of_part_ / unit;
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
    : part_(part), area_of_mesh_(mesh.area), convexity_defect_(mesh.support_points, part, faces),
      defect_of_part_(convexity_defect_.of_part())
  {}

  // Returns the factors. Both sides must have an area.
  Salience_factors operator()(const Sides& side) const
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
    const double length = set_boundary_factors(faces[0], cut, factors);
    set_neighborhood_factors(side, cut, area[0], length, factors);
    set_convexity_factors(faces, area, factors);
    factors.log_relative_part_area = std::log((area[0] + area[1]) / area_of_mesh_);
    return factors;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_EVALUATOR_H
