// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Segmented_mesh/refine_segment_boundaries.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(refine_segment_boundaries)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

typedef Mesh::Property_map<Mesh::Face_index, int> Segment_map;

struct Segmented_mesh
{
  Mesh mesh;
  Segment_map segment;

  Segmented_mesh(const Soup& soup, const Labels& labels) : mesh(mesh_of(soup))
  {
    segment = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
    for (Mesh::Face_index f : mesh.faces())
      segment[f] = int(labels[f]);
  }

  Segmented_mesh(const Segmented_mesh& other) : mesh(other.mesh)
  { segment = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first; }

  std::size_t refine() { return CGAL::refine_segment_boundaries(mesh, segment); }

  Labels labels() const
  {
    Labels result;
    for (Mesh::Face_index f : mesh.faces())
      result.push_back(std::size_t(segment[f]));
    return result;
  }

  bool is_in_boundary(Mesh::Edge_index e) const
  {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    return !mesh.is_border(e) &&
           segment[mesh.face(h)] != segment[mesh.face(mesh.opposite(h))];
  }

  double boundary_length() const
  {
    double length = 0;
    for (Mesh::Edge_index e : mesh.edges())
      if (is_in_boundary(e))
        length += PMP::edge_length(mesh.halfedge(e), mesh);
    return length;
  }

  double area(int label) const
  {
    double area = 0;
    for (Mesh::Face_index f : mesh.faces())
      if (segment[f] == label)
        area += PMP::face_area(f, mesh);
    return area;
  }

  // Returns one number per segment.
  std::map<int, std::size_t> numbers_of_components() const
  {
    std::vector<std::size_t> component(mesh.number_of_faces());
    std::vector<char> is_in_any_boundary(mesh.number_of_edges());
    for (Mesh::Edge_index e : mesh.edges())
      is_in_any_boundary[e] = is_in_boundary(e);
    PMP::connected_components(
      mesh,
      boost::make_iterator_property_map(component.begin(), get(CGAL::face_index, mesh)),
      CGAL::parameters::edge_is_constrained_map(boost::make_iterator_property_map(
        is_in_any_boundary.begin(), get(boost::edge_index, mesh))));
    std::map<int, std::set<std::size_t> > components;
    for (Mesh::Face_index f : mesh.faces())
      components[segment[f]].insert(component[f]);
    std::map<int, std::size_t> result;
    for (const auto& [label, all] : components)
      result[label] = all.size();
    return result;
  }
};

std::size_t number_of_border_edges(const Mesh& mesh)
{
  std::size_t n = 0;
  for (Mesh::Edge_index e : mesh.edges())
    n += mesh.is_border(e);
  return n;
}

double border_length(const Mesh& mesh)
{
  double length = 0;
  for (Mesh::Edge_index e : mesh.edges())
    if (mesh.is_border(e))
      length += PMP::edge_length(mesh.halfedge(e), mesh);
  return length;
}

std::ptrdiff_t euler_characteristic(const Mesh& mesh)
{
  return std::ptrdiff_t(mesh.number_of_vertices()) - std::ptrdiff_t(mesh.number_of_edges()) +
         std::ptrdiff_t(mesh.number_of_faces());
}

// The refined mesh, when all that is promised for any segmentation has been checked.
Segmented_mesh refined(const Segmented_mesh& before)
{
  Segmented_mesh after(before);
  const std::size_t number = after.refine();
  const Mesh &old_mesh = before.mesh, &mesh = after.mesh;
  BOOST_TEST_REQUIRE(CGAL::is_triangle_mesh(mesh));
  BOOST_TEST_REQUIRE(CGAL::is_valid_polygon_mesh(mesh));
  BOOST_TEST(euler_characteristic(mesh) == euler_characteristic(old_mesh));
  BOOST_TEST((number == 0) == (mesh.number_of_faces() == old_mesh.number_of_faces()));
  BOOST_TEST((number_of_border_edges(mesh) == 0) == (number_of_border_edges(old_mesh) == 0));

  // The surface is the same.
  for (Mesh::Vertex_index v : old_mesh.vertices())
    BOOST_TEST(mesh.point(v) == old_mesh.point(v));
  const auto tolerance = tt::tolerance(1e-9);
  BOOST_TEST(PMP::area(mesh) == PMP::area(old_mesh), tolerance);
  BOOST_TEST(border_length(mesh) == border_length(old_mesh), tolerance);
  if (CGAL::is_closed(old_mesh))
    BOOST_TEST(std::abs(PMP::volume(mesh) - PMP::volume(old_mesh)) <
               1e-9 * std::pow(PMP::area(old_mesh), 1.5));

  // So are the segments.
  const auto old_numbers = before.numbers_of_components(), numbers = after.numbers_of_components();
  BOOST_TEST(numbers.size() == old_numbers.size());
  for (const auto& [label, old_number] : old_numbers) {
    BOOST_TEST(numbers.count(label) == 1u);
    if (numbers.count(label))
      BOOST_TEST(numbers.at(label) <= old_number);
  }
  return after;
}

