// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Method_trees.h"
#include "../method_variants.h"
#include "test_meshes.h"

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(method_variants)

using namespace segmentation_benchmark;
using test_meshes::Random;

namespace {

// A thick and a thin rod with necks, and a ring, with more faces than are searched by default.
Mesh two_bodies()
{
  std::vector<std::pair<double, double> > profile = {{0, 0}};
  for (int i = 1; i < 72; ++i)
    profile.emplace_back(i / 9., (i < 36 ? 1 : 0.4) * (1.2 + std::sin(i / 3.)));
  profile.emplace_back(8, 0);
  Random random(5);
  const test_meshes::Soup bodies = test_meshes::disjoint_union(
    test_meshes::surface_of_revolution(profile, 32),
    test_meshes::moved(test_meshes::torus(1, 0.3, 12, 8), 9, 0, 0));
  Mesh mesh;
  CGAL::copy_face_graph(test_meshes::mesh_of(test_meshes::displaced(bodies, 0.01, random)), mesh);
  return mesh;
}

// A mesh that one person cuts, at its neck.
Benchmark_mesh dumbbell()
{
  Benchmark_mesh result{7, {}, {{}}};
  CGAL::copy_face_graph(test_meshes::mesh_of(test_meshes::dumbbell(24, 12)), result.mesh);
  for (Mesh::Face_index f : result.mesh.faces()) {
    double z = 0;
    for (Mesh::Vertex_index v : CGAL::vertices_around_face(result.mesh.halfedge(f), result.mesh))
      z += result.mesh.point(v).z();
    result.people.front().push_back(z < 0 ? 0 : 1);
  }
  return result;
}

std::vector<double> saliences(const Segmentation_hierarchy& tree)
{
  std::vector<double> result;
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
    result.push_back(tree.node(i).salience);
  return result;
}

bool are_equal(const Segmentation_hierarchy& a, const Segmentation_hierarchy& b)
{ return labels_of_run(a) == labels_of_run(b) && saliences(a) == saliences(b); }

Segmentation_hierarchy default_tree(const Tree_method& method, const Mesh& mesh)
{ return method.segment(mesh, method.default_threshold, any_number); }

} // namespace

BOOST_AUTO_TEST_CASE(options_of_the_engine_equal_the_named_parameters)
{
  const Mesh mesh = two_bodies();
  const Segmentation_hierarchy calibrated = hierarchy(mesh, params::default_values()),
                               paper = hierarchy(mesh, params::zhang_liu_2005());
  BOOST_TEST(!are_equal(calibrated, paper));
  for (Execution execution : {Execution::SEQUENTIAL, Execution::PARALLEL}) {
    const auto tree_with = [&](const Engine_options& options)
    { return default_tree(method_with("", options, execution), mesh); };
    BOOST_TEST(are_equal(tree_with(Engine_options()), calibrated));
    BOOST_TEST(are_equal(tree_with(Engine_options::zhang_liu_2005()), paper));
  }
}

BOOST_AUTO_TEST_CASE(each_variant_changes_the_tree)
{
  const Mesh mesh = two_bodies();
  const std::vector<Tree_method> methods = ablated_methods();
  const auto tree_of = [&](const Tree_method& method)
  { return method.segment(mesh, any_salience, 20); };
  const Segmentation_hierarchy whole = tree_of(methods.front());
  BOOST_TEST(are_equal(whole, tree_of(tree_methods().front())));
  for (std::size_t i = 1; i < methods.size(); ++i)
    BOOST_TEST(!are_equal(tree_of(methods[i]), whole), methods[i].name);
}

BOOST_AUTO_TEST_CASE(kept_trees_give_the_labels_of_runs)
{
  const Mesh mesh = two_bodies();
  for (const Tree_method& method : tree_methods()) {
    std::size_t runs = 0;
    const Tree_method counted = {
      method.name, method.default_threshold, method.has_whole_trees,
      [&](const Mesh& m, double threshold, std::size_t n) {
        ++runs;
        return method.segment(m, threshold, n);
      }};
    Method_trees trees(counted, mesh);
    for (double threshold : {0.4, 0.5, 0.6})
      BOOST_TEST((labels_of_tree(trees.down_to(0.4).tree, threshold, any_number) ==
                  labels_of_run(method.segment(mesh, threshold, any_number))));
    for (std::size_t n : {1, 2, 5, 20})
      BOOST_TEST((labels_of_tree(trees.up_to(n).tree, any_salience, n) ==
                  labels_of_run(method.segment(mesh, any_salience, n))));
    BOOST_TEST(runs == (method.has_whole_trees ? 1u : 2u));
    BOOST_TEST((labels_of_tree(trees.up_to(23).tree, any_salience, 23) ==
                labels_of_run(method.segment(mesh, any_salience, 23))));
  }
}

// People are the methods themselves, with six segments each.
BOOST_AUTO_TEST_CASE(errors_read_off_trees_equal_errors_of_runs)
{
  Benchmark_mesh input{1, two_bodies(), {}};
  for (const Tree_method& method : tree_methods())
    input.people.push_back(labels_of_run(method.segment(input.mesh, any_salience, 6)));
  for (const Tree_method& method : tree_methods()) {
    const Tree_errors errors = tree_errors(input, method);
    const auto error = [&](double threshold, std::size_t n)
    {
      return mean_rand_error(labels_of_run(method.segment(input.mesh, threshold, n)),
                             input.people);
    };
    BOOST_TEST(errors.by_default == error(method.default_threshold, any_number));
    BOOST_TEST(errors.k == error(any_salience, 6));
    double least = 1;
    for (std::size_t n = 2; n <= 20; ++n)
      least = (std::min)(least, error(any_salience, n));
    BOOST_TEST(errors.best == least);
  }
}

// One person cuts at the neck, where the tree cuts first, and the other one does not cut.
BOOST_AUTO_TEST_CASE(errors_of_a_dumbbell)
{
  Benchmark_mesh input = dumbbell();
  const auto tolerance = boost::test_tools::tolerance(1e-12);
  const Labels halves = input.people.front(), whole(halves.size(), 0);
  input.people.push_back(whole);
  const double error = rand_error(halves, whole);
  const Tree_errors errors = tree_errors(input, tree_methods().front());
  BOOST_TEST(mean_rand_error_of_people(input.people) == error, tolerance);
  BOOST_TEST(errors.best == error / 2, tolerance);
  BOOST_TEST(errors.k == error / 2, tolerance);
  BOOST_TEST(errors.by_default ==
               mean_rand_error(default_labels("calibrated", input.mesh), input.people), tolerance);

  input.people = {halves, halves};
  const Tree_errors agreed = tree_errors(input, tree_methods().front());
  BOOST_TEST(mean_rand_error_of_people(input.people) == 0);
  BOOST_TEST(agreed.k == 0);
  BOOST_TEST(agreed.best == 0);
}

BOOST_AUTO_TEST_SUITE_END()
