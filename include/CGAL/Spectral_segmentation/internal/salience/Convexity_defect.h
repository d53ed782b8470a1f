// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CONVEXITY_DEFECT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CONVEXITY_DEFECT_H

#include <CGAL/Spectral_segmentation/internal/salience/Support_points.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <bitset>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Measures how far sets of faces of a part are from convex: the mean depth, by area, of their faces
// below their own convex hull, each along its normal. The hull is the convex hull of the extreme
// points in some directions. The point that supports it along a normal is found among the extreme
// points of the directions next to the normal.
class Convexity_defect
{
  const Support_points& extreme_points_;
  const Surface& part_;
  const std::vector<Index>& faces_; // the faces of the part, by their indices in the mesh
  Support_set of_part_;
  std::vector<float> depths_; // below the hull of the part; they hold for many other hulls

  float depth(Index f, const Support_set& extremes) const
  {
    const Face_plane& plane = extreme_points_.plane(faces_[f]);
    float depth = 0;
    for (int d : directions::neighbors()[plane.direction])
      depth = (std::max)(depth, plane.normal.dot(extreme_points_.point(extremes.points[d]) -
                                                 plane.center));
    return depth;
  }

  // Returns the directions next to which a hull differs from the hull of the part.
  std::bitset<directions::number> changes(const Support_set& extremes) const
  {
    std::bitset<directions::number> result;
    for (int i = 0; i < directions::number; ++i)
      for (int d : directions::neighbors()[i])
        if (extremes.points[d] != of_part_.points[d])
          result.set(i);
    return result;
  }

public:
  Convexity_defect(const Support_points& support_points, const Surface& part,
             const std::vector<Index>& faces)
    : extreme_points_(support_points), part_(part), faces_(faces), of_part_(support_points(faces))
  {
    depths_.reserve(faces.size());
    for (Index f = 0; f < faces.size(); ++f)
      depths_.push_back(depth(f, of_part_));
  }

  double of_part() const
  {
    double sum = 0, area = 0;
    for (Index f = 0; f < depths_.size(); ++f) {
      sum += part_.areas[f] * depths_[f];
      area += part_.areas[f];
    }
    return area > 0 ? sum / area : 0;
  }

  // Returns the defect of faces of the part, without repetition; 0 if they have no area.
  double operator()(const std::vector<Index>& faces) const
  {
    std::vector<Index> in_mesh;
    in_mesh.reserve(faces.size());
    for (Index f : faces)
      in_mesh.push_back(faces_[f]);
    const Support_set extremes = extreme_points_(in_mesh);
    const std::bitset<directions::number> is_changed = changes(extremes);
    double sum = 0, area = 0;
    for (Index f : faces) {
      const bool changes = is_changed[extreme_points_.plane(faces_[f]).direction];
      sum += part_.areas[f] * (changes ? depth(f, extremes) : depths_[f]);
      area += part_.areas[f];
    }
    return area > 0 ? sum / area : 0;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CONVEXITY_DEFECT_H
