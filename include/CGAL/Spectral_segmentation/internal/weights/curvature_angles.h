// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_CURVATURE_ANGLES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_CURVATURE_ANGLES_H

#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Averages over the surface with a kernel of a given radius, the root of its mean squared distance.
// It solves the heat equation on the faces, by two steps of backward Euler. The flux over an edge
// is its length over the distance of the two centroids (finite volumes). Therefore the average
// depends on the shape and, unless faces are long and thin, not on the triangulation. No heat
// passes the border.
class Heat_smoothing
{
  typedef Eigen::SparseMatrix<double> Matrix;

  // Eigen's ordering, which would add the transpose to a matrix that is known to be symmetric.
  struct Ordering : Eigen::AMDOrdering<int>
  {
    void operator()(const Matrix& matrix, PermutationType& result) const
    {
      Eigen::AMDOrdering<int>()(matrix.selfadjointView<Eigen::Lower>(), result);
    }
  };

  // The system of a connected component, or of several small ones.
  struct System
  {
    std::vector<Index> faces;
    // The solver for the matrix of a step, which is symmetric because it acts on densities times
    // the roots of the areas. In the bands of cuts it takes a quarter of the time of conjugate
    // gradients, on a complete mesh of a million faces a little more.
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Ordering> solver;
  };

  double radius_;
  Eigen::VectorXd root_of_area_; // one per face
  std::vector<System> systems_;

  // Returns the index of the system of each face.
  std::vector<Index> divide_into_systems(const Surface& mesh)
  {
    constexpr Index small = 1000;
    const Components components = connected_components(mesh);
    std::vector<Index> size(components.number, 0), system(components.number);
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      ++size[components[f]];
    Index number = 0, size_of_last = small;
    for (std::size_t i = 0; i < components.number; ++i) {
      if (size_of_last >= small) {
        ++number;
        size_of_last = 0;
      }
      system[i] = number - 1;
      size_of_last += size[i];
    }
    std::vector<Index> result(mesh.number_of_faces());
    for (Index f = 0; f < result.size(); ++f)
      result[f] = system[components[f]];
    systems_ = std::vector<System>(number);
    return result;
  }

  // Returns the flux over an edge in a step.
  static double flux(const Surface& mesh, const std::vector<Vector>& points, Index h,
                     double step, double smallest_distance)
  {
    const Vector& a = points[mesh.source_vertex(h)];
    const Vector& b = points[mesh.target_vertex(h)];
    const Vector middle = (a + b) / 2;
    const double distance =
      (mesh.centroid(h / 3, points) - middle).norm() +
      (mesh.centroid(mesh.neighbor(h), points) - middle).norm();
    return step * (b - a).norm() / (std::max)(distance, smallest_distance);
  }

public:
  // Takes a radius relative to the square root of the area of the mesh, which must not be 0.
  Heat_smoothing(Execution execution, const Surface& mesh, const std::vector<Vector>& points,
                 double radius)
    : root_of_area_(mesh.number_of_faces())
  {
    const double area = total_area(mesh);
    const double mean_area = area / static_cast<double>(mesh.number_of_faces());
    radius_ = (std::min)(radius * std::sqrt(area),
                         std::sqrt(constants::largest_number_of_averaged_faces * mean_area));
    const double step = radius_ * radius_ / 8;
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      root_of_area_[f] = std::sqrt((std::max)(mesh.areas[f], 1e-9 * mean_area));
    const double smallest_distance = 1e-3 * std::sqrt(mean_area);

    const std::vector<Index> system_of_face = divide_into_systems(mesh);
    std::vector<int> row(mesh.number_of_faces());
    for (Index f = 0; f < mesh.number_of_faces(); ++f) {
      std::vector<Index>& faces = systems_[system_of_face[f]].faces;
      row[f] = static_cast<int>(faces.size());
      faces.push_back(f);
    }
    for_each_index(execution, systems_.size(), [&](std::size_t i) {
      System& system = systems_[i];
      const Eigen::Index n = static_cast<Eigen::Index>(system.faces.size());
      Matrix lower(n, n); // the lower triangle
      lower.reserve(3 * n);
      std::vector<std::pair<int, double> > entries; // of a column, with their rows
      for (Index f : system.faces) {
        double sum = 0;
        entries.clear();
        for (Index h = 3 * f; h < 3 * f + 3; ++h) {
          if (mesh.is_border(h))
            continue;
          const Index g = mesh.neighbor(h);
          const double root = root_of_area_[f] * root_of_area_[g];
          // The flux is clamped to keep the matrix positive definite in double precision.
          const double outward =
            (std::min)(flux(mesh, points, h, step, smallest_distance), 1e14 * root);
          sum += outward;
          if (row[g] > row[f])
            entries.emplace_back(row[g], -outward / root);
        }
        std::sort(entries.begin(), entries.end());
        lower.startVec(row[f]);
        lower.insertBack(row[f], row[f]) = 1 + sum / (root_of_area_[f] * root_of_area_[f]);
        for (std::size_t i = 0; i < entries.size(); ++i)
          if (i + 1 < entries.size() && entries[i].first == entries[i + 1].first)
            entries[i + 1].second += entries[i].second; // two edges of the same faces
          else
            lower.insertBack(entries[i].first, row[f]) = entries[i].second;
      }
      lower.finalize();
      system.solver.compute(lower);
    });
  }

  // Returns the clamped radius, in the unit of the points.
  double radius() const { return radius_; }

