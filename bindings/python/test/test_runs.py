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
    reported = []
    segment(*dumbbell, progress=lambda fraction: reported.append((fraction, threading.get_ident())))
    fractions, threads = zip(*reported)
    assert set(threads) == {threading.get_ident()}
    assert 0 < fractions[0] and fractions[-1] == 1
    assert all(a < b for a, b in zip(fractions, fractions[1:]))


def test_progress_cancels(dumbbell):
    reported = []

    def progress(fraction):
        reported.append(fraction)
        return False

    whole = segment_hierarchy(*dumbbell)
    part = segment_hierarchy(*dumbbell, progress=progress)
    assert len(reported) == 1
    assert part.number_of_nodes <= whole.number_of_nodes
    assert len(part.labels()) == len(dumbbell[1])


@pytest.mark.parametrize("answer, cancels", [
    (None, False), (True, False), (np.True_, False), ("no", False), (np.float64(0.5) < 1, False),
    (False, True), (np.False_, True), (0, True), (np.float64(0.5) < 0, True)])
def test_answers_that_count_as_false_cancel(dumbbell, answer, cancels):
    fractions = []

    def progress(fraction):
        fractions.append(fraction)
        return answer

    segment(*dumbbell, progress=progress)
    assert (len(fractions) == 1) == cancels
    with pytest.raises(ValueError, match="truth value"):
        segment(*dumbbell, progress=lambda fraction: np.array([True, False]))


def test_errors_of_callables_end_the_run(dumbbell):
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


# The begin of programs: a sheet of n x n points with waves, as `points` and `triangles`.
SHEET = """
import numpy as np
n = %d
grid = np.stack(np.meshgrid(np.arange(n), np.arange(n)), -1).reshape(-1, 2)
points = np.column_stack([grid, 20 * np.sin(grid[:, 0] / 50)])
a = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
triangles = np.concatenate([np.stack([a, a + 1, a + n], 1), np.stack([a + 1, a + n + 1, a + n], 1)])
"""


def test_control_c_ends_a_run():
    program = SHEET % 1000 + """
import signal
from spectral_segmentation import segment
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


def test_a_signal_ends_a_run_on_triangles_that_are_not_connected():
    """The search takes a small part of that run; the contacts of the triangles take the rest."""
    random = np.random.default_rng(1)
    points, triangles = random.random((10000, 3)), random.integers(0, 10000, (30000, 3))
    delays = []
    start = time.perf_counter()
    segment(points, triangles, threads=1)
    whole_run = time.perf_counter() - start

    def stop(signal_number, frame):
        delays.append(time.perf_counter())
        raise OwnError

    before = signal.signal(signal.SIGALRM, stop)
    try:
        for fraction in (0.2, 0.4):
            signal.setitimer(signal.ITIMER_REAL, fraction * whole_run)
            with pytest.raises(OwnError):
                segment(points, triangles, threads=1)
            delays.append(time.perf_counter() - delays.pop())
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert min(delays) < whole_run / 2 # the machine may be busy


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
    """Runs also with callables, for which each waits for the lock of Python."""
    meshes = [bumpy_dumbbell_of(seed) for seed in range(6)]
    parameters = [{"number_of_segments": 3, "number_of_coarse_faces": 0}, PAPER,
                  {**PAPER, "part_salience": lambda factors: factors.cut_strength,
                   "progress": lambda fraction: None}]
    runs = [(mesh, p) for mesh in meshes for p in parameters]

    def labels_of(run):
        return segment(*run[0], **run[1])

    alone = list(map(labels_of, runs))
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        together = list(pool.map(labels_of, 2 * runs))
    for a, b in zip(2 * alone, together):
        np.testing.assert_array_equal(a, b)


def test_runs_in_several_threads_count_references_to_types():
    """Python's counts are not for several threads; 0 would free a type that NumPy needs."""
    program = """
import sys, threading
import numpy as np
from spectral_segmentation import segment
points = np.eye(3)
triangles = [np.array([[0, 1, 2]], type) for type in ("i4", "i8", "u4", "u8")]
types = [np.dtype(type) for type in ("f4", "f8", "i4", "i8", "u4", "u8")]
def run():
    for i in range(2000):
        segment(points, triangles[i % 4], threads=1, number_of_coarse_faces=0)
def counts():
    return [sys.getrefcount(type) for type in types]
run()
before = counts()
threads = [threading.Thread(target=run) for _ in range(3)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
assert counts() == before
"""
    subprocess.run([sys.executable, "-c", program], check=True, timeout=120)


