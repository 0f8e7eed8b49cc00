"""Tables of an ensemble, for terminals and pages."""

from __future__ import annotations

from poppet.ensemble import Ensemble
from poppet.ground.readable import USUAL, scaled
from poppet.report.tables import Column, Table

SHOWN = (0.05, 0.5, 0.95)
"""Quantiles of a metric that a table shows."""


def shown_unit(unit: str) -> str:
    """The unit in which a metric is shown: its own where its user has chosen one."""
    return "%" if unit == "1" else USUAL.get(unit, unit)


def in_shown(value: float, unit: str) -> float:
    """A value of a metric in that unit."""
    return 100.0 * value if unit == "1" else float(scaled(value, unit, USUAL.get(unit, unit)))


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
        size = (in_shown(v, s.unit) for v in (s.mean, *(s.quantiles.get(q, float("nan")) for q in SHOWN)))
        spread = in_shown(s.mean + s.sd, s.unit) - in_shown(s.mean, s.unit)
        mean, *rest = size
        lost = s.never + s.failed
        unit = "" if s.unit == "1" and not s.name else shown_unit(s.unit)
        rows.append((s.name, unit, mean, spread, *rest, in_shown(s.least, s.unit), in_shown(s.greatest, s.unit), lost))
    heads = ("mean", "sd", *(f"{100 * q:g} %" for q in SHOWN), "least", "greatest")
    columns = Column("metric"), Column("unit"), *(Column(head, ".4g") for head in heads), Column("without", "d")
    return Table("metrics", "", columns, tuple(rows))