Segmented_mesh refined(const Soup& soup, const Labels& labels)
{ return refined(Segmented_mesh(soup, labels)); }

// The segments grow from random faces, or each face has a label at random.
Labels random_labels(const Mesh& mesh, std::size_t number, bool is_connected, Random& random)
{
  const std::size_t n = mesh.number_of_faces();
  Labels labels(n, number);
  if (!is_connected) {
    for (std::size_t& label : labels)
      label = random() % number;
    return labels;
  }
  for (std::size_t label = 0; label < number; ++label)
    labels[random() % n] = label;
  for (std::size_t step = 0; step < 60 * n; ++step) {
    const Mesh::Halfedge_index h(Mesh::size_type(random() % mesh.number_of_halfedges()));
    if (mesh.is_border(h) || mesh.is_border(mesh.opposite(h)))
      continue;
    std::size_t& label = labels[mesh.face(h)];
    if (label == number)
      label = labels[mesh.face(mesh.opposite(h))];
  }
  return labels;
}

double mean_area(const Mesh& mesh) { return PMP::area(mesh) / double(mesh.number_of_faces()); }

double smallest_area(const Mesh& mesh)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (Mesh::Face_index f : mesh.faces())
    smallest = (std::min)(smallest, PMP::face_area(f, mesh));
  return smallest;
}

// Triangles with their labels, as sets of numbers that do not depend on the mesh type.
typedef std::multiset<std::pair<std::array<std::array<double, 3>, 3>, int> > Labeled_triangles;

template <class TriangleMesh, class SegmentMap>
Labeled_triangles labeled_triangles(const TriangleMesh& mesh, SegmentMap segment)
{
  const auto point = get(CGAL::vertex_point, mesh);
  Labeled_triangles result;
  for (auto f : faces(mesh)) {
    std::array<std::array<double, 3>, 3> triangle;
    auto h = halfedge(f, mesh);
    for (std::array<double, 3>& p : triangle) {
      const auto& q = get(point, target(h, mesh));
      p = {CGAL::to_double(q.x()), CGAL::to_double(q.y()), CGAL::to_double(q.z())};
      h = next(h, mesh);
    }
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    result.insert({triangle, get(segment, f)});
  }
  return result;
}

// A boundary between rows 11 and 13 of a plate that jumps at random.
Soup jagged_plate() { return plate(24, 24); }

Labels jagged_labels(Random& random)
{
  Labels labels;
  std::vector<std::size_t> height(24);
  for (std::size_t& y : height)
    y = 11 + random() % 3;
  for (std::size_t y = 0; y < 24; ++y)
    for (std::size_t x = 0; x < 24; ++x)
      labels.insert(labels.end(), 2, std::size_t(y >= height[x]));
  return labels;
}

// Refines a mesh of another type with the labels, and compares it with the Surface_mesh.
template <class TriangleMesh>
void check_model(const Soup& soup, const Labels& labels)
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor Face;
  Segmented_mesh expected(soup, labels);
  const std::size_t number = expected.refine();
  TriangleMesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  std::map<Face, int> segment;
  std::size_t i = 0;
  for (Face f : faces(mesh))
    segment[f] = int(labels[i++]);
  const auto map = boost::make_assoc_property_map(segment);
  BOOST_TEST(CGAL::refine_segment_boundaries(mesh, map) == number);
  BOOST_TEST(segment.size() == num_faces(mesh));
  BOOST_TEST(CGAL::is_valid_polygon_mesh(mesh));
  BOOST_TEST(labeled_triangles(mesh, map) == labeled_triangles(expected.mesh, expected.segment));
}

} // namespace

