// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_TRANSFER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_TRANSFER_H

#include <CGAL/Spectral_segmentation/Segment_tree.h>
#include <CGAL/Spectral_segmentation/internal/Cut.h>
#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/initialization.h>
#include <CGAL/Spectral_segmentation/internal/minimum_cut.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>
#include <CGAL/Spectral_segmentation/internal/simplification.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// Carries the cuts of a simplified mesh over to the mesh itself. A face is on the side on which all
// faces around its three vertices are, as the simplified mesh has them. Those between, which are a
// band around the cut, are divided by the minimum cut, or if nothing is sure, by what is nearer.
// Where a side is not connected then, the smaller pieces go to the other side.
class Cut_transfer
{
  enum Side : char { Q, REST, BETWEEN, OUTSIDE }; // OUTSIDE: not in the part that is cut

  typedef Iterator_range<std::vector<Index>::const_iterator> Faces; // of a node

  const Segment_tree& cuts_;
  const Simplified_mesh& simplified_;
  const Face_dual_graph& mesh_;
  Face_dual_graph bands_;              // the faces that may be between, and those next to them
  std::vector<Index> number_in_bands_; // of each face; null_index if it is not there
  std::vector<char> side_;             // of each face
  std::vector<Index> reached_;         // by the present flood
  std::vector<Index> flood_;           // the last one that reached each face
  Index number_of_floods_ = 0;

  // What the faces around each vertex of the simplified mesh have in common: their values, joined;
  // null_index of none. Faces whose value is null_index do not count.
  template <class Join>
  std::vector<Index> of_vertices(const std::vector<Index>& values, const Join& join) const
  {
    const Face_dual_graph& graph = simplified_.graph;
    std::vector<Index> result(graph.points.size(), null_index);
    for (Index f = 0; f < graph.number_of_faces(); ++f)
      if (values[f] != null_index)
        for (Index v : graph.corners[f])
          result[v] = result[v] == null_index ? values[f] : join(result[v], values[f]);
    return result;
  }

  std::array<Index, 3> values_at(const std::vector<Index>& of_vertex, Index f) const
  {
    const std::array<Index, 3>& c = mesh_.corners[f];
    const std::vector<Index>& vertices = simplified_.vertices;
    return {of_vertex[vertices[c[0]]], of_vertex[vertices[c[1]]], of_vertex[vertices[c[2]]]};
  }

  // Whether a face may be between the sides of any cut. All may if there might be more cuts: a cut
  // must not depend on those after it.
  std::vector<char> are_between() const
  {
    if (!cuts_.is_whole_)
      return std::vector<char>(mesh_.number_of_faces(), 1);
    constexpr Index several = null_index - 1;
    std::vector<Index> leaf(simplified_.graph.number_of_faces());
    for (std::size_t i = 0; i < cuts_.number_of_nodes(); ++i)
      if (cuts_.node(i).is_leaf())
        for (Index f : cuts_.faces(i))
          leaf[f] = static_cast<Index>(i);
    const std::vector<Index> of_vertex =
      of_vertices(leaf, [](Index a, Index b) { return a == b ? a : several; });
    std::vector<char> result(mesh_.number_of_faces());
    for (Index f = 0; f < result.size(); ++f) {
      const auto [a, b, c] = values_at(of_vertex, f);
      result[f] = a == several || a != b || a != c;
    }
    return result;
  }

