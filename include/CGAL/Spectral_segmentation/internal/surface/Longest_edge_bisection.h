// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_LONGEST_EDGE_BISECTION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_LONGEST_EDGE_BISECTION_H

#include <CGAL/Spectral_segmentation/internal/surface/Face_tree.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the length of the longest edge of a face.
inline double longest_edge(const Surface& mesh, std::size_t f)
{
  const Corners& c = mesh.corners[f];
  return std::sqrt(squared_longest_edge({mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]}));
}

inline std::vector<double> longest_edges_of_faces(Execution execution, const Surface& mesh)
{
  std::vector<double> result(mesh.number_of_faces());
  for_each_index(execution, result.size(), [&](std::size_t f)
    { result[f] = longest_edge(mesh, f); });
  return result;
}

// Estimates how many faces the bisection of longest edges adds until no edge is longer than a
// bound. A face becomes a uniform mesh, but a needle becomes three needles half as long, and so on.
inline double number_of_added_faces(const Surface& mesh,
                                    const std::vector<double>& longest_edges, double bound)
{
  double result = 0;
  for (std::size_t f = 0; f < longest_edges.size(); ++f)
    if (longest_edges[f] > bound)
      result += std::pow(longest_edges[f] / bound, std::log2(3.)) +
                4 * mesh.areas[f] / (bound * bound);
  return result;
}

// Returns the edge length of a uniform mesh of this area with this number of faces.
inline double edge_length(double area, double number_of_faces)
{ return std::sqrt(4 / std::sqrt(3.) * area / number_of_faces); }

// Returns the edge length of a uniform mesh with this number of faces and the area of the largest
// component. The length is larger if many needles would otherwise add more faces than about the
// largest number. Returns none if no edge is longer.
inline std::optional<double> bound_of_edges(Execution execution, const Surface& mesh,
                                            double number_of_faces,
                                            double largest_number_of_added_faces)
{
  const std::vector<double> areas = component_areas(mesh, mesh.components);
  double result = edge_length(*std::max_element(areas.begin(), areas.end()), number_of_faces);
  const std::size_t number_of_long_faces =
    sum_of(execution, mesh.number_of_faces(), std::size_t(0), [&](std::size_t f)
      { return std::size_t(longest_edge(mesh, f) > result); });
  if (number_of_long_faces == 0)
    return std::nullopt;
  const std::vector<double> longest_edges = longest_edges_of_faces(execution, mesh);
  const double longest = *std::max_element(longest_edges.begin(), longest_edges.end());
  result = (std::max)(result, longest / largest_number_of_added_faces); // not 0
  while (number_of_added_faces(mesh, longest_edges, result) > largest_number_of_added_faces)
    result *= 1.25;
  return longest > result ? std::make_optional(result) : std::nullopt;
}

// Bisects faces at their longest edges until no edge is longer than a bound (Rivara 1984). An edge
// is always halved, and only because of its own length. Therefore the faces on its two sides split
// it equally, in any order.
class Longest_edge_bisection
{
  static constexpr double units_of_length = 1024; // the bound, in the unit of Edge::length

  struct Edge
  {
    double length;   // rounded, so that noise breaks no ties
    Vector ends;     // the sum of the two points, which breaks ties
    Index source, target;
    Index halves = null_index;   // the first of two edges, at the source
    Index halfedge = null_index; // its halfedge in the result, once a face has it

    bool operator<(const Edge& other) const
    { return std::tie(length, ends) < std::tie(other.length, other.ends); }
  };

  struct Directed_edge
  {
    Index edge;
    bool is_reversed;
  };

  typedef std::array<Directed_edge, 3> Edges_of_face; // in cyclic order

  const Surface& mesh_;
  const double bound_;
  std::vector<Edge> edges_;
  Level result_;

  std::vector<Vector>& points() { return result_.surface.points; }

