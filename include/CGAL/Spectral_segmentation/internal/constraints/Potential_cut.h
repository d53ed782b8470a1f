// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_POTENTIAL_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_POTENTIAL_CUT_H

#include <CGAL/Spectral_segmentation/internal/bipartition/min_cut_refinement.h>
#include <CGAL/Spectral_segmentation/internal/distances/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Cuts a region between two sets of faces, its terminals. Current flows from one set to the other,
// and hardly passes where the surface is concave. So the lines of equal potential go on from a seam
// that ends, around a limb, and run together along creases. Along the order of the potentials the
// cut is taken that costs least for the area that it cuts off.
//
// The nodes of the current are faces, or clusters of faces if there are many. Each group of faces is
// one node. The seams of the region are open.
class Potential_cut
{
  static constexpr std::size_t largest_number_of_faces = 8192, number_of_clusters = 4096;

  struct Arc // between two nodes, the smaller number first
  {
    std::array<Index, 2> nodes;
    double length; // of the common boundary
    double cost = 0, conductance = 0;
  };

  const Surface& part_;
  const double minimum_area_;
  std::vector<Index> node_; // of each face
  std::vector<double> areas_, borders_; // of each node; the lengths along other regions
  std::vector<Arc> arcs_;
  Sides side_; // of each node, or `open`
  static constexpr char open = 2;

