// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Command line tool: segments the mesh of a file. Exit status 0, or 1 with one sentence on
/// standard error.

#include "segment_mesh/Output_files.h"
#include "segment_mesh/Run_watch.h"
#include "segment_mesh/closed_soup.h"
#include "segment_mesh/is_terminal.h"
#include "segment_mesh/part_tree.h"
#include "segment_mesh/peak_memory.h"
#include "segment_mesh/read_input.h"
#include "segment_mesh/refined_input.h"
#include "segment_mesh/report.h"
#include "segment_mesh/write_meshes.h"

#include <CGAL/assertions_behaviour.h>
#include <CGAL/property_map.h>
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
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
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
  std::string split_format = "ply";
  std::string method_name = "calibrated";
  std::optional<std::size_t> segments;
  std::optional<double> threshold, minimum_size;
  std::optional<std::uint64_t> seed;
  std::optional<std::size_t> threads;
  std::size_t smoothing_iterations = 0;
  bool boundary_smoothing = false;
  bool components_apart = false;
  bool refine_boundaries = false;
  bool close = false;
  bool quiet = false;

  bool is_of_paper() const { return method_name == "paper"; }

  bool writes_to_standard_output() const
  {
    return is_standard_output(label_file) || is_standard_output(report_file);
  }

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
  add_file("IN", o.input, "mesh or polygon soup: .off, .obj, .ply, .stl"
#ifdef SEGMENT_MESH_WITH_ASSIMP
           ", .glb, .fbx and others that Assimp reads"
#endif
           "; - for standard input")->required();
  add_file("-o", o.mesh_file,
           "mesh with a color for each segment: .ply, which also has the property 'segment' of "
           "faces, .obj with groups and materials, .off, or with the tree of parts .glb"
#ifdef SEGMENT_MESH_WITH_LIB3MF
           " or .3mf, in millimeters"
#endif
           );
  add_file("--labels", o.label_file,
           "segment of each face of IN, one a line; a polygon cut by a boundary counts to the "
           "segment that has most of it; - for standard output");
  add_file("--json", o.report_file,
           "counts, seconds by stage summed over all parts, parameters, tree of cuts; - for "
           "standard output");
  add_file("--split-dir", o.split_directory,
           "directory for one file a segment; what an earlier run wrote there is replaced");
  app.add_option("--split-format", o.split_format, "format of these files")
    ->type_name("F")->check(CLI::IsMember({"ply", "obj", "off", "stl", "glb", "3mf"}))
    ->capture_default_str();
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
  app.add_flag("--close", o.close,
               "close the segments of --split-dir, and of -o with .glb or .3mf, as for printing: "
               "with caps that they share, and where the mesh has holes");
  app.add_flag("--quiet", o.quiet, "print neither progress nor summary");
  app.allow_windows_style_options(false); // a name may begin with a slash
  app.set_version_flag("--version", "segment_mesh " CGAL_SPECTRAL_SEGMENTATION_VERSION);
}

// Only files in which each segment is an object of its own have caps.
bool closes_mesh_file(const Options& o)
{
  const std::string extension = mesh_file::output_extension(o.mesh_file);
  return o.close && (extension == ".glb" || is_3mf(extension));
}

// Finds what can be found before a long run.
void check_options(const Options& o)
{
#ifndef CGAL_LINKED_WITH_TBB
  if (o.threads && *o.threads > 1)
    throw std::runtime_error("this build has no threads, as it is without TBB");
#endif
  std::vector<std::filesystem::path> outputs = {o.mesh_file, o.label_file, o.report_file};
  if (!o.mesh_file.empty())
    check_output_format(o.mesh_file, false);
  if (!o.split_directory.empty())
    check_output_format("segment." + o.split_format, true);
  if (mesh_file::output_extension(o.mesh_file) == ".obj")
    outputs.push_back(mesh_file::name_of_materials(o.mesh_file));
  if (o.close && !closes_mesh_file(o) && o.split_directory.empty())
    throw std::runtime_error("--close needs an output of separate segments: --split-dir, or -o "
                             "with .glb or .3mf");
  check_outputs({o.input}, outputs, o.split_directory);
}

std::size_t segment(const Input& input, std::vector<Index>& labels, const Options& o,
                    Segmentation_hierarchy& tree, Run_watch& watch)
{
  const auto np = parameters::minimum_segment_size(o.minimum_segment_size())
                    .number_of_smoothing_iterations(o.smoothing_iterations)
                    .boundary_smoothing(o.boundary_smoothing)
                    .components_apart(o.components_apart || o.is_of_paper())
                    .hierarchy(tree)
                    .visitor(std::ref(watch));
  const auto segment_with = [&](const auto& all) {
    return CGAL::segment_spectral_recursive(input.soup.points, input.triangles,
                                            CGAL::make_property_map(labels), all);
  };
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
Json report(const Options& o, const Input& input, std::size_t number_of_segments,
            const Segmentation_hierarchy& tree, const Run_watch& watch)
{
  return {{"version", CGAL_SPECTRAL_SEGMENTATION_VERSION},
          {"input", o.input},
          {"input_faces", input.soup.number_of_polygons()},
          {"faces", input.triangles.size()},
          {"vertices", number_of_vertices(input)},
          {"node_names", input.node_names},
          {"mesh_names", input.mesh_names},
          {"segments", number_of_segments},
          {"seconds", seconds_report(watch)},
          {"peak_memory", peak_memory()},
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
            {"refine_boundaries", o.refine_boundaries},
            {"close", o.close}}},
          {"tree", tree_report(tree, o.is_of_paper())}};
}

