// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../for_each_mesh.h"
#include "../judged_cuts.h"
#include "../princeton_benchmark.h"
#include "experiment.h"
#include "experiments.h"
#include "face_samples.h"
#include "paired_difference.h"
#include "pictures.h"

#include <CGAL/Spectral_segmentation/internal/Cut_judge.h>
#include <CGAL/Spectral_segmentation/internal/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/embedding.h>
#include <CGAL/Spectral_segmentation/internal/line_search.h>
#include <CGAL/Spectral_segmentation/internal/shortest_paths.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Figure 1: line search between samples in the same part, and in different parts.
namespace segmentation_benchmark {
namespace {

using CGAL::Spectral_segmentation::Salience_factors;
using CGAL::Spectral_segmentation::internal::Cut;
using CGAL::Spectral_segmentation::internal::Sample_faces;

enum Placement { SAME_PART, DIFFERENT_PARTS, SHAPE_CONTEXT, NUMBER_OF_PLACEMENTS };

constexpr std::array<const char*, NUMBER_OF_PLACEMENTS> names =
  {"in the same part", "in different parts", "by shape context"};

// A cut is found if the borders of people's segments are so near to it.
constexpr double enough_agreement = 0.75;

struct Outcome
{
  double salience = undefined, agreement = undefined, is_found = undefined;
};

typedef std::array<Outcome, NUMBER_OF_PLACEMENTS> Outcomes; // by Placement

struct Searched_line
{
  std::vector<double> from_s, from_t;
  std::vector<double> sizes, saliences; // along the line; sizes as shares of the faces
  std::optional<Cut> cut;
};

Searched_line search_line(const Face_dual_graph& part, const Sample_faces& samples,
                          double minimum_area)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  Searched_line result;
  result.from_s = internal::shortest_paths(part, samples.s, &Face_dual_graph::Halfedge::combined);
  result.from_t = internal::shortest_paths(part, samples.t, &Face_dual_graph::Halfedge::combined);
  const double n = static_cast<double>(part.number_of_faces());
  result.cut = internal::line_search(
    part, internal::spectral_order(result.from_s, result.from_t),
    CGAL::Spectral_segmentation::Weighted_part_salience(), minimum_area,
    [&](std::size_t size, const Salience_factors&, double salience) {
      result.sizes.push_back(static_cast<double>(size) / n);
      result.saliences.push_back(salience);
    });
  return result;
}

// With respect to some people.
Outcome outcome(const Part& part, const Sample_faces& samples, double minimum_area,
                const std::vector<Labels>& people)
{
  const std::optional<Cut> cut = search_line(part.graph, samples, minimum_area).cut;
  Outcome result;
  if (!cut)
    return result;
  result.salience = cut->salience;
  result.agreement = mean_agreement(
    Judged_cut{Judged_cut::CANDIDATE, part.faces, cut->side, cut->factors}, people);
  result.is_found = result.agreement >= enough_agreement;
  return result;
}

// Two random faces in the same segment of a person or in different ones, if chance finds some.
std::optional<Sample_faces> random_pair(const Labels& person, bool in_same,
                                        Random_engine& random)
{
  for (int attempt = 0; attempt < 10000; ++attempt) {
    const Index s = random_face(person.size(), random), t = random_face(person.size(), random);
    if (s != t && (person[s] == person[t]) == in_same)
      return Sample_faces{s, t};
  }
  return std::nullopt;
}

Outcome mean_outcome(const std::vector<Outcome>& all)
{
  Mean salience, agreement, is_found;
  for (const Outcome& o : all) {
    salience.add(o.salience);
    agreement.add(o.agreement);
    is_found.add(o.is_found);
  }
  return {salience(), agreement(), is_found()};
}

Outcomes outcomes(const Benchmark_mesh& input, const Placement_options& o)
{
  Random_engine random = random_engine(o.seed, input.id);
  const Face_dual_graph graph = paper_graph(input.mesh);
  const Part part = whole_part(graph);
  const double smallest = minimum_area(graph);
  Outcomes result;
  for (Placement placement : {SAME_PART, DIFFERENT_PARTS}) {
    std::vector<Outcome> all;
    for (std::size_t i = 0; i < o.pairs; ++i) {
      const Labels& person = input.people[i % input.people.size()];
      const auto samples =
        random_pair(labels_of_part(part, person), placement == SAME_PART, random);
      if (samples)
        all.push_back(outcome(part, *samples, smallest, {person}));
    }
    result[placement] = mean_outcome(all);
  }
  const std::vector<Index> samples = samples_by_contexts(part.graph, 2, random);
  result[SHAPE_CONTEXT] = outcome(part, {samples[0], samples[1]}, smallest, input.people);
  return result;
}

// The picture of the paper, for one mesh: a segment of a person that is evidently a part, and that
// person's largest segment, in which both samples of (b) lie.
struct Evident_part
{
  std::vector<char> is_in_part, is_in_body; // of each face
};

// Of all segments of people that are cut off by one cut, and are not the body, the most salient.
std::optional<Evident_part> evident_part(const Part& part, const Face_dual_graph& mesh,
                                         const std::vector<Labels>& people)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  const internal::Options options;
  const internal::Judged_mesh judged = internal::judged_mesh(mesh, options);
  const internal::Judge_of_part judge(part, judged, options);
  std::optional<Evident_part> result;
  double largest_salience = 0;
  for (const Labels& person : people) {
    const Labels labels = labels_of_part(part, person);
    std::vector<double> areas(number_of_segments(labels), 0);
    for (Index f = 0; f < labels.size(); ++f)
      areas[labels[f]] += part.graph.areas[f];
    const std::size_t body = static_cast<std::size_t>(
      std::max_element(areas.begin(), areas.end()) - areas.begin());
    const auto is_in = [&labels](std::size_t segment) {
      std::vector<char> result;
      for (std::size_t label : labels)
        result.push_back(label == segment);
      return result;
    };
    for (std::size_t segment = 0; segment < areas.size(); ++segment) {
      const Sides sides = is_in(segment);
      if (segment == body || !internal::both_sides_are_connected(part.graph, sides))
        continue;
      const std::optional<Cut> cut = judge(sides);
      if (cut && cut->salience > largest_salience) {
        largest_salience = cut->salience;
        result = {sides, is_in(body)};
      }
    }
  }
  return result;
}

