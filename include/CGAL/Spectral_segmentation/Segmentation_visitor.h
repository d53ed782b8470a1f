// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_VISITOR_H
#define CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_VISITOR_H

#include <CGAL/Spectral_segmentation/Part_salience.h>

#include <cstddef>

namespace CGAL {
namespace Spectral_segmentation {

/// \ingroup PkgSpectralSegmentationRef
/// The stages of a run, those of Table 1 in Zhang and Liu 2005.
enum class Stage
{
  INITIALIZATION,    ///< face dual graph, simplification, face distances, thickness, once
  SAMPLING,          ///< the two sample faces of a part, by shape context
  EMBEDDING,         ///< distances from the samples, order of the faces on each line
  LINE_SEARCH,       ///< the most salient cut along the lines, and minimum cuts near the best
  MERGING,           ///< pieces become segments again, once, if there are pieces
  TRANSFER,          ///< the cuts of a simplified mesh are carried over to the mesh, once
  BOUNDARY_SMOOTHING ///< morphological smoothing of the labels, once, if asked for
};

/// \ingroup PkgSpectralSegmentationRef
/// What a run reports while it works; every function does nothing, so a visitor derives from this
/// class and hides the functions that it needs.
///
/// Parts are named by the index of their node in the `Segment_tree` of the run; where pieces are
/// merged again, which is after all these calls, by the number in which they were found.
/// No two functions are called at the same time, but with `CGAL::Parallel_tag` several parts
/// are searched at once: their calls interleave and come from different threads.
/// A run that is stopped, or ended by an exception, leaves starts without their ends, and with
/// `CGAL::Parallel_tag` other parts may call once more after that.
/// An exception that leaves a visitor ends the run, passes through the caller's function, and
/// leaves the caller's labels as they were.
struct Segmentation_visitor
{
  /// the part of stages that concern the whole mesh
  static constexpr std::size_t whole_mesh = static_cast<std::size_t>(-1);

  /// A stage of the search in `part` starts, or one of the whole mesh.
  void start_stage(Stage /* stage */, std::size_t /* part */) {}

  /// The stage has ended.
  void end_stage(Stage /* stage */, std::size_t /* part */) {}

  /// The search for the best cut of `part` starts; it has two faces or more, and room for two
  /// segments of minimum size.
  void start_part(std::size_t /* part */, std::size_t /* number_of_faces */) {}

  /// The search for the best cut of `part` has ended.
  void end_part(std::size_t /* part */) {}

  /// `part` was cut in two; there are now `number_of_segments` segments, or pieces.
  void part_cut(std::size_t /* part */, const Salience_factors&, double /* salience */,
                std::size_t /* number_of_segments */) {}

  /// Asked before each stage of each part, between the shortest path trees of the sampling stage,
  /// and between the iterations of smoothing.
  /// As soon as it returns `false` the run stops; the labels are those of the cuts made so far, or
  /// of the pieces after merging.
  bool go_further() { return true; }
};

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_VISITOR_H
