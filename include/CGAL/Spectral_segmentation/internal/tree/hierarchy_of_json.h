// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TREE_HIERARCHY_OF_JSON_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TREE_HIERARCHY_OF_JSON_H

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/tree/json_of_hierarchy.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

typedef nlohmann::json::value_t Json_kind;

// A value of a JSON text. The elements of an array, or the members of an object, follow it; each
// is followed by its own. Iterating over a value gives its elements or members.
struct Json_value
{
  struct Iterator
  {
    const Json_value* value;

    const Json_value& operator*() const { return *value; }
    Iterator& operator++() { value += value->size; return *this; }
    bool operator!=(const Iterator& other) const { return value != other.value; }
  };

  Json_kind kind;
  std::size_t size;        // the number of values from this one to the last one within it
  std::size_t key;         // the place of its key, if it is a member of an object
  std::uint64_t count = 0; // an unsigned number, a Boolean value, the place of a string, or the
                           // number of elements or members
  double number = 0;       // any number

  bool is_number() const
  {
    return kind == Json_kind::number_unsigned || kind == Json_kind::number_integer ||
           kind == Json_kind::number_float;
  }

  Iterator begin() const { return {this + 1}; }
  Iterator end() const { return {this + size}; }
};

// The values of a JSON text, which its parser reports one by one. They take linear time and memory
// for all texts, because nothing is looked up and no value allocates memory of its own.
class Json_values
{
  static constexpr std::size_t largest_depth_ = 10; // the JSON of a hierarchy is 5 levels deep

  std::vector<Json_value> values_;
  std::string texts_;             // the keys and strings, each with a final 0
  std::vector<std::size_t> open_; // the arrays and objects that have not ended yet
  std::size_t key_ = 0;           // the place of the last key

  bool add(Json_kind kind, std::uint64_t count = 0, double number = 0)
  {
    if (!open_.empty())
      ++values_[open_.back()].count;
    values_.push_back({kind, 1, key_, count, number});
    return true;
  }

  std::size_t add_text(const std::string& text)
  {
    const std::size_t place = texts_.size();
    texts_.append(text.c_str(), text.size() + 1);
    return place;
  }

  bool open(Json_kind kind)
  {
    if (open_.size() == largest_depth_)
      throw std::runtime_error("read_hierarchy: the JSON is nested too deep");
    add(kind);
    open_.push_back(values_.size() - 1);
    return true;
  }

  bool close()
  {
    values_[open_.back()].size = values_.size() - open_.back();
    open_.pop_back();
    return true;
  }

public:
  // Parses a text.
  explicit Json_values(std::istream& is) { nlohmann::json::sax_parse(is, this); }

  const Json_value& root() const { return values_.front(); }
  const char* key(const Json_value& value) const { return texts_.c_str() + value.key; }

  const char* string(const Json_value& value) const { return texts_.c_str() + value.count; }

  // The functions that the parser calls
  bool null() { return add(Json_kind::null); }
  bool boolean(bool value) { return add(Json_kind::boolean, value); }
  bool number_integer(std::int64_t value)
  { return add(Json_kind::number_integer, 0, static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value)
  { return add(Json_kind::number_unsigned, value, static_cast<double>(value)); }
  bool number_float(double value, const std::string&)
  { return add(Json_kind::number_float, 0, value); }
  bool string(const std::string& value) { return add(Json_kind::string, add_text(value)); }
  template <class Binary> bool binary(const Binary&) { return false; }
  bool start_object(std::size_t) { return open(Json_kind::object); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(Json_kind::array); }
  bool end_array() { return close(); }

  bool key(const std::string& value)
  {
    key_ = add_text(value);
    return true;
  }

  [[noreturn]] bool parse_error(std::size_t byte, const std::string&,
                                const nlohmann::json::exception& e)
  {
    if (dynamic_cast<const nlohmann::json::parse_error*>(&e) == nullptr)
      throw std::runtime_error("read_hierarchy: a number is too large");
    throw std::runtime_error("read_hierarchy: the JSON is not well-formed at byte " +
                             std::to_string(byte));
  }
};

// Reads the JSON that json_of_hierarchy.h writes. Checks everything that the functions of a
// hierarchy rely on, and throws `std::runtime_error`.
class Hierarchy_reader
{
  static constexpr std::size_t largest_ = null_index / 3 - 1;

  const Json_values json_;
  const Json_value& root_;
  Cut_hierarchy cuts_;
  std::vector<std::size_t> number_of_faces_; // one per node

  [[noreturn]] static void fail(const std::string& what)
  { throw std::runtime_error("read_hierarchy: " + what); }

  [[noreturn]] static void fail(const char* key, const char* what)
  { fail("\"" + std::string(key) + "\" " + what); }

  // Returns the first member with this key, or null.
  const Json_value* find(const Json_value& object, const char* key) const
  {
    for (const Json_value& value : object)
      if (std::strcmp(json_.key(value), key) == 0)
        return &value;
    return nullptr;
  }

  const Json_value& member(const Json_value& object, const char* key) const
  {
    if (object.kind != Json_kind::object)
      fail("there is something else than the object with \"" + std::string(key) + "\"");
    const Json_value* result = find(object, key);
    if (result == nullptr)
      fail(key, "is missing");
    return *result;
  }

