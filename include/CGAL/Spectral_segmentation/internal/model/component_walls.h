// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_COMPONENT_WALLS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_COMPONENT_WALLS_H

#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>
#include <CGAL/Spectral_segmentation/internal/surface/Face_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Finds the components that are walls of other components. A closed component whose faces point
// inward, inside a solid whose faces point outward, bounds a cavity of the solid. A component at a
// small, nearly constant distance from another one, along most of the area of both, is its second
// wall. So is the coarser of two copies, such as levels of detail: solids of about the same volume,
// most of it in common. A solid with other solids inside has no cavities, because parts of an
// assembled model may be mirrored by mistake.
class Wall_finder
{
  static constexpr double largest_distance = 0.02; // relative to the diagonal of the outer wall
  static constexpr double largest_distance_of_copy = 0.01;
  static constexpr double least_area_of_outer_wall = 0.01; // relative to the area of the model
  static constexpr std::size_t number_of_samples = 100;

  struct Component
  {
    std::vector<Index> faces;
    double area = 0;
    Bounding_box box{{}};
    std::vector<Triangle> triangles; // filled with the tree
    std::unique_ptr<Face_tree> tree;

    double diagonal() const { return (box.largest - box.smallest).norm(); }
  };

  // The distances of samples of a component from another component.
  struct Distances
  {
    std::vector<double> sorted;
    std::size_t number_inside = 0; // samples behind the nearest face
  };

  const Surface& surface_;
  const std::vector<double>& volume_; // one per component, negative if its faces pointed inward
  std::vector<Component> components_;

  Triangle triangle(Index f) const
  {
    const Corners& c = surface_.corners[f];
    return {surface_.points[c[0]], surface_.points[c[1]], surface_.points[c[2]]};
  }

