// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <thread>
#include <type_traits>
#include <vector>

// Tests the progress that a visitor receives, and runs that it stops.
BOOST_AUTO_TEST_SUITE(progress)

using namespace test_meshes;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using CGAL::Spectral_segmentation::Segmentation_visitor;

namespace {

struct Progress_visitor : Segmentation_visitor
{
  std::vector<double> fractions;
  void progress(double fraction) { fractions.push_back(fraction); }
};

template <class ConcurrencyTag, class NamedParameters>
void check_progress(const Mesh& mesh, const NamedParameters& np, std::size_t least_number_of_calls)
{
  Progress_visitor visitor;
  labels_of<ConcurrencyTag>(mesh, np.visitor(std::ref(visitor)));
  const std::vector<double>& fractions = visitor.fractions;
  BOOST_TEST_REQUIRE(!fractions.empty());
  BOOST_TEST(fractions.size() >= least_number_of_calls);
  BOOST_TEST(fractions.size() <= 1000);
  BOOST_TEST(fractions.front() >= 0);
  BOOST_TEST(std::is_sorted(fractions.begin(), fractions.end()));
  BOOST_TEST(fractions.back() == 1);
}

template <class NamedParameters>
void check_progress(const Mesh& mesh, const NamedParameters& np, std::size_t least_number_of_calls)
{
  check_progress<CGAL::Sequential_tag>(mesh, np, least_number_of_calls);
#ifdef CGAL_LINKED_WITH_TBB
  BOOST_TEST_CONTEXT("with threads")
    check_progress<CGAL::Parallel_tag>(mesh, np, least_number_of_calls);
#endif
}

// Says no at the poll of a number; it must not be asked again, not even by a thread that waits to
// ask.
struct Stop_at : Segmentation_visitor
{
  std::size_t poll, number_of_polls = 0;
  bool lets_threads_wait;

  Stop_at(std::size_t number, bool with_threads)
    : poll(number), lets_threads_wait(with_threads) {}

  bool go_further()
  {
    if (number_of_polls == poll && lets_threads_wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return number_of_polls++ != poll;
  }
};

const std::size_t never = static_cast<std::size_t>(-1);

template <class NamedParameters>
std::size_t number_of_polls(const Mesh& mesh, const NamedParameters& np)
{
  Stop_at visitor(never, false);
  labels_of<CGAL::Sequential_tag>(mesh, np.visitor(std::ref(visitor)));
  return visitor.number_of_polls;
}

template <class ConcurrencyTag, class NamedParameters>
void check_stop(const Mesh& mesh, std::size_t poll, const NamedParameters& np)
{
  BOOST_TEST_CONTEXT("stopped at poll " << poll) {
    Stop_at visitor(poll, !std::is_same<ConcurrencyTag, CGAL::Sequential_tag>());
    Segmentation_hierarchy hierarchy;
    const Labels labels =
      labels_of<ConcurrencyTag>(mesh, np.hierarchy(hierarchy).visitor(std::ref(visitor)));
    BOOST_TEST(visitor.number_of_polls == poll + 1);
    check_labels(mesh, labels);
    BOOST_TEST((labels == run_labels(hierarchy)));
  }
}

// A limb, a hole in the surface and a further component
const Soup& small_soup()
{
  static const Soup result = disjoint_union(dumbbell(8, 6), moved(plate(3, 2), 9, 0, 0));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(progress_rises_to_one)
{
  const Soup soups[] = {Soup(), plate(1, 1), small_soup(), doll()};
  for_both_methods([&](const auto& np) {
    for (const Soup& soup : soups) {
      check_progress(mesh_of(soup), np, 1);
      check_progress(mesh_of(soup), np.number_of_coarse_faces(60), 1);
    }
  });
}

BOOST_AUTO_TEST_CASE(progress_over_a_large_mesh_is_told_often)
{
  const Mesh mesh = mesh_of(dumbbell(160, 160)); // the paper's method searches one part
  BOOST_TEST(num_faces(mesh) > 100000);
  for_both_methods([&](const auto& np) { check_progress(mesh, np, 14); });
}

BOOST_AUTO_TEST_CASE(a_run_may_be_stopped_at_any_poll)
{
  const Mesh mesh = mesh_of(small_soup());
  for_both_methods([&](const auto& np) {
    const auto check = [&](const auto& pack) {
      const std::size_t polls = number_of_polls(mesh, pack);
      BOOST_TEST(polls > 20);
      for (std::size_t poll = 0; poll < polls; poll += poll < 20 ? 1 : 5) // random runs try others
        check_stop<CGAL::Sequential_tag>(mesh, poll, pack);
    };
    check(np.maximum_number_of_segments(6).number_of_coarse_faces(0));
    BOOST_TEST_CONTEXT("on a coarse mesh")
      check(np.maximum_number_of_segments(6).number_of_coarse_faces(60)
              .number_of_smoothing_iterations(3));
  });
}

BOOST_AUTO_TEST_CASE(a_run_over_a_large_mesh_may_be_stopped_at_any_poll)
{
  const Mesh mesh = mesh_of(dumbbell(74, 70)); // 20572 faces, coarsened in steps
  BOOST_TEST(num_faces(mesh) > 20000);
  for_both_methods([&](const auto& pack) {
    const auto np = pack.number_of_coarse_faces(400).maximum_number_of_segments(5);
    const std::size_t polls = number_of_polls(mesh, np);
    for (std::size_t i = 0; i < 24; ++i)
      check_stop<CGAL::Sequential_tag>(mesh, i * i * (polls - 1) / (23 * 23), np);
  });
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(a_run_in_threads_may_be_stopped_at_any_poll)
{
  const Mesh mesh = mesh_of(disjoint_union(small_soup(), moved(doll(), 30, 0, 0)));
  for_both_methods([&](const auto& pack) {
    const auto np = pack.maximum_number_of_segments(6).number_of_coarse_faces(300);
    // The number of polls may depend on the threads, but not by so much.
    const std::size_t polls = number_of_polls(mesh, np) / 2;
    for (std::size_t i = 0; i < 40; ++i)
      check_stop<CGAL::Parallel_tag>(mesh, i * polls / 40, np);
  });
}
#endif

BOOST_AUTO_TEST_SUITE_END()
