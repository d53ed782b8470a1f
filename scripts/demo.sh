#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the command line tool, segments a mesh of an elephant with it, and makes a picture of that.
# Installs the Debian packages that are missing.

set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh build pictures
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release \
  -DSPECTRAL_SEGMENTATION_BUILD_TESTS=OFF -DSPECTRAL_SEGMENTATION_BUILD_BENCHMARKS=OFF
echo "compiling the tool, which takes a few minutes"
cmake --build build --target segment_mesh

mkdir -p out
build/bindings/command_line/segment_mesh build/data/meshes/elephant.off -o out/elephant.ply
scripts/render.py out/elephant.ply -o out/elephant.png --azimuth 150
echo "colored mesh: $PWD/out/elephant.ply"
echo "picture:      $PWD/out/elephant.png"
