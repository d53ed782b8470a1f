// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(evident_cuts)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

namespace {

typedef Mesh::Face_index Face;
typedef std::function<bool(const Point&)> Region;

const double infinity = std::numeric_limits<double>::infinity();

template <class NamedParameters>
Segmentation_hierarchy hierarchy_of_parts(const Mesh& mesh, const NamedParameters& np,
                                          std::size_t number_of_segments)
{
  return hierarchy_of(mesh, np.salience_threshold(-infinity)
                              .maximum_number_of_segments(number_of_segments));
}

// A limb, and the vertices at which it is joined to the rest.
struct Limb
{
  Region is_inside; // points that are not on the seam
  Region is_seam;
};

// Returns whether the cut of a node runs within a ring of faces of the seam: the faces of the limb
// that do not touch the seam are on one side, and all other such faces of the node on the other.
bool is_cut_at_seam(const Mesh& mesh, const Segmentation_hierarchy& hierarchy, std::size_t node,
                    const Limb& limb)
{
  if (hierarchy.node(node).is_leaf())
    return false;
  std::size_t faces_of_limb[2] = {0, 0}, other_faces[2] = {0, 0};
  for (int side = 0; side < 2; ++side)
    for (auto number : hierarchy.faces(hierarchy.node(node).children[side])) {
      const auto around = vertices_around_face(mesh.halfedge(Face(number)), mesh);
      const auto all = [&](const Region& region) {
        return std::all_of(around.begin(), around.end(),
                           [&](Mesh::Vertex_index v) { return region(mesh.point(v)); });
      };
      if (all([&](const Point& p) { return !limb.is_seam(p); }))
        ++(all(limb.is_inside) ? faces_of_limb : other_faces)[side];
    }
  return (faces_of_limb[0] > 0 && other_faces[0] == 0 && faces_of_limb[1] == 0) ||
         (faces_of_limb[1] > 0 && other_faces[1] == 0 && faces_of_limb[0] == 0);
}

// Everything above a height, joined in a band below it.
Limb above(double low, double high)
{
  const double rounding = 1e-9;
  return {[=](const Point& p) { return p.z() > high; },
          [=](const Point& p) { return p.z() > low - rounding && p.z() < high + rounding; }};
}

// Outlines in the half-plane of z and radius.
typedef std::vector<std::pair<double, double> > Profile;

void add_arc(Profile& profile, double z, double radius, double radius_of_arc, double from,
             double to, double step)
{
  const int n = std::max(1, int(std::lround(std::abs(to - from) * radius_of_arc / step)));
  for (int i = profile.empty() ? 0 : 1; i <= n; ++i) {
    const double angle = from + (to - from) * i / n;
    const double r = radius + radius_of_arc * std::sin(angle);
    profile.emplace_back(z + radius_of_arc * std::cos(angle), r < 1e-9 ? 0 : r);
  }
}

void add_line(Profile& profile, double z, double radius, double step)
{
  const auto [z_0, r_0] = profile.back();
  const int n = std::max(1, int(std::lround(std::hypot(z - z_0, radius - r_0) / step)));
  for (int i = 1; i <= n; ++i)
    profile.emplace_back(z_0 + (z - z_0) * i / n, r_0 + (radius - r_0) * i / n);
}

// A unit ball at the origin with a round fillet to a bar along z.
struct Ball_with_bar
{
  double radius_of_bar, radius_of_fillet;

  double end_of_fillet() const
  {
    return std::sqrt(std::pow(1 + radius_of_fillet, 2) -
                     std::pow(radius_of_bar + radius_of_fillet, 2));
  }
  double angle_of_fillet() const
  { return std::atan2(radius_of_bar + radius_of_fillet, end_of_fillet()); }
  double start_of_fillet() const { return std::cos(angle_of_fillet()); }

