#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""finish_manual.py FOLDER

Changes the pages of a manual where Doxygen has no setting for it:

- The search also finds named parameters and the titles of sections, and finds every name by each
  of its words. Doxygen indexes neither, and compares the beginnings of names only.
- The tree of pages shows names without namespaces and template parameters, for which it has no
  room.
- The menu leads to the reference, without a page between them that lists only its two groups.
- Concepts are called concepts, and name no header, because they have none.
"""

import html
import pathlib
import re
import sys

ROW = re.compile(r"  \['\w+',\['(.*?)',(\[.*\])\]\],?$", re.MULTILINE)
SECTION = re.compile(r'<h[1-6]><a class="anchor" id="(\w+)"></a>\s*(.*?)</h[1-6]>', re.DOTALL)
PARAMETER = re.compile(
    r'<h2 class="memtitle">.*?</span>(\w+\(\))|<td class="paramname named">(\w+)')


def identifier(words):
    """Returns words as the keys of the search spell them."""
    return re.sub(r"[^a-z0-9\x80-\uffff]", lambda c: "_%02x" % ord(c[0]), words.lower())


def keys(name):
    """Returns the keys of a name: the name from each of its longer words on."""
    name = html.unescape(re.sub(r"<.*?>", "", name))
    starts = [word.start() for word in re.finditer(r"[^\W_]{4,}", name)]
    return {identifier(name)} | {identifier(name[start:]) for start in starts}


def find_sections(page, text):
    """Returns the titles of the sections of a page, with their links."""
    title = re.search(r'<div class="title">(.*?)\s*<', text)
    return [(name.replace("'", "&#39;"), "['../%s#%s',1,'%s']" % (page, anchor, title[1]))
            for anchor, name in SECTION.findall(text)]


def mark_parameters(page, text):
    """Gives the named parameters of a page anchors. Returns the page and their links."""
    found, function = [], None

    def mark(match):
        nonlocal function
        function = match[1] or function
        if match[1]:
            return match[0]
        anchor = function[:-2] + "_" + match[2]
        link = "['../%s#%s',1,'named parameter of %s']" % (page, anchor, function)
        found.append((match[2], link))
        return '<td class="paramname named" id="%s">%s' % (anchor, match[2])

    return PARAMETER.sub(mark, text), found


def extend_search(folder, found):
    """Adds names and their links to the files of the search, one for each first letter."""
    data = (folder / "searchdata.js").read_text()
    letters = re.search(r'0: "(.*?)"', data)[1]
    rows = {}
    for path in folder.glob("all_*.js"):
        found.extend(ROW.findall(path.read_text()))
    for name, links in found:
        for key in keys(name):
            rows.setdefault(key[0], {}).setdefault((key, name), []).append(links)
    all_letters = letters + "".join(sorted(set(rows) - set(letters)))
    (folder / "searchdata.js").write_text(data.replace('"%s"' % letters, '"%s"' % all_letters, 1))
    for number, letter in enumerate(all_letters):
        # Names that begin with what is typed come before those that only contain it.
        order = sorted(rows.get(letter, ()), key=lambda row: (row[0] != identifier(row[1]), row))
        lines = ["  ['%s_%d',['%s',%s]]" % (key, i, name, ",".join(rows[letter][key, name]))
                 for i, (key, name) in enumerate(order)]
        script = "all_%x.js" % number
        (folder / script).write_text("var searchData=\n[\n%s\n];\n" % ",\n".join(lines))
        first = folder / "all_0.html"
        if first.exists():
            frame = first.read_text().replace("all_0.js", script)
            (folder / script).with_suffix(".html").write_text(frame)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    sections, parameters = [], []
    for path in sorted(folder.glob("*.html")):
        text = path.read_text()
        sections += find_sections(path.name, text)
        text, found = mark_parameters(path.name, text)
        parameters += found
        if 'Concepts.html">Concepts</a></div>' in text:
            text = re.sub("Class Reference", "Concept Reference", text)
            text = re.sub(r"<p><code>#include.*</code></p>\n", "", text)
        path.write_text(text)
    if not sections or not parameters:
        sys.exit("finish_manual.py: there are no sections, or no named parameters")
    extend_search(folder / "search", parameters + sections)
    for path in folder.glob("group__*.js"):
        names = re.sub(r'\[ "(?:\w+::)*(\w+)(?:< .*? >)?"', r'[ "\1"', path.read_text())
        path.write_text(names)
    menu = folder / "menudata.js"
    reference = "group__PkgSpectralSegmentationRef.html"
    menu.write_text(menu.read_text().replace("modules.html", reference))


if __name__ == "__main__":
    main()
