// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_CUT_PROPOSALS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_CUT_PROPOSALS_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/search/line_search.h>
#include <CGAL/Spectral_segmentation/internal/search/minimum_cut.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A patch with the capacity of its cut.
class Patch_with_capacity : public Patch
{
  const std::vector<double>& capacities_;
  double capacity_of_cut_ = 0;

public:
  // Makes an empty patch; `capacities` holds one per halfedge.
  Patch_with_capacity(const Surface& part, const std::vector<double>& capacities)
    : Patch(part), capacities_(capacities) {}

  void add(Index f)
  {
    Patch::add(f, [&](Index h, int sign)
      { capacity_of_cut_ += sign * capacities_[h]; });
  }

  double capacity_of_cut() const { return capacity_of_cut_; }
};

struct Sweep_step
{
  std::size_t size; // the size of the meta patch
  double area;
  double smaller_area;
  // These are quantized, so that rounding does not choose between cuts that mirror each other.
  double salience, cheapness;
};

inline std::vector<Sweep_step> sweep_steps(const Surface& part, const Growth& growth,
                                           double minimum_area, Patch_with_capacity empty)
{
  const Weighted_part_salience part_salience;
  std::vector<Sweep_step> steps;
  for_each_cut(
    growth.faces, sizes_of_cuts(part, growth), minimum_area,
    std::move(empty),
    [&](const Patch_with_capacity& q, std::size_t size) {
      if (q.area() > constants::largest_ratio_to_rest * q.area_of_rest())
        return false;
      steps.push_back({size, q.area(), q.smaller_area(), quantized(part_salience(q.factors())),
                       quantized(-q.capacity_of_cut() / std::sqrt(q.smaller_area()))});
      return true;
    });
  return steps;
}

// Returns the cuts of the two best steps by a measure, the second not next to the first.
inline std::vector<Sides> best_steps(const Growth& growth, const std::vector<Sweep_step>& steps,
                                        double Sweep_step::*measure)
{
  const Sweep_step* best[2] = {nullptr, nullptr};
  for (int i = 0; i < 2; ++i)
    for (const Sweep_step& s : steps) {
      const bool is_next_to_first =
        i == 1 && std::abs(s.area - best[0]->area) <
                    constants::distance_of_proposals * best[0]->smaller_area;
      if (!is_next_to_first && (!best[i] || s.*measure > best[i]->*measure))
        best[i] = &s;
    }
  std::vector<Sides> result;
  for (const Sweep_step* s : best)
    if (s)
      result.push_back(sides_of(growth, s->size));
  return result;
}

// Returns the best cuts along an order by two measures: the salience of the paper, and cheapness,
// which is minus the capacity of the cut over the length scale of its smaller side.
inline std::vector<Sides> propose_cuts(const Surface& part, const std::vector<Index>& order,
                                       double minimum_area, const Patch_with_capacity& empty)
{
  const Growth growth = grow_along(part, order);
  const std::vector<Sweep_step> steps = sweep_steps(part, growth, minimum_area, empty);
  std::vector<Sides> result = best_steps(growth, steps, &Sweep_step::salience);
  for (Sides& side : best_steps(growth, steps, &Sweep_step::cheapness))
    result.push_back(std::move(side));
  return result;
}

// Checks whether a cut is new among the cuts that it was given: the faces on which two cuts differ
// must not be few compared with the smallest side of either.
class Distinct_cuts
{
  struct Sized_cut
  {
    Sides side;
    std::size_t smaller; // number of faces
  };

  std::vector<Sized_cut> cuts_;

  static std::size_t smaller(std::size_t number, std::size_t n)
  { return (std::min)(number, n - number); }

  static bool are_alike(const Sized_cut& a, const Sized_cut& b)
  {
    const std::size_t n = a.side.size();
    std::size_t different = 0;
    for (std::size_t f = 0; f < n; ++f)
      different += a.side[f] != b.side[f];
    return 100 * smaller(different, n) <
           constants::percent_of_alike_proposals * (std::min)(a.smaller, b.smaller);
  }

public:
  bool insert(const Sides& side)
  {
    const std::size_t number = std::count(side.begin(), side.end(), 1);
    const Sized_cut cut{side, smaller(number, side.size())};
    for (const Sized_cut& other : cuts_)
      if (are_alike(cut, other))
        return false;
    cuts_.push_back(cut);
    return true;
  }
};

// Returns the best cuts along several orders, no two alike. The larger side may be first.
inline std::vector<Sides> cut_proposals(Execution execution, const Surface& part,
                                        const std::vector<std::vector<Index> >& orders,
                                        double minimum_area)
{
  std::vector<double> capacities(part.number_of_halfedges());
  for (Index h = 0; h < part.number_of_halfedges(); ++h)
    capacities[h] = capacity(part, h);
  const Patch_with_capacity empty(part, capacities);
  std::vector<std::vector<Sides> > proposals(orders.size());
  for_each_index(execution, orders.size(), [&](std::size_t i)
    { proposals[i] = propose_cuts(part, orders[i], minimum_area, empty); });
  std::vector<Sides> result;
  Distinct_cuts distinct;
  for (std::vector<Sides>& along_order : proposals)
    for (Sides& side : along_order)
      if (distinct.insert(side))
        result.push_back(std::move(side));
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_CUT_PROPOSALS_H
