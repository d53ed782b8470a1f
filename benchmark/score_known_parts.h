// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SCORE_KNOWN_PARTS_H
#define SEGMENTATION_BENCHMARK_SCORE_KNOWN_PARTS_H

#include "score_report.h"

#include <CGAL/Spectral_segmentation/internal/base/Index.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Kernel/global_functions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Measures how well methods find known parts, from files with the part of each triangle.
namespace segmentation_benchmark {

// A part with a smaller fraction of the area of the mesh is hardly seen.
constexpr double least_share_of_area = 0.005;

struct Known_parts
{
  std::string name;
  Triangle_soup soup;
  Labels truth; // per triangle
};

inline Triangle_soup read_triangle_soup(const std::filesystem::path& path)
{
  Triangle_soup soup;
  if (!CGAL::IO::read_polygon_soup(path.string(), soup.points, soup.triangles))
    throw std::runtime_error("cannot read " + path.string());
  if (soup.triangles.empty())
    throw std::runtime_error(path.string() + " has no triangle");
  for (const std::vector<std::size_t>& corners : soup.triangles)
    if (corners.size() != 3)
      throw std::runtime_error(path.string() + " has a face that is no triangle");
  return soup;
}

// Reads NAME.off, and the parts from NAME.truth beside it, which has one integer for each triangle.
inline Known_parts read_known_parts(const std::filesystem::path& off_file)
{
  Triangle_soup soup = read_triangle_soup(off_file);
  Labels truth = read_labels(std::filesystem::path(off_file).replace_extension(".truth"),
                             soup.triangles.size());
  return {off_file.stem().string(), std::move(soup), std::move(truth)};
}

// Returns the .off files of a folder, sorted by name.
inline std::vector<std::filesystem::path> off_files(const std::filesystem::path& folder)
{
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".off")
      files.insert(entry.path());
  if (files.empty())
    throw std::runtime_error(folder.string() + " has no .off file");
  return {files.begin(), files.end()};
}

inline std::vector<double> triangle_areas(const Triangle_soup& soup)
{
  std::vector<double> areas;
  for (const auto& t : soup.triangles)
    areas.push_back(std::sqrt(CGAL::squared_area(soup.points[t[0]], soup.points[t[1]],
                                                 soup.points[t[2]])));
  return areas;
}

// Returns the component of each triangle. All triangles at an edge are connected.
inline Labels components(const Triangle_soup& soup)
{
  using CGAL::Spectral_segmentation::internal::Index;
  const Index n = static_cast<Index>(soup.triangles.size());
  CGAL::Spectral_segmentation::internal::Disjoint_sets sets(n);
  std::map<std::pair<std::size_t, std::size_t>, Index> first_at_edge;
  for (Index f = 0; f < n; ++f) {
    const auto& corners = soup.triangles[f];
    for (std::size_t i = 0; i < 3; ++i)
      sets.join(f, first_at_edge.emplace(std::minmax(corners[i], corners[(i + 1) % 3]), f)
                     .first->second);
  }
  std::vector<Index> representatives;
  for (Index f = 0; f < n; ++f)
    representatives.push_back(sets.representative(f));
  return contiguous(representatives);
}

// A true part with at most this fraction of the area is small. One with less than
// `least_share_of_area` is not counted.
constexpr double greatest_share_of_small_part = 0.1;

struct Known_parts_score
{
  double by_area = 0, by_faces = 0; // Rand errors; the triangles of CAD have very different sizes
  double panoptic_quality = 0;       // by area
  std::size_t segments = 0;
  std::size_t found = 0; // small parts
};

struct Scored_known_parts
{
  std::string name;
  std::size_t parts = 0, small_parts = 0;
  std::vector<Known_parts_score> scores; // one a row
};