  Profile profile(double step) const
  {
    Profile p;
    add_arc(p, 0, 0, 1, pi, angle_of_fillet(), step);
    add_arc(p, end_of_fillet(), radius_of_bar + radius_of_fillet, radius_of_fillet,
            pi + angle_of_fillet(), 1.5 * pi, step);
    return p;
  }
};

Mesh ball_with_cylinder(const Ball_with_bar& ball, double length, int n_around)
{
  const double step = 2 * pi / n_around, end = ball.end_of_fillet() + length;
  Profile p = ball.profile(step);
  add_line(p, end, ball.radius_of_bar, step);
  add_line(p, end, 0, step);
  return mesh_of(surface_of_revolution(p, n_around));
}

// The neck is centered at z = 0.
Mesh two_balls(const Ball_with_bar& ball, double length, int n_around)
{
  const double step = 2 * pi / n_around, middle = ball.end_of_fillet() + length / 2;
  Profile p = ball.profile(step);
  for (auto& [z, radius] : p)
    z -= middle;
  const Profile lower = p;
  add_line(p, length / 2, ball.radius_of_bar, step);
  for (std::size_t i = lower.size() - 1; i-- > 0;)
    p.emplace_back(-lower[i].first, lower[i].second);
  return mesh_of(surface_of_revolution(p, n_around));
}

// A ring of square section 3, in a square of the given side.
Cells square_torus(int side)
{
  Cells cells;
  add_box(cells, {0, 0, 0}, {side, side, 3});
  for (int x = 3; x < side - 3; ++x)
    for (int y = 3; y < side - 3; ++y)
      for (int z = 0; z < 3; ++z)
        cells.erase({x, y, z});
  return cells;
}

// A bar of the cells [x, x+1] x [1, 2] that stands on the plane of the given z.
Limb finger_along_z(int x, int z)
{
  const auto is_at_bar = [x](const Point& p)
  { return p.x() >= x && p.x() <= x + 1 && p.y() >= 1 && p.y() <= 2; };
  return {[=](const Point& p) { return p.z() > z && is_at_bar(p); },
          [=](const Point& p) { return p.z() == z && is_at_bar(p); }};
}

// Moves each vertex at random by up to `amount` along each axis, then by `project` to the surface.
Mesh jittered(const Soup& soup, double amount, unsigned seed,
              const std::function<Point(const Point&)>& project)
{
  std::mt19937 engine(seed);
  const auto offset = [&] { return amount * (2 * double(engine()) / double(engine.max()) - 1); };
  Soup result = soup;
  for (Point& p : result.points) {
    const double x = p.x() + offset(), y = p.y() + offset(), z = p.z() + offset();
    p = project(Point(x, y, z));
  }
  return mesh_of(result);
}

// The paper's method makes two parts of two ends and a bar between them; by default the bar
// may be a part, too, or two. Faces whose vertices are all in an end belong to it.
void check_ends_are_two_parts(const Mesh& mesh, const Region& is_first, const Region& is_second)
{
  for_both_methods([&](const auto& np) {
    const Labels labels = labels_of(mesh, np);
    std::set<std::size_t> first, second;
    for (Face f : faces(mesh)) {
      const auto around = vertices_around_face(mesh.halfedge(f), mesh);
      const auto is_in = [&](const Region& region) {
        return std::all_of(around.begin(), around.end(),
                           [&](Mesh::Vertex_index v) { return region(mesh.point(v)); });
      };
      if (is_in(is_first))
        first.insert(labels[f]);
      if (is_in(is_second))
        second.insert(labels[f]);
    }
    BOOST_TEST(first.size() == 1);
    BOOST_TEST(second.size() == 1);
    BOOST_TEST((first != second));
    BOOST_TEST(number_of(labels) <= 5);
  });
  BOOST_TEST(number_of(labels_of(mesh, parameters::zhang_liu_2005())) == 2);
}

void check_one_part(const Mesh& mesh)
{
  for_both_methods([&](const auto& np) { BOOST_TEST(number_of(labels_of(mesh, np)) == 1); });
}

} // namespace

BOOST_AUTO_TEST_CASE(spheres_that_meet_in_a_crease)
{
  for (const auto& [n_around, n_along] : {std::make_pair(12, 8), std::make_pair(16, 12)}) {
    const Mesh mesh = mesh_of(dumbbell(n_around, n_along));
    for_both_methods([&](const auto& np) {
      BOOST_TEST(is_cut_at_seam(mesh, hierarchy_of_parts(mesh, np, 2), 0, above(0, 0)));
      BOOST_TEST(is_cut_at_seam(mesh, hierarchy_of(mesh, np), 0, above(0, 0)));
    });
  }
}

