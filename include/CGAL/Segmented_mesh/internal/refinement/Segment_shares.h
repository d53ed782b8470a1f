// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_SHARES_H
#define CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_SHARES_H

#include <CGAL/Spectral_segmentation/internal/base/arrays.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The neighborhood of the boundaries between segments, in which they may move.
class Boundary_band
{
  static constexpr int width = 3;             // in rings of vertices around the boundary
  static constexpr double smooth_turn = 0.25; // of a boundary that is smooth at a vertex
  static constexpr int number_of_spreads = 3; // of what is not smooth, by an edge each

  typedef std::pair<Index, Index> Ends;

  std::vector<Ends> boundary_;  // its edges
  std::vector<char> is_inside_; // of each vertex
  std::vector<char> is_smooth_; // of each vertex

  // Marks the vertices around marked ones.
  void grow(const Surface& graph, std::vector<char>& is_near) const
  {
    const std::vector<char> was_near = is_near;
    for (const Corners& c : graph.corners)
      if (was_near[c[0]] || was_near[c[1]] || was_near[c[2]])
        is_near[c[0]] = is_near[c[1]] = is_near[c[2]] = 1;
  }

  // A boundary that ends at a border goes on smoothly.
  void find_smooth_vertices(const Surface& graph)
  {
    const std::size_t n = graph.points.size();
    std::vector<Index> degree(n, 0);
    std::vector<Vector> directions(n); // the sum of those to the neighbors in the boundary
    for (const auto& [v, w] : boundary_) {
      const Vector direction = (graph.points[w] - graph.points[v]).normalized();
      directions[v] += direction;
      directions[w] -= direction;
      ++degree[v];
      ++degree[w];
    }
    is_smooth_.assign(n, 0);
    for (Index v = 0; v < n; ++v)
      is_smooth_[v] = degree[v] == 1 || (degree[v] == 2 && directions[v].norm() <= smooth_turn);
    for (int i = 0; i < number_of_spreads; ++i) {
      const std::vector<char> was_smooth = is_smooth_;
      for (const auto& [v, w] : boundary_) {
        is_smooth_[v] &= was_smooth[w];
        is_smooth_[w] &= was_smooth[v];
      }
    }
  }

public:
  std::vector<Index> faces; // with a vertex inside

  Boundary_band(const Surface& graph, const std::vector<Index>& labels)
  {
    for (Index h = 0; h < graph.number_of_halfedges(); ++h)
      if (labels[h / 3] < labels[graph.neighbor(h)])
        boundary_.emplace_back(graph.source(h), graph.target(h));
    find_smooth_vertices(graph);
    is_inside_.assign(graph.points.size(), 0);
    for (const auto& [v, w] : boundary_)
      is_inside_[v] = is_inside_[w] = 1;
    for (int ring = 1; ring < width; ++ring)
      grow(graph, is_inside_);
    for (Index f = 0; f < graph.number_of_faces(); ++f) {
      const Corners& c = graph.corners[f];
      if (is_inside_[c[0]] || is_inside_[c[1]] || is_inside_[c[2]])
        faces.push_back(f);
    }
  }

  bool is_inside(Index v) const { return is_inside_[v] != 0; }

  // Whether the boundary is smooth at the vertex and for some edges in both directions.
  bool is_on_smooth_boundary(Index v) const { return is_smooth_[v] != 0; }
};

// The share of each segment at each vertex of the band: first its share in the angle around the
// vertex, then smoothed by diffusion. Beyond the band they are kept, and on boundaries that are
// smooth already they are equal.
class Segment_shares
{
  typedef std::vector<std::pair<Index, double> > Shares; // labels with their shares

  // With many tiny segments, those of small share would take much time.
  static constexpr std::size_t capacity = 6; // of the shares at a vertex

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

    // The largest shares, of equals those of the smallest labels.
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
  std::vector<Shares> shares_; // of each vertex, in descending order; none outside of the band

  double angle(Index h) const
  {
    const Index f = h / 3, i = h % 3;
    const Vector& p = graph_.points[graph_.corners[f][i]];
    const Vector u = graph_.points[graph_.corners[f][(i + 1) % 3]] - p;
    const Vector v = graph_.points[graph_.corners[f][(i + 2) % 3]] - p;
    return std::atan2(u.cross(v).norm(), u.dot(v));
  }

  // How strongly the face joins the ends of its edge. It is positive for each face, and that of an
  // edge grows with its distance across and falls with its length.
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
        means[graph_.source(h)].add(labels[f], angle(h) + 1e-6);
    for (std::size_t v = 0; v < means.size(); ++v)
      if (means[v].weight() > 0)
        shares_[v] = means[v].result();
    for (Index v = 0; v < shares_.size(); ++v)
      if (band.is_on_smooth_boundary(v))
        for (auto& entry : shares_[v])
          entry.second = 1. / static_cast<double>(shares_[v].size());
  }

  void smooth(const Boundary_band& band, std::size_t number_of_iterations)
  {
    std::vector<std::pair<Index, Index> > arcs; // from, to
    std::vector<double> weights;                // of the arcs
    for (Index f : band.faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index v = graph_.source(h), w = graph_.target(h);
        arcs.insert(arcs.end(), {{v, w}, {w, v}});
        weights.insert(weights.end(), 2, weight(h));
      }
    const Rows arcs_of_vertex(graph_.points.size(), arcs.size(),
                              [&](Index a) { return arcs[a].first; });

    std::vector<Index> vertices;
    for (Index v = 0; v < graph_.points.size(); ++v)
      if (band.is_inside(v) && !band.is_on_smooth_boundary(v))
        vertices.push_back(v);
    std::vector<Shares> next(vertices.size());
    for (std::size_t iteration = 0; iteration < number_of_iterations; ++iteration) {
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Index v = vertices[i];
        Weighted_mean mean;
        for (Index a : arcs_of_vertex[v])
          mean.add(shares_[arcs[a].second], weights[a]);
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

  // Of a vertex of a face of the band.
  Index label_of_largest(Index v) const { return shares_[v].front().first; }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_REFINEMENT_SEGMENT_SHARES_H