BOOST_AUTO_TEST_CASE(a_zigzag_becomes_nearly_straight)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Segmented_mesh before(jagged_plate(), jagged_labels(random));
      const Segmented_mesh after = refined(before);
      BOOST_TEST(before.boundary_length() > 1.3 * 24);
      BOOST_TEST(after.boundary_length() < 1.02 * 24);
      BOOST_TEST(std::abs(after.area(0) - before.area(0)) < 6.);
      BOOST_TEST(smallest_area(after.mesh) >= 1e-3 * mean_area(before.mesh));
      // Three rings of squares around the rows of the boundary.
      for (Mesh::Face_index f : after.mesh.faces())
        for (Mesh::Vertex_index v :
             CGAL::vertices_around_face(after.mesh.halfedge(f), after.mesh)) {
          const double y = after.mesh.point(v).y();
          BOOST_TEST((y < 17 || after.segment[f] == 1));
          BOOST_TEST((y > 8 || after.segment[f] == 0));
        }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_straight_boundary_along_edges_stays)
{
  const Soup soup = plate(16, 16);
  const Labels straight = by_place<std::size_t>(soup, [](const Point& p) { return p.x() > 8; });
  const Segmented_mesh after = refined(soup, straight);
  BOOST_TEST(after.labels() == straight, tt::per_element());

  // Only faces near the step of a boundary are split.
  const Segmented_mesh before(
    soup, by_place<std::size_t>(soup, [](const Point& p) { return p.x() > (p.y() > 8 ? 8 : 9); }));
  const Segmented_mesh stepped = refined(before);
  BOOST_TEST(stepped.boundary_length() < 16.2);
  BOOST_TEST(stepped.boundary_length() > 16.);
  for (Mesh::Vertex_index v : stepped.mesh.vertices())
    if (v >= Mesh::Vertex_index(before.mesh.number_of_vertices()))
      BOOST_TEST(std::abs(stepped.mesh.point(v).y() - 8) <= 4.);
}

BOOST_AUTO_TEST_CASE(a_crease_around_a_limb_stays)
{
  // A tube on a disk: the boundary between them is a polygon of 36 vertices.
  const Soup soup = surface_of_revolution(
    {{0, 3}, {0, 2.5}, {0, 2}, {0, 1.5}, {0, 1}, {0.5, 1}, {1, 1}, {1.5, 1}, {2, 1}}, 36);
  const Labels labels = by_place<std::size_t>(soup, [](const Point& p) { return p.z() > 0; });
  BOOST_TEST(refined(soup, labels).labels() == labels, tt::per_element());
}

// A wall on a ground, along the stairs y = floor(x): the boundary turns by 90 degrees everywhere.
BOOST_AUTO_TEST_CASE(a_crease_with_corners_stays)
{
  const int n = 6;
  Soup soup;
  Labels labels;
  std::map<std::array<int, 3>, std::size_t> vertices;
  const auto add = [&](std::size_t label, const std::array<std::array<int, 3>, 4>& corners) {
    std::array<std::size_t, 4> v;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto [found, is_new] = vertices.emplace(corners[i], soup.points.size());
      if (is_new)
        soup.points.emplace_back(corners[i][0], corners[i][1], corners[i][2]);
      v[i] = found->second;
    }
    soup.triangles.push_back({v[0], v[1], v[2]});
    soup.triangles.push_back({v[0], v[2], v[3]});
    labels.insert(labels.end(), 2, label);
  };
  const auto height = [](int x, int y) { return y >= x ? 2 : 0; };
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y) {
      const int z = height(x, y);
      add(z == 0 ? 0 : 1, {{{x, y, z}, {x + 1, y, z}, {x + 1, y + 1, z}, {x, y + 1, z}}});
      if (z == 0)
        continue;
      for (int k = 0; k < 2; ++k) {
        if (x + 1 < n && height(x + 1, y) == 0)
          add(1, {{{x + 1, y, k}, {x + 1, y + 1, k}, {x + 1, y + 1, k + 1}, {x + 1, y, k + 1}}});
        if (y > 0 && height(x, y - 1) == 0)
          add(1, {{{x, y, k}, {x + 1, y, k}, {x + 1, y, k + 1}, {x, y, k + 1}}});
      }
    }
  Segmented_mesh segmented(soup, labels);
  const double length = segmented.boundary_length(), ground = segmented.area(0);
  segmented.refine();
  // At its ends the boundary leaves the mesh.
  BOOST_TEST(segmented.boundary_length() == length, tt::tolerance(1e-9));
  BOOST_TEST(segmented.area(0) == ground, tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_tube_is_cut_around)
{
  std::vector<std::pair<double, double> > profile;
  for (int i = 0; i <= 20; ++i)
    profile.emplace_back(0.3 * i, 1.);
  const Soup tube = surface_of_revolution(profile, 20);
  const Segmented_mesh before(tube, by_place<std::size_t>(tube, [](const Point& p) {
    return p.z() > 3 + 0.4 * std::sin(9 * std::atan2(p.y(), p.x()));
  }));
  const double around = 40 * std::sin(pi / 20); // a polygon of 20 vertices on the unit circle
  BOOST_TEST(before.boundary_length() > 1.3 * around);
  const Segmented_mesh after = refined(before);
  BOOST_TEST(after.boundary_length() < 1.01 * around);
  BOOST_TEST(after.boundary_length() > around * (1 - 1e-9));
}

