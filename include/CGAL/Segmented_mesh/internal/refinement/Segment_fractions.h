// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_FRACTIONS_H
#define CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_FRACTIONS_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/refinement/Boundary_band.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// The fraction of the angle around each vertex of the band that belongs to each segment, smoothed
// by diffusion. Fractions beyond the band are kept, and fractions on boundaries that are smooth
// already are equal.
class Segment_fractions
{
  typedef std::vector<std::pair<Index, double> > Fractions; // labels with their fractions

  // Small fractions of many tiny segments would take much time.
  static constexpr std::size_t capacity = 6; // the largest number of fractions at a vertex

  class Weighted_mean
  {
    Fractions sums_;
    double weight_ = 0;

  public:
    void add(Index label, double weight)
    {
      weight_ += weight;
      for (auto& [other, sum] : sums_)
        if (other == label) {
          sum += weight;
          return;
        }
      sums_.emplace_back(label, weight);
    }

    void add(const Fractions& fractions, double weight)
    {
      for (const auto& [label, fraction] : fractions)
        add(label, weight * fraction);
    }

    double weight() const { return weight_; }

    // Returns the largest fractions. Ties go to the smallest labels.
    Fractions result()
    {
      std::sort(sums_.begin(), sums_.end(), [](const auto& a, const auto& b)
        { return a.second > b.second || (a.second == b.second && a.first < b.first); });
      sums_.resize((std::min)(sums_.size(), capacity));
      for (auto& entry : sums_)
        entry.second /= weight_;
      return std::move(sums_);
    }
  };

  const Surface& graph_;
  std::vector<Fractions> fractions_; // one list per vertex, descending; empty outside the band

  // Returns the angle at the source of a halfedge, up to 7e-5, by the polynomial 4.4.45 of
  // Abramowitz and Stegun 1964: std::atan2() differs between libraries in its last digits.
  double angle(Index h) const
  {
    const Index f = h / 3, i = h % 3;
    const Vector& p = graph_.points[graph_.corners[f][i]];
    const Vector u = graph_.points[graph_.corners[f][(i + 1) % 3]] - p;
    const Vector v = graph_.points[graph_.corners[f][(i + 2) % 3]] - p;
    const double length = u.norm() * v.norm(), cosine = length > 0 ? u.dot(v) / length : 1;
    const double x = (std::min)(std::abs(cosine), 1.);
    const double result =
      std::sqrt(1 - x) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - x * 0.0187293)));
    return cosine < 0 ? CGAL_PI - result : result;
  }

  // Returns the diffusion weight of an edge in a face, which is positive. It grows with the
  // distance across the edge and falls with its length.
  double weight(Index h) const
  {
    const double length = graph_.length(h), area = graph_.areas[h / 3];
    return 0.02 + (area > 0 ? area / (length * length + area / 4) : 0);
  }

  void initialize(const Boundary_band& band, const std::vector<Index>& labels)
  {
    std::vector<Weighted_mean> means(graph_.points.size());
    for (Index f : band.faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        means[graph_.source_vertex(h)].add(labels[f], angle(h) + 1e-6);
    for (std::size_t v = 0; v < means.size(); ++v)
      if (means[v].weight() > 0)
        fractions_[v] = means[v].result();
    for (Index v = 0; v < fractions_.size(); ++v)
      if (band.is_fixed(v))
        for (auto& entry : fractions_[v])
          entry.second = 1. / static_cast<double>(fractions_[v].size());
  }

  void smooth(const Boundary_band& band, std::size_t number_of_iterations)
  {
    std::vector<Packed_graph::Ends> arcs;
    std::vector<double> weight_of_arc;
    for (Index f : band.faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index v = graph_.source_vertex(h), w = graph_.target_vertex(h);
        arcs.insert(arcs.end(), {{v, w}, {w, v}});
        weight_of_arc.insert(weight_of_arc.end(), 2, weight(h));
      }
    std::vector<Index> place;
    const Packed_graph edges(graph_.points.size(), arcs, place);
    std::vector<double> weights(arcs.size());
    for (std::size_t i = 0; i < arcs.size(); ++i)
      weights[place[i]] = weight_of_arc[i];

    std::vector<Index> vertices;
    for (Index v = 0; v < graph_.points.size(); ++v)
      if (band.is_inside(v) && !band.is_fixed(v))
        vertices.push_back(v);
    std::vector<Fractions> next(vertices.size());
    for (std::size_t iteration = 0; iteration < number_of_iterations; ++iteration) {
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Index v = vertices[i];
        Weighted_mean mean;
        for (Index a = edges.first_arc[v]; a < edges.first_arc[v + 1]; ++a)
          mean.add(fractions_[edges.targets[a]], weights[a]);
        mean.add(fractions_[v], mean.weight() / 2);
        next[i] = mean.result();
      }
      for (std::size_t i = 0; i < vertices.size(); ++i)
        fractions_[vertices[i]].swap(next[i]);
    }
  }

