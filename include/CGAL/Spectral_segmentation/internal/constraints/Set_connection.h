// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_SET_CONNECTION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_SET_CONNECTION_H

#include <CGAL/Spectral_segmentation/internal/constraints/Constraint_groups.h>
#include <CGAL/Spectral_segmentation/internal/distances/shortest_paths.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Joins the groups of each set, within each component of the mesh, by paths of faces. Where sets
// are in the way of each other, those that find no path get the first choice.
class Set_connection
{
  typedef std::vector<Index> Faces;

  const Surface& mesh_;
  const std::vector<Index>& leaf_; // one per face: paths run over few leaves
  const Constraint_groups& given_;
  Constraint_groups groups_;
  std::vector<Faces> faces_;       // of each group
  std::vector<Index> first_face_;  // of each given group
  std::vector<char> has_seed_;     // one per leaf

  void set_groups()
  {
    groups_ = given_;
    faces_.assign(groups_.sets.number(), {});
    for (Index f : groups_.faces)
      faces_[groups_.group[f]].push_back(f);
  }

  // Returns for each set and component with several groups these groups.
  std::vector<Faces> groups_to_join() const
  {
    std::map<std::pair<Index, Index>, Faces> groups;
    for (Index i = 0; i < faces_.size(); ++i)
      groups[{groups_.sets.representative(i), mesh_.components[faces_[i].front()]}].push_back(i);
    std::vector<Faces> result;
    for (const auto& of_set : groups)
      if (of_set.second.size() > 1)
        result.push_back(of_set.second);
    return result;
  }

  // Ends a search once it has reached all faces of a set but those of one group.
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

  // Makes the faces of a path, and all groups that it meets, a part of a group. Returns the first
  // group that is apart from it; then it changes nothing. Otherwise returns null_index.
  Index absorb(Index group, const Faces& path)
  {
    std::vector<Index> met(1, groups_.sets.representative(group));
    for (Index f : path)
      if (const Index set = groups_.set(f);
          set != null_index && std::find(met.begin(), met.end(), set) == met.end()) {
        for (Index other : met)
          if (groups_.sets.are_apart(set, other))
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
      is_banned[i] = groups_.sets.are_apart(i, group);
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
  // Takes the leaf of each face, of so many nodes.
  Set_connection(const Surface& mesh, const std::vector<Index>& leaf, std::size_t number_of_nodes,
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
    std::set<Faces> had_first_choice;
    for (auto groups = all.begin(); groups != all.end();) {
      if (join(*groups)) {
        ++groups;
        continue;
      }
      if (groups == all.begin() || !had_first_choice.insert(*groups).second)
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

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_SET_CONNECTION_H
