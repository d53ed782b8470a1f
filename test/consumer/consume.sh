#!/bin/sh
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# consume.sh find_package BUILD_DIR CMAKE_OPTION ...
# consume.sh add_subdirectory|fetch_content CMAKE_OPTION ...
# Builds and runs the program of this folder, which gets the package in the way that is named, in a
# temporary folder. For find_package the package is first installed there from its build.
set -e
way=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if [ "$way" = find_package ]; then
  # Installed here and moved there: no path may be fixed.
  cmake --install "$1" --prefix "$work/installed"
  mv "$work/installed" "$work/moved"
  shift
fi
cmake -S "$(dirname "$0")/$way" -B "$work/build" -DSpectral_segmentation_ROOT="$work/moved" "$@"
cmake --build "$work/build"
"$work/build/consumer"