public:
  Segment_fractions(const Surface& graph, const std::vector<Index>& labels,
                    const Boundary_band& band, std::size_t number_of_iterations)
    : graph_(graph), fractions_(graph.points.size())
  {
    initialize(band, labels);
    smooth(band, number_of_iterations);
  }

  double operator()(Index v, Index label) const
  {
    for (const auto& [other, fraction] : fractions_[v])
      if (other == label)
        return fraction;
    return 0;
  }

  // Returns the label of the largest fraction at a vertex of a face of the band.
  Index label_of_largest(Index v) const { return fractions_[v].front().first; }
};

// The boundaries between segments as curves on the surface. A vertex lies in a segment or on a
// boundary. An edge between vertices of two segments is crossed once. In a face between vertices of
// three segments, three curves meet in its centroid. A face that is frozen keeps its label, and the
// boundary there follows its edges.
class Boundary_curves
{
  static constexpr double smallest_distance = 0.05;   // between a crossing and an end of its edge
  static constexpr double smallest_area = 1e-3;       // the area of a new face, in mean face areas
  static constexpr double smallest_split_area = 1e-2; // smaller faces may have smaller new faces

  typedef std::array<double, 3> Barycentric;

  const Surface& graph_;
  const std::vector<Index>& labels_; // one per face
  const Boundary_band& band_;
  std::vector<Index> vertex_label_; // `null_index` on a boundary
  std::vector<double> positions_;   // one per crossed halfedge, from its source on
  std::vector<char> is_frozen_;     // one per face
  double mean_area_ = 0;

  // Returns whether the ends of a halfedge lie in two segments.
  bool is_between(Index h) const
  {
    const Index a = vertex_label_[graph_.source_vertex(h)];
    const Index b = vertex_label_[graph_.target_vertex(h)];
    return a != b && a != null_index && b != null_index;
  }

