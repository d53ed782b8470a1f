// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_REGIONS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_REGIONS_H

#include <CGAL/Spectral_segmentation/internal/distances/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/surface/extract_part.h>
#include <CGAL/Spectral_segmentation/internal/surface/surface_integrals.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Region_graph.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Constrained_cut.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Makes regions that satisfy constraints from the leaves of a hierarchy. Each group of faces lies
// in one region, and groups that must be apart lie in different regions.
class Constrained_regions
{
  const Execution execution_;
  const Surface& mesh_;
  const Distance_weights weights_;
  const double minimum_area_;
  Run_monitor& monitor_;
  Constraint_groups& groups_;

  Part_extractor extractor_;
  std::vector<Index> region_;                  // one per face
  std::vector<std::set<std::size_t> > leaves_; // the leaves from which each region was made
  std::vector<char> is_split_;                 // whether a region was cut off by a constraint

  Region_graph graph() const
  { return Region_graph(mesh_, region_, leaves_.size(), groups_); }

  // Moves each group without a seed to the region that has most of its area.
  void move_groups()
  {
    const std::vector<Index> old_region = region_;
    std::vector<std::map<Index, double> > areas(groups_.number);
    for (Index f = 0; f < region_.size(); ++f)
      if (groups_.group[f] != null_index && groups_.seed(f) == null_index)
        areas[groups_.group[f]][region_[f]] += mesh_.areas[f];
    const auto is_smaller = [](const auto& a, const auto& b) { return a.second < b.second; };
    for (Index f = 0; f < region_.size(); ++f)
      if (groups_.group[f] != null_index && groups_.seed(f) == null_index) {
        const auto& of_group = areas[groups_.group[f]];
        region_[f] = std::max_element(of_group.begin(), of_group.end(), is_smaller)->first;
      }
    if (region_ != old_region)
      join_loose_pieces(old_region);
  }

  // Gives all pieces but the largest to neighbors if a region fell into several pieces.
  void join_loose_pieces(const std::vector<Index>& old_region)
  {
    const Components old_piece = connected_components(mesh_, old_region);
    const Components piece = connected_components(mesh_, region_);
    const Region_graph pieces(mesh_, piece.of_all(region_.size()), piece.number, groups_);
    std::vector<Index> largest(old_piece.number, null_index), region_of_piece(piece.number);
    std::vector<char> is_loose(piece.number, 0);
    for (Index f = 0; f < region_.size(); ++f) {
      region_of_piece[piece[f]] = region_[f];
      if (region_[f] != old_region[f])
        continue;
      Index& kept = largest[old_piece[f]];
      if (kept == null_index || pieces.area(piece[f]) > pieces.area(kept))
        kept = piece[f];
      is_loose[piece[f]] = 1;
    }
    for (Index kept : largest)
      if (kept != null_index)
        is_loose[kept] = 0;
    for (Index f = 0; f < region_.size(); ++f)
      if (is_loose[piece[f]])
        if (const Index to = pieces.longest_neighbor(piece[f]).first; to != null_index)
          region_[f] = region_of_piece[to];
  }

