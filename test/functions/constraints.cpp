// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "Face_constraints.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Edges that must be seams, edges that must not, and seeds of faces.
BOOST_AUTO_TEST_SUITE(constraints)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

namespace {

typedef Mesh::Edge_index Edge;
typedef Mesh::Face_index Face;

struct Constrained_mesh
{
  Mesh mesh;
  Mesh::Property_map<Edge, bool> is_seam, is_uncuttable;
  Mesh::Property_map<Face, int> seed;

  explicit Constrained_mesh(const Soup& soup) : mesh(mesh_of(soup))
  {
    is_seam = mesh.add_property_map<Edge, bool>("e:seam", false).first;
    is_uncuttable = mesh.add_property_map<Edge, bool>("e:uncuttable", false).first;
    seed = mesh.add_property_map<Face, int>("f:seed", -1).first;
  }

  Constrained_mesh(const Constrained_mesh&) = delete;

  auto parameters() const
  {
    return parameters::edge_is_constrained_map(is_seam).edge_is_uncuttable_map(is_uncuttable)
             .face_seed_map(seed);
  }

  Two_faces faces_at(Edge e) const { return ::faces_at(mesh, e); }

  // The edge between two faces.
  Edge edge_between(std::size_t f, std::size_t g) const
  {
    for (auto h : halfedges_around_face(mesh.halfedge(Face(f)), mesh))
      if (mesh.face(mesh.opposite(h)) == Face(g))
        return mesh.edge(h);
    throw std::logic_error("the faces have no common edge");
  }

  std::vector<Edge> inner_edges() const
  {
    std::vector<Edge> result;
    for (Edge e : mesh.edges())
      if (!mesh.is_border(e))
        result.push_back(e);
    return result;
  }

  // Those of some other faces of the mesh, for the labels of a run.
  std::vector<Edge> edges_between_segments(const Labels& labels) const
  {
    std::vector<Edge> result;
    for (Edge e : inner_edges())
      if (labels[faces_at(e)[0]] != labels[faces_at(e)[1]])
        result.push_back(e);
    return result;
  }

  Face_constraints face_constraints() const
  {
    Face_constraints result;
    for (Face f : mesh.faces())
      result.seeds.push_back(seed[f]);
    for (Edge e : inner_edges()) {
      if (is_seam[e])
        result.apart.push_back(faces_at(e));
      if (is_uncuttable[e])
        result.together.push_back(faces_at(e));
    }
    return result;
  }

  void check(const Labels& labels) const
  {
    for (const std::string& constraint : face_constraints().violations(labels))
      BOOST_ERROR("violated: " << constraint);
  }

  bool has_contradiction() const
  { return face_constraints().are_contradictory(num_faces(mesh)); }

  Labels labels() const { return labels_of(mesh, parameters()); }

  template <class NamedParameters>
  void check_is_refused(const NamedParameters& np, const std::string& message) const
  { check_refused(mesh, np, message); }

