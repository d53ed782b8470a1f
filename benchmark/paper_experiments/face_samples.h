// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_FACE_SAMPLES_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_FACE_SAMPLES_H

#include "parts.h"

#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/nystrom_embedding.h>
#include <CGAL/Spectral_segmentation/internal/search/line_search.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

// The ways to choose samples that the paper mentions (Sections 4 and 7.2), and the cut between two.
namespace segmentation_benchmark {

// Takes m different faces of a part, or all of a part with fewer.
struct Sampling_scheme
{
  const char* name;
  std::vector<Index> (*take)(const Surface& part, std::size_t m, Random_engine& random);
};

inline std::vector<Index> random_samples(const Surface& part, std::size_t m,
                                         Random_engine& random)
{
  const std::size_t n = part.number_of_faces();
  std::vector<Index> samples;
  while (samples.size() < (std::min)(m, n)) {
    const Index f = random_face(n, random);
    if (std::find(samples.begin(), samples.end(), f) == samples.end())
      samples.push_back(f);
  }
  return samples;
}

// Returns samples each of which is the one farthest from those before. `distances_from(f)` are the
// distances of all n faces.
template <class DistancesFrom>
std::vector<Index> farthest_first(std::size_t n, Index first, std::size_t m,
                                  const DistancesFrom& distances_from)
{
  std::vector<Index> samples = {first};
  std::vector<double> to_nearest(n, std::numeric_limits<double>::infinity());
  while (samples.size() < (std::min)(m, n)) {
    const std::vector<double> distance = distances_from(samples.back());
    for (std::size_t f = 0; f < n; ++f)
      to_nearest[f] = (std::min)(to_nearest[f], distance[f]);
    to_nearest[samples.back()] = -1; // so that it is not taken again where all distances are 0
    samples.push_back(static_cast<Index>(
      std::max_element(to_nearest.begin(), to_nearest.end()) - to_nearest.begin()));
  }
  return samples;
}

// Returns samples far apart along shortest paths. The first is farthest from a random face.
template <auto weighting>
std::vector<Index> samples_by_paths(const Surface& part, std::size_t m,
                                    Random_engine& random)
{
  const auto distances_from = [&](Index f)
  { return CGAL::Spectral_segmentation::internal::shortest_paths(part, weighting, f); };
  const std::size_t n = part.number_of_faces();
  const Index first = farthest_first(n, random_face(n, random), 2, distances_from).back();
  return farthest_first(n, first, m, distances_from);
}

// Returns samples whose shape contexts differ most. The first two are those of the paper, with the
// first reference face of the package.
inline std::vector<Index> samples_by_contexts(const Surface& part, std::size_t m,
                                              Random_engine&)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  const internal::Shape_contexts contexts = internal::shape_contexts(
    part, internal::farthest_face_from_center(Execution::SEQUENTIAL, part),
    Engine_options::zhang_liu_2005().number_of_reference_faces, [] {});
  const auto distances_from = [&](Index from) {
    std::vector<double> squared(part.number_of_faces(), 0);
    for (Index f = 0; f < squared.size(); ++f)
      for (Eigen::Index j = 0; j < contexts.values.cols(); ++j) {
        const double difference = double(contexts.values(f, j)) - contexts.values(from, j);
        squared[f] += difference * difference;
      }
    return squared;
  };
  return farthest_first(part.number_of_faces(),
                        internal::sample_faces(Execution::SEQUENTIAL, contexts).s, m,
                        distances_from);
}

constexpr std::array<Sampling_scheme, 5> sampling_schemes = {{
  {"random", random_samples},
  {"geodesic", samples_by_paths<&Edge_weights::geodesic>},
  {"angle", samples_by_paths<&Edge_weights::angle>},
  {"combined", samples_by_paths<&Edge_weights::combined>},
  {"shape context", samples_by_contexts},
}};

constexpr std::size_t shape_context_scheme = sampling_schemes.size() - 1;

// Returns the cut of BESTCUT of the paper (Figure 2), between two samples, if there is one.
inline std::optional<Cut> best_cut(const Surface& part, const std::vector<Index>& samples,
                                   double minimum_area)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  return internal::line_search(
    Execution::SEQUENTIAL, part,
    internal::face_order(Execution::SEQUENTIAL, part, {samples[0], samples[1]}),
    CGAL::Spectral_segmentation::Weighted_part_salience(), minimum_area);
}

// Returns the sides of the faces at the best cut between two samples of a scheme, if there is one.
inline std::optional<Sides> sides_by_samples(const Sampling_scheme& scheme, const Surface& part,
                                             double minimum_area, Random_engine& random)
{
  if (part.number_of_faces() < 2)
    return std::nullopt;
  const std::optional<Cut> cut = best_cut(part, scheme.take(part, 2, random), minimum_area);
  return cut ? std::optional<Sides>(cut->side) : std::nullopt;
}

// Returns the segments of the recursion with two samples of a scheme.
inline Labels recursive_cuts_by_samples(const Sampling_scheme& scheme, const Surface& mesh,
                                        std::size_t k, Random_engine& random)
{
  return recursive_cuts(mesh, k, [&](const Part& part)
    { return sides_by_samples(scheme, part.graph, minimum_area(mesh), random); });
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_FACE_SAMPLES_H
