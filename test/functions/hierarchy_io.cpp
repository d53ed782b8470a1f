// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_hierarchies.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/IO/hierarchy.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <locale>
#include <numeric>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(hierarchy_io)

using namespace test_meshes;
namespace tt = boost::test_tools;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using CGAL::Spectral_segmentation::read_hierarchy;
using CGAL::Spectral_segmentation::write_hierarchy;

namespace {

typedef std::vector<std::size_t> Nodes;

const double infinity = std::numeric_limits<double>::infinity();
const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

std::string written(const Segmentation_hierarchy& hierarchy)
{
  std::ostringstream out;
  write_hierarchy(out, hierarchy);
  return out.str();
}

Segmentation_hierarchy read_back(const std::string& text)
{
  std::istringstream in(text);
  return read_hierarchy(in);
}

bool has_same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

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
    for (const auto& [name, value] : CGAL::Spectral_segmentation::named_factors)
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

// Returns the error message of reading a text.
std::string error_of(const std::string& text)
{
  try {
    read_back(text);
  }
  catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

// Returns a text with another word at a place, or without the word.
std::string with_word(const std::string& text, std::size_t place, const std::string& word)
{
  std::istringstream in(text);
  std::string result, next;
  for (std::size_t i = 0; in >> next; ++i)
    result += (i == place ? word : next) + ' ';
  return result;
}

bool contains(const std::string& text, const std::string& part)
{ return text.find(part) != std::string::npos; }

// Numbers with a comma for the point, and with points between thousands.
struct German_numbers : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

} // namespace

BOOST_AUTO_TEST_CASE(a_hierarchy_that_is_read_is_the_one_that_was_written)
{
  for_each_hierarchy(check_round_trip);
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
  Segmentation_hierarchy hierarchy = hierarchy_of(mesh_of(doll()), parameters::default_values());
  const Nodes nodes = hierarchy.nodes(5);
  hierarchy.merge(nodes[1], nodes[4]);
  check_round_trip(hierarchy);
}

BOOST_AUTO_TEST_CASE(a_hierarchy_of_duplicate_faces_is_read_back)
{
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
        parameters::hierarchy(hierarchy).number_of_segments(8));
      for (std::size_t k = 1; k <= 8; ++k) {
        labels = labels_of_number(hierarchy, k);
        BOOST_TEST(number_of(labels) == k);
        for (std::size_t f = 0; f < labels.size(); ++f)
          BOOST_TEST(labels[f] == labels[first[f]]);
      }
      check_round_trip(hierarchy);
    }
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
      }
    });
}

BOOST_AUTO_TEST_CASE(locales_make_no_difference)
{
  const Segmentation_hierarchy hierarchy =
    hierarchy_of(mesh_of(dumbbell(30, 30)), parameters::default_values());
  const std::string text = written(hierarchy);
  const std::locale before =
    std::locale::global(std::locale(std::locale::classic(), new German_numbers));
  const std::string again = written(hierarchy);
  const bool is_read = error_of(text).empty();
  std::locale::global(before);
  BOOST_TEST(again == text);
  BOOST_TEST(is_read);
}

BOOST_AUTO_TEST_CASE(errors_are_named)
{
  const Segmentation_hierarchy hierarchy =
    hierarchy_of(mesh_of(dumbbell(8, 8)), parameters::maximum_number_of_segments(4));
  const std::string text = written(hierarchy);
  BOOST_TEST(error_of(text) == "");
  BOOST_TEST(contains(error_of(""), "ends too early"));
  BOOST_TEST(contains(error_of("{}"), "not a hierarchy"));
  BOOST_TEST(error_of(text.substr(0, text.size() / 2)) != "");
  BOOST_TEST(contains(error_of(with_word(text, 1, "2")), "root"));
  BOOST_TEST(contains(error_of(with_word(text, 1, "-1")), "range"));
  BOOST_TEST(contains(error_of(with_word(text, 3, "nan")), "threshold"));
  BOOST_TEST(contains(error_of(with_word(text, 3, "1x")), "not a number"));
  BOOST_TEST(contains(error_of(with_word(text, 4, "2")), "range"));
  BOOST_TEST(contains(error_of(with_word(text, 6, "99999999999999999999")), "range"));
  BOOST_TEST(contains(error_of(with_word(text, 8, "-1")), "area"));
  BOOST_TEST(contains(error_of(with_word(text, 9, "nan")), "salience"));
  std::ostringstream out;
  out.setstate(std::ios::failbit);
  BOOST_CHECK_THROW(write_hierarchy(out, hierarchy), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(many_cuts_are_read)
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
  const std::string text = written(Segmentation_hierarchy(cuts, unlimited, 0));
  BOOST_TEST(written(read_back(text)) == text);
}

// Whatever is read is a hierarchy whose functions work.
BOOST_AUTO_TEST_CASE(no_change_of_a_file_does_harm)
{
  const std::string valid = written(hierarchy_of(
    mesh_of(dumbbell(4, 4)), parameters::maximum_number_of_segments(4)));
  const std::vector<std::string> words = {"0", "1", "2", "5", "-1", "0.5", "nan", "inf", "x", "",
                                          "4294967295", "18446744073709551615"};
  std::istringstream in(valid);
  std::size_t number_of_words = 0;
  for (std::string word; in >> word;)
    ++number_of_words;
  std::mt19937 random(1);
  std::size_t number_read = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string text = valid;
    for (std::size_t k = 1 + random() % 2; k-- > 0;)
      text = with_word(text, random() % number_of_words, words[random() % words.size()]);
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
  BOOST_TEST(number_read > 100);
  BOOST_TEST(number_read < 3000);
}

BOOST_AUTO_TEST_SUITE_END()
