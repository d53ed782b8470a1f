// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TRIANGLES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TRIANGLES_H

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

typedef std::uint32_t Index;
constexpr Index null_index = static_cast<Index>(-1);

typedef Eigen::Vector3d Vector;

// the faces across the three edges of a face; the face itself where there is none
typedef std::array<Index, 3> Neighbors;

// The triangles of a mesh, as arrays. The i-th edge of a face leaves its i-th corner.
struct Triangles
{
  std::vector<std::array<Index, 3> > corners; // vertices of a face
  std::vector<Neighbors> neighbors;           // of a face, as the mesh says
  std::vector<Vector> points;                 // of the vertices
  double unit = 1;                            // the length of 1 in the coordinates of the mesh
};

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TRIANGLES_H
