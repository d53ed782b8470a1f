// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_TRANSFER_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_TRANSFER_H

#include <CGAL/Spectral_segmentation/Segment_tree.h>
#include <CGAL/Spectral_segmentation/internal/Cut.h>
#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/initialization.h>
#include <CGAL/Spectral_segmentation/internal/minimum_cut.h>
#include <CGAL/Spectral_segmentation/internal/options.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>
#include <CGAL/Spectral_segmentation/internal/simplification.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// Carries the cuts of a simplified mesh over to the mesh itself. A face is on the side on which all
// faces around its three vertices are, as the simplified mesh has them. Those between, which are a
// band around the cut, are divided by the minimum cut.
class Cut_transfer
{
  const Segment_tree& cuts_;
  const Simplified_mesh& simplified_;
  const Face_dual_graph& mesh_;
  Face_dual_graph bands_;              // the faces that may be between, and those next to them
  std::vector<Index> number_in_bands_; // of each face; null_index if it is not there

  Index vertex(Index f, int i) const { return simplified_.vertices[mesh_.corners[f][i]]; }

  // For each vertex of the simplified mesh what its faces have in common, joined with `join`; each
  // face gives a value or none.
  template <class ValueOf, class Join>
  std::vector<Index> of_vertices(const ValueOf& value_of, const Join& join) const
  {
    const Face_dual_graph& graph = simplified_.graph;
    std::vector<Index> result(graph.points.size(), null_index);
    for (Index f = 0; f < graph.number_of_faces(); ++f)
      if (value_of(f) != null_index)
        for (Index v : graph.corners[f])
          result[v] = result[v] == null_index ? value_of(f) : join(result[v], value_of(f));
    return result;
  }

