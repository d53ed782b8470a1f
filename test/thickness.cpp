// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/distances/Heat_smoothing.h>
#include <CGAL/Spectral_segmentation/internal/mesh/Face_graph.h>
#include <CGAL/Spectral_segmentation/internal/distances/face_distances.h>
#include <CGAL/Spectral_segmentation/internal/distances/local_thickness.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(thickness)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Heat_smoothing;
using CGAL::Spectral_segmentation::internal::Vector;
using CGAL::Spectral_segmentation::internal::ray_thickness;
using CGAL::Spectral_segmentation::internal::thickness;

namespace {

const double single_precision = 1e-5;

// From the origin to (a, b, c). Two faces each at x = 0, a; y = 0, b; z = 0, c, in this order.
Soup box(double a, double b, double c)
{
  Soup soup;
  for (int i = 0; i < 8; ++i)
    soup.points.emplace_back(i & 1 ? a : 0, i & 2 ? b : 0, i & 4 ? c : 0);
  const std::array<std::size_t, 4> sides[] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                              {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const std::array<std::size_t, 4>& s : sides) {
    soup.triangles.push_back({s[0], s[1], s[2]});
    soup.triangles.push_back({s[0], s[2], s[3]});
  }
  return soup;
}

// A plate of 2 * side^2 faces over another that it looks away from.
Soup sandwich(std::size_t side, double distance)
{
  return disjoint_union(moved(plate(side, side), 0, 0, distance),
                        turned_inside_out(plate(side, side)));
}

// In the coordinates of the soup.
std::vector<double> distances_of(const Soup& soup)
{
  const Face_graph graph = dual_graph_of(soup);
  std::vector<double> distances =
    ray_thickness<CGAL::Sequential_tag>(graph, graph.points,
                                             face_normals(graph, graph.points));
  for (double& d : distances)
    d *= graph.unit;
  return distances;
}

std::vector<float> thickness_of(const Soup& soup, double radius)
{
  const Face_graph graph = dual_graph_of(soup);
  return thickness<CGAL::Sequential_tag>(graph, graph.points, face_normals(graph, graph.points),
                                         radius);
}

double area_of(const Soup& soup)
{
  const Face_graph graph = dual_graph_of(soup);
  return std::accumulate(graph.areas.begin(), graph.areas.end(), 0.) * graph.unit * graph.unit;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_sides_of_a_box_are_its_edges_apart)
{
  const std::vector<double> distances = distances_of(box(3, 5, 0.7));
  BOOST_TEST(distances.size() == 12U);
  for (std::size_t f = 0; f < 12; ++f)
    BOOST_TEST(distances[f] == (f < 4 ? 3 : f < 8 ? 5 : 0.7), tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(the_distance_is_along_the_ray_and_not_to_the_plane)
{
  // A tetrahedron of three faces that meet at right angles in the origin.
  const Soup corner = {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 2, 0), Point(0, 0, 4)},
                       {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const std::vector<double> distances = distances_of(corner);
  // From a third of the way along two axes it is a third of the way along the third axis.
  BOOST_TEST(distances[0] == 4 / 3., tt::tolerance(1e-14));
  BOOST_TEST(distances[1] == 2 / 3., tt::tolerance(1e-14));
  BOOST_TEST(distances[2] == 1 / 3., tt::tolerance(1e-14));
  // From (1, 2, 4) / 3 along -(4, 2, 1): x = 0 comes first, at 1/12 of this vector.
  BOOST_TEST(distances[3] == std::sqrt(21.) / 12, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(the_nearest_of_several_faces_counts)
{
  const Soup soup = disjoint_union(box(1, 1, 1), moved(box(1, 1, 1), 0, 0, 3));
  for (double distance : distances_of(soup))
    BOOST_TEST(distance == 1, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_sphere_is_as_thick_as_its_diameter)
{
  for (double radius : {1., 25.})
    for (double distance : distances_of(scaled(sphere(3), radius)))
      BOOST_TEST(distance == 2 * radius, tt::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(nothing_is_opposite_of_a_plate)
{
  const Soup triangle = {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}}};
  BOOST_TEST(distances_of(triangle).at(0) == 0);
  for (double distance : distances_of(plate(4, 3)))
    BOOST_TEST(distance == 0);
  for (float t : thickness_of(plate(4, 3), 0.02))
    BOOST_TEST(t == 0);
}

BOOST_AUTO_TEST_CASE(plates_are_opposite_if_they_look_away_from_each_other)
{
  const Soup low = plate(3, 2), high = moved(plate(3, 2), 0, 0, 0.4);
  for (double distance : distances_of(disjoint_union(turned_inside_out(low), high)))
    BOOST_TEST(distance == 0.4, tt::tolerance(1e-12));
  for (double distance : distances_of(disjoint_union(low, turned_inside_out(high))))
    BOOST_TEST(distance == 0);
  for (double distance : distances_of(disjoint_union(low, high)))
    BOOST_TEST(distance == 0);
}

BOOST_AUTO_TEST_CASE(a_body_turned_inside_out_has_no_thickness)
{
  for (const Soup& soup : {box(1, 2, 3), sphere(2)}) {
    for (double distance : distances_of(turned_inside_out(soup)))
      BOOST_TEST(distance == 0);
    for (float t : thickness_of(turned_inside_out(soup), 0.02))
      BOOST_TEST(t == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_cavity_leaves_a_shell)
{
  const Soup outside = scaled(sphere(3), 3), inside = sphere(3);
  for (double distance : distances_of(disjoint_union(outside, turned_inside_out(inside))))
    BOOST_TEST(distance == 2, tt::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(a_body_in_a_body_hides_the_other_side)
{
  const Soup soup = disjoint_union(scaled(sphere(2), 3), sphere(2));
  const std::vector<double> distances = distances_of(soup);
  for (std::size_t f = 0; f < 640; ++f)
    BOOST_TEST(distances[f] == (f < 320 ? 0 : 2), tt::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(a_face_without_normal_has_no_distance)
{
  const Face_graph graph = dual_graph_of(box(1, 1, 1));
  std::vector<Vector> normals = face_normals(graph, graph.points);
  normals[5] = Vector::Zero();
  const std::vector<double> distances =
    ray_thickness<CGAL::Sequential_tag>(graph, graph.points, normals);
  BOOST_TEST(distances[5] == 0);
  BOOST_TEST(distances[0] * graph.unit == 1, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_face_without_area_does_no_harm)
{
  // One that lies on the diagonal of a side, where it is met by both rays from the other side.
  Soup soup = box(2, 2, 2);
  soup.triangles[8] = {0, 2, 1};
  soup.triangles[9] = {1, 2, 3};
  soup.points.emplace_back(1, 1, 2);
  soup.triangles[10] = {4, 5, 8};
  soup.triangles.insert(soup.triangles.end(), {{5, 7, 8}, {4, 8, 7}});
  const std::vector<double> distances = distances_of(soup);
  for (std::size_t f = 0; f < 14; ++f)
    BOOST_TEST(distances[f] == (f < 13 ? 2 : 0), tt::tolerance(1e-14));
  for (float t : thickness_of(soup, 0.02))
    BOOST_TEST(t == std::log(2 / std::sqrt(24.)), tt::tolerance(single_precision));
}

BOOST_AUTO_TEST_CASE(the_thickness_is_the_logarithm_relative_to_the_root_of_the_area)
{
  for (float t : thickness_of(box(2, 2, 2), 0.02))
    BOOST_TEST(t == std::log(2 / std::sqrt(24.)), tt::tolerance(single_precision));
  for (float t : thickness_of(sphere(3), 0.02))
    BOOST_TEST(t == std::log(2 / std::sqrt(4 * pi)), tt::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(the_thickness_does_not_change_with_the_size)
{
  const Soup soup = surface_of_revolution({{0, 0}, {0, 1}, {1, 0.8}, {3, 0.2}, {4, 0}}, 9);
  const std::vector<float> thicknesses = thickness_of(soup, 0.02);
  for (double factor : {1e-3, 1000., 1024.}) {
    const std::vector<float> of_scaled = thickness_of(scaled(soup, factor), 0.02);
    for (std::size_t f = 0; f < thicknesses.size(); ++f)
      BOOST_TEST(std::abs(of_scaled[f] - thicknesses[f]) < single_precision);
  }
  const auto range = std::minmax_element(thicknesses.begin(), thicknesses.end());
  BOOST_TEST(*range.second - *range.first > 0.1);
}

BOOST_AUTO_TEST_CASE(each_component_has_its_own_thickness_and_one_without_rays_the_mean)
{
  const Soup thin = sandwich(3, 0.1), thick = moved(sandwich(3, 0.8), 10, 0, 0);
  const Soup soup = disjoint_union(disjoint_union(thin, thick), moved(plate(3, 3), 20, 0, 0));
  const std::vector<float> thicknesses = thickness_of(soup, 0.3);
  const double unit = std::sqrt(5 * 9.);
  BOOST_TEST(std::sqrt(area_of(soup)) == unit, tt::tolerance(1e-12));
  for (std::size_t f = 0; f < thicknesses.size(); ++f) {
    const double expected = f < 36 ? std::log(0.1 / unit) : f < 72 ? std::log(0.8 / unit)
      : std::log(std::sqrt(0.1 * 0.8) / unit);
    BOOST_TEST(thicknesses[f] == expected, tt::tolerance(single_precision));
  }
}

BOOST_AUTO_TEST_CASE(rays_are_joined_by_area)
{
  // The cap is open: rays from below pass it.
  const Soup soup = surface_of_revolution({{0, 0}, {0.5, 1}, {1, 1.2}, {2, 0.6}, {3, 0.9}}, 24);
  const Face_graph graph = dual_graph_of(soup);
  const std::vector<double> distances = distances_of(soup);
  const double unit = std::sqrt(area_of(soup));
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(Eigen::Index(distances.size()));
  Eigen::VectorXd sums = weights;
  for (Index f = 0; f < distances.size(); ++f)
    if (distances[f] > 0) {
      weights[f] = graph.areas[f];
      sums[f] = graph.areas[f] * std::log(distances[f] / unit);
    }
  BOOST_TEST(weights.minCoeff() == 0);
  for (double radius : {0.02, 0.05}) {
    const Heat_smoothing diffusion(graph, graph.points, radius);
    const Eigen::VectorXd weight = diffusion(weights), sum = diffusion(sums);
    const std::vector<float> thicknesses = thickness_of(soup, radius);
    for (Index f = 0; f < distances.size(); ++f)
      if (weight[f] > 0.05)
        BOOST_TEST(thicknesses[f] == sum[f] / weight[f], tt::tolerance(0.01));
    const auto range = std::minmax_element(thicknesses.begin(), thicknesses.end());
    BOOST_TEST(*range.second - *range.first > 0.2);
  }
}

BOOST_AUTO_TEST_CASE(without_a_radius_each_face_has_its_own_thickness)
{
  const std::vector<float> thicknesses = thickness_of(box(1, 2, 4), 0);
  for (Index f = 0; f < 12; ++f)
    BOOST_TEST(thicknesses[f] == std::log((f < 4 ? 1 : f < 8 ? 2 : 4) / std::sqrt(28.)),
               tt::tolerance(single_precision));
}

BOOST_AUTO_TEST_CASE(faces_far_from_all_rays_take_the_mean)
{
  // A long plate over a short one below each of its ends, one near and one far.
  const Soup end = turned_inside_out(plate(4, 4));
  const Soup ends = disjoint_union(end, moved(end, 36, 0, -1.5));
  const Soup soup = disjoint_union(ends, moved(plate(40, 4), 0, 0, 0.5));
  const double unit = std::sqrt(12 * 16.);
  const std::vector<float> thicknesses = thickness_of(soup, 0.05);
  for (std::size_t f = 0; f < thicknesses.size(); ++f) {
    const double x = soup.points[soup.triangles[f][0]].x();
    if (x < 4 || x > 36)
      BOOST_TEST(thicknesses[f] == std::log((x < 4 ? 0.5 : 2) / unit), tt::tolerance(0.01));
    if (x > 10 && x < 30)
      BOOST_TEST(thicknesses[f] == std::log(1 / unit), tt::tolerance(single_precision));
  }
}

BOOST_AUTO_TEST_CASE(a_face_that_sees_nothing_takes_the_thickness_of_its_neighbors)
{
  // The lower plate is smaller: the outer rays of the upper one pass it.
  const Soup soup = disjoint_union(moved(plate(4, 4), 0, 0, 0.5),
                                   turned_inside_out(moved(plate(2, 2), 1, 1, 0)));
  const std::vector<double> distances = distances_of(soup);
  BOOST_TEST(std::count(distances.begin(), distances.end(), 0.) == 32 - 8);
  for (float t : thickness_of(soup, 1))
    BOOST_TEST(t == std::log(0.5 / std::sqrt(20.)), tt::tolerance(single_precision));
}

BOOST_AUTO_TEST_SUITE_END()
