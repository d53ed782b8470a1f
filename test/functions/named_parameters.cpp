// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(named_parameters)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Calibrated_part_salience;
using CGAL::Spectral_segmentation::Salience_factors;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using CGAL::Spectral_segmentation::Segmentation_visitor;
using CGAL::Spectral_segmentation::Weighted_part_salience;

namespace {

typedef Mesh::Face_index Face;
typedef Mesh::Vertex_index Vertex;

const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

// A mesh on which each parameter makes a difference.
const Mesh& doll_mesh()
{
  static const Mesh mesh = mesh_of(doll());
  return mesh;
}

template <class NamedParameters>
Labels labels_of_doll(const NamedParameters& np)
{ return labels_of(doll_mesh(), np); }

Labels labels_of_doll() { return labels_of_doll(parameters::default_values()); }

template <class NamedParameters>
void check_refused(const std::string& name, const NamedParameters& np)
{ test_meshes::check_refused(doll_mesh(), np, name); }

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

BOOST_AUTO_TEST_CASE(maps_and_traits_come_from_the_mesh_by_default)
{
  Segmentation_visitor visitor;
  const Labels labels = labels_of_doll();
  BOOST_TEST(number_of(labels) > 1);
  BOOST_TEST(labels == labels_of_doll(
    parameters::vertex_point_map(get(CGAL::vertex_point, doll_mesh()))
      .face_index_map(get(CGAL::face_index, doll_mesh())).geom_traits(Kernel()).visitor(visitor)),
    boost::test_tools::per_element());
  Labels without_pack;
  CGAL::segment_spectral_recursive(doll_mesh(), map_to(without_pack, doll_mesh()));
  BOOST_TEST(labels == without_pack, boost::test_tools::per_element());
}

// The search on a coarse mesh begins above the default.
BOOST_AUTO_TEST_CASE(the_default_number_of_coarse_faces)
{
  const auto has_projection = [](const Soup& soup, const auto& np) {
    struct Visitor : Segmentation_visitor
    {
      bool has_projection = false;
      void before_stage(CGAL::Spectral_segmentation::Stage stage, std::size_t)
      {
        has_projection =
          has_projection || stage == CGAL::Spectral_segmentation::Stage::PROJECTION;
      }
    } visitor;
    labels_of(soup, np.visitor(std::ref(visitor)));
    return visitor.has_projection;
  };
  // Faces of the first are bisected; edges of the second, which is even, are collapsed.
  const Soup coarse = plate(4, 4), fine = sphere(4);
  const auto by_default = parameters::default_values();
  for (const Soup& soup : {coarse, fine}) {
    BOOST_TEST(has_projection(soup, by_default));
    BOOST_TEST(!has_projection(soup, by_default.number_of_coarse_faces(0)));
    BOOST_TEST(!has_projection(soup, parameters::zhang_liu_2005()));
  }
  // In proportion with more than 20 segments: the sphere has 5120 faces.
  const auto of_2500 = by_default.number_of_coarse_faces(2500).number_of_searches(1);
  BOOST_TEST(has_projection(fine, of_2500.maximum_number_of_segments(40)));
  BOOST_TEST(!has_projection(fine, of_2500.maximum_number_of_segments(41)));
}

BOOST_AUTO_TEST_CASE(weights_are_a_part_salience)
{
  for_both_methods([](const auto& np) {
    const Labels expected = labels_of_doll(np.salience_weights(0.5, 0.4, 0.1));
    BOOST_TEST(expected ==
               labels_of_doll(np.part_salience(Weighted_part_salience{0.5, 0.4, 0.1})),
               boost::test_tools::per_element());
    // The last one counts.
    BOOST_TEST(expected == labels_of_doll(np.part_salience(Calibrated_part_salience())
                                            .salience_weights(0.5, 0.4, 0.1)),
               boost::test_tools::per_element());
  });
  BOOST_TEST(labels_of_doll() ==
             labels_of_doll(parameters::salience_weights(0.5, 0.4, 0.1)
                              .part_salience(Calibrated_part_salience())),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_salience_may_have_any_scale)
{
  const auto probability = [](const Salience_factors& f)
  { return Calibrated_part_salience()(f); };
  const auto logit = [probability](const Salience_factors& f) {
    const double p = probability(f);
    return std::log(p / (1 - p));
  };
  BOOST_TEST(labels_of_doll(parameters::part_salience(probability).salience_threshold(0.3)) ==
             labels_of_doll(parameters::part_salience(logit)
                              .salience_threshold(std::log(0.3 / 0.7))),
             boost::test_tools::per_element());
  const auto eight_times = [](const Salience_factors& f) -> float
  { return float(8 * Weighted_part_salience()(f)); };
  BOOST_TEST(labels_of_doll(parameters::zhang_liu_2005().salience_threshold(0.54)) ==
             labels_of_doll(parameters::zhang_liu_2005().part_salience(eight_times)
                              .salience_threshold(8 * 0.54)), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_salience_is_given_the_factors_that_are_documented)
{
  const auto is_given_more_than_the_paper = [](const auto& np) {
    std::atomic<bool> is_called{false}, result{false};
    labels_of_doll(np.part_salience([&](const Salience_factors& f) {
      if (f.size > 0)
        is_called = true;
      if (f.log_relative_part_area < 0 || f.concavity_near_cut > 0 || f.convexity_gain != 0 ||
          f.relative_convexity_gain != 0 || f.expansion_behind_cut > 0)
        result = true;
      return Weighted_part_salience()(f);
    }));
    BOOST_TEST(is_called);
    return bool(result);
  };
  BOOST_TEST(is_given_more_than_the_paper(parameters::default_values()));
  BOOST_TEST(!is_given_more_than_the_paper(parameters::zhang_liu_2005()));
}

BOOST_AUTO_TEST_CASE(an_exception_of_a_salience_passes_through_and_leaves_the_labels)
{
  const auto failing = [](const Salience_factors&) -> double
  { throw std::runtime_error("failure of a salience"); };
  for_both_methods([&](const auto& np) {
    Labels labels;
    const auto map = map_to(labels, doll_mesh());
    const Labels before = labels;
    BOOST_CHECK_THROW(
      CGAL::segment_spectral_recursive(doll_mesh(), map, np.part_salience(failing)),
      std::runtime_error);
    BOOST_TEST(labels == before, boost::test_tools::per_element());
  });
}

BOOST_AUTO_TEST_CASE(parameters_chain_in_any_order)
{
  Segmentation_hierarchy hierarchy_1, hierarchy_2, hierarchy_3, hierarchy_4;
  const auto point = get(CGAL::vertex_point, doll_mesh());
  const Labels a = labels_of_doll(
    parameters::vertex_point_map(point).salience_threshold(0.4).random_seed(3)
      .maximum_number_of_segments(5).hierarchy(hierarchy_1).keep_components_separate(true));
  const Labels b = labels_of_doll(
    CGAL::parameters::keep_components_separate(true).hierarchy(hierarchy_2)
      .maximum_number_of_segments(5).random_seed(3).salience_threshold(0.4)
      .vertex_point_map(point));
  const Labels c = labels_of_doll(
    parameters::from(CGAL::parameters::random_seed(3).vertex_point_map(point))
      .hierarchy(hierarchy_3).keep_components_separate(true).salience_threshold(0.4)
      .maximum_number_of_segments(5));
  const Labels d = labels_of_doll(CGAL::parameters::combine(
    CGAL::parameters::random_seed(3).vertex_point_map(point),
    CGAL::parameters::hierarchy(hierarchy_4).keep_components_separate(true),
    CGAL::parameters::salience_threshold(0.4).maximum_number_of_segments(5)));
  for (const Labels& labels : {b, c, d})
    BOOST_TEST(a == labels, boost::test_tools::per_element());
  for (const Segmentation_hierarchy* hierarchy :
       {&hierarchy_1, &hierarchy_2, &hierarchy_3, &hierarchy_4})
    BOOST_TEST(run_labels(*hierarchy) == a, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_pack_of_CGAL_is_taken_as_it_is)
{
  std::vector<Point> stretched;
  for (Vertex v : vertices(doll_mesh()))
    stretched.emplace_back(doll_mesh().point(v).x(), 3 * doll_mesh().point(v).y(),
                           doll_mesh().point(v).z());
  const auto map = boost::make_iterator_property_map(stretched.begin(),
                                                     get(CGAL::vertex_index, doll_mesh()));
  BOOST_TEST(labels_of_doll(CGAL::parameters::vertex_point_map(map).random_seed(5)) ==
             labels_of_doll(parameters::random_seed(5).vertex_point_map(map)),
             boost::test_tools::per_element());
  BOOST_TEST(labels_of_doll(CGAL::parameters::all_default()) == labels_of_doll(),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_last_value_wins)
{
  BOOST_TEST(number_of(labels_of_doll(
    parameters::maximum_number_of_segments(2).salience_threshold(-infinity)
      .maximum_number_of_segments(std::size_t(4)))) == 4);
  BOOST_TEST(number_of(labels_of_doll(
    parameters::salience_threshold(-infinity).salience_threshold(infinity))) == 1);
  BOOST_TEST(number_of(labels_of_doll(
    parameters::from(CGAL::parameters::random_seed(1)).maximum_number_of_segments(0)
      .maximum_number_of_segments(1))) == 1);
}

BOOST_AUTO_TEST_CASE(numbers_of_any_type_are_taken)
{
  const Labels labels = labels_of_doll(
    parameters::maximum_number_of_segments(3).salience_threshold(0));
  BOOST_TEST(labels == labels_of_doll(
    parameters::maximum_number_of_segments(3ull).salience_threshold(0.f)));
  BOOST_TEST(labels == labels_of_doll(
    parameters::maximum_number_of_segments(short(3)).salience_threshold(0u)));
}

BOOST_AUTO_TEST_CASE(a_seed_repeats_its_run_and_different_seeds_differ)
{
  const auto with_seed = [](auto seed)
  {
    return labels_of_doll(
      parameters::random_seed(seed).number_of_reference_faces(1).number_of_segments(15));
  };
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
    [](Vertex v) { return doll_mesh().point(v); });
  BOOST_TEST(labels_of_doll(parameters::vertex_point_map(by_value)) == labels_of_doll(),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_minimal_traits_class_is_enough)
{
  Mesh rounded = doll_mesh();
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
  Mesh stretched = doll_mesh();
  for (Vertex v : vertices(stretched)) {
    Point& p = stretched.point(v);
    p = Point(p.x(), 4 * p.y(), p.z());
  }
  Scaling_traits traits;
  traits.scale[1] = 4;
  const Labels expected = labels_of(stretched, parameters::default_values());
  BOOST_TEST(labels_of_doll(parameters::geom_traits(traits)) == expected,
             boost::test_tools::per_element());
  BOOST_TEST((expected != labels_of_doll()));
}

BOOST_AUTO_TEST_CASE(segments_are_numbered_by_the_face_index_map)
{
  const Labels by_position = labels_of_doll();
  const std::size_t n = num_faces(doll_mesh());
  const auto reversed = boost::make_function_property_map<Face, std::size_t>(
    [n](Face f) { return n - 1 - f; });
  const Labels by_map = labels_of_doll(parameters::face_index_map(reversed));
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
  Soup shuffled = doll();
  const std::size_t n = shuffled.triangles.size();
  std::vector<std::size_t> old_number(n);
  for (std::size_t i = 0; i < n; ++i)
    old_number[i] = (i * 7919 + 5) % n;
  std::vector<std::vector<std::size_t> > triangles(n);
  for (std::size_t i = 0; i < n; ++i)
    triangles[i] = shuffled.triangles[old_number[i]];
  BOOST_TEST_REQUIRE(std::set<std::size_t>(old_number.begin(), old_number.end()).size() == n);
  shuffled.triangles = triangles;

  const Labels expected = labels_of_doll();
  const Labels labels = labels_of(
    mesh_of(shuffled), parameters::face_index_map(
      boost::make_function_property_map<Face, std::size_t>([&](Face f) { return old_number[f]; })));
  for (std::size_t i = 0; i < n; ++i)
    BOOST_TEST(labels[i] == expected[old_number[i]]);
}

// The suite of the options tests the ranges. These are values that could be lost on the way there.
BOOST_AUTO_TEST_CASE(numbers_out_of_range_are_refused_by_name)
{
  check_refused("maximum_number_of_segments", parameters::maximum_number_of_segments(-3));
  check_refused("maximum_number_of_segments", parameters::maximum_number_of_segments(0u));
  check_refused("number_of_coarse_faces", parameters::number_of_coarse_faces(-1));
  check_refused("number_of_searches", parameters::number_of_searches(-1));
  check_refused("number_of_reference_faces", parameters::number_of_reference_faces(-1));
  check_refused("number_of_smoothing_iterations", parameters::number_of_smoothing_iterations(-1));
  check_refused("feature_weight", parameters::feature_weight(not_a_number));
  check_refused("salience_weights", parameters::salience_weights(0.1, 0.6, 0.4));
  check_refused("distance_weights", parameters::distance_weights(0.03, 1, -1));
}

BOOST_AUTO_TEST_CASE(a_face_index_map_that_does_not_number_the_faces_is_refused)
{
  const int last = int(num_faces(doll_mesh())) - 1;
  const auto refuse = [](const auto& function) {
    check_refused("face_index_map", parameters::face_index_map(
      boost::make_function_property_map<Face, int>(function)));
  };
  refuse([](Face) { return 0; });
  refuse([](Face f) { return int(f) + 1; });
  refuse([](Face f) { return int(f) - 1; });
  refuse([last](Face f) { return int(f) == last ? 0 : int(f); });
}

BOOST_AUTO_TEST_SUITE_END()
