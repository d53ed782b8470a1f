# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs of the documents run as they stand."""

import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]


@pytest.mark.parametrize("name, start, end", [
    ("README.md", "```python", "```"),
    ("bindings/python/README.md", "```python", "```"),
    ("doc/Python.txt", r"\code{.py}", r"\endcode"),
    ("doc/Surprises.txt", r"\code{.py}", r"\endcode"),
])
def test_programs(meshes, tmp_path, monkeypatch, name, start, end):
    if not (ROOT / name).exists():
        pytest.skip("the documents are in the repository")
    text = (ROOT / name).read_text(encoding="utf-8")
    blocks = re.findall(r"^%s\n(.*?)^%s$" % (re.escape(start), re.escape(end)), text,
                        re.MULTILINE | re.DOTALL)
    assert len(blocks) == text.count("\n" + start) > 0
    (tmp_path / "elephant.off").symlink_to(meshes / "elephant.off")
    monkeypatch.chdir(tmp_path)
    exec(compile("".join(blocks), name, "exec"), {})
    assert b"segment" in (tmp_path / "parts.ply").read_bytes()[:1000]
