// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_METHOD_VARIANTS_H
#define SEGMENTATION_BENCHMARK_METHOD_VARIANTS_H

#include "segmentation_methods.h"

#include <CGAL/Spectral_segmentation/internal/Options.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

// The two methods of the package, and what lies between them.
namespace segmentation_benchmark {

typedef CGAL::Spectral_segmentation::internal::Options Method_options;

// A difference between the methods, which can be taken over alone.
struct Method_switch
{
  const char* name;
  void (*take)(Method_options& to, const Method_options& from);
};

template <auto... members>
void take(Method_options& to, const Method_options& from)
{ ((to.*members = from.*members), ...); }

inline const std::vector<Method_switch>& method_switches()
{
  static const std::vector<Method_switch> switches = {
    {"concavity_radius", take<&Method_options::concavity_radius>},
    {"single_source_orderings", take<&Method_options::single_source_orderings>},
    {"thickness_orderings", take<&Method_options::thickness_orderings>},
    {"number_of_candidates", take<&Method_options::number_of_candidates>},
    {"number_of_refined_candidates", take<&Method_options::number_of_refined_candidates>},
    {"number_of_searched_faces", take<&Method_options::number_of_searched_faces>},
    {"number_of_regions", take<&Method_options::number_of_regions>},
    {"geodesic_weight", take<&Method_options::geodesic_weight>},
    {"minimum_segment_size", take<&Method_options::minimum_segment_size>},
  };
  return switches;
}

inline const Method_switch& salience_switch()
{
  static const Method_switch salience = {
    "part_salience", take<&Method_options::part_salience, &Method_options::salience_threshold>};
  return salience;
}

// Without candidates it would be called with the factors of the paper alone, and have no sense.
inline const Method_switch& salience_switch_with_candidates()
{
  static const Method_switch salience = {
    "part_salience + candidates",
    take<&Method_options::part_salience, &Method_options::salience_threshold,
         &Method_options::number_of_candidates>};
  return salience;
}

// On one thread.
inline Tree_method method_with(const char* name, const Method_options& o)
{
  const auto segment = [o](const Mesh& mesh, double threshold, std::size_t n) {
    return hierarchy<CGAL::Sequential_tag>(
      mesh, params::part_salience(o.part_salience)
              .salience_threshold(threshold)
              .maximum_number_of_segments(n)
              .concavity_radius(o.concavity_radius)
              .single_source_orderings(o.single_source_orderings)
              .thickness_orderings(o.thickness_orderings)
              .number_of_candidates(o.number_of_candidates)
              .number_of_refined_candidates(o.number_of_refined_candidates)
              .number_of_regions(o.number_of_regions)
              .number_of_searched_faces(o.number_of_searched_faces)
              .geodesic_weight(o.geodesic_weight)
              .minimum_segment_size(o.minimum_segment_size));
  };
  return {name, o.salience_threshold, o.number_of_regions > 0, segment};
}

// A method, and the same with one switch at a time put to the value of the other method.
struct Method_block
{
  const char* title;
  std::vector<Tree_method> methods;
};

inline Method_block method_block(const char* title, const char* name, const Method_options& method,
                                 const Method_options& other,
                                 const Method_switch& switch_of_salience)
{
  Method_block block{title, {method_with(name, method)}};
  std::vector<Method_switch> switches = method_switches();
  switches.push_back(switch_of_salience);
  for (const Method_switch& s : switches) {
    Method_options variant = method;
    s.take(variant, other);
    block.methods.push_back(method_with(s.name, variant));
  }
  return block;
}

inline const std::vector<Method_block>& method_blocks()
{
  static const std::vector<Method_block> blocks = [] {
    const Method_options paper,
      calibrated = CGAL::Spectral_segmentation::internal::calibrated_options();
    return std::vector<Method_block>{
      method_block("One switch put to the paper's value", "calibrated", calibrated, paper,
                   salience_switch()),
      method_block("One switch put to the calibrated value", "paper", paper, calibrated,
                   salience_switch_with_candidates())};
  }();
  return blocks;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_METHOD_VARIANTS_H
