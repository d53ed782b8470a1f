// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/hierarchy/region_merging.h>
#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(calibrated_method)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace internal = CGAL::Spectral_segmentation::internal;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using CGAL::Spectral_segmentation::Segmentation_visitor;

namespace {

const double infinity = std::numeric_limits<double>::infinity();
const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

auto calibrated() { return parameters::default_values(); }

template <class NamedParameters>
Labels labels_of(const Soup& soup, const NamedParameters& np)
{
  const Mesh mesh = mesh_of(soup);
  Labels labels;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, map_to(labels, mesh), np);
  BOOST_TEST(n == std::set<std::size_t>(labels.begin(), labels.end()).size());
  return labels;
}

Labels labels_of(const Soup& soup) { return labels_of(soup, calibrated()); }

std::size_t number_of(const Labels& labels)
{ return labels.empty() ? 0 : 1 + *std::max_element(labels.begin(), labels.end()); }

void check_numbering(const Mesh& mesh, const Labels& labels)
{
  std::size_t next = 0; // segments are numbered by their first face
  for (std::size_t label : labels) {
    BOOST_TEST_REQUIRE(label <= next);
    next += label == next;
  }
  BOOST_TEST(number_of_connected_pieces(mesh, labels) == next);
}

// The share of the pairs of faces that are together in both or in neither.
double rand_index(const Labels& a, const Labels& b)
{
  std::map<std::pair<std::size_t, std::size_t>, double> both;
  std::map<std::size_t, double> of_a, of_b;
  for (std::size_t f = 0; f < a.size(); ++f) {
    ++both[{a[f], b[f]}];
    ++of_a[a[f]];
    ++of_b[b[f]];
  }
  const auto pairs = [](double n) { return n * (n - 1) / 2; };
  double apart = 0;
  for (const auto& [label, n] : of_a)
    apart += pairs(n);
  for (const auto& [label, n] : of_b)
    apart += pairs(n);
  for (const auto& [labels, n] : both)
    apart -= 2 * pairs(n);
  return 1 - apart / pairs(double(a.size()));
}

const Soup& elephant()
{
  static const Soup soup = read("elephant.off");
  return soup;
}

const Segmentation_hierarchy& tree_of_elephant()
{
  static const Segmentation_hierarchy tree = [] {
    Segmentation_hierarchy t;
    labels_of(elephant(), calibrated().hierarchy(t));
    return t;
  }();
  return tree;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_sphere_stays_whole)
{
  for (std::size_t level : {1, 2, 3})
    BOOST_TEST(number_of(labels_of(sphere(level))) == 1);
}

BOOST_AUTO_TEST_CASE(a_dumbbell_is_cut_at_its_neck)
{
  const Soup soup = dumbbell(24, 20);
  const Labels labels = labels_of(soup);
  BOOST_TEST(number_of(labels) >= 2);
  BOOST_TEST(number_of(labels) <= 3);
  // Far from the neck there is one label on either side.
  std::set<std::size_t> low, high;
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const std::vector<std::size_t>& t = soup.triangles[f];
    const double z = (soup.points[t[0]].z() + soup.points[t[1]].z() + soup.points[t[2]].z()) / 3;
    if (std::abs(z) > 0.12) // two rings
      (z < 0 ? low : high).insert(labels[f]);
  }
  BOOST_TEST(low.size() == 1);
  BOOST_TEST(high.size() == 1);
  BOOST_TEST((low != high));
}

