// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE same_labels
#include <boost/test/unit_test.hpp>

#include <CGAL/Spectral_segmentation/internal/bipartition/shortest_paths.h>

#include <atomic>
#include <cstddef>
#include <vector>

namespace {

bool uses_dijkstra = false;
std::atomic<std::size_t> number_of_dijkstra_searches(0);

} // namespace

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

template <class Paths>
void grow_paths_by_chosen_search(const Weighted_graph& graph, Index source, Paths& paths)
{
  if (!uses_dijkstra)
    return Bucket_search()(graph, source, paths);
  ++number_of_dijkstra_searches;
  Dijkstra_search()(graph, source, paths);
}

// All searches of a run come here, as these are declared before any is used.

template <>
void grow_paths<Bucket_search>(const Weighted_graph& graph, Index source, Path_lengths& paths)
{ grow_paths_by_chosen_search(graph, source, paths); }

template <>
void grow_paths<Bucket_search>(const Weighted_graph& graph, Index source, Path_angles& paths)
{ grow_paths_by_chosen_search(graph, source, paths); }

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Method;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

namespace {

struct Run
{
  const char* mesh;
  Method method;
  std::size_t number_of_searched_faces;
  std::size_t number_of_simplifications; // of the mesh, then of what is left, and so on
};

const Run runs[] = {{"elephant.off", Method::CALIBRATED, 4000, 1},
                    {"elephant.off", Method::CALIBRATED, 150, 2},
                    {"elephant.off", Method::ZHANG_LIU_2005, 0, 0},
                    {"hand.off", Method::CALIBRATED, 0, 0},
                    {"hand.off", Method::ZHANG_LIU_2005, 0, 0}};

std::size_t number_of_simplifications(const Run& run)
{
  if (run.number_of_searched_faces == 0)
    return 0;
  return CGAL::Spectral_segmentation::internal::coarsen_in_steps<CGAL::Sequential_tag>(
           dual_graph_of(read(run.mesh)), run.number_of_searched_faces).size();
}

struct Result
{
  Labels labels;
  Segmentation_hierarchy tree;
};

template <class ConcurrencyTag>
Result segment(const Mesh& mesh, const Run& run)
{
  Result r;
  CGAL::segment_spectral_recursive<ConcurrencyTag>(
    mesh, map_to(r.labels, mesh),
    parameters::method(run.method).number_of_searched_faces(run.number_of_searched_faces)
      .hierarchy(r.tree));
  return r;
}

void check_equal(const Result& a, const Result& b)
{
  BOOST_TEST((a.labels == b.labels));
  BOOST_TEST_REQUIRE(a.tree.number_of_nodes() == b.tree.number_of_nodes());
  for (std::size_t i = 0; i < a.tree.number_of_nodes(); ++i) {
    BOOST_TEST(a.tree.node(i).salience == b.tree.node(i).salience);
    BOOST_TEST((a.tree.node(i).cut_state == b.tree.node(i).cut_state));
  }
}

// Calls check(mesh, run, expected) for the result of one thread and the default search.
template <class Check>
void for_each_run(const Check& check)
{
  for (const Run& run : runs)
    BOOST_TEST_CONTEXT(run.mesh << ", method " << int(run.method) << ", searched faces "
                                << run.number_of_searched_faces) {
      const Mesh mesh = mesh_of(read(run.mesh));
      const Result expected = segment<CGAL::Sequential_tag>(mesh, run);
      BOOST_TEST(expected.tree.number_of_segments() > 3);
      BOOST_TEST(number_of_simplifications(run) == run.number_of_simplifications);
      check(mesh, run, expected);
    }
}

} // namespace

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(the_number_of_threads_changes_nothing)
{
  for_each_run([](const Mesh& mesh, const Run& run, const Result& expected) {
    for (int threads : {1, 2, 4, 8}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      tbb::task_arena arena(threads); // more threads than cores, too
      check_equal(arena.execute([&] { return segment<CGAL::Parallel_tag>(mesh, run); }), expected);
    }
  });
}
#endif

BOOST_AUTO_TEST_CASE(the_search_for_shortest_paths_changes_nothing)
{
  for_each_run([](const Mesh& mesh, const Run& run, const Result& expected) {
    const std::size_t number_before = number_of_dijkstra_searches;
    uses_dijkstra = true;
    const Result result = segment<CGAL::Sequential_tag>(mesh, run);
    uses_dijkstra = false;
    BOOST_TEST(number_of_dijkstra_searches > number_before);
    check_equal(result, expected);
  });
}
