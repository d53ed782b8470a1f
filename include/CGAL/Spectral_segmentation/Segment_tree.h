// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_SEGMENT_TREE_H
#define CGAL_SPECTRAL_SEGMENTATION_SEGMENT_TREE_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/Triangles.h>
#include <CGAL/Spectral_segmentation/internal/boundary_smoothing.h>
#include <CGAL/Spectral_segmentation/internal/mesh_numbering.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {

/// \cond SKIP_IN_MANUAL
class Segment_tree;
namespace internal {
template <class ConcurrencyTag, class Monitor>
class Recursion;
template <class ConcurrencyTag, class Monitor, class Observer>
class Cut_and_merge;
class Cut_transfer;
inline void number_faces(Segment_tree&, const std::vector<Index>&, const std::vector<Neighbors>&);
}
/// \endcond

/// \ingroup PkgSpectralSegmentationRef
/// The cuts that a run of `segment_spectral_recursive()` made, as a forest of binary trees.
///
/// The roots are the connected components of the mesh, the children of a node its two parts.
/// From a tree the labels for fewer segments, or for a higher threshold, are read off without
/// searching again; they are the labels that a run with these values would give.
///
/// Where a run merged pieces (`number_of_pieces`), the cuts are its merges in reverse, and the tree
/// is whole: it has them all, whatever the threshold and the maximum number of segments of the run.
/// The labels are those of a run with the same number of pieces, that is, for maximum numbers of
/// segments that do not ask for more.
///
/// Faces are named by their number: their position in `faces(mesh)`, or the value of the
/// `face_index_map` if the run was given one.
class Segment_tree
{
public:
  /// an unsigned integer, for nodes, faces, and numbers of them
  typedef std::size_t size_type;

#ifdef DOXYGEN_RUNNING
  /// a range of unsigned integers
  typedef unspecified_type Face_range;
#else
  typedef Iterator_range<std::vector<internal::Index>::const_iterator> Face_range;
#endif

  /// the index that stands for no node
  static constexpr size_type null_node = static_cast<size_type>(-1);

  /// What became of the search for the best cut of a node.
  enum class Cut_state
  {
    NOT_SEARCHED, ///< the run ended before it came to this part
    NO_CUT,       ///< there is no cut with two connected sides of minimum size, or it is a piece
    REJECTED,     ///< the best cut is less salient than the threshold; not if there are pieces
    ACCEPTED      ///< the part has two children; if there are pieces, whatever the threshold
  };

  /// A set of faces: a connected component of the mesh, or one side of the cut of its parent.
  struct Node
  {
    /// the node that was cut; `null_node` for a root
    size_type parent = null_node;

    /// The part that the salience judges, which is the one of smaller area, then the rest;
    /// `null_node` twice for a leaf.
    size_type children[2] = {null_node, null_node};

    size_type number_of_faces = 0; ///< of the set; at least 1

    /// in the square of the unit of the mesh's coordinates
    double area = 0;

    Cut_state cut_state = Cut_state::NOT_SEARCHED; ///< what became of the search for its cut

    /// the salience of the best cut; 0 if there is none or it was not searched.
    /// In a whole tree no cut is less salient than those that follow: its salience is raised to
    /// theirs, while its factors are its own.
    double salience = 0;

    /// the factors of that cut, on the mesh on which it was searched (`number_of_searched_faces`)
    Salience_factors factors;

    /// whether it has no children
    bool is_leaf() const { return children[0] == null_node; }
  };

  /// \name Nodes
  /// @{

  /// the number of faces of the mesh; 0 before a run
  size_type number_of_faces() const { return faces_.size(); }

  /// the number of nodes, leaves too
  size_type number_of_nodes() const { return nodes_.size(); }

  /// Connected components of the mesh: the nodes from 0 to `number_of_roots() - 1`.
  /// The children of the i-th cut that was made follow at `number_of_roots() + 2 * i`.
  size_type number_of_roots() const { return number_of_roots_; }

