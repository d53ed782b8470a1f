// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_PAGE_PAGE_DATA_H
#define SEGMENT_MESH_PAGE_PAGE_DATA_H

#include "../read_input.h"
#include "Page_mesh.h"
#include "packed.h"

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/node_classes.h>
#include <CGAL/Segmented_mesh/refine_segment_boundaries.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

using CGAL::Spectral_segmentation::Segmentation_hierarchy;

// The pieces: the leaves of a hierarchy, numbered in the order of their nodes.
class Pieces
{
  const Segmentation_hierarchy& tree_;
  std::vector<std::size_t> leaves_;
  std::vector<Index> of_triangles_;

public:
  explicit Pieces(const Segmentation_hierarchy& tree)
    : tree_(tree), of_triangles_(tree.number_of_faces())
  {
    for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
      if (tree.node(i).is_leaf()) {
        for (std::size_t t : tree.faces(i))
          of_triangles_[t] = static_cast<Index>(leaves_.size());
        leaves_.push_back(i);
      }
  }

  const std::vector<Index>& of_triangles() const { return of_triangles_; }
  std::size_t number() const { return leaves_.size(); }

  std::vector<Index> first_triangles() const
  {
    std::vector<Index> result;
    for (std::size_t leaf : leaves_)
      result.push_back(static_cast<Index>(*tree_.faces(leaf).begin()));
    return result;
  }

  // For each piece the node that is its segment if there are `n` segments: a cut numbers its
  // children behind all nodes that are there.
  std::vector<std::size_t> segments(std::size_t n) const
  {
    const std::size_t end = 2 * n - tree_.number_of_roots();
    std::vector<std::size_t> result = leaves_;
    for (std::size_t& i : result)
      while (i >= end)
        i = tree_.node(i).parent;
    return result;
  }
};

// The least salient cut, which labels of any number of segments need.
inline double least_salience(const Segmentation_hierarchy& tree)
{
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
    if (!tree.node(i).is_leaf())
      result = (std::min)(result, tree.node(i).salience);
  return result;
}

// Whether the labels of polygons follow from their pieces.
inline bool has_whole_polygons(const Input& input, const Pieces& pieces)
{
  for (std::size_t t = 1; t < input.triangles.size(); ++t)
    if (input.polygon_of_triangle[t] == input.polygon_of_triangle[t - 1] &&
        pieces.of_triangles()[t] != pieces.of_triangles()[t - 1])
      return false;
  return true;
}

// For `n` segments the label of each, by its node, and the polygons that have another label than
// that of their piece: such of several pieces, which count to the segment that has most of them,
// and such beside boundaries that were smoothed.
inline nlohmann::ordered_json label_exceptions(const Input& input,
                                               const Segmentation_hierarchy& tree,
                                               const std::vector<std::size_t>& segment_of_piece,
                                               const std::vector<Index>& piece_of_polygon,
                                               std::size_t n)
{
  const std::vector<std::size_t> labels = tree.labels(tree.nodes_above(least_salience(tree), n));
  const std::vector<Index> label =
    labels_of_polygons(input, std::vector<Index>(labels.begin(), labels.end()));
  std::map<std::size_t, std::map<Index, std::size_t> > counts; // counts of each label in a segment
  for (std::size_t i = 0; i < label.size(); ++i)
    ++counts[segment_of_piece[piece_of_polygon[i]]][label[i]];
  std::map<std::size_t, Index> label_of_segment;
  for (const auto& c : counts)
    label_of_segment[c.first] =
      std::max_element(c.second.begin(), c.second.end(), [](const auto& a, const auto& b)
                       { return a.second < b.second; })->first;
  std::vector<std::size_t> segments_and_labels, polygons;
  std::vector<Index> labels_of_these;
  for (const auto& s : label_of_segment)
    segments_and_labels.insert(segments_and_labels.end(), {s.first, s.second});
  for (std::size_t i = 0; i < label.size(); ++i)
    if (label[i] != label_of_segment[segment_of_piece[piece_of_polygon[i]]]) {
      polygons.push_back(i);
      labels_of_these.push_back(label[i]);
    }
  return {{"segments", segments_and_labels},
          {"faces", packed_differences(polygons)},
          {"labels", packed_runs(labels_of_these)}};
}

