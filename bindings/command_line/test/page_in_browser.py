#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the page of `segment_mesh --html` in Chromium: page_in_browser.py TOOL MESHES CHROMIUM
CHROMEDRIVER, with the directory of CGAL's meshes."""

import json
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import unittest

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "test/helpers"))
from mesh_files import read_glb, read_off

TOOL = None
MESHES = None
CHROMIUM = None
DRIVER = None

# Counts the pixels of each color in the picture, with one place. Only colors of some hundred pixels
# belong to segments; others are mixed at their boundaries.
COUNT_COLORS = """
const done = arguments[0];
viewer.scene.picture(async blob => {
  const image = await createImageBitmap(blob);
  const canvas = new OffscreenCanvas(image.width, image.height);
  const context = canvas.getContext("2d");
  context.drawImage(image, 0, 0);
  const { data } = context.getImageData(0, 0, image.width, image.height);
  const found = {};
  for (let i = 0; i < data.length; i += 4)
    if (data[i + 3] === 255) {
      const color = found[data.slice(i, i + 3)] ??= { count: 0, pixels: [] };
      ++color.count;
      color.pixels.push(i / 4);
    }
  const result = {};
  for (const [key, { count, pixels }] of Object.entries(found))
    if (count > 300) {
      // A pixel whose neighbors have its color
      const set = new Set(pixels);
      const inner = pixels.find(p => [-3, 3, -3 * image.width, 3 * image.width]
        .every(step => set.has(p + step)));
      const pixel = inner ?? pixels[0];
      result[key] = { count, x: pixel % image.width, y: Math.floor(pixel / image.width) };
    }
  done(result);
});
"""


# Returns the box around the shape in the picture, and the size of the picture.
FIND_EXTENT = """
const done = arguments[0];
requestAnimationFrame(() => setTimeout(() => viewer.scene.picture(async blob => {
  const image = await createImageBitmap(blob);
  const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
  context.drawImage(image, 0, 0);
  const { data } = context.getImageData(0, 0, image.width, image.height);
  const box = [Infinity, Infinity, -1, -1];
  for (let i = 3; i < data.length; i += 4)
    if (data[i] > 0) {
      const [x, y] = [(i >> 2) % image.width, Math.floor((i >> 2) / image.width)];
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
    }
  done([...box, image.width, image.height]);
})));
"""


# Linear RGB as seen by people who lack one of two kinds of cones: Vienot, Brettel, Mollon,
# "Digital Video Colourmaps for Checking the Legibility of Displays by Dichromats", 1999.
VISIONS = {
    "all cones": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "protanopia": ((0.11238, 0.88762, 0), (0.11238, 0.88762, 0), (0.00401, -0.00401, 1)),
    "deuteranopia": ((0.29275, 0.70725, 0), (0.29275, 0.70725, 0), (-0.02234, 0.02234, 1)),
}


def product(matrix, v):
    return [sum(a * b for a, b in zip(row, v)) for row in matrix]


def cielab(linear):
    xyz = product(((0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505)),
                  linear)
    x, y, z = (t ** (1 / 3) if t > 216 / 24389 else (24389 / 27 * t + 16) / 116
               for t in (max(c, 0) / w for c, w in zip(xyz, (0.9505, 1, 1.089))))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def seen_difference(kind, *colors):
    """Returns the difference of two colors in CIELAB, where 2 can be just seen."""
    linear = [[c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in color]
              for color in colors]
    return math.dist(*(cielab(product(VISIONS[kind], rgb)) for rgb in linear))


