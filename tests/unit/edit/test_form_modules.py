"""Modules of the form that need no page: values, sliders, steps of sequences and curves of signals."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import numpy as np
import pytest

from javascript import needs_node, run_module
from poppet.circuit.file import loads
from poppet.edit.palette import palette, unit_table

pytestmark = needs_node
EXAMPLES = Path(__file__).parents[3] / "examples"
FIELDS = {f"{entry['kind']}.{field['name']}": field for entry in palette() for field in entry["fields"]}


@pytest.mark.parametrize(
    ("field", "typed", "unit", "present", "value"),
    [
        ("orifice.critical_ratio", "0.4", "", "0.3", 0.4),
        ("orifice.critical_ratio", " 40 % ", "", None, "40 %"),
        ("chamber.volume", "12", "l", "10 l", "12 l"),
        ("chamber.volume", "0.012", "m^3", 0.01, 0.012),  # a number without a unit stays one
        ("chamber.volume", "0.012", "m^3", "0.01 m^3", "0.012 m^3"),
        ("chamber.volume", "2 cm^3", "l", "10 l", "2 cm^3"),
        ("chamber.volume", "", "l", "10 l", None),
        ("chamber.volume", "1e999", "l", "10 l", "1e999"),  # the server reports the error
        ("chamber.thermal", "isothermal", "", None, "isothermal"),
        ("tube.inertia", "true", "", "false", True),
        ("tube.inertia", "yes", "", "false", "yes"),
        ("sequence.outputs", "a, b", "", None, ["a", "b"]),
        ("orifice.characteristic", '{"kind": "table"}', "", None, {"kind": "table"}),
        ("orifice.characteristic", "varga2012", "", None, "varga2012"),
    ],
)
def test_typed_values(field, typed, unit, present, value, tmp_path):
    script = (
        'import { valueOf } from "./field_values.js";\n'
        "console.log(JSON.stringify(valueOf(DATA[0], DATA[1], DATA[2], DATA[3] ?? undefined)));\n"
    )
    assert run_module(tmp_path, script, data=[FIELDS[field], typed, unit, present]) == value


@pytest.mark.parametrize(
    ("field", "value", "low", "high", "is_log", "middle"),
    [
        ("chamber.volume", "3 l", 1, 9, True, "3 l"),
        ("orifice.critical_ratio", 0.3, 0, 0.99, False, "0.495"),
        ("orifice.opening", 1, 0, 1, False, "0.5"),
        ("reservoir.pressure", "6 bar g", 2, 18, True, "6 bar g"),
        ("reservoir.temperature", "20 degC", -10, 50, False, "20 degC"),
        ("pressure_controller.supply_pressure", "3 bar", 1, 9, True, "3 bar"),
        ("muscle.offset", "-9 mm", -27, -3, False, "-15 mm"),
    ],
)
def test_ranges_of_sliders(field, value, low, high, is_log, middle, tmp_path):
    script = (
        'import { rangeOf, textAt, positionOf, STEPS } from "./sliders.js";\n'
        "const [field, value, units] = DATA;\nconst range = rangeOf(field, value, units, 100000);\n"
        "const ends = [0, STEPS].map(position => positionOf(parseFloat(textAt(position, range)), range));\n"
        "console.log(JSON.stringify({ ...range, middle: textAt(STEPS / 2, range), ends, steps: STEPS }));\n"
    )
    result = run_module(tmp_path, script, data=[FIELDS[field], value, unit_table()])
    assert (result["low"], result["high"]) == pytest.approx((low, high))
    assert (result["isLog"], result["middle"]) == (is_log, middle)
    assert result["ends"] == [0, result["steps"]]


def test_values_without_a_range(tmp_path):
    script = (
        'import { rangeOf } from "./sliders.js";\nconst [field, values, units] = DATA;\n'
        "console.log(JSON.stringify(values.map(value => rangeOf(field, value, units, 100000))));\n"
    )
    values = ["0 l", 0, "a lot", "3 furlongs", "", "-"]
    assert run_module(tmp_path, script, data=[FIELDS["chamber.volume"], values, unit_table()]) == [None] * len(values)


def sequences():
    for path in sorted(EXAMPLES.glob("*.toml")):
        for name, table in tomllib.loads(path.read_text(encoding="utf-8")).get("parts", {}).items():
            if table.get("kind") == "sequence":
                yield pytest.param(table["steps"], id=f"{path.stem}-{name}")


STEPS_SCRIPT = 'import { linesOf, stepsOf } from "./steps.js";\n'


@pytest.mark.parametrize("steps", list(sequences()))
def test_steps_as_lines_and_back(steps, tmp_path):
    script = STEPS_SCRIPT + "console.log(JSON.stringify([linesOf(DATA), stepsOf(linesOf(DATA))]));\n"
    lines, back = run_module(tmp_path, script, data=steps)
    assert back == {"steps": steps}
    assert list(back["steps"]) == list(steps)
    assert all(line.endswith(":") for line in lines.split("\n") if not line.startswith(" "))


@pytest.mark.parametrize(
    ("lines", "line"),
    [
        ("x", 1),
        ("a:\n  on: y\nb", 3),
        ("a:\n  off: y", 2),
        ("a:\n  set: y", 2),
        ("a:\na:", 2),
        ("  on: y", 1),
        ("a:\n  next: y", 2),
    ],
)
def test_lines_that_are_no_steps(lines, line, tmp_path):
    assert run_module(tmp_path, STEPS_SCRIPT + "console.log(JSON.stringify(stepsOf(DATA)));\n", data=lines) == {
        "line": line
    }


SIGNALS = {
    "constant": {"value": 0.4},
    "steps": {"times": ["0 s", "0.3 s", "700 ms"], "values": [0, 1, 0.25]},
    "points": {"times": ["0.1 s", "0.5 s", "1.5 s"], "values": [0, 1, 0.5]},
    "sine": {"mean": 0.5, "amplitude": 0.4, "frequency": "2 Hz", "phase": "0.5 rad"},
    "chirp": {"mean": 0.5, "amplitude": 0.4, "frequency": "1 Hz", "end_frequency": "3 Hz"},
    "square": {"low": 0.2, "high": 0.9, "frequency": "2 Hz", "duty": 0.3},
}
RUN = """
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"

