// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PARTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PARTS_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <numeric>
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

// Makes compact copies of sets of faces of a graph, each in time linear in the size of the set. It
// holds arrays of the size of the graph.
class Part_copier
{
  const Face_dual_graph& graph_;
  std::vector<Index> face_, vertex_; // their numbers in the part at hand, else null_index

  void add_vertices(Index f, Face_dual_graph& part)
  {
    std::array<Index, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const Index v = graph_.corners[f][i];
      if (vertex_[v] == null_index) {
        vertex_[v] = static_cast<Index>(part.points.size());
        part.points.push_back(graph_.points[v]);
      }
      corners[i] = vertex_[v];
    }
    part.corners.push_back(corners);
  }

public:
  explicit Part_copier(const Face_dual_graph& graph)
    : graph_(graph), face_(graph.number_of_faces(), null_index),
      vertex_(graph.points.size(), null_index) {}

  // Faces keep the order in which they are given; edges to other faces become border.
  Face_dual_graph operator()(const std::vector<Index>& faces)
  {
    for (Index i = 0; i < faces.size(); ++i)
      face_[faces[i]] = i;
    Face_dual_graph part;
    part.unit = graph_.unit;
    part.corners.reserve(faces.size());
    part.areas.reserve(faces.size());
    part.halfedges.reserve(3 * faces.size());
    for (Index f : faces) {
      add_vertices(f, part);
      part.areas.push_back(graph_.areas[f]);
      if (!graph_.thickness.empty())
        part.thickness.push_back(graph_.thickness[f]);
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        Face_dual_graph::Halfedge halfedge = graph_.halfedges[h];
        const Index neighbor = face_[halfedge.neighbor];
        halfedge.neighbor = neighbor == null_index ? face_[f] : neighbor;
        part.halfedges.push_back(halfedge);
      }
    }
    for (Index f : faces) {
      face_[f] = null_index;
      for (Index v : graph_.corners[f])
        vertex_[v] = null_index;
    }
    return part;
  }
};

// The pieces of a graph. `piece` has the number of the piece of each face. Faces keep their order.
template <class Number>
std::vector<Face_dual_graph> split(const Face_dual_graph& graph, const std::vector<Number>& piece,
                                   std::size_t number_of_pieces)
{
  std::vector<std::vector<Index> > faces(number_of_pieces);
  for (Index f = 0; f < graph.number_of_faces(); ++f)
    faces[piece[f]].push_back(f);
  Part_copier copy(graph);
  std::vector<Face_dual_graph> result;
  for (const std::vector<Index>& f : faces)
    result.push_back(copy(f));
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

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_PARTS_H
