// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/segment_spectral_recursive.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

// Components that bound a cavity, or are the second wall of another component.
BOOST_AUTO_TEST_SUITE(component_walls)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

namespace {

const Soup& ball() { static const Soup soup = sphere(3); return soup; }

// Returns a closed surface moved inward along its normals.
Soup offset_inward(Soup soup, double depth)
{
  std::vector<CGAL::Vector_3<Kernel> > normals(soup.points.size(), CGAL::NULL_VECTOR);
  for (const auto& t : soup.triangles)
    for (std::size_t v : t)
      normals[v] = normals[v] + CGAL::normal(soup.points[t[0]], soup.points[t[1]],
                                             soup.points[t[2]]);
  for (std::size_t v = 0; v < normals.size(); ++v)
    soup.points[v] = soup.points[v] - depth / std::sqrt(normals[v].squared_length()) * normals[v];
  return soup;
}

Labels labels_of_default(const Soup& soup)
{ return labels_of(mesh_of(soup), parameters::default_values()); }

Labels range(const Labels& labels, std::size_t first, std::size_t end)
{
  return Labels(labels.begin() + std::ptrdiff_t(first), labels.begin() + std::ptrdiff_t(end));
}

// Returns the fraction of the faces whose labels differ.
double difference(const Labels& a, const Labels& b)
{
  std::size_t result = 0;
  for (std::size_t f = 0; f < a.size(); ++f)
    result += a[f] != b[f];
  return static_cast<double>(result) / static_cast<double>(a.size());
}

} // namespace

BOOST_AUTO_TEST_CASE(both_walls_of_a_hollow_body_have_the_parts_of_the_solid_body)
{
  const Soup soup = dumbbell(24, 20);
  const std::size_t n = soup.triangles.size();
  const Labels alone = labels_of_default(soup);
  BOOST_TEST(number_of(alone) >= 2u);
  for (double depth : {0.01, 0.05}) {
    const Soup inner = offset_inward(soup, depth);
    const Soup inward = turned_inside_out(inner);
    for (const Soup& hollow : {disjoint_union(soup, inward), disjoint_union(soup, inner),
                               turned_inside_out(disjoint_union(soup, inward))}) {
      const Labels labels = labels_of_default(hollow);
      BOOST_TEST(range(labels, 0, n) == alone, boost::test_tools::per_element());
      BOOST_TEST(difference(range(labels, n, 2 * n), alone) < 0.02);
    }
    // The outer wall is found in any order.
    const Labels labels = labels_of_default(disjoint_union(inward, soup));
    BOOST_TEST(number_of(labels) == number_of(alone));
  }
}