  // Clusters are of the faces that are nearest, over the fewest edges, to evenly spread ones.
  void set_nodes(const std::vector<Index>& group)
  {
    const Index n = static_cast<Index>(part_.number_of_faces());
    const Index step = n > largest_number_of_faces ? n / number_of_clusters : 1;
    std::vector<Index> reached;
    std::map<Index, Index> node_of_group;
    node_.assign(n, null_index);
    for (Index f = 0; f < n; ++f)
      if (group[f] != null_index)
        node_[f] = node_of_group.emplace(group[f], node_of_group.size()).first->second;
    Index number = static_cast<Index>(node_of_group.size());
    const auto add_source = [&](Index f) {
      if (node_[f] == null_index) {
        node_[f] = number++;
        reached.push_back(f);
      }
    };
    for (Index f = 0; f < n; f += step)
      add_source(f);
    std::size_t i = 0;
    for (Index f = 0; f < n; ++f) { // and where none of these gets
      for (; i < reached.size(); ++i)
        for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h)
          if (const Index g = part_.neighbor(h); node_[g] == null_index) {
            node_[g] = node_[reached[i]];
            reached.push_back(g);
          }
      add_source(f);
    }
    areas_.assign(number, 0);
    borders_.assign(number, 0);
    side_.assign(number, open);
  }

  // The bending between two nodes is that between their mean normals.
  void set_arcs(const Distance_weights& weights)
  {
    std::vector<Vector> normals(areas_.size()), centroids(areas_.size());
    for (Index f = 0; f < node_.size(); ++f) {
      normals[node_[f]] += part_.area_vector(f);
      centroids[node_[f]] += part_.areas[f] * part_.centroid(f);
    }
    double area = 0;
    for (std::size_t a = 0; a < areas_.size(); ++a) {
      area += areas_[a];
      normals[a] = normals[a].normalized();
      if (areas_[a] > 0)
        centroids[a] = centroids[a] / areas_[a];
    }
    std::map<std::array<Index, 2>, double> boundaries;
    for (Index h = 0; h < part_.number_of_halfedges(); ++h)
      if (const auto [a, b] = std::minmax({node_[h / 3], node_[part_.neighbor(h)]});
          h < part_.opposite[h] && a != b)
        boundaries[{a, b}] += part_.length(h);
    std::vector<float> angles;
    std::vector<double> lengths;
    std::vector<char> is_concave;
    for (const auto& [nodes, length] : boundaries) {
      const Vector &n = normals[nodes[0]], &m = normals[nodes[1]];
      const Vector way = centroids[nodes[1]] - centroids[nodes[0]];
      const double one_minus_cosine = (n - m).squared_norm() / 2;
      is_concave.push_back(one_minus_cosine > 5e-13 && (m - n).dot(way) < 0);
      angles.push_back(static_cast<float>(
        (is_concave.back() ? weights.concave : weights.convex) * one_minus_cosine));
      lengths.push_back(length);
      arcs_.push_back({nodes, length, 0, way.norm()});
    }
    const std::vector<double> equalized = equalize(angles, lengths);
    const double smallest_distance =
      (std::max)(1e-3 * std::sqrt(area / static_cast<double>(areas_.size())), 1e-12);
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      const double cost = cost_of_cut(is_concave[i] ? equalized[i] : 0);
      const double distance = (std::max)(arcs_[i].conductance, smallest_distance);
      arcs_[i].cost = quantized(cost * lengths[i]);
      arcs_[i].conductance = cost * std::clamp(lengths[i] / distance, 1e-3, 1e3);
    }
  }

  // What current does not reach has the side of the terminals with which it is connected, or any.
  void set_sides_without_current()
  {
    Joined_sets sets(side_.size());
    for (const Arc& a : arcs_)
      sets.join(a.nodes[0], a.nodes[1]);
    std::vector<std::array<bool, 3> > has(side_.size(), {false, false, false});
    for (Index a = 0; a < side_.size(); ++a)
      has[sets[a]][int(side_[a])] = true;
    for (Index a = 0; a < side_.size(); ++a)
      if (side_[a] == open && !(has[sets[a]][0] && has[sets[a]][1]))
        side_[a] = has[sets[a]][0] ? 0 : 1;
  }

  // The potential of each node, from 0 at the second terminals to 1024 at the first.
  std::vector<double> potentials() const
  {
    std::vector<int> row(side_.size(), -1);
    int n = 0;
    for (Index a = 0; a < side_.size(); ++a)
      if (side_[a] == open)
        row[a] = n++;
    std::vector<Eigen::Triplet<double> > entries;
    Eigen::VectorXd values = Eigen::VectorXd::Zero(n); // the inflow, then the potentials
    for (const Arc& arc : arcs_)
      for (int k : {0, 1}) {
        const Index a = arc.nodes[k], b = arc.nodes[1 - k];
        if (row[a] < 0)
          continue;
        entries.emplace_back(row[a], row[a], arc.conductance);
        if (row[b] >= 0)
          entries.emplace_back(row[a], row[b], -arc.conductance);
        else if (side_[b] == 0)
          values[row[a]] += 1024 * arc.conductance;
      }
    if (n > 0) {
      Eigen::SparseMatrix<double> matrix(n, n);
      matrix.setFromTriplets(entries.begin(), entries.end());
      values = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> >(matrix).solve(values).eval();
    }
    std::vector<double> result;
    for (Index a = 0; a < side_.size(); ++a)
      result.push_back(side_[a] == open ? quantized(values[row[a]]) : side_[a] == 0 ? 1024 : 0);
    return result;
  }

  // Takes the best cut along the order of the potentials. Outer boundary counts as cut length for
  // the side with less of it; otherwise corners would be cheap. Sides that are too small come last.
  void cut_along_order()
  {
    struct Step // what is added when the nodes of a potential join the first side
    {
      double area = 0, border = 0, cost = 0;
    };
    const std::vector<double> potential = potentials();
    std::map<double, Step, std::greater<double> > steps;
    Step rest, sum;
    for (Index a = 0; a < side_.size(); ++a)
      for (Step* step : {&steps[potential[a]], &rest}) {
        step->area += areas_[a];
        step->border += borders_[a];
      }
    for (const Arc& a : arcs_) {
      const auto [low, high] = std::minmax({potential[a.nodes[0]], potential[a.nodes[1]]});
      if (low < high) {
        steps[high].cost += a.cost;
        steps[low].cost -= a.cost;
      }
    }
    const double last = steps.rbegin()->first;
    std::pair<bool, double> best(true, std::numeric_limits<double>::infinity());
    double smallest_potential = 0; // of the first side
    for (const auto& [of_step, step] : steps) {
      if (of_step == last)
        break;
      sum.area += step.area;
      sum.border += step.border;
      sum.cost += step.cost;
      const double smaller = (std::min)(sum.area, rest.area - sum.area);
      const double all = sum.cost + (std::min)(sum.border, rest.border - sum.border);
      const std::pair<bool, double> value(
        smaller < minimum_area_, smaller > 0 ? quantized(all / std::sqrt(smaller))
                                             : (std::numeric_limits<double>::max)());
      if (value < best) {
        best = value;
        smallest_potential = of_step;
      }
    }
    for (Index a = 0; a < side_.size(); ++a)
      side_[a] = potential[a] >= smallest_potential ? 0 : 1;
  }

public:
  // `group` is that of each face, or null_index; `border` is its length along other regions. Sides
  // smaller than `minimum_area` are avoided.
  Potential_cut(const Surface& part, const std::vector<Index>& group,
                const std::vector<double>& border, double minimum_area)
    : part_(part), minimum_area_(minimum_area)
  {
    set_nodes(group);
    for (std::size_t f = 0; f < node_.size(); ++f) {
      areas_[node_[f]] += part_.areas[f];
      borders_[node_[f]] += border[f];
    }
  }

  // The side of each face. If there is no time, the first terminals are cut off.
  Sides operator()(const std::array<std::vector<Index>, 2>& terminals,
                   const Distance_weights& weights, bool has_time)
  {
    for (char k : {char(1), char(0)}) // a node of both is on the first side
      for (Index f : terminals[int(k)])
        side_[node_[f]] = k;
    if (has_time) {
      set_arcs(weights);
      set_sides_without_current();
      cut_along_order();
    }
    Sides result;
    for (Index a : node_)
      result.push_back(side_[a] == 0 ? 0 : 1);
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_POTENTIAL_CUT_H