[parts.hole]
kind = "orifice"
from = "supply"
to = "ambient"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3

[run]
duration = "2 s"
output_step = "9.7 ms"

[signals."hole.opening"]
"""


@pytest.mark.parametrize("kind", SIGNALS)
def test_curves_of_signals_are_those_of_a_run(kind, tmp_path):
    table = {"kind": kind, **SIGNALS[kind]}
    result = loads(RUN + "\n".join(f"{key} = {json.dumps(value)}" for key, value in table.items())).simulate()
    seconds = {"s": 1.0, "ms": 1e-3, "Hz": 1.0, "rad": 1.0}
    plain = {
        key: [number(item, seconds) for item in value] if isinstance(value, list) else number(value, seconds)
        for key, value in table.items()
    }
    script = (
        'import { courseOf } from "./signal_kinds.js";\nconst number = name => DATA[name] ?? NaN;\n'
        "console.log(JSON.stringify(courseOf(DATA.kind, { number, list: number, duration: 2, samples: 2000 })));\n"
    )
    times, values = np.array(run_module(tmp_path, script, data=plain)).T
    expected = np.asarray(result["hole.opening"])
    at = np.asarray(result.time)
    # Jumps of the curve are vertical, hence rows at a jump are excluded.
    is_smooth = np.array([not np.any((np.diff(times) == 0) & (np.abs(times[1:] - t) < 1e-9)) for t in at])
    np.testing.assert_allclose(np.interp(at, times, values)[is_smooth], expected[is_smooth], atol=2e-5)


def number(value, factors):
    if not isinstance(value, str) or " " not in value:
        return value
    digits, unit = value.split(" ")
    return float(digits) * factors[unit]