  // Returns points that are spread evenly over a component.
  std::vector<Vector> samples(const Component& c) const
  {
    std::vector<Vector> result;
    double sum = 0; // the area so far
    for (Index f : c.faces) {
      sum += surface_.areas[f];
      const Triangle t = triangle(f);
      while (result.size() < number_of_samples &&
             (static_cast<double>(result.size()) + 0.5) * c.area < number_of_samples * sum) {
        const double i = static_cast<double>(result.size()); // index in a low-discrepancy sequence
        double u = std::fmod(0.5 + i * 0.7548776662466927, 1.),
               v = std::fmod(0.5 + i * 0.5698402909980532, 1.);
        if (u + v > 1) {
          u = 1 - u;
          v = 1 - v;
        }
        result.push_back(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
      }
    }
    return result;
  }

  const Face_tree& tree(Component& c) const
  {
    if (!c.tree) {
      for (Index f : c.faces)
        c.triangles.push_back(triangle(f));
      c.tree = std::make_unique<Face_tree>(c.triangles);
    }
    return *c.tree;
  }

  Distances distances(Index from, Index to)
  {
    const Face_tree& tree = this->tree(components_[to]);
    Distances result;
    for (const Vector& p : samples(components_[from])) {
      const Triangle& t = components_[to].triangles[tree.nearest(p, Vector(), 0)];
      result.sorted.push_back(std::sqrt(squared_distance_to_triangle(p, t)));
      result.number_inside += triangle_normal(t).dot(p - t[0]) < 0;
    }
    std::sort(result.sorted.begin(), result.sorted.end());
    return result;
  }

  // Returns whether the box of a component is inside the box of another one.
  bool may_be_inside(Index inner, Index outer) const
  {
    const Bounding_box &a = components_[inner].box, &b = components_[outer].box;
    bool result = true;
    for (int i = 0; i < 3; ++i)
      result = result && b.smallest[i] <= a.smallest[i] && a.largest[i] <= b.largest[i];
    return result;
  }

  // Returns whether the boxes of two components are about equal.
  bool may_be_walls(Index inner, Index outer) const
  {
    const Bounding_box &a = components_[inner].box, &b = components_[outer].box;
    const double tolerance = 2 * largest_distance * components_[outer].diagonal();
    bool result = true;
    for (int i = 0; i < 3; ++i)
      result = result && std::abs(b.smallest[i] - a.smallest[i]) <= tolerance &&
               std::abs(b.largest[i] - a.largest[i]) <= tolerance;
    return result;
  }

  bool is_inside(Index inner, Index outer)
  {
    if (!may_be_inside(inner, outer))
      return false;
    const Distances there = distances(inner, outer);
    return 10 * there.number_inside > 9 * there.sorted.size();
  }

  // Returns whether most of the distances between two components are at most this.
  static bool are_near(const Distances& there, const Distances& back, double most)
  {
    return there.sorted[there.sorted.size() * 4 / 5] <= most &&
           back.sorted[back.sorted.size() * 4 / 5] <= most;
  }

  // Returns whether the distances between two components are small and nearly constant over most of
  // their areas. Where a limb is thinner than the distance, its inner wall comes nearer to the
  // outer wall. The outer wall is closed and has the second wall inside, unless both coincide:
  // sheets that lie on each other, and clothes on a body, are not walls.
  bool is_second_wall(Index inner, Index outer)
  {
    if (!may_be_walls(inner, outer))
      return false;
    const Distances there = distances(inner, outer), back = distances(outer, inner);
    if (there.sorted.empty() || back.sorted.empty())
      return false;
    const double distance = back.sorted[back.sorted.size() / 2];
    const double diagonal = components_[outer].diagonal(), tiny = 1e-3 * diagonal;
    const bool is_behind = volume_[outer] != 0 && 2 * there.number_inside > there.sorted.size();
    return (is_behind || distance <= tiny) && distance <= largest_distance * diagonal &&
           are_near(there, back, 1.5 * distance + tiny);
  }

  // Returns whether two solids have about the same volume, most of it in common, and whether most
  // of each is near the other. Thin plates on each other have nothing in common.
  bool are_copies(Index a, Index b)
  {
    const double ratio = volume_[a] / volume_[b]; // negative for an inner wall
    if (!(ratio > 0.8 && ratio < 1.25) || !may_be_walls(a, b))
      return false;
    const Distances there = distances(a, b), back = distances(b, a);
    return !there.sorted.empty() && !back.sorted.empty() &&
           4 * (there.number_inside + back.number_inside) > 3 * there.sorted.size() &&
           are_near(there, back, largest_distance_of_copy * components_[b].diagonal());
  }

  // Returns for each closed component the smallest that contains it, or null_index.
  std::vector<Index> containers(const std::vector<Index>& order, double least_area)
  {
    std::vector<Index> result(components_.size(), null_index), closed; // the largest first
    for (Index c : order)
      if (volume_[c] != 0) {
        const auto container = std::find_if(closed.rbegin(), closed.rend(),
                                            [&](Index o) { return is_inside(c, o); });
        result[c] = container == closed.rend() ? null_index : *container;
        if (components_[c].area >= least_area)
          closed.push_back(c);
      }
    return result;
  }

public:
  // Takes a surface whose faces have areas and whose components enclose these volumes. Faces of
  // closed components point outward now; the volumes of those that pointed inward are negative.
  Wall_finder(const Surface& surface, const std::vector<double>& volume)
    : surface_(surface), volume_(volume), components_(surface.components.number)
  {
    for (Index f = 0; f < surface.number_of_faces(); ++f) {
      Component& c = components_[surface.components[f]];
      c.faces.push_back(f);
      c.area += surface.areas[f];
      for (const Vector& p : triangle(f))
        c.box.add(p);
    }
  }

  // Maps each component that is a wall of another one to that component, which is not a wall
  // itself, and all others to null_index.
  std::vector<Index> operator()(const std::vector<char>& may_be_wall)
  {
    double area = 0;
    for (const Component& c : components_)
      area += c.area;
    const double least_area = least_area_of_outer_wall * area;
    std::vector<Index> order = first_indices(components_.size());
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b)
      { return components_[a].area > components_[b].area; });

    std::vector<Index> container(components_.size(), null_index);
    if (std::any_of(volume_.begin(), volume_.end(), [](double v) { return v < 0; }))
      container = containers(order, least_area);
    std::vector<char> has_solid(components_.size(), 0); // contains a solid: has no cavity
    for (Index c : order)
      if (volume_[c] > 0 && container[c] != null_index)
        has_solid[container[c]] = 1;

    std::vector<Index> result(components_.size(), null_index), outer_walls; // the largest first
    for (Index c : order) {
      const Index solid = volume_[c] < 0 ? container[c] : null_index;
      const auto copy = std::find_if(outer_walls.begin(), outer_walls.end(),
                                     [&](Index o) { return are_copies(c, o); });
      if (copy != outer_walls.end() && may_be_wall[*copy] &&
          components_[c].faces.size() > components_[*copy].faces.size()) {
        std::replace(result.begin(), result.end(), *copy, c);
        result[*copy] = c;
        *copy = c;
        continue;
      }
      if (may_be_wall[c] && solid != null_index && volume_[solid] > 0 && !has_solid[solid])
        result[c] = result[solid] == null_index ? solid : result[solid];
      else if (may_be_wall[c] && copy != outer_walls.end())
        result[c] = *copy;
      else if (may_be_wall[c]) {
        const auto outer = std::find_if(outer_walls.rbegin(), outer_walls.rend(),
                                        [&](Index o) { return is_second_wall(c, o); });
        result[c] = outer == outer_walls.rend() ? null_index : *outer;
      }
      if (result[c] == null_index && components_[c].area >= least_area)
        outer_walls.push_back(c);
    }
    return result;
  }

  // Returns the face of a component that is nearest to the centroid of a face.
  Index nearest_face(Index component, Index f)
  {
    Component& c = components_[component];
    return c.faces[tree(c).nearest(surface_.centroid(f), Vector(), 0)];
  }
};

