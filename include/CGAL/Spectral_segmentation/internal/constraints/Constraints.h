// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINTS_H

#include <CGAL/Spectral_segmentation/internal/base/arrays.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

typedef std::array<Index, 2> Face_pair;

// What the caller demands of the segments, by his numbers of the faces. An edge is named by its two
// faces.
struct Constraints
{
  std::vector<Face_pair> seams;      // whose faces are of different segments
  std::vector<Face_pair> uncuttable; // whose faces are of one segment
  std::vector<std::pair<Index, std::int64_t> > seeds; // of faces, which ascend; not negative

  bool empty() const { return seams.empty() && uncuttable.empty() && seeds.empty(); }
};

// The constraints by the faces of the surface, without contradiction. Each group of faces lies in
// one segment.
struct Face_groups
{
  std::vector<Index> group;     // of each face; null_index if no constraint concerns it
  std::vector<Face_pair> seams; // whose faces are of different groups and segments
  std::vector<char> is_seam;    // of each half-edge
  Index number_of_seeds = 0;    // the first groups are those of the seeds, in different segments
  Index number = 0;

  // The group of a face if it has a seed.
  Index seed(Index f) const { return group[f] < number_of_seeds ? group[f] : null_index; }
};

// Makes groups of the constraints. `face` has the face of the surface for each face of the caller:
// one for all faces with the same points. Throws `std::invalid_argument` if constraints contradict
// each other.
class Face_grouping
{
  const Constraints& constraints_;
  const std::vector<Index>& face_;
  Joined_sets sets_;
  std::map<std::int64_t, Index> first_of_seed_; // the caller's number of the face

  [[noreturn]] static void fail(const std::string& what)
  { throw std::invalid_argument("segment_spectral_recursive: " + what); }

  static std::string faces(Index f, Index g)
  { return "the faces " + std::to_string(f) + " and " + std::to_string(g); }

  Index set_of(Index callers_face) { return sets_[face_[callers_face]]; }

  void join()
  {
    for (const auto& [f, g] : constraints_.uncuttable)
      sets_.join(face_[f], face_[g]);
    std::map<Index, std::pair<Index, std::int64_t> > seed_of_set; // with the first face that has it
    for (const auto& constraint : constraints_.seeds) {
      const auto& [f, seed] = constraint;
      const auto& [g, other] = seed_of_set.emplace(set_of(f), constraint).first->second;
      if (other != seed)
        fail(faces(g, f) + " have the seeds " + std::to_string(other) + " and " +
             std::to_string(seed) + ", but are joined by edges that must not be cut, or are one "
             "face twice");
    }
    for (const auto& [f, seed] : constraints_.seeds)
      sets_.join(face_[first_of_seed_.emplace(seed, f).first->second], face_[f]);
    for (const auto& [f, g] : constraints_.seams)
      if (set_of(f) == set_of(g))
        fail("the edge between " + faces(f, g) + " must be a seam, but the two are joined by edges "
             "that must not be cut or by their seed, or are one face twice");
  }

  void check_components(const Components& components) const
  {
    for (const auto& [f, seed] : constraints_.seeds) {
      const Index first = first_of_seed_.at(seed);
      if (components[face_[first]] != components[face_[f]])
        fail(faces(first, f) + " have the seed " + std::to_string(seed) +
             ", but are of components that are kept apart");
    }
  }

public:
  Face_grouping(const Constraints& constraints, const std::vector<Index>& face,
                std::size_t number_of_faces)
    : constraints_(constraints), face_(face), sets_(number_of_faces) {}

  Face_groups operator()(const Surface& surface, bool components_apart)
  {
    join();
    if (components_apart)
      check_components(surface.components);
    Face_groups result;
    result.group.assign(surface.number_of_faces(), null_index);
    std::vector<Index> group_of_set(surface.number_of_faces(), null_index);
    const auto add = [&](Index callers_face) {
      Index& group = group_of_set[set_of(callers_face)];
      if (group == null_index)
        group = result.number++;
      result.group[face_[callers_face]] = group;
    };
    for (const auto& [f, seed] : constraints_.seeds)
      add(f);
    result.number_of_seeds = result.number;
    for (const auto& pairs : {&constraints_.seams, &constraints_.uncuttable})
      for (const auto& [f, g] : *pairs) {
        add(f);
        add(g);
      }
    result.is_seam.assign(surface.number_of_halfedges(), 0);
    for (const auto& [callers_f, callers_g] : constraints_.seams) {
      const Index f = face_[callers_f], g = face_[callers_g];
      result.seams.push_back({f, g});
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (surface.neighbor(h) == g)
          result.is_seam[h] = result.is_seam[surface.opposite[h]] = 1;
    }
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CONSTRAINTS_CONSTRAINTS_H
