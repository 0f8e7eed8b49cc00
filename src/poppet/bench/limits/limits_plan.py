"""Settings for the dynamic limits of a valve: ranges of parameters, and modified circuits."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from poppet.bench.iso10094.rig import find_valve
from poppet.bench.sine_rig import SineRig, without_bands
from poppet.circuit.circuit import BaseCircuit
from poppet.core.errors import ErrorCollector, InputError
from poppet.core.tables import Field
from poppet.parts.chamber import Chamber
from poppet.parts.electronics import SCALES
from poppet.parts.proportional_valve import ProportionalValve
from poppet.timeseries.signals import Constant

Changes = dict[str, Any]  # mapping from the address of a parameter to its new value
SETTLING = 2.0  # time in which a circuit settles before a sine or step [s]
LOOSE = 1e-6  # relative tolerance of the runs
POINTS = 6  # number of volumes and of amplitudes in the default ranges
SPREAD = 10.0  # default volumes extend from a tenth to ten times the volume in the circuit
SMALLEST, LARGEST = 0.005, 0.25  # default amplitudes, relative to the span of the setpoint
SPRINGS = (0.5, 1.0, 2.0)
DAMPINGS = (0.25, 0.5, 1.0, 2.0, 4.0)  # default factors on spring rates and damping
FIELDS = {
    "mean": Field(unit="Pa", kind="pressure", above=0.0, meaning="mean outlet pressure"),
    "volumes": Field(unit="m^3", above=0.0, meaning="volume"),
    "amplitudes": Field(unit="Pa", kind="pressure_difference", above=0.0, meaning="amplitude"),
    **dict.fromkeys(("springs", "dampings"), Field(unit="1", above=0.0, meaning="factor")),
}
IDEAL = 10.0  # factor on the parameters of a part that is made ideal


@dataclass(frozen=True, eq=False)
class LimitsPlan:
    """Plan for the dynamic limits of a valve: circuit and ranges of its parameters."""

    circuit: BaseCircuit
    valve: str
    outlet: str  # name of the chamber at the outlet of the valve
    mean: float  # mean outlet pressure [Pa]
    volumes: tuple[float, ...]  # volumes of the outlet chamber [m^3]
    amplitudes: tuple[float, ...]  # amplitude of a sine, or half of the height of a step [Pa]
    springs: tuple[float, ...]  # factors on the spring rates, at the same preload forces
    dampings: tuple[float, ...]  # factors on the damping
    lowest: float = 0.1  # lowest frequency of the search for a bandwidth [Hz]
    highest: float = 400.0  # highest frequency of the search for a bandwidth [Hz]

    @property
    def setpoint(self) -> str:
        """Address of the setpoint of the valve."""
        return f"{self.valve}.setpoint"

    @property
    def pressure(self) -> str:
        """Address of the outlet pressure."""
        return f"{self.outlet}.pressure"

    @property
    def per_pascal(self) -> float:
        """Setpoint change, in the unit of the setpoint, per Pa of outlet pressure."""
        _, first, last = SCALES[self._kind]
        low, high = self.ends
        return 1.0 if self._kind == "pressure" else (last - first) / (high - low)

    @property
    def _kind(self) -> str:
        kind: str = self.circuit.parts[self.valve].members["electronics"].setpoint_type  # type: ignore[attr-defined]
        return kind

    @property
    def ends(self) -> tuple[float, float]:
        """Outlet pressures at 0 % and at 100 % of the setpoint range [Pa]."""
        values, path = self.circuit.parameters, f"{self.valve}.electronics.scaling"
        return values[f"{path}.low"], values[f"{path}.high"]

    def setpoint_for(self, pressure: float) -> float:
        """Return the setpoint that requests an outlet pressure [Pa], in the unit of the setpoint."""
        if self._kind == "pressure":
            return pressure
        return SCALES[self._kind][1] + (pressure - self.ends[0]) * self.per_pascal

    def rig(self, volume: float, changes: Changes | None = None, *, bands: bool = True) -> SineRig:
        """Return the circuit, settled at the mean pressure, for runs with sines and steps.

        `volume` is the outlet volume [m^3], and `changes` maps addresses of parameters to new values. If the keyword
        `bands` is False, dead band and hold band are zero, and the pulsed flow of each solenoid is replaced by its
        mean.
        """
        case = self.case(volume, changes)
        instance = (case if bands else without_bands(case)).instance
        return SineRig(instance, self.setpoint, self.pressure, settling=SETTLING, relative_tolerance=LOOSE)

    def case(self, volume: float, changes: Changes | None = None) -> BaseCircuit:
        """Return the circuit at the mean pressure with another outlet volume.

        `volume` is this volume [m^3], and `changes` maps further addresses of parameters to new values.
        """
        numbers = self.circuit.parameters
        electronics = f"{self.valve}.electronics.outer"
        ambient = self.circuit.surroundings.pressure
        # The pilot starts at the pressure that its controller will hold, so the run settles within some samples.
        forward, bias = numbers[f"{electronics}.feed_forward"], numbers[f"{electronics}.bias"]
        values: Changes = {
            f"{self.outlet}.volume": volume,
            f"{self.outlet}.initial_pressure": self.mean,
            f"{self.valve}.pilot.initial_pressure": ambient + forward * (self.mean - ambient) + bias,
        }
        wall = f"{self.outlet}.wall_conductance"
        if wall in self.circuit.numbers():  # proportional to the surface
            values[wall] = numbers[wall] * (volume / numbers[f"{self.outlet}.volume"]) ** (2.0 / 3.0)
        held = {**self.circuit.signals, self.setpoint: Constant(self.setpoint_for(self.mean))}
        return replace(self.circuit, signals=held).with_values(values | (changes or {}))


def limits_plan(
    circuit: BaseCircuit, valve: str | None = None, *, mean: Any = None, volumes: Sequence[Any] | None = None,
    amplitudes: Sequence[Any] | None = None, springs: Sequence[float] | None = None,
    dampings: Sequence[float] | None = None,
) -> LimitsPlan:  # fmt: skip
    """Return a plan for the dynamic limits of a valve in a circuit.

    Defaults replace the settings that are None. The keywords `springs` and `dampings` are factors on spring rates and
    damping.
    """
    name = find_valve(circuit, valve, ProportionalValve)
    outlet = circuit.parts[name].ports()["outlet"]
    if not isinstance(circuit.parts.get(outlet), Chamber):
        raise InputError("limits.no_chamber", f"{name}.outlet", given=outlet)
    bare = LimitsPlan(circuit, name, outlet, math.nan, (), (), (), ())
    low, high = bare.ends
    volume = circuit.parameters[f"{outlet}.volume"]
    values: dict[str, list[float]] = {
        "mean": [0.5 * (low + high)],
        "volumes": _geometric_values(volume / SPREAD, volume * SPREAD),
        "amplitudes": _geometric_values(SMALLEST * (high - low), LARGEST * (high - low)),
        "springs": list(SPRINGS),
        "dampings": list(DAMPINGS),
    }
    settings = zip(values, ([mean] if mean is not None else (), volumes, amplitudes, springs, dampings), strict=True)
    with ErrorCollector() as errors:
        for key, arguments in [(key, arguments) for key, arguments in settings if arguments]:
            values[key] = []
            for argument in arguments:
                with errors.collecting():
                    values[key].append(FIELDS[key].read(argument, key, circuit.surroundings.pressure))
        (mean_pressure,), largest = values["mean"] or [math.nan], max(values["amplitudes"], default=math.nan)
        if not errors.collected and not low < mean_pressure - largest < mean_pressure + largest < high:
            errors.add("limits.reach", mean=mean_pressure, amplitude=largest, low=low, high=high)
    ranges = {key: tuple(sorted(values[key])) for key in ("volumes", "amplitudes", "springs", "dampings")}
    return replace(
        bare, mean=mean_pressure, volumes=ranges["volumes"], amplitudes=ranges["amplitudes"],
        springs=ranges["springs"], dampings=ranges["dampings"],
    )  # fmt: skip


def _geometric_values(low: float, high: float) -> list[float]:
    """Return six values in a geometric sequence between two limits, rounded to two digits."""
    return [float(f"{value:.2g}") for value in np.geomspace(low, high, POINTS)]


# Ideal parts -----------------------------------------------------------------------------------------------------


_SOLENOIDS = ("pilot.fill.sonic_conductance", "pilot.vent.sonic_conductance")
_LAGS = ("outlet_sensor.lag", "pilot_sensor.lag", "outer.sample_time", "inner.sample_time")
_MASSES = ("main_stage.moving_mass", "main_stage.emptying_mass")
PARTS: Mapping[str, Mapping[str, float]] = {
    "solenoids": dict.fromkeys(_SOLENOIDS, IDEAL),
    "pilot volume": {"pilot.volume": 1.0 / IDEAL},
    # A tenth of the masses. The damping ratio stays equal, because critical damping is proportional to their root.
    "poppet": {**dict.fromkeys(_MASSES, 1.0 / IDEAL), "main_stage.damping": IDEAL**-0.5},
    "sonic conductance": {"main_stage.exhaust_seat.sonic_conductance": IDEAL},
    "sensors and sampling": dict.fromkeys((f"electronics.{name}" for name in _LAGS), 1.0 / IDEAL),
}
"""Mapping from each part to the factors on its parameters that make it nearly ideal.

