// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>

#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(laplacian_smoothing)

using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::Vector;

namespace {

std::vector<Vector> smoothed_points(const Surface& graph, std::size_t iterations)
{
  return CGAL::Spectral_segmentation::internal::smoothed_points(graph, iterations,
                                                                [] { return true; });
}

// One step at a time, over the vertices of the mesh.
std::vector<Vector> smoothed_by_vertex(const Soup& soup, std::vector<Vector> points,
                                       std::size_t iterations)
{
  const Mesh mesh = mesh_of(soup);
  for (; iterations > 0; --iterations) {
    const std::vector<Vector> old = points;
    for (Mesh::Vertex_index v : mesh.vertices()) {
      if (mesh.is_border(v))
        continue;
      Vector sum;
      for (Mesh::Vertex_index w : vertices_around_target(mesh.halfedge(v), mesh))
        sum += old[w];
      points[v] = (old[v] + sum / mesh.degree(v)) / 2;
    }
  }
  return points;
}

} // namespace

BOOST_AUTO_TEST_CASE(no_step_changes_nothing)
{
  const Surface graph = surface_of(sphere(1));
  BOOST_TEST((smoothed_points(graph, 0) == graph.points));
}

BOOST_AUTO_TEST_CASE(the_peak_over_a_fixed_rim_halves_its_height)
{
  const Soup soup = surface_of_revolution({{0, 1}, {1, 0}}, 6);
  const Surface graph = surface_of(soup);
  const std::size_t peak = soup.points.size() - 1;
  for (std::size_t steps : {1, 2, 5}) {
    const std::vector<Vector> points = smoothed_points(graph, steps);
    const Vector height = points[peak] - (points[0] + points[3]) / 2;
    const Vector old_height = graph.points[peak] - (graph.points[0] + graph.points[3]) / 2;
    BOOST_TEST((height * double(1 << steps) - old_height).norm() < 1e-14);
    for (std::size_t v = 0; v < peak; ++v)
      BOOST_TEST((points[v] == graph.points[v]));
  }
}

BOOST_AUTO_TEST_CASE(an_octahedron_shrinks_to_half_its_size_in_each_step)
{
  const Soup soup = surface_of_revolution({{-1, 0}, {0, 1}, {1, 0}}, 4);
  const Surface graph = surface_of(soup);
  const std::vector<Vector> points = smoothed_points(graph, 3);
  for (std::size_t v = 0; v < 6; ++v)
    BOOST_TEST((points[v] - graph.points[v] / 8).norm() < 1e-15);
}

BOOST_AUTO_TEST_CASE(all_vertices_move_at_once_half_the_way_to_the_mean_of_their_neighbors)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const std::vector<Soup> shapes = {plate(5, 4), sphere(1), torus(2, 0.7, 6, 5),
                                        surface_of_revolution({{0, 0}, {1, 1}, {2, 1}}, 8)};
      const Soup soup = displaced(shapes[seed % shapes.size()], 0.3, random);
      const Surface graph = surface_of(soup);
      const std::size_t steps = 1 + seed % 3;
      const std::vector<Vector> points = smoothed_points(graph, steps);
      const std::vector<Vector> expected = smoothed_by_vertex(soup, graph.points, steps);
      for (std::size_t v = 0; v < points.size(); ++v)
        BOOST_TEST((points[v] - expected[v]).norm() < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_vertex_without_a_face_stays)
{
  Soup soup = sphere(0);
  soup.points.emplace_back(5, 5, 5);
  const Surface graph = surface_of(soup);
  BOOST_TEST((smoothed_points(graph, 2).back() == graph.points.back()));
}

BOOST_AUTO_TEST_SUITE_END()
