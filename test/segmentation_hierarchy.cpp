// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
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
    if (hierarchy.node(i).cut_state == Cut_state::ACCEPTED)
      result.insert({hierarchy.node(i).salience, std::nextafter(hierarchy.node(i).salience, infinity)});
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
  Eigen::Matrix3Xd points(3, along_cut.size());
  Eigen::Index column = 0;
  for (Mesh::Vertex_index v : along_cut) {
    const Point& p = mesh.point(v);
    points.col(column++) << p.x(), p.y(), p.z();
  }
  points.colwise() -= points.rowwise().mean().eval();
  const Eigen::Matrix3d covariance = points * points.transpose() / double(points.cols());
  const Eigen::Vector3d values =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues();
  return 4 * std::sqrt((std::max)(values[1], 0.) * values[2]);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_hierarchy_without_a_run_is_empty)
{
  const Segmentation_hierarchy hierarchy;
  BOOST_TEST(hierarchy.number_of_nodes() == 0);
  BOOST_TEST(hierarchy.number_of_segments() == 0);
  BOOST_TEST(hierarchy.labels().empty());
}

BOOST_AUTO_TEST_CASE(parts_partition_their_parent)
{
  const auto tolerance = boost::test_tools::tolerance(1e-9);
  for (const Mesh& mesh : several_meshes())
    for_both_methods([&](const auto& np) {
      const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, np.salience_threshold(0.3));
      BOOST_TEST(hierarchy.number_of_faces() == num_faces(mesh));
      BOOST_TEST(hierarchy.number_of_nodes() > hierarchy.number_of_roots());
      std::multiset<Face> faces_of_roots;
      for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
        const Segmentation_hierarchy::Node& n = hierarchy.node(i);
        const std::vector<Face> part = faces_of(hierarchy, i);
        BOOST_TEST(part.size() == hierarchy.number_of_faces(i));
        BOOST_TEST(n.area == PMP::area(part, mesh), tolerance);
        BOOST_TEST((n.parent == Segmentation_hierarchy::null_node) == (i < hierarchy.number_of_roots()));
        if (i < hierarchy.number_of_roots())
          faces_of_roots.insert(part.begin(), part.end());
        if (n.is_leaf()) {
          BOOST_TEST(n.children[0] == Segmentation_hierarchy::null_node);
          BOOST_TEST(n.children[1] == Segmentation_hierarchy::null_node);
          continue;
        }
        for (std::size_t child : n.children)
          BOOST_TEST(hierarchy.node(child).parent == i);
        BOOST_TEST((union_of(faces_of(hierarchy, n.children[0]), faces_of(hierarchy, n.children[1])) ==
                    std::multiset<Face>(part.begin(), part.end())));
        BOOST_TEST(hierarchy.node(n.children[0]).area <= hierarchy.node(n.children[1]).area);
      }
      const auto all = faces(mesh);
      BOOST_TEST((faces_of_roots == std::multiset<Face>(all.begin(), all.end())));
    });
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

BOOST_AUTO_TEST_CASE(labels_are_contiguous_and_segments_connected)
{
  for (const Mesh& mesh : several_meshes())
    for (bool smoothing : {false, true})
      for_both_methods([&](const auto& np) {
        const double smallest = 0.1;
        const Segmentation_hierarchy hierarchy =
          hierarchy_of(mesh, np.salience_threshold(smallest).boundary_smoothing(smoothing));
        const std::size_t most = number_of(hierarchy.labels());
        BOOST_TEST(most > hierarchy.number_of_roots());
        for (std::size_t n = hierarchy.number_of_roots(); n <= most; ++n)
          BOOST_TEST(check_labels(mesh, hierarchy.labels(n, smallest)) == n);
      });
}

BOOST_AUTO_TEST_CASE(labels_for_any_number_and_threshold_are_those_of_a_fresh_run)
{
  const double smallest = 0.4;
  for (const Mesh& mesh : several_meshes())
    for (bool smoothing : {false, true}) {
      const auto np = parameters::zhang_liu_2005().boundary_smoothing(smoothing);
      Segmentation_hierarchy hierarchy;
      const Labels labels =
        labels_of(mesh, np.salience_threshold(smallest).hierarchy(hierarchy));
      BOOST_TEST(hierarchy.labels() == labels, boost::test_tools::per_element());

      for (std::size_t n = 1; n <= hierarchy.number_of_segments() + 1; ++n)
        BOOST_TEST(hierarchy.labels(n, smallest) ==
                   labels_of(mesh, np.salience_threshold(smallest).maximum_number_of_segments(n)),
                   boost::test_tools::per_element());
      for (double threshold : interesting_thresholds(hierarchy, smallest))
        for (std::size_t n : {std::size_t(4), unlimited})
          BOOST_TEST(hierarchy.labels(n, threshold) ==
                     labels_of(mesh, np.salience_threshold(threshold)
                                       .maximum_number_of_segments(n)),
                     boost::test_tools::per_element());
    }
}