  void check_is_refused(const std::string& message) const
  { check_is_refused(parameters(), message); }
};

// The face whose centroid is nearest to a point.
std::size_t face_near(const Mesh& mesh, double x, double y, double z)
{
  std::size_t result = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Face f : mesh.faces()) {
    double sum[3] = {0, 0, 0};
    for (auto v : vertices_around_face(mesh.halfedge(f), mesh))
      for (int k = 0; k < 3; ++k)
        sum[k] += mesh.point(v)[k] / 3;
    const double distance = CGAL::square(sum[0] - x) + CGAL::square(sum[1] - y) +
                            CGAL::square(sum[2] - z);
    if (distance < least) {
      least = distance;
      result = f;
    }
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(no_constraint_changes_nothing)
{
  const Constrained_mesh m(read("elephant.off"));
  BOOST_TEST(m.labels() == labels_of(m.mesh, parameters::default_values()));
}

// The constraints are on edges where the method cuts anyway.
BOOST_AUTO_TEST_CASE(seams_that_are_there_change_nothing)
{
  Constrained_mesh m(dumbbell(20, 20));
  const Labels labels = m.labels();
  BOOST_TEST(number_of(labels) == 2u);
  for (Edge e : m.inner_edges())
    (labels[m.faces_at(e)[0]] == labels[m.faces_at(e)[1]] ? m.is_uncuttable : m.is_seam)[e] = true;
  BOOST_TEST(m.labels() == labels);
}

BOOST_AUTO_TEST_CASE(edges_that_must_not_be_cut_move_a_seam)
{
  Constrained_mesh m(dumbbell(20, 20));
  const Labels before = m.labels();
  for (Edge e : m.edges_between_segments(before))
    m.is_uncuttable[e] = true;
  const Labels labels = m.labels();
  BOOST_TEST(labels != before);
  m.check(labels);
}

BOOST_AUTO_TEST_CASE(no_edge_may_be_cut)
{
  Constrained_mesh m(dumbbell(20, 20));
  for (Edge e : m.inner_edges())
    m.is_uncuttable[e] = true;
  BOOST_TEST(number_of(m.labels()) == 1u);
}

BOOST_AUTO_TEST_CASE(seeds_cut_a_sphere)
{
  Constrained_mesh m(sphere(4));
  BOOST_TEST(number_of(m.labels()) == 1u);
  m.seed[Face(face_near(m.mesh, 0, 0, 1))] = 7;
  m.seed[Face(face_near(m.mesh, 0, 0, -1))] = 2;
  const Labels labels = m.labels();
  BOOST_TEST(number_of(labels) == 2u);
  m.check(labels);
}

BOOST_AUTO_TEST_CASE(an_edge_makes_a_whole_seam)
{
  Constrained_mesh m(sphere(4));
  m.is_seam[Edge(100)] = true;
  const Labels labels = m.labels();
  BOOST_TEST(number_of(labels) == 2u);
  BOOST_TEST(m.edges_between_segments(labels).size() >= 3u);
  m.check(labels);
}

// The cut that seeds need is searched in a component as in a mesh of its own.
BOOST_AUTO_TEST_CASE(a_component_is_cut_as_without_the_others)
{
  Random random(4);
  const Soup ball = displaced(sphere(4), 0.01, random);
  const std::size_t n = ball.triangles.size();
  const auto labels_of_first = [&](const Soup& soup) {
    Constrained_mesh m(soup);
    m.seed[Face(face_near(m.mesh, 0, 0, 1))] = 1;
    m.seed[Face(face_near(m.mesh, 0.12, 0, 0.99))] = 2;
    Labels result = m.labels();
    m.check(result);
    result.resize(n);
    std::map<std::size_t, std::size_t> number;
    for (std::size_t& label : result)
      label = number.emplace(label, number.size()).first->second;
    return result;
  };
  BOOST_TEST(labels_of_first(disjoint_union(ball, moved(sphere(3), 2, 0, 0))) ==
             labels_of_first(ball), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(border_edges_mean_nothing)
{
  Constrained_mesh m(plate(10, 10));
  for (Edge e : m.mesh.edges())
    if (m.mesh.is_border(e))
      m.is_seam[e] = m.is_uncuttable[e] = true;
  BOOST_TEST(number_of(m.labels()) == 1u);
}

// Both ends of a limb, and all faces between them, are one segment.
BOOST_AUTO_TEST_CASE(equal_seeds_join_segments)
{
  Constrained_mesh m(read("elephant.off"));
  const Labels before = m.labels();
  std::set<std::size_t> joined;
  for (Face f : m.mesh.faces())
    if (joined.size() < 3 && joined.insert(before[f]).second)
      m.seed[f] = 0;
  const Labels labels = m.labels();
  m.check(labels);
  BOOST_TEST(number_of(labels) <= number_of(before) - 2);
}

BOOST_AUTO_TEST_CASE(points_and_triangles)
{
  const Soup soup = dumbbell(20, 20);
  std::vector<int> seed(soup.triangles.size(), -1);
  seed.front() = seed.back() = 0;
  Labels labels(soup.triangles.size(), untouched);
  const std::size_t n = CGAL::segment_spectral_recursive(
    soup.points, soup.triangles, labels.data(), parameters::face_seed_map(seed.data()));
  BOOST_TEST(n == 1u);
}

BOOST_AUTO_TEST_CASE(edges_of_points_and_triangles)
{
  const Soup soup = sphere(3);
  Constrained_mesh m(soup);
  for (std::size_t e : {10, 40, 41, 300})
    m.is_seam[Edge(unsigned(e))] = true;
  m.is_uncuttable[Edge(100)] = m.is_uncuttable[Edge(101)] = true;
  typedef std::pair<std::size_t, std::size_t> Ends;
  const auto map_of = [&m](const Mesh::Property_map<Edge, bool>& given) {
    std::set<Ends> edges;
    for (Edge e : m.mesh.edges())
      if (given[e])
        edges.insert(std::minmax({std::size_t(m.mesh.vertex(e, 0)),
                                  std::size_t(m.mesh.vertex(e, 1))}));
    return boost::make_function_property_map<Ends>([edges](const Ends& e)
      { return edges.count(e) > 0; });
  };
  Labels labels(soup.triangles.size(), untouched);
  CGAL::segment_spectral_recursive(
    soup.points, soup.triangles, labels.data(),
    parameters::edge_is_constrained_map(map_of(m.is_seam))
      .edge_is_uncuttable_map(map_of(m.is_uncuttable)));
  m.check(labels);
  BOOST_TEST(labels == m.labels(), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(edge_of_three_triangles)
{
  typedef std::pair<std::size_t, std::size_t> Ends;
  const std::vector<std::array<double, 3> > points = {
    {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  const std::vector<std::array<int, 3> > triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const auto is_edge = boost::make_function_property_map<Ends>(
    [](const Ends& e) { return e == Ends(0, 1); });
  const auto np = parameters::salience_threshold(std::numeric_limits<double>::infinity());
  Labels labels(3, untouched);
  const auto segment = [&](const auto& parameters)
    { return CGAL::segment_spectral_recursive(points, triangles, labels.data(), parameters); };
  BOOST_TEST(segment(np) == 1u);
  BOOST_TEST(segment(np.edge_is_constrained_map(is_edge)) == 3u);
  const auto all_cuts = parameters::salience_threshold(-std::numeric_limits<double>::infinity());
  BOOST_TEST(segment(all_cuts) == 3u);
  BOOST_TEST(segment(all_cuts.edge_is_uncuttable_map(is_edge)) == 1u);
}

BOOST_AUTO_TEST_CASE(random_constraints_on_real_meshes)
{
  Random random(1);
  std::size_t number_of_contradictions = 0;
  for (const char* name : {"camel", "dino", "elephant", "hand", "triceratops"})
    BOOST_TEST_CONTEXT(name) {
      Constrained_mesh m(read(std::string(name) + ".off"));
      const std::size_t number_of_edges = m.mesh.number_of_edges();
      const std::size_t n = random() % 2 == 0 ? 4 : 20;
      for (std::size_t i = 0; i < n; ++i) {
        m.is_seam[Edge(random() % number_of_edges)] = true;
        const Edge e(random() % number_of_edges);
        m.is_uncuttable[e] = !m.is_seam[e];
        m.seed[Face(random() % num_faces(m.mesh))] = int(random() % 3);
      }
      if (m.has_contradiction()) {
        ++number_of_contradictions;
        m.check_is_refused("");
        continue;
      }
      Segmentation_hierarchy hierarchy;
      m.check(labels_of(m.mesh, m.parameters().hierarchy(hierarchy)));
      for (std::size_t k : {hierarchy.number_of_roots(), hierarchy.number_of_segments()})
        m.check(labels_above(hierarchy, -std::numeric_limits<double>::infinity(), k));
    }
  BOOST_TEST(number_of_contradictions <= 2u);
}

BOOST_AUTO_TEST_CASE(exact_number)
{
  Constrained_mesh m(read("hand.off"));
  m.is_seam[Edge(1000)] = true;
  m.seed[Face(10)] = 1;
  m.seed[Face(2000)] = 2;
  for (std::size_t n : {3, 10, 30}) {
    const Labels labels = labels_of(m.mesh, m.parameters().number_of_segments(n));
    BOOST_TEST(number_of(labels) == n);
    m.check(labels);
  }
  m.check_is_refused(m.parameters().number_of_segments(1), "are allowed");
  m.check_is_refused(m.parameters().maximum_number_of_segments(1), "are allowed");
}

BOOST_AUTO_TEST_CASE(number_of_groups_is_the_largest)
{
  Constrained_mesh m(sphere(2));
  const std::size_t number_of_faces = num_faces(m.mesh);
  m.is_uncuttable[Edge(0)] = true;
  BOOST_TEST(number_of(labels_of(m.mesh, m.parameters().number_of_segments(number_of_faces - 1))) ==
             number_of_faces - 1);
  m.check_is_refused(m.parameters().number_of_segments(number_of_faces), "at most");
}

BOOST_AUTO_TEST_CASE(contradictions)
{
  {
    Constrained_mesh m(sphere(2));
    m.is_seam[Edge(5)] = m.is_uncuttable[Edge(5)] = true;
    m.check_is_refused("is in both");
  }
  { // around a vertex
    Constrained_mesh m(sphere(2));
    for (auto h : halfedges_around_target(Mesh::Vertex_index(0), m.mesh))
      m.is_uncuttable[m.mesh.edge(h)] = true;
    const Edge e = m.mesh.edge(m.mesh.halfedge(Mesh::Vertex_index(0)));
    m.is_uncuttable[e] = false;
    m.is_seam[e] = true;
    m.check_is_refused("is constrained");
  }
  {
    Constrained_mesh m(sphere(2));
    m.is_seam[Edge(5)] = true;
    for (std::size_t f : m.faces_at(Edge(5)))
      m.seed[Face(f)] = 4;
    m.check_is_refused("is constrained");
  }
  {
    Constrained_mesh m(sphere(2));
    m.is_uncuttable[Edge(5)] = true;
    m.seed[Face(m.faces_at(Edge(5))[0])] = 1;
    m.seed[Face(m.faces_at(Edge(5))[1])] = 2;
    m.check_is_refused("have the seeds");
  }
  {
    const Soup soup = sphere(2);
    Constrained_mesh m(disjoint_union(soup, moved(soup, 5, 0, 0)));
    m.seed[Face(0)] = m.seed[Face(num_faces(m.mesh) - 1)] = 3;
    m.check_is_refused(m.parameters().keep_components_separate(true), "kept apart");
    BOOST_TEST(number_of(m.labels()) == 1u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