// The face of a set that is farthest from another face in geodesic distance.
Index farthest_in(const Face_dual_graph& part, const std::vector<char>& is_in, Index from)
{
  const std::vector<double> distance = CGAL::Spectral_segmentation::internal::shortest_paths(
    part, from, &Face_dual_graph::Halfedge::geodesic);
  Index farthest = from;
  for (Index f = 0; f < distance.size(); ++f)
    if (is_in[f] && (!is_in[farthest] || distance[f] > distance[farthest]))
      farthest = f;
  return farthest;
}

// Intersection over union, for the side where it is larger.
double overlap_with(const std::vector<char>& is_in, const Sides& sides)
{
  double best = 0;
  for (char side : {0, 1}) {
    double common = 0, either = 0;
    for (std::size_t f = 0; f < sides.size(); ++f) {
      common += is_in[f] && sides[f] == side;
      either += is_in[f] || sides[f] == side;
    }
    best = (std::max)(best, common / either);
  }
  return best;
}

// The two Voronoi regions in shades of grey, as in the paper, and the smaller side of the cut.
std::vector<CGAL::IO::Color> colors(const Benchmark_mesh& input,
                                    const Face_dual_graph& graph, const Part& part,
                                    const Sample_faces& samples, const Searched_line& line)
{
  std::vector<CGAL::IO::Color> result(input.mesh.number_of_faces(), CGAL::IO::Color(255, 255, 255));
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    const bool is_near_s = line.from_s[i] <= line.from_t[i];
    const bool is_cut_off = line.cut && line.cut->side[i] == 0;
    result[part.faces[i]] = is_cut_off ? is_near_s ? CGAL::IO::Color(250, 170, 80)
                                                   : CGAL::IO::Color(205, 125, 45)
                            : is_near_s ? CGAL::IO::Color(225, 225, 225)
                                        : CGAL::IO::Color(165, 165, 165);
  }
  mark_sample(graph, part.faces[samples.s], CGAL::IO::Color(20, 60, 200), result);
  mark_sample(graph, part.faces[samples.t], CGAL::IO::Color(200, 20, 40), result);
  return result;
}

