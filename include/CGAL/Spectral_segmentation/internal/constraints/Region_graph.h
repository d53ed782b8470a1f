// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_REGION_GRAPH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_REGION_GRAPH_H

#include <CGAL/Spectral_segmentation/internal/constraints/Constraints.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/gaps.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Regions of a surface, as they are merged: which of them touch, and which must stay apart. A merged
// region is known by one of its regions.
class Region_graph
{
  struct Contact
  {
    double length = 0; // of the common boundary without seams
    bool is_apart = false;
  };

  struct Region
  {
    double area = 0;
    Index seed = null_index;
    std::map<Index, Contact> contacts;
  };

  std::vector<Region> regions_;
  Joined_sets merged_;

  void add_contact(Index a, Index b, const Contact& contact)
  {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      Contact& both = regions_[from].contacts[to];
      both.length += contact.length;
      both.is_apart |= contact.is_apart;
    }
  }

public:
  Region_graph(const Surface& surface, const std::vector<Index>& region, std::size_t number,
               const Face_groups& groups)
    : regions_(number), merged_(number)
  {
    for (Index f = 0; f < region.size(); ++f) {
      regions_[region[f]].area += surface.areas[f];
      regions_[region[f]].seed = (std::min)(regions_[region[f]].seed, groups.seed(f));
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (const Index g = surface.neighbor(h); f < g && region[f] != region[g])
          add_contact(region[f], region[g], {groups.is_seam[h] ? 0 : surface.length(h), false});
    }
    for (const auto& [f, g] : groups.seams)
      if (region[f] != region[g])
        add_contact(region[f], region[g], {0, true});
  }

  // Regions of several components of the surface touch the nearest ones, too.
  void close_gaps(const Surface& surface, std::vector<Index> region)
  {
    const std::vector<Index> old = number_by_first_faces(region);
    for (const Gap& gap : narrowest_gaps(surface, region, old.size()))
      add_contact(old[gap.sets[0]], old[gap.sets[1]], {});
  }

  Index operator[](Index a) { return merged_[a]; } // the region by which it is known
  double area(Index a) const { return regions_[a].area; }

  bool are_apart(Index a, Index b) const
  {
    const auto contact = regions_[a].contacts.find(b);
    const Index s = regions_[a].seed, t = regions_[b].seed;
    return (contact != regions_[a].contacts.end() && contact->second.is_apart) ||
           (s != null_index && t != null_index && s != t);
  }

  // Of the neighbors among some regions that can be merged the two with the longest common
  // boundary.
  std::optional<std::pair<Index, Index> > longest_boundary(const std::set<Index>& regions) const
  {
    std::optional<std::pair<Index, Index> > result;
    double longest = -1;
    for (Index a : regions)
      for (const auto& [b, contact] : regions_[a].contacts)
        if (a < b && quantized(contact.length) > longest && regions.count(b) && !are_apart(a, b)) {
          longest = quantized(contact.length);
          result = {a, b};
        }
    return result;
  }

  // Of the neighbors of a region for which is_possible(b) is true, and which can be merged with it,
  // that with the longest common boundary, and its length; or null_index.
  template <class IsPossible>
  std::pair<Index, double> longest_neighbor(Index a, const IsPossible& is_possible) const
  {
    std::pair<Index, double> result(null_index, 0);
    for (const auto& [b, contact] : regions_[a].contacts)
      if (contact.length > result.second && is_possible(b) && !are_apart(a, b))
        result = {b, contact.length};
    return result;
  }

  // Two regions, each known by itself. Returns by which of them they are known.
  Index merge(Index a, Index b)
  {
    merged_.join(a, b);
    const Index into = merged_[a], from = into == a ? b : a;
    const Region other = std::exchange(regions_[from], Region());
    regions_[into].area += other.area;
    regions_[into].seed = (std::min)(regions_[into].seed, other.seed);
    for (const auto& [c, contact] : other.contacts) {
      regions_[c].contacts.erase(from);
      if (c != into)
        add_contact(into, c, contact);
    }
    return into;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_REGION_GRAPH_H
