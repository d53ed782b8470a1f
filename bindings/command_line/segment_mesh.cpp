// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Command line tool that segments mesh files. The exit status reports how a run ended. If it is
/// not 0, standard error has an error message in one line.

#include "Batch.h"
#include "Constraint_files.h"
#include "../meshes/Failure.h"
#include "Output_files.h"
#include "Run_watch.h"
#include "../meshes/closed_soup.h"
#include "is_terminal.h"
#include "../files/face_colors.h"
#include "../files/read_face_vectors.h"
#include "option_texts.h"
#include "../meshes/page/write_page.h"
#include "../meshes/part_tree.h"
#include "process_memory.h"
#include "../meshes/read_input.h"
#include "../meshes/refined_input.h"
#include "report.h"
#include "../meshes/transferred_labels.h"
#include "write_bodies.h"
#include "write_meshes.h"

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/property_map.h>
#include <CGAL/segment_spectral_recursive.h>

#include <CLI/CLI.hpp>
#include <boost/property_map/function_property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#ifndef _WIN32
#include <unistd.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Option_description;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using namespace segment_mesh;

typedef CGAL::Spectral_segmentation::Options Segmentation_options;

// Returns the text of the two defaults of an option for the help.
template <class Function>
std::string both_defaults(const Function& number)
{
  std::ostringstream out;
  out << " [" << std::invoke(number, Segmentation_options()) << ", paper "
      << std::invoke(number, Segmentation_options::zhang_liu_2005()) << ']';
  return out.str();
}

// Returns whether each segment in the file is an object of its own, which may have caps. These
// formats also have a unit.
bool has_objects(const std::string& mesh_file)
{
  const std::string extension = mesh_file::output_extension(mesh_file);
  return extension == ".glb" || is_3mf(extension);
}

bool can_have_materials(const std::string& mesh_file)
{
  const std::string extension = mesh_file::output_extension(mesh_file);
  return extension == ".obj" || extension == ".glb";
}

struct Options
{
  std::vector<std::string> inputs;
  std::string list_file, output_directory; // used by batches
  std::vector<std::string> output_formats = {"labels"};
  std::optional<std::size_t> jobs;
  std::string input, seed_file, edge_file, feature_file;
  std::string label_file, report_file, hierarchy_file, page_file, split_directory,
    hull_directory, urdf_file, mjcf_file, transfer_file;
  std::vector<std::string> mesh_files; // used by single runs, too
  std::string split_format; // empty for the defaults
  std::optional<std::size_t> hull_vertices;
  std::string method_name = "calibrated";
  std::optional<std::size_t> segments, maximum_segments;
  std::optional<double> threshold;
  Segmentation_options segmentation;
  std::optional<std::size_t> threads;
  double time_limit = std::numeric_limits<double>::infinity();   // in seconds
  double memory_limit = std::numeric_limits<double>::infinity(); // in 10^6 bytes
  bool keep_groups = false;
  bool is_reversed = false;
  bool allow_external_files = false;
  bool keep_faces = false;
  bool close = false;
  bool keep_materials = false;
  std::string unit;
  double scale = 1;
  double density = 1000; // in kg / m^3
  bool quiet = false;
  bool prints_man_page = false, prints_completion = false;

  bool uses_paper_method() const { return method_name == "paper"; }

  bool writes_meshes() const
  { return !mesh_files.empty() || !split_directory.empty() || !hull_directory.empty(); }

  bool writes_bodies() const { return !(urdf_file + mjcf_file).empty(); }

  bool has_output() const
  {
    return writes_meshes() || writes_bodies() ||
           !(label_file + report_file + hierarchy_file + page_file).empty();
  }

  bool writes_to_standard_output() const
  {
    return is_standard_output(label_file) || is_standard_output(report_file) ||
           is_standard_output(hierarchy_file) || is_standard_output(page_file);
  }

  std::string part_extension() const
  { return !split_format.empty() ? '.' + split_format : writes_bodies() ? ".stl" : ".ply"; }

  std::string hull_extension() const
  { return !split_format.empty() ? '.' + split_format : writes_bodies() ? ".stl" : ".obj"; }

  // Adds the meshes that robot descriptions name, in folders beside them.
  void add_meshes_of_bodies()
  {
    if (!writes_bodies())
      return;
    close = true;
    std::filesystem::path path = urdf_file.empty() ? mjcf_file : urdf_file;
    path.replace_extension();
    if (split_directory.empty())
      split_directory = path.string() + "_parts";
    if (hull_directory.empty())
      hull_directory = path.string() + "_hulls";
  }

  // Returns the millimeters of the unit of the mesh; 0 if it is unknown.
  double millimeters() const
  {
    static const std::map<std::string, double> units{
      {"", 0}, {"um", 1e-3}, {"mm", 1}, {"cm", 10}, {"m", 1e3}, {"in", 25.4}, {"ft", 304.8}};
    return units.at(unit);
  }

  bool writes_unit() const
  {
    return writes_bodies() ||
           (!split_directory.empty() && has_objects("part" + part_extension())) ||
           (!hull_directory.empty() && has_objects("hull" + hull_extension())) ||
           std::any_of(mesh_files.begin(), mesh_files.end(), has_objects);
  }

  // Returns whether a file has the materials of the input.
  bool writes_materials() const
  {
    return (!split_directory.empty() && can_have_materials("part" + part_extension())) ||
           (keep_materials &&
            std::any_of(mesh_files.begin(), mesh_files.end(), can_have_materials));
  }

  bool uses_colors() const { return feature_file == "colors"; }

  Segmentation_options segmentation_options() const
  {
    Segmentation_options result = segmentation;
    result.number_of_segments = segments;
    if (maximum_segments)
      result.maximum_number_of_segments = *maximum_segments;
    result.salience_threshold = threshold;
    if (feature_file.empty())
      result.feature_weight = 0;
    return result;
  }
};

const std::vector<std::string> output_formats = {"labels", "hierarchy", "ply", "obj", "off",
                                                 "glb", "3mf", "parts", "hulls", "html", "urdf",
                                                 "mjcf"};

