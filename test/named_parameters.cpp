// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE named_parameters
#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segment_tree;
using CGAL::Spectral_segmentation::Segmentation_visitor;

namespace {

typedef std::vector<std::size_t> Labels;
typedef Mesh::Face_index Face;
typedef Mesh::Vertex_index Vertex;

const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

const Mesh& hand()
{
  static const Mesh mesh = mesh_of(read("hand.off"));
  return mesh;
}

auto map_to(Labels& labels, const Mesh& mesh)
{
  labels.resize(num_faces(mesh), 77);
  return boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh));
}

template <class NamedParameters>
Labels labels_of(const Mesh& mesh, const NamedParameters& np)
{
  Labels labels;
  CGAL::segment_spectral_recursive(mesh, map_to(labels, mesh), np);
  return labels;
}

template <class NamedParameters>
Labels labels_of_hand(const NamedParameters& np)
{ return labels_of(hand(), np); }

Labels labels_of_hand() { return labels_of_hand(parameters::default_values()); }

std::size_t number_of(const Labels& labels)
{ return 1 + *std::max_element(labels.begin(), labels.end()); }

// The run throws an exception that names the parameter, and writes nothing.
template <class NamedParameters>
void check_refused(const std::string& name, const NamedParameters& np)
{
  BOOST_TEST_CONTEXT(name) {
    Labels labels;
    const auto map = map_to(labels, hand());
    const Labels before = labels;
    BOOST_CHECK_EXCEPTION(CGAL::segment_spectral_recursive(hand(), map, np),
                          std::invalid_argument, [&](const std::invalid_argument& e)
                          { return std::string(e.what()).find(name) != std::string::npos; });
    BOOST_TEST(labels == before, boost::test_tools::per_element());
  }
}

// A point type of its own and the least that a traits class may have.
struct Own_point
{
  std::array<float, 3> x;
};

struct Own_traits
{
  typedef Own_point Point_3;

  template <int i>
  struct Compute_coordinate
  {
    float operator()(const Own_point& p) const { return p.x[i]; }
  };
  typedef Compute_coordinate<0> Compute_x_3;
  typedef Compute_coordinate<1> Compute_y_3;
  typedef Compute_coordinate<2> Compute_z_3;
  Compute_x_3 compute_x_3_object() const { return Compute_x_3(); }
  Compute_y_3 compute_y_3_object() const { return Compute_y_3(); }
  Compute_z_3 compute_z_3_object() const { return Compute_z_3(); }
};

// Reads coordinates with another unit on each axis, to be told from a default instance.
struct Scaling_traits
{
  typedef Point Point_3;
  std::array<double, 3> scale{{1, 1, 1}};

  template <int i>
  struct Compute_coordinate
  {
    double scale;
    double operator()(const Point& p) const { return scale * p[i]; }
  };
  typedef Compute_coordinate<0> Compute_x_3;
  typedef Compute_coordinate<1> Compute_y_3;
  typedef Compute_coordinate<2> Compute_z_3;
  Compute_x_3 compute_x_3_object() const { return {scale[0]}; }
  Compute_y_3 compute_y_3_object() const { return {scale[1]}; }
  Compute_z_3 compute_z_3_object() const { return {scale[2]}; }
};

} // namespace

