# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs in examples/, each as a user runs it, where the modules that it needs are."""

import csv
import errno
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

from spectral_segmentation import read, segment, segment_adjacency, segment_colors, write

EXAMPLES = pathlib.Path(__file__).resolve().parent.parent / "examples"


def command(name, *arguments):
    return [sys.executable, EXAMPLES / name, *map(str, arguments)]


def run(name, *arguments):
    done = subprocess.run(command(name, *arguments), stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, timeout=100, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def labels_of_tool(tool, path, *options):
    return subprocess.run([tool, path, "--quiet", "--labels", "-", *options], check=True,
                          stdout=subprocess.PIPE).stdout


def rows_of(folder):
    with open(folder / "table.csv", newline="", encoding="utf-8") as file:
        return {pathlib.Path(row["file"]).name: row for row in csv.DictReader(file)}


def areas(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return np.sqrt((np.cross(b - a, c - a)**2).sum(axis=1)) / 2


def check_colors(picture, colors):
    """Almost all of the colors are on many pixels, lit in any way, and few pixels have others."""
    image = pytest.importorskip("matplotlib.image").imread(picture)[:, :, :3]
    brightness = image.max(axis=2)
    is_colored = (brightness > 0.2) & (image.min(axis=2) < 0.8 * brightness)
    pixels = image[is_colored] / brightness[is_colored][:, np.newaxis]
    colors = colors / colors.max(axis=1, keepdims=True)
    is_like = np.abs(pixels[:, np.newaxis] - colors).max(axis=2) < 0.03
    counts = is_like.sum(axis=0)
    assert (counts > 100).sum() >= 0.8 * len(colors), counts # others are behind
    assert is_like.any(axis=1).mean() > 0.8 # others are at edges


def check_picture(program, tmp_path, meshes, tool):
    path = meshes / "elephant.off"
    labels = np.array(labels_of_tool(tool, path, "--segments", "7").split(), int)
    run(program, path, "-o", tmp_path / "a.png", "--segments", 7)
    colors = segment_colors(read(path).triangles, labels)
    assert len(colors) == 7
    check_colors(tmp_path / "a.png", colors)


def test_picture(tmp_path, meshes, tool):
    pytest.importorskip("matplotlib")
    check_picture("picture.py", tmp_path, meshes, tool)


def test_picture_by_vtk(tmp_path, meshes, tool):
    pytest.importorskip("vtk")
    if "DISPLAY" not in os.environ and not shutil.which("xvfb-run"):
        pytest.skip("neither a display nor xvfb-run")
    check_picture("picture_by_vtk.py", tmp_path, meshes, tool)


def table_of_parts(path, tmp_path, *arguments):
    pytest.importorskip("pandas")
    printed = run("table_of_parts.py", path, "--csv", tmp_path / "parts.csv", *arguments)
    with open(tmp_path / "parts.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(printed.splitlines()) == len(rows) + 2
    assert [row["part"] for row in rows] == [str(part) for part in range(len(rows))]
    return rows


def test_table_of_parts(tmp_path, meshes, tool):
    path = meshes / "elephant.off"
    rows = table_of_parts(path, tmp_path)
    points, triangles, _ = read(path)
    labels = np.array(labels_of_tool(tool, path).split(), int)
    assert len(rows) == labels.max() + 1
    assert sum(float(row["fraction"]) for row in rows) == pytest.approx(1)
    pairs, lengths = segment_adjacency(points, triangles, labels)
    for part, row in enumerate(rows):
        of_part = triangles[labels == part]
        assert int(row["triangles"]) == len(of_part)
        assert float(row["area"]) == pytest.approx(areas(points, of_part).sum(), rel=1e-12)
        for axis, name in enumerate("xyz"):
            assert float(row[name + "_min"]) == points[of_part, axis].min()
            assert float(row[name + "_max"]) == points[of_part, axis].max()
        at_part = (pairs == part).any(axis=1)
        assert [int(other) for other in row["neighbors"].split()] == \
            sorted(pairs[at_part].sum(axis=1) - part)
        assert float(row["boundary"]) == pytest.approx(lengths[at_part].sum())
        assert 0.4 <= float(row["salience"]) <= 1 # from the default threshold on


def test_table_of_a_mesh_that_is_one_part(tmp_path, dumbbell):
    write(tmp_path / "a.ply", *dumbbell)
    row, = table_of_parts(tmp_path / "a.ply", tmp_path, "--segments", 1)
    assert (int(row["triangles"]), float(row["fraction"]), row["neighbors"], float(row["boundary"]),
            row["salience"]) == (len(dumbbell[1]), 1, "", 0, "")


@pytest.fixture
def scans(tmp_path, meshes):
    """Returns a folder of meshes, one of which is damaged."""
    folder = tmp_path / "scans"
    (folder / "more").mkdir(parents=True)
    for name in ("elephant", "hand", "cube"):
        shutil.copy(meshes / (name + ".off"), folder)
    shutil.copy(meshes / "blobby_3cc.off", folder / "more" / "bl\u00f6b, \"left\".OFF")
    torn = (meshes / "cow.off").read_bytes()[:2000]
    (folder / "torn.off").write_bytes(torn)
    (folder / "readme.txt").write_text("no mesh")
    return folder


def check_rows(folder, scans, tool, others):
    """Checks a table. `others` has the status of files that are not in `scans`."""
    rows = rows_of(folder)
    files = {path.name: path for path in scans.rglob("*") if path.suffix.lower() == ".off"}
    assert set(rows) == set(files) | set(others)
    with open(folder / "table.csv", encoding="utf-8") as file:
        assert len(file.readlines()) == len(rows) + 1
    for name, row in rows.items():
        assert row["status"] == others.get(name, "mesh" if name == "torn.off" else "ok")
        assert (row["error"] == "") == (row["labels"] != "") == (row["status"] == "ok")
        if row["status"] == "ok":
            labels = (folder / row["labels"]).read_bytes()
            assert labels == labels_of_tool(tool, files[name])
            mesh = read(files[name])
            of_segments = [float(area) for area in row["areas"].split()]
            assert len(of_segments) == int(row["segments"]) == max(map(int, labels.split())) + 1
            assert sum(of_segments) == pytest.approx(areas(*mesh[:2]).sum(), rel=1e-5)
            assert int(row["triangles"]) == len(mesh.triangles)
            assert float(row["seconds"]) > 0
    assert "line 2: the file is too short" in rows["torn.off"]["error"]
    assert not list(folder.rglob("*.tmp"))


def reader_of(pipe, process):
    """Opens the pipe when another process reads it; that process' id. None if `process` ends."""
    while process.poll() is None:
        try:
            writer = os.open(pipe, os.O_WRONLY | os.O_NONBLOCK)
        except OSError as error:
            assert error.errno == errno.ENXIO # nobody reads it yet
            time.sleep(0.01)
            continue
        while True:
            for link in pathlib.Path("/proc").glob("[0-9]*/fd/*"):
                pid = int(link.parts[2])
                try:
                    if pid != os.getpid() and os.readlink(link) == str(pipe):
                        return writer, pid
                except OSError:
                    pass # the file has been closed
    return None


def wait_for_end(pid):
    """Waits until a process has closed its files, at most for the time limit of the test."""
    try:
        while pathlib.Path("/proc/%d/stat" % pid).read_text().rsplit(")")[-1].split()[0] != "Z":
            time.sleep(0.01)
    except OSError:
        pass # there is no such process any more


def start(name, pipe, *arguments):
    if not sys.platform.startswith("linux"):
        pytest.skip("only Linux has /proc")
    if not pipe.exists():
        os.mkfifo(pipe)
    return subprocess.Popen(command(name, *arguments), stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True)


def run_with_kills(name, pipe, kills, contents, *arguments):
    """Kills the process that reads the pipe some times, and writes to the pipe for the next."""
    process = start(name, pipe, *arguments)
    try:
        for _ in range(kills):
            writer, pid = reader_of(pipe, process)
            os.kill(pid, signal.SIGKILL)
            wait_for_end(pid)
            os.close(writer)
        if contents:
            writer, _ = reader_of(pipe, process)
            os.set_blocking(writer, True)
            with open(writer, "wb") as file:
                file.write(contents)
        output, errors = process.communicate(timeout=100)
        assert process.returncode == 0, errors
        return output
    finally:
        process.kill()
        process.communicate()


def check_that_nothing_is_done_again(name, folder, *arguments):
    files = [path for path in folder.rglob("*") if path.is_file()]
    before = [path.stat().st_mtime_ns for path in files]
    assert "0 meshes segmented, 0 failed, 7 done before" in run(name, *arguments)
    assert [path.stat().st_mtime_ns for path in files] == before


def test_many_meshes(tmp_path, scans, tool):
    """The program is killed, and then goes on with a mesh that kills each process that reads it."""
    out, pipe = tmp_path / "out", tmp_path / "pipe.off"
    arguments = [pipe, scans, tmp_path / "nowhere.off", "-o", out, "--jobs", 2]
    process = start("many_meshes.py", pipe, *arguments)
    writer, worker = reader_of(pipe, process)
    while (out / "table.csv").read_bytes().count(b"\n") < 4: # the other process goes on
        assert process.poll() is None
        time.sleep(0.01)
    process.kill()
    process.communicate()
    wait_for_end(worker)
    os.close(writer)

    ok_before = [row["status"] == "ok" for row in rows_of(out).values()]
    with open(out / "table.csv", "a", encoding="utf-8") as file:
        file.write('"%s,ok' % pipe) # half a row
    assert "%d meshes segmented, %d failed, %d done before" % (
        4 - sum(ok_before), 3 - ok_before.count(False), len(ok_before)) in \
        run_with_kills("many_meshes.py", pipe, 2, b"", *arguments)
    check_rows(out, scans, tool, {"pipe.off": "crash", "nowhere.off": "input"})
    assert rows_of(out)["nowhere.off"]["error"] == "No such file or directory"
    check_that_nothing_is_done_again("many_meshes.py", out, *arguments)


def test_many_meshes_of_a_list(tmp_path, meshes):
    (tmp_path / "list").write_text("%s\n%s\n" % (meshes / "cube.off", meshes / "hand.off"))
    output = run("many_meshes.py", "@%s" % (tmp_path / "list"), "-o", tmp_path / "out",
                 "--segments", 2, meshes / ".." / meshes.name / "cube.off")
    assert "2 meshes segmented, 0 failed, 0 done before" in output
    assert {name: row["segments"] for name, row in rows_of(tmp_path / "out").items()} == \
        {"cube.off": "2", "hand.off": "2"}


def test_contact_sheet(tmp_path, meshes):
    pytest.importorskip("matplotlib")
    mesh = read(meshes / "elephant.off")
    labels = segment(mesh, number_of_segments=7)
    np.savetxt(tmp_path / "labels.txt", labels, fmt="%d")
    (tmp_path / "table.csv").write_text(
        "file,status,segments,labels\n%s,ok,7,labels.txt\nnowhere.off,input,,\n"
        % (meshes / "elephant.off"))
    run("contact_sheet.py", tmp_path, "-o", tmp_path / "sheet.png")
    check_colors(tmp_path / "sheet.png", segment_colors(mesh.triangles, labels))


def test_many_meshes_by_dask(tmp_path, scans, meshes, tool):
    """A worker is killed while it reads a mesh, which another reads then."""
    pytest.importorskip("distributed")
    out, pipe = tmp_path / "out", tmp_path / "pipe.off"
    elephant = (meshes / "elephant.off").read_bytes()
    arguments = [pipe, scans, tmp_path / "nowhere.off", "-o", out, "--jobs", 2]
    assert "5 meshes segmented, 2 failed, 0 done before" in \
        run_with_kills("many_meshes_by_dask.py", pipe, 1, elephant, *arguments)
    check_that_nothing_is_done_again("many_meshes_by_dask.py", out, *arguments)
    pipe.unlink()
    shutil.copy(meshes / "elephant.off", scans / pipe.name)
    check_rows(out, scans, tool, {"nowhere.off": "input"})
