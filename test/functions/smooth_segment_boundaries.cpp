// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Segmented_mesh/segment_boundaries.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(smooth_segment_boundaries)

namespace tt = boost::test_tools;
using namespace test_meshes;
using CGAL::Spectral_segmentation::internal::connected_components;
using CGAL::Spectral_segmentation::internal::split;

namespace {

constexpr std::size_t width = 12; // the side of a square plate

// Labels of the faces of the plate by the square (x, y) that they lie in.
template <class Label_of_square>
Labels labels_of_squares(const Label_of_square& label)
{
  Labels labels;
  for (std::size_t y = 0; y < width; ++y)
    for (std::size_t x = 0; x < width; ++x)
      labels.insert(labels.end(), 2, label(x, y));
  return labels;
}

// The lower right face of a square is the first, the upper left one the second.
std::size_t face_of_square(std::size_t x, std::size_t y, std::size_t i)
{ return 2 * (width * y + x) + i; }

auto ids_of(Labels& labels, const Mesh& mesh)
{ return boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh)); }

Labels smoothed(const Soup& soup, Labels labels)
{
  const Mesh mesh = mesh_of(soup);
  const Labels given = labels;
  const std::size_t changes = CGAL::smooth_segment_boundaries(mesh, ids_of(labels, mesh));
  BOOST_TEST((changes == 0) == (labels == given));
  return labels;
}

Labels smoothed_on_plate(const Labels& labels) { return smoothed(plate(width, width), labels); }

// Splits a mesh into connected segments, which grow at random.
Labels random_segments(const Surface& graph, std::size_t number, Random& random)
{
  const std::size_t n = graph.number_of_faces();
  Labels labels(n, number);
  for (std::size_t i = 0; i < number;) {
    std::size_t& label = labels[random() % n];
    if (label == number)
      label = i++;
  }
  while (std::count(labels.begin(), labels.end(), number) > 0) {
    const Index h = static_cast<Index>(random() % (3 * n));
    std::size_t& label = labels[graph.neighbor(h)];
    if (label == number)
      label = labels[h / 3];
  }
  return labels;
}

std::set<std::size_t> values(const Labels& labels) { return {labels.begin(), labels.end()}; }

bool are_connected(const Surface& graph, const Labels& labels, std::size_t number)
{
  const std::vector<Surface> segments = split(graph, labels, number);
  return std::all_of(segments.begin(), segments.end(), [](const Surface& segment)
    { return connected_components(segment).number == 1; });
}

} // namespace

BOOST_AUTO_TEST_CASE(straight_boundaries_stay)
{
  for (const Labels& labels :
       {labels_of_squares([](std::size_t x, std::size_t) { return x / 6; }),
        labels_of_squares([](std::size_t, std::size_t y) { return y / 6; }),
        labels_of_squares([](std::size_t x, std::size_t) { return x / 4; }),
        labels_of_squares([](std::size_t, std::size_t y) { return y / 3; })})
    BOOST_TEST(smoothed_on_plate(labels) == labels, tt::per_element());

  Labels diagonal; // along the edges that cut the squares in two
  for (std::size_t y = 0; y < width; ++y)
    for (std::size_t x = 0; x < width; ++x)
      diagonal.insert(diagonal.end(), {std::size_t(x < y), std::size_t(x <= y)});
  BOOST_TEST(smoothed_on_plate(diagonal) == diagonal, tt::per_element());

  // Around a ball.
  const Soup ball = surface_of_revolution(
    {{-1, 0}, {-0.8, 0.6}, {-0.6, 0.8}, {-0.3, 0.9}, {0, 1}, {0.3, 0.9}, {0.6, 0.8}, {0.8, 0.6},
     {1, 0}}, 10);
  const auto hemispheres =
    by_place<std::size_t>(ball, [](const Point& p) { return p.z() > 0; });
  BOOST_TEST(smoothed(ball, hemispheres) == hemispheres, tt::per_element());
}