# Daemon threads work while the process ends: `busy` has a long run, `sleep` a callable that does
# not return, and the others have a loop of short calls.
END_OF_PROCESS = SHEET % 500 + """
import sys, threading, time
from spectral_segmentation import read, segment
small = np.eye(3), [[0, 1, 2]]
is_started = threading.Event()
def report(fraction):
    is_started.set()
def report_size(factors):
    is_started.set()
    return factors.size
def sleep(_):
    is_started.set()
    time.sleep(100)
def loop(f):
    while True:
        f()
        is_started.set()
def read_file():
    try:
        read(sys.argv[2])
    except ValueError:
        pass
actions = {
    "busy": lambda: segment(points, triangles, progress=report),
    "busy_salience": lambda: segment(points, triangles, part_salience=report_size),
    "sleep": lambda: segment(points, triangles, progress=sleep),
    "sleep_salience": lambda: segment(points, triangles, part_salience=sleep),
    "short": lambda: loop(lambda: segment(*small, number_of_coarse_faces=0, progress=report)),
    "read": lambda: loop(read_file)}
for _ in range(2):
    threading.Thread(target=actions[sys.argv[1]], daemon=True).start()
is_started.wait()
time.sleep(0.05)
print("ended")
"""


@pytest.mark.parametrize("action", ["busy", "busy_salience", "sleep", "sleep_salience", "short",
                                    "read"])
def test_the_process_ends_while_daemon_threads_run(action):
    done = subprocess.run([sys.executable, "-c", END_OF_PROCESS, action, __file__],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (0, "ended\n", "")


def test_handlers_at_exit_can_run():
    program = """
import atexit
import numpy as np
atexit.register(lambda: print(segment(np.eye(3), [[0, 1, 2]])))
from spectral_segmentation import segment # whose handler is called first
"""
    done = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True,
                          check=True, timeout=60)
    assert done.stdout == "[0]\n"


def test_the_number_of_threads_makes_no_difference(dumbbell):
    expected = segment(*dumbbell, threads=1)
    for number in (2, 3, None, 10**9):
        np.testing.assert_array_equal(segment(*dumbbell, threads=number), expected)


def labels_in_child(seed):
    return segment(*bumpy_dumbbell_of(seed))


def test_runs_in_processes_that_are_forked():
    """Forks after a run with threads, which a child does not have."""
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


def test_a_thousand_runs_with_threads_need_no_thread_and_no_memory_each():
    """TBB keeps 8 KB for each thread that ever called it."""
    program = """
import resource
import numpy as np
from spectral_segmentation import segment
def run(number):
    for _ in range(number):
        segment(np.eye(3), [[0, 1, 2]], number_of_coarse_faces=0)
def memory():
    return int(open("/proc/self/statm").read().split()[1]) * resource.getpagesize()
run(100)
before = memory()
run(1000)
print(memory() - before)
"""
    if not sys.platform.startswith("linux"):
        pytest.skip("only Linux has /proc")
    done = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True,
                          check=True, timeout=60)
    assert int(done.stdout) < 1_000_000


def test_many_runs_leave_no_memory():
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
                                  progress=lambda fraction: None)
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
for _ in range(400):
    run()
print(memory() - before)
"""
    if not sys.platform.startswith("linux"):
        pytest.skip("only Linux has /proc")
    done = subprocess.run([sys.executable, "-c", program, str(__file__).rpartition("/")[0]],
                          stdout=subprocess.PIPE, text=True, check=True)
    assert int(done.stdout) < 200_000 # the labels of the runs alone would take more
