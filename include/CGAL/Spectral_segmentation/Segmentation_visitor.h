// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_VISITOR_H
#define CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_VISITOR_H

#include <CGAL/Spectral_segmentation/Part_salience.h>

#include <cstddef>

namespace CGAL {
namespace Spectral_segmentation {

/// \cond SKIP_IN_MANUAL
namespace internal {
struct Evaluated_cut;
} // namespace internal
/// \endcond

/// \ingroup PkgSpectralSegmentationRef
/// The stages of a run: those of Table 1 in Zhang and Liu 2005, and three of this package.
enum class Stage
{
  INITIALIZATION,    ///< face dual graph, coarsening, face distances, once
  SAMPLING,          ///< the two sample faces of a part, by shape context
  EMBEDDING,         ///< distances from the samples, order of the faces on each line
  LINE_SEARCH,       ///< the most salient cut along the lines, and minimum cuts near the best
  MERGING,           ///< the regions of the default method become segments, once
  PROJECTION,        ///< the cuts of a coarse mesh are projected onto the mesh, once
  BOUNDARY_SMOOTHING ///< smoothing of the labels, once, if asked for
};

/// \ingroup PkgSpectralSegmentationRef
/// What a run reports while it works. Every function does nothing: a visitor derives from this
/// class and overrides the functions that it needs.
///
/// Parts are named by the index of their node in the `Segmentation_hierarchy` of the run; in the
/// default method, which merges regions after all these calls, by the order in which they were
/// found.
/// No two functions are called at the same time. With `CGAL::Parallel_tag` several parts are
/// searched at once, so their calls interleave and come from different threads.
/// A run that is stopped, or ended by an exception, leaves starts without their ends, and with
/// `CGAL::Parallel_tag` other parts may call once more after that.
/// An exception that leaves a visitor ends the run, passes through the caller's function, and
/// leaves the caller's labels as they were.
struct Segmentation_visitor
{
  /// the part of stages that concern the whole mesh
  static constexpr std::size_t whole_mesh = static_cast<std::size_t>(-1);

  /// A stage of the search in `part` starts, or one of the whole mesh.
  virtual void start_stage(Stage /* stage */, std::size_t /* part */) {}

  /// The stage has ended.
  virtual void end_stage(Stage /* stage */, std::size_t /* part */) {}

  /// The search for the best cut of `part` starts; it has two faces or more, and room for two
  /// segments of minimum size.
  virtual void start_part(std::size_t /* part */, std::size_t /* number_of_faces */) {}

  /// The search for the best cut of `part` has ended.
  virtual void end_part(std::size_t /* part */) {}

  /// `part` was cut in two; there are now `number_of_segments` segments, or regions of the default
  /// method before they are merged.
  virtual void part_cut(std::size_t /* part */, const Salience_factors&, double /* salience */,
                        std::size_t /* number_of_segments */) {}

  /// About this share of the run is done: from 0 to 1, never less than before; 1 is reported at the
  /// end of a run that was not stopped. It is called some dozens to some hundreds of times.
  virtual void progress(double /* share */) {}

  /// Asked in every stage: between the shortest path trees and the other steps of the search, every
  /// few milliseconds while the mesh is coarsened, and between passes over the mesh.
  /// Once it returns `false` it is not called again, and the run ends. The labels are those of the
  /// cuts made so far, with the regions found so far merged; the connected components if there is
  /// no cut yet. Cuts of a coarse mesh are projected without minimum cuts then, in a few passes
  /// over the mesh.
  virtual bool go_further() { return true; }

  virtual ~Segmentation_visitor() = default;

  /// \cond SKIP_IN_MANUAL
  // Each cut whose factors were computed, for fits. It names faces of the surface that is searched.
  virtual void cut_evaluated(const internal::Evaluated_cut&) {}
  /// \endcond
};

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_VISITOR_H
