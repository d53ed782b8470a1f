// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/IO/hierarchy_json.h>
#include <CGAL/segment_spectral_recursive.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(hierarchy_json)

using namespace test_meshes;
namespace tt = boost::test_tools;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using CGAL::Spectral_segmentation::read_hierarchy;
using CGAL::Spectral_segmentation::write_hierarchy;

namespace {

typedef nlohmann::ordered_json Json;
typedef std::vector<std::size_t> Nodes;

const double infinity = std::numeric_limits<double>::infinity();
const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

template <class... Arguments>
std::string written(const Segmentation_hierarchy& hierarchy, const Arguments&... arguments)
{
  std::ostringstream out;
  write_hierarchy(out, hierarchy, arguments...);
  return out.str();
}

Segmentation_hierarchy read_back(const std::string& text)
{
  std::istringstream in(text);
  return read_hierarchy(in);
}

bool has_same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// The labels, or nothing where they are not known.
Labels labels_or_nothing(const Segmentation_hierarchy& h, std::size_t n, double threshold)
{
  try {
    return labels_above(h, threshold, n);
  }
  catch (const std::out_of_range&) {
    return {};
  }
}

void check_equal(const Segmentation_hierarchy& a, const Segmentation_hierarchy& b)
{
  BOOST_TEST_REQUIRE(a.number_of_nodes() == b.number_of_nodes());
  BOOST_TEST(a.number_of_roots() == b.number_of_roots());
  BOOST_TEST(a.salience_threshold() == b.salience_threshold());
  for (std::size_t i = 0; i < a.number_of_nodes(); ++i) {
    const Segmentation_hierarchy::Node &m = a.node(i), &n = b.node(i);
    BOOST_TEST(m.parent == n.parent);
    BOOST_TEST(m.children == n.children, tt::per_element());
    BOOST_TEST((m.cut_state == n.cut_state));
    BOOST_TEST(has_same_bits(m.area, n.area));
    BOOST_TEST(has_same_bits(m.salience, n.salience));
    BOOST_TEST(m.factors.is_boundary == n.factors.is_boundary);
    for (const auto& [name, value] : CGAL::Spectral_segmentation::internal::named_factors)
      BOOST_TEST(has_same_bits(m.factors.*value, n.factors.*value));
    BOOST_TEST(a.faces(i) == b.faces(i), tt::per_element());
  }
  BOOST_TEST(run_labels(a) == run_labels(b), tt::per_element());
  for (std::size_t n = 0; n <= a.number_of_segments(); ++n) {
    BOOST_TEST(labels_of_number(a, n) == labels_of_number(b, n), tt::per_element());
    BOOST_TEST(a.nodes(n) == b.nodes(n), tt::per_element());
  }
  for (double threshold : {-infinity, 0.2, 0.5, 0.9, infinity})
    for (std::size_t n : {std::size_t(4), unlimited})
      BOOST_TEST(labels_or_nothing(a, n, threshold) == labels_or_nothing(b, n, threshold),
                 tt::per_element());
}

void check_round_trip(const Segmentation_hierarchy& hierarchy)
{
  const std::string text = written(hierarchy);
  const Segmentation_hierarchy again = read_back(text);
  check_equal(again, hierarchy);
  BOOST_TEST(written(again) == text);
}

// A salience as strange as a user-defined one may be.
struct Strange_salience
{
  double operator()(const CGAL::Spectral_segmentation::Salience_factors& f) const
  { return f.size > 0.3 ? infinity : f.size < 0.1 ? -infinity : -f.size / 3; }
};

Segmentation_hierarchy small_hierarchy()
{ return hierarchy_of(mesh_of(dumbbell(8, 8)), parameters::maximum_number_of_segments(4)); }

// Returns the error message for a text with a change.
std::string error_of(const std::function<void(Json&)>& change)
{
  static const std::string text = written(small_hierarchy());
  Json json = Json::parse(text);
  change(json);
  try {
    read_back(json.dump());
  }
  catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part)
{ return text.find(part) != std::string::npos; }

// One of all values within a value.
Json& random_value(Json& json, std::mt19937& random)
{
  Json* value = &json;
  while (value->is_structured() && !value->empty() && random() % 8 != 0) {
    auto child = value->begin();
    std::advance(child, std::ptrdiff_t(random() % value->size()));
    value = &*child;
  }
  return *value;
}

void change_value(Json& json, std::mt19937& random)
{
  Json& value = random_value(json, random);
  const Json other = random_value(json, random);
  switch (random() % 8) {
    case 0: value = Json(); break;
    case 1: value = "infinity"; break;
    case 2: value = -1; break;
    case 3: value = random() % 12; break;
    case 4: value = 0.5; break;
    case 5: value = std::size_t(-1) - random() % 3; break;
    case 6: value = other; break;
    default:
      if (value.is_array() && !value.empty())
        value.erase(random() % value.size());
      else if (value.is_object() && !value.empty())
        value.erase(value.begin());
  }
}

void change_bytes(std::string& text, std::mt19937& random)
{
  const std::string bytes = "0123456789-+.eE{}[]\",:\\ \x01\xff";
  for (std::size_t k = 1 + random() % 3; k-- > 0;) {
    const std::size_t i = random() % text.size();
    switch (random() % 4) {
      case 0: text.erase(i, 1 + random() % 20); break;
      case 1: text.insert(i, 1, bytes[random() % bytes.size()]); break;
      case 2: text.resize(i + 1); break;
      default: text[i] = bytes[random() % bytes.size()];
    }
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(a_hierarchy_that_is_read_is_the_one_that_was_written)
{
  check_round_trip(Segmentation_hierarchy());
  const auto check_runs = [](const Mesh& mesh, const auto& np) {
    check_round_trip(hierarchy_of(mesh, np));
    check_round_trip(hierarchy_of(mesh, np.number_of_segments(25).smooth_boundaries(true)));
    check_round_trip(hierarchy_of(mesh, np.salience_threshold(-infinity)
                                          .maximum_number_of_segments(6)
                                          .part_salience(Strange_salience())));
  };
  for (const Mesh& mesh : {mesh_of(doll()), mesh_of(dumbbell(8, 8)),
                           mesh_of(disjoint_union(dumbbell(14, 10), torus(3, 1, 20, 10)))})
    check_runs(mesh, parameters::zhang_liu_2005());
  check_runs(mesh_of(disjoint_union(dumbbell(8, 8), torus(3, 1, 20, 10))),
             parameters::default_values());
}

// With a large minimum size the search finds few cuts, and segments are halved.
BOOST_AUTO_TEST_CASE(an_exact_number_of_segments_is_read_back)
{
  for (unsigned seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const std::size_t nu = 3 + random() % 3, nv = 3 + random() % 3;
      const Mesh mesh = mesh_of(displaced(torus(1, 0.4, nu, nv), 0.1, random));
      const std::size_t n = 2 + random() % (num_faces(mesh) - 1);
      const Segmentation_hierarchy hierarchy = hierarchy_of(
        mesh, parameters::zhang_liu_2005().number_of_segments(n).minimum_segment_size(0.25));
      for (std::size_t k = 1; k <= n; ++k)
        BOOST_TEST(number_of(labels_of_number(hierarchy, k)) == k);
      check_round_trip(hierarchy);
    }
}

BOOST_AUTO_TEST_CASE(changes_by_hand_are_kept)
{
  const Mesh mesh = mesh_of(doll());
  Segmentation_hierarchy hierarchy = hierarchy_of(mesh, parameters::default_values());
  Nodes nodes = hierarchy.nodes(5);
  nodes[1] = hierarchy.merge(nodes[1], nodes[4]);
  nodes.pop_back();
  check_round_trip(hierarchy);
  std::istringstream in(written(hierarchy, nodes));
  Nodes again;
  check_equal(read_hierarchy(in, again), hierarchy);
  BOOST_TEST(again == nodes, tt::per_element());
}

BOOST_AUTO_TEST_CASE(a_hierarchy_of_duplicate_faces_is_read_back)
{
  std::size_t changes = 0;
  for (unsigned seed = 0; seed < 20; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Soup soup = displaced(seed % 2 == 0 ? sphere(2) : dumbbell(8, 8), 0.3, random);
      const std::size_t n = soup.triangles.size();
      std::vector<std::size_t> first(n);
      std::iota(first.begin(), first.end(), std::size_t(0));
      for (std::size_t i = 0; i < n; ++i) {
        first.push_back(random() % n);
        soup.triangles.push_back(soup.triangles[first.back()]);
      }
      Segmentation_hierarchy hierarchy;
      Labels labels(2 * n);
      CGAL::segment_spectral_recursive(
        soup.points, soup.triangles, labels.data(),
        parameters::hierarchy(hierarchy).number_of_segments(8).smooth_boundaries(true));
      for (std::size_t k = 1; k <= 8; ++k) {
        labels = labels_of_number(hierarchy, k);
        BOOST_TEST(number_of(labels) == k);
        for (std::size_t f = 0; f < labels.size(); ++f)
          BOOST_TEST(labels[f] == labels[first[f]]);
      }
      for (std::size_t i : hierarchy.nodes())
        for (std::size_t f : hierarchy.faces(i))
          changes += labels[f] != labels[*hierarchy.faces(i).begin()];
      check_round_trip(hierarchy);
    }
  BOOST_TEST(changes > 100);
}

// Compared with the areas in a smaller unit. Powers of two round nothing; the largest is 4e300.
BOOST_AUTO_TEST_CASE(the_largest_coordinates_have_areas)
{
  Soup creased = plate(6, 4); // some faces have no area
  for (Point& p : creased.points)
    if (p.x() < 2.5)
      p = Point(0, p.y(), 0);
  for (const Soup& soup : {sphere(1), plate(6, 4), creased})
    for_both_methods([&](const auto& np) {
      const std::size_t n = soup.triangles.size();
      const Segmentation_hierarchy expected =
        hierarchy_of(mesh_of(soup), np.number_of_segments(n));
      for (int exponent : {498, 510, 520, 700, 998}) {
        const Mesh mesh = mesh_of(scaled(soup, std::ldexp(1., exponent)));
        const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, np.number_of_segments(n));
        for (std::size_t k = 1; k <= n; ++k)
          BOOST_TEST((labels_of_number(hierarchy, k) == labels_of_number(expected, k)));
        for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i)
          BOOST_TEST(hierarchy.node(i).area == std::ldexp(expected.node(i).area, 2 * exponent));
        check_round_trip(hierarchy);
        check_equal(read_back(written(hierarchy, hierarchy.nodes(7), mesh)), hierarchy);
      }
    });
}

// Compared with the halfedges and the faces of the segments.
BOOST_AUTO_TEST_CASE(the_segments_are_described)
{
  const Soup soup = doll();
  const Mesh mesh = mesh_of(soup);
  for_both_methods([&](const auto& np) {
    const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, np.salience_threshold(0.3));
    const Nodes nodes = hierarchy.nodes(5);
    const Labels labels = labels_of_number(hierarchy, 5);
    const std::string text = written(hierarchy, nodes, mesh);
    BOOST_TEST(written(hierarchy, nodes, soup.points, soup.triangles) == text);
    const Json json = Json::parse(text);
    BOOST_TEST(json["leaf_of_face"].size() == num_faces(mesh));
    BOOST_TEST_REQUIRE(json["segments"].size() == nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Json& segment = json["segments"][k];
      std::set<std::size_t> neighbors;
      std::array<std::array<double, 3>, 2> box;
      box[0].fill(infinity);
      box[1].fill(-infinity);
      std::size_t number = 0;
      for (Mesh::Face_index f : faces(mesh)) {
        if (labels[f] != k)
          continue;
        ++number;
        for (Mesh::Halfedge_index h : halfedges_around_face(halfedge(f, mesh), mesh)) {
          const Mesh::Face_index g = face(opposite(h, mesh), mesh);
          if (g != Mesh::null_face() && labels[g] != k)
            neighbors.insert(labels[g]);
          for (int i = 0; i < 3; ++i) {
            const double x = mesh.point(target(h, mesh))[i];
            box[0][i] = (std::min)(box[0][i], x);
            box[1][i] = (std::max)(box[1][i], x);
          }
        }
      }
      BOOST_TEST(segment["id"] == k);
      BOOST_TEST(segment["node"] == nodes[k]);
      BOOST_TEST(segment["faces"] == number);
      BOOST_TEST(segment["area"] == hierarchy.node(nodes[k]).area);
      BOOST_TEST((segment["neighbors"] == Json(neighbors)));
      BOOST_TEST((segment["bounding_box"] == Json(box)));
    }
    std::size_t number_applied = 0;
    for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
      const Json& node = json["nodes"][i];
      number_applied += node["is_applied"].get<bool>();
      std::set<std::size_t> segments;
      for (std::size_t f : hierarchy.faces(i))
        segments.insert(labels[f]);
      BOOST_TEST(node["is_applied"] == (segments.size() > 1));
    }
    BOOST_TEST(number_applied == nodes.size() - 1);
  });
}

