"""Write the component files of the library from a table of published figures.

Usage: python tools/make_components.py COMPONENTS.CSV

The table has one row per component and flow path. Only rows that determine the size of a part are used:

- C and b apply as printed: the path from the supply to C and b of the part, the path to the exhaust to those of the
  exhaust. A missing b is assumed by the part.
- A nominal flow from 6 bar to 5 bar gauge is the field `nominal_flow`. A flow into the ambient is choked and gives C.
- The effective area S of JIS gives C = S / 5 (dm^3/(s bar), mm^2). Cv is the field `flow_coefficient_cv`.
- Flows of Festo refer to DIN 1343 (0 degC, 1.01325 bar). `Nl/min` is read in the same way, with a doubt.
- Switching times are times of the whole stroke, because no document divides them into delay and stroke. A frequency
  limit f of a proportional valve gives the time constant 1 / (2 pi f).
- A word such as `max` before or after a number becomes a doubt.
- Rows of a range of sizes, and rows with switching times only, are omitted.
"""

from __future__ import annotations

import csv
import math
import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from poppet.core.toml import toml_text
from poppet.core.units import convert
from poppet.iso6358 import sonic_conductance_from_flow

DATA = Path(__file__).parents[1] / "src" / "poppet" / "library" / "components" / "data"
TWO_POSITIONS = ["5/2 monostable", "5/2 bistable"]
SWITCHED = [*TWO_POSITIONS, "5/3 closed", "5/3 exhausted", "5/3 pressurised"]
FUNCTIONS = {
    "5/2": TWO_POSITIONS,
    "5/3 closed": ["5/3 closed"],
    "5/3 open (ABR: A,B to R)": ["5/3 exhausted"],
    "5/3 pressure (PAB: P to A,B)": ["5/3 pressurised"],
    "5-port": SWITCHED,
    "5-port (type not stated)": SWITCHED,
    "5/2 and 5/3 slide valve (4-way)": SWITCHED,
    "proportional 5/3 closed": ["proportional"],
}
CONDITIONS = {
    "6->5 bar gauge, p_abs = p_gauge+1.0 bar (SMC convention)": ("7 bar", "6 bar"),
    "6->5 bar gauge": ("6 bar g", "5 bar g"),
    "standard nominal, 6->5 bar gauge": ("6 bar g", "5 bar g"),
    "6 bar gauge, dp 1 bar": ("6 bar g", "5 bar g"),
    "standard nominal flow (test point not stated on the sheet)": ("6 bar g", "5 bar g"),
    "6 bar gauge -> atmosphere": ("6 bar g", "0 bar g"),
    "supply 7 bar, set 5 bar at no flow, outlet fallen to 4 bar gauge": ("7 bar g", "4 bar g"),
}
Row = dict[str, str]
Table = dict[str, Any]
NORMAL_LITRES = "the reference state of Nl/min is not printed: DIN 1343 (0 degC, 1.01325 bar) is assumed"
STROKE = "printed switching time, taken as the time of the whole stroke"


def conductance(row: Row) -> str:
    return f"{row['C_dm3_s_bar']} dm^3/(s bar)"


def flow_text(row: Row) -> str:
    unit = {"l/min ANR": "l/min ANR", "Nl/min": "Nl/min"}.get(row["flow_unit"], "l/min N")
    return f"{row['flow_value']} {unit}"


def capacity(row: Row) -> Table:
    """Return the fields of the flow capacity."""
    if row["C_dm3_s_bar"]:
        ratio = {"critical_ratio": float(row["b"])} if row["b"] else {}
        return {"sonic_conductance": conductance(row), **ratio}
    if row["Cv"]:
        return {"flow_coefficient_cv": float(row["Cv"].removesuffix(" max"))}
    if row["eff_area_mm2"]:
        value = f"{float(row['eff_area_mm2']) / 5:g} dm^3/(s bar)"
        return {
            "sonic_conductance": {"value": value, "note": f"effective area {row['eff_area_mm2']} mm^2 divided by 5"}
        }
    return {"nominal_flow": flow_text(row)}


def exhaust(row: Row, edge: str) -> Table:
    return {f"{edge}_conductance": conductance(row), f"{edge}_ratio": float(row["b"])}


def times(row: Row) -> Table:
    names = {"switching_time": "t_on_ms", "closing_time": "t_off_ms"}
    return {name: {"value": f"{row[key]} ms", "note": STROKE} for name, key in names.items() if row[key]}


def cracking(row: Row) -> Table:
    return {"cracking_pressure": f"{row['cracking_bar']} bar"}


def spool_valve(row: Row) -> Table:
    return {"kinds": ["spool_valve"], "options": {"function": FUNCTIONS[row["function"]]}, "fields": capacity(row)}


def proportional(row: Row) -> Table:
    limit = re.search(r"limit frequency (\d+) Hz", row["notes"])
    width = re.search(r"max. hysteresis ([\d.]+) %", row["notes"])
    assert limit
    assert width
    lag = {
        "value": f"{1e3 / (2 * math.pi * float(limit[1])):.3g} ms",
        "note": f"from the limit frequency {limit[1]} Hz",
    }
    hysteresis = {"value": f"{width[1]} %", "note": "printed maximum"}
    table = spool_valve(row)
    return table | {"fields": table["fields"] | {"lag": lag, "hysteresis": hysteresis}}


