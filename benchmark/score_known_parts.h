// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SCORE_KNOWN_PARTS_H
#define SEGMENTATION_BENCHMARK_SCORE_KNOWN_PARTS_H

#include "known_parts.h"
#include "score_report.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

// How well methods find the parts of meshes whose parts are known.
namespace segmentation_benchmark {

// A true part with at most this share of the area is small. One with less than
// `least_share_of_area` is not counted.
constexpr double greatest_share_of_small_part = 0.1;

// From which intersection over union, by area, a segment is the true part.
constexpr double least_overlap_of_found_part = 0.5;

// Areas are what counts here: triangles of CAD are of all sizes, and most are on what is round.
struct Known_parts_score
{
  double by_area = 0, by_faces = 0; // Rand errors
  std::size_t segments = 0;
  std::size_t found = 0; // small parts
  Labels labels;
};

struct Scored_known_parts
{
  std::string name;
  std::size_t faces = 0, parts = 0, small_parts = 0;
  std::vector<Known_parts_score> scores; // one a row
};

// What a method is compared with: labels that need no search.
struct Reference
{
  const char* name;
  Labels (*segment)(const Triangle_soup&);
};

inline const std::vector<Reference>& references()
{
  static const std::vector<Reference> result = {
    {"one", [](const Triangle_soup& soup) { return Labels(soup.triangles.size(), 0); }},
    {"components", components},
  };
  return result;
}

class Known_parts_scorer
{
  typedef Eigen::Array<bool, Eigen::Dynamic, 1> Flags;

  const Known_parts& input_;
  std::vector<double> face_areas_;
  std::size_t parts_;
  Flags is_small_; // per part
  std::map<std::string, Method_trees> trees_; // by method

  Eigen::ArrayXXd area_in_common(const Labels& labels) const
  { return overlap(labels, input_.truth, face_areas_); }

  Labels labels(const Tree_method& method, Protocol protocol)
  {
    Method_trees& trees = trees_.try_emplace(method.name, method, input_.soup).first->second;
    if (protocol == Protocol::AUTO)
      return labels_of_tree(trees.down_to(method.default_threshold).tree,
                            method.default_threshold);
    const Segmentation_hierarchy& whole = trees.up_to(parts_).tree;
    return protocol == Protocol::K
      ? labels_of_tree(whole, any_salience, parts_)
      : best_labels(whole, [this](const Labels& of_tree)
                           { return rand_error_by_area(area_in_common(of_tree)); });
  }

  Labels labels(const Row& row)
  {
    for (const Tree_method& method : tree_methods())
      if (method.name == row.method)
        return labels(method, row.protocol);
    for (const Reference& reference : references())
      if (reference.name == row.method)
        return reference.segment(input_.soup);
    return default_labels(row.method, input_.mesh.value());
  }

  Known_parts_score score(const Row& row)
  {
    const Labels result = contiguous(labels(row));
    const Eigen::ArrayXXd area = area_in_common(result);
    const Flags is_found = greatest_overlaps(area) >= least_overlap_of_found_part;
    return {rand_error_by_area(area), rand_error(result, input_.truth),
            number_of_segments(result),
            static_cast<std::size_t>((is_small_ && is_found).count()), result};
  }

public:
  explicit Known_parts_scorer(const Known_parts& input)
    : input_(input), face_areas_(triangle_areas(input.soup))
  {
    const Eigen::ArrayXd areas =
      area_in_common(Labels(input.truth.size(), 0)).row(0).transpose();
    const Eigen::ArrayXd shares = areas / areas.sum();
    const Flags is_counted = shares >= least_share_of_area;
    parts_ = static_cast<std::size_t>(is_counted.count());
    is_small_ = is_counted && shares <= greatest_share_of_small_part;
  }

