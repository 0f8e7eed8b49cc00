"""What an engineer asks first of a run with loads: stroke time, end-stop speed, air used, work, efficiency."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from poppet.circuit.instance import Array, Instance
from poppet.core.units import ANR
from poppet.engine.model import FlowInfo, StoreInfo
from poppet.engine.problem import RawRun
from poppet.laws.physics.gas import AIR_GAS_CONSTANT
from poppet.laws.physics.heat_transfer import GRAVITY
from poppet.parts.part import AMBIENT, Surroundings

TURNED = 0.2
"""Part of the whole travel by which a body must come back before a new stroke has begun."""
LEFT, REACHED = 0.02, 0.98
"""Parts of a stroke at which its time begins and ends."""
NONE = 1e-9
"""Travels below this are no stroke [m] or [rad]."""


@dataclass(frozen=True)
class Stroke:
    """A motion of a body from one turning point to the next."""

    body: str
    unit: str  # of the travel
    start: float  # time at which 2 % of the travel are passed [s]
    duration: float  # from there to 98 % [s]
    travel: float  # with its sign
    mean_speed: float  # 96 % of the travel over the duration
    peak_speed: float


@dataclass(frozen=True)
class Arrival:
    """An end stop that is met at more than 10 mm/s or 10 mrad/s."""

    part: str  # the cylinder or body with the stop
    body: str
    time: float  # [s]
    velocity: float  # its sign says at which end
    unit: str


@dataclass(frozen=True)
class Work:
    """Energy of a body over a run [J]: done - returned = on_load + lost + what its kinetic energy has gained."""

    body: str
    done: float  # by its actuators, in the strokes in which they drive it
    returned: float  # to its actuators, in the strokes in which it drives them
    on_load: float  # against weight and load, less what these gave back
    lost: float  # in friction and end stops, those of its cylinders among them


@dataclass(frozen=True)
class Figures:
    """Figures of a run, SI.

    Parameters
    ----------
    strokes : tuple of Stroke
        From turning point to turning point: a new stroke begins where a body has come back by more than 20 % of its
        whole travel, so that rebounds and stick-slip do not part one.
    arrivals : tuple of Arrival
        End stops that were met.
    works : tuple of Work
        One for each body.
    air : mapping
        Reservoir to the air that it gave, less what it took back, as volume at ANR [m^3].
    exergy : float
        Work that the air of all reservoirs could have done down to the ambient state [J].
    stored : float
        What all volumes hold more of it at the end than at the start [J]; NaN where one of them shows no state.

    Notes
    -----
    The flow exergy of an ideal gas, e = c_p (T - T_a) - T_a (c_p ln(T/T_a) - R ln(p/p_a)), is that of compressed air
    without its preparation; with supply at ambient temperature it is R T_a ln(p/p_a). A run that ends with full
    chambers has paid for air that is still there (`stored`): compare whole cycles. Masses of air are integrals of the
    integrator and do not depend on rows, nor does the work on a constant load; the work of actuators is one where no
    end stop is met. All else is summed up over rows.

    References
    ----------
    ISO 8778 for the reference atmosphere, whose air has 1.185 kg/m^3; Cai, Kawashima & Kagawa 2002, Power assessment
    of flowing compressed air, for the exergy ("available energy") of air.
    """

    strokes: tuple[Stroke, ...]
    arrivals: tuple[Arrival, ...]
    works: tuple[Work, ...]
    air: Mapping[str, float]
    exergy: float
    stored: float

    @property
    def air_used(self) -> float:
        """Air that all reservoirs above ambient pressure gave [m^3 ANR]."""
        return sum(self.air.values())

    @property
    def work(self) -> float:
        """Work that all actuators did on their bodies [J]."""
        return sum(work.done for work in self.works)

    @property
    def efficiency(self) -> float:
        """Work over the exergy of the air; NaN where no exergy was drawn."""
        return self.work / self.exergy if self.exergy > 0.0 else math.nan

    def met(self, stroke: Stroke) -> Arrival | None:
        """The hardest arrival at an end stop at the end of a stroke, before the next one of its body.

        Parameters
        ----------
        stroke : Stroke
            One of `strokes`.

        Returns
        -------
        Arrival or None
        """
        later = (s.start for s in self.strokes if s.body == stroke.body and s.start > stroke.start)
        end = min(later, default=math.inf)
        met = [a for a in self.arrivals if a.body == stroke.body and stroke.start <= a.time < end]
        return max(met, key=lambda each: abs(each.velocity), default=None)

    def as_dict(self) -> dict[str, Any]:
        """All figures as plain tables, lists and numbers, for JSON.

        Returns
        -------
        dict
            Fields under their names, with `air_used`, `work` and `efficiency`; what is not a number is None.
        """
        found = asdict(self) | {name: getattr(self, name) for name in ("air_used", "work", "efficiency")}
        return {k: None if isinstance(v, float) and math.isnan(v) else v for k, v in found.items()}


@dataclass(frozen=True)
class Facts:
    """What figures need of a run, in plain data."""

    raw: RawRun
    names: tuple[tuple[str, str], ...]  # outputs with their units
    flows: tuple[FlowInfo, ...]
    stores: tuple[StoreInfo, ...]
    bodies: tuple[tuple[str, tuple[int, ...]], ...]
    parameters: Mapping[str, float]
    surroundings: Surroundings
    holders: Mapping[str, str]  # cylinder to its body

    @classmethod
    def of(cls, instance: Instance, raw: RawRun) -> Facts:
        """Of a run of an instance."""
        m, air = instance.model, instance.surroundings
        return cls(raw, m.outputs, m.flows, m.stores, m.bodies, instance.parameters, air, instance.holders)

    def __getitem__(self, address: str) -> Array:
        """Rows of an output; the open air has its state as well."""
        for k, (name, _) in enumerate(self.names):
            if name == address:
                row: Array = self.raw.values[k]
                return row
        owner, _, quantity = address.rpartition(".")
        assert owner == AMBIENT, address
        return np.full(self.raw.time.size, getattr(self.surroundings, quantity))

    def unit(self, address: str) -> str:
        """Unit of an output, empty where there is none of that name."""
        return dict(self.names).get(address, "")

    def stops(self) -> Iterator[tuple[str, str, str]]:
        """Outputs of end stops with the owner, and what the names of a piston's motion begin with."""
        known = dict(self.names)
        for name in known:
            owner, _, local = name.rpartition(".")
            if local in ("stop_force", "stop_torque"):
                yield name, owner, "piston_" if f"{owner}.piston_position" in known else ""


