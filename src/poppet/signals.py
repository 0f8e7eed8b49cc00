"""Signals: what drives the inputs of a circuit over time."""

from poppet.series.signals import (
    Chirp,
    Constant,
    Delayed,
    Points,
    Prbs,
    Sampled,
    SegmentTable,
    Signal,
    Sine,
    Steps,
    merge,
)

__all__ = [
    "Chirp",
    "Constant",
    "Delayed",
    "Points",
    "Prbs",
    "Sampled",
    "SegmentTable",
    "Signal",
    "Sine",
    "Steps",
    "merge",
]
