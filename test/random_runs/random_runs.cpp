// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// random_runs [--seconds S] [--runs N] [--first SEED]
//
// Checks the promises of the manual on small meshes, damaged and segmented at random, one for each
// seed from SEED on, until N runs are done or S seconds have passed. Prints the seeds of the runs
// that break a promise, saves their triangles to the working directory, and then exits with 1.

#include "check_hierarchy.h"
#include "check_results.h"
#include "random_constraints.h"
#include "random_meshes.h"
#include "run_of_soup.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Finds out whether the compiler adds the address sanitizer
#ifdef __has_feature
#define SPECTRAL_SEGMENTATION_HAS_FEATURE(name) __has_feature(name)
#else
#define SPECTRAL_SEGMENTATION_HAS_FEATURE(name) 0
#endif
#if defined __SANITIZE_ADDRESS__ || SPECTRAL_SEGMENTATION_HAS_FEATURE(address_sanitizer)
#define SPECTRAL_SEGMENTATION_IS_SANITIZED
#include <sanitizer/common_interface_defs.h>
#endif

namespace random_runs {

class Random_run
{
  Random random_;
  Soup soup_;
  Parameters parameters_;
  bool has_valid_triangles_, has_valid_options_ = true;
  std::optional<Mesh> mesh_; // if the triangles are a manifold
  const char* step_ = "making a mesh"; // for the description
  bool has_random_ids_ = false;

  std::size_t number_of_faces() const { return soup_.triangles.size(); }
  const Mesh* mesh() const { return mesh_ ? &*mesh_ : nullptr; }

  // Runs on the soup, or on the mesh if edges are constrained.
  template <class Tag = CGAL::Sequential_tag>
  Outcome run_once(Visitor& visitor,
                   const Segmentation_hierarchy& before = Segmentation_hierarchy()) const
  {
    return parameters_.edges.empty() ? run<Tag>(soup_, parameters_, visitor, before)
                                     : run<Tag>(*mesh_, parameters_, visitor, before);
  }

  bool are_valid_triangles() const
  {
    return std::all_of(soup_.triangles.begin(), soup_.triangles.end(), [this](const auto& t) {
      return t.size() == 3 && std::all_of(t.begin(), t.end(), [this](std::size_t v) {
        return v < soup_.points.size() && std::isfinite(soup_.points[v].x()) &&
               std::isfinite(soup_.points[v].y()) && std::isfinite(soup_.points[v].z());
      });
    });
  }

  bool is_manifold() const
  {
    return has_valid_triangles_ &&
           std::all_of(soup_.triangles.begin(), soup_.triangles.end(), [](const auto& t)
             { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; }) &&
           CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(soup_.triangles);
  }

  // Returns the number of faces where faces with the same points count once.
  std::size_t number_of_distinct_faces() const
  {
    std::set<std::set<Point> > result;
    for (const auto& t : soup_.triangles)
      result.insert({soup_.points[t[0]], soup_.points[t[1]], soup_.points[t[2]]});
    return result.size();
  }

  // Returns whether the numbers of segments and the method allow a run, or nothing if this is not
  // known: duplicate faces that are not adjacent count once.
  std::optional<bool> is_allowed(std::size_t number_of_components) const
  {
    const Options& o = parameters_.options;
    if (!has_valid_triangles_ || !has_valid_options_)
      return false;
    if (parameters_.has_constraints()) {
      if (face_constraints(mesh(), parameters_).are_contradictory(number_of_faces()))
        return false;
      if (o.method == Method::ZHANG_LIU_2005) // border edges do not count
        return parameters_.seeds.empty() ? std::nullopt : std::optional<bool>(false);
      // Seeds may have no path between them, and the constraints may need more segments than are
      // allowed, or allow fewer. Duplicate faces are one face, and groups are kept apart.
      if (!parameters_.seeds.empty() || o.number_of_segments || !parameters_.groups.empty() ||
          o.maximum_number_of_segments != CGAL::Spectral_segmentation::unlimited ||
          number_of_distinct_faces() < number_of_faces())
        return std::nullopt;
    }
    if (!o.number_of_segments)
      return true;
    const std::size_t n = *o.number_of_segments;
    if (n < (o.keep_components_separate ? number_of_components : 1) || n > number_of_faces())
      return false;
    if (o.keep_components_separate || number_of_components == 1 ||
        n <= number_of_distinct_faces())
      return true;
    return std::nullopt;
  }