BOOST_AUTO_TEST_CASE(two_balls_and_a_neck_are_cut_at_the_neck_and_are_two_parts)
{
  const Ball_with_bar ball = {0.25, 0.3};
  const double half_neck = 0.1 + ball.end_of_fillet() - ball.start_of_fillet();
  for (int n_around : {12, 20, 32})
    BOOST_TEST_CONTEXT(n_around << " faces around") {
      const Mesh mesh = two_balls(ball, 0.2, n_around);
      const Limb upper = above(-half_neck, half_neck);
      for_both_methods([&](const auto& np) {
        BOOST_TEST(is_cut_at_seam(mesh, hierarchy_of_parts(mesh, np, 2), 0, upper));
        BOOST_TEST(is_cut_at_seam(mesh, hierarchy_of(mesh, np), 0, upper));
      });
      if (n_around < 32) // else the method of the paper divides the ends
        check_ends_are_two_parts(mesh, [=](const Point& p) { return p.z() < -half_neck + 1e-9; },
                                 [=](const Point& p) { return p.z() > half_neck - 1e-9; });
    }
}

BOOST_AUTO_TEST_CASE(a_dumbbell_of_boxes)
{
  for (int k : {1, 2})
    BOOST_TEST_CONTEXT("scale " << k) {
      Cells cells;
      add_box(cells, {0, 0, 0}, {9 * k, 9 * k, 9 * k});
      add_box(cells, {3 * k, 3 * k, 9 * k}, {6 * k, 6 * k, 15 * k});
      add_box(cells, {0, 0, 15 * k}, {9 * k, 9 * k, 24 * k});
      const Mesh mesh = mesh_of(boundary_of(cells));
      // The two ends of the bar are alike.
      const auto is_at_end = [k](const Point& p, int z) {
        return p.z() == z && p.x() >= 3 * k && p.x() <= 6 * k && p.y() >= 3 * k && p.y() <= 6 * k;
      };
      const Limb lower = {[=](const Point& p) { return p.z() <= 9 * k; },
                          [=](const Point& p) { return is_at_end(p, 9 * k); }};
      const Limb upper = {[=](const Point& p) { return p.z() >= 15 * k; },
                          [=](const Point& p) { return is_at_end(p, 15 * k); }};
      for_both_methods([&](const auto& np) {
        const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, np);
        BOOST_TEST((is_cut_at_seam(mesh, hierarchy, 0, lower) ||
                    is_cut_at_seam(mesh, hierarchy, 0, upper)));
      });
      check_ends_are_two_parts(mesh, lower.is_inside, upper.is_inside);
    }
}

BOOST_AUTO_TEST_CASE(a_capped_cylinder_with_a_ball)
{
  for (int n_around : {12, 20})
    for (double radius_of_fillet : {0.15, 0.3, 0.6})
      BOOST_TEST_CONTEXT(n_around << " faces around, fillet " << radius_of_fillet) {
        const Ball_with_bar ball = {0.35, radius_of_fillet};
        const Mesh mesh = ball_with_cylinder(ball, 2, n_around);
        const Limb cylinder = above(ball.start_of_fillet(), ball.end_of_fillet());
        for_both_methods([&](const auto& np) {
          BOOST_TEST(is_cut_at_seam(mesh, hierarchy_of_parts(mesh, np, 2), 0, cylinder));
          BOOST_TEST(is_cut_at_seam(mesh, hierarchy_of(mesh, np), 0, cylinder));
        });
      }
}

BOOST_AUTO_TEST_CASE(a_torus_with_a_knob)
{
  for (const auto& [side, length] : {std::make_pair(12, 6), std::make_pair(15, 8),
                                     std::make_pair(18, 8)})
    BOOST_TEST_CONTEXT("side " << side << ", length " << length) {
      const int x = side / 2;
      Cells cells = square_torus(side);
      add_box(cells, {x, 1, 3}, {x + 1, 2, 3 + length});
      const Mesh mesh = mesh_of(boundary_of(cells));
      for_both_methods([&](const auto& np)
        { BOOST_TEST(is_cut_at_seam(mesh, hierarchy_of(mesh, np), 0, finger_along_z(x, 3))); });
    }
}

