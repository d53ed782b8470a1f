// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_REFINED_INPUT_H
#define SEGMENT_MESH_REFINED_INPUT_H

#include "read_input.h"

#include <CGAL/Segmented_mesh/refine_segment_boundaries.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace segment_mesh {

// The input with refined boundaries. Polygons that no boundary cuts stay as they are.
struct Refined_input
{
  Input input;
  std::vector<Index> segment; // one per polygon
  std::vector<Index> polygon; // of the input, one per polygon
};

// Refines the boundaries of an input. New points and corners have the means of what the file says
// about the points and corners around them: properties, texture coordinates and normals.
class Input_refinement
{
  typedef std::array<double, 3> Weights;
  typedef std::map<std::array<Index, 4>, Index> Known_means;

  const Input& input_;
  const Polygon_soup& from_;
  Scene scene_;
  Polygon_soup& to_;
  std::vector<Point> points_; // of the refined triangles
  std::vector<Triangle> triangles_;
  std::vector<Index> segment_of_triangle_;
  CGAL::Segmented_mesh::Triangle_refinement refinement_;
  Known_means points_known_, textures_known_, normals_known_;

  // Returns the weights of a new point for the corners of a triangle of the input at whose edge it
  // lies, or in whose middle.
  Weights weights(Index point, std::size_t triangle) const
  {
    const auto& p = refinement_.points[point - from_.points.size()];
    if (p.triangle == triangle)
      return p.weights;
    Weights result = {0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      if (p.weights[k] > 0)
        for (std::size_t i = 0; i < 3; ++i)
          if (input_.triangles[triangle][i] == input_.triangles[p.triangle][k])
            result[i] = p.weights[k];
    return result;
  }

  // Returns the number of a mean of elements at a new point, which `append` appends if it is new,
  // and null_index if an element is missing.
  template <class Append>
  static Index mean(Known_means& known, Index point, const Triangle& elements, const Weights& w,
                    std::size_t size, const Append& append)
  {
    std::array<Index, 4> key = {point, mesh_file::null_index, mesh_file::null_index,
                                mesh_file::null_index};
    for (std::size_t i = 0; i < 3; ++i)
      if (w[i] > 0) {
        if (elements[i] == mesh_file::null_index)
          return mesh_file::null_index;
        key[i + 1] = elements[i];
      }
    std::sort(key.begin() + 1, key.end());
    const auto [place, is_new] = known.emplace(key, static_cast<Index>(size));
    if (is_new)
      append();
    return place->second;
  }

  // Returns the weighted mean of three of the values.
  template <std::size_t n>
  static std::array<double, n> mean(const std::vector<std::array<double, n> >& values,
                                    const Triangle& elements, const Weights& w)
  {
    std::array<double, n> result{};
    for (std::size_t i = 0; i < 3; ++i)
      if (w[i] > 0)
        for (std::size_t k = 0; k < n; ++k)
          result[k] += w[i] * values[elements[i]][k];
    return result;
  }

  Index new_point(Index v, const Triangle& corners, const Weights& w)
  {
    return mean(points_known_, v, corners, w, to_.points.size(), [&] {
      to_.points.push_back(points_[v]);
      for (mesh_file::Property& p : to_.point_properties) {
        double value = 0;
        for (std::size_t i = 0; i < 3; ++i)
          if (w[i] > 0)
            value += w[i] * p.values[corners[i]];
        p.values.push_back(mesh_file::has_type(value, p.type) ? value : std::round(value));
      }
    });
  }

  Index new_texture(Index v, const Triangle& elements, const Weights& w)
  {
    return mean(textures_known_, v, elements, w, to_.texture_coordinates.size(), [&]
      { to_.texture_coordinates.push_back(mean(to_.texture_coordinates, elements, w)); });
  }

  Index new_normal(Index v, const Triangle& elements, const Weights& w)
  {
    return mean(normals_known_, v, elements, w, to_.normals.size(), [&] {
      Point n = mean(to_.normals, elements, w);
      const double length = std::hypot(n[0], n[1], n[2]);
      for (double& x : n)
        x = length > 0 ? x / length : x;
      to_.normals.push_back(n);
    });
  }

  // Ends the polygon that has the last corners.
  void end_polygon(std::size_t polygon)
  {
    to_.end_polygon();
    if (!from_.group_of_polygon.empty())
      to_.group_of_polygon.push_back(from_.group_of_polygon[polygon]);
    if (!from_.material_of_polygon.empty())
      to_.material_of_polygon.push_back(from_.material_of_polygon[polygon]);
    for (std::size_t i = 0; i < from_.polygon_properties.size(); ++i)
      to_.polygon_properties[i].values.push_back(from_.polygon_properties[i].values[polygon]);
  }

  void copy_polygon(std::size_t polygon)
  {
    const auto append = [&](const std::vector<Index>& list, std::vector<Index>& result) {
      if (!list.empty())
        result.insert(result.end(), list.begin() + from_.first_corner[polygon],
                      list.begin() + from_.first_corner[polygon + 1]);
    };
    append(from_.corners, to_.corners);
    append(from_.texture_of_corner, to_.texture_of_corner);
    append(from_.normal_of_corner, to_.normal_of_corner);
    end_polygon(polygon);
  }

  // Adds a part of a triangle of the input, whose points are `corners` in the file.
  void add_part(const Triangle& part, std::size_t triangle, const Triangle& corners)
  {
    const std::size_t polygon = input_.polygon_of_triangle[triangle];
    const Index* const begin = from_.corners.data() + from_.first_corner[polygon];
    const Index* const end = from_.corners.data() + from_.first_corner[polygon + 1];
    const auto elements = [&](const std::vector<Index>& of_corner) {
      Triangle result;
      for (std::size_t i = 0; i < 3; ++i)
        result[i] = of_corner[std::find(begin, end, corners[i]) - from_.corners.data()];
      return result;
    };
    for (Index v : part) {
      const bool is_new = v >= from_.points.size();
      Weights w = {0, 0, 0};
      if (is_new)
        w = weights(v, triangle);
      const auto& whole = input_.triangles[triangle];
      const std::size_t i = std::find(whole.begin(), whole.end(), v) - whole.begin();
      to_.corners.push_back(is_new ? new_point(v, corners, w) : corners[i]);
      if (!from_.texture_of_corner.empty()) {
        const Triangle t = elements(from_.texture_of_corner);
        to_.texture_of_corner.push_back(is_new ? new_texture(v, t, w) : t[i]);
      }
      if (!from_.normal_of_corner.empty()) {
        const Triangle n = elements(from_.normal_of_corner);
        to_.normal_of_corner.push_back(is_new ? new_normal(v, n, w) : n[i]);
      }
    }
    end_polygon(polygon);
  }

  void clear_polygons()
  {
    to_.corners.clear();
    to_.first_corner = {0};
    to_.texture_of_corner.clear();
    to_.normal_of_corner.clear();
    to_.group_of_polygon.clear();
    to_.material_of_polygon.clear();
    for (mesh_file::Property& p : to_.polygon_properties)
      p.values.clear();
  }

public:
  Input_refinement(const Input& input, const std::vector<Index>& segment_of_triangle)
    : input_(input), from_(input.soup), scene_{input.soup, input.node_names, input.mesh_names, {}},
      to_(scene_.soup), points_(from_.points), triangles_(input.triangles),
      segment_of_triangle_(segment_of_triangle)
  {
    refinement_ =
      CGAL::refine_segment_boundaries(points_, triangles_, segment_of_triangle_);
    clear_polygons();
  }

  // Returns the refined input. May be called once. Takes the segments of the unrefined polygons.
  Refined_input operator()(const std::vector<Index>& segment_of_polygon)
  {
    const std::size_t n = input_.triangles.size();
    std::vector<std::pair<std::size_t, std::size_t> > parts; // the triangles with their parts
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      parts.emplace_back(i < n ? i : refinement_.triangles[i - n], i);
    std::sort(parts.begin(), parts.end());
    mesh_file::Polygon_triangulation triangulate(from_.points);

    Refined_input result;
    std::size_t part = 0;
    for (std::size_t polygon = 0, t = 0; polygon < from_.number_of_polygons(); ++polygon) {
      std::size_t end_of_parts = part, end = t;
      for (; end < n && input_.polygon_of_triangle[end] == polygon; ++end)
        while (end_of_parts < parts.size() && parts[end_of_parts].first == end)
          ++end_of_parts;
      bool is_cut = end_of_parts - part > end - t;
      for (std::size_t i = t; i < end; ++i)
        is_cut |= segment_of_triangle_[i] != segment_of_triangle_[t];
      if (is_cut) {
        std::vector<Triangle> corners; // before borders were joined
        triangulate(from_.polygon(polygon), corners);
        for (std::size_t i = part; i < end_of_parts; ++i) {
          add_part(triangles_[parts[i].second], parts[i].first, corners[parts[i].first - t]);
          result.segment.push_back(segment_of_triangle_[parts[i].second]);
        }
      }
      else if (t < end || !input_.has_tetrahedra) {
        copy_polygon(polygon);
        result.segment.push_back(t < end ? segment_of_triangle_[t] : segment_of_polygon[polygon]);
      }
      result.polygon.resize(result.segment.size(), static_cast<Index>(polygon));
      part = end_of_parts;
      t = end;
    }
    result.input = triangulated(std::move(scene_));
    return result;
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_REFINED_INPUT_H