BOOST_AUTO_TEST_CASE(three_segments_meet_in_a_point)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Soup soup = plate(20, 20);
      const double angle = double(random() % 1000), x = 10 + double(random() % 100) / 100;
      const Segmented_mesh before(soup, by_place<std::size_t>(soup, [&](const Point& p) {
        const double turn = (std::atan2(p.y() - 10.3, p.x() - x) + angle) / (2 * pi);
        return 3 * (turn - std::floor(turn));
      }));
      const Segmented_mesh after = refined(before);
      BOOST_TEST(after.numbers_of_components().size() == 3u);
      BOOST_TEST(after.boundary_length() < 0.95 * before.boundary_length());
      std::size_t triple_points = 0;
      for (Mesh::Vertex_index v : after.mesh.vertices()) {
        std::set<int> labels;
        for (Mesh::Face_index f : CGAL::faces_around_target(after.mesh.halfedge(v), after.mesh))
          if (f != Mesh::null_face())
            labels.insert(after.segment[f]);
        triple_points += labels.size() == 3;
      }
      BOOST_TEST(triple_points == 1u);
      BOOST_TEST(smallest_area(after.mesh) >= 1e-3 * mean_area(before.mesh));
    }
  }
}

BOOST_AUTO_TEST_CASE(promises_are_kept_for_labels_at_random)
{
  std::size_t splits = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Soup& shape = small_soups()[random() % small_soups().size()];
      const Soup soup = random() % 2 ? shape : displaced(shape, 0.05, random);
      const Labels labels =
        random_labels(mesh_of(soup), 1 + random() % 7, random() % 3 != 0, random);
      const Segmented_mesh before(soup, labels), after = refined(before);
      splits += after.mesh.number_of_faces() > before.mesh.number_of_faces();
      const double mean = mean_area(before.mesh);
      if (smallest_area(before.mesh) >= 1e-2 * mean)
        BOOST_TEST(smallest_area(after.mesh) >= 1e-3 * mean);
    }
  }
  BOOST_TEST(splits > 60u);
}

BOOST_AUTO_TEST_CASE(promises_are_kept_on_larger_meshes)
{
  const std::vector<Soup> shapes = {plate(30, 20), torus(2, 0.7, 30, 14), sphere(3),
                                    dumbbell(24, 12)};
  for (unsigned seed = 0; seed < 40; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Soup soup = displaced(shapes[seed % shapes.size()], 0.02, random);
      const Labels labels =
        random_labels(mesh_of(soup), 2 + random() % 30, random() % 4 != 0, random);
      const Segmented_mesh before(soup, labels), after = refined(before);
      BOOST_TEST(after.boundary_length() < before.boundary_length());
    }
  }
}

