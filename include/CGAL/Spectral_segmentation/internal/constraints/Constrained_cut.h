// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_CUT_H

#include <CGAL/Spectral_segmentation/internal/bipartition/min_cut_refinement.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/surface/surface_integrals.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Constraints.h>

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

// Cuts a region between two sets of faces, its terminals. Computes a harmonic potential between
// these sets, with low conductance across concave edges. Its level lines continue a forced boundary
// that ends, around a limb, and run together along creases. Takes the cut in the order of the
// potentials that costs least for the area that it cuts off, and moves it to a minimum cut near it.
//
// The cannot-link edges inside the region are borders. Faces of one group stay together.
class Constrained_cut
{
  enum : char { OPEN = 2 };

  const Surface& part_;
  const std::vector<Index>& group_;   // one per face; null_index if it is unconstrained
  const std::vector<double>& border_; // the length of each face along other regions
  const double minimum_area_;
  std::vector<Index> node_;           // one per face: a face of its group, or the face itself
  Sides side_;                        // one per face; OPEN if it is not known yet

  double conductance(Index h, double smallest_distance) const
  {
    const double convexity = 1 - part_.weights[h].concavity;
    const double cost = constants::cost_of_concave_edge + convexity * convexity;
    const double distance =
      (std::max)(static_cast<double>(part_.weights[h].centroids), smallest_distance);
    return cost * std::clamp(part_.length(h) / distance, 1e-3, 1e3);
  }

  // Returns for each face one of the faces of its connected piece. The pieces are those of the
  // sides, or those of the whole region.
  std::vector<Index> pieces(bool are_sides_apart) const
  {
    Face_components sets(side_.size());
    for (Index f = 0; f < side_.size(); ++f)
      sets.add(f);
    for (Index f = 0; f < side_.size(); ++f)
      sets.join(f, node_[f]);
    for (Index h = 0; h < part_.number_of_halfedges(); ++h)
      if (!are_sides_apart || side_[h / 3] == side_[part_.neighbor(h)])
        sets.join(h / 3, part_.neighbor(h));
    std::vector<Index> result;
    for (Index f = 0; f < side_.size(); ++f)
      result.push_back(sets.representative(f));
    return result;
  }

  // Sets the sides of faces that are not connected with both sets of terminals: the side of the
  // terminals with which they are connected, or any side if they are connected with none.
  void set_sides_without_current()
  {
    const std::vector<Index> piece = pieces(false);
    std::vector<std::array<bool, 3> > has(side_.size(), {false, false, false});
    for (Index f = 0; f < side_.size(); ++f)
      has[piece[f]][int(side_[f])] = true;
    for (Index f = 0; f < side_.size(); ++f)
      if (side_[f] == OPEN && !(has[piece[f]][0] && has[piece[f]][1]))
        side_[f] = has[piece[f]][0] ? 0 : 1;
  }

  // Returns the potential of each face, from 0 at the second terminals to 1024 at the first ones.
  std::vector<double> potentials() const
  {
    std::vector<int> row(side_.size(), -1);
    int n = 0;
    for (Index f = 0; f < side_.size(); ++f)
      if (side_[f] == OPEN && node_[f] == f)
        row[f] = n++;
    const double smallest_distance =
      (std::max)(1e-3 * std::sqrt(total_area(part_) / static_cast<double>(side_.size())), 1e-12);
    std::vector<Eigen::Triplet<double> > entries;
    Eigen::VectorXd values = Eigen::VectorXd::Zero(n); // the right-hand side, then the potentials
    for (Index h = 0; h < part_.number_of_halfedges(); ++h) {
      const Index from = node_[h / 3], to = node_[part_.neighbor(h)];
      if (row[from] < 0 || from == to)
        continue;
      const double c = conductance(h, smallest_distance);
      entries.emplace_back(row[from], row[from], c);
      if (row[to] >= 0)
        entries.emplace_back(row[from], row[to], -c);
      else if (side_[to] == 0)
        values[row[from]] += 1024 * c;
    }
    if (n > 0) {
      Eigen::SparseMatrix<double> matrix(n, n);
      matrix.setFromTriplets(entries.begin(), entries.end());
      values = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> >(matrix).solve(values).eval();
    }
    std::vector<double> result;
    for (Index f = 0; f < side_.size(); ++f)
      result.push_back(side_[f] == OPEN ? quantized(values[row[node_[f]]])
                                        : side_[f] == 0 ? 1024 : 0);
    return result;
  }

