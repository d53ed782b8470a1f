// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_MOST_VISIBLE_NORMAL_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_MOST_VISIBLE_NORMAL_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Spectral_segmentation/internal/base/Vector.h>

#include <algorithm>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Returns the unit vector whose largest angle to the normals is smallest, or 0 if that is a right
// angle or more. The mean of normals often has larger angles at sharp edges, and a point that moves
// against it leaves the solid. The vector points to the point nearest to 0 in the convex hull of
// the normals, which the algorithm of Frank and Wolfe finds.
inline Vector most_visible_normal(const std::vector<Vector>& normals)
{
  Vector result;
  for (const Vector& n : normals)
    result += n / static_cast<double>(normals.size());
  for (int step = 0; step < 100 && !normals.empty(); ++step) {
    const Vector& farthest =
      *std::min_element(normals.begin(), normals.end(), [&result](const Vector& a, const Vector& b)
                        { return a.dot(result) < b.dot(result); });
    const Vector change = farthest - result;
    const double decrease = -change.dot(result), squared_length = change.dot(change);
    if (!(decrease > 1e-3 * result.dot(result)))
      break;
    result += (std::min)(1., decrease / squared_length) * change;
  }
  return result.normalized();
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_MOST_VISIBLE_NORMAL_H
