// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_HIERARCHY_JSON_H
#define SEGMENT_MESH_HIERARCHY_JSON_H

#include <CGAL/Spectral_segmentation/IO/hierarchy.h>
#include <CGAL/Spectral_segmentation/Salience_factors.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <istream>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

using CGAL::Spectral_segmentation::Salience_factors;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

constexpr const char* name_of_format = "CGAL Spectral_segmentation hierarchy";
constexpr std::size_t version_of_format = 1;

// The extent of a segment, and its neighbors.
struct Segment_extent
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::array<double, 3> smallest{infinity, infinity, infinity};
  std::array<double, 3> largest{-infinity, -infinity, -infinity};
  std::vector<std::size_t> neighbors; // the adjacent segments, ascending
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
  return result;
}

typedef nlohmann::ordered_json Json;

// Returns a string for infinite numbers and NaN, which JSON does not have.
inline Json json_of_number(double x)
{
  if (std::isnan(x))
    return "nan";
  if (std::isinf(x))
    return x > 0 ? "infinity" : "-infinity";
  return x;
}

inline Json json_of_factors(const Salience_factors& factors)
{
  Json result = {{"is_boundary", factors.is_boundary}};
  for (const auto& [name, value] : CGAL::Spectral_segmentation::named_factors)
    result[name] = json_of_number(factors.*value);
  return result;
}

inline const char* name_of(Segmentation_hierarchy::Cut_state state)
{
  switch (state) {
    case Segmentation_hierarchy::Cut_state::NOT_SEARCHED: return "not searched";
    case Segmentation_hierarchy::Cut_state::NO_CUT: return "no cut";
    case Segmentation_hierarchy::Cut_state::REJECTED: return "rejected";
    case Segmentation_hierarchy::Cut_state::CUT: return "cut";
  }
  return "";
}

// Returns a node. Its salience and factors are null if there is no cut.
inline Json json_of_node(const Segmentation_hierarchy& h, std::size_t i, bool is_applied)
{
  const Segmentation_hierarchy::Node& n = h.node(i);
  const bool is_root = n.parent == Segmentation_hierarchy::null_node;
  const bool has_cut = n.cut_state == Segmentation_hierarchy::Cut_state::REJECTED ||
                       n.cut_state == Segmentation_hierarchy::Cut_state::CUT;
  return {{"id", i},
          {"parent", is_root ? Json() : Json(n.parent)},
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
    for (std::size_t i = h.node(segment).parent;
         i != Segmentation_hierarchy::null_node && !result[i]; i = h.node(i).parent)
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
    }
    result.push_back(segment);
  }
  return result;
}

// Returns a hierarchy with its segments, but without the data of faces. The manual documents the
// keys.
inline Json json_of_hierarchy(const Segmentation_hierarchy& h,
                              const std::vector<std::size_t>& segments,
                              const std::vector<std::size_t>& labels,
                              const std::vector<Segment_extent>& extents)
{
  const std::vector<char> is_applied = applied_cuts(h, segments);
  Json nodes = Json::array();
  for (std::size_t i = 0; i < h.number_of_nodes(); ++i)
    nodes.push_back(json_of_node(h, i, is_applied[i] != 0));
  return {{"format", name_of_format},
          {"version", version_of_format},
          {"number_of_faces", h.number_of_faces()},
          {"number_of_roots", h.number_of_roots()},
          {"salience_threshold", json_of_number(h.salience_threshold())},
          {"segments", json_of_segments(h, segments, labels, extents)},
          {"nodes", nodes}};
}

// Returns a hierarchy with the segments of its run.
inline Json json_of_hierarchy(const Segmentation_hierarchy& h)
{
  const std::vector<std::size_t> nodes = h.nodes();
  return json_of_hierarchy(h, nodes, h.labels(nodes), {});
}

// Returns the same with the neighbors and bounding boxes of the segments. Points and triangles are
// arrays of three.
template <class Points, class Triangles>
Json json_of_hierarchy(const Segmentation_hierarchy& h, const Points& points,
                       const Triangles& triangles)
{
  const std::vector<std::size_t> nodes = h.nodes();
  const std::vector<std::size_t> labels = h.labels(nodes);
  return json_of_hierarchy(h, nodes, labels,
                           segment_extents(points, triangles, labels, nodes.size()));
}

// Writes the JSON of a hierarchy with the leaf of each face, and with the text from which it is
// read again. Each key is on a line of its own.
inline void write_json(std::ostream& os, const Segmentation_hierarchy& h, Json json)
{
  std::vector<std::size_t> leaf(h.number_of_faces());
  for (std::size_t i = 0; i < h.number_of_nodes(); ++i)
    if (h.node(i).is_leaf())
      for (std::size_t f : h.faces(i))
        leaf[f] = i;
  std::ostringstream text;
  CGAL::Spectral_segmentation::write_hierarchy(text, h);
  json["leaf_of_face"] = leaf;
  json["text"] = text.str();
  const char* separator = "{\n";
  for (const auto& item : json.items()) {
    os << separator << Json(item.key()).dump() << ": " << item.value().dump();
    separator = ",\n";
  }
  os << "\n}\n";
  if (!os)
    throw std::runtime_error("write_json: the stream cannot be written");
}

// Reads a hierarchy from its JSON, of which only the text is read. Throws `std::runtime_error`.
inline Segmentation_hierarchy read_hierarchy_json(std::istream& is)
{
  const nlohmann::json json = nlohmann::json::parse(is, nullptr, false);
  if (json.is_discarded())
    throw std::runtime_error("read_hierarchy: the JSON is not well-formed");
  if (!json.is_object() || !json.contains("format") || json["format"] != name_of_format)
    throw std::runtime_error("read_hierarchy: this is not a hierarchy");
  if (!json.contains("version") || json["version"] != version_of_format ||
      !json.contains("text") || !json["text"].is_string())
    throw std::runtime_error("read_hierarchy: this is a hierarchy of another version");
  std::istringstream text(json["text"].get<std::string>());
  return CGAL::Spectral_segmentation::read_hierarchy(text);
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_HIERARCHY_JSON_H
