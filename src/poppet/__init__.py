"""Electro-pneumatic proportional valves and what they drive: measure, identify, simulate, control, deploy."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

from poppet.core.notebook import HtmlMixin
from poppet.core.version import __version__

if TYPE_CHECKING:
    from poppet import iso6358, library, signals
    from poppet.api import Circuit, load, loads
    from poppet.circuit.options import Ambient, GasChoice, Run
    from poppet.core import units
    from poppet.core.errors import InputError, InputErrors, OutOfRangeError, PoppetError, SimulationError, UnitError
    from poppet.core.provenance import Number, Source
    from poppet.laws.curves import Characteristic
    from poppet.monitoring.watch import watch
    from poppet.parts import (
        FMU,
        PID,
        Antagonist,
        Chamber,
        CheckValve,
        Compressor,
        Cylinder,
        DirectionalValve,
        Electronics,
        Filter,
        FlowControlValve,
        FlowSource,
        Gripper,
        Guide,
        InverseMuscle,
        Joint,
        MainStage,
        Mass,
        Muscle,
        Orifice,
        PilotedCheckValve,
        PilotStage,
        PressureBooster,
        PressureController,
        PressureRegulator,
        ProportionalValve,
        QuickExhaustValve,
        ReliefValve,
        Reservoir,
        RotaryActuator,
        Sequence,
        ShuttleValve,
        Silencer,
        SpoolValve,
        SuctionCup,
        Switch,
        Tube,
        TwoPressureValve,
        VacuumEjector,
    )
    from poppet.timeseries.measurements import read_recording as read
    from poppet.timeseries.recording import Recording

_MODULE_OF = {
    "Circuit": "api",
    "load": "api",
    "loads": "api",
    "Characteristic": "laws.curves",
    "Number": "core.provenance",
    "Source": "core.provenance",
    "Recording": "timeseries.recording",
    "Ambient": "circuit.options",
    "GasChoice": "circuit.options",
    "Run": "circuit.options",
    "watch": "monitoring.watch",
}
_MODULES = {"iso6358": "iso6358", "library": "library", "signals": "signals", "units": "core.units"}

# Literal, so that type checkers of those who use the package can read it.
__all__ = [
    "FMU",
    "PID",
    "Ambient",
    "Antagonist",
    "Chamber",
    "Characteristic",
    "CheckValve",
    "Circuit",
    "Compressor",
    "Cylinder",
    "DirectionalValve",
    "Electronics",
    "Filter",
    "FlowControlValve",
    "FlowSource",
    "GasChoice",
    "Gripper",
    "Guide",
    "InputError",
    "InputErrors",
    "InverseMuscle",
    "Joint",
    "MainStage",
    "Mass",
    "Muscle",
    "Number",
    "Orifice",
    "OutOfRangeError",
    "PilotStage",
    "PilotedCheckValve",
    "PoppetError",
    "PressureBooster",
    "PressureController",
    "PressureRegulator",
    "ProportionalValve",
    "QuickExhaustValve",
    "Recording",
    "ReliefValve",
    "Reservoir",
    "RotaryActuator",
    "Run",
    "Sequence",
    "ShuttleValve",
    "Silencer",
    "SimulationError",
    "Source",
    "SpoolValve",
    "SuctionCup",
    "Switch",
    "Tube",
    "TwoPressureValve",
    "UnitError",
    "VacuumEjector",
    "__version__",
    "iso6358",
    "library",
    "load",
    "loads",
    "read",
    "signals",
    "units",
    "watch",
]


# Imported on first use, as the names below.
HtmlMixin.renderer = lambda shown: importlib.import_module("poppet.report.notebook").html_of(shown)


def __getattr__(name: str) -> object:
    # Names are imported on first use: `import poppet` stays fast.
    if name in _MODULES:
        return importlib.import_module(f"poppet.{_MODULES[name]}")
    if name == "read":
        return importlib.import_module("poppet.timeseries.measurements").read_recording
    if name not in __all__:
        raise AttributeError(f"module 'poppet' has no attribute {name!r}")
    module = _MODULE_OF.get(name) or ("core.errors" if name.endswith(("Error", "Errors")) else "parts")
    return getattr(importlib.import_module(f"poppet.{module}"), name)


def __dir__() -> list[str]:
    return sorted(__all__)
