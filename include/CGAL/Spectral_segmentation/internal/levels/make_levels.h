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
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// ONE_PART: a convex mesh, which has no cuts.
enum class Search { NEEDED, ONE_PART, STOPPED };

// The levels of one search after the shared ones. If there are none, the last of those is searched.
struct Searched_levels
{
  std::vector<Level> levels;
  Face_features features; // of the last level
};

// The surfaces of a run: the mesh, the mesh with large faces bisected or vertices clustered, and
// coarser surfaces. Cuts are searched on the last level of each search, which has weights.
struct Levels
{
  std::vector<Level> shared; // by all searches
  std::vector<Searched_levels> searches;
  Search search = Search::NEEDED;

  const Surface& mesh() const { return shared.front().surface; }

  const Surface& searched(std::size_t i) const
  { return (searches[i].levels.empty() ? shared : searches[i].levels).back().surface; }

  Surface& searched(std::size_t i)
  { return const_cast<Surface&>(std::as_const(*this).searched(i)); }

  // Returns the levels of a search, from the mesh to the surface that is searched.
  std::vector<const Level*> levels_of(std::size_t i) const
  {
    std::vector<const Level*> result;
    for (const std::vector<Level>* levels : {&shared, &searches[i].levels})
      for (const Level& level : *levels)
        result.push_back(&level);
    return result;
  }
};

// Returns the caller's face for each face of a level, given the levels of a search up to it.
inline std::vector<Index> callers_faces(const std::vector<const Level*>& levels, std::size_t last)
{
  std::vector<Index> result = levels[last]->parent_face;
  while (last-- > 0)
    result = composed(result, levels[last]->parent_face);
  return result;
}

// Returns the vertex of the last level for each vertex of another one, or null_index.
inline std::vector<Index> last_vertices(const std::vector<const Level*>& levels, std::size_t level)
{
  std::vector<Index> result = first_indices(levels[level]->surface.points.size());
  while (++level < levels.size())
    for (Index& v : result)
      v = v == null_index ? v : levels[level]->coarse_vertex[v];
  return result;
}

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

// Sets the features of the surface of a search, and adds their steps to its weights.
inline void set_features(Levels& l, std::size_t search, const Run_data& d)
{
  const std::vector<const Level*> levels = l.levels_of(search);
  const std::size_t finest = levels.size() > 1 && levels[1]->is_subdivision ? 1 : 0;
  Surface& searched = l.searched(search);
  Face_features& features = l.searches[search].features;
  features = searched_features(
    searched, Feature_means(d.features, levels[finest]->surface, callers_faces(levels, finest),
                            last_vertices(levels, finest), searched.points.size())());
  if (features.empty())
    return;
  // Faces have the means of their corners. Therefore neighbors differ by only a third of the
  // difference of their opposite corners.
  add_feature_steps(features, 3, d.options.feature_weight, searched);
  add_steps_of_faces(d, features.unit, callers_faces(levels, levels.size() - 1), searched);
}

// Returns whether the search is skipped if the mesh is a convex solid. The coarse surface of many
// faces is searched as fast if they are convex as if they are not.
inline bool may_be_one_part(const Surface& mesh, const Run_data& d)
{
  return mesh.number_of_faces() <= d.options.number_of_coarse_faces &&
         d.method.number_of_regions > 0 && !d.options.number_of_segments && !has_features(d) &&
         mesh.components.number == 1;
}

// Adds the levels that are the same for all searches. Large faces are bisected, so that a cut can
// run anywhere. The vertices of a very fine mesh are clustered, so that searches take little time.
inline void add_shared_levels(std::vector<Level>& levels, const Run_data& d)
{
  constexpr double largest_ratio = 64; // of the faces of a level and of a surface that is searched
  const Options& o = d.options;
  Surface& mesh = levels.front().surface;
  const std::size_t n = mesh.number_of_faces();
  if (o.number_of_smoothing_iterations > 0)
    mesh.points = smoothed_points(mesh, o.number_of_smoothing_iterations,
                                  [&] { d.monitor.check(); return true; });
  const double resolution = search_resolution(o, n), area = total_area(mesh);
  if (d.method.bisection && area > 0)
    if (const auto bound = bound_of_edges(d.execution, mesh, resolution, 16 * resolution))
      levels.push_back(Longest_edge_bisection(mesh, *bound)(d.execution));
  const Surface& finest = levels.back().surface;
  const double number = static_cast<double>(faces_to_search(d, n, finest.number_of_faces()));
  if (static_cast<double>(finest.number_of_faces()) > largest_ratio * number && area > 0)
    levels.push_back(clustered(d.execution, finest, width_of_cells(area, number) / 4));
}

