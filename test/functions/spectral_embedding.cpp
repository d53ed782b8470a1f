// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/nystrom_embedding.h>
#include <CGAL/spectral_embedding.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(spectral_embedding)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
namespace params = CGAL::Spectral_segmentation::parameters;
namespace tt = boost::test_tools;
using CGAL::Spectral_segmentation::Options;

namespace {

typedef Mesh::Face_index Face;

struct Embedded
{
  std::vector<double> coordinates; // indexed by face
  std::vector<Face> samples;
};

template <class NamedParameters>
Embedded embedded(const Mesh& mesh, const NamedParameters& np)
{
  Embedded result{std::vector<double>(num_faces(mesh)), {}};
  const auto index = get(CGAL::face_index, mesh);
  result.samples = CGAL::spectral_embedding(
    mesh, boost::make_iterator_property_map(result.coordinates.begin(), index), np);
  return result;
}

Embedded embedded(const Mesh& mesh) { return embedded(mesh, params::default_values()); }

template <class NamedParameters>
void check_refused(const std::string& message, const Mesh& mesh, const NamedParameters& np)
{
  std::vector<double> coordinates(num_faces(mesh), 7);
  const auto map =
    boost::make_iterator_property_map(coordinates.begin(), get(CGAL::face_index, mesh));
  BOOST_CHECK_EXCEPTION(
    CGAL::spectral_embedding(mesh, map, np), std::invalid_argument,
    [&](const std::invalid_argument& e) {
      const std::string what = e.what();
      return what.find(message) != std::string::npos;
    });
  BOOST_TEST(std::count(coordinates.begin(), coordinates.end(), 7) ==
             std::ptrdiff_t(coordinates.size()));
}

// The combined distances of the paper between all pairs of faces, by Floyd and Warshall.
Eigen::MatrixXd all_distances(const Soup& soup)
{
  const Surface graph = graph_with_distances(soup);
  const Eigen::Index n = static_cast<Eigen::Index>(graph.number_of_faces());
  Eigen::MatrixXd d = Eigen::MatrixXd::Constant(n, n, 1e9);
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (!graph.is_border(h))
      d(h / 3, graph.neighbor(h)) = graph.weights[h].combined;
  for (Eigen::Index k = 0; k < n; ++k) {
    d(k, k) = 0;
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j)
        d(i, j) = std::min(d(i, j), d(i, k) + d(k, j));
  }
  return d;
}

} // namespace

// The claim on which the search rests: for two samples the embedding has the order of the search.
BOOST_AUTO_TEST_CASE(two_samples_give_the_order_of_the_search)
{
  for (const char* name : {"elephant.off", "hand.off", "dino.off"})
    BOOST_TEST_CONTEXT(name) {
      const Soup soup = read(name);
      const Embedded e = embedded(mesh_of(soup));
      BOOST_TEST_REQUIRE(e.samples.size() == 2u);
      const Surface graph = graph_with_distances(soup);
      const std::vector<Index> order = internal::face_order(
        sequential, graph, {Index(e.samples[0].idx()), Index(e.samples[1].idx())});
      const double largest = std::abs(e.coordinates[order.front()]);
      double highest = e.coordinates[order.front()];
      std::size_t number_of_descents = 0;
      for (Index f : order) {
        number_of_descents += e.coordinates[f] < highest - 1e-9 * largest;
        highest = std::max(highest, e.coordinates[f]);
      }
      BOOST_TEST(number_of_descents == 0u);
      BOOST_TEST(e.coordinates[order.front()] < e.coordinates[order.back()]);
    }
}

BOOST_AUTO_TEST_CASE(the_default_samples_follow_section_4)
{
  const Soup soup = read("hand.off");
  const Surface graph = graph_with_distances(soup);
  const internal::Sample_faces expected = internal::sample_faces(
    sequential, internal::shape_contexts(
                  graph, internal::farthest_face_from_center(sequential, graph), 10, [] {}));
  const Embedded e = embedded(mesh_of(soup));
  BOOST_TEST_REQUIRE(e.samples.size() == 2u);
  BOOST_TEST(std::size_t(e.samples[0]) == expected.s);
  BOOST_TEST(std::size_t(e.samples[1]) == expected.t);
  const Embedded given = embedded(mesh_of(soup), params::sample_faces(e.samples));
  BOOST_TEST(given.coordinates == e.coordinates, tt::per_element());
  BOOST_TEST((given.samples == e.samples));
}

