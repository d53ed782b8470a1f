# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress, cancelling, threads and memory of runs."""

import concurrent.futures
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

from conftest import bumpy_dumbbell_of
from spectral_segmentation import segment, segment_hierarchy

PAPER = {"method": "paper", "salience_threshold": 0}


class OwnError(Exception):
    pass


def test_progress_goes_from_0_to_1_in_the_thread_of_the_caller(dumbbell):
    told = []
    segment(*dumbbell, progress=lambda share: told.append((share, threading.get_ident())))
    shares, threads = zip(*told)
    assert set(threads) == {threading.get_ident()}
    assert 0 < shares[0] and shares[-1] == 1
    assert all(a < b for a, b in zip(shares, shares[1:]))


def test_progress_cancels(dumbbell):
    told = []

    def progress(share):
        told.append(share)
        return False

    whole = segment_hierarchy(*dumbbell)
    part = segment_hierarchy(*dumbbell, progress=progress)
    assert len(told) == 1
    assert part.number_of_nodes <= whole.number_of_nodes
    assert len(part.labels()) == len(dumbbell[1])


@pytest.mark.parametrize("answer", [None, True, 0, "no"])
def test_only_false_cancels(bumpy_dumbbell, answer):
    expected = segment(*bumpy_dumbbell, **PAPER)
    np.testing.assert_array_equal(
        segment(*bumpy_dumbbell, **PAPER, progress=lambda share: answer), expected)


def test_errors_of_callables_are_those_of_the_run(dumbbell):
    error = OwnError("own")

    def fail(_):
        raise error

    for parameters in ({"progress": fail}, {"part_salience": fail, **PAPER}):
        with pytest.raises(OwnError) as caught:
            segment(*dumbbell, **parameters)
        assert caught.value is error
    with pytest.raises(TypeError, match="part_salience must return a number"):
        segment(*dumbbell, part_salience=lambda factors: "much", salience_threshold=0)
    with pytest.raises(TypeError):
        segment(*dumbbell, part_salience=lambda: 1, salience_threshold=0)
    with pytest.raises(TypeError):
        segment(*dumbbell, progress=lambda: True)


def test_control_c_ends_a_run():
    program = """
import signal
import numpy as np
from spectral_segmentation import segment
n = 1000
grid = np.stack(np.meshgrid(np.arange(n), np.arange(n)), -1).reshape(-1, 2)
points = np.column_stack([grid, 20 * np.sin(grid[:, 0] / 50)])
a = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
triangles = np.concatenate([np.stack([a, a + 1, a + n], 1), np.stack([a + 1, a + n + 1, a + n], 1)])
signal.signal(signal.SIGINT, signal.default_int_handler) # shells have it ignored in the background
print("started", flush=True)
try:
    segment(points, triangles, threads=1)
    print("finished")
except KeyboardInterrupt:
    print("interrupted", segment(np.eye(3), [[0, 1, 2]]))
"""
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE,
                          text=True) as process:
        assert process.stdout.readline() == "started\n"
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        assert process.communicate(timeout=60)[0] == "interrupted [0]\n"


def test_other_threads_of_python_go_on(dumbbell):
    times, is_done = [], threading.Event()

    def tick():
        while not is_done.is_set():
            times.append(time.perf_counter())
            time.sleep(0.001)

    other = threading.Thread(target=tick)
    other.start()
    start = time.perf_counter()
    segment(*dumbbell, threads=1)
    end = time.perf_counter()
    is_done.set()
    other.join()
    assert sum(start < t < end for t in times) > 10


def test_runs_in_several_threads():
    """Also with callables, for which each waits for the lock of Python."""
    meshes = [bumpy_dumbbell_of(seed) for seed in range(6)]
    parameters = [{"number_of_segments": 3, "number_of_coarse_faces": 0}, PAPER,
                  {**PAPER, "part_salience": lambda factors: factors.cut_strength,
                   "progress": lambda share: None}]
    runs = [(mesh, p) for mesh in meshes for p in parameters]

    def labels_of(run):
        return segment(*run[0], **run[1])

    alone = list(map(labels_of, runs))
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        together = list(pool.map(labels_of, 2 * runs))
    for a, b in zip(2 * alone, together):
        np.testing.assert_array_equal(a, b)


def test_the_number_of_threads_makes_no_difference(dumbbell):
    expected = segment(*dumbbell, threads=1)
    for number in (2, 3, None, 10**9):
        np.testing.assert_array_equal(segment(*dumbbell, threads=number), expected)


def labels_in_child(seed):
    return segment(*bumpy_dumbbell_of(seed))


def test_runs_in_processes_that_are_forked():
    """After a run with threads, which a child does not have."""
    expected = [labels_in_child(seed) for seed in range(2)]
    program = """
import concurrent.futures, multiprocessing, sys
sys.path.insert(0, sys.argv[1])
from test_runs import labels_in_child
if __name__ == "__main__":
    labels_in_child(0)
    with concurrent.futures.ProcessPoolExecutor(
            2, multiprocessing.get_context("fork")) as pool:
        for labels in pool.map(labels_in_child, range(2)):
            print(labels.tolist())
"""
    done = subprocess.run([sys.executable, "-c", program, str(__file__).rpartition("/")[0]],
                          stdout=subprocess.PIPE, text=True, check=True, timeout=120)
    assert done.stdout == "".join("%s\n" % labels.tolist() for labels in expected)


def test_a_thousand_runs_leave_no_memory():
    program = """
import pickle, resource, sys
sys.path.insert(0, sys.argv[1])
from conftest import dumbbell_of
from spectral_segmentation import segment, segment_hierarchy, segment_colors, boundary_edges
points, triangles = dumbbell_of(9, 6)
def fail(_):
    raise ValueError
def run():
    hierarchy = segment_hierarchy(points, triangles, method="paper", salience_threshold=0,
                                  threads=1,
                                  part_salience=lambda factors: factors.size,
                                  progress=lambda share: None)
    labels = pickle.loads(pickle.dumps(hierarchy)).labels()
    hierarchy.nodes, segment_colors(triangles, labels)
    for wrong in ({"progress": fail}, {"part_salience": fail},
                  {"salience_threshold": float("nan")}):
        try:
            segment(points, triangles, method="paper", threads=1, **wrong)
        except ValueError:
            pass
def memory():
    return int(open("/proc/self/statm").read().split()[1]) * resource.getpagesize()
for _ in range(100):
    run()
before = memory()
for _ in range(1000):
    run()
print(memory() - before)
"""
    if not sys.platform.startswith("linux"):
        pytest.skip("/proc is of Linux")
    done = subprocess.run([sys.executable, "-c", program, str(__file__).rpartition("/")[0]],
                          stdout=subprocess.PIPE, text=True, check=True)
    assert int(done.stdout) < 400_000 # the labels of the runs alone would take more
