"""Moves of the bodies in a machine cycle: stroke time from command to stop, dwell and impact speed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.load_metrics import STANDSTILL, STROKE_END, STROKE_START, BodyStroke, LoadMetrics
from poppet.parts import Sequence
from poppet.timeseries.recording import Recording

STOP_BAND = 1.0 - STROKE_END
"""Largest distance from its rest position at which a body without end stop has stopped, per travel."""


@dataclass(frozen=True)
class Move:
    """One move of a body, from its command to its stop.

    A body stops when it meets its end stop for the first time, if it does not leave the stop again by more than 2 % of
    the travel. Without an end stop, it stops when it stays within 2 % of the travel around the position in which it
    rests before its next move. The time of the stop is None if the run ends before.
    """

    body: str
    unit: str  # m or rad
    step: str  # step of the sequence that set the command; empty without a sequence
    command: str | None  # address of the input that caused the move
    command_time: float | None  # time of its change [s]
    start: float  # time at 2 % of the travel [s]
    stop: float | None  # [s]
    travel: float  # with its sign [m] or [rad]
    impact_speed: float | None  # absolute speed of the fastest impact on an end stop [m/s] or [rad/s]; None without one
    dwell: float | None  # time from the stop to the start of the next move of the body [s]; None if unknown

    @property
    def stroke_time(self) -> float | None:
        """Time from the command to the stop [s]; None if one of the two is not known."""
        return None if self.command_time is None or self.stop is None else self.stop - self.command_time

    def plain(self) -> dict[str, Any]:
        """Return the move as a dictionary for a result file; None stands for an absent value."""
        return {
            "body": self.body,
            "step": self.step or None,
            "command": self.command,
            "command_time_s": self.command_time,
            "start_s": self.start,
            "stop_s": self.stop,
            "stroke_time_s": self.stroke_time,
            f"travel_{self.unit}": self.travel,
            f"impact_speed_{self.unit}_per_s": self.impact_speed,
            "dwell_s": self.dwell,
        }


def find_moves(
    circuit: BaseCircuit, recording: Recording, cycle: tuple[float, float] | None = None
) -> tuple[Move, ...]:
    """Return the moves of all bodies that start in a cycle, in the order of their starts.

    The last move of a body dwells until its next move in the run. If the run ends before, the cycle is assumed to
    repeat: the move dwells until the first move of the next cycle.

    Parameters
    ----------
    circuit : Circuit
        The simulated circuit.
    recording : Recording
        The result of the simulation.
    cycle : tuple of float, optional
        Start and end of the cycle [s]. By default, the result contains all moves of the run, and the dwell of the last
        move of each body is None.

    Returns
    -------
    tuple of Move
        The result is empty if the circuit has no bodies, or if no body moves.
    """
    metrics: LoadMetrics | None = recording.figures
    if metrics is None:
        return ()
    first, last = (-math.inf, math.inf) if cycle is None else cycle
    moves: list[Move] = []
    for body in dict.fromkeys(stroke.body for stroke in metrics.strokes):
        strokes = [stroke for stroke in metrics.strokes if stroke.body == body]
        in_cycle = [k for k, stroke in enumerate(strokes) if first <= stroke.start < last]
        for k in in_cycle:
            following = strokes[k + 1] if k + 1 < len(strokes) else None
            stop = _stop_time(circuit, recording, strokes[k], following)
            next_start = strokes[in_cycle[0]].start + last - first if following is None else following.start
            moves.append(_move(circuit, recording, strokes[k], stop, next_start))
    return tuple(sorted(moves, key=lambda move: move.start))


def _move(
    circuit: BaseCircuit, recording: Recording, stroke: BodyStroke, stop: float | None, next_start: float
) -> Move:
    """Return the move of a stroke; `next_start` is the start of the next move of the body, or infinite."""
    impact, (step, command_time) = recording.figures.met(stroke), _command_of(circuit, recording, stroke)
    return Move(
        body=stroke.body,
        unit=stroke.unit,
        step=step,
        command=stroke.command,
        command_time=command_time,
        start=stroke.start,
        stop=stop,
        travel=stroke.travel,
        impact_speed=None if impact is None else abs(impact.velocity),
        dwell=None if stop is None or math.isinf(next_start) else next_start - stop,
    )


def _command_of(circuit: BaseCircuit, recording: Recording, stroke: BodyStroke) -> tuple[str, float | None]:
    """Return the step in which a sequence changed the command of a stroke, and the time of the change.

    The time of a sequence is the entry of the step, also between two rows of the recording.
    """
    owner = circuit.connections.get(stroke.command or "", "").partition(".")[0]
    part = circuit.parts.get(owner)
    if not isinstance(part, Sequence) or stroke.command_time is None:
        return "", stroke.command_time
    row = int(np.searchsorted(recording.time, stroke.command_time))
    entry = float(recording.time[row] - recording[f"{owner}.elapsed"][row])
    is_entered = row == 0 or entry > recording.time[row - 1]
    step = str(part.program.steps[round(float(recording[f"{owner}.step"][row])) - 1].name)
    return step, entry if is_entered else stroke.command_time


def _stop_time(
    circuit: BaseCircuit, recording: Recording, stroke: BodyStroke, following: BodyStroke | None
) -> float | None:
    """Return the time at which the body of a stroke stops before its following stroke."""
    time, position = recording.time, recording[f"{stroke.body}.position"]
    if following is None:
        if abs(recording[f"{stroke.body}.velocity"][-1]) > STANDSTILL * stroke.peak_speed:
            return None
        rest, next_start = float(position[-1]), math.inf
    else:
        # The stroke time begins after 2 % of the travel.
        next_start = following.start
        rest = float(np.interp(next_start, time, position)) - STROKE_START * following.travel
    band = STOP_BAND * abs(stroke.travel)
    rows = np.flatnonzero((time >= stroke.start) & (time < next_start))
    deviation = np.abs(position[rows] - rest)
    inside = np.flatnonzero(deviation <= band)
    if not inside.size:
        return None
    last = int(inside[-1])
    outside = np.flatnonzero(deviation[:last] > band)
    settled = float(time[rows[0]])
    if outside.size:
        k = int(outside[-1])
        fraction = (deviation[k] - band) / (deviation[k] - deviation[k + 1])
        settled = float(time[rows[k]] + fraction * (time[rows[k + 1]] - time[rows[k]]))
    return min(
        (t for t in _contact_times(circuit, recording, stroke.body) if settled <= t < next_start), default=settled
    )


def _contact_times(circuit: BaseCircuit, recording: Recording, body: str) -> list[float]:
    """Return the times at which a body meets an end stop, also slowly."""
    actuators = circuit.instance.bodies
    impacts = [impact for impact in recording.figures.arrivals if impact.body == body]
    times = []
    for name in recording.names:
        owner, _, quantity = name.rpartition(".")
        if quantity not in ("stop_force", "stop_torque") or actuators.get(owner, owner) != body:
            continue
        force = recording[name]
        for k in np.flatnonzero((force[:-1] == 0.0) & (force[1:] != 0.0)):
            # An impact has a time between two rows.
            between = (a.time for a in impacts if recording.time[k] <= a.time <= recording.time[k + 1])
            times.append(float(next(between, recording.time[k + 1])))
    return times