  Index add_edge(Index source, Index target)
  {
    const Vector &p = points()[source], &q = points()[target];
    const double length = std::round((q - p).norm() / bound_ * units_of_length);
    edges_.push_back({length, p + q, source, target});
    return static_cast<Index>(edges_.size() - 1);
  }

  Index source(const Directed_edge& side) const
  { return side.is_reversed ? edges_[side.edge].target : edges_[side.edge].source; }

  // Splits an edge unless it is split already. Returns the vertex between the two halves.
  Index bisect(Index edge)
  {
    if (edges_[edge].halves == null_index) {
      const Index source = edges_[edge].source, target = edges_[edge].target;
      const Index middle = static_cast<Index>(points().size());
      points().push_back((points()[source] + points()[target]) / 2);
      const Index first = add_edge(source, middle);
      add_edge(middle, target);
      edges_[edge].halves = first;
    }
    return edges_[edges_[edge].halves].target;
  }

  // Returns the half of a side at its source, or at its target.
  Directed_edge half(const Directed_edge& side, bool is_at_target) const
  {
    return {edges_[side.edge].halves + Index(is_at_target != side.is_reversed), side.is_reversed};
  }

  void add_face(const Edges_of_face& sides, Index face_of_mesh)
  {
    Surface& graph = result_.surface;
    const Index f = static_cast<Index>(graph.corners.size());
    graph.corners.push_back({source(sides[0]), source(sides[1]), source(sides[2])});
    result_.parent_face.push_back(face_of_mesh);
    if (mesh_.components.number > 1)
      graph.components.labels.push_back(mesh_.components[face_of_mesh]);
    for (Index i = 0; i < 3; ++i) {
      const Index h = 3 * f + i;
      graph.opposite.push_back(h);
      Index& other = edges_[sides[i].edge].halfedge;
      if (other == null_index)
        other = h;
      else if (other / 3 != f) {
        graph.opposite[h] = other;
        graph.opposite[other] = h;
      }
    }
  }

  void add_parts(const Edges_of_face& sides_of_face, Index face_of_mesh)
  {
    std::vector<Edges_of_face> left = {sides_of_face};
    while (!left.empty()) {
      const Edges_of_face sides = left.back();
      left.pop_back();
      int i = 0;
      for (int k : {1, 2})
        if (edges_[sides[i].edge] < edges_[sides[k].edge])
          i = k;
      if (edges_[sides[i].edge].length <= units_of_length) {
        add_face(sides, face_of_mesh);
        continue;
      }
      const Directed_edge &longest = sides[i], &next = sides[(i + 1) % 3],
                          &previous = sides[(i + 2) % 3];
      const Index between = add_edge(bisect(longest.edge), source(previous));
      left.push_back({half(longest, false), Directed_edge{between, false}, previous});
      left.push_back({half(longest, true), next, Directed_edge{between, true}});
    }
  }

public:
  Longest_edge_bisection(const Surface& mesh, double largest_length)
    : mesh_(mesh), bound_(largest_length)
  { points() = mesh.points; }

  // Returns the bisected surface, whose first vertices are those of the mesh.
  Level operator()(Execution execution)
  {
    std::vector<Directed_edge> sides; // one per halfedge
    for (Index h = 0; h < mesh_.number_of_halfedges(); ++h)
      if (h <= mesh_.opposite[h])
        sides.push_back({add_edge(mesh_.source_vertex(h), mesh_.target_vertex(h)), false});
      else
        sides.push_back({sides[mesh_.opposite[h]].edge, true});
    for (Index f = 0; f < mesh_.number_of_faces(); ++f)
      add_parts({sides[3 * f], sides[3 * f + 1], sides[3 * f + 2]}, f);
    result_.surface.components.number = mesh_.components.number;
    set_areas(execution, result_.surface);
    result_.coarse_vertex = first_indices(mesh_.points.size());
    result_.is_subdivision = true;
    return std::move(result_);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_LONGEST_EDGE_BISECTION_H
