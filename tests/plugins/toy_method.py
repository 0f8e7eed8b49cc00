"""An identification method of a third-party package: the mean of the numbers in a file."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from poppet.identify.methods import Method

POPPET_API = 1


def read(path: Path) -> list[float]:
    """Return the numbers of a file."""
    return [float(line) for line in path.read_text().splitlines()]


class Mean(NamedTuple):
    """Result of the method."""

    value: float
    interrupted: bool = False


def run(path: Path, **options: Any) -> Mean:
    """Return the mean."""
    values = read(path)
    return Mean(sum(values) / len(values))


METHOD = Method("toy_mean", "mean of numbers", run, read, {}, text=lambda result, count: f"mean {result.value:g}")