def figures_of(facts: Facts) -> Figures | None:
    """Figures of a run; None where it has no two rows."""
    if facts.raw.time.size < 2:
        return None
    bodies = [name for name, _ in facts.bodies]
    gave = dict(_given(facts))
    return Figures(
        tuple(stroke for name in bodies for stroke in _strokes(facts, name)),
        tuple(_arrivals(facts)),
        tuple(_work(facts, *each) for each in facts.bodies),
        {name: mass / _density(facts.surroundings) for name, (mass, _, pressure) in gave.items() if pressure > 1.0},
        sum(exergy for _, exergy, _ in gave.values()),
        _stored(facts),
    )


def _density(air: Surroundings) -> float:
    """Of the gas at ANR; that of air is the one of the standard, which is moist."""
    return float(ANR.density * AIR_GAS_CONSTANT / air.gas_constant)


# Motion ----------------------------------------------------------------------------------------------------------


def _strokes(facts: Facts, body: str) -> Iterator[Stroke]:
    time, position, speed = facts.raw.time, facts[f"{body}.position"], np.abs(facts[f"{body}.velocity"])
    unit = facts.unit(f"{body}.position")
    turns = turning_points(position)
    for first, last in pairwise(turns):
        travel = float(position[last] - position[first])
        way = (position[first : last + 1] - position[first]) / travel
        # The last time that it leaves and the first time that it arrives.
        arrived = int(np.argmax(way >= REACHED))
        left = int(np.flatnonzero(way[: arrived + 1] <= LEFT)[-1])
        rows = time[first : last + 1]
        start, end = (_crossing(rows, way, k, level) for k, level in ((left, LEFT), (arrived - 1, REACHED)))
        peak = float(speed[first : last + 1].max())
        mean = (REACHED - LEFT) * abs(travel) / (end - start)
        yield Stroke(body, unit, start, end - start, travel, mean, peak)


def _crossing(time: Array, way: Array, k: int, level: float) -> float:
    """When a level is passed behind row k."""
    step = way[k + 1] - way[k]
    return float(time[k] + (time[k + 1] - time[k]) * (level - way[k]) / step)


def turning_points(position: Array) -> list[int]:
    """Rows at which a body turns, and its first and last; comings back of less than a fifth of its travel are none.

    Examples
    --------
    >>> turning_points(np.array([0.0, 0.5, 0.45, 1.0, 0.9, 1.0, 0.0]))
    [0, 3, 6]
    """
    least = TURNED * float(np.ptp(position))
    if least < TURNED * NONE:
        return []
    turns, extreme, way = [0], 0, 0.0
    for k in range(1, position.size):
        if (position[k] - position[extreme]) * way > 0.0 or (way == 0.0 and position[k] != position[extreme]):
            if way == 0.0 and abs(position[k] - position[0]) < least:
                continue
            way, extreme = float(np.sign(position[k] - position[extreme])), k
        elif abs(position[k] - position[extreme]) >= least:
            turns.append(extreme)
            way, extreme = -way, k
    return [*turns, extreme] if extreme != turns[-1] else turns


