// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TREE_FORCED_CUTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TREE_FORCED_CUTS_H

#include <CGAL/Spectral_segmentation/internal/base/Run_monitor.h>
#include <CGAL/Spectral_segmentation/internal/search/cut_proposals.h>
#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/tree/Constraint_groups.h>
#include <CGAL/Spectral_segmentation/internal/tree/further_cuts.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Cuts leaves of the search surface that violate the constraints of the mesh. Such a cut is the
// cheapest along the spectral order from one side of a forced boundary to the other, or from the
// faces of one seed to the faces of another. This order extends an open boundary around a limb.
//
// A side consists of the faces along one side of a boundary, around all its vertices except the
// ends. Sides and seeds are classes. Each coarse face gets the class of most constraints near it.
class Forced_cuts
{
  const Surface& mesh_;
  const std::vector<Index>& vertex_; // the vertex of the search surface for each vertex of the mesh
  const Surface& coarse_;
  const Constraint_groups& groups_;
  Run_monitor& monitor_;
  Merge_tree& tree_; // the cuts of the search surface
  Leaf_cutter cutter_;

  std::vector<Index> seams_;       // the halfedges at forced boundaries
  std::vector<std::vector<Index> > halfedges_from_; // one list per coarse vertex
  Separated_sets classes_;         // the sides first, one per halfedge in seams_
  std::map<Index, Index> class_of_seed_;
  std::vector<Index> label_;       // the class of each coarse face, or null_index

  const std::vector<Index>& halfedges_from(Index vertex) const
  {
    static const std::vector<Index> none;
    return vertex == null_index ? none : halfedges_from_[vertex]; // null: left from no face
  }

  Index class_of_side(Index h) const
  {
    return classes_.representative(static_cast<Index>(
      std::lower_bound(seams_.begin(), seams_.end(), h) - seams_.begin()));
  }

  void set_classes()
  {
    for (Index f : groups_.faces)
      if (const Index seed = groups_.sets.seed(groups_.group[f]); seed != null_index)
        class_of_seed_.emplace(seed, static_cast<Index>(seams_.size() + class_of_seed_.size()));
    classes_ = Separated_sets(seams_.size() + class_of_seed_.size());
    for (Index h : seams_) { // the next halfedge of the side, unless the boundary ends
      Index next = Surface::next(h);
      while (!groups_.is_seam[next] && !mesh_.is_border(next))
        next = Surface::next(mesh_.opposite[next]);
      if (groups_.is_seam[next] && next != mesh_.opposite[h])
        classes_.merge(class_of_side(h), class_of_side(next));
    }
    for (Index h : seams_)
      if (class_of_side(h) != class_of_side(mesh_.opposite[h]))
        classes_.separate(class_of_side(h), class_of_side(mesh_.opposite[h]));
    for (const auto& [seed, number] : class_of_seed_)
      classes_.set_seed(number, seed);
  }

  // Returns the halfedge of the search surface from the same vertex in about the same direction, or
  // null_index.
  Index coarse_halfedge(Index h) const
  {
    const Index v = vertex_[mesh_.source_vertex(h)], w = vertex_[mesh_.target_vertex(h)];
    const Vector along =
      mesh_.points[mesh_.target_vertex(h)] - mesh_.points[mesh_.source_vertex(h)];
    Index result = null_index;
    double best = 0;
    for (Index k : halfedges_from(v)) {
      if (coarse_.target_vertex(k) == w)
        return k;
      const Vector step = coarse_.points[coarse_.target_vertex(k)] - coarse_.points[v];
      const double score = quantized(along.dot(step) / (along.norm() * step.norm()));
      if (score > best) {
        best = score;
        result = k;
      }
    }
    return result;
  }

  // Returns the coarse face with the most corners of a face, or null_index.
  Index coarse_face(Index f) const
  {
    const Corners& c = mesh_.corners[f];
    std::pair<int, Index> best(0, null_index);
    for (Index v : c)
      for (Index k : halfedges_from(vertex_[v])) {
        const Corners& d = coarse_.corners[k / 3];
        const auto is_corner = [&](Index w)
        { return int(std::find(d.begin(), d.end(), vertex_[w]) != d.end()); };
        const int number = is_corner(c[0]) + is_corner(c[1]) + is_corner(c[2]);
        if (number > best.first || (number == best.first && k / 3 < best.second))
          best = {number, k / 3};
      }
    return best.second;
  }

