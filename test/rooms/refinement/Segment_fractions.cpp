// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Segmented_mesh/internal/refinement/Segment_fractions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(segment_fractions)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Segmented_mesh::internal;
using internal::Boundary_curves;
using internal::Segment_fractions;
using internal::Vector;

namespace {

// A surface with labels from 0 on, and the fractions and boundary curves that they have.
struct Labeled_surface
{
  Surface surface;
  std::vector<Index> labels;
  internal::Boundary_band band;
  Segment_fractions fractions;

  Labeled_surface(const Soup& soup, const std::vector<Index>& all_labels,
                  std::size_t number_of_iterations)
    : surface(surface_of(soup)), labels(all_labels), band(surface, labels),
      fractions(surface, labels, band, number_of_iterations) {}

  Labeled_surface(const Labeled_surface&) = delete; // members refer to each other

  Boundary_curves curves() const { return {surface, labels, band, fractions}; }
};

// Returns a bent surface, and labels of five segments with frayed boundaries.
Soup stone()
{
  Random random(3);
  return displaced(sphere(3), 0.03, random);
}

std::vector<Index> labels_of_stone()
{
  Random random(4);
  return by_place<Index>(stone(), [&](const Point& p) {
    const double x = p.x() + double(random() % 100) / 800;
    return p.z() > 0.6 ? 4 : (x > 0 ? 2 : 0) + (p.y() > 0 ? 1 : 0);
  });
}

double length_of(const Labeled_surface& s, const Boundary_curves& curves)
{
  double result = 0;
  for (Index f : s.band.faces) {
    std::vector<Vector> points;
    Index crossed = 0;
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (curves.is_crossed(h)) {
        points.push_back(curves.point(h));
        crossed = h;
      }
    if (points.size() == 1) // the curve ends in the opposite corner
      points.push_back(s.surface.points[s.surface.corners[f][(crossed + 2) % 3]]);
    if (points.size() == 2)
      result += (points[0] - points[1]).norm();
    else
      for (const Vector& p : points)
        result += (p - s.surface.centroid(f)).norm();
  }
  return result;
}

// Checks the fractions before any iteration. Fixed vertices have equal ones.
void check_angles(const Labeled_surface& s)
{
  std::vector<std::map<Index, double> > angles(s.surface.points.size());
  for (Index h = 0; h < s.surface.number_of_halfedges(); ++h) {
    const Index v = s.surface.source_vertex(h);
    const Vector a = s.surface.points[s.surface.target_vertex(h)] - s.surface.points[v],
                 b = s.surface.points[s.surface.corners[h / 3][(h + 2) % 3]] - s.surface.points[v];
    angles[v][s.labels[h / 3]] += std::atan2(a.cross(b).norm(), a.dot(b));
  }
  for (Index v = 0; v < angles.size(); ++v) {
    if (!s.band.is_inside(v))
      continue;
    double sum = 0;
    for (const auto& entry : angles[v])
      sum += entry.second;
    for (Index label = 0; label < 5; ++label) {
      const double expected = angles[v].count(label) == 0 ? 0
        : s.band.is_fixed(v) ? 1 / double(angles[v].size()) : angles[v][label] / sum;
      BOOST_TEST(std::abs(s.fractions(v, label) - expected) < 1e-4);
    }
  }
}

// Returns rings of radius 3 that become wider, and are cut in the middle.
Soup tube(double slope)
{
  std::vector<std::pair<double, double> > profile;
  for (int z = 0; z <= 10; ++z)
    profile.emplace_back(z, 3 + slope * z);
  return surface_of_revolution(profile, 36);
}

std::vector<Index> labels_of_tube(const Soup& tube)
{ return by_place<Index>(tube, [](const Point& p) { return p.z() > 5; }); }

} // namespace

BOOST_AUTO_TEST_CASE(fractions_are_those_of_the_angle)
{
  check_angles(Labeled_surface(stone(), labels_of_stone(), 0));
  const Soup funnel = tube(0.5);
  const Labeled_surface s(funnel, labels_of_tube(funnel), 0);
  check_angles(s);
  const Index v = 5 * 36; // where the funnel is cut
  BOOST_TEST(s.band.is_fixed(v));
  BOOST_TEST(Labeled_surface(funnel, labels_of_tube(funnel), 20).fractions(v, 0) == 0.5);
}