BOOST_AUTO_TEST_CASE(defaults_are_those_that_are_documented)
{
  Segmentation_visitor visitor;
  const Labels labels = labels_of_hand();
  BOOST_TEST(number_of(labels) > 2);
  BOOST_TEST(labels == labels_of_hand(
               parameters::vertex_point_map(get(CGAL::vertex_point, hand()))
                 .face_index_map(get(CGAL::face_index, hand())).geom_traits(Kernel())
                 .maximum_number_of_segments((std::numeric_limits<std::size_t>::max)())
                 .salience_threshold(0.54).minimum_segment_size(0.005)
                 .salience_weights(0.1, 0.6, 0.3).geodesic_weight(0.01)
                 .concave_angle_weight(1).convex_angle_weight(0.1).number_of_reference_faces(10)
                 .number_of_smoothing_iterations(0).boundary_smoothing(false)
                 .visitor(visitor)), boost::test_tools::per_element());
  Labels without_pack;
  CGAL::segment_spectral_recursive(hand(), map_to(without_pack, hand()));
  BOOST_TEST(labels == without_pack, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(each_of_the_defaults_is_the_one_that_is_documented)
{
  Segment_tree by_default;
  labels_of_hand(parameters::segment_tree(by_default));
  const auto check = [&](const auto& np) {
    Segment_tree tree;
    labels_of_hand(np.segment_tree(tree));
    BOOST_TEST_REQUIRE(tree.number_of_nodes() == by_default.number_of_nodes());
    for (std::size_t i = 0; i < tree.number_of_nodes(); ++i)
      BOOST_TEST(tree.node(i).salience == by_default.node(i).salience);
  };
  check(parameters::method(CGAL::Spectral_segmentation::Method::ZHANG_LIU_2005));
  check(parameters::salience_threshold(0.54));
  check(parameters::minimum_segment_size(0.005));
  check(parameters::salience_weights(0.1, 0.6, 0.3));
  check(parameters::geodesic_weight(0.01));
  check(parameters::concave_angle_weight(1));
  check(parameters::convex_angle_weight(0.1));
  check(parameters::number_of_reference_faces(10));
  check(parameters::number_of_smoothing_iterations(0));
  check(parameters::boundary_smoothing(false));
}

BOOST_AUTO_TEST_CASE(parameters_chain_in_any_order)
{
  Segment_tree tree_1, tree_2, tree_3;
  const auto point = get(CGAL::vertex_point, hand());
  const Labels a = labels_of_hand(
    parameters::vertex_point_map(point).salience_threshold(0.4).random_seed(3)
      .maximum_number_of_segments(5).segment_tree(tree_1).boundary_smoothing(true));
  const Labels b = labels_of_hand(
    parameters::boundary_smoothing(true).segment_tree(tree_2).maximum_number_of_segments(5)
      .random_seed(3).salience_threshold(0.4).vertex_point_map(point));
  const Labels c = labels_of_hand(
    parameters::from(CGAL::parameters::random_seed(3).vertex_point_map(point))
      .segment_tree(tree_3).boundary_smoothing(true).salience_threshold(0.4)
      .maximum_number_of_segments(5));
  BOOST_TEST(a == b, boost::test_tools::per_element());
  BOOST_TEST(a == c, boost::test_tools::per_element());
  for (const Segment_tree* tree : {&tree_1, &tree_2, &tree_3})
    BOOST_TEST(tree->number_of_segments() == number_of(a));
}

BOOST_AUTO_TEST_CASE(a_pack_of_CGAL_is_taken_as_it_is)
{
  std::vector<Point> stretched;
  for (Vertex v : vertices(hand()))
    stretched.emplace_back(hand().point(v).x(), 3 * hand().point(v).y(), hand().point(v).z());
  const auto map = boost::make_iterator_property_map(stretched.begin(),
                                                     get(CGAL::vertex_index, hand()));
  BOOST_TEST(labels_of_hand(CGAL::parameters::vertex_point_map(map).random_seed(5)) ==
             labels_of_hand(parameters::random_seed(5).vertex_point_map(map)),
             boost::test_tools::per_element());
  BOOST_TEST(labels_of_hand(CGAL::parameters::all_default()) == labels_of_hand(),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_pack_goes_back_to_CGAL)
{
  const auto np = parameters::salience_threshold(0.3).random_seed(4);
  BOOST_TEST(CGAL::parameters::get_parameter(np.cgal_parameters(),
                                             CGAL::internal_np::random_seed) == 4);
}

BOOST_AUTO_TEST_CASE(the_last_value_wins)
{
  BOOST_TEST(number_of(labels_of_hand(
    parameters::maximum_number_of_segments(2).salience_threshold(-infinity)
      .maximum_number_of_segments(std::size_t(4)))) == 4);
  BOOST_TEST(number_of(labels_of_hand(
    parameters::salience_threshold(-infinity).salience_threshold(2))) == 1);
  BOOST_TEST(number_of(labels_of_hand(
    parameters::from(CGAL::parameters::random_seed(1)).maximum_number_of_segments(0)
      .maximum_number_of_segments(1))) == 1);
}

BOOST_AUTO_TEST_CASE(numbers_of_any_type_are_taken)
{
  const Labels labels = labels_of_hand(
    parameters::maximum_number_of_segments(3).salience_threshold(0));
  BOOST_TEST(labels == labels_of_hand(
    parameters::maximum_number_of_segments(3ull).salience_threshold(0.f)));
  BOOST_TEST(labels == labels_of_hand(
    parameters::maximum_number_of_segments(short(3)).salience_threshold(0u)));
}

BOOST_AUTO_TEST_CASE(each_number_has_an_effect)
{
  const auto tree_of = [](const auto& np) {
    Segment_tree tree;
    labels_of_hand(np.salience_threshold(-infinity).maximum_number_of_segments(6)
                     .segment_tree(tree));
    return tree;
  };
  const Segment_tree by_default = tree_of(parameters::default_values());
  const auto differs = [&](const auto& np) { return tree_of(np).labels() != by_default.labels(); };
  BOOST_TEST(differs(parameters::salience_weights(0.5, 0.4, 0.1)));
  BOOST_TEST(differs(parameters::minimum_segment_size(0.3)));
  BOOST_TEST(differs(parameters::geodesic_weight(1)));
  BOOST_TEST(differs(parameters::concave_angle_weight(0)));
  BOOST_TEST(differs(parameters::convex_angle_weight(5)));
  BOOST_TEST(differs(parameters::number_of_reference_faces(1)));
  BOOST_TEST(differs(parameters::number_of_smoothing_iterations(5)));
  BOOST_TEST(differs(parameters::boundary_smoothing(true)));
  BOOST_TEST(number_of(labels_of_hand(parameters::salience_threshold(0.3))) >
             number_of(labels_of_hand(parameters::salience_threshold(0.7))));
  BOOST_TEST(number_of(labels_of_hand(parameters::maximum_number_of_segments(2))) == 2);
}

BOOST_AUTO_TEST_CASE(only_the_ratio_of_the_angle_weights_matters)
{
  BOOST_TEST(labels_of_hand(parameters::concave_angle_weight(8).convex_angle_weight(0.5)) ==
             labels_of_hand(parameters::concave_angle_weight(1).convex_angle_weight(0.0625)),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_seed_repeats_its_run_and_different_seeds_differ)
{
  const auto with_seed = [](auto seed)
  { return labels_of_hand(parameters::random_seed(seed).number_of_reference_faces(1)); };
  std::set<Labels> results;
  for (int seed = 0; seed < 8; ++seed) {
    const Labels labels = with_seed(seed);
    BOOST_TEST(labels == with_seed(static_cast<unsigned long long>(seed)),
               boost::test_tools::per_element());
    results.insert(labels);
  }
  BOOST_TEST(results.size() > 1);
}

BOOST_AUTO_TEST_CASE(points_come_from_the_vertex_point_map)
{
  const Mesh target = mesh_of(dumbbell(16, 12));
  Mesh flat = target;
  for (Vertex v : vertices(flat))
    flat.point(v) = Point(0, 0, 0);
  const auto points_of_target = boost::make_function_property_map<Vertex, const Point&>(
    [&](Vertex v) -> const Point& { return target.point(v); });

  const Labels expected = labels_of(target, parameters::default_values());
  BOOST_TEST(number_of(expected) > 1);
  BOOST_TEST(number_of(labels_of(flat, parameters::default_values())) == 1);
  BOOST_TEST(labels_of(flat, parameters::vertex_point_map(points_of_target)) == expected,
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_point_map_may_return_by_value)
{
  const auto by_value = boost::make_function_property_map<Vertex, Point>(
    [](Vertex v) { return hand().point(v); });
  BOOST_TEST(labels_of_hand(parameters::vertex_point_map(by_value)) == labels_of_hand(),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_minimal_traits_class_is_enough)
{
  Mesh rounded = hand();
  std::vector<Own_point> points;
  for (Vertex v : vertices(rounded)) {
    Point& p = rounded.point(v);
    points.push_back({{{float(p.x()), float(p.y()), float(p.z())}}});
    p = Point(points.back().x[0], points.back().x[1], points.back().x[2]);
  }
  const auto map = boost::make_iterator_property_map(points.begin(),
                                                     get(CGAL::vertex_index, rounded));
  BOOST_TEST(labels_of(rounded, parameters::vertex_point_map(map).geom_traits(Own_traits())) ==
             labels_of(rounded, parameters::default_values()), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_instance_of_the_traits_class_is_used)
{
  Mesh stretched = hand();
  for (Vertex v : vertices(stretched)) {
    Point& p = stretched.point(v);
    p = Point(p.x(), 4 * p.y(), p.z());
  }
  Scaling_traits traits;
  traits.scale[1] = 4;
  const Labels expected = labels_of(stretched, parameters::default_values());
  BOOST_TEST(labels_of_hand(parameters::geom_traits(traits)) == expected,
             boost::test_tools::per_element());
  BOOST_TEST((expected != labels_of_hand()));
}

BOOST_AUTO_TEST_CASE(segments_are_numbered_by_the_face_index_map)
{
  const Labels by_position = labels_of_hand();
  const std::size_t n = num_faces(hand());
  const auto reversed = boost::make_function_property_map<Face, std::size_t>(
    [n](Face f) { return n - 1 - f; });
  const Labels by_map = labels_of_hand(parameters::face_index_map(reversed));
  std::size_t next = 0;
  for (std::size_t f = n; f-- > 0;) {
    BOOST_TEST_REQUIRE(by_map[f] <= next);
    next += by_map[f] == next;
  }
  BOOST_TEST(next == number_of(by_position));
}

BOOST_AUTO_TEST_CASE(a_face_index_map_is_as_good_as_the_order_of_the_faces)
{
  // The same mesh with its faces stored in another order, and told the old one.
  Soup shuffled = read("hand.off");
  const std::size_t n = shuffled.triangles.size();
  std::vector<std::size_t> old_number(n);
  for (std::size_t i = 0; i < n; ++i)
    old_number[i] = (i * 7919 + 5) % n;
  std::vector<std::vector<std::size_t> > triangles(n);
  for (std::size_t i = 0; i < n; ++i)
    triangles[i] = shuffled.triangles[old_number[i]];
  BOOST_TEST_REQUIRE(std::set<std::size_t>(old_number.begin(), old_number.end()).size() == n);
  shuffled.triangles = triangles;

  const Labels expected = labels_of_hand();
  const Labels labels = labels_of(
    mesh_of(shuffled), parameters::face_index_map(
      boost::make_function_property_map<Face, std::size_t>([&](Face f) { return old_number[f]; })));
  for (std::size_t i = 0; i < n; ++i)
    BOOST_TEST(labels[i] == expected[old_number[i]]);
}

BOOST_AUTO_TEST_CASE(numbers_out_of_range_are_refused_by_name)
{
  check_refused("maximum_number_of_segments", parameters::maximum_number_of_segments(0));
  check_refused("maximum_number_of_segments", parameters::maximum_number_of_segments(-3));
  check_refused("maximum_number_of_segments", parameters::maximum_number_of_segments(0u));
  check_refused("minimum_segment_size", parameters::minimum_segment_size(-0.001));
  check_refused("minimum_segment_size", parameters::minimum_segment_size(0.501));
  check_refused("minimum_segment_size", parameters::minimum_segment_size(not_a_number));
  check_refused("salience_threshold", parameters::salience_threshold(not_a_number));
  check_refused("salience_weights", parameters::salience_weights(0.1, 0.6, 0.4));
  check_refused("salience_weights", parameters::salience_weights(0, 0, 0));
  check_refused("salience_weights", parameters::salience_weights(-0.1, 0.6, 0.5));
  check_refused("salience_weights", parameters::salience_weights(1.5, -0.5, 0));
  check_refused("salience_weights", parameters::salience_weights(0.5, 0.75, -0.25));
  check_refused("salience_weights", parameters::salience_weights(not_a_number, 0.5, 0.5));
  check_refused("salience_weights", parameters::salience_weights(infinity, 0, 0));
  check_refused("geodesic_weight", parameters::geodesic_weight(1.5));
  check_refused("geodesic_weight", parameters::geodesic_weight(-0.01));
  check_refused("geodesic_weight", parameters::geodesic_weight(not_a_number));
  check_refused("concave_angle_weight", parameters::concave_angle_weight(-1));
  check_refused("concave_angle_weight", parameters::concave_angle_weight(infinity));
  check_refused("concave_angle_weight", parameters::concave_angle_weight(not_a_number));
  check_refused("convex_angle_weight", parameters::convex_angle_weight(-1));
  check_refused("convex_angle_weight", parameters::convex_angle_weight(infinity));
  check_refused("convex_angle_weight", parameters::convex_angle_weight(not_a_number));
  check_refused("number_of_reference_faces", parameters::number_of_reference_faces(0));
  check_refused("number_of_reference_faces", parameters::number_of_reference_faces(-1));
  check_refused("number_of_smoothing_iterations", parameters::number_of_smoothing_iterations(-1));
}

BOOST_AUTO_TEST_CASE(the_ends_of_the_ranges_are_taken)
{
  const std::size_t n = num_faces(hand());
  const auto is_taken = [&](const auto& np) { return number_of(labels_of_hand(np)) <= n; };
  BOOST_TEST(is_taken(parameters::salience_threshold(-infinity).maximum_number_of_segments(2)));
  BOOST_TEST(is_taken(parameters::salience_threshold(infinity)));
  BOOST_TEST(is_taken(parameters::minimum_segment_size(0)));
  BOOST_TEST(is_taken(parameters::minimum_segment_size(0.5)));
  BOOST_TEST(is_taken(parameters::salience_weights(1, 0, 0)));
  BOOST_TEST(is_taken(parameters::salience_weights(0, 1, 0)));
  BOOST_TEST(is_taken(parameters::salience_weights(0, 0, 1)));
  BOOST_TEST(is_taken(parameters::geodesic_weight(0)));
  BOOST_TEST(is_taken(parameters::geodesic_weight(1)));
  BOOST_TEST(is_taken(parameters::concave_angle_weight(0).convex_angle_weight(0)));
  BOOST_TEST(is_taken(parameters::concave_angle_weight(1e300).convex_angle_weight(1e300)));
  BOOST_TEST(is_taken(parameters::concave_angle_weight(1e-300).convex_angle_weight(1e-300)));
  BOOST_TEST(is_taken(parameters::number_of_reference_faces(1)));
  const Mesh small = mesh_of(dumbbell(8, 6));
  BOOST_TEST(labels_of(small, parameters::number_of_reference_faces(num_faces(small))) ==
             labels_of(small, parameters::number_of_reference_faces(num_faces(small) + 1)),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_face_index_map_that_does_not_number_the_faces_is_refused)
{
  const int last = int(num_faces(hand())) - 1;
  const auto refuse = [](const auto& function) {
    check_refused("face_index_map", parameters::face_index_map(
      boost::make_function_property_map<Face, int>(function)));
  };
  refuse([](Face) { return 0; });
  refuse([](Face f) { return int(f) + 1; });
  refuse([](Face f) { return int(f) - 1; });
  refuse([last](Face f) { return int(f) == last ? 0 : int(f); });
}
