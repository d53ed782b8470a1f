#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_links.py FOLDER

Fails if a page of the folder has a link or a picture that leads nowhere in it.
"""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """The anchors of a page, and the targets of its links and pictures."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.targets = set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name"):
                self.anchors.add(value)
            elif name in ("href", "src") and value:
                self.targets.add(value)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    pages = {path.name: Page(path.read_text()) for path in folder.glob("*.html")}
    if "index.html" not in pages:
        sys.exit("check_links.py: there is no index.html in " + str(folder))
    broken = []
    for name, page in sorted(pages.items()):
        for target in sorted(page.targets):
            url = urllib.parse.urlparse(target)
            if url.scheme or url.netloc:
                continue
            path = urllib.parse.unquote(url.path) or name
            anchor = urllib.parse.unquote(url.fragment)
            if not (folder / path).exists() or (
                    anchor and path in pages and anchor not in pages[path].anchors):
                broken.append(name + ": " + target)
    if broken:
        sys.exit("These lead nowhere:\n" + "\n".join(broken))


if __name__ == "__main__":
    main()
