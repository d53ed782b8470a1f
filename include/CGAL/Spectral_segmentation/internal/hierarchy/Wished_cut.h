// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISHED_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISHED_CUT_H

#include <CGAL/Spectral_segmentation/internal/bipartition/min_cut_refinement.h>
#include <CGAL/Spectral_segmentation/internal/mesh/Face_graph.h>
#include <CGAL/Spectral_segmentation/internal/mesh/connected_components.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Cuts a region between two sets of faces, its terminals. Current flows from one set to the other,
// and hardly passes where the surface is concave. So the lines of equal potential go on from a seam
// that ends, around a limb, and run together along creases. Along the order of the potentials the
// cut is taken that costs least for the area that it cuts off; near it a minimum cut is searched.
//
// The seams of the region are borders. Faces of one node stay together.
class Wished_cut
{
  enum : char { OPEN = 2 };

  struct Node
  {
    std::vector<Index> faces;
    double area = 0;
    double border = 0; // length along other regions
    char side = OPEN;  // of a terminal, or of what no current reaches
  };

  const Face_graph& part_;
  const std::vector<Index>& node_of_face_;
  const double minimum_area_;
  std::vector<Node> nodes_;
  std::vector<char> is_terminal_; // of each node

  double conductance(Index h, double smallest_distance) const
  {
    const double convexity = 1 - part_.weights[h].concavity;
    const double cost = constants::cost_of_concave_edge + convexity * convexity;
    const double distance =
      (std::max)(static_cast<double>(part_.weights[h].centroids), smallest_distance);
    return cost * std::clamp(part_.length(h) / distance, 1e-3, 1e3);
  }

