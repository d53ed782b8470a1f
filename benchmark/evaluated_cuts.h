// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_EVALUATED_CUTS_H
#define SEGMENTATION_BENCHMARK_EVALUATED_CUTS_H

#include "princeton_benchmark.h"
#include "run_engine.h"

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/salience/Boundary_statistics.h>

#include <cstddef>
#include <utility>
#include <vector>

// The cuts that a run evaluates, and what people think of them.
namespace segmentation_benchmark {

namespace spectral = CGAL::Spectral_segmentation;
using spectral::internal::Evaluated_cut;

struct Cut_sample
{
  spectral::Salience_factors factors;
  double agreement; // among people
};

// Cuts among which one is chosen: the candidates of a part, or a single boundary.
struct Cut_group
{
  Evaluated_cut::Kind kind;
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
inline double agreement(const Evaluated_cut& cut, const Labels& person)
{
  const Eigen::ArrayXXd faces =
    overlap(Labels(cut.side.begin(), cut.side.end()), labels_of(cut.faces, person));
  return 1 - faces.colwise().minCoeff().sum() / faces.rowwise().sum().minCoeff();
}

inline double mean_agreement(const Evaluated_cut& cut, const std::vector<Labels>& people)
{
  Mean mean;
  for (const Labels& person : people)
    mean.add(agreement(cut, person));
  return mean();
}

// Collects the cuts of a run with people's opinion of them.
class Cut_collector : public spectral::internal::Run_control
{
  const std::vector<Labels>& people_of_mesh_;
  std::vector<Labels> people_; // on the mesh that is searched
  Mesh_cuts& result_;
  std::pair<spectral::internal::Index, std::size_t> last_part_{spectral::internal::null_index, 0};

public:
  Cut_collector(const std::vector<Labels>& people, Mesh_cuts& result)
    : people_of_mesh_(people), result_(result) {}

  void start_search(const std::vector<spectral::internal::Index>& faces) override
  {
    for (const Labels& person : people_of_mesh_)
      people_.push_back(labels_of(faces, person));
  }

  void cut_evaluated(const Evaluated_cut& cut) override
  {
    // No two parts that are searched have both the first face and the size in common.
    const std::pair<spectral::internal::Index, std::size_t> part(cut.faces.front(),
                                                                 cut.faces.size());
    if (cut.kind == Evaluated_cut::BOUNDARY || part != last_part_)
      result_.groups.push_back({cut.kind, {}});
    last_part_ = part;
    result_.groups.back().cuts.push_back({cut.factors, mean_agreement(cut, people_)});
  }
};

// All cuts that the default method evaluates on its way.
inline Mesh_cuts evaluated_cuts(const Benchmark_mesh& input, const Engine_options& options)
{
  Mesh_cuts result{input.id, {}};
  run_engine(input.mesh, options, Execution::SEQUENTIAL, Cut_collector(input.people, result));
  return result;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_EVALUATED_CUTS_H