// The largest value of options that are 32-bit numbers
const std::int64_t largest_number = (std::numeric_limits<std::uint32_t>::max)();

CLI::Validator not_empty()
{
  return CLI::Validator([](const std::string& name)
    { return std::string(name.empty() ? "the path is empty" : ""); }, "");
}

CLI::Option* add_file(CLI::App& app, const char* name, std::string& file, const char* description)
{ return app.add_option(name, file, description)->type_name("FILE")->check(not_empty()); }

void add_input_options(CLI::App& app, Options& o)
{
  app.option_defaults()->group("Input");
  app.add_option("IN", o.inputs, "mesh or polygon soup: .off, .obj, .ply, .stl"
#ifdef SEGMENT_MESH_WITH_ASSIMP
                 ", .glb, .fbx and others that Assimp reads"
#endif
                 "; - reads standard input; several IN, or a folder to search for meshes, need "
                 "--out-dir")
    ->type_name("FILE")->check(not_empty());
  app.add_flag("--allow-external-files", o.allow_external_files,
               "read files that IN names, such as buffers of glTF, wherever they are; otherwise "
               "they must be in the folder of IN, so that a file from a stranger cannot publish "
               "yours");
}

void add_output_options(CLI::App& app, Options& o)
{
  app.option_defaults()->group("Output");
  app.add_option("-o", o.mesh_files,
                 "mesh with a color for each segment: .ply with the face property 'segment', .obj "
                 "with groups and with materials in a .mtl, .off, or with the tree of parts .glb"
#ifdef SEGMENT_MESH_WITH_LIB3MF
                 " or .3mf"
#endif
                 "; may be repeated")
    ->type_name("FILE")->allow_extra_args(false)->check(not_empty());
  add_file(app, "--labels", o.label_file,
           "label of each face of IN, one per line; a polygon that a boundary cuts gets the label "
           "of the segment that covers most of it; - writes to standard output");
  add_file(app, "--json", o.report_file,
           "report with counts, seconds per stage summed over all parts, parameters, segments and "
           "hierarchy of cuts; - writes to standard output");
  add_file(app, "--hierarchy", o.hierarchy_file,
           "hierarchy of cuts with the leaf of each face, from which C++ and Python make other "
           "numbers of segments without a new run; - writes to standard output");
  add_file(app, "--html", o.page_file,
           "page for a browser that shows the segments, or fewer or more of them, and saves "
           "pictures; - writes to standard output");
  add_file(app, "--split-dir", o.split_directory,
           "directory for one file per segment; replaces the files of an earlier run")
    ->type_name("DIR");
  add_file(app, "--hulls", o.hull_directory,
           "directory for the convex hull of each segment, such as collision shapes; like "
           "--split-dir. The hull of a flat segment gets a thickness, which the report names")
    ->type_name("DIR");
  add_file(app, "--urdf", o.urdf_file,
           "robot description with a link for each segment, and fixed joints where they touch. It "
           "names a closed mesh and a convex hull of each segment, in folders beside FILE whose "
           "names end with _parts and _hulls, unless --split-dir and --hulls name others");
  add_file(app, "--mjcf", o.mjcf_file, "the same for MuJoCo, as one free body that has the others");
  add_file(app, "--transfer-to", o.transfer_file,
           "another mesh of the same shape, such as a decimated copy: its faces get the labels of "
           "the nearest faces of IN, and -o, --labels, --split-dir and --hulls write it instead of "
           "IN");
  app.add_option("--split-format", o.split_format,
                 "format of the files in --split-dir [ply] and --hulls [obj]; [stl] for --urdf and "
                 "--mjcf")
    ->type_name("F")->check(CLI::IsMember({"ply", "obj", "off", "stl", "glb", "3mf"}));
  app.add_flag("--quiet", o.quiet, "print neither progress nor a summary");
}

void add_written_mesh_options(CLI::App& app, Options& o)
{
  app.option_defaults()->group("Written meshes");
  app.add_flag("--keep-faces", o.keep_faces,
               "write meshes and pages with the faces of IN, so that boundaries run along their "
               "edges in zigzag; otherwise faces are split along smooth boundaries. Labels always "
               "refer to the faces of IN");
  app.add_flag("--close", o.close,
               "close the segments of --split-dir, and of -o with .glb or .3mf, for example for 3D "
               "printing: with caps that neighbors share, and at holes of the mesh; with --hulls, "
               "the report also has the volume of each hull divided by the volume of its segment");
  app.add_flag("--keep-materials", o.keep_materials,
               "write -o with .obj or .glb with the materials and textures of IN, if it has any, "
               "instead of a color for each segment; parts of --split-dir in these formats always "
               "have them");
  app.add_option("--hull-vertices", o.hull_vertices,
                 "largest number of vertices of a hull, which stays convex and contains its "
                 "segment; Unity takes at most 255, PhysX on a GPU 64 [no limit]")
    ->type_name("N")->check(CLI::Range(std::int64_t(4), largest_number));
  app.add_option("--unit", o.unit,
                 "unit of the coordinates of IN, so that .3mf has millimeters, and .glb, --urdf "
                 "and --mjcf meters; without it coordinates stay")
    ->type_name("U")->check(CLI::IsMember({"um", "mm", "cm", "m", "in", "ft"}));
  app.add_option("--density", o.density,
                 "density for the mass and inertia in --urdf and --mjcf, in kg/m^3 [1000]")
    ->type_name("D")->check(CLI::Range(1e-9, 1e9));
  app.add_option("--scale", o.scale, "factor of all coordinates that are written [1]")
    ->type_name("F")->check(CLI::Range(1e-9, 1e9));
}

