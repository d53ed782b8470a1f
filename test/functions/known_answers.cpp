// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Segmented_mesh/refine_segment_boundaries.h>
#include <CGAL/segment_spectral_recursive.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

// The default method on meshes of CGAL, coarse or with long thin triangles, whose parts nobody
// would dispute. Each part is told by its place.
BOOST_AUTO_TEST_SUITE(known_answers)

using namespace test_meshes;

namespace {

struct Segmented_mesh
{
  Soup soup;
  Labels labels;

  explicit Segmented_mesh(const char* name)
    : Segmented_mesh(name, CGAL::Spectral_segmentation::parameters::default_values()) {}

  template <class NamedParameters>
  Segmented_mesh(const char* name, const NamedParameters& np)
    : soup(read(name)), labels(labels_of(soup, np)) {}

  Eigen::Vector3d centroid(std::size_t f) const
  {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (std::size_t v : soup.triangles[f])
      result += Eigen::Vector3d(soup.points[v].x(), soup.points[v].y(), soup.points[v].z()) / 3;
    return result;
  }

  // The segments of the faces whose centroids fulfil a condition.
  template <class Condition>
  std::set<std::size_t> segments(const Condition& condition) const
  {
    std::set<std::size_t> result;
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (condition(centroid(f)))
        result.insert(labels[f]);
    return result;
  }

