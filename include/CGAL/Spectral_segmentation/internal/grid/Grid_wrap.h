// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_GRID_WRAP_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_GRID_WRAP_H

#include <CGAL/Spectral_segmentation/internal/distances/laplacian_smoothing.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/grid/Grid.h>
#include <CGAL/Spectral_segmentation/internal/grid/Nearest_elements.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/surface/surface_integrals.h>
#include <CGAL/Spectral_segmentation/internal/grid/triangle_geometry.h>
#include <CGAL/Spectral_segmentation/internal/grid/surface_nets.h>
#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A closed surface around any set of triangles. It is the boundary of the space that is within a
// distance of them, or enclosed by such space, on a grid in their frame. Components that
// are nearer to each other than twice this distance become one. Cracks, holes, orientations and the
// inside vanish.
class Grid_wrap
{
  static constexpr double cells_per_deviation = 46; // about 150 along the diagonal of the shape
  static constexpr double most_cells = 400;         // along it, if few large faces deviate little
  static constexpr double offset = 1.2;             // the distance, in cells
  static constexpr int margin = 5;                  // cells beside the shape, where all is outside
  static constexpr double largest_number_of_nodes = 1 << 23;
  static constexpr double length_of_pieces = 1.5;   // pieces of faces, in cells
  static constexpr std::size_t number_of_smoothing_iterations = 2;

  const Surface& mesh_;
  double cell_; // the length of a cell
  std::vector<Vector> points_; // the points of the mesh, in cells
  std::optional<Grid> grid_;
  std::vector<char> is_near_;       // nodes near the mesh or inside the surface
  Surface surface_;
  std::vector<Index> nearest_face_; // a face of the mesh near each face of the surface
  std::vector<Vector> vertices_;    // the vertices of the surface, in cells

  void set_points(Execution execution)
  {
    points_ = mesh_.points;
    const double area = total_area(mesh_);
    const double variance = mean_over_surface<double>(execution, mesh_, area, [&](const Vector& p)
      { return p.squared_norm(); });
    const Bounding_box box(points_);
    cell_ = (std::max)(std::sqrt(variance) / cells_per_deviation,
                       (box.largest - box.smallest).norm() / most_cells);
    const auto number_of_nodes = [&] {
      Bounding_box in_cells = box;
      in_cells.smallest = box.smallest / cell_;
      in_cells.largest = box.largest / cell_;
      return Grid::number_of_nodes(in_cells, margin);
    };
    while (number_of_nodes() > largest_number_of_nodes)
      cell_ *= 1.25;
    for_each_index(execution, points_.size(), [&](std::size_t v) {
      for (int i = 0; i < 3; ++i)
        points_[v][i] = quantized(points_[v][i] / cell_);
    });
    grid_.emplace(Bounding_box(points_), margin);
  }

  Triangle triangle(Index f) const
  {
    const Corners& c = mesh_.corners[f];
    return {points_[c[0]], points_[c[1]], points_[c[2]]};
  }

  // Calls f(node) for the nodes of the cells around a piece of a face.
  template <class Function>
  void for_each_node_around(const Triangle& piece, const Function& f) const
  {
    const Bounding_box box({piece[0], piece[1], piece[2]});
    const Index first = grid_->cell(box.smallest), last = grid_->cell(box.largest);
    Index number[3];
    for (int i = 0; i < 3; ++i)
      number[i] = grid_->coordinate(last, i) - grid_->coordinate(first, i) + 2;
    for (Index k = 0; k < number[2]; ++k)
      for (Index j = 0; j < number[1]; ++j)
        for (Index i = 0; i < number[0]; ++i)
          f(first + i + j * grid_->stride(1) + k * grid_->stride(2));
  }

