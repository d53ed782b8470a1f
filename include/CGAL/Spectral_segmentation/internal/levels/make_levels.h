// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_MAKE_LEVELS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_MAKE_LEVELS_H

#include <CGAL/Spectral_segmentation/internal/base/Run_data.h>
#include <CGAL/Spectral_segmentation/internal/levels/Cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/levels/coarsening.h>
#include <CGAL/Spectral_segmentation/internal/surface/is_convex.h>
#include <CGAL/Spectral_segmentation/internal/search/recursion.h>
#include <CGAL/Spectral_segmentation/internal/surface/Longest_edge_bisection.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/weights/searched_features.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// ONE_PART: a convex mesh, which has no cuts.
enum class Search { NEEDED, ONE_PART, STOPPED };

// The surfaces of a run: the mesh, the mesh with large faces bisected, and coarser surfaces. Cuts
// are searched on the last, which has weights.
struct Levels
{
  std::vector<Level> levels;
  Search search = Search::NEEDED;
  Face_features features; // of the last level

  const Surface& mesh() const { return levels.front().surface; }
  const Surface& last() const { return levels.back().surface; }

  // Returns the caller's face for each face of a level.
  std::vector<Index> callers_faces(std::size_t level) const
  {
    std::vector<Index> result = levels[level].parent_face;
    while (level-- > 0)
      for (Index& f : result)
        f = levels[level].parent_face[f];
    return result;
  }

  // Returns the vertex of the last level for each vertex of a level, or null_index.
  std::vector<Index> vertices_of_last(std::size_t level) const
  {
    std::vector<Index> result = first_indices(levels[level].surface.points.size());
    while (++level < levels.size())
      for (Index& v : result)
        v = v == null_index ? v : levels[level].coarse_vertex[v];
    return result;
  }
};

// Returns the number of faces of the even mesh on which cuts are searched. A mesh of few faces has
// a simple shape. On 190 meshes that were decimated to 300 faces, 1,300 faces agree with human
// segmentations as well as 4,000, and take a third of the time.
inline double search_resolution(const Options& o, std::size_t number_of_faces)
{ return static_cast<double>((std::min)(o.number_of_coarse_faces, number_of_faces + 1000)); }

// Returns the number of faces to which the surface of a mesh is coarsened: the resolution, and in
// proportion if more regions are needed than by default. In the paper's recursion it must not
// depend on the number of segments, because a hierarchy gives the labels of runs with fewer.
inline std::size_t faces_to_search(const Run_data& d, std::size_t faces_of_mesh,
                                   std::size_t faces_of_surface)
{
  const Options& o = d.options;
  const std::size_t regions = d.method.number_of_regions;
  const double growth = regions > 0
    ? static_cast<double>(number_of_regions(o, regions)) / static_cast<double>(regions) : 1;
  const double number = search_resolution(o, faces_of_mesh) * growth;
  return number > 0 && number < static_cast<double>(faces_of_surface)
    ? static_cast<std::size_t>(number) : faces_of_surface;
}

// Estimates of the times of the phases of a run, in nanoseconds. Only the reported progress depends
// on them.
struct Phase_times
{
  double reading, coarsening, search, projection;

  Phase_times(const Run_data& d, std::size_t number_of_faces)
  {
    const double n = static_cast<double>(number_of_faces);
    const double m = static_cast<double>(faces_to_search(d, number_of_faces, number_of_faces));
    reading = 150 * n;
    coarsening = (m < n ? 1250 : 100) * n;
    search = d.method.time_per_face * m;
    projection = (m < n ? 250 : 0) * n;
  }

  double time_after_reading() const { return coarsening + search + projection; }
};

// Returns whether the mesh itself is searched.
inline bool is_searched_itself(const Run_data& d, std::size_t number_of_faces)
{
  return d.options.number_of_coarse_faces == 0 ||
         (d.method.keeps_points &&
          faces_to_search(d, number_of_faces, number_of_faces) == number_of_faces);
}

inline bool has_features(const Run_data& d)
{ return d.features.dimension > 0 && d.options.feature_weight > 0; }

// Adds the steps between the features of single faces of a level, which locate cuts more exactly
// than means.
inline void add_steps_of_faces(const Run_data& d, double unit,
                               const std::vector<Index>& callers_face, Surface& surface)
{
  add_feature_steps(features_of_faces(d.features, unit, callers_face), 1, d.options.feature_weight,
                    surface);
}

