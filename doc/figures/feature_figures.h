// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_FEATURE_FIGURES_H
#define MANUAL_FIGURES_FEATURE_FIGURES_H

#include "../../benchmark/made_features.h"
#include "Picture_book.h"
#include "segmentations.h"

#include <algorithm>
#include <string>

// Shape, features, and both.
namespace manual_figures {

// Draws an elephant whose features tell of socks, and of the head with the trunk, in noise.
inline void draw_features(Picture_book& book, const Named_mesh& elephant)
{
  namespace benchmark = segmentation_benchmark;
  const Mesh& mesh = elephant.mesh;
  Labels worn;
  for (Mesh::Face_index f : mesh.faces()) {
    Kernel::FT y = 0, z = 0;
    for (Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      y += mesh.point(v).y() / 3;
      z += mesh.point(v).z() / 3;
    }
    worn.push_back(y < -0.3 ? 1 : z > 0.15 ? 2 : 0);
  }
  benchmark::Random_engine random(1);
  benchmark::Feature_matrix features = benchmark::indicators(worn);
  features += 0.7 * benchmark::normal_noise(worn.size(), features.cols(), random);
  benchmark::Feature_source source;
  source.dimension = features.cols();
  source.read = [&](auto face, double* vector)
  { std::copy_n(features.row(face).data(), features.cols(), vector); };

  Row_colors colors;
  const Labels of_shape = segment(mesh, Engine_options());
  const Labels of_both = labels_of_run(
    benchmark::run_engine(mesh, Engine_options(), Execution::PARALLEL,
                          benchmark::Run_control(), source));
  add_segments(book, "features", elephant, colors, of_shape,
               "shape: " + count(number_of_segments(of_shape), "segments"));
  add_segments(book, "features", elephant, colors, benchmark::k_means(features, 3, random),
               "features: 3 clusters of k-means");
  add_segments(book, "features", elephant, colors, of_both,
               "both: " + count(number_of_segments(of_both), "segments"));
}

} // namespace manual_figures

#endif // MANUAL_FIGURES_FEATURE_FIGURES_H
