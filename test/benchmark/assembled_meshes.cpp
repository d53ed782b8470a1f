// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../benchmark/assembled_meshes.h"
#include "test_labels.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(assembled_meshes)

using namespace segmentation_benchmark;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace tt = boost::test_tools;

namespace {

Mesh benchmark_mesh(const test_meshes::Soup& soup)
{
  Mesh mesh;
  CGAL::copy_face_graph(test_meshes::mesh_of(soup), mesh);
  return mesh;
}

Mesh torus_of_4000_faces() { return benchmark_mesh(test_meshes::torus(1, 0.4, 50, 40)); }

Labels halves(const Mesh& mesh)
{
  Labels labels;
  for (Mesh::Face_index f : mesh.faces())
    labels.push_back(centroid(mesh, f).x() > 0 ? 1 : 0);
  return labels;
}

Labels random_labels(const Mesh& mesh, std::size_t n, Uniform_random& random)
{
  Labels labels(mesh.number_of_faces());
  std::generate(labels.begin(), labels.end(), [&] { return random.below(n); });
  return labels;
}

Labels components_of(const Mesh& mesh)
{
  Labels labels(mesh.number_of_faces());
  PMP::connected_components(mesh, CGAL::make_property_map(labels));
  return contiguous(labels);
}

Labels first_labels(const Labels& labels, std::size_t n)
{ return Labels(labels.begin(), labels.begin() + static_cast<std::ptrdiff_t>(n)); }

std::vector<std::size_t> numbers_of_faces(const Labels& labels)
{
  std::vector<std::size_t> result(number_of_segments(labels), 0);
  for (std::size_t label : labels)
    ++result[label];
  return result;
}

// The vertices of a face, in their order from its half-edge on.
std::vector<Kernel::Point_3> corners(const Mesh& mesh, Mesh::Face_index f)
{
  std::vector<Kernel::Point_3> result;
  for (Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    result.push_back(mesh.point(v));
  return result;
}

bool is_same_triangle(std::vector<Kernel::Point_3> a, const std::vector<Kernel::Point_3>& b)
{
  const auto is_near = [](const Kernel::Point_3& p, const Kernel::Point_3& q)
  { return CGAL::squared_distance(p, q) < 1e-24; };
  for (int turn = 0; turn < 3; ++turn) {
    std::rotate(a.begin(), a.begin() + 1, a.end());
    if (std::equal(a.begin(), a.end(), b.begin(), is_near))
      return true;
  }
  return false;
}

void check_is_closed_manifold(const Mesh& mesh)
{
  BOOST_TEST(CGAL::is_valid_polygon_mesh(mesh));
  BOOST_TEST(CGAL::is_triangle_mesh(mesh));
  BOOST_TEST(CGAL::is_closed(mesh));
}

} // namespace

BOOST_AUTO_TEST_CASE(each_set_is_a_closed_component)
{
  const Mesh mesh = torus_of_4000_faces();
  const Labels sets = component_labels(mesh, halves(mesh), 1);
  BOOST_TEST(number_of_segments(sets) > 30u);
  BOOST_TEST(number_of_segments(sets) < 60u);
  for (const std::string& name : assembly_names())
    BOOST_TEST_CONTEXT(name) {
      const Mesh result = assembled(name, mesh, halves(mesh), 1).mesh;
      check_is_closed_manifold(result);
      const Labels components = components_of(result);
      BOOST_TEST(number_of_segments(components) == number_of_segments(sets));
      BOOST_TEST(first_labels(components, sets.size()) == sets, tt::per_element());
    }
}

BOOST_AUTO_TEST_CASE(first_faces_are_scaled_about_the_centroid_of_their_set)
{
  const Mesh mesh = torus_of_4000_faces();
  const Labels sets = component_labels(mesh, halves(mesh), 1);
  std::vector<Kernel::Vector_3> sums(number_of_segments(sets), CGAL::NULL_VECTOR);
  for (Mesh::Face_index f : mesh.faces())
    for (const Kernel::Point_3& p : corners(mesh, f))
      sums[sets[f]] += p - CGAL::ORIGIN;
  const std::vector<std::size_t> faces = numbers_of_faces(sets);
  for (double scale : {0.5, 1., 1.01}) {
    const Mesh result = assembled_from(sets, mesh, scale);
    std::size_t same = 0;
    for (Mesh::Face_index f : mesh.faces()) {
      const Kernel::Point_3 center = CGAL::ORIGIN + sums[sets[f]] / (3. * double(faces[sets[f]]));
      std::vector<Kernel::Point_3> expected;
      for (const Kernel::Point_3& p : corners(mesh, f))
        expected.push_back(center + scale * (p - center));
      same += is_same_triangle(corners(result, f), expected);
    }
    BOOST_TEST(same == mesh.number_of_faces());
  }
}

// On a convex surface: a fan over a saddle may lie outside.
BOOST_AUTO_TEST_CASE(caps_are_oriented_as_the_mesh)
{
  const Mesh mesh = benchmark_mesh(test_meshes::sphere(4));
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    Mesh result = assembled("gaps", mesh, halves(mesh), seed).mesh;
    const Labels components = components_of(result);
    double all = 0;
    for (std::size_t component = 0; component < number_of_segments(components); ++component) {
      Mesh part;
      CGAL::copy_face_graph(
        CGAL::Face_filtered_graph<Mesh>(result, component, CGAL::make_property_map(components)),
        part);
      BOOST_TEST(PMP::volume(part) > 0);
      all += PMP::volume(part);
    }
    BOOST_TEST(all < PMP::volume(mesh));
  }
}