  // Sets the side of a face and of all faces of its group, unless they have one.
  void set_side(Index f, char side)
  {
    if (side_[f] == OPEN)
      for (Index g = 0; g < side_.size(); ++g)
        if (node_[g] == node_[f])
          side_[g] = side;
  }

  void set_sides_by_current(const std::vector<Face_pair>& pairs)
  {
    const std::vector<double> potential = potentials();
    for (const auto& [f, g] : pairs) {
      set_side(f, potential[f] > potential[g] ? 0 : 1);
      set_side(g, potential[f] > potential[g] ? 1 : 0);
    }
  }

  // Takes the best cut in the order of the potentials. The border of the side with less border
  // counts as a part of the cut, because a corner beside another region would otherwise cost
  // little. Cuts with sides that are too small come last.
  void cut_along_order()
  {
    struct Step // the increments when the faces of a potential join the first side
    {
      double area = 0, border = 0, cost = 0;
    };
    const std::vector<double> potential = potentials();
    std::map<double, Step, std::greater<double> > steps;
    Step rest, sum;
    for (Index f = 0; f < side_.size(); ++f) {
      Step& step = steps[potential[f]];
      step.area += part_.areas[f];
      step.border += border_[f];
      rest.area += part_.areas[f];
      rest.border += border_[f];
    }
    for (Index h = 0; h < part_.number_of_halfedges(); ++h) {
      const double first = potential[h / 3], second = potential[part_.neighbor(h)];
      if (first > second) {
        steps[first].cost += capacity(part_, h);
        steps[second].cost -= capacity(part_, h);
      }
    }
    const double last = steps.rbegin()->first;
    std::pair<bool, double> best(true, std::numeric_limits<double>::infinity());
    double smallest_potential = 0; // the smallest one on the first side
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
    for (Index f = 0; f < side_.size(); ++f)
      side_[f] = potential[f] >= smallest_potential ? 0 : 1;
  }

  // Replaces the cut by the minimum cut near it, unless that falls into more pieces.
  void refine()
  {
    double area[2] = {0, 0};
    std::vector<char> is_fixed;
    for (Index f = 0; f < side_.size(); ++f) {
      area[int(side_[f])] += part_.areas[f];
      is_fixed.push_back(group_[f] != null_index);
    }
    const Sides refined =
      minimum_cut_around(part_, side_, (std::min)(area[0], area[1]), is_fixed);
    if (connected_components(part_, refined).number <= connected_components(part_, side_).number)
      side_ = refined;
  }

public:
  // `group` holds the group of each face, or null_index. `border` holds the length of each face
  // along other regions. The cut avoids sides smaller than `minimum_area`.
  Constrained_cut(const Surface& part, const std::vector<Index>& group,
                  const std::vector<double>& border, double minimum_area)
    : part_(part), group_(group), border_(border), minimum_area_(minimum_area),
      side_(part.number_of_faces(), OPEN)
  {
    std::map<Index, Index> first; // the first face of each group
    for (Index f = 0; f < group.size(); ++f)
      node_.push_back(group[f] == null_index ? f : first.emplace(group[f], f).first->second);
  }

  // Separates the first pair of faces, which are of different groups, and if possible also the
  // other pairs, whose sides the potential determines. Returns the pieces into which the region
  // falls, as one of the faces of its piece for each face. If the part has no weights, the first
  // group is cut off.
  std::vector<Index> operator()(const std::vector<Face_pair>& pairs)
  {
    set_side(pairs.front()[0], 0);
    set_side(pairs.front()[1], 1);
    set_sides_without_current();
    if (part_.weights.empty())
      std::replace(side_.begin(), side_.end(), char(OPEN), char(1));
    else {
      if (pairs.size() > 1)
        set_sides_by_current(pairs);
      cut_along_order();
      refine();
    }
    return pieces(true);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_CUT_H
