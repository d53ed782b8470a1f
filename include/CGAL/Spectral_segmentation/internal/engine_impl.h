// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ENGINE_IMPL_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ENGINE_IMPL_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/engine.h>
#include <CGAL/Spectral_segmentation/internal/levels/Cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/levels/coarsening.h>
#include <CGAL/Spectral_segmentation/internal/search/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/search/recursion.h>
#include <CGAL/Spectral_segmentation/internal/search/region_merging.h>
#include <CGAL/Spectral_segmentation/internal/surface/Longest_edge_bisection.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/component_walls.h>
#include <CGAL/Spectral_segmentation/internal/surface/connect_triangles.h>
#include <CGAL/Spectral_segmentation/internal/surface/model_components.h>
#include <CGAL/Spectral_segmentation/internal/surface/reorder_faces.h>
#include <CGAL/Spectral_segmentation/internal/surface/weld_borders.h>
#include <CGAL/Spectral_segmentation/internal/tree/Component_merging.h>
#include <CGAL/Spectral_segmentation/internal/tree/Constrained_merging.h>
#include <CGAL/Spectral_segmentation/internal/tree/Constraint_groups.h>
#include <CGAL/Spectral_segmentation/internal/tree/Forced_cuts.h>
#include <CGAL/Spectral_segmentation/internal/tree/congruent_cuts.h>
#include <CGAL/Spectral_segmentation/internal/tree/further_cuts.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/weights/searched_features.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A part of a model of several components that is searched by itself: a large component, at its own
// scale, or all small components together, at the scale of the model.
struct Searched_part
{
  Surface surface;
  std::vector<Index> callers_faces; // the caller's face for each face
  Constraints constraints;          // on the faces of the surface
  double fraction_of_model = 1;     // 1 unless it is searched at the scale of the model
};

// One run: the stages in their order, and the levels between them.
class Run
{
  const Options& options_;
  const Constraints& constraints_;
  const Feature_source& feature_source_;
  const Execution execution_;
  Run_monitor& monitor_;

  Surface mesh_;
  std::vector<Index> given_faces_;  // the caller's face for each given face; empty if the same
  double fraction_of_model_ = 1;
  double time_left_ = 1;            // the fraction of the run that is left after reading
  std::vector<Searched_part> parts_; // not empty if components are searched by themselves
  double unit_ = 1;                 // the length of 1 in the coordinates of the caller
  std::vector<Index> face_;         // the face of the mesh for each of the caller's faces
  Refined_mesh refined_;            // empty if the edges of the mesh are short enough
  std::vector<Coarse_surface> levels_; // each coarser than the one before; the last is searched
  Face_features features_;             // the features of the searched mesh
  std::vector<Index> searched_faces_;  // the caller's face for each of them; empty without features
  std::vector<double> searched_areas_;
  std::vector<Index> neighbors_;    // the caller's indices, if boundaries are to be smoothed
  Surface walls_;                   // the components that are walls of others
  std::vector<Index> outer_faces_;  // the caller's face on an outer wall nearest to each of theirs
  Constraint_groups groups_;        // empty without constraints
  std::vector<Index> leaf_of_group_; // one per group; empty without constraints

  Distance_weights distance_weights() const
  {
    return {options_.geodesic_weight, options_.concave_angle_weight, options_.convex_angle_weight,
            options_.concavity_radius};
  }

  // Removes duplicate faces, unless the mesh is connected or its components are kept separate.
  void remove_duplicates()
  {
    if (options_.keep_components_separate || mesh_.components.number == 1)
      return;
    const std::vector<Index> first = Duplicate_faces(mesh_)();
    Index number = 0;
    for (Index f = 0; f < first.size(); ++f)
      face_[f] = first[f] == f ? number++ : face_[first[f]];
    if (number == first.size())
      return;
    mesh_ = distinct_faces(mesh_, first);
    mesh_.components = connected_components(mesh_);
  }

  // Returns the order in which faces are kept; empty for the order of the caller. A mesh that is
  // only coarsened needs no order, because its coarse surface is put in one. Components that are
  // merged need one, because ties go to the first of equal components.
  std::vector<Index> order_of_faces()
  {
    if (is_searched_itself())
      return locality_order(mesh_);
    const bool are_merged = !options_.keep_components_separate && mesh_.components.number > 1;
    if (are_merged || options_.number_of_coarse_faces == 0)
      return geometric_order(mesh_);
    return {};
  }

