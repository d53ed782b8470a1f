#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the examples and all tests in build/, and runs the tests.
# Installs the Debian packages that are missing.

set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh build test
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release \
  -DSPECTRAL_SEGMENTATION_BUILD_TESTS=ON -DSPECTRAL_SEGMENTATION_BUILD_EXAMPLES=ON \
  -DSPECTRAL_SEGMENTATION_BUILD_BENCHMARKS=OFF \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=6
cmake --build build --parallel "$(nproc)"
cd build
exec ctest --output-on-failure --parallel "$(nproc)"
