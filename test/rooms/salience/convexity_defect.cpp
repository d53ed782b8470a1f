// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/salience/Cut_evaluator.h>
#include <CGAL/Spectral_segmentation/internal/salience/Support_points.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(convexity_defect)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Support_points;
using CGAL::Spectral_segmentation::internal::Convexity_defect;
using CGAL::Spectral_segmentation::internal::Vector;

namespace {

const double single_precision = 1e-6;
// The points that are extreme in no direction, relative to the diameter; observed.
const double out_of_sight = 0.005;

std::vector<Index> range(Index first, Index last)
{
  std::vector<Index> faces(last - first);
  std::iota(faces.begin(), faces.end(), first);
  return faces;
}

std::vector<Index> all_faces(const Surface& graph)
{ return range(0, Index(graph.number_of_faces())); }

// The defect of sets of faces of a whole mesh.
class Defect_of_mesh
{
  const Support_points support_points_;
  const std::vector<Index> all_faces_;
  const Convexity_defect defect_;

public:
  explicit Defect_of_mesh(const Surface& graph)
    : support_points_(graph), all_faces_(all_faces(graph)),
      defect_(support_points_, graph, all_faces_) {}

  double operator()(const std::vector<Index>& faces) const { return defect_(faces); }
};

// In the coordinates of the soup.
double defect_of(const Soup& soup)
{
  const Surface graph = surface_of(soup);
  return Defect_of_mesh(graph)(all_faces(graph)) * unit_of(soup);
}

// By the hull of all points.
double exact_defect(const Surface& graph, const std::vector<Index>& faces)
{
  const std::vector<Vector> normals = face_normals(graph, graph.points);
  double sum = 0, area = 0;
  for (Index f : faces) {
    double support = -std::numeric_limits<double>::infinity();
    for (Index g : faces)
      for (Index v : graph.corners[g])
        support = std::max(support, normals[f].dot(graph.points[v]));
    sum += graph.areas[f] * (support - normals[f].dot(graph.centroid(f)));
    area += graph.areas[f];
  }
  return sum / area;
}

Eigen::Quaterniond random_rotation(Random& random)
{
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return Eigen::Quaterniond(w, x, y, z).normalized();
}

Soup rotated(Soup soup, const Eigen::Quaterniond& rotation)
{
  return transformed(std::move(soup), [&](const Point& p) {
    const Eigen::Vector3d q = rotation * Eigen::Vector3d(p.x(), p.y(), p.z());
    return Point(q.x(), q.y(), q.z());
  });
}

Soup box(double a, double b, double c)
{
  Soup soup = surface_of_revolution({{-1, 0}, {-1, 1}, {1, 1}, {1, 0}}, 4);
  for (Point& p : soup.points)
    p = Point(a * (p.x() - p.y()), b * (p.x() + p.y()), c * p.z());
  return soup;
}

// The largest distance of two vertices of the faces.
double diameter(const Surface& graph, const std::vector<Index>& faces)
{
  double result = 0;
  for (Index f : faces)
    for (Index g : faces)
      result = std::max(result, (graph.points[graph.corners[f][0]] -
                                 graph.points[graph.corners[g][1]]).norm());
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(no_face_has_no_defect)
{
  const Surface graph = surface_of(sphere(0));
  BOOST_TEST(Defect_of_mesh(graph)({}) == 0);
}

BOOST_AUTO_TEST_CASE(faces_without_area_have_no_defect)
{
  Soup soup = turned_inside_out(sphere(1));
  for (std::size_t v : soup.triangles[4])
    soup.points[v] = Point(0, 0, 0);
  const Surface graph = surface_of(soup);
  const Defect_of_mesh defect(graph);
  BOOST_TEST(defect({4}) == 0);
  BOOST_TEST(defect(all_faces(graph)) > 0.1);
}

BOOST_AUTO_TEST_CASE(a_convex_body_has_no_defect)
{
  for (std::size_t level : {0, 1, 3})
    for (double radius : {1., 30.})
      BOOST_TEST(defect_of(scaled(sphere(level), radius)) < single_precision * radius);
  Random random(1);
  for (int i = 0; i < 20; ++i)
    for (const Soup& soup : {box(1, 1, 1), box(1, 3, 9), box(1, 0.1, 10)})
      BOOST_TEST(defect_of(rotated(soup, random_rotation(random))) < 10 * single_precision);
}

BOOST_AUTO_TEST_CASE(a_sphere_turned_inside_out_is_a_diameter_below_its_hull)
{
  for (double radius : {1., 30.})
    BOOST_TEST(defect_of(turned_inside_out(scaled(sphere(3), radius))) == 2 * radius,
               tt::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(a_cavity_counts_by_its_area)
{
  const Soup soup = disjoint_union(scaled(sphere(3), 3), turned_inside_out(sphere(3)));
  // The shell is 0, the cavity 1 + 3 below the hull; their areas are 9 to 1.
  BOOST_TEST(defect_of(soup) == 0.4, tt::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(two_spheres_have_a_defect_between_each_other)
{
  // The halves that look at each other are 2d |x| below the hull, which is d on average.
  for (double d : {2., 5., 20.})
    BOOST_TEST(defect_of(disjoint_union(moved(sphere(3), -d, 0, 0), moved(sphere(3), d, 0, 0)))
               == d / 2, tt::tolerance(0.006));
}

BOOST_AUTO_TEST_CASE(hardly_any_depth_is_out_of_sight)
{
  for (unsigned seed = 1; seed <= 24; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const std::vector<Soup> shapes = {plate(5, 4), sphere(2), torus(2, 0.7, 12, 8),
                                        dumbbell(10, 6)};
      const Surface graph =
        surface_of(displaced(shapes[seed % shapes.size()], 0.05, random));
      std::vector<Index> faces = all_faces(graph);
      std::shuffle(faces.begin(), faces.end(), random);
      faces.resize(faces.size() / (1 + seed % 3));
      const double defect = Defect_of_mesh(graph)(faces);
      const double exact = exact_defect(graph, faces);
      BOOST_TEST(defect < exact + single_precision);
      BOOST_TEST(defect > exact - out_of_sight * diameter(graph, faces));
      BOOST_TEST(exact > 0.01);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_dumbbell_has_a_defect_and_its_halves_have_none)
{
  const Surface graph = surface_of(dumbbell(24, 16));
  std::vector<Index> low, high;
  for (Index f : all_faces(graph))
    (graph.centroid(f).z() < 0 ? low : high).push_back(f);
  BOOST_TEST(low.size() == high.size());
  const Defect_of_mesh defect(graph);
  const double whole = defect(all_faces(graph));
  BOOST_TEST(whole == exact_defect(graph, all_faces(graph)), tt::tolerance(0.004));
  BOOST_TEST(whole > 0.2);
  BOOST_TEST(defect(low) < single_precision);
  BOOST_TEST(defect(high) < single_precision);
}

BOOST_AUTO_TEST_CASE(only_the_vertices_of_the_set_make_its_hull)
{
  const Soup soup = disjoint_union(moved(sphere(3), -5, 0, 0), moved(sphere(3), 5, 0, 0));
  const Surface graph = surface_of(soup);
  const Defect_of_mesh defect(graph);
  const double both = defect(all_faces(graph));
  for (int i = 0; i < 2; ++i) {
    BOOST_TEST(defect(range(0, 1280)) < single_precision);
    BOOST_TEST(defect(range(1280, 2560)) < single_precision);
    BOOST_TEST(defect(all_faces(graph)) == both);
  }
  BOOST_TEST(both > 0.1);
}

BOOST_AUTO_TEST_CASE(a_flat_set_has_no_defect)
{
  Random random(3);
  for (int i = 0; i < 5; ++i) {
    const Surface graph = surface_of(rotated(plate(30, 30), random_rotation(random)));
    const Defect_of_mesh defect(graph);
    BOOST_TEST(defect(all_faces(graph)) < single_precision);
    BOOST_TEST(defect({17}) < single_precision);
  }
}

BOOST_AUTO_TEST_CASE(rotating_the_part_hardly_matters)
{
  Random random(4);
  for (const Soup& soup : {torus(2, 0.5, 24, 12), dumbbell(24, 16)}) {
    const double unrotated = defect_of(soup);
    for (int i = 0; i < 10; ++i)
      BOOST_TEST(defect_of(rotated(soup, random_rotation(random))) == unrotated,
                 tt::tolerance(0.002));
    BOOST_TEST(unrotated > 0.4);
  }
}

BOOST_AUTO_TEST_CASE(a_part_without_symmetry_may_be_rotated)
{
  Random random(5);
  Soup soup = displaced(dumbbell(24, 16), 0.1, random);
  for (Point& p : soup.points)
    p = Point(1.5 * p.x(), p.y(), p.z());
  const auto defect_in_frame = [](const Soup& s) {
    Surface surface = surface_of(s);
    CGAL::Spectral_segmentation::internal::move_to_frame(sequential, surface);
    return Defect_of_mesh(surface)(all_faces(surface));
  };
  const double unrotated = defect_in_frame(soup);
  for (int i = 0; i < 10; ++i)
    BOOST_TEST(defect_in_frame(rotated(soup, random_rotation(random))) == unrotated,
               tt::tolerance(1e-4));
}

BOOST_AUTO_TEST_SUITE_END()
