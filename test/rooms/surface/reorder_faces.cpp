// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/reorder_faces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

BOOST_AUTO_TEST_SUITE(reorder_faces)

using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::null_index;
using CGAL::Spectral_segmentation::internal::locality_order;

BOOST_AUTO_TEST_CASE(neighbors_are_near_in_the_order_of_locality_whatever_the_order_was)
{
  Random random(1);
  Soup soup = sphere(5);
  std::shuffle(soup.triangles.begin(), soup.triangles.end(), random);
  const Surface triangles = read_surface(soup);
  const std::vector<Index> order = locality_order(triangles);
  std::vector<Index> place(order.size(), null_index);
  for (Index i = 0; i < order.size(); ++i)
    place[order[i]] = i;
  BOOST_TEST(std::count(place.begin(), place.end(), null_index) == 0); // all are in it

  const Surface graph = surface_of(soup);
  std::size_t number_of_near = 0;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    number_of_near += std::abs(double(place[h / 3]) - place[graph.neighbor(h)]) < 1024;
  // A block of 1024 has about 4 * 32 edges to others, of 1536.
  BOOST_TEST(double(number_of_near) > 0.9 * double(graph.number_of_halfedges()));
}

BOOST_AUTO_TEST_CASE(components_keep_their_order)
{
  const Soup soup = disjoint_union(disjoint_union(sphere(1), plate(2, 2)), sphere(0));
  const std::vector<Index> order = locality_order(read_surface(soup));
  const std::size_t first = sphere(1).triangles.size(), second = plate(2, 2).triangles.size();
  for (std::size_t i = 0; i < order.size(); ++i) {
    BOOST_TEST((order[i] < first) == (i < first));
    BOOST_TEST((order[i] < first + second) == (i < first + second));
  }
}

BOOST_AUTO_TEST_CASE(triangles_in_another_order_are_the_same_triangles)
{
  Random random(1);
  for (const Soup& soup : small_soups()) {
    Mesh mesh = mesh_of(soup);
    mesh.add_vertex(Point(0, 0, 0)); // without a face
    const Surface triangles = read_surface(mesh);
    std::vector<Index> order(soup.triangles.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::shuffle(order.begin(), order.end(), random);
    Surface other = triangles;
    CGAL::Spectral_segmentation::internal::reorder_faces(other, order);
    BOOST_REQUIRE(other.corners.size() == order.size());
    BOOST_REQUIRE(other.opposite.size() == 3 * order.size());
    BOOST_TEST(other.points.size() == soup.points.size());
    Index number_of_vertices = 0;
    for (Index f = 0; f < order.size(); ++f)
      for (Index i = 0; i < 3; ++i) {
        const Index v = other.corners[f][i];
        BOOST_TEST((other.points[v] == triangles.points[triangles.corners[order[f]][i]]));
        BOOST_TEST(order[other.neighbor(3 * f + i)] == triangles.neighbor(3 * order[f] + i));
        BOOST_TEST(v <= number_of_vertices); // each comes after those before it
        number_of_vertices = std::max(number_of_vertices, v + 1);
      }
  }
}

BOOST_AUTO_TEST_CASE(faces_that_meet_at_a_point_only_have_vertices_of_their_own)
{
  using CGAL::Spectral_segmentation::internal::Corners;
  Surface two;
  for (int x = 0; x < 5; ++x)
    two.points.emplace_back(x, x % 2, 0);
  two.corners = {{0, 1, 2}, {0, 3, 4}};
  two.opposite = {0, 1, 2, 3, 4, 5};
  separate_fans(two);
  BOOST_TEST((two.corners[0] == Corners{0, 1, 2}));
  BOOST_TEST((two.corners[1] == Corners{3, 4, 5}));
  BOOST_TEST((two.points[5] == two.points[0]));

  for (const Soup& soup : {sphere(2), plate(3, 4), torus(2, 1, 9, 7)}) {
    Surface surface = surface_of(soup);
    const std::size_t number = surface.points.size();
    separate_fans(surface);
    BOOST_TEST(surface.points.size() == number);
  }
}

BOOST_AUTO_TEST_SUITE_END()