  // Calls visit(h) for a halfedge of each edge that is crossed.
  template <class Visit>
  void for_each_crossing(const Visit& visit) const
  {
    for (Index f : band_.faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (is_crossed(h) && (graph_.is_border(h) || h < graph_.opposite[h]))
          visit(h);
  }

  void set_position(Index h, double position)
  {
    positions_[h] = position;
    if (!graph_.is_border(h))
      positions_[graph_.opposite[h]] = 1 - position;
  }

  // Returns the fraction of the edge length that each new face must have, so that its area is not
  // too small.
  double smallest_fraction(Index f) const
  {
    const double area = graph_.areas[f];
    if (!(area > 0) || area < smallest_split_area * mean_area_)
      return smallest_distance;
    return (std::max)(smallest_distance, 1.02 * std::sqrt(smallest_area * mean_area_ / area));
  }

  // Returns the smallest position on an edge; the largest position is as far from its target.
  double smallest_position(Index h) const
  { return (std::max)(smallest_fraction(h / 3), smallest_fraction(graph_.neighbor(h))); }

  // Returns the next point of the curve in the face of a halfedge that the curve crosses.
  Vector next_point(Index h) const
  {
    const Index f = h / 3;
    if (is_junction(f))
      return graph_.centroid(f);
    for (Index i = 1; i < 3; ++i) {
      const Index k = 3 * f + (h + i) % 3;
      if (is_crossed(k))
        return point(k);
    }
    return graph_.points[graph_.corners[f][(h + 2) % 3]];
  }

public:
  Boundary_curves(const Surface& graph, const std::vector<Index>& labels,
                  const Boundary_band& band, const Segment_fractions& fraction)
    : graph_(graph), labels_(labels), band_(band), vertex_label_(graph.points.size(), null_index),
      positions_(graph.number_of_halfedges(), 0.5), is_frozen_(graph.number_of_faces(), 1)
  {
    for (double area : graph.areas)
      mean_area_ += area / static_cast<double>(graph.number_of_faces());
    for (Index f = 0; f < graph.number_of_faces(); ++f)
      for (Index v : graph.corners[f])
        vertex_label_[v] = labels[f];
    for (Index f : band.faces) {
      is_frozen_[f] = 0;
      for (Index v : graph.corners[f])
        vertex_label_[v] = band.is_fixed(v) ? null_index : fraction.label_of_largest(v);
    }
    for (Index f : band.kept_faces)
      freeze(f);
    for_each_crossing([&](Index h) {
      const Index v = graph.source_vertex(h), w = graph.target_vertex(h);
      const Index a = vertex_label_[v], b = vertex_label_[w];
      const double to_v = fraction(v, a) - fraction(v, b), to_w = fraction(w, b) - fraction(w, a);
      set_position(h, to_v + to_w > 0 ? to_v / (to_v + to_w) : 0.5);
    });
  }

  void freeze(Index f) { is_frozen_[f] = 1; }

  // Returns the label of half an edge of a face: the label of the vertex at its end, otherwise of
  // the next vertex with a label.
  Index label(Index h, int half) const
  {
    const Index f = h / 3;
    if (!is_frozen_[f])
      for (Index i : {h + half, h + 1 - half, h + 2}) {
        const Index label = vertex_label_[graph_.corners[f][i % 3]];
        if (label != null_index)
          return label;
      }
    return labels_[f];
  }

  bool is_crossed(Index h) const
  { return is_between(h) && !(is_frozen_[h / 3] && is_frozen_[graph_.neighbor(h)]); }

  double position(Index h) const { return positions_[h]; }

  Vector point(Index h) const
  {
    const Vector& p = graph_.points[graph_.source_vertex(h)];
    return p + positions_[h] * (graph_.points[graph_.target_vertex(h)] - p);
  }

  // Returns whether three curves meet in the face.
  bool is_junction(Index f) const
  { return !is_frozen_[f] && is_between(3 * f) && is_between(3 * f + 1) && is_between(3 * f + 2); }

  // Returns the edge of the point that the new faces have in common, which is the nearest to its
  // opposite corner, or `Refinement::centroid`. For a face that is not split it is any edge.
  int apex_edge(Index f) const
  {
    if (is_junction(f))
      return Refinement::centroid;
    int best = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * f + static_cast<Index>(i);
      if (!is_crossed(h))
        continue;
      const Vector& corner = graph_.points[graph_.corners[f][(i + 2) % 3]];
      const double squared_distance = (point(h) - corner).squared_norm();
      if (squared_distance < smallest) {
        smallest = squared_distance;
        best = i;
      }
    }
    return best;
  }

  Barycentric apex(Index f) const
  {
    const int i = apex_edge(f);
    if (i == Refinement::centroid)
      return {1. / 3, 1. / 3, 1. / 3};
    Barycentric result = {0, 0, 0};
    result[i] = 1 - positions_[3 * f + i];
    result[(i + 1) % 3] = positions_[3 * f + i];
    return result;
  }

  // Lets a curve that comes too close to a vertex pass through it.
  void snap()
  {
    std::vector<Index> vertices;
    for_each_crossing([&](Index h) {
      const double smallest = smallest_position(h);
      if (positions_[h] <= smallest)
        vertices.push_back(graph_.source_vertex(h));
      if (positions_[h] >= 1 - smallest)
        vertices.push_back(graph_.target_vertex(h));
    });
    for (Index v : vertices)
      vertex_label_[v] = null_index;
  }

  // Shortens the curve at each crossing by one step of Weiszfeld's method for the sum of the
  // distances to the points before and after it.
  void tighten()
  {
    for_each_crossing([&](Index h) {
      if (is_frozen_[h / 3] || is_frozen_[graph_.neighbor(h)] || graph_.is_border(h))
        return;
      const Vector p = next_point(h), q = next_point(graph_.opposite[h]);
      const Vector here = point(h), start = graph_.points[graph_.source_vertex(h)];
      const Vector edge = graph_.points[graph_.target_vertex(h)] - start;
      const double to_p = (p - here).norm(), to_q = (q - here).norm();
      const double squared_length = edge.squared_norm();
      if (!(to_p > 0) || !(to_q > 0) || !(squared_length > 0))
        return;
      const Vector middle = (p * to_q + q * to_p) / (to_p + to_q);
      const double smallest = smallest_position(h);
      const double position = (middle - start).dot(edge) / squared_length;
      set_position(h, (std::min)((std::max)(position, smallest), 1 - smallest));
    });
  }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_FRACTIONS_H