  // The same run on a mesh instead of a soup, or with threads.
  void check_same(const Outcome& outcome, const Outcome& expected, const char* what)
  {
    step_ = what;
    require(outcome.error == expected.error, std::string("the same error by ") + what);
    require(outcome.labels == expected.labels, std::string("the same labels by ") + what);
    require(written(outcome.hierarchy) == written(expected.hierarchy),
            std::string("the same hierarchy by ") + what);
  }

  void check_polyhedron(const Outcome& expected)
  {
    step_ = "a run on a Polyhedron_3";
    typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
    Polyhedron polyhedron;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup_.points, soup_.triangles,
                                                                polyhedron);
    std::map<Polyhedron::Facet_const_handle, std::size_t> label;
    CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(
      polyhedron, boost::make_assoc_property_map(label), parameters::options(parameters_.options));
    std::size_t i = 0;
    for (auto f : faces(polyhedron))
      require(label.at(f) == expected.labels[i++], "the same labels for a Polyhedron_3");
  }

  // Runs of which a visitor makes an end at any moment.
  void check_ends(std::size_t number_of_calls, const Segmentation_hierarchy& before,
                  const Neighbors& neighbors)
  {
    Visitor visitor;
    visitor.throws_at = random_() % number_of_calls;
    step_ = "a run whose visitor throws";
    Outcome outcome = one_in(random_, 2)
      ? run_once<CGAL::Parallel_tag>(visitor, before) : run_once(visitor, before);
    require(!outcome.error.empty() || visitor.number_of_calls <= visitor.throws_at,
            "an exception of the visitor passes through");
    step_ = "a run that is stopped";
    visitor = Visitor();
    visitor.stops_at = random_() % number_of_calls;
    outcome = run_once(visitor);
    if (!outcome.error.empty())
      return;
    check_hierarchy(outcome.hierarchy, parameters_, neighbors, 0, false);
    check_constraints(mesh(), parameters_, outcome.hierarchy);
  }

  // Checks the sizes of the leaves of a connected mesh. Points are rounded in a run.
  void check_sizes(const Segmentation_hierarchy& h) const
  {
    const Labels labels = h.labels(h.nodes(h.number_of_segments()));
    const std::map<int, double> area_of_segment = areas(soup_, Ids(labels.begin(), labels.end()));
    const double least = parameters_.options.minimum_segment_size * sum(area_of_segment);
    for (const auto& [id, area] : area_of_segment)
      require(area >= (1 - 1e-4) * least - 1e-5 * double(number_of_faces()),
              "no segment is smaller than the minimum: " + text(area) + " and " + text(least));
  }

  void check_overflow(const Outcome& expected)
  {
    step_ = "a run with small ids";
    std::vector<signed char> ids(number_of_faces(), 77);
    try {
      CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(
        soup_.points, soup_.triangles, CGAL::make_property_map(ids),
        parameters::options(parameters_.options));
    }
    catch (const std::overflow_error&) {
      require(ids == std::vector<signed char>(ids.size(), 77), "an overflow leaves the ids");
      return;
    }
    require(expected.hierarchy.nodes().size() <= 128, "small ids overflow");
  }

  void check_changes(Segmentation_hierarchy h, const Neighbors& neighbors)
  {
    step_ = "changes of the hierarchy";
    for (std::size_t n = random_number(random_, 1, 4); n > 0; --n) {
      if (one_in(random_, 3))
        split_leaf(h, soup_, random_);
      else
        merge(h, parameters_, random_);
      check_hierarchy(h, parameters_, neighbors, 0, false, true);
    }
  }

