#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# consume.sh find_package|debian_package BUILD_DIR PROGRAM CMAKE_OPTION ...
# Builds and runs a program of this folder, which finds the installed package, in a temporary
# folder. For find_package the package is installed from its build; for debian_package the Debian
# packages are made, looked at and unpacked. readme_blocks.py tests the other ways to get the
# package.
set -e
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
case $1 in
  find_package)
    # Installed here and moved there: no path may be fixed.
    cmake --install "$2" --prefix "$work/installed"
    mkdir "$work/root"
    mv "$work/installed" "$work/root/usr" ;;
  debian_package)
    cpack --config "$2/CPackConfig.cmake" -B "$work/package"
    for package in "$work"/package/*.deb; do
      dpkg-deb --info "$package"
      dpkg-deb --extract "$package" "$work/root"
    done
    "$work/root/usr/bin/segment_mesh" --version
    grep -q time.limit "$work/root/usr/share/man/man1/segment_mesh.1"
    . "$work/root/usr/share/bash-completion/completions/segment_mesh"
    COMP_WORDS=(segment_mesh --segm) COMP_CWORD=1
    _segment_mesh
    test "${COMPREPLY[*]}" = --segments
    if [[ -e $work/root/usr/lib/python3 ]]; then
      PYTHONPATH=$work/root/usr/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1 \
        /usr/bin/python3 -c 'import numpy, spectral_segmentation as s
assert s.segment(numpy.eye(3), [[0, 1, 2]]).tolist() == [0]
assert s.__file__.startswith("'"$work"'")'
    fi ;;
esac
program=$3
shift 3
cmake -S "$(dirname "$0")/find_package" -B "$work/build" \
  -DSpectral_segmentation_ROOT="$work/root/usr" "$@"
cmake --build "$work/build" --target "$program"
"$work/build/$program"
