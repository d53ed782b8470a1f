// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_meshes.h"

#include <CGAL/Segmented_mesh/internal/refinement/Boundary_band.h>
#include <CGAL/Spectral_segmentation/internal/surface/connect_triangles.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(boundary_band)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Segmented_mesh::internal;
using internal::Boundary_band;
using internal::Vector;

namespace {

// A surface with labels, and the band around its boundaries.
struct Labeled_surface
{
  Surface surface;
  std::vector<Index> labels;
  Boundary_band band;

  Labeled_surface(const Soup& soup, const std::vector<Index>& all_labels)
    : surface(read_surface(soup)), labels(all_labels), band(surface, labels) {}

  // Returns the vertices at edges between two labels.
  std::set<Index> vertices_of_boundary() const
  {
    std::set<Index> result;
    for (Index h = 0; h < surface.number_of_halfedges(); ++h)
      if (labels[h / 3] != labels[surface.neighbor(h)])
        result.insert({surface.source_vertex(h), surface.target_vertex(h)});
    return result;
  }

  std::set<Index> fixed_vertices() const
  {
    std::set<Index> result;
    for (Index v = 0; v < surface.points.size(); ++v)
      if (band.is_fixed(v))
        result.insert(v);
    return result;
  }
};

template <class Function>
Labeled_surface labeled(const Soup& soup, const Function& label_at)
{ return {soup, by_place<Index>(soup, label_at)}; }

// Returns the grid's vertices at these places, given as x + 100 y.
std::set<int> places(const Labeled_surface& s, const std::set<Index>& vertices)
{
  std::set<int> result;
  for (Index v : vertices)
    result.insert(int(s.surface.points[v].x()) + 100 * int(s.surface.points[v].y()));
  return result;
}

// Makes a cube of side 4 on a slab of 12 by 12; they meet in a square at z = 1.
Soup figure()
{
  Cells cells;
  add_box(cells, {0, 0, 0}, {12, 12, 1});
  add_box(cells, {4, 4, 1}, {8, 8, 5});
  return boundary_of(cells);
}

} // namespace

