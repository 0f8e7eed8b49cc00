"""Which series of a recording stand together in a figure, in which unit and under which name."""

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
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.columns import Columns

# SI unit of the dimension, what it is called, its usual size in the unit it is shown in.
# In this order they stand in a figure; what is not in the list comes last, under its own unit.
_QUANTITIES: tuple[tuple[str, str, float], ...] = (
    ("Pa", "pressure", 1.0),
    ("K", "temperature", 300.0),
    ("m", "stroke", 1.0),
    ("m/s", "velocity", 100.0),
    ("N", "force", 100.0),
    ("rad", "angle", 1.0),
    ("rad/s", "angular velocity", 10.0),
    ("N m", "torque", 10.0),
    ("1", "ratio", 1.0),
    ("kg/s", "mass flow rate", 1.0),
    ("W", "heat flow rate", 10.0),
    ("kg", "mass", 1.0),
    ("m^3", "volume", 1.0),
)
_OF_LOADS = ("Pa", "N", "N m")
"""What stands behind position and velocity where a load moves, in this order."""
AFTER_LOADS = ("K", "W", "kg")
"""And what is not drawn there unless it is asked for."""
STILL = 1e-6
"""A series whose range is this part of its own or usual size shows nothing but the noise of a solver."""


@dataclass(frozen=True)
class Series:
    """One series of the recording number `source`, in the `unit` in which it is drawn; `rank` orders quantities."""

    name: str
    source: int
    time: FloatArray
    values: FloatArray
    unit: str
    quantity: str
    rank: int

    @property
    def is_still(self) -> bool:
        """True when it shows nothing but one value."""
        finite = self.values[np.isfinite(self.values)]
        if not finite.size:
            return True
        usual = _QUANTITIES[self.rank][2] if self.rank < len(_QUANTITIES) else 0.0
        return bool(np.ptp(finite) <= STILL * max(float(np.max(np.abs(finite))), usual))

    @property
    def is_staircase(self) -> bool:
        """True when it jumps and rests: every change stands alone."""
        changed = np.diff(self.values) != 0.0
        return bool(changed.any() and not np.any(changed[1:] & changed[:-1]) and changed.size > 1)