  void order_faces()
  {
    const std::vector<Index> order = order_of_faces();
    monitor_.advance(0.3);
    if (order.empty() || !monitor_.go_further())
      return;
    reorder_faces(mesh_, order);
    renumber_faces(order);
  }

  // Updates the face of the mesh for each face of the caller after the mesh was reordered. Faces of
  // walls follow the faces of the mesh.
  void renumber_faces(const std::vector<Index>& order)
  {
    std::vector<Index> number(order.size());
    for (Index i = 0; i < order.size(); ++i)
      number[order[i]] = i;
    for (Index& f : face_)
      f = f < number.size() ? number[f] : f;
  }

  // Returns whether the method of the paper searches the mesh itself, so that its points must keep
  // all digits.
  bool is_searched_itself() const
  {
    const std::size_t n = mesh_.number_of_faces();
    return options_.method == Method::ZHANG_LIU_2005 &&
           faces_to_search(options_, n, n) == n;
  }

  // Returns whether the mesh is a convex solid, which has no parts. A mesh of many faces is not
  // checked: its coarse surface is searched as fast as any other.
  bool is_one_part() const
  {
    return options_.method == Method::CALIBRATED && !options_.number_of_segments &&
           constraints_.empty() && !has_features() && mesh_.components.number == 1 &&
           mesh_.number_of_faces() <= options_.number_of_coarse_faces && is_convex(mesh_);
  }

  void add_part(const std::vector<Index>& faces, const std::vector<Vector>& points,
                double fraction_of_model)
  {
    Searched_part part{submesh(mesh_, points, faces), composed(faces, callers_faces()), {},
                       fraction_of_model};
    if (!constraints_.empty()) {
      std::vector<Index> face_of_mesh(mesh_.number_of_faces() + walls_.number_of_faces(),
                                      null_index); // walls are not constrained
      for (Index i = 0; i < faces.size(); ++i)
        face_of_mesh[faces[i]] = i;
      part.constraints = constraints_within(constraints_, composed(face_, face_of_mesh));
    }
    parts_.push_back(std::move(part));
  }

  // Removes the components that are walls of others, unless they are constrained, or the rest has
  // fewer faces than segments are asked for.
  void remove_walls(const std::vector<double>& volumes, std::vector<Vector>& given_points)
  {
    std::vector<char> may_be_wall(mesh_.components.number, 1);
    const auto keep = [&](Index f) { may_be_wall[mesh_.components[face_[f]]] = 0; };
    for (const auto& pairs : {&constraints_.cannot_link, &constraints_.must_link})
      for (const auto& [f, g] : *pairs) {
        keep(f);
        keep(g);
      }
    for (const auto& constraint : constraints_.seeds)
      keep(constraint.first);
    Wall_finder finder(mesh_, volumes);
    const std::vector<Index> outer = finder(may_be_wall);
    const std::vector<Index> callers_face = callers_faces();
    std::vector<Index> kept, wall_faces;
    for (Index f = 0; f < mesh_.number_of_faces(); ++f)
      if (const Index o = outer[mesh_.components[f]]; o == null_index)
        kept.push_back(f);
      else {
        wall_faces.push_back(f);
        outer_faces_.push_back(callers_face[finder.nearest_face(o, f)]);
      }
    if (wall_faces.empty() || kept.size() < options_.number_of_segments.value_or(0)) {
      outer_faces_.clear();
      return;
    }
    walls_ = submesh(mesh_, mesh_.points, wall_faces);
    given_points = submesh(mesh_, given_points, kept).points;
    mesh_ = submesh(mesh_, mesh_.points, kept);
    set_areas(execution_, walls_);
    set_areas(execution_, mesh_);
    kept.insert(kept.end(), wall_faces.begin(), wall_faces.end());
    renumber_faces(kept);
  }