  // Adds paths to the group of a seed so that it is connected, unless other groups, cannot-link
  // edges or regions with only other seeds are in the way. The paths run over the fewest regions,
  // then over the fewest faces.
  void connect(const std::vector<Index>& members, const std::vector<char>& has_other_seed)
  {
    // the number of regions, the number of faces, the face, and the previous face
    typedef std::tuple<std::size_t, std::size_t, Index, Index> Entry;
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
        const Index g = mesh_.neighbor(h);
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
    std::vector<std::set<Index> > seeds(leaves_.size()); // one set per region
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

  // Returns the region as a graph of its own, with the distances of adjacent faces unless the run
  // was stopped.
  Surface part_of(const std::vector<Index>& faces)
  {
    Surface part = extractor_(faces);
    const double area = total_area(part);
    if (monitor_.go_further()) {
      Distance_weights weights = weights_;
      weights.concavity_radius *= area > 0 ? std::sqrt(total_area(mesh_) / area) : 0;
      set_face_distances(execution_, part, part.points,
                         face_normals(execution_, part, part.points), weights);
    }
    return part;
  }

  // Returns the pairs of faces to separate: the first pair, and if it is at a cannot-link edge, the
  // pairs at all edges of the stroke of this edge. A stroke is a connected set of cannot-link
  // edges. `seams` holds the halfedges of the cannot-link edges inside the part.
  static std::vector<Face_pair> pairs_to_separate(const Surface& part, const Face_pair& first,
                                                  const std::vector<Index>& seams)
  {
    Face_components strokes(part.points.size()); // sets of vertices
    for (Index v = 0; v < part.points.size(); ++v)
      strokes.add(v);
    for (Index h : seams)
      strokes.join(part.source_vertex(h), part.target_vertex(h));
    std::vector<Face_pair> result(1, first);
    for (Index h : seams)
      if (h / 3 == first[0] && part.neighbor(h) == first[1])
        for (Index other : seams)
          if (strokes.representative(part.source_vertex(other)) ==
              strokes.representative(part.source_vertex(h)))
            result.push_back({other / 3, part.neighbor(other)});
    return result;
  }

  // Splits the region of two faces that must be apart.
  void split(const Face_pair& pair)
  {
    const Index region = region_[pair[0]];
    std::vector<Index> faces, group, number(region_.size(), null_index);
    for (Index f = 0; f < region_.size(); ++f)
      if (region_[f] == region) {
        number[f] = static_cast<Index>(faces.size());
        faces.push_back(f);
        group.push_back(groups_.group[f]);
      }
    Surface part = part_of(faces);
    std::vector<double> border(faces.size(), 0);
    std::vector<Index> seams;
    for (Index h = 0; h < part.number_of_halfedges(); ++h) {
      const Index h_of_mesh = 3 * faces[h / 3] + h % 3;
      if (groups_.is_seam[h_of_mesh] && !part.is_border(h))
        seams.push_back(h);
      else if (region_[mesh_.neighbor(h_of_mesh)] != region && !groups_.is_seam[h_of_mesh])
        border[h / 3] += mesh_.length(h_of_mesh);
    }
    const std::vector<Face_pair> pairs =
      pairs_to_separate(part, {number[pair[0]], number[pair[1]]}, seams);
    for (Index h : seams)
      part.opposite[h] = h;
    const std::vector<Index> piece = Constrained_cut(part, group, border, minimum_area_)(pairs);
    std::map<Index, Index> region_of_piece;
    for (Index i = 0; i < faces.size(); ++i) {
      const auto [entry, is_new] =
        region_of_piece.emplace(piece[i], static_cast<Index>(leaves_.size()));
      if (is_new) {
        leaves_.push_back(std::set<std::size_t>(leaves_[region]));
        is_split_.push_back(1);
      }
      region_[faces[i]] = entry->second;
    }
  }

  // Returns two faces of one region that must be apart; null_index twice if there are none.
  Face_pair find_conflict() const
  {
    for (const Face_pair& pair : groups_.cannot_link)
      if (region_[pair[0]] == region_[pair[1]])
        return pair;
    std::vector<Index> first(leaves_.size(), null_index); // one face with a seed per region
    for (Index f = 0; f < region_.size(); ++f)
      if (groups_.seed(f) != null_index) {
        Index& g = first[region_[f]];
        g = g == null_index ? f : g;
        if (groups_.seed(g) != groups_.seed(f))
          return {g, f};
      }
    return {null_index, null_index};
  }

  void split_all()
  {
    for (Face_pair pair = find_conflict(); pair[0] != null_index; pair = find_conflict())
      split(pair);
  }

  void merge(Region_graph& graph, Index a, Index b)
  {
    const auto [into, from] = std::minmax(a, b);
    graph.merge(into, from);
    leaves_[into].merge(leaves_[from]);
    is_split_[into] |= is_split_[from];
  }

  // Merges the regions with the same seed.
  void join_seeds()
  {
    Region_graph regions = graph();
    std::vector<Index> first(groups_.number_of_seeds, null_index); // a face per seed
    for (Index f = 0; f < region_.size(); ++f)
      if (const Index seed = groups_.seed(f); seed != null_index) {
        first[seed] = (std::min)(first[seed], f);
        const Index a = regions.representative(region_[first[seed]]);
        const Index b = regions.representative(region_[f]);
        if (a != b)
          merge(regions, a, b);
      }
    for (Index& r : region_)
      r = regions.representative(r);
  }

  // Merges each strip between a forced boundary and a nearby boundary of another region with that
  // region, because the forced boundary is meant to be the boundary.
  void join_strips(Region_graph& graph)
  {
    constexpr double largest_area = 0.1; // relative to the square of the length of the boundary
    for (Index r = 0; r < graph.number(); ++r) {
      const auto [neighbor, length] = graph.longest_neighbor(r);
      if (is_split_[r] && graph.area(r) < largest_area * length * length)
        merge(graph, r, neighbor);
    }
    for (Index& r : region_)
      r = graph.representative(r);
  }

public:
  Constrained_regions(Execution execution, const Cut_hierarchy& cuts, const Surface& mesh,
                      const Distance_weights& weights, double minimum_segment_size,
                      Run_monitor& monitor, Constraint_groups& groups)
    : execution_(execution), mesh_(mesh), weights_(weights),
      minimum_area_(minimum_segment_size * total_area(mesh)), monitor_(monitor), groups_(groups),
      extractor_(mesh), region_(cuts.leaf), is_split_(cuts.nodes.size(), 0)
  {
    for (std::size_t i = 0; i < cuts.nodes.size(); ++i)
      leaves_.push_back({i});
  }

  // Makes the regions and returns their graph.
  Region_graph operator()(bool keep_components_separate)
  {
    move_groups();
    connect_seeds();
    split_all();
    join_seeds();
    split_all();
    Region_graph result = graph();
    join_strips(result);
    if (!keep_components_separate)
      result.close_gaps(mesh_, region_, [&](std::size_t n) { monitor_.count_steps(n); });
    return result;
  }

  const std::vector<Index>& region_of_faces() const { return region_; }
  const std::vector<std::set<std::size_t> >& leaves() const { return leaves_; }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINED_REGIONS_H
