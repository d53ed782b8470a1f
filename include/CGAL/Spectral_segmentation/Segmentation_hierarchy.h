// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_HIERARCHY_H
#define CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_HIERARCHY_H

#include <CGAL/Spectral_segmentation/internal/door/numbered_descriptors.h>
#include <CGAL/Spectral_segmentation/internal/engine.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Cut_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/hierarchy/Nested_ranges.h>
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

/// \ingroup PkgSpectralSegmentationRef
/// The cuts that a run of `segment_spectral_recursive()` made, as a forest of binary trees.
///
/// The children of a node are its two parts. The root is the whole mesh; if components are kept
/// apart, as with `zhang_liu_2005()`, each connected component is a root.
/// From a hierarchy the labels for fewer segments, or for a higher threshold, are read off without
/// searching again; they are the labels that a run with these values would give.
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

    /// the factors of that cut, on the mesh on which it was searched (`number_of_searched_faces`)
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

  /// the number of nodes, leaves too
  size_type number_of_nodes() const { return cuts_.nodes.size(); }

  /// The roots are the nodes from 0 to `number_of_roots() - 1`.
  /// The children of the i-th cut that was made follow at `number_of_roots() + 2 * i`.
  size_type number_of_roots() const { return cuts_.number_of_roots; }

  /// the number of leaves: the largest number of segments that can be asked for
  size_type number_of_segments() const { return cuts_.number_of_segments(); }

  /// the node of index `i`, which is below `number_of_nodes()`
  const Node& node(size_type i) const
  {
    CGAL_precondition(i < number_of_nodes());
    return cuts_.nodes[i];
  }

  /// the number of faces of node `i`; at least 1
  size_type number_of_faces(size_type i) const { return faces_.size(i); }

  /// the numbers of the faces of node `i`; those of a leaf ascend
  Face_range faces(size_type i) const { return faces_[i]; }

  /// the salience threshold of the run: with `zhang_liu_2005()` no lower one can be asked for
  double salience_threshold() const { return salience_threshold_; }

  /// @}

  /// \name Labels
  /// A label is a number from 0 to the number of segments - 1. Segments are numbered by their
  /// face of smallest number. All functions take time linear in the number of faces and of cuts.
  ///
  /// They throw `std::out_of_range` if a cut that is needed is not known: the run ended before it,
  /// at its maximum number of segments or stopped by its visitor, or had a higher threshold.
  /// @{

  /// the labels that the run gave
  std::vector<size_type> labels() const
  {
    return labels((std::min)(number_of_segments(), maximum_number_of_segments_),
                  salience_threshold_);
  }

  /// the label of each face, by its number, for at most `maximum_number_of_segments` segments
  /// (never fewer than there are roots) and cuts of at least `salience_threshold`
  std::vector<size_type> labels(size_type maximum_number_of_segments,
                                double salience_threshold) const
  {
    if (std::isnan(salience_threshold))
      throw std::invalid_argument("Segmentation_hierarchy: the salience threshold is not a number");
    const std::vector<char> is_segment = segments(maximum_number_of_segments, salience_threshold);
    std::vector<size_type> segment_of_node(number_of_nodes());
    for (size_type i = 0; i < number_of_nodes(); ++i)
      segment_of_node[i] = is_segment[i] || i < number_of_roots()
        ? i : segment_of_node[cuts_.nodes[i].parent];
    // A segment within a segment is none: parents come before their children.
    std::vector<size_type> result(number_of_faces());
    for (size_type f = 0; f < result.size(); ++f)
      result[f] = segment_of_node[cuts_.leaf[f]];
    number_by_first_face(result);
    if (!cuts_.neighbors.empty()) {
      internal::smooth_boundaries(cuts_.neighbors, result);
      number_by_first_face(result);
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

  /// a hierarchy without nodes, to be given to a run
  Segmentation_hierarchy() = default;

  /// \cond SKIP_IN_MANUAL
  Segmentation_hierarchy(internal::Cut_hierarchy cuts, const internal::Options& options)
    : cuts_(std::move(cuts)), faces_(cuts_, cuts_.leaf),
      maximum_number_of_segments_(options.maximum_number_of_segments),
      salience_threshold_(options.salience_threshold)
  {
    if (!cuts_.is_complete) // no more segments than there are can be asked for
      maximum_number_of_segments_ = (std::min)(maximum_number_of_segments_, number_of_segments());
  }
  /// \endcond

private:
  // Whether a node is a segment: the run's decisions again, in their order.
  std::vector<char> segments(size_type maximum_number_of_segments, double salience_threshold) const
  {
    std::vector<char> is_segment(number_of_nodes(), 0);
    std::fill(is_segment.begin(),
              is_segment.begin() + static_cast<std::ptrdiff_t>(number_of_roots()), 1);
    size_type number = number_of_roots();
    for (size_type i : cuts_.turns) {
      const Node& n = cuts_.nodes[i];
      if (number >= maximum_number_of_segments)
        return is_segment;
      if (!is_segment[i] || n.cut_state == Cut_state::NO_CUT || n.salience < salience_threshold)
        continue;
      if (n.cut_state == Cut_state::REJECTED)
        throw std::out_of_range("Segmentation_hierarchy: the run had a higher salience threshold");
      is_segment[i] = 0;
      is_segment[n.children[0]] = is_segment[n.children[1]] = 1;
      ++number;
    }
    if (number < maximum_number_of_segments)
      for (size_type i = 0; i < number_of_nodes(); ++i)
        if (is_segment[i] && cuts_.nodes[i].cut_state == Cut_state::NOT_SEARCHED)
          throw std::out_of_range("Segmentation_hierarchy: the run ended before it searched the "
                                  "part of node " + std::to_string(i) +
                                  ", which is needed for these labels");
    return is_segment;
  }

  // Labels become 0, 1, ... in the order of the first faces that have them.
  void number_by_first_face(std::vector<size_type>& labels) const
  {
    std::vector<size_type> number(number_of_nodes(), null_node);
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
                  "the labels of a Segmentation_hierarchy depend on no named parameter but "
                  "face_index_map");
    return internal::write_labels(internal::numbered_faces(mesh, pack), labels, segment_ids);
  }

  internal::Cut_hierarchy cuts_;
  internal::Nested_ranges faces_; // of each node
  size_type maximum_number_of_segments_ = internal::unlimited;
  double salience_threshold_ = 0;
};

} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_SEGMENTATION_HIERARCHY_H
