#!/usr/bin/python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the instructions of a run by each method, and compares them with those on file.

  check_instructions.py PROGRAM MESH             fails if a count is off by more than 2 %
  check_instructions.py PROGRAM MESH --update    writes the counts to the file

PROGRAM is benchmark/instructions, built by CMake in Release, MESH is elephant.off of libcgal-demo:
the target check_instructions calls it with these. A count hardly depends on the machine and what
else runs there, but on the compiler and the libraries: the file names those of its counts, and
there is no verdict with others. Needs valgrind.

To renew the counts after a change that is worth its time:

  cmake --build build --target instructions
  scripts/check_instructions.py build/benchmark/instructions build/data/meshes/elephant.off --update
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

COUNTS_FILE = pathlib.Path(__file__).resolve().parent.parent / "benchmark/instruction_counts.json"
METHODS = ("calibrated", "paper")
TOLERANCE = 0.02

# The C library has functions for several processors; these switches leave those for all of them.
GLIBC_TUNABLES = "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4,-ERMS,-FSRM"


def parse_arguments():
    parser = argparse.ArgumentParser(
        description="Counts the instructions of a run by each method.")
    parser.add_argument("program", metavar="PROGRAM", help="benchmark/instructions")
    parser.add_argument("mesh", metavar="MESH")
    parser.add_argument("--update", action="store_true", help="write the counts to the file")
    return parser.parse_args()


def output_of(command, **options):
    try:
        return subprocess.run(command, check=True, text=True, capture_output=True, **options)
    except FileNotFoundError:
        sys.exit(f"check_instructions.py: there is no {command[0]}")
    except subprocess.CalledProcessError as error:
        sys.exit(f"check_instructions.py: {' '.join(error.cmd)}: {error.stderr}")


def number_of_instructions(program, mesh, method):
    run = output_of(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                     "--toggle-collect=counted_run", program, mesh, "--method", method],
                    env={**os.environ, "GLIBC_TUNABLES": GLIBC_TUNABLES})
    return int(re.search(r"Collected : (\d+)", run.stderr).group(1))


def is_near(method, count, expected):
    change = count / expected - 1
    print(f"{method}: {count} instructions, {100 * change:+.2f} %")
    return abs(change) <= TOLERANCE


def main():
    arguments = parse_arguments()
    environment = json.loads(output_of([arguments.program]).stdout)
    counts = {"mesh": pathlib.Path(arguments.mesh).name,
              "environment": environment,
              "instructions": {method: number_of_instructions(arguments.program, arguments.mesh,
                                                              method)
                               for method in METHODS}}
    if arguments.update:
        COUNTS_FILE.write_text(json.dumps(counts, indent=1) + "\n")
        return
    if not COUNTS_FILE.exists():
        sys.exit(f"check_instructions.py: there is no {COUNTS_FILE}; --update writes it")
    expected = json.loads(COUNTS_FILE.read_text())
    near = [is_near(method, counts["instructions"][method], expected["instructions"][method])
            for method in METHODS]
    if (counts["mesh"], environment) != (expected["mesh"], expected["environment"]):
        print(f"No verdict: the counts on file are for {expected['mesh']}, "
              f"{expected['environment']}, these for {counts['mesh']}, {environment}.")
    elif not all(near):
        sys.exit("check_instructions.py: more than 2 % off; --update takes the new counts")


if __name__ == "__main__":
    main()
