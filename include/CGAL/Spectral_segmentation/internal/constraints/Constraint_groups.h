// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINT_GROUPS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINT_GROUPS_H

#include <CGAL/Spectral_segmentation/internal/base/Run_data.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Disjoint sets that can be merged, except pairs that are separated. Sets with different seeds are
// separated, too. The lowest index of a set represents it.
class Separated_sets
{
  mutable std::vector<Index> merged_into_; // paths are halved whenever they are followed
  std::vector<Index> seed_;
  std::vector<std::set<Index> > separated_; // the sets separated from each representative

public:
  explicit Separated_sets(std::size_t number = 0)
    : merged_into_(first_indices(number)), seed_(number, null_index), separated_(number) {}

  std::size_t number() const { return merged_into_.size(); }

  Index representative(Index a) const
  {
    while (merged_into_[a] != a)
      a = merged_into_[a] = merged_into_[merged_into_[a]];
    return a;
  }

  Index seed(Index a) const { return seed_[representative(a)]; }
  void set_seed(Index a, Index seed) { seed_[representative(a)] = seed; }

  // Returns the sets that `separate()` separated from a set, not those with other seeds.
  const std::set<Index>& separated_from(Index a) const { return separated_[representative(a)]; }

  void separate(Index a, Index b)
  {
    a = representative(a);
    b = representative(b);
    separated_[a].insert(b);
    separated_[b].insert(a);
  }

  bool are_separated(Index a, Index b) const
  {
    a = representative(a);
    b = representative(b);
    return separated_[a].count(b) > 0 ||
           (seed_[a] != null_index && seed_[b] != null_index && seed_[a] != seed_[b]);
  }

  void merge(Index a, Index b)
  {
    const auto [into, from] = std::minmax({representative(a), representative(b)});
    if (into == from)
      return;
    merged_into_[from] = into;
    seed_[into] = (std::min)(seed_[into], seed_[from]);
    for (Index c : separated_[from]) {
      separated_[c].erase(from);
      separated_[c].insert(into);
      separated_[into].insert(c);
    }
    separated_[from].clear();
  }
};

// The constraints of a caller in terms of the faces of the mesh, without contradictions. A group is
// a connected set of faces that stay together. Groups that belong to one segment are a set.
struct Constraint_groups
{
  std::vector<Index> group;  // one per face; null_index if it is unconstrained
  std::vector<Index> faces;  // the constrained faces, ascending
  std::vector<char> is_seam; // one per halfedge: whether it must separate segments
  Separated_sets sets;       // sets of groups

  Index set(Index f) const
  { return group[f] == null_index ? null_index : sets.representative(group[f]); }
};

[[noreturn]] inline void fail_constraint(const std::string& what)
{ throw std::invalid_argument("segment_spectral_recursive: " + what); }

inline std::string names_of_faces(Index f, Index g)
{ return "the faces " + std::to_string(f) + " and " + std::to_string(g); }

// Groups constrained faces. `mesh_face` holds the face of the mesh for each face of the caller, one
// face for all duplicates. Throws `std::invalid_argument` if constraints contradict each other.
class Constraint_grouping
{
  const Constraints& constraints_;
  const std::vector<Index> mesh_face_;
  const Surface& mesh_;
  Disjoint_sets groups_, sets_; // faces that are joined by edges; and also by their seeds
  std::map<std::int64_t, Index> first_of_seed_; // the caller's index of the face

  Index set_of(Index callers_face) { return sets_.representative(mesh_face_[callers_face]); }

  bool are_neighbors(Index f, Index g) const
  {
    return mesh_.neighbor(3 * f) == g || mesh_.neighbor(3 * f + 1) == g ||
           mesh_.neighbor(3 * f + 2) == g;
  }

  void join()
  {
    for (const auto& [f, g] : constraints_.must_link) {
      sets_.join(mesh_face_[f], mesh_face_[g]);
      if (are_neighbors(mesh_face_[f], mesh_face_[g]))
        groups_.join(mesh_face_[f], mesh_face_[g]);
    }
    std::map<Index, std::pair<Index, std::int64_t> > seed_of_set; // a face and its seed
    for (const auto& constraint : constraints_.seeds) {
      const auto& [f, seed] = constraint;
      const auto& [g, other] = seed_of_set.emplace(set_of(f), constraint).first->second;
      if (other != seed)
        fail_constraint(names_of_faces(g, f) + " have the seeds " + std::to_string(other) +
                        " and " + std::to_string(seed) + ", but are joined by edges that must not "
                        "be cut, or are one face twice");
    }
    for (const auto& [f, seed] : constraints_.seeds)
      sets_.join(mesh_face_[first_of_seed_.emplace(seed, f).first->second], mesh_face_[f]);
    for (const auto& [f, g] : constraints_.cannot_link)
      if (set_of(f) == set_of(g))
        fail_constraint("the edge between " + names_of_faces(f, g) + " is constrained, but the two "
                        "are joined by edges that must not be cut or by their seed, or are one "
                        "face twice");
  }

