// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_VISITOR_H
#define CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_VISITOR_H

#include <CGAL/Spectral_segmentation/Salience_factors.h>

#include <cstddef>

namespace CGAL {
namespace Spectral_segmentation {

/// \ingroup PkgSpectralSegmentationRef
/// The stages of a run, which include the stages of Table 1 in Zhang and Liu 2005. If a mesh of
/// several components is searched as several surfaces, the stages of the entire mesh come once for
/// each of them, and initialization once more for the mesh.
enum class Stage
{
  INITIALIZATION,    ///< dual graph of the faces, coarsening, face distances; once
  SAMPLING,          ///< the two sample faces of a part, by shape context
  EMBEDDING,         ///< distances from the samples, and the order of the faces on each line
  LINE_SEARCH,       ///< the most salient cut along the lines, and minimum cuts near the best ones
  MERGING,           ///< merging of regions into segments; once, calibrated method (default) only
  PROJECTION         ///< projection of the cuts of a coarse mesh onto the mesh; once
};

/// \ingroup PkgSpectralSegmentationRef
/// Receives the progress of a run and may cancel it. All functions do nothing by default: derive
/// from this class and redefine those you need. The functions are not virtual: a run never calls a
/// function whose name is misspelt. The compiler finds this only if the class redefines no other.
///
/// A part is identified by the index of its node in the `Segmentation_hierarchy` of the run. In the
/// calibrated method (default), which merges regions after the searches, it is identified by its
/// position in the order in which its search found parts, times `number_of_searches`, plus the
/// position of its search.
///
/// No two functions are called at the same time. With `CGAL::Parallel_tag` several parts are
/// searched at once; therefore their calls interleave and come from different threads.
///
/// If a run is stopped, or ended by an exception, some `before_` calls have no `after_` call, and
/// with `CGAL::Parallel_tag` other parts may call once more after that. An exception that leaves a
/// visitor ends the run, passes through the function that the caller called, and leaves the
/// caller's labels unchanged.
struct Segmentation_visitor
{
  /// the part of stages that concern the entire mesh
  static constexpr std::size_t whole_mesh = static_cast<std::size_t>(-1);

  /// A stage of the search in `part` starts, or a stage of the entire mesh (`whole_mesh`).
  void before_stage(Stage /* stage */, std::size_t /* part */) {}

  /// The stage has ended.
  void after_stage(Stage /* stage */, std::size_t /* part */) {}

  /// The search for the best cut of `part` starts. The part has two faces or more, and is large
  /// enough for two segments of minimum size.
  void before_part(std::size_t /* part */, std::size_t /* number_of_faces */) {}

  /// The search for the best cut of `part` has ended.
  void after_part(std::size_t /* part */) {}

  /// `part` was cut in two. There are now `number_of_segments` segments; in the calibrated method
  /// (default) they are the regions of one search before merging.
  void after_cut(std::size_t /* part */, const Salience_factors&, double /* salience */,
                 std::size_t /* number_of_segments */) {}

  /// About this fraction of the run is done. It is between 0 and 1 and never decreases; 1 is
  /// reported at the end of a run that was not stopped. The function is called some dozens to some
  /// hundreds of times.
  void progress(double /* fraction */) {}

  /// Returns whether the run shall go on. The run calls it in every stage: between the shortest
  /// path trees and the other steps of the search, every few milliseconds while the mesh is
  /// coarsened, and between passes over the mesh. Once it returns `false`, the run ends and does
  /// not call it again. The labels are then given by the cuts made so far, with the regions found
  /// so far merged. If there is no cut yet, each connected component is a segment. The cuts of
  /// a coarse mesh are then projected without minimum cuts, in a few passes over the mesh.
  bool go_further() { return true; }
};

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_VISITOR_H
