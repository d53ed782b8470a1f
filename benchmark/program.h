// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PROGRAM_H
#define SEGMENTATION_BENCHMARK_PROGRAM_H

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <exception>
#include <iostream>

// The common part of all programs.
namespace segmentation_benchmark {

// The main function of a program: exit status 0, or 1 with one sentence on standard error.
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