  /// number of leaves, which are the pieces if the run has pieces
  size_type number_of_segments() const
  { return number_of_roots_ + (nodes_.size() - number_of_roots_) / 2; }

  /// the node of index `i`, which is below `number_of_nodes()`; this is not checked
  const Node& node(size_type i) const { return nodes_[i]; }

  /// the salience threshold of the run: no lower one can be asked for, except of a whole tree
  double salience_threshold() const { return salience_threshold_; }

  /// the numbers of the faces of node `i`; those of a leaf ascend
  Face_range faces(size_type i) const
  {
    const auto first = faces_.begin() + first_face_[i];
    return make_range(first, first + nodes_[i].number_of_faces);
  }

  /// @}

  /// \name Labels
  /// A label is a number from 0 to the number of segments - 1. Segments are numbered by their
  /// face of smallest number. All functions are linear in the number of faces, with a term
  /// O(c log c) for c cuts.
  ///
  /// They throw `std::out_of_range` if the run did not go so far: it ended, at its maximum number
  /// of segments or stopped by its visitor, before a cut that is needed here, or had a higher
  /// threshold.
  /// @{

  /// the labels that the run gave
  std::vector<size_type> labels() const
  {
    return labels((std::min)(number_of_segments(), maximum_number_of_segments_),
                  salience_threshold_);
  }

  /// the label of each face, by its number, for at most `maximum_number_of_segments` segments
  /// (never fewer than the mesh has connected components) and cuts of at least `salience_threshold`
  std::vector<size_type> labels(size_type maximum_number_of_segments,
                                double salience_threshold) const
  {
    if (std::isnan(salience_threshold))
      throw std::invalid_argument("Segment_tree: the salience threshold is not a number");
    std::vector<size_type> result(faces_.size());
    const std::vector<size_type> parts = prune(maximum_number_of_segments, salience_threshold);
    for (size_type label = 0; label < parts.size(); ++label)
      for (internal::Index f : faces(parts[label]))
        result[f] = label;
    if (!neighbors_.empty()) {
      internal::smooth_boundaries(neighbors_, result);
      number_by_first_face(result, parts.size());
    }
    return result;
  }

  /// writes the labels for at most `n` segments at the threshold of the run into a property map,
  /// and returns the number of segments; `np` must have the `face_index_map` of the run if that had
  /// one, and may have no other parameter
  template <class TriangleMesh, class SegmentIdMap,
            class NamedParameters = CGAL::parameters::Default_named_parameters>
  size_type segment_by_number(const TriangleMesh& mesh, SegmentIdMap segment_ids, size_type n,
                              const NamedParameters& np = NamedParameters()) const
  { return write(mesh, segment_ids, labels(n, salience_threshold_), np); }

  /// writes the labels for cuts of at least `salience_threshold`, up to the maximum number of
  /// segments of the run, into a property map, and returns the number of segments; `np` is as above
  template <class TriangleMesh, class SegmentIdMap,
            class NamedParameters = CGAL::parameters::Default_named_parameters>
  size_type segment_by_threshold(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                                 double salience_threshold,
                                 const NamedParameters& np = NamedParameters()) const
  { return write(mesh, segment_ids, labels(maximum_number_of_segments_, salience_threshold), np); }

  /// @}

  /// a tree without nodes, to be given to a run
  Segment_tree() = default;

private:
  template <class ConcurrencyTag, class Monitor>
  friend class internal::Recursion;
  template <class ConcurrencyTag, class Monitor, class Observer>
  friend class internal::Cut_and_merge;
  friend class internal::Cut_transfer;
  friend void internal::number_faces(Segment_tree&, const std::vector<internal::Index>&,
                                     const std::vector<internal::Neighbors>&);