  void set_surface(Execution execution)
  {
    const auto squared_distance = [this](Index f, const Vector& p)
    { return squared_distance_to_triangle(p, triangle(f)); };
    // Nodes next to the surface need no larger distances.
    const auto reaches = [](Index, float d) { return d < (offset + 1.1) * (offset + 1.1); };
    Nearest_elements<decltype(squared_distance), decltype(reaches)>
      nearest(*grid_, squared_distance, reaches);
    for (Index f = 0; f < mesh_.number_of_faces(); ++f)
      for_each_piece(triangle(f), length_of_pieces, [&](const Triangle& piece, double)
        { for_each_node_around(piece, [&](Index node) { nearest.offer(node, f); }); });
    nearest.propagate();

    const Index n = grid_->number_of_nodes();
    std::vector<char> is_outside(n, 0);
    std::vector<Index> reached(1, 0);
    is_outside[0] = 1;
    const auto is_far = [&](Index node)
    { return nearest.element(node) == null_index ||
             nearest.squared_distance(node) >= offset * offset; };
    for (std::size_t i = 0; i < reached.size(); ++i)
      grid_->for_each_neighbor(reached[i], [&](Index node) {
        if (!is_outside[node] && is_far(node)) {
          is_outside[node] = 1;
          reached.push_back(node);
        }
      });
    is_near_.resize(n);
    for (Index node = 0; node < n; ++node)
      is_near_[node] = !is_outside[node] || nearest.element(node) != null_index;
    Grid_function values(n);
    for (Index node = 0; node < n; ++node) {
      constexpr float smallest = 0.02f;
      const float distance = nearest.element(node) == null_index
        ? 1.f : std::abs(std::sqrt(nearest.squared_distance(node)) - static_cast<float>(offset));
      values[node] = (is_outside[node] ? 1 : -1) * std::clamp(distance, smallest, 1.f);
    }
    Well_composed_solid(*grid_, values)();
    surface_ = Surface_nets(*grid_, values)();
    vertices_ = surface_.points;
    for (const Corners& c : surface_.corners) {
      Index face = null_index;
      for (Index node : grid_->corners(grid_->cell(vertices_[c[0]])))
        if (nearest.element(node) != null_index)
          face = nearest.element(node);
      nearest_face_.push_back(face == null_index ? 0 : face);
    }
    for (Vector& p : surface_.points)
      p = cell_ * p;
    surface_.components = connected_components(surface_);
    surface_.points = smoothed_points(surface_, number_of_smoothing_iterations);
    set_areas(execution, surface_);
  }

public:
  Grid_wrap(Execution execution, const Surface& mesh) : mesh_(mesh)
  {
    set_points(execution);
    set_surface(execution);
  }

  const Surface& surface() const { return surface_; }

  // Returns a face of the mesh near each face of the surface.
  const std::vector<Index>& nearest_faces() const { return nearest_face_; }

  // Calls f(face of the mesh, fraction of the face, vertex of the surface) for pieces of the faces
  // and the nearest vertex of each piece.
  template <class Function>
  void for_each_piece_and_vertex(const Function& f) const
  {
    const auto squared_distance = [this](Index v, const Vector& p)
    { return (p - vertices_[v]).squared_norm(); };
    const auto reaches = [this](Index node, float) { return is_near_[node] != 0; };
    Nearest_elements<decltype(squared_distance), decltype(reaches)>
      nearest(*grid_, squared_distance, reaches);
    for (Index v = 0; v < vertices_.size(); ++v)
      for (Index node : grid_->corners(grid_->cell(vertices_[v])))
        nearest.offer(node, v);
    nearest.propagate();
    for (Index face = 0; face < mesh_.number_of_faces(); ++face)
      for_each_piece(triangle(face), length_of_pieces, [&](const Triangle& piece, double share) {
        const Vector p = (piece[0] + piece[1] + piece[2]) / 3;
        Index vertex = null_index;
        double least = 0;
        for (Index node : grid_->corners(grid_->cell(p))) {
          const Index v = nearest.element(node);
          const double d = squared_distance(v, p);
          if (vertex == null_index || d < least) {
            vertex = v;
            least = d;
          }
        }
        f(face, share, vertex);
      });
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_GRID_GRID_WRAP_H
