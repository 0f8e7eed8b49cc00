"""Second reading of the component files: each number against the table of published figures, with rules of its own.

The table is not part of the package; without it, the comparison is skipped. No code of the package is used, except in
the last tests, which compare sizes and flows that the package computes with the formula of ISO 6358-1.
"""

from __future__ import annotations

import csv
import math
import re
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import poppet

DATA = Path(poppet.__file__).parent / "library" / "components" / "data"
TABLE = Path(__file__).parents[2].parent / "shared" / "components" / "components.csv"
NORMAL = 1.01325 * 293.15 / 273.15
"""Volume at ANR (1 bar, 20 degC) per volume at DIN 1343 (1.01325 bar, 0 degC) of an ideal gas."""
ATMOSPHERE = 1.01325
EXHAUST_PATHS = {"4/2->5/3 (A/B->R)"}
OTHER_PATHS = {"2->3"}
CELLS = {
    "Cv": ("flow_coefficient_cv", "flow coefficient Cv"),
    "eff_area_mm2": ("effective area",),
    "nominal_bore_mm": ("nominal bore", "bore"),
    "cracking_bar": ("cracking_pressure",),
    "t_on_ms": ("switching_time",),
    "t_off_ms": ("closing_time",),
    "dead_volume_cm3": ("volume",),
    "bore_mm": ("bore",),
    "rod_mm": ("rod_diameter",),
    "stroke_mm": ("stroke_length", "jaw_stroke"),
    "p_min_bar": ("lowest pressure",),
    "p_max_bar": ("highest pressure",),
    "mass_kg": ("mass",),
    "temp_min_C": ("lowest temperature",),
    "temp_max_C": ("highest temperature",),
}
"""Column of the table to the keys of a component that can contain its number, in the unit of the column."""

Row = dict[str, str]


@cache
def table() -> list[Row]:
    if not TABLE.exists():
        pytest.skip("the table of published figures is not part of the package")
    with TABLE.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def components() -> Iterator[tuple[str, str, dict[str, Any]]]:
    """Yield manufacturer, name and content of each component of the package."""
    for path in sorted(DATA.glob("*.toml")):
        content = tomllib.loads(path.read_text(encoding="utf-8"))
        for name, component in content["components"].items():
            yield content["manufacturer"], name, component


ALL = {f"{manufacturer} {name}": (manufacturer, component) for manufacturer, name, component in components()}


def number(value: Any) -> float:
    """Return the number of a value: of a table with `value`, of a text with a unit, or a plain number."""
    if isinstance(value, dict):
        value = value["value"]
    if isinstance(value, int | float):
        return float(value)
    text = re.match(r"\s*([-+0-9.eE]+)", value)
    assert text, value
    return float(text[1])


def cell(text: str) -> float:
    """Return the number of a cell, also of an upper limit such as `0.05 max`."""
    return float(text.removesuffix(" max"))


def unit(value: Any) -> str:
    return str(value["value"] if isinstance(value, dict) else value).partition(" ")[2]


def rows_of(manufacturer: str, component: dict[str, Any]) -> list[Row]:
    """Return the rows of a component: those of its model and function."""
    rows = [row for row in table() if (row["manufacturer"], row["model"]) == (manufacturer, component["model"])]
    return [row for row in rows if row["function"] == component["printed"]["function"]]


def supply_rows(manufacturer: str, component: dict[str, Any]) -> list[Row]:
    """Return the rows of the path from the supply.

    A valve with an additional check valve in its exhaust has the supply path of the valve without it.
    """
    model = component["model"].partition(" + ")[0]
    rows = rows_of(manufacturer, component) + rows_of(manufacturer, component | {"model": model})
    return [row for row in rows if row["flow_path"] not in EXHAUST_PATHS | OTHER_PATHS]


def conductance(litres: float, inlet: float, outlet: float, b: float) -> float:
    """Return C [dm^3/(s bar)] from a flow [l/min ANR] and absolute pressures [bar]."""
    r = max(outlet / inlet, b)
    return litres / (60.0 * inlet * math.sqrt(1.0 - ((r - b) / (1.0 - b)) ** 2))


def flow(c: float, inlet: float, outlet: float, b: float) -> float:
    """Return the flow [l/min ANR] from C [dm^3/(s bar)] and absolute pressures [bar]."""
    r = max(outlet / inlet, b)
    return 60.0 * c * inlet * math.sqrt(1.0 - ((r - b) / (1.0 - b)) ** 2)


def pressures(condition: str, function: str) -> tuple[float, float] | None:
    """Return the absolute pressures of a printed condition [bar]; None if it states none."""
    if "p_abs = p_gauge+1.0" in condition:
        return 7.0, 6.0
    if "6->5 bar gauge" in condition or "6 bar gauge, dp 1 bar" in condition:
        return 6.0 + ATMOSPHERE, 5.0 + ATMOSPHERE
    if "6 bar gauge -> atmosphere" in condition:
        return 6.0 + ATMOSPHERE, ATMOSPHERE
    if "supply 7 bar" in condition and "fallen to 4 bar gauge" in condition:
        return 7.0 + ATMOSPHERE, 4.0 + ATMOSPHERE
    return None


