// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_REFINED_BOUNDARIES_H
#define CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_REFINED_BOUNDARIES_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/refinement/Boundary_band.h>
#include <CGAL/Segmented_mesh/internal/refinement/Segment_fractions.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Splits the faces of a surface. Calls add_point(f, weights) for each new vertex, which lies in
// face f at the mean of its corners with these weights, and add_triangle(f, corners, label) for
// each part of face f. New vertices have numbers from the number of vertices on.
template <class AddPoint, class AddTriangle>
void split_triangles(const Surface& surface, const Refinement& refinement,
                     const AddPoint& add_point, const AddTriangle& add_triangle)
{
  typedef std::array<double, 3> Weights;
  const Index first = static_cast<Index>(surface.points.size());
  for (const Refinement::Edge_point& p : refinement.points) {
    Weights weights = {0, 0, 0};
    weights[p.halfedge % 3] = 1 - p.position;
    weights[(p.halfedge + 1) % 3] = p.position;
    add_point(p.halfedge / 3, weights);
  }
  Index next_centroid = first + static_cast<Index>(refinement.points.size());
  for (const Refinement::Split_face& s : refinement.split_faces) {
    const Corners& c = surface.corners[s.face];
    const Index apex =
      s.apex == Refinement::centroid ? next_centroid++ : first + s.points[s.apex];
    if (s.apex == Refinement::centroid)
      add_point(s.face, Weights{1. / 3, 1. / 3, 1. / 3});
    for (int i = 0; i < 3; ++i) {
      const bool has_point = s.points[i] != null_index;
      const Index source = c[i], target = c[(i + 1) % 3];
      const Index middle = has_point ? first + s.points[i] : target;
      if (source != apex && middle != apex)
        add_triangle(s.face, Corners{source, middle, apex}, s.labels[2 * i]);
      if (has_point && middle != apex)
        add_triangle(s.face, Corners{middle, target, apex}, s.labels[2 * i + 1]);
    }
  }
}

// Freezes the faces of segments that would vanish, lose half of their area or fall into pieces.
class Segment_keeper
{
  static constexpr double smallest_rest = 0.5; // the fraction of the area of a segment

  const Surface& graph_;
  const std::vector<Index>& labels_; // one per face
  const Boundary_band& band_;
  std::vector<double> areas_;        // the initial area of each segment
  std::vector<std::size_t> numbers_; // the initial number of components of each segment

  // Counts the components of each segment, by the labels of the halves of the edges of faces.
  template <class Label>
  std::vector<std::size_t> numbers_of_components(const Label& label) const
  {
    // The part of a face with one label has the index of a corner in it.
    const auto part = [&](Index f, Index l) {
      Index half = 0;
      while (label(3 * f + half / 2, half % 2) != l)
        ++half;
      return 3 * f + (half + 1) / 2 % 3;
    };
    Disjoint_sets components(graph_.number_of_halfedges());
    std::vector<Index> label_of_part(graph_.number_of_halfedges(), null_index);
    for (Index h = 0; h < graph_.number_of_halfedges(); ++h)
      for (int half : {0, 1}) {
        const Index l = label(h, half);
        label_of_part[part(h / 3, l)] = l;
      }
    for (Index h = 0; h < graph_.number_of_halfedges(); ++h) {
      if (h / 3 >= graph_.neighbor(h))
        continue;
      const Index o = graph_.opposite[h];
      for (int half : {0, 1}) {
        const Index l = label(h, half);
        if (l == label(o, 1 - half))
          components.join(part(h / 3, l), part(o / 3, l));
      }
    }
    std::vector<std::size_t> numbers(areas_.size(), 0);
    for (Index p = 0; p < label_of_part.size(); ++p)
      if (label_of_part[p] != null_index)
        numbers[label_of_part[p]] += components.representative(p) == p;
    return numbers;
  }

