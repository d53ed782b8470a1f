// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINT_GROUPS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINT_GROUPS_H

#include <CGAL/Spectral_segmentation/internal/constraints/Constraints.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Separated_sets.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The constraints of a caller in terms of the faces of the mesh, without contradictions. A group is
// a connected set of faces that stay together. Groups that belong to one segment are a set.
struct Constraint_groups
{
  std::vector<Index> group;  // one per face; null_index if it is unconstrained
  std::vector<Index> faces;  // those with a group, ascending
  std::vector<char> is_seam; // one per halfedge: whether it must separate segments
  Separated_sets sets;       // of groups

  Index set(Index f) const
  { return group[f] == null_index ? null_index : sets.representative(group[f]); }
};

[[noreturn]] inline void fail_constraint(const std::string& what)
{ throw std::invalid_argument("segment_spectral_recursive: " + what); }

inline std::string names_of_faces(Index f, Index g)
{ return "the faces " + std::to_string(f) + " and " + std::to_string(g); }

// Groups constrained faces. `number` holds the face of the mesh for each face of the caller; it is
// the same for all faces with the same points. Throws `std::invalid_argument` if constraints
// contradict each other.
class Constraint_grouping
{
  const Constraints& constraints_;
  const std::vector<Index>& number_;
  const Surface& mesh_;
  Face_components groups_, sets_; // faces that are joined by edges; and also by their seeds
  std::map<std::int64_t, Index> first_of_seed_; // the caller's index of the face

  Index set_of(Index callers_face) { return sets_.representative(number_[callers_face]); }

  bool are_neighbors(Index f, Index g) const
  {
    return mesh_.neighbor(3 * f) == g || mesh_.neighbor(3 * f + 1) == g ||
           mesh_.neighbor(3 * f + 2) == g;
  }

  void join()
  {
    for (const auto& [f, g] : constraints_.must_link) {
      sets_.join(number_[f], number_[g]);
      if (are_neighbors(number_[f], number_[g]))
        groups_.join(number_[f], number_[g]);
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
      sets_.join(number_[first_of_seed_.emplace(seed, f).first->second], number_[f]);
    for (const auto& [f, g] : constraints_.cannot_link)
      if (set_of(f) == set_of(g))
        fail_constraint("the edge between " + names_of_faces(f, g) + " is constrained, but the two "
                        "are joined by edges that must not be cut or by their seed, or are one "
                        "face twice");
  }

  void check_components() const
  {
    const auto check = [this](Index f, Index g, const std::string& what) {
      if (mesh_.components[number_[f]] != mesh_.components[number_[g]])
        fail_constraint(names_of_faces(f, g) + what + ", but are of components that are kept "
                        "apart");
    };
    for (const auto& [f, seed] : constraints_.seeds)
      check(first_of_seed_.at(seed), f, " have the seed " + std::to_string(seed));
    for (const auto& [f, g] : constraints_.must_link)
      check(f, g, " are joined by an edge that must not be cut");
  }

public:
  Constraint_grouping(const Constraints& constraints, const std::vector<Index>& number,
                      const Surface& mesh)
    : constraints_(constraints), number_(number), mesh_(mesh), groups_(mesh.number_of_faces()),
      sets_(mesh.number_of_faces())
  {
    for (Index f = 0; f < mesh.number_of_faces(); ++f) {
      groups_.add(f);
      sets_.add(f);
    }
  }

  Constraint_groups operator()(bool keep_components_separate)
  {
    join();
    if (keep_components_separate)
      check_components();
    Constraint_groups result;
    std::vector<char> is_constrained(mesh_.number_of_faces(), 0);
    for (const auto& [f, seed] : constraints_.seeds)
      is_constrained[number_[f]] = 1;
    for (const auto& pairs : {&constraints_.cannot_link, &constraints_.must_link})
      for (const auto& [f, g] : *pairs)
        is_constrained[number_[f]] = is_constrained[number_[g]] = 1;

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
      result.sets.set_seed(result.group[number_[f]], first_of_seed_.at(seed));
    result.is_seam.assign(mesh_.number_of_halfedges(), 0);
    for (const auto& pair : constraints_.cannot_link) {
      const Index f = number_[pair[0]], g = number_[pair[1]];
      result.sets.separate(result.group[f], result.group[g]);
      for (Index i = 0; i < 3; ++i) {
        result.is_seam[3 * f + i] |= mesh_.neighbor(3 * f + i) == g;
        result.is_seam[3 * g + i] |= mesh_.neighbor(3 * g + i) == f;
      }
    }
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINT_GROUPS_H