BOOST_AUTO_TEST_CASE(wrong_arguments_are_refused)
{
  const Mesh mesh = mesh_of(doll());
  const Segmentation_hierarchy hierarchy = small_hierarchy();
  BOOST_CHECK_THROW(written(hierarchy, Nodes{}), std::invalid_argument);
  BOOST_CHECK_THROW(written(hierarchy, hierarchy.nodes(), mesh), std::invalid_argument);
  std::ostringstream out;
  out.setstate(std::ios::failbit);
  BOOST_CHECK_THROW(write_hierarchy(out, hierarchy), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(each_contradiction_is_named)
{
  typedef Json& J;
  BOOST_TEST(error_of([](J) {}) == "");
  BOOST_TEST(contains(error_of([](J j) { j["format"] = "x"; }), "not a hierarchy"));
  BOOST_TEST(contains(error_of([](J j) { j = Json::array(); }), "not a hierarchy"));
  BOOST_TEST(contains(error_of([](J j) { j["version"] = 2; }), "version"));
  BOOST_TEST(contains(error_of([](J j) { j.erase("nodes"); }), "\"nodes\" is missing"));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"].push_back(1); }), "object"));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"] = Json::array(); }), "in its range"));
  BOOST_TEST(contains(error_of([](J j) { j["number_of_roots"] = 2; }), "roots"));
  BOOST_TEST(contains(error_of([](J j) { j["number_of_faces"] = 7; }), "number_of_faces"));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][0]["id"] = 1; }), "\"id\""));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][1]["parent"] = 2; }), "do not agree"));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][0]["children"] = {1, 1}; }), "do not agree"));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][0]["children"] = {1}; }), "two \"children\""));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][0]["children"] = {1, 99}; }), "its range"));
  BOOST_TEST(contains(error_of([](J j) {
    std::swap(j["nodes"][0]["children"][0], j["nodes"][0]["children"][1]);
    j["nodes"][1]["area"] = 1;
    j["nodes"][2]["area"] = 2;
  }), "the larger"));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][0]["area"] = "nan"; }), "\"area\""));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][0]["area"] = -1; }), "negative"));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][0]["cut_state"] = "no cut"; }), "\"cut\""));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][0]["cut_state"] = "x"; }), "words"));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][0]["salience"] = "nan"; }), "\"salience\""));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][0]["factors"]["size"] = "x"; }), "\"size\""));
  BOOST_TEST(contains(error_of([](J j) { j["nodes"][1]["faces"] = 1; }), "\"faces\""));
  BOOST_TEST(contains(error_of([](J j) { j["cut_order"].erase(0); }), "cut_order"));
  BOOST_TEST(contains(error_of([](J j) { j["cut_order"].push_back(0); }), "twice"));
  BOOST_TEST(contains(error_of([](J j) { j["leaf_of_face"][0] = 0; }), "has children"));
  BOOST_TEST(contains(error_of([](J j) { j["leaf_of_face"][0] = 99; }), "leaf_of_face"));
  BOOST_TEST(contains(error_of([](J j) { j["leaf_of_face"][0] = 0.5; }), "leaf_of_face"));
  BOOST_TEST(contains(error_of([](J j) { j["leaf_of_face"].erase(0); }), "number_of_faces"));
  BOOST_TEST(contains(error_of([](J j) {
    j["neighbors_of_faces"] = Json::array();
    for (std::size_t f = 0; f < j["leaf_of_face"].size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        j["neighbors_of_faces"].push_back(k == 0 ? 1 - std::min(f, std::size_t(1)) : 2);
  }), "only one is a neighbor"));
  BOOST_TEST(contains(error_of([](J j) { j["salience_threshold"] = Json(); }), "salience"));

  // A cycle that no root reaches: two nodes that are each other's parent.
  BOOST_TEST(error_of([](J j) {
    Json& nodes = j["nodes"];
    std::size_t leaf = 1;
    while (!nodes[leaf]["children"].empty())
      ++leaf;
    nodes[leaf]["children"] = {leaf, leaf};
    nodes[leaf]["parent"] = leaf;
    nodes[leaf]["cut_state"] = "cut";
  }) != "");

  for (const char* text : {"", "{", "[1, 2", "null", "{\"format\": \"\xff\"}", "1e999"})
    BOOST_CHECK_THROW(read_back(text), std::runtime_error);
  BOOST_CHECK_THROW(read_back(std::string(1000000, '[')), std::runtime_error);
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  BOOST_CHECK_THROW(read_back("{\"format\": " + deep + "}"), std::runtime_error);
}