def directional(ports: str, state: str = "") -> Callable[[Row], Table]:
    def table(row: Row) -> Table:
        names = ["supply", "outlet", "exhaust"] if "3" in ports else ["supply", "outlet"]
        options = {"options": {"normally": [state]}} if state else {}
        return {"kinds": ["directional_valve"], "ports": names, **options, "fields": capacity(row) | times(row)}

    return table


def flow_path(*kinds: str, also: Callable[[Row], Table] = lambda row: {}) -> Callable[[Row], Table]:
    return lambda row: {"kinds": [*kinds], "fields": capacity(row) | also(row)}


def silencer(row: Row) -> Table:
    flow = convert(float(row["flow_value"]), "l/min N", "l/min ANR")
    value = f"{flow / (60 * 7.01325):.4g} dm^3/(s bar)"
    fields = {"sonic_conductance": {"value": value, "note": f"choked flow of {flow_text(row)} divided by 7.01325 bar"}}
    return {"kinds": ["silencer", "orifice"], "fields": fields}


def combination(row: Row) -> Table:
    flow = convert(float(row["flow_value"]), "l/min ANR", "kg/s")
    value = sonic_conductance_from_flow(flow, 8.01325e5, 5.01325e5, 293.15, critical_ratio=0.3)
    note = f"{flow_text(row)} at a drop of 1 bar, with b = 0.3"
    fields = {"sonic_conductance": {"value": f"{1e8 * value:.4g} dm^3/(s bar)", "note": note}}
    droop = {"value": "1 bar", "note": "drop at the printed flow; the valve is taken as fully open"}
    return {"kinds": ["pressure_regulator"], "fields": fields | {"droop": droop}}


def electric_regulator(row: Row) -> Table:
    hysteresis = re.search(r"; hysteresis ([\d.]+ bar)", row["notes"])
    assert hysteresis
    return {"kinds": ["pressure_regulator"], "fields": capacity(row) | {"hysteresis": hysteresis[1]}}


def cylinder(row: Row) -> Table:
    names = {"bore": "bore_mm", "rod_diameter": "rod_mm", "stroke_length": "stroke_mm"}
    fields = {name: f"{row[key]} mm" for name, key in names.items() if row[key]}
    return {"kinds": ["cylinder"], "fields": fields}


RULES: dict[str, Callable[[Row], Table]] = {
    **dict.fromkeys(FUNCTIONS, spool_valve),
    "proportional 5/3 closed": proportional,
    "2x 3/2 in one body": directional("3/2"),
    "2/2 NC": directional("2/2", "closed"),
    "2/2": directional("2/2"),
    "3/2 NC": directional("3/2", "closed"),
    "2/2 air operated angle seat": directional("2/2"),
    "2/2 and 3/2 direct acting": directional("3/2"),
    "soft start-up valve with exhaust 3/2": directional("3/2"),
    "check": flow_path("check_valve", also=cracking),
    "flow control, two-way (as transcribed)": flow_path("orifice"),
    "silencer": silencer,
    "regulator (FRL combination)": combination,
    "proportional pressure regulator": electric_regulator,
    "air reservoir": lambda row: {"kinds": ["chamber"], "fields": {"volume": f"{row['dead_volume_cm3']} cm^3"}},
    "tube, polyurethane": lambda row: {"kinds": ["tube"], "fields": {"bore": f"{row['nominal_bore_mm']} mm"}},
    "cylinder, double acting, through rod": cylinder,
    "cylinder, double acting compact": cylinder,
}
DOUBTS = {
    "cylinder, double acting, through rod": "the document describes a through rod; the part has a rod on one side",
    "cylinder, double acting compact": "the rod diameter was not read: specify rod_diameter",
    "soft start-up valve with exhaust 3/2": "the slow start is not described: the numbers are those of the open valve",
    "proportional pressure regulator": "the pressures of the nominal flow are not printed: 6 bar to 5 bar is assumed",
}
OMITTED = ("VPPE-3-1-1/8-2-...",)
"""Components whose numbers contradict the rules: 2 bar of a regulator cannot be a flow from 6 bar to 5 bar."""
CHECK = " + exhaust malfunction prevention valve"


def has_size(row: Row) -> bool:
    sizes = ("C_dm3_s_bar", "flow_value", "Cv", "eff_area_mm2", "bore_mm", "dead_volume_cm3")
    is_range = any(".." in row[key] for key in sizes)
    is_tube = row["function"].startswith("tube")
    return (is_tube or any(row[key] for key in sizes)) and not is_range and row["model"] not in OMITTED


def doubts(row: Row) -> Iterator[str]:
    if row["doubt"]:
        yield row["doubt"]
    if row["flow_unit"] == "Nl/min":
        yield NORMAL_LITRES
    if row["flow_unit"] == "l/min":
        yield "the reference state of the flow is not printed: DIN 1343 (0 degC, 1.01325 bar) is assumed"
    if " max" in row["Cv"]:
        yield "the printed Cv is a maximum"
    if row["function"] in DOUBTS:
        yield DOUBTS[row["function"]]


