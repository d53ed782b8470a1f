#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many meshes to one table, by Dask, on the cores of one machine or of many.

    many_meshes_by_dask.py scans/ -o out
    many_meshes_by_dask.py scans/ -o out --scheduler tcp://head:8786

The results equal the results of many_meshes.py, also when workers are killed, and the program goes
on in the same way when it is started again. On many machines the folders must be the same on all of
them, such as by NFS, and the package must be installed there. Start `dask scheduler` on one of
them, and on each `dask worker tcp://head:8786 --nworkers auto --nthreads 1`.

Needs dask.distributed, Debian's package python3-distributed.
"""

import pathlib

import mesh_rows
from distributed import Client, KilledWorker, as_completed


def start_client(scheduler, jobs):
    if scheduler:
        return Client(scheduler)
    return Client(n_workers=jobs, threads_per_worker=1, dashboard_address=None)


def rows_of(files, arguments):
    """Yields rows as they are ready. A mesh is tried again after a worker has died at it."""
    if not files:
        return
    with start_client(arguments.scheduler, arguments.jobs) as client:
        client.upload_file(mesh_rows.__file__) # also to workers that come later
        file_of = {client.submit(mesh_rows.segment_file, file, pathlib.Path(arguments.output),
                                 arguments.segments): file for file in files}
        for future in as_completed(list(file_of)):
            try:
                yield future.result()
            except KilledWorker: # several have died at it
                yield mesh_rows.failed_row(file_of[future], "crash",
                                           "the workers ended without a result")


def main():
    arguments = mesh_rows.parse_arguments(
        __doc__.splitlines()[0],
        ("--scheduler", {"metavar": "ADDRESS", "help": "a cluster, in place of this machine"}),
        ("--jobs", {"type": int, "metavar": "N",
                    "help": "meshes at a time, without --scheduler [all cores]"}))
    table = mesh_rows.Table(arguments.output)
    files = table.missing(mesh_rows.files_of(arguments.inputs))
    table.add_all(rows_of(files, arguments), len(files))


if __name__ == "__main__":
    main()