// Of the input, or of its triangles with refined boundaries.
void write_meshes(const Options& o, const Input& input, const std::vector<Index>& label_of_triangle,
                  const std::vector<Index>& label_of_polygon, std::size_t number_of_segments,
                  const Segmentation_hierarchy& tree, Output_files& files)
{
  const std::vector<Rgb> colors =
    segment_colors(segment_neighbors(input, label_of_triangle, number_of_segments));
  Labeled_input refined;
  if (o.refine_boundaries)
    refined = refined_input(input, label_of_triangle);
  const Input& written = o.refine_boundaries ? refined.first : input;
  const std::vector<Index>& labels = o.refine_boundaries ? refined.second : label_of_polygon;
  const std::vector<mesh_file::Part> parts =
    part_tree(tree, label_of_triangle, number_of_segments);
  // The number of a face of the refined mesh would tell nothing about the input.
  const mesh_file::Segmented_mesh mesh{
    written.soup, labels, colors, o.refine_boundaries ? 0 : std::size_t(mesh_file::null_index),
    parts};
  std::pair<Polygon_soup, std::vector<Index> > closed;
  if (o.close)
    closed = closed_soup(written, labels);
  const mesh_file::Segmented_mesh closed_mesh{
    closed.first, closed.second, colors,
    o.refine_boundaries ? 0 : written.soup.number_of_polygons(), parts};
  if (!o.mesh_file.empty())
    write_mesh(files, o.mesh_file, closes_mesh_file(o) ? closed_mesh : mesh);
  if (!o.split_directory.empty())
    write_segments(files, o.split_directory, '.' + o.split_format, o.close ? closed_mesh : mesh);
}

void print_summary(std::ostream& out, const Options& o, const Input& input,
                   std::size_t number_of_segments, double seconds)
{
  out << o.input << ": " << input.soup.number_of_polygons() << " faces, " << number_of_segments
      << (number_of_segments == 1 ? " segment, " : " segments, ") << std::setprecision(3) << seconds
      << " s, " << peak_memory() / 1000000 << " MB" << std::endl;
}

// About how long the phases take. Only what is told of the progress depends on it.
struct Expected_seconds
{
  double reading, joining, segmenting, writing;

  Expected_seconds(double bytes, double faces, bool writes_meshes)
    : reading(4e-9 * bytes), joining(1e-7 * faces), segmenting(0.2 + 1.5e-6 * faces),
      writing((writes_meshes ? 3e-7 : 5e-8) * faces) {}
};

void run(const Options& o)
{
  check_options(o);
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> limit;
  if (o.threads)
    limit.emplace(tbb::global_control::max_allowed_parallelism, *o.threads);
#endif
  Run_watch watch(!o.quiet && standard_error_is_terminal());
  const bool writes_meshes = !o.mesh_file.empty() || !o.split_directory.empty();
  const double bytes = size_of_file(o.input);
  const Expected_seconds first_guess(bytes, bytes / 20, writes_meshes);
  watch.start_phase("reading", first_guess.reading, first_guess.joining + first_guess.segmenting +
                                                      first_guess.writing);
  Scene scene = read_scene(o.input, writes_meshes);
  const Expected_seconds expected(bytes, static_cast<double>(scene.soup.number_of_polygons()),
                                  writes_meshes);
  watch.start_phase("joining", expected.joining, expected.segmenting + expected.writing);
  Input input = triangulated(std::move(scene));
  if (input.triangles.empty())
    throw std::runtime_error(o.input + " has no face with three different corners");

  watch.start_phase("segmentation", expected.segmenting, expected.writing);
  std::vector<Index> labels(input.triangles.size());
  Segmentation_hierarchy tree;
  const std::size_t number_of_segments = segment(input, labels, o, tree, watch);

  watch.start_phase("writing", expected.writing, 0);
  const std::vector<Index> label_of_polygon = labels_of_polygons(input, labels);
  Output_files files;
  if (!o.label_file.empty())
    files.write(o.label_file, [&](std::ostream& out) { write_labels(out, label_of_polygon); });
  if (writes_meshes)
    write_meshes(o, input, labels, label_of_polygon, number_of_segments, tree, files);
  watch.end_phase();
  if (!o.report_file.empty()) // the last, as it has the time of the others
    files.write(o.report_file, [&](std::ostream& out) {
      out << report(o, input, number_of_segments, tree, watch)
               .dump(1, ' ', false, Json::error_handler_t::replace) << "\n";
    });
  files.commit();
  watch.hide();
  if (!o.quiet)
    print_summary(o.writes_to_standard_output() ? std::cerr : std::cout, o, input,
                  number_of_segments, watch.seconds());
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