void add_segmentation_options(CLI::App& app, Options& o)
{
  app.option_defaults()->group("Segmentation");
  app.add_option("--segments", o.segments, "exact number of segments")
    ->type_name("N")->check(CLI::Range(std::int64_t(1), largest_number));
  app.add_option("--maximum-segments", o.maximum_segments,
                 "largest number of segments: of the cuts above the threshold, the most salient "
                 "ones are made")
    ->type_name("N")->check(CLI::Range(std::int64_t(1), largest_number));
  app.add_option("--salience-threshold", o.threshold,
                 "smallest salience of a cut; with --method calibrated the probability that a "
                 "person would cut there" +
                   both_defaults(CGAL::Spectral_segmentation::threshold_of))
    ->type_name("T");
  app.add_option("--minimum-segment-size", o.segmentation.minimum_segment_size,
                 "smallest area of a segment, as a fraction of the area of the mesh" +
                   both_defaults(&Segmentation_options::minimum_segment_size))
    ->type_name("S")->check(CLI::Range(0., 0.5));
  app.add_flag("--keep-components-separate", o.segmentation.keep_components_separate,
               "make each connected component a part from the start, as --method paper does; "
               "otherwise components that touch may belong to the same part");
  app.add_flag("--reverse", o.is_reversed,
               "search the surface as if all its faces were turned around; the outputs keep the "
               "faces of IN. Closed components that point inward, and open ones with small holes, "
               "are turned around anyway");
  app.add_flag("--keep-groups", o.keep_groups,
               "treat each object or group of IN as a separate component; those of .obj, "
               "and the nodes of files that Assimp reads");
  app.add_option("--smooth", o.segmentation.number_of_smoothing_iterations,
                 "number of steps of Laplacian smoothing before distances are computed [0]")
    ->type_name("N")->check(CLI::Range(std::int64_t(0), largest_number));
  app.add_option("--searches", o.segmentation.number_of_searches,
                 "number of coarse meshes that are searched; the cuts are those of the search that "
                 "agrees best with the others" +
                   both_defaults(&Segmentation_options::number_of_searches))
    ->type_name("N")->check(CLI::Range(std::int64_t(1), std::int64_t(100)));
  app.add_option("--method", o.method_name,
                 "calibrated cuts where people cut; paper is the method of Zhang and Liu 2005")
    ->type_name("M")->check(CLI::IsMember({"calibrated", "paper"}))->capture_default_str();
  app.add_option("--seed", o.segmentation.random_seed,
                 "seed for random first reference faces; without it they are not random")
    ->type_name("S")->check(CLI::Range(std::int64_t(0), largest_number));
}

void add_constraint_options(CLI::App& app, Options& o)
{
  app.option_defaults()->group("Constraints");
  add_file(app, "--seeds", o.seed_file,
           "seed of each face of IN, one per line: faces with one seed belong to the same segment, "
           "those with different seeds to different segments; -1 is no seed");
  add_file(app, "--edges", o.edge_file,
           "edges of IN that must lie between segments, or must not, one per line: the indices of "
           "two points, from 0, and 'cut' or 'keep'");
}

void add_feature_options(CLI::App& app, Options& o)
{
  app.option_defaults()->group("Features");
  add_file(app, "--features", o.feature_file,
           "what is known of each face of IN beyond its shape, one line for each: numbers, such as "
           "a color or the output of a neural network, or a whole number, a label that may be "
           "wrong; or an array of NumPy (.npy); or 'colors', those of IN itself");
  app.add_option("--feature-weight", o.segmentation.feature_weight,
                 "the weight of the features: with 0 they are not used, with 1 the shape only "
                 "breaks ties between cuts that the features do not distinguish")
    ->type_name("W")->check(CLI::Range(0., 1.))->capture_default_str();
}

void add_batch_options(CLI::App& app, Options& o)
{
  app.option_defaults()->group("Many meshes");
  CLI::Option* const out_dir =
    add_file(app, "--out-dir", o.output_directory,
             "directory for the outputs of each IN under its path, such as DIR/IN.json, and for "
             "DIR/table.jsonl with a line for each IN; meshes that an earlier run finished are "
             "skipped")
      ->type_name("DIR");
  add_file(app, "--list", o.list_file,
           "file with the paths of further IN, one per line; - reads standard input");
  app.add_option("--outputs", o.output_formats,
                 "outputs in --out-dir besides the reports: colored meshes by their format, "
                 "'parts' as with --split-dir, 'hulls' as with --hulls, 'html' as with --html, "
                 "'urdf', 'mjcf', 'hierarchy' and 'labels'")
    ->type_name("F")->delimiter(',')->allow_extra_args(false)
    ->check(CLI::IsMember(output_formats))->needs(out_dir)->default_str("labels");
  app.add_option("--jobs", o.jobs, "number of meshes that --out-dir segments at a time [all cores]")
    ->type_name("N")->check(CLI::Range(1, 1024))->needs(out_dir);
}

void add_resource_options(CLI::App& app, Options& o)
{
  app.option_defaults()->group("Resources");
  app.add_option("--threads", o.threads,
                 "number of threads; does not change the result [all; 1 with --out-dir]")
    ->type_name("N")->check(CLI::Range(1, 1024));
  app.add_option("--time-limit", o.time_limit, "stop a run that takes more than S seconds [none]")
    ->type_name("S")->check(CLI::Range(1e-3, 1e9));
  app.add_option("--memory-limit", o.memory_limit,
                 "stop a run that needs more than M million bytes of address space; implies "
                 "--threads 1 [none]")
    ->type_name("M")->check(CLI::Range(1., 1e9));
}

void add_options(CLI::App& app, Options& o)
{
  app.formatter(std::make_shared<Help_formatter>());
  app.allow_windows_style_options(false); // a path may begin with a slash
  app.set_help_flag();
  add_input_options(app, o);
  add_output_options(app, o);
  add_written_mesh_options(app, o);
  add_segmentation_options(app, o);
  add_constraint_options(app, o);
  add_feature_options(app, o);
  add_batch_options(app, o);
  add_resource_options(app, o);
  app.option_defaults()->group("Help");
  app.set_help_flag("-h,--help", "print this help");
  app.set_version_flag("--version", "segment_mesh " CGAL_SPECTRAL_SEGMENTATION_VERSION,
                       "print the version");
  app.add_flag("--print-man-page", o.prints_man_page)->group("");
  app.add_flag("--print-bash-completion", o.prints_completion)->group("");
}

