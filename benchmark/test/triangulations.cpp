// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../triangulations.h"
#include "test_meshes.h"

#include <CGAL/boost/graph/copy_face_graph.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>

BOOST_AUTO_TEST_SUITE(triangulations)

using namespace segmentation_benchmark;

namespace {

Mesh benchmark_mesh(const test_meshes::Soup& soup)
{
  Mesh mesh;
  CGAL::copy_face_graph(test_meshes::mesh_of(soup), mesh);
  return mesh;
}

// 0, 1, 2 or 3: in which quarter around the z axis each face is.
Labels quarters(const Mesh& mesh)
{
  Labels labels;
  for (Mesh::Face_index f : mesh.faces()) {
    const Kernel::Point_3 c = centroid(mesh, f);
    labels.push_back((c.x() > 0 ? 1 : 0) + (c.y() > 0 ? 2 : 0));
  }
  return labels;
}

// A torus with more faces than decimated and remeshed ones have, and edges in all directions.
Mesh fine_torus()
{
  test_meshes::Random random(3);
  return benchmark_mesh(test_meshes::displaced(test_meshes::torus(1, 0.4, 120, 60), 0.003, random));
}

} // namespace

BOOST_AUTO_TEST_CASE(meshes_have_the_size_that_is_said)
{
  const Mesh mesh = fine_torus();
  BOOST_TEST(triangulated_as("as_is", mesh).number_of_faces() == mesh.number_of_faces());
  BOOST_TEST(triangulated_as("subdivided", mesh).number_of_faces() == 4 * mesh.number_of_faces());
  const std::size_t decimated = triangulated_as("decimated", mesh).number_of_faces();
  BOOST_TEST(decimated <= faces_of_decimated);
  BOOST_TEST(decimated >= faces_of_decimated - 2);
  const double remeshed =
    static_cast<double>(triangulated_as("remeshed", mesh).number_of_faces());
  BOOST_TEST(std::abs(remeshed / faces_of_remeshed - 1) < 0.2);
}

// No edge of a cube is rounded off.
BOOST_AUTO_TEST_CASE(remeshing_keeps_sharp_edges)
{
  test_meshes::Soup cube;
  for (int i = 0; i < 8; ++i)
    cube.points.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const Mesh mesh = triangulated_as("remeshed", benchmark_mesh(cube));
  BOOST_TEST(CGAL::Polygon_mesh_processing::area(mesh) == 6,
             boost::test_tools::tolerance(1e-6));
}

// Labels of the changed mesh are carried back to where they are, except along the cuts.
BOOST_AUTO_TEST_CASE(labels_are_carried_back_by_place)
{
  const Mesh mesh = fine_torus();
  const Labels expected = contiguous(quarters(mesh));
  for (const std::string& name : triangulation_names()) {
    const Retriangulated_mesh changed = retriangulated(name, mesh);
    BOOST_TEST_CONTEXT(name) {
      BOOST_TEST(changed.faces_on.size() == mesh.number_of_faces());
      const Labels labels = carried_back(changed, contiguous(quarters(changed.mesh)));
      BOOST_TEST(number_of_segments(labels) == 4u);
      BOOST_TEST(rand_error(labels, expected) < (name == "decimated" ? 0.03 : 0.015));
      if (is_as_is(name))
        BOOST_TEST(labels == expected, boost::test_tools::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(subdivided_faces_vote_for_their_parent)
{
  const Retriangulated_mesh changed =
    retriangulated("subdivided", benchmark_mesh(test_meshes::plate(1, 1)));
  BOOST_TEST(carried_back(changed, {0, 1, 1, 1, 2, 0, 2, 0}) == (Labels{0, 1}),
             boost::test_tools::per_element()); // the one of 2 and 0 that comes first
  BOOST_TEST(carried_back(changed, {5, 1, 1, 5, 1, 5, 5, 5}) == (Labels{0, 0}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(cache_gives_the_same_mesh)
{
  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / "spectral_segmentation_triangulations";
  std::filesystem::remove_all(folder);
  const Mesh mesh = fine_torus();
  const Mesh direct = retriangulated("decimated", mesh).mesh;
  for (int run = 0; run < 2; ++run) {
    const Mesh cached = retriangulated("decimated", mesh, folder, "torus").mesh;
    BOOST_TEST(cached.number_of_faces() == direct.number_of_faces());
    BOOST_TEST(std::equal(direct.points().begin(), direct.points().end(),
                          cached.points().begin(), cached.points().end()));
  }
  std::filesystem::remove_all(folder);
}

BOOST_AUTO_TEST_SUITE_END()