// The handle is joined at both ends: a surface of genus 2. Both ends are at the same place of the
// line only if a sample is in the middle of the handle, so one of them may be cut off short.
BOOST_AUTO_TEST_CASE(a_torus_with_a_handle)
{
  Cells cells = square_torus(15);
  add_box(cells, {1, 1, 3}, {2, 2, 6});
  add_box(cells, {13, 1, 3}, {14, 2, 6});
  add_box(cells, {1, 1, 6}, {14, 2, 7});
  const Mesh mesh = mesh_of(boundary_of(cells));

  const double area_of_handle = 2 * 3 * 4 + 4 * 13; // legs and bar
  for_both_methods([&](const auto& np) {
    const Segmentation_hierarchy hierarchy = hierarchy_of_parts(mesh, np, 2);
    BOOST_TEST_REQUIRE(!hierarchy.node(0).is_leaf());
    const std::size_t handle = hierarchy.node(0).children[0];
    BOOST_TEST(hierarchy.node(handle).area > 0.8 * area_of_handle);
    for (auto f : hierarchy.faces(handle))
      for (Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(Face(f)), mesh))
        BOOST_TEST(mesh.point(v).z() >= 3);
  });
}

// A palm that is open at the wrist, four fingers along z and a thumb along x.
BOOST_AUTO_TEST_CASE(a_hand)
{
  Cells cells;
  add_box(cells, {0, 0, 0}, {13, 3, 9});
  std::vector<Limb> fingers;
  for (int x : {1, 4, 7, 10}) {
    add_box(cells, {x, 1, 9}, {x + 1, 2, x == 4 || x == 7 ? 18 : 17});
    fingers.push_back(finger_along_z(x, 9));
  }
  add_box(cells, {13, 1, 3}, {21, 2, 4});
  fingers.push_back({[](const Point& p) { return p.x() > 13; },
                     [](const Point& p) { return p.x() == 13 && p.y() >= 1 && p.y() <= 2 &&
                                                 p.z() >= 3 && p.z() <= 4; }});
  const Mesh mesh = mesh_of(boundary_of(cells, true));

  for_both_methods([&](const auto& np) {
    const Segmentation_hierarchy hierarchy = hierarchy_of_parts(mesh, np, 6);
    std::vector<std::size_t> number_of_cuts(fingers.size(), 0);
    for (std::size_t cut = 0; cut < fingers.size(); ++cut) // the first ones that were made
      for (std::size_t finger = 0; finger < fingers.size(); ++finger)
        number_of_cuts[finger] +=
          is_cut_at_seam(mesh, hierarchy, hierarchy.node(1 + 2 * cut).parent, fingers[finger]);
    BOOST_TEST(number_of_cuts == std::vector<std::size_t>(5, 1), boost::test_tools::per_element());
  });
}

BOOST_AUTO_TEST_CASE(a_sphere_is_one_part)
{
  const auto to_sphere = [](const Point& p)
  { return CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length()); };
  for (std::size_t level = 0; level <= 4; ++level)
    BOOST_TEST_CONTEXT("level " << level) {
      check_one_part(mesh_of(sphere(level)));
      for (unsigned seed : {1, 2, 3})
        BOOST_TEST_CONTEXT("seed " << seed) {
          const double edge = std::ldexp(1., -int(level));
          check_one_part(jittered(sphere(level), 0.1 * edge, seed, to_sphere));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_flat_plate_is_one_part)
{
  const auto to_plane = [](const Point& p) { return Point(p.x(), p.y(), 0); };
  const std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {10, 10}, {30, 10}, {50, 2}, {40, 40}};
  for (const auto& [nx, ny] : sizes)
    BOOST_TEST_CONTEXT(nx << " x " << ny) {
      check_one_part(mesh_of(plate(nx, ny)));
      for (unsigned seed : {1, 2, 3})
        BOOST_TEST_CONTEXT("seed " << seed)
          check_one_part(jittered(plate(nx, ny), 0.2, seed, to_plane));
    }
}

BOOST_AUTO_TEST_SUITE_END()
