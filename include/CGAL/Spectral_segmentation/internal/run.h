// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RUN_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RUN_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/bipartition/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/constraints/constrained.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/congruent_cuts.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/gaps.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/halving.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/recursion.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/region_merging.h>
#include <CGAL/Spectral_segmentation/internal/distances/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/engine.h>
#include <CGAL/Spectral_segmentation/internal/levels/Cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/levels/Grid_wrap.h>
#include <CGAL/Spectral_segmentation/internal/levels/Longest_edge_bisection.h>
#include <CGAL/Spectral_segmentation/internal/levels/coarsening.h>
#include <CGAL/Spectral_segmentation/internal/surface/soup.h>
#include <CGAL/Spectral_segmentation/internal/surface/locality_order.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// One run: the surface of the caller is prepared, levels of it are made for the search, the cuts of
// the coarsest come back, and the dendrogram is completed.
class Run
{
  typedef std::vector<std::unique_ptr<Level> > Levels;

  // The surface as it is worked on: in a unit of its own, its faces in an order of locality, and
  // where components are not kept apart without faces that are there already.
  struct Prepared
  {
    Surface surface;
    std::vector<Index> face; // for each of the caller's
    double unit = 1;         // the length of 1 in the coordinates of the caller
  };

  const Options& options_;
  const Constraints& constraints_;
  const Execution execution_;
  const Distance_weights distance_weights_;
  Run_monitor monitor_;

  void remove_twins(Prepared& p) const
  {
    const std::vector<Index> place = first_points_at_places(p.surface.points);
    const std::vector<Index> first_twin = first_twins(p.surface, place);
    Index number = 0;
    for (Index f = 0; f < first_twin.size(); ++f)
      p.face[f] = first_twin[f] == f ? number++ : p.face[first_twin[f]];
    if (number < first_twin.size()) {
      p.surface = without_twins(p.surface, first_twin, place);
      p.surface.components = connected_components(p.surface);
    }
  }

  void order_faces(Prepared& p)
  {
    const std::vector<Index> order = locality_order(p.surface);
    monitor_.advance(0.3);
    if (!monitor_.go_further())
      return;
    reorder(p.surface, order);
    std::vector<Index> number(order.size());
    for (Index i = 0; i < order.size(); ++i)
      number[order[i]] = i;
    for (Index& f : p.face)
      f = number[f];
    if (Components& components = p.surface.components; components.number > 1) {
      std::vector<Index> of_face;
      for (Index f : order)
        of_face.push_back(components[f]);
      number_by_first_faces(of_face);
      components.of_face = std::move(of_face);
    }
  }

  // A run that is stopped on the way leaves the faces in the caller's order.
  Prepared prepared(Surface surface)
  {
    Prepared p{std::move(surface), {}};
    p.face.resize(p.surface.number_of_faces());
    std::iota(p.face.begin(), p.face.end(), Index(0));
    p.surface.components = connected_components(p.surface);
    if (!options_.components_apart && p.surface.components.number > 1)
      remove_twins(p);
    if (monitor_.go_further())
      order_faces(p);
    monitor_.advance(0.3);
    p.unit = normalize(p.surface.points);
    set_areas(execution_, p.surface);
    check_number(p.surface);
    return p;
  }

  void check_number(const Surface& surface) const
  {
    if (!options_.number_of_segments)
      return;
    const std::size_t number = *options_.number_of_segments;
    const std::size_t least = options_.components_apart ? surface.components.number : 1;
    if (number < least || number > surface.number_of_faces())
      throw std::invalid_argument(
        "segment_spectral_recursive: number_of_segments is " + std::to_string(number) +
        ", but the mesh can have " + std::to_string(least) + " to " +
        std::to_string(surface.number_of_faces()) + " segments");
  }

  // Around components that touch: where none does, the surface itself is searched.
  void add_wrap(const Surface& surface, Levels& levels)
  {
    levels.push_back(std::make_unique<Grid_wrap>(execution_, surface));
    monitor_.check();
    if (levels.back()->surface().components.number == surface.components.number)
      levels.pop_back();
  }

