"""Reader of files with the measured force of a muscle versus pressure and contraction or length."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import Kind
from poppet.identify.data_file import FILE_FIELDS, channel_field, open_table, read_ambient, read_column
from poppet.identify.muscle.points import MusclePoints, join_tables

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
