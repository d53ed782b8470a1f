#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests a small application of the npm package with bundlers, in Chromium: bundlers.py TARBALL
[PACKAGE@VERSION ...], where the tarball is what build.sh makes. The bundlers come from the npm
registry; versions may be given, such as vite@5."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from selenium.webdriver.support.ui import WebDriverWait

from local_server import start_server

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "command_line/test"))
import page_in_browser

TARBALL = None
BUNDLERS = {"vite": "vite", "webpack": "webpack", "webpack-cli": "webpack-cli",
            "esbuild": "esbuild"}

INDEX = '<!DOCTYPE html><html><body><script type="module" src="./%s"></script></body></html>'

# A tetrahedron in this thread and in a worker.
APPLICATION = """
import { load } from "spectral-segmentation";
import { SegmentationWorker } from "spectral-segmentation/worker";
const points = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
const triangles = new Uint32Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
const report = text => { document.title += ` ${text};`; };
const failed = error => report(`failed: ${error.message}`);
load().then(s => report(s.segment(s.mesh(points, triangles)).numberOfSegments), failed)
  .then(() => new SegmentationWorker().segment({ points, triangles }))
  .then(run => report(`worker ${run.numberOfSegments}`), failed);
"""

# The setting that README.md gives for the dev server before Vite 8.
OLD_VITE = 'export default { optimizeDeps: { exclude: ["spectral-segmentation"] } };'


class Bundlers_test(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.folder = pathlib.Path(directory.name)
        (cls.folder / "package.json").write_text('{ "private": true, "type": "module" }')
        cls.run_here("npm", "install", "--no-audit", "--no-fund", "--silent", TARBALL,
                     *BUNDLERS.values())
        (cls.folder / "main.js").write_text(APPLICATION)
        (cls.folder / "index.html").write_text(INDEX % "main.js")
        for name in BUNDLERS:
            package = json.loads((cls.folder / "node_modules" / name / "package.json").read_text())
            print(name, package["version"])
            if name == "vite" and int(package["version"].split(".")[0]) < 8:
                (cls.folder / "vite.config.js").write_text(OLD_VITE)
        profile = tempfile.TemporaryDirectory()
        cls.addClassCleanup(profile.cleanup)
        cls.browser = page_in_browser.start_browser(profile.name)
        cls.addClassCleanup(cls.browser.quit)

    @classmethod
    def run_here(cls, *command):
        run = subprocess.run(command, cwd=cls.folder, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True)
        if run.returncode != 0:
            raise AssertionError("%s:\n%s" % (" ".join(command), run.stdout))
        return run.stdout

    def title_of(self, address):
        self.browser.get(address)
        WebDriverWait(self.browser, 60).until(lambda b: re.search("worker|failed", b.title))
        return self.browser.title

    def check(self, folder):
        server = start_server(self.folder / folder, self.addCleanup)
        self.assertEqual(self.title_of("http://127.0.0.1:%d/" % server.server_port),
                         "1; worker 1;")

    def test_vite_build(self):
        output = self.run_here("npx", "vite", "build", "--outDir", "vite")
        self.assertNotIn("warning", output.lower())
        self.check("vite")

    def test_vite_dev_server(self):
        server = subprocess.Popen(["node_modules/.bin/vite", "--host", "127.0.0.1"],
                                  cwd=self.folder, stdout=subprocess.PIPE, text=True)
        self.addCleanup(server.stdout.close)
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        address = None
        while not address:
            line = server.stdout.readline()
            self.assertTrue(line, "the server of Vite ended")
            address = re.search(r"http://127\.0\.0\.1:\d+/", re.sub(r"\x1b\[\d+m", "", line))
        self.assertEqual(self.title_of(address[0]), "1; worker 1;")

    def test_webpack(self):
        self.run_here("npx", "webpack", "--mode", "production", "--entry", "./main.js",
                      "--output-path", str(self.folder / "webpack"))
        (self.folder / "webpack" / "index.html").write_text(INDEX % "main.js")
        self.check("webpack")

    def test_esbuild(self):
        self.run_here("npx", "esbuild", "main.js",
                      "worker=node_modules/spectral-segmentation/worker.js", "--bundle",
                      "--format=esm", "--outdir=esbuild")
        shutil.copy(self.folder / "node_modules/spectral-segmentation/module.wasm",
                    self.folder / "esbuild")
        (self.folder / "esbuild" / "index.html").write_text(INDEX % "main.js")
        self.check("esbuild")


if __name__ == "__main__":
    page_in_browser.CHROMIUM = shutil.which("chromium")
    page_in_browser.DRIVER = shutil.which("chromedriver")
    TARBALL = str(pathlib.Path(sys.argv[1]).resolve())
    for package in sys.argv[2:]:
        BUNDLERS[package[:package.index("@")]] = package
    unittest.main(argv=sys.argv[:1])
