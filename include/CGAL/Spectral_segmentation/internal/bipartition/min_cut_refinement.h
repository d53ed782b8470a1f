// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_MIN_CUT_REFINEMENT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_MIN_CUT_REFINEMENT_H

#include <CGAL/Spectral_segmentation/internal/salience/Cut.h>
#include <CGAL/Spectral_segmentation/internal/mesh/Face_graph.h>
#include <CGAL/Spectral_segmentation/internal/salience/faces_near_cut.h>
#include <CGAL/Spectral_segmentation/internal/utility/constants.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// What a cut pays for an edge: its length, and far less where the edge is concave.
inline double capacity(const Face_graph& part, Index h)
{
  const double convexity = 1 - part.weights[h].concavity;
  return quantized(part.length(h) * (constants::cost_of_concave_edge + convexity * convexity));
}

// The flow network of a band of faces around a cut: node i is the i-th face of the band; the faces
// beyond it on the side of Q are the source, those on the other side the sink.
class Band_network
{
  typedef boost::no_property No_property;
  typedef boost::compressed_sparse_row_graph<boost::directedS, No_property, No_property,
                                             No_property, int, int> Graph;
  typedef boost::graph_traits<Graph>::edge_descriptor Edge;

  struct Arc
  {
    int from, to;
    double capacity;
  };

  int source_, sink_;
  std::vector<Arc> arcs_; // between faces; arc i ^ 1 is the reverse of arc i
  std::vector<double> from_source_, to_sink_; // capacities of each face

  static void add_both(std::vector<Arc>& arcs, int a, int b, double there, double back)
  {
    arcs.push_back({a, b, there});
    arcs.push_back({b, a, back});
  }

public:
  explicit Band_network(std::size_t number_of_faces)
    : source_(static_cast<int>(number_of_faces)), sink_(source_ + 1),
      from_source_(number_of_faces, 0), to_sink_(number_of_faces, 0)
  {}

  void join(int a, int b, double capacity) { add_both(arcs_, a, b, capacity, capacity); }
  void join_to_source(int a, double capacity) { from_source_[a] += capacity; }
  void join_to_sink(int a, double capacity) { to_sink_[a] += capacity; }

  // For each face of the band: whether it is on the side of the source. Of several minimum cuts it
  // is the one nearest to the source, whatever the order of the arcs.
  std::vector<bool> minimum_cut() const
  {
    // One arc for each terminal and face, which BGL asks for.
    std::vector<Arc> arcs = arcs_;
    for (int i = 0; i < source_; ++i) {
      if (from_source_[i] > 0)
        add_both(arcs, source_, i, from_source_[i], 0);
      if (to_sink_[i] > 0)
        add_both(arcs, i, sink_, to_sink_[i], 0);
    }
    const int n = sink_ + 1;
    std::vector<std::size_t> next(n + 1, 0), place(arcs.size()); // in the order of the nodes
    for (const Arc& a : arcs)
      ++next[a.from + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<std::pair<int, int> > ends(arcs.size());
    std::vector<double> capacities(arcs.size()), residuals(arcs.size());
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      place[i] = next[arcs[i].from]++;
      ends[place[i]] = {arcs[i].from, arcs[i].to};
      capacities[place[i]] = arcs[i].capacity;
    }
    const Graph graph(boost::edges_are_sorted, ends.begin(), ends.end(), n);
    const std::vector<Edge> edge(edges(graph).first, edges(graph).second);
    std::vector<Edge> reverse(arcs.size());
    for (std::size_t i = 0; i < arcs.size(); ++i)
      reverse[place[i]] = edge[place[i ^ 1]];

    std::vector<Edge> predecessors(n);
    std::vector<boost::default_color_type> colors(n);
    std::vector<long> distances(n);
    const auto edge_index = get(boost::edge_index, graph);
    const auto vertex_index = get(boost::vertex_index, graph);
    boost::boykov_kolmogorov_max_flow(
      graph, boost::make_iterator_property_map(capacities.begin(), edge_index),
      boost::make_iterator_property_map(residuals.begin(), edge_index),
      boost::make_iterator_property_map(reverse.begin(), edge_index),
      boost::make_iterator_property_map(predecessors.begin(), vertex_index),
      boost::make_iterator_property_map(colors.begin(), vertex_index),
      boost::make_iterator_property_map(distances.begin(), vertex_index), vertex_index, source_,
      sink_);
    std::vector<bool> result(source_);
    for (int i = 0; i < source_; ++i)
      result[i] = colors[i] == boost::black_color;
    return result;
  }
};

// The cheapest cut that leaves all faces of a part on their sides but those of the band. Faces that
// are on no side, neither 0 nor 1, count as if they were not there. A side that lies wholly in the
// band keeps the last of its faces there. The sides need not be connected.
inline Sides minimum_cut_within(const Face_graph& part, const std::vector<Index>& band,
                                const Sides& side)
{
  std::vector<int> node(part.number_of_faces(), -1);
  int last_of_side[2] = {-1, -1};
  for (std::size_t i = 0; i < band.size(); ++i) {
    node[band[i]] = static_cast<int>(i);
    last_of_side[int(side[band[i]])] = static_cast<int>(i);
  }

  Band_network network(band.size());
  bool has_terminal[2] = {false, false};
  const auto join_to_terminal = [&](int i, char s, double c) {
    has_terminal[int(s)] = true;
    if (s == 0)
      network.join_to_source(i, c);
    else
      network.join_to_sink(i, c);
  };
  for (std::size_t i = 0; i < band.size(); ++i) {
    const Index f = band[i];
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = part.neighbors[h];
      if (node[g] >= 0 && f < g)
        network.join(static_cast<int>(i), node[g], capacity(part, h));
      else if (node[g] < 0 && (side[g] == 0 || side[g] == 1))
        join_to_terminal(static_cast<int>(i), side[g], capacity(part, h));
    }
  }
  for (char s : {char(0), char(1)})
    if (!has_terminal[int(s)] && last_of_side[int(s)] >= 0)
      join_to_terminal(last_of_side[int(s)], s, (std::numeric_limits<float>::max)());

  Sides result = side;
  const std::vector<bool> is_at_source = network.minimum_cut();
  for (std::size_t i = 0; i < band.size(); ++i)
    result[band[i]] = is_at_source[i] ? 0 : 1;
  return result;
}

// The cheapest cut in the neighborhood of a cut. Its sides need not be connected.
inline Sides minimum_cut_around(const Face_graph& part, const Sides& side, double area_of_q)
{
  std::vector<Index> band; // a side that lies wholly in it keeps the face farthest from the cut
  const double radius = constants::neighborhood_radius * std::sqrt(area_of_q);
  for (const Face_at_distance& f :
       faces_near_cut(part, side, halfedges_of_cut(part, side), radius))
    band.push_back(f.face);
  return minimum_cut_within(part, band, side);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_MIN_CUT_REFINEMENT_H