// Throws errors of usage that can be found before any run.
void check_usage(const Options& o)
{
#ifndef CGAL_LINKED_WITH_TBB
  if (o.threads && *o.threads > 1)
    throw Failure(Status::USAGE, "--threads above 1 needs TBB, but this build is without TBB");
#endif
  if (std::isnan(o.time_limit) || std::isnan(o.memory_limit) || std::isnan(o.scale) ||
      std::isnan(o.density))
    throw Failure(Status::USAGE, "--time-limit, --memory-limit, --scale and --density must be "
                                 "numbers");
  if (std::isfinite(o.memory_limit) && o.threads.value_or(1) > 1)
    throw Failure(Status::USAGE, "--memory-limit allows only one thread; leave out --threads");
  if (o.segments && (o.threshold || o.maximum_segments))
    throw Failure(Status::USAGE, "--segments N makes exactly N segments, so it goes neither with "
                                 "--salience-threshold nor with --maximum-segments; "
                                 "--maximum-segments N limits the number");
  if (o.threshold && std::isnan(*o.threshold))
    throw Failure(Status::USAGE, "--salience-threshold must be a number");
  if (o.threshold && !o.uses_paper_method() && std::isfinite(*o.threshold) &&
      !(*o.threshold >= 0 && *o.threshold <= 1))
    throw Failure(Status::USAGE, "--salience-threshold must be in [0, 1] with --method "
                                 "calibrated, because it is a probability, or infinite");
  if (o.output_directory.empty()) {
    if (o.inputs.empty() && o.list_file.empty())
      throw Failure(Status::USAGE, "no input mesh given; see --help");
    if (!o.list_file.empty())
      throw Failure(Status::USAGE, "--list needs --out-dir");
    if (o.inputs.size() > 1)
      throw Failure(Status::USAGE, "several input meshes (" + CLI::detail::join(o.inputs, ", ") +
                                     ") need --out-dir; -o takes one FILE each time");
    if (std::error_code error; std::filesystem::is_directory(o.inputs[0], error))
      throw Failure(Status::USAGE, o.inputs[0] + " is a folder; --out-dir DIR segments the meshes "
                                     "in it");
    return;
  }
  if (o.has_output())
    throw Failure(Status::USAGE, "with --out-dir, choose the outputs with --outputs");
  if (!o.transfer_file.empty())
    throw Failure(Status::USAGE, "--transfer-to goes with one mesh, not with --out-dir");
  if (!o.seed_file.empty() || !o.edge_file.empty() || !o.feature_file.empty())
    throw Failure(Status::USAGE, "--seeds, --edges and --features are of one mesh, not of those of "
                                 "--out-dir");
}

// Throws errors in the files that can be found before a long run.
void check_files(const Options& o)
{
  std::vector<std::filesystem::path> outputs = {o.label_file, o.report_file, o.hierarchy_file,
                                                o.page_file, o.urdf_file, o.mjcf_file};
  for (const std::string& name : {o.urdf_file, o.mjcf_file})
    if (!name.empty() && is_stream(name))
      throw Failure(Status::USAGE, "--urdf and --mjcf need a file, beside which the meshes are");
  if (o.writes_bodies() && o.part_extension() != ".stl" && o.part_extension() != ".obj")
    throw Failure(Status::USAGE, "--urdf and --mjcf need --split-format stl or obj");
  if (!o.page_file.empty())
    check_page();
  for (const std::string& name : o.mesh_files) {
    check_output_format(name, false);
    outputs.push_back(name);
    if (mesh_file::output_extension(name) == ".obj")
      outputs.push_back(mesh_file::name_of_materials(name));
  }
  if (!o.split_directory.empty())
    check_output_format("segment" + o.part_extension(), true);
  if (!o.hull_directory.empty())
    check_output_format("segment" + o.hull_extension(), true);
  if (o.hull_vertices && o.hull_directory.empty())
    throw Failure(Status::USAGE, "--hull-vertices needs --hulls");
  if (o.close && o.split_directory.empty() && o.hull_directory.empty() &&
      std::none_of(o.mesh_files.begin(), o.mesh_files.end(), has_objects))
    throw Failure(Status::USAGE, "--close needs an output of separate segments: --split-dir, "
                                 "--hulls, or -o with .glb or .3mf");
  if (o.keep_materials && !o.writes_materials())
    throw Failure(Status::USAGE, "--keep-materials needs -o with .obj or .glb");
  if (!o.unit.empty() && !o.writes_unit())
    throw Failure(Status::USAGE, "--unit needs an output that has a unit: .glb, .3mf, --urdf or "
                                 "--mjcf");
  if (!o.transfer_file.empty() && !o.writes_meshes() && o.label_file.empty())
    throw Failure(Status::USAGE, "--transfer-to needs an output of the other mesh: -o, --labels, "
                                 "--split-dir or --hulls");
  check_outputs({o.input, o.seed_file, o.edge_file,
                 o.uses_colors() ? std::string() : o.feature_file, o.transfer_file},
                outputs, {o.split_directory, o.hull_directory});
}

template <class NamedParameters>
std::size_t segment(const Input& input, std::vector<Index>& labels, const Options& o,
                    const NamedParameters& np)
{
  const auto ids = CGAL::make_property_map(labels);
  const auto run = [&](const auto& triangles) {
    if (o.threads == 1) // starts no thread, so that running out of memory is an exception
      return CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(input.soup.points, triangles,
                                                                    ids, np);
    return CGAL::segment_spectral_recursive(input.soup.points, triangles, ids, np);
  };
  if (!o.is_reversed)
    return run(input.triangles);
  auto reversed = input.triangles;
  for (auto& t : reversed)
    std::swap(t[1], t[2]);
  return run(reversed);
}

