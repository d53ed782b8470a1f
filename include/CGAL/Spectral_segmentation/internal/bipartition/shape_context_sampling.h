// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_SHAPE_CONTEXT_SAMPLING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_SHAPE_CONTEXT_SAMPLING_H

#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/distances/shortest_paths.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Sampling based on shape context (Section 4).

// The first reference face: the paper takes a random one. The face farthest from the center of the
// part is as good, is at the end of a limb, and does not depend on the numbers of the faces.
inline Index farthest_face_from_center(Execution execution, const Surface& graph)
{
  const double area = total_area(graph);
  const Vector center = area > 0 ? center_of(execution, graph, area) : Vector();
  std::vector<double> distance(graph.number_of_faces());
  for_each_index(execution, distance.size(), [&](std::size_t f)
    { distance[f] = (graph.centroid(static_cast<Index>(f)) - center).squared_norm(); });
  const double largest = *std::max_element(distance.begin(), distance.end());
  // The first of those that are as far but for rounding.
  return static_cast<Index>(
    std::find_if(distance.begin(), distance.end(),
                 [&](double d) { return d >= (1 - 1e-9) * largest; }) - distance.begin());
}

// A random face. The part is told by its smallest face, so that the choice depends neither on the
// order in which parts are searched nor on the thread. The engine is the same on every platform.
inline Index random_face(const Surface& graph, std::uint64_t seed, Index smallest_face)
{
  std::seed_seq seeds{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                      smallest_face, static_cast<Index>(graph.number_of_faces())};
  std::mt19937_64 engine(seeds);
  return static_cast<Index>(engine() % graph.number_of_faces());
}

struct Shape_contexts
{
  std::vector<Index> references;
  Eigen::MatrixXf values; // a row for each face, a column for each reference
};

// Chooses k reference faces, or all of a part with fewer, mutually farthest apart in geodesic
// distance, and sums the angle distances along the shortest geodesic paths to each. Calls
// `before_search()` before each search for paths.
template <class BeforeSearch>
Shape_contexts shape_contexts(const Surface& graph, Index first_reference, std::size_t k,
                              const BeforeSearch& before_search)
{
  const std::size_t n = graph.number_of_faces();
  k = (std::min)(k, n);
  Shape_contexts contexts;
  contexts.values.resize(n, k);
  std::vector<double> to_nearest(n, infinite_distance);
  Index reference = first_reference;
  for (std::size_t j = 0; j < k; ++j) {
    before_search();
    contexts.references.push_back(reference);
    const Geodesic_paths paths = geodesic_paths(graph, reference);
    for (Index f = 0; f < n; ++f) {
      contexts.values(f, j) = paths.angles[f];
      to_nearest[f] = (std::min)(to_nearest[f], paths.lengths[f]);
    }
    const auto farthest = std::max_element(to_nearest.begin(), to_nearest.end());
    reference = static_cast<Index>(farthest - to_nearest.begin());
  }
  return contexts;
}

struct Sample_faces
{
  Index s; // the face whose context has the largest norm
  Index t; // the one whose context differs most from that of s
};

// The two samples (Section 4.2) of a part with two faces or more. Of equals the first is taken.
inline Sample_faces sample_faces(Execution execution, const Shape_contexts& contexts)
{
  const auto farthest = [&](Index from) { // null_index: from 0
    std::vector<double> squared(contexts.values.rows(), 0);
    for_each_index(execution, squared.size(), [&](std::size_t f) {
      for (Eigen::Index j = 0; j < contexts.values.cols(); ++j) {
        const double difference = double(contexts.values(static_cast<Eigen::Index>(f), j)) -
                                  (from == null_index ? 0 : contexts.values(from, j));
        squared[f] += difference * difference;
      }
    });
    if (from != null_index)
      squared[from] = -1;
    return static_cast<Index>(std::max_element(squared.begin(), squared.end()) - squared.begin());
  };
  Sample_faces samples;
  samples.s = farthest(null_index);
  samples.t = farthest(samples.s);
  return samples;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BIPARTITION_SHAPE_CONTEXT_SAMPLING_H
