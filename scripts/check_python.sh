#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# check_python.sh SEGMENT_MESH MESHES
# Whether the Python package is installed by README's lines, without a network, and passes its tests
# then; and whether it is installed from its sdist and its wheel. Needs the packages of
# `setup.sh build test python`.

set -euo pipefail

export SEGMENT_MESH MESHES PIP_NO_INDEX=1 PYTHONDONTWRITEBYTECODE=1
SEGMENT_MESH=$(realpath "$1")
MESHES=$(realpath "$2")
root=$(realpath "$(dirname "$0")/..")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Copies, as the builds leave files beside the sources.
cd "$work"
mkdir clone clone/bindings
cp -r "$root"/{README.md,LICENSE,examples,include,scripts} clone
cp -r "$root"/bindings/{command_line,files,python} clone/bindings

lines=$(sed -n 's/^    \(.*my_env.*\)/\1/p' clone/README.md)
[[ $(wc -l <<< "$lines") -eq 2 ]]
(cd clone && bash -euc "$lines")
clone/my_env/bin/python -m pytest -q -p no:cacheprovider "$root/bindings/python/test"

(cd clone/bindings/python && /usr/bin/python3 setup.py -q sdist bdist_wheel)
/usr/bin/python3 -m zipfile -l clone/bindings/python/dist/*.whl | grep -q 'dist-info/.*LICENSE'
for name in sdist wheel; do
  /usr/bin/python3 -m venv --system-site-packages "from_$name"
done
from_sdist/bin/pip install --no-build-isolation clone/bindings/python/dist/*.tar.gz
from_wheel/bin/pip install clone/bindings/python/dist/*.whl
for name in sdist wheel; do
  "from_$name/bin/python" -c "import numpy, spectral_segmentation as s
assert s.__file__.startswith('$work/from_$name')
mesh = (numpy.eye(3), [[0, 1, 2]])
assert s.segment(mesh).tolist() == [0] and s.view(mesh).html"
done