// Returns the features of the polygons; none without a file.
mesh_file::Face_vectors read_features(const Input& input, const Options& o)
{
  if (o.feature_file.empty())
    return {};
  mesh_file::Face_vectors result;
  try {
    result = o.uses_colors() ? mesh_file::face_vectors(3, mesh_file::face_colors(input.soup))
                             : mesh_file::read_face_vectors(o.feature_file);
  }
  catch (const std::runtime_error& e) {
    throw Failure(Status::INPUT, (o.uses_colors() ? o.input : o.feature_file) + ": " + e.what());
  }
  if (result.number_of_faces() != input.soup.number_of_polygons())
    throw Failure(Status::USAGE, o.feature_file + " has " +
                                   std::to_string(result.number_of_faces()) +
                                   " vectors, but the mesh has " +
                                   std::to_string(input.soup.number_of_polygons()) + " faces");
  return result;
}

std::size_t segment(const Input& input, std::vector<Index>& labels, const Options& o,
                    Segmentation_hierarchy& tree, Run_watch& watch)
{
  const std::vector<Index>& groups = input.soup.group_of_polygon;
  const auto group = boost::make_function_property_map<std::size_t, Index>([&](std::size_t t)
    { return o.keep_groups && !groups.empty() ? groups[input.polygon_of_triangle[t]] : 0; });
  const mesh_file::Face_vectors features = read_features(input, o);
  const auto feature = boost::make_function_property_map<std::size_t>([&](std::size_t t)
    { return features[input.polygon_of_triangle[t]]; });
  const auto np = parameters::options(o.segmentation_options())
                    .face_group_map(group).face_feature_map(feature).hierarchy(tree)
                    .visitor(std::ref(watch));
  Constraint_files constraints(input);
  if (!o.seed_file.empty())
    constraints.read_seeds(o.seed_file);
  if (!o.edge_file.empty())
    constraints.read_edges(o.edge_file);
  try {
    if (!constraints.has_seeds() && !constraints.has_edges())
      return segment(input, labels, o, np);
    typedef std::pair<std::size_t, std::size_t> Edge;
    const auto edges = [&](bool must_be_cut) {
      return boost::make_function_property_map<Edge, bool>([&constraints, must_be_cut](Edge e)
        { return constraints.is_given(e, must_be_cut); });
    };
    const auto seeds = boost::make_function_property_map<std::size_t, std::int64_t>(
      [&](std::size_t t) { return constraints.seed(t); });
    if (!constraints.has_edges())
      return segment(input, labels, o, np.face_seed_map(seeds));
    return segment(input, labels, o, np.face_seed_map(seeds)
                                       .edge_is_constrained_map(edges(true))
                                       .edge_is_uncuttable_map(edges(false)));
  }
  catch (const std::invalid_argument& e) { // "segment_spectral_recursive: message"
    const std::string sentence = e.what();
    throw Failure(Status::USAGE, sentence.substr(sentence.find(": ") + 2));
  }
}

template <class T>
Json json_or_null(const std::optional<T>& value)
{ return value ? Json(*value) : Json(); }

// Returns the parameters of a run. The threshold is null if it has no effect. Parameters without an
// option have the defaults of the version.
Json parameters_report(const Options& o)
{
  const Segmentation_options used = o.segmentation_options();
  Json result = {{"method", o.method_name}};
  for_each_option(used, [&](const Option_description& option, const auto& value) {
    if constexpr (std::is_arithmetic<std::decay_t<decltype(value)> >::value)
      result[option.name] = value;
  });
  for (const char* name : {"number_of_coarse_faces", "number_of_reference_faces"}) // no option
    result.erase(name);
  result.update({
          {"number_of_segments", json_or_null(o.segments)},
          {"maximum_number_of_segments", json_or_null(o.maximum_segments)},
          {"salience_threshold", used.number_of_segments ? Json() : Json(threshold_of(used))},
          {"random_seed", json_or_null(used.random_seed)},
          {"keep_groups", o.keep_groups},
          {"reverse", o.is_reversed},
          {"seeds", o.seed_file.empty() ? Json() : Json(o.seed_file)},
          {"edges", o.edge_file.empty() ? Json() : Json(o.edge_file)},
          {"features", o.feature_file.empty() ? Json() : Json(o.feature_file)},
          {"feature_weight", o.feature_file.empty() ? Json() : Json(used.feature_weight)},
          {"transfer_to", o.transfer_file.empty() ? Json() : Json(o.transfer_file)},
          {"keep_faces", o.keep_faces},
          {"close", o.close},
          {"keep_materials", o.keep_materials},
          {"hull_vertices", json_or_null(o.hull_vertices)},
          {"unit", o.unit.empty() ? Json() : Json(o.unit)},
          {"scale", o.scale},
          {"density", o.writes_bodies() ? Json(o.density) : Json()}});
  return result;
}

// Returns the part of the report that says how a run ended; it is the whole report of a failed run.
Json status_report(const Options& o, Status status, const std::string& message)
{
  return {{"version", CGAL_SPECTRAL_SEGMENTATION_VERSION},
          {"input", o.input},
          {"status", name_of(status)},
          {"message", message}};
}

Page_options page_options(const Options& o, std::size_t number_of_segments)
{
  Page_options result;
  result.name = std::filesystem::path(o.input).filename().string();
  result.number_of_segments = number_of_segments;
  result.is_salience_probability = !o.uses_paper_method();
  result.keep_faces = o.keep_faces;
  return result;
}

Json report(const Options& o, const Input& input, std::size_t number_of_segments,
            const Segmentation_hierarchy& tree, const Run_watch& watch,
            const Json& of_parts)
{
  Json result = status_report(o, Status::OK, "");
  result.update({
          {"input_faces", input.soup.number_of_polygons()},
          {"faces", input.triangles.size()},
          {"vertices", number_of_vertices(input)},
          {"node_names", input.node_names},
          {"mesh_names", input.mesh_names},
          {"missing_files", input.missing_files},
          {"warnings", input.soup.warnings},
          {"segments", number_of_segments},
          {"seconds", seconds_report(watch)},
          {"peak_memory", peak_memory()},
          {"threads", json_or_null(o.threads)},
          {"parameters", parameters_report(o)},
          {"hierarchy", hierarchy_report(tree, input)}});
  result.update(of_parts);
  return result;
}

