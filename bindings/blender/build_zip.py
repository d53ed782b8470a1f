#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a zip of the add-on that Blender installs, with the wheels of the Python package inside.

Without wheels it makes one by pip, with the Python that runs this script: its minor version must be
the one of Blender's Python. That wheel is without TBB, so that it needs no library of the system."""

import argparse
import ast
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
NAME = "segment_parts" # of the folder in the zip, and of the module in Blender
SYSTEMS = {"linux": "linux", "manylinux": "linux", "macosx": "macos", "win": "windows"}


def build_wheel(folder):
    # A build folder of its own: one of an earlier build would give a module with TBB.
    settings = pathlib.Path(folder, "setup.cfg")
    settings.write_text("[build]\nbuild_base = %s\n" % pathlib.Path(folder, "build"))
    environment = dict(os.environ, SPECTRAL_SEGMENTATION_TBB="0",
                       DIST_EXTRA_CONFIG=str(settings))
    subprocess.run([sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps",
                    "--wheel-dir", folder, HERE.parent / "python"], env=environment, check=True)
    return list(pathlib.Path(folder).glob("*.whl"))


def version_of(source):
    return ".".join(map(str, ast.literal_eval(
        re.search(r'"version": (\(.*?\))', source).group(1))))


def platform_of(wheel):
    """Returns the platform of a wheel by Blender's name for it, such as linux-x64."""
    tag = wheel.stem.split("-")[-1]
    match = re.match(r"([a-z]+).*?(x86_64|amd64|arm64|aarch64)$", tag)
    if not match or match[1] not in SYSTEMS:
        sys.exit("%s: Blender has no platform %s" % (wheel, tag))
    processor = "x64" if match[2] in ("x86_64", "amd64") else "arm64"
    return "%s-%s" % (SYSTEMS[match[1]], processor)


def write_zip(path, wheels):
    source = (HERE / "segment_parts.py").read_text()
    manifest = (HERE / "blender_manifest.toml").read_text()
    manifest += 'version = "%s"\n' % version_of(source)
    for key, values in (("platforms", {platform_of(wheel) for wheel in wheels}),
                        ("wheels", {"./wheels/" + wheel.name for wheel in wheels})):
        manifest += "%s = [%s]\n" % (key, ", ".join('"%s"' % value for value in sorted(values)))
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        file.writestr(NAME + "/__init__.py", source)
        file.writestr(NAME + "/blender_manifest.toml", manifest)
        file.write(HERE.parent.parent / "LICENSE", NAME + "/LICENSE")
        for wheel in wheels:
            file.write(wheel, "%s/wheels/%s" % (NAME, wheel.name))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("zip", type=pathlib.Path, help="the file to write")
    parser.add_argument("wheel", type=pathlib.Path, nargs="*",
                        help="one for each Python version and platform")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        write_zip(arguments.zip, arguments.wheel or build_wheel(folder))


if __name__ == "__main__":
    main()
