// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Segmented_mesh/close_segments.h>
#include <CGAL/Segmented_mesh/split_into_segments.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(close_segments)

namespace tt = boost::test_tools;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::Spectral_segmentation::parameters;
using namespace test_meshes;

namespace {

// Returns for each segment the sum of det(p, q, r) / 6 over its triangles.
std::map<int, double> volumes(const Soup& soup, const std::vector<int>& segment)
{
  std::map<int, double> result;
  for (std::size_t f = 0; f < segment.size(); ++f) {
    const auto& t = soup.triangles[f];
    result[segment[f]] +=
      CGAL::volume(Point(0, 0, 0), soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
  }
  return result;
}

// Returns whether as many triangles of each segment pass each edge in one direction as in the
// other.
bool is_closed(const Soup& soup, const std::vector<int>& segment)
{
  std::map<std::array<std::size_t, 3>, int> sums;
  for (std::size_t f = 0; f < segment.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = soup.triangles[f][i], w = soup.triangles[f][(i + 1) % 3];
      sums[{std::size_t(segment[f]), (std::min)(v, w), (std::max)(v, w)}] += v < w ? 1 : -1;
    }
  return std::all_of(sums.begin(), sums.end(), [](const auto& s) { return s.second == 0; });
}

// Closes segments and returns the number of triangles that were appended.
std::size_t number_of_caps(Soup& soup, std::vector<int>& segment)
{
  const std::size_t n = soup.triangles.size();
  CGAL::close_segments(soup.points, soup.triangles, segment);
  return soup.triangles.size() - n;
}

// A prism over a polygon with n corners, with levels z = 0, 1, 2, closed by fans.
Soup prism(std::size_t n)
{ return surface_of_revolution({{0, 0}, {0, 1}, {1, 1}, {2, 1}, {2, 0}}, n); }

} // namespace

BOOST_AUTO_TEST_CASE(prism_cut_in_its_middle_gets_two_flat_polygons)
{
  const std::size_t n = 12;
  Soup soup = prism(n);
  std::vector<int> segment = by_place<int>(soup, [](const Point& p) { return p.z() < 1 ? 7 : -3; });
  const std::size_t triangles = soup.triangles.size(), points = soup.points.size();
  BOOST_TEST(number_of_caps(soup, segment) == 2 * (n - 2));
  BOOST_TEST(soup.points.size() == points);
  BOOST_TEST(segment.size() == triangles + 2 * (n - 2));
  for (std::size_t f = triangles; f < soup.triangles.size(); ++f)
    BOOST_TEST(centroid(soup, f).z() == 1., tt::tolerance(1e-12));
  BOOST_TEST(is_closed(soup, segment));
  const double half = double(n) / 2 * std::sin(2 * pi / double(n)); // area of the base times 1
  for (const auto& [id, volume] : volumes(soup, segment))
    BOOST_TEST(volume == half, tt::tolerance(1e-12));
}

// A long border is flat still, and no fan would be right.
BOOST_AUTO_TEST_CASE(gear_with_many_teeth_gets_flat_caps)
{
  const std::size_t n = 800;
  Soup soup;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * pi * double(i) / n, radius = i % 2 == 0 ? 1 : 0.5;
    for (double z : {0., 1.})
      soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    const std::size_t a = 2 * i, b = 2 * ((i + 1) % n);
    soup.triangles.push_back({a, b, a + 1});
    soup.triangles.push_back({b, b + 1, a + 1});
  }
  std::vector<int> segment(soup.triangles.size(), 0);
  BOOST_TEST(number_of_caps(soup, segment) == 2 * (n - 2));
  BOOST_TEST(is_closed(soup, segment));
  BOOST_TEST(volumes(soup, segment)[0] == double(n) / 4 * std::sin(2 * pi / double(n)),
             tt::tolerance(1e-9));
}