  // Returns the fraction of the faces of a place that belong to the segment with most of them.
  template <class Condition>
  double largest_fraction(const Condition& condition) const
  {
    std::vector<std::size_t> number(labels.size(), 0);
    std::size_t all = 0;
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (condition(centroid(f))) {
        ++number[labels[f]];
        ++all;
      }
    return static_cast<double>(*std::max_element(number.begin(), number.end())) /
           static_cast<double>(all);
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(a_rotor_has_a_body_and_two_pins)
{
  const Segmented_mesh rotor("rotor.off");
  const auto pin = [&](double sign)
    { return rotor.segments([=](const Eigen::Vector3d& p) { return sign * p.z() > 0.45; }); };
  // The ring turns around the x axis. Its side away from the pins
  const auto body = rotor.segments([](const Eigen::Vector3d& p) { return std::abs(p.z()) < 0.3; });
  BOOST_TEST(number_of(rotor.labels) == 3);
  BOOST_TEST(pin(1).size() == 1);
  BOOST_TEST(pin(-1).size() == 1);
  BOOST_TEST(body.size() == 1);
  BOOST_TEST(*pin(1).begin() != *pin(-1).begin());
}

BOOST_AUTO_TEST_CASE(most_teeth_of_a_pinion_are_segments)
{
  // Teeth are parts of a wheel or not, as a matter of taste. They are its most salient parts. It
  // has ten.
  const Segmented_mesh pinion("pinion.off",
    CGAL::Spectral_segmentation::parameters::number_of_segments(10));
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Point& p : pinion.soup.points) {
    const Eigen::Vector3d q(p.x(), p.y(), p.z()); // the center is the origin
    moments += q * q.transpose();
  }
  // The teeth stand around the axis to which no other one is equal.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  const Eigen::Vector3d values = solver.eigenvalues();
  const int axis = values[1] - values[0] > values[2] - values[1] ? 0 : 2;
  const auto place = [&](const Eigen::Vector3d& p) { // around the axis
    return Eigen::Vector2d(p.dot(solver.eigenvectors().col((axis + 1) % 3)),
                           p.dot(solver.eigenvectors().col((axis + 2) % 3)));
  };
  double radius = 0;
  for (std::size_t f = 0; f < pinion.labels.size(); ++f)
    radius = (std::max)(radius, place(pinion.centroid(f)).norm());
  std::set<double> directions; // directions of the tips
  for (std::size_t f = 0; f < pinion.labels.size(); ++f) {
    const Eigen::Vector2d p = place(pinion.centroid(f));
    if (p.norm() > 0.95 * radius)
      directions.insert(std::atan2(p.y(), p.x()));
  }
  std::vector<double> gaps; // each in the middle between two tips
  for (auto d = directions.begin(); std::next(d) != directions.end(); ++d)
    if (*std::next(d) - *d > 0.3)
      gaps.push_back((*d + *std::next(d)) / 2);
  BOOST_TEST_REQUIRE(gaps.size() >= 9); // there are ten; one may be where the angle leaps
  std::set<std::size_t> teeth;
  for (std::size_t i = 0; i + 1 < gaps.size(); ++i) {
    const auto tooth = pinion.segments([&](const Eigen::Vector3d& p) {
      const double direction = std::atan2(place(p).y(), place(p).x());
      return place(p).norm() > 0.95 * radius && direction > gaps[i] && direction < gaps[i + 1];
    });
    if (tooth.size() == 1)
      teeth.insert(*tooth.begin());
  }
  BOOST_TEST(2 * teeth.size() > gaps.size());
}

BOOST_AUTO_TEST_CASE(both_arms_of_a_cactus_are_cut_off)
{
  const Segmented_mesh cactus("cactus.off");
  const auto is_trunk = [](const Eigen::Vector3d& p) { return p.y() < -0.2 || p.y() > 0.48; };
  BOOST_TEST(cactus.segments(is_trunk).size() == 1);
  for (double side : {-1, 1}) {
    const auto upper = [=](const Eigen::Vector3d& p)
      { return side * p.x() > 0.25 && p.y() > 0.25; };
    const auto lower = [=](const Eigen::Vector3d& p) { // between the trunk and the elbow
      return side * p.x() > 0.13 && side * p.x() < 0.165 && p.y() > -0.2 && p.y() < 0.2;
    };
    BOOST_TEST(cactus.segments(upper).size() == 1);
    BOOST_TEST(cactus.largest_fraction(lower) > 0.9);
    BOOST_TEST(cactus.segments(upper).count(*cactus.segments(is_trunk).begin()) == 0);
  }
  BOOST_TEST(number_of(cactus.labels) <= 5); // an arm may also be cut at the elbow
}

BOOST_AUTO_TEST_CASE(an_elephant_has_four_legs_apart_from_its_chest)
{
  const Segmented_mesh elephant("elephant.off");
  typedef Eigen::Vector3d P;
  const std::set<std::size_t> feet[] = {
    elephant.segments([](const P& p) { return p.z() < -0.25 && p.x() > 0.2; }),
    elephant.segments([](const P& p) { return p.y() < -0.44 && p.x() > 0.05; }),
    elephant.segments([](const P& p) { return p.y() < -0.47 && p.x() < -0.04; }),
    elephant.segments([](const P& p) { return p.y() < -0.4 && p.x() < -0.2; })};
  const auto chest = elephant.segments([](const P& p)
    { return p.x() > 0.1 && p.x() < 0.14 && p.y() > -0.14 && p.y() < -0.1; });
  std::set<std::size_t> legs;
  for (const std::set<std::size_t>& foot : feet) {
    BOOST_TEST(foot.size() == 1);
    BOOST_TEST(chest.count(*foot.begin()) == 0);
    legs.insert(*foot.begin());
  }
  BOOST_TEST(legs.size() == 4);
}

BOOST_AUTO_TEST_CASE(a_knot_stays_whole)
{ BOOST_TEST(number_of(Segmented_mesh("knot1.off").labels) == 1); }

// Two of its parts meet in a concave crease of long edges, which a smooth boundary would leave.
BOOST_AUTO_TEST_CASE(refined_boundaries_of_the_anchor_keep_its_long_creases)
{
  typedef std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t> > Faces_of_edge;
  const auto faces_of_edges = [](const Soup& soup) {
    Faces_of_edge result;
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        result[std::minmax({soup.triangles[f][i], soup.triangles[f][(i + 1) % 3]})].push_back(f);
    return result;
  };
  Segmented_mesh anchor("anchor.off");
  Soup refined = anchor.soup;
  Labels labels = anchor.labels;
  CGAL::refine_segment_boundaries(refined.points, refined.triangles, labels);
  const Faces_of_edge after = faces_of_edges(refined);
  const auto normal = [&](std::size_t f) {
    std::array<Point, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = anchor.soup.points[anchor.soup.triangles[f][i]];
    return CGAL::unit_normal(p[0], p[1], p[2]);
  };
  std::size_t creases = 0;
  for (const auto& [edge, faces] : faces_of_edges(anchor.soup)) {
    const Eigen::Vector3d step = anchor.centroid(faces[1]) - anchor.centroid(faces[0]);
    const auto n = normal(faces[0]);
    if (anchor.labels[faces[0]] == anchor.labels[faces[1]] || n * normal(faces[1]) > 0.5 ||
        step.dot(Eigen::Vector3d(n.x(), n.y(), n.z())) < 0 ||
        CGAL::squared_distance(anchor.soup.points[edge.first], anchor.soup.points[edge.second]) <
          0.45 * 0.45) // edges are 0.14 long in the mean
      continue;
    ++creases;
    BOOST_TEST_REQUIRE(after.count(edge) == 1u);
    BOOST_TEST(labels[after.at(edge)[0]] != labels[after.at(edge)[1]]);
  }
  BOOST_TEST(creases >= 1u);
}

BOOST_AUTO_TEST_SUITE_END()