BOOST_AUTO_TEST_CASE(teeth_of_one_face_are_removed)
{
  const Labels straight =
    labels_of_squares([](std::size_t x, std::size_t) { return std::size_t(x >= 6); });
  for (unsigned seed = 1; seed <= 50; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Labels labels = straight;
      for (std::size_t y = 2 + random() % 3; y + 2 < width; y += 3 + random() % 3)
        if (random() % 2)
          labels[face_of_square(6, y, 1)] = 0; // to the right
        else
          labels[face_of_square(5, y, 0)] = 1; // to the left
      BOOST_REQUIRE(labels != straight);
      BOOST_TEST(smoothed_on_plate(labels) == straight, tt::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(a_jagged_boundary_moves_by_a_few_faces)
{
  for (unsigned seed = 1; seed <= 50; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      // Between rows 5 and 6, up to a row higher at each face.
      Labels labels =
        labels_of_squares([](std::size_t, std::size_t y) { return std::size_t(y >= 6); });
      for (std::size_t x = 0; x < width; ++x)
        for (std::size_t i = 0; i < random() % 3; ++i)
          labels[face_of_square(x, 6, i)] = 0;
      const Labels result = smoothed_on_plate(labels);
      for (std::size_t x = 0; x < width; ++x)
        for (std::size_t y : {0, 1, 2, 3, 4, 8, 9, 10, 11})
          for (std::size_t i : {0, 1})
            BOOST_TEST(result[face_of_square(x, y, i)] == labels[face_of_square(x, y, i)]);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_strip_too_thin_for_the_opening_stays)
{
  const Labels strip = labels_of_squares(
    [](std::size_t x, std::size_t) { return std::size_t(x < 6 ? 0 : 1 + (x > 6)); });
  BOOST_TEST(smoothed_on_plate(strip) == strip, tt::per_element());
  Labels face(2 * width * width, 0);
  face[face_of_square(5, 5, 0)] = 1;
  BOOST_TEST(smoothed_on_plate(face)[face_of_square(5, 5, 0)] == 1u);
}

BOOST_AUTO_TEST_CASE(an_isthmus_stays)
{
  // Two lands of 5 x 12 squares, joined by two squares between two seas.
  const Labels labels = labels_of_squares([](std::size_t x, std::size_t y)
    { return std::size_t(x < 5 || x >= 7 || y == 6 ? 0 : 1 + (y > 6)); });
  const Surface graph = surface_of(plate(width, width));
  BOOST_REQUIRE(are_connected(graph, labels, 3));
  const Labels result = smoothed_on_plate(labels);
  BOOST_TEST(values(result) == values(labels), tt::per_element());
  BOOST_TEST(are_connected(graph, result, 3));
  for (std::size_t x : {5, 6})
    BOOST_TEST((result[face_of_square(x, 6, 0)] == 0 || result[face_of_square(x, 6, 1)] == 0));
}

BOOST_AUTO_TEST_CASE(a_spit_of_land_is_removed)
{
  // Like the isthmus, but it does not reach the other side.
  const Labels labels = labels_of_squares(
    [](std::size_t x, std::size_t y) { return std::size_t(x >= 5 && (y != 6 || x >= 9)); });
  const Labels result = smoothed_on_plate(labels);
  for (std::size_t x = 6; x < 9; ++x)
    for (std::size_t i : {0, 1})
      BOOST_TEST(result[face_of_square(x, 6, i)] == 1u);
}

BOOST_AUTO_TEST_CASE(segments_are_neither_emptied_nor_disconnected)
{
  const std::vector<Soup> shapes = {plate(12, 9), plate(40, 2), sphere(2), torus(2, 0.7, 14, 9),
                                    connected_sum(torus(2, 0.7, 9, 7), torus(2, 0.7, 7, 5)),
                                    dumbbell(11, 9)};
  std::size_t changes = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      const Soup& shape = shapes[seed % shapes.size()];
      const Surface graph = surface_of(shape);
      const std::size_t number = 1 + random() % 8;
      const Labels labels = random_segments(graph, number, random);
      BOOST_REQUIRE(are_connected(graph, labels, number));
      const Labels result = smoothed(shape, labels);
      BOOST_TEST(values(result) == values(labels), tt::per_element());
      BOOST_TEST(are_connected(graph, result, number));
      changes += result != labels;
    }
  }
  BOOST_TEST(changes > 200u);
}

BOOST_AUTO_TEST_CASE(one_segment_and_no_face_are_left_as_they_are)
{
  const Labels one(2 * width * width, 0);
  BOOST_TEST(smoothed_on_plate(one) == one, tt::per_element());
  BOOST_TEST(smoothed(Soup(), {}).empty());
}

BOOST_AUTO_TEST_CASE(segments_of_a_real_mesh_stay_connected_and_boundaries_become_shorter)
{
  const Mesh mesh = mesh_of(read("elephant.off"));
  const Labels labels = labels_of(mesh, CGAL::parameters::default_values());
  Labels result = labels;
  const std::size_t changes = CGAL::smooth_segment_boundaries(mesh, ids_of(result, mesh));
  BOOST_TEST(changes > 0);
  const auto number_of_edges = [&mesh](Labels ids) {
    std::size_t number = 0;
    for (const auto& b : CGAL::segment_boundaries(mesh, ids_of(ids, mesh)))
      number += b.halfedges.size();
    return number;
  };
  BOOST_TEST(number_of_edges(result) + changes == number_of_edges(labels));
  BOOST_TEST(check_labels(mesh, result) == number_of(labels));
  BOOST_TEST(CGAL::smooth_segment_boundaries(mesh, ids_of(result, mesh)) == 0);
}

// A quadrilateral between triangles keeps its id, whatever its neighbors are.
BOOST_AUTO_TEST_CASE(faces_of_other_sizes_keep_their_ids)
{
  CGAL::Surface_mesh<Point> mesh;
  const auto v = [&](double x, double y) { return mesh.add_vertex(Point(x, y, 0)); };
  const auto a = v(0, 0), b = v(1, 0), c = v(1, 1), d = v(0, 1);
  mesh.add_face(a, b, c, d);
  mesh.add_face(b, a, v(.5, -1));
  mesh.add_face(c, b, v(2, .5));
  mesh.add_face(d, c, v(.5, 2));
  Labels labels = {0, 0, 1, 1};
  BOOST_TEST(CGAL::smooth_segment_boundaries(mesh, ids_of(labels, mesh)) == 0);
  BOOST_TEST((labels == Labels{0, 0, 1, 1}));
}

BOOST_AUTO_TEST_SUITE_END()
