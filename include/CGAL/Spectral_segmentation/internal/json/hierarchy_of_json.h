// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_HIERARCHY_OF_JSON_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_HIERARCHY_OF_JSON_H

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/json/Hierarchy_access.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Reads the JSON that json_of_hierarchy.h writes. Checks everything that the functions of a
// hierarchy rely on, and throws `std::runtime_error`.
class Hierarchy_reader
{
  typedef nlohmann::ordered_json Json;

  static constexpr std::size_t largest_ = null_index / 3 - 1;

  const Json& json_;
  Cut_hierarchy cuts_;

  [[noreturn]] static void fail(const std::string& what)
  { throw std::runtime_error("read_hierarchy: " + what); }

  static const Json& member(const Json& object, const std::string& key)
  {
    if (!object.is_object())
      fail("there is something else than the object with \"" + key + "\"");
    const auto found = object.find(key);
    if (found == object.end())
      fail("\"" + key + "\" is missing");
    return *found;
  }

  static const Json& array(const Json& object, const std::string& key)
  {
    const Json& result = member(object, key);
    if (!result.is_array())
      fail("\"" + key + "\" is not an array");
    return result;
  }

  static std::size_t count(const Json& value, const std::string& key, std::size_t largest)
  {
    if (!value.is_number_unsigned() || value.get<std::size_t>() > largest)
      fail("a number of \"" + key + "\" is not an integer in its range");
    return value.get<std::size_t>();
  }

  static bool flag(const Json& object, const std::string& key)
  {
    const Json& value = member(object, key);
    if (!value.is_boolean())
      fail("\"" + key + "\" is neither true nor false");
    return value.get<bool>();
  }

  static double number(const Json& object, const std::string& key)
  {
    const Json& value = member(object, key);
    if (value == infinity_string)
      return std::numeric_limits<double>::infinity();
    if (value == minus_infinity_string)
      return -std::numeric_limits<double>::infinity();
    if (value == nan_string)
      return std::numeric_limits<double>::quiet_NaN();
    if (!value.is_number())
      fail("\"" + key + "\" is not a number");
    return value.get<double>();
  }

  static double number_but_nan(const Json& object, const std::string& key)
  {
    const double result = number(object, key);
    if (std::isnan(result))
      fail("\"" + key + "\" is not a number");
    return result;
  }

  static Cut_state cut_state(const Json& node)
  {
    for (const auto& [state, name] : names_of_cut_states)
      if (member(node, "cut_state") == name)
        return state;
    fail("\"cut_state\" is none of its words");
  }

  std::size_t node_index(const Json& value, const std::string& key) const
  {
    if (cuts_.nodes.empty())
      fail("there are no nodes");
    return count(value, key, cuts_.nodes.size() - 1);
  }