  const Json_value& array(const Json_value& object, const char* key) const
  {
    const Json_value& result = member(object, key);
    if (result.kind != Json_kind::array)
      fail(key, "is not an array");
    return result;
  }

  static std::size_t count(const Json_value& value, const char* key, std::size_t largest)
  {
    if (value.kind != Json_kind::number_unsigned || value.count > largest)
      fail("a number of \"" + std::string(key) + "\" is not an integer in its range");
    return static_cast<std::size_t>(value.count);
  }

  bool flag(const Json_value& object, const char* key) const
  {
    const Json_value& value = member(object, key);
    if (value.kind != Json_kind::boolean)
      fail(key, "is neither true nor false");
    return value.count != 0;
  }

  bool is_string(const Json_value& value, const char* string) const
  { return value.kind == Json_kind::string && std::strcmp(json_.string(value), string) == 0; }

  double number(const Json_value& object, const char* key) const
  {
    const Json_value& value = member(object, key);
    if (value.is_number())
      return value.number;
    if (is_string(value, infinity_string))
      return std::numeric_limits<double>::infinity();
    if (is_string(value, minus_infinity_string))
      return -std::numeric_limits<double>::infinity();
    if (!is_string(value, nan_string))
      fail(key, "is not a number");
    return std::numeric_limits<double>::quiet_NaN();
  }

  double number_but_nan(const Json_value& object, const char* key) const
  {
    const double result = number(object, key);
    if (std::isnan(result))
      fail(key, "is not a number");
    return result;
  }

  Cut_state cut_state(const Json_value& node) const
  {
    const Json_value& value = member(node, "cut_state");
    for (const auto& [state, name] : names_of_cut_states)
      if (is_string(value, name))
        return state;
    fail("cut_state", "is none of its words");
  }

  std::size_t node_index(const Json_value& value, const char* key) const
  {
    if (cuts_.nodes.empty())
      fail("there are no nodes");
    return count(value, key, cuts_.nodes.size() - 1);
  }

  void read_node(const Json_value& json, std::size_t i)
  {
    Cut_node& n = cuts_.nodes[i];
    if (node_index(member(json, "id"), "id") != i)
      fail("the nodes are not in the order of their \"id\"");
    const Json_value& parent = member(json, "parent");
    const bool is_root = parent.kind == Json_kind::null;
    if (is_root != (i < cuts_.number_of_roots))
      fail("the first nodes are not the roots");
    if (!is_root)
      n.parent = node_index(parent, "parent");
    const Json_value& children = array(json, "children");
    if (children.count != 0 && children.count != 2)
      fail("a node has not two \"children\"");
    std::size_t* next = n.children;
    for (const Json_value& child : children)
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
    const Json_value& factors = member(json, "factors");
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
    for (const Json_value& value : array(root_, "cut_order")) {
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
    for (const Json_value& value : array(root_, "leaf_of_face")) {
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
    if (find(root_, "neighbors_of_faces") == nullptr)
      return;
    const Json_value& neighbors = array(root_, "neighbors_of_faces");
    const std::size_t n = cuts_.leaf.size();
    if (n == 0 || neighbors.count != 3 * n)
      fail("\"neighbors_of_faces\" has not three numbers for each face");
    for (const Json_value& value : neighbors)
      cuts_.neighbors.push_back(
        static_cast<Index>(count(value, "neighbors_of_faces", n - 1)));
    for (std::size_t h = 0; h < 3 * n; ++h) {
      if (!is_neighbor(static_cast<Index>(h / 3), cuts_.neighbors[h]))
        fail("of two faces in \"neighbors_of_faces\" only one is a neighbor of the other");
    }
  }

public:
  explicit Hierarchy_reader(std::istream& is) : json_(is), root_(json_.root()) {}

  Segmentation_hierarchy operator()()
  {
    if (root_.kind != Json_kind::object || find(root_, "format") == nullptr ||
        !is_string(member(root_, "format"), name_of_format))
      fail("this is not a hierarchy");
    const Json_value& version = member(root_, "version");
    if (!version.is_number() || version.number != version_of_format)
      fail("its version is not " + std::to_string(version_of_format));
    const Json_value& nodes = array(root_, "nodes");
    if (nodes.count > largest_)
      fail("there are too many nodes");
    cuts_.nodes.resize(static_cast<std::size_t>(nodes.count));
    cuts_.number_of_roots =
      count(member(root_, "number_of_roots"), "number_of_roots", cuts_.nodes.size());
    cuts_.is_monotonic = flag(root_, "is_monotonic");
    cuts_.has_all_cuts = flag(root_, "has_all_cuts");
    std::size_t i = 0;
    for (const Json_value& node : nodes)
      read_node(node, i++);
    check_tree();
    read_order();
    read_faces();
    read_neighbors();

    const double threshold = number_but_nan(root_, "salience_threshold");
    const Json_value& maximum = member(root_, "maximum_number_of_segments");
    return Segmentation_hierarchy(
      std::move(cuts_),
      maximum.kind == Json_kind::null
        ? unlimited : count(maximum, "maximum_number_of_segments", unlimited),
      threshold);
  }

  // Returns the nodes of the segments that were written.
  std::vector<std::size_t> segments(const Segmentation_hierarchy& h) const
  {
    std::vector<std::size_t> result;
    for (const Json_value& segment : array(root_, "segments"))
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

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_TREE_HIERARCHY_OF_JSON_H