@dataclass(frozen=True)
class Panel:
    """Series that share an axis, by recording, in the order of the recording."""

    quantity: str
    unit: str
    series: tuple[Series, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the series, each once."""
        return tuple(dict.fromkeys(one.name for one in self.series))

    @property
    def labels(self) -> dict[str, str]:
        """Name to what a legend says."""
        return readable(self.names, self.quantity)


def chosen_names(recordings: Sequence[Columns], select: str | Iterable[str] | None) -> tuple[str, ...] | None:
    """Names that patterns choose."""
    if select is None:
        return None
    names = tuple(dict.fromkeys(name for recording in recordings for name in recording.names))
    found: dict[str, None] = {}
    for pattern in [select] if isinstance(select, str) else select:
        fitting = [name for name in names if name == pattern or fnmatchcase(name, pattern)]
        if not fitting:
            raise InputError("drawing.unknown", name=pattern, near=NameSuggestion(pattern, names))
        found.update(dict.fromkeys(fitting))
    return tuple(found)


def shown_series(
    recordings: Sequence[Columns],
    names: tuple[str, ...] | None,
    units: Mapping[str, str] | Sequence[str] | str | None,
) -> list[Series]:
    """Series of several recordings in the units a reader expects, or asked for."""
    wanted = _wanted(units)
    used: set[int] = set()
    found = []
    for source, recording in enumerate(recordings):
        own = recording.names if names is None else [name for name in names if name in recording]
        found += [_series(recording, source, name, wanted, used) for name in own]
    for place, (pattern, unit) in enumerate(wanted):
        if place not in used:
            known = {one.name if pattern else one.unit for one in found}
            raise InputError("drawing.unused_unit", name=pattern or unit, near=NameSuggestion(pattern or unit, known))
    return found


def bodies_of(recordings: Sequence[Columns]) -> set[str]:
    """Names of the bodies that move in some recordings."""
    found = {name.rpartition(".")[0] for each in recordings for name in each.names if name.endswith(".acceleration")}
    return {body for body in found if any(f"{body}.position" in each for each in recordings)}


def panels_of(
    series: Sequence[Series], *, keep_still: bool = False, bodies: Collection[str] = ()
) -> tuple[list[Panel], list[Series]]:
    """Series by quantity and unit, those of bodies first, and those left out because nothing happens in them."""
    moving = {one.name for one in series if keep_still or not one.is_still}
    moving = moving or {one.name for one in series}  # where all rest, that is what there is to see
    left_out = {one.name: one for one in reversed(series) if one.name not in moving}
    groups: dict[tuple[int, str, str], list[Series]] = {}
    for one in series:
        if one.name in moving:
            groups.setdefault((one.rank, one.quantity, one.unit), []).append(one)
    ordered = sorted(groups.items(), key=lambda item: (_place(item[1], bodies) if bodies else 0, item[0][0]))
    panels = [Panel(_title(quantity, members), unit, tuple(members)) for (_, quantity, unit), members in ordered]
    return panels, list(reversed(left_out.values()))


def _place(members: Sequence[Series], bodies: Collection[str]) -> int:
    """Where a panel stands where bodies move."""
    names = {one.name for one in members}
    motions = [any(f"{body}.{each}" in names for body in bodies) for each in ("position", "velocity")]
    unit = _QUANTITIES[members[0].rank][0] if members[0].rank < len(_QUANTITIES) else ""
    return [*motions, *(unit == each for each in _OF_LOADS), True].index(True)


def thinned(time: FloatArray, values: FloatArray, columns: int) -> NDArray[np.int64]:
    """Which samples to draw so that nothing visible is lost: first, last, lowest and highest of each column.

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
    # By time and not by count: where samples lie close, a column holds many of them.
    edges = np.unique(np.searchsorted(time, np.linspace(time[0], time[-1], columns + 1)[:-1]))
    lost = np.isnan(values)
    low, high = np.where(lost, np.inf, values), np.where(lost, -np.inf, values)
    kept = [edges, np.append(edges[1:], len(time)) - 1]
    for start, end in zip(edges, np.append(edges[1:], len(time)), strict=True):
        # The first lost sample of a column keeps the gap in its line.
        places = low[start:end].argmin(), high[start:end].argmax(), lost[start:end].argmax()
        kept.append(start + np.array(places))
    return np.unique(np.concatenate(kept))


def draw_thinned(axes: Any, x: FloatArray, y: FloatArray, kept: NDArray[np.int64], **look: Any) -> None:
    """Draw a line of the samples `kept`; the whole of it stays with it for plots that are zoomed."""
    (line,) = axes.plot(x[kept], y[kept], **look)
    if len(kept) < len(x):
        line.whole = x, y


def whole_of(line: Any) -> tuple[FloatArray, FloatArray]:
    """All samples of a line, those among them that its picture leaves out."""
    whole: tuple[FloatArray, FloatArray] = getattr(line, "whole", None) or line.get_data()
    return whole


def readable(names: Sequence[str], quantity: str) -> dict[str, str]:
    """What a legend says: the part, and of the rest what the axis does not say already.

    Examples
    --------
    >>> readable(["tank.pressure", "valve.pilot_pressure"], "pressure")
    {'tank.pressure': 'tank', 'valve.pilot_pressure': 'valve: pilot'}
    """
    labels = {}
    for name in names:
        part, _, rest = name.partition(".")
        words = rest.replace("_", " ").replace(".", " ")
        labels[name] = f"{part}: {words.removesuffix(f' {quantity}')}" if rest and words != quantity else part
    texts = list(labels.values())
    # Two series of one label are told apart by their whole names.
    return {name: label if texts.count(label) == 1 else name for name, label in labels.items()}


def _title(quantity: str, members: Sequence[Series]) -> str:
    """The quantity; what has no name of its own takes that of its series when they agree."""
    own = {one.name.rpartition(".")[2].replace("_", " ") for one in members}
    if quantity == "stroke" and "position" in own:
        return "position"
    return own.pop() if len(own) == 1 and quantity in ("ratio", "stroke", "angle", "") else quantity


def _wanted(units: Mapping[str, str] | Sequence[str] | str | None) -> list[tuple[str, str]]:
    """Pairs of a pattern, empty for all series of the quantity, and the unit asked for."""
    if units is None:
        return []
    if isinstance(units, Mapping):
        pairs = list(units.items())
    else:
        pairs = [("", unit) for unit in ([units] if isinstance(units, str) else units)]
    for _, unit in pairs:
        check_unit(unit)
    return pairs


def _series(recording: Columns, source: int, name: str, wanted: Sequence[tuple[str, str]], used: set[int]) -> Series:
    given = recording.unit(name) or "1"
    rank, quantity, unit = _usual(given)
    for place, (pattern, asked) in enumerate(wanted):
        if pattern and (pattern == name or fnmatchcase(name, pattern)):
            if not same_dimension(given, asked):
                raise UnitError("series.other_quantity", name=name, unit=given, asked=asked)
        elif pattern or not same_dimension(given, asked):
            continue
        unit = asked
        used.add(place)
    values = recording[name]
    if unit != given:
        values = convert(values, given, unit, ambient_pressure=recording.ambient_pressure)
    return Series(name, source, recording.time, values, unit, quantity, rank)


def _usual(unit: str) -> tuple[int, str, str]:
    """Place, name and usual unit of a quantity."""
    for rank, (reference, quantity, _) in enumerate(_QUANTITIES):
        if same_dimension(unit, reference):
            return rank, quantity, USUAL.get(reference, reference)
    return len(_QUANTITIES), "", unit
