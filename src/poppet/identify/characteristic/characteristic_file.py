"""Input files of `identify characteristic`, and files with the fitted characteristics."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from poppet.circuit.circuit import BaseCircuit
from poppet.core.errors import ErrorCollector, InputError, OutOfRangeError
from poppet.core.files import by_suffix, write_whole
from poppet.core.tables import Field, missing_field, read_fields
from poppet.core.toml import toml_text
from poppet.core.toml_file import TomlFile
from poppet.core.units import quantity
from poppet.identify.characteristic.stroke_tests import (
    NUMBERS,
    UNITS,
    StrokePoint,
    StrokeRecording,
    StrokeTest,
    common_of_result,
    point_of_result,
)
from poppet.identify.fit.fit_plan import read_circuit
from poppet.identify.free_parameter import FreeParameter, read_free
from poppet.identify.result import Result, read_result
from poppet.laws.curves import characteristic_from_mapping
from poppet.timeseries.measurements import read_measurement

CLOSING = 2e-5
"""Default stroke over which C falls to zero at the seat, as in the library characteristic that closes [m]."""
OPTIONS = (
    "form", "degree_conductance", "degree_ratio", "domain", "knots", "joint", "common", "bootstrap", "seed",
)  # fmt: skip
TOP_LEVEL = {
    **dict.fromkeys(("title", "circuit", "passage", "tests", *OPTIONS), Field()),
    **dict.fromkeys(("recording", "set", "free"), Field(type="table")),
}
SOURCES = ("file", "result", "sonic_conductance")
"""Fields that can give C and b of a test; each test has exactly one of them."""
_POINT = {f"{u}{name}": Field(unit=unit) for u in ("", "u_") for name, unit in UNITS.items()}
OF_TEST = {
    **dict.fromkeys(("name", "result", "part", "file"), Field()),
    **dict.fromkeys(("set", "recording"), Field(type="table")),
    "stroke": Field(is_required=True, unit="m", example='stroke = "0.5 mm"'),
    **_POINT,
    "correlation": Field(unit="1"),
}


def write_characteristic(result: Result, path: str | Path, *, closing: float | None = None) -> None:
    """Write a fitted characteristic to a file.

    A circuit file refers to it by `characteristic = "mine.toml"`.

    Parameters
    ----------
    result : Result
        Result of `identify_characteristic`.
    path : str or Path
        A `.toml` file.
    closing : float, optional
        Stroke over which C falls to zero at the seat [m]; 0 leaves the curve unchanged. The default is 0 for
        polynomials. For a spline it is 0.02 mm, or the first tested stroke if that is smaller.

    Raises
    ------
    InputError
        If the result is of another method, its curves are invalid (C below 0, b outside 0 to 1), or the closing law
        changes C at a tested stroke.
    """
    table = characteristic_table(result, closing=closing)
    write = by_suffix(Path(path), {".toml": toml_text})
    write_whole(Path(path), lambda stream: stream.write(write(table).encode("utf-8")))


def characteristic_table(result: Result, *, closing: float | None = None) -> dict[str, Any]:
    """Return the fitted curves of C and b as the content of a characteristic file.

    `write_characteristic` describes the arguments.
    """
    if result.method != "characteristic":
        raise InputError("characteristic.other_method", method=result.method)
    conditions, is_table = result.conditions, result.conditions["form"] == "spline"
    table: dict[str, Any] = {"kind": "table" if is_table else "polynomial"}
    if is_table:
        table["stroke"] = [_millimetres(x) for x in conditions["knots"]]
    else:
        table |= {"argument_unit": "mm", "domain": [_millimetres(x) for x in conditions["domain"]]}
    for name in NUMBERS:
        table[name] = [e.value for key, e in result.parameters.items() if re.search(rf"(^|\.){name}\.[kpy]\d+$", key)]
    low, high = conditions["tested"]
    if closing is None:
        closing = min(CLOSING, low) if is_table and low > 0.0 else 0.0
    elif not 0.0 <= closing <= max(low, 0.0):
        raise OutOfRangeError("characteristic.closing", "closing", given_mm=1e3 * closing, first_mm=1e3 * low)
    if closing > 0.0:
        table["closing"] = _millimetres(closing)
    table["source"] = f"fitted, {result.title}"
    table["note"] = (
        f"{len(conditions['tests'])} tests between {_millimetres(low)} and {_millimetres(high)}, {conditions['way']}; "
        f"{'values at knots' if is_table else 'highest power first, all digits count'}"
    )
    if result.comparison.get("monotone", {}).get("rejected"):
        table["note"] += "; the data contradict a C(x) that never falls"
    characteristic_from_mapping(table, name=result.title)
    return table


def _millimetres(x: float) -> str:
    return f"{1e3 * x:.12g} mm"


def read_characteristic_file(path: str | Path) -> tuple[list[StrokeTest], dict[str, Any]]:
    """Read a file with tests of a flow path at several strokes.

    Parameters
    ----------
    path : str or Path
        A TOML file as in the example.

    Returns
    -------
    tests : list of StrokePoint or StrokeRecording
        In the order of the file.
    options : dict
        The keywords of `identify_characteristic`.

    Raises
    ------
    InputErrors
        All errors of the file, each with its line.

    Notes
    -----
    A test has a `stroke` and one of: `file`, `result`, or values of C and b. `file` is a recording that the common
    `[recording]` table describes; the `recording` table of a test extends it, and `set` changes the circuit for this
    test. `result` is a result of `identify tank` or `identify flow`, with `part` as the name of the flow path.
    `[free]` has further free parameters of the bench, as in a fit file.

    Examples
    --------
    >>> import tempfile
    >>> text = '''
    ... form = "polynomial"
    ... degree_conductance = 1
    ... degree_ratio = 0
    ... [[tests]]
    ... stroke = "0.2 mm"
    ... sonic_conductance = "1.3 dm^3/(s bar)"
    ... u_sonic_conductance = "0.01 dm^3/(s bar)"
    ... critical_ratio = 0.42
    ... u_critical_ratio = 0.01
    ... '''
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = (Path(folder) / "tests.toml").write_text(text)
    ...     tests, options = read_characteristic_file(Path(folder) / "tests.toml")
    >>> tests[0].stroke, options["degree_conductance"]
    (0.0002, 1)
    """
    file = TomlFile.read(path, "free")
    with file.errors():
        with ErrorCollector() as errors:
            data = read_fields(errors, file.content, TOP_LEVEL, table="list of tests")
            tables = data.get("tests")
            if not isinstance(tables, list) or not tables or not all(isinstance(table, Mapping) for table in tables):
                errors.add("characteristic.no_tests")
        circuit = read_circuit(data, file.folder) if "circuit" in data else None
        if data.get("free") and circuit is None:
            raise InputError("characteristic.free_without_circuit", "free")
        free = tuple(read_free(a, t, circuit) for a, t in data.get("free", {}).items()) if circuit else ()
        bench = _Bench(file.folder, str(data.get("passage", "valve")), circuit, data.get("recording", {}), free, [])
        tests: list[StrokeTest] = []
        with ErrorCollector() as errors:
            for k, table in enumerate(data["tests"]):
                try:
                    tests.append(_read_test(table, bench, str(table.get("name", f"test{k + 1}"))))
                except InputError as error:  # without an address, the error is located at the tests
                    errors.extend([error.located(address="tests")])
        options = {key: data[key] for key in OPTIONS if key in data}
        for key in [key for key in ("domain", "knots") if key in options]:
            if not isinstance(options[key], list) or (key == "domain" and len(options[key]) != 2):
                raise InputError("characteristic.no_strokes", key, value=options[key])
            options[key] = tuple(quantity(x, "m", name=key).value for x in options[key])
        # Common errors of different benches are unknown: the largest is conservative.
        shared = [max(column) for column in zip(*bench.common, strict=True)]
        if "common" in options or shared:
            options["common"] = tuple(options.get("common", shared))
        return tests, {**options, "title": str(data.get("title", Path(file.name).stem))}


class _Bench(NamedTuple):
    """Settings that all tests in a file have in common.

    They include the standard uncertainties of errors of sonic conductance and critical ratio that all tests share.
    """

    folder: Path
    passage: str
    circuit: BaseCircuit | None
    recording: Mapping[str, Any]
    free: tuple[FreeParameter, ...]
    common: list[tuple[float, float]]


def _read_test(table: Mapping[str, Any], bench: _Bench, name: str) -> StrokeTest:
    address = f"tests.{name}"
    with ErrorCollector() as errors:
        fields = read_fields(errors, table, OF_TEST, address, table="test")
        sources = [source for source in SOURCES if source in table]
        if len(sources) != 1:
            errors.add("stroke.one_way", test=name, ways=sources or ["nothing"])
        # A misspelt field is one error, not two.
        if sources == ["sonic_conductance"] and not errors.collected:
            for key in (key for key in _POINT if key not in table):
                errors.extend([missing_field(f"{address}.{key}", OF_TEST[key])])
    if "file" in fields:
        if bench.circuit is None:
            raise InputError("stroke.no_bench", test=name)
        circuit = bench.circuit.with_values(fields.get("set", {}))
        mapping = {**bench.recording, **fields.get("recording", {}), "file": fields["file"]}
        measurement = read_measurement(name, mapping, bench.folder, ambient_pressure=circuit.surroundings.pressure)
        return StrokeRecording(fields["stroke"], circuit, measurement, bench.passage, bench.free, name)
    if "result" in fields:
        result = read_result(bench.folder / str(fields["result"]))
        part = str(fields.get("part", bench.passage if f"{bench.passage}.{NUMBERS[0]}" in result.parameters else ""))
        bench.common.append(common_of_result(result, part=part))
        return point_of_result(result, fields["stroke"], part=part, name=name)
    numbers = {key: fields[key] for key in (*_POINT, "correlation") if key in fields}
    return StrokePoint(fields["stroke"], name=name, **numbers)