// Makes the faces of walls in each set of a tree connected, from the roots on. Pieces that are
// disconnected from their side of a cut go to the other side.
class Wall_labels
{
  typedef std::vector<Index> Faces;
  typedef const Merged_set* Node;

  const Surface& walls_;           // each component is a wall
  const Merged_sets sets_;         // the sets of the outer walls
  Faces& leaf_;                    // one per face
  std::vector<Node> node_;         // one per face: a side of the current cut
  std::vector<std::pair<Node, Faces> > connected_; // faces to divide further, and their node

  // Returns the connected pieces of the faces of a node.
  std::vector<Faces> pieces(const Faces& faces, Node node)
  {
    std::vector<Faces> result;
    for (Index first : faces)
      if (node_[first] == node) {
        Faces piece(1, first);
        node_[first] = nullptr;
        for (std::size_t i = 0; i < piece.size(); ++i)
          for (Index h = 3 * piece[i]; h < 3 * piece[i] + 3; ++h)
            if (const Index g = walls_.neighbor(h); node_[g] == node) {
              node_[g] = nullptr;
              piece.push_back(g);
            }
        result.push_back(std::move(piece));
      }
    for (const Faces& piece : result)
      for (Index f : piece)
        node_[f] = node;
    return result;
  }

  double area(const Faces& faces) const
  {
    double result = 0;
    for (Index f : faces)
      result += walls_.areas[f];
    return quantized(result);
  }

  // Moves a piece to the face of another node beside which it has the longest boundary.
  void move(const Faces& piece)
  {
    const Node node = node_[piece.front()];
    std::map<Index, std::pair<double, Index> > boundary; // its length, and a face, for each leaf
    for (Index f : piece)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (const Index g = walls_.neighbor(h); node_[g] != node && node_[g] != nullptr) {
          boundary[leaf_[g]].first += walls_.length(h);
          boundary[leaf_[g]].second = g;
        }
    const Index g =
      std::max_element(boundary.begin(), boundary.end(), [](const auto& a, const auto& b)
        { return quantized(a.second.first) < quantized(b.second.first); })->second.second;
    for (Index f : piece) {
      node_[f] = node_[g];
      leaf_[f] = leaf_[g];
    }
  }

  // Divides connected faces among nodes. Moves all pieces of a node except the largest.
  void divide(const Faces& faces, const std::vector<Node>& nodes)
  {
    for (Node node : nodes)
      for (Index f : faces)
        if (sets_.position[leaf_[f]] - node->first < node->size()) // wraps around if it is less
          node_[f] = node;
    for (Node node : nodes) {
      const std::vector<Faces> all = pieces(faces, node);
      const auto largest = std::max_element(all.begin(), all.end(),
        [&](const Faces& a, const Faces& b) { return area(a) < area(b); });
      for (auto piece = all.begin(); piece != all.end(); ++piece)
        if (piece != largest)
          move(*piece);
    }
    for (Node node : nodes)
      if (std::vector<Faces> all = pieces(faces, node); !all.empty())
        connected_.emplace_back(node, std::move(all.front()));
    for (Index f : faces)
      node_[f] = nullptr;
  }

public:
  // Takes the leaf of the nearest face of an outer wall for each face, which it changes.
  Wall_labels(const Surface& walls, const Merge_tree& tree, std::vector<Index>& leaf)
    : walls_(walls), sets_(tree), leaf_(leaf), node_(leaf.size(), nullptr) {}

  void operator()()
  {
    std::vector<Faces> walls(walls_.components.number);
    for (Index f = 0; f < leaf_.size(); ++f)
      walls[walls_.components[f]].push_back(f);
    std::vector<Node> roots;
    for (const Merged_set& root : sets_.roots)
      roots.push_back(&root);
    for (const Faces& wall : walls)
      divide(wall, roots);
    while (!connected_.empty()) {
      const auto [node, faces] = std::move(connected_.back());
      connected_.pop_back();
      if (node->merge != null_index)
        divide(faces, {&sets_.sides[node->merge][0], &sets_.sides[node->merge][1]});
    }
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MODEL_COMPONENT_WALLS_H
