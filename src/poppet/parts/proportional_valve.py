"""The complete pressure valve: main stage, pilot stage and electronics in one part."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from poppet.core.codes import Note
from poppet.parts.compound import Compound
from poppet.parts.electronics import PRESETS, SCALES, Electronics
from poppet.parts.fields import member, option, port, reference
from poppet.parts.main_stage import OUTPUTS, MainStage
from poppet.parts.part import AMBIENT
from poppet.parts.pilot_stage import PilotStage, too_small

SHORTEST_PLATEAU, TURNS = 10, 6
"""Rows of a plateau about which something can be said, and changes of sign that make an oscillation."""


@dataclass(frozen=True)
class ProportionalValve(Compound):
    """An electro-pneumatic pressure regulator.

    Parameters
    ----------
    supply, outlet, exhaust : str
        Stores at ports 1, 2 and 3.
    data : str
        A library set for all three members; fields given below them override it.
    preset : str
        `universal` (default), `fast` or `precise`.
    setpoint_type : str
        `pressure` (default), `0-10 V` or `4-20 mA`.
    pilot_exhaust : str
        Store into which the pilot is vented; default the open air.
    main_stage : table
        Fields of `main_stage`, but its ports and mode: it works as a regulator.
    pilot : table
        Fields of `pilot_stage`, but its ports.
    electronics : table
        Fields of `electronics`, but preset and setpoint_type.

    Notes
    -----
    The pilot volume grows with the plate's stroke, the pilot's pressure drives the plate, the electronics read pilot
    and outlet pressure and set the duties of the pilot's solenoids. The pilot starts at `pilot.initial_pressure`, 1 bar
    by default, whatever the outlet's pressure is then.

    References
    ----------
    Varga & Keski-Honkola 2012, fig. 1.

    Examples
    --------
    >>> valve = ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l", preset="fast")
    >>> print(valve.numbers()["pilot.volume"])
    5e-06 m^3
    """

    kind: ClassVar[str] = "proportional_valve"
    summary: ClassVar[str] = "an electro-pneumatic pressure regulator: main stage, pilot stage and electronics"

    supply: str | None = port("store at port 1")
    outlet: str | None = port("store at port 2")
    exhaust: str | None = port("store at port 3")
    data: Any = reference(doc="library set")
    preset: str = option(*PRESETS, doc="preset")
    setpoint_type: str = option(*SCALES, doc="type of setpoint")
    pilot_exhaust: str | None = port("store into which the pilot is vented", optional=True)
    main_stage: Any = member(MainStage, doc="the main stage", inherited=("data", "mode", "supply", "outlet", "exhaust"))
    pilot: Any = member(PilotStage, doc="the pilot stage", inherited=("data", "supply", "exhaust"))
    electronics: Any = member(Electronics, doc="the electronics", inherited=("data", "preset", "setpoint_type"))

    links: ClassVar[Mapping[str, str]] = {
        "main_stage.pilot_pressure": "pilot.pressure",
        "pilot.displacement": "main_stage.displacement",
        "pilot.fill_duty": "electronics.fill_duty",
        "pilot.vent_duty": "electronics.vent_duty",
        "electronics.outlet_pressure": "main_stage.outlet_pressure",
        "electronics.pilot_pressure": "pilot.pressure",
    }
    inlets: ClassVar[Mapping[str, str]] = {"setpoint": "electronics.setpoint", "power": "electronics.power"}
    # By member; all but the pilot's state are called outside as they are called inside.
    outlets: ClassVar[Mapping[str, str]] = {
        **{name: f"electronics.{name}" for name in (
            "target_pressure", "actual_value", "pilot_setpoint", "integral", "fill_duty", "vent_duty",
            "outlet_sensor_pressure", "pilot_sensor_pressure",
        )},
        **{f"pilot_{name}": f"pilot.{name}" for name in ("pressure", "temperature", "mass")},
        **{name: f"pilot.{name}" for name in (
            "fill_opening", "vent_opening", "fill_mass_flow_rate", "vent_mass_flow_rate",
            "supply_leak_mass_flow_rate", "exhaust_leak_mass_flow_rate",
        )},
        **{name: f"main_stage.{name}" for name in OUTPUTS},
    }  # fmt: skip
    internal_outputs: ClassVar[tuple[str, ...]] = (
        *Electronics.internal_outputs, *MainStage.internal_outputs, "pilot_temperature", "pilot_mass",
        *(name for name in PilotStage.internal_outputs if name.endswith(("opening", "mass_flow_rate"))),
    )  # fmt: skip
    resume: ClassVar[dict[str, str]] = {
        "pilot_pressure": "pilot.initial_pressure",
        "pilot_temperature": "pilot.initial_temperature",
        "stroke": "main_stage.initial_stroke",
        "velocity": "main_stage.initial_velocity",
        "integral": "electronics.initial_integral",
    }

    def list_internal_outputs(self) -> tuple[str, ...]:
        return (*self.internal_outputs, *self.electronics.list_internal_outputs())

    def options(self) -> dict[str, str]:
        # A preset is a set of numbers and shapes no model.
        return {name: choice for name, choice in super().options().items() if name != "preset"}

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        time, target = series("time"), series(f"{name}.target_pressure")
        supply, outlet = series(f"{self.supply}.pressure"), series(f"{self.outlet}.pressure")
        electronics, air = self.electronics, float(series(f"{AMBIENT}.pressure")[0])
        low, high = electronics.scaling.low.absolute(air), electronics.scaling.high.absolute(air)
        is_idle = target < low + float(electronics.zero_suppression) * (high - low)
        swept = -float(self.main_stage.plate_area) * float(series(f"{name}.stroke").min())
        remarks = too_small("pilot.volume", self.pilot.volume, swept)
        shown = {"target_bar": target / 1e5, "time": time}
        remarks += _first("valve.out_of_reach", target >= supply, **shown, supply_bar=supply / 1e5)
        remarks += _first("valve.counts_as_zero", is_idle & (target > low), **shown)
        ends = np.append(np.flatnonzero(np.diff(target)), time.size - 1)
        starts = np.append(0, ends[:-1] + 1)
        has_power = series(f"{name}.power") > 0.5
        missed = []
        # A target that moves all the time has no plateaus.
        if 2 * ends.size < time.size:
            for first, last in zip(starts, ends, strict=True):
                if not is_idle[last]:
                    rows = slice(first, last + 1)
                    missed += _of_plateau(
                        time[rows], outlet[rows], target[last], 0.01 * (high - low), not has_power[last]
                    )
        return *remarks, *missed

    def inherited_fields(self, member: str) -> dict[str, Any]:
        match member:
            case "main_stage":
                ports = {name: getattr(self, name) for name in ("supply", "outlet", "exhaust")}
                return {"data": self.data, "mode": "regulator", **ports}
            case "pilot":
                return {"data": self.data, "supply": self.supply, "exhaust": self.pilot_exhaust or AMBIENT}
            case _:
                return {"data": self.data, "preset": self.preset, "setpoint_type": self.setpoint_type}


def _first(code: str, holds: Any, **series: Any) -> list[Note]:
    """The note on the first moment at which something holds, with what the series are then."""
    return [Note(code, **{name: values[k] for name, values in series.items()}) for k in np.flatnonzero(holds)[:1]]


def _of_plateau(time: Any, outlet: Any, target: float, allowed: float, unpowered: bool) -> list[Note]:
    """What a plateau of the target has not come to: its value, or rest."""
    facts = {"target_bar": target / 1e5, "time": time[-1], "unpowered": bool(unpowered)}
    # The last third: what came before may still belong to the step.
    late = outlet[time >= time[-1] - 0.3 * (time[-1] - time[0])]
    swing = np.ptp(late)
    turns = np.count_nonzero(np.diff(np.sign(late - late.mean())))
    if time.size > SHORTEST_PLATEAU and turns >= TURNS and swing > allowed:
        return [Note("valve.not_held", **facts, swing_bar=swing / 1e5)]
    missed = abs(outlet[-1] - target)
    if time.size > SHORTEST_PLATEAU and missed > allowed:
        return [Note("valve.not_reached", **facts, outlet_bar=outlet[-1] / 1e5, missed_bar=missed / 1e5)]
    return []
