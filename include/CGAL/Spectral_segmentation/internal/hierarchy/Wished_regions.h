// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISHED_REGIONS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISHED_REGIONS_H

#include <CGAL/Spectral_segmentation/internal/distances/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Seam_sides.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Wish_groups.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Wished_cut.h>
#include <CGAL/Spectral_segmentation/internal/mesh/extract_part.h>
#include <CGAL/Spectral_segmentation/internal/mesh/surface_integrals.h>
#include <CGAL/Spectral_segmentation/internal/utility/Run_monitor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The salience of the lowest cut that has two leaves on different sides.
inline double salience_between(const Cut_hierarchy& cuts, std::size_t a, std::size_t b)
{
  if (a == b)
    return -std::numeric_limits<double>::infinity();
  while (a != b) { // parents come before their children
    std::size_t& later = a > b ? a : b;
    later = cuts.nodes[later].parent;
    if (later == null_node)
      return std::numeric_limits<double>::infinity();
  }
  return cuts.nodes[a].salience;
}

// Makes regions that fulfill wishes from the leaves of a hierarchy: each group of faces in one of
// them, and no two groups together that must not be.
class Wished_regions
{
  typedef std::vector<Index> Faces;

  const Execution execution_;
  const Cut_hierarchy& cuts_;
  const Face_graph& mesh_;
  const Distance_weights weights_;
  const double minimum_area_;
  Run_monitor& monitor_;
  Wish_groups& groups_;

  const Seam_sides seam_sides_;
  Part_extractor extractor_;
  std::vector<Faces> members_;      // of each group
  std::vector<Index> region_;       // of each face
  std::vector<Faces> faces_;        // of each region, ascending
  std::vector<std::set<std::size_t> > leaves_; // of each region
  std::vector<char> is_split_;      // whether a region was cut off by a wish
  std::vector<Index> previous_;     // of each face, on a path; null_index between searches

  void set_faces()
  {
    for (Faces& faces : faces_)
      faces.clear();
    for (Index f = 0; f < region_.size(); ++f)
      faces_[region_[f]].push_back(f);
  }

  // A region that became several pieces keeps the largest; the others go to neighbors.
  void join_loose_pieces(const std::vector<Index>& old_region)
  {
    std::size_t number_of_old, number;
    const std::vector<Index> old_piece = connected_components(mesh_, number_of_old, old_region);
    const std::vector<Index> piece = connected_components(mesh_, number, region_);
    const std::vector<double> areas = component_areas(mesh_, piece, number);
    std::vector<Index> largest(number_of_old, null_index); // piece
    std::vector<char> is_loose(number, 0);
    for (Index f = 0; f < piece.size(); ++f)
      if (region_[f] == old_region[f]) {
        Index& kept = largest[old_piece[f]];
        if (kept == null_index || areas[piece[f]] > areas[kept])
          kept = piece[f];
        is_loose[piece[f]] = 1;
      }
    for (Index kept : largest)
      if (kept != null_index)
        is_loose[kept] = 0;
    std::map<std::pair<Index, Index>, double> lengths; // of a loose piece along a region
    for (Index h = 0; h < mesh_.number_of_halfedges(); ++h) {
      const Index f = h / 3, g = mesh_.neighbors[h];
      if (is_loose[piece[f]] && !is_loose[piece[g]])
        lengths[{piece[f], region_[g]}] += mesh_.length(h);
    }
    std::vector<std::pair<double, Index> > best(number, {-1, null_index});
    for (const auto& [pair, length] : lengths)
      if (length > best[pair.first].first)
        best[pair.first] = {length, pair.second};
    for (Index f = 0; f < piece.size(); ++f)
      if (best[piece[f]].second != null_index)
        region_[f] = best[piece[f]].second;
  }

  // A group without a seed goes to the region that has most of its area.
  void move_groups()
  {
    const std::vector<Index> old_region = region_;
    for (Index i = 0; i < members_.size(); ++i) {
      if (groups_.seed[i] != null_index)
        continue;
      std::map<Index, double> areas;
      for (Index f : members_[i])
        areas[old_region[f]] += mesh_.areas[f];
      const auto is_smaller = [](const auto& a, const auto& b) { return a.second < b.second; };
      const Index largest = std::max_element(areas.begin(), areas.end(), is_smaller)->first;
      for (Index f : members_[i])
        region_[f] = largest;
    }
    if (region_ != old_region) {
      join_loose_pieces(old_region);
      set_faces();
    }
  }

