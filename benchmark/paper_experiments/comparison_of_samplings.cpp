// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../evaluation.h"
#include "../for_each_mesh.h"
#include "../princeton_benchmark.h"
#include "cut_between_samples.h"
#include "experiment.h"
#include "experiments.h"
#include "face_samples.h"
#include "pictures.h"
#include "recursive_cuts.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

// Figure 3 and Section 4: how often the two samples lie in different parts.
namespace segmentation_benchmark {
namespace {

constexpr std::size_t number_of_schemes = sampling_schemes.size();

// Schemes that depend on a random face are tried as often as this at each part.
constexpr int number_of_trials = 5;

// Returns the fraction that has the two faces in different segments, among the people who have two
// segments or more in the part.
double share_that_separates(const std::vector<Labels>& people_in_part, Index s, Index t)
{
  Mean share;
  for (const Labels& person : people_in_part)
    if (number_of_segments(person) > 1)
      share.add(person[s] != person[t]);
  return share();
}

double separation(const Part& part, const std::vector<Labels>& people,
                  const Sampling_scheme& scheme, Random_engine& random)
{
  std::vector<Labels> people_in_part;
  for (const Labels& person : people)
    people_in_part.push_back(labels_of_part(part, person));
  Mean share;
  for (int i = 0; i < (scheme.take == samples_by_contexts ? 1 : number_of_trials); ++i) {
    const std::vector<Index> samples = scheme.take(part.graph, 2, random);
    share.add(share_that_separates(people_in_part, samples[0], samples[1]));
  }
  return share();
}

typedef std::array<double, number_of_schemes> Values; // indexed by scheme

// At each part of the recursion by shape context.
std::vector<Values> separations(const Benchmark_mesh& input, const Surface& graph,
                                Random_engine& random)
{
  const double smallest = minimum_area(graph);
  std::vector<Values> result;
  const auto see_and_cut = [&](const Part& part) -> std::optional<Sides> {
    if (part.graph.number_of_faces() < 2)
      return std::nullopt;
    result.emplace_back();
    for (std::size_t i = 0; i < number_of_schemes; ++i)
      result.back()[i] = separation(part, input.people, sampling_schemes[i], random);
    return cut_between_samples(sampling_schemes[shape_context_scheme], part.graph, smallest,
                               random);
  };
  recursive_cuts(graph, usual_number_of_segments(input.people), see_and_cut);
  return result;
}

struct Scores
{
  Values at_first_cut, over_recursion, rand_error;
};

Scores scores(const Benchmark_mesh& input, const Experiment_options& o)
{
  Random_engine random = random_engine(o.seed, input.id);
  const Surface graph = paper_graph(input.mesh);
  const std::vector<Values> of_parts = separations(input, graph, random);
  Scores result;
  result.at_first_cut.fill(undefined);
  if (!of_parts.empty())
    result.at_first_cut = of_parts.front();
  for (std::size_t i = 0; i < number_of_schemes; ++i) {
    result.over_recursion[i] =
      mean_of(values_of(of_parts, [i](const Values& values) { return values[i]; }));
    const Labels labels = recursive_cuts(
      graph, usual_number_of_segments(input.people), [&](const Part& part) {
        return cut_between_samples(sampling_schemes[i], part.graph, minimum_area(graph), random);
      });
    result.rand_error[i] = mean_rand_error(labels, input.people);
  }
  return result;
}

typedef Values Scores::*Column;

std::vector<double> values(const std::vector<Scores>& meshes, Column column, std::size_t scheme)
{ return values_of(meshes, [=](const Scores& scores) { return (scores.*column)[scheme]; }); }

// Compares a scheme with shape context.
Paired_difference difference(const std::vector<Scores>& meshes, Column column, std::size_t scheme)
{
  return paired_difference(values(meshes, column, scheme),
                           values(meshes, column, shape_context_scheme));
}

void print_table(const std::vector<Scores>& meshes)
{
  std::printf("%-13s%21s%21s%21s\n", "samples", "first cut", "recursion", "Rand error");
  for (std::size_t i = 0; i < number_of_schemes; ++i) {
    std::printf("%-13s", sampling_schemes[i].name);
    for (Column column : {&Scores::at_first_cut, &Scores::over_recursion, &Scores::rand_error}) {
      const Paired_difference d = difference(meshes, column, i);
      std::printf("  %.3f %+.3f+-%.3f", mean_of(values(meshes, column, i)), d.mean,
                  d.standard_error);
    }
    std::printf("\n");
  }
  std::printf("first cut, recursion: share of people who have the two samples in different parts, "
              "of those\nwho have two parts there; Rand error: with people's usual number of "
              "parts; differences from\nshape context with their standard errors\n");
}

void print_claim(const std::vector<Scores>& meshes, Column column, const char* where)
{
  std::printf("Section 4, that samples by shape context lie in different parts more often, %s:",
              where);
  for (std::size_t i = 0; i < number_of_schemes; ++i)
    if (i != shape_context_scheme)
      std::printf(" %s against %s%s", verdict(difference(meshes, column, i).is_negative()),
                  sampling_schemes[i].name, i + 2 < number_of_schemes ? "," : ".\n");
}

// The samples of all schemes at the first cut, on the parts of a person.
void write_picture(const Benchmark_mesh& input, const Experiment_options& o)
{
  const Pictures pictures(o.pictures);
  const Surface graph = paper_graph(input.mesh);
  const Part part = whole_part(graph);
  const std::vector<CGAL::IO::Color> of_person =
    pale(segment_colors(input.mesh, input.people.front()));
  for (const Sampling_scheme& scheme : sampling_schemes) {
    Random_engine random = random_engine(o.seed, input.id);
    std::vector<CGAL::IO::Color> colors = of_person;
    for (Index sample : scheme.take(part.graph, 2, random))
      mark_sample(graph, part.faces[sample], CGAL::IO::black(), colors);
    pictures.write_mesh(std::string("samples by ") + scheme.name, input.mesh, colors);
  }
}

} // namespace

void run_comparison_of_samplings(const Experiment_options& o)
{
  const std::vector<int> ids = parse_ids(o.ids);
  if (!o.pictures.empty())
    write_picture(read_benchmark_mesh(o.folder, ids.front()), o);
  std::vector<Scores> meshes;
  Progress progress(ids.size());
  for (int id : ids) {
    meshes.push_back(scores(read_benchmark_mesh(o.folder, id), o));
    progress.step();
  }
  print_table(meshes);
  print_claim(meshes, &Scores::at_first_cut, "at the first cut");
  print_claim(meshes, &Scores::over_recursion, "over the recursion");
}

} // namespace segmentation_benchmark
