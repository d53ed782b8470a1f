#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many meshes to one table, on all cores of a machine.

    many_meshes.py scans/ -o out
    many_meshes.py @list.txt more.stl -o out --jobs 4

Writes a row for each mesh to out/table.csv: file, status, numbers of triangles and segments, areas
of segments, seconds, and the file of labels in out/labels, a line for each triangle of `read()`. A
mesh that is missing or damaged has another status than "ok" and an error; so has one at which a
process crashes, and the others go on.

A run that was ended on the way goes on when it is started again. Files that have a row are skipped.
With other options, take another folder. contact_sheet.py draws all meshes of a table, and
many_meshes_by_dask.py does the same on many machines. Needs nothing but the package.
"""

import collections
import multiprocessing
import os
import pathlib
import threading
from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool

from mesh_rows import Table, failed_row, files_of, parse_arguments, segment_file


def end_with_parent():
    """Processes would wait forever for one that was killed."""
    def wait_for_parent():
        multiprocessing.parent_process().join()
        os._exit(1)
    threading.Thread(target=wait_for_parent, daemon=True).start()


def start_processes(number):
    return ProcessPoolExecutor(number, multiprocessing.get_context("spawn"), end_with_parent)


def rows_of(files, arguments):
    """Yields rows as they are ready."""
    others = [pathlib.Path(arguments.output), arguments.segments]
    waiting = collections.deque(files)
    suspects = []
    while waiting:
        running = {}
        try:
            with start_processes(min(arguments.jobs, len(waiting))) as processes:
                while waiting or running:
                    while waiting and len(running) < 2 * arguments.jobs:
                        future = processes.submit(segment_file, waiting[0], *others)
                        running[future] = waiting.popleft()
                    for future in wait(running, return_when=FIRST_COMPLETED).done:
                        yield future.result()
                        del running[future]
        except BrokenProcessPool: # one has crashed, or was killed, and nobody knows at which mesh
            suspects += running.values()
    for file in suspects: # each in a process of its own
        try:
            with start_processes(1) as process:
                yield process.submit(segment_file, file, *others).result()
        except BrokenProcessPool:
            yield failed_row(file, "crash", "the process ended without a result")


def main():
    arguments = parse_arguments(__doc__.splitlines()[0], ("--jobs", {
        "type": int, "default": os.cpu_count(), "metavar": "N",
        "help": "meshes that are segmented at a time [all cores]"}))
    table = Table(arguments.output)
    files = table.missing(files_of(arguments.inputs))
    table.add_all(rows_of(files, arguments), len(files))


if __name__ == "__main__":
    main()
