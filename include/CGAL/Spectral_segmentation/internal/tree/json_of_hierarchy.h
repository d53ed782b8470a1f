// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TREE_JSON_OF_HIERARCHY_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TREE_JSON_OF_HIERARCHY_H

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/base/Index.h>
#include <CGAL/Spectral_segmentation/internal/salience/Boundary_network.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Gives access to the data of a hierarchy that are written and have no public name.
struct Hierarchy_access
{
  static const Cut_hierarchy& cuts(const Segmentation_hierarchy& h) { return h.cuts_; }

  static std::size_t maximum_number_of_segments(const Segmentation_hierarchy& h)
  { return h.maximum_number_of_segments_; }
};

constexpr const char* name_of_format = "CGAL Spectral_segmentation hierarchy";
constexpr std::size_t version_of_format = 1;

constexpr std::array<std::pair<Cut_state, const char*>, 4> names_of_cut_states = {{
  {Cut_state::NOT_SEARCHED, "not searched"},
  {Cut_state::NO_CUT, "no cut"},
  {Cut_state::REJECTED, "rejected"},
  {Cut_state::CUT, "cut"}}};

// Numbers that JSON does not have are strings.
constexpr const char* infinity_string = "infinity";
constexpr const char* minus_infinity_string = "-infinity";
constexpr const char* nan_string = "nan";

// The extent of a segment, its neighbors, and the class of its copies.
struct Segment_extent
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::array<double, 3> smallest{infinity, infinity, infinity};
  std::array<double, 3> largest{-infinity, -infinity, -infinity};
  std::vector<std::size_t> neighbors; // the segments with which it shares an edge, ascending
  std::size_t segment_class = 0;      // segments of one class may be copies or mirror images
};

// Returns the extent of each segment. Points and triangles are arrays of three; labels are below
// `number`.
template <class Points, class Triangles, class Labels>
std::vector<Segment_extent> segment_extents(const Points& points, const Triangles& triangles,
                                            const Labels& labels, std::size_t number)
{
  std::vector<Segment_extent> result(number);
  constexpr std::size_t several = static_cast<std::size_t>(-2), none = several + 1;
  std::vector<std::size_t> segment_at(points.size(), none);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Segment_extent& extent = result[labels[t]];
    for (auto v : triangles[t]) {
      for (int k = 0; k < 3; ++k) {
        extent.smallest[k] = (std::min)(extent.smallest[k], points[v][k]);
        extent.largest[k] = (std::max)(extent.largest[k], points[v][k]);
      }
      if (segment_at[v] == none)
        segment_at[v] = labels[t];
      else if (segment_at[v] != labels[t])
        segment_at[v] = several;
    }
  }

  // The edges at a boundary, with the segments of their triangles.
  typedef std::pair<std::array<std::size_t, 2>, std::size_t> Edge;
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::size_t v = triangles[t][k], w = triangles[t][(k + 1) % 3];
      if (segment_at[v] == several && segment_at[w] == several)
        edges.push_back({{(std::min)(v, w), (std::max)(v, w)}, labels[t]});
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size() && edges[j].first == edges[i].first; ++j) {
      result[edges[i].second].neighbors.push_back(edges[j].second);
      result[edges[j].second].neighbors.push_back(edges[i].second);
    }
  for (Segment_extent& extent : result) {
    std::vector<std::size_t>& list = extent.neighbors;
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  const std::vector<std::size_t> classes =
    congruence_classes(segment_moments(points, triangles, labels, number));
  for (std::size_t i = 0; i < number; ++i)
    result[i].segment_class = classes[i];
  return result;
}

typedef nlohmann::ordered_json Json;

inline Json json_of_number(double x)
{
  if (std::isnan(x))
    return nan_string;
  if (std::isinf(x))
    return x > 0 ? infinity_string : minus_infinity_string;
  return x;
}

inline Json json_of_count(std::size_t i, std::size_t null)
{ return i == null ? Json() : Json(i); }

inline Json json_of_factors(const Salience_factors& factors)
{
  Json result = {{"is_boundary", factors.is_boundary}};
  for (const auto& [name, member] : named_factors)
    result[name] = json_of_number(factors.*member);
  return result;
}

