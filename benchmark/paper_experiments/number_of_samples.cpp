// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../evaluation.h"
#include "../for_each_mesh.h"
#include "../princeton_benchmark.h"
#include "experiment.h"
#include "experiments.h"
#include "face_affinities.h"
#include "face_samples.h"
#include "pictures.h"
#include "recursive_cuts.h"
#include "simplified.h"
#include "spectral_lines.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Section 7.2: two samples or more.
namespace segmentation_benchmark {
namespace {

constexpr std::array<std::size_t, 6> numbers = {2, 5, 10, 20, 50, 100};

struct Errors_of_line
{
  double first, second; // eigenvectors, at the whole mesh
  double rand_error;    // the error of the segmentation
};

struct Scores
{
  std::array<std::array<Errors_of_line, numbers.size()>, sampling_schemes.size()> by_samples;
  double exact_rand_error; // uses the exact eigenvectors
};

// The error of the recursion with eigenvectors from the samples that `take(part)` chooses.
template <class Take>
double rand_error_with(const Surface& graph, const std::vector<Labels>& people,
                       const Take& take)
{
  const double smallest = minimum_area(graph);
  const auto sides_of = [&](const Part& part) -> std::optional<Sides> {
    if (part.graph.number_of_faces() < 3)
      return std::nullopt;
    const std::vector<Index> samples = take(part.graph);
    const std::optional<Cut> cut = cut_by_eigenvectors(
      part.graph, face_eigenpairs(part.graph, samples), samples, smallest);
    return cut ? std::optional<Sides>(cut->side) : std::nullopt;
  };
  return mean_rand_error(recursive_cuts(graph, usual_number_of_segments(people), sides_of), people);
}

Scores scores(const Benchmark_mesh& input, const Number_of_samples_options& o)
{
  Random_engine random = random_engine(o.seed, input.id);
  const Surface graph = paper_graph(input.mesh);
  const Part whole = whole_part(graph);
  const Eigenpairs exact = face_eigenpairs(whole.graph, all_faces(whole.graph));
  Scores result;
  for (std::size_t i = 0; i < sampling_schemes.size(); ++i)
    for (std::size_t j = 0; j < numbers.size(); ++j) {
      const auto take = [&](const Surface& part)
      { return sampling_schemes[i].take(part, numbers[j], random); };
      const Eigenpairs approximate = face_eigenpairs(whole.graph, take(whole.graph));
      const auto error = [&](Eigen::Index e)
      { return direction_error(approximate.vectors.col(e), exact.vectors.col(e)); };
      result.by_samples[i][j] = {error(0), error(1),
                                 rand_error_with(graph, input.people, take)};
    }
  result.exact_rand_error = rand_error_with(graph, input.people, all_faces);
  return result;
}

typedef double Errors_of_line::*Column;

std::vector<double> values(const std::vector<Scores>& meshes, std::size_t scheme,
                           std::size_t number, Column error)
{
  return values_of(meshes, [=](const Scores& s) { return s.by_samples[scheme][number].*error; });
}

void print_table(const std::vector<Scores>& meshes, const char* title, Column error)
{
  std::printf("%s\n%-13s", title, "samples");
  for (std::size_t number : numbers)
    std::printf(" %7zu", number);
  std::printf("\n");
  for (std::size_t i = 0; i < sampling_schemes.size(); ++i) {
    std::printf("%-13s", sampling_schemes[i].name);
    for (std::size_t j = 0; j < numbers.size(); ++j)
      std::printf(" %7.4f", mean_of(values(meshes, i, j, error)));
    std::printf("\n");
  }
}

// In how many settings an error is smaller than that of two samples, or larger, beyond chance.
struct Comparison
{
  std::size_t settings = 0, smaller = 0, larger = 0;

