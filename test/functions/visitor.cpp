// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "Event_visitor.h"
#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/tags.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(visitor)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Salience_factors;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using CGAL::Spectral_segmentation::Segmentation_visitor;
using CGAL::Spectral_segmentation::Stage;

namespace {

const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();
const Stage stages_of_part[] = {Stage::SAMPLING, Stage::EMBEDDING, Stage::LINE_SEARCH};

// Checks that the events of each part are balanced and in order, in whatever way parts interleave.
struct Strict_visitor : Segmentation_visitor
{
  struct State
  {
    std::size_t number_of_faces = 0;
    int number_of_stages = 0;
    bool is_in_stage = false;
    bool has_ended = false;
    bool is_cut = false;
    double salience = 0;
  };

  std::map<std::size_t, State> parts;
  std::vector<std::pair<Stage, bool> > events_of_mesh; // stage, is it the start
  std::vector<std::size_t> cuts;
  std::vector<std::size_t> numbers_of_segments;
  std::size_t number_of_polls = 0;

  void before_stage(Stage stage, std::size_t part)
  {
    if (part == whole_mesh) {
      events_of_mesh.emplace_back(stage, true);
      return;
    }
    State& p = parts.at(part);
    BOOST_TEST_REQUIRE(p.number_of_stages < 3);
    BOOST_TEST(!p.is_in_stage);
    BOOST_TEST((stage == stages_of_part[p.number_of_stages]));
    p.is_in_stage = true;
  }

  void after_stage(Stage stage, std::size_t part)
  {
    if (part == whole_mesh) {
      events_of_mesh.emplace_back(stage, false);
      return;
    }
    State& p = parts.at(part);
    BOOST_TEST(p.is_in_stage);
    BOOST_TEST((stage == stages_of_part[p.number_of_stages]));
    p.is_in_stage = false;
    ++p.number_of_stages;
  }

  void before_part(std::size_t part, std::size_t number_of_faces)
  {
    BOOST_TEST(parts.count(part) == 0);
    parts[part].number_of_faces = number_of_faces;
  }

  void after_part(std::size_t part)
  {
    State& p = parts.at(part);
    BOOST_TEST(!p.has_ended);
    BOOST_TEST(!p.is_in_stage);
    BOOST_TEST(p.number_of_stages == 3);
    p.has_ended = true;
  }

  void after_cut(std::size_t part, const Salience_factors&, double salience,
                 std::size_t number_of_segments)
  {
    State& p = parts.at(part);
    BOOST_TEST(p.has_ended);
    BOOST_TEST(!p.is_cut);
    p.is_cut = true;
    p.salience = salience;
    cuts.push_back(part);
    numbers_of_segments.push_back(number_of_segments);
  }

  bool go_further()
  {
    ++number_of_polls;
    return true;
  }
};

template <class ConcurrencyTag>
void check_events(const Mesh& mesh)
{
  Strict_visitor visitor;
  Segmentation_hierarchy hierarchy;
  labels_of<ConcurrencyTag>(
    mesh, parameters::zhang_liu_2005().visitor(std::ref(visitor)).salience_threshold(0.4)
            .hierarchy(hierarchy));

  const std::vector<std::pair<Stage, bool> > expected = {{Stage::INITIALIZATION, true},
                                                         {Stage::INITIALIZATION, false}};
  BOOST_TEST((visitor.events_of_mesh == expected));

  for (const auto& [part, state] : visitor.parts) {
    BOOST_TEST(state.has_ended);
    BOOST_TEST_REQUIRE(part < hierarchy.number_of_nodes());
    BOOST_TEST(state.number_of_faces == hierarchy.number_of_faces(part));
    BOOST_TEST(state.is_cut == !hierarchy.node(part).is_leaf());
    if (state.is_cut)
      BOOST_TEST(state.salience == hierarchy.node(part).salience);
  }
  // A part of one face, or without room for two segments, is not searched.
  double area_of_mesh = 0;
  for (std::size_t i = 0; i < hierarchy.number_of_roots(); ++i)
    area_of_mesh += hierarchy.node(i).area;
  for (std::size_t i = 0; i < hierarchy.number_of_nodes(); ++i) {
    const bool has_room = hierarchy.node(i).area > 2 * 0.005 * area_of_mesh;
    BOOST_TEST(visitor.parts.count(i) == (hierarchy.number_of_faces(i) > 1 && has_room ? 1 : 0));
  }

  BOOST_TEST(visitor.cuts.size() == hierarchy.number_of_segments() - hierarchy.number_of_roots());
  for (std::size_t i = 0; i < visitor.cuts.size(); ++i) {
    BOOST_TEST(hierarchy.node(hierarchy.number_of_roots() + 2 * i).parent == visitor.cuts[i]);
    BOOST_TEST(visitor.numbers_of_segments[i] == hierarchy.number_of_roots() + i + 1);
  }
  BOOST_TEST(visitor.number_of_polls > 3 * visitor.parts.size());
}

struct Stop_at : Segmentation_visitor
{
  std::size_t remaining_polls;
  explicit Stop_at(std::size_t poll) : remaining_polls(poll) {}
  bool go_further() { return remaining_polls-- > 0; }
};

// Notices calls at the same time.
struct Lonely_visitor : Event_visitor<Lonely_visitor>
{
  std::atomic<int> callers{0};
  std::atomic<bool> met_another{false};
  std::size_t number_of_calls = 0; // without a lock, for the thread sanitizer

