// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_REGION_GRAPH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_REGION_GRAPH_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/grid/set_contacts.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Constraint_groups.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Stores the regions of a mesh while they are merged, which of them touch, and which must stay
// apart. Merged regions are identified by the lowest of their indices.
class Region_graph
{
  struct Contact
  {
    double length = 0; // the length of the common boundary without cannot-link edges
    bool is_apart = false;
  };

  struct Region
  {
    double area = 0;
    Index seed = null_index;
    std::map<Index, Contact> contacts;
  };

  std::vector<Region> regions_;
  std::vector<Index> merged_into_;

  void add_contact(Index a, Index b, const Contact& contact)
  {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      Contact& both = regions_[from].contacts[to];
      both.length += contact.length;
      both.is_apart |= contact.is_apart;
    }
  }

public:
  Region_graph(const Surface& mesh, const std::vector<Index>& region, std::size_t number,
               const Constraint_groups& groups)
    : regions_(number), merged_into_(number)
  {
    std::iota(merged_into_.begin(), merged_into_.end(), Index(0));
    for (Index f = 0; f < region.size(); ++f) {
      regions_[region[f]].area += mesh.areas[f];
      regions_[region[f]].seed = (std::min)(regions_[region[f]].seed, groups.seed(f));
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = mesh.neighbor(h);
        if (f < g && region[f] != region[g] && !groups.is_seam[h])
          add_contact(region[f], region[g], {mesh.length(h), false});
      }
    }
    for (const auto& [f, g] : groups.cannot_link)
      if (region[f] != region[g])
        add_contact(region[f], region[g], {0, true});
  }

  // Adds contacts along a minimum spanning tree of the regions if the mesh has several components,
  // so that regions of different components can be merged.
  void close_gaps(const Surface& mesh, const std::vector<Index>& region,
                  const Step_counter& count_steps)
  {
    if (mesh.components.number == 1)
      return;
    std::vector<Index> number(regions_.size(), null_index), region_of_number, set;
    for (Index r : region) {
      if (number[r] == null_index) {
        number[r] = static_cast<Index>(region_of_number.size());
        region_of_number.push_back(r);
      }
      set.push_back(number[r]);
    }
    for (const auto& [a, b] :
         nearest_sets_of_faces(mesh, set, region_of_number.size(), count_steps))
      add_contact(region_of_number[a], region_of_number[b], {});
  }

  std::size_t number() const { return regions_.size(); }
  double area(Index a) const { return regions_[a].area; }
  Index seed(Index a) const { return regions_[a].seed; }

  Index representative(Index a) const
  {
    while (merged_into_[a] != a)
      a = merged_into_[a];
    return a;
  }

  std::set<Index> representatives(const std::set<Index>& regions) const
  {
    std::set<Index> result;
    for (Index a : regions)
      result.insert(representative(a));
    return result;
  }

  bool are_apart(Index a, Index b) const
  {
    const auto contact = regions_[a].contacts.find(b);
    return (contact != regions_[a].contacts.end() && contact->second.is_apart) ||
           (seed(a) != null_index && seed(b) != null_index && seed(a) != seed(b));
  }

  // Returns the mergeable pair of adjacent `regions` with the longest common boundary; null_index
  // twice if there is none.
  Face_pair longest_boundary(const std::set<Index>& regions) const
  {
    Face_pair result = {null_index, null_index};
    double longest = -1;
    for (Index a : regions)
      for (const auto& [b, contact] : regions_[a].contacts)
        if (a < b && quantized(contact.length) > longest && regions.count(b) && !are_apart(a, b)) {
          longest = quantized(contact.length);
          result = {a, b};
        }
    return result;
  }

  // Returns the neighbor of a region that can be merged with it and has the longest common
  // boundary, and the length of this boundary; null_index and 0 if there is none.
  std::pair<Index, double> longest_neighbor(Index a) const
  {
    std::pair<Index, double> result(null_index, 0);
    for (const auto& [b, contact] : regions_[a].contacts)
      if (contact.length > result.second && !are_apart(a, b))
        result = {b, contact.length};
    return result;
  }

  void merge(Index a, Index b)
  {
    const auto [into, from] = std::minmax(a, b);
    const Region other = std::exchange(regions_[from], Region());
    merged_into_[from] = into;
    regions_[into].area += other.area;
    regions_[into].seed = (std::min)(regions_[into].seed, other.seed);
    for (const auto& [c, contact] : other.contacts) {
      regions_[c].contacts.erase(from);
      if (c != into)
        add_contact(into, c, contact);
    }
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_REGION_GRAPH_H