BOOST_AUTO_TEST_CASE(segments_of_fewer_or_more_salient_cuts_are_unions)
{
  const auto is_union_of = [](const Labels& coarse, const Labels& fine) {
    std::set<std::pair<std::size_t, std::size_t> > pairs;
    for (std::size_t f = 0; f < fine.size(); ++f)
      pairs.insert({fine[f], coarse[f]});
    return pairs.size() == number_of(fine);
  };
  for (const Mesh& mesh : several_meshes())
    for_both_methods([&](const auto& np) {
      const double smallest = 0.1;
      const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, np.salience_threshold(smallest));
      Labels finer(num_faces(mesh));
      std::iota(finer.begin(), finer.end(), std::size_t(0));
      for (double threshold : interesting_thresholds(hierarchy, smallest)) {
        const Labels labels = hierarchy.labels(unlimited, threshold);
        BOOST_TEST(is_union_of(labels, finer));
        finer = labels;
      }
      // No threshold joins what does not touch.
      BOOST_TEST(number_of(finer) == number_of(hierarchy.labels(unlimited, infinity)));
      BOOST_TEST(number_of(hierarchy.labels(1, smallest)) == hierarchy.number_of_roots());
      for (std::size_t n = 1; n < number_of(hierarchy.labels()); ++n)
        BOOST_TEST(is_union_of(hierarchy.labels(n, smallest), hierarchy.labels(n + 1, smallest)));
    });
}

BOOST_AUTO_TEST_CASE(a_run_with_a_maximum_gives_labels_up_to_it)
{
  const Mesh mesh = mesh_of(doll());
  const auto np = parameters::zhang_liu_2005().salience_threshold(-infinity);
  const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, np.maximum_number_of_segments(6));
  for (std::size_t n = 1; n <= 6; ++n)
    BOOST_TEST(hierarchy.labels(n, -infinity) == labels_of(mesh, np.maximum_number_of_segments(n)),
               boost::test_tools::per_element());
  BOOST_CHECK_THROW(hierarchy.labels(7, -infinity), std::out_of_range);
  BOOST_CHECK_THROW(hierarchy.labels(unlimited, -infinity), std::out_of_range);
  // No cut reaches this threshold, so the run did not end too early for it.
  BOOST_TEST(hierarchy.labels(unlimited, infinity) == Labels(num_faces(mesh), 0),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_run_with_a_threshold_gives_no_labels_below_it)
{
  const Mesh mesh = mesh_of(doll());
  const Segmentation_hierarchy hierarchy =
    hierarchy_of(mesh, parameters::zhang_liu_2005().salience_threshold(0.5));
  BOOST_CHECK_THROW(hierarchy.labels(unlimited, 0.2), std::out_of_range);
  BOOST_CHECK_THROW(hierarchy.labels(unlimited, -infinity), std::out_of_range);
  BOOST_CHECK_THROW(hierarchy.labels(1, std::nan("")), std::invalid_argument);
  BOOST_TEST(hierarchy.labels(1, 0.2) == Labels(num_faces(mesh), 0), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(labels_are_written_into_a_property_map)
{
  const Mesh mesh = mesh_of(doll());
  for_both_methods([&](const auto& np) {
    const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, np.salience_threshold(0.1));
    Labels written;
    BOOST_TEST(hierarchy.segment_by_number(mesh, map_to(written, mesh), 5) == 5);
    BOOST_TEST(written == hierarchy.labels(5, 0.1), boost::test_tools::per_element());

    const double threshold = hierarchy.node(0).salience;
    const std::size_t n = hierarchy.segment_by_threshold(mesh, map_to(written, mesh), threshold);
    BOOST_TEST(written == hierarchy.labels(unlimited, threshold), boost::test_tools::per_element());
    BOOST_TEST(n == number_of(written));
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
    hierarchy.segment_by_number(mesh, map_to(written, mesh), unlimited, of_run);
    BOOST_TEST(written == expected, boost::test_tools::per_element());
    BOOST_TEST(written[last] == 0);
  });
}

BOOST_AUTO_TEST_CASE(a_hierarchy_of_another_mesh_is_refused)
{
  const Segmentation_hierarchy hierarchy = hierarchy_of(mesh_of(sphere(1)), parameters::default_values());
  const Mesh other = mesh_of(sphere(2));
  Labels written;
  BOOST_CHECK_THROW(hierarchy.segment_by_number(other, map_to(written, other), 1),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
