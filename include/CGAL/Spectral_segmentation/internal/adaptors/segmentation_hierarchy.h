// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_SEGMENTATION_HIERARCHY_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_SEGMENTATION_HIERARCHY_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/engine.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/recursion.h>

#include <cstddef>
#include <utility>

namespace CGAL::Spectral_segmentation::internal {

// Runs the engine. Returns its cuts with the maximum number of segments and the threshold that
// select them.
inline Segmentation_hierarchy
segmentation_hierarchy(Surface triangles, const Options& options, Execution execution,
                       Run_control& control, const Constraints& constraints = Constraints(),
                       const Feature_source& features = Feature_source())
{
  return {segment(std::move(triangles), options, execution, control, constraints, features),
          maximum_number(options), threshold(options)};
}

// Passes the calls of the engine on to the visitor of the caller, whose functions are not virtual.
template <class Visitor>
class Visitor_control : public Run_control
{
  Visitor& visitor_;

public:
  explicit Visitor_control(Visitor& visitor) : visitor_(visitor) {}

  void before_stage(Stage stage, std::size_t part) override { visitor_.before_stage(stage, part); }
  void after_stage(Stage stage, std::size_t part) override { visitor_.after_stage(stage, part); }
  void before_part(std::size_t part, std::size_t n) override { visitor_.before_part(part, n); }
  void after_part(std::size_t part) override { visitor_.after_part(part); }
  void after_cut(std::size_t part, const Salience_factors& factors, double salience,
                 std::size_t number_of_segments) override
  { visitor_.after_cut(part, factors, salience, number_of_segments); }
  void progress(double share) override { visitor_.progress(share); }
  bool go_further() override { return visitor_.go_further(); }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_SEGMENTATION_HIERARCHY_H