// Returns the number of faces of a search, relative to the first one. The fractions 1, 5/6, 11/12,
// 3/4, ... are evenly spread (van der Corput 1935).
inline double fraction_of_faces(std::size_t search)
{
  double result = 1;
  for (double step = 1. / 6; search > 0; search /= 2, step /= 2)
    result -= search % 2 == 1 ? step : 0;
  return result;
}

// Adds a search, and the levels to the surface on which it searches cuts. Throws `Run_stopped`.
inline void add_search(Levels& l, std::size_t search, const Run_data& d)
{
  const std::size_t n = l.mesh().number_of_faces();
  const Surface& shared = l.shared.back().surface;
  const double number = static_cast<double>(faces_to_search(d, n, shared.number_of_faces()));
  if (!is_searched_itself(d, n))
    l.searches[search].levels =
      coarsened(d.execution, shared,
                static_cast<std::size_t>(std::ceil(number * fraction_of_faces(search))), d.monitor);
  Surface& searched = l.searched(search);
  const std::vector<Vector> points = !is_searched_itself(d, n) ? searched.points
    : smoothed_points(shared, d.options.number_of_smoothing_iterations,
                      [&] { d.monitor.check(); return true; });
  set_face_distances(d.execution, searched, points, face_normals(d.execution, searched, points),
                     distance_weights(d.options, d.method));
  if (has_features(d))
    set_features(l, search, d);
  d.monitor.advance(1 / static_cast<double>(l.searches.size()));
}

// Adds the levels to the mesh, which is the only one, and stays the only one if no search is needed
// or the run is stopped meanwhile.
inline void make_levels(Levels& l, std::size_t number_of_searches, const Run_data& d)
{
  const std::size_t n = l.mesh().number_of_faces();
  d.start_phase(Phase_times(d, n).coarsening);
  if (may_be_one_part(l.mesh(), d) && is_convex(l.mesh())) {
    l.search = Search::ONE_PART;
    return;
  }
  const auto unless_stopped = [&](const auto& f) {
    try {
      d.monitor.check();
      f();
    }
    catch (const Run_stopped&) {
    }
  };
  if (!is_searched_itself(d, n))
    unless_stopped([&] { add_shared_levels(l.shared, d); });
  l.searches.resize(is_searched_itself(d, n) ? 1 : number_of_searches);
  for_each_index(d.execution, l.searches.size(), [&](std::size_t i)
    { unless_stopped([&] { add_search(l, i, d); }); });
  if (d.monitor.is_stopped()) {
    l.search = Search::STOPPED;
    l.shared.resize(1);
    l.searches.clear();
  }
}

// Carries the cuts of a level back to the surface from which it was made. `add_steps(faces, bands)`
// may change the weights of these faces.
template <class Add_steps>
Merge_tree carry_back(const Merge_tree& tree, const Level& from, const Surface& to,
                      const Add_steps& add_steps, const Run_data& d)
{
  const Face_fractions fractions(to, from, tree.leaf);
  // The method of the paper loses no small sides: its runs would end with fewer segments than the
  // hierarchy of a longer run has after as many cuts.
  const double minimum_area = tree.is_monotonic
    ? d.options.minimum_segment_size * total_area(to) / d.fraction_of_model : 0;
  return Cut_transfer(d.execution, tree, to, minimum_area, fractions,
                      distance_weights(d.options, d.method), add_steps, d.monitor)();
}

// Carries the cuts of a search back to the mesh, level by level.
inline Merge_tree carry_to_mesh(Merge_tree tree, const Levels& l, std::size_t search,
                                const Run_data& d)
{
  const Face_features& features = l.searches[search].features;
  const std::vector<const Level*> levels = l.levels_of(search);
  for (std::size_t i = levels.size() - 1; i > 0; --i)
    tree = carry_back(tree, *levels[i], levels[i - 1]->surface,
                      [&](const std::vector<Index>& faces, Surface& bands) {
      if (!features.empty() && (i == 1 || levels[i - 1]->is_subdivision))
        add_steps_of_faces(d, features.unit, composed(faces, callers_faces(levels, i - 1)), bands);
    }, d);
  return tree;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_MAKE_LEVELS_H