  void event()
  {
    if (++callers != 1)
      met_another = true;
    for (int i = 0; i < 1000; ++i)
      ++number_of_calls;
    --callers;
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(events_are_balanced_and_in_order)
{
  const Soup triangle = {{Point(0, 0, 9), Point(1, 0, 9), Point(0, 1, 9)}, {{0, 1, 2}}};
  for (const Mesh& mesh : {mesh_of(doll()), mesh_of(disjoint_union(dumbbell(16, 12), triangle))}) {
    check_events<CGAL::Sequential_tag>(mesh);
#ifdef CGAL_LINKED_WITH_TBB
    check_events<CGAL::Parallel_tag>(mesh);
#endif
  }
}

BOOST_AUTO_TEST_CASE(parts_do_not_interleave_in_one_thread)
{
  struct Visitor : Segmentation_visitor
  {
    bool is_in_part = false;
    void before_part(std::size_t, std::size_t)
    {
      BOOST_TEST(!is_in_part);
      is_in_part = true;
    }
    void after_part(std::size_t) { is_in_part = false; }
    void after_cut(std::size_t, const Salience_factors&, double, std::size_t)
    { BOOST_TEST(!is_in_part); }
  };
  for_both_methods([](const auto& np)
    { labels_of<CGAL::Sequential_tag>(doll(), np.visitor(Visitor())); });
}

BOOST_AUTO_TEST_CASE(regions_are_merged_and_cuts_projected_once_after_the_search)
{
  struct Stages : Segmentation_visitor
  {
    std::vector<Stage> all, of_mesh;
    void before_stage(Stage stage, std::size_t part)
    {
      all.push_back(stage);
      if (part == whole_mesh)
        of_mesh.push_back(stage);
    }
  };
  const Mesh mesh = mesh_of(doll());
  const auto stages = [&](const auto& np) {
    Stages visitor;
    labels_of(mesh, np.visitor(std::ref(visitor)));
    return visitor;
  };
  const auto by_default = parameters::default_values();
  const auto of_paper = parameters::zhang_liu_2005();
  const Stages whole = stages(by_default.number_of_coarse_faces(0));
  typedef std::vector<Stage> Expected;
  BOOST_TEST((whole.of_mesh == Expected{Stage::INITIALIZATION, Stage::MERGING}));
  BOOST_TEST((whole.all.back() == Stage::MERGING));
  BOOST_TEST((stages(by_default.number_of_coarse_faces(100)).of_mesh ==
              Expected{Stage::INITIALIZATION, Stage::MERGING, Stage::PROJECTION}));
  BOOST_TEST((stages(of_paper.number_of_coarse_faces(100)).of_mesh ==
              Expected{Stage::INITIALIZATION, Stage::PROJECTION}));
}

BOOST_AUTO_TEST_CASE(a_visitor_that_listens_changes_nothing)
{
  const Mesh mesh = mesh_of(doll());
  for_both_methods([&](const auto& np) {
    Strict_visitor visitor;
    BOOST_TEST(labels_of(mesh, np.visitor(std::ref(visitor))) == labels_of(mesh, np),
               boost::test_tools::per_element());
    BOOST_TEST(visitor.cuts.size() > 1);
  });
}

BOOST_AUTO_TEST_CASE(a_visitor_is_taken_by_value_and_by_reference)
{
  const Mesh mesh = mesh_of(dumbbell(16, 12));
  const Labels whole(num_faces(mesh), 0);
  Stop_at visitor(0);
  const Stop_at const_visitor(0);
  BOOST_TEST(labels_of(mesh, parameters::visitor(visitor)) == whole);
  BOOST_TEST(labels_of(mesh, parameters::visitor(const_visitor)) == whole);
  BOOST_TEST(labels_of(mesh, CGAL::parameters::visitor(Stop_at(0))) == whole);
  BOOST_TEST(visitor.remaining_polls == 0);
  BOOST_TEST(labels_of<CGAL::Sequential_tag>(mesh, parameters::visitor(std::ref(visitor))) ==
             whole);
  BOOST_TEST(visitor.remaining_polls == unlimited); // asked once, below 0
}

BOOST_AUTO_TEST_CASE(a_stopped_run_gives_the_labels_of_the_cuts_made_so_far)
{
  const Mesh mesh = mesh_of(disjoint_union(dumbbell(8, 6), doll()));
  const auto np = parameters::zhang_liu_2005().salience_threshold(0.3);
  Strict_visitor counter;
  Segmentation_hierarchy whole_hierarchy;
  const Labels whole = labels_of<CGAL::Sequential_tag>(
    mesh, np.visitor(std::ref(counter)).hierarchy(whole_hierarchy));
  BOOST_TEST(whole_hierarchy.number_of_segments() > 3);

  std::map<std::size_t, Labels> labels_of_run; // by the number of segments
  for (std::size_t n = 2; n <= whole_hierarchy.number_of_segments(); ++n)
    labels_of_run[n] = labels_of(mesh, np.maximum_number_of_segments(n));
  std::size_t segments_before = 0;
  for (std::size_t poll = 0; poll < counter.number_of_polls + 7; poll += 7) {
    BOOST_TEST_CONTEXT("stopped at poll " << poll) {
      Segmentation_hierarchy hierarchy;
      Stop_at visitor(poll);
      const Labels labels =
        labels_of<CGAL::Sequential_tag>(mesh, np.visitor(std::ref(visitor)).hierarchy(hierarchy));
      const std::size_t n = number_of(labels);
      BOOST_TEST(n >= segments_before);
      BOOST_TEST(n == hierarchy.number_of_segments());
      BOOST_TEST((labels == run_labels(hierarchy)));
      BOOST_TEST((labels == labels_of_run.at(n)));
      segments_before = n;
    }
  }
  BOOST_TEST(segments_before == whole_hierarchy.number_of_segments());
}

BOOST_AUTO_TEST_CASE(a_stopped_hierarchy_does_not_invent_labels)
{
  Segmentation_hierarchy hierarchy;
  labels_of(doll(), parameters::zhang_liu_2005().visitor(Stop_at(0)).hierarchy(hierarchy));
  BOOST_TEST(hierarchy.number_of_segments() == 1);
  BOOST_CHECK_THROW(labels_above(hierarchy, 0.5, 2), std::out_of_range);
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(a_run_in_threads_stops_too)
{
  const Mesh mesh = mesh_of(disjoint_union(doll(), dumbbell(20, 15)));
  const auto np = parameters::zhang_liu_2005().salience_threshold(0.3);
  for (std::size_t poll = 0; poll < 300; poll += 13) {
    Segmentation_hierarchy hierarchy;
    const Labels labels =
      labels_of<CGAL::Parallel_tag>(mesh, np.visitor(Stop_at(poll)).hierarchy(hierarchy));
    const std::size_t n = number_of(labels);
    BOOST_TEST(n == hierarchy.number_of_segments());
    BOOST_TEST(labels == labels_of(mesh, np.maximum_number_of_segments(n)),
               boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(calls_from_threads_come_one_at_a_time)
{
  const Mesh mesh = mesh_of(disjoint_union(doll(), dumbbell(20, 15)));
  for_both_methods([&](const auto& np) {
    Lonely_visitor visitor;
    labels_of<CGAL::Parallel_tag>(
      mesh, np.visitor(std::ref(visitor)).salience_threshold(0.3).number_of_coarse_faces(700));
    BOOST_TEST(visitor.number_of_calls > 0);
    BOOST_TEST(!visitor.met_another);
  });
}
#endif

BOOST_AUTO_TEST_SUITE_END()
