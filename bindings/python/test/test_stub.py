# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The stub for type checkers has the names and parameters of the package."""

import ast
import inspect
import pathlib

import spectral_segmentation

STUB = ast.parse(pathlib.Path(spectral_segmentation.__file__).with_suffix(".pyi").read_text())


def definitions(body, kind):
    return {node.name: node for node in body if isinstance(node, kind)}


def test_names():
    assigned = {"CUT_STATES", "__version__"} & {node.target.id for node in STUB.body
                                 if isinstance(node, ast.AnnAssign)}
    names = {*definitions(STUB.body, (ast.FunctionDef, ast.ClassDef)), *assigned}
    assert sorted(names) == spectral_segmentation.__all__


def test_functions():
    for name, node in definitions(STUB.body, ast.FunctionDef).items():
        parameters = inspect.signature(getattr(spectral_segmentation, name)).parameters.values()
        assert [a.arg for a in node.args.args] == \
            [p.name for p in parameters if p.kind == p.POSITIONAL_OR_KEYWORD]
        keywords = [p for p in parameters if p.kind == p.KEYWORD_ONLY]
        assert [a.arg for a in node.args.kwonlyargs] == [p.name for p in keywords]
        assert [ast.literal_eval(d) for d in node.args.kw_defaults] == [p.default for p in keywords]


def test_classes():
    for name, node in definitions(STUB.body, ast.ClassDef).items():
        members = {*definitions(node.body, ast.FunctionDef),
                   *(part.target.id for part in node.body if isinstance(part, ast.AnnAssign))}
        public = {member for member in vars(getattr(spectral_segmentation, name))
                  if not member.startswith("_")}
        assert {member for member in members if not member.startswith("_")} == public


def test_everything_is_described():
    for name in spectral_segmentation.__all__:
        thing = getattr(spectral_segmentation, name)
        assert isinstance(thing, (tuple, str)) or \
            (thing.__doc__ and thing.__module__ == "spectral_segmentation")
        if inspect.isclass(thing):
            assert all(member.__doc__ for key, member in vars(thing).items()
                       if not key.startswith("_"))