  // Divides the components of the mesh into parts that are searched by themselves, with the points
  // that the caller gave.
  void set_parts(const std::vector<Vector>& given_points)
  {
    constexpr double least_fraction_of_large_component = 0.1;
    const Component_fractions fractions = component_fractions(mesh_);
    std::vector<std::vector<Index> > faces(mesh_.components.number);
    for (Index f = 0; f < mesh_.number_of_faces(); ++f)
      faces[mesh_.components[f]].push_back(f);
    std::vector<Index> small;
    double fraction = 0; // the area of the small components
    for (Index c = 0; c < faces.size(); ++c)
      if (fractions.fraction[c] < least_fraction_of_large_component) {
        small.insert(small.end(), faces[c].begin(), faces[c].end());
        fraction += fractions.fraction[c];
      }
      else
        add_part(faces[c], given_points, 1);
    std::sort(small.begin(), small.end());
    if (!small.empty())
      add_part(small, given_points, fraction > 0 ? (std::min)(fraction, 1.) : 1);
  }

  // Moves the mesh into a frame of its own, unless it is searched itself, and orders its faces.
  void move_mesh_to_frame()
  {
    if (!is_searched_itself())
      unit_ *= move_to_frame(execution_, mesh_);
    if (mesh_.components.number > 1) // thousands may meet at one vertex, with all their leaves
      separate_vertices(mesh_, mesh_.components);
    if (monitor_.go_further())
      order_faces();
    monitor_.advance(0.3);
  }

  void number_faces()
  {
    face_.resize(mesh_.number_of_faces());
    std::iota(face_.begin(), face_.end(), Index(0));
  }

  void normalize_mesh()
  {
    unit_ = normalize(mesh_.points);
    set_areas(execution_, mesh_);
  }

  void group_constrained_faces()
  {
    if (!constraints_.empty())
      groups_ = Constraint_grouping(constraints_, face_, mesh_)(options_.keep_components_separate);
  }

  // Prepares the mesh. A run that is stopped meanwhile leaves the faces in the caller's order.
  void prepare_mesh()
  {
    number_faces();
    separate_groups(mesh_);
    mesh_.components = connected_components(mesh_);
    remove_duplicates();
    const bool are_merged = !options_.keep_components_separate && mesh_.components.number > 1;
    std::vector<Vector> given_points;
    if (are_merged)
      given_points = mesh_.points;
    normalize_mesh();
    if (are_merged)
      weld_borders(mesh_);
    const std::vector<double> volumes = orient_outward(mesh_);
    mesh_.groups.clear(); // they are components now
    if (are_merged) {
      remove_walls(volumes, given_points);
      set_parts(given_points);
    }
    const double old_unit = unit_;
    move_mesh_to_frame();
    for (double& area : walls_.areas)
      area *= old_unit / unit_ * (old_unit / unit_);
    check_number();
    group_constrained_faces();
    if (options_.smooth_boundaries)
      set_neighbors();
  }

  // Prepares a part of a model, which is oriented and has components already.
  void prepare_part()
  {
    number_faces();
    normalize_mesh();
    move_mesh_to_frame();
    group_constrained_faces();
  }

  // Returns values[i] for each index i.
  static std::vector<Index> composed(const std::vector<Index>& indices,
                                     const std::vector<Index>& values)
  {
    std::vector<Index> result;
    result.reserve(indices.size());
    for (Index i : indices)
      result.push_back(values[i]);
    return result;
  }

  // Returns a face of the caller for each face of the mesh, the first of duplicate faces.
  std::vector<Index> callers_faces() const
  {
    std::vector<Index> result; // the mesh may be moved to the search already
    for (Index f = static_cast<Index>(face_.size()); f-- > 0;) {
      if (face_[f] >= result.size())
        result.resize(face_[f] + 1);
      result[face_[f]] = given_faces_.empty() ? f : given_faces_[f];
    }
    return result;
  }

  // Sets the neighbors. A constrained face is its own neighbor, so that its label stays. The only
  // neighbor of a duplicate face is the first face with the same points.
  void set_neighbors()
  {
    const std::vector<Index> callers_face = callers_faces();
    neighbors_.resize(3 * face_.size());
    const Index n = static_cast<Index>(mesh_.number_of_faces());
    for (Index h = 0; h < neighbors_.size(); ++h) {
      const Index f = face_[h / 3];
      if (f >= n) { // this is a face of a wall
        neighbors_[h] = callers_face[n + walls_.neighbor(3 * (f - n) + h % 3)];
        continue;
      }
      const bool is_constrained = !constraints_.empty() && groups_.group[f] != null_index;
      const bool is_duplicate = callers_face[f] != h / 3;
      neighbors_[h] = is_constrained ? h / 3
        : callers_face[is_duplicate ? f : mesh_.neighbor(3 * f + h % 3)];
    }
  }

