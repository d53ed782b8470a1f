// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISHED_MERGING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISHED_MERGING_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Wish_groups.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Wished_regions.h>
#include <CGAL/Spectral_segmentation/internal/mesh/component_distances.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Merges the regions that fulfill wishes, as the cuts of the old hierarchy are undone, the least
// salient first. Where an old cut has a region on one side that can be merged with one on the
// other, they are merged with the salience of the cut. What no wish concerns is merged as before.
// Regions that a wish keeps apart stay so: what is left are the roots.
class Wished_merging
{
  typedef std::vector<Index> Clusters;

  struct Cluster // of regions; known by one of them
  {
    double area = 0;
    Index seed = null_index;
    std::set<Index> apart;             // clusters that must not be merged with it
    std::map<Index, double> neighbors; // with the lengths of the common boundaries
  };

  struct Merge
  {
    Index smaller, larger; // the smaller of the two numbers is that of the result
    double areas[2];
    std::size_t old_node;
    bool is_old; // the same cut as that of the node
  };

  const Cut_hierarchy& old_;
  const Face_graph& mesh_;
  const Wish_groups& groups_;
  const Wished_regions& regions_;
  std::vector<Cluster> clusters_;
  std::vector<Index> cluster_of_region_;
  std::vector<Index> leaf_region_;   // of each region: that with which it makes a leaf
  std::vector<Clusters> below_;      // of each node of the old hierarchy
  std::vector<char> is_whole_;       // whether a node of the old hierarchy is one cluster as before
  std::vector<Merge> merges_;

  Index cluster(Index region) const
  {
    while (cluster_of_region_[region] != region)
      region = cluster_of_region_[region];
    return region;
  }

  bool are_apart(Index a, Index b) const
  {
    const Cluster &first = clusters_[a], &second = clusters_[b];
    return first.apart.count(b) || (first.seed != null_index && second.seed != null_index &&
                                    first.seed != second.seed);
  }

  void join(Index a, Index b)
  {
    const auto [into, from] = std::minmax(a, b);
    Cluster &result = clusters_[into], other = std::exchange(clusters_[from], Cluster());
    cluster_of_region_[from] = into;
    result.area += other.area;
    result.seed = (std::min)(result.seed, other.seed);
    for (Index c : other.apart) {
      clusters_[c].apart.erase(from);
      clusters_[c].apart.insert(into);
      result.apart.insert(c);
    }
    for (const auto& [c, length] : other.neighbors) {
      clusters_[c].neighbors.erase(from);
      if (c != into) {
        result.neighbors[c] += length;
        clusters_[c].neighbors[into] += length;
      }
    }
    result.neighbors.erase(from);
  }

  // Of the neighbors that can be merged the two with the longest common boundary; or null_index.
  Face_pair next_pair(const Clusters& clusters) const
  {
    const std::set<Index> all(clusters.begin(), clusters.end());
    Face_pair result = {null_index, null_index};
    double longest = -1;
    for (Index a : all)
      for (const auto& [b, length] : clusters_[a].neighbors)
        if (a < b && quantized(length) > longest && all.count(b) && !are_apart(a, b)) {
          longest = quantized(length);
          result = {a, b};
        }
    return result;
  }

  void set_cluster_of_regions(Clusters& regions) const
  {
    for (Index& region : regions)
      region = cluster(region);
    std::sort(regions.begin(), regions.end());
    regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
  }

  void record(Index a, Index b, std::size_t old_node, bool is_old)
  {
    const double area[2] = {clusters_[a].area, clusters_[b].area};
    const bool is_swapped = !is_old && area[1] < area[0];
    merges_.push_back({is_swapped ? b : a, is_swapped ? a : b,
                       {area[is_swapped], area[!is_swapped]}, old_node, is_old});
  }

  void set_clusters()
  {
    const std::size_t number = regions_.faces().size();
    clusters_.resize(number);
    cluster_of_region_.resize(number);
    std::iota(cluster_of_region_.begin(), cluster_of_region_.end(), Index(0));
    const std::vector<Index>& region = regions_.region_of_faces();
    std::vector<std::size_t> size_of_leaf(old_.nodes.size(), 0);
    for (Index f = 0; f < region.size(); ++f) {
      ++size_of_leaf[old_.leaf[f]];
      Cluster& c = clusters_[region[f]];
      c.area += mesh_.areas[f];
      if (groups_.group[f] != null_index)
        c.seed = (std::min)(c.seed, groups_.seed[groups_.group[f]]);
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (region[mesh_.neighbors[h]] != region[f] && !regions_.seam_sides().is_seam(h))
          c.neighbors[region[mesh_.neighbors[h]]] += mesh_.length(h);
    }
    for (const auto& [f, g] : groups_.seams) {
      clusters_[region[f]].apart.insert(region[g]);
      clusters_[region[g]].apart.insert(region[f]);
    }
    for (Index r = 0; r < number; ++r) {
      for (std::size_t leaf : regions_.leaves()[r])
        below_[leaf].push_back(r);
      const std::vector<Index>& faces = regions_.faces()[r];
      if (faces.empty())
        continue;
      const std::size_t leaf = old_.leaf[faces.front()];
      const auto is_of_leaf = [&](Index f) { return old_.leaf[f] == leaf; };
      if (faces.size() == size_of_leaf[leaf] &&
          std::all_of(faces.begin(), faces.end(), is_of_leaf)) {
        is_whole_[leaf] = 1;
        clusters_[r].area = old_.nodes[leaf].area;
      }
    }
  }

