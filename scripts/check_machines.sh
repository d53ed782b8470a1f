#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# check_machines.sh [--build DIR]
# Whether other machines give the labels of this one, by both methods, on meshes of libcgal-demo.
# test/other_machines/labels.cpp is built by Debian's cross compilers and run in emulators: ARM64
# and AVX2, both with contracted floating point; Windows, with another C library; WebAssembly, with
# another C++ library and pointers of 32 bits. On Windows the command line tool is compared too.
# Builds in build-machines/ or the --build folder. Needs the packages of `setup.sh build machines`.

set -euo pipefail
cd "$(dirname "$0")/.."

build=build-machines
while [[ $# -gt 0 ]]; do
  case $1 in
    --build) build=$2; shift 2 ;;
    *) echo "check_machines.sh: unknown option: $1" >&2; exit 1 ;;
  esac
done

archive=/usr/share/doc/libcgal-dev/data.tar.gz
missing=()
need() { # COMMAND_OR_PATH PACKAGE
  [[ -e $1 ]] || command -v "$1" > /dev/null || missing+=("$2")
}
need g++ g++
need /usr/include/CGAL libcgal-dev
need /usr/include/boost libboost-dev
need /usr/include/eigen3 libeigen3-dev
need /usr/include/CLI libcli11-dev
need /usr/include/nlohmann nlohmann-json3-dev
need "$archive" libcgal-demo
need aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
need qemu-aarch64 qemu-user
need x86_64-w64-mingw32-g++-posix g++-mingw-w64-x86-64-posix
need wine wine
need /usr/lib/wine/wine64 wine64
need em++ emscripten
if [[ ${#missing[@]} -gt 0 ]]; then
  echo "check_machines.sh: missing Debian packages: ${missing[*]}" >&2
  exit 1
fi

meshes=(elephant bunny00 fandisk_large triceratops hand cactus camel bull)
mkdir -p "$build"
build=$(realpath "$build")
rm -rf "$build"/{include,labels,meshes}
mkdir "$build"/{include,labels,meshes}
tar xzf "$archive" -C "$build/meshes" --strip-components=2 \
  $(printf 'data/meshes/%s.off ' "${meshes[@]}")
# The headers that are the same on all machines, without those of the C library beside them
for headers in boost CGAL CLI eigen3/Eigen nlohmann; do
  ln -s "/usr/include/$headers" "$build/include"
done

# compile SOURCE PROGRAM COMPILER FLAG ...
compile() {
  "${@:3}" -std=c++17 -Wall -Wextra -Werror -DNDEBUG -Iinclude -isystem "$build/include" "$1" \
    -o "$build/$2"
}

# segment MACHINE COMMAND ..., which is the program `labels` there
segment() {
  for mesh in "${meshes[@]}"; do
    "${@:2}" "$build/meshes/$mesh.off" | tr -d '\r' > "$build/labels/$1.$mesh" || return
  done
}

# compare NAME EXPECTED LABELS prints the first faces whose labels differ; its status has bit 0 if
# labels by the default method differ, bit 1 if those by the paper's do.
compare() {
  paste -d ' ' "$2" "$3" | awk -v name="$1" '
    NF != 4 || $1 != $3 { by_default = 1 }
    NF != 4 || $2 != $4 { of_paper = 1 }
    (NF != 4 || $1 != $3 || $2 != $4) && ++number <= 5 {
      print name ": face " NR - 1 " has " $3 ", paper " $4 "; expected " $1 ", paper " $2
    }
    END {
      if (number > 5)
        print name ": " number - 5 " more faces"
      exit by_default + 2 * of_paper
    }'
}

failed=()
check_machine() { # MACHINE COMMAND ...
  if ! segment "$@"; then
    echo "$1: the program failed"
    failed+=("$1")
    return
  fi
  local by_default=0 of_paper=0 status
  for mesh in "${meshes[@]}"; do
    status=0
    compare "$1, $mesh" "$build/labels/here.$mesh" "$build/labels/$1.$mesh" || status=$?
    [[ $((status & 1)) -ne 0 ]] || by_default=$((by_default + 1))
    [[ $((status & 2)) -ne 0 ]] || of_paper=$((of_paper + 1))
  done
  local all=${#meshes[@]}
  echo "$1: same labels on $by_default of $all meshes, by the paper's method on $of_paper"
  [[ $by_default -eq $all && $of_paper -eq $all ]] || failed+=("$1")
}

# The command line tool gives the labels of one mesh by both methods.
check_tool_on_windows() {
  for method in calibrated paper; do
    wine "$build/segment_mesh.exe" "$build/meshes/elephant.off" --quiet --method "$method" \
      --labels "$build/labels/tool.$method" || return
  done
  paste -d ' ' "$build"/labels/tool.{calibrated,paper} > "$build/labels/tool.elephant"
  compare "segment_mesh, elephant" "$build"/labels/{here,tool}.elephant
}

labels=test/other_machines/labels.cpp
compile $labels labels-here g++ -O2
segment here "$build/labels-here"

compile $labels labels-avx2 g++ -O3 -march=x86-64-v3 -ffp-contract=fast
check_machine avx2 qemu-x86_64 -cpu max "$build/labels-avx2"

compile $labels labels-arm64 aarch64-linux-gnu-g++ -O2 -ffp-contract=fast -static -Wno-psabi
check_machine arm64 qemu-aarch64 "$build/labels-arm64"

compile $labels labels.exe x86_64-w64-mingw32-g++-posix -O2 -static
compile bindings/command_line/segment_mesh.cpp segment_mesh.exe \
  x86_64-w64-mingw32-g++-posix -O2 -static
export WINEPREFIX=$build/wine WINEDEBUG=-all
wine wineboot > "$build/wineboot.log" 2>&1
check_machine windows wine "$build/labels.exe"
check_tool_on_windows || failed+=(segment_mesh)

# Debian's modules of node, and files as they are in the system
NODE_PATH=/usr/share/nodejs compile $labels labels.js em++ -O2 -fexceptions \
  -sALLOW_MEMORY_GROWTH -sNODERAWFS -sWASM_ASYNC_COMPILATION=0
check_machine webassembly node "$build/labels.js"

echo "machines that differ: ${failed[*]:-none}"
[[ ${#failed[@]} -eq 0 ]]
