// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_SHARES_H
#define CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_SHARES_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Segmented_mesh/internal/refinement/Boundary_band.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/base/Packed_graph.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// The share of each segment at each vertex of the band: first its fraction of the angle around the
// vertex, then smoothed by diffusion. Shares beyond the band are kept, and shares on boundaries
// that are smooth already are equal.
class Segment_shares
{
  typedef std::vector<std::pair<Index, double> > Shares; // labels with their shares

  // Small shares of many tiny segments would take much time.
  static constexpr std::size_t capacity = 6; // the largest number of shares at a vertex

  class Weighted_mean
  {
    Shares sums_;
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

    void add(const Shares& shares, double weight)
    {
      for (const auto& [label, share] : shares)
        add(label, weight * share);
    }

    double weight() const { return weight_; }

    // Returns the largest shares. Ties go to the smallest labels.
    Shares result()
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
  std::vector<Shares> shares_; // one list per vertex, in descending order; empty outside the band

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

  // Returns how strongly the face joins the ends of its edge. The weight is positive for each face.
  // The weight of an edge grows with the distance across it and falls with its length.
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
        shares_[v] = means[v].result();
    for (Index v = 0; v < shares_.size(); ++v)
      if (band.is_fixed(v))
        for (auto& entry : shares_[v])
          entry.second = 1. / static_cast<double>(shares_[v].size());
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
    std::vector<Shares> next(vertices.size());
    for (std::size_t iteration = 0; iteration < number_of_iterations; ++iteration) {
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Index v = vertices[i];
        Weighted_mean mean;
        for (Index a = edges.first_arc[v]; a < edges.first_arc[v + 1]; ++a)
          mean.add(shares_[edges.targets[a]], weights[a]);
        mean.add(shares_[v], mean.weight() / 2);
        next[i] = mean.result();
      }
      for (std::size_t i = 0; i < vertices.size(); ++i)
        shares_[vertices[i]].swap(next[i]);
    }
  }

public:
  Segment_shares(const Surface& graph, const std::vector<Index>& labels,
                 const Boundary_band& band, std::size_t number_of_iterations)
    : graph_(graph), shares_(graph.points.size())
  {
    initialize(band, labels);
    smooth(band, number_of_iterations);
  }

  double operator()(Index v, Index label) const
  {
    for (const auto& [other, share] : shares_[v])
      if (other == label)
        return share;
    return 0;
  }

  // Returns the label of the largest share at a vertex of a face of the band.
  Index label_of_largest(Index v) const { return shares_[v].front().first; }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_SHARES_H