  // The number of votes for each pair of an element and a value.
  typedef std::map<std::pair<Index, Index>, std::size_t> Votes;

  // Returns the value with the most votes for each of n elements; null_index without votes.
  static std::vector<Index> most_votes(const Votes& votes, std::size_t n)
  {
    std::vector<Index> result(n, null_index);
    std::vector<std::size_t> most(n, 0);
    for (const auto& [vote, number] : votes)
      if (number > most[vote.first]) {
        most[vote.first] = number;
        result[vote.first] = vote.second;
      }
    return result;
  }

  void set_labels()
  {
    Votes votes; // pairs of a coarse face and a class
    for (Index h : seams_)
      if (const Index k = coarse_halfedge(h); k != null_index) {
        ++votes[{k / 3, class_of_side(h)}];
        if (!coarse_.is_border(k))
          ++votes[{coarse_.neighbor(k), class_of_side(mesh_.opposite[h])}];
      }
    for (Index f : groups_.faces)
      if (const Index seed = groups_.sets.seed(groups_.group[f]); seed != null_index)
        if (const Index g = coarse_face(f); g != null_index)
          ++votes[{g, class_of_seed_.at(seed)}];
    label_ = most_votes(votes, coarse_.number_of_faces());
  }

  // Returns two separated classes of faces of a leaf; null_index twice if there are none.
  std::pair<Index, Index> find_conflict(const std::vector<Index>& faces) const
  {
    std::vector<Index> classes;
    for (Index f : faces)
      if (label_[f] != null_index)
        classes.push_back(label_[f]);
    std::sort(classes.begin(), classes.end());
    classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
    for (Index a : classes)
      for (Index b : classes)
        if (a < b && classes_.are_separated(a, b))
          return {a, b};
    return {null_index, null_index};
  }

  // Returns the order of the faces of a part from one class to the other. No path crosses an edge
  // between the two.
  Face_order order(const Surface& part, const std::vector<Index>& label, Index a, Index b) const
  {
    const auto distances = [&](Index source) {
      std::vector<double> result(label.size(), infinite_distance);
      std::vector<Index> sources;
      for (Index f = 0; f < label.size(); ++f)
        if (label[f] == source) {
          result[f] = 0;
          sources.push_back(f);
        }
      run_dijkstra(part, sources, [&](Index h) -> double {
        const Index from = label[h / 3], to = label[part.neighbor(h)];
        const bool is_between = (from == a && to == b) || (from == b && to == a);
        return is_between ? infinite_distance : part.weights[h].combined;
      }, result, boost::dijkstra_visitor<>());
      for (double& d : result)
        d = (std::min)(d, 1e9); // out of reach
      return result;
    };
    Face_order result = spectral_order(Execution::SEQUENTIAL, distances(a), distances(b));
    std::stable_partition(result.begin(), result.end(), [&](Index f) { return label[f] == a; });
    std::stable_partition(result.begin(), result.end(), [&](Index f) { return label[f] != b; });
    return result;
  }

