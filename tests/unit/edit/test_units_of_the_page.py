"""Conversions of units on the page have the same bits as those of Python."""

from __future__ import annotations

import json
import random
import subprocess
from fractions import Fraction
from pathlib import Path

import pytest

from javascript import needs_node
from poppet import edit
from poppet.core.errors import InputError
from poppet.core.units import quantity, same_dimension
from poppet.edit.palette import palette, sections, unit_table

pytestmark = needs_node
WWW = Path(edit.__file__).parent / "www"
AMBIENT = 101325.0
NUMBERS = ("0", "1", "6", "0.35", "12.5", "1e-3", "-40", "1.234567890123456789", "98.6", ".5", "7.", "3.3333333333E5")


def in_node(body: str, data: object, folder: Path) -> object:
    """Run statements with the functions of units.js; they read `data` and return a value for JSON."""
    script = folder / "script.mjs"
    script.write_text(
        f"import {{ readFileSync }} from 'node:fs';\nimport * as page from {json.dumps((WWW / 'units.js').as_uri())};\n"
        f"const {{ units, data }} = JSON.parse(readFileSync(0));\n"
        f"const run = () => {{ {body} }};\nconsole.log(JSON.stringify(run()));\n",
        encoding="utf-8",
    )
    request = json.dumps({"units": unit_table(), "data": data})
    done = subprocess.run(["node", script], input=request, capture_output=True, text=True, check=True)
    return json.loads(done.stdout, parse_int=float)


def fields():
    """Each pair of SI unit and kind of quantity, with the units that the form offers."""
    found = [field for entry in palette() for field in entry["fields"]]
    found += [field for table in sections().values() for field in table]
    return {(f["unit"], f["quantity"]): f["units"] for f in found if f["type"] == "number"}


def values_of_python():
    """Rows of text, SI unit and SI value, in all units that a field accepts."""
    rows = []
    for (unit, kind), offered in fields().items():
        others = [
            choice for choice in unit_table() if choice not in (*offered, "1", "") and same_dimension(choice, unit)
        ]
        for choice in (*offered, *others):
            for number in NUMBERS:
                text = f"{number} {choice}".strip()
                try:
                    read = quantity(text, unit, kind=kind, is_told=False)
                except InputError:
                    continue
                rows.append([text, unit, read.value + (AMBIENT if read.reference == "gauge" else 0.0)])
    return rows


def test_values_have_the_bits_of_python(tmp_path):
    rows = [row for row in values_of_python() if Fraction(row[0].split()[0])]
    assert len(rows) > 1500
    calculated = in_node(f"return data.map(([text, unit]) => page.siOf(text, unit, units, {AMBIENT}))", rows, tmp_path)
    assert [(row[0], row[1], value) for row, value in zip(rows, calculated, strict=True) if row[2] != value] == []


def test_another_unit_leaves_the_value_unchanged(tmp_path):
    offered = dict(fields_by_unit())
    rows = [[text, unit, choice] for text, unit, _ in values_of_python()[::5] for choice in offered[unit]]
    body = f"return data.map(([text, unit, to]) => page.converted(text, unit, to, units, {AMBIENT}))"
    result = in_node(body, rows, tmp_path)
    before = in_node(f"return data.map(([text, unit]) => page.siOf(text, unit, units, {AMBIENT}))", rows, tmp_path)
    again = [[text, unit] for text, (_, unit, _) in zip(result, rows, strict=True)]
    after = in_node(f"return data.map(([text, unit]) => page.siOf(text, unit, units, {AMBIENT}))", again, tmp_path)
    for (text, unit, choice), new, first, second in zip(rows, result, before, after, strict=True):
        assert new.endswith(choice)
        assert second == pytest.approx(first, rel=1e-9, abs=1e-9 * AMBIENT if unit == "Pa" else 0), (text, new)


def fields_by_unit():
    for (unit, _), offered in fields().items():
        if unit != "Pa":
            yield unit, [choice for choice in offered if choice]
    yield "Pa", ["bar", "mbar", "kPa", "bar g", "psi"]


@pytest.mark.parametrize(
    ("text", "unit", "to", "result"),
    [
        ("10 l", "m^3", "cm^3", "10000 cm^3"),
        ("0.5 dm^3/(s bar)", "m^3/(s Pa)", "l/(min bar)", "30 l/(min bar)"),
        ("6 bar g", "Pa", "bar", "7 bar"),
        ("20 degC", "K", "K", "293.15 K"),
        ("0.2", "m^3", "l", "200 l"),
        ("35 %", "1", "", "0.35"),
        ("0.35", "1", "%", "35 %"),
        ("1 m^3/h N", "m^3/s ANR", "m^3/h ANR", "1.0874"),
    ],
)
def test_typed_values_stay_short(text, unit, to, result, tmp_path):
    new = in_node("return page.converted(...data, units)", [text, unit, to], tmp_path)
    assert new == result if " " in result or result == "0.35" else new.startswith(result)


def test_quotients_are_rounded_to_the_nearest_float(tmp_path):
    generator = random.Random(5)
    pairs = [
        (generator.getrandbits(generator.randint(1, 1100)) + 1, generator.getrandbits(generator.randint(1, 1100)) + 1)
        for _ in range(2000)
    ]
    pairs += [
        (2**53 + 1, 1),
        (2**54 + 3, 2),
        (1, 2**1074),
        (3, 2**1075),
        (1, 2**1075),
        (2**1074 + 1, 2**2148),
        (10**308, 1),
    ]
    pairs += [(-first, second) for first, second in pairs[:50]]
    pairs = [pair for pair in pairs if abs(Fraction(*pair)) < 2**1023]
    body = "return data.map(pair => page.toNumber(pair.map(BigInt)))"
    values = in_node(body, [[str(top), str(bottom)] for top, bottom in pairs], tmp_path)
    assert values == [float(Fraction(*pair)) for pair in pairs]
