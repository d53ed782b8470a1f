// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SCORE_MESH_H
#define SEGMENTATION_BENCHMARK_SCORE_MESH_H

#include "Method_trees.h"
#include "mirror_metrics.h"
#include "part_metrics.h"
#include "segmentation_methods.h"
#include "timed.h"
#include "triangulations.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace segmentation_benchmark {

// The information that a method gets. AUTO: none. K: the usual number of people's parts. TREE: the
// number of parts, of all that the tree of cuts can give, with the smallest Rand error.
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

// The quality of a row on a mesh.
struct Score
{
  Errors errors;
  Part_agreement parts;
  double segments = 0;
  double seconds = 0;
};

struct Scored_mesh
{
  int id = 0;
  double people_error = 0;   // mean Rand error of two people
  std::vector<Score> scores; // one a row
};

class Mesh_scorer
{
  const Benchmark_mesh& input_;
  std::optional<double> threshold_;
  std::filesystem::path cache_;
  Mesh_facts facts_;
  Mirror_scorer mirror_scorer_;
  std::vector<Segmentation> people_;
  std::size_t usual_number_;
  std::map<std::string, Retriangulated_mesh> meshes_; // indexed by the name of the triangulation
  std::map<std::pair<std::string, std::string>, Method_trees> trees_; // method, triangulation

  // Compares a segmentation with all people but itself.
  Score score(const Segmentation& result) const
  {
    std::vector<Errors> all;
    std::vector<Eigen::ArrayXXd> overlaps;
    for (const Segmentation& person : people_)
      if (&person != &result) {
        all.push_back(errors(facts_, result, person));
        overlaps.push_back(overlap(result.labels, person.labels));
      }
    Score of_result{mean_errors(all), part_agreement(overlaps),
                    static_cast<double>(number_of_segments(result.labels))};
    mirror_scorer_.set(of_result.parts, result.labels);
    return of_result;
  }

  Score score(const Labels& labels, const Time& time) const
  {
    Score result = score(segmentation(facts_, labels));
    result.seconds = time.wall;
    return result;
  }

  // Returns the mean of the scores of all people; nothing is defined for one person.
  Score score_of_people() const
  {
    std::vector<Errors> errors;
    std::vector<Part_agreement> parts;
    Mean segments;
    for (const Segmentation& person : people_) {
      if (people_.size() > 1) {
        const Score of_person = score(person);
        errors.push_back(of_person.errors);
        parts.push_back(of_person.parts);
      }
      segments.add(static_cast<double>(number_of_segments(person.labels)));
    }
    return {mean_errors(errors), mean_agreement(parts), segments()};
  }

  const Retriangulated_mesh& mesh(const std::string& triangulation)
  {
    const auto found = meshes_.find(triangulation);
    if (found != meshes_.end())
      return found->second;
    return meshes_.emplace(triangulation,
                           retriangulated(triangulation, input_.mesh, cache_,
                                          std::to_string(input_.id))).first->second;
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
    return score(carried_back(of_row, labels), found.time);
  }

  Score score(const Row& row)
  {
    if (const Tree_method* method = tree_method(row.method))
      return score(*method, row);
    if (row.method == people_method)
      return score_of_people();
    const Retriangulated_mesh& of_row = mesh(row.triangulation);
    const auto [labels, time] = timed([&] { return default_labels(row.method, of_row.mesh); });
    return score(carried_back(of_row, labels), time);
  }

public:
  // Takes a threshold, if any, to be used in place of the default one of each method, and a folder
  // for changed meshes, or an empty path.
  Mesh_scorer(const Benchmark_mesh& input, std::optional<double> threshold,
              std::filesystem::path cache = {})
    : input_(input), threshold_(threshold), cache_(std::move(cache)),
      facts_(mesh_facts(input.mesh)), mirror_scorer_(input.mesh),
      usual_number_(usual_number_of_segments(input.people))
  {
    for (const Labels& labels : input.people)
      people_.push_back(segmentation(facts_, labels));
  }

  Scored_mesh operator()(const std::vector<Row>& rows)
  {
    Scored_mesh result;
    result.id = input_.id;
    result.people_error = mean_rand_error_of_people(input_.people);
    for (const Row& row : rows)
      result.scores.push_back(score(row));
    return result;
  }
};

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SCORE_MESH_H