  void check_results(const Labels& labels)
  {
    Ids ids(labels.begin(), labels.end());
    has_random_ids_ = one_in(random_, 3);
    if (has_random_ids_) {
      const std::size_t n = random_number(random_, 1, 6);
      for (int& id : ids)
        id = int(random_() % n);
    }
    if (one_in(random_, 3))
      for (int& id : ids)
        id = 1000 * id - 1500;
    step_ = "refine_segment_boundaries";
    check_refining(soup_, ids, mesh(), random_);
    step_ = "close_segments";
    check_closing(soup_, ids, mesh(), random_);
    step_ = "split_into_segments";
    if (mesh_)
      check_splitting(*mesh_, ids, one_in(random_, 2));
  }

public:
  explicit Random_run(unsigned seed) : random_(seed), soup_(random_soup(random_))
  {
    if (soup_.triangles.size() > 600)
      soup_.triangles.resize(600);
    if (!soup_.triangles.empty() && one_in(random_, 40))
      spoil(soup_, random_);
    parameters_.options = random_options(number_of_faces(), random_);
    if (one_in(random_, 5))
      parameters_.groups = random_groups(number_of_faces(), random_);
    if (parameters_.options.method == Method::CALIBRATED && one_in(random_, 4)) {
      parameters_.features = random_features(number_of_faces(), random_);
      parameters_.options.feature_weight =
        one_of(random_, std::vector<double>{0.5, 0.5, 0, 0.1, 0.8, 1});
    }
    if (one_in(random_, 40)) {
      spoil(parameters_.options, random_);
      has_valid_options_ = false;
    }
    has_valid_options_ = has_valid_options_ && parameters_.options.number_of_segments != 0u;
    has_valid_triangles_ = are_valid_triangles();
    if (is_manifold())
      mesh_ = mesh_of(soup_);
    if (one_in(random_, 3))
      add_constraints(number_of_faces(), mesh(), parameters_, random_);
  }

  void operator()()
  {
    step_ = "a run";
    Visitor visitor;
    const Outcome outcome = run_once(visitor);
    if (!has_valid_triangles_ || !has_valid_options_) {
      require(!outcome.error.empty(), "bad input is refused");
      return;
    }
    const Options& o = parameters_.options;
    const Neighbors neighbors(soup_, parameters_.groups, mesh_.has_value());
    const std::size_t number_of_components =
      neighbors.number_of_pieces(Labels(number_of_faces(), 0));
    const std::optional<bool> is_expected = is_allowed(number_of_components);
    require(!is_expected || outcome.error.empty() == *is_expected,
            "the number of segments is allowed, or there is an exception: " + outcome.error);
    Visitor other_visitor;
    if (mesh_ && parameters_.edges.empty())
      check_same(run(*mesh_, parameters_, other_visitor), outcome, "a run on a mesh");
    if (one_in(random_, 2))
      check_same(run_once<CGAL::Parallel_tag>(other_visitor), outcome, "a run with threads");
    if (!outcome.error.empty() || outcome.labels.empty())
      return;

    step_ = "the hierarchy of a run";
    const Segmentation_hierarchy& h = outcome.hierarchy;
    const bool are_connected = o.keep_components_separate || number_of_components == 1;
    const std::size_t n = number_of(outcome.labels);
    const std::size_t number_of_roots =
      o.keep_components_separate ? number_of_components : 1;
    require(h.number_of_roots() == number_of_roots ||
              (parameters_.has_constraints() && h.number_of_roots() > number_of_roots),
            "the roots are the components, or all: " + std::to_string(h.number_of_roots()) +
              " instead of " + std::to_string(number_of_roots));
    require(!o.number_of_segments || n == *o.number_of_segments,
            "number_of_segments is exact: " + std::to_string(n));
    require(o.number_of_segments || n <= (std::max)(o.maximum_number_of_segments, number_of_roots),
            "maximum_number_of_segments is kept: " + std::to_string(n));
    require(!are_connected || neighbors.number_of_pieces(outcome.labels) == n,
            "segments are connected");
    check_hierarchy(h, parameters_, neighbors, are_connected ? number_of_components : 0,
                    o.method == Method::CALIBRATED);
    if (o.method == Method::CALIBRATED && number_of_components == 1 &&
        !parameters_.has_constraints() && !o.number_of_segments)
      check_sizes(h);
    check_constraints(mesh(), parameters_, outcome.labels, "the segments");
    check_constraints(mesh(), parameters_, h);
    const bool has_options_only = parameters_.groups.empty() && parameters_.features.empty() &&
                                  !parameters_.has_constraints();
    if (has_options_only && one_in(random_, 4))
      check_overflow(outcome);
    if (mesh_ && has_options_only && one_in(random_, 4))
      check_polyhedron(outcome);
    check_ends(visitor.number_of_calls, h, neighbors);
    check_changes(h, neighbors);
    check_results(outcome.labels);
  }

