#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# build_manual.sh DOXYGEN DOXYFILE PYTHON HTML_FOLDER [WEB_PAGE_FOLDER]
# Builds the manual, with the page to drop a mesh on if there is one, and fails for a warning of
# Doxygen or a link or picture that leads nowhere.

set -euo pipefail
mkdir -p "$4/pictures"
# Pages of an earlier build go; the pictures, and the shapes that they lead to, are made before.
find "$4" -mindepth 1 -maxdepth 1 ! -name pictures ! -name pages -exec rm -r {} +
if [[ -n ${5:-} ]]; then
  cp -r "$5" "$4/try"
  sed -i 's|<!-- manual -->|<a href="../index.html">Manual</a>|' "$4/try/index.html"
fi
# If there are no pictures, a note is in the place of each figure. If there is no Chromium, only the
# picture of the editor is missing.
names=editor.html
compgen -G "$4/pictures/*.png" > /dev/null ||
  names=$(sed -n 's/^\\htmlinclude\[block\] //p' "$(dirname "$0")"/*.txt)
for name in $names; do
  [[ -e $4/pictures/$name ]] ||
    echo '<p class="left-out"><i>Left out: the pictures of this figure.</i></p>' \
      > "$4/pictures/$name"
done
"$1" "$2"
"$3" "$(dirname "$0")/finish_manual.py" "$4"
"$3" "$(dirname "$0")/check_links.py" "$4"
