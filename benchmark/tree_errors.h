// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_TREE_ERRORS_H
#define SEGMENTATION_BENCHMARK_TREE_ERRORS_H

#include "Method_trees.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

// The Rand errors of all that can be read off the trees of a mesh.
namespace segmentation_benchmark {

// Saliences at which a run may end.
inline const std::vector<double>& tried_thresholds()
{
  static const std::vector<double> thresholds = [] {
    std::vector<double> result;
    for (int percent = 30; percent <= 70; percent += 2)
      result.push_back(percent / 100.);
    return result;
  }();
  return thresholds;
}

struct Tree_errors
{
  int id = 0;
  double people = undefined;      // error between two people
  double by_default = undefined;  // error at the default threshold
  std::vector<double> automatic;  // errors at each threshold
  double k = undefined;           // error with people's usual number of parts
  double best = undefined;        // least error of all numbers of parts
  Time time;                      // time of the tree up to the largest number of parts
};

inline Tree_errors tree_errors(const Benchmark_mesh& input, const Tree_method& method)
{
  const double lowest = (std::min)(method.default_threshold, tried_thresholds().front());
  const std::size_t usual_number = usual_number_of_segments(input.people);
  Method_trees trees(method, input.mesh);
  const Segmentation_hierarchy& automatic = trees.down_to(lowest).tree;
  const auto& [whole, time] = trees.up_to(usual_number);
  const auto error = [&](const Labels& labels) { return mean_rand_error(labels, input.people); };
  Tree_errors result;
  result.id = input.id;
  result.people = mean_rand_error_of_people(input.people);
  result.by_default = error(labels_of_tree(automatic, method.default_threshold, any_number));
  for (double threshold : tried_thresholds())
    result.automatic.push_back(error(labels_of_tree(automatic, threshold, any_number)));
  result.k = error(labels_of_tree(whole, any_salience, usual_number));
  result.best = error(best_labels(whole, error));
  result.time = time;
  return result;
}

// Returns the mean errors, without the time.
inline Tree_errors mean_tree_errors(const std::vector<Tree_errors>& meshes)
{
  const auto mean = [&](const auto& error) {
    Mean result;
    for (const Tree_errors& mesh : meshes)
      result.add(error(mesh));
    return result();
  };
  Tree_errors result;
  result.people = mean([](const Tree_errors& e) { return e.people; });
  result.by_default = mean([](const Tree_errors& e) { return e.by_default; });
  for (std::size_t t = 0; t < tried_thresholds().size(); ++t)
    result.automatic.push_back(mean([t](const Tree_errors& e) { return e.automatic[t]; }));
  result.k = mean([](const Tree_errors& e) { return e.k; });
  result.best = mean([](const Tree_errors& e) { return e.best; });
  return result;
}

inline nlohmann::ordered_json json_of(const Tree_errors& errors)
{
  return {{"people", errors.people},
          {"auto", errors.by_default},
          {"auto_at_thresholds", errors.automatic},
          {"k", errors.k},
          {"tree", errors.best},
          {"seconds", errors.time.thread}};
}

// The position of the threshold of least error, the lowest of several.
inline std::size_t best_threshold(const Tree_errors& errors)
{
  return static_cast<std::size_t>(
    std::min_element(errors.automatic.begin(), errors.automatic.end()) -
    errors.automatic.begin());
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_TREE_ERRORS_H
