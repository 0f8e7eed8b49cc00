"""Assignment of series to panels of a figure and to rows of a timeline."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import InputError, NameSuggestion, UnitError
from poppet.core.number_format import USUAL
from poppet.core.units import check_unit, convert, same_dimension
from poppet.laws.iso6358 import REGIMES
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.columns import Columns

# SI unit of the dimension, quantity, usual size in the drawing unit, in the order of the panels.
# Other quantities come last, with their own unit.
_QUANTITIES: tuple[tuple[str, str, float], ...] = (
    ("Pa", "pressure", 1.0),
    ("K", "temperature", 300.0),
    ("m", "stroke", 1.0),
    ("m/s", "velocity", 100.0),
    ("N", "force", 100.0),
    ("rad", "angle", 1.0),
    ("rad/s", "angular velocity", 10.0),
    ("N m", "torque", 10.0),
    ("J", "energy", 10.0),
    ("1", "ratio", 1.0),
    ("kg/s", "mass flow rate", 1.0),
    ("W", "power", 10.0),
    ("kg", "mass", 1.0),
    ("m^3", "volume", 1.0),
)
_COUNT = "number"
# Units of the panels after position and velocity in figures with moving loads, in this order.
_OF_LOADS = ("Pa", "N", "N m")
AFTER_LOADS = ("K", "W", "kg")  # units of the series that such figures omit by default
STILL = 1e-6  # range of a series, relative to its own or usual size, below which the series is solver noise


@dataclass(frozen=True)
class Series:
    """One series of a recording, in the unit in which it is drawn.

    `source` is the index of the recording. `rank` determines the order of the panels: it is the index of the physical
    quantity. A band, such as that of the cells of a tube, extends from `values` to `high`.
    """

    name: str
    source: int
    time: FloatArray
    values: FloatArray
    unit: str
    quantity: str
    rank: int
    high: FloatArray | None = None

    @property
    def is_still(self) -> bool:
        """True if the series is constant, except for numerical noise of the solver."""
        edges = self.values if self.high is None else np.concatenate([self.values, self.high])
        finite = edges[np.isfinite(edges)]
        if not finite.size:
            return True
        usual = _QUANTITIES[self.rank][2] if self.rank < len(_QUANTITIES) else 0.0
        return bool(np.ptp(finite) <= STILL * max(float(np.max(np.abs(finite))), usual))

    @property
    def is_staircase(self) -> bool:
        """True if the series jumps and is constant between jumps."""
        is_change = np.diff(self.values) != 0.0
        return bool(
            self.high is None and is_change.any() and not np.any(is_change[1:] & is_change[:-1]) and is_change.size > 1
        )

    @property
    def is_count(self) -> bool:
        """True for a number without unit that takes only whole values, some of them above 1, such as a step."""
        finite = self.values[np.isfinite(self.values)]
        return self.quantity == "ratio" and bool(np.any(finite > 1.0) and np.all(finite == np.round(finite)))


@dataclass(frozen=True)
class Panel:
    """Group of series that are drawn on the same axes."""

    quantity: str
    unit: str
    series: tuple[Series, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the series in the panel, without duplicates."""
        return tuple(dict.fromkeys(series.name for series in self.series))

    @property
    def labels(self) -> dict[str, str]:
        """Mapping from the name of each series to its legend label."""
        return readable(self.names, self.quantity)


def chosen_names(recordings: Sequence[Columns], select: str | Iterable[str] | None) -> tuple[str, ...] | None:
    """Return the names of all series that match the patterns in `select`.

    The result is None, which means all series, if `select` is None.
    """
    if select is None:
        return None
    names = tuple(dict.fromkeys(name for recording in recordings for name in recording.names))
    selected: dict[str, None] = {}
    for pattern in [select] if isinstance(select, str) else select:
        matches = [name for name in names if name == pattern or fnmatchcase(name, pattern)]
        if not matches:
            near = NameSuggestion(pattern, names)
            raise InputError("names.unknown", pattern, meaning="an output of any recording", suggestion=near)
        selected.update(dict.fromkeys(matches))
    return tuple(selected)


