// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_JUDGED_CUTS_H
#define SEGMENTATION_BENCHMARK_JUDGED_CUTS_H

#include "princeton_benchmark.h"

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/internal/Run_control.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/region_merging.h>
#include <CGAL/Spectral_segmentation/internal/multilevel/coarsening.h>
#include <CGAL/Spectral_segmentation/internal/Options.h>
#include <CGAL/Spectral_segmentation/internal/door/read_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <utility>
#include <vector>

// The cuts that a run has to judge, and what people think of them.
namespace segmentation_benchmark {

namespace spectral = CGAL::Spectral_segmentation;
using spectral::internal::Judged_cut;

struct Cut_sample
{
  spectral::Salience_factors factors;
  double agreement; // of people
};

// Cuts among which one is chosen: the candidates of a part, or a single boundary.
struct Cut_group
{
  Judged_cut::Kind kind;
  std::vector<Cut_sample> cuts;
};

struct Mesh_cuts
{
  int id;
  std::vector<Cut_group> groups;
};

inline std::size_t number_of_cuts(const std::vector<Mesh_cuts>& meshes)
{
  std::size_t number = 0;
  for (const Mesh_cuts& mesh : meshes)
    for (const Cut_group& group : mesh.groups)
      number += group.cuts.size();
  return number;
}

inline Labels labels_of(const std::vector<spectral::internal::Index>& faces, const Labels& labels)
{
  Labels result;
  for (spectral::internal::Index f : faces)
    result.push_back(labels[f]);
  return result;
}

// 1 less the faces that the cut takes off the person's segments, of each the smaller of two pieces,
// relative to those of the cut's smaller side: 1 where it follows the borders of segments, 0 where
// the smaller side is nowhere the larger piece of one.
inline double agreement(const Judged_cut& cut, const Labels& person)
{
  const Eigen::ArrayXXd faces =
    overlap(Labels(cut.side.begin(), cut.side.end()), labels_of(cut.faces, person));
  return 1 - faces.colwise().minCoeff().sum() / faces.rowwise().sum().minCoeff();
}

inline double mean_agreement(const Judged_cut& cut, const std::vector<Labels>& people)
{
  Mean mean;
  for (const Labels& person : people)
    mean.add(agreement(cut, person));
  return mean();
}

// All cuts that the calibrated method judges on its way.
inline Mesh_cuts judged_cuts(const Benchmark_mesh& input, std::size_t number_of_searched_faces)
{
  namespace internal = spectral::internal;
  internal::Options options = internal::calibrated_options();
  options.number_of_searched_faces = number_of_searched_faces;
  const std::vector<Mesh::Face_index> faces(input.mesh.faces().begin(), input.mesh.faces().end());
  internal::Mesh_levels mesh = internal::initialize<CGAL::Sequential_tag>(
    internal::read_triangles(input.mesh, faces, input.mesh.points(),
                             CGAL::Exact_predicates_inexact_constructions_kernel()),
    options, [] { return true; });
  std::vector<Labels> people = input.people;
  for (const internal::Coarse_mesh& simplified : mesh.simplified)
    for (Labels& person : people)
      person = labels_of(simplified.faces, person);

  Mesh_cuts result{input.id, {}};
  std::pair<internal::Index, std::size_t> last_part(internal::null_index, 0);
  const auto observe = [&](const Judged_cut& cut) {
    // No two parts that are searched have both the first face and the size in common.
    const std::pair<internal::Index, std::size_t> part(cut.faces.front(), cut.faces.size());
    if (cut.kind == Judged_cut::BOUNDARY || part != last_part)
      result.groups.push_back({cut.kind, {}});
    last_part = part;
    result.groups.back().cuts.push_back({cut.factors, mean_agreement(cut, people)});
  };
  spectral::Segmentation_visitor visitor;
  internal::Monitor<spectral::Segmentation_visitor> monitor(visitor);
  internal::cut_and_merge<CGAL::Sequential_tag>(std::move(mesh.searched()), options, monitor,
                                                observe);
  return result;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_JUDGED_CUTS_H
