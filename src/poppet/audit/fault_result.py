"""Result of a fault table: consequences of every single fault of a circuit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.toml import ResultFileMixin

CONSEQUENCES = (
    "failed", "timed_out", "waits", "diverts", "moves_without_command", "not_reached", "overtravel", "pressure_stays",
    "pressure_missing", "pressure_falls", "vacuum_missing", "pressure_high", "stroke_time", "cycle_time", "air", "none",
)  # fmt: skip
"""Kinds of consequences, in the order of the table."""


@dataclass(frozen=True)
class Consequence:
    """Difference between a run with a fault and the healthy run.

    `value` belongs to the run with the fault, `healthy` to the healthy run, both in `unit`. `facts` contains further
    facts, for example the names of steps.
    """

    kind: str  # one of `CONSEQUENCES`
    address: str  # sequence, body, volume or reservoir
    value: float | None = None
    healthy: float | None = None
    unit: str = ""
    time: float | None = None  # [s]
    facts: Mapping[str, Any] = field(default_factory=dict)

    @property
    def note(self) -> Note:
        """Consequence as a note, whose text is a sentence."""
        facts: dict[str, Any] = {"value": self.value, "healthy": self.healthy, "unit": self.unit, "time": self.time}
        return Note(f"consequence.{self.kind}", self.address, **(facts | dict(self.facts)))

    def plain(self) -> dict[str, Any]:
        """Return the consequence as a dictionary for a result file, without absent values."""
        values = {"value": self.value, "healthy": self.healthy, "unit": self.unit, "time_s": self.time}
        present = {key: value for key, value in values.items() if value not in (None, "")}
        return {"kind": self.kind, "address": self.address, **present, **self.facts, "text": str(self.note)}


@dataclass(frozen=True)
class FaultRow:
    """One single fault with its consequences."""

    valve: str
    word: str  # stuck_open, stuck_closed, stuck, slow or leak
    consequences: tuple[Consequence, ...]

    @property
    def fault(self) -> str:
        """Name of the fault, `VALVE.WORD`."""
        return f"{self.valve}.{self.word}"

    @property
    def stops_machine(self) -> bool:
        """True if a step of a sequence waits or ends by its timeout, so that the control can notice the fault."""
        return any(consequence.kind in ("waits", "timed_out") for consequence in self.consequences)

    @property
    def is_hidden(self) -> bool:
        """True if no difference from the healthy run exceeds its limit, so that the fault has no consequence."""
        return all(consequence.kind == "none" for consequence in self.consequences)


@dataclass(frozen=True)
class OmittedFault:
    """Fault that a valve cannot have, with the reason."""

    valve: str
    word: str
    reason: str


@dataclass(frozen=True, eq=False)
class FaultTable(ResultFileMixin):
    """Consequences of every single fault of a circuit.

    Parameters
    ----------
    title : str
        Title of the circuit.
    start : float
        Time at which each fault begins [s].
    duration : float
        Duration of each run [s].
    threshold : float
        Gauge pressure below which a volume counts as exhausted [Pa].
    rows : tuple of FaultRow
        One element for each fault.
    omitted : tuple of OmittedFault
        Faults that a valve cannot have.
    cycle_time : float or None
        Duration of the last complete cycle of the healthy run [s]; None without a complete cycle.
    notes : tuple of Note
        Assumptions and limits of the result.
    is_whole : bool
        False if Ctrl-C stopped the runs. The table then contains the completed runs.
    """

    title: str
    start: float
    duration: float
    threshold: float
    rows: tuple[FaultRow, ...]
    omitted: tuple[OmittedFault, ...] = ()
    cycle_time: float | None = None
    notes: tuple[Note, ...] = ()
    is_whole: bool = True

    def row(self, fault: str) -> FaultRow:
        """Return the row of one fault.

        Parameters
        ----------
        fault : str
            Name of the fault, `VALVE.WORD`.

        Raises
        ------
        InputError
            If the table does not contain the fault.
        """
        rows = {row.fault: row for row in self.rows}
        if fault not in rows:
            suggestion = NameSuggestion(fault, rows)
            raise InputError("names.unknown", fault, meaning="a fault of the table", suggestion=suggestion)
        return rows[fault]

    def content(self) -> dict[str, Any]:
        """Return the result as nested dictionaries, the content of the result file.

        Returns
        -------
        dict
            The faults are in `faults`, each with a list of `consequences`.
        """
        return {
            "title": self.title,
            "start_s": self.start,
            "duration_s": self.duration,
            "threshold_pa": self.threshold,
            **({} if self.cycle_time is None else {"cycle_time_s": self.cycle_time}),
            "is_whole": self.is_whole,
            "faults": [
                {"fault": row.fault, "valve": row.valve, "word": row.word, "stops_machine": row.stops_machine,
                 "is_hidden": row.is_hidden, "consequences": [c.plain() for c in row.consequences]}
                for row in self.rows
            ],
            "omitted": [{"valve": o.valve, "word": o.word, "reason": o.reason} for o in self.omitted],
            "notes": [{**note.plain(), "text": str(note)} for note in self.notes],
        }  # fmt: skip
