// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_WRAP_RESTRICTION_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_WRAP_RESTRICTION_H

#include <CGAL/Spectral_segmentation/internal/hierarchy/Nested_ranges.h>
#include <CGAL/Spectral_segmentation/internal/coarsening/Cut_transfer.h>
#include <CGAL/Spectral_segmentation/internal/grid/Grid_wrap.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Restricts the cuts of a wrap to the mesh that is wrapped. A face goes to the side that has most
// of it. A connected piece of a component on a side goes to the other side if it is small, compared
// with the side and with the piece of the component in the part. A boundary is expected where a
// component ends.
class Wrap_restriction : private Cut_transfer
{
  // The fraction of a face that is nearest to a leaf of the other hierarchy.
  struct Share
  {
    Index leaf; // its position in the order in which the leaves of each node follow each other
    double share;
  };

  const Surface& mesh_;
  const Grid_wrap& wrap_;
  const Nested_ranges leaves_;           // the leaves of each node
  std::vector<std::size_t> root_of_leaf_;
  std::vector<Share> shares_;            // the fractions of one face after the other
  std::vector<std::size_t> first_share_; // one per face, and the end
  std::vector<Index> reached_;           // the faces that the current flood reached
  std::vector<char> is_reached_;
  Sides side_;                           // one per face, by the current cut

  // Returns ranges with the leaves as elements, so that the leaves of each node follow each other.
  static Nested_ranges ranges_of_leaves(const Cut_hierarchy& cuts)
  {
    std::vector<Index> leaves;
    for (Index i = 0; i < cuts.nodes.size(); ++i)
      if (cuts.nodes[i].is_leaf())
        leaves.push_back(i);
    return Nested_ranges(cuts, leaves);
  }

  void set_shares()
  {
    std::vector<Index> leaf_of_vertex(wrap_.surface().points.size());
    for (Index f = 0; f < cuts_.leaf.size(); ++f)
      for (Index v : wrap_.surface().corners[f])
        leaf_of_vertex[v] = static_cast<Index>(leaves_.first(cuts_.leaf[f]));
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

  // Returns the component of the wrap that has the largest fraction of a face.
  std::size_t root_of_wrap(Index f) const
  {
    const auto begin = shares_.begin();
    const auto largest = std::max_element(
      begin + static_cast<std::ptrdiff_t>(first_share_[f]),
      begin + static_cast<std::ptrdiff_t>(first_share_[f + 1]),
      [](const Share& a, const Share& b) { return a.share < b.share; });
    return root_of_leaf_[largest->leaf];
  }

  double share_in(std::size_t node, Index f) const
  {
    const std::size_t first = leaves_.first(node);
    const std::size_t end = first + leaves_.size(node);
    double result = 0;
    for (std::size_t i = first_share_[f]; i < first_share_[f + 1]; ++i)
      if (shares_[i].leaf >= first && shares_[i].leaf < end)
        result += shares_[i].share;
    return result;
  }

  double area(Index f) const override { return mesh_.areas[f]; }

  // Adds the faces of a part that are connected with a face, and for which f(face) is true, to the
  // faces that were reached; returns their area.
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
        const Index g = mesh_.neighbor(h);
        if (!is_reached_[g] && side_[g] != OUTSIDE && f(g)) {
          is_reached_[g] = 1;
          reached_.push_back(g);
        }
      }
    }
    return area;
  }

  // A piece of a component on a side is small if it is less than this fraction of the component
  // within the part, and of its side.
  static constexpr double share_of_small_piece = 0.3;

  // Returns the small pieces of the component of a face, one after the other.
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
      result.push_back(std::exchange(side_[f], char(OUTSIDE)));
    return result;
  }

public:
  Wrap_restriction(const Cut_hierarchy& cuts, const Grid_wrap& wrap, const Surface& mesh,
                   Run_monitor& monitor)
    : Cut_transfer(cuts, monitor), mesh_(mesh), wrap_(wrap),
      leaves_(ranges_of_leaves(cuts)), is_reached_(mesh.number_of_faces(), 0),
      side_(mesh.number_of_faces(), OUTSIDE)
  {}

  Cut_hierarchy operator()()
  {
    for (std::size_t root = 0; root < cuts_.number_of_roots; ++root)
      root_of_leaf_.insert(root_of_leaf_.end(), leaves_.size(root), root);
    set_shares();
    // The roots are the roots of the wrap that have a face.
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

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_COARSENING_WRAP_RESTRICTION_H