// Sets the features of the last level, and adds their steps to its weights.
inline void set_features(Levels& l, const Run_data& d)
{
  const std::size_t finest = l.levels.size() > 2 && l.levels[1].is_subdivision ? 1 : 0;
  const std::vector<Index> faces = l.callers_faces(finest), vertices = l.vertices_of_last(finest);
  Surface& searched = l.levels.back().surface;
  l.features = searched_features(
    searched, Feature_means(d.features, l.levels[finest].surface, faces, vertices,
                            searched.points.size())());
  if (l.features.empty())
    return;
  // Faces have the means of their corners. Therefore neighbors differ by only a third of the
  // difference of their opposite corners.
  add_feature_steps(l.features, 3, d.options.feature_weight, searched);
  add_steps_of_faces(d, l.features.unit, l.callers_faces(l.levels.size() - 1), searched);
}

// Returns whether the search is skipped if the mesh is a convex solid. The coarse surface of many
// faces is searched as fast if they are convex as if they are not.
inline bool may_be_one_part(const Surface& mesh, const Run_data& d)
{
  return mesh.number_of_faces() <= d.options.number_of_coarse_faces &&
         d.method.number_of_regions > 0 && !d.options.number_of_segments && !has_features(d) &&
         mesh.components.number == 1;
}

// Adds the levels from the mesh, which is the first, to the one on which cuts are searched. Faces
// that are larger than the faces of an even mesh with as many faces are bisected, so that a cut can
// run anywhere. Throws `Run_stopped`.
inline void add_levels(std::vector<Level>& levels, const Run_data& d)
{
  const Options& o = d.options;
  Surface& mesh = levels.front().surface;
  const std::size_t n = mesh.number_of_faces();
  d.monitor.check();
  std::vector<Vector> points;
  if (o.number_of_smoothing_iterations > 0 || is_searched_itself(d, n))
    points = smoothed_points(mesh, o.number_of_smoothing_iterations,
                             [&] { d.monitor.check(); return true; });
  if (!is_searched_itself(d, n)) {
    if (o.number_of_smoothing_iterations > 0)
      mesh.points = std::move(points);
    const double resolution = search_resolution(o, n);
    if (d.method.bisection && total_area(mesh) > 0)
      if (const auto bound = bound_of_edges(d.execution, mesh, resolution, 16 * resolution))
        levels.push_back(Longest_edge_bisection(mesh, *bound)(d.execution));
    const Surface& finest = levels.back().surface;
    for (Level& level : coarsened(d.execution, finest,
                                  faces_to_search(d, n, finest.number_of_faces()), d.monitor))
      levels.push_back(std::move(level));
    points = levels.back().surface.points;
  }
  Surface& searched = levels.back().surface;
  set_face_distances(d.execution, searched, points, face_normals(d.execution, searched, points),
                     distance_weights(o, d.method));
}

// Adds the levels to the mesh, which is the only one, and stays the only one if no search is needed
// or the run is stopped meanwhile.
inline void make_levels(Levels& l, const Run_data& d)
{
  d.start_phase(Phase_times(d, l.mesh().number_of_faces()).coarsening);
  if (may_be_one_part(l.mesh(), d) && is_convex(l.mesh())) {
    l.search = Search::ONE_PART;
    return;
  }
  try {
    add_levels(l.levels, d);
    if (has_features(d))
      set_features(l, d);
  }
  catch (const Run_stopped&) {
    l.search = Search::STOPPED;
    l.levels.resize(1);
  }
}

// Carries the cuts of the last level back to the level before it, which becomes the last.
inline Merge_tree carry_back(Merge_tree tree, Levels& l, const Run_data& d)
{
  const std::size_t to = l.levels.size() - 2;
  const Level& from = l.levels.back();
  const Surface& mesh = l.levels[to].surface;
  const Face_fractions fractions(mesh, from, tree.leaf);
  const auto add_steps = [&](const std::vector<Index>& faces, Surface& bands) {
    if (!l.features.empty() && (to == 0 || l.levels[to].is_subdivision))
      add_steps_of_faces(d, l.features.unit, composed(faces, l.callers_faces(to)), bands);
  };
  // The method of the paper loses no small sides: its runs would end with fewer segments than the
  // hierarchy of a longer run has after as many cuts.
  const double minimum_area = tree.is_monotonic
    ? d.options.minimum_segment_size * total_area(mesh) / d.fraction_of_model : 0;
  Cut_transfer transfer(d.execution, tree, mesh, minimum_area, fractions,
                        distance_weights(d.options, d.method), add_steps, d.monitor);
  Merge_tree result = transfer();
  l.levels.pop_back();
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_MAKE_LEVELS_H