// Writes an input as meshes, with refined boundaries if its faces need not be kept. Adds what holds
// for closed segments and hulls to a report, and warnings.
void write_meshes(const Options& o, const Input& input, const std::vector<Index>& label_of_triangle,
                  const std::vector<Index>& label_of_polygon, std::size_t number_of_segments,
                  const std::vector<mesh_file::Part>& parts, Output_files& files, Json& report,
                  std::vector<std::string>& warnings)
{
  const std::vector<Rgb> colors =
    segment_colors(segment_neighbors(input, label_of_triangle, number_of_segments));
  bool is_refined = !o.keep_faces && number_of_segments > 1;
  Refined_input refined;
  if (is_refined)
    refined = Input_refinement(input, label_of_triangle)(label_of_polygon);
  Closed_soup closed;
  if (o.close) {
    const std::size_t pairs = number_of_intersecting_pairs(input);
    report["intersecting_pairs"] = pairs;
    if (pairs > 0)
      warnings.push_back("the input intersects itself in " + std::to_string(pairs) +
                         (pairs == 1 ? " pair" : " pairs") + " of faces; the modifier Remesh of "
                         "Blender, in its mode Voxel, makes a solid of it");
    closed = is_refined ? closed_soup(refined.input, refined.segment)
                        : closed_soup(input, label_of_polygon);
    if (is_refined && pairs == 0 && number_of_solids(closed) < closed.segments.size()) {
      Closed_soup unrefined = closed_soup(input, label_of_polygon);
      if (number_of_solids(unrefined) > number_of_solids(closed)) {
        closed = std::move(unrefined);
        refined = Refined_input();
        is_refined = false;
        warnings.push_back("boundaries run along the faces as with --keep-faces, because more "
                           "closed segments bound a solid then");
      }
    }
    report["closed_segments"] = closed_report(closed.segments);
    if (const std::string warning = closed_warning(closed.segments); !warning.empty())
      warnings.push_back(warning);
  }
  const Input& written = is_refined ? refined.input : input;
  const std::vector<Index>& labels = is_refined ? refined.segment : label_of_polygon;
  const mesh_file::Segmented_soup mesh{written.soup, labels, colors, parts, refined.polygon,
                                       o.keep_materials};
  std::vector<Index> closed_faces = refined.polygon;
  if (!is_refined) {
    closed_faces.resize(input.soup.number_of_polygons());
    std::iota(closed_faces.begin(), closed_faces.end(), Index(0));
  }
  closed_faces.resize(closed.segment.size(), mesh_file::null_index);
  const mesh_file::Segmented_soup closed_mesh{closed.soup, closed.segment, colors, parts,
                                              closed_faces, o.keep_materials};
  for (const std::string& name : o.mesh_files)
    write_mesh(files, name, o.close && has_objects(name) ? closed_mesh : mesh, o.millimeters());
  if (!o.split_directory.empty())
    write_segments(files, o.split_directory, o.part_extension(), o.close ? closed_mesh : mesh,
                   o.millimeters(), report["closed_segments"]);
  if (o.hull_directory.empty())
    return;
  const std::vector<double> volumes = volumes_of_solids(closed.segments, number_of_segments);
  const std::vector<mesh_file::Convex_hull> hulls =
    segment_hulls(mesh, o.hull_vertices.value_or(largest_number));
  report["hulls"] = write_hulls(files, o.hull_directory, o.hull_extension(), hulls, colors,
                                o.millimeters(), volumes, warnings);
  if (!o.writes_bodies())
    return;
  const double meters = o.unit.empty() ? 1 : o.millimeters() / 1000;
  std::vector<Body> bodies =
    body_tree(bodies_of(closed_mesh, hulls, volumes, meters, o.density, warnings),
              contacts(written, labels), meters);
  const std::string name = std::filesystem::path(o.input).stem().string();
  for (const auto& [file, write] : {std::pair(o.urdf_file, &write_urdf),
                                    std::pair(o.mjcf_file, &write_mjcf)}) {
    if (file.empty())
      continue;
    name_meshes(bodies, file, o.split_directory, o.hull_directory, o.part_extension());
    std::ostringstream text;
    write(text, name, bodies, meters);
    files.write(file, [&](std::ostream& out) { out << text.str(); });
  }
}

void print_summary(std::ostream& out, const Options& o, const Input& input,
                   std::size_t number_of_segments, double seconds)
{
  out << o.input << ": " << input.soup.number_of_polygons() << " faces, " << number_of_segments
      << (number_of_segments == 1 ? " segment, " : " segments, ") << std::fixed
      << std::setprecision(2) << seconds << " s, " << peak_memory() / 1000000 << " MB" << std::endl;
  if (!out)
    throw_cannot_write("the summary");
}

// Estimates of the times of the phases. Only the reported progress depends on them.
struct Expected_seconds
{
  double reading, joining, segmenting, writing;

  Expected_seconds(double bytes, double faces, bool writes_triangles)
    : reading(4e-9 * bytes), joining(1e-7 * faces), segmenting(0.2 + 1.5e-6 * faces),
      writing((writes_triangles ? 3e-7 : 5e-8) * faces) {}
};

// Returns an input that has triangles.
Input checked(Input input, const std::string& name)
{
  if (input.triangles.empty())
    throw Failure(Status::MESH, name + " has no face with three different corners" +
                                  first_warning(input.soup));
  return input;
}

// Returns a warning of segments that no triangle of another mesh has; else nothing.
std::string missing_segments(const std::vector<Index>& labels, std::size_t number_of_segments)
{
  std::vector<char> is_found(number_of_segments, 0);
  for (Index label : labels)
    is_found[label] = 1;
  const auto number = std::count(is_found.begin(), is_found.end(), 0);
  return number == 0 ? "" : std::to_string(number) +
                              (number == 1 ? " segment is" : " segments are") +
                              " smaller than its faces, and missing";
}

