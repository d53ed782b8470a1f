// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../evaluation.h"
#include "../for_each_mesh.h"
#include "../princeton_benchmark.h"
#include "experiment.h"
#include "experiments.h"
#include "face_samples.h"
#include "pictures.h"

#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/line_search.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Figure 1: line search between samples in the same part, and in different parts.
namespace segmentation_benchmark {
namespace {

using CGAL::Spectral_segmentation::internal::Cut;
using CGAL::Spectral_segmentation::internal::Sample_faces;

enum Placement { SAME_PART, DIFFERENT_PARTS, SHAPE_CONTEXT, NUMBER_OF_PLACEMENTS };

constexpr std::array<const char*, NUMBER_OF_PLACEMENTS> names =
  {"in the same part", "in different parts", "by shape context"};

// A part is found if its borders are so near to the cut.
constexpr double enough_agreement = 0.75;

struct Searched_line
{
  std::vector<double> from_s, from_t;
  std::vector<double> sizes, saliences; // along the line; sizes as fractions of the faces
  std::optional<Cut> cut;
};

Searched_line search_line(const Surface& part, const Sample_faces& samples,
                          double minimum_area)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  Searched_line result;
  result.from_s = internal::shortest_paths(part, &Edge_weights::combined, samples.s);
  result.from_t = internal::shortest_paths(part, &Edge_weights::combined, samples.t);
  const std::vector<internal::Index> order =
    internal::spectral_order(Execution::SEQUENTIAL, result.from_s, result.from_t);
  const CGAL::Spectral_segmentation::Weighted_part_salience salience;
  result.cut =
    internal::line_search(Execution::SEQUENTIAL, part, order, salience, minimum_area);
  const internal::Growth growth = internal::grow_along(part, order);
  internal::for_each_cut(
    growth.faces, internal::sizes_of_cuts(part, growth), minimum_area,
    internal::Boundary_statistics(part),
    [&](const internal::Boundary_statistics& q, std::size_t size) {
      result.sizes.push_back(static_cast<double>(size) /
                             static_cast<double>(part.number_of_faces()));
      result.saliences.push_back(salience(q.factors()));
      return true;
    });
  return result;
}

// Two samples and what is found between them.
struct Trial
{
  Sample_faces samples;
  double salience = undefined, agreement = 0; // both for the best cut, if there is one
};

typedef std::array<std::vector<Trial>, NUMBER_OF_PLACEMENTS> Trials; // indexed by Placement

// The first cut of a mesh.
class First_cut
{
  const Benchmark_mesh& input_;
  Surface graph_;
  Part part_;
  double minimum_area_;
  Random_engine random_;

  // Two random faces in the same segment or in different ones, if chance finds some.
  std::optional<Sample_faces> random_pair(const Labels& segments, bool in_same)
  {
    for (int attempt = 0; attempt < 10000; ++attempt) {
      const Index s = random_face(segments.size(), random_),
                  t = random_face(segments.size(), random_);
      if (s != t && (segments[s] == segments[t]) == in_same)
        return Sample_faces{s, t};
    }
    return std::nullopt;
  }

  void add_trial(const Sample_faces& samples, const std::optional<Cut>& cut, const Labels& person,
                 std::vector<Trial>& trials) const
  {
    Trial trial{samples};
    if (cut) {
      trial.salience = cut->salience;
      trial.agreement = agreement(part_, cut->side, person);
    }
    trials.push_back(trial);
  }

public:
  First_cut(const Benchmark_mesh& input, std::uint64_t seed)
    : input_(input), graph_(paper_graph(input.mesh)), part_(whole_part(graph_)),
      minimum_area_(segmentation_benchmark::minimum_area(graph_)),
      random_(random_engine(seed, input.id)) {}

  Searched_line search(const Sample_faces& samples) const
  { return search_line(part_.graph, samples, minimum_area_); }

  // Random pairs with respect to one person after the other; the pair by shape context with respect
  // to each.
  Trials trials(std::size_t number_of_pairs)
  {
    Trials result;
    for (Placement placement : {SAME_PART, DIFFERENT_PARTS})
      for (std::size_t i = 0; i < number_of_pairs; ++i) {
        const Labels& person = input_.people[i % input_.people.size()];
        if (const auto samples =
              random_pair(labels_of_part(part_, person), placement == SAME_PART))
          add_trial(*samples, search(*samples).cut, person, result[placement]);
      }
    const std::vector<Index> pair = samples_by_contexts(part_.graph, 2, random_);
    const Sample_faces samples = {pair[0], pair[1]};
    const std::optional<Cut> cut = search(samples).cut;
    for (const Labels& person : input_.people)
      add_trial(samples, cut, person, result[SHAPE_CONTEXT]);
    return result;
  }

