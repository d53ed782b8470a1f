// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PARTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PARTS_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The components of faces that are added one by one, by union-find.
class Face_components
{
  typedef boost::typed_identity_property_map<Index> Face_index;
  typedef boost::iterator_property_map<std::vector<Index>::iterator, Face_index> Map;

  std::vector<Index> rank_, parent_;
  boost::disjoint_sets<Map, Map> sets_;
  std::size_t number_ = 0;

public:
  explicit Face_components(std::size_t number_of_faces)
    : rank_(number_of_faces), parent_(number_of_faces),
      sets_(Map(rank_.begin(), Face_index()), Map(parent_.begin(), Face_index())) {}

  Face_components(const Face_components&) = delete; // the sets look into the vectors
  Face_components& operator=(const Face_components&) = delete;

  void add(Index f)
  {
    sets_.make_set(f);
    ++number_;
  }

  // Two faces that were added.
  void join(Index f, Index g)
  {
    const Index a = sets_.find_set(f), b = sets_.find_set(g);
    if (a == b)
      return;
    sets_.link(a, b);
    --number_;
  }

  Index representative(Index f) { return sets_.find_set(f); }
  std::size_t number() const { return number_; }
};

// The component of each face, numbered in the order of their first faces, where neighbors are
// connected if `are_connected(f, g)`. A fifth of the time of BGL's depth-first search.
template <class AreConnected>
std::vector<Index> connected_components(const Face_dual_graph& graph, std::size_t& number,
                                        const AreConnected& are_connected)
{
  const Index n = static_cast<Index>(graph.number_of_faces());
  Face_components components(n);
  for (Index f = 0; f < n; ++f)
    components.add(f);
  for (Index h = 0; h < graph.halfedges.size(); ++h) {
    const Index f = h / 3, g = graph.halfedges[h].neighbor;
    if (f < g && are_connected(f, g))
      components.join(f, g);
  }
  number = 0;
  std::vector<Index> result(n), number_of(n, null_index); // of the representative
  for (Index f = 0; f < n; ++f) {
    Index& component = number_of[components.representative(f)];
    if (component == null_index)
      component = static_cast<Index>(number++);
    result[f] = component;
  }
  return result;
}

inline std::vector<Index> connected_components(const Face_dual_graph& graph, std::size_t& number)
{ return connected_components(graph, number, [](Index, Index) { return true; }); }

inline std::vector<double> component_areas(const Face_dual_graph& graph,
                                           const std::vector<Index>& component, std::size_t number)
{
  std::vector<double> areas(number, 0);
  for (Index f = 0; f < graph.number_of_faces(); ++f)
    areas[component[f]] += graph.areas[f];
  return areas;
}

// Makes compact graphs of sets of faces of a graph, each in time linear in the size of the set. It
// holds arrays of the size of the graph.
class Part_copier
{
  const Face_dual_graph& graph_;
  std::vector<Index> face_, vertex_; // their numbers in the part at hand, else null_index

  void resize(Face_dual_graph& part, std::size_t number_of_faces) const
  {
    part.corners.resize(number_of_faces);
    part.areas.resize(number_of_faces);
    part.thickness.resize(graph_.thickness.empty() ? 0 : number_of_faces);
    part.halfedges.resize(3 * number_of_faces);
  }

public:
  explicit Part_copier(const Face_dual_graph& graph)
    : graph_(graph), face_(graph.number_of_faces(), null_index),
      vertex_(graph.points.size(), null_index) {}

  // Faces keep the order in which they are given; edges to other faces become border. If they
  // ascend, `part` may be the graph itself, which loses all others.
  void copy(const std::vector<Index>& faces, Face_dual_graph& part)
  {
    if (part.number_of_faces() < faces.size())
      resize(part, faces.size());
    for (Index i = 0; i < faces.size(); ++i)
      face_[faces[i]] = i;
    std::vector<Vector> points;
    std::vector<Index> vertices; // of the graph
    for (Index i = 0; i < faces.size(); ++i) {
      const Index f = faces[i];
      for (int j = 0; j < 3; ++j) {
        const Index v = graph_.corners[f][j];
        if (vertex_[v] == null_index) {
          vertex_[v] = static_cast<Index>(vertices.size());
          vertices.push_back(v);
          points.push_back(graph_.points[v]);
        }
        part.corners[i][j] = vertex_[v];
        Face_dual_graph::Halfedge halfedge = graph_.halfedges[3 * f + j];
        const Index neighbor = face_[halfedge.neighbor];
        halfedge.neighbor = neighbor == null_index ? i : neighbor;
        part.halfedges[3 * i + j] = halfedge;
      }
      part.areas[i] = graph_.areas[f];
      if (!graph_.thickness.empty())
        part.thickness[i] = graph_.thickness[f];
    }
    resize(part, faces.size());
    part.points = std::move(points);
    part.unit = graph_.unit;
    for (Index f : faces)
      face_[f] = null_index;
    for (Index v : vertices)
      vertex_[v] = null_index;
  }

  Face_dual_graph operator()(const std::vector<Index>& faces)
  {
    Face_dual_graph part;
    copy(faces, part);
    return part;
  }
};

// The pieces of a graph. `piece` has the number of the piece of each face. Faces keep their order.
// The largest piece stays in the memory of the graph.
template <class Number>
std::vector<Face_dual_graph> split(Face_dual_graph graph, const std::vector<Number>& piece,
                                   std::size_t number_of_pieces)
{
  std::vector<Face_dual_graph> result(number_of_pieces);
  if (number_of_pieces == 1)
    result[0] = std::move(graph);
  if (number_of_pieces < 2)
    return result;
  std::vector<std::vector<Index> > faces(number_of_pieces);
  for (Index f = 0; f < graph.number_of_faces(); ++f)
    faces[piece[f]].push_back(f);
  const auto has_less = [](const auto& a, const auto& b) { return a.size() < b.size(); };
  const std::size_t largest =
    std::max_element(faces.begin(), faces.end(), has_less) - faces.begin();
  Part_copier copier(graph);
  for (std::size_t i = 0; i < number_of_pieces; ++i)
    if (i != largest)
      copier.copy(faces[i], result[i]);
  copier.copy(faces[largest], graph);
  result[largest] = std::move(graph);
  return result;
}

inline std::vector<Neighbors> neighbors(const Face_dual_graph& graph)
{
  std::vector<Neighbors> result(graph.number_of_faces());
  for (Index h = 0; h < graph.halfedges.size(); ++h)
    result[h / 3][h % 3] = graph.halfedges[h].neighbor;
  return result;
}

inline double total_area(const Face_dual_graph& graph)
{ return std::accumulate(graph.areas.begin(), graph.areas.end(), 0.); }

// The mean of a function of the points of the surface, taken at the centroids of the faces. `area`
// is that of the graph, and not 0.
template <class ConcurrencyTag, class Value, class Function>
Value mean_over_surface(const Face_dual_graph& graph, double area, const Function& of_point)
{
  return sum_of<ConcurrencyTag>(graph.number_of_faces(), Value(Value::Zero()), [&](Index f)
    { return Value(graph.areas[f] / area * of_point(graph.centroid(f))); });
}

template <class ConcurrencyTag>
Vector center_of(const Face_dual_graph& graph, double area)
{
  return mean_over_surface<ConcurrencyTag, Vector>(graph, area, [](const Vector& p) { return p; });
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PARTS_H
