// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// One run with one thread, whose instructions `scripts/check_instructions.py` counts; and what
/// such counts depend on.

#include "princeton_benchmark.h"
#include "program.h"

#include <CGAL/segment_spectral_recursive.h>
#include <CGAL/tags.h>
#include <CGAL/version.h>

#include <boost/property_map/vector_property_map.hpp>
#include <boost/version.hpp>

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <gnu/libc-version.h>

#include <cstddef>
#include <iostream>
#include <string>

using namespace segmentation_benchmark;
namespace params = CGAL::Spectral_segmentation::parameters;

struct Options
{
  std::string mesh_file;
  std::string method = "calibrated";
};

// Instructions are counted from the call of this function to its end.
extern "C" __attribute__((noinline)) void counted_run(const Mesh& mesh, bool is_by_paper)
{
  const boost::vector_property_map<std::size_t> segment_ids(mesh.number_of_faces());
  if (is_by_paper)
    CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(mesh, segment_ids,
                                                           params::zhang_liu_2005());
  else
    CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(mesh, segment_ids);
}

void print_environment()
{
  std::cout << nlohmann::ordered_json{
    {"compiler", __VERSION__},
    {"glibc", gnu_get_libc_version()},
    {"CGAL", CGAL_VERSION_STR},
    {"Eigen", std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) +
                "." + std::to_string(EIGEN_MINOR_VERSION)},
    {"Boost", BOOST_LIB_VERSION},
    {"flags", SPECTRAL_SEGMENTATION_COMPILER_FLAGS}} << std::endl;
}

void add_options(CLI::App& app, Options& o)
{
  app.add_option("mesh", o.mesh_file, "mesh file; without one, what the counts depend on is "
                                      "printed")->check(CLI::ExistingFile);
  app.add_option("--method", o.method, "calibrated or paper")
    ->check(CLI::IsMember({"calibrated", "paper"}))->capture_default_str();
}

void run(const Options& o)
{
  if (o.mesh_file.empty())
    print_environment();
  else
    counted_run(read_mesh(o.mesh_file), o.method == "paper");
}

int main(int argc, char** argv)
{
  return run_program("instructions", "One run, for a count of its instructions.", add_options, run,
                     argc, argv);
}
