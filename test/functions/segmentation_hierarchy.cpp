// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(segmentation_hierarchy)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

namespace {

typedef Segmentation_hierarchy::Cut_state Cut_state;
typedef Mesh::Face_index Face;
typedef Mesh::Halfedge_index Halfedge;

const double infinity = std::numeric_limits<double>::infinity();
const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

// Two of them small, one with two components.
std::vector<Mesh> several_meshes()
{
  return {mesh_of(doll()), mesh_of(read("cactus.off")),
          mesh_of(disjoint_union(dumbbell(14, 10), torus(3, 1, 20, 10)))};
}

// Some of the thresholds at which the labels change, values beside them, and others.
std::set<double> interesting_thresholds(const Segmentation_hierarchy& hierarchy, double smallest)
{
  std::set<double> result = {smallest, 0.5, 0.6, 0.9, 2, infinity};
  for (std::size_t i = 0; i < hierarchy.number_of_nodes(); i += 3)
    if (hierarchy.node(i).cut_state == Cut_state::CUT)
      result.insert(
        {hierarchy.node(i).salience, std::nextafter(hierarchy.node(i).salience, infinity)});
  return result;
}

std::vector<Face> faces_of(const Segmentation_hierarchy& hierarchy, std::size_t i)
{
  std::vector<Face> result;
  for (auto f : hierarchy.faces(i))
    result.push_back(Face(f));
  return result;
}

std::multiset<Face> union_of(const std::vector<Face>& a, const std::vector<Face>& b)
{
  std::multiset<Face> result(a.begin(), a.end());
  result.insert(b.begin(), b.end());
  return result;
}

// 4 sqrt(l1 l2), from the vertices of the edges between two sets of faces.
double spread_of_cut(const Mesh& mesh, const std::vector<Face>& q, const std::vector<Face>& rest)
{
  const std::set<Face> in_rest(rest.begin(), rest.end());
  std::set<Mesh::Vertex_index> along_cut;
  for (Face f : q)
    for (Halfedge h : halfedges_around_face(halfedge(f, mesh), mesh))
      if (in_rest.count(face(opposite(h, mesh), mesh)))
        along_cut.insert({source(h, mesh), target(h, mesh)});
  const auto point = [&](Mesh::Vertex_index v)
  { return Eigen::Vector3d(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()); };
  Eigen::Vector3d mean(0, 0, 0);
  for (Mesh::Vertex_index v : along_cut)
    mean += point(v) / double(along_cut.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (Mesh::Vertex_index v : along_cut)
    covariance += (point(v) - mean) * (point(v) - mean).transpose() / double(along_cut.size());
  const Eigen::Vector3d values =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues();
  return 4 * std::sqrt((std::max)(values[1], 0.) * values[2]);
}

// Nodes are a forest of sets of faces, with their areas.
void check_nodes(const Segmentation_hierarchy& hierarchy, const Mesh& mesh)
{
  const auto tolerance = boost::test_tools::tolerance(1e-9);
  BOOST_TEST(hierarchy.number_of_faces() == num_faces(mesh));
  std::multiset<Face> faces_of_roots;
  for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
    const Segmentation_hierarchy::Node& n = hierarchy.node(i);
    const std::vector<Face> part = faces_of(hierarchy, i);
    BOOST_TEST(part.size() == hierarchy.number_of_faces(i));
    BOOST_TEST(n.area == PMP::area(part, mesh), tolerance);
    BOOST_TEST((n.parent == Segmentation_hierarchy::null_node) ==
               (i < hierarchy.number_of_roots()));
    if (i < hierarchy.number_of_roots())
      faces_of_roots.insert(part.begin(), part.end());
    if (n.is_leaf()) {
      BOOST_TEST(n.children[0] == Segmentation_hierarchy::null_node);
      BOOST_TEST(n.children[1] == Segmentation_hierarchy::null_node);
      continue;
    }
    for (std::size_t child : n.children)
      BOOST_TEST_REQUIRE(hierarchy.node(child).parent == i);
    BOOST_TEST((union_of(faces_of(hierarchy, n.children[0]),
                         faces_of(hierarchy, n.children[1])) ==
                std::multiset<Face>(part.begin(), part.end())));
    BOOST_TEST(hierarchy.node(n.children[0]).area <= hierarchy.node(n.children[1]).area);
  }
  const auto all = faces(mesh);
  BOOST_TEST((faces_of_roots == std::multiset<Face>(all.begin(), all.end())));
}

// Each number gives that many segments: the segments of one fewer, with one of them cut in two.
void check_labels_of_numbers(const Segmentation_hierarchy& hierarchy)
{
  Labels coarse;
  for (std::size_t n = hierarchy.number_of_roots(); n <= hierarchy.number_of_segments(); ++n) {
    const Labels labels = labels_of_number(hierarchy, n);
    check_numbering(labels);
    BOOST_TEST(number_of(labels) == n);
    std::set<std::pair<std::size_t, std::size_t> > pairs;
    for (std::size_t f = 0; f < coarse.size(); ++f)
      pairs.insert({coarse[f], labels[f]});
    if (!coarse.empty())
      BOOST_TEST(pairs.size() == n);
    coarse = labels;
  }
}

Labels joined(Labels labels, std::size_t a, std::size_t b)
{
  std::replace(labels.begin(), labels.end(), b, a);
  return labels;
}

bool are_same_parts(const Labels& a, const Labels& b)
{
  std::set<std::pair<std::size_t, std::size_t> > pairs;
  for (std::size_t f = 0; f < a.size(); ++f)
    pairs.insert({a[f], b[f]});
  return a.size() == b.size() &&
         pairs.size() == std::set<std::size_t>(a.begin(), a.end()).size() &&
         pairs.size() == std::set<std::size_t>(b.begin(), b.end()).size();
}

// The hierarchy of a run on the faces of a node.
template <class NamedParameters>
Segmentation_hierarchy hierarchy_of_node(const Segmentation_hierarchy& hierarchy, std::size_t i,
                                         const Mesh& mesh, const NamedParameters& np)
{
  const CGAL::Face_filtered_graph<Mesh> part(mesh, faces_of(hierarchy, i));
  Labels labels;
  Segmentation_hierarchy result;
  CGAL::segment_spectral_recursive(part, map_to(labels, mesh), np.hierarchy(result));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_hierarchy_without_a_run_is_empty)
{
  const Segmentation_hierarchy hierarchy;
  BOOST_TEST(hierarchy.number_of_nodes() == 0);
  BOOST_TEST(hierarchy.number_of_segments() == 0);
  BOOST_TEST(run_labels(hierarchy).empty());
}

BOOST_AUTO_TEST_CASE(each_cut_has_the_factors_of_its_salience)
{
  const auto tolerance = boost::test_tools::tolerance(1e-6);
  for (const Mesh& mesh : several_meshes()) {
    const Segmentation_hierarchy hierarchy = hierarchy_of(
      mesh, parameters::zhang_liu_2005().salience_threshold(0.3).salience_weights(0.2, 0.3, 0.5));
    for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
      const Segmentation_hierarchy::Node& n = hierarchy.node(i);
      BOOST_TEST(n.salience == 0.2 * n.factors.size + 0.3 * n.factors.cut_strength +
                                 0.5 * n.factors.protrusiveness, tolerance);
      BOOST_TEST(n.factors.cut_strength >= 0);
      BOOST_TEST(n.factors.cut_strength <= 1);
      if (n.is_leaf())
        continue;
      const double area = hierarchy.node(n.children[0]).area;
      BOOST_TEST(n.factors.size == area / n.area, tolerance);
      const double spread =
        spread_of_cut(mesh, faces_of(hierarchy, n.children[0]), faces_of(hierarchy, n.children[1]));
      BOOST_TEST(std::abs(n.factors.protrusiveness - (1 - spread / area)) < 1e-6);
    }
  }
}

