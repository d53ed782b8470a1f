// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_AND_MERGE_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_AND_MERGE_H

#include <CGAL/Spectral_segmentation/Segment_tree.h>
#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/internal/Cut.h>
#include <CGAL/Spectral_segmentation/internal/Cut_judge.h>
#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/Monitor.h>
#include <CGAL/Spectral_segmentation/internal/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/cut_candidates.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// A cut whose factors were found out: of a part that is searched, or the boundary between two sets
// of pieces as the cut of their union.
struct Judged_cut
{
  enum Kind { CANDIDATE, BOUNDARY };

  Kind kind;
  const std::vector<Index>& faces; // of the part, by their numbers in the mesh
  const Sides& side;               // of each of these faces
  const Salience_factors& factors;
};

// Recursive two-way cuts, the most salient first, down to more pieces than anybody wants; then the
// two neighbors whose common boundary is the least salient become one, until each component of the
// mesh is whole again. A cut that was needed only to reach others is undone on the way, for nobody
// would cut between its two sides once the others are gone. The tree has the merges in reverse.
//
// `Observer` is called with each `Judged_cut`; from several threads if the run has several.
template <class ConcurrencyTag, class Monitor, class Observer = No_observer>
class Cut_and_merge
{
  struct Piece
  {
    Part part;
    std::optional<Cut> cut;
  };

  // Two sets of pieces become one.
  struct Merge
  {
    std::size_t into, from; // pieces that stand for their sets
    double salience;
    Salience_factors factors;
  };

  struct Boundary
  {
    double salience;
    Salience_factors factors;
  };

  typedef std::vector<std::vector<Index> > Face_sets; // each ascending
  typedef std::pair<std::size_t, std::size_t> Pair;   // of sets, the smaller number first
  typedef std::map<Pair, Boundary> Boundaries;

  const Face_dual_graph mesh_;
  const Options& options_;
  Monitor& monitor_;
  const Observer& observe_;
  const Judged_mesh judged_mesh_;

  std::vector<Index> component_;
  std::size_t number_of_components_;
  std::vector<Piece> pieces_;
  std::size_t number_of_parts_ = 0; // that were searched or wait for it, to name them

  void add_piece(Face_dual_graph graph, std::vector<Index> faces)
  {
    pieces_.push_back({Part{std::move(graph), number_of_parts_++, std::move(faces)}, std::nullopt});
  }

  void search(const std::vector<std::size_t>& pieces)
  {
    for_each_index<ConcurrencyTag>(pieces.size(), [&](std::size_t i) {
      Piece& p = pieces_[pieces[i]];
      p.cut = best_cut<ConcurrencyTag>(
        p.part, judged_mesh_, options_, monitor_, [&](const Cut& cut)
        { observe_(Judged_cut{Judged_cut::CANDIDATE, p.part.faces, cut.side, cut.factors}); });
    });
  }

