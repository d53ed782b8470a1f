#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test.sh TOOL MESHES [DIR]
# Tests what build.sh has built in DIR, by default build-web/, beside the native tool: the types,
# the module in Node, the page in Chromium. MESHES is the folder of libcgal-demo's meshes,
# data/meshes/ in a build folder. With the variable ALL_MESHES the labels of all of them are
# compared.

set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
tool=$(realpath "$1")
meshes=$(realpath "$2")
build=$(realpath "${3:-$here/../../build-web}")

cp "$here/test/types.ts" "$build"
tsc --noEmit --strict --target es2022 --moduleResolution node "$build/types.ts"
PACKAGE=$build/package MESHES=$meshes SEGMENT_MESH=$tool \
  node --test "$here/test/module.test.mjs"
/usr/bin/python3 "$here/test/page.py" "$build/try" "$tool" "$meshes" \
  "$(command -v chromium)" "$(command -v chromedriver)"