inline const char* name_of(Cut_state state)
{
  for (const auto& [known_state, name] : names_of_cut_states)
    if (known_state == state)
      return name;
  return "";
}

// Returns a node. Its salience and factors are null if there is no cut.
inline Json json_of_node(const Segmentation_hierarchy& h, std::size_t i, bool is_applied)
{
  const Cut_node& n = h.node(i);
  const bool has_cut =
    n.cut_state == Cut_state::REJECTED || n.cut_state == Cut_state::CUT;
  return {{"id", i},
          {"parent", json_of_count(n.parent, null_node)},
          {"children", n.is_leaf() ? Json::array() : Json(n.children)},
          {"faces", h.number_of_faces(i)},
          {"area", json_of_number(n.area)},
          {"cut_state", name_of(n.cut_state)},
          {"is_applied", is_applied},
          {"salience", has_cut ? json_of_number(n.salience) : Json()},
          {"factors", has_cut ? json_of_factors(n.factors) : Json()}};
}

// Marks the cuts that make these segments, which are the cuts above their nodes.
inline std::vector<char> applied_cuts(const Segmentation_hierarchy& h,
                                      const std::vector<std::size_t>& segments)
{
  std::vector<char> result(h.number_of_nodes(), 0);
  for (std::size_t segment : segments)
    for (std::size_t i = h.node(segment).parent; i != null_node && !result[i];
         i = h.node(i).parent)
      result[i] = 1;
  return result;
}

// Returns the segments; `extents` may be empty.
inline Json json_of_segments(const Segmentation_hierarchy& h,
                             const std::vector<std::size_t>& segments,
                             const std::vector<std::size_t>& labels,
                             const std::vector<Segment_extent>& extents)
{
  std::vector<std::size_t> number_of_faces(segments.size(), 0);
  for (std::size_t label : labels)
    ++number_of_faces[label];
  Json result = Json::array();
  for (std::size_t k = 0; k < segments.size(); ++k) {
    Json segment = {{"id", k},
                    {"node", segments[k]},
                    {"faces", number_of_faces[k]},
                    {"area", json_of_number(h.node(segments[k]).area)}};
    if (!extents.empty()) {
      segment["neighbors"] = extents[k].neighbors;
      segment["bounding_box"] = {extents[k].smallest, extents[k].largest};
      segment["class"] = extents[k].segment_class;
    }
    result.push_back(segment);
  }
  return result;
}

// Returns the hierarchy with the segments that were chosen, but without the data of faces.
inline Json json_of_hierarchy(const Segmentation_hierarchy& h,
                              const std::vector<std::size_t>& segments,
                              const std::vector<std::size_t>& labels,
                              const std::vector<Segment_extent>& extents)
{
  const Cut_hierarchy& cuts = Hierarchy_access::cuts(h);
  const std::vector<char> is_applied = applied_cuts(h, segments);
  Json nodes = Json::array();
  for (std::size_t i = 0; i < h.number_of_nodes(); ++i)
    nodes.push_back(json_of_node(h, i, is_applied[i] != 0));
  return {{"format", name_of_format},
          {"version", version_of_format},
          {"number_of_faces", h.number_of_faces()},
          {"number_of_roots", h.number_of_roots()},
          {"maximum_number_of_segments",
           json_of_count(Hierarchy_access::maximum_number_of_segments(h), unlimited)},
          {"salience_threshold", json_of_number(h.salience_threshold())},
          {"is_monotonic", cuts.is_monotonic},
          {"has_all_cuts", cuts.has_all_cuts},
          {"segments", json_of_segments(h, segments, labels, extents)},
          {"nodes", nodes},
          {"cut_order", cuts.cut_order}};
}

// Adds the data of faces, which are needed to read labels off.
inline void add_faces(const Segmentation_hierarchy& h, Json& json)
{
  const Cut_hierarchy& cuts = Hierarchy_access::cuts(h);
  json["leaf_of_face"] = cuts.leaf;
  if (!cuts.neighbors.empty())
    json["neighbors_of_faces"] = cuts.neighbors;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TREE_JSON_OF_HIERARCHY_H