  // A forest of roots only. `component` is the number of the component of each face, and
  // `areas` has one entry a component; components are numbered by their first face.
  // Areas are handed over in the square of `unit`.
  Segment_tree(const std::vector<internal::Index>& component, const std::vector<double>& areas,
               double unit, const internal::Options& options)
    : number_of_roots_(areas.size()), nodes_(areas.size()), first_face_(areas.size()),
      areas_(areas), unit_(unit),
      maximum_number_of_segments_(options.maximum_number_of_segments),
      salience_threshold_(options.salience_threshold)
  {
    for (size_type c = 0; c < areas.size(); ++c)
      nodes_[c].area = areas[c] * unit * unit;
    set_faces(component);
  }

  // Puts faces into the leaves, of which each gets one or more, in place of those that were there.
  void set_faces(const std::vector<internal::Index>& leaf)
  {
    for (Node& n : nodes_)
      n.number_of_faces = 0;
    smallest_face_.assign(nodes_.size(), internal::null_index);
    for (internal::Index f = 0; f < leaf.size(); ++f) {
      ++nodes_[leaf[f]].number_of_faces;
      smallest_face_[leaf[f]] = (std::min)(smallest_face_[leaf[f]], f);
    }
    for (size_type i = nodes_.size(); i-- > 0;)
      if (!nodes_[i].is_leaf())
        for (size_type child : nodes_[i].children) {
          nodes_[i].number_of_faces += nodes_[child].number_of_faces;
          smallest_face_[i] = (std::min)(smallest_face_[i], smallest_face_[child]);
        }
    size_type first = 0;
    for (size_type i = 0; i < number_of_roots_; ++i) {
      first_face_[i] = first;
      first += nodes_[i].number_of_faces;
    }
    for (size_type i = 0; i < nodes_.size(); ++i)
      if (!nodes_[i].is_leaf()) {
        const auto& [a, b] = nodes_[i].children;
        first_face_[a] = first_face_[i];
        first_face_[b] = first_face_[i] + nodes_[a].number_of_faces;
      }
    faces_.resize(leaf.size());
    std::vector<size_type> next(first_face_);
    for (internal::Index f = 0; f < leaf.size(); ++f)
      faces_[next[leaf[f]]++] = f;
  }

  // The order of the cuts: that in which they were made if the tree is whole, else large parts come
  // first; of equals the part that was made first.
  struct Before
  {
    const Segment_tree* tree;
    bool operator()(size_type a, size_type b) const
    {
      if (tree->is_whole_ && tree->nodes_[a].children[0] != tree->nodes_[b].children[0])
        return tree->nodes_[a].children[0] < tree->nodes_[b].children[0];
      if (!tree->is_whole_ && tree->areas_[a] != tree->areas_[b])
        return tree->areas_[a] > tree->areas_[b];
      return a < b;
    }
  };

  typedef std::set<size_type, Before> Queue;

  Queue empty_queue() const { return Queue(Before{this}); }

  void set_cut(size_type i, Cut_state state, double salience, const Salience_factors& factors)
  {
    nodes_[i].cut_state = state;
    nodes_[i].salience = salience;
    nodes_[i].factors = factors;
  }

  // Cuts leaf i: the j-th of its faces, in ascending order, goes to the child that `side[j]` names.
  void cut(size_type i, const std::vector<char>& side, const double (&area)[2])
  {
    const auto first = faces_.begin() + first_face_[i];
    std::vector<internal::Index> rest;
    auto out = first;
    for (size_type j = 0; j < side.size(); ++j)
      if (side[j] == 0)
        *out++ = first[j];
      else
        rest.push_back(first[j]);
    std::copy(rest.begin(), rest.end(), out);

    const size_type size[2] = {side.size() - rest.size(), rest.size()};
    for (int k = 0; k < 2; ++k) {
      nodes_[i].children[k] = nodes_.size();
      Node child;
      child.parent = i;
      child.number_of_faces = size[k];
      child.area = area[k] * unit_ * unit_;
      nodes_.push_back(child);
      first_face_.push_back(first_face_[i] + (k == 0 ? 0 : size[0]));
      smallest_face_.push_back(faces_[first_face_.back()]);
      areas_.push_back(area[k]);
    }
  }

