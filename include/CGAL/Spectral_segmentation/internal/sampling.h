// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SAMPLING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SAMPLING_H

#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// Sampling based on shape context (Section 4).

// The first reference face: the paper takes a random one. The face farthest from the center of the
// part is as good, is at the end of a limb, and does not depend on the numbers of the faces.
inline Index farthest_face_from_center(const Face_dual_graph& graph)
{
  Vector center = Vector::Zero();
  double area = 0;
  for (Index f = 0; f < graph.number_of_faces(); ++f) {
    center += graph.areas[f] * graph.centroid(f);
    area += graph.areas[f];
  }
  if (area > 0)
    center /= area;
  std::vector<double> distance(graph.number_of_faces());
  for (Index f = 0; f < graph.number_of_faces(); ++f)
    distance[f] = (graph.centroid(f) - center).squaredNorm();
  const double largest = *std::max_element(distance.begin(), distance.end());
  // The first of those that are as far but for rounding.
  return static_cast<Index>(
    std::find_if(distance.begin(), distance.end(),
                 [&](double d) { return d >= (1 - 1e-9) * largest; }) - distance.begin());
}

// A random face. The part is told by its smallest face, so that the choice depends neither on the
// order in which parts are searched nor on the thread. The engine is the same on every platform.
inline Index random_face(const Face_dual_graph& graph, std::uint64_t seed, Index smallest_face)
{
  std::seed_seq seeds{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                      smallest_face, static_cast<Index>(graph.number_of_faces())};
  std::mt19937_64 engine(seeds);
  return static_cast<Index>(engine() % graph.number_of_faces());
}

struct Shape_contexts
{
  std::vector<Index> references;
  std::vector<float> values; // the context vector of face f begins at f * references.size()

  const float* operator[](Index f) const { return values.data() + f * references.size(); }
};

// The sums of the angle distances along the shortest geodesic paths to a face.
inline std::vector<float> angles_along_paths(const Face_dual_graph& graph, Index reference,
                                             const std::vector<double>& distance)
{
  const std::vector<Index> step =
    first_steps(graph, reference, &Face_dual_graph::Halfedge::geodesic, distance);
  constexpr float unknown = -1;
  std::vector<float> sum(graph.number_of_faces(), unknown);
  sum[reference] = 0;
  std::vector<Index> path;
  for (Index first = 0; first < sum.size(); ++first) {
    Index f = first;
    for (; sum[f] == unknown; f = graph.halfedges[step[f]].neighbor)
      path.push_back(step[f]);
    for (float s = sum[f]; !path.empty(); path.pop_back())
      sum[path.back() / 3] = s += graph.halfedges[path.back()].angle;
  }
  return sum;
}

// Chooses k reference faces, or all of a part with fewer, mutually farthest apart in geodesic
// distance, and sums the angle distances along the shortest geodesic paths to each, while the tree
// of the next one grows. `between_trees()` is called before each tree.
template <class ConcurrencyTag, class BetweenTrees>
Shape_contexts shape_contexts(const Face_dual_graph& graph, Index first_reference, std::size_t k,
                              const BetweenTrees& between_trees)
{
  const std::size_t n = graph.number_of_faces();
  k = (std::min)(k, n);
  Shape_contexts contexts;
  contexts.values.resize(n * k);
  std::vector<double> to_nearest(n, std::numeric_limits<double>::infinity());
  std::vector<double> distance, next_distance;
  const auto grow_tree = [&] {
    const Index reference = contexts.references.empty() ? first_reference : static_cast<Index>(
      std::max_element(to_nearest.begin(), to_nearest.end()) - to_nearest.begin());
    contexts.references.push_back(reference);
    next_distance = shortest_paths(graph, reference, &Face_dual_graph::Halfedge::geodesic);
    for (Index f = 0; f < n; ++f)
      to_nearest[f] = (std::min)(to_nearest[f], next_distance[f]);
  };
  const auto sum_angles = [&](std::size_t j, Index reference) {
    const std::vector<float> angles = angles_along_paths(graph, reference, distance);
    for (Index f = 0; f < n; ++f)
      contexts.values[f * k + j] = angles[f];
  };
  between_trees();
  grow_tree();
  for (std::size_t j = 0; j < k; ++j) {
    distance.swap(next_distance);
    const Index reference = contexts.references.back();
    if (j + 1 < k)
      between_trees();
    for_each_index<ConcurrencyTag>(j + 1 < k ? 2 : 1, [&](std::size_t task) {
      if (task == 0)
        sum_angles(j, reference);
      else
        grow_tree();
    });
  }
  return contexts;
}

struct Sample_faces
{
  Index s; // the face whose context has the largest norm
  Index t; // the one whose context differs most from that of s
};

// The two samples (Section 4.2) of a part with two faces or more. Of equals the first is taken.
inline Sample_faces sample_faces(const Shape_contexts& contexts)
{
  const std::size_t k = contexts.references.size();
  const Index n = static_cast<Index>(contexts.values.size() / k);
  const auto farthest = [&](const std::vector<float>& from, Index except) {
    Index best = null_index;
    double largest = -1;
    for (Index f = 0; f < n; ++f) {
      double squared = 0;
      for (std::size_t j = 0; j < k; ++j) {
        const double difference = double(contexts[f][j]) - from[j];
        squared += difference * difference;
      }
      if (f != except && squared > largest) {
        largest = squared;
        best = f;
      }
    }
    return best;
  };
  Sample_faces samples;
  samples.s = farthest(std::vector<float>(k, 0.f), null_index);
  samples.t = farthest(std::vector<float>(contexts[samples.s], contexts[samples.s] + k), samples.s);
  return samples;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SAMPLING_H