// There is no cap that is better than another, but the time must be short.
BOOST_AUTO_TEST_CASE(border_that_fills_space_gets_fans)
{
  const std::size_t n = 2000;
  Random random(1);
  std::uniform_real_distribution<double> coordinate(0, 1);
  Soup soup;
  for (std::size_t i = 0; i < n; ++i) {
    const Point p(coordinate(random), coordinate(random), coordinate(random));
    soup.points.push_back(p);
    soup.points.emplace_back(p.x() + 0.001, p.y(), p.z());
    const std::size_t a = 2 * i, b = 2 * ((i + 1) % n);
    soup.triangles.push_back({a, b, a + 1});
    soup.triangles.push_back({b, b + 1, a + 1});
  }
  std::vector<int> segment(soup.triangles.size(), 0);
  BOOST_TEST(number_of_caps(soup, segment) == 2 * n);
  BOOST_TEST(is_closed(soup, segment));
}

BOOST_AUTO_TEST_CASE(corners_must_be_able_to_count_new_points)
{
  std::vector<std::array<double, 3> > points;
  std::vector<std::array<unsigned char, 3> > triangles;
  std::vector<int> segment;
  for (int i = 0; i < 128; ++i) { // a crumpled strip
    for (int k : {0, 1})
      points.push_back({double(i * 37 % 41), double(i * 53 % 43), double(i * 29 % 47) + 0.01 * k});
    const int a = 2 * i, b = 2 * ((i + 1) % 128);
    const auto corner = [](int v) { return static_cast<unsigned char>(v); };
    triangles.push_back({corner(a), corner(b), corner(a + 1)});
    triangles.push_back({corner(b), corner(b + 1), corner(a + 1)});
    segment.insert(segment.end(), 2, 0);
  }
  BOOST_CHECK_THROW(CGAL::close_segments(points, triangles, segment), std::overflow_error);
  BOOST_TEST(points.size() == 256u);
  BOOST_TEST(triangles.size() == 256u);
}

