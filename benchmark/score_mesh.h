// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SCORE_MESH_H
#define SEGMENTATION_BENCHMARK_SCORE_MESH_H

#include "Method_trees.h"
#include "assembled_meshes.h"
#include "congruent_parts.h"
#include "consensus_floor.h"
#include "partner_cuts.h"
#include "segmentation_methods.h"
#include "timed.h"
#include "triangulations.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace segmentation_benchmark {

// AUTO: nothing is given. K: the usual number of people's parts is given. TREE: of all numbers of
// parts that the tree of cuts can give, the one with the smallest Rand error.
enum class Protocol { AUTO, K, TREE, OTHERS };

constexpr std::array<const char*, 4> protocol_names = {"auto", "k", "tree", "others"};

inline const char* name(Protocol protocol)
{ return protocol_names[static_cast<std::size_t>(protocol)]; }

// A row of the tables. Protocol OTHERS is for people, each of whom is compared with the others.
struct Row
{
  std::string method;
  Protocol protocol;
  std::string triangulation = triangulation_names().front(); // the mesh is segmented in it
};

// How a row does on a mesh.
struct Score
{
  Errors errors{};
  double segments = 0;
  double excess = 0; // the Rand error less the consensus floor
  double congruent = 0; // fraction of people's classes of congruent parts that are treated alike
  Partner_counts partners{undefined, undefined}; // of a tree
  double seconds = 0;
  Labels labels;
};

struct Scored_mesh
{
  int id = 0;
  std::size_t faces = 0;
  std::size_t people = 0;
  std::size_t usual_number_of_segments = 0;
  double floor = 0;
  double people_error = 0; // mean Rand error of each person with respect to the others
  std::vector<Score> scores; // one a row
};

class Mesh_scorer
{
  const Benchmark_mesh& input_;
  std::optional<double> threshold_;
  std::filesystem::path cache_;
  Mesh_facts facts_;
  std::vector<Segmentation> people_;
  std::vector<std::vector<Congruent_parts> > congruent_parts_; // one list per person
  std::size_t usual_number_;
  double floor_;
  std::map<std::string, Retriangulated_mesh> meshes_; // indexed by the name of the triangulation
  std::map<std::pair<std::string, std::string>, Method_trees> trees_; // method, triangulation

  // Undefined if the person has made no congruent parts.
  double fraction_of_congruent_parts(std::size_t person, const Labels& labels) const
  {
    return share_treated_alike(congruent_parts_[person],
                               overlap(people_[person].labels, labels, facts_.face_areas));
  }

  Score score(const Labels& labels, const Time& time) const
  {
    const Segmentation result = segmentation(facts_, labels);
    std::vector<Errors> all;
    Mean congruent;
    for (std::size_t person = 0; person < people_.size(); ++person) {
      all.push_back(errors(facts_, result, people_[person]));
      congruent.add(fraction_of_congruent_parts(person, labels));
    }
    Score s;
    s.congruent = congruent();
    s.errors = mean_errors(all);
    s.segments = static_cast<double>(number_of_segments(labels));
    s.excess = s.errors[RAND_ERROR] - floor_;
    s.seconds = time.wall;
    s.labels = labels;
    return s;
  }

  // The labels are those of the person who agrees best with the others.
  Score score_of_people() const
  {
    std::vector<Errors> all;
    Mean segments, congruent;
    double least = std::numeric_limits<double>::infinity();
    Score s;
    for (const Segmentation& person : people_) {
      std::vector<Errors> of_person;
      for (std::size_t other = 0; other < people_.size(); ++other)
        if (&people_[other] != &person) {
          of_person.push_back(errors(facts_, person, people_[other]));
          congruent.add(fraction_of_congruent_parts(other, person.labels));
        }
      all.insert(all.end(), of_person.begin(), of_person.end());
      segments.add(static_cast<double>(number_of_segments(person.labels)));
      const double error = mean_errors(of_person)[RAND_ERROR];
      if (error < least) {
        least = error;
        s.labels = person.labels;
      }
    }
    s.errors = mean_errors(all);
    s.segments = segments();
    s.congruent = congruent();
    s.excess = s.errors[RAND_ERROR] - floor_;
    return s;
  }

  Retriangulated_mesh retriangulated(const std::string& triangulation) const
  {
    if (is_assembly(triangulation))
      return assembled(triangulation, input_.mesh, input_.people.front(),
                       static_cast<std::uint64_t>(input_.id));
    return segmentation_benchmark::retriangulated(triangulation, input_.mesh, cache_,
                                                  std::to_string(input_.id));
  }

  const Retriangulated_mesh& mesh(const std::string& triangulation)
  {
    const auto found = meshes_.find(triangulation);
    if (found != meshes_.end())
      return found->second;
    return meshes_.emplace(triangulation, retriangulated(triangulation)).first->second;
  }

  Score score(const Tree_method& method, const Row& row)
  {
    const Retriangulated_mesh& of_row = mesh(row.triangulation);
    Method_trees& trees =
      trees_.try_emplace({row.method, row.triangulation}, method, of_row.mesh).first->second;
    const double threshold = threshold_.value_or(method.default_threshold);
    const bool is_auto = row.protocol == Protocol::AUTO;
    const Timed_tree& found = is_auto ? trees.down_to(threshold) : trees.up_to(usual_number_);
    const Labels labels = is_auto ? labels_of_tree(found.tree, threshold, any_number)
      : row.protocol == Protocol::K ? labels_of_tree(found.tree, any_salience, usual_number_)
      : best_labels(found.tree, [&](const Labels& of_tree)
          { return mean_rand_error(carried_back(of_row, of_tree), input_.people); });
    Score result = score(carried_back(of_row, labels), found.time);
    if (method.has_whole_trees || !is_auto) // else all cuts of the tree are made
      result.partners = partner_counts(of_row.mesh, found.tree, labels);
    return result;
  }

  Score score(const Row& row)
  {
    for (const Tree_method& method : tree_methods())
      if (method.name == row.method)
        return score(method, row);
    if (row.method == people_method)
      return score_of_people();
    const Retriangulated_mesh& of_row = mesh(row.triangulation);
    const auto [labels, time] = timed([&] { return default_labels(row.method, of_row.mesh); });
    return score(carried_back(of_row, labels), time);
  }

public:
  // The threshold, if any, is used in place of the default one of each method. The cache is a
  // folder of changed meshes, or empty.
  Mesh_scorer(const Benchmark_mesh& input, std::optional<double> threshold,
              std::filesystem::path cache = {})
    : input_(input), threshold_(threshold), cache_(std::move(cache)),
      facts_(mesh_facts(input.mesh)),
      usual_number_(segmentation_benchmark::usual_number_of_segments(input.people)),
      floor_(consensus_floor(input.people))
  {
    const std::vector<Moments> moments = face_moments(input.mesh, facts_.face_areas);
    for (const Labels& labels : input.people) {
      people_.push_back(segmentation(facts_, labels));
      congruent_parts_.push_back(congruent_parts(part_shapes(moments, labels)));
    }
  }

  Scored_mesh operator()(const std::vector<Row>& rows)
  {
    Scored_mesh result;
    result.id = input_.id;
    result.faces = input_.mesh.number_of_faces();
    result.people = people_.size();
    result.usual_number_of_segments = usual_number_;
    result.floor = floor_;
    result.people_error = score_of_people().errors[RAND_ERROR];
    for (const Row& row : rows)
      result.scores.push_back(score(row));
    return result;
  }
};

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SCORE_MESH_H