  void check_number() const
  {
    if (!options_.number_of_segments)
      return;
    const std::size_t number = *options_.number_of_segments;
    const std::size_t least = options_.keep_components_separate ? mesh_.components.number : 1;
    if (number < least || number > mesh_.number_of_faces())
      throw std::invalid_argument(
        "segment_spectral_recursive: number_of_segments is " + std::to_string(number) +
        ", but the mesh can have " + std::to_string(least) + " to " +
        std::to_string(mesh_.number_of_faces()) + " segments");
  }

  void set_weights(Surface& graph, const std::vector<Vector>& points) const
  {
    set_face_distances(execution_, graph, points, face_normals(execution_, graph, points),
                       distance_weights());
  }

  // Bisects the faces that are larger than the faces of an even mesh with the number of faces on
  // which cuts are searched, so that a cut can run anywhere.
  void refine()
  {
    if (!options_.bisection || !(total_area(mesh_) > 0))
      return;
    const double resolution = search_resolution(options_, mesh_.number_of_faces());
    const auto bound = bound_of_edges(execution_, mesh_, resolution, 16 * resolution);
    if (bound)
      refined_ = Longest_edge_bisection(mesh_, *bound)(execution_);
  }

  const Surface& finest() const
  { return refined_.faces.empty() ? mesh_ : refined_.graph; }

  // Returns whether the mesh is used after the search.
  bool is_mesh_needed() const
  {
    return options_.number_of_segments || !options_.keep_components_separate ||
           !constraints_.empty() || has_features();
  }

  bool has_features() const
  { return feature_source_.dimension > 0 && options_.feature_weight > 0; }

  // Returns the mesh on which cuts are searched.
  Surface coarse_mesh()
  {
    monitor_.check();
    std::vector<Vector> points = smoothed_points(mesh_, options_.number_of_smoothing_iterations,
                                                 [&] { monitor_.check(); return true; });
    if (options_.number_of_coarse_faces == 0 || is_searched_itself()) {
      Surface result = is_mesh_needed() ? mesh_ : std::move(mesh_);
      prepare_search(result, points);
      return result;
    }
    mesh_.points = std::move(points);
    refine();
    const std::size_t number = faces_to_search(options_, mesh_.number_of_faces(),
                                               finest().number_of_faces());
    levels_ = coarsened(execution_, finest(), number, monitor_);
    Surface result = levels_.back().graph;
    prepare_search(result, result.points);
    return result;
  }

  // Returns the caller's indices of the faces that are left in the coarsest mesh.
  std::vector<Index> searched_faces() const
  {
    std::vector<Index> result = callers_faces_of_finest();
    for (const Coarse_surface& level : levels_)
      result = composed(level.faces, result);
    return result;
  }

  // Returns the caller's indices of the faces of the finest mesh.
  std::vector<Index> callers_faces_of_finest() const
  {
    std::vector<Index> result = callers_faces();
    result.resize(mesh_.number_of_faces()); // the rest are walls
    return refined_.faces.empty() ? result : composed(refined_.faces, result);
  }

  // Sets the weights and the features of the mesh on which cuts are searched.
  void prepare_search(Surface& searched, const std::vector<Vector>& points)
  {
    set_weights(searched, points);
    if (!has_features())
      return;
    const std::vector<Index> faces = callers_faces_of_finest(),
                             vertices = searched_vertices(finest().points.size());
    features_ = searched_features(searched, Feature_means(feature_source_, finest(), faces,
                                                          vertices, searched.points.size())());
    if (features_.empty())
      return;
    // Faces have the means of their corners. Therefore neighbors differ by only a third of the
    // difference of their opposite corners.
    add_feature_steps(features_, 3, options_.feature_weight, searched);
    searched_faces_ = searched_faces();
    searched_areas_ = searched.areas;
    add_steps_of_faces(searched_faces_, searched);
  }

  // Adds the steps between the features of single faces, which locate cuts more exactly than means.
  void add_steps_of_faces(const std::vector<Index>& callers_face, Surface& graph) const
  {
    add_feature_steps(features_of_faces(feature_source_, features_.unit, callers_face), 1,
                      options_.feature_weight, graph);
  }