BOOST_AUTO_TEST_CASE(tiny_segments_survive)
{
  const Soup soup = plate(12, 12);
  const auto distance = [](const Point& p, double x, double y)
  { return std::hypot(p.x() - x, p.y() - y); };
  // A face, a square, a disk; a strip of one square's width, of which no part may be lost.
  const Segmented_mesh before(soup, by_place<std::size_t>(soup, [&](const Point& p) {
    if (distance(p, 2.7, 2.3) < 0.2)
      return 1;
    if (distance(p, 5.5, 2.5) < 0.3)
      return 2;
    if (distance(p, 9, 3) < 1.5)
      return 3;
    return p.y() > 8 && p.y() < 9 ? 4 : 0;
  }));
  BOOST_TEST_REQUIRE(before.numbers_of_components().size() == 5u);
  const Segmented_mesh after = refined(before);
  BOOST_TEST(after.numbers_of_components().size() == 5u);
  for (int label : {1, 2, 3, 4})
    BOOST_TEST(after.area(label) >= before.area(label) / 2);
  BOOST_TEST(after.numbers_of_components().at(0) == 2u);
}

BOOST_AUTO_TEST_CASE(each_face_a_segment)
{
  const Soup soup = sphere(2);
  Labels labels;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    labels.push_back(f);
  BOOST_TEST(refined(soup, labels).numbers_of_components().size() == labels.size());
}

BOOST_AUTO_TEST_CASE(degenerate_faces)
{
  for (unsigned seed = 0; seed < 60; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Soup soup = plate(8, 8);
      for (std::size_t i = 0; i < 20; ++i) // some faces become segments of lines, or points
        soup.points[random() % soup.points.size()] = soup.points[random() % soup.points.size()];
      if (seed % 10 == 0)
        soup.points.assign(soup.points.size(), Point(1, 2, 3));
      if (seed % 10 == 1)
        soup = scaled(soup, 1e150);
      refined(soup, random_labels(mesh_of(soup), 4, seed % 2, random));
    }
  }
}

BOOST_AUTO_TEST_CASE(nothing_to_refine)
{
  const Soup soup = sphere(1);
  Segmented_mesh one(soup, Labels(soup.triangles.size(), 3));
  BOOST_TEST(one.refine() == 0u);
  BOOST_TEST(one.mesh.number_of_faces() == soup.triangles.size());
  Segmented_mesh empty{Soup(), Labels()};
  BOOST_TEST(empty.refine() == 0u);
  // Segments that do not touch.
  const Soup two = disjoint_union(sphere(1), moved(sphere(1), 3, 0, 0));
  Segmented_mesh apart(two, by_place<std::size_t>(two, [](const Point& p) { return p.x() > 1.5; }));
  BOOST_TEST(apart.refine() == 0u);
}

BOOST_AUTO_TEST_CASE(any_numbers_are_ids)
{
  Random random(1);
  const Segmented_mesh plain(jagged_plate(), jagged_labels(random));
  Segmented_mesh expected(plain), other(plain);
  for (Mesh::Face_index f : other.mesh.faces())
    other.segment[f] = plain.segment[f] == 0 ? -7 : 2000000000;
  expected.refine();
  other.refine();
  BOOST_TEST_REQUIRE(other.mesh.number_of_faces() == expected.mesh.number_of_faces());
  for (Mesh::Face_index f : other.mesh.faces())
    BOOST_TEST(other.segment[f] == (expected.segment[f] == 0 ? -7 : 2000000000));
}

BOOST_AUTO_TEST_CASE(all_models_of_a_mesh_give_the_same)
{
  typedef CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2, 3, CGAL::Linear_cell_complex_traits<3, Kernel> >::type Cell_complex;
  for (unsigned seed = 0; seed < 10; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Soup soup = displaced(small_soups()[seed], 0.05, random);
      const Labels labels = random_labels(mesh_of(soup), 3, true, random);
      check_model<CGAL::Polyhedron_3<Kernel> >(soup, labels);
      check_model<Cell_complex>(soup, labels);
    }
  }
}

