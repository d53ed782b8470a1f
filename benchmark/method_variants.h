// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_METHOD_VARIANTS_H
#define SEGMENTATION_BENCHMARK_METHOD_VARIANTS_H

#include "run_engine.h"
#include "segmentation_methods.h"

#include <cstddef>
#include <vector>

// The default method, and variants without one of its elements.
namespace segmentation_benchmark {

inline Tree_method method_with(const char* name, const Engine_options& options,
                               Execution execution = Execution::SEQUENTIAL)
{
  const auto segment = [=](const Mesh& mesh, double threshold, std::size_t n) {
    Engine_options o = options;
    o.salience_threshold = threshold;
    o.maximum_number_of_segments = n;
    return run_engine(mesh, o, execution);
  };
  return {name, CGAL::Spectral_segmentation::threshold_of(options),
          options.method == CGAL::Spectral_segmentation::Method::CALIBRATED, segment};
}

struct Method_variant
{
  const char* name;
  void (*change)(Engine_options&);
};

// Returns the default method, and variants in which one element is left out or the paper's.
inline const std::vector<Method_variant>& method_variants()
{
  static const std::vector<Method_variant> variants = {
    {"all of it", [](Engine_options&) {}},
    {"dihedral angles", [](Engine_options& o) { o.concavity_radius = 0; }},
    {"one search", [](Engine_options& o) { o.number_of_searches = 1; }},
    {"no minimum cuts", [](Engine_options& o) { o.number_of_refined_candidates = 0; }},
    {"no coarsening", [](Engine_options& o) { o.number_of_coarse_faces = 0; }},
    {"no bisection", [](Engine_options& o) { o.bisection = false; }},
    {"paper's geodesic weight", [](Engine_options& o) { o.geodesic_weight = 0.01; }},
    {"paper's part salience", [](Engine_options& o)
      { o.part_salience = CGAL::Spectral_segmentation::Weighted_part_salience(); }},
  };
  return variants;
}

inline std::vector<Tree_method> ablated_methods()
{
  std::vector<Tree_method> result;
  for (const Method_variant& variant : method_variants()) {
    Engine_options options;
    variant.change(options);
    result.push_back(method_with(variant.name, options));
  }
  return result;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_METHOD_VARIANTS_H
