"""Tests of conversion formulas in MDF files, which another package would evaluate as code."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from poppet.timeseries.tables.formulas import formulas_of, is_arithmetic
from poppet.timeseries.tables.reading import read_table
from refusals import refused

HOSTILE = [
    "__import__('os').system('true')",
    "X.__class__",
    "(lambda: X)()",
    "X if 1 else 2",
    "[X][0]",
    "X; 1",
    "eval('1')",
    "9**9**9",
    "9**X",
    "X**100",
    "((((9**9)**9)**9)**9)",
    "print(X)",
    "X(1)(2) sin",
    "sin",
    "1 +",
    "1" * 600,
]


@pytest.mark.parametrize("formula", ["X", "X1*2.5 - 0.1", " -1e-3*(X + 4) / 2 ", "sqrt(abs(X)) + X**2", "X**0.5"])
def test_arithmetic_is_valid(formula):
    assert is_arithmetic(formula)


@pytest.mark.parametrize("formula", [*HOSTILE, "Ⅹ", ""])
def test_other_formulas_are_not_arithmetic(formula):
    assert not is_arithmetic(formula)


def test_nested_conversions_are_found():
    inner = SimpleNamespace(formula=b"9**9**9", referenced_blocks=None)
    outer = SimpleNamespace(formula="", referenced_blocks={"default_addr": inner, "text_0": b"x", "none": None})
    inner.referenced_blocks = {"cycle": outer}
    assert formulas_of(outer) == ["9**9**9"]
    assert formulas_of(None) == []


def _write(path, formula):
    mdf = pytest.importorskip("asammdf")
    from asammdf.blocks import v4_blocks, v4_constants

    conversion = v4_blocks.ChannelConversion(conversion_type=v4_constants.CONVERSION_TYPE_ALG, formula=formula)
    time = np.arange(5.0)
    with mdf.MDF(version="4.10") as file:
        file.append([mdf.Signal(2.0 * time, time, name="p", unit="bar", conversion=conversion)])
        file.save(path, overwrite=True)


def test_formulas_of_an_mdf_file(tmp_path):
    path = tmp_path / "a.mf4"
    _write(path, "X * 2 + 1")
    assert read_table(path).columns[1].tolist() == [1.0, 5.0, 9.0, 13.0, 17.0]
    for formula in ("9**9**9**9", "__import__('os').system('true')", "X.__class__"):
        _write(path, formula)
        with refused("table.formula", channel="p", formula=formula):
            read_table(path)
