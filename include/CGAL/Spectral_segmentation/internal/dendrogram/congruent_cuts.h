// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_CONGRUENT_CUTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_CONGRUENT_CUTS_H

#include <CGAL/Spectral_segmentation/internal/base/Vector.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/Dendrogram.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// What a cut has in common with that of a twin limb. The unit is the root of the mesh's area.
struct Cut_shape
{
  double area = 0;                  // of Q, the smaller side
  double length = 0;                // of the cut
  double distance = 0;              // of the centroid of Q from that of its component
  double deviations[3] = {0, 0, 0}; // standard ones of Q along its principal axes
};

// The tolerances were chosen by measurement. No cut that is searched depends on them.
inline bool are_congruent(const Cut_shape& a, const Cut_shape& b)
{
  const auto are_near = [](double x, double y, double tolerance)
  { return std::abs(x - y) <= tolerance * (std::max)(x, y); };
  constexpr double of_shape = 0.15, of_length = 0.2, of_place = 0.1;
  constexpr double thickness = 0.001; // below it, flat parts have one of rounding errors
  bool result = are_near(a.area, b.area, of_shape) && are_near(a.length, b.length, of_length) &&
                std::abs(a.distance - b.distance) <= of_place;
  for (int i = 0; i < 3; ++i)
    result = result &&
             are_near(a.deviations[i] + thickness, b.deviations[i] + thickness, of_shape);
  return result;
}

// The moments of the area of a set of faces around the center of their component.
struct Area_moments
{
  double area = 0;
  Vector first;
  Symmetric_matrix second;

  friend Area_moments operator+(const Area_moments& a, const Area_moments& b)
  { return {a.area + b.area, a.first + b.first, a.second + b.second}; }
};

inline std::vector<Area_moments> moments_of_leaves(const Surface& mesh, const Dendrogram& d)
{
  const double area_of_mesh = total_area(mesh), unit = std::sqrt(area_of_mesh);
  const std::vector<double> areas = component_areas(mesh, mesh.components);
  std::vector<Vector> centers(areas.size());
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    centers[mesh.components[f]] += mesh.areas[f] / areas[mesh.components[f]] * mesh.centroid(f);
  std::vector<Area_moments> result(d.number_of_leaves());
  for (Index f = 0; f < mesh.number_of_faces(); ++f) {
    Vector sum;
    Symmetric_matrix squares;
    for (Index v : mesh.corners[f]) {
      const Vector p = (mesh.points[v] - centers[mesh.components[f]]) / unit;
      sum += p;
      squares += Symmetric_matrix::square(p);
    }
    const double area = mesh.areas[f] / area_of_mesh;
    Area_moments& moments = result[d.leaf[f]];
    moments = moments + Area_moments{area, area / 3 * sum,
                                     area / 12 * (squares + Symmetric_matrix::square(sum))};
  }
  return result;
}

// The length of each cut.
inline std::vector<double> lengths_of_cuts(const Surface& mesh, const Dendrogram& d)
{
  std::map<std::pair<Index, Index>, double> lengths; // of the boundaries of leaves
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if (const Index a = d.leaf[h / 3], b = d.leaf[mesh.neighbor(h)]; a < b)
      lengths[{a, b}] += mesh.length(h);
  const std::vector<std::size_t> above = parents(d);
  std::vector<double> result(d.merges.size(), 0);
  for (const auto& [leaves, length] : lengths) {
    std::size_t a = leaves.first, b = leaves.second;
    while (a != b) // each node is numbered after those below it
      (a < b ? a : b) = above[(std::min)(a, b)];
    result[a - d.number_of_leaves()] += length;
  }
  return result;
}

// The shape of each cut.
inline std::vector<Cut_shape> shapes_of_cuts(const Surface& mesh, const Dendrogram& d)
{
  const std::vector<double> lengths = lengths_of_cuts(mesh, d);
  const double unit = std::sqrt(total_area(mesh));
  std::vector<Cut_shape> result(d.merges.size());
  std::vector<Area_moments> moments = moments_of_leaves(mesh, d);
  replay(d, moments, [&](std::size_t k, const Area_moments& a, const Area_moments& b) {
    const Area_moments& q = a.area <= b.area ? a : b;
    const Vector centroid = q.first / q.area;
    const Symmetric_eigensystem variances(q.second / q.area - Symmetric_matrix::square(centroid));
    result[k] = {q.area, lengths[k] / unit, centroid.norm(), {}};
    for (int i = 0; i < 3; ++i)
      result[k].deviations[i] = std::sqrt((std::max)(variances.eigenvalue(i), 0.));
    return a + b;
  });
  return result;
}

// Gives cuts that make congruent parts, such as the legs of a horse, a common salience, the mean of
// theirs, so that a threshold treats them alike. Being congruent is not transitive: one after the
// other, the most salient first, each cut joins the first class with all of which it is congruent.
inline void unite_congruent_cuts(const Surface& mesh, Dendrogram& d)
{
  const std::vector<Cut_shape> shapes = shapes_of_cuts(mesh, d);
  std::vector<std::vector<std::size_t> > classes;
  for (std::size_t k = shapes.size(); k-- > 0;) {
    const auto found = std::find_if(classes.begin(), classes.end(), [&](const auto& members) {
      return std::all_of(members.begin(), members.end(), [&](std::size_t member)
                         { return are_congruent(shapes[k], shapes[member]); });
    });
    if (found == classes.end())
      classes.push_back({k});
    else
      found->push_back(k);
  }
  for (const std::vector<std::size_t>& members : classes) {
    // A caller's saliences may be infinite.
    const double least = d.merges[members.back()].salience;
    const double largest = d.merges[members.front()].salience;
    double sum = 0;
    for (std::size_t k : members)
      sum += d.merges[k].salience;
    const double mean = sum / static_cast<double>(members.size());
    for (std::size_t k : members)
      d.merges[k].salience = std::isnan(mean) ? least : std::clamp(mean, least, largest);
  }
  make_ultrametric(d);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_CONGRUENT_CUTS_H
