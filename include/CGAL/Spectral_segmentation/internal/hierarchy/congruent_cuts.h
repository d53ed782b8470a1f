// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_CONGRUENT_CUTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_CONGRUENT_CUTS_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Dendrogram.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/surface/segment_classes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The properties of a cut that the cuts of congruent parts share. The unit is the root of the
// mesh's area.
struct Cut_shape
{
  Shape shape;         // of Q, the smaller side
  double length = 0;   // the length of the cut
  double distance = 0; // between the centroids of Q and of its component
};

// Returns whether cuts make congruent parts. The tolerances are measured. No searched cut depends
// on them.
inline bool are_congruent(const Cut_shape& a, const Cut_shape& b)
{
  return are_congruent(a.shape, b.shape, 0.001) &&
         std::abs(a.length - b.length) <= 0.2 * (std::max)(a.length, b.length) &&
         std::abs(a.distance - b.distance) <= 0.1;
}

// Gives cuts that make congruent parts, such as the legs of a horse, the mean of their saliences,
// so that a threshold treats them alike. The hierarchy must consist of merges.
class Congruent_cuts
{
  typedef std::vector<std::size_t> Class; // cuts, each given by its turn

  const Surface& mesh_;
  const Cut_hierarchy& cuts_;
  std::vector<Cut_shape> shapes_; // one per cut
  std::vector<double> saliences_; // one per cut
  std::vector<Class> classes_;

  void set_shapes()
  {
    const double area_of_mesh = total_area(mesh_), unit = std::sqrt(area_of_mesh);
    const Nested_ranges faces(cuts_, cuts_.leaf);
    std::vector<Vector> centers; // the center of the component of each node
    for (std::size_t node = 0; node < cuts_.nodes.size(); ++node) {
      centers.push_back(node < cuts_.number_of_roots ? Vector()
                                                     : centers[cuts_.nodes[node].parent]);
      if (node < cuts_.number_of_roots)
        for (Index f : faces[node])
          centers[node] += mesh_.areas[f] / cuts_.nodes[node].area * mesh_.centroid(f);
    }
    std::vector<std::size_t> cut_with_rest(mesh_.number_of_faces(), null_node);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const std::size_t (&sides)[2] = cuts_.nodes[cuts_.cut_order[i]].children;
      const Vector& center = centers[cuts_.cut_order[i]];
      for (Index f : faces[sides[1]])
        cut_with_rest[f] = i;
      double length = 0;
      Moments moments; // of Q
      for (Index f : faces[sides[0]]) {
        std::array<Vector, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
          corners[k] = (mesh_.points[mesh_.corners[f][k]] - center) / unit;
        moments.add(mesh_.areas[f] / area_of_mesh, corners);
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
          if (cut_with_rest[mesh_.neighbor(h)] == i)
            length += mesh_.length(h) / unit;
      }
      shapes_[i] = {{moments.area, moments.deviations()}, length, moments.centroid().norm()};
    }
  }

  // Finds the classes of congruent cuts. Cuts that are merged late come first.
  void set_classes()
  {
    std::vector<std::size_t> order(shapes_.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    classes_ = first_fit_classes(order, [this](std::size_t i, std::size_t j)
                                 { return are_congruent(shapes_[i], shapes_[j]); });
  }

  // Returns the mean salience of congruent cuts. A caller's saliences may be infinite.
  double mean_salience(const Class& congruent) const
  {
    double sum = 0, least = saliences_[congruent.front()], largest = least;
    for (std::size_t i : congruent) {
      sum += saliences_[i];
      least = (std::min)(least, saliences_[i]);
      largest = (std::max)(largest, saliences_[i]);
    }
    const double mean = sum / static_cast<double>(congruent.size());
    return std::isnan(mean) ? least : std::clamp(mean, least, largest);
  }

public:
  Congruent_cuts(const Surface& mesh, const Cut_hierarchy& cuts)
    : mesh_(mesh), cuts_(cuts), shapes_(cuts.cut_order.size())
  {
    for (std::size_t node : cuts.cut_order)
      saliences_.push_back(cuts.nodes[node].salience);
  }

  // Returns the same cuts, as they are applied from the top down.
  Cut_hierarchy operator()()
  {
    set_shapes();
    set_classes();
    for (const Class& congruent : classes_) {
      const double mean = mean_salience(congruent);
      for (std::size_t i : congruent)
        saliences_[i] = mean;
    }
    Cut_hierarchy result = cuts_;
    for (std::size_t i = 0; i < saliences_.size(); ++i)
      result.nodes[result.cut_order[i]].salience = saliences_[i];
    return applied_from_top_down(std::move(result));
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_CONGRUENT_CUTS_H
