#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the examples and the tests in build-test/, and runs them, but those that take long, which
# check_all.sh runs.
# Installs the Debian packages that are missing. The variable CMAKE_OPTIONS may hold further options
# for CMake, such as -DCGAL_DIR=/opt/CGAL-6.1.1.

set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh build test python
# The engine runs fast, and the programs around it compile fast. Not with -O0: the linker would take
# functions of the engine that tests include from there. With -Og, GCC takes variables for not
# initialized that are. It compiles 14 % faster if it collects its garbage rarely.
program_options='-Og;-Wno-maybe-uninitialized;--param=ggc-min-heapsize=1000000'
cmake -S . -B build-test -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DSPECTRAL_SEGMENTATION_BUILD_TESTS=ON -DSPECTRAL_SEGMENTATION_BUILD_EXAMPLES=ON \
  -DSPECTRAL_SEGMENTATION_BUILD_BENCHMARKS=OFF -DSPECTRAL_SEGMENTATION_LONG_TESTS=OFF \
  -DCMAKE_CXX_FLAGS_RELEASE='-O2 -DNDEBUG' \
  "-DSPECTRAL_SEGMENTATION_PROGRAM_OPTIONS=$program_options" \
  -DCMAKE_UNITY_BUILD=ON \
  ${CMAKE_OPTIONS:-}
cmake --build build-test --parallel "$(nproc)"
cd build-test
exec ctest --output-on-failure --parallel "$(nproc)" --label-exclude long