// Sets that touch themselves at vertices, and loops within loops.
BOOST_AUTO_TEST_CASE(any_sets_are_closed)
{
  Uniform_random random(7);
  for (const Mesh& mesh : {torus_of_4000_faces(), benchmark_mesh(test_meshes::sphere(3)),
                           benchmark_mesh(test_meshes::plate(20, 20))})
    for (std::size_t n = 1; n < 5; ++n) {
      const Labels labels = random_labels(mesh, n, random);
      const Labels sets = overlay(mesh, labels, labels);
      const Mesh result = assembled_from(sets, mesh, 0.9);
      check_is_closed_manifold(result);
      BOOST_TEST(first_labels(components_of(result), sets.size()) == contiguous(sets),
                 tt::per_element());
    }
}

// A ring of squares that is shut only by a vertex becomes a sphere: it has one border loop, which
// visits two vertices at that place.
BOOST_AUTO_TEST_CASE(loop_visits_a_place_twice)
{
  const Mesh mesh = benchmark_mesh(test_meshes::plate(3, 3));
  const Labels squares = {0, 0, 0, 0, 1, 0, 2, 0, 0};
  Labels sets;
  for (std::size_t set : squares)
    sets.insert(sets.end(), 2, set);
  const Mesh result = assembled_from(sets, mesh, 1);
  check_is_closed_manifold(result);
  BOOST_TEST(number_of_segments(components_of(result)) == 3u);
  BOOST_TEST(result.number_of_vertices() + result.number_of_faces() ==
             result.number_of_edges() + 3 * 2);
  BOOST_TEST(result.number_of_vertices() == 17u + 5 + 5); // the ring and two squares
}

BOOST_AUTO_TEST_CASE(small_sets_join_a_neighbor)
{
  const Mesh mesh = benchmark_mesh(test_meshes::plate(4, 1));
  const Labels sets = {0, 0, 0, 1, 2, 2, 2, 2}; // in a row, each next to the one before
  BOOST_TEST(Joiner_of_small_sets(mesh, sets)(1) == sets, tt::per_element());
  BOOST_TEST(Joiner_of_small_sets(mesh, sets)(4) == (Labels{0, 0, 0, 0, 1, 1, 1, 1}),
             tt::per_element());
  BOOST_TEST(Joiner_of_small_sets(mesh, sets)(100) == Labels(8, 0), tt::per_element());

  Uniform_random random(3);
  const Mesh torus = torus_of_4000_faces();
  const Labels labels = random_labels(torus, 3, random);
  const Labels pieces = overlay(torus, labels, labels);
  const Labels joined = Joiner_of_small_sets(torus, pieces)(20);
  const std::vector<std::size_t> faces = numbers_of_faces(joined);
  BOOST_TEST(*std::min_element(faces.begin(), faces.end()) >= 20u);
  BOOST_TEST(number_of_segments(joined) > 10u);
  BOOST_TEST(contiguous(overlay(torus, joined, joined)) == joined, tt::per_element());
  BOOST_TEST(contiguous(overlay(torus, joined, pieces)) == contiguous(pieces), tt::per_element());
}

// A component of the mesh that has no center is a set of its own, however small.
BOOST_AUTO_TEST_CASE(whole_components_stay)
{
  Mesh mesh = torus_of_4000_faces();
  const std::size_t faces = mesh.number_of_faces();
  CGAL::copy_face_graph(benchmark_mesh(test_meshes::plate(1, 1)), mesh);
  const Labels of_cells = cells(mesh, {Mesh::Face_index(0), Mesh::Face_index(1000)});
  BOOST_TEST(std::count(of_cells.begin(), of_cells.end(), 2u) == 2);
  const Labels sets = component_labels(mesh, Labels(mesh.number_of_faces(), 0), 1);
  BOOST_TEST(sets[faces] == sets[faces + 1]);
  BOOST_TEST(std::count(sets.begin(), sets.end(), sets[faces]) == 2);
  check_is_closed_manifold(assembled_from(sets, mesh, 1.01));
}

BOOST_AUTO_TEST_CASE(centers_are_different_faces)
{
  const Mesh mesh = benchmark_mesh(test_meshes::plate(5, 5));
  Uniform_random random(1);
  std::vector<Mesh::Face_index> faces = random_faces(mesh, 100, random);
  BOOST_TEST(faces.size() == 50u);
  std::sort(faces.begin(), faces.end());
  BOOST_TEST((std::unique(faces.begin(), faces.end()) == faces.end()));
  BOOST_TEST(random_faces(mesh, 30, random).size() == 30u);
}

BOOST_AUTO_TEST_CASE(only_faces_of_the_mesh_are_judged)
{
  const Mesh mesh = torus_of_4000_faces();
  const Retriangulated_mesh result = assembled("intersecting", mesh, halves(mesh), 1);
  BOOST_TEST(result.mesh.number_of_faces() > mesh.number_of_faces());
  Labels labels = halves(mesh);
  labels.resize(result.mesh.number_of_faces(), 2);
  BOOST_TEST(carried_back(result, labels) == contiguous(halves(mesh)), tt::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