  void check_components() const
  {
    const auto check = [this](Index f, Index g, const std::string& what) {
      if (mesh_.components[mesh_face_[f]] != mesh_.components[mesh_face_[g]])
        fail_constraint(names_of_faces(f, g) + what + ", but are of components that are kept "
                        "apart");
    };
    for (const auto& [f, seed] : constraints_.seeds)
      check(first_of_seed_.at(seed), f, " have the seed " + std::to_string(seed));
    for (const auto& [f, g] : constraints_.must_link)
      check(f, g, " are joined by an edge that must not be cut");
  }

public:
  Constraint_grouping(const Constraints& constraints, std::vector<Index> mesh_face,
                      const Surface& mesh)
    : constraints_(constraints), mesh_face_(std::move(mesh_face)), mesh_(mesh),
      groups_(mesh.number_of_faces()), sets_(mesh.number_of_faces())
  {}

  Constraint_groups operator()(bool keep_components_separate)
  {
    join();
    if (keep_components_separate)
      check_components();
    Constraint_groups result;
    const std::vector<char> is_constrained =
      constrained_faces(constraints_, mesh_face_, mesh_.number_of_faces());
    result.group.assign(mesh_.number_of_faces(), null_index);
    std::map<Index, Index> number_of_group, first_of_set;
    for (Index f = 0; f < is_constrained.size(); ++f)
      if (is_constrained[f]) {
        result.faces.push_back(f);
        const Index number = static_cast<Index>(number_of_group.size());
        result.group[f] =
          number_of_group.emplace(groups_.representative(f), number).first->second;
      }
    result.sets = Separated_sets(number_of_group.size());
    for (Index f : result.faces)
      result.sets.merge(
        first_of_set.emplace(sets_.representative(f), result.group[f]).first->second,
        result.group[f]);
    for (const auto& [f, seed] : constraints_.seeds) // a seed is named by its first face
      result.sets.set_seed(result.group[mesh_face_[f]], first_of_seed_.at(seed));
    result.is_seam.assign(mesh_.number_of_halfedges(), 0);
    for (const auto& pair : constraints_.cannot_link) {
      const Index f = mesh_face_[pair[0]], g = mesh_face_[pair[1]];
      result.sets.separate(result.group[f], result.group[g]);
      for (Index i = 0; i < 3; ++i) {
        result.is_seam[3 * f + i] |= mesh_.neighbor(3 * f + i) == g;
        result.is_seam[3 * g + i] |= mesh_.neighbor(3 * g + i) == f;
      }
    }
    return result;
  }
};

// Joins the groups of each set, within each component of the mesh, by paths of faces. A set that is
// blocked by others is routed first on the next attempt.
class Group_connection
{
  typedef std::vector<Index> Faces;

  const Surface& mesh_;
  const std::vector<Index>& leaf_; // one per face: paths run over few leaves
  const Constraint_groups& given_;
  Constraint_groups groups_;
  std::vector<Faces> faces_;       // one list per group
  std::vector<Index> first_face_;  // one per given group
  std::vector<char> has_seed_;     // one per leaf

  void set_groups()
  {
    groups_ = given_;
    faces_.assign(groups_.sets.number(), {});
    for (Index f : groups_.faces)
      faces_[groups_.group[f]].push_back(f);
  }

  // Returns the groups of each set and component that has several.
  std::vector<Faces> groups_to_join() const
  {
    std::map<std::pair<Index, Index>, Faces> groups;
    for (Index i = 0; i < faces_.size(); ++i)
      groups[{groups_.sets.representative(i), mesh_.components[faces_[i].front()]}].push_back(i);
    std::vector<Faces> result;
    for (const auto& entry : groups)
      if (entry.second.size() > 1)
        result.push_back(entry.second);
    return result;
  }

  // Ends a search once it has reached all faces of a set outside one group.
  struct Reached_set {};

  class Reached_set_visitor : public boost::dijkstra_visitor<>
  {
    const Constraint_groups* groups_;
    Index group_;
    std::size_t* missing_;

  public:
    Reached_set_visitor(const Constraint_groups& groups, Index group, std::size_t& missing)
      : groups_(&groups), group_(group), missing_(&missing) {}

    void examine_vertex(Index f, const Surface&) const
    {
      if (groups_->group[f] != group_ && groups_->set(f) == groups_->sets.representative(group_) &&
          --*missing_ == 0)
        throw Reached_set();
    }
  };

  // Returns the cost of the step across a halfedge. Paths run over the fewest leaves with seeds,
  // then over the fewest leaves, then over the fewest faces. They avoid banned groups.
  double cost(Index h, const std::vector<char>& is_banned) const
  {
    const Index g = mesh_.neighbor(h);
    if (groups_.group[g] != null_index && is_banned[groups_.group[g]])
      return infinite_distance;
    if (leaf_[h / 3] == leaf_[g])
      return 1;
    return has_seed_[leaf_[g]] ? std::ldexp(1., 40) : std::ldexp(1., 20);
  }