// Only the outer wall is searched, whether it is coarsened or not.
BOOST_AUTO_TEST_CASE(walls_follow_the_parts_that_features_make)
{
  const std::size_t n = ball().triangles.size();
  const auto segments = [](const Soup& soup, std::size_t number_of_coarse_faces) {
    const Mesh mesh = mesh_of(soup);
    const auto is_above = [&](Mesh::Face_index f) {
      double z = 0;
      for (Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
        z += mesh.point(v).z();
      return int(z > 0);
    };
    return labels_of(mesh, parameters::number_of_coarse_faces(number_of_coarse_faces)
      .face_feature_map(boost::make_function_property_map<Mesh::Face_index>(is_above)));
  };
  const Soup hollow = disjoint_union(ball(), turned_inside_out(offset_inward(ball(), 0.05)));
  for (std::size_t number_of_coarse_faces : {0, 300, 100000}) {
    const Labels labels = segments(hollow, number_of_coarse_faces);
    const Labels alone = segments(ball(), number_of_coarse_faces);
    BOOST_TEST(number_of(alone) == 2u);
    BOOST_TEST(number_of(labels) == 2u);
    BOOST_TEST(difference(range(labels, 0, n), alone) < 0.02);
    BOOST_TEST(difference(range(labels, n, 2 * n), alone) < 0.02);
  }
}

BOOST_AUTO_TEST_CASE(each_node_of_a_hollow_body_is_connected_within_each_wall)
{
  const Soup soup = read("elephant.off");
  double extent = 0;
  for (const Point& p : soup.points)
    extent = (std::max)(extent, std::abs(p.x()));
  const Mesh mesh =
    mesh_of(disjoint_union(soup, turned_inside_out(offset_inward(soup, 0.01 * extent))));
  const std::size_t n = soup.triangles.size();
  const Segmentation_hierarchy hierarchy =
    hierarchy_of(mesh, parameters::number_of_segments(40));
  BOOST_TEST(number_of(run_labels(hierarchy)) == 40u);
  BOOST_TEST(hierarchy.number_of_roots() == 1u);
  for (std::size_t node = 0; node < hierarchy.number_of_nodes(); ++node) {
    Labels labels; // 0 and 1 in the walls of the node; other faces have labels of their own
    for (std::size_t f = 0; f < 2 * n; ++f)
      labels.push_back(2 + f);
    bool is_in_wall[2] = {false, false};
    double area = 0;
    for (std::size_t f : hierarchy.faces(node)) {
      labels[f] = f < n ? 0 : 1;
      is_in_wall[labels[f]] = true;
      area += CGAL::Polygon_mesh_processing::face_area(Mesh::Face_index(unsigned(f)), mesh);
    }
    BOOST_TEST(is_in_wall[0]);
    BOOST_TEST(hierarchy.node(node).area == area, boost::test_tools::tolerance(1e-5));
    if (!hierarchy.node(node).is_leaf())
      BOOST_TEST(hierarchy.node(hierarchy.node(node).children[0]).area <=
                 hierarchy.node(hierarchy.node(node).children[1]).area * (1 + 1e-6));
    const std::size_t number_of_pieces =
      number_of_connected_pieces(mesh, labels) - (2 * n - hierarchy.number_of_faces(node));
    BOOST_TEST(number_of_pieces == std::size_t(is_in_wall[0]) + std::size_t(is_in_wall[1]));
  }
}

BOOST_AUTO_TEST_CASE(a_cavity_belongs_to_the_part_around_it)
{
  // Two balls and their neck, with a bubble in one ball, which is small, and turned inward
  const Soup soup = dumbbell(24, 20);
  const Soup bubble = moved(turned_inside_out(scaled(ball(), 0.3)), 0, 0, 1.3);
  const std::size_t n = soup.triangles.size();
  const Labels labels = labels_of_default(disjoint_union(soup, bubble));
  BOOST_TEST(range(labels, 0, n) == labels_of_default(soup), boost::test_tools::per_element());
  std::size_t label_above = 0;
  for (std::size_t f = 0; f < n; ++f)
    if (soup.points[soup.triangles[f][0]].z() > 1.5)
      label_above = labels[f];
  BOOST_TEST(range(labels, n, labels.size()) == Labels(bubble.triangles.size(), label_above),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_solid_inside_of_another_component_is_no_wall)
{
  const Soup box = scaled(ball(), 2), inside = scaled(ball(), 0.7);
  // a ball in a ball
  BOOST_TEST(number_of(labels_of_default(disjoint_union(box, inside))) == 2u);
  // a ball in the cavity of a ball, as a rattle has it
  const Soup rattle = disjoint_union(box, turned_inside_out(scaled(ball(), 1.5)));
  const Labels labels = labels_of_default(disjoint_union(rattle, inside));
  BOOST_TEST(number_of(labels) == 2u);
  BOOST_TEST(number_of(range(labels, 0, rattle.triangles.size())) == 1u);
  // fish in a tank, some of which are mirrored and point inward
  const Soup fish = scaled(ball(), 0.4);
  const Soup tank = disjoint_union(
    disjoint_union(box, moved(fish, 0.8, 0, 0)), moved(turned_inside_out(fish), -0.8, 0, 0));
  BOOST_TEST(number_of(labels_of_default(tank)) == 3u);
  // an eye that looks out of a head
  const Soup head = disjoint_union(box, moved(scaled(ball(), 0.5), 1.8, 0, 0));
  BOOST_TEST(number_of(labels_of_default(head)) == 2u);
  // two balls that have the same distance along half of their areas
  BOOST_TEST(number_of(labels_of_default(
               disjoint_union(box, moved(scaled(ball(), 1.9), 0.3, 0, 0)))) == 2u);
}

BOOST_AUTO_TEST_CASE(copies_at_one_place_have_the_same_parts)
{
  const Soup soup = dumbbell(24, 20);
  const std::size_t n = soup.triangles.size();
  const Labels alone = labels_of_default(soup);
  for (double shift : {-0.001, 0.001}) {
    const Labels labels = labels_of_default(disjoint_union(soup, moved(soup, 0, shift, 0)));
    BOOST_TEST(range(labels, 0, n) == alone, boost::test_tools::per_element());
    BOOST_TEST(difference(range(labels, n, 2 * n), alone) < 0.02);
  }
}

BOOST_AUTO_TEST_CASE(levels_of_detail_have_the_parts_of_the_finest)
{
  const Soup fine = dumbbell(24, 20), coarse = dumbbell(20, 14), coarsest = dumbbell(16, 12);
  const std::size_t n = fine.triangles.size(), m = coarse.triangles.size();
  const Labels alone = labels_of_default(fine);
  const Labels first = labels_of_default(disjoint_union(fine, coarse)),
               last = labels_of_default(disjoint_union(coarse, fine)),
               three = labels_of_default(disjoint_union(disjoint_union(coarse, coarsest), fine));
  BOOST_TEST(range(first, 0, n) == alone, boost::test_tools::per_element());
  for (const Labels& labels : {first, last, three})
    BOOST_TEST(number_of(labels) == number_of(alone));
  std::size_t different = 0; // of the numbers of segments, the first face decides
  for (std::size_t f = 0; f < n; ++f)
    different += (last[m + f] == last[m]) != (alone[f] == alone[0]);
  BOOST_TEST(different == 0u);
}

BOOST_AUTO_TEST_CASE(thin_plates_on_each_other_are_no_copies)
{
  const Soup thin = transformed(ball(), [](const Point& p)
    { return Point(10 * p.x(), 10 * p.y(), 0.02 * p.z()); });
  BOOST_TEST(number_of(labels_of_default(disjoint_union(thin, moved(thin, 0, 0, 0.05)))) == 2u);
}

BOOST_AUTO_TEST_CASE(open_surfaces_beside_each_other_are_no_walls)
{
  // a stack of plates, and an open shell around a body
  const Soup sheet = plate(10, 10);
  const Soup stack = disjoint_union(disjoint_union(sheet, moved(sheet, 0, 0, 0.2)),
                                    moved(sheet, 0, 0, 0.4));
  BOOST_TEST(number_of(labels_of_default(stack)) == 3u);
  Soup shell = scaled(ball(), 1.03);
  shell.triangles.resize(shell.triangles.size() * 9 / 10);
  BOOST_TEST(number_of(labels_of_default(disjoint_union(ball(), shell))) == 2u);
}

BOOST_AUTO_TEST_CASE(walls_are_components_if_these_are_kept_separate_or_constrained)
{
  const Soup soup = dumbbell(24, 20);
  const std::size_t n = soup.triangles.size();
  const Mesh mesh = mesh_of(disjoint_union(soup, turned_inside_out(offset_inward(soup, 0.02))));
  for_both_methods([&](const auto& np) {
    const Labels labels = labels_of(mesh, np.keep_components_separate(true));
    for (std::size_t f = 0; f < n; ++f)
      for (std::size_t g : {std::size_t(0), n - 1})
        BOOST_TEST(labels[g] != labels[n + f]);
  });
  const Labels without = labels_of(mesh, parameters::default_values());
  const auto seeds = boost::make_function_property_map<Mesh::Face_index, int>(
    [n](Mesh::Face_index f) { return std::size_t(f) == n ? 1 : std::size_t(f) == 0 ? 0 : -1; });
  const Labels labels = labels_of(mesh, parameters::face_seed_map(seeds));
  BOOST_TEST(labels[0] != labels[n]);
  BOOST_TEST(range(labels, 0, n) == range(without, 0, n), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(walls_of_a_body_stay_walls_if_another_body_is_constrained)
{
  const Soup body = dumbbell(24, 20);
  const std::size_t n = body.triangles.size();
  const Soup hollow = disjoint_union(body, turned_inside_out(offset_inward(body, 0.01)));
  const Mesh mesh = mesh_of(disjoint_union(hollow, moved(body, 20, 0, 0)));
  const auto seeds = boost::make_function_property_map<Mesh::Face_index, int>(
    [n](Mesh::Face_index f)
    { return std::size_t(f) == 2 * n ? 1 : std::size_t(f) == 3 * n - 1 ? 2 : -1; });
  const Labels labels = labels_of(mesh, parameters::face_seed_map(seeds));
  BOOST_TEST(labels[2 * n] != labels[3 * n - 1]);
  BOOST_TEST(difference(range(labels, n, 2 * n), range(labels, 0, n)) < 0.02);
}

BOOST_AUTO_TEST_CASE(numbers_of_segments_of_walls_are_met)
{
  const Soup soup = dumbbell(8, 8);
  const Mesh mesh = mesh_of(disjoint_union(soup, turned_inside_out(offset_inward(soup, 0.02))));
  const std::size_t n = soup.triangles.size();
  for (std::size_t number : {std::size_t(1), std::size_t(7), n, n + 1, 2 * n})
    BOOST_TEST(number_of(labels_of(mesh, parameters::number_of_segments(number))) == number);
}

BOOST_AUTO_TEST_SUITE_END()
