"""An ensemble in a notebook: the yield, and how metrics are spread."""

from __future__ import annotations

from poppet.ensemble import Ensemble
from poppet.report.ensemble.ensemble_tables import metric_table, yield_table
from poppet.report.notebook.card import card


def shown(found: Ensemble) -> str:
    """An ensemble as HTML."""
    tables = (table.html() for table in (yield_table(found), metric_table(found)) if table.rows)
    return card(found.plan.circuit.title, f"Ensemble of {found.done} runs", *tables)