  // Returns the vertex of the coarsest mesh for each of the first n vertices of the finest, or
  // null_index.
  std::vector<Index> searched_vertices(std::size_t n) const
  {
    std::vector<Index> result(n);
    std::iota(result.begin(), result.end(), Index(0));
    for (const Coarse_surface& level : levels_)
      for (Index& v : result)
        v = v == null_index ? v : level.vertices[v];
    return result;
  }

  Merge_tree search(Surface mesh)
  {
    const Best_cut best_cut(mesh, options_, features_, fraction_of_model_);
    if (options_.method == Method::ZHANG_LIU_2005)
      return Recursion(execution_, std::move(mesh), best_cut, options_, monitor_).by_area();
    const std::vector<Index> regions =
      Recursion(execution_, mesh, best_cut, options_, monitor_).by_salience().leaf;
    return monitor_.stage(Stage::MERGING, Segmentation_visitor::whole_mesh, [&] {
      Region_merging merge(execution_, mesh, best_cut.context(), options_.part_salience, monitor_);
      Merge_tree result = merge(regions);
      average_saliences(mesh, result);
      if (!constraints_.empty()) {
        const std::vector<Index> vertices = searched_vertices(mesh_.points.size());
        Forced_cuts cuts(mesh_, vertices, mesh, groups_, result, monitor_);
        cuts();
        leaf_of_group_ = cuts.leaves_of_groups();
      }
      return result;
    });
  }

  bool is_reordered_only() const
  { return levels_.back().faces.size() == finest().number_of_faces(); }

  // Transfers the cuts of another surface to a mesh. In the end, constrained faces belong
  // entirely to the leaves of their groups.
  template <class For_each_fraction>
  Merge_tree transferred(const Merge_tree& tree, const Surface& mesh,
                         const For_each_fraction& for_each_fraction)
  {
    const auto add_steps = [&](const std::vector<Index>& faces, Surface& bands) {
      if (features_.empty())
        return;
      if (&mesh == &mesh_)
        add_steps_of_faces(composed(faces, callers_faces()), bands);
      else if (&mesh == &refined_.graph)
        add_steps_of_faces(composed(faces, callers_faces_of_finest()), bands);
    };
    if (leaf_of_group_.empty())
      return Cut_transfer(execution_, tree, mesh, for_each_fraction, distance_weights(), add_steps,
                          monitor_)();
    Cut_transfer transfer(execution_, tree, mesh, [&](Index f, const auto& add) {
      const Index group = &mesh == &mesh_ ? groups_.group[f] : null_index;
      if (group != null_index && leaf_of_group_[group] != null_index)
        add(leaf_of_group_[group], 1);
      else
        for_each_fraction(f, add);
    }, distance_weights(), add_steps, monitor_);
    const Merge_tree result = transfer();
    for (Index& leaf : leaf_of_group_)
      leaf = leaf == null_index ? leaf : transfer.leaf_of(leaf);
    return result;
  }

  // Projects the cuts of the coarse surface onto the mesh, level by level.
  Merge_tree project(Merge_tree tree)
  {
    if (is_reordered_only()) {
      std::vector<Index> leaf(tree.leaf.size());
      for (Index f = 0; f < leaf.size(); ++f)
        leaf[levels_.back().faces[f]] = tree.leaf[f];
      tree = transferred(tree, finest(), [&](Index f, const auto& add) { add(leaf[f], 1); });
      levels_.clear();
    }
    for (std::size_t i = levels_.size(); i-- > 0; levels_.pop_back()) {
      const Surface& mesh = i > 0 ? levels_[i - 1].graph : finest();
      const Leaf_fractions fractions = vertex_fractions(levels_[i].graph, tree.leaf);
      tree = transferred(tree, mesh, [&](Index f, const auto& add) {
        for (Index v : mesh.corners[f])
          for (const auto& [leaf, fraction] : fractions[levels_[i].vertices[v]])
            add(leaf, fraction);
      });
    }
    if (refined_.faces.empty())
      return tree;
    const Leaf_fractions fractions = face_fractions(refined_, tree.leaf);
    return transferred(tree, mesh_, [&](Index f, const auto& add) {
      for (const auto& [leaf, fraction] : fractions[f])
        add(leaf, fraction);
    });
  }