  // The two Voronoi regions in shades, as in the paper; Q is orange.
  void draw(const Pictures& pictures, const std::string& name, const Sample_faces& samples,
            const Searched_line& line) const
  {
    std::vector<CGAL::IO::Color> colors(input_.mesh.number_of_faces(), CGAL::IO::white());
    for (std::size_t i = 0; i < part_.faces.size(); ++i) {
      const bool is_near_s = line.from_s[i] <= line.from_t[i];
      const bool is_in_q = line.cut && line.cut->side[i] == 0;
      colors[part_.faces[i]] =
        is_in_q ? is_near_s ? CGAL::IO::Color(250, 170, 80) : CGAL::IO::Color(205, 125, 45)
                : is_near_s ? CGAL::IO::Color(225, 225, 225) : CGAL::IO::Color(165, 165, 165);
    }
    mark_sample(graph_, part_.faces[samples.s], CGAL::IO::Color(20, 60, 200), colors);
    mark_sample(graph_, part_.faces[samples.t], CGAL::IO::Color(200, 20, 40), colors);
    pictures.write_mesh(name, input_.mesh, colors);
  }
};

// Writes for both placements the pair whose cut agrees best with the person, and the salience along
// its line.
void write_pictures(const First_cut& first_cut, const Trials& trials, int id,
                    const Pictures& pictures)
{
  Json plot = {{"title", "Salience along the line, mesh " + std::to_string(id)},
               {"x", "fraction of the faces in Q"}, {"y", "salience"}, {"lines", Json::array()}};
  for (Placement placement : {SAME_PART, DIFFERENT_PARTS}) {
    const auto best = std::max_element(
      trials[placement].begin(), trials[placement].end(), [](const Trial& a, const Trial& b)
      { return a.agreement < b.agreement; });
    if (best == trials[placement].end())
      continue;
    const Searched_line line = first_cut.search(best->samples);
    first_cut.draw(pictures, std::string("samples ") + names[placement], best->samples, line);
    plot["lines"].push_back(
      {{"name", names[placement]}, {"x", line.sizes}, {"y", line.saliences}});
  }
  pictures.write_plot("salience", plot);
}

// Means over the trials of a mesh, or over meshes.
struct Outcome
{
  double salience, agreement, is_found;
};

typedef std::array<Outcome, NUMBER_OF_PLACEMENTS> Outcomes; // indexed by Placement

Outcomes outcomes(const Trials& trials)
{
  Outcomes result;
  for (std::size_t p = 0; p < NUMBER_OF_PLACEMENTS; ++p)
    result[p] = {mean_of(values_of(trials[p], &Trial::salience)),
                 mean_of(values_of(trials[p], &Trial::agreement)),
                 mean_of(values_of(trials[p], [](const Trial& t)
                                   { return t.agreement >= enough_agreement; }))};
  return result;
}

typedef double Outcome::*Column;

std::vector<double> values(const std::vector<Outcomes>& meshes, std::size_t placement,
                           Column column)
{ return values_of(meshes, [=](const Outcomes& o) { return o[placement].*column; }); }

void print(const std::vector<Outcomes>& meshes)
{
  std::printf("%-20s %9s %10s %6s\n", "samples", "salience", "agreement", "found");
  for (std::size_t p = 0; p < NUMBER_OF_PLACEMENTS; ++p)
    std::printf("%-20s %9.3f %10.3f %6.3f\n", names[p],
                mean_of(values(meshes, p, &Outcome::salience)),
                mean_of(values(meshes, p, &Outcome::agreement)),
                mean_of(values(meshes, p, &Outcome::is_found)));
  std::printf("agreement: 1 where the best cut follows the borders of a person's segments; found: "
              "share of cuts\nwith at least %.2f\n", enough_agreement);
  const auto gain = [&](Column column) {
    return paired_difference(values(meshes, DIFFERENT_PARTS, column),
                             values(meshes, SAME_PART, column));
  };
  const Paired_difference agreement = gain(&Outcome::agreement),
                          salience = gain(&Outcome::salience);
  std::printf("Figure 1, that line search finds the better cut between samples in different parts: "
              "%s; agreement changes by %+.3f +- %.3f, salience by %+.3f +- %.3f.\n",
              verdict(agreement.is_positive()), agreement.mean, agreement.standard_error,
              salience.mean, salience.standard_error);
}

} // namespace

void run_placement_of_samples(const Placement_options& o)
{
  const std::vector<int> ids = parse_ids(o.ids);
  std::vector<Outcomes> meshes;
  Progress progress(ids.size());
  for (int id : ids) {
    const Benchmark_mesh input = read_benchmark_mesh(o.folder, id);
    First_cut first_cut(input, o.seed);
    const Trials trials = first_cut.trials(o.pairs);
    if (meshes.empty() && !o.pictures.empty())
      write_pictures(first_cut, trials, id, Pictures(o.pictures));
    meshes.push_back(outcomes(trials));
    progress.step();
  }
  print(meshes);
}

} // namespace segmentation_benchmark
