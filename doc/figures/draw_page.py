#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the picture of the page in which segments are edited.

  draw_page.py PAGE CHROMIUM OUTPUT

Opens PAGE, which `segment_mesh --html` wrote, merges its first two segments as a user would, and
names the result. OUTPUT receives editor.png, and editor.html, which shows it in the manual.
"""

import pathlib
import subprocess
import sys
import tempfile

EDIT = """<script type="module">
viewer.selectNext(1);
viewer.startMerge();
viewer.selectNext(1);
viewer.startMerge();
viewer.rename("head and neck");
</script>
</body>"""
HTML = """<div class="pictures columns-1">
<figure><img src="pictures/editor.png" alt="The page with an edited segment"/></figure>
</div>
"""


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    page, chromium, output = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
    output.mkdir(parents=True, exist_ok=True)
    picture = output.resolve() / "editor.png"
    with tempfile.TemporaryDirectory() as folder:
        edited = pathlib.Path(folder) / "edited.html"
        edited.write_text(page.read_text(encoding="utf-8").replace("</body>", EDIT), "utf-8")
        subprocess.run([chromium, "--headless=new", "--no-sandbox", "--hide-scrollbars",
                        "--use-gl=angle", "--use-angle=swiftshader",
                        "--enable-unsafe-swiftshader", "--user-data-dir=%s/profile" % folder,
                        "--window-size=1100,760", "--virtual-time-budget=4000",
                        "--screenshot=%s" % picture, edited.as_uri()],
                       check=True, stderr=subprocess.DEVNULL)
    if not picture.exists():
        sys.exit("draw_page.py: %s has made no picture" % chromium)
    (output / "editor.html").write_text(HTML)


if __name__ == "__main__":
    main()