  // Returns the averaged densities of three quantities, given their amounts in each face. Solves
  // for the three at once, which takes a third of the time of Eigen's solver.
  std::vector<Vector> operator()(const std::vector<Vector>& amounts) const
  {
    std::vector<Vector> result(amounts.size());
    for (const System& system : systems_) {
      const Matrix& lower = system.solver.matrixL().nestedExpression();
      const auto& place = system.solver.permutationP().indices();
      const Eigen::VectorXd inverse_diagonal = system.solver.vectorD().cwiseInverse();
      const int *first = lower.outerIndexPtr(), *row = lower.innerIndexPtr();
      const double* value = lower.valuePtr();
      const int n = static_cast<int>(system.faces.size());
      std::vector<Vector> x(system.faces.size());
      for (int i = 0; i < n; ++i)
        x[place[i]] = amounts[system.faces[i]] / root_of_area_[system.faces[i]];
      for (int step = 0; step < 2; ++step) {
        for (int j = 0; j < n; ++j) {
          for (int k = first[j]; k < first[j + 1]; ++k)
            x[row[k]] -= value[k] * x[j];
          x[j] = inverse_diagonal[j] * x[j];
        }
        for (int j = n; j-- > 0;)
          for (int k = first[j]; k < first[j + 1]; ++k)
            x[j] -= value[k] * x[row[k]];
      }
      for (int i = 0; i < n; ++i)
        result[system.faces[i]] = x[place[i]] / root_of_area_[system.faces[i]];
    }
    return result;
  }
};

// Curvature of the surface at the scale of the shape instead of the scale of the triangulation.

// The coefficients of a symmetric tensor, on its diagonal and off it. They are scaled so that the
// dot product of all is the inner product of the tensors.
typedef std::array<Vector, 2> Symmetric_tensor;

inline Symmetric_tensor squared(const Vector& v)
{
  const double root = std::sqrt(2.);
  return {Vector(v.x() * v.x(), v.y() * v.y(), v.z() * v.z()),
          Vector(root * (v.x() * v.y()), root * (v.y() * v.z()), root * (v.z() * v.x()))};
}

// Returns for each halfedge the angle by which the surface bends over a path of twice the radius
// across the edge, which is negative where the surface is concave. It is computed from the
// curvature tensor of Cohen-Steiner and Morvan (2003), averaged over the radius by diffusion.
// `radius` is relative to the square root of the area of the mesh.
inline std::vector<double> curvature_angles(Execution execution, const Surface& mesh,
                                       const std::vector<Vector>& points,
                                       const std::vector<Vector>& normals, double radius)
{
  const auto edge_vector = [&](Index h) -> Vector
  { return points[mesh.target_vertex(h)] - points[mesh.source_vertex(h)]; };

  std::vector<double> angles(mesh.opposite.size(), 0);
  if (!(total_area(mesh) > 0))
    return angles;
  std::vector<Vector> tensors[2]; // the two halves of a tensor per face
  for (std::vector<Vector>& half : tensors)
    half.resize(mesh.number_of_faces());
  const auto set_tensor = [&](std::size_t i) {
    const Index f = static_cast<Index>(i);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = mesh.neighbor(h);
      const Vector edge = edge_vector(h);
      const double length = edge.norm();
      const double area = mesh.areas[f] + mesh.areas[g];
      if (mesh.is_border(h) || length == 0 || area == 0)
        continue;
      const double sine = normals[f].cross(normals[g]).dot(edge) / length;
      const double angle = // pi at a fold, where the sign of the sine is that of rounding errors
        std::atan2(std::abs(sine) > 1e-6 ? sine : 0, normals[f].dot(normals[g]));
      // The density is split by area; otherwise a sliver beside a sharp edge would get nearly all.
      const double density = angle * mesh.areas[f] / area / length;
      const Symmetric_tensor tensor = squared(edge);
      for (std::size_t k = 0; k < 2; ++k)
        tensors[k][f] += density * tensor[k];
    }
  };
  std::optional<Heat_smoothing> smoothing;
  call_all(execution, [&] { smoothing.emplace(execution, mesh, points, radius); },
           [&] { for_each_index(execution, mesh.number_of_faces(), set_tensor); });
  for_each_index(execution, 2, [&](std::size_t k) { tensors[k] = (*smoothing)(tensors[k]); });

  const double path_length = 2 * smoothing->radius();
  for_each_index(execution, angles.size(), [&](std::size_t i) {
    const Index h = static_cast<Index>(i), f = h / 3, g = mesh.neighbor(h);
    const Vector edge = edge_vector(h);
    const double area = mesh.areas[f] + mesh.areas[g];
    const double squared_length = edge.squared_norm();
    if (mesh.is_border(h) || squared_length == 0 || area == 0)
      return;
    const Symmetric_tensor across = squared(edge);
    const auto mean = [&](const std::vector<Vector>& half)
    { return (mesh.areas[f] * half[f] + mesh.areas[g] * half[g]) / area; };
    const Vector a = mean(tensors[0]), b = mean(tensors[1]);
    const double curvature =
      ((b.y() * across[1].y() + a.z() * across[0].z() + a.x() * across[0].x()) +
       (b.z() * across[1].z() + b.x() * across[1].x() + a.y() * across[0].y())) / squared_length;
    const double angle = path_length * curvature;
    if (std::abs(angle) > 1e-6) // a smaller angle is rounding, and the surface is flat
      angles[h] = (std::min)((std::max)(angle, -CGAL_PI), CGAL_PI);
  });
  return angles;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_CURVATURE_ANGLES_H