// Multiplies the points, which must stay finite.
void multiply_points(Polygon_soup& soup, double factor)
{
  mesh_file::scale(soup, factor);
  for (Index v : soup.corners)
    for (double c : soup.points[v])
      if (!std::isfinite(c))
        throw Failure(Status::OUTPUT, "--scale makes the coordinates too large");
}

void print_warning(const std::string& name, const std::string& warning)
{ std::cerr << "segment_mesh: warning: " << name << ": " << warning << std::endl; }

// Segments a mesh and writes the outputs. Returns a row of the table of a batch.
Json run(const Options& o)
{
  const Memory_limit memory_limit(1e6 * o.memory_limit);
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> limit;
  if (o.threads)
    limit.emplace(tbb::global_control::max_allowed_parallelism, *o.threads);
#endif
  Run_watch watch(!o.quiet && standard_error_is_terminal(), o.time_limit);
  const bool writes_triangles = o.writes_meshes() || !o.page_file.empty();
  const double bytes = size_of_file(o.input);
  const Expected_seconds first_guess(bytes, bytes / 20, writes_triangles);
  watch.start_phase("reading", first_guess.reading, first_guess.joining + first_guess.segmenting +
                                                      first_guess.writing);
  const bool is_transferred = !o.transfer_file.empty();
  const Reading_limits limits{o.time_limit, o.jobs.value_or(1), o.allow_external_files,
                              o.writes_materials() || o.uses_colors()};
  Scene scene, other_scene;
  try {
    scene = read_scene(o.input, o.writes_meshes() || o.uses_colors(), limits);
    if (is_transferred)
      other_scene = read_scene(o.transfer_file, o.writes_meshes(), limits);
  }
  catch (const Failure&) {
    watch.end_phase(); // fails if the reader has taken all the time
    throw;
  }
  const Expected_seconds expected(bytes, static_cast<double>(scene.soup.number_of_polygons()),
                                  writes_triangles);
  watch.start_phase("joining", expected.joining, expected.segmenting + expected.writing);
  Input input = checked(triangulated(std::move(scene)), o.input), other;
  if (is_transferred)
    other = checked(triangulated(std::move(other_scene)), o.transfer_file);
  Input& written = is_transferred ? other : input;

  watch.start_phase("segmentation", expected.segmenting, expected.writing);
  std::vector<Index> labels(input.triangles.size());
  Segmentation_hierarchy tree;
  const std::size_t number_of_segments = segment(input, labels, o, tree, watch);
  if (!o.is_reversed)
    if (std::string warning = inward_warning(input); !warning.empty())
      input.soup.warnings.push_back(std::move(warning));

  watch.start_phase("writing", expected.writing, 0);
  std::vector<mesh_file::Part> parts;
  if (o.writes_meshes())
    parts = part_tree(tree, labels, number_of_segments);
  if (is_transferred)
    labels = transferred_labels(input, labels, other);
  const std::vector<Index> label_of_polygon = labels_of_polygons(written, labels);
  if (o.scale != 1) { // the labels do not depend on it
    multiply_points(input.soup, o.scale);
    if (is_transferred)
      multiply_points(other.soup, o.scale);
  }
  Output_files files;
  if (!o.label_file.empty())
    files.write(o.label_file, [&](std::ostream& out) { write_labels(out, label_of_polygon); });
  Json of_parts = {{"intersecting_pairs", nullptr}, {"closed_segments", Json::array()},
                   {"hulls", Json::array()}};
  std::vector<std::string> warnings = written.soup.warnings;
  if (is_transferred)
    if (const std::string warning = missing_segments(labels, number_of_segments); !warning.empty())
      warnings.push_back(warning);
  if (o.writes_meshes())
    write_meshes(o, written, labels, label_of_polygon, number_of_segments, parts, files, of_parts,
                 warnings);
  if (!o.hierarchy_file.empty())
    files.write(o.hierarchy_file, [&](std::ostream& out) { write_hierarchy(out, tree, input); });
  if (!o.page_file.empty())
    files.write(o.page_file, [&](std::ostream& out) {
      write_page(out, page_data(input, tree, page_options(o, number_of_segments)));
    });
  watch.end_phase();
  if (!o.report_file.empty()) // written last, because it holds the time of the others
    files.write(o.report_file, [&](std::ostream& out) {
      out << report(o, input, number_of_segments, tree, watch, of_parts)
               .dump(1, ' ', false, Json::error_handler_t::replace) << "\n";
    });
  files.commit();
  watch.hide();
  if (!o.quiet) {
    print_summary(o.writes_to_standard_output() ? std::cerr : std::cout, o, input,
                  number_of_segments, watch.seconds());
    if (!o.has_output() && standard_error_is_terminal())
      std::cerr << "Nothing was written. --html FILE shows the segments, -o FILE.ply or .glb has "
                   "their colors; see --help" << std::endl;
    if (is_transferred)
      for (const std::string& warning : input.soup.warnings)
        print_warning(o.input, warning);
    const std::string& name_of_written = is_transferred ? o.transfer_file : o.input;
    for (const std::string& warning : warnings)
      print_warning(name_of_written, warning);
    if (!written.missing_files.empty())
      std::cerr << "segment_mesh: warning: " << mesh_file::in_quotes(written.missing_files[0])
                << (written.missing_files.size() > 1 ? " and other files of materials" : "")
                << " cannot be read"
                << (o.allow_external_files ? "" : " in the folder of " + name_of_written)
                << std::endl;
    const std::size_t wanted = o.segments.value_or(o.maximum_segments.value_or(number_of_segments));
    if (number_of_segments > wanted)
      std::cerr << "segment_mesh: warning: more than " << wanted
                << " segments, because each connected component is at least one" << std::endl;
  }
  return {{"input", o.input},
          {"status", name_of(Status::OK)},
          {"message", ""},
          {"faces", input.soup.number_of_polygons()},
          {"segments", number_of_segments},
          {"seconds", watch.seconds()},
          {"peak_memory", peak_memory()}};
}