BOOST_AUTO_TEST_CASE(fractions_add_up_to_one)
{
  for (std::size_t number_of_iterations : {0, 1, 10}) {
    const Labeled_surface s(stone(), labels_of_stone(), number_of_iterations);
    for (Index v = 0; v < s.surface.points.size(); ++v) {
      if (!s.band.is_inside(v))
        continue;
      double sum = 0, largest = 0;
      for (Index label = 0; label < 5; ++label) {
        sum += s.fractions(v, label);
        largest = (std::max)(largest, s.fractions(v, label));
      }
      BOOST_TEST(sum == 1, tt::tolerance(1e-9));
      BOOST_TEST(s.fractions(v, s.fractions.label_of_largest(v)) == largest);
    }
  }
}

// The boundary of a tube is fixed, and so are the ends of the band. Between them the fractions
// become linear, because the rings of the tube are equal.
BOOST_AUTO_TEST_CASE(diffusion_makes_fractions_linear)
{
  const Soup soup = tube(0);
  const Labeled_surface s(soup, labels_of_tube(soup), 300);
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (s.band.is_inside(Index(v)))
      BOOST_TEST(std::abs(s.fractions(Index(v), 1) - (0.5 + (soup.points[v].z() - 5) / 6)) < 1e-6);
}

BOOST_AUTO_TEST_CASE(curves_cross_edges_where_both_fractions_are_equal)
{
  const Labeled_surface s(stone(), labels_of_stone(), 4);
  const Boundary_curves curves = s.curves();
  std::size_t number_of_junctions = 0;
  for (Index h = 0; h < s.surface.number_of_halfedges(); ++h) {
    number_of_junctions += h % 3 == 0 && curves.is_junction(h / 3);
    BOOST_TEST(curves.is_crossed(h) == curves.is_crossed(s.surface.opposite[h]));
    if (!curves.is_crossed(h))
      continue;
    const Index v = s.surface.source_vertex(h), w = s.surface.target_vertex(h);
    const Index a = s.fractions.label_of_largest(v), b = s.fractions.label_of_largest(w);
    const double t = curves.position(h);
    BOOST_TEST(a != b);
    BOOST_TEST(std::abs((1 - t) * (s.fractions(v, a) - s.fractions(v, b)) +
                        t * (s.fractions(w, a) - s.fractions(w, b))) < 1e-12);
    BOOST_TEST(t + curves.position(s.surface.opposite[h]) == 1, tt::tolerance(1e-12));
    BOOST_TEST(curves.label(h, 0) == a);
    BOOST_TEST(curves.label(h, 1) == b);
  }
  BOOST_TEST(number_of_junctions > 1u);
}

BOOST_AUTO_TEST_CASE(curves_become_shorter_and_keep_away_from_vertices)
{
  const Labeled_surface s(stone(), labels_of_stone(), 1);
  Boundary_curves curves = s.curves();
  curves.snap();
  const double first = length_of(s, curves);
  for (int step = 0; step < 10; ++step) {
    for (Index h = 0; h < s.surface.number_of_halfedges(); ++h)
      if (curves.is_crossed(h)) {
        BOOST_TEST(curves.position(h) > 0.049);
        BOOST_TEST(curves.position(h) < 0.951);
      }
    const double before = length_of(s, curves);
    curves.tighten();
    BOOST_TEST(length_of(s, curves) <= before * (1 + 1e-12));
  }
  BOOST_TEST(length_of(s, curves) < 0.99 * first);
}

BOOST_AUTO_TEST_CASE(frozen_faces_keep_their_labels)
{
  const Labeled_surface s(stone(), labels_of_stone(), 4);
  Boundary_curves curves = s.curves();
  std::vector<char> is_frozen(s.surface.number_of_faces(), 0);
  for (Index f : s.band.faces)
    if (s.labels[f] == 4 || curves.is_junction(f)) {
      curves.freeze(f);
      is_frozen[f] = 1;
    }
  std::size_t number_of_crossings = 0;
  for (Index h = 0; h < s.surface.number_of_halfedges(); ++h) {
    number_of_crossings += curves.is_crossed(h);
    if (!is_frozen[h / 3])
      continue;
    for (int half : {0, 1})
      BOOST_TEST(curves.label(h, half) == s.labels[h / 3]);
    BOOST_TEST(!curves.is_junction(h / 3));
    if (is_frozen[s.surface.neighbor(h)])
      BOOST_TEST(!curves.is_crossed(h));
  }
  BOOST_TEST(number_of_crossings > 0u);
}

BOOST_AUTO_TEST_SUITE_END()