BOOST_AUTO_TEST_CASE(labels_for_any_number_of_segments_are_those_of_a_fresh_run)
{
  for (std::size_t n = 1; n <= 8; ++n) {
    const Labels fresh = labels_of(elephant(), calibrated().maximum_number_of_segments(n));
    BOOST_TEST(tree_of_elephant().labels(n, 0.5) == fresh, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(labels_for_any_number_without_a_threshold_are_those_of_a_fresh_run)
{
  const auto np = calibrated().salience_threshold(-infinity);
  Segmentation_hierarchy tree;
  labels_of(elephant(), np.hierarchy(tree));
  for (std::size_t n = 1; n <= 8; ++n) {
    const Labels fresh = labels_of(elephant(), np.maximum_number_of_segments(n));
    BOOST_TEST(number_of(fresh) == n);
    BOOST_TEST(tree.labels(n, -infinity) == fresh, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(as_many_segments_as_are_asked_for)
{
  const auto np = calibrated().salience_threshold(-infinity);
  const Mesh mesh = mesh_of(elephant());
  for (std::size_t n : {20, 21, 40}) {
    const Labels labels = labels_of(elephant(), np.maximum_number_of_segments(n));
    BOOST_TEST(number_of(labels) == n);
    check_numbering(mesh, labels);
  }
  BOOST_TEST(number_of(labels_of(elephant(), np)) == 20);
  BOOST_TEST(number_of(labels_of(elephant(), np.number_of_regions(7))) == 7);
  const Soup three = disjoint_union(dumbbell(16, 12), disjoint_union(sphere(2), sphere(1)));
  BOOST_TEST(number_of(labels_of(three, np.number_of_regions(6))) == 8);
  BOOST_TEST(number_of(labels_of(three, np.number_of_regions(6).maximum_number_of_segments(11))) ==
             11);
  BOOST_TEST(number_of(labels_of(dumbbell(6, 4), np.minimum_segment_size(0)
                                                   .number_of_regions(unlimited))) > 20);
}

BOOST_AUTO_TEST_CASE(labels_depend_on_the_maximum_only_above_the_number_of_pieces)
{
  Segmentation_hierarchy whole, up_to_10, up_to_30;
  labels_of(elephant(), calibrated().hierarchy(whole));
  labels_of(elephant(), calibrated().maximum_number_of_segments(10).hierarchy(up_to_10));
  labels_of(elephant(), calibrated().maximum_number_of_segments(30).hierarchy(up_to_30));
  BOOST_TEST(whole.number_of_segments() == 20);
  BOOST_TEST(up_to_30.number_of_segments() == 30);
  for (std::size_t n = 1; n <= 20; ++n)
    BOOST_TEST(whole.labels(n, -infinity) == up_to_10.labels(n, -infinity),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(an_observer_hears_of_the_cuts_that_are_judged)
{
  typedef internal::Judged_cut Judged_cut;
  const internal::Face_graph mesh =
    graph_with_distances(dumbbell(20, 16), weights_of_calibrated_method);
  const internal::Options options = internal::calibrated_options();
  Segmentation_visitor visitor;
  internal::Monitor<Segmentation_visitor> monitor(visitor);
  std::set<std::vector<internal::Index> > parts;
  std::size_t number_of[2] = {0, 0};
  std::set<double> saliences[2];
  const Segmentation_hierarchy tree = internal::cut_and_merge<CGAL::Sequential_tag>(
    mesh, options, monitor, [&](const Judged_cut& cut) {
      ++number_of[cut.kind];
      saliences[cut.kind].insert(options.part_salience(cut.factors));
      BOOST_TEST_REQUIRE(cut.side.size() == cut.faces.size());
      BOOST_TEST(std::is_sorted(cut.faces.begin(), cut.faces.end()));
      double area[2] = {0, 0};
      for (std::size_t i = 0; i < cut.faces.size(); ++i)
        area[int(cut.side[i])] += mesh.areas[cut.faces[i]];
      BOOST_TEST(cut.factors.size == area[0] / (area[0] + area[1]),
                 boost::test_tools::tolerance(1e-9));
      BOOST_TEST(cut.factors.log_relative_part_area ==
                 std::log((area[0] + area[1]) / internal::total_area(mesh)),
                 boost::test_tools::tolerance(1e-9));
      if (cut.kind == Judged_cut::CANDIDATE)
        parts.insert(cut.faces);
    });
  // Each cut into pieces was a candidate, and makes two parts that are searched; but the last one
  // ends the search. No part has more candidates than are taken and refined.
  const std::size_t pieces = tree.number_of_segments();
  BOOST_TEST(pieces == 20);
  BOOST_TEST(parts.size() <= 2 * pieces - 3);
  BOOST_TEST(parts.size() >= pieces - 1);
  BOOST_TEST(number_of[Judged_cut::CANDIDATE] <= parts.size() * (14 + 4));
  // Each merge is of a boundary.
  BOOST_TEST(number_of[Judged_cut::BOUNDARY] >= pieces - 1);
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
    if (!tree.node(i).is_leaf())
      BOOST_TEST(saliences[Judged_cut::BOUNDARY].count(tree.node(i).salience) == 1);
}

BOOST_AUTO_TEST_CASE(labels_for_any_threshold_are_those_of_a_fresh_run)
{
  for (double threshold : {-1., 0.1, 0.3, 0.5, 0.6, 0.8, 0.95, 2.})
    BOOST_TEST(tree_of_elephant().labels(unlimited, threshold) ==
               labels_of(elephant(), calibrated().salience_threshold(threshold)),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_child_is_at_most_as_salient_as_its_parent)
{
  const Segmentation_hierarchy& tree = tree_of_elephant();
  BOOST_TEST(tree.number_of_segments() > 5);
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i) {
    const Segmentation_hierarchy::Node& n = tree.node(i);
    BOOST_TEST(n.salience >= 0);
    BOOST_TEST(n.salience <= 1);
    if (i >= tree.number_of_roots())
      BOOST_TEST(n.salience <= tree.node(n.parent).salience);
    if (n.is_leaf())
      continue;
    const Segmentation_hierarchy::Node &small = tree.node(n.children[0]), &large = tree.node(n.children[1]);
    BOOST_TEST(small.area <= large.area);
  }
}

BOOST_AUTO_TEST_CASE(factors_are_those_of_the_mesh_that_is_searched)
{
  Segmentation_hierarchy tree;
  labels_of(elephant(), calibrated().number_of_searched_faces(0).hierarchy(tree));
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i) {
    const Segmentation_hierarchy::Node& n = tree.node(i);
    if (!n.is_leaf())
      BOOST_TEST(n.factors.size == tree.node(n.children[0]).area / n.area,
                 boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(labels_are_contiguous_and_segments_connected)
{
  const Mesh mesh = mesh_of(elephant());
  const Segmentation_hierarchy& tree = tree_of_elephant();
  for (std::size_t n = 1; n <= number_of(tree.labels(unlimited, 0.3)); ++n) {
    const Labels labels = tree.labels(n, 0.3);
    check_numbering(mesh, labels);
    BOOST_TEST(number_of(labels) == n);
  }
}

BOOST_AUTO_TEST_CASE(smoothed_boundaries_leave_segments_connected_and_few_faces_changed)
{
  const Mesh mesh = mesh_of(elephant());
  const Labels smoothed = labels_of(elephant(), calibrated().boundary_smoothing(true));
  const Labels labels = tree_of_elephant().labels();
  check_numbering(mesh, smoothed);
  BOOST_TEST(number_of(smoothed) == number_of(labels));
  BOOST_TEST(rand_index(smoothed, labels) > 0.95);
}

BOOST_AUTO_TEST_CASE(a_polyhedron_and_a_surface_mesh_get_the_same_labels)
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  Polyhedron polyhedron;
  PMP::polygon_soup_to_polygon_mesh(elephant().points, elephant().triangles, polyhedron);
  std::map<Polyhedron::Facet_const_handle, std::size_t> label;
  const Polyhedron& mesh = polyhedron;
  CGAL::segment_spectral_recursive(
    mesh,
    boost::make_function_property_map<boost::graph_traits<Polyhedron>::face_descriptor,
                                      std::size_t&>(
      [&](boost::graph_traits<Polyhedron>::face_descriptor f) -> std::size_t&
      { return label[f]; }),
    calibrated());
  Labels labels;
  for (auto f = mesh.facets_begin(); f != mesh.facets_end(); ++f)
    labels.push_back(label.at(f));
  BOOST_TEST(labels == labels_of(elephant()), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_numbers_of_faces_and_vertices_do_not_matter)
{
  const Labels expected = labels_of(elephant());
  for (unsigned seed : {1, 2}) {
    Random random(seed);
    std::vector<std::size_t> vertex(elephant().points.size()), face(elephant().triangles.size());
    std::iota(vertex.begin(), vertex.end(), std::size_t(0));
    std::iota(face.begin(), face.end(), std::size_t(0));
    std::shuffle(vertex.begin(), vertex.end(), random);
    std::shuffle(face.begin(), face.end(), random);
    Soup soup = elephant();
    for (std::size_t v = 0; v < vertex.size(); ++v)
      soup.points[vertex[v]] = elephant().points[v];
    for (std::size_t f = 0; f < face.size(); ++f) {
      std::vector<std::size_t> t = elephant().triangles[f];
      for (std::size_t& v : t)
        v = vertex[v];
      std::rotate(t.begin(), t.begin() + std::ptrdiff_t(random() % 3), t.end());
      soup.triangles[face[f]] = t;
    }
    const Labels shuffled = labels_of(soup);
    Labels labels;
    for (std::size_t f = 0; f < face.size(); ++f)
      labels.push_back(shuffled[face[f]]);
    BOOST_TEST(rand_index(labels, expected) == 1);
  }
}

BOOST_AUTO_TEST_CASE(the_unit_does_not_matter)
{
  Soup soup = elephant();
  for (Point& p : soup.points)
    p = Point(1024 * p.x(), 1024 * p.y(), 1024 * p.z());
  BOOST_TEST(labels_of(soup) == labels_of(elephant()), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_names_of_the_axes_do_not_matter)
{
  Soup soup = elephant();
  for (Point& p : soup.points)
    p = Point(p.y(), p.z(), p.x());
  BOOST_TEST(rand_index(labels_of(soup), labels_of(elephant())) == 1);
}

BOOST_AUTO_TEST_CASE(components_are_never_merged)
{
  const Soup soup = disjoint_union(dumbbell(16, 12), dumbbell(16, 12));
  const std::size_t half = soup.triangles.size() / 2;
  for (std::size_t maximum : {std::size_t(1), std::size_t(3), unlimited}) {
    const Labels labels = labels_of(soup, calibrated().maximum_number_of_segments(maximum));
    const std::set<std::size_t> first(labels.begin(), labels.begin() + std::ptrdiff_t(half)),
                                second(labels.begin() + std::ptrdiff_t(half), labels.end());
    for (std::size_t label : first)
      BOOST_TEST(second.count(label) == 0);
    if (maximum != unlimited)
      BOOST_TEST(number_of(labels) == (std::max)(maximum, std::size_t(2)));
    else
      BOOST_TEST(number_of(labels) >= 4);
    check_numbering(mesh_of(soup), labels);
  }
}

BOOST_AUTO_TEST_CASE(meshes_of_up_to_two_faces_stay_whole)
{
  const Soup triangle = {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}}};
  BOOST_TEST(labels_of(Soup()).empty());
  BOOST_TEST((labels_of(triangle) == Labels{0}));
  BOOST_TEST((labels_of(plate(1, 1)) == Labels{0, 0}));
  BOOST_TEST((labels_of(disjoint_union(triangle, triangle)) == Labels{0, 1}));
}

BOOST_AUTO_TEST_CASE(faces_without_area_do_no_harm)
{
  const Soup flat = {{Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(3, 0, 0)},
                     {{0, 1, 2}, {0, 2, 3}}};
  BOOST_TEST((labels_of(flat, calibrated().salience_threshold(-infinity)).size() == 2));
  Soup soup = dumbbell(16, 12);
  // A triangle becomes three, of which one has no area.
  const std::vector<std::size_t> t = soup.triangles[100];
  const std::size_t v = soup.points.size();
  soup.points.push_back(CGAL::midpoint(soup.points[t[0]], soup.points[t[1]]));
  soup.triangles[100] = {v, t[1], t[2]};
  soup.triangles.push_back({t[2], t[0], v});
  soup.triangles.push_back({t[0], t[1], v});
  const Labels labels = labels_of(soup);
  BOOST_TEST(number_of(labels) >= 2);
  BOOST_TEST(number_of(labels) <= 3);
  check_numbering(mesh_of(soup), labels);
}

BOOST_AUTO_TEST_CASE(a_visitor_that_stops_at_once_leaves_the_components)
{
  struct Stop : Segmentation_visitor
  {
    bool go_further() { return false; }
  };
  const Soup soup = disjoint_union(dumbbell(16, 12), dumbbell(16, 12));
  const std::size_t half = soup.triangles.size() / 2;
  Labels expected(2 * half, 0);
  std::fill(expected.begin() + std::ptrdiff_t(half), expected.end(), std::size_t(1));
  BOOST_TEST(labels_of(soup, calibrated().visitor(Stop())) == expected,
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_run_that_is_stopped_has_labels_of_connected_segments)
{
  struct Stop_after : Segmentation_visitor
  {
    std::size_t remaining_polls;
    explicit Stop_after(std::size_t polls) : remaining_polls(polls) {}
    bool go_further()
    {
      if (remaining_polls > 0)
        --remaining_polls;
      return remaining_polls > 0;
    }
  };
  const Soup soup = dumbbell(16, 12);
  const Mesh mesh = mesh_of(soup);
  std::size_t largest_number = 0;
  for (std::size_t polls = 1; polls < 200; polls += 11) {
    Segmentation_hierarchy tree;
    const Labels labels = labels_of(
      soup, calibrated().visitor(Stop_after(polls)).hierarchy(tree));
    check_numbering(mesh, labels);
    BOOST_TEST(labels == tree.labels(), boost::test_tools::per_element());
    largest_number = (std::max)(largest_number, number_of(labels));
  }
  BOOST_TEST(largest_number >= 2);
}

BOOST_AUTO_TEST_SUITE_END()