// Labels that need no search, with which a method is compared.
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
    if (const Tree_method* method = tree_method(row.method))
      return labels(*method, row.protocol);
    for (const Reference& reference : references())
      if (reference.name == row.method)
        return reference.segment(input_.soup);
    throw std::invalid_argument(row.method + " needs a manifold mesh");
  }

  Known_parts_score score(const Row& row)
  {
    const Labels result = contiguous(labels(row));
    const Eigen::ArrayXXd area = area_in_common(result);
    const Eigen::ArrayXd best = overlap_ratios(area).colwise().maxCoeff();
    const Flags is_found = best >= least_overlap_of_found_part;
    return {rand_error_by_area(area), rand_error(result, input_.truth),
            part_agreement({area}).panoptic_quality, number_of_segments(result),
            static_cast<std::size_t>((is_small_ && is_found).count())};
  }

public:
  explicit Known_parts_scorer(const Known_parts& input)
    : input_(input), face_areas_(triangle_areas(input.soup))
  {
    const Eigen::ArrayXd areas =
      area_in_common(Labels(input.truth.size(), 0)).row(0).transpose();
    const Eigen::ArrayXd fractions = areas / areas.sum();
    const Flags is_counted = fractions >= least_share_of_area;
    parts_ = static_cast<std::size_t>(is_counted.count());
    is_small_ = is_counted && fractions <= greatest_share_of_small_part;
  }

  Scored_known_parts operator()(const std::vector<Row>& rows)
  {
    Scored_known_parts result{
      input_.name, parts_, static_cast<std::size_t>(is_small_.count()), {}};
    for (const Row& row : rows)
      result.scores.push_back(score(row));
    return result;
  }
};

// Returns the rows that can be of meshes whose parts are known, then the references. There are no
// people and no other triangulations, and methods must accept triangle soups.
inline std::vector<Row> rows_of_known_parts(const std::vector<Row>& rows)
{
  std::vector<Row> result;
  for (const Row& row : rows)
    if (tree_method(row.method) && is_as_is(row.triangulation))
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
inline void print_known_parts(const std::vector<Row>& rows,
                              const std::vector<Scored_known_parts>& meshes)
{
  std::size_t width = std::string("Rand error").size();
  for (const Row& row : rows)
    width = (std::max)(width, title(row).size());
  std::printf("%zu files with known parts\n%-*s %17s %8s %7s %7s %7s\n", meshes.size(),
              static_cast<int>(width), "Rand error", "by area", "by face", "PQ", "parts", "found");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto values = [&](const auto Known_parts_score::*value) {
      return values_of(meshes, [=](const Scored_known_parts& mesh)
                               { return static_cast<double>(mesh.scores[i].*value); });
    };
    const Estimated_mean by_area = estimated_mean(values(&Known_parts_score::by_area));
    std::printf("%-*s %7.4f +- %6.4f %8.4f %7.4f %7.2f", static_cast<int>(width),
                title(rows[i]).c_str(), by_area.mean, by_area.standard_error,
                mean_of(values(&Known_parts_score::by_faces)),
                mean_of(values(&Known_parts_score::panoptic_quality)),
                mean_of(values(&Known_parts_score::segments)));
    print_value(7, fraction_found(meshes, i));
    std::printf("\n");
  }
  std::printf("%-*s %17s %8s %7s %7.2f %7s\n", static_cast<int>(width), "truth", "-", "-", "-",
              mean_of(values_of(meshes, [](const Scored_known_parts& mesh)
                                        { return static_cast<double>(mesh.parts); })), "-");
  std::printf("PQ: panoptic quality by area; parts: those of the truth have at least 0.5 %% of the "
              "area\n"
              "found: fraction of the true parts of 0.5 to 10 %% of the area that have an "
              "intersection\n       over union of at least 0.5 with a segment\n");
}

inline Json json_of_known_parts(const std::vector<Row>& rows,
                                const std::vector<Scored_known_parts>& meshes)
{
  Json json;
  for (const Scored_known_parts& mesh : meshes)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Known_parts_score& score = mesh.scores[i];
      json[title(rows[i])][mesh.name] = {{"by_area", score.by_area},
                                         {"by_faces", score.by_faces},
                                         {"panoptic_quality", score.panoptic_quality},
                                         {"segments", score.segments},
                                         {"found", score.found}};
    }
  return json;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SCORE_KNOWN_PARTS_H
