#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the command line tool on damaged files: mutated_files.py TOOL [--count N] [--seed S].

The files come from fuzz/make_corpus.py. The fuzzers look for damage that harms a reader; this
looks at the tool. Each run has to end in time with exit code 0 and labels, or with exit code 4 and
a message of its own, and to take no more memory than a small multiple of the file. Files that fail
are kept in --keep, if it is given.
"""

import argparse
import concurrent.futures
import os
import pathlib
import random
import re
import resource
import struct
import subprocess
import sys
import tempfile

import make_corpus

SECONDS = 10
IS_SANITIZED = False  # the tool
LIBRARY_WORDS = ["std::", "vector", "basic_string", "bad_alloc", "terminate", "CGAL", "filesystem",
                 "runtime error", "Sanitizer", "stoi", "stod"]
EXTREMES = ["0", "-0", "-1", "1", "255", "256", "65536", "2147483647", "-2147483648", "4294967295",
            "4294967296", "9000000000000000000", "18446744073709551616", "1e308", "-1e309",
            "1e-320",
            "nan", "inf", "-inf", "0x10", "1.5", "+3", "1e", "", "x"]
BINARY_EXTREMES = [struct.pack(order + code, number) for order in "<>" for code, number in [
    ("i", 0), ("i", -1), ("i", 2 ** 31 - 1), ("i", -2 ** 31), ("i", 4 * 10 ** 8), ("H", 65535),
    ("f", float("nan")), ("f", float("inf")), ("f", 3e38), ("d", 1e308), ("d", float("nan"))]]


def base_files():
    """Pairs of the extension and the bytes, which the tool reads, and those that it refuses."""
    files = [(name, data) for name in ("off", "obj", "ply", "stl")
             for data in getattr(make_corpus, name + "_files")()]
    refused = [(name, data) for name, data in files if b"400000000 0 1 2" in data]
    return [file for file in files if file not in refused], refused


# The functions that damage files. Each takes and returns bytes.

def change_numbers(data, rng, choose):
    """Replaces one number of a text."""
    numbers = list(re.finditer(rb"(?<![\w.])[-+]?\d[\w.+-]*", data))
    if not numbers:
        return data
    number = rng.choice(numbers)
    return data[:number.start()] + choose(number.group()) + data[number.end():]


def place(data, rng):
    return rng.randrange(len(data) + 1)


def flip_bits(data, rng):
    result = bytearray(data)
    for _ in range(rng.choice([1, 1, 3, 20]) if data else 0):
        result[rng.randrange(len(result))] ^= 1 << rng.randrange(8)
    return bytes(result)


def truncate(data, rng):
    return data[:place(data, rng)]


def put_extreme(data, rng):
    return change_numbers(data, rng, lambda _: rng.choice(EXTREMES).encode())


def put_binary_extreme(data, rng):
    extreme = rng.choice(BINARY_EXTREMES)
    at = place(data, rng)
    return data[:at] + extreme + data[at + len(extreme):]


def change_count(data, rng):
    """A small change of an integer: a count, or the number of a point."""
    def other(number):
        return b"%d" % (int(number) + rng.choice([-1, 1, 7])) if number.isdigit() else number
    head = rng.choice([len(data), min(len(data), 250)])
    return change_numbers(data[:head], rng, other) + data[head:]


MUTATORS = [flip_bits, truncate, put_extreme, put_binary_extreme, change_count]


def cases(bases, count, seed):
    """Yields a description, the extension and the bytes of each file, the untouched ones first."""
    for i, (name, data) in enumerate(bases):
        yield "file %d untouched" % i, name, data
    for number in range(count):
        rng = random.Random("%d %d" % (seed, number))
        i = rng.randrange(len(bases))
        name, data = bases[i]
        mutators = rng.choices(MUTATORS, k=rng.choice([1, 1, 1, 2, 4]))
        for mutate in mutators:
            data = mutate(data, rng)
        yield "file %d, %d: %s" % (i, number, ", ".join(m.__name__ for m in mutators)), name, data


# Runs

def limit_memory(size, is_sanitized):
    if not is_sanitized: # AddressSanitizer reserves terabytes
        limit = 64 * size + 600 * 10 ** 6
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def check_labels(path):
    labels = path.read_text().split("\n")[:-1] if path.exists() else []
    return None if labels and all(label.isdigit() for label in labels) else "no labels"


def check_sentence(error):
    word = next((w for w in LIBRARY_WORDS if w in error), None)
    if word:
        return "the error names %r" % word
    if not re.fullmatch(r"[^\n]*\w[^\n]*\n", error):
        return "the error is not one line"
    return None


def run(tool, folder, number, case, is_sound):
    """Returns a description of the failure, or None; and the exit code."""
    _, name, data = case
    path, labels = folder / ("%d.%s" % (number, name)), folder / ("%d.labels" % number)
    path.write_bytes(data)
    written = folder / ("%d.out.%s" % (number, ("ply", "obj", "off", "glb")[number % 4]))
    try:
        done = subprocess.run([tool, path, "--labels", labels, "--quiet", "--threads", "1",
                               "--method", ("paper", "calibrated")[number % 8 == 0], "-o", written],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=SECONDS,
                              preexec_fn=lambda: limit_memory(len(data), IS_SANITIZED), check=False)
    except subprocess.TimeoutExpired:
        return "over %d seconds" % SECONDS, None
    error = done.stderr.decode(errors="replace").replace(str(path), "FILE")
    if done.returncode == 0:
        wrong = check_labels(labels) or (error and "an error with exit code 0")
    elif done.returncode == 4:
        wrong = check_sentence(error) or (is_sound and "a sound file is refused")
        wrong = wrong or (labels.exists() and "labels with exit code 4")
    elif done.returncode == 7 and "a coordinate is too large for the numbers of GLB" in error:
        wrong = check_sentence(error) or (labels.exists() and "labels with exit code 7")
    else:
        wrong = "exit code %d" % done.returncode
    path.unlink()
    for output in (labels, written, written.with_suffix(".mtl")):
        output.unlink(missing_ok=True)
    return wrong and "%s: %s" % (wrong, error.strip()[:200]), done.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tool", type=os.path.abspath)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()

    global IS_SANITIZED
    IS_SANITIZED = b"__asan_init" in pathlib.Path(options.tool).read_bytes()

    sound, refused = base_files()
    all_cases = list(cases(sound + refused, options.count, options.seed))
    with tempfile.TemporaryDirectory() as folder, \
         concurrent.futures.ThreadPoolExecutor(max_workers=2) as executor:
        results = list(executor.map(
            lambda i: run(options.tool, pathlib.Path(folder), i, all_cases[i],
                          i < len(sound)), range(len(all_cases))))
    failures = 0
    for i, ((what, name, data), (wrong, _)) in enumerate(zip(all_cases, results)):
        if wrong:
            failures += 1
            print("%s (%s): %s" % (what, name, wrong))
            if options.keep:
                options.keep.mkdir(parents=True, exist_ok=True)
                (options.keep / ("%d.%s" % (i, name))).write_bytes(data)
    codes = [code for _, code in results]
    print("%d files, %d read, %d refused, %d failures" % (
        len(results), codes.count(0), codes.count(4), failures))
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()
