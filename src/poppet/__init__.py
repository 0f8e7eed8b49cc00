"""Electro-pneumatic proportional valves and what they drive: measure, identify, simulate, control, deploy."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from poppet._version import __version__

if TYPE_CHECKING:
    from poppet import iso6358, library, signals, units
    from poppet.circuit import Circuit
    from poppet.circuit_file import load
    from poppet.curves import Characteristic
    from poppet.errors import InputError, InputErrors, OutOfRangeError, PoppetError, SimulationError, UnitError
    from poppet.parts import (
        PID,
        Chamber,
        CheckValve,
        DirectionalValve,
        Electronics,
        FlowSource,
        MainStage,
        Orifice,
        PilotStage,
        PressureController,
        ProportionalValve,
        ReliefValve,
        Reservoir,
        Silencer,
    )
    from poppet.provenance import Number, Source
    from poppet.recording import Recording
    from poppet.run_options import Ambient, GasChoice, Run

_PLACES = {
    "Circuit": "circuit",
    "load": "circuit_file",
    "Characteristic": "curves",
    "Number": "provenance",
    "Source": "provenance",
    "Recording": "recording",
    **dict.fromkeys(("Ambient", "GasChoice", "Run"), "run_options"),
    **dict.fromkeys(
        ("InputError", "InputErrors", "OutOfRangeError", "PoppetError", "SimulationError", "UnitError"), "errors"
    ),
    **dict.fromkeys(
        (
            "PID",
            "Chamber",
            "CheckValve",
            "DirectionalValve",
            "Electronics",
            "FlowSource",
            "MainStage",
            "Orifice",
            "PilotStage",
            "PressureController",
            "ProportionalValve",
            "ReliefValve",
            "Reservoir",
            "Silencer",
        ),
        "parts",
    ),
}
_MODULES = ("iso6358", "library", "signals", "units")

__all__ = ["__version__", *_MODULES, *_PLACES]


def __getattr__(name: str) -> Any:
    # Names are looked up when first used: `import poppet` stays fast.
    if name in _PLACES:
        return getattr(importlib.import_module(f"poppet.{_PLACES[name]}"), name)
    if name in _MODULES:
        return importlib.import_module(f"poppet.{name}")
    raise AttributeError(f"module 'poppet' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)