BOOST_AUTO_TEST_CASE(labels_for_any_number_and_threshold_equal_a_fresh_run)
{
  const double smallest = 0.4;
  const auto np = parameters::zhang_liu_2005();
  for (const Mesh& mesh : several_meshes()) {
    Segmentation_hierarchy hierarchy;
    const Labels labels =
      labels_of(mesh, np.salience_threshold(smallest).hierarchy(hierarchy));
    BOOST_TEST(run_labels(hierarchy) == labels, boost::test_tools::per_element());

    for (std::size_t n = 1; n <= hierarchy.number_of_segments() + 1; ++n)
      BOOST_TEST(labels_above(hierarchy, smallest, n) ==
                 labels_of(mesh, np.salience_threshold(smallest).maximum_number_of_segments(n)),
                 boost::test_tools::per_element());
    for (double threshold : interesting_thresholds(hierarchy, smallest))
      for (std::size_t n : {std::size_t(4), unlimited})
        BOOST_TEST(labels_above(hierarchy, threshold, n) ==
                   labels_of(mesh, np.salience_threshold(threshold)
                                     .maximum_number_of_segments(n)),
                   boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_run_with_a_maximum_gives_labels_up_to_it)
{
  const Mesh mesh = mesh_of(doll());
  const auto np = parameters::zhang_liu_2005().salience_threshold(-infinity);
  const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, np.maximum_number_of_segments(6));
  for (std::size_t n = 1; n <= 6; ++n)
    BOOST_TEST(labels_above(hierarchy, -infinity, n) ==
                 labels_of(mesh, np.maximum_number_of_segments(n)),
               boost::test_tools::per_element());
  BOOST_CHECK_THROW(labels_above(hierarchy, -infinity, 7), std::out_of_range);
  BOOST_CHECK_THROW(labels_above(hierarchy, -infinity, unlimited), std::out_of_range);
  // No cut reaches this threshold, so the run did not end too early for it.
  BOOST_TEST(labels_above(hierarchy, infinity, unlimited) == Labels(num_faces(mesh), 0),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_run_with_a_threshold_gives_no_labels_below_it)
{
  const Mesh mesh = mesh_of(doll());
  const Segmentation_hierarchy hierarchy =
    hierarchy_of(mesh, parameters::zhang_liu_2005().salience_threshold(0.5));
  BOOST_CHECK_THROW(labels_above(hierarchy, 0.2, unlimited), std::out_of_range);
  BOOST_CHECK_THROW(labels_above(hierarchy, -infinity, unlimited), std::out_of_range);
  BOOST_CHECK_THROW(labels_above(hierarchy, std::nan(""), 1), std::invalid_argument);
  BOOST_TEST(labels_above(hierarchy, 0.2, 1) == Labels(num_faces(mesh), 0),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(labels_are_written_into_a_property_map)
{
  const Mesh mesh = mesh_of(doll());
  for_both_methods([&](const auto& np) {
    const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, np.salience_threshold(0.1));
    Labels written;
    const std::vector<std::size_t> nodes = hierarchy.nodes(5);
    BOOST_TEST(hierarchy.write(mesh, map_to(written, mesh), nodes) == 5);
    BOOST_TEST(written == hierarchy.labels(nodes), boost::test_tools::per_element());
    BOOST_TEST(written == labels_above(hierarchy, 0.1, 5), boost::test_tools::per_element());
    BOOST_TEST(hierarchy.nodes_above(infinity).size() == 1);
  });
}

BOOST_AUTO_TEST_CASE(labels_follow_the_face_index_map_of_the_run)
{
  const Mesh mesh = mesh_of(doll());
  const std::size_t last = num_faces(mesh) - 1;
  const auto backwards = boost::make_function_property_map<Face, std::size_t>(
    [last](Face f) { return last - f; });
  const auto of_run = parameters::face_index_map(backwards);
  for_both_methods([&](const auto& np) {
    Segmentation_hierarchy hierarchy;
    const Labels expected = labels_of(mesh, np.face_index_map(backwards).hierarchy(hierarchy));
    Labels written;
    hierarchy.write(mesh, map_to(written, mesh), hierarchy.nodes(), of_run);
    BOOST_TEST(written == expected, boost::test_tools::per_element());
    BOOST_TEST(written[last] == 0);
    std::vector<Face> part = hierarchy.faces(1, mesh, of_run);
    for (Face& f : part)
      f = Face(last - f);
    BOOST_TEST((part == faces_of(hierarchy, 1)));
  });
}

BOOST_AUTO_TEST_CASE(a_hierarchy_of_another_mesh_is_refused)
{
  const Segmentation_hierarchy hierarchy =
    hierarchy_of(mesh_of(sphere(1)), parameters::default_values());
  const Mesh other = mesh_of(sphere(2));
  Labels written;
  BOOST_CHECK_THROW(hierarchy.write(other, map_to(written, other), hierarchy.nodes()),
                    std::invalid_argument);
  BOOST_CHECK_THROW(hierarchy.faces(0, other), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_number_alone_is_exact)
{
  for (const Mesh& mesh : several_meshes())
    for_both_methods([&](const auto& np) {
      const Segmentation_hierarchy hierarchy =
        hierarchy_of(mesh, np.maximum_number_of_segments(7));
      check_labels_of_numbers(hierarchy);
      Labels written;
      const auto by_number = [&](std::size_t n)
      { return hierarchy.write(mesh, map_to(written, mesh), hierarchy.nodes(n)); };
      BOOST_TEST(by_number(0) == hierarchy.number_of_roots());
      BOOST_TEST(by_number(hierarchy.number_of_segments() - 1) ==
                 hierarchy.number_of_segments() - 1);
      BOOST_TEST(by_number(unlimited) == hierarchy.number_of_segments());
    });
  // The threshold of the run leaves fewer than half of the leaves.
  const Mesh elephant = mesh_of(read("elephant.off"));
  const Segmentation_hierarchy hierarchy = hierarchy_of(elephant, parameters::default_values());
  BOOST_TEST(number_of(run_labels(hierarchy)) < 15);
  BOOST_TEST(check_labels(elephant, labels_of_number(hierarchy, 15)) == 15);
}

BOOST_AUTO_TEST_CASE(a_convex_mesh_is_cut_only_if_a_number_is_given)
{
  const Mesh mesh = mesh_of(sphere(2));
  BOOST_TEST(hierarchy_of(mesh, parameters::salience_threshold(0)).number_of_nodes() == 1);
  BOOST_TEST(number_of(labels_of(mesh, parameters::number_of_segments(4))) == 4);
  // A sphere that is turned inside out is turned around.
  BOOST_TEST(hierarchy_of(mesh_of(turned_inside_out(sphere(2))), parameters::default_values())
               .number_of_nodes() == 1);
}

BOOST_AUTO_TEST_CASE(each_segment_is_a_node)
{
  for (const Mesh& mesh : several_meshes())
    for_both_methods([&](const auto& np) {
      const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, np.salience_threshold(0.1));
      BOOST_TEST(hierarchy.nodes() == hierarchy.nodes_above(0.1, unlimited),
                 boost::test_tools::per_element());
      for (std::size_t n : {1, 3, 6}) {
        const std::vector<std::size_t> nodes = hierarchy.nodes(n);
        const Labels labels = labels_of_number(hierarchy, n);
        BOOST_TEST(nodes.size() == number_of(labels));
        for (std::size_t k = 0; k < nodes.size(); ++k) {
          BOOST_TEST(hierarchy.number_of_faces(nodes[k]) ==
                     std::size_t(std::count(labels.begin(), labels.end(), k)));
          for (Face f : hierarchy.faces(nodes[k], mesh))
            BOOST_TEST(labels[f] == k);
        }
      }
    });
}

BOOST_AUTO_TEST_CASE(nodes_that_are_no_segmentation_are_refused)
{
  const Segmentation_hierarchy hierarchy =
    hierarchy_of(mesh_of(doll()), parameters::default_values());
  const auto [a, b] = hierarchy.node(0).children;
  BOOST_TEST(number_of(hierarchy.labels({b, a})) == 2);
  typedef std::vector<std::size_t> Nodes;
  for (const Nodes& nodes : {Nodes{}, Nodes{a}, Nodes{a, b, a}, Nodes{a, b, 0}, Nodes{0, a, b},
                             Nodes{a, b, hierarchy.number_of_nodes()}})
    BOOST_CHECK_THROW(hierarchy.labels(nodes), std::invalid_argument);
}

// Labels of as many segments as are left are those before, with the two joined.
BOOST_AUTO_TEST_CASE(any_two_segments_are_merged)
{
  const Mesh mesh = mesh_of(read("cactus.off"));
  for_both_methods([&](const auto& np) {
    const Segmentation_hierarchy before = hierarchy_of(mesh, np.salience_threshold(0.3));
    const std::size_t n = 5;
    const Labels labels = labels_of_number(before, n);
    const std::vector<std::size_t> nodes = before.nodes(n);
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) {
        if (a == b)
          continue;
        BOOST_TEST_CONTEXT("segments " << a << " and " << b) {
          Segmentation_hierarchy h = before;
          const std::size_t merged = h.merge(nodes[a], nodes[b]);
          check_nodes(h, mesh);
          check_labels_of_numbers(h);
          BOOST_TEST(h.number_of_nodes() == before.number_of_nodes());
          BOOST_TEST((union_of(faces_of(h, nodes[a]), faces_of(h, nodes[b])) ==
                      union_of(faces_of(h, merged), {})));
          for (std::size_t k = 0; k < n; ++k)
            BOOST_TEST((faces_of(h, nodes[k]) == faces_of(before, nodes[k])));
          BOOST_TEST(are_same_parts(labels_of_number(h, n - 1), joined(labels, a, b)));
          std::vector<std::size_t> chosen = nodes;
          chosen[a] = merged;
          chosen.erase(chosen.begin() + std::ptrdiff_t(b));
          BOOST_TEST(are_same_parts(h.labels(chosen), joined(labels, a, b)));
        }
      }
  });
}

BOOST_AUTO_TEST_CASE(a_leaf_is_cut_again_as_its_faces_are)
{
  const Mesh mesh = mesh_of(read("cactus.off"));
  for_both_methods([&](const auto& np) {
    Segmentation_hierarchy h = hierarchy_of(mesh, np.maximum_number_of_segments(3));
    std::size_t leaf = 0; // the largest
    for (std::size_t i = 0; i < h.number_of_nodes(); ++i)
      if (h.node(i).is_leaf() && (leaf == 0 || h.number_of_faces(i) > h.number_of_faces(leaf)))
        leaf = i;
    const std::vector<Face> faces_of_leaf = faces_of(h, leaf);
    const Segmentation_hierarchy part =
      hierarchy_of_node(h, leaf, mesh, np.salience_threshold(0.1));
    BOOST_TEST_REQUIRE(part.number_of_segments() > 2);
    const std::size_t shift = h.number_of_nodes() - 1;
    h.split_leaf(leaf, part);
    BOOST_TEST((union_of(faces_of(h, leaf), {}) == union_of(faces_of_leaf, {})));
    BOOST_TEST(h.node(leaf).factors.size == part.node(0).factors.size);
    for (std::size_t i = 1; i < part.number_of_nodes(); ++i) {
      std::vector<Face> expected;
      for (auto f : part.faces(i))
        expected.push_back(faces_of_leaf[f]);
      BOOST_TEST((faces_of(h, i + shift) == expected));
    }
  });
}

BOOST_AUTO_TEST_CASE(changes_that_make_no_sense_are_refused)
{
  const Mesh mesh = mesh_of(disjoint_union(dumbbell(14, 10), torus(3, 1, 20, 10)));
  Segmentation_hierarchy h = hierarchy_of(mesh, parameters::zhang_liu_2005());
  const Labels labels = run_labels(h);
  BOOST_TEST_REQUIRE(h.number_of_roots() == 2);
  BOOST_TEST_REQUIRE(!h.node(0).is_leaf());
  BOOST_CHECK_THROW(h.merge(0, 1), std::invalid_argument);
  BOOST_CHECK_THROW(h.merge(0, 0), std::invalid_argument);
  BOOST_CHECK_THROW(h.merge(2, h.number_of_nodes()), std::invalid_argument);
  BOOST_CHECK_THROW(h.split_leaf(Segmentation_hierarchy::null_node, h), std::invalid_argument);
  BOOST_CHECK_THROW(h.merge(h.node(0).children[0], 0), std::invalid_argument);
  BOOST_CHECK_THROW(h.split_leaf(0, h), std::invalid_argument);
  const std::size_t leaf = h.number_of_nodes() - 1;
  BOOST_CHECK_THROW(h.split_leaf(leaf, h), std::invalid_argument);
  BOOST_CHECK_THROW(h.split_leaf(leaf, Segmentation_hierarchy()), std::invalid_argument);
  BOOST_TEST(run_labels(h) == labels, boost::test_tools::per_element());
  BOOST_TEST(h.merge(h.node(0).children[1], h.node(0).children[0]) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
