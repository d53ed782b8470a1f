// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DIFFUSION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DIFFUSION_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// Averages over the surface with a kernel of a given radius, the root of its mean squared distance:
// the heat equation on the faces, by two steps of backward Euler. The flux over an edge is its
// length over the distance of the two centroids (finite volumes), so that the average depends on
// the shape and, unless faces are long and thin, not on the triangulation. No heat passes the
// border.
class Diffusion
{
  typedef Eigen::SparseMatrix<double> Matrix;

  double radius_;
  Eigen::VectorXd root_of_area_;
  // Of the matrix of a step; symmetric, as it is for densities times the roots of the areas. In the
  // bands of cuts it takes a quarter of the time of conjugate gradients, on a whole mesh of a
  // million faces a little more.
  Eigen::SimplicialLDLT<Matrix> solver_;

public:
  // `radius` is relative to the square root of the area of the mesh, which must not be 0.
  Diffusion(const Face_dual_graph& mesh, const std::vector<Vector>& points, double radius)
    : root_of_area_(mesh.number_of_faces())
  {
    const double area = total_area(mesh);
    const double mean_area = area / static_cast<double>(mesh.number_of_faces());
    // About 9 faces: the bands around the cuts of a simplified mesh are not wider.
    radius_ = (std::min)(radius * std::sqrt(area), std::sqrt(80 * mean_area));
    const double step = radius_ * radius_ / 8;
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      root_of_area_[f] = std::sqrt((std::max)(mesh.areas[f], 1e-9 * mean_area));
    const double smallest_distance = 1e-3 * std::sqrt(mean_area);

    std::vector<Eigen::Triplet<double> > entries;
    entries.reserve(4 * mesh.number_of_faces());
    for (Index f = 0; f < mesh.number_of_faces(); ++f) {
      double sum = 0;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        if (mesh.is_border(h))
          continue;
        const Index g = mesh.halfedges[h].neighbor;
        const Vector& a = points[mesh.source_vertex(h)];
        const Vector& b = points[mesh.target_vertex(h)];
        const double distance = (mesh.centroid(f, points) - (a + b) / 2).norm() +
                                (mesh.centroid(g, points) - (a + b) / 2).norm();
        // Bounded, lest the 1 on the diagonal is lost beside it, and the matrix singular.
        const double flux =
          (std::min)(step * (b - a).norm() / (std::max)(distance, smallest_distance),
                     1e14 * root_of_area_[f] * root_of_area_[g]);
        sum += flux;
        entries.emplace_back(f, g, -flux / (root_of_area_[f] * root_of_area_[g]));
      }
      entries.emplace_back(f, f, 1 + sum / (root_of_area_[f] * root_of_area_[f]));
    }
    Matrix matrix(mesh.number_of_faces(), mesh.number_of_faces());
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(matrix);
  }

  // As it was bounded, in the unit of the points.
  double radius() const { return radius_; }

  // The averaged density of a quantity of which each face has some amount.
  Eigen::VectorXd operator()(const Eigen::VectorXd& amounts) const
  {
    const Eigen::VectorXd middle = solver_.solve(amounts.cwiseQuotient(root_of_area_));
    return solver_.solve(middle).cwiseQuotient(root_of_area_);
  }
};

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DIFFUSION_H