BOOST_AUTO_TEST_CASE(the_band_has_the_vertices_within_two_edges)
{
  for (const Soup& soup : {sphere(3), torus(2, 0.7, 24, 12), plate(12, 9)}) {
    const Labeled_surface s = labeled(soup, [](const Point& p) { return p.x() + p.y() > 0.3; });
    std::set<Index> near = s.vertices_of_boundary();
    for (int ring = 0; ring < 2; ++ring) {
      const std::set<Index> before = near;
      for (const internal::Corners& c : s.surface.corners)
        if (before.count(c[0]) + before.count(c[1]) + before.count(c[2]) > 0)
          near.insert(c.begin(), c.end());
    }
    std::vector<Index> faces;
    for (Index f = 0; f < s.surface.number_of_faces(); ++f) {
      const internal::Corners& c = s.surface.corners[f];
      if (near.count(c[0]) + near.count(c[1]) + near.count(c[2]) > 0)
        faces.push_back(f);
    }
    for (Index v = 0; v < s.surface.points.size(); ++v)
      BOOST_TEST(s.band.is_inside(v) == (near.count(v) == 1));
    BOOST_TEST(s.band.faces == faces, tt::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_smooth_boundary_is_fixed)
{
  const Labeled_surface straight = labeled(plate(9, 7), [](const Point& p) { return p.x() > 4; });
  BOOST_TEST((straight.fixed_vertices() == straight.vertices_of_boundary()));
  BOOST_TEST(straight.fixed_vertices().size() == 8u);
  const Labeled_surface stairs = labeled(plate(9, 9), [](const Point& p)
    { return int(p.x()) + int(p.y()) > 8; });
  // only an end at the border may be smooth, and its neighbors are not
  BOOST_TEST(stairs.fixed_vertices().empty());
  BOOST_TEST(labeled(plate(9, 7), [](const Point&) { return 0; }).band.faces.empty());
}

// The boundary runs along x = 4 up to y = 8, then along y = 8 to the right.
BOOST_AUTO_TEST_CASE(vertices_within_three_edges_of_a_corner_are_not_fixed)
{
  const Labeled_surface s = labeled(plate(16, 16), [](const Point& p)
    { return p.x() > 4 && p.y() < 8; });
  BOOST_TEST(places(s, s.fixed_vertices()) ==
             (std::set<int>{4, 104, 204, 304, 404, 808, 809, 810, 811, 812, 813, 814, 815, 816}),
             tt::per_element());
}

BOOST_AUTO_TEST_CASE(a_concave_crease_is_fixed_with_its_corners)
{
  const Labeled_surface s = labeled(figure(), [](const Point& p) { return p.z() > 1; });
  BOOST_TEST(s.fixed_vertices().size() == 16u);
  BOOST_TEST((s.fixed_vertices() == s.vertices_of_boundary()));
  std::set<Index> faces; // at the edges of the boundary
  for (Index h = 0; h < s.surface.number_of_halfedges(); ++h)
    if (s.labels[h / 3] != s.labels[s.surface.neighbor(h)])
      faces.insert(h / 3);
  BOOST_TEST(std::set<Index>(s.band.kept_faces.begin(), s.band.kept_faces.end()) == faces,
             tt::per_element());
}

// The boundary leaves the crease at (6, 4) and (6, 8), and crosses the top of the cube.
BOOST_AUTO_TEST_CASE(a_boundary_may_move_where_it_leaves_a_crease)
{
  const Labeled_surface s = labeled(figure(), [](const Point& p)
    { return p.z() > 1 && p.x() < 6; });
  BOOST_TEST(places(s, s.fixed_vertices()) == (std::set<int>{404, 405, 504, 604, 704, 804, 805}),
             tt::per_element());
  for (Index v : s.fixed_vertices())
    BOOST_TEST(s.surface.points[v].z() == 1);
  std::set<Index> kept(s.band.kept_faces.begin(), s.band.kept_faces.end());
  BOOST_TEST(kept.size() == 12u); // at the six edges between fixed vertices

  // The ends of an edge of the crease that is long for the mesh are fixed.
  const Soup longer = transformed(figure(), [](const Point& p)
    { return Point(p.x() > 5 ? p.x() + 7 : p.x(), p.y(), p.z()); });
  const Labeled_surface l = labeled(longer, [](const Point& p) { return p.z() > 1 && p.x() < 13; });
  BOOST_TEST(places(l, l.fixed_vertices()) ==
             (std::set<int>{404, 405, 413, 504, 604, 704, 804, 805, 813}), tt::per_element());
}

// The edges around the top of the cube are convex. Between its corners the boundary is smooth for
// less than three edges.
BOOST_AUTO_TEST_CASE(a_convex_edge_is_not_fixed)
{
  const Labeled_surface s = labeled(figure(), [](const Point& p) { return p.z() > 4.9; });
  BOOST_TEST(s.vertices_of_boundary().size() == 16u);
  BOOST_TEST(s.fixed_vertices().empty());
  BOOST_TEST(s.band.kept_faces.empty());
}

BOOST_AUTO_TEST_CASE(the_ends_of_an_edge_of_three_faces_are_fixed)
{
  const Soup soup = fan_at_edge(3);
  Surface surface;
  for (const Point& p : soup.points)
    surface.points.push_back(Vector(p.x(), p.y(), p.z()));
  for (const auto& t : soup.triangles)
    surface.corners.push_back({Index(t[0]), Index(t[1]), Index(t[2])});
  internal::connect_triangles(surface);
  const Boundary_band band(surface, {0, 0, 0});
  for (Index v = 0; v < surface.points.size(); ++v)
    BOOST_TEST(band.is_fixed(v) == (v < 2));
}

BOOST_AUTO_TEST_SUITE_END()
