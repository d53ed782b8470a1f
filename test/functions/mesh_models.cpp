// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "mesh_models.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(mesh_models)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel Epeck;
typedef CGAL::Simple_cartesian<float> Single;
typedef CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
  2, 3, CGAL::Linear_cell_complex_traits<3, Epick> >::type Cell_complex;

typedef Mesh::Face_index Face;

typedef boost::mpl::list<
  CGAL::Surface_mesh<Epick::Point_3>, CGAL::Surface_mesh<Epeck::Point_3>,
  CGAL::Surface_mesh<Single::Point_3>, CGAL::Polyhedron_3<Epick>, CGAL::Polyhedron_3<Epeck>,
  CGAL::Polyhedron_3<Kernel>, CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>,
  Cell_complex> Models;

// The faces of a soup that are not left out.
template <class IsLeftOut>
Soup remaining(const Soup& soup, const IsLeftOut& is_left_out)
{
  Soup result = soup;
  result.triangles.clear();
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    if (!is_left_out(f))
      result.triangles.push_back(soup.triangles[f]);
  return result;
}

// Some faces without which the rest is a manifold.
std::set<std::size_t> removable_faces(const Soup& soup)
{
  std::set<std::size_t> result;
  const auto is_chosen = [&](std::size_t f) { return result.count(f) > 0; };
  const std::size_t n = soup.triangles.size();
  for (std::size_t f = 0; f < n; f += n / 10) {
    result.insert(f);
    if (!PMP::is_polygon_soup_a_polygon_mesh(remaining(soup, is_chosen).triangles))
      result.erase(f);
  }
  return result;
}

struct Own_map
{
  typedef Face key_type;
  typedef long long value_type;
  typedef void reference;
  typedef boost::writable_property_map_tag category;
  std::vector<long long>* values;

  friend void put(const Own_map& map, Face f, long long value) { (*map.values)[f] = value; }
};

template <class Id>
void check_id_type()
{
  Mesh mesh = mesh_of(soups_of_models()[0]);
  const Labels expected = labels_of_graph(mesh, parameters::salience_threshold(0.4));
  auto ids = mesh.add_property_map<Face, Id>("f:segment").first;
  CGAL::segment_spectral_recursive(mesh, ids, parameters::salience_threshold(0.4));
  for (Face f : faces(mesh))
    BOOST_TEST(static_cast<std::size_t>(ids[f]) == expected[f]);
}

template <class Id>
void check_capacity(std::size_t capacity)
{
  const Mesh just_enough = mesh_of(separate_triangles(capacity));
  std::vector<Id> ids(capacity, Id(7));
  const auto map = boost::make_iterator_property_map(ids.begin(),
                                                     get(CGAL::face_index, just_enough));
  const auto apart = parameters::keep_components_separate(true);
  BOOST_TEST(CGAL::segment_spectral_recursive(just_enough, map, apart) == capacity);
  BOOST_TEST(ids.back() == static_cast<Id>(capacity - 1));

  const Mesh too_many = mesh_of(separate_triangles(capacity + 1));
  ids.assign(capacity + 1, Id(7));
  BOOST_CHECK_THROW(
    CGAL::segment_spectral_recursive(
      too_many, boost::make_iterator_property_map(ids.begin(), get(CGAL::face_index, too_many)),
      apart),
    std::overflow_error);
  BOOST_TEST(std::count(ids.begin(), ids.end(), Id(7)) == std::ptrdiff_t(capacity + 1));
}

} // namespace