  // Changes the tree so that it satisfies the constraints.
  void satisfy_constraints(Merge_tree& tree)
  {
    const std::size_t number_of_roots = tree.number_of_roots();
    groups_ = Set_connection(mesh_, tree.leaf, tree.leaves.size(), groups_)(callers_faces());
    tree = Constrained_merging(mesh_, groups_, options_.minimum_segment_size, tree, monitor_)();
    const std::size_t number = tree.number_of_roots();
    if (number > number_of_roots && number > maximum_number(options_))
      throw std::invalid_argument(
        "segment_spectral_recursive: the constrained edges and seeds need " +
        std::to_string(number) + " segments, but " + std::to_string(maximum_number(options_)) +
        " are allowed");
  }

  // Returns the features of the components of the mesh, computed on a coarse mesh.
  Set_features features_of_components()
  {
    if (!has_features())
      return {};
    try {
      coarse_mesh();
    }
    catch (const Run_stopped&) {
      return {};
    }
    levels_.clear();
    refined_ = Refined_mesh();
    if (features_.empty())
      return {};
    std::vector<Index> component;
    for (Index f : searched_faces_)
      component.push_back(mesh_.components[face_[f]]);
    return Set_features(features_, searched_areas_, component, mesh_.components.number);
  }

  // Returns the options for a surface that is searched at the scale of a model, of whose area it
  // has a fraction.
  Options options_of_part(double fraction_of_model) const
  {
    Options result = options_;
    if (fraction_of_model == 1)
      return result;
    result.concavity_radius /= std::sqrt(fraction_of_model);
    if (result.number_of_coarse_faces > 0)
      result.number_of_coarse_faces = static_cast<std::size_t>(
        std::ceil(static_cast<double>(result.number_of_coarse_faces) * fraction_of_model));
    return result;
  }

  // Searches the parts one after the other, and merges the components.
  Merge_tree search_parts()
  {
    double time = 0;
    for (const Searched_part& part : parts_)
      time += Phase_times(options_, part.callers_faces.size()).time_after_reading();
    Merge_tree tree;
    tree.leaf.resize(mesh_.number_of_faces());
    for (Searched_part& part : parts_) {
      const Options options = options_of_part(part.fraction_of_model);
      const std::vector<Index> faces = composed(part.callers_faces, face_);
      Run run(options, part.constraints, feature_source_, execution_, monitor_);
      append(tree, run.cuts_of_part(std::move(part), time_left_ / (std::max)(time, 1.)), faces);
      part = Searched_part();
    }
    set_areas_of_leaves(tree, mesh_);
    const Component_fractions fractions = component_fractions(mesh_);
    return Component_merging(std::move(tree), mesh_, fractions, features_of_components(),
                             options_.feature_weight, monitor_)();
  }

  // Satisfies constraints, and makes as many cuts as were asked for.
  void apply_options(Merge_tree& tree)
  {
    if (!constraints_.empty())
      satisfy_constraints(tree);
    if (!options_.number_of_segments || monitor_.is_stopped())
      return;
    const std::size_t number = *options_.number_of_segments;
    std::vector<Index> sets;
    for (Index f = 0; f < groups_.group.size(); ++f)
      sets.push_back(groups_.set(f));
    Further_cuts(mesh_, tree, sets)(number);
    if (tree.leaves.size() < number)
      throw std::invalid_argument(
        "segment_spectral_recursive: number_of_segments is " + std::to_string(number) +
        ", but the edges that must not be cut and the seeds leave at most " +
        std::to_string(tree.leaves.size()) + " segments");
  }

  // Adds the walls to a tree. Their faces get the leaves of the nearest faces of their outer walls,
  // provided that the faces of a wall in each set stay connected.
  void add_walls(Merge_tree& tree) const
  {
    if (walls_.corners.empty())
      return;
    std::vector<Index> leaf = composed(composed(outer_faces_, face_), tree.leaf);
    Wall_labels(walls_, tree, leaf)();
    for (std::size_t i = 0; i < leaf.size(); ++i) {
      tree.leaf.push_back(leaf[i]);
      tree.leaves[leaf[i]].area += walls_.areas[i];
    }
  }

  // Replaces the indices of faces by the indices of the given faces.
  void number_given_faces(Merge_tree& tree) const
  { tree.leaf = composed(face_, tree.leaf); }