// Their reading took quadratic time.
BOOST_AUTO_TEST_CASE(many_cuts_and_many_foreign_keys_are_read)
{
  CGAL::Spectral_segmentation::internal::Cut_hierarchy cuts;
  cuts.number_of_roots = 1;
  cuts.nodes.resize(1);
  cuts.nodes[0].area = 15001;
  for (std::size_t i = 0; i < 30000; i += 2) { // each cut separates one face
    cuts.cut(i, 1, cuts.nodes[i].area - 1);
    cuts.nodes[i].cut_state = CGAL::Spectral_segmentation::internal::Cut_state::CUT;
    cuts.cut_order.push_back(i);
    cuts.leaf.push_back(static_cast<Index>(i + 1));
  }
  cuts.leaf.push_back(30000);
  const std::string many_cuts = written(Segmentation_hierarchy(cuts, unlimited, 0), Nodes{0});
  std::string many_keys = written(small_hierarchy());
  many_keys.resize(many_keys.rfind('}'));
  for (int i = 0; i < 30000; ++i)
    many_keys += ",\"key" + std::to_string(i) + "\":0";
  many_keys += "}";
  BOOST_TEST(written(read_back(many_cuts), Nodes{0}) == many_cuts);
  BOOST_TEST(written(read_back(many_keys)) == written(small_hierarchy()));
}

