// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINT_GROUPS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINT_GROUPS_H

#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/constraints/Constraints.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The constraints of a caller in terms of the faces of the mesh, without contradictions. Each group
// of faces lies in one segment.
struct Constraint_groups
{
  std::vector<Index> group;     // one per face; null_index if it is unconstrained
  std::vector<Face_pair> cannot_link; // pairs of faces of different groups and segments
  std::vector<char> is_seam;    // one per halfedge: whether it must separate segments
  Index number_of_seeds = 0;    // the first groups belong to the seeds, in different segments
  Index number = 0;

  // Returns the group of a face if it has a seed, otherwise null_index.
  Index seed(Index f) const { return group[f] < number_of_seeds ? group[f] : null_index; }
};

// Groups constrained faces. `number` holds the face of the mesh for each face of the caller; it is
// the same for all faces with the same points. Throws `std::invalid_argument` if constraints
// contradict each other.
class Constraint_grouping
{
  const Constraints& constraints_;
  const std::vector<Index>& number_;
  Face_components sets_;
  std::map<std::int64_t, Index> first_of_seed_; // the caller's index of the face

  [[noreturn]] static void fail(const std::string& what)
  { throw std::invalid_argument("segment_spectral_recursive: " + what); }

  static std::string faces(Index f, Index g)
  { return "the faces " + std::to_string(f) + " and " + std::to_string(g); }

  Index set_of(Index callers_face) { return sets_.representative(number_[callers_face]); }

  void join()
  {
    for (const auto& [f, g] : constraints_.must_link)
      sets_.join(number_[f], number_[g]);
    std::map<Index, std::pair<Index, std::int64_t> > seed_of_set; // a face and its seed
    for (const auto& constraint : constraints_.seeds) {
      const auto& [f, seed] = constraint;
      const auto& [g, other] = seed_of_set.emplace(set_of(f), constraint).first->second;
      if (other != seed)
        fail(faces(g, f) + " have the seeds " + std::to_string(other) + " and " +
             std::to_string(seed) + ", but are joined by edges that must not be cut, or are one "
             "face twice");
    }
    for (const auto& [f, seed] : constraints_.seeds)
      sets_.join(number_[first_of_seed_.emplace(seed, f).first->second], number_[f]);
    for (const auto& [f, g] : constraints_.cannot_link)
      if (set_of(f) == set_of(g))
        fail("the edge between " + faces(f, g) + " is constrained, but the two are joined by edges "
             "that must not be cut or by their seed, or are one face twice");
  }

  void check_components(const Surface& mesh) const
  {
    for (const auto& [f, seed] : constraints_.seeds) {
      const Index first = first_of_seed_.at(seed);
      if (mesh.components[number_[first]] != mesh.components[number_[f]])
        fail(faces(first, f) + " have the seed " + std::to_string(seed) +
             ", but are of components that are kept apart");
    }
  }

public:
  Constraint_grouping(const Constraints& constraints, const std::vector<Index>& number,
                      std::size_t number_of_faces)
    : constraints_(constraints), number_(number), sets_(number_of_faces)
  {
    for (Index f = 0; f < number_of_faces; ++f)
      sets_.add(f);
  }

  Constraint_groups operator()(const Surface& mesh, bool keep_components_separate)
  {
    join();
    if (keep_components_separate)
      check_components(mesh);
    Constraint_groups result;
    result.group.assign(mesh.number_of_faces(), null_index);
    std::vector<Index> group_of_set(mesh.number_of_faces(), null_index);
    const auto add = [&](Index callers_face) {
      Index& group = group_of_set[set_of(callers_face)];
      if (group == null_index)
        group = result.number++;
      result.group[number_[callers_face]] = group;
    };
    for (const auto& [f, seed] : constraints_.seeds)
      add(f);
    result.number_of_seeds = result.number;
    for (const auto& pairs : {&constraints_.cannot_link, &constraints_.must_link})
      for (const auto& [f, g] : *pairs) {
        add(f);
        add(g);
      }
    for (const auto& [f, g] : constraints_.cannot_link)
      result.cannot_link.push_back({number_[f], number_[g]});
    result.is_seam.assign(mesh.number_of_halfedges(), 0);
    for (const auto& [f, g] : result.cannot_link)
      for (Index i = 0; i < 3; ++i) {
        result.is_seam[3 * f + i] |= mesh.neighbor(3 * f + i) == g;
        result.is_seam[3 * g + i] |= mesh.neighbor(3 * g + i) == f;
      }
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINT_GROUPS_H