  // Searches the mesh once it is prepared. `time_scale` is the fraction of the run that a
  // nanosecond takes.
  template <class Prepare>
  Merge_tree cuts(const Prepare& prepare, const Phase_times& times, double time_scale)
  {
    Merge_tree result;
    try {
      std::optional<Surface> searched =
        monitor_.stage(Stage::INITIALIZATION, Segmentation_visitor::whole_mesh, [&] {
          prepare();
          if (!parts_.empty())
            return std::optional<Surface>();
          monitor_.start_phase(time_scale * times.coarsening);
          return is_one_part() ? std::nullopt : std::make_optional(coarse_mesh());
        });
      if (!parts_.empty())
        return search_parts();
      monitor_.start_phase(time_scale * times.search);
      if (searched)
        result = search(*std::move(searched));
      else { // the mesh is convex
        result = uncut_tree(mesh_, Cut_state::NO_CUT);
        result.is_monotonic = true;
      }
    }
    catch (const Run_stopped&) { // before there was a cut
      levels_.clear();
      refined_ = Refined_mesh();
      result = uncut_tree(mesh_, Cut_state::NOT_SEARCHED);
    }
    monitor_.start_phase(time_scale * times.projection);
    if (!levels_.empty() && &finest() == &mesh_ && is_reordered_only())
      return project(std::move(result)); // it only reorders faces, and is not reported as a stage
    if (!levels_.empty())
      return monitor_.stage(Stage::PROJECTION, Segmentation_visitor::whole_mesh,
                            [&] { return project(std::move(result)); });
    if (!leaf_of_group_.empty())
      return transferred(result, mesh_,
                         [&](Index f, const auto& add) { add(result.leaf[f], 1); });
    return result;
  }

  // Returns the cuts of a part of a model, whose faces keep their order.
  Merge_tree cuts_of_part(Searched_part part, double time_scale)
  {
    const Phase_times times(options_, part.surface.number_of_faces());
    mesh_ = std::move(part.surface);
    given_faces_ = std::move(part.callers_faces);
    fraction_of_model_ = part.fraction_of_model;
    Merge_tree result = cuts([this] { prepare_part(); }, times, time_scale);
    number_given_faces(result);
    return result;
  }

public:
  Run(const Options& options, const Constraints& constraints, const Feature_source& features,
      Execution execution, Run_monitor& monitor)
    : options_(options), constraints_(constraints), feature_source_(features),
      execution_(execution), monitor_(monitor)
  {
  }

  // Returns the hierarchy of a mesh. Its areas are in the unit of the caller, whose square may be
  // infinite even if an area is not.
  Cut_hierarchy operator()(Surface mesh)
  {
    const Phase_times times(options_, mesh.number_of_faces());
    const double time_scale = 1 / (std::max)(times.reading + times.time_after_reading(), 1.);
    mesh_ = std::move(mesh);
    time_left_ = 1 - time_scale * times.reading;
    monitor_.start_phase(time_scale * times.reading);
    Merge_tree tree = cuts([this] { prepare_mesh(); }, times, time_scale);
    apply_options(tree);
    add_walls(tree);
    number_given_faces(tree);
    Cut_hierarchy result = hierarchy_of(tree);
    for (Cut_node& node : result.nodes)
      node.area = node.area * unit_ * unit_;
    result.neighbors = std::move(neighbors_);
    monitor_.finish();
    return result;
  }
};

CGAL_SPECTRAL_SEGMENTATION_INLINE
Cut_hierarchy segment(Surface surface, const Options& options, Execution execution,
                      Run_control& control, const Constraints& constraints,
                      const Feature_source& features)
{
  if (!constraints.empty() && options.method == Method::ZHANG_LIU_2005)
    throw std::invalid_argument("segment_spectral_recursive: the method of the paper takes no "
                                "constraints: use the calibrated method with them");
  if (features.dimension > 0 && options.feature_weight > 0 &&
      options.method == Method::ZHANG_LIU_2005)
    throw std::invalid_argument("segment_spectral_recursive: the method of the paper takes no "
                                "features: use the calibrated method with them");
  Cut_hierarchy result;
  call_isolated([&] {
    Run_monitor monitor(control);
    result = Run(options, constraints, features, execution, monitor)(std::move(surface));
  });
  return result;
}

CGAL_SPECTRAL_SEGMENTATION_INLINE
void connect(Surface& soup)
{
  separate_groups(soup);
  connect_triangles(soup);
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ENGINE_IMPL_H
