#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# setup.sh GROUP ...
# Installs the Debian packages that are missing of the groups build, test, python, python_examples,
# pictures, manual, performance, machines, cluster, blender and web. The tests of the Python package
# need the groups python and test.

set -euo pipefail

packages=()
for group in "$@"; do
  case $group in
    build)
      packages+=(cmake make g++ libcgal-dev libeigen3-dev libboost-dev libtbb-dev libcli11-dev
                 nlohmann-json3-dev libassimp-dev lib3mf-dev libjs-three libcgal-demo) ;;
    test)
      packages+=(ninja-build libboost-test-dev libopenmesh-dev python3 doxygen chromium
                 chromium-driver python3-selenium python3-pytest python3-hypothesis python3-meshio
                 python3-open3d) ;;
    python)
      packages+=(python3-dev python3-numpy python3-pybind11 python3-setuptools python3-wheel
                 python3-pip python3-venv) ;;
    pictures) packages+=(python3-vtk9 xvfb xauth) ;;
    manual) packages+=(doxygen python3-vtk9 xvfb xauth) ;;
    performance)
      packages+=(libbenchmark-dev libmeshoptimizer-dev valgrind python3 python3-matplotlib
                 python3-numpy python3-scipy) ;;
    machines)
      packages+=(g++-aarch64-linux-gnu qemu-user g++-mingw-w64-x86-64-posix wine wine64
                 emscripten) ;;
    cluster) packages+=(slurm-wlm munge) ;;
    python_examples)
      packages+=(python3-matplotlib python3-pandas python3-vtk9 python3-distributed xvfb xauth) ;;
    blender) packages+=(blender xvfb xauth) ;;
    web)
      packages+=(emscripten node-acorn node-typescript libfast-float-dev libfmt-dev chromium
                 chromium-driver python3-selenium)
      command -v npm > /dev/null || packages+=(nodejs npm) ;; # Node of other sources has its own
    *) echo "setup.sh: no such group: $group (build, test, python, python_examples, pictures," \
            "manual, performance, machines, cluster, blender, web)" >&2
       exit 1 ;;
  esac
done

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
[[ ${#missing[@]} -gt 0 ]] || exit 0

as_root=()
if [[ $EUID -ne 0 ]]; then
  as_root=(sudo)
  if ! command -v sudo > /dev/null; then
    echo "setup.sh: not root and no sudo; please install: ${missing[*]}" >&2
    exit 1
  fi
fi
"${as_root[@]}" apt-get update
# Slim images of Debian leave out /usr/share/doc, where libcgal-demo has its meshes.
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
  -o 'DPkg::Options::=--path-include=/usr/share/doc/libcgal-dev/*' "${missing[@]}"