struct Page_options
{
  std::string name;
  std::size_t number_of_segments;      // that the page shows first
  bool is_salience_probability, smooth_boundaries;
  bool keep_faces = false;             // otherwise boundaries are refined
  std::size_t most_triangles = 300000; // a phone can turn so many
};

inline nlohmann::ordered_json hierarchy_data(const Input& input, const Segmentation_hierarchy& tree,
                                             const Pieces& pieces)
{
  nlohmann::ordered_json saliences = nlohmann::ordered_json::array();
  nlohmann::ordered_json parents = saliences, areas = saliences;
  for (std::size_t i = tree.number_of_roots(); i < tree.number_of_nodes(); i += 2) {
    const std::size_t parent = tree.node(i).parent;
    parents.push_back(parent);
    saliences.push_back(tree.node(parent).salience); // null if it is infinite
  }
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
    areas.push_back(tree.node(i).area);
  return {{"roots", tree.number_of_roots()},
          {"cut_nodes", parents},
          {"saliences", saliences},
          {"areas", areas},
          {"classes", node_classes(tree, input.soup.points, input.triangles)},
          {"first_triangles", pieces.first_triangles()}};
}

// Returns the mesh for the eye: with refined boundaries, or with fewer triangles.
inline Page_mesh page_mesh(const Input& input, const Pieces& pieces, const Page_options& o)
{
  Page_mesh result{input.soup.points, input.triangles, pieces.of_triangles()};
  if (!o.keep_faces && pieces.number() > 1 && input.triangles.size() <= o.most_triangles)
    CGAL::refine_segment_boundaries(result.points, result.triangles, result.pieces);
  return simplified(result, o.most_triangles);
}

inline nlohmann::ordered_json mesh_data(const Page_mesh& mesh)
{
  const Page_cube cube(mesh);
  std::vector<std::int64_t> positions;
  for (const Point& p : mesh.points)
    for (double x : cube.position(p, 65535))
      positions.push_back(std::llround(x));
  std::vector<Index> corners;
  for (const Triangle& t : mesh.triangles)
    corners.insert(corners.end(), t.begin(), t.end());
  return {{"corner", {4 * cube.corner[0], 4 * cube.corner[1], 4 * cube.corner[2]}},
          {"unit", 4 * (cube.edge / 65535)},
          {"points", packed_differences(positions, 3)},
          {"triangles", packed_differences(corners)},
          {"pieces", packed_runs(mesh.pieces)}};
}

// Returns the data that page/decode.js reads.
inline nlohmann::ordered_json page_data(const Input& input, const Segmentation_hierarchy& tree,
                                        const Page_options& o)
{
  const Pieces pieces(tree);
  const std::vector<Index> piece_of_polygon = labels_of_polygons(input, pieces.of_triangles());
  nlohmann::ordered_json exceptions = nlohmann::ordered_json::object();
  if (o.smooth_boundaries || !has_whole_polygons(input, pieces))
    for (std::size_t n = tree.number_of_roots(); n <= tree.number_of_segments(); ++n)
      exceptions[std::to_string(n)] =
        label_exceptions(input, tree, pieces.segments(n), piece_of_polygon, n);
  return {{"name", o.name},
          {"segments", o.number_of_segments},
          {"salience", o.is_salience_probability ? "probability" : "salience"},
          {"input_triangles", input.triangles.size()},
          {"hierarchy", hierarchy_data(input, tree, pieces)},
          {"mesh", mesh_data(page_mesh(input, pieces, o))},
          {"piece_of_face", packed_runs(piece_of_polygon)},
          {"exceptions", exceptions}};
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_PAGE_PAGE_DATA_H
