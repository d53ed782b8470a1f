// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_FUZZ_RANDOM_CONSTRAINTS_H
#define SPECTRAL_SEGMENTATION_TEST_FUZZ_RANDOM_CONSTRAINTS_H

#include "Face_constraints.h"
#include "run_of_soup.h"

#include <cstddef>
#include <string>
#include <vector>

// Constraints at random, and their meaning.
namespace random_runs {

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

inline Face_constraints face_constraints(const Mesh* mesh, const Parameters& p)
{
  Face_constraints result;
  result.seeds = p.seeds;
  for (std::size_t i = 0; i < p.edges.size(); ++i) {
    const Mesh::Edge_index e(static_cast<unsigned>(i));
    if (p.edges[i] != '-' && !mesh->is_border(e))
      (p.edges[i] == 'c' ? result.apart : result.together).push_back(faces_at(*mesh, e));
  }
  return result;
}

inline void check_constraints(const Mesh* mesh, const Parameters& p, const Labels& labels,
                              const std::string& where)
{
  const std::vector<std::string> violations = face_constraints(mesh, p).violations(labels);
  if (!violations.empty())
    throw Broken_invariant(violations.front() + ", in " + where);
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
