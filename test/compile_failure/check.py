#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""check.py FILE COMMAND ...

Compiles the file by the command. Lines that end with "// error: PATTERN" must not compile: the
compiler has to print at least as many errors of a pattern as there are lines with it, and no
others. A file without such lines must compile.
"""

import collections
import os
import re
import subprocess
import sys

source, command = sys.argv[1], sys.argv[2:]
with open(source, encoding="utf-8") as file:
    expected = collections.Counter(re.findall(r"// error: (.*)$", file.read(), re.MULTILINE))
done = subprocess.run(command + [source], env={**os.environ, "LC_ALL": "C"}, text=True,
                      stderr=subprocess.PIPE, check=False)
print(done.stderr)

failures = []
if (done.returncode != 0) != bool(expected):
    failures.append("compiled, but must not" if expected else "did not compile")
errors = [line for line in done.stderr.splitlines() if re.search(r"[^/] error: ", line)]
for pattern, number in expected.items():
    found = sum(bool(re.search(pattern, line)) for line in errors)
    if found < number:
        failures.append("%d errors in place of %d: %s" % (found, number, pattern))
for line in errors:
    if not any(re.search(pattern, line) for pattern in expected):
        failures.append("one more error: " + line)
sys.exit("\n".join(failures) or 0)