// Writes the report of a run that failed, if requested. Returns the row of the run in a table.
Json report_failure(const Options& o, const Failure& failure)
{
  if (!o.report_file.empty())
    try {
      Output_files files;
      files.write(o.report_file, [&](std::ostream& out) {
        out << status_report(o, failure.status, failure.what())
                 .dump(1, ' ', false, Json::error_handler_t::replace) << "\n";
      });
      files.commit();
    }
    catch (const std::exception&) { // only the first failure counts
    }
  return {{"input", o.input},
          {"status", name_of(failure.status)},
          {"message", failure.what()},
          {"faces", nullptr},
          {"segments", nullptr},
          {"seconds", nullptr},
          {"peak_memory", nullptr}};
}

// Returns the options of one mesh of a batch. The names of its outputs begin with `path`.
Options options_of_mesh(const Options& batch, const std::string& input, const Path& path)
{
  Options o = batch;
  o.input = input;
  o.quiet = true;
  o.threads = batch.threads.value_or(1);
  o.report_file = path.string() + ".json";
  for (const std::string& format : batch.output_formats) {
    const std::string name = path.string() + '.' + format;
    if (format == "labels")
      o.label_file = name;
    else if (format == "hierarchy")
      o.hierarchy_file = name + ".json";
    else if (format == "html")
      o.page_file = name;
    else if (format == "parts")
      o.split_directory = name;
    else if (format == "hulls")
      o.hull_directory = name;
    else if (format == "urdf")
      o.urdf_file = name;
    else if (format == "mjcf")
      o.mjcf_file = path.string() + ".xml";
    else
      o.mesh_files.push_back(name);
  }
  o.add_meshes_of_bodies();
  return o;
}

Json run_of_batch(const Options& o)
{
#ifndef _WIN32
  if (std::isfinite(o.time_limit))
    alarm(static_cast<unsigned>(o.time_limit) + 5); // stops code that does not check the limit
#endif
  try {
    check_files(o);
    std::vector<std::string> files = o.mesh_files;
    files.insert(files.end(), {o.label_file, o.hierarchy_file, o.page_file});
    for (const std::string& name : files)
      if (!name.empty() && is_stream(name)) // nobody may read it
        throw_cannot_write(name, "it is not a file");
    return run(o);
  }
  catch (...) {
    return report_failure(o, current_failure(o.input));
  }
}

Status run_batch(Options o)
{
  std::vector<std::string> names = o.inputs, inputs;
  if (!o.list_file.empty())
    for (std::string& name : read_list(o.list_file))
      names.push_back(std::move(name));
  for (const std::string& name : names)
    for (std::string& mesh : meshes_in(name, o.output_directory))
      inputs.push_back(std::move(mesh));
  const std::size_t cores = (std::max)(1u, std::thread::hardware_concurrency());
  o.jobs = std::clamp(o.jobs.value_or(cores / o.threads.value_or(1)), std::size_t(1),
                      (std::max)(inputs.size(), std::size_t(1)));
  const Json parameters = {{"version", CGAL_SPECTRAL_SEGMENTATION_VERSION},
                           {"parameters", parameters_report(o)},
                           {"outputs", o.output_formats}};
  Batch batch(o.output_directory, !o.quiet && standard_error_is_terminal());
  const Batch::Counts counts = batch(
    inputs, parameters, *o.jobs,
    [&](const std::string& input, const Path& path)
    { return run_of_batch(options_of_mesh(o, input, path)); },
    [&](const std::string& input, const Path& path, const Failure& failure)
    { return report_failure(options_of_mesh(o, input, path), failure); });
  if (!o.quiet)
    std::cout << counts.done - counts.failed
              << (counts.done - counts.failed == 1 ? " mesh segmented, " : " meshes segmented, ")
              << counts.failed << " failed, " << counts.kept << " done before; see "
              << (Path(o.output_directory) / "table.jsonl").string() << std::endl;
  return counts.failed > 0 ? Status::SOME_FAILED : Status::OK;
}

int fail(const Failure& failure)
{
  std::string sentence = failure.what();
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');
  std::cerr << "segment_mesh: " << sentence << std::endl;
  return static_cast<int>(failure.status);
}

// Returns the failure that CLI11 has found. For an unknown option it suggests a similar one.
Failure failure_of_usage(const CLI::App& app, const CLI::ParseError& error)
{
  for (const std::string& word : app.remaining())
    if (word.size() > 1 && word[0] == '-') {
      const std::string similar = similar_option(app, word);
      return Failure(Status::USAGE, "unknown option " + word +
                                      (similar.empty() ? "; see --help"
                                                       : "; did you mean " + similar + "?"));
    }
  return Failure(Status::USAGE, error.what());
}

int main(int argc, char* argv[])
{
  // Keeps CGAL from printing the errors that it throws.
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  Options options;
  CLI::App app("Cuts a mesh into the parts that a person would name.",
               "segment_mesh");
  try {
    add_options(app, options);
    app.parse(argc, argv);
    if (options.uses_paper_method()) { // with other defaults
      options.segmentation = Segmentation_options::zhang_liu_2005();
      app.parse(argc, argv);
    }
    if (options.prints_man_page || options.prints_completion) {
      std::cout << (options.prints_man_page ? man_page(app) : bash_completion(app));
      return EXIT_SUCCESS;
    }
    check_usage(options);
    if (!options.output_directory.empty())
      return static_cast<int>(run_batch(options));
    options.input = options.inputs.front();
    if (std::isfinite(options.memory_limit))
      options.threads = 1;
    options.add_meshes_of_bodies();
    check_files(options);
  }
  catch (const CLI::Success& e) {
    return app.exit(e);
  }
  catch (const CLI::ParseError& e) {
    return fail(failure_of_usage(app, e));
  }
  catch (...) {
    return fail(current_failure(options.input));
  }
  try {
    run(options);
    return EXIT_SUCCESS;
  }
  catch (...) {
    const Failure failure = current_failure(options.input);
    report_failure(options, failure);
    return fail(failure);
  }
}
