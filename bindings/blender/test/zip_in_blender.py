# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs the zip of the add-on, in a Blender that has neither the add-on nor the package:

    BLENDER_USER_CONFIG=EMPTY BLENDER_USER_SCRIPTS=EMPTY \\
      blender -b -noaudio --factory-startup --python-exit-code 1 -P zip_in_blender.py -- ZIP"""

import importlib.util
import sys
import tomllib
import zipfile

import bpy

ZIP, = sys.argv[sys.argv.index("--") + 1:]

assert importlib.util.find_spec("spectral_segmentation") is None
with zipfile.ZipFile(ZIP) as file:
    names = file.namelist()
    manifest = tomllib.loads(file.read("segment_parts/blender_manifest.toml").decode())
assert all("segment_parts/" + wheel[2:] in names for wheel in manifest["wheels"])

if bpy.app.version < (4, 2):
    bpy.ops.preferences.addon_install(filepath=ZIP)
    module = "segment_parts"
    bpy.ops.preferences.addon_enable(module=module)
else:
    bpy.ops.extensions.package_install_files(filepath=ZIP, repo="user_default",
                                             enable_on_install=True)
    module = "bl_ext.user_default.segment_parts"
version = ".".join(map(str, sys.modules[module].bl_info["version"]))
assert manifest["version"] == version, (manifest["version"], version)

bpy.ops.mesh.primitive_monkey_add()
suzanne = bpy.context.object
bpy.ops.object.segment_into_parts(choice='NUMBER', number=5, results={'MATERIALS', 'ATTRIBUTE'})
labels = {value.value for value in suzanne.data.attributes["segment"].data}
assert labels == set(range(5)), labels
assert len(suzanne.data.materials) == 5
import spectral_segmentation
assert spectral_segmentation.__version__ == version
assert spectral_segmentation.__file__.startswith(bpy.utils.user_resource('SCRIPTS')) or \
    bpy.app.version >= (4, 2)
bpy.ops.preferences.addon_disable(module=module)
assert not hasattr(bpy.types, "OBJECT_OT_segment_into_parts")
print("The zip is installed and works.")
