"""HTML output of circuits, recordings, linear models, ensembles and results in notebooks."""

from __future__ import annotations

import importlib
from typing import Any

CARDS = {
    "poppet.circuit.circuit.BaseCircuit": "circuit_card",
    "poppet.timeseries.recording.Recording": "recording_card",
    "poppet.circuit.linear_model.LinearModel": "linear_card",
    "poppet.identify.result.Result": "identification_card",
    "poppet.bench.iso10094.bench_result.BenchResult": "bench_card",
    "poppet.bench.limits.maps.LimitsResult": "limits_card",
    "poppet.ensemble.ensemble_result.Ensemble": "ensemble_card",
    "poppet.control.tuning.Tuning": "tuning_card",
}
"""Mapping from the name of a class to the function in `poppet.report.notebook.cards`, imported at the first call."""


def html_of(value: Any) -> str | None:
    """Return an object as HTML for a notebook.

    The result is None if there is no HTML form for the object: the notebook then shows its text.

    Examples
    --------
    >>> from poppet import Recording
    >>> html_of(Recording.from_series([0.0, 1.0], {"tank.pressure [Pa]": [1e5, 2e5]})).startswith("<div")
    True
    """
    for cls in type(value).__mro__:
        if name := CARDS.get(f"{cls.__module__}.{cls.__qualname__}"):
            text: str = getattr(importlib.import_module("poppet.report.notebook.cards"), name)(value)
            return text
    return None
