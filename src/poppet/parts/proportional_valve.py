"""Proportional valve: main stage, pilot stage and electronics in one part."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from poppet.core.codes import Note
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.compound import Compound
from poppet.parts.electronics import PRESETS, SCALES, Electronics
from poppet.parts.faults import HEALTHY, NUMBERS, Valve
from poppet.parts.fields import member, option, port, reference
from poppet.parts.main_stage import OUTPUTS, MainStage
from poppet.parts.part import AMBIENT
from poppet.parts.pilot_stage import PilotStage, volume_notes

_OF_MAIN_STAGE = ("data", "mode", "supply", "outlet", "exhaust", "fault", *NUMBERS)
MIN_PLATEAU_ROWS, MIN_REVERSALS = 10, 6
"""Minimum count of rows in an evaluated plateau, and minimum count of sign changes in an oscillation."""


@dataclass(frozen=True)
class ProportionalValve(Compound, Valve):
    """Electro-pneumatic pressure regulator.

    Notes
    -----
    The main stage has the mode `regulator`. The pilot pressure drives its plate, and the pilot volume increases with
    the stroke of the plate. The electronics measure pilot and outlet pressure and set the duties of the solenoid
    valves. The initial pilot pressure is `pilot.initial_pressure`, by default 1 bar; it does not depend on the outlet
    pressure. The default of `pilot_exhaust` is the ambient.

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
    symbol: ClassVar[symbols.Symbol | str] = symbols.PROPORTIONAL_VALVE
    summary: ClassVar[str] = "an electro-pneumatic pressure regulator: main stage, pilot stage and electronics"

    supply: str | None = port("gas node at port 1")
    outlet: str | None = port("gas node at port 2")
    exhaust: str | None = port("gas node at port 3")
    data: Any = reference(doc="name of a parameter set of the library, for all members")
    preset: str = option(*PRESETS, doc="preset; variant of the parameter set in `data`")
    setpoint_type: str = option(*SCALES, doc="type of setpoint")
    pilot_exhaust: str | None = port("gas node into which the pilot is vented", optional=True)
    main_stage: Any = member(MainStage, doc="main stage", inherited=_OF_MAIN_STAGE)
    pilot: Any = member(PilotStage, doc="pilot stage", inherited=("data", "supply", "exhaust"))
    electronics: Any = member(Electronics, doc="electronics", inherited=("data", "preset", "setpoint_type"))

    links: ClassVar[Mapping[str, str]] = {
        "main_stage.pilot_pressure": "pilot.pressure",
        "pilot.displacement": "main_stage.displacement",
        "pilot.fill_duty": "electronics.fill_duty",
        "pilot.vent_duty": "electronics.vent_duty",
        "electronics.outlet_pressure": "main_stage.outlet_pressure",
        "electronics.pilot_pressure": "pilot.pressure",
    }
    inlets: ClassVar[Mapping[str, str]] = {
        **{name: f"electronics.{name}" for name in ("setpoint", "power", "input_fault")},
        "fault": "main_stage.fault",
    }
    # By member. Only the outputs of the pilot state have other names outside.
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

    def __post_init__(self) -> None:
        self.forget_defaults()
        super().__post_init__()

    def notes(self) -> tuple[Note, ...]:
        return (*super().notes(), *self.fault_notes())

    def outside(self) -> dict[str, str]:
        names = super().outside()
        if self.fault == HEALTHY:
            del names["fault"]
        return names

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        count = sum(number.source.kind == "assumed" for number in self.numbers().values())
        assumed = f"{self.data}: {count} assumed numbers" if self.data else f"{count} assumed numbers"
        return [f"pressure regulator, {self.preset}", f"C(x), b(x): {self.main_stage.curve.name}", assumed]

    def list_internal_outputs(self) -> tuple[str, ...]:
        return (*self.internal_outputs, *self.electronics.list_internal_outputs())

    def options(self) -> dict[str, str]:
        # A preset is a set of numbers and does not change the model.
        return {name: choice for name, choice in super().options().items() if name != "preset"}

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        time, target = series("time"), series(f"{name}.target_pressure")
        supply, outlet = series(f"{self.supply}.pressure"), series(f"{self.outlet}.pressure")
        electronics, ambient = self.electronics, float(series(f"{AMBIENT}.pressure")[0])
        low, high = electronics.scaling.low.absolute(ambient), electronics.scaling.high.absolute(ambient)
        is_idle = target < low + float(electronics.zero_suppression) * (high - low)
        swept = -float(self.main_stage.plate_area) * float(series(f"{name}.stroke").min())
        notes = volume_notes("pilot.volume", self.pilot.volume, swept)
        facts = {"target_bar": target / 1e5, "time": time}
        notes += _first_note("valve.out_of_reach", target >= supply, **facts, supply_bar=supply / 1e5)
        notes += _first_note("valve.counts_as_zero", is_idle & (target > low), **facts)
        ends = np.append(np.flatnonzero(np.diff(target)), time.size - 1)
        starts = np.append(0, ends[:-1] + 1)
        has_power = series(f"{name}.power") > 0.5
        tolerance = 0.01 * (high - low)
        # A target that a controller changes has no plateaus, but the outlet can oscillate about it.
        is_driven = np.repeat(ends - starts < MIN_PLATEAU_ROWS, ends - starts + 1) & ~is_idle
        notes += _oscillation_notes(time, outlet, target, tolerance, is_driven, has_power)
        # A plateau is a period with a constant target. A target that changes in most rows has no plateaus.
        for first, last in zip(starts, ends, strict=True) if 2 * ends.size < time.size else ():
            if is_idle[last] or last - first < MIN_PLATEAU_ROWS:
                continue
            facts = {"target_bar": target[last] / 1e5, "time": time[last], "unpowered": not has_power[last]}
            # The last 30 %: earlier rows can belong to the step response.
            rows = slice(first, last + 1)
            final_rows = outlet[rows][time[rows] >= time[last] - 0.3 * (time[last] - time[first])]
            swing, error = np.ptp(final_rows), abs(outlet[last] - target[last])
            reversals = np.count_nonzero(np.diff(np.sign(final_rows - final_rows.mean())))
            if reversals >= MIN_REVERSALS and swing > tolerance:
                notes.append(Note("valve.not_held", **facts, swing_bar=swing / 1e5))
            elif error > tolerance:
                missed = {"outlet_bar": outlet[last] / 1e5, "missed_bar": error / 1e5}
                notes.append(Note("valve.not_reached", **facts, **missed))
        return tuple(notes)

    def inherited_fields(self, member: str) -> dict[str, Any]:
        match member:
            case "main_stage":
                ports = {name: getattr(self, name) for name in ("supply", "outlet", "exhaust")}
                fault: dict[str, Any] = {"fault": self.fault} if self.fault in self.faults else {"fault": HEALTHY}
                fault |= {name: None if fault["fault"] == HEALTHY else getattr(self, name) for name in NUMBERS}
                return {"data": self.data, "mode": "regulator", **ports, **fault}
            case "pilot":
                return {"data": self.data, "supply": self.supply, "exhaust": self.pilot_exhaust or AMBIENT}
            case _:
                return {"data": self.data, "preset": self.preset, "setpoint_type": self.setpoint_type}