  std::vector<double> areas(const Boundary_curves& curves) const
  {
    std::vector<double> result = areas_;
    for (Index f : band_.faces) {
      result[labels_[f]] -= graph_.areas[f];
      // The boundaries in the face meet in its apex.
      const auto apex = curves.apex(f);
      for (Index i = 0; i < 3; ++i) {
        const Index h = 3 * f + i;
        const double area = apex[(i + 2) % 3] * graph_.areas[f], t = curves.position(h);
        result[curves.label(h, 0)] += t * area;
        result[curves.label(h, 1)] += (1 - t) * area;
      }
    }
    return result;
  }

public:
  Segment_keeper(const Surface& graph, const std::vector<Index>& labels,
                 std::size_t number_of_segments, const Boundary_band& band)
    : graph_(graph), labels_(labels), band_(band), areas_(number_of_segments, 0)
  {
    for (Index f = 0; f < graph.number_of_faces(); ++f)
      areas_[labels[f]] += graph.areas[f];
    numbers_ = numbers_of_components([&](Index h, int) { return labels[h / 3]; });
  }

  // Freezes faces until no segment is bad. At worst all faces are frozen.
  void operator()(Boundary_curves& curves) const
  {
    const auto label = [&](Index h, int half) { return curves.label(h, half); };
    for (;;) {
      const std::vector<double> new_areas = areas(curves);
      const std::vector<std::size_t> new_numbers = numbers_of_components(label);
      std::vector<char> is_bad(areas_.size(), 0);
      for (std::size_t s = 0; s < is_bad.size(); ++s)
        is_bad[s] = new_areas[s] < smallest_rest * areas_[s] || new_numbers[s] == 0 ||
                    new_numbers[s] > numbers_[s];
      if (std::find(is_bad.begin(), is_bad.end(), 1) == is_bad.end())
        return;
      for (Index f : band_.faces) {
        bool is_to_freeze = is_bad[labels_[f]];
        for (Index half = 0; half < 6; ++half)
          is_to_freeze |= is_bad[label(3 * f + half / 2, half % 2)] != 0;
        if (is_to_freeze)
          curves.freeze(f);
      }
    }
  }
};

// Returns the splits of faces along the curves.
inline Refinement refinement(const Surface& graph, const std::vector<Index>& labels,
                             const Boundary_band& band, const Boundary_curves& curves)
{
  Refinement result;
  std::vector<Index> point(graph.number_of_halfedges(), null_index);
  for (Index f : band.faces) {
    Refinement::Split_face split{f, {}, curves.apex_edge(f), {}};
    bool has_point = false;
    for (Index i = 0; i < 3; ++i) {
      const Index h = 3 * f + i;
      if (curves.is_crossed(h) && point[h] == null_index) {
        point[h] = static_cast<Index>(result.points.size());
        if (!graph.is_border(h))
          point[graph.opposite[h]] = point[h];
        result.points.push_back({h, curves.position(h)});
      }
      has_point |= point[h] != null_index;
      split.points[i] = point[h];
      split.labels[2 * i] = curves.label(h, 0);
      split.labels[2 * i + 1] = curves.label(h, 1);
    }
    if (has_point)
      result.split_faces.push_back(split);
    else if (split.labels[0] != labels[f])
      result.other_labels.emplace_back(f, split.labels[0]);
  }
  return result;
}

// Refines the boundaries between segments. The fraction of the angle at a vertex that belongs to
// each segment is smoothed by diffusion in a band around them, and each vertex takes the label of
// its largest fraction. If the ends of an edge have two labels, the boundary crosses it where both
// fractions are equal. Then the boundaries are pulled taut.
//
// The labels of the faces must be less than `number_of_segments`, and each must have a face. The
// points of the surface are normalized, and its areas are set.
inline Refinement refined_boundaries(Surface& graph, const std::vector<Index>& labels,
                                     std::size_t number_of_segments,
                                     std::size_t number_of_iterations)
{
  normalize(graph.points);
  set_areas(Execution::SEQUENTIAL, graph);
  constexpr int number_of_rounds = 2, number_of_steps = 10;
  const Boundary_band band(graph, labels);
  if (band.faces.empty())
    return Refinement();
  Boundary_curves curves(graph, labels, band,
                         Segment_fractions(graph, labels, band, number_of_iterations));
  const Segment_keeper keep_segments(graph, labels, number_of_segments, band);
  for (int round = 0; round < number_of_rounds; ++round) {
    curves.snap();
    for (int step = 0; step < number_of_steps; ++step)
      curves.tighten();
    keep_segments(curves);
  }
  return refinement(graph, labels, band, curves);
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_REFINED_BOUNDARIES_H