  // Returns the cheapest cut along an order among the cuts that leave the fewest faces of the two
  // classes on the wrong side.
  std::optional<Sides> cheapest_cut(const Surface& part, const std::vector<Index>& label, Index a,
                                    Index b) const
  {
    const Growth growth = grow_along(part, order(part, label, a, b));
    if (growth.faces.size() < label.size())
      return std::nullopt; // the part is not connected
    const std::size_t all_of_a = std::count(label.begin(), label.end(), a),
                      all_of_b = std::count(label.begin(), label.end(), b);
    std::vector<std::size_t> count_a(1, 0), count_b(1, 0); // both among the first faces
    for (Index f : growth.faces) {
      count_a.push_back(count_a.back() + (label[f] == a));
      count_b.push_back(count_b.back() + (label[f] == b));
    }
    std::vector<double> capacities(part.number_of_halfedges());
    for (Index h = 0; h < part.number_of_halfedges(); ++h)
      capacities[h] = capacity(part, h);
    std::pair<std::size_t, double> best((std::numeric_limits<std::size_t>::max)(), 0);
    Index size_of_best = 0;
    for_each_cut(growth.faces, sizes_of_cuts(part, growth), 0,
                 Patch_with_capacity(part, capacities), [&](const auto& q, Index size) {
      const std::pair<std::size_t, double> cost(
        all_of_a - count_a[size] + count_b[size],
        quantized(q.capacity_of_cut() / std::sqrt(q.smaller_area())));
      if (count_a[size] > 0 && count_b[size] < all_of_b && cost < best) {
        best = cost;
        size_of_best = size;
      }
      return true;
    });
    if (size_of_best == 0)
      return std::nullopt;
    return sides_of(growth, size_of_best);
  }

  // Separates two classes in a leaf. Faces on the wrong side lose their class. Returns the new
  // leaf; null_index if there is no cut.
  Index cut(Index leaf, Index a, Index b)
  {
    const std::vector<Index>& faces = cutter_.faces(leaf);
    std::vector<Index> label;
    for (Index f : faces)
      label.push_back(label_[f]);
    const Surface part = Part_extractor(coarse_)(faces);
    std::optional<Sides> side = cheapest_cut(part, label, a, b);
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (label[i] == (!side || (*side)[i] == 0 ? b : a))
        label_[faces[i]] = null_index;
    return side ? cutter_.cut(leaf, *std::move(side)) : null_index;
  }

public:
  // Takes the mesh and the search surface, which has weights, and the cuts of the latter.
  Forced_cuts(const Surface& mesh, const std::vector<Index>& vertex, const Surface& coarse,
              const Constraint_groups& groups, Merge_tree& tree, Run_monitor& monitor)
    : mesh_(mesh), vertex_(vertex), coarse_(coarse), groups_(groups), monitor_(monitor),
      tree_(tree), cutter_(coarse, tree), halfedges_from_(coarse.points.size())
  {
    for (Index h = 0; h < coarse.number_of_halfedges(); ++h)
      halfedges_from_[coarse.source_vertex(h)].push_back(h);
    for (Index h = 0; h < groups.is_seam.size(); ++h)
      if (groups.is_seam[h])
        seams_.push_back(h);
    set_classes();
    set_labels();
  }

  void operator()()
  {
    std::vector<Index> leaves = first_indices(tree_.leaves.size());
    for (std::size_t i = 0; i < leaves.size(); ++i) // there will be more
      for (;;) {
        const auto [a, b] = find_conflict(cutter_.faces(leaves[i]));
        if (a == null_index)
          break;
        monitor_.go_further(); // may throw
        if (const Index other = cut(leaves[i], a, b); other != null_index) {
          leaves.insert(leaves.end(), {other, leaves[i]});
          break;
        }
      }
    cutter_.finish();
  }

  // Returns the leaf to which most faces of each group belong. A single face that is at no forced
  // boundary can stay where the cuts leave it; its group gets null_index.
  std::vector<Index> leaves_of_groups() const
  {
    std::vector<Index> size(groups_.sets.number(), 0);
    for (Index f : groups_.faces)
      ++size[groups_.group[f]];
    for (Index h : seams_)
      ++size[groups_.group[h / 3]];
    Votes votes; // pairs of a group and a leaf
    for (Index f : groups_.faces) {
      if (size[groups_.group[f]] == 1)
        continue;
      Index g = coarse_face(f);
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (groups_.is_seam[h])
          if (const Index k = coarse_halfedge(h);
              k != null_index && label_[k / 3] == class_of_side(h))
            g = k / 3;
      for (Index i = 0; g == null_index; ++i) // no coarse face is near
        g = coarse_.components[i] == mesh_.components[f] ? i : g;
      ++votes[{groups_.group[f], tree_.leaf[g]}];
    }
    return most_votes(votes, size.size());
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TREE_FORCED_CUTS_H