  // Bisects the faces that are larger than those of an even mesh with the number of faces on which
  // cuts are searched, so that a cut can run anywhere.
  void add_bisected(const Surface& surface, Levels& levels) const
  {
    const double number_of_faces = static_cast<double>(options_.number_of_searched_faces);
    const auto bound = bound_of_edges(execution_, surface, number_of_faces, 16 * number_of_faces);
    if (bound)
      levels.push_back(std::make_unique<Bisected_level>(execution_, surface, *bound));
  }

  static const Surface& last_surface(const Surface& surface, const Levels& levels)
  { return levels.empty() ? surface : levels.back()->surface(); }

  // The levels from the surface to the one on which cuts are searched.
  Levels surfaces_to_search(const Surface& surface)
  {
    Levels levels;
    if (options_.number_of_searched_faces == 0)
      return levels;
    if (total_area(surface) > 0) {
      if (!options_.components_apart && surface.components.number > 1)
        add_wrap(surface, levels);
      if (levels.empty() && options_.bisection)
        add_bisected(surface, levels);
    }
    const Surface& finest = last_surface(surface, levels);
    const std::size_t number_of_faces = options_.faces_to_search(finest.number_of_faces());
    if (number_of_faces < finest.number_of_faces())
      add_coarse_levels(execution_, finest, number_of_faces, monitor_, levels);
    return levels;
  }

  // Bends are measured at `points`.
  Surface weighted(Surface surface, const std::vector<Vector>& points) const
  {
    set_face_distances(execution_, surface, points, face_normals(execution_, surface, points),
                       distance_weights_);
    return surface;
  }

  // Whether something is done with the surface after the search.
  bool is_needed_later() const
  { return options_.number_of_segments || !options_.components_apart || !constraints_.empty(); }

  // The surface on which cuts are searched.
  Surface searched_surface(Surface& surface, Levels& levels)
  {
    monitor_.check();
    std::vector<Vector> points = smoothed_points(surface, options_.number_of_smoothing_iterations,
                                                 [&] { monitor_.check(); return true; });
    if (options_.number_of_searched_faces == 0)
      return weighted(is_needed_later() ? surface : std::move(surface), points);
    surface.points = std::move(points);
    levels = surfaces_to_search(surface);
    const Surface& searched = last_surface(surface, levels);
    return weighted(searched, searched.points);
  }

  Dendrogram search(Surface surface)
  {
    const Best_cut best_cut(execution_, surface, options_);
    if (options_.method == Method::ZHANG_LIU_2005)
      return Recursion(execution_, std::move(surface), best_cut, options_, monitor_).by_area();
    Dendrogram d = Recursion(execution_, surface, best_cut, options_, monitor_).by_salience();
    monitor_.stage(Stage::MERGING, Segmentation_visitor::whole_mesh, [&] {
      Region_merging(execution_, surface, best_cut.context(), options_.part_salience, monitor_)(d);
      unite_congruent_cuts(surface, d);
    });
    return d;
  }

  void bring_back(Dendrogram& d, Levels& levels)
  {
    for (; !levels.empty(); levels.pop_back()) {
      const Level& level = *levels.back();
      d.leaf = Cut_transfer(execution_, level, d, distance_weights_, monitor_)();
      set_areas(level.finer(), d);
      number_leaves_by_first_faces(d);
    }
  }

  // All nodes of the dendrogram fulfill the constraints then.
  void constrain(const Surface& surface, Face_groups& groups, Dendrogram& d)
  {
    Constrained_regions make_regions(execution_, d, surface, distance_weights_,
                                     options_.minimum_segment_size, monitor_, groups);
    Region_graph regions = make_regions(options_.components_apart);
    d = Constrained_merging(d, regions)(surface, make_regions.region_of_faces(),
                                        make_regions.leaves());
    std::vector<char> unused(d.number_of_leaves());
    const std::size_t least =
      replay(d, unused, [](std::size_t, char, char) { return char(); }).number;
    if (least > options_.maximum() &&
        (!options_.components_apart || least > surface.components.number))
      throw std::invalid_argument(
        "segment_spectral_recursive: the seams and seeds need " + std::to_string(least) +
        " segments, but " + std::to_string(options_.maximum()) + " are allowed");
  }

