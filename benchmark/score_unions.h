// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SCORE_UNIONS_H
#define SEGMENTATION_BENCHMARK_SCORE_UNIONS_H

#include "primitive_unions.h"
#include "score_report.h"

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

// How well methods find the primitives of which mechanical parts are united.
namespace segmentation_benchmark {

// Areas are what counts here: triangles of CAD are of all sizes, and most are on what is round.
struct Union_score
{
  double by_area = 0, by_faces = 0; // Rand errors
  double segments = 0;
  Labels labels;
};

struct Scored_union
{
  std::uint64_t seed = 0;
  std::size_t faces = 0, pieces = 0;
  std::vector<Union_score> scores; // one a row
};

class Union_scorer
{
  const Primitive_union& input_;
  std::vector<double> face_areas_;

  double error_by_area(const Labels& labels) const
  { return rand_error_by_area(overlap(labels, input_.truth, face_areas_)); }

  Labels labels(const Tree_method& method, Protocol protocol) const
  {
    Method_trees trees(method, input_.mesh);
    if (protocol == Protocol::AUTO)
      return labels_of_tree(trees.down_to(method.default_threshold).tree,
                            method.default_threshold);
    const std::size_t pieces = number_of_segments(input_.truth);
    const Segmentation_hierarchy& whole = trees.up_to(pieces).tree;
    return protocol == Protocol::K
      ? labels_of_tree(whole, any_salience, pieces)
      : best_labels(whole, [this](const Labels& of_tree) { return error_by_area(of_tree); });
  }

  Labels labels(const Row& row) const
  {
    for (const Tree_method& method : tree_methods())
      if (method.name == row.method)
        return labels(method, row.protocol);
    return default_labels(row.method, input_.mesh);
  }

public:
  explicit Union_scorer(const Primitive_union& input) : input_(input)
  {
    for (Mesh::Face_index f : input.mesh.faces())
      face_areas_.push_back(CGAL::Polygon_mesh_processing::face_area(f, input.mesh));
  }

  Union_score operator()(const Row& row) const
  {
    const Labels result = contiguous(labels(row));
    return {error_by_area(result), rand_error(result, input_.truth),
            static_cast<double>(number_of_segments(result)), result};
  }
};

// People have not cut these, and there is one triangulation.
inline std::vector<Row> rows_of_unions(const std::vector<Row>& rows)
{
  std::vector<Row> result;
  for (const Row& row : rows)
    if (row.protocol != Protocol::OTHERS && is_as_is(row.triangulation))
      result.push_back(row);
  return result;
}

inline void print_unions(const std::vector<Row>& rows, const std::vector<Scored_union>& unions)
{
  std::size_t width = std::string("Rand error").size();
  for (const Row& row : rows)
    width = (std::max)(width, title(row).size());
  std::printf("%zu unions of primitives\n%-*s %8s %8s %7s\n", unions.size(),
              static_cast<int>(width), "Rand error", "by area", "by face", "parts");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto mean = [&](double Union_score::*value) {
      return mean_of(unions, [=](const Scored_union& u) { return u.scores[i].*value; });
    };
    std::printf("%-*s %8.4f %8.4f %7.2f\n", static_cast<int>(width), title(rows[i]).c_str(),
                mean(&Union_score::by_area), mean(&Union_score::by_faces),
                mean(&Union_score::segments));
  }
  std::printf("%-*s %8s %8s %7.2f\n", static_cast<int>(width), "truth", "-", "-",
              mean_of(unions, [](const Scored_union& u)
                      { return static_cast<double>(u.pieces); }));
}

inline Json json_of_unions(const std::vector<Row>& rows, const std::vector<Scored_union>& unions)
{
  Json json;
  for (const Scored_union& u : unions) {
    Json& of_seed = json["seeds"][std::to_string(u.seed)] = {{"faces", u.faces},
                                                             {"pieces", u.pieces}};
    for (std::size_t i = 0; i < rows.size(); ++i)
      of_seed["methods"][rows[i].method][name(rows[i].protocol)] = {
        {"by_area", u.scores[i].by_area},
        {"by_faces", u.scores[i].by_faces},
        {"k", u.scores[i].segments}};
  }
  return json;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SCORE_UNIONS_H
