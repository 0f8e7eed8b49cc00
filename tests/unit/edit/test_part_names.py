"""Renaming of parts: every place of a circuit file that can contain the name of a part."""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import pytest

from poppet import loads
from poppet.core.errors import InputError
from poppet.edit.document import Document
from poppet.edit.part_names import references, renamed, without_references
from poppet.edit.toml_text import TomlText
from poppet.ensemble import plan_of
from poppet.parts import KINDS
from poppet.parts.fields import port, reference
from poppet.parts.part import Controller, ControlOutputs, PartConnection, Scope

ROOT = Path(__file__).parents[3]
EXAMPLES = {
    str(path.relative_to(ROOT)): text
    for folder in ("examples", "website/circuits")
    for path in sorted((ROOT / folder).rglob("*.toml"))
    if "parts" in tomllib.loads(text := path.read_bytes().decode("utf-8"))
}
EVERYWHERE = """\
title = "tank"                            # the name in a comment: tank.pressure
[parts.tank]
kind = "chamber"
volume = "10 l"
[parts.valve]
kind = "directional_valve"
supply = "tank"
outlet = 'tank.cap'
model = "tank"                            # the name of a component
[parts.hose]
kind = "tube"
from = "tank.outlet"
to = "tank2"
[parts.rod]
kind = "cylinder"
body = "tank"
[parts.main]
kind = "proportional_valve"
main_stage = { exhaust = "tank" }
[parts.plc]
kind = "sequence"
outputs = ["tank"]
[parts.plc.steps.tank]
on = ["tank"]
next = { tank = 'count("tank.x") > 2 and tank.pressure > 3 tank.m', b = "(not tank.on or tank2.on)" }
timeout = { after = "1 s", to = "tank" }
[parts.plc.steps.b]
next = { tank = \"\"\"
tank.pressure > > 2\"\"\" }
[parts.sensor]
kind = "switch"
measurement = "tank.pressure"
[parts.odd]
kind = "unknown"
joined = "tank"
other = "tank of steel"
[signals."tank.pressure"]
kind = "sampled"
path = "tank.csv"
column = "tank.pressure"
[signals.tank.temperature]
kind = "constant"
[connections]
"tank.command" = "tank.pressure"
tank.other = "tank2.pressure"
[run]
stop_when = ["tank.pressure > 5 bar", "tank2.pressure < tank.pressure"]
[ensemble]
curves = ["tank.pressure"]
[ensemble.parameters]
"tank.volume" = { distribution = "normal" }
[ensemble.metrics]
tank = { of = "tank.pressure", metric = "overshoot", target = "tank.setpoint" }
sum = { of = ["tank.pressure", "tank2.pressure"], metric = "tank.py:tank" }
[requirements]
tank = "tank < 5 bar"
[drawing]
tank = { x = 1, y = 2 }
"tank.command" = { points = [[1, 2]] }
"tank2.command" = { points = [[1, 2]] }
"""
RENAMED = [
    "[parts.tank]", 'supply = "tank"', "outlet = 'tank.cap'", 'from = "tank.outlet"', 'body = "tank"',
    'main_stage = { exhaust = "tank" }', "and tank.pressure > 3 tank.m'", '"(not tank.on or tank2.on)"',
    "tank.pressure > > 2", 'measurement = "tank.pressure"', 'joined = "tank"', '[signals."tank.pressure"]',
    "[signals.tank.temperature]", '"tank.command" = "tank.pressure"', 'tank.other = "tank2.pressure"',
    'stop_when = ["tank.pressure > 5 bar", "tank2.pressure < tank.pressure"]', 'curves = ["tank.pressure"]',
    '"tank.volume" = { distribution', 'of = "tank.pressure", metric = "overshoot", target = "tank.setpoint"',
    'of = ["tank.pressure", "tank2.pressure"]', "tank = { x = 1, y = 2 }", '"tank.command" = { points = [[1, 2]] }',
]  # fmt: skip