The load volume is the sixth candidate. It is absent here, because the plan varies it as a range.
"""
SEVERAL = ("solenoids", "sensors and sampling")  # parts whose name is a plural
LOAD = "load volume"
CONTROLLER = "controller"  # limiting part if no other part limits: the control loops and their bands


def ideal_part_changes(plan: LimitsPlan, part: str) -> Changes:
    """Return parameter values with which one part of the valve is nearly ideal.

    The parameters that slow this part down are improved by a factor of ten. The result maps addresses to values. For
    the sonic conductance, it includes the characteristic of the supply seat over the whole stroke.
    """
    changes = _scaled_parameters(plan, PARTS[part])
    if part == "sonic conductance":
        curve = plan.circuit.parts[plan.valve].members["main_stage"].curve  # type: ignore[attr-defined]
        own = {
            name: replace(number, value=number.value * IDEAL)
            for name, number in curve.numbers().items()
            if name.startswith("sonic_conductance.") and number.unit == "m^3/(s Pa)"
        }
        # All coefficients change together, because a curve with some changed coefficients can be invalid.
        changes[f"{plan.valve}.main_stage.characteristic"] = curve.with_numbers(own)
    return changes


def spring_and_damping_changes(plan: LimitsPlan, spring: float, damping: float) -> Changes:
    """Return parameter values for other spring rates and another damping.

    `spring` and `damping` are factors on the present values. The result maps addresses to values. The preload forces of
    the springs stay equal.
    """
    factors = {"damping": damping}
    for name in ("upper_spring", "lower_spring"):
        factors |= {f"{name}.rate": spring, f"{name}.preload": 1.0 / spring}
    return _scaled_parameters(plan, {f"main_stage.{name}": factor for name, factor in factors.items()})


def _scaled_parameters(plan: LimitsPlan, factors: Mapping[str, float]) -> Changes:
    """Return the values of some valve parameters, multiplied by factors.

    `factors` maps addresses within the valve to factors. The result maps complete addresses to values.
    """
    values, own = plan.circuit.parameters, f"{plan.valve}."
    return {own + name: values[own + name] * factor for name, factor in factors.items()}
