// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_CONTROL_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_CONTROL_H

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

struct Evaluated_cut;

// Receives the progress of the engine and may stop it. The functions mean the same as the functions
// of `Segmentation_visitor`. No two are called at the same time, but for `cut_evaluated()`, which
// several threads may call at once.
class Run_control
{
public:
  virtual ~Run_control() = default;

  virtual void before_stage(Stage, std::size_t /* part */) {}
  virtual void after_stage(Stage, std::size_t /* part */) {}
  virtual void before_part(std::size_t /* part */, std::size_t /* number_of_faces */) {}
  virtual void after_part(std::size_t /* part */) {}
  virtual void after_cut(std::size_t /* part */, const Salience_factors&, double /* salience */,
                         std::size_t /* number_of_segments */) {}
  virtual void progress(double /* share */) {}
  virtual bool go_further() { return true; }

  // Receive data for experiments: the faces of the caller's mesh that are left in the searched
  // mesh, and each cut whose factors were computed. The cut names faces by their positions among
  // these.
  virtual void start_search(const std::vector<Index>& /* faces */) {}
  virtual void cut_evaluated(const Evaluated_cut&) {}
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_CONTROL_H