  // As many cuts as were asked for.
  void complete(const Surface& surface, Face_groups& groups, Dendrogram& d)
  {
    if (!options_.components_apart)
      merge_over_gaps(surface, d);
    if (!constraints_.empty())
      constrain(surface, groups, d);
    if (!options_.number_of_segments || monitor_.is_stopped())
      return;
    const std::size_t number = *options_.number_of_segments;
    Leaf_halving(surface, d, groups.group)(number);
    if (d.number_of_leaves() < number)
      throw std::invalid_argument(
        "segment_spectral_recursive: number_of_segments is " + std::to_string(number) +
        ", but the edges that must not be cut and the seeds leave at most " +
        std::to_string(d.number_of_leaves()) + " segments");
  }

  // From the numbers and the unit of the run to those of the caller.
  void convert(const Prepared& p, Dendrogram& d) const
  {
    std::vector<Index> leaf;
    leaf.reserve(p.face.size());
    for (Index f : p.face)
      leaf.push_back(d.leaf[f]);
    d.leaf = std::move(leaf);
    for (double& area : d.areas)
      area *= p.unit * p.unit;
  }

public:
  Run(const Options& options, const Constraints& constraints, Execution execution,
      Segmentation_visitor& visitor)
    : options_(options), constraints_(constraints), execution_(execution),
      distance_weights_{options.geodesic_weight, options.concave_angle_weight,
                        options.convex_angle_weight, options.concavity_radius},
      monitor_(visitor) {}

  Dendrogram operator()(Surface given)
  {
    // About how long the phases take, in nanoseconds; only what is told of the progress depends on
    // it.
    const double n = static_cast<double>(given.number_of_faces());
    const double m = static_cast<double>(options_.faces_to_search(given.number_of_faces()));
    const double of_reading = 150 * n;
    const double of_coarsening = (m < n ? 1250 : 100) * n;
    const double of_search = (options_.method == Method::CALIBRATED ? 50000 : 4000) * m;
    const double of_projection = (m < n ? 250 : 0) * n;
    const double all = (std::max)(of_reading + of_coarsening + of_search + of_projection, 1.);

    Prepared p;
    Levels levels;
    Dendrogram d;
    Face_groups groups;
    monitor_.start_phase(of_reading / all);
    try {
      Surface searched =
        monitor_.stage(Stage::INITIALIZATION, Segmentation_visitor::whole_mesh, [&] {
          p = prepared(std::move(given));
          if (!constraints_.empty())
            groups = Face_grouping(constraints_, p.face, p.surface.number_of_faces())(
              p.surface, options_.components_apart);
          monitor_.start_phase(of_coarsening / all);
          return searched_surface(p.surface, levels);
        });
      monitor_.start_phase(of_search / all);
      d = search(std::move(searched));
    }
    catch (const Run_stopped&) { // before there was a cut
      levels.clear();
      d = uncut_dendrogram(p.surface);
    }
    monitor_.start_phase(1);
    if (!levels.empty())
      monitor_.stage(Stage::PROJECTION, Segmentation_visitor::whole_mesh,
                     [&] { bring_back(d, levels); });
    complete(p.surface, groups, d);
    convert(p, d);
    monitor_.finish();
    return d;
  }
};

CGAL_SPECTRAL_SEGMENTATION_INLINE
Dendrogram segment(Surface surface, const Options& options, Execution execution,
                   Segmentation_visitor& visitor, const Constraints& constraints)
{
  Dendrogram result;
  call_isolated([&]
    { result = Run(options, constraints, execution, visitor)(std::move(surface)); });
  return result;
}

CGAL_SPECTRAL_SEGMENTATION_INLINE
void connect(Surface& soup) { connect_triangles(soup); }

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_RUN_H
