// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PART_METRICS_H
#define SEGMENTATION_BENCHMARK_PART_METRICS_H

#include "evaluation.h"

#include <Eigen/Core>

#include <limits>
#include <vector>

// Measures in which each part counts the same, however small it is. In the Rand error a false
// segment of a thousandth of the faces costs nothing, but a person sees it at once.
namespace segmentation_benchmark {

// From this intersection over union on, a segment is a part of a person.
constexpr double least_overlap_of_found_part = 0.5;

// A false segment with a smaller fraction of the mesh is a scrap.
constexpr double greatest_fraction_of_scrap = 0.01;

struct Part_agreement
{
  double panoptic_quality = undefined; // A. Kirillov et al., Panoptic Segmentation, CVPR 2019
  double mean_overlap = undefined;     // of a person's parts with the most similar segments
  double made = undefined;             // the fraction of the segments that some person made
  double false_segments = undefined;   // the number of segments that nobody made
  double scraps = undefined;           // the number of those that are scraps
  // Defined only for meshes that are their own mirror images, except for details
  // (mirror_metrics.h):
  double unlike = undefined;     // the number of segments whose mirror images are no segments
  double same_place = undefined; // of the others, the fraction whose seams are mirror images
};

// Returns the intersection over union of each row with each column.
inline Eigen::ArrayXXd overlap_ratios(const Eigen::ArrayXXd& overlap)
{
  const Eigen::ArrayXd rows = overlap.rowwise().sum();
  const Eigen::ArrayXXd columns = overlap.colwise().sum();
  const Eigen::ArrayXXd all = rows.replicate(1, overlap.cols()) +
                              columns.replicate(overlap.rows(), 1) - overlap;
  return overlap / all.max((std::numeric_limits<double>::min)()); // areas may be 0
}

// Compares segments with the parts of some people, given the overlap of the segments, in rows, with
// the parts of each person, in columns. The first two measures are means over people.
inline Part_agreement part_agreement(const std::vector<Eigen::ArrayXXd>& overlaps)
{
  Mean quality, mean_overlap;
  Eigen::ArrayXd best = Eigen::ArrayXd::Zero(overlaps.front().rows());
  for (const Eigen::ArrayXXd& overlap : overlaps) {
    const Eigen::ArrayXXd ratios = overlap_ratios(overlap);
    quality.add((ratios > 0.5).select(ratios, 0).sum() * 2 /
                static_cast<double>(ratios.rows() + ratios.cols()));
    mean_overlap.add(ratios.colwise().maxCoeff().mean());
    best = best.max(ratios.rowwise().maxCoeff());
  }
  typedef Eigen::Array<bool, Eigen::Dynamic, 1> Flags;
  const Eigen::ArrayXd sizes = overlaps.front().rowwise().sum();
  const Flags is_false = best < least_overlap_of_found_part;
  const Flags is_small = sizes < greatest_fraction_of_scrap * sizes.sum();
  const double number = static_cast<double>(is_false.count());
  Part_agreement result;
  result.panoptic_quality = quality();
  result.mean_overlap = mean_overlap();
  result.made = 1 - number / static_cast<double>(best.size());
  result.false_segments = number;
  result.scraps = static_cast<double>((is_false && is_small).count());
  return result;
}

// The measures, in the order in which tables have them.
struct Part_measure
{
  const char* title;
  const char* key; // in JSON
  double Part_agreement::*value;
};

constexpr Part_measure part_measures[] = {
  {"PQ", "panoptic_quality", &Part_agreement::panoptic_quality},
  {"IoU", "mean_overlap", &Part_agreement::mean_overlap},
  {"made", "made", &Part_agreement::made},
  {"false", "false_segments", &Part_agreement::false_segments},
  {"scraps", "scraps", &Part_agreement::scraps},
  {"unlike", "unlike", &Part_agreement::unlike},
  {"place", "same_place", &Part_agreement::same_place}};

// Returns the mean of each measure where it is defined.
inline Part_agreement mean_agreement(const std::vector<Part_agreement>& all)
{
  Part_agreement result;
  for (const Part_measure& measure : part_measures)
    result.*measure.value = mean_of(values_of(all, measure.value));
  return result;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PART_METRICS_H
