// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

// A program of its own: it replaces the global operator new by one that fails on demand.

namespace {

constexpr std::size_t never = static_cast<std::size_t>(-1);
std::atomic<std::size_t> number_of_allocations{0};
std::atomic<std::size_t> first_failing{never}, last_failing{never};

void* allocate(std::size_t size, std::size_t alignment)
{
  const std::size_t number = number_of_allocations++;
  if (number >= first_failing && number <= last_failing)
    throw std::bad_alloc();
  size = (std::max)((size + alignment - 1) / alignment, std::size_t(1)) * alignment;
  if (void* p = std::aligned_alloc(alignment, size))
    return p;
  throw std::bad_alloc();
}

} // namespace

void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new[](std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment)
{ return allocate(size, std::size_t(alignment)); }
void* operator new[](std::size_t size, std::align_val_t alignment)
{ return allocate(size, std::size_t(alignment)); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

BOOST_AUTO_TEST_SUITE(bad_alloc)

using namespace test_meshes;

namespace {

// Lets the allocations from `first` to `last` of a run fail. Returns whether it succeeded.
template <class ConcurrencyTag, class NamedParameters>
bool succeeds(const Mesh& mesh, const NamedParameters& np, const Labels& expected,
              std::size_t first, std::size_t last)
{
  Labels labels;
  const auto map = map_to(labels, mesh);
  bool has_failed = false;
  number_of_allocations = 0;
  last_failing = last;
  first_failing = first;
  try {
    CGAL::segment_spectral_recursive<ConcurrencyTag>(mesh, map, np);
  }
  catch (const std::bad_alloc&) {
    has_failed = true;
  }
  first_failing = never;
  const bool is_as_expected = has_failed
    ? std::count(labels.begin(), labels.end(), untouched) == std::ptrdiff_t(labels.size())
    : labels == expected;
  BOOST_TEST(is_as_expected, "allocation " << first << (has_failed ? " failed" : ""));
  return !has_failed;
}

template <class ConcurrencyTag, class NamedParameters>
void check(const Mesh& mesh, const NamedParameters& np)
{
  const Labels expected = labels_of<ConcurrencyTag>(mesh, np);
  number_of_allocations = 0;
  labels_of<ConcurrencyTag>(mesh, np);
  const std::size_t all = number_of_allocations;
  BOOST_TEST(all > 100);
  const auto check_failure = [&](std::size_t k) {
    succeeds<ConcurrencyTag>(mesh, np, expected, k, k);
    succeeds<ConcurrencyTag>(mesh, np, expected, k, never);
  };
  for (std::size_t k = 0; k < 2 * all; k = (std::max)(2 * k, k + 1))
    check_failure(k);
  Random random(1);
  for (int i = 0; i < 50; ++i)
    check_failure(random() % all);
  BOOST_TEST(succeeds<ConcurrencyTag>(mesh, np, expected, never, never));
}

} // namespace

BOOST_AUTO_TEST_CASE(a_run_that_finds_no_memory_says_so_and_writes_nothing)
{
  const Mesh mesh = mesh_of(doll());
  for_both_methods([&](const auto& np) {
    const auto pack = np.number_of_coarse_faces(200);
    check<CGAL::Sequential_tag>(mesh, pack);
    BOOST_TEST(!succeeds<CGAL::Sequential_tag>(mesh, pack, Labels(), 0, never));
#ifdef CGAL_LINKED_WITH_TBB
    BOOST_TEST_CONTEXT("with threads")
      check<CGAL::Parallel_tag>(mesh, pack);
#endif
  });
}

BOOST_AUTO_TEST_SUITE_END()
