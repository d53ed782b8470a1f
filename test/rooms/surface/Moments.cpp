// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>

#include <cmath>
#include <cstddef>

BOOST_AUTO_TEST_SUITE(moments)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Execution;
using internal::Vector;
using internal::center_of;
using internal::mean_over_surface;
using internal::total_area;

BOOST_AUTO_TEST_CASE(areas_of_plates_and_spheres_are_known)
{
  const double unit = unit_of(plate(4, 3));
  BOOST_TEST(total_area(surface_of(plate(4, 3))) * unit * unit == 12, tt::tolerance(1e-12));
  const double unit_of_sphere = unit_of(sphere(5));
  BOOST_TEST(total_area(surface_of(sphere(5))) * unit_of_sphere * unit_of_sphere == 4 * pi,
             tt::tolerance(0.002));
  BOOST_TEST(total_area(Surface()) == 0);
}

BOOST_AUTO_TEST_CASE(faces_count_by_their_area)
{
  // Two plates of areas 1 and 9 whose centers are at x = 0.5 and x = 101.5.
  const Soup soup = disjoint_union(plate(1, 1), moved(scaled(plate(2, 2), 1.5), 100, 0, 0));
  const Surface graph = surface_of(soup);
  const double unit = unit_of(soup), area = total_area(graph);
  for (Execution execution : {Execution::SEQUENTIAL, Execution::PARALLEL}) {
    const Vector from_corner = unit * (center_of(execution, graph, area) - graph.points[0]);
    BOOST_TEST(from_corner.x() == (1 * 0.5 + 9 * 101.5) / 10, tt::tolerance(1e-12));
    BOOST_TEST(from_corner.y() == (1 * 0.5 + 9 * 1.5) / 10, tt::tolerance(1e-12));
    BOOST_TEST(std::abs(from_corner.z()) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_mean_of_a_function_is_taken_at_the_centroids)
{
  Random random(1);
  const Surface graph = surface_of(displaced(sphere(4), 0.05, random)); // several blocks
  const double area = total_area(graph);
  const auto cubes = [](const Vector& p)
  { return Vector(std::pow(p.x(), 3), std::pow(p.y(), 3), std::pow(p.z(), 3)); };
  Vector expected;
  for (Index f = 0; f < graph.number_of_faces(); ++f)
    expected += graph.areas[f] / area * cubes(graph.centroid(f));
  const Vector mean = mean_over_surface<Vector>(Execution::SEQUENTIAL, graph, area, cubes);
  BOOST_TEST((mean - expected).norm() < 1e-14);
  BOOST_TEST((mean_over_surface<Vector>(Execution::PARALLEL, graph, area, cubes) == mean));
}

BOOST_AUTO_TEST_SUITE_END()
