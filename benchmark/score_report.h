// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SCORE_REPORT_H
#define SEGMENTATION_BENCHMARK_SCORE_REPORT_H

#include "evaluation.h"
#include "score_mesh.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace segmentation_benchmark {

typedef nlohmann::ordered_json Json;

// The means of a row over some meshes.
struct Summary
{
  std::size_t meshes = 0;
  Errors errors;
  Part_agreement parts;
  double segments = undefined, median_seconds = undefined, people_error = undefined;

  bool is_at_or_below_people() const { return errors.rand_error <= people_error; }
};

struct Row_summary
{
  Row row;
  Summary over_meshes;
  std::map<std::size_t, Summary> categories;

  long categories_at_or_below_people() const
  {
    return std::count_if(categories.begin(), categories.end(), [](const auto& entry)
                         { return entry.second.is_at_or_below_people(); });
  }
};

inline Summary summary(std::size_t row, const std::vector<const Scored_mesh*>& meshes)
{
  std::vector<Errors> errors;
  std::vector<Part_agreement> parts;
  std::vector<double> seconds;
  Mean segments, people_error;
  for (const Scored_mesh* mesh : meshes) {
    const Score& score = mesh->scores[row];
    errors.push_back(score.errors);
    parts.push_back(score.parts);
    seconds.push_back(score.seconds);
    segments.add(score.segments);
    people_error.add(mesh->people_error);
  }
  return {meshes.size(), mean_errors(errors), mean_agreement(parts), segments(), median(seconds),
          people_error()};
}

inline std::vector<Row_summary> row_summaries(const std::vector<Row>& rows,
                                              const std::vector<Scored_mesh>& meshes)
{
  std::vector<const Scored_mesh*> all;
  std::map<std::size_t, std::vector<const Scored_mesh*> > by_category;
  for (const Scored_mesh& mesh : meshes) {
    all.push_back(&mesh);
    by_category[category(mesh.id)].push_back(&mesh);
  }
  std::vector<Row_summary> result;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    result.push_back({rows[row], summary(row, all), {}});
    for (const auto& [category, of_category] : by_category)
      result.back().categories[category] = summary(row, of_category);
  }
  return result;
}

inline std::string title(const Row& row)
{
  return row.method + " " + name(row.protocol) +
         (is_as_is(row.triangulation) ? "" : " " + row.triangulation);
}

inline int width_of_titles(const std::vector<Row_summary>& rows)
{
  std::size_t width = std::string("method").size();
  for (const Row_summary& r : rows)
    width = (std::max)(width, title(r.row).size());
  return static_cast<int>(width);
}

// Prints a value, or a dash if it is not defined.
inline void print_value(int width, double value)
{
  if (std::isnan(value))
    std::printf(" %*s", width, "-");
  else
    std::printf(" %*.4f", width, value);
}

// Prints the means of each row over all meshes.
inline void print_means(const std::vector<Row_summary>& rows)
{
  const int width = width_of_titles(rows);
  std::printf("%-*s %7s %7s", width, "method", "Rand", "cut");
  for (const Part_measure& measure : part_measures)
    std::printf(" %7s", measure.title);
  std::printf(" %7s %9s %11s\n", "parts", "median s", "categories");
  for (const Row_summary& r : rows) {
    const Summary& means = r.over_meshes;
    std::printf("%-*s", width, title(r.row).c_str());
    print_value(7, means.errors.rand_error);
    print_value(7, means.errors.cut_discrepancy);
    for (const Part_measure& measure : part_measures)
      print_value(7, means.parts.*measure.value);
    std::printf(" %7.2f %9.3f %8ld/%zu\n", means.segments, means.median_seconds,
                r.categories_at_or_below_people(), r.categories.size());
  }
  std::printf("Rand: Rand error; cut: cut discrepancy; PQ: panoptic quality; IoU: mean over "
              "people's parts of the\n  intersection over union with the most similar segment; "
              "made: fraction of the segments that somebody\n  made; false: segments a mesh that "
              "nobody made; scraps: those below 1 %% of the faces; unlike,\n  "
              "place, of meshes that are their own mirror images: segments a mesh whose mirror "
              "images are no\n  segments; of the others, the fraction whose seams are mirror "
              "images; categories: in how many the\n  Rand error is at most people's own\n");
}