void write_pictures(const Benchmark_mesh& input, const Pictures& pictures)
{
  const Face_dual_graph graph = paper_graph(input.mesh);
  const Part part = whole_part(graph);
  const std::optional<Evident_part> evident = evident_part(part, graph, input.people);
  if (!evident) {
    std::printf("mesh %d has no evident part\n", input.id);
    return;
  }
  const Index first = farthest_in(part.graph, evident->is_in_part, 0),
              body_1 = farthest_in(part.graph, evident->is_in_body, first),
              body_2 = farthest_in(part.graph, evident->is_in_body, body_1),
              in_part = farthest_in(part.graph, evident->is_in_part, body_1);
  Json plot = {{"title", "Salience along the line, mesh " + std::to_string(input.id)},
               {"x", "share of the faces in Q"}, {"y", "salience"}, {"lines", Json::array()}};
  const std::pair<const char*, Sample_faces> pairs[] = {{"different_parts", {in_part, body_1}},
                                                        {"same_part", {body_2, body_1}}};
  for (const auto& [name, samples] : pairs) {
    const Searched_line line = search_line(part.graph, samples, minimum_area(graph));
    pictures.write_colors(name, input.mesh, colors(input, graph, part, samples, line));
    plot["lines"].push_back({{"name", name}, {"x", line.sizes}, {"y", line.saliences}});
    std::printf("mesh %d, samples %-15s: salience %.3f, overlap with the evident part %.3f\n",
                input.id, name, line.cut ? line.cut->salience : undefined,
                line.cut ? overlap_with(evident->is_in_part, line.cut->side) : undefined);
  }
  pictures.write_plot("salience", plot);
}

template <class Member>
std::vector<double> column(const std::vector<Outcomes>& meshes, Placement placement, Member member)
{
  std::vector<double> values;
  for (const Outcomes& o : meshes)
    values.push_back(o[placement].*member);
  return values;
}

void print(const std::vector<Outcomes>& meshes)
{
  std::printf("samples               salience  agreement  found\n");
  for (int p = 0; p < NUMBER_OF_PLACEMENTS; ++p) {
    std::vector<Outcome> row;
    for (const Outcomes& o : meshes)
      row.push_back(o[p]);
    const Outcome mean = mean_outcome(row);
    std::printf("%-20s %9.3f %10.3f %6.3f\n", names[p], mean.salience, mean.agreement,
                mean.is_found);
  }
  std::printf("agreement: 1 where the best cut follows the borders of people's segments; found: "
              "share of cuts with at least %.2f\n", enough_agreement);
  const auto gain = [&](auto member) {
    return paired_difference(column(meshes, DIFFERENT_PARTS, member),
                             column(meshes, SAME_PART, member));
  };
  const Paired_difference agreement = gain(&Outcome::agreement),
                          salience = gain(&Outcome::salience);
  std::printf("Figure 1, that line search finds the better cut between samples in different parts: "
              "%s; agreement changes by %+.3f +- %.3f, salience by %+.3f +- %.3f.\n",
              agreement.is_positive() ? "reproduced" : "not reproduced", agreement.mean,
              agreement.standard_error, salience.mean, salience.standard_error);
}

} // namespace

// The picture is of the first mesh.
void run_placement_of_samples(const Placement_options& o)
{
  const std::vector<int> ids = parse_ids(o.ids);
  if (!o.pictures.empty())
    write_pictures(read_benchmark_mesh(o.folder, ids.front()), Pictures(o.pictures));
  std::vector<Outcomes> meshes;
  Progress progress(ids.size());
  for (int id : ids) {
    meshes.push_back(outcomes(read_benchmark_mesh(o.folder, id), o));
    progress.step();
  }
  print(meshes);
}

} // namespace segmentation_benchmark
