// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/levels/coarsening.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(edge_collapse)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using internal::Level;

namespace {

Level collapsed(const Surface& mesh, std::size_t number_of_faces)
{
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  internal::Edge_collapse collapse(mesh, 1e-9, monitor);
  collapse.collapse_edges(number_of_faces);
  return collapse.result();
}

// The ends of the shortest edge, in ascending order.
std::pair<Index, Index> shortest_edge(const Surface& mesh)
{
  std::pair<Index, Index> result;
  double shortest = 1e300;
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h) {
    const Index v = mesh.source_vertex(h), w = mesh.target_vertex(h);
    const double length = (mesh.points[v] - mesh.points[w]).norm();
    if (length < shortest) {
      shortest = length;
      result = std::minmax({v, w});
    }
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_shortest_edge_is_collapsed_first)
{
  for (unsigned seed = 0; seed < 50; ++seed) {
    Random random(seed);
    const Surface mesh = surface_of(displaced(sphere(2), 0.01, random));
    const Level level = collapsed(mesh, mesh.number_of_faces() - 2);
    BOOST_TEST(level.surface.number_of_faces() == mesh.number_of_faces() - 2);
    const auto [v, w] = shortest_edge(mesh);
    BOOST_TEST(level.coarse_vertex[v] == level.coarse_vertex[w]);
    BOOST_TEST(std::set<Index>(level.coarse_vertex.begin(), level.coarse_vertex.end()).size() ==
               mesh.points.size() - 1);
  }
}

BOOST_AUTO_TEST_CASE(a_plate_keeps_its_area_and_its_side)
{
  Random random(7);
  Soup soup = plate(6, 6);
  const auto moved = [&](double x)
  { return x > 0 && x < 6 ? x + 0.01 * double(random_number(random, 0, 30)) : x; };
  for (Point& p : soup.points)
    p = Point(moved(p.x()), moved(p.y()), p.z());
  const Surface mesh = surface_of(soup);
  const Level level = collapsed(mesh, 20);
  BOOST_TEST(level.surface.number_of_faces() <= 20u);
  double area = 0;
  for (Index f = 0; f < level.surface.number_of_faces(); ++f) {
    BOOST_TEST(level.surface.normal(f).z() > 0);
    area += level.surface.normal(f).norm() / 2;
  }
  BOOST_TEST(area == internal::total_area(mesh), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_SUITE_END()
