// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(read_triangle_mesh)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::read_triangle_soup;

namespace {

const double bad_coordinates[] = {std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()};

} // namespace

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

BOOST_AUTO_TEST_CASE(points_and_corners_equal_the_soup)
{
  for (const Soup& soup : small_soups()) {
    const Surface triangles = read_triangle_soup(soup.points, soup.triangles);
    BOOST_TEST_REQUIRE(triangles.points.size() == soup.points.size());
    BOOST_TEST_REQUIRE(triangles.corners.size() == soup.triangles.size());
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      for (int i = 0; i < 3; ++i)
        BOOST_TEST(triangles.points[v][i] == soup.points[v][i]);
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        BOOST_TEST(triangles.corners[f][i] == soup.triangles[f][i]);
  }
}

// Whatever becomes of the run, they must not enter the extent of the mesh.
BOOST_AUTO_TEST_CASE(points_that_no_triangle_uses_may_be_anything)
{
  for (double bad : bad_coordinates) {
    Soup soup = plate(2, 2);
    soup.points.emplace_back(0, bad, 0);
    const Surface triangles = read_triangle_soup(soup.points, soup.triangles);
    BOOST_TEST_REQUIRE(triangles.points.size() == soup.points.size());
    BOOST_TEST(triangles.points.back().is_zero());
  }
}

BOOST_AUTO_TEST_CASE(arrays_of_numbers_are_points_and_triangles_too)
{
  const std::vector<std::array<float, 3> > points = {{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}};
  const std::vector<std::array<unsigned char, 3> > corners = {{2, 0, 1}};
  const Surface triangles = read_triangle_soup(points, corners);
  BOOST_TEST(triangles.points[2].y() == 0.5);
  BOOST_TEST((triangles.corners.front() ==
              CGAL::Spectral_segmentation::internal::Corners{2, 0, 1}));
  BOOST_TEST(read_triangle_soup(std::vector<Point>(), std::vector<std::array<int, 3> >())
               .corners.empty());
}

BOOST_AUTO_TEST_SUITE_END()