def printed(row: Row) -> Table:
    names = {
        "function": ("function", ""), "flow path": ("flow_path", ""), "flow coefficient Cv": ("Cv", ""),
        "effective area": ("eff_area_mm2", " mm^2"), "nominal bore": ("nominal_bore_mm", " mm"),
        "lowest pressure": ("p_min_bar", " bar g"), "highest pressure": ("p_max_bar", " bar g"),
        "lowest temperature": ("temp_min_C", " degC"), "highest temperature": ("temp_max_C", " degC"),
        "mass": ("mass_kg", " kg"), "condition of times": ("t_condition", ""),
    }  # fmt: skip
    return {name: f"{row[key]}{unit}" for name, (key, unit) in names.items() if row[key]}


def aliases(model: str, base_names: list[str]) -> list[str]:
    """Return other names of a model: members of a list, the name without a remark, and part numbers."""
    base, _, remark = model.removesuffix(CHECK).partition(" (")
    names = []
    if remark:
        names += [base] if base_names.count(base) == 1 else []
        names += [number for number in remark.removesuffix(")").split(", ") if number.isdigit() and len(number) > 4]
    first, *others = base.split("/")
    if others and re.match(r"(M\dG|SY|VXB)", first):
        names += [first, *(first[: max(0, len(first) - len(other))] + other for other in others)]
        names = [f"{name}{CHECK}" for name in names] if model.endswith(CHECK) else names
    return names


def component(row: Row, supply: Row | None, base_names: list[str], document_key: str) -> Table:
    """Return the table of a component; `supply` is the row of the path from the supply, if it is another one."""
    main = supply or row
    table = RULES[row["function"]](main)
    if supply:
        edge = "exhaust" if table["kinds"] == ["directional_valve"] else "exhaust_a"
        table["fields"] |= exhaust(row, edge)
    flow = {}
    if row["flow_value"]:
        inlet, outlet = CONDITIONS[row["flow_condition"]]
        flow = {"flow": {"value": flow_text(row), "inlet_pressure": inlet, "outlet_pressure": outlet}}
    names = [name for name in aliases(row["model"], base_names) if name != row["model"]]
    found = [*dict.fromkeys([*doubts(main), *doubts(row)])]
    return {
        "model": row["model"],
        **({"aliases": names} if names else {}),
        "series": row["series"],
        **table,
        **flow,
        "printed": printed(row) | ({"flow path": f"{main['flow_path']}; {row['flow_path']}"} if supply else {}),
        "document": document_key,
        "page": "" if row["page"] in ("n/a", "-") else row["page"],
        **({"doubts": found} if found else {}),
        **({"remarks": [row["notes"]]} if row["notes"] and row["function"] != "silencer" else {}),
    }


def document(row: Row) -> Table:
    year = {} if row["doc_year"] == "n/a" else {"year": row["doc_year"]}
    return {"title": row["document"], **year, "copy": row["source_type"]}


def manufacturer_file(manufacturer: str, rows: list[Row]) -> Table:
    used = [row for row in rows if row["function"] in RULES and has_size(row)]
    supplies = {(r["model"], r["function"]): r for r in used if r["flow_path"].startswith("1->4/2 (P")}
    base_names = [model.partition(" (")[0] for model in dict.fromkeys(row["model"] for row in used)]
    keys: dict[str, str] = {}
    documents: Table = {}
    for row in used:
        if row["document"] not in keys:
            # The first word of the series, with a number if another document has it.
            word = re.split(r"[ ,/]", row["series"])[0]
            number = sum(key.split(" ")[0] == word for key in documents) + 1
            keys[row["document"]] = key = word if number == 1 else f"{word} {number}"
            documents[key] = document(row)
    tables: Table = {}
    for row in used:
        # The path to the exhaust belongs to the component of the path from the supply.
        supply = supplies.get((row["model"].removesuffix(CHECK), row["function"]))
        if supply is row and any(
            r is not row and (r["model"], r["function"]) == (row["model"], row["function"]) for r in used
        ):
            continue
        key = row["model"] if supply is None else f"{row['model']}, {row['function']}"
        assert key not in tables, key
        tables[key] = component(row, supply, base_names, keys[row["document"]])
    return {"manufacturer": manufacturer, "documents": documents, "components": tables}


def main(path: str) -> None:
    with Path(path).open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    for manufacturer in dict.fromkeys(row["manufacturer"] for row in rows):
        table = manufacturer_file(manufacturer, [row for row in rows if row["manufacturer"] == manufacturer])
        target = DATA / f"{manufacturer.lower()}.toml"
        head = (
            f"# Components of {manufacturer}: numbers from published documents. Written by tools/make_components.py.\n"
        )
        target.write_text(head + toml_text(table), encoding="utf-8")
        print(f"{target.name}: {len(table['components'])} components")


if __name__ == "__main__":
    main(sys.argv[1])
