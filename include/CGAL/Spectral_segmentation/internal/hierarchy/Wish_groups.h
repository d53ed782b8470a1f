// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISH_GROUPS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISH_GROUPS_H

#include <CGAL/Spectral_segmentation/internal/Wishes.h>
#include <CGAL/Spectral_segmentation/internal/mesh/connected_components.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The wishes of a caller as groups of faces: each group lies in one segment. They have no
// contradiction.
struct Wish_groups
{
  std::vector<Index> group;        // of each face; null_index if no wish concerns it
  std::vector<Index> seed;         // of each group, from 0 on; null_index if it has none
  std::vector<Face_pair> seams;    // whose faces are of different groups and segments

  bool empty() const { return seed.empty(); }
};

// Makes groups of wishes. `number` has the face of the mesh for each face of the caller: one for
// all faces with the same points. Throws `std::invalid_argument` if wishes contradict each other.
class Wish_grouping
{
  typedef std::pair<Index, std::int64_t> Seed; // with the first face that has it

  const Wishes& wishes_;
  const std::vector<Index>& number_;
  Face_components sets_;
  std::map<std::int64_t, Index> first_of_seed_; // the caller's number of the face

  [[noreturn]] static void fail(const std::string& what)
  { throw std::invalid_argument("segment_spectral_recursive: " + what); }

  static std::string faces(Index f, Index g)
  { return "the faces " + std::to_string(f) + " and " + std::to_string(g); }

  Index set_of(Index callers_face) { return sets_.representative(number_[callers_face]); }

  void join()
  {
    for (const auto& [f, g] : wishes_.uncuttable)
      sets_.join(number_[f], number_[g]);
    std::map<Index, Seed> seed_of_set;
    for (const auto& [f, seed] : wishes_.seeds) {
      const auto [g, other] = seed_of_set.emplace(set_of(f), Seed(f, seed)).first->second;
      if (other != seed)
        fail(faces(g, f) + " have the seeds " + std::to_string(other) + " and " +
             std::to_string(seed) + ", but are joined by edges that must not be cut, or are one "
             "face twice");
    }
    for (const auto& [f, seed] : wishes_.seeds)
      sets_.join(number_[first_of_seed_.emplace(seed, f).first->second], number_[f]);
  }

  void check_seams()
  {
    for (const auto& [f, g] : wishes_.seams)
      if (set_of(f) == set_of(g))
        fail("the edge between " + faces(f, g) + " must be a seam, but the two are joined by edges "
             "that must not be cut or by their seed, or are one face twice");
  }

  void check_components(const std::vector<Index>& component)
  {
    for (const auto& [f, seed] : wishes_.seeds) {
      const Index first = first_of_seed_[seed];
      if (component[number_[first]] != component[number_[f]])
        fail(faces(first, f) + " have the seed " + std::to_string(seed) +
             ", but are of components that are kept apart");
    }
  }

public:
  Wish_grouping(const Wishes& wishes, const std::vector<Index>& number, std::size_t number_of_faces)
    : wishes_(wishes), number_(number), sets_(number_of_faces)
  {
    for (Index f = 0; f < number_of_faces; ++f)
      sets_.add(f);
  }

  Wish_groups operator()(const Face_graph& mesh, bool components_apart)
  {
    join();
    check_seams();
    if (components_apart) {
      std::size_t number_of_components;
      check_components(connected_components(mesh, number_of_components));
    }
    Wish_groups result;
    result.group.assign(mesh.number_of_faces(), null_index);
    std::vector<char> is_of_wish(mesh.number_of_faces(), 0);
    for (const auto& pairs : {&wishes_.seams, &wishes_.uncuttable})
      for (const auto& [f, g] : *pairs)
        is_of_wish[number_[f]] = is_of_wish[number_[g]] = 1;
    for (const auto& [f, seed] : wishes_.seeds)
      is_of_wish[number_[f]] = 1;
    std::vector<Index> group_of_set(mesh.number_of_faces(), null_index);
    for (Index f = 0; f < mesh.number_of_faces(); ++f) {
      if (!is_of_wish[f])
        continue;
      Index& group = group_of_set[sets_.representative(f)];
      if (group == null_index) {
        group = static_cast<Index>(result.seed.size());
        result.seed.push_back(null_index);
      }
      result.group[f] = group;
    }
    Index next_seed = 0;
    for (const auto& [value, f] : first_of_seed_)
      result.seed[result.group[number_[f]]] = next_seed++;
    for (const auto& [f, g] : wishes_.seams)
      result.seams.push_back({number_[f], number_[g]});
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_HIERARCHY_WISH_GROUPS_H
