// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_MIRROR_METRICS_H
#define SEGMENTATION_BENCHMARK_MIRROR_METRICS_H

#include "part_metrics.h"
#include "run_engine.h"

#include <CGAL/Spectral_segmentation/internal/surface/symmetries.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Measures of how alike the segments of a mesh are that is its own mirror image, but for details.
namespace segmentation_benchmark {

class Mirror_scorer
{
  static constexpr double largest_common = 0.3; // of a segment with its own mirror image
  static constexpr double largest_distance = 2; // of mirrored seams, in mean edge lengths
  static constexpr double fraction_of_seam = 0.9; // that is nearer

  Surface surface_;
  double mean_edge_ = 0;
  std::vector<Index> image_; // the face at the mirror image of each; empty without symmetry

  std::vector<std::vector<Index> > seams(const Labels& labels) const
  {
    std::vector<std::vector<Index> > result(number_of_segments(labels));
    for (Index h = 0; h < surface_.number_of_halfedges(); ++h)
      if (labels[h / 3] != labels[surface_.neighbor(h)])
        result[labels[h / 3]].push_back(h / 3);
    return result;
  }

  // Returns whether most faces along a seam have mirror images near another seam.
  bool are_mirrored(const std::vector<Index>& seam, const std::vector<Index>& other) const
  {
    std::size_t near = 0;
    for (Index f : seam)
      near += std::any_of(other.begin(), other.end(), [&](Index g) {
        return (surface_.centroid(image_[f]) - surface_.centroid(g)).norm() <=
               largest_distance * mean_edge_;
      });
    return static_cast<double>(near) >= fraction_of_seam * static_cast<double>(seam.size());
  }

public:
  explicit Mirror_scorer(const Mesh& mesh) : surface_(triangles_of(mesh))
  {
    namespace internal = CGAL::Spectral_segmentation::internal;
    surface_.components = internal::connected_components(surface_);
    internal::normalize(surface_.points);
    internal::set_areas(Execution::SEQUENTIAL, surface_);
    internal::move_to_frame(Execution::SEQUENTIAL, surface_);
    const internal::Symmetry_search search(surface_);
    const auto reflection = search.reflection();
    if (!reflection)
      return;
    image_ = search.images(Execution::SEQUENTIAL, *reflection);
    for (Index f = 0; f < image_.size(); ++f)
      if (image_[f] == internal::null_index)
        image_[f] = f;
    for (Index h = 0; h < surface_.number_of_halfedges(); ++h)
      mean_edge_ += surface_.length(h) / static_cast<double>(surface_.number_of_halfedges());
  }

  // Sets how alike the segments are that are elsewhere than their mirror images. The mirror image
  // of a segment is another segment if the intersection over union of both is at least that of a
  // found part.
  void set(Part_agreement& result, const Labels& labels) const
  {
    if (image_.empty())
      return;
    const Eigen::Index n = static_cast<Eigen::Index>(number_of_segments(labels));
    Eigen::ArrayXXd overlap = Eigen::ArrayXXd::Zero(n, n); // of segments with mirror images
    for (Index f = 0; f < image_.size(); ++f)
      overlap(static_cast<Eigen::Index>(labels[f]),
              static_cast<Eigen::Index>(labels[image_[f]])) += surface_.areas[f];
    const Eigen::ArrayXXd ratios = overlap_ratios(overlap);
    const std::vector<std::vector<Index> > seam = seams(labels);
    result.unlike = 0;
    Mean same_place;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (overlap(i, i) > largest_common * overlap.row(i).sum())
        continue;
      Eigen::Index partner = 0;
      if (ratios.row(i).maxCoeff(&partner) < least_overlap_of_found_part || partner == i)
        ++result.unlike;
      else
        same_place.add(are_mirrored(seam[static_cast<std::size_t>(i)],
                                    seam[static_cast<std::size_t>(partner)]));
    }
    result.same_place = same_place();
  }
};

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_MIRROR_METRICS_H
