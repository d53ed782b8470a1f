// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_PARTS_H
#define SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_PARTS_H

#include "../random_numbers.h"
#include "../run_engine.h"

#include <CGAL/Spectral_segmentation/internal/salience/Patch.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

// The parts of a mesh that the experiments cut.
namespace segmentation_benchmark {

using CGAL::Spectral_segmentation::internal::Cut;
using CGAL::Spectral_segmentation::internal::Sides;

struct Part
{
  Surface graph;
  std::vector<Index> faces; // their numbers in the mesh, ascending
};

// Returns a random engine for a mesh, by its number in the benchmark.
inline Random_engine random_engine(int id, std::uint32_t seed = 1)
{
  std::seed_seq seeds{seed, std::uint32_t(0), static_cast<std::uint32_t>(id)};
  return Random_engine(seeds);
}

inline Index random_face(std::size_t number_of_faces, Random_engine& random)
{ return static_cast<Index>(random() % number_of_faces); }

inline std::vector<Index> all_faces(const Surface& part)
{
  return CGAL::Spectral_segmentation::internal::first_indices(part.number_of_faces());
}

// Returns the connected components.
inline std::vector<Part> components(const Surface& mesh)
{
  const CGAL::Spectral_segmentation::internal::Components of_mesh =
    connected_components(mesh);
  const std::vector<Index> component = of_mesh.face_labels(mesh.number_of_faces());
  const std::size_t number = of_mesh.number;
  std::vector<Part> parts(number);
  for (Index f = 0; f < component.size(); ++f)
    parts[component[f]].faces.push_back(f);
  std::vector<Surface> graphs = split(mesh, component, number);
  for (std::size_t i = 0; i < number; ++i)
    parts[i].graph = std::move(graphs[i]);
  return parts;
}

// Returns the component with the most faces, which is the first part that is cut.
inline Part whole_part(const Surface& mesh)
{
  std::vector<Part> parts = components(mesh);
  return std::move(*std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b)
                                     { return a.faces.size() < b.faces.size(); }));
}

inline Labels labels_of_part(const Part& part, const Labels& labels)
{
  Labels result;
  for (Index f : part.faces)
    result.push_back(labels[f]);
  return contiguous(result);
}

// Returns 1 minus a fraction: the faces that the cut takes off the person's segments, of each the
// smaller of two pieces, relative to those of the cut's smaller side. It is 1 where the cut follows
// the borders of segments, 0 where the smaller side is nowhere the larger piece of one.
inline double agreement(const Part& part, const Sides& side, const Labels& person)
{
  const Eigen::ArrayXXd faces =
    overlap(Labels(side.begin(), side.end()), labels_of_part(part, person));
  return 1 - faces.colwise().minCoeff().sum() / faces.rowwise().sum().minCoeff();
}

inline double minimum_area(const Surface& mesh)
{ return Engine_options::zhang_liu_2005().minimum_segment_size * total_area(mesh); }

// Returns the segments of the paper's recursion with any two-way cut: the part of the largest area
// is cut next, until there are k parts or none can be cut. `sides_of(part)` are the sides of the
// faces of a part, if it has a cut. Connected components of the mesh are parts from the start.
template <class SidesOf>
Labels recursive_cuts(const Surface& mesh, std::size_t k, const SidesOf& sides_of)
{
  std::vector<Part> parts = components(mesh);
  std::vector<double> areas; // 0 if there is no cut
  for (const Part& part : parts)
    areas.push_back(total_area(part.graph));
  while (parts.size() < k) {
    const auto largest = std::max_element(areas.begin(), areas.end());
    if (!(*largest > 0))
      break;
    Part& part = parts[static_cast<std::size_t>(largest - areas.begin())];
    const std::optional<Sides> sides = sides_of(std::as_const(part));
    *largest = 0;
    if (!sides)
      continue;
    std::vector<Surface> graphs = split(part.graph, *sides, 2);
    std::vector<Index> faces[2];
    for (std::size_t i = 0; i < part.faces.size(); ++i)
      faces[int((*sides)[i])].push_back(part.faces[i]);
    const double areas_of_sides[] = {total_area(graphs[0]), total_area(graphs[1])};
    part = {std::move(graphs[0]), std::move(faces[0])};
    *largest = areas_of_sides[0];
    parts.push_back({std::move(graphs[1]), std::move(faces[1])});
    areas.push_back(areas_of_sides[1]);
  }

  Labels labels(mesh.number_of_faces());
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (Index f : parts[i].faces)
      labels[f] = i;
  return labels;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PAPER_EXPERIMENTS_PARTS_H
