"""Metrics of a run with moved bodies: stroke time, impact speed, air consumption, work, efficiency."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
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
from poppet.timeseries.segments import Signal
from poppet.timeseries.signals import Pwm

TURNED = 0.2
"""Fraction of the travel since the last standstill by which a moving body must return before a new stroke begins."""
MIN_STROKE = 0.02
"""Fraction of the whole travel of a run below which a motion is not a stroke."""
STANDSTILL = 0.05
"""Fraction of the peak speed of a motion below which a body stands still."""
LONG_REST = 2.0
"""Multiple of the time of the next motion that a standstill without a change of an input must exceed.

A return by more than 20 % of the whole travel, or without any change of an input, needs a standstill of its own time.
"""
STROKE_START, STROKE_END = 0.02, 0.98
"""Fractions of the travel at which the measurement of the stroke time begins and ends."""
MIN_TRAVEL = 1e-9
"""Smallest range of motion in which strokes are detected [m] or [rad]."""


@dataclass(frozen=True)
class BodyStroke:
    """One stroke of a body: its motion from one standstill or turning point to the next."""

    body: str
    unit: str  # of the travel
    start: float  # time at 2 % of the travel [s]
    duration: float  # time from 2 % to 98 % of the travel [s]
    travel: float  # with its sign
    mean_speed: float  # 96 % of the travel divided by the duration
    peak_speed: float
    # The command that caused the stroke; None if no command changed between the previous stroke and this one.
    command: str | None = None  # address of the input
    command_time: float | None = None  # time of its change [s]
    from_command: float | None = None  # time from this change to 98 % of the travel [s]


@dataclass(frozen=True)
class StrokeArrival:
    """Impact on an end stop at more than 10 mm/s or 10 mrad/s."""

    part: str  # the cylinder or body with the stop
    body: str
    time: float  # [s]
    velocity: float  # the sign identifies the end
    unit: str


@dataclass(frozen=True)
class BodyWork:
    """Energy balance of a body over a run [J].

    The net work of the actuators, `done - returned`, equals `on_load + lost` plus the increase in kinetic energy.
    """

    body: str
    done: float  # by the actuators, in strokes in which they drive the body
    returned: float  # to the actuators, in strokes in which the body drives them
    on_load: float  # net work against weight and load
    lost: float  # in friction and end stops, including those of its cylinders


@dataclass(frozen=True)
class LoadMetrics:
    """Metrics of a run with moved bodies, SI.

    Parameters
    ----------
    strokes : tuple of BodyStroke
        Motions from a standstill or turning point to the next, as `find_strokes` defines them. Overshoots, rebounds
        and stick-slip do not divide a stroke: without a standstill, the body must return by more than 20 % of its
        travel.
    arrivals : tuple of StrokeArrival
        Impacts on end stops.
    works : tuple of BodyWork
        One element per body.
    air : mapping
        Mapping from reservoir to net air consumption, as volume at ANR [m^3].
    exergy : float
        Maximum work that the consumed air could do until it reaches the ambient state [J].
    stored : float
        Increase in exergy of all volumes [J]; NaN if the state of a volume is not an output.

    Notes
    -----
    The exergy is the flow exergy of an ideal gas, e = c_p (T - T_a) - T_a (c_p ln(T/T_a) - R ln(p/p_a)). It excludes
    the preparation of the compressed air. With a supply at ambient temperature, it is R T_a ln(p/p_a). Compare complete
    cycles: a run that ends with full chambers has consumed air that is still available (`stored`).

    The integrator computes masses of air, the work on a constant load, and the work of actuators without contact with
    an end stop. All other values are sums over the output rows, so they depend on the output step.

    References
    ----------
    ISO 8778 for the reference atmosphere, whose air has 1.185 kg/m^3; Cai, Kawashima & Kagawa 2002, Power assessment
    of flowing compressed air, for the exergy ("available energy") of air.
    """

    strokes: tuple[BodyStroke, ...]
    arrivals: tuple[StrokeArrival, ...]
    works: tuple[BodyWork, ...]
    air: Mapping[str, float]
    exergy: float
    stored: float

    @property
    def air_used(self) -> float:
        """Air consumption from all reservoirs above ambient pressure [m^3 ANR]."""
        return sum(self.air.values())

    @property
    def work(self) -> float:
        """Work of all actuators on their bodies [J]."""
        return sum(work.done for work in self.works)

    @property
    def efficiency(self) -> float:
        """Work on the bodies, divided by the exergy of the consumed air.

        The result is NaN if the exergy is not positive.
        """
        return self.work / self.exergy if self.exergy > 0.0 else math.nan

    def met(self, stroke: BodyStroke) -> StrokeArrival | None:
        """Return the fastest impact on an end stop during a stroke.

        The result is None if there is no impact before the next stroke of the body.

        Parameters
        ----------
        stroke : BodyStroke
            Element of `strokes`.

        Returns
        -------
        StrokeArrival or None
        """
        later = (s.start for s in self.strokes if s.body == stroke.body and s.start > stroke.start)
        end = min(later, default=math.inf)
        met = [a for a in self.arrivals if a.body == stroke.body and stroke.start <= a.time < end]
        return max(met, key=lambda arrival: abs(arrival.velocity), default=None)

    def as_dict(self) -> dict[str, Any]:
        """Return all metrics as a dictionary that can be written as JSON.

        Returns
        -------
        dict
            All fields, and the properties `air_used`, `work` and `efficiency`. NaN is replaced by None.
        """
        values = asdict(self) | {name: getattr(self, name) for name in ("air_used", "work", "efficiency")}
        return {k: None if isinstance(v, float) and math.isnan(v) else v for k, v in values.items()}


@dataclass(frozen=True)
class LoadData:
    """Outputs and model properties of a run that are needed for its load metrics."""

    raw: RawRun
    outputs: tuple[tuple[str, str], ...]  # names and units
    flows: tuple[FlowInfo, ...]
    stores: tuple[StoreInfo, ...]
    bodies: tuple[tuple[str, tuple[int, ...]], ...]
    parameters: Mapping[str, float]
    surroundings: Surroundings
    body_of: Mapping[str, str]  # actuator to its body
    drives: Mapping[str, Mapping[str, bool]]  # body to the inputs that can move it; True for commands
    signals: Mapping[str, Signal]

    @classmethod
    def of(cls, instance: Instance, raw: RawRun) -> LoadData:
        """Return the load data of a run.

        `raw` contains the result arrays of the run.
        """
        m, air, parameters = instance.model, instance.surroundings, instance.parameters
        drives, signals = instance.circuit.drives(), dict(instance.signals)
        return cls(raw, m.outputs, m.flows, m.stores, m.bodies, parameters, air, instance.bodies, drives, signals)

    def __getitem__(self, address: str) -> Array:
        """Return the values of an output at all output times.

        `address` can also identify an ambient condition, which is constant.
        """
        for k, (name, _) in enumerate(self.outputs):
            if name == address:
                row: Array = self.raw.values[k]
                return row
        owner, _, quantity = address.rpartition(".")
        assert owner == AMBIENT, address
        return np.full(self.raw.time.size, getattr(self.surroundings, quantity))

    def unit(self, address: str) -> str:
        """Return the unit of the output with a given address.

        The text is empty if there is no such output.
        """
        return dict(self.outputs).get(address, "")

    def input_changes(self, body: str) -> list[tuple[float, str | None]]:
        """Return the times at which the inputs of a body jump or begin to change [s].

        Each element is a time and the address of the input; the address is None unless the input is a command. A value
        at t = 0 is part of the initial state. Pulses and sines have no such times.
        """
        end = float(self.raw.time[-1])
        changes: list[tuple[float, str | None]] = []
        resets: list[tuple[float, str | None]] = []
        for address, is_command in self.drives.get(body, {}).items():
            if address not in self.signals:  # the output of a sequence or a switch, known at the output times
                jumps = np.diff(self[address])
                changes += [(float(self.raw.time[k + 1]), address) for k in np.flatnonzero(jumps > 0.0)]
                resets += [(float(self.raw.time[k + 1]), address) for k in np.flatnonzero(jumps < 0.0)]
                continue
            table = self.signals[address].table(end)
            if isinstance(self.signals[address], Pwm) or table.amplitude.any():
                continue
            begins = (table.slope[1:] != 0.0) & (table.slope[:-1] == 0.0)
            moments = table.start[1:][table.jump[1:] | begins]
            changes += [(float(moment), address if is_command else None) for moment in moments]
        # The sort is stable: of two commands that change at once, the one that is set comes first.
        return sorted([*changes, *resets], key=lambda change: change[0])

    def stops(self) -> Iterator[tuple[str, str, str]]:
        """Yield the output name of each end-stop force, with its part and a prefix.

        The prefix is `piston_` if the part has the outputs `piston_position` and `piston_velocity`. Otherwise it is
        empty, and the outputs are `position` and `velocity`.
        """
        names = dict(self.outputs)
        for name in names:
            owner, _, local = name.rpartition(".")
            if local in ("stop_force", "stop_torque"):
                yield name, owner, "piston_" if f"{owner}.piston_position" in names else ""


def load_metrics(run: LoadData) -> LoadMetrics | None:
    """Return the load metrics of a run.

    The result is None if the run has fewer than two rows (output times).
    """
    if run.raw.time.size < 2:
        return None
    from poppet.parts.bodies import find_impacts  # only runs with bodies need it

    arrivals = []
    for name, owner, prefix in run.stops():
        stops = tuple(run.parameters.get(f"{owner}.{end}_stop.position", math.nan) for end in ("lower", "upper"))
        if prefix:
            stops = 0.0, run.parameters[f"{owner}.piston.stroke_length"]
        position, velocity = run[f"{owner}.{prefix}position"], run[f"{owner}.{prefix}velocity"]
        unit = run.unit(f"{owner}.{prefix}velocity")
        for time, speed in find_impacts(run.raw.time, position, velocity, run[name], stops):
            arrivals.append(StrokeArrival(owner, run.body_of.get(owner, owner), time, speed, unit))
    strokes: list[BodyStroke] = []
    works = []
    for body, integrals in run.bodies:
        changes, motion = run.input_changes(body), (run[f"{body}.position"], np.abs(run[f"{body}.velocity"]))
        rows = find_strokes(run.raw.time, *motion, [change for change, _ in changes])
        strokes += _strokes(run, body, rows, changes)
        works.append(_work(run, body, integrals, [first for first, _ in rows]))
    return LoadMetrics(tuple(strokes), tuple(arrivals), tuple(works), *_air_and_exergy(run))


# Motion ----------------------------------------------------------------------------------------------------------


def _strokes(
    run: LoadData, body: str, rows: Sequence[tuple[int, int]], changes: Sequence[tuple[float, str | None]]
) -> Iterator[BodyStroke]:
    """Yield the strokes of a body, each with the command that caused it.

    `rows` contains the first and last output row of each stroke. `changes` is the result of `LoadData.input_changes`.
    """
    time, position, speed = run.raw.time, run[f"{body}.position"], np.abs(run[f"{body}.velocity"])
    unit, previous_last, since, arrival = run.unit(f"{body}.position"), 0, -math.inf, -math.inf
    for first, last in rows:
        travel = float(position[last] - position[first])
        fraction = (position[first : last + 1] - position[first]) / travel
        # The first row at the end of the stroke, and the last row before it at the start.
        end_row = int(np.argmax(fraction >= STROKE_END))
        start_row = int(np.flatnonzero(fraction[: end_row + 1] <= STROKE_START)[-1])
        t = time[first : last + 1]
        start, end = (
            float(t[k] + (t[k + 1] - t[k]) * (level - fraction[k]) / (fraction[k + 1] - fraction[k]))
            for k, level in ((start_row, STROKE_START), (end_row - 1, STROKE_END))
        )
        mean = (STROKE_END - STROKE_START) * abs(travel) / (end - start)
        peak = max(float(speed[first : last + 1].max()), mean)  # few rows can miss the peak
        # Only a body that turns without a standstill can do so because of a command before it arrived.
        earliest = since if first == previous_last else arrival
        causes = [change for change in changes if change[1] is not None and earliest < change[0] <= start]
        moment, command = max(causes, key=lambda change: change[0], default=(None, None))
        from_command = None if moment is None else end - moment
        yield BodyStroke(body, unit, start, end - start, travel, mean, peak, command, moment, from_command)
        previous_last, since, arrival = last, start, end


def find_strokes(time: Array, position: Array, speed: Array, changes: Sequence[float]) -> list[tuple[int, int]]:
    """Return the first and last index of each stroke of a body.

    `changes` contains the times at which an input of the body changes [s]. A stroke ends at a turning point, from which
    the body moves back by more than 20 % of the travel since the last standstill. A stroke also ends at a standstill if
    one of these conditions is met:

    - An input changes during the standstill.
    - An input changes during the motion before the standstill. Until the next change, the body moves again, but for
      less than half the duration of the standstill.
    - After the standstill, the body moves back by more than 2 % of the range of its positions, and this motion takes
      less time than the standstill. If the motion covers less than 20 % of the range and an input changes in the run,
      this motion must take less than half the duration of the standstill.

    If the body does not move, the list is empty.

    Examples
    --------
    >>> time = np.linspace(0.0, 3.0, 301)
    >>> position = np.interp(time, [0.2, 0.7, 1.5, 1.8, 2.4, 2.5], [0.0, 1.0, 1.0, 0.95, 0.95, 0.85])
    >>> strokes = find_strokes(time, position, np.abs(np.gradient(position, time)), [1.4, 2.3])
    >>> [(round(float(position[first]), 2), round(float(position[last]), 2)) for first, last in strokes]
    [(0.0, 1.0), (1.0, 0.95), (0.95, 0.85)]
    """
    span = float(np.ptp(position))
    if span < MIN_TRAVEL:
        return []
    starts = {0}
    # Standstills during which an input changes. Two inputs often change together.
    rows = np.unique(
        np.searchsorted(time, [change for change in changes if time[0] <= change < time[-1]], "right") - 1
    ).tolist()
    for before, row, after in zip([0, *rows], rows, [*rows[1:], time.size - 1], strict=False):
        if speed[row] <= STANDSTILL * min(speed[before : row + 1].max(), speed[row : after + 1].max()):
            starts.add(row)
            continue
        # A change before the body arrives marks the next long standstill.
        moving = row + np.flatnonzero(speed[row : after + 1] > STANDSTILL * speed[row : after + 1].max())
        steps = np.diff(time)[moving[:-1]]
        for k, (stop, end) in enumerate(pairwise(moving)):
            is_long = time[end] - time[stop] > LONG_REST * steps[k + 1 :].sum()
            if is_long and abs(position[after] - position[end]) > MIN_STROKE * span:
                starts.add(int(stop + end) // 2)
                break
    # Standstills before a return, or after the return from an overshoot. If inputs change elsewhere, a small return
    # after a short rest is the correction of an overshoot.
    turns = turning_points(position, MIN_STROKE * span)
    for before, first, last in zip(turns, turns[1:], turns[2:], strict=False):
        moving = before + np.flatnonzero(speed[before : last + 1] > STANDSTILL * speed[first : last + 1].max())
        return_time = np.diff(time[first : last + 1])[moving[moving > first] - first - 1].sum()
        way = abs(position - position[first])
        for stop, end in pairwise(moving):
            is_small = bool(rows) and abs(position[last] - position[first]) < TURNED * span
            rest = time[end] - time[stop]
            is_long = end > first and rest > (LONG_REST if is_small else 1.0) * return_time
            if is_long and way[stop] < TURNED * span and way[last] - way[end] > 0.5 * MIN_STROKE * span:
                starts.add(int(stop + end) // 2)
                break
    bounds = [*sorted(starts), time.size - 1]
    strokes = []
    for first, last in pairwise(bounds):
        path = position[first : last + 1]
        min_return = max(TURNED * float(np.ptp(path)), MIN_STROKE * span)
        strokes += [(first + a, first + b) for a, b in pairwise(turning_points(path, min_return))]
    return strokes


def turning_points(position: Array, min_return: float) -> list[int]:
    """Return the indices at which a motion reverses, with the first and the last index.

    The body must return by at least `min_return`; smaller reversals do not count. The last index is the index of the
    last extreme. The list is empty if the whole motion is smaller than `min_return`.

    Examples
    --------
    >>> turning_points(np.array([0.0, 0.5, 0.45, 1.0, 0.9, 1.0, 0.0]), 0.2)
    [0, 3, 6]
    """
    turns, extreme, direction = [0], 0, 0.0
    for k in range(1, position.size):
        change = position[k] - position[extreme]
        if change * direction > 0.0 or (direction == 0.0 and change != 0.0):
            if direction == 0.0 and abs(position[k] - position[0]) < min_return:
                continue
            direction, extreme = float(np.sign(change)), k
        elif abs(change) >= min_return:
            turns.append(extreme)
            direction, extreme = -direction, k
    return [*turns, extreme] if extreme != turns[-1] else []


# Energy ----------------------------------------------------------------------------------------------------------


def _work(run: LoadData, body: str, integrals: tuple[int, ...], starts: Sequence[int]) -> BodyWork:
    position, velocity, time = run[f"{body}.position"], run[f"{body}.velocity"], run.raw.time
    effort, inertia = ("force", "mass") if run.unit(f"{body}.load_force") else ("torque", "inertia")
    mass = run.parameters[f"{body}.{inertia}"]
    weight = mass * GRAVITY * math.sin(run.parameters.get(f"{body}.inclination", 0.0))
    load = run[f"{body}.load_{effort}"]
    # A load that changes at less than 10 % of the output times counts as piecewise constant.
    is_staircase = np.count_nonzero(np.diff(load)) < 0.1 * load.size
    load_work = np.sum((load[:-1] if is_staircase else 0.5 * (load[:-1] + load[1:])) * np.diff(position))
    on_load = float(load_work) + weight * float(position[-1] - position[0])
    power, is_free = run[f"{body}.actuator_{effort}"] * velocity, True
    for name, owner, prefix in run.stops():
        # The end stops of a cylinder also push its body, which is not work of the air.
        if prefix and run.body_of.get(owner) == body:
            power, is_free = power - run[name] * run[f"{owner}.{prefix}velocity"], is_free and not run[name].any()
    bounds = [0, *starts[1:], time.size - 1]
    parts = [float(np.trapezoid(power[a : b + 1], time[a : b + 1])) for a, b in pairwise(bounds)]
    if is_free:  # the integrator computes the exact sum
        parts[int(np.argmax(np.abs(parts)))] += float(run.raw.x[integrals[0]]) + on_load - sum(parts)
    kinetic = 0.5 * mass * float(velocity[-1] ** 2 - velocity[0] ** 2)
    done, returned = (sum(max(sign * part, 0.0) for part in parts) for sign in (1.0, -1.0))
    return BodyWork(body, done, returned, on_load, done - returned - on_load - kinetic)


def _air_and_exergy(run: LoadData) -> tuple[dict[str, float], float, float]:
    """Return the air consumption and two exergies of a run.

    The first item is the air consumption of each reservoir above ambient pressure, as a volume at ANR [m^3] by name of
    the reservoir. The second item is the net exergy that flows from reservoirs and ambient into the circuit [J]. The
    third item is the increase in exergy of the gas in all volumes [J]. The increase is NaN if the pressure, temperature
    or mass of a volume is not an output.
    """
    stores, air = {store.name for store in run.stores}, run.surroundings
    # Gas density at ANR; that of air is the value of the standard, for moist air.
    density = ANR.density * AIR_GAS_CONSTANT / air.gas_constant
    consumption, total = {}, 0.0
    ends = dict.fromkeys(end for flow in run.flows for end in (flow.source, flow.target) if end is not None)
    for name in ends:
        if name in stores:
            continue
        pressure, temperature = run[f"{name}.pressure"], run[f"{name}.temperature"]
        specific = flow_exergy(pressure, temperature, air)
        mass = exergy = 0.0
        for flow in run.flows:
            sign = (flow.source == name) - (flow.target == name)
            flow_mass = sign * float(run.raw.x[flow.mass])
            mass += flow_mass
            if sign and np.ptp(specific) > 0.0 and run.unit(flow.name):
                exergy += sign * float(np.trapezoid(run[flow.name] * specific, run.raw.time))
            else:
                exergy += flow_mass * float(specific.mean())
        total += exergy
        if float(pressure.mean()) / air.pressure > 1.0:
            consumption[name] = float(mass / density)
    stored = 0.0
    for store in run.stores:
        names = [f"{store.name}.{quantity}" for quantity in ("pressure", "temperature", "mass")]
        if not all(map(run.unit, names)):
            return consumption, total, math.nan
        p, t, m = (run[name][[0, -1]] for name in names)
        # Exergy of enclosed gas: flow exergy minus the work of displacing the surroundings, (p - p_a) V.
        enclosed = m * flow_exergy(p, t, air) - (p - air.pressure) * m * air.gas_constant * t / p
        stored += float(enclosed[1] - enclosed[0])
    return consumption, total, stored


def flow_exergy(pressure: Array, temperature: Array, air: Surroundings) -> Array:
    """Return the specific flow exergy of a gas [J/kg].

    This is the maximum work that the flowing gas can do until it reaches the ambient state. `air` contains this state
    and the gas properties.
    """
    heat, ratio = air.heat_capacity_pressure, temperature / air.temperature
    entropy = heat * np.log(ratio) - air.gas_constant * np.log(pressure / air.pressure)
    exergy: Array = heat * (temperature - air.temperature) - air.temperature * entropy
    return exergy
