"""What a notebook shows of circuits, recordings, linear models, ensembles and results, one module for each."""

from __future__ import annotations

import importlib
from typing import Any

PAGES = {
    "poppet.circuit.circuit.BaseCircuit": "circuit",
    "poppet.timeseries.recording.Recording": "recording",
    "poppet.circuit.linear_model.LinearModel": "linear",
    "poppet.identify.result.Result": "results",
    "poppet.bench.iso10094.bench_result.BenchResult": "results",
    "poppet.bench.limits.maps.LimitsResult": "results",
    "poppet.ensemble.ensemble_result.Ensemble": "ensemble",
}
"""Class to the module that shows it: nothing is imported before something of its kind is shown."""


def html_of(thing: Any) -> str | None:
    """HTML of something that a notebook is to show, or None where its text will do.

    Examples
    --------
    >>> from poppet import Recording
    >>> html_of(Recording.from_series([0.0, 1.0], {"tank.pressure [Pa]": [1e5, 2e5]})).startswith("<div")
    True
    """
    for kind in type(thing).__mro__:
        page = PAGES.get(f"{kind.__module__}.{kind.__qualname__}")
        if page:
            text: str = importlib.import_module(f"poppet.report.notebook.{page}").shown(thing)
            return text
    return None