  template <class ConcurrencyTag>
  void set_bands(const Options& options)
  {
    const std::vector<char> is_between = are_between();
    std::vector<Index> faces;
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      bool is_needed = is_between[f];
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        is_needed = is_needed || is_between[mesh_.halfedges[h].neighbor];
      if (is_needed) {
        number_in_bands_[f] = static_cast<Index>(faces.size());
        faces.push_back(f);
      }
    }
    bands_ = Part_copier(mesh_)(faces);
    const double area = total_area(bands_);
    const double radius = // which is relative to the area
      area > 0 ? options.concavity_radius * std::sqrt(total_area(mesh_) / area) : 0;
    set_face_distances<ConcurrencyTag>(bands_, bands_.points,
                                       face_normals<ConcurrencyTag>(bands_, bands_.points),
                                       {options.geodesic_weight, options.concave_angle_weight,
                                        options.convex_angle_weight, radius});
  }

  // Tells whether there are faces on either side.
  bool set_sure_sides(std::size_t node, const Faces& faces)
  {
    std::vector<Index> bit(simplified_.graph.number_of_faces(), null_index);
    for (Index s : {Q, REST})
      for (Index f : cuts_.faces(cuts_.node(node).children[s]))
        bit[f] = Index(1) << s;
    const std::vector<Index> of_vertex = of_vertices(bit, [](Index a, Index b) { return a | b; });
    Index all = 0;
    for (Index f : faces) {
      Index sides = 0;
      for (Index bits : values_at(of_vertex, f))
        if (bits != null_index)
          sides |= bits;
      // Faces that came here to keep a part connected have no side; that will take care of them.
      side_[f] = sides == 3 ? BETWEEN : sides == 2 ? REST : Q;
      if (sides != 3)
        all |= sides;
    }
    return all == 3;
  }

  void divide_band(const Faces& faces)
  {
    Sides in_bands(bands_.number_of_faces(), OUTSIDE);
    std::vector<Index> band;
    for (Index f : faces) {
      const Index b = number_in_bands_[f];
      if (b == null_index)
        continue;
      in_bands[b] = side_[f] == BETWEEN ? char(Q) : side_[f];
      if (side_[f] == BETWEEN)
        band.push_back(b);
    }
    in_bands = minimum_cut_within(bands_, band, in_bands);
    for (Index f : faces)
      if (side_[f] == BETWEEN)
        side_[f] = in_bands[number_in_bands_[f]];
  }

  // Where a side is so thin that all of it is between: the faces that are left in the simplified
  // mesh have their sides, and the others between follow them, step by step.
  void grow_sides(std::size_t node, const Faces& faces)
  {
    std::vector<Index> reached;
    for (Index f : faces)
      if (side_[f] != BETWEEN)
        reached.push_back(f);
    for (char s : {Q, REST})
      for (Index f : cuts_.faces(cuts_.node(node).children[int(s)])) {
        const Index left = simplified_.faces[f];
        if (side_[left] == BETWEEN) {
          side_[left] = s;
          reached.push_back(left);
        }
      }
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h) {
        const Index g = mesh_.halfedges[h].neighbor;
        if (side_[g] == BETWEEN) {
          side_[g] = side_[reached[i]];
          reached.push_back(g);
        }
      }
    for (Index f : faces)
      if (side_[f] == BETWEEN) // nothing was reached
        side_[f] = REST;
  }

  // Adds the faces of one side that are connected with a face, to those that this flood reached.
  void flood(Index first)
  {
    std::size_t next = reached_.size();
    reached_.push_back(first);
    flood_[first] = number_of_floods_;
    for (; next < reached_.size(); ++next)
      for (Index h = 3 * reached_[next]; h < 3 * reached_[next] + 3; ++h) {
        const Index g = mesh_.halfedges[h].neighbor;
        if (side_[g] == side_[first] && flood_[g] != number_of_floods_) {
          flood_[g] = number_of_floods_;
          reached_.push_back(g);
        }
      }
  }

  void start_flood()
  {
    reached_.clear();
    ++number_of_floods_;
  }

  // The connected sets of faces on a side of a connected part, but for the largest, go to the other
  // side.
  void keep_largest(const Faces& faces, Side given)
  {
    start_flood();
    std::vector<std::size_t> first_of_set; // in reached_
    std::vector<double> areas;
    for (Index f : faces) {
      if (side_[f] != given || flood_[f] == number_of_floods_)
        continue;
      first_of_set.push_back(reached_.size());
      flood(f);
      areas.push_back(0);
      for (std::size_t i = first_of_set.back(); i < reached_.size(); ++i)
        areas.back() += mesh_.areas[reached_[i]];
    }
    if (areas.size() < 2)
      return;
    const std::size_t largest = std::max_element(areas.begin(), areas.end()) - areas.begin();
    first_of_set.push_back(reached_.size());
    for (std::size_t i = 0; i < reached_.size(); ++i)
      if (i < first_of_set[largest] || i >= first_of_set[largest + 1])
        side_[reached_[i]] = given == Q ? REST : Q;
  }

  // A side on which no face is gets one, without which the part is still connected.
  void keep_both_sides(const Faces& faces)
  {
    const Side first = static_cast<Side>(side_[*faces.begin()]);
    if (std::any_of(faces.begin(), faces.end(), [&](Index f) { return side_[f] != first; }))
      return;
    start_flood();
    flood(*faces.begin());
    side_[reached_.back()] = first == Q ? REST : Q;
  }

  Sides sides(std::size_t node, const Faces& faces)
  {
    if (set_sure_sides(node, faces))
      divide_band(faces);
    else
      grow_sides(node, faces);
    keep_largest(faces, Q);
    keep_largest(faces, REST);
    keep_both_sides(faces);
    Sides result;
    result.reserve(faces.size());
    for (Index f : faces) {
      result.push_back(side_[f]);
      side_[f] = OUTSIDE;
    }
    return result;
  }

