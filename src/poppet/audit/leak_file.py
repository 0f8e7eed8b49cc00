"""File of a leak survey: tariff and measured leaks of a plant."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from poppet.audit.leaks import LeakSurvey, PlantLeak, bag_flow, decibel_flow, orifice_flow, survey_leaks
from poppet.audit.tariff import read_tariff
from poppet.core.errors import ErrorCollector, InputError
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import Kind, quantity

AMBIENT_PRESSURE = 101325.0
"""Default of the ambient pressure [Pa]."""
_FILE = {
    "title": Field(type="text", default="", meaning="title of the survey"),
    "ambient_pressure": Field(unit="Pa", kind="pressure", above=0.0, default=AMBIENT_PRESSURE,
                              meaning="absolute pressure of the surroundings"),
    "control_fraction": Field(unit="1", low=0.0, high=1.0, default=1.0,
                              meaning="fraction of the electricity of a leak that its repair saves"),
    "audit": Field(type="table", default={}, meaning="tariff"),
    "leaks": Field(type="table", is_required=True, meaning="table of the leaks",
                   example='[leaks.press_3] with method = "bag"'),
}  # fmt: skip
_COUNT = {"count": Field(type="integer", low=1, high=1_000_000, default=1, meaning="number of equal leaks")}
_LENGTH = Field(unit="m", above=0.0, is_required=True)
METHODS: dict[str, dict[str, Field]] = {
    "estimate": {"flow": Field(unit="m^3/s ANR", kind="volume_flow_anr", low=0.0, is_required=True,
                               meaning="flow of one leak")},
    "bag": {"diameter": _LENGTH, "height": _LENGTH, "fill_time": Field(unit="s", above=0.0, is_required=True)},
    "decibel": {
        "pressure": Field(unit="Pa", kind="pressure", is_required=True, meaning="line pressure"),
        "level": Field(type="number", is_required=True, meaning="sound level in dB"),
        "pressures": Field(is_required=True, meaning="list of two pressures of the table",
                           example='["5 bar g", "7 bar g"]'),
        "levels": Field(is_required=True, meaning="list of two sound levels of the table in dB", example="[20, 30]"),
        "flows": Field(is_required=True, meaning="flows at both pressures for each of both levels",
                       example='[["29 l/min ANR", "34 l/min ANR"], ["47 l/min ANR", "52 l/min ANR"]]'),
    },
    "orifice": {
        "diameter": _LENGTH,
        "pressure": Field(unit="Pa", kind="pressure", is_required=True, meaning="line pressure"),
        "temperature": Field(unit="K", kind="temperature", above=0.0, default=293.15, meaning="line temperature"),
        "discharge_coefficient": Field(unit="1", above=0.0, high=1.0, default=0.6,
                                       meaning="ratio of the flow to that of an ideal nozzle"),
    },
}  # fmt: skip
"""Fields of a leak for each method of measurement."""


def read_survey(path: str | Path) -> LeakSurvey:
    """Return the result of the leak survey in a TOML file.

    Parameters
    ----------
    path : str or Path
        File of the survey; see docs/energy_audit.md.

    Returns
    -------
    LeakSurvey
        Flow and cost of each leak.

    Raises
    ------
    InputError
        If the file contains errors; all of them are reported together.
    """
    file = TomlFile.read(path, "leaks")
    with file.errors() as errors:
        values = read_fields(errors, file.content, _FILE, table="leak survey")
        tariff = None
        with errors.collecting():
            tariff = read_tariff(values.get("audit"), "audit")
        leaks = []
        for name, table in values.get("leaks", {}).items():
            with errors.collecting():
                leaks.append(_read_leak(name, table, values.get("ambient_pressure", AMBIENT_PRESSURE)))
    assert tariff is not None
    return survey_leaks(leaks, tariff, title=values["title"], control_fraction=values["control_fraction"])


def _read_leak(name: str, table: Any, ambient_pressure: float) -> PlantLeak:
    address = f"leaks.{name}"
    if not isinstance(table, Mapping):
        raise InputError("fields.no_table", address, value=table)
    method_field = Field(choices=tuple(METHODS), is_required=True, meaning="method of measurement")
    with ErrorCollector() as errors:
        method = read_fields(
            errors, {k: v for k, v in table.items() if k == "method"}, {"method": method_field}, address
        )
    fields = {"method": method_field, **METHODS[method["method"]], **_COUNT}
    with ErrorCollector() as errors:
        values = read_fields(
            errors,
            table,
            fields,
            address,
            table=f"leak with method {method['method']}",
            ambient_pressure=ambient_pressure,
        )
    count, name_of_method = values.pop("count"), values.pop("method")
    with ErrorCollector() as errors, errors.collecting(address):
        match name_of_method:
            case "estimate":
                flow = values["flow"]
            case "bag":
                flow = bag_flow(**values)
            case "decibel":
                flow = _decibel_flow(values, ambient_pressure)
            case _:
                flow = orifice_flow(**values, ambient_pressure=ambient_pressure)
    return PlantLeak(name, flow, count, name_of_method)


def _decibel_flow(values: Mapping[str, Any], ambient_pressure: float) -> float:
    def read(name: str, raw: Any, unit: str, kind: Kind = "plain") -> tuple[float, float]:
        numbers = [quantity(text, unit, kind=kind, name=name) for text in _pair(name, raw)]
        first, second = (n.value + (ambient_pressure if n.reference == "gauge" else 0.0) for n in numbers)
        return first, second

    first, second = (read("flows", row, "m^3/s ANR", "volume_flow_anr") for row in _pair("flows", values["flows"]))
    low, high = read("pressures", values["pressures"], "Pa", "pressure")
    # In bar, because errors show the pressures.
    return decibel_flow(
        values["pressure"] / 1e5,
        values["level"],
        pressures=(low / 1e5, high / 1e5),
        pressure_unit="bar",
        levels=read("levels", values["levels"], "1"),
        flows=(first, second),
    )


def _pair(name: str, raw: Any) -> tuple[Any, Any]:
    if not isinstance(raw, list) or len(raw) != 2:
        raise InputError("leaks.no_pair", name, value=raw, example=METHODS["decibel"][name].example)
    return raw[0], raw[1]
