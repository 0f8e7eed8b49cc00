"""What is looked at for the dynamic limits of a valve: ranges, and circuits with changed parts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.ground.errors import InputError, collect, suggestion
from poppet.ground.units import quantity
from poppet.parts.chamber import Chamber
from poppet.parts.electronics import SCALES
from poppet.parts.proportional_valve import ProportionalValve
from poppet.series.signals import Constant

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

VOLUMES, AMPLITUDES = 6, 6
"""Points of the default ranges."""
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
    """A valve in its circuit and the ranges over which its limits are looked for.

    Parameters
    ----------
    circuit : Circuit
        Of the valve, its load and its supply.
    valve, outlet : str
        Names of the valve and of the chamber at its outlet.
    mean : float
        Outlet pressure about which it works [Pa].
    volumes : tuple of float
        Of the outlet chamber [m^3].
    amplitudes : tuple of float
        Of the sine and of the half step [Pa].
    springs, dampings : tuple of float
        Factors on spring rates (at the same preload forces) and on the damping.
    lowest, highest : float
        Frequencies between which a bandwidth is looked for [Hz].
    """

    circuit: Circuit
    valve: str
    outlet: str
    mean: float
    volumes: tuple[float, ...]
    amplitudes: tuple[float, ...]
    springs: tuple[float, ...]
    dampings: tuple[float, ...]
    lowest: float = 0.1
    highest: float = 400.0

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
        _, first, last = self._scale
        low, high = self._ends
        return 1.0 if self._kind == "pressure" else (last - first) / (high - low)

    @property
    def _kind(self) -> str:
        kind: str = self.circuit.parts[self.valve].members["electronics"].setpoint_type  # type: ignore[attr-defined]
        return kind

    @property
    def _scale(self) -> tuple[str, float, float]:
        return SCALES[self._kind]

    @property
    def _ends(self) -> tuple[float, float]:
        """Pressures at 0 % and 100 % of the setpoint."""
        values = self.circuit.parameters
        path = f"{self.valve}.electronics.scaling"
        return values[f"{path}.low"], values[f"{path}.high"]

    def asked(self, pressure: float) -> float:
        """Setpoint for a pressure."""
        if self._kind == "pressure":
            return pressure
        return self._scale[1] + (pressure - self._ends[0]) * self.per_pascal

    def case(self, volume: float, changes: Mapping[str, Any] | None = None) -> Circuit:
        """The circuit at the mean pressure with another outlet volume."""
        numbers = self.circuit.parameters
        electronics = f"{self.valve}.electronics.outer"
        forward = numbers[f"{electronics}.feed_forward"]
        ambient = self.circuit.surroundings.pressure
        values: dict[str, Any] = {
            f"{self.outlet}.volume": volume,
            f"{self.outlet}.initial_pressure": self.mean,
            f"{self.valve}.pilot.initial_pressure": ambient + forward * (self.mean - ambient)
            + numbers[f"{electronics}.bias"],
        }  # fmt: skip
        wall = f"{self.outlet}.wall_conductance"
        if wall in self.circuit.numbers():
            values[wall] = numbers[wall] * (volume / numbers[f"{self.outlet}.volume"]) ** (2.0 / 3.0)
        held = {**self.circuit.signals, self.setpoint: Constant(self.asked(self.mean))}
        return replace(self.circuit, signals=held).with_values(values | dict(changes or {}))


def limits_plan(
    circuit: Circuit, valve: str | None = None, *, mean: Any = None, volumes: Sequence[Any] | None = None,
    amplitudes: Sequence[Any] | None = None, springs: Sequence[float] | None = None,
    dampings: Sequence[float] | None = None,
) -> LimitsPlan:  # fmt: skip
    """Complete what was asked for."""
    name = _valve(circuit, valve)
    outlet = circuit.parts[name].ports()["outlet"]
    if not isinstance(circuit.parts.get(outlet), Chamber):
        raise InputError(
            f"{name}.outlet = {outlet!r}", "is no chamber: a volume is what the limits are looked for over.",
            "Join the valve to a chamber.", address=f"{name}.outlet",
        )  # fmt: skip
    values = circuit.parameters
    low, high = (values[f"{name}.electronics.scaling.{end}"] for end in ("low", "high"))
    problems: list[InputError] = []
    ambient = circuit.surroundings.pressure
    middle = _read(problems, "mean", [mean], "Pa", "pressure", ambient)[0] if mean is not None else 0.5 * (low + high)
    own = values[f"{outlet}.volume"]
    default = np.geomspace(own / SPREAD, own * SPREAD, VOLUMES)
    found = _read(problems, "volumes", volumes, "m^3", "plain") if volumes else [_rounded(v) for v in default]
    smallest, largest = SMALLEST * (high - low), LARGEST * (high - low)
    sizes = (
        _read(problems, "amplitudes", amplitudes, "Pa", "difference")
        if amplitudes
        else [_rounded(a) for a in np.geomspace(smallest, largest, AMPLITUDES)]
    )
    for what, given in (("springs", springs), ("dampings", dampings)):
        problems += [
            InputError(f"{what} = {factor}", "is no positive factor.", "Write 0.5, 1, 2.")
            for factor in given or ()
            if not factor > 0.0
        ]
    if not problems and not low < middle - max(sizes) < middle + max(sizes) < high:
        problems.append(
            InputError(
                f"mean = {middle:g} Pa, amplitudes up to {max(sizes):g} Pa",
                f"reach beyond the setpoint's range {low:g} ... {high:g} Pa.", "Lower them.",
            )
        )  # fmt: skip
    collect(problems)
    factors = tuple(sorted(springs or SPRINGS)), tuple(sorted(dampings or DAMPINGS))
    return LimitsPlan(circuit, name, outlet, middle, tuple(sorted(found)), tuple(sorted(sizes)), *factors)


def _valve(circuit: Circuit, given: str | None) -> str:
    valves = [name for name, part in circuit.parts.items() if isinstance(part, ProportionalValve)]
    if given in valves:
        return str(given)
    if given is None and len(valves) == 1:
        return valves[0]
    if not valves:
        raise InputError("the circuit", "has no proportional_valve.", 'Add a part of kind = "proportional_valve".')
    reason = "is no proportional_valve of this circuit." if given else "does not say which of several valves is meant."
    raise InputError(f"valve = {given!r}", reason, suggestion(given or "", valves))


def _read(
    problems: list[InputError], what: str, given: Sequence[Any], unit: str, kind: Any, ambient: float = 0.0
) -> list[float]:
    result = []
    for each in given:
        try:
            read = quantity(each, unit, kind=kind, name=what)
            value = read.value + (ambient if read.reference == "gauge" else 0.0)
            if not value > 0.0:
                raise InputError(f"{what} = {each}", "is not above zero.", "Correct it.")
            result.append(value)
        except InputError as error:
            problems.append(error)
    return result or [1.0]


def _rounded(value: float) -> float:
    """Two digits: a grid that people can read."""
    return float(f"{value:.2g}")


# Ideal parts -----------------------------------------------------------------------------------------------------

Changes = dict[str, Any]


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
