# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything has types for type checkers, and a description."""

import inspect
import typing

import numpy as np
import numpy.typing
import pytest

import spectral_segmentation

NAMES = {"np": np, **vars(numpy.typing)} # which only type checkers import


def public_members(thing):
    return {name: member for name, member in vars(thing).items() if not name.startswith("_")}


def functions():
    for name in spectral_segmentation.__all__:
        thing = getattr(spectral_segmentation, name)
        if inspect.isfunction(thing):
            yield pytest.param(thing, id=name)
        elif inspect.isclass(thing) and not issubclass(thing, tuple):
            for key, member in public_members(thing).items():
                function = getattr(member, "fget", getattr(member, "__func__", member))
                yield pytest.param(function, id="%s.%s" % (name, key))


@pytest.mark.parametrize("function", functions())
def test_functions(function):
    signature = inspect.signature(function)
    annotations = [p.annotation for p in signature.parameters.values() if p.name != "self"]
    assert signature.empty not in annotations + [signature.return_annotation]
    assert typing.get_type_hints(function, localns=NAMES)


def test_segment_has_the_parameters_of_segment_hierarchy():
    signatures = [inspect.signature(function) for function in (
        spectral_segmentation.segment, spectral_segmentation.segment_hierarchy)]
    assert signatures[0].parameters == signatures[1].parameters
    assert [signature.return_annotation for signature in signatures] == \
        ["NDArray[np.intp]", "Hierarchy"]


def test_tuples():
    for thing in (spectral_segmentation.Mesh, spectral_segmentation.Part,
                  spectral_segmentation.SalienceFactors):
        assert tuple(thing.__annotations__) == thing._fields


def test_everything_is_described():
    for name in spectral_segmentation.__all__:
        thing = getattr(spectral_segmentation, name)
        assert isinstance(thing, (tuple, str)) or \
            (thing.__doc__ and thing.__module__ == "spectral_segmentation")
        if inspect.isclass(thing):
            assert all(member.__doc__ for member in public_members(thing).values())