// Whatever is read is a hierarchy whose functions work.
BOOST_AUTO_TEST_CASE(no_change_of_a_file_does_harm)
{
  const std::string valid = written(hierarchy_of(
    mesh_of(dumbbell(4, 4)), parameters::smooth_boundaries(true).maximum_number_of_segments(4)));
  const Json json = Json::parse(valid);
  std::mt19937 random(1);
  std::size_t number_read = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = valid;
    if (i % 2 == 0)
      change_bytes(text, random);
    else {
      Json changed = json;
      change_value(changed, random);
      text = changed.dump();
    }
    try {
      std::istringstream in(text);
      Nodes nodes;
      const Segmentation_hierarchy h = read_hierarchy(in, nodes);
      ++number_read;
      for (std::size_t n = 0; n <= h.number_of_segments(); ++n)
        BOOST_TEST(h.nodes(n).size() == (std::max)(n, h.number_of_roots()));
      labels_or_nothing(h, unlimited, 0.1);
      BOOST_TEST(written(read_back(written(h, nodes))) == written(h));
    }
    catch (const std::runtime_error& e) {
      BOOST_TEST(contains(e.what(), "read_hierarchy: "));
    }
  }
  BOOST_TEST(number_read > 20);
  BOOST_TEST(number_read < 1000);
}

BOOST_AUTO_TEST_SUITE_END()
