// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_MINIMUM_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_MINIMUM_CUT_H

#include <CGAL/Spectral_segmentation/internal/salience/Patch.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Returns the cost of an edge for a cut: its length, and far less if the edge is concave.
inline double capacity(const Surface& part, Index h)
{
  const double convexity = 1 - part.weights[h].concavity;
  return quantized(part.length(h) * (constants::cost_of_concave_edge + convexity * convexity));
}

// Models the BGL concepts that a search for a maximum flow needs: each arc has a reverse.
struct Flow_graph : Packed_graph
{
  std::vector<Index> reverse; // one per arc

  typedef Index vertex_descriptor;
  typedef Index edge_descriptor;
  typedef boost::directed_tag directed_category;
  typedef boost::allow_parallel_edge_tag edge_parallel_category;
  struct traversal_category : boost::vertex_list_graph_tag, boost::edge_list_graph_tag,
                              boost::incidence_graph_tag {};
  typedef boost::counting_iterator<Index> vertex_iterator;
  typedef boost::counting_iterator<Index> edge_iterator;
  typedef boost::counting_iterator<Index> out_edge_iterator;
  typedef Index vertices_size_type;
  typedef Index edges_size_type;
  typedef Index degree_size_type;
  typedef std::pair<vertex_iterator, vertex_iterator> Range;
  static Index null_vertex() { return null_index; }

  friend Index num_vertices(const Flow_graph& g) { return g.number_of_nodes(); }
  friend Index num_edges(const Flow_graph& g) { return g.number_of_arcs(); }
  friend Index source(Index a, const Flow_graph& g) { return g.targets[g.reverse[a]]; }
  friend Index target(Index a, const Flow_graph& g) { return g.targets[a]; }
  friend Index out_degree(Index v, const Flow_graph& g)
  { return g.first_arc[v + 1] - g.first_arc[v]; }
  friend Range vertices(const Flow_graph& g)
  { return {vertex_iterator(0), vertex_iterator(g.number_of_nodes())}; }
  friend Range edges(const Flow_graph& g)
  { return {edge_iterator(0), edge_iterator(g.number_of_arcs())}; }
  friend Range out_edges(Index v, const Flow_graph& g)
  { return {out_edge_iterator(g.first_arc[v]), out_edge_iterator(g.first_arc[v + 1])}; }
};

// The flow network of a band of faces around a cut. Node i is the i-th face of the band. The faces
// beyond the band are the source on the side of Q, and the sink on the other side.
class Band_network
{
  struct Arcs
  {
    std::vector<Packed_graph::Ends> ends; // one per arc; arc i ^ 1 is the reverse of arc i
    std::vector<double> capacities;

    void add_both(Index a, Index b, double there, double back)
    {
      ends.push_back({a, b});
      ends.push_back({b, a});
      capacities.push_back(there);
      capacities.push_back(back);
    }
  };

  Index source_, sink_;
  Arcs arcs_; // between faces
  std::vector<double> from_source_, to_sink_; // capacities of each face

public:
  explicit Band_network(std::size_t number_of_faces)
    : source_(static_cast<Index>(number_of_faces)), sink_(source_ + 1),
      from_source_(number_of_faces, 0), to_sink_(number_of_faces, 0)
  {}

  void join(Index a, Index b, double capacity) { arcs_.add_both(a, b, capacity, capacity); }
  void join_to_source(Index a, double capacity) { from_source_[a] += capacity; }
  void join_to_sink(Index a, double capacity) { to_sink_[a] += capacity; }

  // Returns for each face of the band whether it is on the side of the source. If there are several
  // minimum cuts, the cut is the one nearest to the source, whatever the order of the arcs.
  std::vector<bool> minimum_cut() const
  {
    // BGL asks for one arc for each terminal and face.
    Arcs arcs = arcs_;
    for (Index i = 0; i < source_; ++i) {
      if (from_source_[i] > 0)
        arcs.add_both(source_, i, from_source_[i], 0);
      if (to_sink_[i] > 0)
        arcs.add_both(i, sink_, to_sink_[i], 0);
    }
    const std::size_t n = sink_ + 1, m = arcs.ends.size();
    std::vector<Index> place;
    Flow_graph graph{Packed_graph(n, arcs.ends, place), std::vector<Index>(m)};
    std::vector<double> capacities(m), residuals(m);
    for (std::size_t i = 0; i < m; ++i) {
      graph.reverse[place[i]] = place[i ^ 1];
      capacities[place[i]] = arcs.capacities[i];
    }

    std::vector<Index> predecessors(n);
    std::vector<boost::default_color_type> colors(n);
    std::vector<long> distances(n);
    const boost::typed_identity_property_map<Index> index;
    boost::boykov_kolmogorov_max_flow(
      std::as_const(graph), boost::make_iterator_property_map(capacities.begin(), index),
      boost::make_iterator_property_map(residuals.begin(), index),
      boost::make_iterator_property_map(graph.reverse.cbegin(), index),
      boost::make_iterator_property_map(predecessors.begin(), index),
      boost::make_iterator_property_map(colors.begin(), index),
      boost::make_iterator_property_map(distances.begin(), index), index, source_, sink_);
    std::vector<bool> result(source_);
    for (Index i = 0; i < source_; ++i)
      result[i] = colors[i] == boost::black_color;
    return result;
  }
};

// Returns the cheapest cut that leaves all faces of a part outside the band on their sides. Faces
// on neither side 0 nor side 1 count as absent. A side that lies entirely in the band keeps its
// last face there. The sides need not be connected.
inline Sides minimum_cut_within(const Surface& part, const std::vector<Index>& band,
                                const Sides& side)
{
  std::vector<Index> node(part.number_of_faces(), null_index);
  Index last_of_side[2] = {null_index, null_index};
  for (Index i = 0; i < band.size(); ++i) {
    node[band[i]] = i;
    last_of_side[int(side[band[i]])] = i;
  }

  Band_network network(band.size());
  bool has_terminal[2] = {false, false};
  const auto join_to_terminal = [&](Index i, char s, double c) {
    has_terminal[int(s)] = true;
    if (s == 0)
      network.join_to_source(i, c);
    else
      network.join_to_sink(i, c);
  };
  for (Index i = 0; i < band.size(); ++i) {
    const Index f = band[i];
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = part.neighbor(h);
      if (node[g] != null_index && f < g)
        network.join(i, node[g], capacity(part, h));
      else if (node[g] == null_index && (side[g] == 0 || side[g] == 1))
        join_to_terminal(i, side[g], capacity(part, h));
    }
  }
  for (char s : {char(0), char(1)})
    if (!has_terminal[int(s)] && last_of_side[int(s)] != null_index)
      join_to_terminal(last_of_side[int(s)], s, (std::numeric_limits<float>::max)());

  Sides result = side;
  const std::vector<bool> is_at_source = network.minimum_cut();
  for (std::size_t i = 0; i < band.size(); ++i)
    result[band[i]] = is_at_source[i] ? 0 : 1;
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_MINIMUM_CUT_H
