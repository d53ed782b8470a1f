// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_BAND_CELLS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_BAND_CELLS_H

#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The leaves of a tree that each element touches, with its fraction in each leaf.
class Leaf_fractions
{
public:
  struct Fraction
  {
    Index leaf;
    float fraction;
  };

private:
  std::vector<Fraction> fractions_; // grouped by element
  std::vector<Index> first_ = {0};  // one per element, and the end

  const Fraction* begin(std::size_t element) const { return fractions_.data() + first_[element]; }

public:
  // Adds an element without fractions.
  void add_element() { first_.push_back(first_.back()); }

  // Adds to the fraction of the last element in a leaf.
  void add(Index leaf, float fraction)
  {
    const auto first = fractions_.begin() + static_cast<std::ptrdiff_t>(first_[first_.size() - 2]);
    const auto found = std::find_if(first, fractions_.end(),
                                    [leaf](const Fraction& f) { return f.leaf == leaf; });
    if (found != fractions_.end())
      found->fraction += fraction;
    else {
      fractions_.push_back({leaf, fraction});
      ++first_.back();
    }
  }

  std::size_t number_of_elements() const { return first_.size() - 1; }

  // Returns whether each element touches only one leaf.
  bool are_undivided() const { return fractions_.size() == number_of_elements(); }

  Iterator_range<const Fraction*> operator[](std::size_t element) const
  { return make_range(begin(element), begin(element + 1)); }
};

// Returns the fractions of the vertices of a coarse surface in the leaves of the faces around them.
inline Leaf_fractions vertex_fractions(const Surface& coarse, const std::vector<Index>& leaf)
{
  std::vector<Packed_graph::Ends> corners;
  corners.reserve(3 * leaf.size());
  for (Index f = 0; f < leaf.size(); ++f)
    for (Index v : coarse.corners[f])
      corners.emplace_back(v, leaf[f]);
  std::vector<Index> position;
  const Packed_graph leaves(coarse.points.size(), corners, position);
  Leaf_fractions result;
  for (Index v = 0; v < coarse.points.size(); ++v) {
    result.add_element();
    const Index first = leaves.first_arc[v], end = leaves.first_arc[v + 1];
    for (Index i = first; i < end; ++i)
      result.add(leaves.targets[i], 1 / static_cast<float>(end - first));
  }
  return result;
}

// Returns the fractions, as areas, of the n faces of a surface in the leaves of a subdivision.
inline Leaf_fractions face_fractions(const Level& subdivision, const std::vector<Index>& leaf,
                                     std::size_t n)
{
  std::vector<Packed_graph::Ends> ends;
  for (Index f = 0; f < leaf.size(); ++f)
    ends.emplace_back(subdivision.parent_face[f], f);
  std::vector<Index> position;
  const Packed_graph faces(n, ends, position);
  Leaf_fractions result;
  for (Index parent = 0; parent < n; ++parent) {
    result.add_element();
    for (Index i = faces.first_arc[parent]; i < faces.first_arc[parent + 1]; ++i) {
      const double area = subdivision.surface.areas[faces.targets[i]];
      result.add(leaf[faces.targets[i]],
                 (std::max)(static_cast<float>(area), (std::numeric_limits<float>::min)()));
    }
  }
  return result;
}

// The leaves of a tree of another surface that the faces of a mesh touch, and the fraction in each.
class Face_fractions
{
  const Surface& mesh_;
  const Level& other_;
  const Leaf_fractions fractions_; // of the faces of a subdivision, else of the coarse vertices

public:
  Face_fractions(const Surface& mesh, const Level& other, const std::vector<Index>& leaf)
    : mesh_(mesh), other_(other),
      fractions_(other.is_subdivision ? face_fractions(other, leaf, mesh.number_of_faces())
                                      : vertex_fractions(other.surface, leaf)) {}

  // Calls visit(leaf, fraction) for each leaf that a face touches, up to three times.
  template <class Visit>
  void for_each(Index f, const Visit& visit) const
  {
    for (int i = 0; i < (other_.is_subdivision ? 1 : 3); ++i) {
      const Index element = other_.is_subdivision ? f : other_.coarse_vertex[mesh_.corners[f][i]];
      for (const auto& [leaf, fraction] : fractions_[element])
        visit(leaf, fraction);
    }
  }
};

// The cells of a mesh, which no cut divides: the single faces of the bands, followed by the cores.
// The bands are the faces that may border a cut, and the faces next to these. A core is a connected
// component of the other faces.
class Band_cells
{
  std::vector<Index> faces_of_bands_;
  std::vector<Index> cell_;       // the cell of each face
  std::vector<Index> first_face_; // one per cell
  std::vector<double> areas_;     // one per cell
  std::optional<Packed_graph> graph_;

  void find_bands(const Surface& mesh, const std::vector<char>& may_border_cut)
  {
    cell_.assign(mesh.number_of_faces(), null_index);
    for (Index f = 0; f < mesh.number_of_faces(); ++f) {
      bool is_needed = may_border_cut[f];
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        is_needed = is_needed || may_border_cut[mesh.neighbor(h)];
      if (is_needed) {
        cell_[f] = static_cast<Index>(faces_of_bands_.size());
        faces_of_bands_.push_back(f);
      }
    }
  }

  void find_cores(const Surface& mesh)
  {
    Disjoint_sets cores(cell_.size());
    for (Index f = 0; f < cell_.size(); ++f)
      if (cell_[f] == null_index)
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
          if (const Index g = mesh.neighbor(h); f < g && cell_[g] == null_index)
            cores.join(f, g);
    first_face_ = faces_of_bands_;
    for (Index f = 0; f < cell_.size(); ++f) {
      if (cell_[f] != null_index)
        continue;
      const Index first = cores.representative(f);
      if (first == f)
        first_face_.push_back(f);
      cell_[f] = first == f ? static_cast<Index>(first_face_.size() - 1) : cell_[first];
    }
  }

public:
  // Makes the cells; `may_border_cut` has a flag for each face.
  Band_cells(const Surface& mesh, const std::vector<char>& may_border_cut)
  {
    find_bands(mesh, may_border_cut);
    find_cores(mesh);
    areas_.assign(first_face_.size(), 0);
    for (Index f = 0; f < cell_.size(); ++f)
      areas_[cell_[f]] += mesh.areas[f];

    std::vector<Packed_graph::Ends> arcs;
    for (Index cell = 0; cell < faces_of_bands_.size(); ++cell)
      for (Index h = 3 * first_face_[cell]; h < 3 * first_face_[cell] + 3; ++h) {
        const Index neighbor = cell_[mesh.neighbor(h)];
        arcs.emplace_back(cell, neighbor);
        if (is_core(neighbor))
          arcs.emplace_back(neighbor, cell);
      }
    std::vector<Index> position;
    graph_.emplace(number(), arcs, position);
  }

  std::size_t number() const { return first_face_.size(); }
  const std::vector<Index>& faces_of_bands() const { return faces_of_bands_; } // ascending
  bool is_core(Index cell) const { return cell >= faces_of_bands_.size(); }
  Index cell_of_face(Index f) const { return cell_[f]; }
  Index first_face(Index cell) const { return first_face_[cell]; }
  double area(Index cell) const { return areas_[cell]; }

  Iterator_range<const Index*> neighbors(Index cell) const
  {
    const Index* targets = graph_->targets.data();
    return make_range(targets + graph_->first_arc[cell], targets + graph_->first_arc[cell + 1]);
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_BAND_CELLS_H
