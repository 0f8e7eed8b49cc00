"""Consequences of a fault, from the comparison of a run with the fault and the healthy run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from poppet.audit.fault_result import CONSEQUENCES, Consequence
from poppet.audit.visits import Visit, visits_of
from poppet.audit.volumes import bodies_of, volumes_of
from poppet.circuit.circuit import BaseCircuit
from poppet.core.units import ANR
from poppet.laws.physics.gas import AIR_GAS_CONSTANT
from poppet.parts.sequence import Sequence
from poppet.parts.sources import Reservoir
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.recording import Recording

LONGER = 1.2
"""Ratio to the healthy run above which a time counts as longer: that in a step, or that above the threshold."""
MARGIN = 0.01
"""Difference from the healthy run that a longer time must also exceed [s]."""
TRAVEL = 0.02
"""Fraction of the travel of a body that a difference of positions must exceed."""
MIN_TRAVEL = 1e-4
"""Difference of positions that must also be exceeded [m] or [rad]."""
PRESSURE = 0.1
"""Fraction of the highest healthy gauge pressure by which a higher pressure must exceed it."""
STEADY = 0.9
"""Ratio of the final gauge pressure to that at the start of the last tenth of the run, above which it is steady."""
MISSING = 0.5
"""Ratio to the healthy run below which a gauge pressure (highest or lowest) or the deepest vacuum is missing."""
MIN_VACUUM = 1e4
"""Smallest vacuum of the healthy run that counts [Pa], relative to the ambient pressure."""
DURATION, AIR = 0.05, 0.05
"""Smallest relative changes of a stroke time or cycle time, and of the air consumption, that count."""
MIN_AIR = 1e-6
"""Smallest air consumption that counts [m^3 ANR]."""


@dataclass(frozen=True)
class RunPair:
    """Run with a fault and healthy run of one circuit, with the same output times.

    `start` is the start of the fault [s]. A volume with a gauge pressure below `threshold` [Pa] counts as exhausted.
    """

    circuit: BaseCircuit
    healthy: Recording
    faulty: Recording
    start: float
    threshold: float

    @property
    def rows(self) -> slice:
        """Rows from the start of the fault on."""
        return slice(int(np.searchsorted(self.healthy.time, self.start)), None)

    def series(self, address: str) -> tuple[FloatArray, FloatArray]:
        """Return the values of an output in the healthy run and with the fault, from the start of the fault on."""
        return self.healthy[address][self.rows], self.faulty[address][self.rows]

    @property
    def time(self) -> FloatArray:
        """Times from the start of the fault on [s]."""
        return self.healthy.time[self.rows]


def find_consequences(runs: RunPair) -> tuple[Consequence, ...]:
    """Return all consequences of a fault, in the order of their kinds."""
    consequences: list[Consequence] = []
    for name, part in runs.circuit.parts.items():
        if isinstance(part, Sequence):
            consequences += _of_sequence(runs, name, part)
    for body, unit in bodies_of(runs.circuit).items():
        consequences += _of_body(runs, body, unit)
    for volume, addresses in volumes_of(runs.circuit).items():
        consequences += [*_of_volume(runs, volume, addresses), *_of_vacuum(runs, volume, addresses)]
    # Stroke times are comparable only if all sequences complete their steps.
    if not any(item.kind in ("waits", "timed_out", "diverts") for item in consequences):
        consequences += _of_strokes(runs)
    consequences += _of_air(runs)
    return tuple(sorted(consequences, key=lambda item: CONSEQUENCES.index(item.kind))) or (Consequence("none", ""),)


# Sequences -------------------------------------------------------------------------------------------------------


def cycle_times(visits: list[Visit]) -> list[float]:
    """Return the durations of the complete cycles [s], each from the first step of the run until it begins again."""
    starts = [visit.start for visit in visits if visit.step == visits[0].step]
    return [end - start for start, end in pairwise(starts)]


def _of_sequence(runs: RunPair, name: str, part: Sequence) -> Iterator[Consequence]:
    names = part.program.names
    healthy, faulty = visits_of(runs.healthy, name), visits_of(runs.faulty, name)
    common = next((k for k, (a, b) in enumerate(zip(healthy, faulty, strict=False)) if a.step != b.step), None)
    timeout = _timeout(runs.faulty, name, part)
    if timeout and common is not None and timeout["time"] > faulty[common].start - MARGIN:
        facts = {"step": timeout["name"], "target": timeout["target"]}
        yield Consequence("timed_out", name, time=timeout["time"], facts=facts)
    elif common is not None:
        step, expected = (names[visits[common].step - 1] for visits in (faulty, healthy))
        yield Consequence("diverts", name, time=faulty[common].start, facts={"step": step, "expected": expected})
    last = faulty[-1]
    if common is None and len(faulty) < len(healthy):
        usual = healthy[len(faulty) - 1].end - healthy[len(faulty) - 1].start
    else:
        usual = max((visit.end - visit.start for visit in healthy if visit.step == last.step), default=0.0)
    has_diverged = common is not None or len(faulty) < len(healthy)
    if has_diverged and last.end - last.start > LONGER * usual + MARGIN:
        facts = {"step": names[last.step - 1]}
        yield Consequence("waits", name, last.end - last.start, usual or None, "s", last.start, facts)
    # The last cycle of equal number: the first one can include waiting for a start button.
    cycles = [*zip(cycle_times(healthy), cycle_times(faulty), strict=False)]
    if cycles and abs(cycles[-1][1] - cycles[-1][0]) > DURATION * cycles[-1][0]:
        usual, value = cycles[-1]
        yield Consequence("cycle_time", name, value, usual, "s")


def _timeout(recording: Recording, name: str, part: Sequence) -> Mapping[str, Any]:
    """Return the facts of the first timeout of a run; empty without a timeout."""

    def series(address: str) -> FloatArray:
        return recording.time if address == "time" else recording[address]

    return next((note.facts for note in part.remarks(name, series) if note.code == "sequence.timed_out"), {})


# Bodies ----------------------------------------------------------------------------------------------------------


def _of_body(runs: RunPair, body: str, unit: str) -> Iterator[Consequence]:
    healthy, faulty = runs.series(f"{body}.position")
    lowest, highest = float(healthy.min()), float(healthy.max())
    margin = max(TRAVEL * (highest - lowest), MIN_TRAVEL)
    if (motion := _uncommanded(runs, body, healthy, faulty, margin)) is not None:
        distance, time = motion
        yield Consequence("moves_without_command", body, distance, unit=unit, time=time)
    for value, usual, sign in ((float(faulty.max()), highest, 1.0), (float(faulty.min()), lowest, -1.0)):
        if sign * (usual - value) > margin:
            yield Consequence("not_reached", body, value, usual, unit)
        elif sign * (value - usual) > margin:
            yield Consequence("overtravel", body, value, usual, unit)


def _uncommanded(
    runs: RunPair, body: str, healthy: FloatArray, faulty: FloatArray, margin: float
) -> tuple[float, float] | None:
    """Return distance and start of the first motion of a body without a command; None if there is none.

    While the commands of both runs are equal, a motion has no command if the healthy body does not move in this
    direction between the last and the next change of a command. Later, a stroke has no command if no input of the body
    changed since the previous stroke.
    """
    drives = runs.circuit.drives().get(body, {})
    commands = [runs.series(address) for address, is_command in drives.items() if is_command]
    differs, changes = np.zeros(healthy.size, dtype=bool), np.zeros(healthy.size, dtype=bool)
    for usual, present in commands:
        differs |= np.abs(usual - present) > 1e-9
        changes[1:] |= np.diff(usual) != 0.0
    end = int(differs.argmax()) if differs.any() else healthy.size
    differences = np.flatnonzero(np.abs(faulty[:end] - healthy[:end]) > margin)
    if differences.size:
        row = int(differences[0])
        bounds = np.flatnonzero(changes)
        first = max(bounds[bounds <= row].tolist(), default=0)
        last = min(bounds[bounds > row].tolist(), default=healthy.size - 1)
        sign = 1.0 if faulty[row] > healthy[row] else -1.0
        usual_travel = float((sign * (healthy[first : last + 1] - healthy[first])).max())
        # From the turning point before the difference: a command can have moved the body to it.
        origin = first + int(np.argmin(sign * faulty[first : row + 1]))
        travel = sign * (faulty[origin:] - faulty[origin])
        # Up to the row at which the body has returned.
        returned = np.flatnonzero(np.maximum.accumulate(travel) - travel > margin)
        distance = float(travel[: int(returned[0]) if returned.size else travel.size].max())
        if travel[: last + 1 - origin].max() > margin >= usual_travel:
            begin = origin + int(np.flatnonzero(travel > 0.1 * margin)[0])
            return distance, float(runs.time[begin])
    if end == healthy.size:
        return None
    strokes = [stroke for stroke in runs.faulty.figures.strokes if stroke.body == body]
    usual_strokes = [stroke for stroke in runs.healthy.figures.strokes if stroke.body == body]
    n_usual = sum(stroke.command is None for stroke in usual_strokes)
    free = [k for k, stroke in enumerate(strokes) if stroke.command is None][n_usual:]
    for k in free:
        stroke, since = strokes[k], strokes[k - 1].start + strokes[k - 1].duration if k else 0.0
        rows = (runs.time >= since) & (runs.time <= stroke.start)
        is_driven = any(np.ptp(runs.series(address)[1][rows]) > 0.0 for address in drives if rows.any())
        if stroke.start >= runs.time[end] and abs(stroke.travel) > margin and not is_driven:
            return abs(stroke.travel), stroke.start
    return None


# Volumes, strokes and air ----------------------------------------------------------------------------------------


def _of_volume(runs: RunPair, volume: str, addresses: tuple[str, ...]) -> Iterator[Consequence]:
    ambient, time = runs.circuit.surroundings.pressure, runs.time
    pairs = [runs.series(address) for address in addresses]
    healthy, faulty = (np.max([pair[k] for pair in pairs], axis=0) - ambient for k in range(2))
    highest, lowest = float(healthy.max()), float(healthy.min())
    tail = faulty[-max(faulty.size // 10, 2) :]
    # At the end, the pressure must be steady: in a slower cycle, it can still fall.
    if lowest < runs.threshold < tail.min() and faulty[-1] > STEADY * tail[0]:
        low_rows = np.flatnonzero(faulty <= runs.threshold)
        first = int(low_rows[-1]) + 1 if low_rows.size else 0
        if time[-1] - time[first] > LONGER * _longest(time, healthy > runs.threshold) + MARGIN:
            values = _rounded(faulty[-1]), _rounded(healthy[first:].min())
            limit = {"threshold": runs.threshold}
            yield Consequence("pressure_stays", volume, *values, "Pa", float(time[first]), limit)
    peak = float(faulty.max())
    if highest > runs.threshold and peak < MISSING * highest:
        yield Consequence("pressure_missing", volume, _rounded(peak), _rounded(highest), "Pa")
    elif lowest > runs.threshold and (low := float(faulty.min())) < MISSING * lowest:
        # A volume that is full at the start of the fault.
        yield Consequence("pressure_falls", volume, _rounded(low), _rounded(lowest), "Pa", float(time[faulty.argmin()]))
    if peak - highest > max(runs.threshold, PRESSURE * highest):
        facts = _rounded(peak), _rounded(highest), "Pa", float(time[int(faulty.argmax())])
        yield Consequence("pressure_high", volume, *facts)


def _of_vacuum(runs: RunPair, volume: str, addresses: tuple[str, ...]) -> Iterator[Consequence]:
    ambient = runs.circuit.surroundings.pressure
    pairs = [runs.series(address) for address in addresses]
    usual, vacuum = (ambient - min(float(pair[k].min()) for pair in pairs) for k in range(2))
    if usual > MIN_VACUUM and vacuum < MISSING * usual:
        yield Consequence("vacuum_missing", volume, _rounded(max(vacuum, 0.0)), _rounded(usual), "Pa")


def _rounded(pressure: float) -> float:
    """Round a pressure to 1 mbar [Pa]; smaller digits of an exhausted volume have no meaning."""
    return round(float(pressure), -2) + 0.0


def _longest(time: FloatArray, is_above: Any) -> float:
    """Return the duration of the longest interval in which a condition is true [s]."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], is_above, [False]]).astype(int)))
    starts, ends = edges[::2], edges[1::2]
    return max((float(time[min(b, time.size - 1)] - time[a]) for a, b in zip(starts, ends, strict=True)), default=0.0)


def _of_strokes(runs: RunPair) -> Iterator[Consequence]:
    for body in bodies_of(runs.circuit):
        usual, value = (
            max((s.from_command for s in run.figures.strokes if s.body == body and s.from_command), default=None)
            for run in (runs.healthy, runs.faulty)
        )
        if usual is not None and value is not None and abs(value - usual) > DURATION * usual:
            yield Consequence("stroke_time", body, value, usual, "s")


def _of_air(runs: RunPair) -> Iterator[Consequence]:
    """Yield increases of the air consumption of all reservoirs above ambient pressure, as volumes at ANR."""
    air = runs.circuit.surroundings
    density = ANR.density * AIR_GAS_CONSTANT / air.gas_constant
    for name, part in runs.circuit.parts.items():
        if isinstance(part, Reservoir) and runs.healthy[f"{name}.pressure"].mean() > air.pressure:
            flows = runs.series(f"{name}.mass_flow_rate")
            usual, value = (float(np.trapezoid(flow, runs.time)) / density for flow in flows)
            if value > MIN_AIR and value - usual > AIR * abs(usual):
                # Without consumption, the flow of a supply is not exactly zero.
                yield Consequence("air", name, value, usual if abs(usual) > MIN_AIR else 0.0, "m^3")
