// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/model/surrounding_components.h>
#include <CGAL/Spectral_segmentation/internal/surface/orient_outward.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(surrounding_components)

namespace internal = CGAL::Spectral_segmentation::internal;
using namespace test_meshes;
using internal::Component_fractions;

namespace {

Soup box(double x, double y, double z)
{
  Cells cell;
  add_box(cell, {0, 0, 0}, {1, 1, 1});
  return transformed(boundary_of(cell), [=](const Point& p)
    { return Point(x * (p.x() - 0.5), y * (p.y() - 0.5), z * (p.z() - 0.5)); });
}

Soup sheet(double side, double height_of_waves)
{
  return transformed(plate(20, 20), [=](const Point& p) {
    return Point(side * (p.x() / 20 - 0.5), side * (p.y() / 20 - 0.5),
                 height_of_waves * std::sin(p.x() / 2) * std::sin(p.y() / 3));
  });
}

Component_fractions fractions_of(const std::vector<Soup>& components)
{
  Soup all;
  for (const Soup& component : components)
    all = disjoint_union(std::move(all), component);
  Surface surface = surface_of(all);
  internal::orient_outward(surface);
  return internal::component_fractions(surface);
}

// Returns whether a component surrounds a ball of radius 1 at a height.
bool surrounds_ball(const Soup& component, double height)
{
  const Component_fractions f = fractions_of({moved(sphere(3), 0, 0, height), component});
  BOOST_TEST(!f.is_surrounding[0]);
  if (f.is_surrounding[1])
    BOOST_TEST(f.fraction[0] == 1);
  return f.is_surrounding[1] != 0;
}

} // namespace

BOOST_AUTO_TEST_CASE(fractions_of_areas)
{
  const Component_fractions f =
    fractions_of({box(1, 1, 1), moved(box(2, 2, 2), 5, 0, 0), moved(box(2, 2, 2), 9, 0, 0)});
  BOOST_TEST(f.fraction[0] == 1. / 9, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(f.fraction[1] == 4. / 9, boost::test_tools::tolerance(1e-12));
  BOOST_TEST((f.is_surrounding == std::vector<char>{0, 0, 0}));
  BOOST_TEST(f.effective_number() == 81. / 33, boost::test_tools::tolerance(1e-12));
}

// The area of the ball is 12.6.
BOOST_AUTO_TEST_CASE(solids)
{
  BOOST_TEST(surrounds_ball(box(4, 4, 4), 0));
  BOOST_TEST(surrounds_ball(scaled(sphere(3), 100), 0));
  BOOST_TEST(!surrounds_ball(box(1.2, 1.2, 1.2), 3));  // has less area
  BOOST_TEST(!surrounds_ball(box(16, 16, 16), 8));     // the ball is half inside
  BOOST_TEST(surrounds_ball(box(40, 40, 4), 3));       // is flat
  BOOST_TEST(surrounds_ball(box(12, 10, 3), 2.5));
  BOOST_TEST(!surrounds_ball(box(3.4, 3.4, 0.5), 1));  // is not twice as long
  BOOST_TEST(!surrounds_ball(torus(6, 1, 40, 20), 2)); // is not convex
}

BOOST_AUTO_TEST_CASE(sheets)
{
  BOOST_TEST(surrounds_ball(sheet(10, 0), 1));
  BOOST_TEST(surrounds_ball(sheet(10, 0.4), 1.5));
  BOOST_TEST(!surrounds_ball(sheet(10, 2), 3)); // is not flat
  BOOST_TEST(!surrounds_ball(sheet(3.8, 0), 1)); // is not twice as long
}

BOOST_AUTO_TEST_CASE(one_after_the_other)
{
  const Component_fractions f =
    fractions_of({sphere(3), moved(box(20, 20, 1), 0, 0, -2), box(60, 60, 60)});
  BOOST_TEST((f.is_surrounding == std::vector<char>{0, 1, 1}));
  BOOST_TEST(f.fraction[0] == 1);
  BOOST_TEST(fractions_of({sphere(3)}).fraction[0] == 1);
}

BOOST_AUTO_TEST_SUITE_END()
