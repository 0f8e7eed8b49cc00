"""The run of the page is that of `Circuit.simulate` for the saved file, bit for bit without fused operations."""

from __future__ import annotations

import numpy as np
import pytest

from circuits_of_exports import EXAMPLES
from javascript import unfused
from poppet import load

EXACT = ("fill_staircase", "two_tanks", "emptying")
"""Circuits without functions whose last bit differs between browser and system, such as the exponential function."""


@pytest.mark.parametrize("name", EXACT)
def test_the_run_has_the_bits_of_the_saved_file(start_editor, name, tmp_path, monkeypatch):
    editor = start_editor((EXAMPLES / f"{name}.toml").read_text(encoding="utf-8"))
    editor.save()
    run = editor.recording()
    expected = unfused(load(editor.folder / "plant.toml"), monkeypatch, tmp_path)
    names = [name for name, _ in expected.problem.kernel.model.outputs]
    rows = int(expected.counts[2])
    assert {*run} == {"time", *names}
    for row, output in zip(expected.table, names, strict=True):
        assert np.array_equal(run[output], row[:rows]), output
