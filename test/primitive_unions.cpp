// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../benchmark/primitive_unions.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(primitive_unions)

using namespace segmentation_benchmark;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace tt = boost::test_tools;

// The first numbers of the generator, which the standard defines, are those of every machine.
BOOST_AUTO_TEST_CASE(random_numbers_are_those_of_the_standard)
{
  Uniform_random random(5489);
  for (int i = 0; i < 9999; ++i)
    random();
  BOOST_TEST(random() == double(9981545732273789042u >> 11) / 9007199254740992.);
  for (int i = 0; i < 1000; ++i) {
    BOOST_TEST(random.below(3) < 3u);
    const double x = random(-2, 5);
    BOOST_TEST((x >= -2 && x < 5));
  }
}

BOOST_AUTO_TEST_CASE(primitives_are_solids)
{
  const std::vector<std::pair<std::string, Mesh> > primitives = {
    {"box", box(1, 2, 3)},
    {"cylinder", frustum(1, 1, -1, 2, 16)},
    {"cone", frustum(1, 0, 0, 2, 16)},
    {"cone with the tip below", frustum(0, 1, 0, 2, 16)},
    {"frustum", frustum(1, 0.3, 0, 2, 5)},
    {"sphere", uv_sphere(2, 40)},
    {"torus", torus(2, 0.5, 40, 16)}};
  for (const auto& [name, mesh] : primitives)
    BOOST_TEST_CONTEXT(name) {
      BOOST_TEST(is_solid(mesh));
      BOOST_TEST(PMP::is_outward_oriented(mesh));
    }
  BOOST_TEST(PMP::volume(box(1, 2, 3)) == 6, tt::tolerance(1e-12));
  BOOST_TEST(PMP::volume(frustum(1, 1, -1, 2, 4)) == 6, tt::tolerance(1e-12));
  BOOST_TEST(PMP::volume(uv_sphere(2, 40)) == 32 / 3. * CGAL_PI, tt::tolerance(0.03));
  BOOST_TEST(PMP::volume(torus(2, 0.5, 40, 16)) == CGAL_PI * CGAL_PI, tt::tolerance(0.05));
}

// A pin through a plate: its two ends are pieces of their own.
BOOST_AUTO_TEST_CASE(faces_know_their_primitives)
{
  const std::vector<Primitive> primitives = {
    {box(4, 4, 1), {}},
    {placed(frustum(1, 1, -2, 3, 4), Eigen::Isometry3d::Identity()), {}}};
  std::optional<Mesh> mesh = united(primitives);
  BOOST_TEST_REQUIRE(mesh.has_value());
  BOOST_TEST(is_solid(*mesh));
  BOOST_TEST(PMP::volume(*mesh) == 16 + 2 * 4, tt::tolerance(1e-9));

  const Labels pieces = connected_pieces(*mesh);
  const Face_origins origins = face_origins(*mesh, 0);
  std::vector<double> areas(number_of_segments(pieces), 0.);
  BOOST_TEST_REQUIRE(areas.size() == 3u);
  for (Mesh::Face_index f : mesh->faces()) {
    areas[pieces[f]] += PMP::face_area(f, *mesh);
    const auto& p = mesh->point(mesh->target(mesh->halfedge(f)));
    const auto& q = mesh->point(mesh->source(mesh->halfedge(f)));
    // Faces that leave the plate are the pin's.
    if (std::abs(p.z() + q.z()) > 1 + 1e-9)
      BOOST_TEST(origins[f] == 1u);
  }
  std::sort(areas.begin(), areas.end());
  const double side = std::sqrt(2.);
  BOOST_TEST(areas[0] == 2 + 4 * side * 1.5, tt::tolerance(1e-9));
  BOOST_TEST(areas[1] == 2 + 4 * side * 2.5, tt::tolerance(1e-9));
  BOOST_TEST(areas[2] == 2 * (16 - 2) + 16, tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(seeds_make_solids_with_visible_parts)
{
  for (std::uint64_t seed : {1, 2, 3, 4, 6, 7, 58, 60}) {
    const Known_parts made = primitive_union(seed), again = primitive_union(seed);
    BOOST_TEST_REQUIRE(made.mesh.has_value());
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    BOOST_TEST(is_solid(*made.mesh));
    BOOST_TEST(PMP::is_outward_oriented(*made.mesh));
    BOOST_TEST(made.truth.size() == made.mesh->number_of_faces());
    BOOST_TEST(number_of_segments(made.truth) >= 3u);
    BOOST_TEST(made.truth == again.truth, tt::per_element());
  }
}

// The whole surface in one segment errs in all pairs of points that are in different parts.
BOOST_AUTO_TEST_CASE(rand_error_by_area_by_hand)
{
  const std::vector<double> areas = {3, 1, 2, 2};
  const Labels truth = {0, 0, 1, 1}, one = {0, 0, 0, 0}, other = {0, 1, 1, 1};
  BOOST_TEST(rand_error_by_area(overlap(truth, truth, areas)) == 0);
  BOOST_TEST(rand_error_by_area(overlap(one, truth, areas)) == 0.5, tt::tolerance(1e-12));
  // The second face, of area 1, with the first and with the last two: 2 (3 + 4) of 64.
  BOOST_TEST(rand_error_by_area(overlap(other, truth, areas)) == 14 / 64., tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
