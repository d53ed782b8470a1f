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

// Means over some meshes.
struct Summary
{
  std::size_t meshes = 0;
  Score mean;
  double median_seconds = undefined;
  double floor = undefined;
  double people_error = undefined;

  bool is_at_or_below_people() const { return mean.errors[RAND_ERROR] <= people_error; }
};

// A row in full.
struct Row_summary
{
  Row row;
  Summary over_meshes, over_categories;
  std::map<std::size_t, Summary> categories;

  long categories_at_or_below_people() const
  {
    return std::count_if(categories.begin(), categories.end(), [](const auto& entry)
                         { return entry.second.is_at_or_below_people(); });
  }
};

template <class Range, class Value>
double mean_of(const Range& range, const Value& value)
{
  Mean mean;
  for (const auto& element : range)
    mean.add(value(element));
  return mean();
}

inline Summary mean_summary(const std::vector<Summary>& all)
{
  const auto mean = [&all](const auto& value) { return mean_of(all, value); };
  Summary result;
  std::vector<Errors> errors;
  std::vector<double> seconds;
  for (const Summary& s : all) {
    result.meshes += s.meshes;
    errors.push_back(s.mean.errors);
    seconds.push_back(s.median_seconds);
  }
  result.mean.errors = mean_errors(errors);
  result.mean.segments = mean([](const Summary& s) { return s.mean.segments; });
  result.mean.excess = mean([](const Summary& s) { return s.mean.excess; });
  result.mean.congruent = mean([](const Summary& s) { return s.mean.congruent; });
  result.mean.partners = {mean([](const Summary& s) { return s.mean.partners.made; }),
                          mean([](const Summary& s) { return s.mean.partners.made_unlike; })};
  result.mean.seconds = mean([](const Summary& s) { return s.mean.seconds; });
  result.median_seconds = median(seconds);
  result.floor = mean([](const Summary& s) { return s.floor; });
  result.people_error = mean([](const Summary& s) { return s.people_error; });
  return result;
}

inline Row_summary row_summary(const std::vector<Row>& rows, std::size_t row,
                               const std::vector<Scored_mesh>& meshes)
{
  std::vector<Summary> all;
  std::map<std::size_t, std::vector<Summary> > by_category;
  for (const Scored_mesh& mesh : meshes) {
    const Score& score = mesh.scores[row];
    all.push_back({1, score, score.seconds, mesh.floor, mesh.people_error});
    by_category[category(mesh.id)].push_back(all.back());
  }
  Row_summary result{rows[row], mean_summary(all), {}, {}};
  std::vector<Summary> categories;
  for (const auto& [category, summaries] : by_category)
    categories.push_back(result.categories[category] = mean_summary(summaries));
  result.over_categories = mean_summary(categories);
  return result;
}

