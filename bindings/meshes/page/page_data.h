// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_PAGE_PAGE_DATA_H
#define SEGMENT_MESH_PAGE_PAGE_DATA_H

#include "../read_input.h"
#include "Page_mesh.h"
#include "packed.h"

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Segmented_mesh/refine_segment_boundaries.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
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

  // Returns, for each piece, the node that is its segment if there are `n` segments. The nodes of
  // `n` segments come first because a cut numbers its children behind all nodes that are there.
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

// Returns the salience of the least salient cut, the threshold for any number of segments.
inline double least_salience(const Segmentation_hierarchy& tree)
{
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
    if (!tree.node(i).is_leaf())
      result = (std::min)(result, tree.node(i).salience);
  return result;
}

// Returns whether the labels of polygons follow from their pieces.
inline bool has_whole_polygons(const Input& input, const Pieces& pieces)
{
  for (std::size_t t = 1; t < input.triangles.size(); ++t)
    if (input.polygon_of_triangle[t] == input.polygon_of_triangle[t - 1] &&
        pieces.of_triangles()[t] != pieces.of_triangles()[t - 1])
      return false;
  return true;
}

// Returns what `n` segments need besides the pieces: the label of each segment, by its node, and
// the polygons with another label than that of the segment of their piece, which have several
// pieces.
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
  bool is_salience_probability;
  bool keep_faces = false;             // otherwise boundaries are refined
  std::size_t most_triangles = 300000; // a phone can turn so many
};

inline nlohmann::ordered_json hierarchy_data(const Segmentation_hierarchy& tree,
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
          {"first_triangles", pieces.first_triangles()}};
}

// Appends points for the corners of triangles, so that each segment has points of its own. Returns
// the point that each of all points was.
inline std::vector<Index> take_apart(Page_mesh& mesh, const std::vector<Index>& segments)
{
  std::vector<Index> origins, copies(mesh.points.size()), order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b)
                   { return segments[a] < segments[b]; });
  std::vector<Index> segment_of_copy(mesh.points.size(), mesh_file::null_index);
  for (Index t : order)
    for (Index& v : mesh.triangles[t]) {
      if (std::exchange(segment_of_copy[v], segments[t]) != segments[t]) {
        copies[v] = static_cast<Index>(origins.size());
        origins.push_back(v);
      }
      v = copies[v];
    }
  std::vector<Point> points;
  for (Index v : origins)
    points.push_back(mesh.points[v]);
  mesh.points.swap(points);
  return origins;
}

// Gives each triangle without a piece the piece of a triangle that it touches, else any piece of
// its segment.
inline void spread_pieces(Page_mesh& mesh, const std::vector<Index>& segments)
{
  std::map<Index, Index> piece_of_segment;
  std::vector<Index> piece_at(mesh.points.size(), mesh_file::null_index);
  for (bool has_changed = true; std::exchange(has_changed, false);)
    for (std::size_t t = 0; t < segments.size(); ++t) {
      Index& piece = mesh.pieces[t];
      if (piece == mesh_file::null_index)
        for (Index v : mesh.triangles[t])
          piece = (std::min)(piece, piece_at[v]);
      if (piece == mesh_file::null_index)
        continue;
      piece_of_segment[segments[t]] = piece;
      for (Index v : mesh.triangles[t])
        if (piece < piece_at[v]) {
          piece_at[v] = piece;
          has_changed = true;
        }
    }
  for (std::size_t t = 0; t < segments.size(); ++t)
    if (mesh.pieces[t] == mesh_file::null_index)
      mesh.pieces[t] = piece_of_segment[segments[t]];
}