  // The piece with the most salient cut, the first of several; none if there is no cut.
  std::optional<std::size_t> next_piece() const
  {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const std::optional<Cut>& cut = pieces_[i].cut;
      if (cut && (!best || on_grid(cut->salience) > on_grid(pieces_[*best].cut->salience)))
        best = i;
    }
    return best;
  }

  bool has_enough_pieces() const
  {
    const std::size_t maximum = options_.maximum_number_of_segments;
    return pieces_.size() - number_of_components_ + 1 >= options_.number_of_pieces &&
           (maximum == unlimited || pieces_.size() >= maximum);
  }

  void cut_down()
  {
    std::vector<std::size_t> news(pieces_.size());
    std::iota(news.begin(), news.end(), std::size_t(0));
    while (!has_enough_pieces()) {
      search(news);
      const std::optional<std::size_t> next = next_piece();
      if (!next)
        return;
      Piece whole = std::move(pieces_[*next]);
      std::vector<Index> faces[2];
      for (std::size_t i = 0; i < whole.part.faces.size(); ++i)
        faces[int(whole.cut->side[i])].push_back(whole.part.faces[i]);
      std::vector<Face_dual_graph> sides = split(std::move(whole.part.graph), whole.cut->side, 2);
      pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(*next));
      for (int s = 0; s < 2; ++s)
        add_piece(std::move(sides[s]), std::move(faces[s]));
      news = {pieces_.size() - 2, pieces_.size() - 1};
      monitor_.part_cut(whole.part.node, whole.cut->factors, whole.cut->salience, pieces_.size());
    }
  }

  // The faces of the pieces, in the order of their first faces. Their graphs have served.
  Face_sets take_faces_of_pieces()
  {
    Face_sets result;
    for (Piece& p : pieces_)
      result.push_back(std::move(p.part.faces));
    pieces_.clear();
    std::sort(result.begin(), result.end());
    return result;
  }

  // The boundary between two sets of faces as the cut of their union.
  Boundary boundary(const std::vector<Index>& first, const std::vector<Index>& second) const
  {
    std::vector<Index> faces;
    std::merge(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(faces));
    Sides side;
    double area[2] = {0, 0};
    for (Index f : faces) {
      side.push_back(std::binary_search(first.begin(), first.end(), f) ? 0 : 1);
      area[int(side.back())] += mesh_.areas[f];
    }
    put_smaller_side_first(side, area);
    const Face_dual_graph both = Part_copier(mesh_)(faces);
    const Salience_factors factors = Cut_judge(both, faces, judged_mesh_)(side);
    observe_(Judged_cut{Judged_cut::BOUNDARY, faces, side, factors});
    return {options_.part_salience(factors), factors};
  }

  // All neighbors, or those of one set.
  std::vector<Pair> neighbors(const std::vector<std::size_t>& set_of_face,
                              std::optional<std::size_t> of = std::nullopt) const
  {
    std::set<Pair> pairs;
    for (Index h = 0; h < mesh_.halfedges.size(); ++h) {
      const std::size_t a = set_of_face[h / 3], b = set_of_face[mesh_.halfedges[h].neighbor];
      if (a < b && (!of || a == *of || b == *of))
        pairs.insert({a, b});
    }
    return {pairs.begin(), pairs.end()};
  }

  void judge(const Face_sets& sets, const std::vector<Pair>& pairs, Boundaries& boundaries) const
  {
    std::vector<Boundary> judged(pairs.size());
    for_each_index<ConcurrencyTag>(pairs.size(), [&](std::size_t i)
      { judged[i] = boundary(sets[pairs[i].first], sets[pairs[i].second]); });
    for (std::size_t i = 0; i < pairs.size(); ++i)
      boundaries[pairs[i]] = judged[i];
  }

  std::vector<Merge> merge_up(Face_sets sets, std::vector<std::size_t> set_of_face) const
  {
    std::vector<Merge> merges;
    Boundaries boundaries;
    judge(sets, neighbors(set_of_face), boundaries);
    while (!boundaries.empty()) {
      const auto least = std::min_element(
        boundaries.begin(), boundaries.end(), [](const auto& a, const auto& b)
        { return on_grid(a.second.salience) < on_grid(b.second.salience); });
      const auto [into, from] = least->first;
      merges.push_back({into, from, least->second.salience, least->second.factors});
      for (auto b = boundaries.begin(); b != boundaries.end();)
        if (b->first.first == into || b->first.second == into || b->first.first == from ||
            b->first.second == from)
          b = boundaries.erase(b);
        else
          ++b;
      const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(sets[into].size());
      sets[into].insert(sets[into].end(), sets[from].begin(), sets[from].end());
      std::inplace_merge(sets[into].begin(), sets[into].begin() + size, sets[into].end());
      sets[from].clear();
      std::replace(set_of_face.begin(), set_of_face.end(), from, into);
      judge(sets, neighbors(set_of_face, into), boundaries);
    }
    return merges;
  }

  // A boundary that outlives another is at least as salient.
  static void make_monotone(std::vector<Merge>& merges)
  {
    double largest = -std::numeric_limits<double>::infinity();
    for (Merge& m : merges)
      largest = m.salience = (std::max)(m.salience, largest);
  }

  Segment_tree tree_of(const Face_sets& pieces, const std::vector<std::size_t>& piece_of_face,
                       const std::vector<Merge>& merges) const
  {
    Segment_tree tree(component_, component_areas(mesh_, component_, number_of_components_),
                      mesh_.unit, options_);
    tree.is_whole_ = true;

    // The sets of pieces on the two sides of each merge, and the node that a set becomes.
    std::vector<std::vector<std::size_t> > set(pieces.size());
    for (std::size_t i = 0; i < set.size(); ++i)
      set[i] = {i};
    std::vector<std::vector<std::size_t> > from(merges.size());
    for (std::size_t k = 0; k < merges.size(); ++k) {
      from[k] = set[merges[k].from];
      std::vector<std::size_t>& into = set[merges[k].into];
      into.insert(into.end(), from[k].begin(), from[k].end());
    }
    std::vector<std::size_t> node(pieces.size()); // that holds the piece
    for (std::size_t i = 0; i < node.size(); ++i)
      node[i] = component_[pieces[i].front()];
    for (std::size_t k = merges.size(); k-- > 0;) {
      const std::size_t cut_node = node[merges[k].into];
      std::vector<char> is_from(pieces.size(), 0);
      for (std::size_t piece : from[k])
        is_from[piece] = 1;
      Sides side;
      double area[2] = {0, 0};
      for (Index f : tree.faces(cut_node)) {
        side.push_back(is_from[piece_of_face[f]]); // 1 as in boundary(), should the areas be equal
        area[int(side.back())] += mesh_.areas[f];
      }
      const int side_of_from = area[0] <= area[1] ? 1 : 0;
      put_smaller_side_first(side, area);
      tree.set_cut(cut_node, Segment_tree::Cut_state::ACCEPTED, merges[k].salience,
                   merges[k].factors);
      tree.cut(cut_node, side, area);
      const Segment_tree::Node& n = tree.node(cut_node);
      for (std::size_t i = 0; i < node.size(); ++i)
        if (node[i] == cut_node)
          node[i] = n.children[is_from[i] ? side_of_from : 1 - side_of_from];
    }
    for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
      if (tree.node(i).is_leaf())
        tree.set_cut(i, Segment_tree::Cut_state::NO_CUT, 0, Salience_factors());
    return tree;
  }

