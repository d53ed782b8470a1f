// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/utility/sorted_indices.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

BOOST_AUTO_TEST_SUITE(sorted_indices)

using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;

template <class Value>
std::vector<Index> stably_sorted(const std::vector<Value>& values)
{
  std::vector<Index> order(values.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](Index i, Index j) { return values[i] < values[j]; });
  return order;
}

BOOST_AUTO_TEST_CASE(order_is_that_of_a_stable_sort_with_any_number_of_threads)
{
  typedef CGAL::Parallel_if_available_tag Several_threads;
  Random random(1);
  for (std::size_t n : {0, 1, 2, 500, 10001, 60000})
    for (unsigned number_of_values : {1, 2, 50, 1000000}) {
      std::vector<float> values;
      for (std::size_t i = 0; i < n; ++i)
        values.push_back((float(random() % number_of_values) - float(number_of_values / 2)) / 1024);
      const std::vector<double> distances(values.begin(), values.end());
      BOOST_TEST(internal::sorted_indices(values) == stably_sorted(values));
      BOOST_TEST(internal::sorted_indices<Several_threads>(values) == stably_sorted(values));
      BOOST_TEST(internal::sorted_by_distance(distances) == stably_sorted(distances));
      BOOST_TEST(internal::sorted_by_distance<Several_threads>(distances) ==
                 stably_sorted(distances));
    }
}

BOOST_AUTO_TEST_SUITE_END()
