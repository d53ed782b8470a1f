// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_HIERARCHY_JSON_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_HIERARCHY_JSON_H

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/base/Boundary_network.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

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

// Reads the JSON that is written above. Checks everything that the functions of a
// hierarchy rely on, and throws `std::runtime_error`.
class Hierarchy_reader
{
  static constexpr std::size_t largest_ = null_index / 3 - 1;

  typedef nlohmann::json Value;

  const Value root_;
  Cut_hierarchy cuts_;
  std::vector<std::size_t> number_of_faces_; // one per node

  [[noreturn]] static void fail(const std::string& what)
  { throw std::runtime_error("read_hierarchy: " + what); }

  [[noreturn]] static void fail(const char* key, const char* what)
  { fail("\"" + std::string(key) + "\" " + what); }

  static Value parsed(std::istream& is)
  {
    try {
      return Value::parse(is);
    }
    catch (const Value::parse_error& e) {
      fail("the JSON is not well-formed at byte " + std::to_string(e.byte));
    }
    catch (const Value::out_of_range&) {
      fail("a number is too large");
    }
  }

  static const Value& member(const Value& object, const char* key)
  {
    if (!object.is_object())
      fail("there is something else than the object with \"" + std::string(key) + "\"");
    const auto found = object.find(key);
    if (found == object.end())
      fail(key, "is missing");
    return *found;
  }

  static const Value& array(const Value& object, const char* key)
  {
    const Value& result = member(object, key);
    if (!result.is_array())
      fail(key, "is not an array");
    return result;
  }

  static std::size_t count(const Value& value, const char* key, std::size_t largest)
  {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > largest)
      fail("a number of \"" + std::string(key) + "\" is not an integer in its range");
    return value.get<std::size_t>();
  }

  static bool flag(const Value& object, const char* key)
  {
    const Value& value = member(object, key);
    if (!value.is_boolean())
      fail(key, "is neither true nor false");
    return value.get<bool>();
  }

  static double number(const Value& object, const char* key)
  {
    const Value& value = member(object, key);
    if (value.is_number())
      return value.get<double>();
    if (value == infinity_string)
      return std::numeric_limits<double>::infinity();
    if (value == minus_infinity_string)
      return -std::numeric_limits<double>::infinity();
    if (value != nan_string)
      fail(key, "is not a number");
    return std::numeric_limits<double>::quiet_NaN();
  }

  static double number_but_nan(const Value& object, const char* key)
  {
    const double result = number(object, key);
    if (std::isnan(result))
      fail(key, "is not a number");
    return result;
  }

  static Cut_state cut_state(const Value& node)
  {
    const Value& value = member(node, "cut_state");
    for (const auto& [state, name] : names_of_cut_states)
      if (value == name)
        return state;
    fail("cut_state", "is none of its words");
  }

  std::size_t node_index(const Value& value, const char* key) const
  {
    if (cuts_.nodes.empty())
      fail("there are no nodes");
    return count(value, key, cuts_.nodes.size() - 1);
  }

  void read_node(const Value& json, std::size_t i)
  {
    Cut_node& n = cuts_.nodes[i];
    if (node_index(member(json, "id"), "id") != i)
      fail("the nodes are not in the order of their \"id\"");
    const Value& parent = member(json, "parent");
    const bool is_root = parent.is_null();
    if (is_root != (i < cuts_.number_of_roots))
      fail("the first nodes are not the roots");
    if (!is_root)
      n.parent = node_index(parent, "parent");
    const Value& children = array(json, "children");
    if (!children.empty() && children.size() != 2)
      fail("a node has not two \"children\"");
    std::size_t* next = n.children;
    for (const Value& child : children)
      *next++ = node_index(child, "children");
    number_of_faces_.push_back(count(member(json, "faces"), "faces", largest_));
    n.area = number_but_nan(json, "area");
    if (n.area < 0)
      fail("an \"area\" is negative");
    n.cut_state = cut_state(json);
    if ((n.cut_state == Cut_state::CUT) == n.is_leaf())
      fail("a node has children if and only if its \"cut_state\" is \"cut\"");
    if (n.cut_state != Cut_state::CUT && n.cut_state != Cut_state::REJECTED)
      return;
    n.salience = number_but_nan(json, "salience");
    const Value& factors = member(json, "factors");
    n.factors.is_boundary = flag(factors, "is_boundary");
    for (const auto& [name, value] : named_factors)
      n.factors.*value = number(factors, name);
  }

  // Checks that each node but the roots is one child of one node, and that all are below the roots.
  void check_tree() const
  {
    const std::vector<Cut_node>& nodes = cuts_.nodes;
    std::vector<char> is_child(nodes.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!nodes[i].is_leaf())
        for (std::size_t child : nodes[i].children) {
          if (nodes[child].parent != i || is_child[child])
            fail("\"parent\" and \"children\" do not agree");
          is_child[child] = 1;
        }
    if (parents_first(cuts_).size() != nodes.size())
      fail("a node is not below a root");
    for (const Cut_node& n : nodes)
      if (!n.is_leaf() && nodes[n.children[0]].area > nodes[n.children[1]].area)
        fail("the first of two \"children\" is the larger");
  }

  void read_order()
  {
    std::vector<char> is_read(cuts_.nodes.size(), 0);
    for (const Value& value : array(root_, "cut_order")) {
      const std::size_t i = node_index(value, "cut_order");
      const std::size_t parent = cuts_.nodes[i].parent;
      if (is_read[i] || (parent != null_node && !is_read[parent]))
        fail("a node comes twice, or before its parent, in \"cut_order\"");
      is_read[i] = 1;
      cuts_.cut_order.push_back(i);
    }
    for (std::size_t i = 0; i < cuts_.nodes.size(); ++i)
      if (!cuts_.nodes[i].is_leaf() && !is_read[i])
        fail("a node with children is missing in \"cut_order\"");
  }

  void read_faces()
  {
    std::vector<std::size_t> size(cuts_.nodes.size(), 0);
    for (const Value& value : array(root_, "leaf_of_face")) {
      const std::size_t leaf = node_index(value, "leaf_of_face");
      if (!cuts_.nodes[leaf].is_leaf())
        fail("a node of \"leaf_of_face\" has children");
      cuts_.leaf.push_back(static_cast<Index>(leaf));
      ++size[leaf];
    }
    if (cuts_.leaf.size() != count(member(root_, "number_of_faces"), "number_of_faces", largest_))
      fail("\"leaf_of_face\" has not \"number_of_faces\" numbers");
    const std::vector<std::size_t> order = parents_first(cuts_);
    for (std::size_t k = order.size(); k-- > cuts_.number_of_roots;)
      size[cuts_.nodes[order[k]].parent] += size[order[k]];
    if (size != number_of_faces_ || std::count(size.begin(), size.end(), std::size_t(0)) > 0)
      fail("a node has not as many \"faces\" as \"leaf_of_face\" says");
  }

  // Returns how many of the three edges of a face lead to another face.
  std::ptrdiff_t edges_to(Index from, Index to) const
  {
    const auto first = cuts_.neighbors.begin() + 3 * std::ptrdiff_t(from);
    return std::count(first, first + 3, to);
  }

  // Returns whether two neighbors are mutual. Smoothing then ends because each step makes
  // boundaries shorter. A face with three equal neighbors is never smoothed, because it is
  // constrained and has itself for neighbors, or because it is a duplicate.
  bool is_neighbor(Index f, Index g) const
  {
    return f == g || edges_to(f, g) == edges_to(g, f) || edges_to(g, g) == 3 ||
           edges_to(f, g) == 3;
  }

  void read_neighbors()
  {
    if (!root_.contains("neighbors_of_faces"))
      return;
    const Value& neighbors = array(root_, "neighbors_of_faces");
    const std::size_t n = cuts_.leaf.size();
    if (n == 0 || neighbors.size() != 3 * n)
      fail("\"neighbors_of_faces\" has not three numbers for each face");
    for (const Value& value : neighbors)
      cuts_.neighbors.push_back(
        static_cast<Index>(count(value, "neighbors_of_faces", n - 1)));
    for (std::size_t h = 0; h < 3 * n; ++h) {
      if (!is_neighbor(static_cast<Index>(h / 3), cuts_.neighbors[h]))
        fail("of two faces in \"neighbors_of_faces\" only one is a neighbor of the other");
    }
  }

