// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_HIERARCHY_H
#define CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_HIERARCHY_H

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_editor.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/read/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {

/// \cond SKIP_IN_MANUAL
namespace internal {
struct Hierarchy_access;
} // namespace internal
/// \endcond

/// \ingroup PkgSpectralSegmentationRef
/// The cuts that a run of `segment_spectral_recursive()` made, as a forest of binary trees.
///
/// The children of a node are its two parts. The root is the mesh; if components are kept
/// separate, for example by `zhang_liu_2005()`, each connected component is a root.
/// A hierarchy gives the labels for another number of segments, or another threshold, without a new
/// search. Each segment is a node. Segments can be merged by hand, and cut again.
/// `IO/hierarchy.h` writes a hierarchy to a stream, and reads it.
///
/// The calibrated method (default) merges the regions of an over-segmentation. The cuts are its
/// merges in reverse, and the hierarchy has all of them, whatever the threshold and the maximum
/// number of segments of the run. A run with a maximum above 20 makes more regions. Its labels may
/// then differ from the labels of a run with the default maximum, even for fewer segments.
///
/// Faces are identified by their index: their position in `faces(mesh)`, or the value of the
/// `face_index_map` if the run was given one, or their position in the range of triangles.
class Segmentation_hierarchy
{
public:
  /// an unsigned integer, for nodes, faces, and numbers of them
  typedef std::size_t size_type;

#ifdef DOXYGEN_RUNNING
  /// a range of unsigned integers
  typedef unspecified_type Face_range;

  /// the index that stands for no node
  static constexpr size_type null_node = static_cast<size_type>(-1);

  /// The outcome of the search for the best cut of a node.
  enum class Cut_state
  {
    NOT_SEARCHED, ///< the run ended before it came to this part
    /// no cut has two connected sides of minimum size; in the calibrated method (default): a leaf
    NO_CUT,
    /// the best cut is less salient than the threshold; not used by the calibrated method (default)
    REJECTED,
    /// the part has two children; in the calibrated method (default) whatever the threshold
    CUT
  };

  /// A set of faces: a root, or one side of the cut of its parent.
  struct Node
  {
    size_type parent;      ///< the node that was cut; `null_node` for a root

    /// the side of smaller area, to which the factors belong, then the other side; `null_node`
    /// twice for a leaf
    size_type children[2];

    /// in the square of the unit of the mesh's coordinates; infinite if it is above the largest
    /// number
    double area;
    Cut_state cut_state;   ///< the outcome of the search for its cut

    /// the salience of the best cut; 0 if there is none or it was not searched, infinite between
    /// components that do not touch.
    /// In the calibrated method (default) a salience that is larger than the salience of the cut
    /// above it becomes that salience, because a cut can only be made after the cut above it.
    /// Therefore saliences never grow from cut to cut. Cuts that are images of each other, under a
    /// reflection or rotation of the mesh, have the mean of their saliences. The factors stay.
    double salience;

    /// the factors of that cut, on the mesh on which it was searched (`number_of_coarse_faces`);
    /// 0 for a cut between two nodes that `merge()` made siblings
    Salience_factors factors;

    bool is_leaf() const;  ///< whether it has no children
  };
#else
  typedef internal::Nested_ranges::Range Face_range;
  static constexpr size_type null_node = internal::null_node;
  typedef internal::Cut_state Cut_state;
  typedef internal::Cut_node Node;
#endif

  /// \name Nodes
  /// @{

  /// the number of faces of the mesh; 0 before a run
  size_type number_of_faces() const { return faces_.size(); }

  /// the number of nodes, including leaves
  size_type number_of_nodes() const { return cuts_.nodes.size(); }

  /// the number of roots, which are the nodes from 0 to `number_of_roots() - 1`.
  /// Until the hierarchy is edited, the children of the i-th cut that was made are the node
  /// `number_of_roots() + 2 * i` and the next one.
  size_type number_of_roots() const { return cuts_.number_of_roots; }

  /// the number of leaves, which is the largest number of segments that can be requested
  size_type number_of_segments() const { return cuts_.number_of_segments(); }

  /// the node of index `i`, which is below `number_of_nodes()`
  const Node& node(size_type i) const
  {
    CGAL_precondition(i < number_of_nodes());
    return cuts_.nodes[i];
  }

  /// the number of faces of node `i`; at least 1
  size_type number_of_faces(size_type i) const { return faces_.size(i); }

  /// the indices of the faces of node `i`; in a leaf they ascend
  Face_range faces(size_type i) const { return faces_[i]; }

  /// the descriptors of the faces of node `i`, in the order of `faces(i)`. If the run had a
  /// `face_index_map`, `np` must have it too. The time is linear in the number of faces of the
  /// mesh. Throws `std::invalid_argument` if the mesh has another number of faces.
  template <class TriangleMesh,
            class NamedParameters = CGAL::parameters::Default_named_parameters>
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>
  faces(size_type i, const TriangleMesh& mesh, const NamedParameters& np = NamedParameters()) const
  {
    const auto descriptors = internal::numbered_faces(mesh, checked_pack(np));
    internal::check_number_of_faces(descriptors.size(), number_of_faces());
    std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> result;
    result.reserve(number_of_faces(i));
    for (auto f : faces(i))
      result.push_back(descriptors[f]);
    return result;
  }

  /// the salience threshold of the run; with `zhang_liu_2005()` no lower one can be requested
  double salience_threshold() const { return salience_threshold_; }

  /// @}

  /// \name Segments
  /// A choice of segments is a vector of nodes that contain each face exactly once. The functions
  /// `nodes()` and `nodes_above()` return choices, with the nodes in the order of their faces of
  /// smallest index. To change a choice by hand, replace a node by its two children, or two
  /// children by their parent. The label of a face is the position of its node, and so is its
  /// segment id. All functions take time linear in the number of faces and of cuts.
  /// @{

  /// the segments that the run returned
  std::vector<size_type> nodes() const
  {
    const size_type most = (std::min)(number_of_segments(), maximum_number_of_segments_);
    return in_order(cuts_above(salience_threshold_, most, false));
  }

  /// exactly `n` segments, which the first cuts of the run make, but never fewer than the roots and
  /// never more than the leaves, `number_of_segments()`; a run with `number_of_segments(n)` makes
  /// exactly `n`. No threshold applies.
  std::vector<size_type> nodes(size_type n) const { return in_order(first_cuts(n)); }

  /// the segments that cuts with a salience of at least `salience_threshold` make, as in a run with
  /// this threshold, and with the maximum number of segments of this run. Throws
  /// `std::out_of_range` if this needs a cut that is not known because the run ended before it, at
  /// its maximum number of segments or stopped by its visitor, or had a higher threshold.
  std::vector<size_type> nodes_above(double salience_threshold) const
  { return nodes_above(salience_threshold, maximum_number_of_segments_); }

  /// the same, but at most `maximum_number_of_segments` segments, never fewer than there are roots
  std::vector<size_type> nodes_above(double salience_threshold,
                                     size_type maximum_number_of_segments) const
  { return in_order(cuts_above(salience_threshold, maximum_number_of_segments)); }

  /// the label of each face, by its index, if these nodes are the segments: the position of its
  /// node in `nodes`. Throws `std::invalid_argument` if the nodes do not contain each face exactly
  /// once.
  std::vector<size_type> labels(const std::vector<size_type>& nodes) const
  {
    std::vector<size_type> position(number_of_nodes(), null_node);
    for (size_type k = 0; k < nodes.size(); ++k) {
      if (nodes[k] >= number_of_nodes() || position[nodes[k]] != null_node)
        throw std::invalid_argument("Segmentation_hierarchy: the nodes of segments must be "
                                    "different nodes of the hierarchy");
      position[nodes[k]] = k;
    }
    for (size_type i : internal::parents_first(cuts_)) {
      const Node& n = cuts_.nodes[i];
      const size_type above = n.parent == null_node ? null_node : position[n.parent];
      if (above != null_node && position[i] != null_node)
        throw std::invalid_argument("Segmentation_hierarchy: a segment contains another");
      if (above != null_node)
        position[i] = above;
      else if (n.is_leaf() && position[i] == null_node)
        throw std::invalid_argument("Segmentation_hierarchy: a face is in no segment");
    }
    std::vector<size_type> result;
    result.reserve(number_of_faces());
    for (size_type leaf : cuts_.leaf)
      result.push_back(position[leaf]);
    return result;
  }

  /// writes `labels(nodes)` into a property map, and returns the number of segments. If the run had
  /// a `face_index_map`, `np` must have it too. It may have no other parameter.
  template <class TriangleMesh, class SegmentIdMap,
            class NamedParameters = CGAL::parameters::Default_named_parameters>
  size_type write(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                  const std::vector<size_type>& nodes,
                  const NamedParameters& np = NamedParameters()) const
  {
    return internal::write_labels(internal::numbered_faces(mesh, checked_pack(np)), labels(nodes),
                                  segment_ids);
  }

  /// @}

  /// \name Changes by Hand
  /// Experimental: `merge()` makes two nodes the children of one node, and `split_leaf()`
  /// cuts a leaf. All functions keep working and nodes keep their indices.
  /// Nodes below the given ones, and nodes with no face in common with them, also keep their faces.
  /// Both functions take time linear in the number of faces and O(*c* log *c*) in the number *c* of
  /// cuts. If they throw an exception, nothing has changed.
  ///
  /// In a hierarchy of the calibrated method (default) cuts stay in the order of their salience: if
  /// a change puts a cut below a less salient one, its salience is lowered to the salience of the
  /// cut above.
  /// @{

  /// makes two nodes the children of one node, and returns that node.
  ///
  /// The cut between `a` and `b` moves as late as possible: directly before the first cut of
  /// either, with the larger salience of their cuts. If both are leaves it comes last, with
  /// salience 0 or the smallest salience, whichever is less. Therefore after two segments of
  /// `nodes(n)` were merged, `nodes(n - 1)` has them as one segment.
  ///
  /// If `a` and `b` are not siblings, node `b` moves next to node `a`, and the cut that separated
  /// `b` is undone. Nodes that contain only one of the two gain or lose the faces of `b`. Therefore
  /// the two nodes should touch, and `b` should be the one that the rest needs less to be
  /// connected.
  ///
  /// Throws `std::invalid_argument` if one node contains the other, if there is no such node, or if
  /// they have different roots, as with `keep_components_separate` or with constraints that keep
  /// parts apart.
  size_type merge(size_type a, size_type b)
  {
    check_node(a);
    check_node(b);
    internal::Cut_hierarchy cuts = cuts_;
    const size_type result = internal::Cut_editor(cuts).merge(a, b);
    set_cuts(std::move(cuts));
    return result;
  }

  /// cuts a leaf like `part`, which is the hierarchy of a run on only the faces of that leaf, in
  /// their order; see the example `edit_segments.cpp`. The nodes of its cuts get the indices after
  /// the existing ones.
  ///
  /// Throws `std::invalid_argument` if `leaf` is not a leaf, or if `part` has another number of
  /// faces or several roots.
  void split_leaf(size_type leaf, const Segmentation_hierarchy& part)
  {
    check_node(leaf);
    if (!node(leaf).is_leaf())
      throw std::invalid_argument("Segmentation_hierarchy: only a leaf can be cut again; for other "
                                  "nodes there are their children");
    if (part.number_of_faces() != number_of_faces(leaf))
      throw std::invalid_argument("Segmentation_hierarchy: the hierarchy of a part must have the "
                                  "faces of the leaf that is cut");
    if (part.number_of_roots() != 1)
      throw std::invalid_argument("Segmentation_hierarchy: the hierarchy of a part must have one "
                                  "root");
    internal::Cut_hierarchy cuts = cuts_;
    internal::Cut_editor(cuts).graft(leaf, faces(leaf), part.cuts_);
    set_cuts(std::move(cuts));
  }

  /// @}

  /// a hierarchy without nodes, to be passed to a run
  Segmentation_hierarchy() = default;

  /// \cond SKIP_IN_MANUAL
  Segmentation_hierarchy(internal::Cut_hierarchy cuts, size_type maximum_number_of_segments,
                         double salience_threshold)
    : cuts_(std::move(cuts)), faces_(cuts_),
      maximum_number_of_segments_(maximum_number_of_segments),
      salience_threshold_(salience_threshold)
  {
    if (!cuts_.has_all_cuts) // there are no more segments than these
      maximum_number_of_segments_ = (std::min)(maximum_number_of_segments_, number_of_segments());
  }
  /// \endcond

private:
  friend struct internal::Hierarchy_access;

  void check_node(size_type i) const
  {
    if (i >= number_of_nodes())
      throw std::invalid_argument("Segmentation_hierarchy: there is no node " + std::to_string(i));
  }

  void set_cuts(internal::Cut_hierarchy cuts)
  {
    internal::Nested_ranges faces(cuts);
    cuts_ = std::move(cuts);
    faces_ = std::move(faces);
  }

  std::vector<char> roots() const
  {
    std::vector<char> result(number_of_nodes(), 0);
    std::fill(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(number_of_roots()), 1);
    return result;
  }

  void cut(size_type i, std::vector<char>& is_segment) const
  {
    is_segment[i] = 0;
    for (size_type child : cuts_.nodes[i].children)
      is_segment[child] = 1;
  }

  // Returns for each node whether it is a segment after the first cuts.
  std::vector<char> first_cuts(size_type number_of_segments) const
  {
    std::vector<char> is_segment = roots();
    size_type number = number_of_roots();
    for (size_type i : cuts_.cut_order)
      if (number < number_of_segments && !cuts_.nodes[i].is_leaf()) {
        cut(i, is_segment);
        ++number;
      }
    return is_segment;
  }

  // Returns for each node whether it is a segment of a run with these values, by repeating the
  // decisions of the run in their order. Throws if such a run would have to search further.
  std::vector<char> cuts_above(double salience_threshold, size_type maximum_number_of_segments,
                               bool searches_further = true) const
  {
    if (std::isnan(salience_threshold))
      throw std::invalid_argument("Segmentation_hierarchy: the salience threshold is not a number");
    std::vector<char> is_segment = roots();
    size_type number = number_of_roots();
    for (size_type i : cuts_.cut_order) {
      const Node& n = cuts_.nodes[i];
      if (number >= maximum_number_of_segments)
        return is_segment;
      if (!is_segment[i] || n.cut_state == Cut_state::NO_CUT || n.salience < salience_threshold)
        continue;
      if (n.cut_state == Cut_state::REJECTED)
        throw std::out_of_range("Segmentation_hierarchy: the run had a higher salience threshold");
      cut(i, is_segment);
      ++number;
    }
    if (searches_further && number < maximum_number_of_segments)
      for (size_type i = 0; i < number_of_nodes(); ++i)
        if (is_segment[i] && cuts_.nodes[i].cut_state == Cut_state::NOT_SEARCHED)
          throw std::out_of_range("Segmentation_hierarchy: the run ended before it searched the "
                                  "part of node " + std::to_string(i) +
                                  ", which is needed for these labels");
    return is_segment;
  }

  // Returns the segments in the order of their first faces.
  std::vector<size_type> in_order(const std::vector<char>& is_segment) const
  {
    std::vector<size_type> result, nodes;
    for (size_type i = 0; i < number_of_nodes(); ++i)
      if (is_segment[i])
        nodes.push_back(i);
    for (size_type label : labels(nodes))
      if (nodes[label] != null_node)
        result.push_back(std::exchange(nodes[label], null_node));
    return result;
  }

  template <class NamedParameters>
  static const auto& checked_pack(const NamedParameters& np)
  {
    const auto& pack = internal::cgal_pack(np);
    static_assert(internal_np::has_only_face_index_map<std::decay_t<decltype(pack)> >::value,
                  "the labels of a Segmentation_hierarchy depend on no named parameter but "
                  "face_index_map");
    return pack;
  }

  internal::Cut_hierarchy cuts_;
  internal::Nested_ranges faces_; // one range per node
  size_type maximum_number_of_segments_ = unlimited;
  double salience_threshold_ = 0;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// Gives access to the data of a hierarchy that are written and have no public name.
struct Hierarchy_access
{
  static const Cut_hierarchy& cuts(const Segmentation_hierarchy& h) { return h.cuts_; }

  static std::size_t maximum_number_of_segments(const Segmentation_hierarchy& h)
  { return h.maximum_number_of_segments_; }
};

} // namespace internal
/// \endcond

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_HIERARCHY_H
