// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Spectral_segmentation/internal/utility/concurrency.h>

#include <cmath>
#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(concurrency)

using CGAL::Spectral_segmentation::internal::for_each_index;
using CGAL::Spectral_segmentation::internal::sum_of;

#ifdef CGAL_LINKED_WITH_TBB
typedef CGAL::Parallel_tag Several_threads;
#else
typedef CGAL::Sequential_tag Several_threads;
#endif

BOOST_AUTO_TEST_CASE(each_index_is_visited_once)
{
  for (std::size_t n : {0, 1, 2, 1000, 100000}) {
    std::vector<int> visits(n, 0);
    for_each_index<Several_threads>(n, [&](std::size_t i) { ++visits[i]; });
    BOOST_TEST(visits == std::vector<int>(n, 1));
  }
}

BOOST_AUTO_TEST_CASE(sums_have_all_terms)
{
  for (std::size_t n : {0, 1, 2, 4095, 4096, 4097, 8192, 100001}) {
    const auto index = [](std::size_t i) { return i; };
    const std::size_t expected = n * (n + 1) / 2 - n;
    BOOST_TEST(sum_of<CGAL::Sequential_tag>(n, std::size_t(0), index) == expected);
    BOOST_TEST(sum_of<Several_threads>(n, std::size_t(0), index) == expected);
  }
}

BOOST_AUTO_TEST_CASE(the_rounding_of_a_sum_does_not_depend_on_the_threads)
{
  const auto term = [](std::size_t i) { return std::sin(static_cast<double>(i)) / 3; };
  const double sum = sum_of<CGAL::Sequential_tag>(1000000, 0., term);
  for (int i = 0; i < 20; ++i)
    BOOST_TEST(sum_of<Several_threads>(1000000, 0., term) == sum);
}

BOOST_AUTO_TEST_SUITE_END()
