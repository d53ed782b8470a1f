// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

// Segmentation with features of the faces.
BOOST_AUTO_TEST_SUITE(face_features)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
typedef Mesh::Face_index Face;

namespace {

template <class Function>
auto map_of(const Function& function)
{ return boost::make_function_property_map<Face>(function); }

// The height of the center of a face, times 3.
double height(const Mesh& mesh, Face f)
{
  double sum = 0;
  for (Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
    sum += mesh.point(v).z();
  return sum;
}

// A sphere, which has no parts, and whether each face is in the upper half. No face crosses the
// equator by much.
const Mesh& ball()
{
  static const Mesh result = mesh_of(sphere(4));
  return result;
}

Labels halves()
{
  Labels result;
  for (Face f : ball().faces())
    result.push_back(height(ball(), f) > 0);
  return result;
}

// Checks that there are two segments, the halves but for faces near the equator.
void check_halves(const Labels& labels, double least_rand_index)
{
  BOOST_TEST(number_of(labels) == 2);
  BOOST_TEST(rand_index(labels, halves()) > least_rand_index);
}

template <class Function>
void check_error(const Mesh& mesh, const Function& function, const std::string& part)
{
  check_refused(mesh, parameters::face_feature_map(map_of(function)), part);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_shape_without_parts_is_cut_where_features_change)
{
  BOOST_TEST(number_of(labels_of(ball(), parameters::default_values())) == 1);
  const Labels half = halves();
  const auto segments = [&](const auto& function)
  { return labels_of(ball(), parameters::face_feature_map(map_of(function))); };

  const Labels of_labels = segments([&](Face f) { return half[f] == 1 ? -7 : 1000000; });
  check_halves(of_labels, 0.97);
  check_halves(segments([&](Face f) { return double(half[f]); }), 0.97);
  check_halves(segments([&](Face f) { return std::array<float, 3>{1, 0.5f, half[f] ? 1.f : 0.f}; }),
               0.97);
  check_halves(segments([&](Face f) { return std::vector<int>(100, half[f] == 1 ? 3 : 4); }), 0.8);
  BOOST_TEST(segments([&](Face f) { return half[f]; }) == of_labels, "names of labels matter");
}

BOOST_AUTO_TEST_CASE(unit_and_offset_make_no_difference)
{
  const Labels half = halves();
  const auto segments = [&](double unit, double offset) {
    return labels_of(ball(), parameters::face_feature_map(map_of([=](Face f)
      { return offset + unit * (double(half[f]) + 0.25 * std::sin(double(std::size_t(f)))); })));
  };
  const Labels expected = segments(1, 0);
  check_halves(expected, 0.8);
  for (double unit : {1e-90, -1., 1024., 1e90})
    BOOST_TEST(segments(unit, 0) == expected, unit);
  BOOST_TEST(segments(1, 1 << 20) == expected);
}

BOOST_AUTO_TEST_CASE(uninformative_features_change_nothing)
{
  const Mesh mesh = mesh_of(doll());
  const Labels expected = labels_of(mesh, parameters::default_values());
  BOOST_TEST(number_of(expected) > 2);
  const auto same = parameters::face_feature_map(map_of([](Face) { return 0.1; }));
  BOOST_TEST(labels_of(mesh, same) == expected);
  BOOST_TEST(labels_of(mesh, same.feature_weight(1)) == expected);
  const auto halves_of_doll =
    parameters::face_feature_map(map_of([&](Face f) { return int(height(mesh, f) > 3); }));
  BOOST_TEST(labels_of(mesh, halves_of_doll.feature_weight(0)) == expected);

  Mesh bells = mesh_of(dumbbell(40, 40));
  Random random(1);
  std::vector<double> noise;
  for (std::size_t f = 0; f < bells.number_of_faces(); ++f)
    noise.push_back(double(random()) / double(Random::max()));
  const Labels spheres = labels_of(bells, parameters::default_values());
  BOOST_TEST(number_of(spheres) == 2);
  BOOST_TEST(rand_index(labels_of(bells, parameters::face_feature_map(map_of([&](Face f)
    { return noise[f]; }))), spheres) > 0.99);
}

BOOST_AUTO_TEST_CASE(noisy_labels_become_parts)
{
  Random random(2);
  Labels noisy = halves();
  for (std::size_t& label : noisy)
    if (random_number(random, 1, 5) == 1)
      label = random_number(random, 0, 3);
  const auto np = parameters::face_feature_map(map_of([&](Face f) { return noisy[f]; }));
  const Labels labels = labels_of(ball(), np);
  check_halves(labels, 0.8);
  check_labels(ball(), labels);
  BOOST_TEST(labels_of<CGAL::Sequential_tag>(ball(), np) == labels);
}

BOOST_AUTO_TEST_CASE(the_weight_decides_between_shape_and_features)
{
  // Two spheres in a row; the features separate left from right.
  const Mesh mesh = mesh_of(dumbbell(40, 40));
  Labels of_shape, of_features;
  for (Face f : mesh.faces()) {
    double x = 0;
    for (Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      x += mesh.point(v).x();
    of_shape.push_back(height(mesh, f) > 0);
    of_features.push_back(x > 0);
  }
  const auto segments = [&](double weight) {
    return labels_of(mesh, parameters::face_feature_map(map_of([&](Face f)
      { return of_features[f]; })).feature_weight(weight).number_of_segments(2));
  };
  BOOST_TEST(rand_index(segments(0), of_shape) > 0.99);
  BOOST_TEST(rand_index(segments(1), of_features) > 0.9);
}

// A painted ball beside others: three components, of which one has two colors.
BOOST_AUTO_TEST_CASE(a_component_is_cut_where_features_change)
{
  const Soup ball_soup = sphere(3);
  const std::size_t n = ball_soup.triangles.size();
  const Mesh mesh = mesh_of(disjoint_union(
    disjoint_union(ball_soup, moved(ball_soup, 1.99, 0, 0)), moved(ball_soup, 3.98, 0, 0)));
  BOOST_TEST(number_of(labels_of(mesh, parameters::default_values())) == 3);
  Labels color;
  for (Face f : mesh.faces())
    color.push_back(std::size_t(f) >= n ? 0 : height(mesh, f) > 0 ? 1 : 2);
  const Labels labels = labels_of(mesh, parameters::face_feature_map(map_of([&](Face f)
    { return color[f]; })).feature_weight(1).number_of_segments(4));
  const Labels painted(labels.begin(), labels.begin() + std::ptrdiff_t(n)),
    colors(color.begin(), color.begin() + std::ptrdiff_t(n));
  BOOST_TEST(rand_index(painted, colors) > 0.85);
  BOOST_TEST(labels[n] != labels[2 * n]);
}

BOOST_AUTO_TEST_CASE(many_labels)
{
  // Ten times ten patches of a torus, each with a label of its own.
  const std::size_t n = 40;
  const Mesh mesh = mesh_of(torus(2, 0.7, n, n));
  Labels patch;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      patch.insert(patch.end(), 2, i / 4 * 10 + j / 4);
  const Labels labels = labels_of(mesh, parameters::face_feature_map(map_of([&](Face f)
    { return patch[f]; })).number_of_segments(20));
  BOOST_TEST(number_of(labels) == 20);
  check_labels(mesh, labels);
}

// A face without area may have any number.
BOOST_AUTO_TEST_CASE(outliers_of_no_area)
{
  Soup soup = sphere(4);
  const Labels half = halves();
  soup.triangles.push_back({0, 1, 0}); // of two points
  for (double outlier : {1e140, -1e140, 1e9}) {
    Labels labels(soup.triangles.size(), untouched);
    std::vector<double> features(half.begin(), half.end());
    features.push_back(outlier);
    CGAL::segment_spectral_recursive(soup.points, soup.triangles, labels.data(),
                                     parameters::face_feature_map(features.data()));
    labels.pop_back();
    BOOST_TEST(rand_index(labels, half) > 0.9);
  }
}

BOOST_AUTO_TEST_CASE(soups_have_features_too)
{
  const Soup soup = sphere(4);
  const Labels half = halves();
  Labels labels(soup.triangles.size(), untouched);
  CGAL::segment_spectral_recursive(soup.points, soup.triangles, labels.data(),
                                   parameters::face_feature_map(half.data()));
  BOOST_TEST(labels == labels_of(soup, parameters::face_feature_map(map_of([&](Face f)
    { return half[f]; }))));
  CGAL::segment_spectral_recursive(std::vector<Point>(), std::vector<std::array<int, 3> >(),
                                   labels.data(), parameters::face_feature_map(half.data()));
}

BOOST_AUTO_TEST_CASE(bad_features_are_reported)
{
  const Mesh mesh = mesh_of(dumbbell(6, 4));
  const double infinity = std::numeric_limits<double>::infinity();
  const auto zero_but = [](std::size_t face, double x)
  { return [=](Face f) { return std::size_t(f) == face ? x : 0; }; };
  check_error(mesh, zero_but(17, infinity), "not finite, at face 17");
  check_error(mesh, zero_but(3, infinity - infinity), "not finite, at face 3");
  check_error(mesh, zero_but(3, 1e300), "too large");
  check_error(mesh, [](Face f) { return std::vector<float>(std::size_t(f) == 5 ? 3 : 2); },
              "2 numbers at face 0, but 3 at face 5");
  check_error(mesh, [](Face) { return std::vector<float>(); }, "have no numbers");

  const auto features =
    parameters::face_feature_map(map_of([](Face f) { return int(std::size_t(f) % 2); }));
  for (double weight : {-0.1, 1.1, infinity, infinity - infinity})
    check_refused(mesh, features.feature_weight(weight));
  check_refused(mesh, features.options(CGAL::Spectral_segmentation::Options::zhang_liu_2005()));
}

BOOST_AUTO_TEST_SUITE_END()
