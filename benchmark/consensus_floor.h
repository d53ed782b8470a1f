// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_CONSENSUS_FLOOR_H
#define SEGMENTATION_BENCHMARK_CONSENSUS_FLOOR_H

#include "princeton_benchmark.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// People disagree, so no one segmentation agrees with all of them. The least mean Rand error that
// one segmentation can have is NP-hard to find (it is correlation clustering); what is found here
// is an upper bound of it, by descent from each person's segmentation.
namespace segmentation_benchmark {

// Faces that nobody separates, but for the smallest of these sets, which were added to others.
struct Atoms
{
  Labels atom_of_face;
  std::vector<double> sizes;                         // number of faces
  std::vector<std::vector<std::size_t> > labels;     // one list per atom, with one label per person
};

// The sets of faces that nobody separates, the largest first.
inline Atoms all_atoms(const std::vector<Labels>& people)
{
  std::map<std::vector<std::size_t>, std::vector<std::size_t> > faces_of_labels;
  for (std::size_t f = 0; f < people.front().size(); ++f) {
    std::vector<std::size_t> labels;
    for (const Labels& person : people)
      labels.push_back(person[f]);
    faces_of_labels[labels].push_back(f);
  }
  typedef decltype(faces_of_labels)::const_pointer Entry;
  std::vector<Entry> entries;
  for (const auto& entry : faces_of_labels)
    entries.push_back(&entry);
  std::stable_sort(entries.begin(), entries.end(), [](Entry a, Entry b)
                   { return a->second.size() > b->second.size(); });

  Atoms atoms;
  atoms.atom_of_face.resize(people.front().size());
  for (Entry entry : entries) {
    for (std::size_t f : entry->second)
      atoms.atom_of_face[f] = atoms.sizes.size();
    atoms.sizes.push_back(static_cast<double>(entry->second.size()));
    atoms.labels.push_back(entry->first);
  }
  return atoms;
}

// The share of the people who join two atoms.
inline double agreement(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b)
{
  int number = 0;
  for (std::size_t person = 0; person < a.size(); ++person)
    number += a[person] == b[person];
  return number / static_cast<double>(a.size());
}

// Leaves the `maximum` largest atoms. Each other is added to the one that most people join it with.
inline void absorb_small_atoms(Atoms& atoms, std::size_t maximum)
{
  if (atoms.sizes.size() <= maximum)
    return;
  std::vector<std::size_t> host(atoms.sizes.size());
  for (std::size_t i = 0; i < host.size(); ++i) {
    host[i] = i;
    if (i < maximum)
      continue;
    double best = -1;
    for (std::size_t j = 0; j < maximum; ++j) {
      const double share = agreement(atoms.labels[i], atoms.labels[j]);
      if (share > best) {
        best = share;
        host[i] = j;
      }
    }
    atoms.sizes[host[i]] += atoms.sizes[i];
  }
  for (std::size_t& atom : atoms.atom_of_face)
    atom = host[atom];
  atoms.sizes.resize(maximum);
  atoms.labels.resize(maximum);
}

// Returns the costs of joining two atoms, in proportion to the mean Rand error: the number of their
// pairs of faces, times the fraction of people who separate them less the fraction who do not.
inline Eigen::MatrixXd costs_of_joining(const Atoms& atoms)
{
  const Eigen::Index n = static_cast<Eigen::Index>(atoms.sizes.size());
  Eigen::MatrixXd costs = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      costs(i, j) = costs(j, i) =
        atoms.sizes[i] * atoms.sizes[j] * (1 - 2 * agreement(atoms.labels[i], atoms.labels[j]));
  return costs;
}

// A partition of the atoms that moves of atoms and unions of parts make better.
class Consensus
{
  const Eigen::MatrixXd& costs_;
  std::vector<std::size_t> part_of_atom_;
  Eigen::MatrixXd costs_in_part_; // rows: atoms; columns: parts, the last of which is empty

  // A change below this is rounding: costs are multiples of 1 / number of people.
  static constexpr double least_gain = 1e-6;

  void add_empty_part()
  {
    costs_in_part_.conservativeResize(Eigen::NoChange, costs_in_part_.cols() + 1);
    costs_in_part_.rightCols<1>().setZero();
  }

  void move(std::size_t atom, std::size_t part)
  {
    costs_in_part_.col(part_of_atom_[atom]) -= costs_.col(atom);
    costs_in_part_.col(part) += costs_.col(atom);
    part_of_atom_[atom] = part;
    if (part + 1 == static_cast<std::size_t>(costs_in_part_.cols()))
      add_empty_part();
  }

  bool move_atoms()
  {
    bool has_moved = false;
    for (std::size_t atom = 0; atom < part_of_atom_.size(); ++atom) {
      Eigen::Index best;
      const double cost = costs_in_part_.row(atom).minCoeff(&best);
      if (cost < costs_in_part_(atom, part_of_atom_[atom]) - least_gain) {
        move(atom, best);
        has_moved = true;
      }
    }
    return has_moved;
  }

  // Costs of joining each pair of parts.
  Eigen::MatrixXd costs_of_union() const
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(costs_in_part_.cols(), costs_in_part_.cols());
    for (std::size_t atom = 0; atom < part_of_atom_.size(); ++atom)
      result.row(part_of_atom_[atom]) += costs_in_part_.row(atom);
    result.diagonal().setZero();
    return result;
  }

  bool unite_parts()
  {
    Eigen::Index a, b;
    if (costs_of_union().minCoeff(&a, &b) > -least_gain)
      return false;
    for (std::size_t atom = 0; atom < part_of_atom_.size(); ++atom)
      if (part_of_atom_[atom] == static_cast<std::size_t>(b))
        move(atom, a);
    return true;
  }

public:
  Consensus(const Eigen::MatrixXd& costs, const std::vector<std::size_t>& start)
    : costs_(costs), part_of_atom_(start)
  {
    costs_in_part_ = Eigen::MatrixXd::Zero(costs.rows(), number_of_segments(start) + 1);
    for (std::size_t atom = 0; atom < start.size(); ++atom)
      costs_in_part_.col(start[atom]) += costs.col(atom);
  }

  const std::vector<std::size_t>& operator()()
  {
    while (move_atoms() || unite_parts()) {}
    return part_of_atom_;
  }
};

// The least mean Rand error that was found for one segmentation with respect to all people:
// an upper bound of the least that there is.
inline double consensus_floor(const std::vector<Labels>& people,
                              std::size_t maximum_number_of_atoms = 600)
{
  Atoms atoms = all_atoms(people);
  absorb_small_atoms(atoms, maximum_number_of_atoms);
  const Eigen::MatrixXd costs = costs_of_joining(atoms);
  double floor = 1;
  for (std::size_t person = 0; person < people.size(); ++person) {
    std::vector<std::size_t> start;
    for (const std::vector<std::size_t>& labels : atoms.labels)
      start.push_back(labels[person]);
    const std::vector<std::size_t> part_of_atom = Consensus(costs, start)();
    Labels consensus;
    for (std::size_t atom : atoms.atom_of_face)
      consensus.push_back(part_of_atom[atom]);
    floor = (std::min)({floor, mean_rand_error(people[person], people),
                        mean_rand_error(contiguous(consensus), people)});
  }
  return floor;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_CONSENSUS_FLOOR_H
