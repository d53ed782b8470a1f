// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_FEATURE_FIGURES_H
#define MANUAL_FIGURES_FEATURE_FIGURES_H

#include "../../benchmark/k_means.h"
#include "../../benchmark/made_features.h"
#include "Picture_book.h"
#include "segmentations.h"

#include <algorithm>
#include <string>

// The figure of segments by shape, by features, and by both.
namespace manual_figures {

// Draws an elephant whose noisy features mark socks and a cover of the trunk.
inline void draw_features(Picture_book& book, const Named_mesh& elephant)
{
  namespace benchmark = segmentation_benchmark;
  const Mesh& mesh = elephant.mesh;
  Labels worn;
  for (Mesh::Face_index f : mesh.faces()) {
    Kernel::FT height = 0;
    for (Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      height += mesh.point(v).y() / 3;
    worn.push_back(height < -0.28 ? 1 : height > 0.22 ? 2 : 0);
  }
  benchmark::Feature_random random(1);
  benchmark::Feature_matrix features = benchmark::indicators(worn);
  features += 0.4 * benchmark::normal_noise(worn.size(), features.cols(), random);
  benchmark::Feature_source source;
  source.dimension = features.cols();
  source.read = [&](auto face, double* vector)
  { std::copy_n(features.row(face).data(), features.cols(), vector); };

  Row_colors colors;
  const Labels shape_labels = segment(mesh, Engine_options());
  const Labels combined_labels = labels_of_run(
    benchmark::run_engine(mesh, Engine_options(), Execution::PARALLEL,
                          benchmark::Run_control(), source));
  add_segments(book, "features", elephant, colors, shape_labels, "shape");
  benchmark::Random_engine random_centers(1);
  add_segments(book, "features", elephant, colors,
               benchmark::k_means(features, 3, random_centers), "features, by k-means");
  add_segments(book, "features", elephant, colors, combined_labels, "both");
}

} // namespace manual_figures

#endif // MANUAL_FIGURES_FEATURE_FIGURES_H
