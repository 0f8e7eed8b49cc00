"""Statements of the paper of Varga & Keski-Honkola (2012), with verdicts.

The texts are in `messages/paper.toml`.
"""

from __future__ import annotations

import enum
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.core.message_format import sentence
from poppet.report.varga2012.runs import REPORTED_RISE, START_TEMPERATURE, SUPPLIES, SUPPLY, TANKS, Findings


class Verdict(enum.Enum):
    """Verdict on a statement of the paper; the value is the printed text."""

    HOLDS = "holds"
    FAILS = "does not hold"
    OPEN = "cannot be told"


@dataclass(frozen=True)
class Statement:
    """Statement of the paper: code, verdict, and the values in the text of the finding."""

    code: str
    verdict: Verdict
    facts: Mapping[str, Any]

    @property
    def text(self) -> str:
        """Text of the statement."""
        return sentence(f"{self.code}.text", {})

    @property
    def place(self) -> str:
        """Location of the statement in the paper."""
        return sentence(f"{self.code}.place", {})

    @property
    def finding(self) -> str:
        """Text on the simulation result that supports the verdict."""
        return sentence(f"{self.code}.finding", self.facts)


def statements(results: Findings) -> tuple[Statement, ...]:
    """Return all statements of the paper with their verdicts."""
    verdicts = {True: Verdict.HOLDS, False: Verdict.FAILS, None: Verdict.OPEN}
    return tuple(
        Statement(f"paper.{name}", verdicts[None if holds is None else bool(holds)], facts)
        for name, holds, facts in _judged(results)
    )


def _judged(results: Findings) -> Iterator[tuple[str, bool | None, dict[str, Any]]]:
    """Yield the name, the truth and the facts of each statement.

    The truth is None if the statement cannot be decided. The facts are in the units of the text.
    """
    c, b, (stroke, largest) = results.conductances, results.ratios, results.largest
    smallest_stroke, smallest = results.smallest_ratio
    fill = results.fillings
    isentrope, adiabatic, walled = fill["isentrope"], fill["adiabatic"], fill["wall of the peak"]
    isothermal, polytropic = fill["isothermal"].time, fill["polytropic"].time
    settling = {"settling": 1e3 * results.settling_time}
    first, greatest = {"first": 1e8 * c[0]}, {"largest": 1e8 * largest}

    # The flow law.
    yield "law", results.law_deviation < 1e-9, {"deviation": results.law_deviation}
    yield "downstream", abs(results.downstream_error) < 1e-3, {"per_cent": 100.0 * results.downstream_error}
    is_physical = min(c) > 0.0 and min(b) > 0.0 and max(b) < 1.0
    yield "range", is_physical, {"zero": 1e3 * results.zero_beyond, "beyond": 1e8 * results.conductance_beyond}

    # The characteristic.
    ratios = {"lowest_ratio": smallest, "lowest_stroke": 1e3 * smallest_stroke, "first_ratio": b[0]}
    spread = {**first, **greatest, **ratios, "growth": largest / c[0], "stroke": 1e3 * stroke}
    yield "nonlinear", largest > 1.1 * c[0] and b[0] > 1.1 * smallest, spread
    hump = {"fall": 100.0 * (1.0 - c[-1] / largest), "suspected": 1e8 * results.suspected_largest}
    yield "drawn", None, greatest | hump  # the points of the figure are not in the text
    yield "closing", c[0] < 1e-3 * largest, first | {"share": 100.0 * c[0] / largest, "leak": 1e3 * results.leak}

    # Mechanics.
    strokes = results.exhaust_strokes
    yield "emptying", max(strokes) - min(strokes) < 1e-9, {"strokes": [1e6 * x for x in strokes]}
    printed, from_figure = results.stroke_printed, results.stroke_fig5
    yield "fig5", abs(from_figure - printed) < 1e-3 * printed, {"printed": 1e3 * printed, "drawn": 1e3 * from_figure}
    low, high = results.open_end
    yield "following", max(low, high) < 0.99 * SUPPLY, {"low": 1e-5 * low, "high": 1e-5 * high}
    yield "slow", results.settling_time < 1e-2 * walled.time, settling | {"filling": walled.time}
    yield "faster", None, settling  # no response of the real valve is given

    # The tank.
    rise = isentrope.end_temperature - START_TEMPERATURE
    warmed = {"isentrope": rise, "adiabatic": adiabatic.end_temperature - START_TEMPERATURE}
    walls = {"walls": [wall.for_peak for wall in results.walls], "supplies": [1e-5 * p for p in SUPPLIES]}
    reported = {"reported": REPORTED_RISE, "exponent": results.exponent}
    yield "warming", abs(rise - REPORTED_RISE) < 0.5 * REPORTED_RISE, warmed | reported | walls
    times = {"isentrope": isentrope.time, "adiabatic": adiabatic.time}
    ends = {"isentrope_end": isentrope.end_temperature, "adiabatic_end": adiabatic.end_temperature}
    yield "no_heat", abs(isentrope.time - adiabatic.time) < 1e-2 * adiabatic.time, times | ends
    times = {"isentrope": isentrope.time, "walled": walled.time, "isothermal": isothermal}
    excess = {"least": walled.time / isentrope.time, "most": isothermal / isentrope.time}
    yield "measured_slower", walled.time > isentrope.time, times | excess | {"wall": results.wall.for_peak}

    # Conclusions.
    by_heat, by_law = walled.time - adiabatic.time, adiabatic.time - isentrope.time
    shares = {"difference": walled.time - isentrope.time, "by_heat": by_heat, "by_law": by_law}
    yield "heat", by_heat > by_law and results.pressure_drop > 0.0, shares | {"drop": 1e-5 * results.pressure_drop}
    times = {"polytropic": polytropic, "walled": walled.time, "isentrope": isentrope.time}
    is_near = abs(polytropic - walled.time) < 0.1 * abs(isentrope.time - walled.time)
    yield "polytropic", is_near, times | {"exponent": results.exponent}
    slow, constant = results.slow_time, results.slow_time_constant
    yield "precise", slow > 1.1 * constant, {"slow": slow, "constant": constant}
    lowest, highest, miss = _staircase(results)
    facts = {"low": lowest, "high": highest, "miss": 100.0 * miss}
    yield "staircase", miss < 1e-2 and lowest > 0.999 and highest < 5.5, facts
    yield "works_well", None, {}  # the points of fig. 6 are not in the text


def _staircase(results: Findings) -> tuple[float, float, float]:
    """Return the minimum and the maximum pressure [bar], and the maximum relative error at the end of a step.

    They are taken over all tanks.
    """
    run = results.staircase
    required = run["required.pressure"]
    ends = np.append(np.flatnonzero(np.diff(required)), required.size - 1)
    rows = np.array([run[f"{tank}.pressure"] for tank in TANKS])
    miss = float(np.max(np.abs(rows[:, ends] / required[ends] - 1.0)))
    return 1e-5 * float(rows.min()), 1e-5 * float(rows.max()), miss
