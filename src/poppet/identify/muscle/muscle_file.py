"""Files that name the measured force of a muscle: which columns are pressure, contraction or length, and force."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import Kind
from poppet.identify import columns as shared
from poppet.identify.muscle.points import MusclePoints, joined
from poppet.timeseries.checks import FloatArray

if TYPE_CHECKING:
    from poppet.timeseries.tables.reading import Table

COLUMNS: dict[str, tuple[str, Kind]] = {
    "pressure": ("Pa", "pressure"),
    "contraction": ("1", "plain"),
    "length": ("m", "plain"),
    "force": ("N", "plain"),
    "time": ("s", "plain"),
}
TOP_LEVEL = {
    **shared.TOP_LEVEL,
    "law": Field(),
    **{
        name: Field(type="table", is_required=True, example=f'{name} = {{ column = "...", unit = "..." }}')
        for name in ("pressure", "force")
    },
    **dict.fromkeys(("contraction", "length", "time"), Field(type="table")),
    **dict.fromkeys(("nominal_length", "nominal_diameter"), Field(unit="m", is_required=True)),
    "slack_below": Field(unit="N"),
}


def read_muscle_file(path: str | Path) -> tuple[MusclePoints, dict[str, Any]]:
    """Read a file that names a force map, or recordings, of a muscle.

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
        With all mistakes, each with its line where it can be told.

    Notes
    -----
    `file` is a table that `poppet` reads, or a list of recordings, relative to the file. Each column has a `unit` where
    its heading has none. `contraction` may be a `length` instead. With a column `time` the recordings are samples in
    order, and the direction of the motion tells the hysteresis.

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
        data = read_fields(errors, file.content, TOP_LEVEL, table="force map file")
        if ("contraction" in file.content) == ("length" in file.content):
            errors.add("force_map.contraction_or_length", "contraction")
    ambient = shared.ambient_of(data)
    given = data["file"] if isinstance(data["file"], list) else [data["file"]]
    sizes = {name: data[name] for name in ("nominal_length", "nominal_diameter", "slack_below") if name in data}
    tables, notes = [], list[Note]()
    for name in given:
        table = shared.table_of(file.folder, name, data)
        notes += table.notes
        columns: dict[str, Any] = {}
        with ErrorCollector() as errors:
            for channel in [each for each in COLUMNS if each in data]:
                with errors.collecting():
                    columns[channel] = _column(channel, data[channel], table, ambient)
        if "length" in columns:
            columns["contraction"] = 1.0 - columns.pop("length") / float(data["nominal_length"])
        tables.append(MusclePoints(**columns, **sizes))
    points = tables[0] if len(tables) == 1 else joined(tables)
    named = {"title": str(data.get("title", Path(file.name).stem)), "part": str(data.get("part", ""))}
    return points, named | {"law": str(data.get("law", "best")), "notes": tuple(notes)}


def _column(channel: str, given: Mapping[str, Any], table: Table, ambient: float) -> FloatArray:
    """Readings in SI, pressures gauge."""
    unit, kind = COLUMNS[channel]
    with ErrorCollector() as errors:
        own = read_fields(
            errors, given, {"column": Field(is_required=True, example='column = "F"'), "unit": Field()}, channel
        )
    values, _, _ = shared.column(channel, own, table, unit, kind, ambient)
    return values - ambient if kind == "pressure" else values
