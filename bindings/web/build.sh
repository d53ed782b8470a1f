#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# build.sh [DIR]
# Builds the WebAssembly module, its npm package and the web page in build-web/ or DIR: the package
# in package/, the page in try/. Needs the packages of `scripts/setup.sh build web`.

set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
build=$(mkdir -p "${1:-$root/build-web}" && cd "${1:-$root/build-web}" && pwd)

# The headers of the libraries, without the headers of the system.
mkdir -p "$build/include"
for name in CGAL boost eigen3/Eigen nlohmann fast_float fmt; do
  ln -sfn "/usr/include/$name" "$build/include/$(basename "$name")"
done

version=$(sed -n 's/.*_VERSION "\(.*\)"/\1/p' \
  "$root/include/CGAL/Spectral_segmentation/version.h")
# The compiler must not fuse multiplications and additions, so that labels equal those elsewhere.
flags=(-std=c++17 -DNDEBUG -fexceptions -ffp-contract=off -msimd128 -Wall -Wextra
  -DCGAL_SPECTRAL_SEGMENTATION_COMPILED
  -DCGAL_DISABLE_GMP -DCGAL_NO_GMP -DCGAL_DISABLE_ROUNDING_MATH_CHECK
  "-I$root/include" "-I$root/bindings" -isystem "$build/include")
export NODE_PATH=/usr/share/nodejs # where Debian has acorn, which the linker needs
mkdir -p "$build/package"
em++ "${flags[@]}" -O3 -c "$here/src/engine.cpp" -o "$build/engine.o"
em++ "${flags[@]}" -O2 -c "$here/src/segmentation.cpp" -o "$build/segmentation.o"
em++ "${flags[@]}" -O3 "$build/engine.o" "$build/segmentation.o" -o "$build/package/module.js" \
  --bind -sMODULARIZE -sEXPORT_ES6 -sENVIRONMENT=web,worker -sALLOW_MEMORY_GROWTH \
  -sMAXIMUM_MEMORY=4GB -sINITIAL_MEMORY=32MB -sTOTAL_STACK=4MB -sFILESYSTEM=0 --minify 0 -g1

sed "s/@version@/$version/" "$here/package.json.in" > "$build/package/package.json"
cp "$here"/*.js "$here"/*.d.ts "$here/README.md" "$root/LICENSE" \
  "$root"/bindings/meshes/page/{decode,hierarchy}.js "$build/package"
(cd "$build" && npm pack --silent ./package)

# The page: the viewer of `segment_mesh --html`, three.js, and meshes of libcgal-demo as samples.
mkdir -p "$build/try/samples"
cp "$here"/page/* \
  "$build"/package/{api,client,decode,hierarchy,index,module,worker,worker_actions,worker_client}.js \
  "$build/package/module.wasm" "$root"/bindings/meshes/page/{viewer,colors,first_view,glb,scene}.js \
  "$root/bindings/meshes/page/viewer.css" "$root/doc/fig/shapes.png" \
  /usr/share/javascript/three/three.min.js \
  /usr/share/javascript/three/examples/js/{controls/OrbitControls,loaders/GLTFLoader}.js \
  "$build/try"
samples=(triceratops.off elephant.off bear.off) # small ones first
tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$build/try/samples" --strip-components 2 \
  "${samples[@]/#/data/meshes/}"
printf '"%s",' "${samples[@]}" | sed 's/.*/export const samples = [&];/' > "$build/try/samples.js"