def rename(text: str, old: str, new: str) -> str:
    return Document(text).apply([{"op": "rename", "part": old, "name": new}]).text


def test_all_places_and_no_others():
    text = EVERYWHERE
    expected = text
    for piece in RENAMED:
        assert expected.count(piece) == 1, piece
        new = re.sub(r"(?<!\w)tank(?!2)", "vessel-1", piece.replace("3 tank.m", "3 UNIT"))
        expected = expected.replace(piece, new.replace("UNIT", "tank.m"))
    assert rename(text, "tank", "vessel-1").splitlines() == expected.splitlines()
    assert rename(rename(text, "tank", "vessel-1"), "vessel-1", "tank") == text
    windows = text.replace("\n", "\r\n")
    assert rename(windows, "tank", "v").replace("\r\n", "\n") == rename(text, "tank", "v")


@pytest.mark.parametrize("file", EXAMPLES)
def test_examples_are_valid_after_each_rename(file):
    text = EXAMPLES[file]
    folder = (ROOT / file).parent
    for name in tomllib.loads(text)["parts"]:
        after = rename(text, name, "zz-1")
        assert rename(after, "zz-1", name) == text
    # All names at the same time, with one check.
    for number, name in enumerate(tomllib.loads(text)["parts"]):
        text = rename(text, name, f"zz-{number}")
    before, after = loads(EXAMPLES[file], folder=folder), loads(text, folder=folder)
    assert [*after.parts] == [f"zz-{k}" for k in range(len(before.parts))]
    assert len(after.connections) == len(before.connections)
    assert len(after.run.stop_texts) == len(before.run.stop_texts)
    if "ensemble" in tomllib.loads(text):
        plan_of(after)


@dataclass(frozen=True)
class Probe(Controller):
    """Controller of a plugin."""

    kind: ClassVar[str] = "probe"
    summary: ClassVar[str] = "probe"
    where: str | None = port("gas node")
    observed: Any = reference(doc="address of an output")  # noqa: RUF009
    label: Any = reference(doc="text")  # noqa: RUF009

    def connections(self) -> dict[str, PartConnection]:
        return {"observed": PartConnection(self.observed, "observed")}

    def control(self, scope: Scope) -> ControlOutputs:
        return ControlOutputs({})


def test_parts_of_plugins_by_their_declarations(monkeypatch):
    monkeypatch.setitem(KINDS, "probe", Probe)
    text = (
        '[parts.tank]\nkind = "chamber"\n[parts.probe]\nkind = "probe"\nwhere = "tank"\n'
        'observed = "tank.pressure"\nlabel = "tank.pressure"\n'
    )
    after = rename(text, "tank", "vessel")
    parts = tomllib.loads(after)["parts"]["probe"]
    assert (parts["where"], parts["observed"], parts["label"]) == ("vessel", "vessel.pressure", "tank.pressure")


def test_references_of_an_invalid_table():
    assert [*references(3)] == []
    assert [*references({"kind": []}, ["a"])] == []
    assert [reference.path for reference in references({"kind": "?", "x": "a.b", "y": "c"}, ["a"])] == [("x",)]


def test_a_rename_to_a_name_of_a_part_is_rejected():
    with pytest.raises(InputError):
        rename(EVERYWHERE, "tank", "valve")


MODBUS = """
[modbus.registers]
"tank.pressure" = { input = 0 }  # gauge
hole.opening = { holding = 0 }
"""


def test_registers_follow_the_name_of_their_part():
    text = renamed(TomlText(MODBUS), {}, "tank", "vessel")
    assert text == MODBUS.replace('"tank.pressure"', '"vessel.pressure"')
    text = renamed(TomlText(MODBUS), {}, "hole", "gap")
    assert text == MODBUS.replace("hole.", "gap.")
    for removed, left in (("tank", {"hole": {"opening": {"holding": 0}}}), ("hole", {"tank.pressure": {"input": 0}})):
        after = tomllib.loads(without_references(TomlText(MODBUS), {}, {removed}))
        assert after["modbus"]["registers"] == left
