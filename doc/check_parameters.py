#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""check_parameters.py HEADER TEXT...

Fails if the texts, pages of the manual, leave out a named parameter that the header documents.
"""

import pathlib
import re
import sys


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    header, *texts = (pathlib.Path(name).read_text() for name in sys.argv[1:])
    text = "".join(texts)
    names = re.findall(r"\\cgalParamNBegin\{(\w+)\}", header)
    missing = [name for name in names if not re.search(r"(`|params::)" + name + r"\b", text)]
    if missing or not names:
        sys.exit("The manual does not name: " + (", ".join(missing) or "any parameter"))


if __name__ == "__main__":
    main()
