// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/salience/Cut_evaluator.h>
#include <CGAL/Spectral_segmentation/internal/salience/Support_points.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(cut_evaluator)

namespace internal = CGAL::Spectral_segmentation::internal;
namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::Salience_factors;
using internal::Cut_evaluator;
using internal::Support_points;
using internal::Edge_weights;
using internal::Evaluation_context;
using internal::total_area;
using internal::Convexity_defect;
using internal::Vector;

namespace {

typedef std::vector<char> Sides;

auto tolerance(double t) { return boost::test_tools::tolerance(t); }

Surface graph_of(const Soup& soup)
{ return graph_with_distances(soup, weights_of_calibrated_method); }

// z of the centroid of each face, in the coordinates of the soup.
std::vector<double> heights(const Soup& soup)
{
  std::vector<double> result;
  for (const std::vector<std::size_t>& t : soup.triangles)
    result.push_back((soup.points[t[0]].z() + soup.points[t[1]].z() + soup.points[t[2]].z()) / 3);
  return result;
}

Sides below(const Soup& soup, double z)
{
  Sides side;
  for (double h : heights(soup))
    side.push_back(h < z ? 0 : 1);
  return side;
}

Sides swapped(Sides side)
{
  for (char& s : side)
    s = 1 - s;
  return side;
}

// Returns the factors of a cut of the whole mesh, as if the area of the mesh were multiplied.
Salience_factors factors(const Surface& graph, const Sides& side, double times = 1,
                         bool is_boundary = false)
{
  std::vector<Index> faces(graph.number_of_faces());
  std::iota(faces.begin(), faces.end(), Index(0));
  Evaluation_context mesh(graph);
  mesh.area_of_model *= times;
  return Cut_evaluator(graph, faces, mesh)(side, is_boundary);
}

Salience_factors factors_of_boundary(const Surface& graph, const Sides& side)
{ return factors(graph, side, 1, true); }

// 1 x 1 x 2: two cubes on top of each other.
Soup box()
{
  const double r = std::sqrt(0.5);
  return surface_of_revolution({{0, 0}, {0, r}, {1, r}, {2, r}, {2, 0}}, 4);
}

// Radius 1, open.
Soup tube(std::size_t length, std::size_t rings_per_unit, std::size_t n_around)
{
  std::vector<std::pair<double, double> > profile;
  for (std::size_t i = 0; i <= length * rings_per_unit; ++i)
    profile.emplace_back(double(i) / double(rings_per_unit), 1.);
  return surface_of_revolution(profile, n_around);
}

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

BOOST_AUTO_TEST_CASE(a_box_of_two_cubes_is_cut_in_the_middle)
{
  const Soup soup = box();
  const Surface graph = graph_of(soup);
  const Salience_factors f = factors(graph, below(soup, 1), 4);
  BOOST_TEST(f.size == 0.5, tolerance(1e-12));
  // The corners of the unit square have the variance 1/4 in each direction; a half has the area 5.
  BOOST_TEST(f.protrusiveness == 1 - 4 * 0.25 / 5, tolerance(1e-12));
  BOOST_TEST(f.cut_strength == 0);
  BOOST_TEST(f.log_relative_part_area == -std::log(4.), tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_plate_cut_off_a_plate_has_a_base_without_width)
{
  const Surface graph = graph_of(plate(4, 1));
  const Salience_factors f = factors(graph, {0, 0, 1, 1, 1, 1, 1, 1});
  BOOST_TEST(f.size == 0.25, tolerance(1e-12));
  BOOST_TEST(f.protrusiveness == 1, tolerance(1e-7));
  BOOST_TEST(f.cut_strength == 0);
}

BOOST_AUTO_TEST_CASE(the_size_of_the_whole_mesh_enters_three_factors)
{
  const Soup soup = dumbbell(20, 15);
  const Surface graph = graph_of(soup);
  const Salience_factors a = factors(graph, below(soup, 0)),
                         b = factors(graph, below(soup, 0), 100);
  BOOST_TEST(std::abs(a.log_relative_part_area) < 1e-12);
  BOOST_TEST(b.log_relative_part_area == -std::log(100.), tolerance(1e-12));
  BOOST_TEST(a.convexity_gain == 10 * b.convexity_gain, tolerance(1e-12));
  // The sides are convex.
  for (const Salience_factors& f : {a, b})
    BOOST_TEST(f.relative_convexity_gain == std::log(1 + 200 * f.convexity_gain), tolerance(1e-3));
  BOOST_TEST(a.expansion_behind_cut == b.expansion_behind_cut);
}

BOOST_AUTO_TEST_CASE(a_convex_body_does_not_get_more_convex)
{
  const Soup soup = sphere(3);
  const Salience_factors f = factors(graph_of(soup), below(soup, 0));
  BOOST_TEST(std::abs(f.convexity_gain) < 1e-6);
  BOOST_TEST(std::abs(f.relative_convexity_gain) < 1e-3);
}

BOOST_AUTO_TEST_CASE(two_spheres_are_convex_once_they_are_cut_apart)
{
  const Soup soup = dumbbell(40, 30);
  const Salience_factors f = factors(graph_of(soup), below(soup, 0));
  // The hull is a capsule. Below it a face whose normal leans by c towards the other sphere has the
  // depth c times the distance of the centers, in the mean a fourth of that.
  const double distance = 2 * std::sqrt(1 - 0.04);
  BOOST_TEST(f.convexity_gain == distance / 4 / std::sqrt(8 * pi), tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(gains_of_convexity_are_differences_of_the_defects)
{
  const Soup soup = dumbbell(20, 15);
  const Surface graph = graph_of(soup);
  const Sides side = below(soup, 0.5);
  std::vector<Index> all, faces[2];
  double area[2] = {0, 0};
  for (Index f = 0; f < side.size(); ++f) {
    all.push_back(f);
    faces[int(side[f])].push_back(f);
    area[int(side[f])] += graph.areas[f];
  }
  const Support_points support_points(graph);
  const internal::Convexity_defect defect(support_points, graph, all);
  const double of_sides =
    (area[0] * defect(faces[0]) + area[1] * defect(faces[1])) / (area[0] + area[1]);
  const double unit = 5, whole = defect(all) / unit, sides = of_sides / unit;
  const Salience_factors f = factors(graph, side, 25 / total_area(graph));
  BOOST_TEST(sides > 0.01);
  BOOST_TEST(whole - sides > 0.01);
  BOOST_TEST(f.convexity_gain == whole - sides, tolerance(1e-9));
  BOOST_TEST(f.relative_convexity_gain == std::log((whole + 0.005) / (sides + 0.005)),
             tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(concavity_near_the_cut_is_a_mean_by_length)
{
  // The faces near the cut are the 8 that have an edge of it, each with edges 1, 1, sqrt(2).
  const Soup soup = box();
  Surface graph = graph_of(soup);
  const Sides side = below(soup, 1);
  for (Edge_weights& h : graph.weights)
    h.concavity = 0;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (side[h / 3] != side[graph.neighbor(h)])
      graph.weights[h].concavity = 0.5;
  const Salience_factors f = factors(graph, side);
  BOOST_TEST(f.cut_strength == 0.5, tolerance(1e-12));
  BOOST_TEST(f.concavity_near_cut == 0.5 / (2 + std::sqrt(2.)), tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(concavity_near_the_cut_ignores_distant_edges)
{
  const Soup soup = tube(12, 4, 24);
  Surface graph = graph_of(soup);
  const Sides side = below(soup, 3);
  const double area_of_q = factors(graph, side).size * total_area(graph);
  std::vector<char> is_near(side.size(), 0);
  for (const internal::Face_at_distance& f :
       internal::faces_near_cut(graph, side, internal::halfedges_of_cut(graph, side),
                                0.35 * std::sqrt(area_of_q)))
    is_near[f.face] = 1;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    graph.weights[h].concavity =
      is_near[h / 3] || is_near[graph.neighbor(h)] ? 0.25f : 1.f;
  BOOST_TEST(std::count(is_near.begin(), is_near.end(), 0) > 0);
  BOOST_TEST(factors(graph, side).concavity_near_cut == 0.25, tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(expansion_is_the_area_near_the_cut_over_its_length_and_the_radius)
{
  // Half a box has the area 5, which makes a radius of 0.78; the faces at the cut have their
  // centroids at 0.37, the others are beyond 0.78. Each of the 4 at the cut that belong to the rest
  // has the area 1/2, the cut the length 4.
  const Soup soup = box();
  const Salience_factors f = factors(graph_of(soup), below(soup, 1));
  BOOST_TEST(f.expansion_behind_cut == 4 * 0.5 / (0.35 * std::sqrt(5.) * 4), tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_cylinder_does_not_expand_and_a_sphere_behind_a_neck_does)
{
  const Soup cylinder = tube(20, 6, 36);
  const double expansion = factors(graph_of(cylinder), below(cylinder, 6)).expansion_behind_cut;
  BOOST_TEST(expansion > 0.75); // ways over centroids are a bit longer than the straight ones
  BOOST_TEST(expansion < 1.02);

  const Soup spheres = dumbbell(40, 30);
  const double of_sphere = factors(graph_of(spheres), below(spheres, 0)).expansion_behind_cut;
  // A zone of the sphere from the neck up to the radius.
  const double neck = std::asin(0.2), radius = 0.35 * std::sqrt(4 * pi);
  const double zone = 2 * pi * (std::cos(neck) - std::cos(neck + radius));
  BOOST_TEST(of_sphere < 1.02 * zone / (radius * 2 * pi * 0.2));
  BOOST_TEST(of_sphere > 0.65 * zone / (radius * 2 * pi * 0.2));
}

BOOST_AUTO_TEST_CASE(expansion_ends_at_four)
{
  const Soup soup = dumbbell(20, 15);
  const Sides side = below(soup, 0);
  Surface graph = graph_of(soup);
  for (Index f = 0; f < side.size(); ++f)
    graph.areas[f] *= side[f] == 1 ? 100 : 1;
  BOOST_TEST(factors(graph, side).expansion_behind_cut == 4);
}

BOOST_AUTO_TEST_CASE(a_boundary_has_the_factors_of_a_candidate_and_more)
{
  const Soup soup = dumbbell(20, 15);
  const Surface graph = graph_of(soup);
  const Salience_factors a = factors(graph, below(soup, 0)),
                         b = factors_of_boundary(graph, below(soup, 0));
  BOOST_TEST(!a.is_boundary);
  BOOST_TEST(b.is_boundary);
  for (std::size_t i = 0; i < CGAL::Spectral_segmentation::named_factors.size(); ++i) {
    const auto [name, value] = CGAL::Spectral_segmentation::named_factors[i];
    BOOST_TEST_CONTEXT(name)
      {
        const double of_candidate = a.*value, of_boundary = b.*value;
        BOOST_TEST(of_candidate == (i < 8 ? of_boundary : 0));
      }
  }
}

BOOST_AUTO_TEST_CASE(roundness_of_a_square_a_rectangle_and_a_line)
{
  const Soup square = box();
  BOOST_TEST(factors_of_boundary(graph_of(square), below(square, 1)).roundness == 1,
             tolerance(1e-7));
  // The rectangle 1 x 3, by length: x has the variance (6 / 4 + 2 / 12) / 8, y that of a side of
  // length 3 and of ends at 3/2, (6 * 9 / 12 + 2 * 9 / 4) / 8.
  Soup wide = box();
  Surface graph = graph_of(wide);
  const double r = std::sqrt(0.5); // the corners of the square are at (r, 0), (0, r) and so on
  const internal::Vector direction(r, r, 0);
  for (internal::Vector& p : graph.points)
    p += 2 * p.dot(direction) * direction;
  BOOST_TEST(factors_of_boundary(graph, below(wide, 1)).roundness ==
             std::sqrt((6. / 4 + 2. / 12) / (6. * 9 / 12 + 2. * 9 / 4)), tolerance(1e-7));
  const Salience_factors line =
    factors_of_boundary(graph_of(plate(4, 1)), {0, 0, 1, 1, 1, 1, 1, 1});
  BOOST_TEST(std::abs(line.roundness) < 1e-7);
}

BOOST_AUTO_TEST_CASE(the_rest_is_flat_on_a_plate_and_not_at_all_on_a_tube)
{
  BOOST_TEST(factors_of_boundary(graph_of(plate(4, 1)), {0, 0, 1, 1, 1, 1, 1, 1})
               .flatness_behind_cut == 1, tolerance(1e-9));
  const Soup cylinder = tube(12, 4, 24);
  BOOST_TEST(factors_of_boundary(graph_of(cylinder), below(cylinder, 3)).flatness_behind_cut < 0.1);
}

BOOST_AUTO_TEST_CASE(a_quarter_of_the_length_is_at_most_as_concave_as_the_quartile)
{
  const Soup soup = tube(6, 1, 6);
  Surface graph = graph_of(soup);
  const Sides side = below(soup, 3);
  std::vector<Index> cut = internal::halfedges_of_cut(graph, side);
  BOOST_TEST_REQUIRE(cut.size() == 6u);
  for (std::size_t i = 0; i < cut.size(); ++i) // of equal lengths, a quarter is 1.5 edges
    graph.weights[cut[i]].concavity = graph.weights[graph.opposite[cut[i]]].concavity =
      float((i * 5 + 2) % 6 + 1) / 8;
  BOOST_TEST(factors_of_boundary(graph, side).lower_quartile_of_concavity == 0.25);
}

BOOST_AUTO_TEST_CASE(concavity_around_the_cut_sees_twice_as_far)
{
  const Soup soup = tube(12, 4, 24);
  Surface graph = graph_of(soup);
  const Sides side = below(soup, 3);
  const double area_of_q = factors(graph, side).size * total_area(graph);
  const std::vector<Index> cut = internal::halfedges_of_cut(graph, side);
  std::vector<char> is_near(side.size(), 0);
  for (const internal::Face_at_distance& f :
       internal::faces_near_cut(graph, side, cut, 0.7 * std::sqrt(area_of_q)))
    is_near[f.face] = 1;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    graph.weights[h].concavity = is_near[h / 3] || is_near[graph.neighbor(h)] ? 0.25f : 1.f;
  BOOST_TEST(std::count(is_near.begin(), is_near.end(), 0) > 0);
  BOOST_TEST(factors_of_boundary(graph, side).concavity_around_cut == 0.25, tolerance(1e-9));

  for (const internal::Face_at_distance& f :
       internal::faces_near_cut(graph, side, cut, 0.36 * std::sqrt(area_of_q)))
    for (Index h = 3 * f.face; h < 3 * f.face + 3; ++h)
      graph.weights[h].concavity = graph.weights[graph.opposite[h]].concavity = 0;
  const Salience_factors f = factors_of_boundary(graph, side);
  BOOST_TEST(f.concavity_near_cut == 0);
  BOOST_TEST(f.concavity_around_cut > 0.08);
  BOOST_TEST(f.concavity_around_cut < 0.17);
}

// On both sides of the middle of a cylinder the same area is near.
BOOST_AUTO_TEST_CASE(expansion_before_the_cut_is_measured_on_the_smaller_side)
{
  const Soup cylinder = tube(20, 6, 36);
  const Salience_factors long_side = factors_of_boundary(graph_of(cylinder), below(cylinder, 8));
  BOOST_TEST(long_side.expansion_before_cut > 0.75);
  BOOST_TEST(long_side.expansion_before_cut < 1.02);
  // The side ends within the distance 2 r = 0.7 sqrt(2 pi h), and all of it counts.
  const Salience_factors short_side = factors_of_boundary(graph_of(cylinder), below(cylinder, 2));
  const double area = 36 * 2 * std::sin(pi / 36) * 2; // of 36 sides of a prism
  BOOST_TEST(short_side.expansion_before_cut ==
             area / (0.7 * std::sqrt(area) * 36 * 2 * std::sin(pi / 36)), tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(halves_of_equal_area_swap_their_factors_with_their_labels)
{
  Random random(7);
  const Soup soup = displaced(dumbbell(20, 15), 0.01, random);
  Surface graph = graph_of(soup);
  const Sides side = below(soup, 0);
  // The halves get the same area, and each face its fraction of it.
  double area[2] = {0, 0};
  for (Index f = 0; f < side.size(); ++f)
    area[int(side[f])] += graph.areas[f];
  for (Index f = 0; f < side.size(); ++f)
    graph.areas[f] /= area[int(side[f])];
  const Salience_factors a = factors(graph, side), b = factors(graph, swapped(side));
  const auto same = tolerance(1e-9);
  BOOST_TEST(a.size == b.size, same);
  BOOST_TEST(a.cut_strength == b.cut_strength, same);
  BOOST_TEST(a.protrusiveness == b.protrusiveness, same);
  BOOST_TEST(a.log_relative_part_area == b.log_relative_part_area, same);
  BOOST_TEST(a.concavity_near_cut == b.concavity_near_cut, same);
  BOOST_TEST(a.convexity_gain == b.convexity_gain, same);
  BOOST_TEST(a.relative_convexity_gain == b.relative_convexity_gain, same);
}

BOOST_AUTO_TEST_CASE(cut_strength_is_the_mean_concavity_by_length)
{
  for (unsigned seed = 1; seed <= 40; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const std::vector<Soup> shapes = {plate(9, 7), sphere(2), torus(2, 0.7, 16, 10),
                                        dumbbell(12, 8)};
      const Soup soup = displaced(shapes[seed % shapes.size()], 0.1, random);
      const Mesh mesh = mesh_of(soup);
      const Surface graph = graph_of(soup);
      Sides side(graph.number_of_faces());
      for (char& s : side)
        s = random() % 3 == 0 ? 0 : 1;
      side[0] = 0;
      side[1] = 1;

      double length = 0, sum = 0;
      for (Mesh::Edge_index e : mesh.edges()) {
        if (mesh.is_border(e))
          continue;
        const Mesh::Face_index f = mesh.face(mesh.halfedge(e, 0)),
                               g = mesh.face(mesh.halfedge(e, 1));
        if (side[f] == side[g])
          continue;
        const double l = std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)),
                                                          mesh.point(mesh.vertex(e, 1))));
        length += l;
        for (Index h = 3 * Index(f); h < 3 * Index(f) + 3; ++h)
          if (graph.neighbor(h) == Index(g))
            sum += l * graph.weights[h].concavity;
      }
      BOOST_TEST(factors(graph, side).cut_strength == sum / length, tolerance(1e-9));
      BOOST_TEST(sum > 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(an_evaluator_forgets_the_cuts_before)
{
  const Soup soup = torus(2, 0.7, 16, 10);
  const Surface graph = graph_of(soup);
  std::vector<Index> faces(graph.number_of_faces());
  std::iota(faces.begin(), faces.end(), Index(0));
  const Evaluation_context mesh(graph);
  const Cut_evaluator evaluator(graph, faces, mesh);
  for (double z : {-0.5, 0.3, -0.5}) {
    const Salience_factors a = evaluator(below(soup, z)), b = factors(graph, below(soup, z));
    BOOST_TEST(a.protrusiveness == b.protrusiveness);
    BOOST_TEST(a.cut_strength == b.cut_strength);
    BOOST_TEST(a.concavity_near_cut == b.concavity_near_cut);
    BOOST_TEST(a.relative_convexity_gain == b.relative_convexity_gain);
    BOOST_TEST(a.expansion_behind_cut == b.expansion_behind_cut);
  }
}

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
