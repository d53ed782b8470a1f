// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_JSON_JSON_OF_HIERARCHY_H
#define CGAL_SEGMENTED_MESH_INTERNAL_JSON_JSON_OF_HIERARCHY_H

#include <CGAL/Segmented_mesh/internal/json/segment_extents.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// What is written of a hierarchy and has no public name.
struct Hierarchy_access
{
  static const Cut_hierarchy& cuts(const Segmentation_hierarchy& h) { return h.cuts_; }

};

constexpr const char* name_of_format = "CGAL Spectral_segmentation hierarchy";
constexpr std::size_t version_of_format = 1;

constexpr std::array<std::pair<Cut_state, const char*>, 4> names_of_cut_states = {{
  {Cut_state::NOT_SEARCHED, "not searched"},
  {Cut_state::NO_CUT, "no cut"},
  {Cut_state::REJECTED, "rejected"},
  {Cut_state::ACCEPTED, "known"}}};

constexpr std::array<std::pair<const char*, double Salience_factors::*>, 8> names_of_factors = {{
  {"size", &Salience_factors::size},
  {"cut_strength", &Salience_factors::cut_strength},
  {"protrusiveness", &Salience_factors::protrusiveness},
  {"log_relative_part_area", &Salience_factors::log_relative_part_area},
  {"concavity_near_cut", &Salience_factors::concavity_near_cut},
  {"convexity_gain", &Salience_factors::convexity_gain},
  {"relative_convexity_gain", &Salience_factors::relative_convexity_gain},
  {"expansion_behind_cut", &Salience_factors::expansion_behind_cut}}};

// Numbers that JSON does not have are strings.
constexpr const char* infinity_string = "infinity";
constexpr const char* minus_infinity_string = "-infinity";
constexpr const char* nan_string = "nan";

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
  Json result;
  for (const auto& [name, member] : names_of_factors)
    result[name] = json_of_number(factors.*member);
  return result;
}

inline const char* name_of(Cut_state state)
{
  for (const auto& [known, name] : names_of_cut_states)
    if (known == state)
      return name;
  return "";
}

// Salience and factors are null if there is no cut.
inline Json json_of_node(const Segmentation_hierarchy& h, std::size_t i, bool is_made)
{
  const Cut_node& n = h.node(i);
  const bool has_cut =
    n.cut_state == Cut_state::REJECTED || n.cut_state == Cut_state::ACCEPTED;
  return {{"id", i},
          {"parent", json_of_count(n.parent, null_node)},
          {"children", n.is_leaf() ? Json::array() : Json(n.children)},
          {"faces", h.number_of_faces(i)},
          {"area", json_of_number(n.area)},
          {"cut", name_of(n.cut_state)},
          {"made", is_made},
          {"salience", has_cut ? json_of_number(n.salience) : Json()},
          {"factors", has_cut ? json_of_factors(n.factors) : Json()}};
}

// The cuts that these segments have: those above their nodes.
inline std::vector<char> made_cuts(const Segmentation_hierarchy& h,
                                   const std::vector<std::size_t>& segments)
{
  std::vector<char> result(h.number_of_nodes(), 0);
  for (std::size_t segment : segments)
    for (std::size_t i = h.node(segment).parent; i != null_node && !result[i];
         i = h.node(i).parent)
      result[i] = 1;
  return result;
}

// `extents` may be empty.
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

// The hierarchy with the segments that were chosen, but for what is of each face.
inline Json json_of_hierarchy(const Segmentation_hierarchy& h,
                              const std::vector<std::size_t>& segments,
                              const std::vector<std::size_t>& labels,
                              const std::vector<Segment_extent>& extents)
{
  const Cut_hierarchy& cuts = Hierarchy_access::cuts(h);
  const std::vector<char> is_made = made_cuts(h, segments);
  Json nodes = Json::array();
  for (std::size_t i = 0; i < h.number_of_nodes(); ++i)
    nodes.push_back(json_of_node(h, i, is_made[i] != 0));
  return {{"format", name_of_format},
          {"version", version_of_format},
          {"number_of_faces", h.number_of_faces()},
          {"number_of_roots", h.number_of_roots()},
          {"maximum_number_of_segments",
           json_of_count(h.maximum_number_of_segments(), unlimited)},
          {"salience_threshold", json_of_number(h.salience_threshold())},
          {"is_monotone", cuts.is_ultrametric},
          {"is_complete", cuts.is_complete},
          {"segments", json_of_segments(h, segments, labels, extents)},
          {"nodes", nodes},
          {"order_of_nodes", cuts.order}};
}

// What else is needed to read labels off: of each face.
inline void add_faces(const Segmentation_hierarchy& h, Json& json)
{
  const Cut_hierarchy& cuts = Hierarchy_access::cuts(h);
  json["leaf_of_face"] = cuts.leaf;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_JSON_JSON_OF_HIERARCHY_H