  Scored_known_parts operator()(const std::vector<Row>& rows)
  {
    Scored_known_parts result{input_.name, input_.truth.size(), parts_,
                              static_cast<std::size_t>(is_small_.count()), {}};
    for (const Row& row : rows)
      result.scores.push_back(score(row));
    return result;
  }
};

inline bool is_reference(const std::string& method)
{
  const std::vector<Reference>& all = references();
  return std::any_of(all.begin(), all.end(),
                     [&](const Reference& reference) { return reference.name == method; });
}

// Returns the rows that can be of meshes whose parts are known, then the references. People have
// not cut these meshes, and there is one triangulation. If the meshes are not manifold, only
// methods that segment triangle soups remain.
inline std::vector<Row> rows_of_known_parts(const std::vector<Row>& rows, bool are_manifold)
{
  std::vector<Row> result;
  for (const Row& row : rows)
    if (row.protocol != Protocol::OTHERS && is_as_is(row.triangulation) &&
        !is_reference(row.method) && (are_manifold || is_tree_method(row.method)))
      result.push_back(row);
  for (const Reference& reference : references())
    result.push_back({reference.name, Protocol::AUTO});
  return result;
}

// Returns the fraction of the small parts of all meshes that a row finds.
inline double fraction_found(const std::vector<Scored_known_parts>& meshes, std::size_t row)
{
  double found = 0, parts = 0;
  for (const Scored_known_parts& mesh : meshes) {
    found += static_cast<double>(mesh.scores[row].found);
    parts += static_cast<double>(mesh.small_parts);
  }
  return parts > 0 ? found / parts : undefined;
}

// Prints the means over meshes; of the Rand error by area, with its standard error.
inline void print_known_parts(const std::string& kind, const std::vector<Row>& rows,
                              const std::vector<Scored_known_parts>& meshes)
{
  std::size_t width = std::string("Rand error").size();
  for (const Row& row : rows)
    width = (std::max)(width, title(row).size());
  std::printf("%zu %s\n%-*s %17s %8s %7s %7s\n", meshes.size(), kind.c_str(),
              static_cast<int>(width), "Rand error", "by area", "by face", "parts", "found");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto values = [&](const auto Known_parts_score::*value) {
      return values_of(meshes, [=](const Scored_known_parts& mesh)
                               { return static_cast<double>(mesh.scores[i].*value); });
    };
    const Estimated_mean by_area = estimated_mean(values(&Known_parts_score::by_area));
    std::printf("%-*s %7.4f +- %6.4f %8.4f %7.2f", static_cast<int>(width), title(rows[i]).c_str(),
                by_area.mean, by_area.standard_error,
                mean_of(values(&Known_parts_score::by_faces)),
                mean_of(values(&Known_parts_score::segments)));
    print_value(7, fraction_found(meshes, i));
    std::printf("\n");
  }
  std::printf("%-*s %17s %8s %7.2f %7s\n", static_cast<int>(width), "truth", "-", "-",
              mean_of(meshes, [](const Scored_known_parts& mesh)
                              { return static_cast<double>(mesh.parts); }), "-");
  std::printf("parts: those of the truth have at least 0.5 %% of the area\n"
              "found: fraction of the true parts of 0.5 to 10 %% of the area that have an "
              "intersection\n       over union of at least 0.5 with a segment\n");
}

inline Json json_of_known_parts(const std::vector<Row>& rows,
                                const std::vector<Scored_known_parts>& meshes)
{
  Json json;
  for (const Scored_known_parts& mesh : meshes) {
    Json& of_mesh = json["meshes"][mesh.name] = {
      {"faces", mesh.faces}, {"parts", mesh.parts}, {"small_parts", mesh.small_parts}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Known_parts_score& score = mesh.scores[i];
      of_mesh["methods"][rows[i].method][name(rows[i].protocol)] = {{"by_area", score.by_area},
                                                                    {"by_faces", score.by_faces},
                                                                    {"k", score.segments},
                                                                    {"found", score.found}};
    }
  }
  return json;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SCORE_KNOWN_PARTS_H
