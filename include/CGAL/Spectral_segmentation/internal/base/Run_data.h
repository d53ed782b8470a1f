// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_DATA_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_DATA_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

typedef std::array<Index, 2> Face_pair;

// The constraints of the caller, in terms of the indices of the caller's faces. A constraint on an
// edge is stored as its two faces.
struct Constraints
{
  std::vector<Face_pair> cannot_link; // the two faces belong to different segments
  std::vector<Face_pair> must_link;   // the two faces belong to the same segment
  std::vector<std::pair<Index, std::int64_t> > seeds; // faces ascend, seeds are not negative

  bool empty() const { return cannot_link.empty() && must_link.empty() && seeds.empty(); }
};

// Returns whether each of n faces is constrained. `face` holds one of them for each of the caller's
// faces.
inline std::vector<char> constrained_faces(const Constraints& constraints,
                                           const std::vector<Index>& face, std::size_t n)
{
  std::vector<char> result(n, 0);
  for (const auto& pairs : {&constraints.cannot_link, &constraints.must_link})
    for (const auto& [f, g] : *pairs)
      result[face[f]] = result[face[g]] = 1;
  for (const auto& constraint : constraints.seeds)
    result[face[constraint.first]] = 1;
  return result;
}

// The feature vectors of the caller's faces. They are read one by one, so that no copy of all is
// needed.
struct Feature_source
{
  std::size_t dimension = 0; // 0: there are no features
  std::function<void(Index face, double* vector)> read;
};

// The constants of a method. `Calibrated_part_salience` was fitted with those of the calibrated
// method, the defaults, and must be fitted again (benchmark/fit_part_salience.py) if one of them
// changes but the last two. The ablation study in the manual shows the gain of most.
struct Method_constants
{
  // The radius for averaging curvature, as a fraction of the square root of the area of the mesh.
  // With 0 the method uses dihedral angles.
  double concavity_radius = 0.02;
  bool bisection = true;            // whether faces larger than the searched ones are bisected
  std::size_t number_of_refined_candidates = 4; // cuts of a part that are moved to minimum cuts
  std::size_t number_of_regions = 20; // of an over-segmentation; 0 if the method makes none
  bool keeps_points = false;    // whether a mesh that is not coarsened is searched as given
  double time_per_face = 50000; // of the search, in nanoseconds, for the progress
};

inline Method_constants constants_of(Method method)
{
  Method_constants result;
  if (method == Method::ZHANG_LIU_2005) {
    result.concavity_radius = 0;
    result.bisection = false;
    result.number_of_regions = 0;
    result.keeps_points = true;
    result.time_per_face = 4000;
  }
  return result;
}

// The data of a run beside the mesh.
struct Run_data
{
  const Options& options;
  const Method_constants& method;
  const Constraints& constraints;
  const Feature_source& features;
  Execution execution;
  Run_monitor& monitor;
  double time_scale;            // the fraction of the run that takes a nanosecond
  double fraction_of_model = 1; // less than 1 for a part that is searched at the scale of a model

  // Starts a phase that takes some nanoseconds.
  void start_phase(double time) const { monitor.start_phase(time_scale * time); }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_DATA_H