BOOST_AUTO_TEST_CASE(points_of_an_exact_kernel_stay_on_the_surface)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;
  Random random(3);
  const Labels labels = jagged_labels(random);
  const Mesh inexact = mesh_of(jagged_plate());
  CGAL::Surface_mesh<Exact::Point_3> mesh;
  for (Mesh::Vertex_index v : inexact.vertices()) { // in an inclined plane
    const Point& p = inexact.point(v);
    mesh.add_vertex(Exact::Point_3(p.x(), p.y(), Exact::FT(p.x()) / 3 + p.y()));
  }
  for (Mesh::Face_index f : inexact.faces())
    mesh.add_face(CGAL::vertices_around_face(inexact.halfedge(f), inexact));
  const auto segment = mesh.add_property_map<CGAL::SM_Face_index, int>("f:segment").first;
  for (CGAL::SM_Face_index f : mesh.faces())
    segment[f] = int(labels[f]);
  BOOST_TEST(CGAL::refine_segment_boundaries(mesh, segment) > 0u);
  for (CGAL::SM_Vertex_index v : mesh.vertices()) {
    const Exact::Point_3& p = mesh.point(v);
    BOOST_TEST((p.z() == p.x() / 3 + p.y()));
  }
}

BOOST_AUTO_TEST_CASE(more_iterations_are_smoother)
{
  namespace parameters = CGAL::Spectral_segmentation::parameters;
  Random random(5);
  const Segmented_mesh before(jagged_plate(), jagged_labels(random));
  double longer = before.boundary_length();
  for (unsigned iterations : {0u, 3u, 15u}) {
    Segmented_mesh after(before);
    CGAL::refine_segment_boundaries(after.mesh, after.segment,
                                    parameters::number_of_iterations(iterations)
                                      .vertex_point_map(after.mesh.points())
                                      .geom_traits(Kernel()));
    BOOST_TEST(after.boundary_length() < longer);
    longer = after.boundary_length();
  }
  Segmented_mesh after(before);
  CGAL::refine_segment_boundaries(after.mesh, after.segment,
                                  parameters::vertex_point_map(after.mesh.points()));
  BOOST_TEST(after.boundary_length() == longer);
}

// The corners of the triangles of a segment by their coordinates, rounded and from the smallest on.
typedef std::multiset<std::array<std::array<long, 3>, 3> > Triangle_set;

std::map<int, Triangle_set> triangles_of_segments(const Soup& soup, const std::vector<int>& segment)
{
  std::map<int, Triangle_set> result;
  for (std::size_t f = 0; f < segment.size(); ++f) {
    std::array<std::array<long, 3>, 3> t;
    for (std::size_t i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        t[i][std::size_t(k)] = std::lround(1e7 * soup.points[soup.triangles[f][i]][k]);
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result[segment[f]].insert(t);
  }
  return result;
}

CGAL::Vector_3<Kernel> area_vector(const Soup& soup, std::size_t f)
{
  const auto& t = soup.triangles[f];
  return CGAL::cross_product(soup.points[t[1]] - soup.points[t[0]],
                             soup.points[t[2]] - soup.points[t[0]]) / 2;
}

BOOST_AUTO_TEST_CASE(triangles_are_split_like_the_faces_of_their_mesh)
{
  const std::vector<Soup> shapes = {plate(12, 9), torus(2, 0.7, 20, 9), sphere(2)};
  for (unsigned seed = 0; seed < 30; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Soup before = displaced(shapes[seed % 3], 0.02, random);
      const Labels labels = random_labels(mesh_of(before), 2 + random() % 5, true, random);
      const Segmented_mesh mesh = refined(Segmented_mesh(before, labels));
      Soup expected;
      std::vector<int> expected_segment;
      for (Mesh::Vertex_index v : mesh.mesh.vertices())
        expected.points.push_back(mesh.mesh.point(v));
      for (Mesh::Face_index f : mesh.mesh.faces()) {
        expected.triangles.emplace_back();
        for (Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.mesh.halfedge(f), mesh.mesh))
          expected.triangles.back().push_back(v);
        expected_segment.push_back(mesh.segment[f]);
      }

      Soup after = before;
      std::vector<int> segment(labels.begin(), labels.end());
      const auto refinement =
        CGAL::refine_segment_boundaries(after.points, after.triangles, segment);
      BOOST_TEST((triangles_of_segments(after, segment) ==
                  triangles_of_segments(expected, expected_segment)));

      BOOST_TEST_REQUIRE(after.points.size() == before.points.size() + refinement.points.size());
      for (std::size_t i = 0; i < refinement.points.size(); ++i) {
        const auto& [f, w] = refinement.points[i];
        const auto& t = before.triangles[f];
        const Point mean = CGAL::barycenter(before.points[t[0]], w[0], before.points[t[1]], w[1],
                                            before.points[t[2]], w[2]);
        BOOST_TEST(CGAL::squared_distance(mean, after.points[before.points.size() + i]) < 1e-24);
        BOOST_TEST(w[0] + w[1] + w[2] == 1, tt::tolerance(1e-12));
      }

      // The parts of each triangle cover it, and are oriented like it.
      const std::size_t n = before.triangles.size();
      BOOST_TEST_REQUIRE(segment.size() == n + refinement.triangles.size());
      BOOST_TEST_REQUIRE(after.triangles.size() == segment.size());
      std::vector<CGAL::Vector_3<Kernel> > sums;
      for (std::size_t f = 0; f < n; ++f)
        sums.push_back(area_vector(after, f));
      for (std::size_t i = 0; i < refinement.triangles.size(); ++i)
        sums[refinement.triangles[i]] += area_vector(after, n + i);
      for (std::size_t f = 0; f < n; ++f)
        BOOST_TEST((sums[f] - area_vector(before, f)).squared_length() < 1e-24);
    }
  }
}