  // Breadth-first search from a face of a group through its region: through faces of the group, or,
  // if `is_by_free_faces`, through those of no group, up to the next one of the group. Returns
  // what it reached, and the face at which it ended. Seams are not crossed.
  std::pair<Faces, Index> search(Faces reached, bool is_by_free_faces)
  {
    const Index group = groups_.group[reached.front()], region = region_[reached.front()];
    for (Index f : reached)
      previous_[f] = f;
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h) {
        const Index g = mesh_.neighbors[h];
        if (previous_[g] != null_index || region_[g] != region || seam_sides_.is_seam(h))
          continue;
        const bool is_of_group = groups_.group[g] == group;
        if (!is_of_group && (!is_by_free_faces || groups_.group[g] != null_index))
          continue;
        previous_[g] = reached[i];
        reached.push_back(g);
        if (is_of_group && is_by_free_faces)
          return {std::move(reached), g};
      }
    return {std::move(reached), null_index};
  }

  void forget(const Faces& reached)
  {
    for (Index f : reached)
      previous_[f] = null_index;
  }

  // Takes paths into a group so that its faces in a region are connected, unless other groups are
  // in the way.
  void connect(Index group, const Faces& faces_in_region)
  {
    std::set<Index> rest(faces_in_region.begin(), faces_in_region.end());
    while (!rest.empty()) {
      Faces reached = search(Faces(1, *rest.begin()), false).first;
      forget(reached);
      for (;;) {
        for (Index f : reached)
          rest.erase(f);
        if (rest.empty())
          return;
        const auto [all, end] = search(reached, true);
        if (end != null_index)
          for (Index f = previous_[end]; groups_.group[f] != group; f = previous_[f]) {
            groups_.group[f] = group;
            members_[group].push_back(f);
          }
        forget(all);
        if (end == null_index)
          break;
        reached = search(Faces(1, end), false).first;
        forget(reached);
      }
    }
  }

  void connect_groups()
  {
    for (Index i = 0; i < members_.size(); ++i) {
      std::map<Index, Faces> in_region;
      for (Index f : members_[i])
        in_region[region_[f]].push_back(f);
      for (const auto& entry : in_region)
        connect(i, entry.second);
    }
  }

  void add_region(const Faces& faces, const std::set<std::size_t>& leaves)
  {
    for (Index f : faces)
      region_[f] = static_cast<Index>(faces_.size());
    faces_.push_back(faces);
    leaves_.push_back(leaves);
    is_split_.push_back(1);
  }

  // The region as a graph of its own, with the distances of adjacent faces if there is time.
  Face_graph part_of(const Faces& faces)
  {
    Face_graph part = extractor_(faces);
    const double area = total_area(part);
    if (monitor_.go_further()) {
      Distance_weights weights = weights_;
      weights.concavity_radius *= area > 0 ? std::sqrt(total_area(mesh_) / area) : 0;
      set_face_distances(execution_, part, part.points,
                         face_normals(execution_, part, part.points), weights);
    }
    return part;
  }

  // Splits a region, with faces of one set on one side and those of another on the other side, or
  // at least the two faces of the pair.
  void split(Index region, const std::array<Faces, 2>& sets, const Face_pair& pair)
  {
    const Faces faces = std::move(faces_[region]);
    Face_graph part = part_of(faces);
    std::size_t number_of_components;
    connected_components(part, number_of_components);
    std::vector<Index> node;
    std::map<Index, Index> node_of_group;
    Index number_of_nodes = 0;
    std::vector<double> border(faces.size(), 0);
    for (Index i = 0; i < faces.size(); ++i) {
      const Index group = groups_.group[faces[i]];
      const auto [entry, is_new] = node_of_group.emplace(group, number_of_nodes);
      node.push_back(is_new || group == null_index ? number_of_nodes++ : entry->second);
      for (Index k = 0; k < 3; ++k) {
        const Index h = 3 * faces[i] + k;
        if (seam_sides_.is_seam(h))
          part.neighbors[3 * i + k] = i;
        else if (region_[mesh_.neighbors[h]] != region)
          border[i] += mesh_.length(h);
      }
    }
    const auto node_of = [&](Index f)
    { return node[std::lower_bound(faces.begin(), faces.end(), f) - faces.begin()]; };

    std::optional<Wished_cut> cut;
    cut.emplace(part, node, border, minimum_area_);
    bool is_consistent = true;
    for (char k : {char(0), char(1)})
      for (Index f : sets[k])
        if (region_[f] == region)
          is_consistent = cut->set_terminal(node_of(f), k) && is_consistent;
    if (!is_consistent) {
      cut.emplace(part, node, border, minimum_area_);
      for (char k : {char(0), char(1)})
        cut->set_terminal(node_of(pair[k]), k);
    }
    const Sides side = (*cut)();
    if (number_of_components > 1)
      divide(region, faces, std::vector<Index>(side.begin(), side.end()));
    else
      divide(region, faces, pieces(part, node, side));
  }

  static std::vector<Index> pieces(const Face_graph& part, const std::vector<Index>& node,
                                   const Sides& side)
  {
    Face_components sets(part.number_of_faces());
    for (Index f = 0; f < side.size(); ++f)
      sets.add(f);
    std::vector<Index> first_of_node(side.size(), null_index);
    for (Index f = 0; f < side.size(); ++f) {
      Index& first = first_of_node[node[f]];
      first = first == null_index ? f : first;
      sets.join(first, f);
    }
    for (Index h = 0; h < part.number_of_halfedges(); ++h)
      if (side[h / 3] == side[part.neighbors[h]])
        sets.join(h / 3, part.neighbors[h]);
    std::vector<Index> result;
    for (Index f = 0; f < side.size(); ++f)
      result.push_back(sets.representative(f));
    return result;
  }

  void divide(Index region, const Faces& faces, const std::vector<Index>& piece)
  {
    std::map<Index, Faces> faces_of_piece;
    for (std::size_t i = 0; i < faces.size(); ++i)
      faces_of_piece[piece[i]].push_back(faces[i]);
    faces_[region].clear();
    const std::set<std::size_t> leaves = std::exchange(leaves_[region], {});
    for (const auto& entry : faces_of_piece)
      add_region(entry.second, leaves);
  }

  // Two faces of one region that have different seeds; or null_index twice.
  Face_pair find_different_seeds() const
  {
    std::map<Index, Index> first; // face with a seed of each region
    for (const Faces& faces : members_)
      for (Index f : faces) {
        const Index seed = groups_.seed[groups_.group[f]];
        if (seed == null_index)
          break;
        const Index g = first.emplace(region_[f], f).first->second;
        if (groups_.seed[groups_.group[g]] != seed)
          return {g, f};
      }
    return {null_index, null_index};
  }

  // Until no region has what must be apart.
  void split_all()
  {
    connect_groups();
    for (Index i = 0; i < groups_.seams.size(); ++i) {
      const Face_pair& pair = groups_.seams[i];
      if (region_[pair[0]] == region_[pair[1]])
        split(region_[pair[0]], {seam_sides_.faces(i, 0), seam_sides_.faces(i, 1)}, pair);
    }
    for (Face_pair pair = find_different_seeds(); pair[0] != null_index;
         pair = find_different_seeds())
      split(region_[pair[0]], {Faces(1, pair[0]), Faces(1, pair[1])}, pair);
  }

  // The neighbors of a region, with the lengths of the common boundaries without seams.
  std::map<Index, double> boundaries(Index region) const
  {
    std::map<Index, double> result;
    for (Index f : faces_[region])
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (region_[mesh_.neighbors[h]] != region && !seam_sides_.is_seam(h))
          result[region_[mesh_.neighbors[h]]] += mesh_.length(h);
    return result;
  }

  // The regions that must be apart from one.
  std::set<Index> apart_from(Index region) const
  {
    std::set<Index> result;
    for (const auto& [f, g] : groups_.seams) {
      if (region_[f] == region)
        result.insert(region_[g]);
      if (region_[g] == region)
        result.insert(region_[f]);
    }
    std::set<Index> seeds;
    for (Index i = 0; i < members_.size(); ++i)
      if (groups_.seed[i] != null_index)
        for (Index f : members_[i])
          if (region_[f] == region)
            seeds.insert(i);
    for (Index i = 0; i < members_.size(); ++i)
      if (groups_.seed[i] != null_index && !seeds.empty() && (seeds.size() > 1 || !seeds.count(i)))
        for (Index f : members_[i])
          result.insert(region_[f]);
    return result;
  }

  double salience_between_regions(Index a, Index b) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t i : leaves_[a])
      for (std::size_t j : leaves_[b])
        result = (std::min)(result, salience_between(cuts_, i, j));
    return result;
  }

  // The regions on the way from one to the nearest of the others: the way whose most salient cut is
  // the least salient.
  std::vector<Index> path(Index from, const std::set<Index>& to) const
  {
    typedef std::tuple<double, std::size_t, Index> Entry; // salience, number of steps, region
    const std::set<Index> forbidden = apart_from(from);
    std::vector<Index> previous(faces_.size(), null_index);
    std::vector<Entry> best(faces_.size(), {std::numeric_limits<double>::infinity(),
                                            faces_.size() + 1, null_index});
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    best[from] = {-std::numeric_limits<double>::infinity(), 0, from};
    queue.push(best[from]);
    while (!queue.empty()) {
      const Entry entry = queue.top();
      const auto [salience, steps, region] = entry;
      queue.pop();
      if (entry > best[region])
        continue;
      if (to.count(region)) {
        std::vector<Index> result;
        for (Index r = region; r != null_index; r = previous[r])
          result.push_back(r);
        return result;
      }
      for (const auto& [neighbor, length] : boundaries(region)) {
        if (forbidden.count(neighbor) && !to.count(neighbor))
          continue;
        const Entry next((std::max)(salience, salience_between_regions(region, neighbor)),
                         steps + 1, neighbor);
        if (next < best[neighbor]) {
          best[neighbor] = next;
          previous[neighbor] = region;
          queue.push(next);
        }
      }
    }
    return {from, *to.begin()};
  }

  void merge(const std::vector<Index>& regions)
  {
    const Index into = *std::min_element(regions.begin(), regions.end());
    for (Index region : regions) {
      if (region == into)
        continue;
      for (Index f : faces_[region])
        region_[f] = into;
      faces_[into].insert(faces_[into].end(), faces_[region].begin(), faces_[region].end());
      faces_[region].clear();
      leaves_[into].merge(leaves_[region]);
      leaves_[region].clear();
      is_split_[into] |= is_split_[region];
    }
    std::sort(faces_[into].begin(), faces_[into].end());
  }

  // The regions with the same seed become one, with those between them.
  void merge_regions_of_seeds()
  {
    for (Index i = 0; i < members_.size(); ++i) {
      if (groups_.seed[i] == null_index)
        continue;
      for (;;) {
        std::set<Index> regions;
        for (Index f : members_[i])
          regions.insert(region_[f]);
        if (regions.size() < 2)
          break;
        const Index from = *regions.begin();
        regions.erase(from);
        merge(path(from, regions));
      }
    }
  }

  // A strip that is left between a wished seam and the boundary of another region near it belongs
  // to that region: the seam is meant to be the boundary.
  void join_strips()
  {
    constexpr double largest_area = 0.1; // relative to the square of the length
    for (Index region = 0; region < faces_.size(); ++region) {
      if (!is_split_[region] || faces_[region].empty())
        continue;
      double area = 0;
      for (Index f : faces_[region])
        area += mesh_.areas[f];
      const std::set<Index> apart = apart_from(region);
      std::pair<double, Index> longest(0, null_index);
      for (const auto& [neighbor, length] : boundaries(region))
        if (!apart.count(neighbor) && length > longest.first)
          longest = {length, neighbor};
      if (area < largest_area * longest.first * longest.first)
        merge({region, longest.second});
    }
  }

