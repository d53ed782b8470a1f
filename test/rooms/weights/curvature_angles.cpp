// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/weights/curvature_angles.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(curvature_angles)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Vector;
using CGAL::Spectral_segmentation::internal::Heat_smoothing;
using CGAL::Spectral_segmentation::internal::total_area;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

std::vector<double> angles_of(const Surface& graph, double radius)
{
  return CGAL::Spectral_segmentation::internal::curvature_angles(sequential, graph, graph.points,
                                                  face_normals(graph, graph.points), radius);
}

// The length over which the surface bends by an angle, in the coordinates of the graph.
double way(const Surface& graph, double radius)
{ return 2 * radius * std::sqrt(std::accumulate(graph.areas.begin(), graph.areas.end(), 0.)); }

Vector edge_of(const Surface& graph, Index h)
{ return graph.points[graph.target_vertex(h)] - graph.points[graph.source_vertex(h)]; }

double mean(const std::vector<double>& values)
{ return std::accumulate(values.begin(), values.end(), 0.) / double(values.size()); }

// Around the z axis, open, of radius 1 and height 4.
Soup cylinder(std::size_t n_around)
{ return surface_of_revolution({{-2, 1}, {-1.5, 1}, {-0.5, 1}, {0, 1}, {1, 1}, {2, 1}}, n_around); }

// The fraction of the norm of the amounts over the roots of the areas. In this norm no step makes
// the error of the step before larger.
const double tolerance_of_two_steps = 1e-12;

VectorXd areas_of(const Surface& graph)
{ return Eigen::Map<const VectorXd>(graph.areas.data(), Eigen::Index(graph.areas.size())); }

// Averages the amounts beside two other quantities, which have no influence.
VectorXd averaged(const Surface& graph, double radius, const VectorXd& amounts)
{
  std::vector<Vector> triples;
  for (double amount : amounts)
    triples.emplace_back(1, amount, -2 * amount);
  VectorXd result = amounts;
  std::size_t f = 0;
  for (const Vector& v : Heat_smoothing(sequential, graph, graph.points, radius)(triples)) {
    BOOST_TEST(v.z() == -2 * v.y());
    result[Eigen::Index(f++)] = v.y();
  }
  return result;
}

double norm_of_amounts(const Surface& graph, const VectorXd& amounts)
{ return amounts.cwiseQuotient(areas_of(graph).cwiseSqrt()).norm(); }

double norm_of_density(const Surface& graph, const VectorXd& density)
{ return density.cwiseProduct(areas_of(graph).cwiseSqrt()).norm(); }

// With a mean of 1/2 of the area.
VectorXd random_amounts(const Surface& graph, Random& random)
{
  std::uniform_real_distribution<double> density(0, 1);
  VectorXd amounts = areas_of(graph);
  for (double& amount : amounts)
    amount *= density(random);
  return amounts;
}

std::vector<Soup> shapes(Random& random)
{
  return {sphere(2), displaced(sphere(2), 0.1, random), plate(9, 7),
          displaced(plate(12, 5), 0.3, random), displaced(torus(2, 0.7, 16, 10), 0.1, random),
          dumbbell(12, 8)};
}

// A rhombus of 2 * n^2 equilateral triangles.
Soup rhombus(std::size_t n)
{
  Soup soup = plate(n, n);
  for (Point& p : soup.points)
    p = Point(p.x() - p.y() / 2, p.y() * std::sqrt(0.75), 0);
  return soup;
}