BOOST_AUTO_TEST_CASE(turned_triangles_stay_turned)
{
  Random random(2);
  const Soup plain = jagged_plate();
  const Labels labels = jagged_labels(random);
  Soup turned = plain;
  for (auto& t : turned.triangles)
    if (random() % 3 == 0)
      std::swap(t[1], t[2]);
  const Soup before = turned;
  std::vector<int> segment(labels.begin(), labels.end());
  const auto refinement = CGAL::refine_segment_boundaries(turned.points, turned.triangles, segment);
  BOOST_TEST(refinement.triangles.size() > 24u);
  for (std::size_t f = 0; f < turned.triangles.size(); ++f) {
    const std::size_t whole =
      f < before.triangles.size() ? f : refinement.triangles[f - before.triangles.size()];
    BOOST_TEST(area_vector(turned, f).z() * area_vector(before, whole).z() > 0);
  }
}

// Three plates meet at the line y = 0, across which their common boundary x = 6 runs in zigzag.
BOOST_AUTO_TEST_CASE(no_boundary_crosses_an_edge_of_three_triangles)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    Random random(seed);
    Soup soup;
    std::map<std::array<double, 3>, std::size_t> index;
    std::vector<int> segment;
    const Soup leaf = displaced(plate(12, 6), 0, random);
    for (int turn = 0; turn < 3; ++turn)
      for (const auto& t : leaf.triangles) {
        soup.triangles.emplace_back();
        double x = 0;
        for (std::size_t v : t) {
          const Point& p = leaf.points[v];
          const double angle = turn * 2 * pi / 3;
          const std::array<double, 3> q = {p.x(), p.y() * std::cos(angle), p.y() * std::sin(angle)};
          const auto known = index.emplace(q, soup.points.size());
          if (known.second)
            soup.points.emplace_back(q[0], q[1], q[2]);
          soup.triangles.back().push_back(known.first->second);
          x += p.x() / 3;
        }
        segment.push_back(x + double(random() % 3) > 7);
      }
    const auto before = soup.triangles;
    const auto refinement = CGAL::refine_segment_boundaries(soup.points, soup.triangles, segment);
    BOOST_TEST(!refinement.points.empty());
    for (const auto& [f, w] : refinement.points) {
      bool is_on_line = true;
      for (std::size_t i = 0; i < 3; ++i)
        is_on_line &= w[i] == 0 || (soup.points[before[f][i]].y() == 0 &&
                                    soup.points[before[f][i]].z() == 0);
      BOOST_TEST(!is_on_line);
    }
  }
}

