"""Measured recordings: assignment of file columns to circuit signals, and plausibility checks."""

from __future__ import annotations

from poppet.timeseries.measurements.mapping import read_measurement, read_recording
from poppet.timeseries.measurements.measurement import Channel, InputChannel, Measurement, noise_of, quantum_of

__all__ = [
    "Channel", "InputChannel", "Measurement", "noise_of", "quantum_of", "read_measurement", "read_recording",
]  # fmt: skip