  // Returns the costs of the paths from a group to the other groups of its set in its component.
  std::vector<double> costs(Index group, const std::vector<char>& is_banned) const
  {
    const Index component = mesh_.components[faces_[group].front()];
    std::size_t missing = 0;
    for (Index i = 0; i < faces_.size(); ++i)
      if (i != group && !faces_[i].empty() && mesh_.components[faces_[i].front()] == component &&
          groups_.sets.representative(i) == groups_.sets.representative(group))
        missing += faces_[i].size();
    std::vector<double> result(mesh_.number_of_faces(), infinite_distance);
    for (Index f : faces_[group])
      result[f] = 0;
    try {
      run_dijkstra(mesh_, faces_[group], [&](Index h) { return cost(h, is_banned); }, result,
                   Reached_set_visitor(groups_, group, missing));
    }
    catch (const Reached_set&) {
    }
    return result;
  }

  // Returns the cheapest path from a face back to where the costs begin.
  Faces path(Index f, const std::vector<double>& costs, const std::vector<char>& is_banned) const
  {
    Faces result(1, f);
    while (costs[result.back()] > 0)
      for (Index h = 3 * result.back(), end = h + 3; h < end; ++h)
        if (const Index g = mesh_.neighbor(h);
            costs[g] + cost(mesh_.opposite[h], is_banned) == costs[result.back()]) {
          result.push_back(g);
          break;
        }
    return result;
  }

  // Adds the faces of a path, and all groups that it meets, to a group. Returns null_index, or the
  // first group that is separated from it; then it changes nothing.
  Index absorb(Index group, const Faces& path)
  {
    std::vector<Index> met(1, groups_.sets.representative(group));
    for (Index f : path)
      if (const Index set = groups_.set(f);
          set != null_index && std::find(met.begin(), met.end(), set) == met.end()) {
        for (Index other : met)
          if (groups_.sets.are_separated(set, other))
            return groups_.group[f];
        met.push_back(set);
      }
    for (Index set : met)
      groups_.sets.merge(group, set);
    const auto add = [&](Index f) {
      groups_.group[f] = group;
      faces_[group].push_back(f);
    };
    for (Index f : path)
      if (const Index other = groups_.group[f]; other == null_index)
        add(f);
      else if (other != group)
        for (Index g : std::exchange(faces_[other], {}))
          add(g);
    return null_index;
  }

  // Joins groups of a set in one component. Returns whether there were paths.
  bool join(const Faces& groups)
  {
    // An earlier path may have absorbed groups.
    const Index group = groups_.group[first_face_[groups.front()]];
    const auto is_joined = [&](Index i) { return groups_.group[first_face_[i]] == group; };
    std::vector<char> is_banned(faces_.size(), 0);
    for (Index i = 0; i < faces_.size(); ++i)
      is_banned[i] = groups_.sets.are_separated(i, group);
    while (!std::all_of(groups.begin(), groups.end(), is_joined)) {
      const std::vector<double> costs_of_paths = costs(group, is_banned);
      Index conflict = null_index;
      for (auto i = groups.begin(); i != groups.end() && conflict == null_index; ++i)
        if (!is_joined(*i)) {
          if (costs_of_paths[first_face_[*i]] == infinite_distance)
            return false;
          conflict = absorb(group, path(first_face_[*i], costs_of_paths, is_banned));
        }
      if (conflict != null_index)
        is_banned[conflict] = 1;
    }
    return true;
  }

public:
  // Takes the leaf of each face, which is below `number_of_nodes`.
  Group_connection(const Surface& mesh, const std::vector<Index>& leaf, std::size_t number_of_nodes,
                 const Constraint_groups& groups)
    : mesh_(mesh), leaf_(leaf), given_(groups), has_seed_(number_of_nodes, 0)
  {
    set_groups();
    for (const Faces& faces : faces_)
      first_face_.push_back(faces.front());
    for (Index f : groups.faces)
      if (groups.sets.seed(groups.group[f]) != null_index)
        has_seed_[leaf[f]] = 1;
  }

  // Returns the groups with the paths. `callers_face` holds a face of the caller for each face.
  Constraint_groups operator()(const std::vector<Index>& callers_face)
  {
    std::vector<Faces> all = groups_to_join();
    std::set<Faces> routed_first;
    for (auto groups = all.begin(); groups != all.end();) {
      if (join(*groups)) {
        ++groups;
        continue;
      }
      if (groups == all.begin() || !routed_first.insert(*groups).second)
        fail_constraint(names_of_faces(callers_face[first_face_[groups->front()]],
                                       callers_face[first_face_[groups->back()]]) +
                        " must be in one segment, which must be connected, but other constraints "
                        "leave no path between them");
      std::rotate(all.begin(), groups, groups + 1);
      set_groups();
      groups = all.begin();
    }
    groups_.faces.clear();
    for (Index f = 0; f < groups_.group.size(); ++f)
      if (groups_.group[f] != null_index)
        groups_.faces.push_back(f);
    return std::move(groups_);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINT_GROUPS_H