// A triangle of a third segment touches the corner of a plate that is far from the boundary.
BOOST_AUTO_TEST_CASE(segments_may_meet_at_a_vertex_away_from_boundaries)
{
  Random random(3);
  Soup soup = displaced(plate(20, 2), 0.1, random);
  std::vector<int> segment;
  for (const auto& t : soup.triangles)
    segment.push_back(soup.points[t[0]].x() < 3 + int(random() % 2));
  const std::size_t corner = soup.points.size() - 1;
  soup.points.insert(soup.points.end(), {{21, 2, 0}, {21, 3, 0}});
  soup.triangles.push_back({corner, corner + 1, corner + 2});
  segment.push_back(7);
  const auto refinement = CGAL::refine_segment_boundaries(soup.points, soup.triangles, segment);
  BOOST_TEST(!refinement.points.empty());
  for (std::size_t f = 0; f < segment.size(); ++f)
    BOOST_TEST((segment[f] == 7) == (soup.triangles[f][1] == corner + 1));
}

BOOST_AUTO_TEST_CASE(bad_triangles_are_refused_and_left_as_they_are)
{
  const Soup good = plate(4, 4);
  const std::vector<signed char> ids(good.triangles.size(), 1);
  const auto is_refused = [](Soup soup, std::vector<signed char> segment, int iterations) {
    const Soup before = soup;
    BOOST_CHECK_THROW(CGAL::refine_segment_boundaries(
                        soup.points, soup.triangles, segment,
                        CGAL::parameters::number_of_iterations(iterations)),
                      std::invalid_argument);
    BOOST_TEST((soup.points == before.points && soup.triangles == before.triangles));
  };
  is_refused(good, ids, -1);
  is_refused(good, ids, 100001);
  is_refused(good, std::vector<signed char>(5, 0), 1);
  Soup bad = good;
  bad.triangles[3] = {0, 1};
  is_refused(bad, ids, 1);
  bad = good;
  bad.points[5] = Point(0, 0, std::numeric_limits<double>::infinity());
  is_refused(bad, ids, 1);

  std::vector<Point> points = plate(12, 9).points; // 130 points; a signed char counts to 127
  points.resize(120);
  std::vector<std::array<signed char, 3> > triangles;
  for (const auto& t : plate(12, 9).triangles)
    if (*std::max_element(t.begin(), t.end()) < 120)
      triangles.push_back({(signed char)(t[0]), (signed char)(t[1]), (signed char)(t[2])});
  std::vector<int> segment;
  Random random(4);
  for (std::size_t f = 0; f < triangles.size(); ++f)
    segment.push_back(int(random() % 2));
  const auto before = triangles;
  BOOST_CHECK_THROW(CGAL::refine_segment_boundaries(points, triangles, segment),
                    std::overflow_error);
  BOOST_TEST((triangles == before));
  BOOST_TEST(points.size() == 120u);
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused)
{
  const Soup soup = plate(4, 4);
  const Segmented_mesh good(
    soup, by_place<std::size_t>(soup, [](const Point& p) { return p.x() > p.y(); }));
  const auto check_refused = [](Segmented_mesh bad, int number_of_iterations) {
    const Labels labels = bad.labels();
    const std::size_t number_of_vertices = bad.mesh.number_of_vertices();
    BOOST_CHECK_EXCEPTION(
      CGAL::refine_segment_boundaries(
        bad.mesh, bad.segment, CGAL::parameters::number_of_iterations(number_of_iterations)),
      std::invalid_argument, [](const std::invalid_argument& e) {
        return std::string(e.what()).rfind("refine_segment_boundaries: ", 0) == 0;
      });
    BOOST_TEST(bad.mesh.number_of_vertices() == number_of_vertices);
    BOOST_TEST(bad.labels() == labels, tt::per_element());
  };
  check_refused(good, -1);
  Segmented_mesh quadrangle(good);
  const Mesh::Halfedge_index h = *std::find_if(
    quadrangle.mesh.halfedges().begin(), quadrangle.mesh.halfedges().end(),
    [&](Mesh::Halfedge_index i) { return !quadrangle.mesh.is_border(quadrangle.mesh.edge(i)); });
  CGAL::Euler::join_face(h, quadrangle.mesh);
  quadrangle.mesh.collect_garbage();
  quadrangle.segment =
    quadrangle.mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  check_refused(quadrangle, 1);
  Segmented_mesh infinite(good);
  infinite.mesh.point(Mesh::Vertex_index(7)) =
    Point(std::numeric_limits<double>::infinity(), 0, 0);
  check_refused(infinite, 1);
}

BOOST_AUTO_TEST_SUITE_END()
