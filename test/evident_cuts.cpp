// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

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
Segmentation_hierarchy tree_of(const Mesh& mesh, const NamedParameters& np)
{
  Segmentation_hierarchy tree;
  std::vector<std::size_t> labels(num_faces(mesh));
  CGAL::segment_spectral_recursive(
    mesh, boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh)),
    np.hierarchy(tree));
  return tree;
}

Segmentation_hierarchy tree_of_parts(const Mesh& mesh, std::size_t number_of_segments)
{
  return tree_of(mesh, parameters::zhang_liu_2005().salience_threshold(-infinity)
                         .maximum_number_of_segments(number_of_segments));
}

Segmentation_hierarchy tree_of(const Mesh& mesh) { return tree_of(mesh, parameters::zhang_liu_2005()); }

// A limb, and the vertices at which it is joined to the rest.
struct Limb
{
  Region is_inside; // of points that are not on the seam
  Region is_seam;
};

// Whether the cut of a node runs within a ring of faces of the seam: of its faces that do not touch
// the seam, those of the limb and no others are on the one side.
bool is_cut_at_seam(const Mesh& mesh, const Segmentation_hierarchy& tree, std::size_t node, const Limb& limb)
{
  if (tree.node(node).is_leaf())
    return false;
  std::size_t faces_of_limb[2] = {0, 0}, other_faces[2] = {0, 0};
  for (int side = 0; side < 2; ++side)
    for (auto number : tree.faces(tree.node(node).children[side])) {
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

typedef std::array<int, 3> Cell;
typedef std::set<Cell> Cells;

void add_box(Cells& cells, const Cell& low, const Cell& high)
{
  for (int x = low[0]; x < high[0]; ++x)
    for (int y = low[1]; y < high[1]; ++y)
      for (int z = low[2]; z < high[2]; ++z)
        cells.insert({x, y, z});
}

// The boundary of a set of unit cubes, each square cut in two; on demand open in the plane z = 0.
Mesh boundary_of(const Cells& cells, bool is_open = false)
{
  Soup soup;
  std::map<Cell, std::size_t> number;
  const auto vertex = [&](const Cell& c) {
    const auto [entry, is_new] = number.emplace(c, soup.points.size());
    if (is_new)
      soup.points.emplace_back(c[0], c[1], c[2]);
    return entry->second;
  };
  for (const Cell& cell : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (int end = 0; end < 2; ++end) {
        Cell across = cell;
        across[axis] += 2 * end - 1;
        if (cells.count(across) || (is_open && across[2] < 0))
          continue;
        Cell corners[4] = {cell, cell, cell, cell};
        for (Cell& c : corners)
          c[axis] += end;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        ++corners[end == 1 ? 1 : 3][u];
        ++corners[2][u];
        ++corners[2][v];
        ++corners[end == 1 ? 3 : 1][v];
        const std::size_t a = vertex(corners[0]), b = vertex(corners[1]), c = vertex(corners[2]),
                          d = vertex(corners[3]);
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({a, c, d});
      }
  return mesh_of(soup);
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

} // namespace

BOOST_AUTO_TEST_CASE(spheres_that_meet_in_a_crease)
{
  for (const auto& [n_around, n_along] : {std::make_pair(12, 8), std::make_pair(16, 12)}) {
    const Mesh mesh = mesh_of(dumbbell(n_around, n_along));
    BOOST_TEST(is_cut_at_seam(mesh, tree_of_parts(mesh, 2), 0, above(0, 0)));
    BOOST_TEST(is_cut_at_seam(mesh, tree_of(mesh), 0, above(0, 0)));
  }
}

BOOST_AUTO_TEST_CASE(spheres_that_are_joined_by_a_neck)
{
  const Ball_with_bar ball = {0.25, 0.3};
  const double half_neck = 0.1 + ball.end_of_fillet() - ball.start_of_fillet();
  for (int n_around : {12, 20, 32})
    BOOST_TEST_CONTEXT(n_around << " faces around") {
      const Mesh mesh = two_balls(ball, 0.2, n_around);
      const Limb upper = above(-half_neck, half_neck);
      BOOST_TEST(is_cut_at_seam(mesh, tree_of_parts(mesh, 2), 0, upper));
      BOOST_TEST(is_cut_at_seam(mesh, tree_of(mesh), 0, upper));
    }
}

BOOST_AUTO_TEST_CASE(two_balls_are_two_parts)
{
  for (int n_around : {12, 20})
    BOOST_TEST(tree_of(two_balls({0.25, 0.3}, 0.2, n_around)).number_of_segments() == 2);
}

BOOST_AUTO_TEST_CASE(a_dumbbell_of_boxes)
{
  for (int k : {1, 2})
    BOOST_TEST_CONTEXT("scale " << k) {
      Cells cells;
      add_box(cells, {0, 0, 0}, {9 * k, 9 * k, 9 * k});
      add_box(cells, {3 * k, 3 * k, 9 * k}, {6 * k, 6 * k, 15 * k});
      add_box(cells, {0, 0, 15 * k}, {9 * k, 9 * k, 24 * k});
      const Mesh mesh = boundary_of(cells);
      const Segmentation_hierarchy tree = tree_of(mesh);
      BOOST_TEST(tree.number_of_segments() == 2);
      // The two ends of the bar are alike.
      const auto is_at_end = [k](const Point& p, int z) {
        return p.z() == z && p.x() >= 3 * k && p.x() <= 6 * k && p.y() >= 3 * k && p.y() <= 6 * k;
      };
      const Limb lower = {[=](const Point& p) { return p.z() <= 9 * k; },
                          [=](const Point& p) { return is_at_end(p, 9 * k); }};
      const Limb upper = {[=](const Point& p) { return p.z() >= 15 * k; },
                          [=](const Point& p) { return is_at_end(p, 15 * k); }};
      BOOST_TEST((is_cut_at_seam(mesh, tree, 0, lower) || is_cut_at_seam(mesh, tree, 0, upper)));
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
        BOOST_TEST(is_cut_at_seam(mesh, tree_of_parts(mesh, 2), 0, cylinder));
        BOOST_TEST(is_cut_at_seam(mesh, tree_of(mesh), 0, cylinder));
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
      const Mesh mesh = boundary_of(cells);
      BOOST_TEST(is_cut_at_seam(mesh, tree_of(mesh), 0, finger_along_z(x, 3)));
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
  const Mesh mesh = boundary_of(cells);

  const Segmentation_hierarchy tree = tree_of_parts(mesh, 2);
  const std::size_t handle = tree.node(0).children[0];
  const double area_of_handle = 2 * 3 * 4 + 4 * 13; // legs and bar
  BOOST_TEST_REQUIRE(!tree.node(0).is_leaf());
  BOOST_TEST(tree.node(handle).area > 0.8 * area_of_handle);
  for (auto f : tree.faces(handle))
    for (Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(Face(f)), mesh))
      BOOST_TEST(mesh.point(v).z() >= 3);
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
  const Mesh mesh = boundary_of(cells, true);

  const Segmentation_hierarchy tree = tree_of_parts(mesh, 6);
  std::vector<std::size_t> number_of_cuts(fingers.size(), 0);
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
    for (std::size_t finger = 0; finger < fingers.size(); ++finger)
      number_of_cuts[finger] += is_cut_at_seam(mesh, tree, i, fingers[finger]);
  BOOST_TEST(number_of_cuts == std::vector<std::size_t>(5, 1), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_sphere_is_one_part)
{
  const auto to_sphere = [](const Point& p)
  { return CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length()); };
  for (std::size_t level = 0; level <= 4; ++level)
    BOOST_TEST_CONTEXT("level " << level) {
      BOOST_TEST(tree_of(mesh_of(sphere(level))).number_of_segments() == 1);
      for (unsigned seed : {1, 2, 3}) {
        const double edge = std::ldexp(1., -int(level));
        const Mesh mesh = jittered(sphere(level), 0.1 * edge, seed, to_sphere);
        BOOST_TEST(tree_of(mesh).number_of_segments() == 1, "seed " << seed);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_flat_plate_is_one_part)
{
  const auto to_plane = [](const Point& p) { return Point(p.x(), p.y(), 0); };
  const std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {10, 10}, {30, 10}, {50, 2}, {40, 40}};
  for (const auto& [nx, ny] : sizes)
    BOOST_TEST_CONTEXT(nx << " x " << ny) {
      BOOST_TEST(tree_of(mesh_of(plate(nx, ny))).number_of_segments() == 1);
      for (unsigned seed : {1, 2, 3}) {
        const Mesh mesh = jittered(plate(nx, ny), 0.2, seed, to_plane);
        BOOST_TEST(tree_of(mesh).number_of_segments() == 1, "seed " << seed);
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
