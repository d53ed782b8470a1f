# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of single arguments. Each function returns the argument as a type of Python's own."""

import math
import operator
import os
from typing import Union

import numpy as np

Path = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]


def integer(name, value, largest=2**63 - 1):
    if isinstance(value, (bool, np.bool_)):
        raise TypeError("%s must be an integer, not a bool" % name)
    try:
        result = operator.index(value)
    except TypeError:
        raise TypeError("%s must be an integer, not %s" % (name, type(value).__name__)) from None
    if result > largest:
        raise OverflowError("%s is too large: %d" % (name, result))
    return max(result, -2**63)


def real(name, value):
    if isinstance(value, (bool, np.bool_, str, bytes)) or not hasattr(value, "__float__"):
        raise TypeError("%s must be a number, not %s" % (name, type(value).__name__))
    return float(value)


def threshold(value, is_probability):
    """A salience threshold."""
    result = real("salience_threshold", value)
    if is_probability and math.isfinite(result) and not 0 <= result <= 1:
        raise ValueError("salience_threshold must be in [0, 1], because it is a probability, or "
                         "infinite")
    return result


def flag(name, value):
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError("%s must be a bool, not %s" % (name, type(value).__name__))
    return bool(value)


def three_numbers(name, value):
    try:
        numbers = list(value)
    except TypeError:
        raise TypeError("%s must be three numbers" % name) from None
    if len(numbers) != 3:
        raise ValueError("%s must be three numbers, not %d" % (name, len(numbers)))
    return [real(name, number) for number in numbers]


def function(name, value):
    if value is not None and not callable(value):
        raise TypeError("%s must be callable, not %s" % (name, type(value).__name__))
    return value