def shown_series(
    recordings: Sequence[Columns], names: tuple[str, ...] | None, units: Mapping[str, str] | Sequence[str] | str | None
) -> list[Series]:
    """Return the series to draw, in their usual or requested units.

    `names` are the selected names. If it is None, all series are selected. `units` are the requested units.
    """
    # Pairs of a pattern and its requested unit; an empty pattern matches the whole quantity.
    if isinstance(units, Mapping):
        requests = list(units.items())
    else:
        requests = [("", unit) for unit in ([units] if isinstance(units, str) else units or ())]
    for _, unit in requests:
        check_unit(unit)
    applied: set[int] = set()
    series = []
    for source, recording in enumerate(recordings):
        own_names = recording.names if names is None else [name for name in names if name in recording]
        series += [_series(recording, source, name, requests, applied) for name in own_names]
    for index, (pattern, unit) in enumerate(requests):
        if index not in applied:
            candidates = {item.name if pattern else item.unit for item in series}
            near = NameSuggestion(pattern or unit, candidates)
            raise InputError("drawing.unused_unit", name=pattern or unit, suggestion=near)
    return series


def bodies_of(recordings: Sequence[Columns]) -> set[str]:
    """Return the names of all bodies for which position and acceleration are recorded."""
    names = (name for recording in recordings for name in recording.names)
    bodies = {name.rpartition(".")[0] for name in names if name.endswith(".acceleration")}
    return {body for body in bodies if any(f"{body}.position" in recording for recording in recordings)}


def panels_of(
    series: Sequence[Series], *, keep_still: bool = False, bodies: Collection[str] = ()
) -> tuple[list[Panel], list[Series]]:
    """Group series of the same quantity and unit into panels; return the panels and the omitted series.

    Constant series are omitted, unless the keyword `keep_still` is True. If the keyword `bodies` contains names of
    moving bodies, the panels of positions and velocities come first.
    """
    moving = {item.name for item in series if keep_still or not item.is_still}
    moving = moving or {item.name for item in series}  # if all series are constant, all are drawn
    omitted = {item.name: item for item in reversed(series) if item.name not in moving}
    groups: dict[tuple[int, str, str], list[Series]] = {}
    for item in series:
        if item.name in moving:
            quantity = _COUNT if item.is_count else item.quantity
            groups.setdefault((item.rank, quantity, item.unit), []).append(item)
    ranked: list[tuple[tuple[int, int], Panel]] = []
    for (rank, quantity, unit), members in groups.items():
        order = 0
        if bodies:
            # Positions come first, then velocities, pressures, forces and torques.
            names = {item.name for item in members}
            motions = [any(f"{body}.{motion}" in names for body in bodies) for motion in ("position", "velocity")]
            reference = _QUANTITIES[rank][0] if rank < len(_QUANTITIES) else ""
            order = [*motions, *(reference == load for load in _OF_LOADS), True].index(True)
        phrases = {item.name.rpartition(".")[2].replace("_", " ") for item in members}
        title = quantity
        if quantity == "stroke" and "position" in phrases:
            title = "position"
        elif len(phrases) == 1 and quantity in ("ratio", _COUNT, "stroke", "angle", "power", ""):
            # The quantity is unspecific: the title is the common name of the series.
            title = phrases.pop()
        ranked.append(((order, rank), Panel(title, unit, tuple(members))))
    ranked.sort(key=lambda item: item[0])
    return [panel for _, panel in ranked], list(reversed(omitted.values()))


def thinned(time: FloatArray, values: FloatArray, columns: int) -> NDArray[np.int64]:
    """Return the indices of the samples that are sufficient for drawing a line.

    `columns` is the number of pixel columns. For each column, the first, last, lowest and highest sample remain.

    Examples
    --------
    >>> values = np.zeros(10_000)
    >>> values[4321] = 1.0
    >>> kept = thinned(np.arange(10_000.0), values, 100)
    >>> bool(4321 in kept), len(kept) <= 500
    (True, True)
    """
    if len(time) <= 5 * columns:
        return np.arange(len(time))
    # Columns of equal time, not of equal count: a column can contain many samples.
    edges = np.unique(np.searchsorted(time, np.linspace(time[0], time[-1], columns + 1)[:-1]))
    is_nan = np.isnan(values)
    low, high = np.where(is_nan, np.inf, values), np.where(is_nan, -np.inf, values)
    parts = [edges, np.append(edges[1:], len(time)) - 1]
    for start, end in zip(edges, np.append(edges[1:], len(time)), strict=True):
        # The first NaN of a column preserves the gap in the line.
        offsets = low[start:end].argmin(), high[start:end].argmax(), is_nan[start:end].argmax()
        parts.append(start + np.array(offsets))
    return np.unique(np.concatenate(parts))


