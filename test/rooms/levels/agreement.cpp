// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/levels/agreement.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(agreement)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
namespace tt = boost::test_tools;

namespace {

typedef std::vector<Index> Partition;

// The definition, set by set.
double quality(const Partition& first, const Partition& second, const std::vector<double>& areas)
{
  std::map<Index, std::set<std::size_t> > segments[2];
  for (std::size_t f = 0; f < areas.size(); ++f) {
    segments[0][first[f]].insert(f);
    segments[1][second[f]].insert(f);
  }
  double sum = 0;
  for (const auto& [i, a] : segments[0])
    for (const auto& [j, b] : segments[1]) {
      double both = 0, any = 0;
      for (std::size_t f = 0; f < areas.size(); ++f) {
        both += a.count(f) && b.count(f) ? areas[f] : 0;
        any += a.count(f) || b.count(f) ? areas[f] : 0;
      }
      sum += 2 * both > any ? both / any : 0; // 1/2 is no match
    }
  return sum / (0.5 * double(segments[0].size() + segments[1].size()));
}

} // namespace

BOOST_AUTO_TEST_CASE(the_quality_of_some_partitions)
{
  const std::vector<double> areas = {1, 1, 1, 1, 4};
  const Partition all = {0, 0, 0, 0, 0}, halves = {1, 1, 1, 1, 0}, with_tip = {0, 2, 2, 2, 5};
  BOOST_TEST(internal::panoptic_quality(halves, halves, areas) == 1);
  BOOST_TEST(internal::panoptic_quality(all, halves, areas) == 0); // 1/2 is no match
  // 3/4 and 1, over the mean of 2 and 3
  BOOST_TEST(internal::panoptic_quality(halves, with_tip, areas) == 1.75 / 2.5);
  BOOST_TEST(internal::panoptic_quality(with_tip, halves, areas) == 1.75 / 2.5);
}

BOOST_AUTO_TEST_CASE(the_quality_of_random_partitions)
{
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const std::size_t n = 1 + random() % 12, groups = 1 + random() % 4;
    Partition first(n), second(n);
    std::vector<double> areas(n);
    for (std::size_t f = 0; f < n; ++f) {
      areas[f] = double(1 + random() % 10);
      first[f] = static_cast<Index>(random() % groups);
      second[f] = random() % 4 == 0 ? static_cast<Index>(random() % 5) : first[f];
    }
    BOOST_TEST(internal::panoptic_quality(first, second, areas) == quality(first, second, areas),
               tt::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(the_partition_that_most_others_resemble_is_taken)
{
  const std::vector<double> areas(6, 1);
  const Partition halves = {0, 0, 0, 1, 1, 1}, thirds = {0, 0, 1, 1, 2, 2},
                  nearly_halves = {0, 0, 0, 0, 1, 1};
  BOOST_TEST(internal::most_agreed({thirds}, areas) == 0u);
  BOOST_TEST(internal::most_agreed({thirds, halves}, areas) == 0u); // ties go to the first
  BOOST_TEST(internal::most_agreed({thirds, halves, halves}, areas) == 1u);
  BOOST_TEST(internal::most_agreed({thirds, nearly_halves, halves, halves}, areas) == 2u);
  BOOST_TEST(internal::most_agreed({halves, halves, thirds, thirds, thirds}, areas) == 2u);
}

BOOST_AUTO_TEST_CASE(a_finer_face_gets_the_segment_around_its_corners)
{
  // A row of squares. Each vertex keeps its place, so each face gets the segment that is most
  // frequent at its corners.
  const Surface plate = surface_of(test_meshes::plate(8, 1));
  const auto x = [&](Index f) {
    double sum = 0;
    for (Index v : plate.corners[f])
      sum += plate.points[v].x() / 3;
    return sum;
  };
  Partition segments;
  double largest = 0;
  for (Index f = 0; f < plate.number_of_faces(); ++f)
    largest = (std::max)(largest, x(f));
  const double middle = largest / 2;
  for (Index f = 0; f < plate.number_of_faces(); ++f)
    segments.push_back(x(f) < middle ? 7 : 3);
  Partition vertices = internal::first_indices(plate.points.size());
  const auto carried = [&]
  { return internal::segments_of_finer_faces(plate, plate, segments, vertices); };
  Partition result = carried();
  for (Index f = 0; f < plate.number_of_faces(); ++f)
    if (std::abs(x(f) - middle) > largest / 8)
      BOOST_TEST(result[f] == segments[f]);

  // Faces whose vertices all became one have the segment with most of the faces around that vertex.
  Index last = 0;
  for (Index v = 0; v < vertices.size(); ++v)
    last = plate.points[v].x() > plate.points[last].x() ? v : last;
  std::fill(vertices.begin(), vertices.end(), last);
  BOOST_TEST(carried() == Partition(plate.number_of_faces(), 3), tt::per_element());

  // A vertex that is left out does not count.
  vertices = internal::first_indices(plate.points.size());
  for (Index v : plate.corners[0])
    vertices[v] = v == plate.corners[0][0] ? v : internal::null_index;
  BOOST_TEST(carried()[0] == segments[0]);
}

BOOST_AUTO_TEST_SUITE_END()
