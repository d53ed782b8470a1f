// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_HIERARCHY_H
#define CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_HIERARCHY_H

#include <CGAL/Spectral_segmentation/internal/door/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/dendrogram/editing.h>
#include <CGAL/Spectral_segmentation/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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
/// The children of a node are its two parts. The root is the whole mesh; if components are kept
/// apart, as with `zhang_liu_2005()`, each connected component is a root.
/// From a hierarchy the labels for another number of segments, or another threshold, are read off
/// without searching again: `labels(nodes(n))`. Segments can be merged, and cut again, by hand.
/// `Segmented_mesh/IO/hierarchy_json.h` writes a hierarchy to a stream, and reads it.
///
/// The default method merges the regions of an over-segmentation, and the cuts are its merges in
/// reverse: the hierarchy has them all, whatever the threshold and the maximum number of segments
/// of the run. A run with a maximum above 20 makes more regions. Its labels may then differ from
/// those of a run with the default maximum, even for fewer segments.
///
/// Faces are named by their number: their position in `faces(mesh)`, or the value of the
/// `face_index_map` if the run was given one; or their position in the range of triangles.
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

  /// What became of the search for the best cut of a node.
  enum class Cut_state
  {
    NOT_SEARCHED, ///< the run ended before it came to this part
    NO_CUT,       ///< no cut has two connected sides of minimum size; in the default method: a leaf
    REJECTED,     ///< the best cut is less salient than the threshold; not in the default method
    ACCEPTED      ///< the part has two children; in the default method whatever the threshold
  };

  /// A set of faces: a root, or one side of the cut of its parent.
  struct Node
  {
    size_type parent;      ///< the node that was cut; `null_node` for a root

    /// the side of smaller area, to which the factors belong, then the rest; `null_node` twice for
    /// a leaf
    size_type children[2];

    double area;           ///< in the square of the unit of the mesh's coordinates
    Cut_state cut_state;   ///< what became of the search for its cut

    /// the salience of the best cut; 0 if there is none or it was not searched, infinite between
    /// components that do not touch.
    /// In the default method cuts that make congruent parts have the mean of their saliences, which
    /// is raised to the largest salience of the cuts that follow, so that saliences never grow from
    /// cut to cut. The factors are not changed.
    double salience;

    /// the factors of that cut, on the mesh on which it was searched (`number_of_searched_faces`);
    /// 0 for a cut between two nodes that `merge()` put together
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
  /// All functions that take a node throw `std::invalid_argument` if there is no such node.
  /// @{

  /// the number of faces of the mesh; 0 before a run
  size_type number_of_faces() const { return faces_.size(); }

  /// the number of nodes, leaves too
  size_type number_of_nodes() const { return cuts_.nodes.size(); }

  /// The roots are the nodes from 0 to `number_of_roots() - 1`.
  /// Until the hierarchy is edited, the children of the i-th cut that was made follow at
  /// `number_of_roots() + 2 * i`.
  size_type number_of_roots() const { return cuts_.number_of_roots; }

  /// the number of leaves: the largest number of segments that can be asked for
  size_type number_of_segments() const { return cuts_.number_of_segments(); }

  /// the node of index `i`
  const Node& node(size_type i) const
  {
    check_node(i);
    return cuts_.nodes[i];
  }

  /// the number of faces of node `i`; at least 1
  size_type number_of_faces(size_type i) const
  {
    check_node(i);
    return faces_.size(i);
  }

  /// the numbers of the faces of node `i`; those of a leaf ascend
  Face_range faces(size_type i) const
  {
    check_node(i);
    return faces_[i];
  }

  /// the descriptors of the faces of node `i`, in the order of `faces(i)`; `np` must have the
  /// `face_index_map` of the run if that had one. Takes time linear in the number of faces of the
  /// mesh. Throws `std::invalid_argument` if the mesh has another number of faces.
  template <class TriangleMesh,
            class NamedParameters = CGAL::parameters::Default_named_parameters>
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>
  faces(size_type i, const TriangleMesh& mesh, const NamedParameters& np = NamedParameters()) const
  {
    const auto& pack = internal::checked_pack<internal_np::has_only_face_index_map>(np);
    const auto descriptors = internal::numbered_faces(mesh, pack);
    internal::check_number_of_faces(descriptors.size(), number_of_faces());
    std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> result;
    result.reserve(number_of_faces(i));
    for (auto f : faces(i))
      result.push_back(descriptors[f]);
    return result;
  }

  /// the salience of the cut that separates two nodes: that of the smallest node that contains
  /// both. Infinite if they have different roots; 0 if one contains the other.
  double salience_between(size_type a, size_type b) const
  {
    check_node(a);
    check_node(b);
    std::vector<char> is_above(number_of_nodes(), 0);
    for (size_type i = a; i != null_node; i = cuts_.nodes[i].parent)
      is_above[i] = 1;
    size_type common = b;
    while (common != null_node && !is_above[common])
      common = cuts_.nodes[common].parent;
    return common == null_node ? std::numeric_limits<double>::infinity()
           : common == a || common == b ? 0 : cuts_.nodes[common].salience;
  }

  /// the salience threshold of the run: with `zhang_liu_2005()` no lower one can be asked for
  double salience_threshold() const { return salience_threshold_; }

  /// the maximum number of segments of the run, or the exact number
  size_type maximum_number_of_segments() const { return maximum_number_of_segments_; }

  /// @}

  /// \name Segments
  /// A choice of segments is a vector of nodes, which contain each face exactly once. The label of a
  /// face is the position of its node. All functions take time linear in the number of faces and of
  /// cuts.
  ///
  /// The functions that choose nodes order them by their faces of smallest number, as
  /// `segment_spectral_recursive()` numbers segments. To cut a segment again, replace its node by the
  /// two children.
  /// @{

  /// the nodes of the segments that the run gave
  std::vector<size_type> nodes() const
  {
    return nodes_above(salience_threshold_,
                       (std::min)(number_of_segments(), maximum_number_of_segments_));
  }

  /// the nodes of exactly `n` segments, by the first cuts of the run; or as near to it as there are
  /// roots and leaves. No threshold applies.
  std::vector<size_type> nodes(size_type n) const
  {
    std::vector<char> is_segment = roots();
    size_type number = number_of_roots();
    for (size_type i : cuts_.order)
      if (number < n && !cuts_.nodes[i].is_leaf()) {
        cut(i, is_segment);
        ++number;
      }
    return in_order(is_segment);
  }

  /// the nodes of the segments of a run with this threshold, and the maximum number of segments of
  /// this run. Throws `std::out_of_range` if a cut that is needed is not known: the run ended before
  /// it, at its maximum number of segments or stopped by its visitor, or had a higher threshold.
  std::vector<size_type> nodes_above(double salience_threshold) const
  { return nodes_above(salience_threshold, maximum_number_of_segments_); }

  /// the same for another maximum number of segments; there are never fewer than roots
  std::vector<size_type> nodes_above(double salience_threshold,
                                     size_type maximum_number_of_segments) const
  {
    if (std::isnan(salience_threshold))
      throw std::invalid_argument("Segmentation_hierarchy: the salience threshold is not a number");
    std::vector<char> is_segment = roots();
    size_type number = number_of_roots();
    for (size_type i : cuts_.order) {
      const Node& n = cuts_.nodes[i];
      if (number >= maximum_number_of_segments)
        break;
      if (!is_segment[i] || n.cut_state == Cut_state::NO_CUT || n.salience < salience_threshold)
        continue;
      if (n.cut_state == Cut_state::REJECTED)
        throw std::out_of_range("Segmentation_hierarchy: the run had a higher salience threshold");
      cut(i, is_segment);
      ++number;
    }
    for (size_type i = 0; i < number_of_nodes() && number < maximum_number_of_segments; ++i)
      if (is_segment[i] && cuts_.nodes[i].cut_state == Cut_state::NOT_SEARCHED)
        throw std::out_of_range("Segmentation_hierarchy: the run ended before it searched the "
                                "part of node " + std::to_string(i) +
                                ", which is needed for these segments");
    return in_order(is_segment);
  }

  /// the label of each face, by its number, if the segments are these nodes.
  /// With `boundary_smoothing` the run itself gave some faces along boundaries other labels.
  /// Throws `std::invalid_argument` if the nodes do not contain each face exactly once.
  std::vector<size_type> labels(const std::vector<size_type>& nodes) const
  {
    std::vector<size_type> position(number_of_nodes(), null_node);
    for (size_type k = 0; k < nodes.size(); ++k) {
      check_node(nodes[k]);
      if (position[nodes[k]] != null_node)
        throw std::invalid_argument("Segmentation_hierarchy: node " + std::to_string(nodes[k]) +
                                    " is a segment twice");
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
    for (internal::Index leaf : cuts_.leaf)
      result.push_back(position[leaf]);
    return result;
  }

  /// writes `labels(nodes)` into a property map, and returns the number of segments. `np` must have
  /// the `face_index_map` of the run if that had one, and may have no other parameter.
  template <class TriangleMesh, class SegmentIdMap,
            class NamedParameters = CGAL::parameters::Default_named_parameters>
  size_type write(const std::vector<size_type>& nodes, const TriangleMesh& mesh,
                  SegmentIdMap segment_ids, const NamedParameters& np = NamedParameters()) const
  {
    const auto& pack = internal::checked_pack<internal_np::has_only_face_index_map>(np);
    return internal::write_labels(internal::numbered_faces(mesh, pack), labels(nodes), segment_ids);
  }

  /// @}

  /// \name Changes by Hand
  /// `merge()` puts two nodes below one, and `cut_again()` cuts a leaf. All functions stay valid, nodes keep their numbers, and those that are below the nodes
  /// given, or have none of their faces, keep their faces. Both take time linear in the number of
  /// faces and O(*c* log *c*) in that of cuts. If they throw, nothing has changed.
  ///
  /// In a hierarchy of the default method cuts stay in the order of their salience: where a change
  /// puts a cut below a less salient one, its salience is lowered to that of the latter.
  /// @{

  /// makes two nodes the children of one node, and returns that.
  ///
  /// The cut that separates `a` from `b` comes as late as it can from now on: right before the
  /// first cut of either, with its salience, or last, with the salience 0, or the smallest if that
  /// is below 0. So after two segments of `nodes(n)` were merged, `nodes(n - 1)` has them as one.
  ///
  /// If they are not siblings, node `b` is moved to the place of `a`, and the cut that separated
  /// `b` is undone. Nodes that contain only one of the two gain or lose the faces of `b`. So the
  /// two should touch, and choose for `b` the one that the rest needs less to be connected.
  ///
  /// Throws `std::invalid_argument` if one node contains the other, if there is no such node, or if
  /// they have different roots, as with `components_apart`, or with wishes that keep parts apart.
  size_type merge(size_type a, size_type b)
  {
    check_node(a);
    check_node(b);
    internal::Hierarchy_editor editor(cuts_);
    const size_type result = editor.merge(a, b);
    set_cuts(editor.hierarchy());
    return result;
  }

  /// cuts a leaf as `part`, the hierarchy of a run on the faces of that leaf alone, in their order;
  /// see the example `edit_segments.cpp`. The nodes of its cuts are added behind the others.
  ///
  /// Throws `std::invalid_argument` if `leaf` is no leaf, or if `part` has another number of faces
  /// or several roots.
  void cut_again(size_type leaf, const Segmentation_hierarchy& part)
  {
    check_node(leaf);
    if (!cuts_.nodes[leaf].is_leaf())
      throw std::invalid_argument("Segmentation_hierarchy: only a leaf can be cut again; for other "
                                  "nodes there are their children");
    if (part.number_of_faces() != number_of_faces(leaf))
      throw std::invalid_argument("Segmentation_hierarchy: the hierarchy of a part must have the "
                                  "faces of the leaf that is cut");
    if (part.number_of_roots() != 1)
      throw std::invalid_argument("Segmentation_hierarchy: the hierarchy of a part must have one "
                                  "root");
    if (part.cuts_.nodes[0].is_leaf())
      return;
    internal::Hierarchy_editor editor(cuts_);
    editor.graft(leaf, faces(leaf), part.cuts_);
    set_cuts(editor.hierarchy());
  }

  /// @}

  /// a hierarchy without nodes, to be given to a run
  Segmentation_hierarchy() = default;

  /// \cond SKIP_IN_MANUAL
  Segmentation_hierarchy(internal::Cut_hierarchy cuts, const Options& options)
    : cuts_(std::move(cuts)), faces_(cuts_),
      maximum_number_of_segments_(options.maximum()), salience_threshold_(options.threshold())
  {
    if (!cuts_.is_complete) // no more segments than there are can be asked for
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

  // By their first faces.
  std::vector<size_type> in_order(const std::vector<char>& is_segment) const
  {
    std::vector<size_type> segment(number_of_nodes(), null_node); // of each node
    std::vector<size_type> result;
    for (size_type i : internal::parents_first(cuts_)) {
      const size_type parent = cuts_.nodes[i].parent;
      segment[i] = is_segment[i] ? i : parent == null_node ? null_node : segment[parent];
    }
    std::vector<char> is_met(number_of_nodes(), 0);
    for (internal::Index leaf : cuts_.leaf)
      if (!std::exchange(is_met[segment[leaf]], char(1)))
        result.push_back(segment[leaf]);
    return result;
  }

  internal::Cut_hierarchy cuts_;
  internal::Nested_ranges faces_; // of each node
  size_type maximum_number_of_segments_ = unlimited;
  double salience_threshold_ = 0;
};

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_HIERARCHY_H
