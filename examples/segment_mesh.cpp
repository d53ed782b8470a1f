// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Command line tool: segments the mesh of a file. Exit status 0, or 1 with one sentence on
/// standard error.

#include "segment_mesh/Output_files.h"
#include "segment_mesh/Run_watch.h"
#include "segment_mesh/is_terminal.h"
#include "segment_mesh/read_mesh.h"
#include "segment_mesh/report.h"
#include "segment_mesh/write_meshes.h"

#include <CGAL/Spectral_segmentation/refine_segment_boundaries.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/segment_spectral_recursive.h>

#include <CLI/CLI.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <new>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using namespace segment_mesh;

// The numbers that follow the method.
typedef CGAL::Spectral_segmentation::internal::Options Defaults;

Defaults defaults(bool is_of_paper)
{
  return is_of_paper ? CGAL::Spectral_segmentation::internal::zhang_liu_2005_options()
                     : CGAL::Spectral_segmentation::internal::calibrated_options();
}

// For the help.
std::string both_defaults(double Defaults::*number)
{
  std::ostringstream out;
  out << " [" << defaults(false).*number << ", paper " << defaults(true).*number << ']';
  return out.str();
}

struct Options
{
  std::string input, mesh_file, label_file, report_file, split_directory;
  std::string method_name = "calibrated";
  std::optional<std::size_t> segments;
  std::optional<double> threshold, minimum_size;
  std::optional<std::uint64_t> seed;
  std::optional<std::size_t> threads;
  std::size_t smoothing_iterations = 0;
  bool boundary_smoothing = false;
  bool components_apart = false;
  bool refine_boundaries = false;
  bool quiet = false;

  bool is_of_paper() const { return method_name == "paper"; }

  double minimum_segment_size() const
  { return minimum_size.value_or(defaults(is_of_paper()).minimum_segment_size); }

  // A number of segments alone means so many, however shallow the last cuts are.
  bool is_number_exact() const { return segments && !threshold; }

  std::size_t maximum_number_of_segments() const
  { return segments.value_or((std::numeric_limits<std::size_t>::max)()); }

  double salience_threshold() const
  {
    return is_number_exact() ? -std::numeric_limits<double>::infinity()
                             : threshold.value_or(defaults(is_of_paper()).salience_threshold);
  }
};

void add_options(CLI::App& app, Options& o)
{
  const std::int64_t largest = (std::numeric_limits<std::uint32_t>::max)();
  const CLI::Validator not_empty(
    [](const std::string& name) { return std::string(name.empty() ? "the name is empty" : ""); },
    "");
  const auto add_file = [&](const char* name, std::string& file, const char* description) {
    return app.add_option(name, file, description)->type_name("FILE")->check(not_empty);
  };
  add_file("IN", o.input, "mesh or polygon soup: .off, .obj, .ply or .stl")->required();
  add_file("-o", o.mesh_file,
           "colored triangle mesh with the property 'segment' of its faces: .ply");
  add_file("--labels", o.label_file,
           "segment of each face of IN, one a line; a polygon cut by a boundary counts to the "
           "segment that has most of it");
  add_file("--json", o.report_file,
           "counts, seconds by stage summed over all parts, parameters, tree of cuts");
  add_file("--split-dir", o.split_directory, "directory for one .ply file a segment");
  app.add_option("--method", o.method_name,
                 "calibrated: cuts where people cut; paper: Zhang and Liu 2005")
    ->type_name("M")->check(CLI::IsMember({"calibrated", "paper"}))->capture_default_str();
  app.add_option("--segments", o.segments,
                 "number of segments; with --salience-threshold the largest number")
    ->type_name("N")->check(CLI::Range(std::int64_t(1), largest));
  app.add_option("--salience-threshold", o.threshold,
                 "smallest salience of a cut; with the method 'calibrated' the "
                 "probability that people cut there" + both_defaults(&Defaults::salience_threshold))
    ->type_name("T");
  app.add_option("--minimum-segment-size", o.minimum_size,
                 "smallest area of a side of a cut, as a share of the area of the mesh" +
                   both_defaults(&Defaults::minimum_segment_size))
    ->type_name("S")->check(CLI::Range(0., 0.5));
  app.add_option("--seed", o.seed,
                 "seed of random first reference faces; without it they are not random")
    ->type_name("S")->check(CLI::Range(std::int64_t(0), largest));
  app.add_option("--threads", o.threads,
                 "number of threads; the result does not depend on it [all]")
    ->type_name("N")->check(CLI::Range(1, 1024));
  app.add_option("--smooth", o.smoothing_iterations,
                 "steps of Laplacian smoothing before distances are computed [0]")
    ->type_name("N")->check(CLI::Range(std::int64_t(0), largest));
  app.add_flag("--boundary-smoothing", o.boundary_smoothing,
               "smooth the boundaries between segments");
  app.add_flag("--components-apart", o.components_apart,
               "each connected component is a part from the start, as with the method 'paper'; "
               "else components that touch may be of one part");
  app.add_flag("--refine-boundaries", o.refine_boundaries,
               "split faces of the written meshes along smooth boundaries; labels stay those of "
               "the faces of IN");
  app.add_flag("--quiet", o.quiet, "print neither progress nor summary");
  app.allow_windows_style_options(false); // a name may begin with a slash
  app.set_version_flag("--version", "segment_mesh " CGAL_SPECTRAL_SEGMENTATION_VERSION);
}

