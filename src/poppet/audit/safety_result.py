"""Result of a safety audit: exhaust times of volumes and travel of bodies after an event, with and without a fault."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.toml import ResultFileMixin
from poppet.timeseries.checks import FloatArray

TRAPPED, SUPPLIED, FALLING = "trapped", "supplied", "falling"
"""Reasons for which a volume keeps its pressure: closed elements, a supply, or a slow exhaust."""


@dataclass(frozen=True)
class EventValue:
    """Value that an input has from the event on, SI and absolute."""

    address: str
    value: float
    unit: str  # SI unit of the value
    text: str = ""  # value as the user wrote it
    replaced: str = ""  # output that drives the input before the event; empty for a signal or a default
    is_gauge: bool = False  # True if the text is a gauge pressure

    @property
    def shown(self) -> str:
        """Assignment as text, for example `supply.pressure = 0 bar g`."""
        return f"{self.address} = {self.text or f'{self.value:g}'}"


@dataclass(frozen=True)
class Moment:
    """Time of the event in the run [s], with the active step of the first sequence."""

    time: float
    step: str = ""


@dataclass(frozen=True)
class ExhaustTime:
    """Time from the event until the pressure of a volume remains below the threshold.

    The values belong to the moment with the longest time. The time is 0 if the volume is never above the threshold
    after the event. It is infinite if the volume is above the threshold at the end of the run, and NaN if a run
    failed. All pressures are gauge pressures.
    """

    volume: str
    fault: str  # `VALVE.WORD`; empty in normal operation
    time: float  # [s]
    moment: Moment
    start_pressure: float  # at the event [Pa]
    end_pressure: float  # at the end of the run [Pa]
    reason: str = ""  # of an infinite time: `trapped`, `supplied` or `falling`
    by: tuple[str, ...] = ()  # elements that trap the gas, or reservoirs that supply it
    low: float | None = None  # limits of the 95 % interval [s]; None without distributions
    high: float | None = None

    @property
    def is_exhausted(self) -> bool:
        """True if the volume is not above the threshold at the end of the run; False also for a failed run."""
        return math.isfinite(self.time)


@dataclass(frozen=True)
class Travel:
    """Distance that a body travels after the event.

    The values belong to the moment with the longest distance. The distance is the length of the path, so a return adds
    to it. It is infinite if the body still moves at the end of the run, and NaN if a run failed.
    """

    body: str
    fault: str  # `VALVE.WORD`; empty in normal operation
    unit: str  # m or rad
    distance: float
    moment: Moment
    path: float  # distance until the end of the run, also if the body still moves; NaN if a run failed
    net: float  # final position minus the position at the event
    farthest: float  # largest distance from the position at the event
    stop_time: float  # time from the event until the body remains at its final position [s]; infinite if it moves
    low: float | None = None  # limits of the 95 % interval of the distance; None without distributions
    high: float | None = None

    @property
    def is_stopped(self) -> bool:
        """True if the body does not move at the end of the run; False also for a failed run."""
        return math.isfinite(self.distance)


@dataclass(frozen=True, eq=False)
class SafetyCurves:
    """Pressures and positions after the event, for one moment of the event and one fault."""

    fault: str  # empty in normal operation
    moment: Moment
    time: FloatArray  # time from the event [s]
    pressures: Mapping[str, FloatArray]  # gauge pressure of each volume [Pa]
    positions: Mapping[str, FloatArray]  # of each body [m] or [rad]


@dataclass(frozen=True, eq=False)
class SafetyAudit(ResultFileMixin):
    """Exhaust times and travels after an event, in normal operation and with each single fault.

    Parameters
    ----------
    title : str
        Title of the circuit.
    events : tuple of EventValue
        Inputs that change at the event, with their values.
    moments : tuple of Moment
        Times of the event that were simulated.
    threshold : float
        Gauge pressure below which a volume counts as exhausted [Pa].
    duration : float
        Simulated time after the event [s].
    faults : tuple of str
        Simulated faults, `VALVE.WORD`.
    exhaust : tuple of ExhaustTime
        One element for each volume in normal operation and with each fault.
    travel : tuple of Travel
        One element for each body in normal operation and with each fault.
    samples : int
        Number of samples of the uncertain parameters; 0 without distributions.
    notes : tuple of Note
        Assumptions and limits of the result, and failed runs.
    curves : tuple of SafetyCurves
        Pressures and positions in normal operation and with each fault, at the moment with the longest exhaust time.
    is_whole : bool
        False if Ctrl-C stopped the audit. The result then contains the faults whose runs are complete.

    Notes
    -----
    The audit follows the ideas of ISO 13849-1 (single fault in a channel) and ISO 4414 (exhaust of stored pressure).
    It does not certify a machine and computes no performance level.
    """

    title: str
    events: tuple[EventValue, ...]
    moments: tuple[Moment, ...]
    threshold: float
    duration: float
    faults: tuple[str, ...]
    exhaust: tuple[ExhaustTime, ...]
    travel: tuple[Travel, ...]
    samples: int = 0
    notes: tuple[Note, ...] = ()
    curves: tuple[SafetyCurves, ...] = field(default=(), repr=False)
    is_whole: bool = True

    @property
    def volumes(self) -> tuple[str, ...]:
        """Names of all volumes."""
        return tuple(dict.fromkeys(row.volume for row in self.exhaust))

    @property
    def bodies(self) -> tuple[str, ...]:
        """Names of all bodies."""
        return tuple(dict.fromkeys(row.body for row in self.travel))

    def exhaust_of(self, volume: str, fault: str = "") -> ExhaustTime:
        """Return the exhaust time of a volume in normal operation or with a fault.

        Parameters
        ----------
        volume : str
            Name of the volume.
        fault : str, optional
            Fault, `VALVE.WORD`; empty in normal operation.

        Raises
        ------
        InputError
            If the audit does not contain the volume or the fault.
        """
        rows = {(row.volume, row.fault): row for row in self.exhaust}
        _check_names(volume, fault, rows, "a volume of the audit")
        return rows[volume, fault]

    def travel_of(self, body: str, fault: str = "") -> Travel:
        """Return the travel of a body in normal operation or with a fault.

        Parameters
        ----------
        body : str
            Name of the body.
        fault : str, optional
            Fault, `VALVE.WORD`; empty in normal operation.

        Raises
        ------
        InputError
            If the audit does not contain the body or the fault.
        """
        rows = {(row.body, row.fault): row for row in self.travel}
        _check_names(body, fault, rows, "a body of the audit")
        return rows[body, fault]

    def content(self) -> dict[str, Any]:
        """Return the result as nested dictionaries, the content of the result file.

        Returns
        -------
        dict
            Keys end with their SI unit. Pressures are gauge pressures. A time longer than `duration_s` is infinite.
        """

        def interval(name: str, unit: str, low: float | None, high: float | None) -> dict[str, float]:
            return {} if low is None or high is None else {f"{name}_low_{unit}": low, f"{name}_high_{unit}": high}

        exhaust = [
            {"volume": row.volume, "time_s": row.time, "fault": row.fault}
            | interval("time", "s", row.low, row.high)
            | {"event_s": row.moment.time, "step": row.moment.step}
            | {"start_pressure_pa": row.start_pressure, "end_pressure_pa": row.end_pressure}
            | ({"reason": row.reason, "by": list(row.by)} if row.reason else {})
            for row in self.exhaust
        ]
        travel = [
            {"body": row.body, f"distance_{row.unit}": row.distance, "fault": row.fault}
            | interval("distance", row.unit, row.low, row.high)
            | {f"path_{row.unit}": row.path, f"net_{row.unit}": row.net, f"farthest_{row.unit}": row.farthest}
            | {"stop_time_s": row.stop_time, "event_s": row.moment.time, "step": row.moment.step}
            for row in self.travel
        ]
        return {
            "title": self.title,
            "statement": str(Note("safety.statement")),
            "threshold_pa": self.threshold,
            "duration_s": self.duration,
            "samples": self.samples,
            "is_whole": self.is_whole,
            "faults": list(self.faults),
            "events": [{"address": e.address, "value": e.value, "unit": e.unit} for e in self.events],
            "moments": [{"time_s": moment.time, "step": moment.step} for moment in self.moments],
            "exhaust": exhaust,
            "travel": travel,
            "notes": [{**note.plain(), "text": str(note)} for note in self.notes],
        }


def _check_names(name: str, fault: str, rows: Iterable[tuple[str, str]], meaning: str) -> None:
    """Raise an error if no row has a name and a fault."""
    for argument, valid, noun in (
        (name, [n for n, _ in rows], meaning),
        (fault, [f for _, f in rows], "a fault of the audit"),
    ):
        if argument not in valid:
            suggestion = NameSuggestion(argument, filter(None, valid))
            raise InputError("names.unknown", argument, meaning=noun, suggestion=suggestion)