def draw_thinned(axes: Any, x: FloatArray, y: FloatArray, indices: NDArray[np.int64], **options: Any) -> None:
    """Draw a line `y` versus `x` through the samples with the given indices.

    The line object also stores all other samples, for figures that can be enlarged.
    """
    (line,) = axes.plot(x[indices], y[indices], **options)
    if len(indices) < len(x):
        line.whole = x, y


def whole_of(line: Any) -> tuple[FloatArray, FloatArray]:
    """Return all samples of a line from `draw_thinned`, including samples that were not drawn."""
    samples: tuple[FloatArray, FloatArray] = getattr(line, "whole", None) or line.get_data()
    return samples


def readable(names: Sequence[str], quantity: str) -> dict[str, str]:
    """Return short legend labels for series of one quantity, by series name.

    A label consists of the name of the part and the rest of the series name. The name of the quantity is omitted,
    because the axis shows it.

    Examples
    --------
    >>> readable(["tank.pressure", "valve.pilot_pressure"], "pressure")
    {'tank.pressure': 'tank', 'valve.pilot_pressure': 'valve: pilot'}
    """
    labels = {}
    for name in names:
        part, _, output = name.partition(".")
        phrase = output.replace("_", " ").replace(".", " ")
        labels[name] = f"{part}: {phrase.removesuffix(f' {quantity}')}" if output and phrase != quantity else part
    texts = list(labels.values())
    # Series with equal labels have their full names.
    return {name: label if texts.count(label) == 1 else name for name, label in labels.items()}


def _series(
    recording: Columns, source: int, name: str, requests: Sequence[tuple[str, str]], applied: set[int]
) -> Series:
    recorded_unit = recording.unit(name) or "1"
    ranks = [k for k, (si, _, _) in enumerate(_QUANTITIES) if same_dimension(recorded_unit, si)] or [len(_QUANTITIES)]
    # Energy and torque have the same dimension, so the text of the unit distinguishes them.
    rank = ranks[-1 if "J" in recorded_unit else 0]
    reference, quantity, _ = (*_QUANTITIES, (recorded_unit, "", 0.0))[rank]
    unit = USUAL.get(reference, reference) if rank < len(_QUANTITIES) else recorded_unit
    for index, (pattern, requested) in enumerate(requests):
        if pattern and (pattern == name or fnmatchcase(name, pattern)):
            if not same_dimension(recorded_unit, requested):
                raise UnitError("series.other_quantity", name=name, unit=recorded_unit, asked=requested)
        elif pattern or not same_dimension(recorded_unit, requested):
            continue
        unit = requested
        applied.add(index)
    values = recording[name]
    if unit != recorded_unit:
        values = convert(values, recorded_unit, unit, ambient_pressure=recording.ambient_pressure)
    return Series(name, source, recording.time, values, unit, quantity, rank)


_USUAL_FLOW = 1e-3  # [kg/s]
CONTACTS: dict[int, str] = {
    -2: "lower stop",
    -1: "exhaust open",
    0: "both seats closed",
    1: "supply open",
    2: "upper stop",
}
"""Meaning of each code of the output `contact` of a main stage."""

_REGIME_COLOURS = {0: "#dfe2e7", 1: "#f3c76b", 2: "#5b9bd5", 3: "#1f4e87"}
_CONTACT_COLOURS = {-2: "#7a4b1e", -1: "#d9822b", 0: "#dfe2e7", 1: "#3d9a5f", 2: "#14532d"}


@dataclass(frozen=True)
class CodeStyle:
    """Text, colour and hatching of a state code in a figure.

    A state code is an integer in a series, for example a flow regime. The timeline below the panels shows these codes.
    """

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
# Rows of a timeline, from top to bottom.
BANDS = (("friction", FRICTION_LOOKS), ("flow\nregime", REGIME_LOOKS), ("contact", CONTACT_LOOKS))


@dataclass(frozen=True)
class Span:
    """Time interval in which a series has one state code, with start and width [s]."""

    start: float
    width: float
    code: int


@dataclass(frozen=True)
class Band:
    """Row of the timeline, which shows one series of state codes such as flow regimes.

    `is_thinned` is True if the codes change faster than the figure can show.
    """

    name: str
    label: str
    source: int
    looks: dict[int, CodeStyle]
    spans: tuple[Span, ...]
    is_thinned: bool


