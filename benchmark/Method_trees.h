// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_METHOD_TREES_H
#define SEGMENTATION_BENCHMARK_METHOD_TREES_H

#include "segmentation_methods.h"
#include "timed.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <utility>

namespace segmentation_benchmark {

// The least number of segments into which a tree is cut, which is more than people make.
constexpr std::size_t number_of_segments_of_tree = 20;

struct Timed_tree
{
  Segmentation_hierarchy tree;
  Time time;
};

// The trees of a method on a mesh or a triangle soup. Each is made when it is first requested, and
// kept.
class Method_trees
{
  bool has_whole_trees_;
  std::function<Segmentation_hierarchy(double, std::size_t)> segment_;
  std::map<std::pair<double, std::size_t>, Timed_tree> trees_; // by the arguments of the run

  const Timed_tree& run(double threshold, std::size_t maximum_number_of_segments)
  {
    const std::pair<double, std::size_t> arguments(threshold, maximum_number_of_segments);
    const auto found = trees_.find(arguments);
    if (found != trees_.end())
      return found->second;
    auto [tree, time] = timed([&] { return segment_(threshold, maximum_number_of_segments); });
    return trees_.emplace(arguments, Timed_tree{std::move(tree), time}).first->second;
  }

public:
  Method_trees(const Tree_method& method, const Mesh& mesh)
    : has_whole_trees_(method.has_whole_trees),
      segment_([&](double threshold, std::size_t n) { return method.segment(mesh, threshold, n); })
  {}

  Method_trees(const Tree_method& method, const Triangle_soup& soup)
    : has_whole_trees_(method.has_whole_trees),
      segment_([&](double threshold, std::size_t n)
               { return method.segment_soup(soup, threshold, n); })
  {}

  // Returns a tree with the labels for this threshold and all higher ones.
  const Timed_tree& down_to(double threshold)
  { return has_whole_trees_ ? up_to(1) : run(threshold, any_number); }

  // Returns a tree with the labels for so many segments and all smaller numbers.
  const Timed_tree& up_to(std::size_t number_of_segments)
  { return run(any_salience, (std::max)(number_of_segments, number_of_segments_of_tree)); }
};

// Returns the labels of the tree with the least error(labels), for any number of segments.
template <class Error>
Labels best_labels(const Segmentation_hierarchy& tree, const Error& error_of)
{
  Labels best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = tree.number_of_roots(); n <= tree.number_of_segments(); ++n) {
    Labels labels = labels_of_tree(tree, any_salience, n);
    const double error = error_of(labels);
    if (error < least) {
      least = error;
      best.swap(labels);
    }
  }
  return best;
}

// The errors that can be read off the trees of a mesh.
struct Tree_errors
{
  double by_default; // error at the default threshold
  double k;          // error with people's usual number of parts
  double best;       // least error of all numbers of parts
  double seconds;    // of one thread, for the tree up to the largest number of parts
};

inline Tree_errors tree_errors(const Benchmark_mesh& input, const Tree_method& method)
{
  const std::size_t usual_number = usual_number_of_segments(input.people);
  Method_trees trees(method, input.mesh);
  const double threshold = method.default_threshold;
  const Segmentation_hierarchy& automatic = trees.down_to(threshold).tree;
  const auto& [whole, time] = trees.up_to(usual_number);
  const auto error = [&](const Labels& labels) { return mean_rand_error(labels, input.people); };
  return {error(labels_of_tree(automatic, threshold, any_number)),
          error(labels_of_tree(whole, any_salience, usual_number)),
          error(best_labels(whole, error)), time.thread};
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_METHOD_TREES_H
