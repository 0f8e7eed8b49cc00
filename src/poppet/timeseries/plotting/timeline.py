"""What codes over time mean: the regime of every flow, where the plate of a valve is, whether a body sticks."""

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
"""What the codes of a main stage's `contact` mean."""

_REGIME_COLOURS = {0: "#dfe2e7", 1: "#f3c76b", 2: "#5b9bd5", 3: "#1f4e87"}
_CONTACT_COLOURS = {-2: "#7a4b1e", -1: "#d9822b", 0: "#dfe2e7", 1: "#3d9a5f", 2: "#14532d"}


@dataclass(frozen=True)
class CodeStyle:
    """How a code is drawn: its meaning, its colour, and whether it is hatched."""

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
"""What the rows of a timeline show, from top to bottom."""


@dataclass(frozen=True)
class Span:
    """A time over which a code holds: from `start`, `width` long [s]."""

    start: float
    width: float
    code: int


@dataclass(frozen=True)
class Band:
    """One row of the timeline; `is_thinned` where codes change faster than the picture can show."""

    name: str
    label: str
    source: int
    looks: dict[int, CodeStyle]
    spans: tuple[Span, ...]
    is_thinned: bool


def looks_of(name: str, unit: str, values: FloatArray) -> dict[int, CodeStyle] | None:
    """How the codes of a series are drawn."""
    last = name.rpartition(".")[2]
    looks = {"contact": CONTACT_LOOKS, "regime": REGIME_LOOKS}.get(last.rpartition("_")[2])
    looks = FRICTION_LOOKS if last == "friction_state" else looks
    if looks is None or unit not in ("", "1"):
        return None
    finite = values[np.isfinite(values)]
    return looks if np.isin(finite, list(looks)).all() else None


def bands_of(recordings: Sequence[Columns], names: tuple[str, ...] | None, columns: int) -> list[Band]:
    """Rows of the timeline in the order of `BANDS`, recordings side by side."""
    found = []
    for source, recording in enumerate(recordings):
        for name in recording.names if names is None else names:
            if name not in recording:
                continue
            looks = looks_of(name, recording.unit(name), recording[name])
            if looks is not None:
                spans, is_thinned = spans_of(recording.time, at_rest(recording, name), columns)
                found.append(Band(name, _label(name), source, looks, spans, is_thinned))
    order = list(dict.fromkeys(band.name for band in found))
    ranks = [id(looks) for _, looks in BANDS]
    return sorted(found, key=lambda band: (ranks.index(id(band.looks)), order.index(band.name), band.source))


def at_rest(recording: Columns, name: str) -> FloatArray:
    """Codes of a series, those of a regime as no flow where what flows is the noise of a solver about equal pressures.

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
    least = STILL * max(float(np.max(size[np.isfinite(size)], initial=0.0)), _USUAL_FLOW)
    return np.where((size <= least) & (np.abs(codes) <= 1.0), 0.0, codes)


def spans_of(time: FloatArray, codes: FloatArray, columns: int) -> tuple[tuple[Span, ...], bool]:
    """Codes as spans of time; a code holds from its row to the next.

    Examples
    --------
    >>> spans, is_thinned = spans_of(np.array([0.0, 1.0, 2.0]), np.array([0.0, 3.0, 3.0]), 1000)
    >>> [(span.start, span.width, span.code) for span in spans]
    [(0.0, 1.0, 0), (1.0, 1.0, 3)]
    """
    if len(time) < 2:
        return (), False
    held, edges = codes[:-1], time
    is_thinned = bool(np.count_nonzero(np.diff(held)) > columns)
    if is_thinned:
        edges = np.linspace(time[0], time[-1], columns + 1)
        held = _most_frequent(time, held, edges)
    first = np.flatnonzero(np.diff(held, prepend=np.nan) != 0.0)
    ends = np.append(edges[first[1:]], edges[-1])
    spans = (
        Span(float(edges[k]), float(end - edges[k]), int(held[k]))
        for k, end in zip(first, ends, strict=True)
        if np.isfinite(held[k])
    )
    return tuple(spans), is_thinned


def _most_frequent(time: FloatArray, held: FloatArray, edges: FloatArray) -> FloatArray:
    """The code that holds longest between each two edges."""
    kinds = np.unique(held[np.isfinite(held)])
    if not kinds.size:
        return np.full(len(edges) - 1, np.nan)
    lasting = np.empty((kinds.size, len(edges) - 1))
    for row, kind in zip(lasting, kinds, strict=True):
        # How long it has held so far, a straight line between samples: its difference is exact between any two edges.
        total = np.concatenate(([0.0], np.cumsum(np.where(held == kind, np.diff(time), 0.0))))
        row[:] = np.diff(np.interp(edges, time, total))
    return np.asarray(kinds[lasting.argmax(axis=0)])


def _label(name: str) -> str:
    last = name.rpartition(".")[2]
    quantity = {"contact": "contact", "friction_state": "friction state"}.get(last, "regime")
    return readable([name], quantity)[name]
