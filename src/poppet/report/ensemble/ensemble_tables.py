"""Tables of an ensemble, for terminals and pages."""

from __future__ import annotations

import math

from poppet.core.number_format import USUAL, pretty, scaled
from poppet.ensemble import Ensemble
from poppet.report.tables import Column, Table

SHOWN = (0.05, 0.5, 0.95)
"""Quantiles of a metric that a table shows."""


def in_usual(value: float, unit: str) -> float:
    """A value of a metric or number as people read it."""
    return float(scaled(value, unit, USUAL.get(unit, unit)))


def usual(unit: str) -> str:
    """The unit of that, as print has it; nothing where there is none."""
    return "" if unit == "1" else pretty(USUAL.get(unit, unit))


def yield_table(found: Ensemble) -> Table:
    """Share of good runs for each requirement, with its interval."""
    rows = tuple(
        (y.name, y.text or "all requirements", y.good, 100.0 * y.share, f"{100.0 * y.low:.4g} ... {100.0 * y.high:.4g}")
        for y in found.yields()
    )
    columns = (
        Column("requirement"),
        Column(""),
        Column("good runs", "d"),
        Column("yield [%]", ".4g"),
        Column("95 % [%]"),
    )
    return Table("yield", "", columns, rows)


def metric_table(found: Ensemble) -> Table:
    """Mean, spread and quantiles of every metric."""
    rows = []
    for s in found.summaries():
        values = s.mean, *(s.quantiles.get(q, math.nan) for q in SHOWN), s.least, s.greatest
        mean, *rest = (in_usual(value, s.unit) for value in values)
        # Of a temperature in degC the spread is one of kelvins.
        spread = in_usual(s.mean + s.sd, s.unit) - mean
        rows.append((s.name, usual(s.unit), mean, spread, *rest, s.never, s.failed))
    heads = ("mean", "sd", *(f"{100 * q:g} %" for q in SHOWN), "least", "greatest")
    columns = (
        *(Column("metric"), Column("unit"), *(Column(head, ".4g") for head in heads)),
        *(Column("never", "d"), Column("no value", "d")),
    )
    return Table("metrics", "", columns, tuple(rows))


def worst_table(found: Ensemble, units: dict[str, str], count: int = 3) -> Table:
    """The worst runs of each requirement, with their numbers."""
    metrics = {metric.name: metric for metric in found.plan.metrics}
    of = {each.name: metrics[each.metric] for each in found.plan.requirements}
    rows = []
    for name, cases in found.worst(count).items():
        for case in cases:
            value = in_usual(case.value, of[name].unit)
            told = f"{value:.4g}\N{NO-BREAK SPACE}{usual(of[name].unit)}" if math.isfinite(case.margin) else "failed"
            told = "never" if case.value == math.inf else told
            numbers = (in_usual(value, units[address]) for address, value in case.numbers.items())
            rows.append((name, case.run, told.strip(), *numbers))
    heads = (f"{address} [{usual(units[address])}]".replace(" []", "") for address in found.plan.addresses)
    columns = Column("requirement"), Column("run", "d"), Column("metric"), *(Column(head, ".4g") for head in heads)
    return Table("worst", "", columns, tuple(rows))
