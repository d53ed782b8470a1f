#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the examples and all tests in build-test/, and runs the tests.
# Installs the Debian packages that are missing.

set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh build test
# Less to compile than with -O3 and each test by itself, which is what check_all.sh builds.
cmake -S . -B build-test -DCMAKE_BUILD_TYPE=Release \
  -DSPECTRAL_SEGMENTATION_BUILD_TESTS=ON -DSPECTRAL_SEGMENTATION_BUILD_EXAMPLES=ON \
  -DSPECTRAL_SEGMENTATION_BUILD_BENCHMARKS=OFF \
  -DCMAKE_CXX_FLAGS_RELEASE='-O1 -DNDEBUG' \
  -DSPECTRAL_SEGMENTATION_UNITY_TESTS=ON
cmake --build build-test --parallel "$(nproc)"
cd build-test
exec ctest --output-on-failure --parallel "$(nproc)"