def _first_note(code: str, is_true: Any, **series: Any) -> list[Note]:
    """Return a list with a note on the first row of a recording in which a condition is true.

    `is_true` contains the condition for each row. The facts of the note are the values of the keyword arguments in this
    row. The list is empty if the condition is never true.
    """
    return [Note(code, **{name: values[k] for name, values in series.items()}) for k in np.flatnonzero(is_true)[:1]]


def _oscillation_notes(
    time: Any, outlet: Any, target: Any, tolerance: float, is_driven: Any, has_power: Any
) -> list[Note]:
    """Return a list with a note if the outlet pressure oscillates while its target changes often.

    The arrays have one value for each row of the recording, and `is_driven` is True in the rows to be evaluated. An
    oscillation is a sequence of rises and falls above `tolerance` [Pa] during each of which the target changes less
    than half as much. The note is on the last oscillation.
    """
    # 1 where driven rows begin, and -1 after their end.
    edges = np.diff(np.concatenate([[0], is_driven.astype(int), [0]]))
    last: list[int] = []
    for first, after in zip(np.flatnonzero(edges == 1), np.flatnonzero(edges == -1), strict=True):
        turns = [int(first) + k for k in _turning_points(outlet[first:after].tolist(), tolerance)]
        sequence = turns[:1]
        for start, end in itertools.pairwise(turns):
            is_constant = abs(outlet[end] - outlet[start]) > 2.0 * np.ptp(target[start : end + 1])
            sequence = [*sequence, end] if is_constant else [end]
            if len(sequence) > MIN_REVERSALS:
                last = sequence[-MIN_REVERSALS - 1 :]
    if not last:
        return []
    rows = slice(last[0], last[-1] + 1)
    swing, mean, unpowered = np.ptp(outlet[rows]), np.mean(target[rows]), not has_power[last[-1]]
    facts = {"target_bar": mean / 1e5, "time": time[last[-1]], "unpowered": unpowered}
    return [Note("valve.not_held", **facts, swing_bar=swing / 1e5)]


def _turning_points(values: list[float], threshold: float) -> list[int]:
    """Return the indices at which a series changes between rising and falling.

    Rises and falls up to `threshold` are ignored.
    """
    turns: list[int] = []
    low = high = 0
    direction = 0
    for k, value in enumerate(values):
        high, low = (k if value > values[high] else high), (k if value < values[low] else low)
        if direction >= 0 and values[high] - value > threshold:
            turns.append(high)
            direction, low = -1, k
        elif direction <= 0 and value - values[low] > threshold:
            turns.append(low)
            direction, high = 1, k
    return turns