public:
  Cut_and_merge(Face_dual_graph mesh, const Options& options, Monitor& monitor,
                const Observer& observe)
    : mesh_(std::move(mesh)), options_(options), monitor_(monitor), observe_(observe),
      judged_mesh_(judged_mesh(mesh_, options)),
      component_(connected_components(mesh_, number_of_components_))
  {
    std::vector<std::vector<Index> > faces(number_of_components_);
    for (Index f = 0; f < component_.size(); ++f)
      faces[component_[f]].push_back(f);
    std::vector<Face_dual_graph> graphs = split(mesh_, component_, number_of_components_);
    for (std::size_t i = 0; i < number_of_components_; ++i)
      add_piece(std::move(graphs[i]), std::move(faces[i]));
  }

  Segment_tree operator()()
  {
    try {
      cut_down();
    }
    catch (const Run_stopped&) {
      // The pieces are those of the cuts that were made.
    }
    const Face_sets pieces = take_faces_of_pieces();
    std::vector<std::size_t> piece_of_face(mesh_.number_of_faces());
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (Index f : pieces[i])
        piece_of_face[f] = i;
    std::vector<Merge> merges = monitor_.stage(Stage::MERGING, Segmentation_visitor::whole_mesh,
                                               [&] { return merge_up(pieces, piece_of_face); });
    make_monotone(merges);
    return tree_of(pieces, piece_of_face, merges);
  }
};

// The tree of a mesh; `observe` hears of each cut that is judged on the way.
template <class ConcurrencyTag, class Monitor, class Observer = No_observer>
Segment_tree cut_and_merge(Face_dual_graph mesh, const Options& options, Monitor& monitor,
                           const Observer& observe = Observer())
{
  return Cut_and_merge<ConcurrencyTag, Monitor, Observer>(std::move(mesh), options, monitor,
                                                          observe)();
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_AND_MERGE_H
