// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(read_triangle_mesh)

namespace tt = boost::test_tools;
using namespace test_meshes;

BOOST_AUTO_TEST_CASE(the_first_corner_is_the_smallest_vertex_whatever_the_mesh_starts_with)
{
  for (Soup soup : small_soups()) {
    const Surface triangles = read_surface(soup);
    for (Index f = 0; f < triangles.corners.size(); ++f) {
      std::vector<std::size_t> corners = soup.triangles[f];
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      BOOST_TEST(triangles.corners[f] == corners, tt::per_element());
    }
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      std::rotate(soup.triangles[f].begin(),
                  soup.triangles[f].begin() + static_cast<std::ptrdiff_t>(f % 3),
                  soup.triangles[f].end());
    const Surface rotated = read_surface(soup);
    BOOST_TEST((rotated.corners == triangles.corners));
    BOOST_TEST((rotated.opposite == triangles.opposite));
  }
}

BOOST_AUTO_TEST_CASE(points_equal_the_points_of_the_mesh)
{
  for (const Soup& soup : small_soups()) {
    const Surface triangles = read_surface(soup);
    BOOST_TEST_REQUIRE(triangles.points.size() == soup.points.size());
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      for (int i = 0; i < 3; ++i)
        BOOST_TEST(triangles.points[v][i] == soup.points[v][i]);
  }
}

BOOST_AUTO_TEST_CASE(vertices_without_a_face_do_not_count)
{
  const Soup soup = sphere(1);
  const Surface triangles = read_surface(soup);
  for (double x : {1e6, std::numeric_limits<double>::quiet_NaN()}) {
    Mesh mesh = mesh_of(soup);
    mesh.add_vertex(Point(x, 0, 0));
    const Surface other = read_surface(mesh);
    BOOST_TEST((other.corners == triangles.corners));
    BOOST_TEST((other.opposite == triangles.opposite));
    BOOST_TEST_REQUIRE(other.points.size() == triangles.points.size() + 1);
    BOOST_TEST(std::equal(triangles.points.begin(), triangles.points.end(), other.points.begin()));
    BOOST_TEST(other.points.back().is_finite());
  }
}

BOOST_AUTO_TEST_CASE(only_the_given_faces_are_read)
{
  const Mesh mesh = mesh_of(sphere(1));
  std::vector<Mesh::Face_index> faces;
  for (Mesh::Face_index f : mesh.faces())
    if (f.idx() % 3 != 0)
      faces.push_back(f);
  std::reverse(faces.begin(), faces.end());
  const Surface all = read_surface(mesh);
  const Surface some = CGAL::Spectral_segmentation::internal::read_triangle_mesh(
    mesh, faces, mesh.points(), Kernel());
  BOOST_TEST_REQUIRE(some.corners.size() == faces.size());
  for (Index f = 0; f < faces.size(); ++f) {
    BOOST_TEST((some.corners[f] == all.corners[faces[f]]));
    for (Index i = 0; i < 3; ++i) {
      const Index across = all.neighbor(3 * faces[f] + i);
      const auto found = std::find(faces.begin(), faces.end(), Mesh::Face_index(across));
      BOOST_TEST(some.neighbor(3 * f + i) ==
                 (found == faces.end() ? f : static_cast<Index>(found - faces.begin())));
    }
  }
}

BOOST_AUTO_TEST_CASE(an_empty_mesh_is_read)
{
  const Surface triangles = read_surface(Soup());
  BOOST_TEST(triangles.corners.empty());
  BOOST_TEST(triangles.opposite.empty());
  BOOST_TEST(triangles.points.empty());
}

BOOST_AUTO_TEST_SUITE_END()
