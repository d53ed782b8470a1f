// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/engine.h>
#include <CGAL/Spectral_segmentation/internal/salience/Patch.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/segment_spectral_recursive.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

// Tests the particularities of the default method. The promises of both methods have other suites.
BOOST_AUTO_TEST_SUITE(calibrated_method)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
namespace internal = CGAL::Spectral_segmentation::internal;
using CGAL::Spectral_segmentation::Salience_factors;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

namespace {

const double infinity = std::numeric_limits<double>::infinity();
const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

auto calibrated() { return parameters::default_values(); }

Labels labels_of_default(const Soup& soup) { return labels_of(soup, calibrated()); }

const Segmentation_hierarchy& hierarchy_of_doll()
{
  static const Segmentation_hierarchy hierarchy = hierarchy_of(mesh_of(doll()), calibrated());
  return hierarchy;
}

// A mesh that is coarsened
const Soup& elephant()
{
  static const Soup soup = read("elephant.off");
  return soup;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_dumbbell_is_cut_at_its_neck)
{
  const Soup soup = dumbbell(24, 20);
  const Labels labels = labels_of_default(soup);
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

BOOST_AUTO_TEST_CASE(labels_for_any_number_and_threshold_equal_a_fresh_run)
{
  const auto all_cuts = calibrated().salience_threshold(-infinity);
  const Segmentation_hierarchy all = hierarchy_of(mesh_of(doll()), all_cuts);
  const double threshold = hierarchy_of_doll().salience_threshold();
  for (std::size_t n = 1; n <= 8; ++n) {
    BOOST_TEST((labels_above(hierarchy_of_doll(), threshold, n) ==
                labels_of(doll(), calibrated().maximum_number_of_segments(n))));
    BOOST_TEST(number_of(labels_above(all, -infinity, n)) == n);
    BOOST_TEST((labels_above(all, -infinity, n) ==
                labels_of(doll(), all_cuts.maximum_number_of_segments(n))));
  }
  for (double t : {-infinity, 0., 0.1, 0.3, 0.5, 0.6, 0.8, 0.95, 1., infinity})
    BOOST_TEST((labels_above(hierarchy_of_doll(), t, unlimited) ==
                labels_of(doll(), calibrated().salience_threshold(t))));
}

BOOST_AUTO_TEST_CASE(as_many_segments_as_are_asked_for)
{
  const auto np = calibrated().salience_threshold(-infinity);
  const Mesh mesh = mesh_of(doll());
  for (std::size_t n : {20, 21})
    BOOST_TEST(check_labels(mesh, labels_of(mesh, calibrated().number_of_segments(n))) == n);
  // Cuts are lost if a side, on the faces of the mesh, is below the minimum.
  const std::size_t of_20 = number_of(labels_of(mesh, np));
  BOOST_TEST(of_20 >= 18);
  BOOST_TEST(of_20 <= 20);
  const std::size_t of_40 = number_of(labels_of(mesh, np.maximum_number_of_segments(40)));
  BOOST_TEST(of_40 >= 34);
  BOOST_TEST(of_40 <= 40);
  // One region more for each further component that nothing touches
  const Soup three = disjoint_union(
    dumbbell(16, 12), disjoint_union(moved(sphere(3), 20, 0, 0), moved(sphere(2), 0, 20, 0)));
  BOOST_TEST(number_of(labels_of(three, np)) >= 16);
  BOOST_TEST(number_of(labels_of(three, np)) <= 22);
  BOOST_TEST(number_of(labels_of(three, np.maximum_number_of_segments(25))) >= 17);
  BOOST_TEST(number_of(labels_of(three, np.maximum_number_of_segments(25))) <= 25);
  BOOST_TEST(number_of(labels_of(three, np.maximum_number_of_segments(2))) == 2);
}

BOOST_AUTO_TEST_CASE(the_maximum_changes_the_hierarchy_only_above_the_number_of_regions)
{
  for (const Soup& soup : {doll(), elephant()}) {
    const Mesh mesh = mesh_of(soup);
    const Segmentation_hierarchy
      whole = hierarchy_of(mesh, calibrated()),
      up_to_10 = hierarchy_of(mesh, calibrated().maximum_number_of_segments(10)),
      up_to_30 = hierarchy_of(mesh, calibrated().maximum_number_of_segments(30));
    BOOST_TEST(whole.number_of_segments() <= 20); // some cuts may be lost
    BOOST_TEST(whole.number_of_segments() >= 19);
    BOOST_TEST(up_to_30.number_of_segments() <= 30);
    BOOST_TEST(up_to_30.number_of_segments() >= 24);
    for (std::size_t n = 1; n <= 19; ++n)
      BOOST_TEST((labels_above(whole, -infinity, n) == labels_above(up_to_10, -infinity, n)));
  }
}

// A cut of the hierarchy has factors that the function of the caller was given, but for the
// numbers of neighbors, which may have changed since.
BOOST_AUTO_TEST_CASE(the_salience_is_asked_for_each_cut_of_the_hierarchy)
{
  const CGAL::Spectral_segmentation::Calibrated_part_salience calibrated;
  const auto salience_without_neighbors = [=](Salience_factors factors) {
    factors.number_of_common_neighbors = factors.number_of_other_neighbors = 0;
    return calibrated(factors);
  };
  CGAL::Spectral_segmentation::Options options;
  options.number_of_coarse_faces = 0; // so that the mesh itself is searched
  std::set<double> asked; // saliences of boundaries
  options.part_salience = [&](const Salience_factors& factors) {
    if (factors.is_boundary)
      asked.insert(salience_without_neighbors(factors));
    return calibrated(factors);
  };
  internal::Run_control control;
  const internal::Cut_hierarchy hierarchy =
    internal::segment(read_surface(dumbbell(20, 16)), options, {}, sequential, control, {}, {});
  BOOST_TEST(hierarchy.number_of_segments() == 20u);
  for (const internal::Cut_node& node : hierarchy.nodes)
    if (!node.is_leaf())
      BOOST_TEST(asked.count(salience_without_neighbors(node.factors)) == 1u);
}

BOOST_AUTO_TEST_CASE(factors_describe_the_mesh_that_is_searched)
{
  const Segmentation_hierarchy hierarchy =
    hierarchy_of(mesh_of(doll()), calibrated().number_of_coarse_faces(0));
  for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
    const Segmentation_hierarchy::Node& n = hierarchy.node(i);
    if (!n.is_leaf())
      BOOST_TEST(n.factors.size == hierarchy.node(n.children[0]).area / n.area,
                 boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(components_that_shall_stay_apart_are_never_merged)
{
  const Soup soup = disjoint_union(dumbbell(16, 12), moved(dumbbell(16, 12), 0, 0, 0.1));
  const std::size_t half = soup.triangles.size() / 2;
  for (std::size_t maximum : {std::size_t(1), std::size_t(3), unlimited}) {
    const Labels labels = labels_of(
      soup, calibrated().keep_components_separate(true).maximum_number_of_segments(maximum));
    const std::set<std::size_t> first(labels.begin(), labels.begin() + std::ptrdiff_t(half)),
                                second(labels.begin() + std::ptrdiff_t(half), labels.end());
    for (std::size_t label : first)
      BOOST_TEST(second.count(label) == 0);
    if (maximum != unlimited)
      BOOST_TEST(number_of(labels) == (std::max)(maximum, std::size_t(2)));
    else
      BOOST_TEST(number_of(labels) >= 4);
    check_labels(mesh_of(soup), labels);
  }
}

BOOST_AUTO_TEST_CASE(meshes_of_up_to_two_faces_stay_whole)
{
  const Soup triangle = {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}}};
  BOOST_TEST(labels_of_default(Soup()).empty());
  BOOST_TEST((labels_of_default(triangle) == Labels{0}));
  BOOST_TEST((labels_of_default(plate(1, 1)) == Labels{0, 0}));
  const Soup far = moved(triangle, 10, 0, 0);
  BOOST_TEST((labels_of_default(disjoint_union(triangle, far)) == Labels{0, 1}));
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
  const Labels labels = labels_of_default(soup);
  BOOST_TEST(number_of(labels) >= 2);
  BOOST_TEST(number_of(labels) <= 3);
  check_labels(mesh_of(soup), labels);
}

BOOST_AUTO_TEST_SUITE_END()