BOOST_AUTO_TEST_CASE(the_meshes_have_several_segments)
{
  for (std::size_t i = 0; i < 3; ++i) {
    BOOST_TEST(number_of(labels_of_graph(mesh_of(soups_of_models()[i]))) > 2);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(every_model_of_a_mesh_gives_the_same_arrays, Graph, Models)
{ check_arrays_of_model<Graph>(); }

BOOST_AUTO_TEST_CASE(models_without_indices_have_the_same_labels)
{
  check_labels_of_model<CGAL::Polyhedron_3<Epick> >();
  check_labels_of_model<Cell_complex>();
}

BOOST_AUTO_TEST_CASE(ids_of_a_polyhedron_may_be_anything)
{
  typedef CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3> Polyhedron;
  Polyhedron polyhedron;
  fill(polyhedron, soups_of_models()[1]);
  const Mesh expected = mesh_of(soups_of_models()[1]);
  const auto check = [&](const char* what, const auto& set_id) {
    BOOST_TEST_CONTEXT(what) {
      std::size_t i = 0;
      for (auto v : vertices(polyhedron))
        set_id(v->id(), i++);
      i = 0;
      for (auto f : faces(polyhedron))
        set_id(f->id(), i++);
      check_arrays(polyhedron, expected);
    }
  };
  check("all 0", [](std::size_t& id, std::size_t) { id = 0; });
  check("in order", [](std::size_t& id, std::size_t i) { id = i; });
  check("backwards", [](std::size_t& id, std::size_t i) { id = 100000 - i; });
  check("with large gaps", [](std::size_t& id, std::size_t i) { id = i * 1000000007; });
  check("in pairs", [](std::size_t& id, std::size_t i) { id = i / 2; });
  check("none", [](std::size_t& id, std::size_t) { id = std::size_t(-1); });
}

BOOST_AUTO_TEST_CASE(junk_that_was_removed_leaves_no_trace)
{
  for (const Soup& soup : soups_of_models()) {
    Mesh mesh = mesh_of(soup);
    const Mesh expected = mesh;
    std::vector<Face> junk;
    for (int i = 0; i < 5; ++i) {
      const Mesh::Halfedge_index h =
        CGAL::make_triangle(Point(i, 0, 0), Point(0, i + 1, 0), Point(0, 0, 7), mesh);
      junk.push_back(face(h, mesh));
    }
    for (Face f : junk)
      CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
    BOOST_TEST_REQUIRE(mesh.has_garbage());
    check_arrays(mesh, expected);
  }
}

BOOST_AUTO_TEST_CASE(a_mesh_with_removed_faces_is_the_mesh_of_the_others)
{
  for (const Soup& soup : soups_of_models()) {
    Mesh mesh = mesh_of(soup);
    const std::set<std::size_t> removed = removable_faces(soup);
    for (std::size_t f : removed)
      CGAL::Euler::remove_face(mesh.halfedge(Face(f)), mesh);
    const auto is_removed = [&](std::size_t f) { return removed.count(f) > 0; };
    BOOST_TEST_REQUIRE(mesh.has_garbage());
    const Labels labels = labels_of_graph(mesh);
    BOOST_TEST(labels == labels_of_graph(mesh_of(remaining(soup, is_removed))),
               boost::test_tools::per_element());
    mesh.collect_garbage();
    BOOST_TEST(labels.size() == 2 * num_faces(mesh));
  }
}

BOOST_AUTO_TEST_CASE(a_face_filtered_graph_is_the_mesh_of_its_faces)
{
  std::size_t number_of_selections = 0;
  for (const Soup& soup : soups_of_models()) {
    const Mesh mesh = mesh_of(soup);
    const Labels segments = labels_of_graph(mesh);
    for (std::size_t s = 0; s < (std::min)(number_of(segments), std::size_t(4)); ++s) {
      const auto is_left_out = [&](std::size_t f) { return segments[f] == s; };
      std::vector<Face> selected;
      for (Face f : faces(mesh))
        if (!is_left_out(f))
          selected.push_back(f);
      const Soup rest = remaining(soup, is_left_out);
      if (selected.empty() || !PMP::is_polygon_soup_a_polygon_mesh(rest.triangles))
        continue;
      ++number_of_selections;
      const CGAL::Face_filtered_graph<Mesh> filtered(mesh, selected);
      BOOST_TEST(labels_of_graph(filtered) == labels_of_graph(mesh_of(rest)),
                 boost::test_tools::per_element());
    }
  }
  BOOST_TEST(number_of_selections > 5);
}

BOOST_AUTO_TEST_CASE(ids_of_any_integer_type_are_written)
{
  check_id_type<int>();
  check_id_type<unsigned char>();
  check_id_type<signed char>();
  check_id_type<short>();
  check_id_type<std::size_t>();
}

BOOST_AUTO_TEST_CASE(any_writable_property_map_is_taken)
{
  const Mesh mesh = mesh_of(soups_of_models()[1]);
  const auto np = parameters::salience_threshold(0.4);
  const Labels expected = labels_of_graph(mesh, np);

  std::map<Face, unsigned short> in_map;
  CGAL::segment_spectral_recursive(
    mesh, boost::associative_property_map<std::map<Face, unsigned short> >(in_map), np);
  std::vector<long long> in_vector(num_faces(mesh));
  CGAL::segment_spectral_recursive(mesh, Own_map{&in_vector}, np);
  BOOST_TEST(in_map.size() == expected.size());
  for (Face f : faces(mesh)) {
    BOOST_TEST(in_map.at(f) == expected[f]);
    BOOST_TEST(in_vector[f] == static_cast<long long>(expected[f]));
  }
}

BOOST_AUTO_TEST_CASE(an_id_type_that_is_too_small_is_refused)
{
  check_capacity<unsigned char>(256);
  check_capacity<signed char>(128);
}

BOOST_AUTO_TEST_CASE(two_threads_may_segment_the_same_mesh)
{
  CGAL::Polyhedron_3<Epick> polyhedron;
  fill(polyhedron, soups_of_models()[1]);
  const Mesh mesh = mesh_of(soups_of_models()[0]);
  const auto segment_in_two_threads = [](const auto& graph) {
    const Labels expected = labels_of_graph(graph);
    Labels labels[2];
    std::vector<std::thread> threads;
    for (Labels& result : labels)
      threads.emplace_back([&] { result = labels_of_graph(graph); });
    for (std::thread& thread : threads)
      thread.join();
    BOOST_TEST(labels[0] == expected, boost::test_tools::per_element());
    BOOST_TEST(labels[1] == expected, boost::test_tools::per_element());
  };
  segment_in_two_threads(mesh);
  segment_in_two_threads(polyhedron);
}

BOOST_AUTO_TEST_SUITE_END()
