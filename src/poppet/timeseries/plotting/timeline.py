"""Codes over time: flow regimes, position of a valve plate, sticking of bodies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from poppet.core.units import convert, same_dimension
from poppet.laws.iso6358 import REGIMES
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.columns import Columns
from poppet.timeseries.plotting.panels import STILL, readable

_USUAL_FLOW = 1e-3  # [kg/s]
CONTACTS: dict[int, str] = {
    -2: "lower stop",
    -1: "exhaust open",
    0: "both seats closed",
    1: "supply open",
    2: "upper stop",
}
"""Meanings of the codes of `contact` of a main stage."""

_REGIME_COLOURS = {0: "#dfe2e7", 1: "#f3c76b", 2: "#5b9bd5", 3: "#1f4e87"}
_CONTACT_COLOURS = {-2: "#7a4b1e", -1: "#d9822b", 0: "#dfe2e7", 1: "#3d9a5f", 2: "#14532d"}


@dataclass(frozen=True)
class CodeStyle:
    """Meaning, colour and hatching of a code."""

    text: str
    colour: str
    is_hatched: bool = False


REGIME_LOOKS = {
    code: CodeStyle(REGIMES[code], _REGIME_COLOURS[abs(code)], code < 0) for code in (3, 2, 1, 0, -1, -2, -3)
}
REGIME_LOOKS[0] = CodeStyle("no flow", _REGIME_COLOURS[0])
CONTACT_LOOKS = {code: CodeStyle(CONTACTS[code], _CONTACT_COLOURS[code]) for code in (2, 1, 0, -1, -2)}
FRICTION_LOOKS = {
    1: CodeStyle("slips", "#3d9a5f"),
    0: CodeStyle("sticks", "#cbb8a2"),
    -1: CodeStyle("slips back", "#3d9a5f", True),
}
BANDS = (("friction", FRICTION_LOOKS), ("flow\nregime", REGIME_LOOKS), ("contact", CONTACT_LOOKS))
"""Rows of a timeline, from top to bottom."""


@dataclass(frozen=True)
class Span:
    """Time span of a code: start and width [s]."""

    start: float
    width: float
    code: int


@dataclass(frozen=True)
class Band:
    """Row of the timeline; `is_thinned` if codes change faster than the figure can resolve."""

    name: str
    label: str
    source: int
    looks: dict[int, CodeStyle]
    spans: tuple[Span, ...]
    is_thinned: bool


def looks_of(name: str, unit: str, values: FloatArray) -> dict[int, CodeStyle] | None:
    """Return the styles of the codes of a series, None if the series has no codes."""
    last = name.rpartition(".")[2]
    styles = {"contact": CONTACT_LOOKS, "regime": REGIME_LOOKS}.get(last.rpartition("_")[2])
    styles = FRICTION_LOOKS if last == "friction_state" else styles
    if styles is None or unit not in ("", "1"):
        return None
    finite = values[np.isfinite(values)]
    return styles if np.isin(finite, list(styles)).all() else None


def bands_of(recordings: Sequence[Columns], names: tuple[str, ...] | None, columns: int) -> list[Band]:
    """Return the rows of the timeline in the order of `BANDS`, recordings side by side."""
    bands = []
    for source, recording in enumerate(recordings):
        for name in recording.names if names is None else names:
            if name not in recording:
                continue
            styles = looks_of(name, recording.unit(name), recording[name])
            if styles is not None:
                spans, is_thinned = spans_of(recording.time, at_rest(recording, name), columns)
                bands.append(Band(name, _label(name), source, styles, spans, is_thinned))
    order = list(dict.fromkeys(band.name for band in bands))
    ranks = [id(styles) for _, styles in BANDS]
    return sorted(bands, key=lambda band: (ranks.index(id(band.looks)), order.index(band.name), band.source))


def at_rest(recording: Columns, name: str) -> FloatArray:
    """Return the codes of a series; regimes of solver noise near equal pressures become no flow.

    Examples
    --------
    >>> flow, regime = [1e-3, 1e-13, -1e-13, 0.0], [2.0, 1.0, -1.0, 0.0]
    >>> series = {"valve.mass_flow_rate [kg/s]": flow, "valve.regime [1]": regime}
    >>> at_rest(Columns.from_series([0.0, 1.0, 2.0, 3.0], series), "valve.regime").tolist()
    [2.0, 0.0, 0.0, 0.0]
    """
    codes, flow = recording[name], f"{name.removesuffix('regime')}mass_flow_rate"
    if not name.endswith("regime") or flow not in recording or not same_dimension(recording.unit(flow), "kg/s"):
        return codes
    size = np.abs(convert(recording[flow], recording.unit(flow), "kg/s"))
    limit = STILL * max(float(np.max(size[np.isfinite(size)], initial=0.0)), _USUAL_FLOW)
    return np.where((size <= limit) & (np.abs(codes) <= 1.0), 0.0, codes)


def spans_of(time: FloatArray, codes: FloatArray, columns: int) -> tuple[tuple[Span, ...], bool]:
    """Return codes as time spans; a code is valid from its row to the next.

    Examples
    --------
    >>> spans, is_thinned = spans_of(np.array([0.0, 1.0, 2.0]), np.array([0.0, 3.0, 3.0]), 1000)
    >>> [(span.start, span.width, span.code) for span in spans]
    [(0.0, 1.0, 0), (1.0, 1.0, 3)]
    """
    if len(time) < 2:
        return (), False
    values, edges = codes[:-1], time
    is_thinned = bool(np.count_nonzero(np.diff(values)) > columns)
    if is_thinned:
        edges = np.linspace(time[0], time[-1], columns + 1)
        values = _most_frequent(time, values, edges)
    first = np.flatnonzero(np.diff(values, prepend=np.nan) != 0.0)
    ends = np.append(edges[first[1:]], edges[-1])
    spans = (
        Span(float(edges[k]), float(end - edges[k]), int(values[k]))
        for k, end in zip(first, ends, strict=True)
        if np.isfinite(values[k])
    )
    return tuple(spans), is_thinned


def _most_frequent(time: FloatArray, codes: FloatArray, edges: FloatArray) -> FloatArray:
    """Return the code with the longest total duration between adjacent edges."""
    kinds = np.unique(codes[np.isfinite(codes)])
    if not kinds.size:
        return np.full(len(edges) - 1, np.nan)
    durations = np.empty((kinds.size, len(edges) - 1))
    for row, kind in zip(durations, kinds, strict=True):
        # Total duration so far, linear between samples, so differences between edges are exact.
        total = np.concatenate(([0.0], np.cumsum(np.where(codes == kind, np.diff(time), 0.0))))
        row[:] = np.diff(np.interp(edges, time, total))
    return np.asarray(kinds[durations.argmax(axis=0)])


def _label(name: str) -> str:
    last = name.rpartition(".")[2]
    quantity = {"contact": "contact", "friction_state": "friction state"}.get(last, "regime")
    return readable([name], quantity)[name]