// Finds what can be found before a long run.
void check_options(const Options& o)
{
#ifndef CGAL_LINKED_WITH_TBB
  if (o.threads && *o.threads > 1)
    throw std::runtime_error("this build has no threads, as it is without TBB");
#endif
  if (!o.mesh_file.empty() && std::filesystem::path(o.mesh_file).extension() != ".ply")
    throw std::runtime_error("cannot write " + o.mesh_file + ": the name must end in .ply");
  std::set<std::filesystem::path> names;
  for (const std::string& name : {o.mesh_file, o.label_file, o.report_file, o.split_directory}) {
    if (name.empty())
      continue;
    if (name != o.split_directory || !std::filesystem::is_directory(name))
      check_output_name(name);
    if (!names.insert(std::filesystem::weakly_canonical(std::filesystem::absolute(name))).second)
      throw std::runtime_error("two outputs have the name " + name);
  }
}

std::size_t segment(const Mesh& mesh, const Segment_map& segment_ids, const Options& o,
                    Segmentation_hierarchy& tree, Run_watch& watch)
{
  const auto np = parameters::minimum_segment_size(o.minimum_segment_size())
                    .number_of_smoothing_iterations(o.smoothing_iterations)
                    .boundary_smoothing(o.boundary_smoothing)
                    .components_apart(o.components_apart || o.is_of_paper())
                    .hierarchy(tree)
                    .visitor(std::ref(watch));
  const auto segment_with = [&](const auto& all)
  { return CGAL::segment_spectral_recursive(mesh, segment_ids, all); };
  const auto segment_with_number = [&](const auto& others) {
    if (o.is_number_exact())
      return segment_with(others.number_of_segments(*o.segments));
    return segment_with(others.maximum_number_of_segments(o.maximum_number_of_segments())
                          .salience_threshold(o.salience_threshold()));
  };
  const auto segment_with_seed = [&](const auto& others) {
    return o.seed ? segment_with_number(others.random_seed(*o.seed))
                  : segment_with_number(others);
  };
  return o.is_of_paper() ? segment_with_seed(np.zhang_liu_2005()) : segment_with_seed(np);
}

template <class T>
Json json_or_null(const std::optional<T>& value)
{ return value ? Json(*value) : Json(); }

// A threshold without limit is null. Parameters without an option have the version's defaults.
Json report(const Options& o, const Input_mesh& input, std::size_t number_of_segments,
            const Segmentation_hierarchy& tree, const Json& seconds)
{
  return {{"version", CGAL_SPECTRAL_SEGMENTATION_VERSION},
          {"input", o.input},
          {"input_faces", input.polygons.size()},
          {"faces", input.mesh.number_of_faces()},
          {"vertices", input.mesh.number_of_vertices()},
          {"segments", number_of_segments},
          {"seconds", seconds},
          {"parameters",
           {{"method", o.method_name},
            {"maximum_number_of_segments", json_or_null(o.segments)},
            {"components_apart", o.components_apart || o.is_of_paper()},
            {"salience_threshold", o.salience_threshold()},
            {"minimum_segment_size", o.minimum_segment_size()},
            {"random_seed", json_or_null(o.seed)},
            {"threads", json_or_null(o.threads)},
            {"number_of_smoothing_iterations", o.smoothing_iterations},
            {"boundary_smoothing", o.boundary_smoothing},
            {"refine_boundaries", o.refine_boundaries}}},
          {"tree", tree_report(tree, o.is_of_paper())}};
}

void run(const Options& o)
{
  check_options(o);
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> limit;
  if (o.threads)
    limit.emplace(tbb::global_control::max_allowed_parallelism, *o.threads);
#endif

  Input_mesh input = read_mesh(o.input);
  const Segment_map segment_ids =
    input.mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  Segmentation_hierarchy tree;
  std::size_t number_of_segments;
  Json seconds;
  {
    Run_watch watch(!o.quiet && standard_error_is_terminal());
    number_of_segments = segment(input.mesh, segment_ids, o, tree, watch);
    seconds = seconds_report(watch);
  }

  Output_files files;
  if (!o.label_file.empty())
    files.write(o.label_file, [&](std::ostream& out) {
      for (int label : labels_of_polygons(input, segment_ids))
        out << label << "\n";
    });
  if (!o.report_file.empty())
    files.write(o.report_file, [&](std::ostream& out) {
      out << report(o, input, number_of_segments, tree, seconds)
               .dump(1, ' ', false, Json::error_handler_t::replace) << "\n";
    });
  if (o.refine_boundaries) // after what is about the faces of the input
    CGAL::refine_segment_boundaries(input.mesh, segment_ids);
  if (!o.mesh_file.empty()) {
    color_segments(input.mesh, segment_ids, number_of_segments);
    files.write(o.mesh_file, [&](std::ostream& out) { write_ply(out, input.mesh); });
  }
  if (!o.split_directory.empty())
    write_segments(files, o.split_directory, input.mesh, segment_ids, number_of_segments);
  files.commit();

  if (!o.quiet)
    std::cout << o.input << ": " << input.polygons.size() << " faces, " << number_of_segments
              << " segments, " << std::setprecision(3) << seconds["total"].get<double>() << " s"
              << std::endl;
}

int fail(std::string sentence)
{
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');
  std::cerr << "segment_mesh: " << sentence << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char* argv[])
{
  // CGAL prints what it throws.
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  Options options;
  CLI::App app("Cuts a mesh into the parts that a person would name.",
               "segment_mesh");
  try {
    add_options(app, options);
    app.parse(argc, argv);
    run(options);
    return EXIT_SUCCESS;
  }
  catch (const CLI::Success& e) {
    return app.exit(e);
  }
  catch (const std::bad_alloc&) {
    return fail("there is not enough memory for " + options.input);
  }
  catch (const std::exception& e) {
    return fail(e.what());
  }
}