// Their borders have arcs in common, which are no loops.
BOOST_AUTO_TEST_CASE(three_sectors_that_meet_at_the_axis_fit)
{
  Soup soup = prism(12);
  std::vector<int> segment = by_place<int>(soup, [](const Point& p) {
    return int((std::atan2(p.y(), p.x()) + pi) / (2 * pi) * 3);
  });
  const double whole = volumes(soup, std::vector<int>(segment.size(), 0))[0];
  BOOST_TEST(number_of_caps(soup, segment) > 0);
  BOOST_TEST(is_closed(soup, segment));
  const std::map<int, double> parts = volumes(soup, segment);
  BOOST_TEST(parts.size() == 3);
  double sum = 0;
  for (const auto& [id, volume] : parts) {
    BOOST_TEST(volume > whole / 6);
    sum += volume;
  }
  BOOST_TEST(sum == whole, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(holes_of_the_surface_are_closed_too)
{
  Soup soup = surface_of_revolution({{0, 1}, {1, 1}, {2, 1}}, 8); // an open tube
  std::vector<int> segment = by_place<int>(soup, [](const Point& p) { return p.z() < 1; });
  CGAL::close_segments(soup.points, soup.triangles, segment);
  BOOST_TEST(is_closed(soup, segment));
  for (const auto& [id, volume] : volumes(soup, segment))
    BOOST_TEST(volume == 4 * std::sin(pi / 4), tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(cap_whose_edge_is_taken_is_a_fan)
{
  // A tetrahedron of which two faces are a segment: the other two have the sixth edge.
  Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  std::vector<int> segment = {0, 0, 1, 1};
  BOOST_TEST(number_of_caps(soup, segment) == 8);
  BOOST_REQUIRE(soup.points.size() == 5);
  BOOST_TEST(soup.points[4] == Point(0.25, 0.25, 0.25));
  BOOST_TEST(is_closed(soup, segment));
  const std::map<int, double> parts = volumes(soup, segment);
  BOOST_TEST(parts.at(0) + parts.at(1) == 1. / 6, tt::tolerance(1e-12));
  BOOST_TEST(parts.at(0) > 0);
}

BOOST_AUTO_TEST_CASE(closed_segments_stay_as_they_are)
{
  Soup soup = sphere(1);
  std::vector<int> segment(soup.triangles.size(), 4);
  BOOST_TEST(number_of_caps(soup, segment) == 0);
  Soup none;
  std::vector<int> no_segment;
  BOOST_TEST(number_of_caps(none, no_segment) == 0);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused_and_left_as_it_is)
{
  const Soup good = sphere(0);
  const std::vector<int> ids(20, 0);
  const auto is_refused = [&](Soup soup, std::vector<int> segment) {
    const std::size_t points = soup.points.size(), triangles = soup.triangles.size();
    BOOST_CHECK_THROW(CGAL::close_segments(soup.points, soup.triangles, segment),
                      std::invalid_argument);
    BOOST_TEST(soup.points.size() == points);
    BOOST_TEST(soup.triangles.size() == triangles);
  };
  is_refused(good, std::vector<int>(19, 0));
  Soup bad = good;
  bad.triangles[3] = {0, 1};
  is_refused(bad, ids);
  bad.triangles[3] = {0, 1, 12};
  is_refused(bad, ids);
  bad = good;
  bad.points[5] = Point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  is_refused(bad, ids);
}

BOOST_AUTO_TEST_CASE(open_parts_have_the_faces_of_their_segments)
{
  const Mesh mesh = mesh_of(prism(6));
  Labels labels;
  const auto segment_ids = map_to(labels, mesh);
  for (Mesh::Face_index f : mesh.faces())
    labels[f] = f % 3; // patches that touch themselves at vertices
  std::vector<Mesh> parts(1);
  std::vector<std::vector<Mesh::Face_index> > faces;
  CGAL::split_into_segments(mesh, segment_ids, parts, params::faces_of_parts(faces));
  BOOST_REQUIRE(parts.size() == 4); // one was there
  BOOST_REQUIRE(faces.size() == 3);
  const auto triangle = [](const Mesh& m, Mesh::Face_index f) {
    std::vector<Point> result;
    for (Mesh::Vertex_index v : CGAL::vertices_around_face(m.halfedge(f), m))
      result.push_back(m.point(v));
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
  };
  for (std::size_t s = 0; s < 3; ++s) {
    const Mesh& part = parts[s + 1];
    BOOST_TEST(CGAL::is_valid_polygon_mesh(part));
    BOOST_REQUIRE(part.number_of_faces() == faces[s].size());
    for (Mesh::Face_index f : part.faces()) {
      BOOST_TEST(labels[faces[s][f]] == s);
      BOOST_TEST((triangle(part, f) == triangle(mesh, faces[s][f])));
    }
  }
}

// Returns whether the mesh of a part is a solid, by functions of CGAL.
bool is_solid(const Mesh& part)
{
  return CGAL::is_closed(part) && PMP::volume(part) > 0 && !PMP::does_self_intersect(part) &&
         PMP::is_outward_oriented(part);
}

// Their boundaries have folds and teeth, so that flat caps would leave the solid.
BOOST_AUTO_TEST_CASE(closed_parts_of_real_meshes_are_solid)
{
  for (const char* name : {"elephant", "hand", "homer", "oblong", "part", "joint"}) {
    BOOST_TEST_CONTEXT(name) {
      const Mesh mesh = mesh_of(read(name + std::string(".off")));
      Labels labels;
      const auto segment_ids = map_to(labels, mesh);
      const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids);
      std::vector<Mesh> parts;
      std::vector<std::vector<Mesh::Face_index> > faces;
      const auto segments = CGAL::split_into_segments(
        mesh, segment_ids, parts, params::faces_of_parts(faces).close_parts(true));
      BOOST_REQUIRE(parts.size() == n);
      BOOST_REQUIRE(segments.size() == n);
      double sum = 0;
      std::size_t number = 0;
      for (std::size_t s = 0; s < n; ++s) {
        BOOST_TEST(is_solid(parts[s]));
        BOOST_TEST(segments[s].id == s);
        BOOST_TEST(segments[s].is_solid());
        BOOST_TEST(segments[s].volume == PMP::volume(parts[s]), tt::tolerance(1e-9));
        sum += PMP::volume(parts[s]);
        for (Mesh::Face_index f : faces[s])
          number += f != Mesh::null_face();
        BOOST_TEST(faces[s].size() == parts[s].number_of_faces());
      }
      BOOST_TEST(number == mesh.number_of_faces());
      BOOST_TEST(sum == PMP::volume(mesh), tt::tolerance(1e-9));
    }
  }
}

// Returns what CGAL finds with a kernel that makes no errors.
bool is_exactly_solid(const Mesh& part)
{
  CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> copy;
  CGAL::copy_face_graph(part, copy);
  return CGAL::is_closed(copy) && PMP::volume(copy) > 0 && !PMP::does_self_intersect(copy) &&
         PMP::does_bound_a_volume(copy);
}

// Closes segments, has CGAL check that each is a solid, and returns their volumes.
std::map<int, double> volumes_of_solids(const Soup& soup, const std::vector<int>& segment)
{
  const Mesh mesh = mesh_of(soup);
  std::map<Mesh::Face_index, int> ids;
  for (Mesh::Face_index f : mesh.faces())
    ids[f] = segment[f];
  std::vector<Mesh> parts;
  const auto segments = CGAL::split_into_segments(mesh, boost::make_assoc_property_map(ids), parts,
                                                  params::close_parts(true));
  BOOST_REQUIRE(segments.size() == parts.size());
  std::map<int, double> result;
  double sum = 0;
  for (std::size_t s = 0; s < parts.size(); ++s) {
    BOOST_TEST_CONTEXT("segment " << segments[s].id) {
      BOOST_TEST(is_exactly_solid(parts[s]));
      BOOST_TEST(segments[s].is_solid());
      result[segments[s].id] = PMP::volume(parts[s]);
      BOOST_TEST(segments[s].volume == result[segments[s].id], tt::tolerance(1e-9));
      sum += PMP::volume(parts[s]);
    }
  }
  BOOST_TEST(sum == PMP::volume(mesh), tt::tolerance(1e-9));
  return result;
}

// Returns the area of a regular polygon with n corners in a circle.
double area_of_polygon(std::size_t n, double radius)
{ return double(n) / 2 * std::sin(2 * pi / double(n)) * radius * radius; }

// A prism of radius 2 and height 4 with a coaxial cavity of a radius between two heights.
Soup hollow_prism(double radius, double low, double high)
{
  return disjoint_union(
    surface_of_revolution({{0, 0}, {0, 2}, {2, 2}, {3, 2}, {4, 2}, {4, 0}}, 12),
    turned_inside_out(surface_of_revolution(
      {{low, 0}, {low, radius}, {(low + high) / 2, radius}, {high, radius}, {high, 0}}, 12)));
}

BOOST_AUTO_TEST_CASE(hollow_prism_is_cut_between_its_walls)
{
  Soup soup = hollow_prism(1, 1, 3);
  std::vector<int> segment = by_place<int>(soup, [](const Point& p) { return p.z() < 2 ? 5 : 6; });
  const double half = 2 * area_of_polygon(12, 2) - area_of_polygon(12, 1);
  for (const auto& [id, volume] : volumes_of_solids(soup, segment))
    BOOST_TEST(volume == half, tt::tolerance(1e-12));
  const std::size_t points = soup.points.size();
  BOOST_TEST(number_of_caps(soup, segment) == 2 * (12 + 12)); // a ring, no discs
  BOOST_TEST(soup.points.size() == points);
}

BOOST_AUTO_TEST_CASE(cavity_of_one_segment_stays)
{
  const Soup soup = hollow_prism(1, 1, 2);
  const auto volume = volumes_of_solids(
    soup, by_place<int>(soup, [](const Point& p) { return p.z() < 3 ? 5 : 6; }));
  BOOST_TEST(volume.at(5) == 3 * area_of_polygon(12, 2) - area_of_polygon(12, 1),
             tt::tolerance(1e-12));
  BOOST_TEST(volume.at(6) == area_of_polygon(12, 2), tt::tolerance(1e-12));
}

// Each part has a piece of the inner wall. The edge between the walls at the axis is an edge of
// three segments, but not of four.
BOOST_AUTO_TEST_CASE(sectors_of_a_hollow_prism_fit)
{
  const Soup soup = hollow_prism(1, 1, 3);
  const double whole = 4 * area_of_polygon(12, 2) - 2 * area_of_polygon(12, 1);
  for (int n : {2, 3, 4}) {
    const auto volume = volumes_of_solids(soup, by_place<int>(soup, [n](const Point& p) {
      return int((std::atan2(p.y(), p.x()) + pi) / (2 * pi) * n);
    }));
    BOOST_TEST(volume.size() == std::size_t(n));
    for (const auto& [id, v] : volume)
      BOOST_TEST(v == whole / n, tt::tolerance(n < 4 ? 1e-9 : 0.1));
  }
}

// Three segments meet at two edges of the ring: the lower half, and two quarters above it.
BOOST_AUTO_TEST_CASE(ring_between_one_segment_and_two_others_fits)
{
  const Soup soup = hollow_prism(1.5, 1, 3);
  const auto volume = volumes_of_solids(soup, by_place<int>(soup, [](const Point& p) {
    return p.z() < 2 ? 0 : p.y() < 0 ? 1 : 2;
  }));
  const double half = 2 * area_of_polygon(12, 2) - area_of_polygon(12, 1.5);
  BOOST_TEST(volume.at(0) == half, tt::tolerance(1e-9));
  BOOST_TEST(volume.at(1) == half / 2, tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(cut_through_two_cavities_has_two_holes)
{
  const Soup cavity = turned_inside_out(surface_of_revolution(
    {{1, 0}, {1, 0.5}, {2, 0.5}, {3, 0.5}, {3, 0}}, 6));
  Soup soup = surface_of_revolution({{0, 0}, {0, 2}, {2, 2}, {4, 2}, {4, 0}}, 12);
  for (double x : {-0.9, 0.9})
    soup = disjoint_union(soup, moved(cavity, x, 0.1, 0));
  for (const auto& [id, volume] : volumes_of_solids(
         soup, by_place<int>(soup, [](const Point& p) { return p.z() < 2; })))
    BOOST_TEST(volume == 2 * area_of_polygon(12, 2) - 2 * area_of_polygon(6, 0.5),
               tt::tolerance(1e-12));
}

// Checks the volume of each part, which `part_at` has for the place of a face.
template <class PartAt>
void check_volumes(const Soup& soup, const PartAt& part_at, const std::vector<double>& expected)
{
  const auto volumes = volumes_of_solids(soup, by_place<int>(soup, part_at));
  BOOST_TEST(volumes.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    BOOST_TEST(volumes.at(int(i)) == expected[i], tt::tolerance(1e-12));
}

// Two boxes stand on a plate and against each other, so that borders have right angles, and three
// planes meet in the corner of the last box. Each part has the volume of its cubes.
BOOST_AUTO_TEST_CASE(boxes_in_corners_get_flat_sectors)
{
  Cells cells;
  add_box(cells, {0, 0, 0}, {12, 8, 2});
  add_box(cells, {2, 2, 2}, {5, 5, 10});
  add_box(cells, {5, 3, 2}, {10, 4, 6});
  check_volumes(boundary_of(cells), [](const Point& p) {
    return p.z() <= 2 ? 0 : p.x() <= 5 ? 1 : 2;
  }, {192, 72, 20});

  cells.clear();
  add_box(cells, {0, 0, 0}, {8, 8, 2});
  add_box(cells, {0, 0, 2}, {1, 8, 10});
  add_box(cells, {1, 0, 2}, {8, 1, 10});
  add_box(cells, {1, 1, 2}, {4, 4, 5});
  check_volumes(boundary_of(cells), [](const Point& p) {
    return p.z() <= 2 ? 0 : p.x() <= 1 ? 1 : p.y() <= 1 ? 2 : 3;
  }, {128, 64, 56, 27});
}

// The first cap takes the place that another one needs, so that another order is tried.
BOOST_AUTO_TEST_CASE(walls_at_a_corner_are_closed_in_another_order)
{
  Cells cells;
  add_box(cells, {1, 1, 0}, {20, 10, 1});
  add_box(cells, {3, 1, 1}, {5, 10, 12});
  add_box(cells, {1, 0, 0}, {4, 1, 9});
  const Soup soup = boundary_of(cells);
  const Mesh mesh = mesh_of(soup);
  Labels labels;
  const auto segment_ids = map_to(labels, mesh);
  BOOST_TEST(CGAL::segment_spectral_recursive(mesh, segment_ids) == 3);
  double sum = 0;
  for (const auto& [id, volume] :
       volumes_of_solids(soup, std::vector<int>(labels.begin(), labels.end())))
    sum += volume;
  BOOST_TEST(sum == 19 * 9 * 1 + 2 * 9 * 11 + 3 * 1 * 9, tt::tolerance(1e-9));
}

// Returns a mesh and a copy that is turned inside out and moved inwards.
Soup hollow(const Soup& soup, double depth)
{
  const Mesh mesh = mesh_of(soup);
  Soup inner = turned_inside_out(soup);
  for (Mesh::Vertex_index v : mesh.vertices())
    inner.points[v] = inner.points[v] - depth * PMP::compute_vertex_normal(v, mesh);
  return disjoint_union(soup, inner);
}

BOOST_AUTO_TEST_CASE(parts_of_hollow_real_meshes_are_solid)
{
  for (const char* name : {"blobby", "dragknob", "eight", "knot", "pinion"}) {
    BOOST_TEST_CONTEXT(name) {
      const Soup soup = read(name + std::string(".off"));
      const Mesh mesh = mesh_of(soup);
      Labels labels;
      const auto segment_ids = map_to(labels, mesh);
      CGAL::segment_spectral_recursive(mesh, segment_ids, params::number_of_segments(6));
      std::vector<int> segment(labels.begin(), labels.end());
      segment.insert(segment.end(), labels.begin(), labels.end());
      const CGAL::Bbox_3 box = CGAL::bbox_3(soup.points.begin(), soup.points.end());
      const double diagonal = std::sqrt(std::pow(box.x_span(), 2) + std::pow(box.y_span(), 2) +
                                        std::pow(box.z_span(), 2));
      volumes_of_solids(hollow(soup, 0.01 * diagonal), segment);
    }
  }
}

// Their triangles do not lie opposite of each other, and borders zigzag.
BOOST_AUTO_TEST_CASE(walls_of_a_sphere_with_other_triangles_are_joined)
{
  const Soup soup = disjoint_union(sphere(3), turned_inside_out(scaled(sphere(2), 0.8)));
  for (int n : {2, 3})
    volumes_of_solids(soup, by_place<int>(soup, [n](const Point& p) {
      return int((std::atan2(p.y() + 0.1, p.x() + 0.2) + pi) / (2 * pi) * n);
    }));
}

// One of its segments is a flat base, whose cap must not lie in it.
BOOST_AUTO_TEST_CASE(base_of_a_prism_that_is_inside_out_becomes_solid)
{
  const Soup soup = turned_inside_out(prism(12));
  const Mesh mesh = mesh_of(soup);
  Labels labels;
  const auto segment_ids = map_to(labels, mesh);
  for (Mesh::Face_index f : mesh.faces())
    labels[f] = centroid(soup, f).z() > 1.9 ? 1 : 0;
  std::vector<Mesh> parts;
  CGAL::split_into_segments(mesh, segment_ids, parts, params::close_parts(true));
  BOOST_REQUIRE(parts.size() == 2);
  BOOST_TEST(is_solid(parts[0]));
  BOOST_TEST(is_solid(parts[1]));
  BOOST_TEST(PMP::volume(parts[0]) + PMP::volume(parts[1]) == -PMP::volume(mesh),
             tt::tolerance(1e-12));
}

// Each property fails alone. The volumes are worked out by hand.
BOOST_AUTO_TEST_CASE(broken_promises_are_reported)
{
  const auto told = [](Soup soup) {
    std::vector<int> segment(soup.triangles.size(), 7);
    const auto result = CGAL::close_segments(soup.points, soup.triangles, segment);
    BOOST_REQUIRE(result.size() == 1);
    BOOST_TEST(result[0].id == 7);
    return result[0];
  };
  const auto add_tetrahedron = [](Soup& soup, const std::vector<Point>& corners) {
    const std::size_t n = soup.points.size();
    soup.points.insert(soup.points.end(), corners.begin(), corners.end());
    for (const auto& t : std::vector<std::vector<std::size_t> >{
           {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}})
      soup.triangles.push_back({n + t[0], n + t[1], n + t[2]});
  };
  const std::vector<Point> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Soup soup;
  add_tetrahedron(soup, corners);
  BOOST_TEST(told(soup).is_solid());
  BOOST_TEST(told(soup).volume == 1. / 6, tt::tolerance(1e-12));

  const Soup inside_out = turned_inside_out(soup);
  BOOST_TEST(!told(inside_out).is_outward_oriented);
  BOOST_TEST(told(inside_out).is_manifold);
  BOOST_TEST(!told(inside_out).has_self_intersections);

  Soup two = soup; // the second one intersects the first
  add_tetrahedron(two, {{0.1, 0.1, 0.1}, {1.1, 0.1, 0.1}, {0.1, 1.1, 0.1}, {0.1, 0.1, 1.1}});
  BOOST_TEST(told(two).has_self_intersections);
  BOOST_TEST(told(two).is_manifold);
  BOOST_TEST(told(two).volume == 1. / 3, tt::tolerance(1e-12));

  Soup pinched = soup; // both have the vertex 0
  add_tetrahedron(pinched, {{0, 0, 0}, {-1, 0, 0}, {0, 0, -1}, {0, -1, 0}});
  for (auto& t : pinched.triangles)
    std::replace(t.begin(), t.end(), std::size_t(4), std::size_t(0));
  BOOST_TEST(told(pinched).is_closed);
  BOOST_TEST(!told(pinched).is_manifold);

  Soup nested = soup; // two walls that are both oriented outward
  add_tetrahedron(nested, {{0.1, 0.1, 0.1}, {0.2, 0.1, 0.1}, {0.1, 0.2, 0.1}, {0.1, 0.1, 0.2}});
  BOOST_TEST(!told(nested).is_outward_oriented);
  BOOST_TEST(!told(nested).has_self_intersections);
  Soup cavity = soup;
  add_tetrahedron(cavity, {{0.1, 0.1, 0.1}, {0.1, 0.2, 0.1}, {0.2, 0.1, 0.1}, {0.1, 0.1, 0.2}});
  BOOST_TEST(told(cavity).is_solid());
  BOOST_TEST(told(cavity).volume == 0.999 / 6, tt::tolerance(1e-12));
  Soup beside = soup; // it would be a cavity if it were inside
  add_tetrahedron(beside, {{1.1, 1.1, 1.1}, {1.1, 1.2, 1.1}, {1.2, 1.1, 1.1}, {1.1, 1.1, 1.2}});
  BOOST_TEST(!told(beside).is_outward_oriented);
  BOOST_TEST(told(beside).volume == 0.999 / 6, tt::tolerance(1e-12));

  Soup edge = soup; // a third triangle at an edge, which a flat cap doubles
  edge.triangles.push_back({0, 1, 2});
  BOOST_TEST(!told(edge).is_closed);
  BOOST_TEST(!told(edge).is_solid());
}

BOOST_AUTO_TEST_CASE(parts_of_a_polyhedron)
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  const Soup soup = prism(5);
  Polyhedron mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  std::map<Polyhedron::Facet_const_handle, int> segment;
  for (auto f : CGAL::faces(mesh))
    segment[f] = CGAL::centroid(f->halfedge()->vertex()->point(),
                                f->halfedge()->next()->vertex()->point(),
                                f->halfedge()->next()->next()->vertex()->point()).z() < 1;
  std::vector<Mesh> parts;
  CGAL::split_into_segments(mesh, boost::make_assoc_property_map(segment), parts,
                            params::close_parts(true));
  BOOST_REQUIRE(parts.size() == 2);
  BOOST_TEST(PMP::volume(parts[0]) == PMP::volume(mesh) / 2, tt::tolerance(1e-12));
  BOOST_TEST(PMP::volume(parts[1]) == PMP::volume(mesh) / 2, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
