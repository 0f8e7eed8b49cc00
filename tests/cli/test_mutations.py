"""Seeded mutations of every kind of file: a clear refusal or a result, never an internal error, a warning or a hang."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from mutated_files import KINDS, campaign

LARGEST = 512.0
"""Growth of the memory of the process while it reads the files [MB]."""


@pytest.mark.parametrize("count", [500, pytest.param(20_000, marks=pytest.mark.slow)])
@pytest.mark.parametrize("kind", KINDS)
def test_a_mutated_file_is_read_or_refused(kind: str, count: int, tmp_path: Path) -> None:
    tally = campaign(kind, count, tmp_path)
    assert tally.codes.total() == count
    # Mutations that are all harmless, or all fatal, would prove nothing.
    assert 0.02 * count < tally.codes[0] < 0.98 * count
    assert tally.growth < LARGEST
