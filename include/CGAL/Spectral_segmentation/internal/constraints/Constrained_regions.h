// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_REGIONS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_REGIONS_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Region_graph.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Potential_cut.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/Dendrogram.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut.h>
#include <CGAL/Spectral_segmentation/internal/surface/submesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Makes regions that fulfill the constraints from the leaves of a dendrogram: each group of faces in
// one of them, and no two groups together that must not be.
class Constrained_regions
{
  const Execution execution_;
  const Surface& surface_;
  const Distance_weights weights_;
  const double minimum_area_;
  Run_monitor& monitor_;
  Face_groups& groups_;

  Submesh_extractor extractor_;
  std::vector<Index> region_;            // of each face
  std::vector<std::set<Index> > leaves_; // of each region, from which it was made
  std::vector<char> is_split_;           // whether a region was cut off by a constraint

  Region_graph graph() const
  { return Region_graph(surface_, region_, leaves_.size(), groups_); }

  Index add_region(Index like)
  {
    leaves_.push_back(std::set<Index>(leaves_[like]));
    is_split_.push_back(1);
    return static_cast<Index>(leaves_.size() - 1);
  }

  // Lets a group without a seed go to the region that has most of its area.
  void move_groups()
  {
    const std::vector<Index> old_region = region_;
    std::vector<std::map<Index, double> > areas(groups_.number);
    const auto is_moved = [&](Index f)
    { return groups_.group[f] != null_index && groups_.seed(f) == null_index; };
    for (Index f = 0; f < region_.size(); ++f)
      if (is_moved(f))
        areas[groups_.group[f]][region_[f]] += surface_.areas[f];
    for (Index f = 0; f < region_.size(); ++f)
      if (is_moved(f)) {
        const auto& of_group = areas[groups_.group[f]];
        region_[f] = std::max_element(of_group.begin(), of_group.end(), [](auto& a, auto& b)
                                      { return a.second < b.second; })->first;
      }
    if (region_ != old_region)
      join_loose_pieces(old_region);
  }

  // Lets what a region lost the connection with go to the neighbor with the longest common boundary;
  // the largest piece of what was connected before stays. What has no neighbor but over seams
  // becomes a region.
  void join_loose_pieces(const std::vector<Index>& old_region)
  {
    const auto components = [this](const std::vector<Index>& label)
    { return connected_components(surface_, [&](Index f) { return label[f]; }); };
    const Components old_piece = components(old_region), piece = components(region_);
    std::vector<Index> piece_of_face, region_of_piece(piece.number);
    for (Index f = 0; f < region_.size(); ++f) {
      piece_of_face.push_back(piece[f]);
      region_of_piece[piece[f]] = region_[f];
    }
    const Region_graph pieces(surface_, piece_of_face, piece.number, groups_);
    std::vector<Index> largest(old_piece.number, null_index);
    for (Index f = 0; f < region_.size(); ++f)
      if (Index& kept = largest[old_piece[f]]; region_[f] == old_region[f] &&
          (kept == null_index || pieces.area(piece[f]) > pieces.area(kept)))
        kept = piece[f];
    std::vector<char> is_settled(piece.number, 0);
    for (Index kept : largest)
      if (kept != null_index)
        is_settled[kept] = 1;
    std::vector<Index> loose;
    for (Index p = 0; p < piece.number; ++p)
      if (!is_settled[p])
        loose.push_back(p);
    for (bool has_changed = true; std::exchange(has_changed, false);)
      for (Index p : loose)
        if (!is_settled[p]) {
          const Index to =
            pieces.longest_neighbor(p, [&](Index q) { return is_settled[q] != 0; }).first;
          if (to == null_index)
            continue;
          region_of_piece[p] = region_of_piece[to];
          is_settled[p] = 1;
          has_changed = true;
        }
    for (Index p : loose)
      if (!is_settled[p])
        region_of_piece[p] = add_region(region_of_piece[p]);
    for (Index f = 0; f < region_.size(); ++f)
      region_[f] = region_of_piece[piece[f]];
  }