public:
  Cut_transfer(const Segment_tree& cuts, const Simplified_mesh& simplified,
               const Face_dual_graph& mesh)
    : cuts_(cuts), simplified_(simplified), mesh_(mesh),
      number_in_bands_(mesh.number_of_faces(), null_index), side_(mesh.number_of_faces(), OUTSIDE),
      flood_(mesh.number_of_faces(), 0)
  {}

  template <class ConcurrencyTag>
  Segment_tree operator()(const Options& options)
  {
    std::size_t number_of_components;
    std::vector<Index> component;
    for_each_index<ConcurrencyTag>(2, [&](std::size_t task) {
      if (task == 0)
        set_bands<ConcurrencyTag>(options);
      else
        component = connected_components(mesh_, number_of_components);
    });
    Segment_tree tree(component, component_areas(mesh_, component, number_of_components),
                      mesh_.unit, options);
    tree.is_whole_ = cuts_.is_whole_;

    std::vector<std::size_t> same(cuts_.number_of_nodes(), Segment_tree::null_node); // in the tree
    bool is_complete = true;
    for (std::size_t i = 0; i < cuts_.number_of_roots(); ++i)
      same[i] = component[simplified_.faces[*cuts_.faces(i).begin()]];
    for (std::size_t i = cuts_.number_of_roots(); i < cuts_.number_of_nodes(); i += 2) {
      const std::size_t cut = cuts_.node(i).parent, node = same[cut];
      if (node == Segment_tree::null_node)
        continue;
      Sides side = sides(cut, tree.faces(node));
      double area[2] = {0, 0};
      std::size_t number[2] = {0, 0}, k = 0;
      for (Index f : tree.faces(node)) {
        area[int(side[k])] += mesh_.areas[f];
        ++number[int(side[k++])];
      }
      // Of a part that has one face left there is nothing to cut.
      if (number[0] == 0 || number[1] == 0) {
        same[cuts_.node(cut).children[number[0] == 0 ? 1 : 0]] = node;
        is_complete = false;
        continue;
      }
      const bool is_swapped = area[0] > area[1];
      put_smaller_side_first(side, area);
      tree.cut(node, side, area);
      for (int s = 0; s < 2; ++s)
        same[cuts_.node(cut).children[s]] = tree.node(node).children[is_swapped ? 1 - s : s];
    }
    for (std::size_t i = 0; i < cuts_.number_of_nodes(); ++i)
      if (same[i] != Segment_tree::null_node) {
        tree.set_cut(same[i], cuts_.node(i).cut_state, cuts_.node(i).salience,
                     cuts_.node(i).factors);
        tree.areas_[same[i]] = cuts_.areas_[i]; // by which the run chose what to cut next
      }
    if (!is_complete) // no more segments than there are can be asked for
      tree.maximum_number_of_segments_ =
        (std::min)(tree.maximum_number_of_segments_, tree.number_of_segments());
    return tree;
  }
};

// From the mesh on which they were searched to the whole mesh.
template <class ConcurrencyTag>
Segment_tree transfer_cuts(Segment_tree tree, const Initial_mesh& mesh, const Options& options)
{
  for (std::size_t i = mesh.simplified.size(); i-- > 0;)
    tree = Cut_transfer(tree, mesh.simplified[i],
                        i > 0 ? mesh.simplified[i - 1].graph : mesh.graph)
             .template operator()<ConcurrencyTag>(options);
  return tree;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_TRANSFER_H