// The same by the equations of the finite volumes as they stand in the books, with the areas as
// the masses, on the coordinates of the soup.
VectorXd averaged_by_dense_equations(const Soup& soup, double radius, const VectorXd& amounts)
{
  const Mesh mesh = mesh_of(soup);
  const Eigen::Index n = Eigen::Index(mesh.number_of_faces());
  const auto corners = [&](Mesh::Face_index f) {
    std::vector<Point> result;
    for (Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      result.push_back(mesh.point(v));
    return result;
  };
  VectorXd areas(n);
  std::vector<Point> centroids;
  for (Mesh::Face_index f : mesh.faces()) {
    const std::vector<Point> c = corners(f);
    areas[f] = std::sqrt(CGAL::squared_area(c[0], c[1], c[2]));
    centroids.push_back(CGAL::centroid(c[0], c[1], c[2]));
  }
  MatrixXd flux = MatrixXd::Zero(n, n);
  for (Mesh::Edge_index e : mesh.edges()) {
    if (mesh.is_border(e))
      continue;
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    const Mesh::size_type f = mesh.face(h), g = mesh.face(mesh.opposite(h));
    const Point a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h));
    const Point middle = CGAL::midpoint(a, b);
    const double conductance = std::sqrt(CGAL::squared_distance(a, b)) /
      (std::sqrt(CGAL::squared_distance(centroids[f], middle)) +
       std::sqrt(CGAL::squared_distance(middle, centroids[g])));
    flux(f, f) += conductance;
    flux(g, g) += conductance;
    flux(f, g) -= conductance;
    flux(g, f) -= conductance;
  }
  const double time = radius * radius * areas.sum() / 4;
  const Eigen::LDLT<MatrixXd> step(MatrixXd(areas.asDiagonal()) + time / 2 * flux);
  const VectorXd middle = step.solve(amounts);
  return step.solve(areas.cwiseProduct(middle));
}

// Returns the value for the average of a unit amount on the face next to the center.
double mean_squared_distance(const Soup& soup, double radius)
{
  const Surface graph = surface_of(soup);
  const Vector center = std::accumulate(graph.points.begin(), graph.points.end(),
                                        Vector()) / double(graph.points.size());
  Index source = 0;
  for (Index f = 0; f < graph.number_of_faces(); ++f)
    if ((graph.centroid(f) - center).norm() < (graph.centroid(source) - center).norm())
      source = f;
  VectorXd amounts = VectorXd::Zero(Eigen::Index(graph.number_of_faces()));
  amounts[source] = 1;
  const VectorXd density = averaged(graph, radius, amounts);
  double sum = 0;
  for (Index f = 0; f < graph.number_of_faces(); ++f)
    sum += density[f] * graph.areas[f] *
           (graph.centroid(f) - graph.centroid(source)).squared_norm();
  return sum / total_area(graph);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_plate_does_not_bend)
{
  for (double angle : angles_of(surface_of(plate(6, 5)), 0.1))
    BOOST_TEST(angle == 0);
}

BOOST_AUTO_TEST_CASE(a_plate_does_not_bend_in_any_position)
{
  Soup soup = plate(20, 20);
  for (Point& p : soup.points)
    p = Point(p.x(), p.y(), p.x() / 3 + p.y() / 7);
  const Surface graph = surface_of(soup);
  for (double angle : angles_of(graph, 0.01))
    BOOST_TEST(angle == 0);
}

