// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../benchmark/twin_classes.h"
#include "test_meshes.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(twin_classes)

using namespace segmentation_benchmark;
using test_meshes::disjoint_union;
using test_meshes::mesh_of;
using test_meshes::moved;
using test_meshes::plate;
using test_meshes::scaled;

namespace tt = boost::test_tools;

namespace {

const double tolerance = 1e-12;

// The labels of soups that follow each other.
Labels labels_of(const std::vector<test_meshes::Soup>& soups)
{
  Labels labels;
  for (std::size_t i = 0; i < soups.size(); ++i)
    labels.insert(labels.end(), soups[i].triangles.size(), i);
  return labels;
}

std::vector<Part_shape> shapes_of(const std::vector<test_meshes::Soup>& soups)
{
  test_meshes::Soup all;
  for (const test_meshes::Soup& soup : soups)
    all = disjoint_union(all, soup);
  const auto mesh = mesh_of(all);
  return part_shapes(face_moments(mesh, mesh_facts(mesh).face_areas), labels_of(soups));
}

// Three parts of area 4 each, and segments that have so much of each in common.
Eigen::ArrayXXd areas(const std::vector<std::vector<double> >& rows)
{
  Eigen::ArrayXXd result(rows.size(), rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j)
      result(i, j) = rows[i][j];
  return result;
}

} // namespace

// The variance of a side of length n is n^2 / 12, whatever the triangles and the place.
BOOST_AUTO_TEST_CASE(shape_of_a_rectangle)
{
  for (const test_meshes::Soup& soup :
       {plate(4, 2), moved(scaled(plate(8, 4), 0.5), 3, -2, 1)}) {
    const Part_shape shape = shapes_of({soup}).front();
    BOOST_TEST(shape.area == 8, tt::tolerance(tolerance));
    BOOST_TEST(std::abs(shape.deviations[0]) < 1e-6);
    BOOST_TEST(shape.deviations[1] == 2 / std::sqrt(12), tt::tolerance(tolerance));
    BOOST_TEST(shape.deviations[2] == 4 / std::sqrt(12), tt::tolerance(tolerance));
  }
}

// A sphere and a torus of its area differ by their deviations only.
BOOST_AUTO_TEST_CASE(parts_of_one_size_and_spread_are_twins)
{
  const test_meshes::Soup sphere = test_meshes::sphere(3);
  const std::vector<Part_shape> shapes = shapes_of({
    plate(1, 1),
    sphere,
    moved(test_meshes::torus(1, 0.314, 32, 16), 9, 0, 0),
    moved(scaled(sphere, 1.04), 0, 8, 0),  // by 8 % larger
    moved(scaled(sphere, 0.97), 0, -8, 0), // by 13 % smaller than the largest
    moved(plate(1, 1), 0, 3, 3)});
  BOOST_TEST(shapes[1].area == shapes[2].area, tt::tolerance(0.05));
  BOOST_TEST(are_congruent(shapes[1], shapes[4]));
  BOOST_TEST(!are_congruent(shapes[3], shapes[4]));
  BOOST_TEST(!are_congruent(shapes[1], shapes[2]));

  // The class of the largest takes the middle one, and the smallest has no other twin.
  const std::vector<Twin_class> classes = segmentation_benchmark::twin_classes(shapes);
  BOOST_TEST_REQUIRE(classes.size() == 2u);
  BOOST_TEST(classes[0] == (Twin_class{3, 1}), tt::per_element());
  BOOST_TEST(classes[1] == (Twin_class{0, 5}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(best_overlap_by_hand)
{
  const std::vector<double> best = best_overlaps(areas({{3, 1, 0}, {0, 2, 2}, {0, 0, 4}}));
  BOOST_TEST(best[0] == 3 / 4., tt::tolerance(tolerance));
  BOOST_TEST(best[1] == 2 / 5., tt::tolerance(tolerance)); // 2 / 8 with the last segment
  BOOST_TEST(best[2] == 4 / 6., tt::tolerance(tolerance));
}

BOOST_AUTO_TEST_CASE(twins_are_treated_alike_or_not)
{
  const std::vector<Twin_class> all = {{0, 1, 2}}, first_two = {{0, 1}}, pairs = {{0, 1}, {1, 2}};

  // All are cut off; none is; the last one is left on the second.
  BOOST_TEST(share_treated_alike(all, areas({{4, 0, 0}, {0, 4, 0}, {0, 0, 4}})) == 1);
  BOOST_TEST(share_treated_alike(all, areas({{4}, {4}, {4}})) == 1);
  const Eigen::ArrayXXd last_is_left = areas({{4, 0}, {0, 4}, {0, 4}});
  BOOST_TEST(share_treated_alike(all, last_is_left) == 0);
  BOOST_TEST(share_treated_alike(first_two, last_is_left) == 0);
  BOOST_TEST(share_treated_alike(pairs, last_is_left) == 0.5);

  // A quarter more or less is alike.
  BOOST_TEST(share_treated_alike(first_two, areas({{4, 0, 0}, {0, 3, 1}})) == 1);
  BOOST_TEST(share_treated_alike(first_two, areas({{4, 0, 0}, {0, 2.9, 1.1}})) == 0);
  BOOST_TEST(std::isnan(share_treated_alike({}, areas({{4}}))));
}

BOOST_AUTO_TEST_SUITE_END()