BOOST_AUTO_TEST_CASE(all_faces_as_samples_give_the_eigenvectors_of_the_whole_matrix)
{
  Random random(3);
  const Soup soup = displaced(dumbbell(8, 6), 0.05, random);
  const Mesh mesh = mesh_of(soup);
  const Embedded e =
    embedded(mesh, params::sample_faces(std::vector<Face>(mesh.faces().begin(),
                                                          mesh.faces().end())));
  const Eigen::MatrixXd d = all_distances(soup);
  const double sigma = d.mean();
  const Eigen::MatrixXd a = (-d.array() / (sigma * sigma)).exp().matrix();
  const Eigen::VectorXd scale = a.rowwise().sum().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
    Eigen::MatrixXd(scale.asDiagonal() * a * scale.asDiagonal()));
  const Eigen::Index n = d.rows();
  Eigen::VectorXd z =
    solver.eigenvectors().col(n - 2).cwiseQuotient(solver.eigenvectors().col(n - 1));
  if (z[0] > z[n - 1])
    z = -z;
  for (Eigen::Index f = 0; f < n; ++f)
    BOOST_TEST(std::abs(z[f] - e.coordinates[std::size_t(f)]) < 1e-6 * z.cwiseAbs().maxCoeff());
}

BOOST_AUTO_TEST_CASE(more_samples_come_nearer_to_the_exact_embedding)
{
  const Mesh mesh = mesh_of(dumbbell(10, 8));
  const std::vector<Face> all(mesh.faces().begin(), mesh.faces().end());
  const auto coordinates = [&](std::vector<Face> samples) -> Eigen::VectorXd {
    const Embedded e = embedded(mesh, params::sample_faces(samples));
    const Eigen::VectorXd z = Eigen::Map<const Eigen::VectorXd>(
      e.coordinates.data(), static_cast<Eigen::Index>(e.coordinates.size()));
    return z.normalized();
  };
  const auto every = [&](std::size_t step) {
    std::vector<Face> result;
    for (std::size_t i = 0; i < all.size(); i += step)
      result.push_back(all[i]);
    return result;
  };
  const Eigen::VectorXd exact = coordinates(all);
  const auto error = [&](const Eigen::VectorXd& z)
  { return std::min((z - exact).norm(), (z + exact).norm()); };
  BOOST_TEST(error(coordinates(every(2))) < 0.1);
  BOOST_TEST(error(coordinates(every(2))) < error(coordinates(every(30))));
}

BOOST_AUTO_TEST_CASE(the_two_balls_of_a_dumbbell_lie_on_two_sides)
{
  const Soup soup = dumbbell(24, 16);
  const Mesh mesh = mesh_of(soup);
  const Embedded e = embedded(mesh);
  std::vector<double> below, above;
  for (Face f : mesh.faces()) {
    double z = 0;
    for (auto v : vertices_around_face(mesh.halfedge(f), mesh))
      z += mesh.point(v).z() / 3;
    if (std::abs(z) > 0.5)
      (z < 0 ? below : above).push_back(e.coordinates[std::size_t(f)]);
  }
  std::sort(below.begin(), below.end());
  std::sort(above.begin(), above.end());
  BOOST_TEST((below.back() < above.front() || above.back() < below.front()));
}

BOOST_AUTO_TEST_CASE(every_mesh_type_is_taken)
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  const Mesh mesh = mesh_of(dumbbell(8, 6));
  Polyhedron polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  std::map<Polyhedron::Facet_handle, float> coordinates;
  CGAL::spectral_embedding(polyhedron, boost::make_assoc_property_map(coordinates));
  const Embedded e = embedded(mesh);
  std::size_t i = 0;
  for (auto f : faces(polyhedron))
    BOOST_TEST(coordinates[f] == float(e.coordinates[i++]));
}

BOOST_AUTO_TEST_CASE(weights_change_the_embedding)
{
  const Mesh mesh = mesh_of(doll());
  const Embedded paper = embedded(mesh);
  BOOST_TEST(embedded(mesh, params::options(Options::zhang_liu_2005())).coordinates ==
             paper.coordinates, tt::per_element());
  BOOST_TEST(embedded(mesh, params::distance_weights(0.01, 1, 0.1)).coordinates ==
             paper.coordinates, tt::per_element());
  BOOST_TEST((embedded(mesh, params::distance_weights(1, 1, 0.1)).coordinates !=
              paper.coordinates));
  BOOST_TEST((embedded(mesh, params::options(Options())).coordinates != paper.coordinates));
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused_and_nothing_is_written)
{
  const Mesh mesh = mesh_of(dumbbell(8, 6));
  const Face f(0), beyond(num_faces(mesh));
  check_refused("at least two sample faces", mesh, params::sample_faces(std::vector<Face>{f}));
  check_refused("different faces", mesh, params::sample_faces(std::vector<Face>{f, f}));
  check_refused("different faces", mesh, params::sample_faces(std::vector<Face>{f, beyond}));
  check_refused("number_of_reference_faces", mesh, params::number_of_reference_faces(0));
  check_refused("distance_weights", mesh, params::distance_weights(2, 1, 1));
  check_refused("connected", mesh_of(disjoint_union(plate(1, 1), moved(plate(1, 1), 5, 0, 0))),
                params::default_values());
  check_refused("connected", Mesh(), params::default_values());
}

BOOST_AUTO_TEST_SUITE_END()
