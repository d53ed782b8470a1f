// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <cmath>
#include <cstddef>
#include <vector>

// Tests the relation of the labels of a changed mesh to the labels of the mesh.
BOOST_AUTO_TEST_SUITE(transformed_meshes)

using namespace test_meshes;

namespace {

// On a grid, so that sums with not too large numbers are exact.
double on_grid(double x) { return std::ldexp(std::round(std::ldexp(x, 20)), -20); }

// Returns soups without symmetries, because these make many cuts equally salient.
const std::vector<Soup>& soups()
{
  static const std::vector<Soup> result = [] {
    Random random(1);
    std::vector<Soup> soups = {doll(), displaced(dumbbell(14, 10), 0.05, random),
                               displaced(connected_sum(dumbbell(12, 9), torus(3, 1, 14, 9)), 0.05,
                                         random),
                               disjoint_union(displaced(dumbbell(10, 8), 0.05, random),
                                              moved(doll(), 20, 0, 0))};
    for (Soup& soup : soups)
      soup = transformed(soup, [](const Point& p)
        { return Point(on_grid(p.x()), on_grid(p.y()), on_grid(p.z())); });
    return soups;
  }();
  return result;
}

// Calls check(soup, np) for all soups and both methods, also with a search on a coarse mesh.
template <class Check>
void for_each_run(const Check& check)
{
  for_both_methods([&](const auto& np) {
    for (std::size_t i = 0; i < soups().size(); ++i)
      BOOST_TEST_CONTEXT("soup " << i) {
        check(soups()[i], np);
        BOOST_TEST_CONTEXT("on a coarse mesh")
          check(soups()[i], np.number_of_coarse_faces(220));
      }
  });
}

} // namespace

BOOST_AUTO_TEST_CASE(there_are_several_segments)
{
  for_each_run([](const Soup& soup, const auto& np)
    { BOOST_TEST(number_of(labels_of(soup, np)) > 1); });
}

BOOST_AUTO_TEST_CASE(a_power_of_two_as_unit_changes_nothing)
{
  for_each_run([](const Soup& soup, const auto& np) {
    const Labels expected = labels_of(soup, np);
    for (int exponent : {-480, 480})
      BOOST_TEST((labels_of(scaled(soup, std::ldexp(1., exponent)), np) == expected));
  });
}

BOOST_AUTO_TEST_CASE(a_translation_without_rounding_changes_nothing)
{
  const double far = std::ldexp(1., 30);
  for_each_run([far](const Soup& soup, const auto& np)
    { BOOST_TEST((labels_of(moved(soup, far, -far, far), np) == labels_of(soup, np))); });
}

BOOST_AUTO_TEST_CASE(the_numbers_of_faces_and_vertices_do_not_matter)
{
  for_both_methods([](const auto& np) {
    for (const Soup& soup : soups()) {
      const Labels expected = labels_of(soup, np);
      const auto on_coarse_mesh = np.number_of_coarse_faces(220);
      const Labels expected_on_coarse_mesh = labels_of(soup, on_coarse_mesh);
      Random random(1);
      for (int run = 0; run < 2; ++run) {
        std::vector<std::size_t> face;
        const Soup other = renumbered(soup, random, face);
        const auto in_old_order = [&](const Labels& labels) {
          Labels result;
          for (std::size_t f : face)
            result.push_back(labels[f]);
          return result;
        };
        BOOST_TEST(rand_index(in_old_order(labels_of(other, np)), expected) == 1);
        // Sums are rounded in another order while cuts are carried back, and of almost equal cuts
        // another one may be the smallest.
        BOOST_TEST(rand_index(in_old_order(labels_of(other, on_coarse_mesh)),
                              expected_on_coarse_mesh) > 0.995);
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(the_axes_may_be_exchanged)
{
  for_each_run([](const Soup& soup, const auto& np) {
    const Soup exchanged =
      transformed(soup, [](const Point& p) { return Point(p.y(), p.z(), p.x()); });
    BOOST_TEST(rand_index(labels_of(exchanged, np), labels_of(soup, np)) == 1);
  });
}

BOOST_AUTO_TEST_CASE(a_mirror_image_is_cut_alike)
{
  for_each_run([](const Soup& soup, const auto& np) {
    const Soup mirrored = turned_inside_out(
      transformed(soup, [](const Point& p) { return Point(-p.x(), p.y(), p.z()); }));
    BOOST_TEST(rand_index(labels_of(mirrored, np), labels_of(soup, np)) > 0.8);
  });
}

BOOST_AUTO_TEST_CASE(a_rotation_changes_little)
{
  // By 0.5 around an axis that is not one of the coordinate axes
  const double c = std::cos(0.5), s = std::sin(0.5), t = 1 - c, x = 2. / 7, y = 3. / 7, z = 6. / 7;
  const auto rotated = [=](const Point& p) {
    return Point(
      (t * x * x + c) * p.x() + (t * x * y - s * z) * p.y() + (t * x * z + s * y) * p.z(),
      (t * x * y + s * z) * p.x() + (t * y * y + c) * p.y() + (t * y * z - s * x) * p.z(),
      (t * x * z - s * y) * p.x() + (t * y * z + s * x) * p.y() + (t * z * z + c) * p.z());
  };
  // The frame turns with a shape whose variances differ.
  const auto stretched = [](const Point& p) { return Point(1.5 * p.x(), p.y(), 0.7 * p.z()); };
  for_each_run([&](const Soup& soup, const auto& np) {
    const Soup long_soup = transformed(soup, stretched);
    BOOST_TEST(rand_index(labels_of(transformed(long_soup, rotated), np),
                          labels_of(long_soup, np)) > 0.95);
  });
}

// Not in the method of the paper: the new edges are flat, and the angle distance of an edge is its
// rank among all edges.
BOOST_AUTO_TEST_CASE(a_subdivision_of_the_faces_changes_little)
{
  for (const Soup& soup : soups()) {
    const auto np = CGAL::Spectral_segmentation::parameters::default_values();
    Labels expected;
    for (std::size_t label : labels_of(soup, np))
      expected.insert(expected.end(), 4, label);
    BOOST_TEST(rand_index(labels_of(subdivided(soup), np), expected) > 0.8);
  }
}

// One of a single face, as each edge counts for the angle distances of all others.
BOOST_AUTO_TEST_CASE(a_small_component_far_away_leaves_the_others_almost_as_they_are)
{
  const Soup face = {{Point(900, 0, 0), Point(900.01, 0, 0), Point(900, 0.01, 0)}, {{0, 1, 2}}};
  for_both_methods([&](const auto& np) {
    for (const Soup& soup : soups()) {
      Labels labels = labels_of(disjoint_union(soup, face), np);
      labels.pop_back(); // the face may belong to the nearest part
      BOOST_TEST_CONTEXT(soup.triangles.size() << " faces")
        BOOST_TEST(rand_index(labels, labels_of(soup, np)) > 0.95);
    }
  });
}

BOOST_AUTO_TEST_SUITE_END()