  std::vector<char> are_between() const
  {
    std::vector<Index> leaf(simplified_.graph.number_of_faces());
    for (std::size_t i = 0; i < cuts_.number_of_nodes(); ++i)
      if (cuts_.node(i).is_leaf())
        for (Index f : cuts_.faces(i))
          leaf[f] = static_cast<Index>(i);
    const Index several = null_index - 1;
    const std::vector<Index> of_vertex = of_vertices(
      [&](Index f) { return leaf[f]; }, [](Index a, Index b) { return a == b ? a : several; });
    std::vector<char> result(mesh_.number_of_faces());
    for (Index f = 0; f < result.size(); ++f) {
      const Index a = of_vertex[vertex(f, 0)], b = of_vertex[vertex(f, 1)],
                  c = of_vertex[vertex(f, 2)];
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
    const double radius =
      area > 0 ? options.concavity_radius * std::sqrt(total_area(mesh_) / area) : 0;
    set_face_distances<ConcurrencyTag>(bands_, bands_.points, face_normals(bands_, bands_.points),
                                       {options.geodesic_weight, options.concave_angle_weight,
                                        options.convex_angle_weight, radius});
  }

  // The sides of the faces of a node; 2 for those between.
  template <class Faces>
  Sides sure_sides(std::size_t node, const Faces& faces) const
  {
    std::vector<Index> side(simplified_.graph.number_of_faces(), null_index);
    for (Index s = 0; s < 2; ++s)
      for (Index f : cuts_.faces(cuts_.node(node).children[s]))
        side[f] = s + 1;
    const std::vector<Index> of_vertex =
      of_vertices([&](Index f) { return side[f]; }, [](Index a, Index b) { return a | b; });
    Sides result;
    result.reserve(faces.size());
    bool has_side[2] = {false, false};
    for (Index f : faces) {
      Index sides = 0;
      for (int i = 0; i < 3; ++i)
        if (of_vertex[vertex(f, i)] != null_index)
          sides |= of_vertex[vertex(f, i)];
      // Faces that connect() brought here, of which the simplified mesh knows nothing, are on any
      // side; it will do so again.
      result.push_back(sides == 3 ? 2 : sides == 2 ? 1 : 0);
      if (sides == 1 || sides == 2)
        has_side[sides - 1] = true;
    }
    // A side so thin that all is between has the faces that are left of it in the simplified mesh.
    for (Index s = 0; s < 2; ++s)
      if (!has_side[s])
        for (Index g : cuts_.faces(cuts_.node(node).children[s])) {
          const auto f = std::lower_bound(faces.begin(), faces.end(), simplified_.faces[g]);
          if (f != faces.end() && *f == simplified_.faces[g])
            result[static_cast<std::size_t>(f - faces.begin())] = static_cast<char>(s);
        }
    return result;
  }

  template <class Faces>
  void divide_band(const Faces& faces, Sides& side) const
  {
    Sides in_bands(bands_.number_of_faces(), 2);
    std::vector<Index> band;
    std::size_t i = 0;
    for (Index f : faces) {
      const Index b = number_in_bands_[f];
      if (b != null_index)
        in_bands[b] = side[i];
      if (side[i] == 2) {
        band.push_back(b);
        in_bands[b] = 0;
      }
      ++i;
    }
    in_bands = minimum_cut_within(bands_, band, in_bands);
    i = 0;
    for (Index f : faces) {
      if (side[i] == 2)
        side[i] = in_bands[number_in_bands_[f]];
      ++i;
    }
  }

  // The connected sets of faces of a connected part with the same side, but for the largest on
  // `given`, go to the other side.
  template <class Faces>
  void keep_largest(const Faces& faces, char given, std::vector<char>& side_of_face) const
  {
    constexpr char met = 3;
    std::vector<Index> largest;
    double largest_area = -1;
    std::vector<std::vector<Index> > others;
    for (Index first : faces) {
      if (side_of_face[first] != given)
        continue;
      std::vector<Index> set(1, first);
      side_of_face[first] = met;
      double area = 0;
      for (std::size_t i = 0; i < set.size(); ++i) {
        area += mesh_.areas[set[i]];
        for (Index h = 3 * set[i]; h < 3 * set[i] + 3; ++h) {
          const Index g = mesh_.halfedges[h].neighbor;
          if (side_of_face[g] == given) {
            side_of_face[g] = met;
            set.push_back(g);
          }
        }
      }
      if (area > largest_area) {
        largest.swap(set);
        largest_area = area;
      }
      others.push_back(std::move(set));
    }
    for (Index f : largest)
      side_of_face[f] = given;
    for (const std::vector<Index>& set : others)
      for (Index f : set)
        side_of_face[f] = static_cast<char>(1 - given);
  }

  template <class Faces>
  void connect(const Faces& faces, std::vector<char>& side_of_face, Sides& side) const
  {
    std::size_t i = 0;
    for (Index f : faces)
      side_of_face[f] = side[i++];
    keep_largest(faces, 0, side_of_face);
    keep_largest(faces, 1, side_of_face);
    i = 0;
    for (Index f : faces) {
      side[i++] = side_of_face[f];
      side_of_face[f] = 2;
    }
  }

public:
  Cut_transfer(const Segment_tree& cuts, const Simplified_mesh& simplified,
               const Face_dual_graph& mesh)
    : cuts_(cuts), simplified_(simplified), mesh_(mesh),
      number_in_bands_(mesh.number_of_faces(), null_index)
  {}

  template <class ConcurrencyTag>
  Segment_tree transfer(const Options& options)
  {
    set_bands<ConcurrencyTag>(options);
    std::size_t number_of_components;
    const std::vector<Index> component = connected_components(mesh_, number_of_components);
    Segment_tree tree(component, component_areas(mesh_, component, number_of_components),
                      mesh_.unit, options);
    tree.is_whole_ = cuts_.is_whole_;
    if (options.boundary_smoothing)
      tree.smooth_boundaries_with(neighbors(mesh_));

    std::vector<std::size_t> node_of(cuts_.number_of_nodes()); // in the tree
    std::vector<std::size_t> in_order; // nodes with children, in the order of the cuts
    for (std::size_t i = 0; i < cuts_.number_of_nodes(); ++i) {
      if (i < cuts_.number_of_roots())
        node_of[i] = component[simplified_.faces[*cuts_.faces(i).begin()]];
      else if ((i - cuts_.number_of_roots()) % 2 == 0)
        in_order.push_back(cuts_.node(i).parent);
    }
    std::vector<char> side_of_face(mesh_.number_of_faces(), 2);
    for (std::size_t i : in_order) {
      const auto faces = tree.faces(node_of[i]);
      Sides side = sure_sides(i, faces);
      divide_band(faces, side);
      connect(faces, side_of_face, side);
      double area[2] = {0, 0};
      std::size_t k = 0;
      for (Index f : faces)
        area[int(side[k++])] += mesh_.areas[f];
      const int first = area[0] <= area[1] ? 0 : 1;
      put_smaller_side_first(side, area);
      tree.cut(node_of[i], side, area);
      for (int s = 0; s < 2; ++s)
        node_of[cuts_.node(i).children[s]] =
          tree.node(node_of[i]).children[first == 0 ? s : 1 - s];
    }
    for (std::size_t i = 0; i < cuts_.number_of_nodes(); ++i) {
      const Segment_tree::Node& n = cuts_.node(i);
      tree.set_cut(node_of[i], n.cut_state, n.salience, n.factors);
    }
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
             .template transfer<ConcurrencyTag>(options);
  return tree;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_CUT_TRANSFER_H
