// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "../hierarchy_json.h"
#include "box_figures.h"
#include "test_hierarchies.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
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

namespace {

typedef nlohmann::ordered_json Json;
typedef std::vector<std::size_t> Nodes;

const double infinity = std::numeric_limits<double>::infinity();
const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

std::string written(const Segmentation_hierarchy& hierarchy)
{
  std::ostringstream out;
  segment_mesh::write_json(out, hierarchy, segment_mesh::json_of_hierarchy(hierarchy));
  return out.str();
}

Segmentation_hierarchy read_back(const std::string& text)
{
  std::istringstream in(text);
  return segment_mesh::read_hierarchy_json(in);
}

void check_round_trip(const Segmentation_hierarchy& hierarchy)
{
  const std::string text = written(hierarchy);
  const Segmentation_hierarchy again = read_back(text);
  BOOST_TEST(written(again) == text);
  BOOST_TEST(run_labels(again) == run_labels(hierarchy), tt::per_element());
  for (std::size_t n = 0; n <= hierarchy.number_of_segments(); ++n)
    BOOST_TEST(labels_of_number(again, n) == labels_of_number(hierarchy, n), tt::per_element());
}

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
  for_each_hierarchy(check_round_trip);
}

// Compared with the halfedges and the faces of the segments.
BOOST_AUTO_TEST_CASE(the_segments_are_described)
{
  const Soup soup = doll();
  const Mesh mesh = mesh_of(soup);
  for_both_methods([&](const auto& np) {
    const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, np.salience_threshold(0.3));
    const Nodes nodes = hierarchy.nodes();
    BOOST_TEST(nodes.size() > 2);
    const Labels labels = run_labels(hierarchy);
    const Json json = segment_mesh::json_of_hierarchy(hierarchy, soup.points, soup.triangles);
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

BOOST_AUTO_TEST_CASE(a_stream_that_fails_is_reported)
{
  std::ostringstream out;
  out.setstate(std::ios::failbit);
  BOOST_CHECK_THROW(segment_mesh::write_json(out, small_hierarchy(), {}), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(errors_are_named)
{
  typedef Json& J;
  BOOST_TEST(error_of([](J) {}) == "");
  BOOST_TEST(contains(error_of([](J j) { j["format"] = "x"; }), "not a hierarchy"));
  BOOST_TEST(contains(error_of([](J j) { j = Json::array(); }), "not a hierarchy"));
  BOOST_TEST(contains(error_of([](J j) { j["version"] = 2; }), "version"));
  BOOST_TEST(contains(error_of([](J j) { j.erase("text"); }), "version"));
  BOOST_TEST(contains(error_of([](J j) { j["text"] = 1; }), "version"));
  BOOST_TEST(contains(error_of([](J j) { j["text"] = "x"; }), "not a hierarchy"));
  for (const char* text : {"", "{", "[1, 2", "null", "{\"format\": \"\xff\"}", "1e999"})
    BOOST_CHECK_THROW(read_back(text), std::runtime_error);
  BOOST_CHECK_THROW(read_back(std::string(1000000, '[')), std::runtime_error);
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  BOOST_CHECK_THROW(read_back("{\"format\": " + deep + "}"), std::runtime_error);
}

// Its reading took quadratic time.
BOOST_AUTO_TEST_CASE(many_foreign_keys_are_read)
{
  std::string many_keys = written(small_hierarchy());
  many_keys.resize(many_keys.rfind('}'));
  for (int i = 0; i < 30000; ++i)
    many_keys += ",\"key" + std::to_string(i) + "\":0";
  BOOST_TEST(written(read_back(many_keys + "}")) == written(small_hierarchy()));
}

// Whatever is read is a hierarchy whose functions work.
BOOST_AUTO_TEST_CASE(no_change_of_a_file_does_harm)
{
  const std::string valid = written(hierarchy_of(
    mesh_of(dumbbell(4, 4)), parameters::maximum_number_of_segments(4)));
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
      const Segmentation_hierarchy h = read_back(text);
      ++number_read;
      for (std::size_t n = 0; n <= h.number_of_segments(); ++n)
        BOOST_TEST(h.nodes(n).size() == (std::max)(n, h.number_of_roots()));
      labels_or_nothing(h, unlimited, 0.1);
      BOOST_TEST(written(read_back(written(h))) == written(h));
    }
    catch (const std::runtime_error& e) {
      BOOST_TEST(contains(e.what(), "read_hierarchy: "));
    }
  }
  BOOST_TEST(number_read > 20);
  BOOST_TEST(number_read < 1000);
}

BOOST_AUTO_TEST_SUITE_END()
