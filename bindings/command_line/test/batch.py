#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many meshes through the command line tool: batch.py TOOL [--count N].

N small meshes, some of them damaged, are segmented in one batch, which is killed on the way and
started again. Its table and labels must equal the results of single runs. Another batch runs
after many meshes.
"""

import argparse
import collections
import json
import math
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time


def blob(random_numbers):
    """Returns an OFF of two balls with a neck between them, each time another one."""
    around, rings = 8, 11
    thick = [0.3 + abs(math.cos(math.pi * (i + 0.5) / rings * random_numbers.uniform(1.5, 2.5)))
             for i in range(rings)]
    points = [(0, 0, -0.5)]
    for z, radius in enumerate(thick):
        points += [(radius * math.cos(2 * math.pi * i / around),
                    radius * math.sin(2 * math.pi * i / around), z / 2) for i in range(around)]
    points.append((0, 0, rings / 2))
    faces = []
    for i in range(around):
        j = (i + 1) % around
        faces.append((0, 1 + j, 1 + i))
        for z in range(rings - 1):
            a, b = 1 + z * around + i, 1 + z * around + j
            faces += [(a, b, a + around), (b, b + around, a + around)]
        top = 1 + (rings - 1) * around
        faces.append((top + i, top + j, len(points) - 1))
    return "OFF\n%d %d 0\n" % (len(points), len(faces)) + "".join(
        ["%.17g %.17g %.17g\n" % p for p in points] + ["3 %d %d %d\n" % f for f in faces])


def make_inputs(directory, count):
    """Returns the status that is expected of each input, by its name."""
    random_numbers = random.Random(1)
    expected = {}
    for i in range(count):
        name = "scans/%d/mesh %03d.off" % (i % 3, i)
        path = directory / name
        path.parent.mkdir(parents=True, exist_ok=True)
        expected[name] = "ok"
        if i % 10 == 3:
            expected[name] = "mesh"
            path.write_text(blob(random_numbers)[:random_numbers.randrange(2, 3000)])
        elif i % 10 == 7:
            expected[name] = "input"
        else:
            path.write_text(blob(random_numbers))
    return expected


def check(condition, message):
    if not condition:
        sys.exit("batch.py: " + message)


def rows(directory):
    """Returns the rows of the table, without a line that is not whole."""
    result = []
    table = directory / "out/table.jsonl"
    for line in table.read_text().splitlines() if table.exists() else []:
        try:
            result.append(json.loads(line))
        except json.JSONDecodeError:
            pass
    return result


def check_results(directory, expected):
    table = rows(directory)
    check(sorted(r["input"] for r in table) == sorted(expected), "not one row for each mesh")
    for row in table:
        check(row["status"] == expected[row["input"]], "%s has the status %s" %
              (row["input"], row["status"]))
    for name, status in expected.items():
        report = json.loads((directory / "out" / (name + ".json")).read_text())
        check(report["status"] == status, "the report of " + name)
        labels = directory / "out" / (name + ".labels")
        check(labels.exists() == (status == "ok"), "the labels of " + name)
    check(not list(directory.rglob("*.tmp")), "temporary files are left")


def check_labels(directory, tool, expected):
    for name, status in expected.items():
        if status == "ok":
            single = subprocess.run([tool, name, "--searches", "1", "--labels", "-", "--quiet"],
                                    cwd=directory, capture_output=True, check=True)
            labels = (directory / "out" / (name + ".labels")).read_bytes()
            check(single.stdout == labels, name + " has other labels")


def run(directory, tool, *arguments):
    return subprocess.run([tool, *arguments, "--out-dir", "out"], cwd=directory,
                          capture_output=True, text=True, check=False)


def check_long_table(directory, tool):
    """Checks that rows before take no memory from a run, and a name that is not UTF-8."""
    name = b"\xff.off" if sys.platform == "linux" else b"a.off"
    (directory / os.fsdecode(name)).write_text(blob(random.Random(1)))
    (directory / "out").mkdir()
    with open(directory / "out/table.jsonl", "w", encoding="utf-8") as table:
        for i in range(150000):
            table.write('{"input":"scans/%d.off","status":"ok","message":"","faces":20000,'
                        '"segments":7,"seconds":0.2,"peak_memory":19000000}\n' % i)
    limit = []
    if b"__asan_init" not in pathlib.Path(tool).read_bytes(): # which needs address space
        limit = ["--memory-limit", "100"]
    for summary in ("1 mesh segmented, 0 failed, 0 done before",
                    "0 meshes segmented, 0 failed, 1 done before"):
        done = run(directory, tool, name, *limit)
        check(done.returncode == 0 and summary in done.stdout, "the long table: " + done.stdout)
        check((directory / "out/table.jsonl").read_bytes().count(b"\n") == 150001,
              "the lines of the long table")


def check_hostile_lists(directory, tool):
    """Lists and directories that stopped a batch for ever, or mixed up its results."""
    small = blob(random.Random(2))
    for name in ("a.off", "b.off"):
        (directory / name).write_text(small)

    def batch(*arguments, program=(tool,)):
        return subprocess.run([*program, *arguments], cwd=directory, capture_output=True,
                              text=True, timeout=60, check=False)

    # The substitution is a child of the tool, because bash executes its last command in place.
    done = batch(program=("bash", "-c", "exec \"$0\" --out-dir child --list <(ls a.off b.off)",
                          tool))
    check((done.returncode, done.stderr) == (0, "") and "2 meshes" in done.stdout,
          "a batch with a child of another: " + done.stderr)
    (directory / "long").write_text("x" * 70000 + "\na.off\n")
    done = batch("--out-dir", "out_long", "--list", "long")
    check(done.returncode == 8 and "1 mesh segmented, 1 failed" in done.stdout,
          "a line of 70,000 bytes: " + done.stderr)
    (directory / "marked").write_bytes(b"\xEF\xBB\xBFa.off\r\n")
    done = batch("--out-dir", "out_marked", "--list", "marked")
    check(done.returncode == 0, "a list with a byte order mark: " + done.stderr)
    (directory / "zero").write_bytes(b"a.off\0b\n")
    for name, words in (("zero", "has a zero byte in line 1"), (".", "cannot be opened")):
        done = batch("--out-dir", "out_zero", "--list", name)
        check(done.returncode == 3 and words in done.stderr, "the list %s: %s" %
              (name, done.stderr))

    for content in ("", "{", "[]"):
        batch("--out-dir", "parameters", "--segments", "2", "a.off")
        (directory / "parameters/parameters.json").write_text(content)
        done = batch("--out-dir", "parameters", "--segments", "3", "b.off")
        check(done.returncode == 2 and "other parameters" in done.stderr,
              "damaged parameters: " + done.stderr)
        for file in (directory / "parameters").iterdir():
            file.unlink()

    for i, name in enumerate(("table.jsonl", "parameters.json", "a.off.json", "a.off.labels")):
        (directory / ("fifo%d" % i)).mkdir()
        os.mkfifo(directory / ("fifo%d" % i) / name)
        done = batch("--out-dir", "fifo%d" % i, "a.off")
        check(done.returncode in (7, 8), "a pipe in the place of " + name)
    (directory / "link").symlink_to("nowhere/nothing")
    done = batch("--out-dir", "link", "a.off")
    check(done.returncode == 7 and "link: it is not a directory" in done.stderr,
          "a link to nothing: " + done.stderr)

    if sys.platform == "linux": # other systems refuse such names
        names = [b"\xfe.off", b"\xff.off", b"\xc3\xbc.off"]
        for name in names:
            (directory / os.fsdecode(name)).write_text(small)
        done = subprocess.run([tool, *names, "--out-dir", "out"], cwd=directory,
                              capture_output=True, check=False)
        check(done.returncode == 0, "names that are no UTF-8")
        check(sorted(r["input"] for r in rows(directory)) == ["%FE.off", "%FF.off", "\u00fc.off"],
              "rows of names that are no UTF-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tool", type=os.path.abspath)
    parser.add_argument("--count", type=int, default=40)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        check_long_table(pathlib.Path(name), options.tool)
    with tempfile.TemporaryDirectory() as name:
        check_hostile_lists(pathlib.Path(name), options.tool)
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        expected = make_inputs(directory, options.count)
        count = collections.Counter(expected.values())
        (directory / "list").write_text("\n".join(expected))
        command = [options.tool, "--list", "list", "--out-dir", "out", "--jobs", "2",
                   "--searches", "1"]

        batch = subprocess.Popen(command, cwd=directory, stdout=subprocess.PIPE)
        while len(rows(directory)) < options.count // 3:
            time.sleep(0.01)
        batch.send_signal(signal.SIGKILL)
        batch.communicate()
        done_before = sum(r["status"] == "ok" for r in rows(directory))
        check(0 < done_before < count["ok"], "the first batch ended before it was killed")
        time.sleep(1) # for its last meshes to end
        check(not list(directory.rglob("*.tmp")), "temporary files are left by a batch killed")

        for kept in (done_before, count["ok"]): # the second time there is nothing more to do
            done = subprocess.run(command, cwd=directory, capture_output=True, text=True,
                                  check=False)
            check((done.returncode, done.stderr) == (8, ""), "the exit status: " + done.stderr)
            check("%d meshes segmented, %d failed, %d done before" %
                  (count["ok"] - kept, options.count - count["ok"], kept) in done.stdout,
                  "the summary: " + done.stdout)
            check_results(directory, expected)
        check_labels(directory, options.tool, expected)


if __name__ == "__main__":
    main()
