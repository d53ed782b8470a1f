// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_SET_CONNECTION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_SET_CONNECTION_H

#include <CGAL/Spectral_segmentation/internal/constraints/Constraint_groups.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <queue>
#include <set>
#include <tuple>
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

  // Returns a path from a group to another group of its set, which it is not joined with, by the
  // fewest leaves with other seeds, then the fewest leaves, then the fewest faces; empty if there
  // is none. It avoids banned groups.
  Faces path(Index group, const std::vector<char>& is_banned) const
  {
    typedef std::tuple<std::size_t, std::size_t, std::size_t, Index, Index> Entry; // costs, face,
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;    // its previous
    std::map<Index, Index> previous;
    for (Index f : faces_[group])
      queue.push({0, 0, 0, f, f});
    while (!queue.empty()) {
      const auto [seeds, leaves, length, f, before] = queue.top();
      queue.pop();
      if (!previous.emplace(f, before).second)
        continue;
      const Index other = groups_.group[f];
      if (other != null_index && other != group &&
          groups_.sets.representative(other) == groups_.sets.representative(group)) {
        Faces result(1, f);
        while (previous.at(result.back()) != result.back())
          result.push_back(previous.at(result.back()));
        return result;
      }
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = mesh_.neighbor(h), of_g = groups_.group[g];
        if (previous.count(g) || (of_g != null_index && is_banned[of_g]))
          continue;
        const bool is_new = leaf_[f] != leaf_[g];
        queue.push({seeds + (is_new && has_seed_[leaf_[g]]), leaves + is_new, length + 1, g, f});
      }
    }
    return {};
  }

  // Makes the faces of a path, and all groups that it meets, a part of a group. Returns the first
  // group that is apart from it; then it changes nothing. Otherwise returns null_index.
  Index absorb(Index group, const Faces& path)
  {
    Separated_sets sets = groups_.sets;
    for (Index f : path)
      if (const Index other = groups_.group[f]; other != null_index) {
        if (sets.are_apart(group, other))
          return other;
        sets.merge(group, other);
      }
    groups_.sets = std::move(sets);
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
      const Faces faces = path(group, is_banned);
      if (faces.empty())
        return false;
      if (const Index other = absorb(group, faces); other != null_index)
        is_banned[other] = 1;
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