public:
  explicit Hierarchy_reader(std::istream& is) : root_(parsed(is)) {}

  Segmentation_hierarchy operator()()
  {
    if (!root_.is_object() || !root_.contains("format") || root_["format"] != name_of_format)
      fail("this is not a hierarchy");
    const Value& version = member(root_, "version");
    if (version != version_of_format)
      fail("its version is not " + std::to_string(version_of_format));
    const Value& nodes = array(root_, "nodes");
    if (nodes.size() > largest_)
      fail("there are too many nodes");
    cuts_.nodes.resize(nodes.size());
    cuts_.number_of_roots =
      count(member(root_, "number_of_roots"), "number_of_roots", cuts_.nodes.size());
    cuts_.is_monotonic = flag(root_, "is_monotonic");
    cuts_.has_all_cuts = flag(root_, "has_all_cuts");
    std::size_t i = 0;
    for (const Value& node : nodes)
      read_node(node, i++);
    check_tree();
    read_order();
    read_faces();
    read_neighbors();

    const double threshold = number_but_nan(root_, "salience_threshold");
    const Value& maximum = member(root_, "maximum_number_of_segments");
    return Segmentation_hierarchy(
      std::move(cuts_),
      maximum.is_null()
        ? unlimited : count(maximum, "maximum_number_of_segments", unlimited),
      threshold);
  }

  // Returns the nodes of the segments that were written.
  std::vector<std::size_t> segments(const Segmentation_hierarchy& h) const
  {
    std::vector<std::size_t> result;
    for (const Value& segment : array(root_, "segments"))
      result.push_back(count(member(segment, "node"), "node", largest_));
    try {
      h.labels(result);
    }
    catch (const std::invalid_argument&) {
      fail("the \"segments\" do not have each face once");
    }
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_HIERARCHY_JSON_H
