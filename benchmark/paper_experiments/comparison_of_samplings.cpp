// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../evaluation.h"
#include "experiments.h"
#include "face_samples.h"
#include "parts.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <vector>

// Figure 3 and Section 4: how often the two samples lie in different parts.
namespace segmentation_benchmark {
namespace {

constexpr std::size_t number_of_schemes = sampling_schemes.size();

// The number of trials at each part of schemes that depend on a random face.
constexpr int number_of_trials = 5;

// Returns the fraction that has the two faces in different segments, among the people who have two
// segments or more in the part.
double share_that_separates(const std::vector<Labels>& people_in_part, Index s, Index t)
{
  Mean fraction;
  for (const Labels& person : people_in_part)
    if (number_of_segments(person) > 1)
      fraction.add(person[s] != person[t]);
  return fraction();
}

double separation(const Part& part, const std::vector<Labels>& people,
                  const Sampling_scheme& scheme, Random_engine& random)
{
  std::vector<Labels> people_in_part;
  for (const Labels& person : people)
    people_in_part.push_back(labels_of_part(part, person));
  Mean fraction;
  for (int i = 0; i < (scheme.take == samples_by_contexts ? 1 : number_of_trials); ++i) {
    const std::vector<Index> samples = scheme.take(part.graph, 2, random);
    fraction.add(share_that_separates(people_in_part, samples[0], samples[1]));
  }
  return fraction();
}

typedef std::array<double, number_of_schemes> Values; // indexed by scheme

// Returns the separations at each part of the recursion by shape context.
std::vector<Values> separations(const Benchmark_mesh& input, const Surface& graph,
                                Random_engine& random)
{
  std::vector<Values> result;
  const auto see_and_cut = [&](const Part& part) -> std::optional<Sides> {
    if (part.graph.number_of_faces() < 2)
      return std::nullopt;
    result.emplace_back();
    for (std::size_t i = 0; i < number_of_schemes; ++i)
      result.back()[i] = separation(part, input.people, sampling_schemes[i], random);
    return sides_by_samples(sampling_schemes[shape_context_scheme], part.graph,
                            minimum_area(graph), random);
  };
  recursive_cuts(graph, usual_number_of_segments(input.people), see_and_cut);
  return result;
}

struct Scores
{
  Values at_first_cut, over_recursion, rand_error;
};

Scores scores(const Benchmark_mesh& input)
{
  Random_engine random = random_engine(input.id);
  const Surface graph = paper_graph(input.mesh);
  const std::vector<Values> of_parts = separations(input, graph, random);
  Scores result;
  result.at_first_cut.fill(undefined);
  if (!of_parts.empty())
    result.at_first_cut = of_parts.front();
  for (std::size_t i = 0; i < number_of_schemes; ++i) {
    result.over_recursion[i] =
      mean_of(values_of(of_parts, [i](const Values& values) { return values[i]; }));
    result.rand_error[i] = mean_rand_error(
      recursive_cuts_by_samples(sampling_schemes[i], graph, usual_number_of_segments(input.people),
                                random), input.people);
  }
  return result;
}

} // namespace

void compare_samplings(const Experiment_options& o)
{
  const std::vector<Scores> meshes = measure_meshes(o, scores);
  std::printf("%-13s%21s%21s%21s\n", "samples", "first cut", "recursion", "Rand error");
  for (std::size_t i = 0; i < number_of_schemes; ++i) {
    std::printf("%-13s", sampling_schemes[i].name);
    for (Values Scores::*column :
         {&Scores::at_first_cut, &Scores::over_recursion, &Scores::rand_error}) {
      const auto values = [&](std::size_t scheme)
      { return values_of(meshes, [=](const Scores& s) { return (s.*column)[scheme]; }); };
      const Paired_difference d = paired_difference(values(i), values(shape_context_scheme));
      std::printf("  %.3f %+.3f+-%.3f", mean_of(values(i)), d.mean, d.standard_error);
    }
    std::printf("\n");
  }
  std::printf("first cut, recursion: fraction of people who have the two samples in different "
              "parts, of those\nwho have two parts there; Rand error: with people's usual number "
              "of parts; differences from\nshape context with their standard errors\n");
}

} // namespace segmentation_benchmark
