#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the web page in Chromium: page.py TRY TOOL MESHES CHROMIUM CHROMEDRIVER, with the folder of
the page, the native tool and the folder of libcgal-demo's meshes. SCREENSHOTS names a folder for
pictures."""

import functools
import http.server
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "test"))
import page_in_browser  # how to start a browser and count colors

# Drops a file as a person does.
DROP = """
const [name, text] = arguments;
const transfer = new DataTransfer();
transfer.items.add(new File([text], name));
document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true }));
"""


class Quiet_handler(http.server.SimpleHTTPRequestHandler):

    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map,
                      ".js": "text/javascript", ".wasm": "application/wasm"}

    def log_message(self, *_):
        pass


class Page_test(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        server = http.server.ThreadingHTTPServer(
            ("localhost", 0), functools.partial(Quiet_handler, directory=TRY))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        cls.addClassCleanup(server.shutdown)
        cls.url = "http://localhost:%d/" % server.server_port
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.downloads = pathlib.Path(directory.name, "downloads")
        cls.browser = page_in_browser.start_browser(directory.name)
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.execute_cdp_cmd("Browser.setDownloadBehavior", {
            "behavior": "allow", "downloadPath": str(cls.downloads)})

    open_url = page_in_browser.Page_in_browser_test.open
    part = page_in_browser.Page_in_browser_test.part
    press = page_in_browser.Page_in_browser_test.press
    number = page_in_browser.Page_in_browser_test.number
    colors = page_in_browser.Page_in_browser_test.colors
    show_plain = page_in_browser.Page_in_browser_test.show_plain
    downloaded = page_in_browser.Page_in_browser_test.downloaded
    tearDown = page_in_browser.Page_in_browser_test.tearDown

    def open(self, width=1280, height=800, is_dark=False):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 700})
        self.browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": width < 700})
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark" if is_dark else "light"}]})
        self.browser.get(self.url)
        self.wait(lambda: self.browser.find_elements(By.CSS_SELECTOR, "[data-ready]"))

    def wait(self, condition, seconds=60):
        WebDriverWait(self.browser, seconds, poll_frequency=0.02).until(lambda _: condition())

    def id(self, name):
        return self.browser.find_element(By.ID, name)

    def shown_name(self):
        return self.browser.execute_script("return globalThis.viewer?.model?.name")

    def choose(self, path):
        self.id("file").send_keys(str(path))
        self.wait(lambda: self.shown_name() == path.name or self.id("error").is_displayed())
        self.assertFalse(self.id("error").is_displayed(), self.id("error").text)

    def labels_of_tool(self, path, *options):
        return subprocess.run([TOOL, path, "--labels", "-", "--quiet", *options], check=True,
                              stdout=subprocess.PIPE).stdout

    def labels_of_page(self):
        return self.browser.execute_script("return globalThis.viewer?.labelText?.() ?? ''").encode()

    def screenshot(self, name):
        if "SCREENSHOTS" in os.environ:
            self.browser.save_screenshot(os.path.join(os.environ["SCREENSHOTS"], name + ".png"))

    def test_dropped_mesh(self):
        path = MESHES / "elephant.off"
        self.open()
        self.screenshot("empty")
        self.browser.execute_script(DROP, path.name, path.read_text())
        self.wait(lambda: self.shown_name() == path.name)
        self.screenshot("elephant")
        labels = self.labels_of_tool(path)
        self.assertEqual(self.labels_of_page(), labels)
        self.show_plain()
        number = len(set(labels.split()))
        self.assertGreaterEqual(len(self.colors()), 10)
        self.assertLessEqual(len(self.colors()), number)
        slider = self.part("slider")
        slider.send_keys(*[Keys.ARROW_LEFT] * (number - 5))
        self.assertEqual(self.number(), 5)
        self.part("saveLabels").click()
        self.assertEqual(self.downloaded("elephant_5.seg"),
                         self.labels_of_tool(path, "--segments", "5"))
        for button, extension, start in (("savePly", "ply", b"ply\n"), ("saveGlb", "glb", b"glTF")):
            self.id(button).click()
            contents = self.downloaded("elephant_5." + extension)
            self.assertEqual(contents[:4], start)
        self.assertEqual(contents.count(b"segment_"), contents.count(b"segment_"))

    def test_damaged_files_leave_the_mesh(self):
        self.open()
        self.choose(MESHES / "cube.off")
        for name, text, sentence in (
                ("a.off", "OFF 3 x", "a.off cannot be cut: line 1: 'x' is not a number of faces"),
                ("a.txt", "Dear Sir", "a.txt cannot be cut: the format is unknown"),
                ("a.glb", "Dear Sir", "a.glb cannot be cut: "),
                ("a.stl", "", "a.stl cannot be cut: ")):
            self.browser.execute_script(DROP, name, text)
            self.wait(lambda: self.id("error").is_displayed() and name in self.id("error").text)
            self.assertIn(sentence, self.id("error").text)
            self.assertEqual(self.id("error").get_attribute("role"), "alert")
            self.assertEqual(self.shown_name(), "cube.off")
        self.screenshot("error")
        self.choose(MESHES / "hand.off")
        self.assertFalse(self.id("error").is_displayed())

    def test_cancel(self):
        self.open()
        self.id("file").send_keys(str(MESHES / "refined_elephant.off"
                                      if (MESHES / "refined_elephant.off").exists()
                                      else MESHES / "man.off"))
        self.wait(lambda: self.id("cancel").is_displayed())
        self.id("cancel").click()
        self.wait(lambda: not self.id("progress").is_displayed())
        self.assertFalse(self.id("error").is_displayed())
        self.choose(MESHES / "cube.off")

    def test_samples_and_methods(self):
        self.open()
        Select(self.id("sample")).select_by_visible_text("hand")
        self.wait(lambda: self.shown_name() == "hand.off")
        self.assertEqual(self.labels_of_page(), self.labels_of_tool(MESHES / "hand.off"))
        Select(self.id("method")).select_by_value("paper")
        of_paper = self.labels_of_tool(MESHES / "hand.off", "--method", "paper")
        self.wait(lambda: self.labels_of_page() == of_paper)

    def test_meshes_that_are_not_made_for_it(self):
        self.open()
        for name in ("bones.off", "camel.off", "blobby_3cc.off", "bear.off", "homer.off",
                     "fandisk.off", "head.off", "pinion.off", "bunny00.off", "knot1.off"):
            with self.subTest(name=name):
                self.choose(MESHES / name)
                self.assertEqual(self.labels_of_page(), self.labels_of_tool(MESHES / name))

    def test_glb(self):
        path = self.downloads.parent / "parts.glb"
        subprocess.run([TOOL, MESHES / "hand.off", "-o", path, "--quiet"], check=True)
        self.open()
        self.choose(path)
        faces = len(self.labels_of_tool(MESHES / "hand.off").split())
        self.assertEqual(len(self.labels_of_page().split()), faces)

    def test_widths_and_schemes(self):
        for width in (1280, 390):
            for is_dark in (False, True):
                with self.subTest(width=width, is_dark=is_dark):
                    self.open(width, 800, is_dark)
                    name = "%d_%s" % (width, "dark" if is_dark else "light")
                    self.screenshot(name + "_empty")
                    self.choose(MESHES / "elephant.off")
                    time.sleep(0.3)
                    self.screenshot(name)
                    self.assertLessEqual(self.browser.execute_script(
                        "return document.documentElement.scrollWidth"), width)
                    for element in ("file", "sample", "method", "savePly", "saveGlb"):
                        rectangle = self.id(element).rect
                        self.assertGreaterEqual(rectangle["x"], 0)
                        self.assertLessEqual(rectangle["x"] + rectangle["width"], width)

    def test_time_from_file_to_colors(self):
        """Only told: benchmarks measure, tests do not."""
        if "LARGE" not in os.environ:
            self.skipTest("LARGE names files to be timed")
        self.open()
        for path in map(pathlib.Path, os.environ["LARGE"].split(":")):
            for _ in range(3):
                self.browser.execute_script("globalThis.viewer = {}")
                start = time.perf_counter()
                self.choose(path)
                self.browser.execute_async_script("requestAnimationFrame(arguments[0])")
                print("%s: %.2f s" % (path.name, time.perf_counter() - start))


if __name__ == "__main__":
    TRY, TOOL, MESHES, CHROMIUM, DRIVER = (os.path.realpath(path) for path in sys.argv[1:6])
    MESHES = pathlib.Path(MESHES)
    page_in_browser.CHROMIUM, page_in_browser.DRIVER = CHROMIUM, DRIVER
    del sys.argv[1:6]
    unittest.main()
