#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# check_all.sh --cgal DIR [--build DIR]
# All programs and tests under g++ and clang++, each in Release with warnings as errors and in Debug
# with sanitizers, each header alone, the readers under a fuzzer, an hour of random runs with
# sanitizers, the pictures of the manual, the number of instructions of a run, the labels on other
# machines, the add-on in Blender, the installed Python package, the web page, the npm package with
# bundlers from the npm registry, and many meshes, also on a cluster of Slurm.
# Release once more against a CGAL 6 whose CGALConfig.cmake is in DIR, the tool, the Python module
# and all examples too, and the examples of the package that scripts/lay_out_cgal_package.py lays
# out. Takes long; builds in build-check/ or the --build folder. Needs to be root, clang, and the
# packages of `setup.sh build test python python_examples performance machines cluster blender web`.

set -euo pipefail
cd "$(dirname "$0")/.."

cgal=
build=build-check
while [[ $# -gt 0 ]]; do
  case $1 in
    --cgal) cgal=$(realpath "$2"); shift 2 ;;
    --build) build=$2; shift 2 ;;
    *) echo "check_all.sh: unknown option: $1" >&2; exit 1 ;;
  esac
done
if [[ -z $cgal ]]; then
  echo "check_all.sh: --cgal DIR is missing: the folder of CGALConfig.cmake of a CGAL 6" >&2
  exit 1
fi

failed=()

# check NAME PRESET CMAKE_OPTION ...
check() {
  local name=$1 preset=$2
  shift 2
  echo "=== $name"
  cmake --preset "$preset" -B "$build/$name" "$@" &&
    cmake --build "$build/$name" --parallel "$(nproc)" &&
    ctest --test-dir "$build/$name" --output-on-failure --parallel "$(nproc)" ||
    failed+=("$name")
}

# The first build shows that each file compiles by itself, optimized.
quick="-DCMAKE_UNITY_BUILD=ON -DSPECTRAL_SEGMENTATION_PROGRAM_OPTIONS=-O1"
warnings=-DCMAKE_COMPILE_WARNING_AS_ERROR=ON # not with sanitizers, under which g++ has false ones
for compiler in g++ clang++; do
  echo "=== $compiler, each header alone"
  while read -r header; do
    "$compiler" -std=c++17 -Wall -Wextra -Werror -fsyntax-only -Iinclude \
      -isystem "$cgal/include" -isystem /usr/include/eigen3 -include "$header" \
      -x c++ /dev/null || failed+=("$compiler-$header")
  done < <(cd include && find . -name '*.h' | sort)

  check "$compiler-release" release "$warnings" -DCMAKE_CXX_COMPILER="$compiler" \
    $([[ $compiler = g++ ]] || echo "$quick")
  check "$compiler-sanitize" sanitize $quick -DCMAKE_CXX_COMPILER="$compiler"
  check "$compiler-cgal" release "$warnings" $quick -DCMAKE_CXX_COMPILER="$compiler" \
    -DCGAL_DIR="$cgal"
done
rm -rf "$build/cgal_package"
scripts/lay_out_cgal_package.py "$build/cgal_package" --cgal "$cgal" || failed+=(cgal_package)

echo "=== files that a fuzzer makes up"
cmake --build "$build/g++-release" --target fuzz || failed+=(fuzz)

echo "=== what computes the pictures of the manual"
cmake --build "$build/g++-release" --target manual_figures || failed+=(manual_figures)

echo "=== random runs"
"$build/g++-sanitize/test/random_runs/random_runs" --seconds 3600 --first "$(date +%s)" ||
  failed+=(random_runs)

echo "=== instructions of a run"
cmake --build "$build/g++-release" --target check_instructions || failed+=(instructions)

echo "=== many meshes"
bindings/command_line/test/batch.py "$build/g++-release/bindings/command_line/segment_mesh" \
  --count 200 || failed+=(batch)
scripts/check_slurm.sh "$build/g++-release/bindings/command_line/segment_mesh" \
  "$build/g++-release/data/meshes" || failed+=(slurm)

echo "=== Blender"
PYTHONPATH="$build/g++-release/bindings/python" \
  blender -b -noaudio --factory-startup --python-exit-code 1 \
  -P bindings/blender/test/segment_parts_in_blender.py -- \
  "$build/g++-release/bindings/command_line/segment_mesh" "$build/g++-release/data/meshes" ||
  failed+=(blender)
PYTHONPATH="$build/g++-release/bindings/python" xvfb-run -a blender -noaudio --factory-startup \
  --enable-event-simulate --python-exit-code 1 -P bindings/blender/test/escape_in_blender.py ||
  failed+=(blender_escape)
empty=$(mktemp -d)
/usr/bin/python3 bindings/blender/build_zip.py "$empty/segment_parts.zip" &&
  BLENDER_USER_CONFIG="$empty" BLENDER_USER_SCRIPTS="$empty" \
    blender -b -noaudio --factory-startup --python-exit-code 1 \
    -P bindings/blender/test/zip_in_blender.py -- "$empty/segment_parts.zip" ||
  failed+=(blender_zip)

echo "=== Python, installed"
scripts/check_python.sh "$build/g++-release/bindings/command_line/segment_mesh" \
  "$build/g++-release/data/meshes" || failed+=(python)

echo "=== web"
bindings/web/build.sh "$build/web" &&
  ALL_MESHES=1 bindings/web/test.sh "$build/g++-release/bindings/command_line/segment_mesh" \
    "$build/g++-release/data/meshes" "$build/web" || failed+=(web)
/usr/bin/python3 bindings/web/test/bundlers.py "$build"/web/spectral-segmentation-*.tgz ||
  failed+=(bundlers)

echo "=== other machines"
scripts/check_machines.sh --build "$build/machines" || failed+=(machines)

echo "failed: ${failed[*]:-none}"
[[ ${#failed[@]} -eq 0 ]]
