// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_WRAP_RESTRICTION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_WRAP_RESTRICTION_H

#include <CGAL/Spectral_segmentation/internal/mesh/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/multilevel/Cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/multilevel/Grid_wrap.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Restricts the cuts of a wrap to the mesh that is wrapped. A face goes to the side that has most
// of it. A connected piece of a component on a side goes to the other side if it is small, against
// the side and against what the part has of the component: where a component ends is where
// a boundary is expected.
class Wrap_restriction : private Cut_transfer
{
  // Of a face: what is nearest to a leaf of the other hierarchy.
  struct Share
  {
    Index leaf; // its position in the order in which the leaves of each node follow each other
    double share;
  };

  const Face_graph& mesh_;
  const Grid_wrap& wrap_;
  std::vector<std::size_t> first_leaf_, end_of_leaves_; // positions, of each node
  std::vector<Share> shares_;                           // of the faces, one after the other
  std::vector<std::size_t> first_share_;                // of each face, and the end
  std::vector<Index> reached_; // by the present flood
  std::vector<char> is_reached_;
  std::vector<char> side_;                              // of each face, by the cut at hand

  void set_leaves()
  {
    const std::size_t n = cuts_.nodes.size();
    std::vector<std::size_t> size(n, 0);
    for (std::size_t i = n; i-- > 0;) {
      if (cuts_.nodes[i].is_leaf())
        size[i] = 1;
      if (cuts_.nodes[i].parent != null_node)
        size[cuts_.nodes[i].parent] += size[i];
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t parent = cuts_.nodes[i].parent;
      if (parent == null_node)
        first_leaf_.push_back(std::exchange(next, next + size[i]));
      else if (i == cuts_.nodes[parent].children[0])
        first_leaf_.push_back(first_leaf_[parent]);
      else
        first_leaf_.push_back(first_leaf_[parent] + size[cuts_.nodes[parent].children[0]]);
      end_of_leaves_.push_back(first_leaf_[i] + size[i]);
    }
  }

  void set_shares()
  {
    std::vector<Index> leaf_of_vertex(wrap_.surface().points.size());
    for (Index f = 0; f < cuts_.leaf.size(); ++f)
      for (Index v : wrap_.surface().corners[f])
        leaf_of_vertex[v] = static_cast<Index>(first_leaf_[cuts_.leaf[f]]);
    first_share_.assign(1, 0);
    wrap_.for_each_piece_and_vertex([&](Index f, double share, Index vertex) {
      while (first_share_.size() <= f)
        first_share_.push_back(shares_.size());
      const Index leaf = leaf_of_vertex[vertex];
      const auto begin = shares_.begin() + static_cast<std::ptrdiff_t>(first_share_[f]);
      const auto found = std::find_if(begin, shares_.end(),
                                      [&](const Share& s) { return s.leaf == leaf; });
      if (found != shares_.end())
        found->share += share;
      else
        shares_.push_back({leaf, share});
    });
    first_share_.push_back(shares_.size());
  }

  // The component of the wrap that has the largest share of a face.
  std::size_t root_of_wrap(Index f) const
  {
    const auto begin = shares_.begin();
    const auto largest = std::max_element(
      begin + static_cast<std::ptrdiff_t>(first_share_[f]),
      begin + static_cast<std::ptrdiff_t>(first_share_[f + 1]),
      [](const Share& a, const Share& b) { return a.share < b.share; });
    const auto roots = first_leaf_.begin();
    return std::upper_bound(roots, roots + static_cast<std::ptrdiff_t>(cuts_.number_of_roots),
                            largest->leaf) - roots - 1;
  }

  double share_in(std::size_t node, Index f) const
  {
    double result = 0;
    for (std::size_t i = first_share_[f]; i < first_share_[f + 1]; ++i)
      if (shares_[i].leaf >= first_leaf_[node] && shares_[i].leaf < end_of_leaves_[node])
        result += shares_[i].share;
    return result;
  }

  double area(Index f) const override { return mesh_.areas[f]; }

  // Adds the faces of a part that are connected with one, and for which f(face) is true, to those
  // that were reached; returns their area.
  template <class Function>
  double flood(Index first, const Function& f)
  {
    std::size_t next = reached_.size();
    reached_.push_back(first);
    is_reached_[first] = 1;
    double area = 0;
    for (; next < reached_.size(); ++next) {
      area += mesh_.areas[reached_[next]];
      for (Index h = 3 * reached_[next]; h < 3 * reached_[next] + 3; ++h) {
        const Index g = mesh_.neighbors[h];
        if (!is_reached_[g] && side_[g] != OUTSIDE && f(g)) {
          is_reached_[g] = 1;
          reached_.push_back(g);
        }
      }
    }
    return area;
  }

  // The pieces of a component on both sides are small if they are less than this share of what the
  // part has of the component, and of their side.
  static constexpr double share_of_small_piece = 0.3;

  // The small pieces of the component of a face, one after the other.
  std::vector<Index> small_pieces(Index first, const double (&area_of_side)[2])
  {
    reached_.clear();
    const double area = flood(first, [](Index) { return true; });
    const std::vector<Index> component = reached_;
    for (Index f : component)
      is_reached_[f] = 0;
    reached_.clear();
    std::vector<Index> result;
    for (Index seed : component) {
      if (is_reached_[seed])
        continue;
      const std::size_t begin = reached_.size();
      const double of_piece = flood(seed, [&](Index f) { return side_[f] == side_[seed]; });
      if (of_piece < share_of_small_piece * area &&
          of_piece < share_of_small_piece * area_of_side[int(side_[seed])])
        result.insert(result.end(), reached_.begin() + static_cast<std::ptrdiff_t>(begin),
                      reached_.end());
    }
    return result;
  }

  void move_small_pieces(const Elements& faces)
  {
    double area_of_side[2] = {0, 0};
    for (Index f : faces)
      area_of_side[int(side_[f])] += mesh_.areas[f];
    for (Index first : faces)
      if (!is_reached_[first])
        for (Index f : small_pieces(first, area_of_side))
          side_[f] = side_[f] == Q ? REST : Q;
    for (Index f : faces)
      is_reached_[f] = 0;
  }

  Sides sides(std::size_t node, const Elements& faces) override
  {
    const auto& children = cuts_.nodes[node].children;
    for (Index f : faces)
      side_[f] = share_in(children[1], f) > share_in(children[0], f) ? REST : Q;
    move_small_pieces(faces);
    Sides result;
    for (Index f : faces)
      result.push_back(side_[f]);
    for (Index f : faces)
      side_[f] = OUTSIDE;
    return result;
  }

public:
  Wrap_restriction(const Cut_hierarchy& cuts, const Grid_wrap& wrap, const Face_graph& mesh,
                   Run_monitor& monitor)
    : Cut_transfer(cuts, monitor), mesh_(mesh), wrap_(wrap),
      is_reached_(mesh.number_of_faces(), 0), side_(mesh.number_of_faces(), OUTSIDE)
  {}

  Cut_hierarchy operator()()
  {
    set_leaves();
    set_shares();
    // The roots are those of the wrap that have a face.
    std::vector<Index> root_of_face;
    std::vector<std::size_t> root_of(cuts_.number_of_roots, null_node);
    std::vector<double> areas;
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      std::size_t& root = root_of[root_of_wrap(f)];
      if (root == null_node) {
        root = areas.size();
        areas.push_back(0);
      }
      root_of_face.push_back(static_cast<Index>(root));
      areas[root] += mesh_.areas[f];
    }
    return transfer(uncut_hierarchy(std::move(root_of_face), areas), std::move(root_of));
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_WRAP_RESTRICTION_H
