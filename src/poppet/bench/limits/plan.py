"""What is looked at for the dynamic limits of a valve: ranges, and circuits with changed parts."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from poppet.bench.agreement import without_bands
from poppet.bench.sine_rig import SineRig
from poppet.circuit.circuit import Circuit
from poppet.ground.errors import InputError, Mistakes, Near
from poppet.ground.units import quantity
from poppet.parts.chamber import Chamber
from poppet.parts.electronics import SCALES
from poppet.parts.proportional_valve import ProportionalValve
from poppet.series.signals import Constant

Changes = dict[str, Any]
"""Address of a number to its new value."""
SETTLING = 2.0
"""Time for which a circuit settles before it is driven [s]."""
LOOSE = 1e-6
"""Relative tolerance of the runs."""
POINTS = 6
"""Volumes and amplitudes of the default ranges."""
SPREAD = 10.0
"""Default volumes reach from a tenth to ten times that of the circuit."""
SMALLEST, LARGEST = 0.005, 0.25
"""Default amplitudes, per span of the setpoint."""
SPRINGS = (0.5, 1.0, 2.0)
DAMPINGS = (0.25, 0.5, 1.0, 2.0, 4.0)
"""Default factors on spring rates and damping."""
IDEAL = 10.0
"""Factor by which a part is made ideal."""


@dataclass(frozen=True, eq=False)
class LimitsPlan:
    """A valve in its circuit and the ranges over which its limits are looked for."""

    circuit: Circuit
    valve: str
    outlet: str  # name of the chamber at its outlet
    mean: float  # outlet pressure about which it works [Pa]
    volumes: tuple[float, ...]  # of that chamber [m^3]
    amplitudes: tuple[float, ...]  # of the sine and of the half step [Pa]
    springs: tuple[float, ...]  # factors on the spring rates, at the same preload forces
    dampings: tuple[float, ...]  # factors on the damping
    lowest: float = 0.1  # frequency from which a bandwidth is looked for [Hz]
    highest: float = 400.0  # and up to which [Hz]

    @property
    def setpoint(self) -> str:
        """Address of the valve's setpoint."""
        return f"{self.valve}.setpoint"

    @property
    def pressure(self) -> str:
        """Address of the outlet pressure."""
        return f"{self.outlet}.pressure"

    @property
    def per_pascal(self) -> float:
        """Setpoint per pressure, in its unit per Pa."""
        _, first, last = SCALES[self._kind]
        low, high = self.ends
        return 1.0 if self._kind == "pressure" else (last - first) / (high - low)

    @property
    def _kind(self) -> str:
        kind: str = self.circuit.parts[self.valve].members["electronics"].setpoint_type  # type: ignore[attr-defined]
        return kind

    @property
    def ends(self) -> tuple[float, float]:
        """Pressures at 0 % and 100 % of the setpoint."""
        values, path = self.circuit.parameters, f"{self.valve}.electronics.scaling"
        return values[f"{path}.low"], values[f"{path}.high"]

    def asked(self, pressure: float) -> float:
        """Setpoint for a pressure."""
        if self._kind == "pressure":
            return pressure
        return SCALES[self._kind][1] + (pressure - self.ends[0]) * self.per_pascal

    def rig(self, volume: float, changes: Changes | None = None, *, bands: bool = True) -> SineRig:
        """The settled circuit at the mean pressure with another outlet volume, as it is or without bands."""
        case = self.case(volume, changes)
        instance = (case if bands else without_bands(case)).instance
        return SineRig(instance, self.setpoint, self.pressure, settling=SETTLING, relative_tolerance=LOOSE)

    def case(self, volume: float, changes: Changes | None = None) -> Circuit:
        """The circuit at the mean pressure with another outlet volume."""
        numbers = self.circuit.parameters
        electronics = f"{self.valve}.electronics.outer"
        ambient = self.circuit.surroundings.pressure
        # The pilot starts where its controller will hold it, so that the run settles within some samples.
        pilot = (
            ambient + numbers[f"{electronics}.feed_forward"] * (self.mean - ambient) + numbers[f"{electronics}.bias"]
        )
        values: Changes = {
            f"{self.outlet}.volume": volume,
            f"{self.outlet}.initial_pressure": self.mean,
            f"{self.valve}.pilot.initial_pressure": pilot,
        }
        wall = f"{self.outlet}.wall_conductance"
        if wall in self.circuit.numbers():  # it grows with the surface
            values[wall] = numbers[wall] * (volume / numbers[f"{self.outlet}.volume"]) ** (2.0 / 3.0)
        held = {**self.circuit.signals, self.setpoint: Constant(self.asked(self.mean))}
        return replace(self.circuit, signals=held).with_values(values | (changes or {}))