  const Soup& soup() const { return soup_; }

  std::string description() const
  {
    std::ostringstream os;
    os << "in " << step_ << (has_random_ids_ ? " with ids at random, " : ", ")
       << number_of_faces() << " faces" << (mesh_ ? " of a mesh, " : ", ") << parameters_;
    return os.str();
  }
};

} // namespace random_runs

namespace {

unsigned current_seed = 0;
std::string current_description;

// Names the run that ends the program, or that does not end.
void print_seed()
{
  std::fprintf(stderr, "seed %u: the program ends\n  %s\n  to repeat it: random_runs --first %u "
                       "--runs 1\n", current_seed, current_description.c_str(), current_seed);
}

void on_signal(int signal)
{
  print_seed();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// Returns whether all that is promised holds.
bool check_run(unsigned seed)
{
  current_seed = seed;
  random_runs::Random_run run(seed);
  current_description = run.description();
  std::string what;
  try {
    run();
    return true;
  }
  catch (const random_runs::Broken_invariant& e) {
    what = std::string("not so: ") + e.what();
  }
  catch (const std::exception& e) {
    what = std::string("unexpected exception: ") + e.what();
  }
  const std::string name = "random_run_" + std::to_string(seed) + ".off";
  CGAL::IO::write_polygon_soup(name, run.soup().points, run.soup().triangles,
                               CGAL::parameters::stream_precision(17));
  std::cout << "seed " << seed << ": " << what << "\n  " << run.description() << "\n  saved as "
            << name << "; to repeat it: random_runs --first " << seed << " --runs 1" << std::endl;
  return false;
}

} // namespace

int main(int argc, char** argv)
{
  double seconds = std::numeric_limits<double>::infinity();
  unsigned long runs = (std::numeric_limits<unsigned long>::max)(), first = 0;
  for (int i = 1; i < argc; i += 2) {
    const std::string option = argv[i];
    if (i + 1 < argc && option == "--seconds")
      seconds = std::atof(argv[i + 1]);
    else if (i + 1 < argc && option == "--runs")
      runs = std::strtoul(argv[i + 1], nullptr, 10);
    else if (i + 1 < argc && option == "--first")
      first = std::strtoul(argv[i + 1], nullptr, 10);
    else {
      std::cerr << "random_runs [--seconds S] [--runs N] [--first SEED]\n";
      return 2;
    }
  }
#ifdef SPECTRAL_SEGMENTATION_IS_SANITIZED
  __sanitizer_set_death_callback(print_seed);
#else
  std::signal(SIGSEGV, on_signal);
#endif
  for (int signal : {SIGABRT, SIGFPE, SIGTERM, SIGINT})
    std::signal(signal, on_signal);

  typedef std::chrono::steady_clock Clock;
  const auto seconds_since = [](Clock::time_point start)
  { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const Clock::time_point start = Clock::now();
  unsigned long number_of_failures = 0, i = 0;
  std::pair<double, unsigned long> slowest(0, first);
  for (; i < runs && seconds_since(start) < seconds; ++i) {
    const Clock::time_point start_of_run = Clock::now();
    number_of_failures += !check_run(unsigned(first + i));
    slowest = (std::max)(slowest, {seconds_since(start_of_run), first + i});
  }
  std::cout << i << " runs from seed " << first << ", " << number_of_failures
            << " failures; the slowest is that of seed " << slowest.second << ", "
            << slowest.first << " s" << std::endl;
  return number_of_failures == 0 ? 0 : 1;
}
