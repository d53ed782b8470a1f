// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SCORE_MESH_H
#define SEGMENTATION_BENCHMARK_SCORE_MESH_H

#include "Method_trees.h"
#include "consensus_floor.h"
#include "segmentation_methods.h"
#include "timed.h"

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
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
};

// How a row does on a mesh.
struct Score
{
  Errors errors{};
  double segments = 0;
  double excess = 0; // of the Rand error over the consensus floor
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

inline Labels best_labels(const Segmentation_hierarchy& tree, const std::vector<Labels>& people)
{
  Labels best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = tree.number_of_roots(); n <= tree.number_of_segments(); ++n) {
    Labels labels = tree.labels(n, any_salience);
    const double error = mean_rand_error(labels, people);
    if (error < least) {
      least = error;
      best.swap(labels);
    }
  }
  return best;
}

class Mesh_scorer
{
  const Benchmark_mesh& input_;
  std::optional<double> threshold_;
  Mesh_facts facts_;
  std::vector<Segmentation> people_;
  std::size_t usual_number_;
  double floor_;
  std::map<std::string, Method_trees> trees_; // by the name of the method

  Score score(const Labels& labels, const Time& time) const
  {
    const Segmentation result = segmentation(facts_, labels);
    std::vector<Errors> all;
    for (const Segmentation& person : people_)
      all.push_back(errors(facts_, result, person));
    Score s;
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
    Mean segments;
    double least = std::numeric_limits<double>::infinity();
    Score s;
    for (const Segmentation& person : people_) {
      std::vector<Errors> of_person;
      for (const Segmentation& other : people_)
        if (&other != &person)
          of_person.push_back(errors(facts_, person, other));
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
    s.excess = s.errors[RAND_ERROR] - floor_;
    return s;
  }

  Score score(const Tree_method& method, Protocol protocol)
  {
    Method_trees& trees = trees_.try_emplace(method.name, method, input_.mesh).first->second;
    if (protocol == Protocol::AUTO) {
      const double threshold = threshold_.value_or(method.default_threshold);
      const Timed_tree& automatic = trees.down_to(threshold);
      return score(automatic.tree.labels(any_number, threshold), automatic.time);
    }
    const Timed_tree& whole = trees.up_to(usual_number_);
    return score(protocol == Protocol::K ? whole.tree.labels(usual_number_, any_salience)
                                         : best_labels(whole.tree, input_.people),
                 whole.time);
  }

  Score score(const Row& row)
  {
    for (const Tree_method& method : tree_methods())
      if (method.name == row.method)
        return score(method, row.protocol);
    if (row.method == people_method)
      return score_of_people();
    const auto [labels, time] = timed([&] { return default_labels(row.method, input_.mesh); });
    return score(labels, time);
  }

public:
  // The threshold, if any, is used in place of the default one of each method.
  Mesh_scorer(const Benchmark_mesh& input, std::optional<double> threshold)
    : input_(input), threshold_(threshold), facts_(mesh_facts(input.mesh)),
      usual_number_(segmentation_benchmark::usual_number_of_segments(input.people)),
      floor_(consensus_floor(input.people))
  {
    for (const Labels& labels : input.people)
      people_.push_back(segmentation(facts_, labels));
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