  // The nodes that are the segments, in the order of their labels. Repeats the run's recursion.
  std::vector<size_type> prune(size_type maximum_number_of_segments,
                               double salience_threshold) const
  {
    Queue queue = empty_queue();
    for (size_type i = 0; i < number_of_roots_; ++i)
      queue.insert(i);
    std::vector<size_type> parts;
    while (!queue.empty() && parts.size() + queue.size() < maximum_number_of_segments) {
      const size_type i = *queue.begin();
      queue.erase(queue.begin());
      const Node& n = nodes_[i];
      if (n.cut_state == Cut_state::NOT_SEARCHED)
        throw std::out_of_range("Segment_tree: the run ended before it searched the part of node " +
                                std::to_string(i) + ", which is needed for these labels");
      if (n.cut_state == Cut_state::NO_CUT || n.salience < salience_threshold)
        parts.push_back(i);
      else if (n.cut_state == Cut_state::REJECTED)
        throw std::out_of_range("Segment_tree: the run had a higher salience threshold");
      else
        queue.insert(std::begin(n.children), std::end(n.children));
    }
    parts.insert(parts.end(), queue.begin(), queue.end());
    std::sort(parts.begin(), parts.end(), [this](size_type a, size_type b)
              { return smallest_face_[a] < smallest_face_[b]; });
    return parts;
  }

  static void number_by_first_face(std::vector<size_type>& labels, size_type number_of_labels)
  {
    std::vector<size_type> number(number_of_labels, null_node);
    size_type next = 0;
    for (size_type& label : labels) {
      if (number[label] == null_node)
        number[label] = next++;
      label = number[label];
    }
  }

  template <class TriangleMesh, class SegmentIdMap, class NamedParameters>
  size_type write(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                  const std::vector<size_type>& labels, const NamedParameters& np) const
  {
    const auto& pack = internal::cgal_pack(np);
    static_assert(internal_np::has_only_face_index_map<std::decay_t<decltype(pack)> >::value,
                  "the labels of a Segment_tree depend on no named parameter but face_index_map");
    return internal::write_labels(internal::numbered_faces(mesh, pack), labels, segment_ids);
  }

  size_type number_of_roots_ = 0;
  std::vector<Node> nodes_;
  std::vector<size_type> first_face_;            // of each node, in faces_
  std::vector<internal::Index> smallest_face_;   // of each node
  std::vector<double> areas_;                    // of each node, in a unit in which none overflows
  double unit_ = 1;
  std::vector<internal::Index> faces_;           // permuted so that each node is a range
  std::vector<internal::Neighbors> neighbors_;   // dual graph, only if boundaries are smoothed
  size_type maximum_number_of_segments_ = (std::numeric_limits<size_type>::max)();
  double salience_threshold_ = 0;
  bool is_whole_ = false; // the cuts were made from the most salient on, down to the last
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// The leaf in which each face is.
inline std::vector<Index> leaves(const Segment_tree& tree)
{
  std::vector<Index> leaf(tree.number_of_faces());
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
    if (tree.node(i).is_leaf())
      for (Index f : tree.faces(i))
        leaf[f] = static_cast<Index>(i);
  return leaf;
}

// Numbers the faces of a run as the mesh does: f becomes `number[f]`. `neighbors` are those of the
// faces of the run if boundaries shall be smoothed.
inline void number_faces(Segment_tree& tree, const std::vector<Index>& number,
                         const std::vector<Neighbors>& neighbors)
{
  const std::vector<Index> leaf = leaves(tree);
  std::vector<Index> numbered(leaf.size());
  for (Index f = 0; f < leaf.size(); ++f)
    numbered[number[f]] = leaf[f];
  tree.set_faces(numbered);
  tree.neighbors_.resize(neighbors.size());
  for (Index f = 0; f < neighbors.size(); ++f)
    for (int i = 0; i < 3; ++i)
      tree.neighbors_[number[f]][i] = number[neighbors[f][i]];
}

} // namespace internal
/// \endcond

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_SEGMENT_TREE_H