inline std::vector<Row_summary> row_summaries(const std::vector<Row>& rows,
                                              const std::vector<Scored_mesh>& meshes)
{
  std::vector<Row_summary> result;
  for (std::size_t row = 0; row < rows.size(); ++row)
    result.push_back(row_summary(rows, row, meshes));
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

// Values that are not defined are a dash.
inline void print_value(int width, double value)
{
  if (std::isnan(value))
    std::printf(" %*s", width, "-");
  else
    std::printf(" %*.4f", width, value);
}

// All metrics of each row, mean over meshes.
inline void print_metrics(const std::vector<Row_summary>& rows)
{
  const int width = width_of_titles(rows);
  std::printf("%-*s", width, "method");
  for (const char* metric : metric_names)
    std::printf(" %7s", metric);
  std::printf(" %7s %7s %9s %7s %9s %9s %11s\n", "parts", "excess", "congruent", "unlike",
              "median s", "mean s", "categories");
  for (const Row_summary& r : rows) {
    const Score& mean = r.over_meshes.mean;
    std::printf("%-*s", width, title(r.row).c_str());
    for (double error : mean.errors)
      print_value(7, error);
    std::printf(" %7.2f %7.4f", mean.segments, mean.excess);
    print_value(9, mean.congruent);
    print_value(7, mean.partners.made_unlike / mean.partners.made);
    std::printf(" %9.3f %9.3f %8ld/%zu\n", r.over_meshes.median_seconds, mean.seconds,
                r.categories_at_or_below_people(), r.categories.size());
  }
  std::printf("excess: Rand error less the consensus floor, for which an upper bound stands\n"
              "congruent: fraction of the classes of congruent parts that people made which are "
              "treated alike\n"
              "unlike: of the pairs of congruent cuts in the tree of which one is made, the "
              "fraction of which the other is not\n"
              "categories: in how many the Rand error is at most people's own\n");
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

// How much the Rand error of each mesh changes with its triangulation.
inline void print_triangulations(const std::vector<Row_summary>& rows,
                                 const std::vector<Scored_mesh>& meshes)
{
  const int width = width_of_titles(rows);
  std::printf("%-*s %7s  %18s %7s\n", width, "Rand error", "mean", "more than as_is", "parts");
  const auto errors_of = [&](std::size_t row) {
    return values_of(meshes, [row](const Scored_mesh& mesh)
                     { return mesh.scores[row].errors[RAND_ERROR]; });
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Summary& summary = rows[i].over_meshes;
    std::printf("%-*s %7.4f", width, title(rows[i].row).c_str(), summary.mean.errors[RAND_ERROR]);
    const std::size_t as_is = row_as_is(rows, rows[i].row);
    if (as_is == i || as_is == rows.size())
      std::printf("  %18s", "-");
    else {
      const Paired_difference d = paired_difference(errors_of(i), errors_of(as_is));
      std::printf("  %+8.4f +- %6.4f", d.mean, d.standard_error);
    }
    std::printf(" %7.2f\n", summary.mean.segments);
  }
  std::printf("more than as_is: mean of the differences on each mesh, with its standard error\n");
}

inline std::string marked_error(const Summary& s)
{
  char text[16];
  std::snprintf(text, sizeof text, "%s%.4f", s.is_at_or_below_people() ? "*" : "",
                s.mean.errors[RAND_ERROR]);
  return text;
}

inline void print_line(const char* name, const Summary& first,
                       const std::vector<const Summary*>& cells, const std::vector<int>& widths)
{
  std::printf("%-15s %6zu %7.4f %7.4f", name, first.meshes, first.floor, first.people_error);
  for (std::size_t i = 0; i < cells.size(); ++i)
    std::printf("  %*s", widths[i], marked_error(*cells[i]).c_str());
  std::printf("\n");
}

// The Rand error of each row by category.
inline void print_categories(const std::vector<Row_summary>& rows)
{
  std::vector<int> widths;
  std::printf("%-15s %6s %7s %7s", "Rand error", "meshes", "floor", "people");
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
  print("all categories",
        [](const Row_summary& r) -> const Summary& { return r.over_categories; });
  std::printf("*: at most people's own\n");
}

inline Json json_of(const Score& score)
{
  Json json;
  for (std::size_t metric = 0; metric < NUMBER_OF_METRICS; ++metric)
    json[metric_names[metric]] = score.errors[metric];
  json["k"] = score.segments;
  json["excess"] = score.excess;
  json["congruent"] = score.congruent;
  json["partners_made"] = score.partners.made;
  json["partners_made_unlike"] = score.partners.made_unlike;
  json["seconds"] = score.seconds;
  return json;
}

inline Json json_of(const Summary& s)
{
  Json json = json_of(s.mean);
  json["median_seconds"] = s.median_seconds;
  json["meshes"] = s.meshes;
  json["floor"] = s.floor;
  json["people"] = s.people_error;
  return json;
}

inline Json json_of(const Row_summary& r)
{
  Json json;
  json["mean_over_meshes"] = json_of(r.over_meshes);
  json["mean_over_categories"] = json_of(r.over_categories);
  json["categories_at_or_below_people"] = r.categories_at_or_below_people();
  for (const auto& [category, summary] : r.categories)
    json["categories"][category_names[category]] = json_of(summary);
  return json;
}

inline Json json_of(const Scored_mesh& mesh)
{
  return {{"category", category_names[category(mesh.id)]},
          {"faces", mesh.faces},
          {"number_of_people", mesh.people},
          {"usual_number_of_segments", mesh.usual_number_of_segments},
          {"floor", mesh.floor},
          {"people", mesh.people_error}};
}

// Values that are not defined are null.
inline Json json_report(const std::vector<Row_summary>& rows,
                        const std::vector<Scored_mesh>& meshes)
{
  Json json;
  for (const Scored_mesh& mesh : meshes)
    json["meshes"][std::to_string(mesh.id)] = json_of(mesh);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Json row = json_of(rows[i]);
    for (const Scored_mesh& mesh : meshes)
      row["meshes"][std::to_string(mesh.id)] = json_of(mesh.scores[i]);
    Json& methods = is_as_is(rows[i].row.triangulation)
      ? json["methods"] : json["triangulations"][rows[i].row.triangulation];
    methods[rows[i].row.method][name(rows[i].row.protocol)] = row;
  }
  return json;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SCORE_REPORT_H
