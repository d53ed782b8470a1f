# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests in Blender's window that Esc cancels a run, and that a run without Esc ends by itself:

    xvfb-run blender -noaudio --factory-startup --enable-event-simulate -P escape_in_blender.py

The package spectral_segmentation is found by PYTHONPATH."""

import os
import pathlib
import sys
import threading
import time
import traceback

import bpy
import spectral_segmentation

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import segment_parts # after the path is known

search = spectral_segmentation.segment_hierarchy


def slow_search(*arguments, progress, **parameters):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        time.sleep(0.05)
        progress(0)
    return search(*arguments, progress=progress, **parameters)


def is_running():
    return threading.active_count() > 1


def start(window):
    area = next(area for area in window.screen.areas if area.type == 'VIEW_3D')
    region = next(region for region in area.regions if region.type == 'WINDOW')
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.mesh.primitive_monkey_add()
        made = bpy.context.object
        result = bpy.ops.object.segment_into_parts('INVOKE_DEFAULT', True)
    assert result == {'RUNNING_MODAL'}, result
    return made


def simulate(window, value):
    window.event_simulate(type='ESC', value=value, x=window.width // 2, y=window.height // 2)


def steps():
    """Yields whenever Blender shall go on."""
    global seconds
    seconds = 30
    window = bpy.context.window_manager.windows[0]
    suzanne = start(window)
    simulate(window, 'PRESS')
    while is_running():
        yield
    assert time.monotonic() < limit - 35, "the run was not cancelled"
    for _ in range(10):
        yield # A run that was not cancelled would write its result now.
    assert len(suzanne.data.materials) == 0
    seconds = 2
    suzanne = start(window)
    simulate(window, 'RELEASE') # does not cancel the next run
    while is_running() or len(suzanne.data.materials) == 0:
        yield
    assert len(bpy.context.window_manager.operators) > 0 # for the panel of the last operator


running = steps()


def go_on():
    """Is called by Blender again after the time that it returns."""
    try:
        next(running)
        assert time.monotonic() < limit, "it takes too long"
        return 0.1
    except StopIteration:
        print("Esc cancels.", flush=True)
        os._exit(0)
    except BaseException:
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)


spectral_segmentation.segment_hierarchy = slow_search
segment_parts.register()
limit = time.monotonic() + 60
bpy.app.timers.register(go_on, first_interval=1)