  // Visits the half-edges of a node that lead to others.
  template <class Visit>
  void for_each_halfedge(Index node, const Visit& visit) const
  {
    for (Index f : nodes_[node].faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (node_of_face_[part_.neighbors[h]] != node)
          visit(h, node_of_face_[part_.neighbors[h]]);
  }

  Vector centroid(const std::vector<Index>& faces) const
  {
    Vector sum;
    double area = 0;
    for (Index f : faces) {
      sum += part_.areas[f] * part_.centroid(f);
      area += part_.areas[f];
    }
    return area > 0 ? sum / area : part_.centroid(faces.front());
  }

  // The side of what is not connected with both: that of its terminals, or of the nearest ones.
  char side_of(const std::vector<Index>& faces, bool has_first, bool has_second) const
  {
    if (has_first || has_second)
      return has_first ? 0 : 1;
    const Vector center = centroid(faces);
    double least[2] = {std::numeric_limits<double>::infinity(),
                       std::numeric_limits<double>::infinity()};
    for (Index node = 0; node < nodes_.size(); ++node)
      if (is_terminal_[node])
        for (Index f : nodes_[node].faces) {
          double& distance = least[int(nodes_[node].side)];
          distance = (std::min)(distance, quantized((part_.centroid(f) - center).norm()));
        }
    return least[0] <= least[1] ? 0 : 1;
  }

  // Gives a side to all nodes that are not connected with terminals of both.
  void set_sides_of_pieces()
  {
    Face_components sets(nodes_.size());
    for (Index node = 0; node < nodes_.size(); ++node)
      sets.add(node);
    for (Index node = 0; node < nodes_.size(); ++node)
      for_each_halfedge(node, [&](Index, Index other) { sets.join(node, other); });
    std::vector<std::vector<Index> > faces(nodes_.size()); // of each set
    std::vector<std::array<bool, 2> > has_terminal(nodes_.size(), {false, false});
    for (Index node = 0; node < nodes_.size(); ++node) {
      const Index set = sets.representative(node);
      faces[set].insert(faces[set].end(), nodes_[node].faces.begin(), nodes_[node].faces.end());
      if (is_terminal_[node])
        has_terminal[set][int(nodes_[node].side)] = true;
    }
    std::vector<char> side(nodes_.size(), OPEN);
    for (Index set = 0; set < nodes_.size(); ++set)
      if (!faces[set].empty() && !(has_terminal[set][0] && has_terminal[set][1]))
        side[set] = side_of(faces[set], has_terminal[set][0], has_terminal[set][1]);
    for (Index node = 0; node < nodes_.size(); ++node)
      if (!is_terminal_[node])
        nodes_[node].side = side[sets.representative(node)];
  }

  std::vector<Index> open_nodes() const
  {
    std::vector<Index> result;
    for (Index node = 0; node < nodes_.size(); ++node)
      if (nodes_[node].side == OPEN)
        result.push_back(node);
    return result;
  }

  // The potential of each open node, from 0 at the second terminals to 1 at the first.
  std::vector<double> potentials(const std::vector<Index>& open) const
  {
    if (open.empty())
      return {};
    const double mean_area = std::accumulate(part_.areas.begin(), part_.areas.end(), 0.) /
                             static_cast<double>(part_.number_of_faces());
    const double smallest_distance = (std::max)(1e-3 * std::sqrt(mean_area), 1e-12);
    std::vector<int> row(nodes_.size(), -1);
    for (std::size_t i = 0; i < open.size(); ++i)
      row[open[i]] = static_cast<int>(i);
    std::vector<Eigen::Triplet<double> > entries;
    const Eigen::Index n = static_cast<Eigen::Index>(open.size());
    Eigen::VectorXd inflow = Eigen::VectorXd::Zero(n);
    for (std::size_t i = 0; i < open.size(); ++i) {
      double sum = 0;
      for_each_halfedge(open[i], [&](Index h, Index other) {
        const double c = conductance(h, smallest_distance);
        sum += c;
        if (nodes_[other].side == OPEN)
          entries.emplace_back(row[open[i]], row[other], -c);
        else if (nodes_[other].side == 0)
          inflow[row[open[i]]] += c;
      });
      entries.emplace_back(row[open[i]], row[open[i]], sum);
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd solution =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> >(matrix).solve(inflow);
    std::vector<double> result;
    for (Eigen::Index i = 0; i < n; ++i)
      result.push_back(quantized(1024 * solution[i])); // they differ little far from terminals
    return result;
  }

  // Sides that grow from the terminals, where there is no time for more.
  void grow(const std::vector<Index>& open)
  {
    std::vector<Index> reached;
    for (Index node = 0; node < nodes_.size(); ++node)
      if (is_terminal_[node])
        reached.push_back(node);
    for (std::size_t i = 0; i < reached.size(); ++i)
      for_each_halfedge(reached[i], [&](Index, Index other) {
        if (nodes_[other].side != OPEN)
          return;
        nodes_[other].side = nodes_[reached[i]].side;
        reached.push_back(other);
      });
    CGAL_assertion(std::all_of(open.begin(), open.end(),
                               [&](Index node) { return nodes_[node].side != OPEN; }));
    static_cast<void>(open);
  }

  // The best cut along the order of the potentials. The side with less border pays for it too, or a
  // corner beside another region would cost little. Sides that are too small come last.
  void cut_along_order(std::vector<Index> open)
  {
    const std::vector<double> potential = potentials(open);
    std::vector<std::size_t> order(open.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j)
                     { return potential[i] > potential[j]; });

    double area[2] = {0, 0}, border[2] = {0, 0}, cost = 0;
    std::vector<char> is_first(nodes_.size(), 0);
    const auto add = [&](Index node) {
      for_each_halfedge(node, [&](Index h, Index other)
                        { cost += (is_first[other] ? -1 : 1) * capacity(part_, h); });
      is_first[node] = 1;
      area[0] += nodes_[node].area;
      area[1] -= nodes_[node].area;
      border[0] += nodes_[node].border;
      border[1] -= nodes_[node].border;
    };
    for (const Node& n : nodes_) {
      area[1] += n.area;
      border[1] += n.border;
    }
    for (Index node = 0; node < nodes_.size(); ++node)
      if (nodes_[node].side == 0)
        add(node);
    std::pair<bool, double> best(true, std::numeric_limits<double>::infinity());
    std::size_t best_number = 0;
    for (std::size_t i = 0; i <= order.size(); ++i) {
      if (i == 0 || i == order.size() || potential[order[i - 1]] != potential[order[i]]) {
        const double smaller = (std::min)(area[0], area[1]);
        const double all = cost + (std::min)(border[0], border[1]);
        const std::pair<bool, double> value(
          smaller < minimum_area_, smaller > 0 ? quantized(all / std::sqrt(smaller))
                                               : (std::numeric_limits<double>::max)());
        if (value < best) {
          best = value;
          best_number = i;
        }
      }
      if (i < order.size())
        add(open[order[i]]);
    }
    for (std::size_t i = 0; i < order.size(); ++i)
      nodes_[open[order[i]]].side = i < best_number ? 0 : 1;
  }

  Sides sides() const
  {
    Sides result(part_.number_of_faces());
    for (const Node& n : nodes_)
      for (Index f : n.faces)
        result[f] = n.side;
    return result;
  }

  // What is connected with no terminal of its side goes to the other side.
  void join_to_terminals(Sides& side, const std::vector<char>& is_movable) const
  {
    for (char s : {char(0), char(1)}) {
      Face_components sets(part_.number_of_faces());
      for (Index f = 0; f < side.size(); ++f)
        sets.add(f);
      for (const Node& n : nodes_)
        for (Index f : n.faces)
          sets.join(f, n.faces.front());
      for (Index h = 0; h < part_.number_of_halfedges(); ++h)
        if (side[h / 3] == side[part_.neighbors[h]])
          sets.join(h / 3, part_.neighbors[h]);
      std::vector<char> has_terminal(side.size(), 0); // of each set
      for (Index node = 0; node < nodes_.size(); ++node)
        if (is_terminal_[node])
          has_terminal[sets.representative(nodes_[node].faces.front())] = 1;
      for (Index f = 0; f < side.size(); ++f)
        if (side[f] == s && is_movable[node_of_face_[f]] && !has_terminal[sets.representative(f)])
          side[f] = 1 - s;
    }
  }

  // The minimum cut near a cut, in the widest band where it falls into no more pieces.
  Sides refined(const Sides& side) const
  {
    std::size_t number_of_pieces;
    connected_components(part_, number_of_pieces, side);
    double area[2] = {0, 0};
    for (Index f = 0; f < side.size(); ++f)
      area[int(side[f])] += part_.areas[f];
    const double radius =
      constants::neighborhood_radius * std::sqrt((std::min)(area[0], area[1]));
    const std::vector<Index> cut = halfedges_of_cut(part_, side);
    for (double share : {1., 0.5, 0.25}) {
      std::vector<Index> band;
      for (const Face_at_distance& f : faces_near_cut(part_, side, cut, share * radius)) {
        const Index node = node_of_face_[f.face];
        if (!is_terminal_[node] && nodes_[node].faces.size() == 1)
          band.push_back(f.face);
      }
      const Sides result = minimum_cut_within(part_, band, side);
      std::size_t number;
      connected_components(part_, number, result);
      if (number <= number_of_pieces)
        return result;
    }
    return side;
  }

public:
  // `node_of_face` numbers the nodes from 0 on; `border` has the length of each face along other
  // regions. Smaller sides than `minimum_area` are avoided.
  Wished_cut(const Face_graph& part, const std::vector<Index>& node_of_face,
             const std::vector<double>& border, double minimum_area)
    : part_(part), node_of_face_(node_of_face), minimum_area_(minimum_area)
  {
    for (Index f = 0; f < node_of_face.size(); ++f) {
      if (node_of_face[f] >= nodes_.size())
        nodes_.resize(node_of_face[f] + 1);
      nodes_[node_of_face[f]].faces.push_back(f);
      nodes_[node_of_face[f]].area += part.areas[f];
      nodes_[node_of_face[f]].border += border[f];
    }
    is_terminal_.assign(nodes_.size(), 0);
  }

  // Gives a node its side. Tells whether it has not the other one.
  bool set_terminal(Index node, char side)
  {
    if (is_terminal_[node])
      return nodes_[node].side == side;
    is_terminal_[node] = 1;
    nodes_[node].side = side;
    return true;
  }

  // The side of each face. If the part has no weights, the sides only grow from the terminals.
  Sides operator()()
  {
    set_sides_of_pieces();
    const std::vector<Index> open = open_nodes();
    std::vector<char> is_movable(nodes_.size(), 0);
    for (Index node : open)
      is_movable[node] = 1;
    if (part_.weights.empty()) {
      grow(open);
      return sides();
    }
    cut_along_order(open);
    Sides result = sides();
    join_to_terminals(result, is_movable);
    if (open.empty())
      return result;
    result = refined(result);
    join_to_terminals(result, is_movable);
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISHED_CUT_H
