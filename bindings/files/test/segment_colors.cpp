// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../segment_colors.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(segment_colors)

using segment_mesh::Rgb;
using segment_mesh::segment_colors;

typedef std::vector<std::vector<std::size_t> > Neighbors;

namespace {

// The formulas of IEC 61966-2-1.
double linear_intensity(double c)
{ return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

// CIE 1976 L*a*b* of a linear RGB color, white D65, from the formulas of CIE 15.
std::array<double, 3> lab_of_linear(const double (&linear)[3])
{
  const auto f = [](double t) {
    const double d = 6. / 29;
    return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4. / 29;
  };
  const double x =
    f((0.4124564 * linear[0] + 0.3575761 * linear[1] + 0.1804375 * linear[2]) / 0.95047);
  const double y = f(0.2126729 * linear[0] + 0.7151522 * linear[1] + 0.0721750 * linear[2]);
  const double z =
    f((0.0193339 * linear[0] + 0.1191920 * linear[1] + 0.9503041 * linear[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

std::array<double, 3> lab(const Rgb& rgb)
{
  double linear[3];
  for (int i = 0; i < 3; ++i)
    linear[i] = linear_intensity(rgb[i] / 255.);
  return lab_of_linear(linear);
}

double difference(const Rgb& a, const Rgb& b)
{
  const std::array<double, 3> p = lab(a), q = lab(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double smallest_difference_of_neighbors(const Neighbors& neighbors, const std::vector<Rgb>& colors)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < neighbors.size(); ++a)
    for (std::size_t b : neighbors[a])
      smallest = (std::min)(smallest, difference(colors[a], colors[b]));
  return smallest;
}

// Returns the color that a person without one kind of cones sees. A matrix maps linear RGB.
std::array<double, 3> lab_without_cones(const Rgb& rgb, const double (&matrix)[3][3])
{
  double linear[3];
  for (int i = 0; i < 3; ++i)
    linear[i] = linear_intensity(rgb[i] / 255.);
  double seen[3] = {0, 0, 0};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      seen[i] += matrix[i][k] * linear[k];
  for (double& x : seen)
    x = std::clamp(x, 0., 1.);
  return lab_of_linear(seen);
}

bool all_differ(const std::vector<Rgb>& colors)
{ return std::set<Rgb>(colors.begin(), colors.end()).size() == colors.size(); }

void connect(Neighbors& neighbors, std::size_t a, std::size_t b)
{
  neighbors[a].push_back(b);
  neighbors[b].push_back(a);
}

// A planar graph with as many edges as it can have: each new node goes into a random triangle.
Neighbors random_triangulation(std::size_t n, std::mt19937& random)
{
  Neighbors neighbors(n);
  std::vector<std::array<std::size_t, 3> > triangles{{0, 1, 2}, {0, 1, 2}};
  connect(neighbors, 0, 1);
  connect(neighbors, 1, 2);
  connect(neighbors, 2, 0);
  for (std::size_t v = 3; v < n; ++v) {
    const std::size_t i = random() % triangles.size();
    const std::array<std::size_t, 3> t = triangles[i];
    for (std::size_t corner : t)
      connect(neighbors, v, corner);
    triangles[i] = {t[0], t[1], v};
    triangles.push_back({t[1], t[2], v});
    triangles.push_back({t[2], t[0], v});
  }
  return neighbors;
}

// Nearby nodes of a ring, as of segments with any neighbors on a surface with handles.
Neighbors random_ring(std::size_t n, std::mt19937& random)
{
  Neighbors neighbors(n);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t step = 1; step <= 6 && a + step < n; ++step)
      if (random() % 2 == 0)
        connect(neighbors, a, a + step);
  return neighbors;
}

} // namespace

BOOST_AUTO_TEST_CASE(no_segments)
{
  BOOST_TEST(segment_colors({}).empty());
}

BOOST_AUTO_TEST_CASE(neighbors_never_look_alike)
{
  for (unsigned seed = 0; seed < 20; ++seed)
    for (std::size_t n : {3, 10, 50, 400}) {
      std::mt19937 random(seed);
      for (const Neighbors& neighbors : {random_triangulation(n, random), random_ring(n, random)}) {
        BOOST_TEST_INFO_SCOPE("seed " << seed << ", " << n << " segments");
        const std::vector<Rgb> colors = segment_colors(neighbors);
        BOOST_TEST(colors.size() == n);
        BOOST_TEST(all_differ(colors));
        BOOST_TEST(smallest_difference_of_neighbors(neighbors, colors) > 20);
      }
    }
}

// The matrix for people without the cones for long waves: Machado et al. 2009, Table 1. They take
// red and green of one lightness for one color.
BOOST_AUTO_TEST_CASE(people_who_take_red_for_green_distinguish_neighbors)
{
  const double without_long[3][3] = {{0.152286, 1.052583, -0.204868},
                                     {0.114503, 0.786281, 0.099216},
                                     {-0.003882, -0.048116, 1.051998}};
  const auto seen = [&](const Rgb& a, const Rgb& b) {
    const std::array<double, 3> p = lab_without_cones(a, without_long),
                                q = lab_without_cones(b, without_long);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  BOOST_TEST(difference({200, 110, 60}, {135, 130, 60}) > 35);
  BOOST_TEST(seen({200, 110, 60}, {135, 130, 60}) < 10);
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const Neighbors neighbors = random_ring(20, random);
    const std::vector<Rgb> colors = segment_colors(neighbors);
    for (std::size_t a = 0; a < neighbors.size(); ++a)
      for (std::size_t b : neighbors[a])
        BOOST_TEST(seen(colors[a], colors[b]) > 10);
  }
}

BOOST_AUTO_TEST_CASE(a_body_with_very_many_limbs)
{
  const std::size_t n = 10000;
  Neighbors star(n);
  for (std::size_t limb = 1; limb < n; ++limb)
    connect(star, 0, limb);
  const std::vector<Rgb> colors = segment_colors(star);
  BOOST_TEST(all_differ(colors));
  BOOST_TEST(smallest_difference_of_neighbors(star, colors) > 40);
}

BOOST_AUTO_TEST_CASE(segments_that_all_touch_each_other)
{
  const std::size_t n = 12;
  Neighbors complete(n);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < a; ++b)
      connect(complete, a, b);
  const std::vector<Rgb> colors = segment_colors(complete);
  BOOST_TEST(smallest_difference_of_neighbors(complete, colors) > 20);
}

BOOST_AUTO_TEST_CASE(many_components)
{
  BOOST_TEST(all_differ(segment_colors(Neighbors(50000))));
}

BOOST_AUTO_TEST_CASE(no_color_is_lost_on_a_white_ground)
{
  for (const Rgb& color : segment_colors(Neighbors(2000)))
    BOOST_TEST(difference(color, {255, 255, 255}) > 20);
}

BOOST_AUTO_TEST_SUITE_END()