  // Components of the mesh that are not kept apart are neighbors of the nearest ones.
  void set_neighbors_across_gaps()
  {
    std::size_t number_of_components;
    connected_components(mesh_, number_of_components);
    if (number_of_components == 1)
      return;
    std::vector<Index> number(clusters_.size(), null_index), region_of_number, set;
    for (Index r : regions_.region_of_faces()) {
      if (number[r] == null_index) {
        number[r] = static_cast<Index>(region_of_number.size());
        region_of_number.push_back(r);
      }
      set.push_back(number[r]);
    }
    for (const auto& [i, j] : nearest_sets_of_faces(mesh_, set, region_of_number.size())) {
      const Index a = region_of_number[i], b = region_of_number[j];
      clusters_[a].neighbors.emplace(b, 0);
      clusters_[b].neighbors.emplace(a, 0);
    }
  }

  void merge_below(std::size_t node)
  {
    const std::size_t (&children)[2] = old_.nodes[node].children;
    for (std::size_t child : children)
      set_cluster_of_regions(below_[child]);
    const Clusters &first = below_[children[0]], &second = below_[children[1]];
    if (is_whole_[children[0]] && is_whole_[children[1]] &&
        !are_apart(first.front(), second.front())) {
      record(first.front(), second.front(), node, true);
      join(first.front(), second.front());
      below_[node] = {cluster(first.front())};
      clusters_[below_[node].front()].area = old_.nodes[node].area;
      is_whole_[node] = 1;
      return;
    }
    Clusters& all = below_[node];
    all = first;
    all.insert(all.end(), second.begin(), second.end());
    set_cluster_of_regions(all);
    for (Face_pair pair = next_pair(all); pair[0] != null_index; pair = next_pair(all)) {
      record(pair[0], pair[1], node, false);
      join(pair[0], pair[1]);
      set_cluster_of_regions(all);
    }
  }

  // What a wish cut off from a leaf and what is left of it are merged for good where they can be.
  void merge_in_leaves()
  {
    for (std::size_t leaf = 0; leaf < old_.nodes.size(); ++leaf) {
      if (!old_.nodes[leaf].is_leaf())
        continue;
      Clusters& all = below_[leaf];
      set_cluster_of_regions(all);
      for (Face_pair pair = next_pair(all); pair[0] != null_index; pair = next_pair(all)) {
        join(pair[0], pair[1]);
        set_cluster_of_regions(all);
      }
    }
    for (Index r = 0; r < clusters_.size(); ++r)
      leaf_region_.push_back(cluster(r));
  }

  // The roots in the order of their first faces, and cuts that undo the merges.
  Cut_hierarchy hierarchy() const
  {
    Cut_hierarchy result;
    result.is_ultrametric = old_.is_ultrametric;
    result.is_complete = old_.is_complete;
    std::vector<std::size_t> node(clusters_.size(), null_node); // of a cluster
    for (Index r : regions_.region_of_faces())
      if (node[cluster(r)] == null_node) {
        node[cluster(r)] = result.nodes.size();
        result.nodes.emplace_back();
        result.nodes.back().area = clusters_[cluster(r)].area;
      }
    result.number_of_roots = result.nodes.size();
    for (auto m = merges_.rbegin(); m != merges_.rend(); ++m) {
      const std::size_t parent = node[(std::min)(m->smaller, m->larger)];
      const Cut_node& old = old_.nodes[m->old_node];
      result.nodes[parent].cut_state = Cut_state::ACCEPTED;
      result.nodes[parent].salience = old.salience;
      if (m->is_old)
        result.nodes[parent].factors = old.factors;
      result.turns.push_back(parent);
      result.cut(parent, m->areas[0], m->areas[1]);
      node[m->smaller] = result.nodes[parent].children[0];
      node[m->larger] = result.nodes[parent].children[1];
    }
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      const std::size_t leaf = node[leaf_region_[regions_.region_of_faces()[f]]];
      result.leaf.push_back(static_cast<Index>(leaf));
      result.nodes[leaf].cut_state = old_.nodes[old_.leaf[f]].cut_state;
    }
    return result;
  }

public:
  Wished_merging(const Cut_hierarchy& old, const Face_graph& mesh, const Wish_groups& groups,
                 const Wished_regions& regions)
    : old_(old), mesh_(mesh), groups_(groups), regions_(regions), below_(old.nodes.size()),
      is_whole_(old.nodes.size(), 0) {}

  Cut_hierarchy operator()(bool components_apart)
  {
    set_clusters();
    if (!components_apart)
      set_neighbors_across_gaps();
    merge_in_leaves();
    for (std::size_t i = old_.turns.size(); i-- > 0;)
      if (!old_.nodes[old_.turns[i]].is_leaf())
        merge_below(old_.turns[i]);
    return hierarchy();
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISHED_MERGING_H
