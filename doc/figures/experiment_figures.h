// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_EXPERIMENT_FIGURES_H
#define MANUAL_FIGURES_EXPERIMENT_FIGURES_H

#include "../../benchmark/paper_experiments/face_samples.h"
#include "../../benchmark/paper_experiments/spectral_clusters.h"
#include "Picture_book.h"
#include "method_figures.h"
#include "segmentations.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

// The figures about the experiments of the paper.
namespace manual_figures {

namespace benchmark = segmentation_benchmark;

// Draws samples by several schemes, with the best cut along the line of each, like Figure 3 of the
// paper. Angle distance is left out because its samples nearly equal those by combined distance.
inline void draw_samplings(Picture_book& book, const Named_mesh& shape)
{
  const Surface graph = paper_graph(shape.mesh);
  for (const benchmark::Sampling_scheme& scheme : benchmark::sampling_schemes) {
    if (scheme.name == std::string("angle"))
      continue;
    benchmark::Random_engine random = benchmark::random_engine(0);
    const std::vector<Index> samples = scheme.take(graph, 2, random);
    draw_regions(book, "samplings", shape, graph, Searched_line(graph, {samples[0], samples[1]}),
                 scheme.name);
  }
}

// Draws clusterings like Figure 4 of the paper, with some rows of the affinity matrix.
inline void draw_clusterings(Picture_book& book, const Named_mesh& shape, std::size_t k)
{
  const Surface graph = paper_graph(shape.mesh);
  const std::size_t rows = 500;
  benchmark::Random_engine random = benchmark::random_engine(0);
  Engine_options line_search = Engine_options::zhang_liu_2005();
  line_search.maximum_number_of_segments = k;
  line_search.salience_threshold = -std::numeric_limits<double>::infinity();
  Row_colors colors;
  add_segments(book, "clusterings", shape, colors, segment(shape.mesh, line_search),
               "line search");
  add_segments(book, "clusterings", shape, colors,
               benchmark::k_way_clusters(graph, k, rows, random), "k-way k-means");
  add_segments(book, "clusterings", shape, colors,
               benchmark::recursive_two_means(graph, k, rows, random), "recursive 2-means");
}

} // namespace manual_figures

#endif // MANUAL_FIGURES_EXPERIMENT_FIGURES_H
