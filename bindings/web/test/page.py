#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the page to drop a mesh on in Chromium: page.py FOLDER TOOL MESHES CHROMIUM CHROMEDRIVER,
with the folder of the page, the native segment_mesh, and the directory of CGAL's meshes."""

import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from selenium.common.exceptions import NoSuchElementException, StaleElementReferenceException
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait

from local_server import Handler, start_server

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "command_line/test"))
import page_in_browser # the tests of the viewer

FOLDER = None
TOOL = None
MESHES = None

# Seconds from a drop until another mesh is drawn.
WATCH_DROP = """
const before = globalThis.viewer;
globalThis.seconds = undefined;
addEventListener("drop", () => {
  const start = performance.now();
  const look = () => requestAnimationFrame(() => {
    if (globalThis.viewer === before)
      look();
    else
      requestAnimationFrame(() => { seconds = (performance.now() - start) / 1000; });
  });
  look();
}, { once: true, capture: true });
"""


def tool(*arguments):
    run = subprocess.run([TOOL, *map(str, arguments), "--quiet"], stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE)
    return run.stdout, run.stderr.decode()


class Page_test(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.directory = pathlib.Path(directory.name)
        cls.server = start_server(FOLDER, cls.addClassCleanup)
        cls.browser = page_in_browser.start_browser(
            directory.name, "--host-resolver-rules=MAP mesh.test 127.0.0.1")
        cls.addClassCleanup(cls.browser.quit)
        cls.downloads = cls.directory / "downloads"
        cls.browser.execute_cdp_cmd("Browser.setDownloadBehavior", {
            "behavior": "allow", "downloadPath": str(cls.downloads)})

    def open(self, width=1280, height=800, is_dark=False):
        command = self.browser.execute_cdp_cmd
        command("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 700})
        command("Emulation.setTouchEmulationEnabled", {"enabled": width < 700})
        command("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark" if is_dark else "light"}]})
        # The server has no certificate and no local name, so that browsers allow less.
        self.browser.get("http://mesh.test:%d/" % self.server.server_port)
        self.wait(lambda: self.browser.find_element(By.CSS_SELECTOR, "[data-ready]"))

    def tearDown(self):
        self.assertEqual([line for line in self.browser.get_log("browser")
                          if line["level"] != "INFO"], [])
        self.assertEqual({command for command, _ in Handler.requests}, {"GET"})

    def wait(self, condition, seconds=120):
        return WebDriverWait(self.browser, seconds, 0.02, ignored_exceptions=[
            NoSuchElementException, StaleElementReferenceException]).until(lambda _: condition())

    def by_id(self, name):
        return self.browser.find_element(By.ID, name)

    def part(self, name):
        return self.browser.find_element(By.CSS_SELECTOR, "[data-id=%s]" % name)

    def choose(self, path):
        self.by_id("file").send_keys(str(path))

    def drop(self, *paths):
        for kind in ("dragEnter", "dragOver", "drop"):
            self.browser.execute_cdp_cmd("Input.dispatchDragEvent", {
                "type": kind, "x": 200, "y": 500,
                "data": {"items": [], "files": [*map(str, paths)], "dragOperationsMask": 1}})

    def wait_for(self, name):
        self.wait(lambda: self.by_id("error").is_displayed() or
                  (self.part("name").text == name and not self.by_id("progress").is_displayed()))
        self.assertFalse(self.by_id("error").is_displayed(), self.by_id("error").text)

    def error(self):
        self.wait(lambda: self.by_id("error").is_displayed())
        self.assertFalse(self.by_id("progress").is_displayed())
        return self.by_id("error").text

    def number(self):
        return int(self.part("number").text)

    def set_number(self, n):
        key = Keys.ARROW_RIGHT if n > self.number() else Keys.ARROW_LEFT
        self.part("slider").send_keys(*[key] * abs(n - self.number()))
        self.assertEqual(self.number(), n)

    def colors(self):
        """Returns the colors of the segments that are seen."""
        Select(self.part("shading")).select_by_value("none")
        if self.part("seams").is_selected():
            self.part("seams").click()
        return self.browser.execute_async_script(page_in_browser.COUNT_COLORS)

    def saved(self, button, name):
        path = self.downloads / name
        path.unlink(missing_ok=True)
        self.part(button).click()
        self.wait(lambda: path.exists() and not list(self.downloads.glob("*.crdownload")))
        return path.read_bytes()

    def shown_labels(self):
        """Returns those that the button saves."""
        return self.browser.execute_script("return viewer.labelText()").encode()

    def test_begins_with_a_sample(self):
        self.open()
        self.wait_for("triceratops.off")
        self.assertIn("A sample", self.part("counts").text)
        self.assertEqual(self.shown_labels(),
                         tool(MESHES / "triceratops.off", "--labels", "-")[0])

    def test_textures(self):
        """A note names textures that are not kept."""
        self.open()
        path = self.directory / "image.glb"
        tool(MESHES / "hand.off", "-o", path)
        for has_image in (False, True):
            glb = path.read_bytes()
            size = int.from_bytes(glb[12:16], "little")
            text = glb[20:20 + size].decode().rstrip()
            if has_image:
                text = '{"images":[{"uri":"skin.png"}],' + text[1:]
            text = text.encode() + b" " * (-len(text.encode()) % 4)
            path.write_bytes(glb[:8] + (len(glb) - size + len(text)).to_bytes(4, "little") +
                             len(text).to_bytes(4, "little") + glb[16:20] + text +
                             glb[20 + size:])
            self.choose(path)
            self.wait_for("image.glb")
            self.wait(lambda: has_image == ("textures are not kept" in self.part("counts").text))

    def test_elephant(self):
        self.open()
        path = MESHES / "elephant.off"
        materials = self.directory / "elephant.mtl"
        materials.write_text("newmtl skin")
        self.drop(materials, path)
        self.wait_for("elephant.off")
        self.assertIn("Not read: elephant.mtl.", self.part("counts").text)
        self.assertEqual(self.number(), len(set(tool(path, "--labels", "-")[0].split())))
        self.assertGreaterEqual(len(self.colors()), 10)
        self.set_number(5)
        self.assertEqual(self.saved("saveLabels", "elephant_5.seg"),
                         tool(path, "--segments", 5, "--labels", "-")[0])
        self.assertTrue(self.saved("savePicture", "elephant_5.png").startswith(b"\x89PNG"))
        for extension in ("ply", "glb"):
            mine = self.saved("save" + extension, "elephant_5." + extension)
            tools = self.directory / ("tool." + extension)
            tool(path, "--segments", 5, "-o", tools)
            self.assertEqual(mine, tools.read_bytes(), extension)
        self.browser.execute_script(
            "for (const piece of viewer.segmentOfPiece.keys())"
            "  if (viewer.number === 5) { viewer.select(piece); viewer.cut(); }")
        self.assertEqual(self.number(), 6)
        glb = self.saved("saveglb", "elephant_6.glb")
        self.assertEqual(glb.count(b'"Segment '), 3 * 6) # nodes, meshes, materials
        self.part("saveply").click()
        self.assertIn("PLY is saved without edits", self.error())

    def test_methods(self):
        self.open()
        path = MESHES / "bear.off"
        Select(self.by_id("sample")).select_by_visible_text("bear")
        self.wait_for("bear.off")
        self.assertEqual(self.shown_labels(), tool(path, "--labels", "-")[0])
        Select(self.by_id("method")).select_by_value("paper")
        self.wait(lambda: self.browser.execute_script("return viewer.model.salience")
                  == "salience")
        self.assertEqual(self.shown_labels(),
                         tool(path, "--method", "paper", "--labels", "-")[0])

    def test_formats(self):
        """A mesh that the tool has put together from parts has them, too."""
        self.open()
        for extension in ("off", "obj", "ply", "glb"):
            path = self.directory / ("parts." + extension)
            tool(MESHES / "hand.off", "-o", path)
            self.choose(path)
            self.wait_for(path.name)
            self.assertEqual(self.shown_labels(), tool(path, "--labels", "-")[0], extension)

    def test_warnings(self):
        """They are shown as text, also if a word of the file looks like HTML."""
        self.open()
        path = self.directory / "more.obj"
        path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\n<b>bold</b> 1\nf 1 2 3\nf 2 1 4\n")
        self.choose(path)
        self.wait_for(path.name)
        self.assertIn("Warning: line 5: '<b>bold</b>' is not a statement of OBJ. Warning: face 1 "
                      "uses a point that is not finite; corners left out: 1.",
                      self.part("counts").text)
        self.assertEqual(self.shown_labels(), tool(path, "--labels", "-")[0])
        self.choose(MESHES / "hand.off")
        self.wait_for("hand.off")
        self.assertNotIn("Warning", self.part("counts").text)

    def test_damaged_files(self):
        self.open()
        self.choose(MESHES / "hand.off")
        self.wait_for("hand.off")
        labels = self.shown_labels()
        text = (MESHES / "elephant.off").read_bytes()
        for name, contents, words in [
                ("short.off", text[:50000], "the file ends where a number should be"),
                ("word.off", b"OFF 3 x", "line 1: 'x' is not a number of faces"),
                ("empty.ply", b"", ""), ("noise.stl", bytes(range(256)) * 9, ""),
                ("mesh.xyz", b"hello", "the format is unknown"),
                ("short.glb", b"glTF\2\0\0\0\xff\0\0\0\x10\0\0\0JSON", "it ends after 20 bytes"),
                ("text.gltf", b"hello", "it is damaged or no glTF"),
                ("empty.gltf", b"{}", "it has no mesh"),
                ("lost.gltf", b'{"meshes": [{"primitives": [{"attributes": {"POSITION": 7}}]}], '
                 b'"nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0}',
                 "its data contradict each other"),
                ("copies.gltf", b'{"meshes": [{"primitives": []}], "nodes": [{"mesh": 0, '
                 b'"extensions": {"EXT_mesh_gpu_instancing": {}}}]}', "EXT_mesh_gpu_instancing"),
                ("far.gltf", b'{"meshes": [{"primitives": []}], '
                 b'"buffers": [{"uri": "http://example.org/points.bin"}]}',
                 "in another file, http://example.org/points.bin")]:
            path = self.directory / name
            path.write_bytes(contents)
            self.choose(path)
            self.wait(lambda: name in self.by_id("error").text)
            message = self.error()
            self.assertIn(words, message)
            self.assertEqual(self.by_id("error").get_attribute("role"), "alert")
            if path.suffix in (".off", ".ply", ".stl"): # else the tool has another reader
                self.assertIn(message.split("cannot be cut: ")[1], tool(path)[1])
            self.assertEqual(self.part("name").text, "hand.off")
            self.assertEqual(self.shown_labels(), labels)
        self.by_id("closeError").click()
        self.assertFalse(self.by_id("error").is_displayed())
        self.assertIn("hand", self.browser.title)
        self.assertGreater(len(self.saved("saveply", "hand_%d.ply" % self.number())), 1000)

    def test_cancel(self):
        self.open()
        self.choose(MESHES / "hand.off")
        self.wait_for("hand.off")
        large = self.directory / "large.off"
        if not large.exists():
            write_grid(large, 700)
        self.choose(large)
        self.wait(lambda: "Cutting" in self.by_id("stage").text)
        name = self.part("name").rect # which is not covered
        bar = self.by_id("progress").rect
        self.assertLessEqual(bar["x"] + bar["width"], name["x"])
        self.by_id("cancel").click()
        self.assertFalse(self.by_id("progress").is_displayed())
        self.assertEqual(self.part("name").text, "hand.off")
        self.choose(large) # another mesh in its place
        self.wait(lambda: "Reading" in self.by_id("stage").text)
        self.choose(MESHES / "elephant.off")
        self.wait_for("elephant.off")
        time.sleep(0.5)
        self.assertEqual(self.part("name").text, "elephant.off")
        self.assertFalse(self.by_id("error").is_displayed())

    def test_many_in_a_row(self):
        """More than a browser has contexts of WebGL, of which Chromium warns."""
        self.open()
        for i in range(18):
            name = ["hand.off", "anchor.off"][i % 2]
            self.choose(MESHES / name)
            self.wait_for(name)
        self.assertGreater(len(self.colors()), 1)

    def test_other_meshes(self):
        self.open()
        for name in ("bear.off", "bones.off", "cactus.off", "cheese.off", "cow.off",
                     "cube_quad.off", "dino.off", "fandisk.off", "horizons.off", "man.off",
                     "blobby_3cc.off"):
            with self.subTest(name=name):
                self.choose(MESHES / name)
                self.wait_for(name)
                self.assertEqual(self.shown_labels(), tool(MESHES / name, "--labels", "-")[0])

    def test_layout(self):
        for width, height in ((1280, 800), (390, 844)):
            for is_dark in (False, True):
                self.open(width, height, is_dark)
                self.check_widths(width, ["sample", "method"])
                self.choose(MESHES / "elephant.off")
                self.wait_for("elephant.off")
                self.assertTrue(self.by_id("privacy").is_displayed())
                self.check_widths(width, ["sample", "method", "privacy"])
                red, green, blue = self.background("stage")
                self.assertEqual(red + green + blue < 200, is_dark)
                canvas = self.browser.find_element(By.TAG_NAME, "canvas").rect
                self.assertLessEqual(canvas["x"] + canvas["width"], width)
                self.assertGreater(canvas["height"], 300)
                self.assertLessEqual(canvas["y"] + canvas["height"], height)

    def background(self, name):
        color = self.part(name).value_of_css_property("background-color")
        return [float(x) for x in color.strip("rgba()").split(",")[:3]]

    def check_widths(self, width, names):
        root = "document.documentElement."
        self.assertEqual(self.browser.execute_script(
            "return %sscrollWidth" % root), width)
        for name in names:
            rectangle = self.by_id(name).rect
            self.assertGreaterEqual(rectangle["x"], 0)
            self.assertLessEqual(rectangle["x"] + rectangle["width"], width)

    def test_time_from_drop_to_colors(self):
        """Prints the times only if MESHES_TO_TIME has names of files."""
        if "MESHES_TO_TIME" not in os.environ:
            self.skipTest("MESHES_TO_TIME has no names of files")
        self.open()
        time.sleep(3) # the page is idle
        for path in map(pathlib.Path, os.environ["MESHES_TO_TIME"].split(":")):
            for _ in range(3):
                self.browser.execute_script(WATCH_DROP)
                self.drop(path)
                while not (seconds := self.browser.execute_script("return globalThis.seconds")):
                    time.sleep(0.5)
                print("%s: %.2f s" % (path.name, seconds))

    def test_keyboard(self):
        """Each control has its turn under the tab key, and shows it."""
        self.open()
        self.choose(MESHES / "hand.off")
        self.wait_for("hand.off")
        found = []
        self.browser.execute_script("document.activeElement.blur()")
        for _ in range(30):
            ActionChains(self.browser, duration=0).send_keys(Keys.TAB).perform()
            name, outline = self.browser.execute_script("""
                const part = document.activeElement;
                const shown = part.id === "file" ? part.parentElement : part;
                return [part.id || part.dataset.id, getComputedStyle(shown).outlineStyle];""")
            if name:
                self.assertEqual(outline == "none", False, name)
                found.append(name)
        for name in ("file", "sample", "method", "slider", "saveLabels", "saveply", "saveglb",
                     "savePicture"):
            self.assertIn(name, found)


def write_grid(path, n):
    """Returns a bumpy square of 2 n^2 triangles."""
    with path.open("w") as out:
        out.write("OFF\n%d %d 0\n" % ((n + 1) ** 2, 2 * n * n))
        for i in range(n + 1):
            out.write("".join("%d %d %d\n" % (i, j, (i * i + 3 * j) % 17 // 8)
                              for j in range(n + 1)))
        for i in range(n):
            for j in range(n):
                a = i * (n + 1) + j
                out.write("3 %d %d %d\n3 %d %d %d\n" % (a, a + 1, a + n + 2, a, a + n + 2,
                                                        a + n + 1))


if __name__ == "__main__":
    FOLDER, TOOL, MESHES, page_in_browser.CHROMIUM, page_in_browser.DRIVER = (
        os.path.realpath(path) for path in sys.argv[1:6])
    MESHES = pathlib.Path(MESHES)
    del sys.argv[1:6]
    unittest.main()
