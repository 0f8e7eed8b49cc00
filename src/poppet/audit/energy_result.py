"""Result of an energy audit: air, energy and exergy of one machine cycle."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from poppet.audit.moves import Move
from poppet.audit.tariff import Tariff
from poppet.core.codes import Note
from poppet.core.note_groups import grouped
from poppet.core.toml import ResultFileMixin
from poppet.timeseries.recording import Recording

SUPPLIED, WORK, FRICTION, THROTTLING, MIXING, HEAT, EXHAUSTED, STORED, INTEGRATION = CATEGORIES = (
    "supplied", "work", "friction", "throttling", "mixing", "heat", "exhausted", "stored", "integration"
)  # fmt: skip
"""Categories of the rows of a balance. The supplied energy equals the sum of all other rows."""
LITRE = 1e-3
"""One litre [m^3]."""
SMALLEST_AIR = 1e-3
"""Air of a part, relative to the total, below which tables show 0."""
REPEATED = 0.01
"""Change of a state during a cycle, relative to its maximum or range, above which the cycle does not repeat."""


@dataclass(frozen=True)
class Cycle:
    """Period that an audit evaluates: one machine cycle, or several in succession."""

    start: float  # [s]
    end: float  # [s]
    count: int = 1  # number of cycles from `start` to `end`
    found_by: str = "stated"  # "sequence", "signal" or "stated"
    source: str = ""  # address of the sequence or of the signal that repeats
    steps: tuple[str, ...] = ()  # steps of the sequence in this period
    change: float = 0.0  # largest change of a state from start to end, relative to its maximum or range
    changed: str = ""  # address of this state

    @property
    def duration(self) -> float:
        """Duration of one cycle [s]."""
        return (self.end - self.start) / self.count

    def notes(self) -> tuple[Note, ...]:
        """Return a tuple with a note if the final state of the cycle differs from its initial state."""
        if self.change <= REPEATED:
            return ()
        return (Note("cycle.not_repeated", self.changed, change=100.0 * self.change, start=self.start, end=self.end),)


@dataclass(frozen=True)
class BalanceRow:
    """Energy and exergy per cycle in one place of the circuit [J].

    A row is positive if the energy is supplied (`supplied`), or leaves the circuit, is lost or stored (all others). A
    loss of exergy that is not a loss of energy, such as throttling, has an energy of 0.
    """

    name: str  # address of the flow path, gas node, body or actuator
    part: str  # part of the circuit to which it belongs
    category: str  # element of `CATEGORIES`
    energy: float
    exergy: float


@dataclass(frozen=True)
class FlowPathAir:
    """Air through one flow path per cycle, as a volume at ANR [m^3], and the exergy lost by its throttling [J]."""

    name: str  # address of the mass flow rate, for example `valve.supply_a_mass_flow_rate`
    part: str
    source: str  # gas node from which positive flow comes; empty outside the circuit
    target: str  # gas node that receives positive flow
    air: float  # net volume from source to target
    forward: float  # volume that flowed from source to target
    throttling: float

    @property
    def backward(self) -> float:
        """Volume that flowed from target to source [m^3]."""
        return self.forward - self.air


@dataclass(frozen=True)
class PartRow:
    """Air that a part consumes per cycle [m^3 ANR], and exergy that is lost in it per cycle [J]."""

    part: str
    air: float
    exergy_lost: float
    category: str  # category of its largest loss


@dataclass(frozen=True)
class LeakRow:
    """Air and exergy that one leak costs per cycle, and their cost per year."""

    part: str
    flow_path: str  # address of the flow path, or of the part whose closing element leaks
    air: float  # [m^3 ANR]
    exergy: float  # lost [J]
    cost_per_year: float  # [currency]; NaN without a price


@dataclass(frozen=True)
class SavingRow:
    """Effect of one measure: reductions per cycle and per year, and the cycle time with the measure."""

    measure: str
    air: float  # reduction [m^3 ANR]
    exergy: float  # reduction of the supplied exergy [J]
    cost_per_year: float  # [currency]; NaN without a price
    co2_per_year: float  # [kg]; NaN without an emission
    cycle_time: float  # [s]
    is_bound: bool = False  # True for an upper bound of the saving


@dataclass(frozen=True)
class EnergyAudit(ResultFileMixin):
    """Air, energy and exergy of one machine cycle.

    Parameters
    ----------
    title : str
        Title of the circuit.
    cycle : Cycle
        Period of the audit. All other values are per cycle.
    air : mapping
        Mapping from each reservoir or source to the air that it supplies, minus the air that returns [m^3 ANR].
    rows : tuple of BalanceRow
        Energy and exergy balance.
    flow_paths : tuple of FlowPathAir
        Air and throttling of each flow path.
    parts : tuple of PartRow
        Air and lost exergy of each part. The sum of the air is `air_used`.
    leaks, savings : tuple, optional
        Leaks, and effects of measures.
    tariff : Tariff, optional
        Prices and emissions.
    notes : tuple of Note, optional
        Notes on the run and limits of the result.
    recording : Recording, optional
        Recording of the run that contains the cycle.
    moves : tuple of Move, optional
        Moves of the bodies, by their starts.
    """

    title: str
    cycle: Cycle
    air: Mapping[str, float]
    rows: tuple[BalanceRow, ...]
    flow_paths: tuple[FlowPathAir, ...]
    parts: tuple[PartRow, ...]
    leaks: tuple[LeakRow, ...] = ()
    savings: tuple[SavingRow, ...] = ()
    tariff: Tariff | None = None
    notes: tuple[Note, ...] = ()
    recording: Recording | None = field(default=None, repr=False)
    moves: tuple[Move, ...] = ()

    @property
    def air_used(self) -> float:
        """Air that all reservoirs and sources supply per cycle [m^3 ANR]."""
        return sum(self.air.values())

    def total(self, *categories: str, quantity: str = "exergy") -> float:
        """Return the sum of all rows of some categories [J].

        Parameters
        ----------
        *categories : str
            Elements of `CATEGORIES`.
        quantity : str, optional
            `exergy` or `energy`.
        """
        return math.fsum(getattr(row, quantity) for row in self.rows if row.category in categories)

    @property
    def exergy_supplied(self) -> float:
        """Exergy that all reservoirs and sources supply per cycle [J]."""
        return self.total(SUPPLIED)

    @property
    def work(self) -> float:
        """Net work on loads and weights per cycle [J]."""
        return self.total(WORK)

    @property
    def cost(self) -> float:
        """Cost of the air per cycle in the currency of the tariff; NaN without a price."""
        return math.nan if self.tariff is None else self.tariff.cost(self.air_used)

    @property
    def co2(self) -> float:
        """Mass of CO2 per cycle [kg]; NaN without an emission in the tariff."""
        return math.nan if self.tariff is None else self.tariff.co2(self.air_used)

    def shown_air(self, part: PartRow) -> float:
        """Return the air of a part for tables [m^3 ANR]: 0 if it is less than 0.1 % of the total.

        The division between parts is not more accurate.

        Parameters
        ----------
        part : PartRow
            Air and exergy of a part.
        """
        return part.air if abs(part.air) >= SMALLEST_AIR * self.air_used else 0.0

    def residual(self, quantity: str = "exergy") -> float:
        """Return the supplied energy or exergy minus all other rows, relative to the size of the balance.

        This size is the sum of the absolute energies of all rows, or that of the exergies if it is larger: the energy
        of all rows can be zero, because compressed air at ambient temperature has no energy relative to the ambient.

        Parameters
        ----------
        quantity : str, optional
            `exergy` or `energy`.
        """
        values = [getattr(row, quantity) * (1.0 if row.category == SUPPLIED else -1.0) for row in self.rows]
        scale = max(math.fsum(abs(getattr(row, name)) for row in self.rows) for name in ("energy", "exergy"))
        return math.fsum(values) / scale if scale > 0.0 else 0.0

    def content(self) -> dict[str, Any]:
        """Return the content of the result file of an energy audit as nested tables."""
        cycle = self.cycle
        return {
            "method": "audit energy",
            "title": self.title,
            "cycle": {
                "duration_s": cycle.duration,
                "air_l_anr": self.air_used / LITRE,
                "exergy_supplied_j": self.exergy_supplied,
                "work_j": self.work,
                "cost": _known(self.cost),
                "currency": self.tariff.currency if self.tariff is not None and self.tariff.currency else None,
                "co2_kg": _known(self.co2),
                "start_s": cycle.start,
                "end_s": cycle.end,
                "count": cycle.count,
                "found_by": cycle.found_by,
                "source": cycle.source,
                "steps": list(cycle.steps),
                "change": cycle.change,
                "exergy_residual": self.residual(),
                "energy_residual": self.residual("energy"),
            },
            "air_l_anr": {name: volume / LITRE for name, volume in self.air.items()},
            "findings": [str(note) for note in grouped(self.notes)],
            "leaks": [
                {"part": leak.part, "flow_path": leak.flow_path, "air_l_anr_per_cycle": leak.air / LITRE,
                 "air_l_anr_per_min": leak.air / LITRE * 60.0 / cycle.duration, "exergy_j": leak.exergy,
                 "cost_per_year": _known(leak.cost_per_year)}
                for leak in self.leaks
            ],
            "parts": [
                {"part": row.part, "air_l_anr": row.air / LITRE, "exergy_lost_j": row.exergy_lost,
                 "category": row.category}
                for row in self.parts
            ],
            "savings": [
                {"measure": row.measure, "air_l_anr": row.air / LITRE, "exergy_j": row.exergy,
                 "cost_per_year": _known(row.cost_per_year), "co2_kg_per_year": _known(row.co2_per_year),
                 "cycle_time_s": row.cycle_time, "is_bound": row.is_bound}
                for row in self.savings
            ],
            "moves": [move.plain() for move in self.moves],
            "balance": [
                {"name": row.name, "part": row.part, "category": row.category, "energy_j": row.energy,
                 "exergy_j": row.exergy}
                for row in self.rows
            ],
            "flow_paths": [
                {"name": path.name, "part": path.part, "source": path.source, "target": path.target,
                 "air_l_anr": path.air / LITRE, "forward_l_anr": path.forward / LITRE,
                 "throttling_j": path.throttling}
                for path in self.flow_paths
            ],
        }  # fmt: skip


def _known(value: float) -> float | None:
    """Return a value, or None for NaN, which a result file omits."""
    return None if math.isnan(value) else value
