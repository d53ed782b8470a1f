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

// Figure 1: line search between samples in the same part, and in different parts.
namespace segmentation_benchmark {
namespace {

enum Placement { SAME_PART, DIFFERENT_PARTS, SHAPE_CONTEXT, NUMBER_OF_PLACEMENTS };

constexpr std::array<const char*, NUMBER_OF_PLACEMENTS> names =
  {"in the same part", "in different parts", "by shape context"};

// Pairs of random faces of each placement on a mesh.
constexpr std::size_t number_of_pairs = 10;

// A part is found if its agreement with the cut is at least this.
constexpr double enough_agreement = 0.75;

// Returns two random faces in the same segment or in different ones, if chance finds some.
std::optional<std::vector<Index> > random_pair(const Labels& segments, bool in_same,
                                               Random_engine& random)
{
  for (int attempt = 0; attempt < 10000; ++attempt) {
    const Index s = random_face(segments.size(), random), t = random_face(segments.size(), random);
    if (s != t && (segments[s] == segments[t]) == in_same)
      return std::vector<Index>{s, t};
  }
  return std::nullopt;
}

// The means over the best cuts of a mesh. A pair without a cut has no salience and no agreement.
struct Outcome
{
  Mean salience, agreement, is_found;

  void add(const Part& part, const std::optional<Cut>& cut, const Labels& person)
  {
    const double of_cut =
      cut ? segmentation_benchmark::agreement(part, cut->side, person) : 0.;
    salience.add(cut ? cut->salience : undefined);
    agreement.add(of_cut);
    is_found.add(of_cut >= enough_agreement);
  }
};

typedef std::array<Outcome, NUMBER_OF_PLACEMENTS> Outcomes; // indexed by Placement

// Tries random pairs with respect to one person after the other, and the pair by shape context with
// respect to each.
Outcomes outcomes(const Benchmark_mesh& input)
{
  Random_engine random = random_engine(input.id);
  const Surface graph = paper_graph(input.mesh);
  const Part part = whole_part(graph);
  const auto cut_between = [&](const std::vector<Index>& samples)
  { return best_cut(part.graph, samples, minimum_area(graph)); };
  Outcomes result;
  for (Placement placement : {SAME_PART, DIFFERENT_PARTS})
    for (std::size_t i = 0; i < number_of_pairs; ++i) {
      const Labels& person = input.people[i % input.people.size()];
      if (const auto samples =
            random_pair(labels_of_part(part, person), placement == SAME_PART, random))
        result[placement].add(part, cut_between(*samples), person);
    }
  const std::optional<Cut> cut = cut_between(samples_by_contexts(part.graph, 2, random));
  for (const Labels& person : input.people)
    result[SHAPE_CONTEXT].add(part, cut, person);
  return result;
}

} // namespace

void compare_placements(const Experiment_options& o)
{
  const std::vector<Outcomes> meshes = measure_meshes(o, outcomes);
  const auto values = [&](std::size_t placement, Mean Outcome::*column)
  { return values_of(meshes, [=](const Outcomes& all) { return (all[placement].*column)(); }); };
  std::printf("%-20s %9s %10s %6s\n", "samples", "salience", "agreement", "found");
  for (std::size_t p = 0; p < NUMBER_OF_PLACEMENTS; ++p)
    std::printf("%-20s %9.3f %10.3f %6.3f\n", names[p], mean_of(values(p, &Outcome::salience)),
                mean_of(values(p, &Outcome::agreement)), mean_of(values(p, &Outcome::is_found)));
  const auto gain = [&](Mean Outcome::*column)
  { return paired_difference(values(DIFFERENT_PARTS, column), values(SAME_PART, column)); };
  const Paired_difference salience = gain(&Outcome::salience),
                          agreement = gain(&Outcome::agreement);
  std::printf("%-20s %+.3f +- %.3f, %+.3f +- %.3f\n", "different - same", salience.mean,
              salience.standard_error, agreement.mean, agreement.standard_error);
  std::printf("agreement: 1 where the best cut follows the borders of a person's segments; found: "
              "fraction of cuts\nwith at least %.2f\n", enough_agreement);
}

} // namespace segmentation_benchmark