  // Takes paths into the group of a seed so that it is connected, unless other groups, seams or
  // regions of other seeds are in the way: over the fewest regions, then over the fewest faces.
  void connect(const std::vector<Index>& members, const std::vector<char>& has_other_seed)
  {
    typedef std::tuple<std::size_t, std::size_t, Index, Index> Entry; // numbers of regions and of
                                                                      // faces, face, previous one
    std::vector<Index>& group = groups_.group;
    const Index seed = group[members.front()];
    std::vector<Index> previous(region_.size(), null_index);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    queue.push({0, 0, members.front(), members.front()});
    for (std::size_t missing = members.size(); missing > 0 && !queue.empty();) {
      const auto [regions, faces, f, before] = queue.top();
      queue.pop();
      if (previous[f] != null_index)
        continue;
      previous[f] = before;
      missing -= group[f] == seed;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = surface_.neighbor(h);
        const bool is_free = group[g] == null_index && !has_other_seed[region_[g]];
        if (previous[g] == null_index && !groups_.is_seam[h] && (is_free || group[g] == seed))
          queue.push({regions + (region_[f] != region_[g]), faces + is_free, g, f});
      }
    }
    for (Index f : members)
      if (previous[f] != null_index)
        for (Index on_path = f; group[on_path = previous[on_path]] != seed;)
          group[on_path] = seed;
  }

  void connect_seeds()
  {
    std::vector<std::vector<Index> > members(groups_.number_of_seeds);
    std::vector<std::set<Index> > seeds(leaves_.size()); // of each region
    for (Index f = 0; f < region_.size(); ++f)
      if (groups_.seed(f) != null_index) {
        members[groups_.seed(f)].push_back(f);
        seeds[region_[f]].insert(groups_.seed(f));
      }
    for (Index seed = 0; seed < members.size(); ++seed) {
      std::vector<char> has_other_seed;
      for (const std::set<Index>& of_region : seeds)
        has_other_seed.push_back(!of_region.empty() && !of_region.count(seed));
      connect(members[seed], has_other_seed);
    }
  }

  // A region as a surface whose seams are open.
  struct Part
  {
    std::vector<Index> faces;   // of the surface, ascending
    std::vector<Index> group;   // of each face
    std::vector<double> border; // length of each face along other regions
    Surface surface;
    std::vector<Index> seams;   // its half-edges
  };

  Part part_of(Index region)
  {
    Part part;
    for (Index f = 0; f < region_.size(); ++f)
      if (region_[f] == region) {
        part.faces.push_back(f);
        part.group.push_back(groups_.group[f]);
      }
    part.surface = extractor_(part.faces);
    part.border.assign(part.faces.size(), 0);
    for (Index h = 0; h < part.surface.number_of_halfedges(); ++h) {
      const Index h_of_surface = 3 * part.faces[h / 3] + h % 3;
      const bool is_inside = !part.surface.is_border(h);
      if (is_inside && groups_.is_seam[h_of_surface])
        part.seams.push_back(h);
      else if (!is_inside && !surface_.is_border(h_of_surface) && !groups_.is_seam[h_of_surface])
        part.border[h / 3] += part.surface.length(h);
    }
    return part;
  }

  // The faces along the two sides of the seams that go on from the one between two faces; or these
  // faces themselves. Around each vertex where two seams or more meet, the faces between them are on
  // one side.
  static std::array<std::vector<Index>, 2> terminals(const Part& part, const Face_pair& pair)
  {
    const Surface& s = part.surface;
    std::vector<unsigned char> is_seam(s.number_of_halfedges(), 0);
    std::vector<Index> number(s.points.size(), 0); // of half-edges of seams at each vertex
    for (Index h : part.seams) {
      is_seam[h] = 1;
      ++number[s.source(h)];
      ++number[s.target(h)];
    }
    Joined_sets sides(s.number_of_faces());
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
      if (!is_seam[h] && (number[s.source(h)] > 2 || number[s.target(h)] > 2))
        sides.join(h / 3, s.neighbor(h));
    std::array<std::vector<Index>, 2> result = {{{pair[0]}, {pair[1]}}};
    if (sides[pair[0]] != sides[pair[1]])
      for (Index h : part.seams)
        for (int k : {0, 1})
          if (sides[h / 3] == sides[pair[k]])
            result[k].push_back(h / 3);
    return result;
  }

  // Splits the region of two faces that must be apart.
  void split(const Face_pair& pair)
  {
    const Index region = region_[pair[0]];
    Part part = part_of(region);
    const auto number_in_part = [&](Index f) {
      return static_cast<Index>(
        std::lower_bound(part.faces.begin(), part.faces.end(), f) - part.faces.begin());
    };
    const std::array<std::vector<Index>, 2> of_terminals =
      terminals(part, {number_in_part(pair[0]), number_in_part(pair[1])});
    for (Index h : part.seams)
      part.surface.opposite[h] = h;
    const bool has_time = monitor_.go_further();
    const Sides side = Potential_cut(part.surface, part.group, part.border, minimum_area_)(
      of_terminals, weights_, has_time);
    Components pieces = pieces_of_sides(part, side);
    if (has_time) {
      Components smooth = pieces_of_sides(part, smoothed(part, side));
      if (smooth.number <= pieces.number)
        pieces = std::move(smooth);
    }
    std::vector<Index> region_of_piece(1, region);
    while (region_of_piece.size() < pieces.number)
      region_of_piece.push_back(add_region(region));
    is_split_[region] = 1;
    for (std::size_t i = 0; i < part.faces.size(); ++i)
      region_[part.faces[i]] = region_of_piece[pieces[i]];
  }

  // The faces but those of groups near the cut between the sides, ring by ring.
  static std::vector<Index> faces_near_cut(const Part& part, const Sides& side)
  {
    constexpr std::size_t largest_number = 3000;
    const Surface& s = part.surface;
    double area[2] = {0, 0};
    for (std::size_t f = 0; f < side.size(); ++f)
      area[int(side[f])] += s.areas[f];
    const double smaller = (std::min)(area[0], area[1]), all = area[0] + area[1];
    // A ring is about as wide as the root of a face.
    const double number_of_rings = all > 0
      ? neighborhood_radius * std::sqrt(smaller / all * static_cast<double>(side.size())) : 0;
    std::vector<Index> result;
    std::vector<char> is_reached(side.size(), 0);
    const auto reach = [&](Index f) {
      if (!std::exchange(is_reached[f], char(1)) && part.group[f] == null_index)
        result.push_back(f);
    };
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
      if (side[h / 3] != side[s.neighbor(h)])
        reach(h / 3);
    std::size_t begin = 0, end = result.size();
    for (double ring = 1; ring < number_of_rings && result.size() < largest_number; ++ring) {
      for (; begin < end; ++begin)
        for (Index h = 3 * result[begin]; h < 3 * result[begin] + 3; ++h)
          if (side[s.neighbor(h)] == side[h / 3])
            reach(s.neighbor(h));
      end = result.size();
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  // Moves a cut to the minimum cut near it.
  Sides smoothed(const Part& part, Sides side) const
  {
    const Surface& s = part.surface;
    const std::vector<Index> free = faces_near_cut(part, side);
    std::vector<char> is_free(side.size(), 0);
    for (Index f : free)
      is_free[f] = 1;
    std::vector<Index> faces, band; // those that are free and next to them; the places of the free
    Sides old;
    for (Index f = 0; f < side.size(); ++f)
      if (is_free[f] || is_free[s.neighbor(3 * f)] || is_free[s.neighbor(3 * f + 1)] ||
          is_free[s.neighbor(3 * f + 2)]) {
        if (is_free[f])
          band.push_back(static_cast<Index>(faces.size()));
        faces.push_back(f);
        old.push_back(side[f]);
      }
    Surface near = Submesh_extractor(s)(faces);
    Distance_weights weights = weights_;
    const double area = total_area(near); // to which the radius is relative
    weights.concavity_radius *= area > 0 ? std::sqrt(total_area(surface_) / area) : 0;
    set_face_distances(execution_, near, near.points, face_normals(execution_, near, near.points),
                       weights);
    const Sides moved = minimum_cut_within(near, band, old);
    for (Index i : band)
      side[faces[i]] = moved[i];
    return side;
  }

  // The connected pieces of the sides of a part. Groups stay whole.
  static Components pieces_of_sides(const Part& part, const Sides& side)
  {
    const std::size_t n = part.faces.size();
    Joined_sets pieces(n);
    std::map<Index, Index> first; // face of each group
    for (Index f = 0; f < n; ++f)
      if (part.group[f] != null_index)
        pieces.join(f, first.emplace(part.group[f], f).first->second);
    for (Index h = 0; h < part.surface.number_of_halfedges(); ++h)
      if (side[h / 3] == side[part.surface.neighbor(h)])
        pieces.join(h / 3, part.surface.neighbor(h));
    return numbered_sets(pieces, n);
  }

  // Two faces of one region that must be apart.
  std::optional<Face_pair> find_conflict() const
  {
    for (const Face_pair& pair : groups_.seams)
      if (region_[pair[0]] == region_[pair[1]])
        return pair;
    std::vector<Index> first(leaves_.size(), null_index); // face with a seed of each region
    for (Index f = 0; f < region_.size(); ++f)
      if (groups_.seed(f) != null_index) {
        Index& g = first[region_[f]];
        g = g == null_index ? f : g;
        if (groups_.seed(g) != groups_.seed(f))
          return Face_pair{g, f};
      }
    return std::nullopt;
  }

  void split_all()
  {
    while (const std::optional<Face_pair> pair = find_conflict())
      split(*pair);
  }

  void merge(Region_graph& graph, Index a, Index b)
  {
    const Index into = graph.merge(a, b), from = into == a ? b : a;
    leaves_[into].merge(leaves_[from]);
    is_split_[into] |= is_split_[from];
  }

  void set_merged_regions(Region_graph& graph)
  {
    for (Index& r : region_)
      r = graph[r];
  }

  // The regions with the same seed become one.
  void join_seeds()
  {
    Region_graph regions = graph();
    std::vector<Index> first(groups_.number_of_seeds, null_index); // face
    for (Index f = 0; f < region_.size(); ++f)
      if (const Index seed = groups_.seed(f); seed != null_index) {
        first[seed] = (std::min)(first[seed], f);
        const Index a = regions[region_[first[seed]]], b = regions[region_[f]];
        if (a != b)
          merge(regions, a, b);
      }
    set_merged_regions(regions);
  }

  // A strip that is left between a seam and the boundary of another region near it belongs to that
  // region: the seam is meant to be the boundary.
  void join_strips(Region_graph& graph)
  {
    constexpr double largest_area = 0.1; // relative to the square of the length
    for (Index r = 0; r < is_split_.size(); ++r) {
      const auto [neighbor, length] = graph.longest_neighbor(r, [](Index) { return true; });
      if (is_split_[r] && graph.area(r) < largest_area * length * length)
        merge(graph, r, neighbor);
    }
    set_merged_regions(graph);
  }

public:
  Constrained_regions(Execution execution, const Dendrogram& d, const Surface& surface,
                      const Distance_weights& weights, double minimum_segment_size,
                      Run_monitor& monitor, Face_groups& groups)
    : execution_(execution), surface_(surface), weights_(weights),
      minimum_area_(minimum_segment_size * total_area(surface)), monitor_(monitor),
      groups_(groups), extractor_(surface), region_(d.leaf), is_split_(d.number_of_leaves(), 0)
  {
    for (Index leaf = 0; leaf < d.number_of_leaves(); ++leaf)
      leaves_.push_back({leaf});
  }

  // Returns the regions.
  Region_graph operator()(bool components_apart)
  {
    move_groups();
    connect_seeds();
    split_all();
    join_seeds();
    split_all();
    Region_graph result = graph();
    join_strips(result);
    if (!components_apart && surface_.components.number > 1)
      result.close_gaps(surface_, region_);
    return result;
  }

  const std::vector<Index>& region_of_faces() const { return region_; }
  const std::vector<std::set<Index> >& leaves() const { return leaves_; } // of each region
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_REGIONS_H
