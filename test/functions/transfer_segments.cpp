// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Segmented_mesh/transfer_segments.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(transfer_segments)

using namespace test_meshes;

namespace {

typedef std::vector<int> Ids;

// Returns the ids that the faces of `to` get.
Ids transfer(const Mesh& from, Ids from_ids, const Mesh& to)
{
  Ids result(num_faces(to), -1);
  CGAL::transfer_segments(
    from, boost::make_iterator_property_map(from_ids.begin(), get(CGAL::face_index, from)),
    to, boost::make_iterator_property_map(result.begin(), get(CGAL::face_index, to)));
  return result;
}

Ids transfer(const Soup& from, const Ids& ids, const Soup& to)
{ return transfer(mesh_of(from), ids, mesh_of(to)); }

Ids random_ids(std::size_t n, std::mt19937& random)
{
  Ids result(n);
  for (int& id : result)
    id = static_cast<int>(random() % 7) - 3;
  return result;
}

// A sheet of nx * ny squares: two plates that look away from each other.
Soup sheet(std::size_t nx, std::size_t ny, double thickness)
{
  const Soup top = plate(nx, ny);
  const std::size_t n = top.points.size();
  Soup result;
  for (double z : {thickness / 2, -thickness / 2})
    for (const Point& p : top.points)
      result.points.emplace_back(p.x(), p.y(), z);
  result.triangles = top.triangles;
  for (const std::vector<std::size_t>& t : top.triangles)
    result.triangles.push_back({n + t[1], n + t[0], n + t[2]});
  return result;
}

std::size_t number_of_pieces(const Mesh& mesh, const Ids& ids)
{ return number_of_connected_pieces(mesh, Labels(ids.begin(), ids.end())); }

template <class Mesh1, class Mesh2>
void check_error(const Mesh1& from, const Mesh2& to)
{
  std::map<typename boost::graph_traits<Mesh1>::face_descriptor, int> from_ids;
  std::map<typename boost::graph_traits<Mesh2>::face_descriptor, int> to_ids;
  BOOST_CHECK_THROW(CGAL::transfer_segments(from, boost::make_assoc_property_map(from_ids), to,
                                            boost::make_assoc_property_map(to_ids)),
                    std::invalid_argument);
  BOOST_TEST(to_ids.empty());
}

} // namespace