def limits_plan(
    circuit: Circuit, valve: str | None = None, *, mean: Any = None, volumes: Sequence[Any] | None = None,
    amplitudes: Sequence[Any] | None = None, springs: Sequence[float] | None = None,
    dampings: Sequence[float] | None = None,
) -> LimitsPlan:  # fmt: skip
    """Complete what was asked for."""
    name = _valve(circuit, valve)
    outlet = circuit.parts[name].ports()["outlet"]
    if not isinstance(circuit.parts.get(outlet), Chamber):
        raise InputError("limits.no_chamber", f"{name}.outlet", given=outlet)
    bare = LimitsPlan(circuit, name, outlet, math.nan, (), (), (), ())
    low, high = bare.ends
    own = circuit.parameters[f"{outlet}.volume"]
    with Mistakes() as mistakes:
        ambient = circuit.surroundings.pressure
        means = _read(mistakes, "mean", [mean], "Pa", "pressure", ambient) if mean is not None else [0.5 * (low + high)]
        found = _read(mistakes, "volumes", volumes, "m^3", "plain") if volumes else _spread(own / SPREAD, own * SPREAD)
        sizes = (
            _read(mistakes, "amplitudes", amplitudes, "Pa", "difference")
            if amplitudes
            else _spread(SMALLEST * (high - low), LARGEST * (high - low))
        )
        for what, given in (("springs", springs), ("dampings", dampings)):
            for factor in given or ():
                if not factor > 0.0:
                    mistakes.add("limits.factor", what, given=factor)
        if not mistakes.found and not low < means[0] - max(sizes) < means[0] + max(sizes) < high:
            mistakes.add("limits.reach", mean=means[0], amplitude=max(sizes), low=low, high=high)
    return replace(
        bare, mean=means[0], volumes=tuple(sorted(found)), amplitudes=tuple(sorted(sizes)),
        springs=tuple(sorted(springs or SPRINGS)), dampings=tuple(sorted(dampings or DAMPINGS)),
    )  # fmt: skip


def _valve(circuit: Circuit, given: str | None) -> str:
    valves = [name for name, part in circuit.parts.items() if isinstance(part, ProportionalValve)]
    if given in valves:
        return str(given)
    if not valves:
        raise InputError("limits.no_valve")
    if given is not None:
        raise InputError("limits.unknown_valve", given=given, near=Near(given, valves))
    if len(valves) > 1:
        raise InputError("limits.several_valves", known=tuple(valves))
    return valves[0]


def _read(
    mistakes: Mistakes, what: str, given: Sequence[Any], unit: str, kind: Any, ambient: float = 0.0
) -> list[float]:
    result = []
    for each in given:
        with mistakes.kept():
            read = quantity(each, unit, kind=kind, name=what)
            value = read.value + (ambient if read.reference == "gauge" else 0.0)
            if not value > 0.0:
                raise InputError("limits.not_positive", what, given=each)
            result.append(value)
    return result


def _spread(low: float, high: float) -> list[float]:
    """A default range, rounded to two digits: a grid that people can read."""
    return [float(f"{value:.2g}") for value in np.geomspace(low, high, POINTS)]


# Ideal parts -----------------------------------------------------------------------------------------------------


def _scaled(plan: LimitsPlan, names: Sequence[str], factor: float) -> Changes:
    values = plan.circuit.parameters
    return {name: values[name] * factor for name in names}


def _solenoids(plan: LimitsPlan) -> Changes:
    pilot = f"{plan.valve}.pilot"
    return _scaled(plan, [f"{pilot}.{name}.sonic_conductance" for name in ("fill", "vent")], IDEAL)


def _pilot_volume(plan: LimitsPlan) -> Changes:
    return _scaled(plan, [f"{plan.valve}.pilot.volume"], 1.0 / IDEAL)


def _poppet(plan: LimitsPlan) -> Changes:
    """A tenth of the masses; the damping keeps its ratio to the critical one."""
    stage = f"{plan.valve}.main_stage"
    masses = _scaled(plan, [f"{stage}.moving_mass", f"{stage}.emptying_mass"], 1.0 / IDEAL)
    return masses | _scaled(plan, [f"{stage}.damping"], IDEAL**-0.5)


def _conductance(plan: LimitsPlan) -> Changes:
    """Ten times C of both seats, over the whole stroke."""
    stage = f"{plan.valve}.main_stage"
    curve = plan.circuit.parts[plan.valve].members["main_stage"].curve  # type: ignore[attr-defined]
    own = {
        name: replace(number, value=number.value * IDEAL)
        for name, number in curve.numbers().items()
        if name.startswith("sonic_conductance.") and number.unit == "m^3/(s Pa)"
    }
    # All coefficients together: a curve in which some have changed may be none.
    changed: Changes = {f"{stage}.characteristic": curve.with_numbers(own)}
    return changed | _scaled(plan, [f"{stage}.exhaust_seat.sonic_conductance"], IDEAL)


def _sensing(plan: LimitsPlan) -> Changes:
    e = f"{plan.valve}.electronics"
    names = ("outlet_sensor.lag", "pilot_sensor.lag", "outer.sample_time", "inner.sample_time")
    return _scaled(plan, [f"{e}.{name}" for name in names], 1.0 / IDEAL)


PARTS: Mapping[str, Callable[[LimitsPlan], Changes]] = {
    "solenoids": _solenoids,
    "pilot volume": _pilot_volume,
    "poppet": _poppet,
    "sonic conductance": _conductance,
    "sensors and sampling": _sensing,
}
"""Part to what makes it ideal; the load volume, the sixth, is a range of the plan."""
SEVERAL = ("solenoids", "sensors and sampling")
"""Parts whose name is a plural."""
LOAD = "load volume"
CONTROLLER = "controller"
"""What limits where no part does: the loops and their bands."""


def stage_changes(plan: LimitsPlan, spring: float, damping: float) -> Changes:
    """Another spring rate at the same preload forces, another damping."""
    stage = f"{plan.valve}.main_stage"
    springs = [f"{stage}.{name}_spring" for name in ("upper", "lower")]
    changes = _scaled(plan, [f"{name}.rate" for name in springs], spring)
    changes |= _scaled(plan, [f"{name}.preload" for name in springs], 1.0 / spring)
    return changes | _scaled(plan, [f"{stage}.damping"], damping)
