// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_FUZZ_RANDOM_CONSTRAINTS_H
#define SPECTRAL_SEGMENTATION_TEST_FUZZ_RANDOM_CONSTRAINTS_H

#include "run_of_soup.h"

#include <boost/pending/disjoint_sets.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

// Constraints at random, and what they mean.
namespace random_runs {

inline std::array<std::size_t, 2> faces_at(const Mesh& mesh, Mesh::Edge_index e)
{
  const Mesh::Halfedge_index h = mesh.halfedge(e);
  return {std::size_t(mesh.face(h)), std::size_t(mesh.face(mesh.opposite(h)))};
}

// Returns the faces within some steps over edges from a face at random.
inline std::vector<char> random_ball(const Mesh& mesh, Random& random)
{
  std::vector<char> result(num_faces(mesh), 0);
  result[random() % result.size()] = 1;
  for (std::size_t steps = random() % 5; steps > 0; --steps) {
    const std::vector<char> inner = result;
    for (Mesh::Edge_index e : mesh.edges())
      if (!mesh.is_border(e)) {
        const auto [f, g] = faces_at(mesh, e);
        if (inner[f] || inner[g])
          result[f] = result[g] = 1;
      }
  }
  return result;
}

// Adds seeds and, for a mesh, edges: single ones, the inside of a ball, or its boundary.
inline void add_constraints(std::size_t number_of_faces, const Mesh* mesh, Parameters& p,
                            Random& random)
{
  if (number_of_faces == 0)
    return;
  if (!mesh || one_in(random, 3)) {
    p.seeds.assign(number_of_faces, -1);
    const unsigned number_of_seeds = 1 + random() % 4;
    for (std::size_t n = random_number(random, 1, 6); n > 0; --n)
      p.seeds[random() % number_of_faces] = 5 * int(random() % number_of_seeds);
    if (!mesh || one_in(random, 2))
      return;
  }
  p.edges.assign(mesh->number_of_edges(), '-');
  for (std::size_t n = random() % 12; n > 0; --n)
    p.edges[random() % p.edges.size()] = one_in(random, 2) ? 'c' : 'u';
  for (std::size_t n = random() % 3; n > 0; --n) {
    const std::vector<char> ball = random_ball(*mesh, random);
    const bool is_inside = one_in(random, 2);
    for (Mesh::Edge_index e : mesh->edges())
      if (!mesh->is_border(e) && !one_in(random, 20)) {
        const auto [f, g] = faces_at(*mesh, e);
        if (is_inside && ball[f] && ball[g])
          p.edges[std::size_t(e)] = 'u';
        else if (!is_inside && ball[f] != ball[g])
          p.edges[std::size_t(e)] = 'c';
      }
  }
}

// Whether faces that must be together are joined with those that must be apart.
inline bool is_contradiction(const Mesh* mesh, const Parameters& p, std::size_t number_of_faces)
{
  std::vector<std::size_t> rank(number_of_faces), parent(number_of_faces);
  boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
  for (std::size_t f = 0; f < number_of_faces; ++f)
    sets.make_set(f);
  std::map<int, std::size_t> first;
  for (std::size_t f = 0; f < p.seeds.size(); ++f)
    if (p.seeds[f] >= 0)
      sets.union_set(first.emplace(p.seeds[f], f).first->second, f);
  const auto for_each_edge = [&](char kind, const auto& visit) {
    for (std::size_t e = 0; e < p.edges.size(); ++e)
      if (p.edges[e] == kind && !mesh->is_border(Mesh::Edge_index(unsigned(e)))) {
        const auto [f, g] = faces_at(*mesh, Mesh::Edge_index(unsigned(e)));
        visit(f, g);
      }
  };
  for_each_edge('u', [&](std::size_t f, std::size_t g) { sets.union_set(f, g); });
  std::set<std::size_t> seeded;
  bool result = false;
  for (const auto& [seed, f] : first)
    result |= !seeded.insert(sets.find_set(f)).second;
  for_each_edge('c', [&](std::size_t f, std::size_t g)
    { result |= sets.find_set(f) == sets.find_set(g); });
  return result;
}

inline void check_constraints(const Mesh* mesh, const Parameters& p, const Labels& labels,
                              const std::string& where)
{
  std::map<int, std::set<std::size_t> > segments_of;
  std::map<std::size_t, std::set<int> > seeds_in;
  for (std::size_t f = 0; f < p.seeds.size(); ++f)
    if (p.seeds[f] >= 0) {
      segments_of[p.seeds[f]].insert(labels[f]);
      seeds_in[labels[f]].insert(p.seeds[f]);
    }
  for (const auto& of_seed : segments_of)
    require(of_seed.second.size() == 1, "faces with one seed are in one segment of " + where);
  for (const auto& in_segment : seeds_in)
    require(in_segment.second.size() == 1, "seeds are in different segments of " + where);
  for (std::size_t e = 0; e < p.edges.size(); ++e)
    if (p.edges[e] != '-' && !mesh->is_border(Mesh::Edge_index(unsigned(e)))) {
      const auto [f, g] = faces_at(*mesh, Mesh::Edge_index(unsigned(e)));
      require((labels[f] == labels[g]) == (p.edges[e] == 'u'),
              std::string(p.edges[e] == 'u' ? "an uncuttable edge is not cut by "
                                            : "a constrained edge is cut by ") + where);
    }
}

// All nodes are between the roots and the leaves, so that these satisfy the constraints for all.
inline void check_constraints(const Mesh* mesh, const Parameters& p,
                              const Segmentation_hierarchy& h)
{
  check_constraints(mesh, p, h.labels(h.nodes(h.number_of_roots())), "the roots");
  check_constraints(mesh, p, h.labels(h.nodes(h.number_of_segments())), "the leaves");
}

} // namespace random_runs

#endif // SPECTRAL_SEGMENTATION_TEST_FUZZ_RANDOM_CONSTRAINTS_H
