# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are never half written."""

import contextlib
import os
import secrets


def replace_file(path, contents):
    """Writes a file that is complete or, after an error, unchanged."""
    temporary = os.path.join(os.path.dirname(path), ".%s.tmp" % secrets.token_hex(8))
    try:
        with open(temporary, "xb") as file:
            file.write(contents)
        os.replace(temporary, path)
    except BaseException as error:
        with contextlib.suppress(OSError):
            os.remove(temporary)
        if isinstance(error, OSError):
            error.filename = path # the name that the caller knows
            del error.filename2 # None would be in the message
        raise