// Returns the index of the row with the same method and protocol on the meshes as they are; or the
// number of rows.
inline std::size_t row_as_is(const std::vector<Row_summary>& rows, const Row& row)
{
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row_summary& r) {
    return r.row.method == row.method && r.row.protocol == row.protocol &&
           is_as_is(r.row.triangulation);
  });
  return static_cast<std::size_t>(found - rows.begin());
}

// Prints how much the Rand error of each mesh changes with its triangulation.
inline void print_triangulations(const std::vector<Row_summary>& rows,
                                 const std::vector<Scored_mesh>& meshes)
{
  const int width = width_of_titles(rows);
  std::printf("%-*s %7s  %18s %7s\n", width, "Rand error", "mean", "more than as_is", "parts");
  const auto errors_of = [&](std::size_t row) {
    return values_of(meshes, [row](const Scored_mesh& mesh)
                     { return mesh.scores[row].errors.rand_error; });
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Summary& summary = rows[i].over_meshes;
    std::printf("%-*s %7.4f", width, title(rows[i].row).c_str(), summary.errors.rand_error);
    const std::size_t as_is = row_as_is(rows, rows[i].row);
    if (as_is == i || as_is == rows.size())
      std::printf("  %18s", "-");
    else {
      const Paired_difference d = paired_difference(errors_of(i), errors_of(as_is));
      std::printf("  %+8.4f +- %6.4f", d.mean, d.standard_error);
    }
    std::printf(" %7.2f\n", summary.segments);
  }
  std::printf("more than as_is: mean of the differences on each mesh, with its standard error\n");
}

inline std::string marked_error(const Summary& s)
{
  char text[16];
  std::snprintf(text, sizeof text, "%s%.4f", s.is_at_or_below_people() ? "*" : "",
                s.errors.rand_error);
  return text;
}

inline void print_line(const char* name, const Summary& first,
                       const std::vector<const Summary*>& cells, const std::vector<int>& widths)
{
  std::printf("%-15s %6zu %7.4f", name, first.meshes, first.people_error);
  for (std::size_t i = 0; i < cells.size(); ++i)
    std::printf("  %*s", widths[i], marked_error(*cells[i]).c_str());
  std::printf("\n");
}

// Prints the Rand error of each row by category.
inline void print_categories(const std::vector<Row_summary>& rows)
{
  std::vector<int> widths;
  std::printf("%-15s %6s %7s", "Rand error", "meshes", "people");
  for (const Row_summary& r : rows) {
    widths.push_back((std::max)(7, static_cast<int>(title(r.row).size())));
    std::printf("  %*s", widths.back(), title(r.row).c_str());
  }
  std::printf("\n");

  const auto print = [&](const char* name, const auto& summary_of) {
    std::vector<const Summary*> cells;
    for (const Row_summary& r : rows)
      cells.push_back(&summary_of(r));
    print_line(name, *cells.front(), cells, widths);
  };
  for (const auto& entry : rows.front().categories) {
    const std::size_t c = entry.first;
    print(category_names[c],
          [c](const Row_summary& r) -> const Summary& { return r.categories.at(c); });
  }
  print("all meshes", [](const Row_summary& r) -> const Summary& { return r.over_meshes; });
  std::printf("*: at most people's own\n");
}

// Returns the values of each row on each mesh; those that are not defined are null.
inline Json json_report(const std::vector<Row>& rows, const std::vector<Scored_mesh>& meshes)
{
  Json json;
  for (const Scored_mesh& mesh : meshes)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Score& score = mesh.scores[i];
      Json& of_mesh = json[title(rows[i])][std::to_string(mesh.id)];
      of_mesh = {{"rand_error", score.errors.rand_error},
                 {"cut_discrepancy", score.errors.cut_discrepancy},
                 {"segments", score.segments},
                 {"seconds", score.seconds}};
      for (const Part_measure& measure : part_measures)
        of_mesh[measure.key] = score.parts.*measure.value;
    }
  return json;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SCORE_REPORT_H