namespace {

// The unit sphere has the tensor 1 - nn', nn' the projection on the normal. A step of backward
// Euler divides nn' - 1/3, of eigenvalue 6 on the sphere, by 1 and 6 times the time of the step.
double bending_of_sphere(double radius)
{
  const double step = radius * radius * 4 * pi / 8;
  return 2 * radius * std::sqrt(4 * pi) * (2 + 1 / ((1 + 6 * step) * (1 + 6 * step))) / 3;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_sphere_bends_by_the_way_over_its_radius_everywhere)
{
  for (double size : {1., 7., 1000.})
    for (double radius : {0.02, 0.05, 0.1})
      for (double angle : angles_of(surface_of(scaled(sphere(3), size)), radius))
        BOOST_TEST(angle == bending_of_sphere(radius), tt::tolerance(0.025));
}

BOOST_AUTO_TEST_CASE(the_angle_does_not_depend_on_the_triangulation)
{
  for (std::size_t level : {2, 3, 4})
    BOOST_TEST(mean(angles_of(surface_of(sphere(level)), 0.1)) == bending_of_sphere(0.1),
               tt::tolerance(0.01));
}

// Euler: the curvature across an edge is that around the axis times the squared cosine of its angle
// to the axis. It holds exactly, as each triangle has the same tensor in proportion to its area.
BOOST_AUTO_TEST_CASE(a_cylinder_bends_across_its_axis_only)
{
  for (std::size_t n : {5, 12, 40})
    for (double radius : {0.02, 0.1}) {
      const Surface graph = surface_of(cylinder(n));
      const double side = 2 * std::sin(pi / double(n)) / unit_of(cylinder(n));
      const double along = way(graph, radius) * 2 * pi / double(n) / side;
      const std::vector<double> angles = angles_of(graph, radius);
      for (Index h = 0; h < angles.size(); ++h) {
        const Vector edge = edge_of(graph, h);
        BOOST_TEST(std::abs(angles[h] - along * edge.z() * edge.z() / edge.squared_norm()) < 1e-12);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_torus_is_concave_around_its_hole_only)
{
  const std::size_t n_tube = 24;
  const Surface graph = surface_of(torus(3, 1, 72, n_tube));
  const double unit = unit_of(torus(3, 1, 72, n_tube)), length = way(graph, 0.02) * unit;
  const std::vector<double> angles = angles_of(graph, 0.02);
  for (Index h = 0; h < angles.size(); ++h) {
    const Index a = graph.source_vertex(h), b = graph.target_vertex(h);
    const Vector middle = (graph.points[a] + graph.points[b]) / 2 * unit;
    const double from_axis = std::hypot(middle.x(), middle.y());
    if (a / n_tube == b / n_tube) // around the tube
      BOOST_TEST(std::abs(angles[h] - length * (from_axis - 3) / from_axis) < 0.05 * length);
    else if (a % n_tube == b % n_tube)
      BOOST_TEST(std::abs(angles[h] - length) < 0.05 * length);
  }
}

BOOST_AUTO_TEST_CASE(turned_inside_out_convex_is_concave)
{
  for (const Soup& soup : {sphere(1), cylinder(9), torus(3, 1, 9, 8)}) {
    const std::vector<double> angles = angles_of(surface_of(soup), 0.05);
    const Surface inside_out = surface_of(turned_inside_out(soup));
    const std::vector<double> reversed = angles_of(inside_out, 0.05);
    double sum = 0;
    for (Index h = 0; h < angles.size(); ++h) {
      // A face has its first corner as before, and its edges in reverse.
      BOOST_TEST(std::abs(reversed[h] + angles[3 * (h / 3) + 2 - h % 3]) < 1e-12);
      sum += angles[h];
    }
    BOOST_TEST(sum > 0.1);
  }
}

BOOST_AUTO_TEST_CASE(a_valley_is_negative_and_a_ridge_is_positive)
{
  for (double rise : {-1., 1.}) {
    const Surface graph = surface_of(
      {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, rise), Point(1, -1, rise)},
       {{0, 1, 2}, {1, 0, 3}}});
    // Both slopes have 45 degrees: a right angle over the area of both, along an edge of length 1.
    const double area = std::sqrt(2.);
    const double expected = -rise * 0.2 * std::sqrt(area) * pi / 2 / area;
    const std::vector<double> angles = angles_of(graph, 0.1);
    for (Index h = 0; h < 6; ++h) {
      if (graph.is_border(h))
        BOOST_TEST(angles[h] == 0);
      else
        BOOST_TEST(angles[h] == expected, tt::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(both_sides_of_an_edge_have_the_same_angle)
{
  Random random(3);
  const Surface graph = surface_of(displaced(torus(2, 0.7, 12, 8), 0.2, random));
  const std::vector<double> angles = angles_of(graph, 0.05);
  double largest = 0, smallest = 0;
  for (Index h = 0; h < angles.size(); ++h) {
    BOOST_TEST(std::abs(angles[h] - angles[graph.opposite[h]]) < 1e-12);
    largest = std::max(largest, angles[h]);
    smallest = std::min(smallest, angles[h]);
  }
  BOOST_TEST(largest > 0.1);
  BOOST_TEST(smallest < -0.1);
}

BOOST_AUTO_TEST_CASE(no_angle_is_more_than_half_a_turn)
{
  for (double angle : angles_of(surface_of(sphere(1)), 10))
    BOOST_TEST(angle == pi);
  for (double angle : angles_of(surface_of(turned_inside_out(sphere(1))), 10))
    BOOST_TEST(angle == -pi);
}

BOOST_AUTO_TEST_CASE(faces_without_area_leave_the_angles_finite)
{
  Soup soup = sphere(1);
  soup.points[soup.triangles[0][0]] = soup.points[soup.triangles[0][1]];
  for (double angle : angles_of(surface_of(soup), 0.05))
    BOOST_TEST(std::isfinite(angle));
}

BOOST_AUTO_TEST_CASE(a_constant_density_stays)
{
  Random random(1);
  for (const Soup& soup : shapes(random)) {
    const Surface graph = surface_of(soup);
    for (double radius : {0.001, 0.05, 3.})
      for (double density : averaged(graph, radius, 3 * areas_of(graph)))
        BOOST_TEST(density == 3, tt::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_lost)
{
  Random random(2);
  for (const Soup& soup : shapes(random)) {
    const Surface graph = surface_of(soup);
    const VectorXd amounts = random_amounts(graph, random);
    for (double radius : {0.01, 0.05, 0.2}) {
      const double total = averaged(graph, radius, amounts).dot(areas_of(graph));
      const double norm = norm_of_amounts(graph, amounts) * std::sqrt(total_area(graph));
      BOOST_TEST(std::abs(total - amounts.sum()) <= tolerance_of_two_steps * norm);
    }
  }
}

BOOST_AUTO_TEST_CASE(nothing_passes_between_components)
{
  const Soup low = plate(5, 5), high = moved(low, 0, 0, 1);
  const Surface graph = surface_of(disjoint_union(disjoint_union(sphere(1), low), high));
  const Index source = 80 + 7;
  VectorXd amounts = VectorXd::Zero(80 + 50 + 50);
  amounts[source] = 1;
  const VectorXd density = averaged(graph, 0.1, amounts);
  BOOST_TEST(density[source] * graph.areas[source] < 0.5);
  BOOST_TEST(density.head(80).isZero(0));
  BOOST_TEST(density.tail(50).isZero(0));
}

BOOST_AUTO_TEST_CASE(components_of_any_size_are_averaged_as_if_alone)
{
  const std::vector<Soup> components = {sphere(0), sphere(3), sphere(1), sphere(1), sphere(3),
                                        sphere(0)};
  Soup all = components.front();
  for (std::size_t i = 1; i < components.size(); ++i)
    all = disjoint_union(all, components[i]);
  const Surface graph = surface_of(all);
  Random random(1);
  const VectorXd start = random_amounts(graph, random).cwiseQuotient(areas_of(graph));
  const VectorXd averages = averaged(graph, 0.02, start.cwiseProduct(areas_of(graph)));
  Eigen::Index first = 0;
  for (const Soup& component : components) {
    const Surface alone = surface_of(component);
    const Eigen::Index n = Eigen::Index(alone.number_of_faces());
    const double fraction = areas_of(graph).segment(first, n).sum() / total_area(graph);
    const VectorXd amounts = start.segment(first, n).cwiseProduct(areas_of(alone));
    BOOST_TEST((averages.segment(first, n) - averaged(alone, 0.02 / std::sqrt(fraction), amounts))
                 .cwiseAbs().maxCoeff() < 1e-9);
    first += n;
  }
}

BOOST_AUTO_TEST_CASE(it_solves_the_equations_of_two_steps)
{
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    for (const Soup& soup : shapes(random))
      for (double radius : {0.02, 0.1, 0.2}) {
        const Surface graph = surface_of(soup);
        const VectorXd amounts = random_amounts(graph, random);
        const VectorXd start = amounts.cwiseQuotient(areas_of(graph));
        // Amounts are areas in the units of the graph, and densities are without unit.
        const VectorXd expected =
          averaged_by_dense_equations(soup, radius, amounts * unit_of(soup) * unit_of(soup));
        const double norm = norm_of_amounts(graph, amounts);
        BOOST_TEST(norm_of_density(graph, averaged(graph, radius, amounts) - expected) <=
                   tolerance_of_two_steps * norm);
        BOOST_TEST(norm_of_density(graph, start - expected) > 5 * tolerance_of_two_steps * norm);
      }
  }
}

BOOST_AUTO_TEST_CASE(the_mean_squared_distance_is_the_square_of_the_radius)
{
  // The equations are exact if centroids are across the middles of edges.
  for (double radius : {0.03, 0.05, 0.1})
    BOOST_TEST(mean_squared_distance(rhombus(40), radius) == radius * radius, tt::tolerance(0.03));
  // Right triangles average farther along their diagonals, and less far across them.
  for (double radius : {0.05, 0.1})
    BOOST_TEST(mean_squared_distance(plate(40, 40), radius) == radius * radius,
               tt::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(the_radius_ends_at_nine_faces)
{
  const Soup soup = rhombus(40);
  const double end = std::sqrt(80. / 3200);
  BOOST_TEST(mean_squared_distance(soup, 0.9 * end) < 0.9 * mean_squared_distance(soup, end));
  for (double radius : {1.01 * end, 1., 1e100})
    BOOST_TEST(mean_squared_distance(soup, radius) == mean_squared_distance(soup, end),
               tt::tolerance(1e-9));
}

// On the unit sphere z and xy are eigenfunctions, of eigenvalues 2 and 6: a step of backward Euler
// divides them by 1 and its time times that.
BOOST_AUTO_TEST_CASE(the_average_does_not_depend_on_the_triangulation)
{
  for (std::size_t level : {2, 3, 4})
    for (double radius : {0.05, 0.1}) {
      const Surface graph = surface_of(sphere(level));
      const Eigen::Index n = Eigen::Index(graph.number_of_faces());
      VectorXd z(n), xy(n);
      for (Index f = 0; f < graph.number_of_faces(); ++f) {
        const Vector p = graph.centroid(f).normalized();
        z[f] = p.z();
        xy[f] = p.x() * p.y();
      }
      const double step = radius * radius * 4 * pi / 4 / 2;
      for (const auto& [values, eigenvalue] : {std::make_pair(z, 2), std::make_pair(xy, 6)}) {
        const double factor = 1 / ((1 + eigenvalue * step) * (1 + eigenvalue * step));
        const VectorXd density = averaged(graph, radius, values.cwiseProduct(areas_of(graph)));
        BOOST_TEST(density.dot(values) / values.squaredNorm() == factor, tt::tolerance(0.002));
        BOOST_TEST((density - factor * values).cwiseAbs().maxCoeff() < 0.015);
      }
    }
}

BOOST_AUTO_TEST_CASE(faces_of_hardly_any_area_do_no_harm)
{
  Random random(4);
  for (double remainder : {0., 1e-12, 1e-6, 1e-3}) {
    Soup soup = sphere(2);
    for (std::size_t t : {3, 40, 200}) {
      const Point p = soup.points[soup.triangles[t][0]];
      Point& q = soup.points[soup.triangles[t][1]];
      q = p + remainder * (q - p);
    }
    const Surface graph = surface_of(soup);
    BOOST_TEST(areas_of(graph).minCoeff() <= remainder * areas_of(graph).maxCoeff());
    for (double density : averaged(graph, 0.05, random_amounts(graph, random)))
      BOOST_TEST(std::isfinite(density));
    for (double density : averaged(graph, 0.05, 3 * areas_of(graph)))
      BOOST_TEST(density == 3, tt::tolerance(0.01));
  }
}

BOOST_AUTO_TEST_CASE(a_long_component_without_area_does_no_harm)
{
  for (double length : {1e2, 1e4, 1e6, 1e8}) {
    const Soup needle = {{Point(0, 0, 0), Point(length, 0, 0), Point(length / 2, 0, 0)},
                         {{0, 1, 2}, {0, 2, 1}}};
    const Surface graph = surface_of(disjoint_union(plate(40, 40), needle));
    const Eigen::Index n = 2 * 40 * 40;
    BOOST_REQUIRE(graph.number_of_faces() == std::size_t(n) + 2);
    for (double radius : {0.02, 0.05, 1.}) {
      const VectorXd density = averaged(graph, radius, 3 * areas_of(graph));
      for (double d : density.head(n))
        BOOST_TEST(d == 3, tt::tolerance(1e-9));
      BOOST_TEST(density.tail(2).isZero(0));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