  void add(const std::vector<double>& more, const std::vector<double>& two)
  {
    const Paired_difference d = paired_difference(more, two);
    ++settings;
    smaller += d.is_negative();
    larger += d.is_positive();
  }
};

// With more samples by one scheme, and two by another.
void add_settings(const std::vector<Scores>& meshes, Column error, std::size_t scheme,
                  std::size_t scheme_of_two, Comparison& comparison)
{
  for (std::size_t j = 1; j < numbers.size(); ++j)
    comparison.add(values(meshes, scheme, j, error), values(meshes, scheme_of_two, 0, error));
}

void print_claim_of_eigenvectors(const std::vector<Scores>& meshes)
{
  Comparison c;
  for (std::size_t i = 0; i < sampling_schemes.size(); ++i)
    add_settings(meshes, &Errors_of_line::second, i, i, c);
  std::printf("Section 7.2, that more samples bring the second eigenvector nearer: %s; it is "
              "nearer in %zu of %zu settings and farther in %zu.\n",
              verdict(c.smaller > 0 && c.larger == 0), c.smaller, c.settings, c.larger);
}

void print_claim_of_cuts(const char* two, const Comparison& c)
{
  std::printf("Section 7.2, that more samples cut no better than two by %s: %s; they cut better in "
              "%zu of %zu settings and worse in %zu.\n",
              two, verdict(c.smaller == 0), c.smaller, c.settings, c.larger);
}

// Against two samples by the same scheme; then all of them, and the exact eigenvectors, against two
// by shape context, which is the method of the paper.
void print_claims_of_cuts(const std::vector<Scores>& meshes)
{
  constexpr Column error = &Errors_of_line::rand_error;
  Comparison all;
  for (std::size_t i = 0; i < sampling_schemes.size(); ++i) {
    Comparison of_scheme;
    add_settings(meshes, error, i, i, of_scheme);
    print_claim_of_cuts((std::string("the same scheme, ") + sampling_schemes[i].name).c_str(),
                        of_scheme);
    add_settings(meshes, error, i, shape_context_scheme, all);
  }
  all.add(values_of(meshes, &Scores::exact_rand_error),
          values(meshes, shape_context_scheme, 0, error));
  print_claim_of_cuts("shape context", all);
}

void write_plot(const Pictures& pictures, const std::vector<Scores>& meshes,
                const std::string& name, const char* title, Column error)
{
  Json plot = {{"title", title}, {"x", "samples"}, {"y", "error"}, {"logarithmic_x", true},
               {"lines", Json::array()}};
  for (std::size_t i = 0; i < sampling_schemes.size(); ++i) {
    Json y;
    for (std::size_t j = 0; j < numbers.size(); ++j)
      y.push_back(mean_of(values(meshes, i, j, error)));
    plot["lines"].push_back({{"name", sampling_schemes[i].name}, {"x", numbers}, {"y", y}});
  }
  pictures.write_plot(name, plot);
}

void report(const std::vector<Scores>& meshes, const std::string& pictures)
{
  const std::tuple<const char*, const char*, Column> tables[] = {
    {"first_eigenvector", "L2 error of the first eigenvector", &Errors_of_line::first},
    {"second_eigenvector", "L2 error of the second eigenvector", &Errors_of_line::second},
    {"rand_error", "Rand error with people's usual number of parts", &Errors_of_line::rand_error}};
  for (const auto& [name, title, error] : tables) {
    print_table(meshes, title, error);
    if (!pictures.empty())
      write_plot(Pictures(pictures), meshes, name, title, error);
  }
  std::printf("%-13s %7.4f\n", "exact", mean_of(values_of(meshes, &Scores::exact_rand_error)));
  print_claim_of_eigenvectors(meshes);
  print_claims_of_cuts(meshes);
}

} // namespace

void run_number_of_samples(const Number_of_samples_options& o)
{
  const std::vector<int> ids = parse_ids(o.ids);
  std::vector<Scores> meshes;
  Progress progress(ids.size());
  for (int id : ids) {
    meshes.push_back(scores(simplified(read_benchmark_mesh(o.folder, id), o.faces), o));
    progress.step();
  }
  report(meshes, o.pictures);
}

} // namespace segmentation_benchmark
