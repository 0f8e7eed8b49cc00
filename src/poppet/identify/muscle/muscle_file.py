"""Measured forces of a muscle from a map or recordings, with groups for validation, and their files."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import Kind
from poppet.identify.data_file import FILE_FIELDS, channel_field, open_table, read_ambient, read_column
from poppet.timeseries.checks import FloatArray, numbers

CHANNELS = {"pressure": "Pa", "contraction": "1", "force": "N"}
SLACK = 0.002
"""Default force up to which a point is slack, as a fraction of the maximum force."""
SAME = 0.005
"""Distance of neighbouring values of one level, as a fraction of the range."""
BLOCKS = 10
"""Number of blocks of a recording without levels of pressure or contraction."""
STILL = 0.1
"""Speed below which a muscle is at rest, as a fraction of the 90 % quantile of the speed."""
STIFF = 1e-3
"""Range of contraction below which a recording is isometric."""
LEAST_GROUPS = 3


@dataclass(frozen=True, eq=False)
class MusclePoints:
    """Measured force of a muscle at points of pressure and contraction.

    Parameters
    ----------
    pressure : (n,) array
        Gauge pressure [Pa].
    contraction : (n,) array
        Contraction (L0 - L)/L0, with the length L and the nominal length L0 [1].
    force : (n,) array
        Tensile force [N].
    nominal_length, nominal_diameter : float
        Length and inner diameter without pressure and load [m].
    recording : (n,) array of int, optional
        Index of the recording to which each point belongs; by default all points are one table.
    time : (n,) array, optional
        Time of each sample of a recording; the direction of the motion then gives the hysteresis [s].
    slack_below : float, optional
        Force up to which a point is slack; the default is 0.2 % of the maximum [N].

    Raises
    ------
    InputErrors
        Different lengths, values that are not finite, contractions in per cent, no taut points.

    Examples
    --------
    >>> points = MusclePoints([2e5, 2e5, 4e5], [0.0, 0.2, 0.1], [500.0, 0.0, 600.0], 0.3, 0.02)
    >>> points.taut.tolist()
    [True, False, True]
    """

    pressure: FloatArray
    contraction: FloatArray
    force: FloatArray
    nominal_length: float
    nominal_diameter: float
    recording: NDArray[np.int_] | None = None
    time: FloatArray | None = None
    slack_below: float | None = None

    def __post_init__(self) -> None:
        arrays = {name: np.atleast_1d(numbers(name, getattr(self, name))) for name in CHANNELS}
        size = arrays["force"].size
        with ErrorCollector() as errors:
            for name, array in arrays.items():
                if array.shape != (size,):
                    errors.add("force_map.shape", name, shape=str(array.shape), points=size)
                elif not np.isfinite(array).all():
                    errors.add("force_map.not_finite", name, place=int(np.argmin(np.isfinite(array))))
            # In per cent, almost all contractions are above 1.
            largest = float(np.max(np.abs(arrays["contraction"]), initial=0.0))
            if largest >= 1.0:
                errors.add("force_map.per_cent", "contraction", value=largest)
            force = arrays["force"]
            maximum, minimum = float(np.max(force, initial=0.0)), float(np.min(force, initial=0.0))
            if not maximum > 0.0:
                errors.add("force_map.no_pull", "force")
            elif -minimum > maximum:
                errors.add("force_map.pushes", "force", most=maximum, least=minimum)
            elif size > 1 and not np.ptp(force):
                errors.add("force_map.still", "force", value=maximum)
        for name, array in arrays.items():
            object.__setattr__(self, name, array)

    def __len__(self) -> int:
        return int(self.force.size)

    @cached_property
    def slack_force(self) -> float:
        """Largest force at which the muscle is regarded as slack [N]."""
        return SLACK * float(np.max(self.force)) if self.slack_below is None else self.slack_below

    @cached_property
    def taut(self) -> NDArray[np.bool_]:
        """Mask of the points at which the muscle pulls (is taut), shape (n,)."""
        return np.asarray(self.force > self.slack_force)

    @cached_property
    def direction(self) -> FloatArray | None:
        """Direction of the motion at each point, (n,).

        It is 1 for contraction, -1 for extension, and 0 at rest. The value is None if the points have no time, or if
        the muscle does not move while it pulls.
        """
        if self.time is None:
            return None
        speed = np.zeros(len(self))
        for k in np.unique(self._recordings):
            samples = np.flatnonzero(self._recordings == k)
            if samples.size > 1 and np.ptp(self.contraction[samples]) > STIFF:
                speed[samples] = np.gradient(self.contraction[samples], self.time[samples])
        typical_speed = float(np.quantile(np.abs(speed), 0.9))
        direction = np.where(np.abs(speed) > STILL * typical_speed, np.sign(speed), 0.0)
        return np.asarray(direction) if direction[self.taut].any() else None

    @property
    def _recordings(self) -> NDArray[np.int_]:
        return np.zeros(len(self), dtype=int) if self.recording is None else np.asarray(self.recording)

    @cached_property
    def groups(self) -> tuple[str, NDArray[np.int_]]:
        """Groups of points for validation: their kind, and the group index of each point, (n,).

        The groups are recordings if there are enough of them. Otherwise they are levels of pressure or contraction, or
        blocks in time.
        """
        if self._is_sufficient(self._recordings):
            return "recording", self._recordings
        if self.time is None or len(self) < 5 * BLOCKS:
            for name in ("pressure", "contraction"):
                level = levels(getattr(self, name))
                if self._is_sufficient(level) and int(level.max()) + 1 <= 0.6 * len(self):
                    return name, level
        block = np.minimum(np.arange(len(self)) * BLOCKS // len(self), BLOCKS - 1)
        if len(self) < 5 * BLOCKS or not self._is_sufficient(block):
            raise InputError("force_map.too_few", "force", count=int(self.taut.sum()), least=LEAST_GROUPS)
        return "block", block

    @cached_property
    def second_groups(self) -> tuple[str, NDArray[np.int_]] | None:
        """Second kind of groups for validation: levels of the other axis of a force map.

        If `groups` are levels of pressure, these are levels of contraction, and vice versa. The value contains the name
        of the axis, and the group index of each point, (n,). Points at the outer levels have the index -1. They are
        never withheld along this axis, because a law would have to extrapolate to them. The value is None if the points
        are not a force map, or if the axis has too few levels.
        """
        name = {"pressure": "contraction", "contraction": "pressure"}.get(self.groups[0])
        if name is None:
            return None
        level = levels(getattr(self, name))
        present = np.unique(level[self.taut])
        if present.size < LEAST_GROUPS or present.size > 0.6 * len(self):
            return None
        return name, np.asarray(np.where((level > present[0]) & (level < present[-1]), level, -1))

    def _is_sufficient(self, group: NDArray[np.int_]) -> bool:
        return np.unique(group[self.taut]).size >= LEAST_GROUPS


def levels(values: FloatArray) -> NDArray[np.int_]:
    """Return the index of the level to which each value belongs, (n,).

    A level is a group of values that are almost equal. The levels are in ascending order.
    """
    order = np.argsort(values, kind="stable")
    steps = np.diff(values[order], prepend=values[order][:1]) > SAME * float(np.ptp(values))
    result = np.empty(values.size, dtype=int)
    result[order] = np.cumsum(steps)
    return result


def join_tables(tables: Sequence[MusclePoints]) -> MusclePoints:
    """Join the points of several recordings of one muscle into one object."""
    with ErrorCollector() as errors:
        for (k, first_table), (n, second_table) in itertools.combinations(enumerate(tables), 2):
            if all(np.array_equal(getattr(first_table, name), getattr(second_table, name)) for name in CHANNELS):
                errors.add("force_map.same_twice", "file", first=k + 1, second=n + 1)
    template = tables[0]
    columns = {name: np.concatenate([getattr(points, name) for points in tables]) for name in CHANNELS}
    times = [points.time for points in tables]
    return MusclePoints(
        **columns,
        nominal_length=template.nominal_length,
        nominal_diameter=template.nominal_diameter,
        recording=np.repeat(np.arange(len(tables)), [len(points) for points in tables]),
        time=None if any(t is None for t in times) else np.concatenate([t for t in times if t is not None]),
        slack_below=template.slack_below,
    )


COLUMNS: dict[str, tuple[str, Kind]] = {
    "pressure": ("Pa", "pressure"),
    "contraction": ("1", "plain"),
    "length": ("m", "plain"),
    "force": ("N", "plain"),
    "time": ("s", "plain"),
}
_SIZES = {
    "nominal_length": Field(unit="m", is_required=True, example='nominal_length = "300 mm"'),
    "nominal_diameter": Field(unit="m", is_required=True, example='nominal_diameter = "20 mm"'),
    "slack_below": Field(unit="N"),
}
TOP_LEVEL = {
    **FILE_FIELDS,
    "law": Field(type="text", default="best"),
    **{name: channel_field(name, is_required=name in ("pressure", "force")) for name in COLUMNS},
    **_SIZES,
}
CHANNEL_FIELDS = {"column": Field(is_required=True, example='column = "F"'), "unit": Field()}


def read_muscle_file(path: str | Path) -> tuple[MusclePoints, dict[str, Any]]:
    """Read a file that names a force map or recordings of a muscle.

    Parameters
    ----------
    path : str or Path
        A TOML file as in the example.

    Returns
    -------
    points : MusclePoints
        In SI units, pressures gauge.
    options : dict
        The keywords of `identify_muscle`.

    Raises
    ------
    InputErrors
        All errors of the file, each with its line.

    Notes
    -----
    `file` is a table that `poppet` reads, or a list of recordings, relative to the file. A column needs a `unit` if
    its heading has none. `length` may replace `contraction`. With a column `time`, the rows are samples in order; the
    direction of the motion then gives the hysteresis.

    Examples
    --------
    >>> import tempfile
    >>> text = '''
    ... file = "map.csv"
    ... nominal_length = "300 mm"
    ... nominal_diameter = "20 mm"
    ... pressure = { column = "p", unit = "bar g" }
    ... length = { column = "L", unit = "mm" }
    ... force = { column = "F", unit = "N" }
    ... '''
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = (Path(folder) / "map.csv").write_text("p,L,F\\n2,300,500\\n2,270,90\\n4,270,330\\n")
    ...     _ = (Path(folder) / "map.toml").write_text(text)
    ...     points, options = read_muscle_file(Path(folder) / "map.toml")
    >>> points.contraction.round(6).tolist(), options["title"]
    ([0.0, 0.1, 0.1], 'map')
    """
    file = TomlFile.read(path, "force")
    with file.errors():
        return _read(file)


def _read(file: TomlFile) -> tuple[MusclePoints, dict[str, Any]]:
    with ErrorCollector() as errors:
        fields = read_fields(errors, file.content, TOP_LEVEL, table="force map file")
        if ("contraction" in file.content) == ("length" in file.content):
            errors.add("force_map.contraction_or_length", "contraction")
    ambient_pressure = read_ambient(fields)
    names = fields["file"] if isinstance(fields["file"], list) else [fields["file"]]
    sizes = {name: fields[name] for name in _SIZES if name in fields}
    maps, notes = [], list[Note]()
    for name in names:
        table = open_table(file.folder, name, fields)
        notes += table.notes
        columns: dict[str, Any] = {}
        with ErrorCollector() as errors:
            for channel, (unit, kind) in COLUMNS.items():
                if channel not in fields:
                    continue
                with errors.collecting():
                    with ErrorCollector() as channel_errors:
                        options = read_fields(channel_errors, fields[channel], CHANNEL_FIELDS, channel, table="channel")
                    columns[channel] = read_column(channel, options, table, unit, kind, ambient_pressure).values
        columns["pressure"] = columns["pressure"] - ambient_pressure
        if "length" in columns:
            columns["contraction"] = 1.0 - columns.pop("length") / float(fields["nominal_length"])
        maps.append(MusclePoints(**columns, **sizes))
    options = {"title": fields.get("title", Path(file.name).stem), "part": fields["part"], "law": fields["law"]}
    return maps[0] if len(maps) == 1 else join_tables(maps), options | {"notes": tuple(notes)}