def start_browser(directory, *arguments):
    options = Options()
    options.binary_location = CHROMIUM
    for argument in ["--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run",
                     "--disable-background-networking", "--disable-component-update",
                     "--disable-sync", "--disable-dev-shm-usage", "--use-gl=angle",
                     "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                     "--user-data-dir=%s/profile" % directory, *arguments]:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(DRIVER), options=options)


class Page_in_browser_test(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.directory = pathlib.Path(directory.name)
        subprocess.run([TOOL, MESHES / "elephant.off", "--html", cls.directory / "page.html",
                        "--quiet"], check=True)
        cls.browser = start_browser(directory.name)
        cls.addClassCleanup(cls.browser.quit)
        cls.downloads = cls.directory / "downloads"
        cls.browser.execute_cdp_cmd("Browser.setDownloadBehavior", {
            "behavior": "allow", "downloadPath": str(cls.downloads)})

    def open(self, width=1280, height=800, is_dark=False):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 700})
        self.browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {
            "enabled": width < 700})
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark" if is_dark else "light"}]})
        self.browser.get((self.directory / "page.html").as_uri())
        self.browser.execute_script("document.querySelector('canvas')?.focus()")

    def tearDown(self):
        self.assertEqual([line for line in self.browser.get_log("browser")
                          if line["level"] != "INFO"], [])

    def part(self, name):
        return self.browser.find_element(By.CSS_SELECTOR, "[data-id=%s]" % name)

    def press(self, *keys):
        ActionChains(self.browser, duration=0).send_keys(*keys).perform()

    def number(self):
        return int(self.part("number").text)

    def set_number(self, n):
        step = Keys.PAGE_UP if n > self.number() else Keys.PAGE_DOWN
        self.press(*[step] * abs(n - self.number()))
        self.assertEqual(self.number(), n)

    def colors(self):
        """Returns the colors of visible segments, each of which has one without shading."""
        return self.browser.execute_async_script(COUNT_COLORS)

    def show_plain(self):
        self.press("s", "s", "b")
        self.assertEqual(self.part("shading").get_attribute("value"), "none")
        self.assertFalse(self.part("seams").is_selected())

    def click(self, place):
        canvas = self.browser.find_element(By.TAG_NAME, "canvas")
        x, y = place["x"] - canvas.size["width"] // 2, place["y"] - canvas.size["height"] // 2
        ActionChains(self.browser, duration=0).move_to_element_with_offset(canvas, x, y) \
            .click().perform()

    def downloaded(self, name):
        path = self.downloads / name
        for _ in range(400):
            if path.exists() and not list(self.downloads.glob("*.crdownload")):
                return path.read_bytes()
            time.sleep(0.05)
        self.fail("no download " + name)

    def labels(self, n):
        return subprocess.run([TOOL, MESHES / "elephant.off", "--segments", str(n), "--labels", "-",
                               "--quiet"], check=True, stdout=subprocess.PIPE).stdout

    def test_number_of_segments(self):
        self.open()
        self.assertEqual(self.number(), 12)
        self.show_plain()
        self.set_number(1)
        seen = [self.colors()]
        self.assertEqual(len(seen[0]), 1)
        for n in (2, 5, 12, 17):
            self.set_number(n)
            seen.append(self.colors())
            self.assertLessEqual(len(seen[-1]), n)
            self.assertGreaterEqual(len(seen[-1]), len(seen[-2])) # colors stay
            self.assertLessEqual(set(seen[-2]), set(seen[-1]))
        self.assertGreater(len(seen[-1]), 10)

    def test_colors(self):
        """The larger child keeps its color; touching segments differ for the color-blind."""
        self.open()
        colors, cuts, roots, neighbors = self.browser.execute_script(
            "return [viewer.colors, viewer.hierarchy.cutNodes, viewer.hierarchy.roots, "
            "viewer.neighbors().map(set => [...set])]")
        for i, node in enumerate(cuts):
            self.assertEqual(colors[roots + 2 * i + 1], colors[node])
            self.assertNotEqual(colors[roots + 2 * i], colors[node])
        for n in range(2, len(cuts) + 2):
            segments = self.browser.execute_script(
                "return viewer.hierarchy.segmentOfPiece(arguments[0])", n)
            for a, others in zip(segments, neighbors):
                for b in (segments[other] for other in others):
                    if a != b:
                        for kind in VISIONS:
                            self.assertGreater(seen_difference(kind, colors[a], colors[b]), 10)

    def test_strip(self):
        self.open()
        strip = self.part("strip")
        width = strip.size["width"]
        saliences = self.browser.execute_script("return viewer.hierarchy.saliences")
        n = len(saliences)
        for cut in (0, 6, n - 1):
            ActionChains(self.browser, duration=0).move_to_element_with_offset(
                strip, int((cut + 0.5) / n * width - width / 2), 0).click().perform()
            self.assertEqual(self.number(), cut + 2)
        self.assertIn("probability %.2f" % saliences[n - 1], self.part("cutText").text)

    def test_selection(self):
        self.open()
        self.show_plain()
        self.set_number(5)
        colors = self.colors()
        label_of = {}
        for color, place in colors.items():
            self.press(Keys.ESCAPE)
            self.click(place)
            self.assertTrue(self.part("card").is_displayed())
            self.assertEqual(self.part("swatch").value_of_css_property("background-color")
                             .replace("rgba", "rgb").replace(", 1)", ")"),
                             "rgb(%s)" % color.replace(",", ", "))
            label_of[color] = self.part("partName").get_attribute("placeholder")
            count = self.labels(5).split().count(label_of[color].split()[1].encode())
            self.assertIn("%s faces" % format(count, ","), self.part("partText").text)
        self.assertEqual(len(set(label_of.values())), len(colors))
        self.part("hide").click()
        self.assertFalse(self.part("card").is_displayed())
        self.assertNotIn(color, self.colors())
        self.assertEqual(self.part("hiddenText").text, "1 segment is hidden.")
        self.part("showAll").click()
        self.assertEqual(set(self.colors()), set(colors))
        self.click(place)
        self.press("i")
        self.assertEqual(set(self.colors()), {color})
        self.press("a", Keys.ESCAPE)
        self.assertEqual(set(self.colors()), set(colors))
        self.click(place)
        self.press("i")
        self.set_number(3) # of larger segments, all of which are shown
        self.assertFalse(self.part("hiddenNote").is_displayed())

    def shown_labels(self):
        return self.browser.execute_script("return viewer.labelText()").encode()

    def test_edits(self):
        """Merges the two sides of the last cut, cuts them again, undoes, and saves a name."""
        self.open()
        self.set_number(5)
        a, b = self.browser.execute_script("""
            const four = viewer.hierarchy.segmentOfPiece(4), five = viewer.segmentOfPiece;
            const a = four.findIndex((node, i) => five.some((other, j) =>
              four[j] === node && other !== five[i]));
            return [a, five.findIndex((other, j) => four[j] === four[a] && other !== five[a])];""")
        self.browser.execute_script("viewer.take(%d); viewer.take(%d, true)" % (a, b))
        self.assertEqual(self.number(), 4)
        self.assertEqual(self.shown_labels(), self.labels(4))
        self.assertIn("Merged. 4 segments", self.part("said").get_attribute("textContent"))
        self.part("cut").click()
        self.assertEqual(self.number(), 5)
        self.assertEqual(self.shown_labels(), self.labels(5))
        self.part("undo").click()
        self.part("undo").click()
        self.assertFalse(self.part("undo").is_enabled())
        self.part("redo").click()
        self.assertEqual(self.number(), 4)
        self.part("partName").send_keys("rump" + Keys.ENTER)
        self.part("saveglb").click()
        glb = self.downloaded("elephant_4.glb")
        document, data = read_glb(glb)
        self.assertEqual(document["buffers"][0]["byteLength"], len(data))
        names = [node["name"] for node in document["nodes"]]
        self.assertEqual(len(names), 4)
        self.assertIn("rump", names)
        self.assertEqual(len([name for name in names if name.startswith("Segment ")]), 3)
        points, _ = read_off(MESHES / "elephant.off")
        ends = [a for a in document["accessors"] if "min" in a]
        for k in range(3):
            self.assertAlmostEqual(min(a["min"][k] for a in ends), min(p[k] for p in points), 3)
            self.assertAlmostEqual(max(a["max"][k] for a in ends), max(p[k] for p in points), 3)
        self.part("saveLabels").click()
        self.assertEqual(self.downloaded("elephant_4.seg"), self.labels(4))
        (name,) = json.loads(self.downloaded("elephant_4_names.json")).values()
        self.assertEqual(name, "rump")

    def test_keyboard(self):
        self.open()
        canvas = self.browser.find_element(By.TAG_NAME, "canvas")
        self.assertIn("elephant.off", canvas.accessible_name)
        self.assertEqual(canvas.aria_role, "application")
        first = self.camera()
        self.press(Keys.ARROW_LEFT, Keys.ARROW_UP)
        turned = self.camera()
        self.assertGreater(math.dist(first, turned), 0.2)
        self.press("n")
        said = self.part("said").get_attribute("textContent")
        self.assertRegex(said, "^Segment 0, [0-9,]+ faces")
        self.press("m", "n", "m")
        self.assertEqual(self.number(), 11)
        self.press("u")
        self.assertEqual(self.number(), 12)
        self.part("slider").send_keys("u", "y", "x", "m") # letters are commands of the picture only
        self.assertEqual(self.number(), 12)
        self.assertEqual(self.part("explosion").get_attribute("value"), "0")

    def test_downloads(self):
        self.open()
        self.set_number(7)
        self.part("saveLabels").click()
        self.assertEqual(self.downloaded("elephant_7.seg"), self.labels(7))
        self.part("savePicture").click()
        picture = self.downloaded("elephant_7.png")
        self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
        size = self.browser.find_element(By.TAG_NAME, "canvas").size
        self.assertEqual(struct.unpack(">II", picture[16:24]), (size["width"], size["height"]))

    def test_explosion_and_edges(self):
        self.open()
        self.show_plain()
        self.set_number(8)
        before = self.colors()
        self.check_fit()
        self.press("x")
        after = self.colors()
        self.check_fit()
        moved = [c for c in after if c in before and after[c] != before[c]]
        self.assertGreaterEqual(len(moved), len(before) - 1)
        self.press("x")
        self.assertEqual(self.colors(), before)
        self.press("e")
        self.assertNotEqual(self.colors(), before)

    def check_fit(self):
        """The picture leaves a margin of the stage, which is narrow in one direction."""
        left, top, right, bottom, width, height = self.browser.execute_async_script(FIND_EXTENT)
        margins = [min(left, width - 1 - right) / width, min(top, height - 1 - bottom) / height]
        self.assertGreater(min(margins), 0.01)
        self.assertLess(min(margins), 0.06)

    def test_first_view(self):
        """The elephant stands and shows its 12 segments; another stage is filled as well."""
        self.open()
        self.assertFalse(self.part("up").is_selected())
        self.show_plain()
        self.assertEqual(len(self.colors()), 12)
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": 900, "height": 500, "deviceScaleFactor": 1, "mobile": False})
        self.check_fit()

    def camera(self):
        return self.browser.execute_script("return viewer.scene.camera.position.toArray()")

    def test_turning_and_zooming(self):
        self.open()
        first = self.camera()
        canvas = self.browser.find_element(By.TAG_NAME, "canvas")
        ActionChains(self.browser, duration=0).drag_and_drop_by_offset(canvas, 100, 30).perform()
        turned = self.camera()
        self.assertNotEqual(turned, first)
        self.assertFalse(self.part("card").is_displayed()) # it was no click
        target = self.browser.execute_script("return viewer.scene.controls.target.toArray()")
        radius = lambda p: math.dist(p, target)
        self.assertAlmostEqual(radius(turned), radius(first))
        self.browser.execute_script(
            "arguments[0].dispatchEvent(new WheelEvent('wheel', {deltaY: -100}))", canvas)
        self.assertLess(radius(self.camera()), radius(first))
        self.press("r")
        for x, y in zip(self.camera(), first):
            self.assertAlmostEqual(x, y)

    def touch(self, *places):
        for kind, points in zip(["touchStart"] + ["touchMove"] * (len(places) - 1) + ["touchEnd"],
                                [[{"x": x, "y": y}] for x, y in places] + [[]]):
            self.browser.execute_cdp_cmd("Input.dispatchTouchEvent",
                                         {"type": kind, "touchPoints": points})

    def test_narrow(self):
        self.open(390, 844)
        root = "document.documentElement."
        self.assertEqual(self.browser.execute_script("return [%sscrollWidth, %sclientWidth]"
                                                     % (root, root)), [390, 390])
        first = self.camera()
        self.touch((150, 200), (180, 210), (220, 230))
        self.assertNotEqual(self.camera(), first)
        self.press("r")
        self.show_plain()
        place = next(iter(self.colors().values()))
        self.touch((place["x"], place["y"]))
        self.assertTrue(self.part("card").is_displayed())
        for name in ("slider", "strip", "explosion", "saveLabels", "isolate", "deselect"):
            rectangle = self.part(name).rect
            self.assertGreaterEqual(rectangle["x"], 0)
            self.assertLessEqual(rectangle["x"] + rectangle["width"], 390)

    def luminance(self, name):
        color = self.browser.find_element(By.CSS_SELECTOR, name).value_of_css_property(
            "background-color")
        return sum(float(x) for x in color.strip("rgba()").split(",")[:3]) / 3

    def test_dark(self):
        self.open()
        self.assertGreater(self.luminance(".stage"), 200)
        self.open(is_dark=True)
        self.assertLess(self.luminance(".stage"), 60)

    def test_browser_without_webgl(self):
        script = self.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {
            "source": "HTMLCanvasElement.prototype.getContext = () => null"})
        self.open()
        self.assertIn("needs WebGL", self.part("stage").text)
        self.browser.get_log("browser") # which has what three.js says
        self.browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", script)


if __name__ == "__main__":
    TOOL, MESHES, CHROMIUM, DRIVER = (os.path.realpath(path) for path in sys.argv[1:5])
    MESHES = pathlib.Path(MESHES)
    del sys.argv[1:5]
    unittest.main()