BOOST_AUTO_TEST_CASE(faces_and_vertices_in_random_order)
{
  std::mt19937 random(1);
  for (const Soup& soup : {sphere(2), torus(3, 1, 20, 12), plate(9, 7), sheet(6, 5, 0)}) {
    const Ids ids = random_ids(soup.triangles.size(), random);
    std::vector<std::size_t> face;
    const Soup other = renumbered(soup, random, face);
    Ids expected(ids.size());
    for (std::size_t f = 0; f < face.size(); ++f)
      expected[face[f]] = ids[f];
    BOOST_TEST(transfer(soup, ids, other) == expected, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(parts_of_faces_have_the_ids_of_the_faces_and_give_them_back)
{
  std::mt19937 random(2);
  for (const Soup& soup : {sphere(2), torus(3, 1, 20, 12), plate(9, 7), sheet(6, 5, 0.01)}) {
    const Soup fine = subdivided(soup);
    const Ids ids = random_ids(soup.triangles.size(), random);
    const Ids fine_ids = transfer(soup, ids, fine);
    for (std::size_t f = 0; f < fine_ids.size(); ++f)
      BOOST_TEST(fine_ids[f] == ids[f / 4]);
    BOOST_TEST(transfer(fine, fine_ids, soup) == ids, boost::test_tools::per_element());
  }
}

// A mesh with the same vertices may be anywhere; with another order of faces it may not.
BOOST_AUTO_TEST_CASE(a_deformed_mesh_with_the_same_faces)
{
  std::mt19937 random(3);
  const Soup soup = torus(3, 1, 20, 12);
  const Ids ids = random_ids(soup.triangles.size(), random);
  Soup other = soup;
  for (Point& p : other.points)
    p = Point(100 - 3 * p.z(), p.x() * p.y(), 7 + p.y());
  BOOST_TEST(transfer(soup, ids, other) == ids, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(faces_that_are_not_connected_go_by_place)
{
  const Soup soup = sphere(1);
  Soup pieces, reversed;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      pieces.points.push_back(soup.points[soup.triangles[f][i]]);
      reversed.points.push_back(soup.points[soup.triangles[soup.triangles.size() - 1 - f][i]]);
    }
  for (std::size_t v = 0; v < pieces.points.size(); v += 3)
    pieces.triangles.push_back({v, v + 1, v + 2});
  reversed.triangles = pieces.triangles;
  Ids ids;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    ids.push_back(static_cast<int>(f));
  const Ids result = transfer(pieces, ids, reversed);
  BOOST_TEST(Ids(result.rbegin(), result.rend()) == ids, boost::test_tools::per_element());
}

// Each side of the other sheet is nearer to the wrong side of the first.
BOOST_AUTO_TEST_CASE(sides_of_a_thin_sheet)
{
  const auto side_ids = [](const Soup& soup) {
    Ids result(soup.triangles.size(), 1);
    std::fill(result.begin(), result.begin() + static_cast<int>(result.size() / 2), 0);
    return result;
  };
  for (double thickness : {0., 0.001, 0.05})
    for (double shift : {0., 0.1, -0.1}) {
      const Soup soup = sheet(12, 9, thickness);
      Soup other = subdivided(sheet(6, 6, thickness));
      for (Point& p : other.points)
        p = Point(2 * p.x(), 1.5 * p.y(), p.z() + shift);
      BOOST_TEST(transfer(soup, side_ids(soup), other) == side_ids(other),
                 boost::test_tools::per_element());
      BOOST_TEST(transfer(other, side_ids(other), soup) == side_ids(soup),
                 boost::test_tools::per_element());
    }
}

BOOST_AUTO_TEST_CASE(sides_of_a_box)
{
  Cells box;
  add_box(box, {0, 0, 0}, {1, 1, 1});
  const Soup soup = boundary_of(box);
  const auto side = [](const Point& p) {
    for (int i = 0; i < 3; ++i)
      for (int end : {0, 1})
        if (std::abs(p[i] - end) < 1e-9)
          return 2 * i + end;
    return -1;
  };
  const Soup fine = subdivided(subdivided(soup));
  BOOST_TEST(transfer(soup, by_place<int>(soup, side), fine) == by_place<int>(fine, side),
             boost::test_tools::per_element());
  BOOST_TEST(transfer(fine, by_place<int>(fine, side), soup) == by_place<int>(soup, side),
             boost::test_tools::per_element());
}

// The centroids of one triangulation lie on the diagonals of the other.
BOOST_AUTO_TEST_CASE(the_first_of_equally_near_faces)
{
  const Soup soup = plate(4, 4);
  Soup other = soup;
  for (std::size_t f = 0; f < soup.triangles.size(); f += 2) {
    const std::vector<std::size_t> t = soup.triangles[f], u = soup.triangles[f + 1];
    other.triangles[f] = {t[0], t[1], u[2]};
    other.triangles[f + 1] = {t[1], t[2], u[2]};
  }
  Ids ids;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    ids.push_back(static_cast<int>(f));
  const Ids result = transfer(soup, ids, other);
  for (std::size_t f = 0; f < result.size(); ++f)
    BOOST_TEST(result[f] == int(f - f % 2));
}

// A sphere of a quarter of the faces moves the boundary between two halves, but no piece comes off.
BOOST_AUTO_TEST_CASE(a_coarse_sphere_and_back)
{
  const Soup soup = sphere(4);
  const Ids ids = by_place<int>(soup, [](const Point& p)
    { return p.x() + 0.3 * p.y() + 0.2 * p.z() < 0.1 ? 5 : 9; });
  Soup other = sphere(3);
  for (Point& p : other.points) // turned around the x axis, then around the z axis
    p = Point(0.6 * p.x() - 0.8 * (0.8 * p.y() - 0.6 * p.z()),
              0.8 * p.x() + 0.6 * (0.8 * p.y() - 0.6 * p.z()), 0.6 * p.y() + 0.8 * p.z());
  const Mesh mesh = mesh_of(soup), coarse = mesh_of(other);
  const Ids coarse_ids = transfer(mesh, ids, coarse);
  const Ids result = transfer(coarse, coarse_ids, mesh);
  std::size_t number_of_equal = 0;
  for (std::size_t f = 0; f < ids.size(); ++f)
    number_of_equal += result[f] == ids[f];
  BOOST_TEST(double(number_of_equal) > 0.98 * double(ids.size()));
  BOOST_TEST(number_of_pieces(coarse, coarse_ids) == 2u);
  BOOST_TEST(number_of_pieces(mesh, result) == 2u);
}

// A small segment stays, though a piece as small that comes off another one would not.
BOOST_AUTO_TEST_CASE(small_segments_stay)
{
  const Soup soup = plate(20, 20);
  const auto id = [](const Point& p) { return std::abs(p.x() - 7) + std::abs(p.y() - 9) < 1.5; };
  const Soup fine = subdivided(soup);
  const Ids expected = by_place<int>(soup, id), result = transfer(soup, expected, fine);
  for (std::size_t f = 0; f < result.size(); ++f)
    BOOST_TEST(result[f] == expected[f / 4]);
}

BOOST_AUTO_TEST_CASE(other_types_and_point_maps)
{
  const Soup soup = sphere(2), fine = subdivided(soup);
  const Mesh from = mesh_of(soup);
  CGAL::Polyhedron_3<Kernel> to;
  Mesh moved = mesh_of(fine);
  for (auto v : moved.vertices())
    moved.point(v) = moved.point(v) + Kernel::Vector_3(10, 0, 0);
  CGAL::copy_face_graph(moved, to);
  std::map<boost::graph_traits<CGAL::Polyhedron_3<Kernel> >::vertex_descriptor, Point> points;
  for (auto v : vertices(to))
    points[v] = v->point() - Kernel::Vector_3(10, 0, 0);

  std::vector<std::int64_t> ids;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    ids.push_back(std::int64_t(f) - 100);
  const auto from_ids =
    boost::make_iterator_property_map(ids.begin(), get(CGAL::face_index, from));
  std::map<boost::graph_traits<CGAL::Polyhedron_3<Kernel> >::face_descriptor, short> to_ids;
  const auto np_to = CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(points));
  CGAL::transfer_segments(
    from, from_ids, to, boost::make_assoc_property_map(to_ids),
    CGAL::Spectral_segmentation::parameters::geom_traits(Kernel()), np_to);
  std::size_t i = 0;
  for (auto f : faces(to))
    BOOST_TEST(to_ids[f] == int(i++ / 4) - 100);

  to_ids.clear();
  for (std::int64_t too_large : {std::int64_t(40000), std::int64_t(-40000)}) {
    ids[3] = too_large;
    BOOST_CHECK_THROW(CGAL::transfer_segments(from, from_ids, to,
                                              boost::make_assoc_property_map(to_ids),
                                              CGAL::parameters::all_default(), np_to),
                      std::overflow_error);
  }
  BOOST_TEST(to_ids.empty());
}

BOOST_AUTO_TEST_CASE(wrong_input)
{
  const Mesh good = mesh_of(sphere(1)), empty;
  Mesh quad, infinite = good, nan = good;
  CGAL::make_quad(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), quad);
  infinite.point(Mesh::Vertex_index(5)) = Point(0, std::numeric_limits<double>::infinity(), 0);
  nan.point(Mesh::Vertex_index(0)) = Point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  for (const Mesh* bad : {&quad, &infinite, &nan}) {
    check_error(*bad, good);
    check_error(good, *bad);
  }
  check_error(empty, good);
  BOOST_TEST(transfer(good, Ids(num_faces(good), 1), empty).empty());
  BOOST_TEST(transfer(empty, {}, empty).empty());
}

BOOST_AUTO_TEST_CASE(faces_without_area)
{
  const Soup soup = sphere(2);
  const Ids ids = by_place<int>(soup, [](const Point& p) { return p.z() < 0; });
  for (const Point& p : {Point(0, 0, 0), Point(3e-320, 0, 0)}) { // everything at one place
    Soup point = subdivided(soup);
    std::fill(point.points.begin(), point.points.end(), p);
    const Ids result = transfer(soup, ids, point);
    BOOST_TEST(std::set<int>(result.begin(), result.end()).size() == 1u);
    BOOST_TEST(transfer(point, Ids(point.triangles.size(), 4), soup) ==
                 Ids(soup.triangles.size(), 4), boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_SUITE_END()