def code_styles(name: str, unit: str, values: FloatArray) -> dict[int, CodeStyle] | None:
    """Return the style of each state code that a series can contain.

    The result is None if the series does not contain state codes, such as flow regimes.
    """
    last = name.rpartition(".")[2]
    styles = {"contact": CONTACT_LOOKS, "regime": REGIME_LOOKS}.get(last.rpartition("_")[2])
    styles = FRICTION_LOOKS if last == "friction_state" else styles
    if styles is None or unit not in ("", "1"):
        return None
    finite = values[np.isfinite(values)]
    return styles if np.isin(finite, list(styles)).all() else None


def bands_of(recordings: Sequence[Columns], names: tuple[str, ...] | None, columns: int) -> list[Band]:
    """Return the rows of the timeline, one for each series of state codes.

    They are ordered by kind of code, series and recording. `names` contains the names of the series. If it is None, all
    series are selected. `columns` is the width of the figure in pixels.
    """
    bands = []
    for source, recording in enumerate(recordings):
        for name in recording.names if names is None else names:
            if name not in recording:
                continue
            styles = code_styles(name, recording.unit(name), recording[name])
            if styles is not None:
                spans, is_thinned = spans_of(recording.time, displayed_codes(recording, name), columns)
                bands.append(Band(name, _label(name), source, styles, spans, is_thinned))
    order = list(dict.fromkeys(band.name for band in bands))
    ranks = [id(styles) for _, styles in BANDS]
    return sorted(bands, key=lambda band: (ranks.index(id(band.looks)), order.index(band.name), band.source))


def displayed_codes(recording: Columns, name: str) -> FloatArray:
    """Return the state codes of a series, in which negligible flows count as no flow.

    Only flow regimes change: near equal pressures, numerical noise would otherwise switch between regimes. `name` is
    the name of the series.

    Examples
    --------
    >>> flow, regime = [1e-3, 1e-13, -1e-13, 0.0], [2.0, 1.0, -1.0, 0.0]
    >>> series = {"valve.mass_flow_rate [kg/s]": flow, "valve.regime [1]": regime}
    >>> displayed_codes(Columns.from_series([0.0, 1.0, 2.0, 3.0], series), "valve.regime").tolist()
    [2.0, 0.0, 0.0, 0.0]
    """
    codes, flow = recording[name], f"{name.removesuffix('regime')}mass_flow_rate"
    if not name.endswith("regime") or flow not in recording or not same_dimension(recording.unit(flow), "kg/s"):
        return codes
    size = np.abs(convert(recording[flow], recording.unit(flow), "kg/s"))
    limit = STILL * max(float(np.max(size[np.isfinite(size)], initial=0.0)), _USUAL_FLOW)
    return np.where((size <= limit) & (np.abs(codes) <= 1.0), 0.0, codes)


def spans_of(time: FloatArray, codes: FloatArray, columns: int) -> tuple[tuple[Span, ...], bool]:
    """Convert a series of state codes to time intervals of constant code.

    A code is valid from its sample to the next one. The second result is True if the codes change too fast for a figure
    with `columns` pixel columns.

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
        # The code with the longest total duration in each interval between edges.
        kinds = np.unique(values[np.isfinite(values)])
        durations = np.zeros((kinds.size, columns))
        for row, kind in zip(durations, kinds, strict=True):
            # Total duration so far, linear between samples, so differences between edges are exact.
            total = np.concatenate(([0.0], np.cumsum(np.where(values == kind, np.diff(time), 0.0))))
            row[:] = np.diff(np.interp(edges, time, total))
        values = kinds[durations.argmax(axis=0)] if kinds.size else np.full(columns, np.nan)
    first = np.flatnonzero(np.diff(values, prepend=np.nan) != 0.0)
    ends = np.append(edges[first[1:]], edges[-1])
    known = [(k, end) for k, end in zip(first, ends, strict=True) if np.isfinite(values[k])]
    return tuple(Span(float(edges[k]), float(end - edges[k]), int(values[k])) for k, end in known), is_thinned


def _label(name: str) -> str:
    last = name.rpartition(".")[2]
    quantity = {"contact": "contact", "friction_state": "friction state"}.get(last, "regime")
    return readable([name], quantity)[name]
