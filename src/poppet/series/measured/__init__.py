"""Recordings made by others: tables in many formats, their mapping to a circuit's addresses, and sanity verdicts."""

from __future__ import annotations

from poppet.series.measured.mapping import read_measurement
from poppet.series.measured.measurement import Channel, InputChannel, Measurement
from poppet.series.measured.tables import Table, read_table
from poppet.series.measured.verdicts import noise_of, quantum_of

__all__ = [
    "Channel",
    "InputChannel",
    "Measurement",
    "Table",
    "noise_of",
    "quantum_of",
    "read_measurement",
    "read_table",
]