// Refines the boundaries between `n` segments as meshes on file have them. Triangles on the other
// side of a boundary lose their pieces. Returns the segment of each triangle. A piece that would
// lose all its triangles is a segment of its own.
inline std::vector<Index> refine_segments(Page_mesh& mesh, const Segmentation_hierarchy& tree,
                                          std::size_t number_of_pieces, std::size_t n)
{
  const std::vector<std::size_t> nodes = tree.nodes_above(least_salience(tree), n);
  const std::vector<std::size_t> labels = tree.labels(nodes);
  std::vector<Index> segment_of_piece(number_of_pieces);
  for (Index s = 0; s < nodes.size(); ++s)
    for (std::size_t t : tree.faces(nodes[s]))
      segment_of_piece[mesh.pieces[t]] = s;
  for (std::size_t number = nodes.size();;) {
    Page_mesh refined = mesh;
    std::vector<Index> segments(labels.begin(), labels.end());
    for (std::size_t t = 0; t < segments.size(); ++t)
      if (segment_of_piece[mesh.pieces[t]] >= nodes.size())
        segments[t] = segment_of_piece[mesh.pieces[t]];
    for (std::size_t t :
         CGAL::refine_segment_boundaries(refined.points, refined.triangles, segments).triangles)
      refined.pieces.push_back(mesh.pieces[t]);
    std::vector<char> has_triangle(number_of_pieces, 0);
    for (std::size_t t = 0; t < segments.size(); ++t)
      if (Index& piece = refined.pieces[t]; segment_of_piece[piece] == segments[t])
        has_triangle[piece] = 1;
      else
        piece = mesh_file::null_index;
    const std::size_t number_before = number;
    for (std::size_t i = 0; i < number_of_pieces; ++i)
      if (!has_triangle[i] && segment_of_piece[i] < nodes.size())
        segment_of_piece[i] = static_cast<Index>(number++);
    if (number == number_before) {
      mesh = std::move(refined);
      return segments;
    }
  }
}

// Refines the boundaries between the pieces of each segment, which end at those of segments.
inline void refine_pieces(Page_mesh& mesh, const std::vector<Index>& segments)
{
  std::vector<Point> points = mesh.points;
  std::vector<Index> origins = take_apart(mesh, segments);
  spread_pieces(mesh, segments);
  // A triangle without edges keeps the boundaries at its point from moving.
  std::vector<Index> number_of_copies(points.size(), 0);
  for (Index v : origins)
    ++number_of_copies[v];
  for (std::size_t t = 0; t < segments.size(); ++t)
    for (Index v : Triangle(mesh.triangles[t]))
      if (number_of_copies[origins[v]] > 1) {
        mesh.triangles.push_back({v, v, v});
        mesh.pieces.push_back(mesh.pieces[t]);
      }
  const auto begin = static_cast<std::ptrdiff_t>(segments.size());
  const auto end = static_cast<std::ptrdiff_t>(mesh.triangles.size());
  CGAL::refine_segment_boundaries(mesh.points, mesh.triangles, mesh.pieces);
  mesh.triangles.erase(mesh.triangles.begin() + begin, mesh.triangles.begin() + end);
  mesh.pieces.erase(mesh.pieces.begin() + begin, mesh.pieces.begin() + end);
  for (std::size_t v = origins.size(); v < mesh.points.size(); ++v) {
    origins.push_back(static_cast<Index>(points.size()));
    points.push_back(mesh.points[v]);
  }
  for (Triangle& t : mesh.triangles)
    for (Index& v : t)
      v = origins[v];
  mesh.points.swap(points);
}

// Returns the mesh to be shown, with refined boundaries or with fewer triangles.
inline Page_mesh page_mesh(const Input& input, const Segmentation_hierarchy& tree,
                           const Pieces& pieces, const Page_options& o)
{
  Page_mesh result{input.soup.points, input.triangles, pieces.of_triangles()};
  if (!o.keep_faces && pieces.number() > 1 && input.triangles.size() <= o.most_triangles)
    refine_pieces(result,
                  refine_segments(result, tree, pieces.number(), o.number_of_segments));
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
  if (!has_whole_polygons(input, pieces))
    for (std::size_t n = tree.number_of_roots(); n <= tree.number_of_segments(); ++n)
      exceptions[std::to_string(n)] =
        label_exceptions(input, tree, pieces.segments(n), piece_of_polygon, n);
  return {{"name", o.name},
          {"segments", o.number_of_segments},
          {"salience", o.is_salience_probability ? "probability" : "salience"},
          {"input_triangles", input.triangles.size()},
          {"hierarchy", hierarchy_data(tree, pieces)},
          {"mesh", mesh_data(page_mesh(input, tree, pieces, o))},
          {"piece_of_face", packed_runs(piece_of_polygon)},
          {"exceptions", exceptions}};
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_PAGE_PAGE_DATA_H