  void read_node(const Json& json, std::size_t i)
  {
    Cut_node& n = cuts_.nodes[i];
    if (node_index(member(json, "id"), "id") != i)
      fail("the nodes are not in the order of their \"id\"");
    const Json& parent = member(json, "parent");
    if (parent.is_null() != (i < cuts_.number_of_roots))
      fail("the first nodes are not the roots");
    if (!parent.is_null())
      n.parent = node_index(parent, "parent");
    const Json& children = array(json, "children");
    if (children.size() != 0 && children.size() != 2)
      fail("a node has not two \"children\"");
    for (std::size_t k = 0; k < children.size(); ++k)
      n.children[k] = node_index(children[k], "children");
    n.area = number_but_nan(json, "area");
    if (n.area < 0)
      fail("an \"area\" is negative");
    n.cut_state = cut_state(json);
    if ((n.cut_state == Cut_state::CUT) == n.is_leaf())
      fail("a node has children if and only if its \"cut_state\" is \"cut\"");
    if (n.cut_state != Cut_state::CUT && n.cut_state != Cut_state::REJECTED)
      return;
    n.salience = number_but_nan(json, "salience");
    const Json& factors = member(json, "factors");
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
    for (const Json& value : array(json_, "cut_order")) {
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

  void read_faces(const Json& nodes)
  {
    std::vector<std::size_t> size(cuts_.nodes.size(), 0);
    for (const Json& value : array(json_, "leaf_of_face")) {
      const std::size_t leaf = node_index(value, "leaf_of_face");
      if (!cuts_.nodes[leaf].is_leaf())
        fail("a node of \"leaf_of_face\" has children");
      cuts_.leaf.push_back(static_cast<Index>(leaf));
      ++size[leaf];
    }
    if (cuts_.leaf.size() != count(member(json_, "number_of_faces"), "number_of_faces", largest_))
      fail("\"leaf_of_face\" has not \"number_of_faces\" numbers");
    const std::vector<std::size_t> order = parents_first(cuts_);
    for (std::size_t k = order.size(); k-- > cuts_.number_of_roots;)
      size[cuts_.nodes[order[k]].parent] += size[order[k]];
    for (std::size_t i = 0; i < size.size(); ++i)
      if (size[i] == 0 || count(member(nodes[i], "faces"), "faces", largest_) != size[i])
        fail("a node has not as many \"faces\" as \"leaf_of_face\" says");
  }

  // Returns how many of the three edges of a face lead to another face.
  std::ptrdiff_t edges_to(Index from, Index to) const
  {
    const auto first = cuts_.neighbors.begin() + 3 * std::ptrdiff_t(from);
    return std::count(first, first + 3, to);
  }

  // Returns whether two neighbors are mutual. Smoothing then ends because each step makes
  // boundaries shorter. A constrained face has itself for neighbors, and is not smoothed.
  bool is_neighbor(Index f, Index g) const
  { return f == g || edges_to(f, g) == edges_to(g, f) || edges_to(g, g) == 3; }

  void read_neighbors()
  {
    if (!json_.contains("neighbors_of_faces"))
      return;
    const Json& neighbors = array(json_, "neighbors_of_faces");
    const std::size_t n = cuts_.leaf.size();
    if (n == 0 || neighbors.size() != 3 * n)
      fail("\"neighbors_of_faces\" has not three numbers for each face");
    for (const Json& value : neighbors)
      cuts_.neighbors.push_back(
        static_cast<Index>(count(value, "neighbors_of_faces", n - 1)));
    for (std::size_t h = 0; h < 3 * n; ++h) {
      if (!is_neighbor(static_cast<Index>(h / 3), cuts_.neighbors[h]))
        fail("of two faces in \"neighbors_of_faces\" only one is a neighbor of the other");
    }
  }

public:
  explicit Hierarchy_reader(const Json& json) : json_(json) {}

  Segmentation_hierarchy operator()()
  {
    if (!json_.is_object() || !json_.contains("format") || json_["format"] != name_of_format)
      fail("this is not a hierarchy");
    if (member(json_, "version") != version_of_format)
      fail("its version is not " + std::to_string(version_of_format));
    const Json& nodes = array(json_, "nodes");
    if (nodes.size() > largest_)
      fail("there are too many nodes");
    cuts_.nodes.resize(nodes.size());
    cuts_.number_of_roots =
      count(member(json_, "number_of_roots"), "number_of_roots", nodes.size());
    cuts_.is_monotonic = flag(json_, "is_monotonic");
    cuts_.has_all_cuts = flag(json_, "has_all_cuts");
    for (std::size_t i = 0; i < nodes.size(); ++i)
      read_node(nodes[i], i);
    check_tree();
    read_order();
    read_faces(nodes);
    read_neighbors();

    const double threshold = number_but_nan(json_, "salience_threshold");
    const Json& maximum = member(json_, "maximum_number_of_segments");
    return Segmentation_hierarchy(
      std::move(cuts_),
      maximum.is_null() ? unlimited : count(maximum, "maximum_number_of_segments", unlimited),
      threshold);
  }

  // Returns the nodes of the segments that were written.
  static std::vector<std::size_t> segments(const Json& json, const Segmentation_hierarchy& h)
  {
    std::vector<std::size_t> result;
    for (const Json& segment : array(json, "segments"))
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

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_HIERARCHY_OF_JSON_H