def litres_anr(row: Row) -> float:
    """Return the printed flow of a row [l/min ANR]."""
    return float(row["flow_value"]) * (1.0 if row["flow_unit"] == "l/min ANR" else NORMAL)


@pytest.mark.parametrize("name", ALL)
def test_each_size_is_that_of_the_table(name: str) -> None:
    manufacturer, component = ALL[name]
    fields, rows = component["fields"], supply_rows(manufacturer, component)
    exhaust = [row for row in rows_of(manufacturer, component) if row["flow_path"] in EXHAUST_PATHS]
    assert rows or exhaust, "the table does not contain this model"
    c, ratio = fields.get("sonic_conductance"), fields.get("critical_ratio")
    if isinstance(c, dict):  # computed: from an effective area or from a flow
        expected = set()
        for row in rows:
            if row["eff_area_mm2"]:
                expected.add(float(row["eff_area_mm2"]) / 5.0)
            elif (limits := pressures(row["flow_condition"], row["function"])) is not None:
                expected.add(conductance(litres_anr(row), *limits, 0.3))
        assert any(number(c) == pytest.approx(value, rel=1e-3) for value in expected), (c, expected)
    elif c is not None:
        pairs = {(row["C_dm3_s_bar"] and float(row["C_dm3_s_bar"]), row["b"] and float(row["b"])) for row in rows}
        assert (number(c), "" if ratio is None else number(ratio)) in pairs
        assert unit(c) == "dm^3/(s bar)"
    else:
        assert ratio is None
    for prefix in ("exhaust", "exhaust_a"):
        if f"{prefix}_conductance" in fields:
            pairs = {(float(row["C_dm3_s_bar"]), float(row["b"])) for row in exhaust}
            assert (number(fields[f"{prefix}_conductance"]), number(fields[f"{prefix}_ratio"])) in pairs
    if "nominal_flow" in fields:
        printed = {(float(row["flow_value"]), row["flow_unit"]) for row in rows}
        units = {"Nl/min": "Nl/min", "l/min N": "l/min DIN 1343", "l/min ANR": "l/min ANR"}
        assert any(
            number(fields["nominal_flow"]) == value
            and (
                units[unit(fields["nominal_flow"])] == text or (text == "l/min" and "N" in unit(fields["nominal_flow"]))
            )
            for value, text in printed
        ), printed


@pytest.mark.parametrize("name", ALL)
def test_each_number_of_the_rows_is_in_the_component(name: str) -> None:
    manufacturer, component = ALL[name]
    entries = component.get("printed", {}) | component["fields"]
    for row in rows_of(manufacturer, component):
        for column, keys in CELLS.items():
            if not row[column]:
                continue
            found = [number(entries[key]) for key in keys if key in entries]
            found += [number(component["printed"][key]) for key in keys if key in component.get("printed", {})]
            assert cell(row[column]) in found, (row["id"], column, row[column], found)
            if "max" in row[column]:
                assert any("maximum" in doubt for doubt in component["doubts"])


@pytest.mark.parametrize("name", ALL)
def test_each_number_of_the_component_is_in_the_rows(name: str) -> None:
    manufacturer, component = ALL[name]
    rows = rows_of(manufacturer, component) + supply_rows(manufacturer, component)
    sizes = {"sonic_conductance", "critical_ratio", "nominal_flow", "exhaust_conductance", "exhaust_ratio"}
    sizes |= {"exhaust_a_conductance", "exhaust_a_ratio"}
    texts = {"function", "flow path", "condition of times"}
    entries = [*component["fields"].items(), *component.get("printed", {}).items()]
    for key, value in entries:
        if key in sizes or (key in texts and isinstance(value, str)):
            continue
        columns = [column for column, keys in CELLS.items() if key in keys]
        cells = {cell(row[column]) for row in rows for column in columns if row[column]}
        if key == "lag":  # of the first order with the limit frequency in the notes of the row
            cells = {1e3 / (2.0 * math.pi * float(f)) for row in rows for f in re.findall(r"(\d+) Hz", row["notes"])}
            assert any(number(value) == pytest.approx(cell, rel=5e-3) for cell in cells)
        elif key == "hysteresis":
            notes = " ".join(row["notes"] for row in rows)
            assert f"hysteresis {number(value):g} {unit(value)}" in notes
        elif key == "droop":
            assert all("set 5 bar at no flow, outlet fallen to 4 bar" in row["flow_condition"] for row in rows)
            assert (number(value), unit(value)) == (1.0, "bar")
        else:
            assert number(value) in cells, (key, value, cells)


