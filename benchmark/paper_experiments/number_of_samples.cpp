// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../evaluation.h"
#include "experiments.h"
#include "face_samples.h"
#include "parts.h"
#include "spectral_lines.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
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

// Returns the error of the recursion with eigenvectors from the samples that `take(part)` chooses.
template <class Take>
double rand_error_with(const Surface& graph, const std::vector<Labels>& people, const Take& take)
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

Scores scores(const Benchmark_mesh& input)
{
  Random_engine random = random_engine(input.id);
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
      result.by_samples[i][j] = {error(0), error(1), rand_error_with(graph, input.people, take)};
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

// The numbers of settings in which an error is smaller, or larger, than that of two samples beyond
// chance.
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

  void print(const std::string& title) const
  {
    std::printf("%s: smaller in %zu of %zu settings, larger in %zu\n", title.c_str(), smaller,
                settings, larger);
  }
};

// Compares more samples by one scheme with two by another.
void add_settings(const std::vector<Scores>& meshes, Column error, std::size_t scheme,
                  std::size_t scheme_of_two, Comparison& comparison)
{
  for (std::size_t j = 1; j < numbers.size(); ++j)
    comparison.add(values(meshes, scheme, j, error), values(meshes, scheme_of_two, 0, error));
}

// Prints comparisons with two samples by the same scheme; and of Rand errors, also those of the
// exact eigenvectors, with two samples by shape context, which is the method of the paper.
void print_comparisons(const std::vector<Scores>& meshes)
{
  std::printf("Errors of more samples than two\n");
  Comparison of_second, all;
  for (std::size_t i = 0; i < sampling_schemes.size(); ++i) {
    Comparison of_scheme;
    add_settings(meshes, &Errors_of_line::second, i, i, of_second);
    add_settings(meshes, &Errors_of_line::rand_error, i, i, of_scheme);
    add_settings(meshes, &Errors_of_line::rand_error, i, shape_context_scheme, all);
    of_scheme.print(std::string("Rand error, ") + sampling_schemes[i].name);
  }
  all.add(values_of(meshes, &Scores::exact_rand_error),
          values(meshes, shape_context_scheme, 0, &Errors_of_line::rand_error));
  all.print("Rand error, against two by shape context");
  of_second.print("second eigenvector");
}

} // namespace

void compare_numbers_of_samples(const Experiment_options& o)
{
  const std::vector<Scores> meshes = measure_meshes(o, scores);
  print_table(meshes, "L2 error of the first eigenvector", &Errors_of_line::first);
  print_table(meshes, "L2 error of the second eigenvector", &Errors_of_line::second);
  print_table(meshes, "Rand error with people's usual number of parts",
              &Errors_of_line::rand_error);
  std::printf("%-13s %7.4f\n", "exact", mean_of(values_of(meshes, &Scores::exact_rand_error)));
  print_comparisons(meshes);
}

} // namespace segmentation_benchmark