def _arrivals(facts: Facts) -> Iterator[Arrival]:
    from poppet.parts.bodies import find_impacts  # which runs without bodies do not need

    for name, owner, kind in facts.stops():
        stops = tuple(facts.parameters.get(f"{owner}.{end}_stop.position", math.nan) for end in ("lower", "upper"))
        if kind:
            stops = 0.0, facts.parameters[f"{owner}.piston.stroke_length"]
        position, velocity = facts[f"{owner}.{kind}position"], facts[f"{owner}.{kind}velocity"]
        unit = facts.unit(f"{owner}.{kind}velocity")
        for time, speed in find_impacts(facts.raw.time, position, velocity, facts[name], stops):
            yield Arrival(owner, facts.holders.get(owner, owner), time, speed, unit)


# Energy ----------------------------------------------------------------------------------------------------------


def _work(facts: Facts, body: str, places: tuple[int, ...]) -> Work:
    position, velocity, time = facts[f"{body}.position"], facts[f"{body}.velocity"], facts.raw.time
    effort, inertia = ("force", "mass") if facts.unit(f"{body}.load_force") else ("torque", "inertia")
    amount = facts.parameters[f"{body}.{inertia}"]
    weight = amount * GRAVITY * math.sin(facts.parameters.get(f"{body}.inclination", 0.0))
    on_load = _integral(facts[f"{body}.load_{effort}"], position) + weight * float(position[-1] - position[0])
    power, is_free = facts[f"{body}.actuator_{effort}"] * velocity, True
    for name, owner, kind in facts.stops():
        # A cylinder pushes its body with its covers too, which is no work of the air.
        if kind and facts.holders.get(owner) == body:
            power, is_free = power - facts[name] * facts[f"{owner}.{kind}velocity"], is_free and not facts[name].any()
    turns = turning_points(position) or [0, time.size - 1]
    parts = [float(np.trapezoid(power[a : b + 1], time[a : b + 1])) for a, b in pairwise(turns)]
    if turns[-1] < time.size - 1:
        parts[-1] += float(np.trapezoid(power[turns[-1] :], time[turns[-1] :]))
    if is_free:  # the integrator has the sum
        parts[int(np.argmax(np.abs(parts)))] += float(facts.raw.x[places[0]]) + on_load - sum(parts)
    gained = 0.5 * amount * float(velocity[-1] ** 2 - velocity[0] ** 2)
    done, returned = (sum(max(sign * part, 0.0) for part in parts) for sign in (1.0, -1.0))
    return Work(body, done, returned, on_load, done - returned - on_load - gained)


def _integral(value: Array, over: Array) -> float:
    """Of a series over another: one that mostly rests holds from its row to the next, others are straight between."""
    steps = np.diff(over)
    is_staircase = np.count_nonzero(np.diff(value)) < 0.1 * value.size
    return float(np.sum((value[:-1] if is_staircase else 0.5 * (value[:-1] + value[1:])) * steps))


def _given(facts: Facts) -> Iterator[tuple[str, tuple[float, float, float]]]:
    """Reservoir to the mass [kg] and exergy [J] that it gave, and its mean pressure over the ambient one."""
    inside, air = {store.name for store in facts.stores}, facts.surroundings
    ends = dict.fromkeys(end for flow in facts.flows for end in (flow.source, flow.target) if end is not None)
    for name in ends:
        if name in inside:
            continue
        pressure, temperature = facts[f"{name}.pressure"], facts[f"{name}.temperature"]
        specific = flow_exergy(pressure, temperature, air)
        mass = exergy = 0.0
        for flow in facts.flows:
            sign = (flow.source == name) - (flow.target == name)
            given = sign * float(facts.raw.x[flow.mass])
            mass += given
            if sign and np.ptp(specific) > 0.0 and facts.unit(flow.name):
                exergy += sign * float(np.trapezoid(facts[flow.name] * specific, facts.raw.time))
            else:
                exergy += given * float(specific.mean())
        yield name, (mass, exergy, float(pressure.mean()) / air.pressure)


def flow_exergy(pressure: Any, temperature: Any, air: Surroundings) -> Any:
    """Work that flowing gas can do down to the ambient state [J/kg]."""
    heat, ratio = air.heat_capacity_pressure, temperature / air.temperature
    entropy = heat * np.log(ratio) - air.gas_constant * np.log(pressure / air.pressure)
    return heat * (temperature - air.temperature) - air.temperature * entropy


def _stored(facts: Facts) -> float:
    """What the volumes hold more of exergy at the end than at the start [J]."""
    air, total = facts.surroundings, 0.0
    for store in facts.stores:
        if not all(facts.unit(f"{store.name}.{each}") for each in ("pressure", "temperature", "mass")):
            return math.nan
        p, t, m = (facts[f"{store.name}.{each}"][[0, -1]] for each in ("pressure", "temperature", "mass"))
        # Of closed gas: flow exergy less the work of displacing the surroundings, (p - p_a) V.
        held = m * flow_exergy(p, t, air) - (p - air.pressure) * m * air.gas_constant * t / p
        total += float(held[1] - held[0])
    return total
