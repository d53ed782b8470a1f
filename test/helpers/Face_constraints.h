// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_FACE_CONSTRAINTS_H
#define SPECTRAL_SEGMENTATION_TEST_FACE_CONSTRAINTS_H

#include "test_meshes.h"

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/vector_property_map.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

typedef std::array<std::size_t, 2> Two_faces;

inline Two_faces faces_at(const test_meshes::Mesh& mesh, test_meshes::Mesh::Edge_index e)
{
  const auto h = mesh.halfedge(e);
  return {std::size_t(mesh.face(h)), std::size_t(mesh.face(mesh.opposite(h)))};
}

// Constraints and their meaning, by definition.
struct Face_constraints
{
  std::vector<int> seeds; // of the faces; negative for none. Empty if no face has one
  std::vector<Two_faces> apart, together; // the faces at edges

  // Returns whether faces that must be together are joined with those that must be apart.
  bool are_contradictory(std::size_t number_of_faces) const
  {
    // Not pointers: a function of Boost's sparse row graphs, which CGAL 6 includes, hides theirs.
    const boost::vector_property_map<std::size_t> rank(number_of_faces), parent(number_of_faces);
    boost::disjoint_sets<decltype(rank), decltype(parent)> sets(rank, parent);
    for (std::size_t f = 0; f < number_of_faces; ++f)
      sets.make_set(f);
    std::map<int, std::size_t> first;
    for (std::size_t f = 0; f < seeds.size(); ++f)
      if (seeds[f] >= 0)
        sets.union_set(first.emplace(seeds[f], f).first->second, f);
    for (const auto& [f, g] : together)
      sets.union_set(f, g);
    std::set<std::size_t> seeded;
    for (const auto& of_seed : first)
      if (!seeded.insert(sets.find_set(of_seed.second)).second)
        return true;
    for (const auto& [f, g] : apart)
      if (sets.find_set(f) == sets.find_set(g))
        return true;
    return false;
  }

  // Returns the constraints that these labels violate.
  std::vector<std::string> violations(const std::vector<std::size_t>& labels) const
  {
    std::vector<std::string> result;
    const auto check = [&](bool holds, const char* constraint) {
      if (!holds)
        result.push_back(constraint);
    };
    std::map<int, std::set<std::size_t> > segments_of_seed;
    std::map<std::size_t, std::set<int> > seeds_of_segment;
    for (std::size_t f = 0; f < seeds.size(); ++f)
      if (seeds[f] >= 0) {
        segments_of_seed[seeds[f]].insert(labels[f]);
        seeds_of_segment[labels[f]].insert(seeds[f]);
      }
    for (const auto& entry : segments_of_seed)
      check(entry.second.size() == 1, "faces with one seed are in one segment");
    for (const auto& entry : seeds_of_segment)
      check(entry.second.size() == 1, "faces with different seeds are in different segments");
    for (const auto& [f, g] : apart)
      check(labels[f] != labels[g], "a constrained edge is between segments");
    for (const auto& [f, g] : together)
      check(labels[f] == labels[g], "an uncuttable edge is within a segment");
    return result;
  }
};

#endif // SPECTRAL_SEGMENTATION_TEST_FACE_CONSTRAINTS_H
