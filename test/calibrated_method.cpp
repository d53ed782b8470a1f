// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/engine.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/salience/Boundary_statistics.h>
#include <CGAL/segment_spectral_recursive.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

// Tests what is particular to the default method; tests of what both methods promise are elsewhere.
BOOST_AUTO_TEST_SUITE(calibrated_method)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
namespace internal = CGAL::Spectral_segmentation::internal;
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

BOOST_AUTO_TEST_CASE(labels_for_any_number_of_segments_are_those_of_a_fresh_run)
{
  const double threshold = hierarchy_of_doll().salience_threshold();
  for (std::size_t n = 1; n <= 8; ++n) {
    const Labels fresh = labels_of(doll(), calibrated().maximum_number_of_segments(n));
    BOOST_TEST(labels_above(hierarchy_of_doll(), threshold, n) == fresh,
               boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(labels_for_any_number_without_a_threshold_are_those_of_a_fresh_run)
{
  const auto np = calibrated().salience_threshold(-infinity);
  const Segmentation_hierarchy hierarchy = hierarchy_of(mesh_of(doll()), np);
  for (std::size_t n = 1; n <= 8; ++n) {
    const Labels fresh = labels_of(doll(), np.maximum_number_of_segments(n));
    BOOST_TEST(number_of(fresh) == n);
    BOOST_TEST(labels_above(hierarchy, -infinity, n) == fresh, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(as_many_segments_as_are_asked_for)
{
  const auto np = calibrated().salience_threshold(-infinity);
  const Mesh mesh = mesh_of(doll());
  for (std::size_t n : {20, 21, 40})
    BOOST_TEST(check_labels(mesh, labels_of(mesh, np.maximum_number_of_segments(n))) == n);
  BOOST_TEST(number_of(labels_of(mesh, np)) == 20);
  // One region more for each further component that nothing touches, unless it is lost because it
  // has less than half of each face.
  const Soup three = disjoint_union(
    dumbbell(16, 12), disjoint_union(moved(sphere(3), 20, 0, 0), moved(sphere(2), 0, 20, 0)));
  BOOST_TEST(number_of(labels_of(three, np)) >= 21);
  BOOST_TEST(number_of(labels_of(three, np)) <= 22);
  BOOST_TEST(number_of(labels_of(three, np.maximum_number_of_segments(25))) >= 23);
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
    BOOST_TEST(whole.number_of_segments() == 20);
    BOOST_TEST(up_to_30.number_of_segments() == 30);
    for (std::size_t n = 1; n <= 20; ++n)
      BOOST_TEST((labels_above(whole, -infinity, n) == labels_above(up_to_10, -infinity, n)));
  }
}

BOOST_AUTO_TEST_CASE(the_cuts_that_are_evaluated_are_told)
{
  typedef internal::Evaluated_cut Evaluated_cut;
  CGAL::Spectral_segmentation::Options options;
  options.number_of_coarse_faces = 0; // so that the mesh itself is searched
  struct Observer : internal::Run_control
  {
    const CGAL::Spectral_segmentation::Options& options;
    std::vector<internal::Index> searched_faces;
    std::vector<double> areas; // in the order of the searched faces
    std::set<std::vector<internal::Index> > parts;
    std::size_t number_of[2] = {0, 0};
    std::set<double> saliences[2];

    explicit Observer(const CGAL::Spectral_segmentation::Options& o) : options(o) {}

    double salience_without_neighbors(CGAL::Spectral_segmentation::Salience_factors factors) const
    {
      factors.number_of_common_neighbors = 0;
      return options.part_salience(factors);
    }

    void start_search(const std::vector<internal::Index>& faces) override
    {
      searched_faces = faces;
      const Surface mesh = surface_of(dumbbell(20, 16));
      for (internal::Index f : faces)
        areas.push_back(mesh.areas[f]);
    }

    void cut_evaluated(const Evaluated_cut& cut) override
    {
      ++number_of[cut.kind];
      saliences[cut.kind].insert(salience_without_neighbors(cut.factors));
      BOOST_TEST_REQUIRE(cut.side.size() == cut.faces.size());
      BOOST_TEST(std::is_sorted(cut.faces.begin(), cut.faces.end()));
      double area[2] = {0, 0}, whole = 0;
      for (std::size_t i = 0; i < cut.faces.size(); ++i)
        area[int(cut.side[i])] += areas[cut.faces[i]];
      for (double a : areas)
        whole += a;
      BOOST_TEST(cut.factors.size == area[0] / (area[0] + area[1]),
                 boost::test_tools::tolerance(1e-9));
      BOOST_TEST(std::abs(cut.factors.log_relative_part_area -
                          std::log((area[0] + area[1]) / whole)) < 1e-9);
      if (cut.kind == Evaluated_cut::CANDIDATE)
        parts.insert(cut.faces);
    }
  } observer(options);
  const internal::Cut_hierarchy hierarchy =
    internal::segment(read_surface(dumbbell(20, 16)), options, sequential, observer);

  std::vector<internal::Index> all = observer.searched_faces;
  std::sort(all.begin(), all.end());
  BOOST_TEST_REQUIRE(all.size() == hierarchy.leaf.size());
  for (std::size_t f = 0; f < all.size(); ++f)
    BOOST_TEST_REQUIRE(all[f] == f);
  // Each cut into regions was a candidate, and makes two parts that are searched; but the last one
  // ends the search. No part has more candidates than are taken and refined.
  const std::size_t regions = hierarchy.number_of_segments();
  BOOST_TEST(regions == 20);
  BOOST_TEST(observer.parts.size() <= 2 * regions - 3);
  BOOST_TEST(observer.parts.size() >= regions - 1);
  BOOST_TEST(observer.number_of[Evaluated_cut::CANDIDATE] <= observer.parts.size() * (14 + 4));
  // Each merge is of a boundary, whose number of common neighbors may have changed since, and whose
  // salience may be that of congruent cuts, or of a cut above it.
  BOOST_TEST(observer.number_of[Evaluated_cut::BOUNDARY] >= regions - 1);
  for (const internal::Cut_node& node : hierarchy.nodes)
    if (!node.is_leaf())
      BOOST_TEST(observer.saliences[Evaluated_cut::BOUNDARY].count(
        observer.salience_without_neighbors(node.factors)) == 1);
}

BOOST_AUTO_TEST_CASE(labels_for_any_threshold_are_those_of_a_fresh_run)
{
  for (double threshold : {-1., 0.1, 0.3, 0.5, 0.6, 0.8, 0.95, 2.})
    BOOST_TEST(labels_above(hierarchy_of_doll(), threshold, unlimited) ==
               labels_of(doll(), calibrated().salience_threshold(threshold)),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_child_is_at_most_as_salient_as_its_parent)
{
  const Segmentation_hierarchy& hierarchy = hierarchy_of_doll();
  BOOST_TEST(hierarchy.number_of_segments() > 5);
  for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
    const Segmentation_hierarchy::Node& n = hierarchy.node(i);
    BOOST_TEST(n.salience >= 0);
    BOOST_TEST(n.salience <= 1);
    if (i >= hierarchy.number_of_roots())
      BOOST_TEST(n.salience <= hierarchy.node(n.parent).salience);
    if (n.is_leaf())
      continue;
    const Segmentation_hierarchy::Node& small = hierarchy.node(n.children[0]);
    const Segmentation_hierarchy::Node& large = hierarchy.node(n.children[1]);
    BOOST_TEST(small.area <= large.area);
  }
}

BOOST_AUTO_TEST_CASE(factors_are_those_of_the_mesh_that_is_searched)
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

BOOST_AUTO_TEST_CASE(smoothed_boundaries_leave_segments_connected_and_few_faces_changed)
{
  const Mesh mesh = mesh_of(elephant());
  const Labels smoothed = labels_of(mesh, calibrated().smooth_boundaries(true));
  const Labels labels = labels_of(mesh, calibrated());
  BOOST_TEST(check_labels(mesh, smoothed) == number_of(labels));
  BOOST_TEST(rand_index(smoothed, labels) > 0.95);
  BOOST_TEST(rand_index(smoothed, labels) < 1);
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
