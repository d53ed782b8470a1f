// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BEST_CUT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BEST_CUT_H

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/embedding.h>
#include <CGAL/Spectral_segmentation/internal/line_search.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/internal/sampling.h>
#include <CGAL/Spectral_segmentation/internal/shortest_paths.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// A connected part of the mesh that may be cut.
struct Part
{
  Face_dual_graph graph;
  std::size_t node;    // in the segment tree
  Index smallest_face; // its number in the mesh
};

// BESTCUT (Figure 2): the most salient cut of a part, if there is one.
// Throws `Run_stopped` if the visitor stops the run.
template <class ConcurrencyTag, class PartSalience, class Monitor>
std::optional<Cut> best_cut(const Part& part, const Options& options,
                            const PartSalience& part_salience, double minimum_area,
                            Monitor& monitor)
{
  const Face_dual_graph& m = part.graph;
  if (m.number_of_faces() < 2)
    return std::nullopt;
  monitor.check();
  monitor.start_part(part.node, m.number_of_faces());

  // 1. two sample faces
  const Sample_faces samples = monitor.stage(Stage::SAMPLING, part.node, [&] {
    const Index first = options.random_seed
      ? random_face(m, *options.random_seed, part.smallest_face) : farthest_face_from_center(m);
    return sample_faces(shape_contexts(m, first, options.number_of_reference_faces,
                                       [&] { monitor.check(); }));
  });

  // 2. distances from both; 3. to 5. the order of the faces on the line, for which neither kernel nor
  // eigenvectors are needed
  monitor.check();
  const std::vector<Index> line = monitor.stage(Stage::EMBEDDING, part.node, [&] {
    std::vector<double> from_s, from_t;
    const Weighting combined = &Face_dual_graph::Halfedge::combined;
    do_both<ConcurrencyTag>([&] { from_s = shortest_paths(m, samples.s, combined); },
                            [&] { from_t = shortest_paths(m, samples.t, combined); });
    return spectral_order(from_s, from_t);
  });

  // 6. line search
  monitor.check();
  std::optional<Cut> cut = monitor.stage(Stage::LINE_SEARCH, part.node, [&]
    { return line_search(m, line, part_salience, minimum_area); });

  monitor.end_part(part.node);
  return cut;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BEST_CUT_H