public:
  Wished_regions(Execution execution, const Cut_hierarchy& cuts, const Face_graph& mesh,
                 const Distance_weights& weights, double minimum_segment_size, Run_monitor& monitor,
                 Wish_groups& groups)
    : execution_(execution), cuts_(cuts), mesh_(mesh), weights_(weights),
      minimum_area_(minimum_segment_size * total_area(mesh)), monitor_(monitor), groups_(groups),
      seam_sides_(mesh, groups.seams), extractor_(mesh), members_(groups.seed.size()),
      previous_(mesh.number_of_faces(), null_index)
  {
    for (Index f = 0; f < groups.group.size(); ++f)
      if (groups.group[f] != null_index)
        members_[groups.group[f]].push_back(f);
    std::vector<Index> region_of_leaf(cuts.nodes.size());
    for (std::size_t i = 0; i < cuts.nodes.size(); ++i)
      if (cuts.nodes[i].is_leaf()) {
        region_of_leaf[i] = static_cast<Index>(leaves_.size());
        leaves_.push_back({i});
      }
    for (Index leaf : cuts.leaf)
      region_.push_back(region_of_leaf[leaf]);
    faces_.resize(leaves_.size());
    is_split_.assign(leaves_.size(), 0);
    set_faces();
  }

  void operator()()
  {
    move_groups();
    split_all();
    merge_regions_of_seeds();
    split_all();
    join_strips();
  }

  const Seam_sides& seam_sides() const { return seam_sides_; }
  const std::vector<Index>& region_of_faces() const { return region_; }
  const std::vector<Faces>& faces() const { return faces_; } // of each region; maybe none
  const std::vector<std::set<std::size_t> >& leaves() const { return leaves_; }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISHED_REGIONS_H
