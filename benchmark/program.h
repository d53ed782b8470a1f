// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PROGRAM_H
#define SEGMENTATION_BENCHMARK_PROGRAM_H

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

// The common part of all programs.
namespace segmentation_benchmark {

// Adds the folder of the benchmark, required by default, and the ids of its meshes.
inline CLI::Option* add_benchmark_options(CLI::App& app, std::string& folder, std::string& ids)
{
  app.add_option("--ids", ids, "odd, even, all, or a list as 1-20,33")->capture_default_str();
  return app.add_option("folder", folder, "holds off/N.off and seg/Benchmark/N/*.seg")
    ->required()->check(CLI::ExistingDirectory);
}

inline void add_threads_option(CLI::App& app, std::size_t& threads)
{
  app.add_option("--threads", threads, "meshes at a time, each on one thread if more than 1")
    ->check(CLI::Range(1, 1024))->capture_default_str();
}

// Runs a program. Returns its exit status: 0, or 1 with a message on standard error.
template <class Options>
int run_program(const char* name, const char* description,
                void (*add_options)(CLI::App&, Options&), void (*run)(const Options&), int argc,
                char** argv)
{
  Options options;
  CLI::App app(description, name);
  try {
    add_options(app, options);
    app.parse(argc, argv);
    run(options);
    return EXIT_SUCCESS;
  }
  catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& e) {
    std::cerr << name << ": " << e.what() << "\n";
    return EXIT_FAILURE;
  }
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PROGRAM_H