@pytest.mark.parametrize("name", [name for name, (_, component) in ALL.items() if "flow" in component])
def test_each_printed_flow_has_its_condition(name: str) -> None:
    manufacturer, component = ALL[name]
    printed = component["flow"]
    for row in rows_of(manufacturer, component):
        if not row["flow_value"]:
            continue
        assert number(printed["value"]) == float(row["flow_value"])
        assert ("ANR" in unit(printed["value"])) == (row["flow_unit"] == "l/min ANR")
        limits = pressures(row["flow_condition"], row["function"])
        if limits is None:
            assert any("pressures of the nominal flow are not printed" in doubt for doubt in component["doubts"])
            continue
        for key, limit in zip(("inlet_pressure", "outlet_pressure"), limits, strict=True):
            absolute = number(printed[key]) + (ATMOSPHERE if unit(printed[key]) == "bar g" else 0.0)
            assert absolute == pytest.approx(limit, abs=1e-9)


@pytest.mark.parametrize("name", ALL)
def test_each_doubt_of_the_table_is_a_doubt_of_the_component(name: str) -> None:
    manufacturer, component = ALL[name]
    doubts = " ".join(component.get("doubts", []))
    for row in rows_of(manufacturer, component):
        assert row["doubt"] in doubts, row["id"]


def test_rows_with_a_size_are_components() -> None:
    used = {row["id"] for manufacturer, component in ALL.values() for row in rows_of(manufacturer, component)}
    sized = {row["id"] for row in table() if re.fullmatch(r"[0-9.]+", row["C_dm3_s_bar"])}
    # One path of a universal 3/2 valve, of which the table does not contain the supply.
    assert sized - used == {"C136"}
    assert len(ALL) >= 60


def test_the_deviations_of_the_table_follow_from_the_formula() -> None:
    """The column with the deviations, and the two of more than 1 %: one of them is a doubt of its component."""
    large = []
    for row in table():
        if not (row["C_dm3_s_bar"] and row["b"] and re.fullmatch(r"[0-9.]+", row["flow_value"])):
            continue
        c, b, printed = float(row["C_dm3_s_bar"]), float(row["b"]), float(row["flow_value"])
        factor = 1.185 / 1.2929 if "DIN 1343" in row["flow_unit"] else 1.0
        for atmosphere in (1.0, ATMOSPHERE):
            deviation = 100.0 * (factor * flow(c, 6.0 + atmosphere, 5.0 + atmosphere, b) / printed - 1.0)
            assert f"{deviation:+.2f} (p_atm {atmosphere:g}" in row["check_dev_pct"].replace("1.0 ", "1 ").replace(
                "1.0)", "1)"
            ), (row["id"], deviation)
        if abs(deviation) > 1.0:
            large.append(row["id"])
    assert large == ["C104"]


@pytest.mark.parametrize("name", [name for name, (_, component) in ALL.items() if "flow" in component])
def test_the_size_of_the_package_gives_the_printed_flow_or_the_passport_shows_the_deviation(name: str) -> None:
    from poppet.library.components import components as of_package
    from poppet.parts.component_search import flow_capacity
    from poppet.report.component_passport import passport

    _, raw = ALL[name]
    component = next(component for component in of_package() if component.name == name)
    capacity, printed = flow_capacity(component), raw["flow"]
    assert capacity is not None
    inlet, outlet = (
        number(printed[key]) + (ATMOSPHERE if unit(printed[key]) == "bar g" else 0.0)
        for key in ("inlet_pressure", "outlet_pressure")
    )
    computed = flow(1e8 * capacity.sonic_conductance, inlet, outlet, capacity.critical_ratio)
    deviation = computed / (number(printed["value"]) * (1.0 if "ANR" in unit(printed["value"]) else NORMAL)) - 1.0
    shown = re.search(r"deviation ([-+0-9.]+) %", passport(component))
    assert shown is not None
    assert float(shown[1]) == pytest.approx(100.0 * deviation, abs=0.03)
    if abs(deviation) > 0.01:
        assert component.doubts


SI = {"dm^3/(s bar)": 1e-8, "bar": 1e5, "mm": 1e-3, "ms": 1e-3, "cm^3": 1e-6, "%": 1e-2, "": 1.0}


@pytest.mark.parametrize("name", ALL)
def test_parts_receive_the_numbers_with_their_source(name: str) -> None:
    from poppet.library.components import components as of_package
    from poppet.parts import KINDS
    from poppet.parts.components import numbers_of

    manufacturer, raw = ALL[name]
    full_name, function = f"{manufacturer} {raw['model']}", raw["printed"]["function"]
    component = next(c for c in of_package() if (c.name, c.printed["function"]) == (full_name, function))
    for kind in raw["kinds"]:
        numbers = numbers_of(component, KINDS[kind])
        for field, value in raw["fields"].items():
            if field == "nominal_flow":
                continue  # C follows from it, see above
            assert numbers[field].value == pytest.approx(number(value) * SI[unit(value)], rel=1e-12), field
            assert numbers[field].source.kind in ("datasheet", "assumed")
            assert component.document in str(numbers[field].source)
