"""Documents of the editor: texts that do not change on their own, views, and the history."""

from __future__ import annotations

import json
import random
import subprocess
import sys
import tomllib
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from poppet import loads
from poppet.core.errors import InputError
from poppet.edit import document as document_module
from poppet.edit.document import Document, History
from poppet.parts import KINDS
from refusals import refused

ROOT = Path(__file__).parents[3]
FILES = {
    str(path.relative_to(ROOT)): text
    for path in sorted((ROOT / "examples").rglob("*.toml"))
    if "parts" in tomllib.loads(text := path.read_bytes().decode("utf-8"))
}


@pytest.mark.parametrize("file", FILES)
@pytest.mark.parametrize("line_ending", ["\n", "\r\n"])
def test_examples_are_unchanged(file, line_ending):
    text = FILES[file].replace("\n", line_ending)
    history = History(text)
    view = history.document.view()
    json.dumps(view, allow_nan=False)
    assert [*view["parts"]] == [*tomllib.loads(FILES[file])["parts"]]
    assert history.document.text == text
    for name in view["parts"]:
        history.apply(history.revision, [{"op": "place", "part": name, "x": 1, "y": 2}])
    assert history.document.text.startswith(text)  # only the drawing is new
    assert history.document.text.count("\n") == history.document.text.count(line_ending)
    loads(history.document.text, folder=(ROOT / file).parent)
    while history.can_undo:
        history.undo(history.revision)
    assert history.document.text == text


def random_operation(rng: random.Random, view: dict[str, Any], number: int) -> dict[str, Any]:
    parts = view["parts"]
    names = [*parts] or ["none"]
    one, other = rng.choice(names), rng.choice(names)
    fields = [*parts.get(one, {"fields": {}})["fields"], f"new_{number}", f"group.new_{number}"]
    ports = [f"{name}.{port}" for name, part in parts.items() for port in part["ports"]] or ["none.from"]
    pulse = {"kind": "steps", "times": [0, number], "values": [0, 1]}
    operations: list[dict[str, Any]] = [
        {"op": "add", "kind": rng.choice([*KINDS])},
        {"op": "add", "kind": rng.choice([*KINDS]), "name": f"n{number}", "place": {"x": number, "y": 0.5}},
        {"op": "remove", "parts": sorted({one, other})},
        {"op": "rename", "part": one, "name": f"r{number}"},
        {
            "op": "set",
            "address": f"{one}.{rng.choice(fields)}",
            "value": rng.choice([None, 1.5, "2 bar", True, [1, 2]]),
        },
        {"op": "set", "address": rng.choice(["run.duration", "title", "gas", "ambient.pressure"]), "value": "1 s"},
        {"op": "connect", "port": rng.choice(ports), "to": rng.choice([other, "ambient", rng.choice(ports)])},
        {"op": "disconnect", "port": rng.choice(ports)},
        {"op": "signal", "address": f"{one}.command", "table": rng.choice([None, number, pulse])},
        {"op": "link", "input": f"{one}.command", "output": f"{other}.pressure"},
        {"op": "unlink", "input": f"{one}.command"},
        {"op": "place", "part": one, "x": rng.random(), "y": number, "rotation": rng.choice([0, 90, 180, 270])},
        {"op": "route", "port": rng.choice(ports), "points": rng.choice([None, [[1, number]]])},
        {"op": "paste", "parts": {one: {"kind": "orifice", "from": other}}, "drawing": {one: {"x": 1, "y": 2}}},
    ]
    return rng.choice(operations)


EXPECTED = {"edit.two_ports", "edit.no_table", "names.unknown", "fields.not_an_option", "edit.no_port"}


@pytest.mark.parametrize("seed", range(8))
def test_random_operations_and_undo(seed):
    rng = random.Random(seed)
    codes = set()
    for text in rng.sample([*FILES.values()], 5):
        text = text.replace("\n", rng.choice(["\n", "\r\n"]))
        history, texts = History(text), [text]
        while len(texts) <= 50:
            before = history.document
            operation = random_operation(rng, before.view(), len(texts))
            try:
                after = history.apply(history.revision, [operation])
            except InputError as error:
                codes.add(error.code)
                assert history.document is before
                continue
            texts.append(after.text)
            content = tomllib.loads(after.text.replace("\r\n", "\n"))
            check(operation, tomllib.loads(before.text.replace("\r\n", "\n")), content)
            assert ("\r\n" in text) == ("\r\n" in after.text)
            assert after.text.count("\n") in (0, after.text.count("\r\n") or after.text.count("\n"))
        for _ in range(sum(a != b for a, b in pairwise(texts))):
            history.undo(history.revision)
        assert history.document.text == text
        assert not history.can_undo
        while history.can_redo:
            history.redo(history.revision)
        assert history.document.text == texts[-1]
    assert codes <= EXPECTED


def check(operation: dict[str, Any], before: Any, after: Any) -> None:
    """The content that an operation states, and no change of other parts."""
    old, new = before.get("parts", {}), after.get("parts", {})
    match operation:
        case {"op": "add", "kind": kind}:
            (name,) = new.keys() - old.keys()
            assert new == old | {name: {"kind": kind}}
        case {"op": "remove", "parts": names}:
            assert new.keys() == old.keys() - {*names}
            for name in new:
                assert new[name].items() <= old[name].items() or has_members(old[name])
        case {"op": "rename", "part": part, "name": name}:
            assert [*new] == [name if other == part else other for other in old]
        case {"op": "set", "address": address, "value": value}:
            start, _, rest = address.partition(".")
            place: Any = new.get(start, after)
            names = rest.split(".") if start in new else address.split(".")
            for name in names[:-1]:
                place = place.get(name, {})
            assert place.get(names[-1]) == value or "." in rest
            assert {k: v for k, v in new.items() if k != start} == {k: v for k, v in old.items() if k != start}
        case {"op": "place", "part": part, "x": x, "y": y}:
            assert (after["drawing"][part]["x"], after["drawing"][part]["y"]) == (x, y)
            assert new == old
        case {"op": "link", "input": target, "output": source}:
            assert Document.view(Document(text_of(after)))["connections"][target] == source
            assert new == old
    untouched = ("title", "components", "gas", "ensemble", "requirements")
    if operation["op"] in ("place", "route", "connect", "signal", "add", "disconnect"):
        assert all(before.get(name) == after.get(name) for name in untouched)


def has_members(table: dict[str, Any]) -> bool:
    return any(isinstance(value, dict) for value in table.values())


def text_of(content: dict[str, Any]) -> str:
    from poppet.core.toml import toml_text

    return toml_text({"connections": content["connections"]})


def test_view():
    text = (
        'title = "T"\n[parts.v]\nkind = "main_stage"\nsupply = "s"\nplate_area = "1 mm^2"\nlower_spring.rate = 2\n'
        '[parts.v.upper_spring]\nrate = "3 N/m"\n[parts.c]\nkind = "cylinder"\nbody = "m"\n'
        "[parts.c.cap]\nvolume = 1979-05-27\n[parts.x]\nanything = inf\n"
        '[signals.v.stroke]\nkind = "steps"\n[connections]\n"v.p" = "c.q"\n'
        "[drawing]\nv = { x = 1, y = 2 }\n[run]\nduration = 3\n"
        '[ambient]\npressure = "1 bar"\n[gas]\nname = "helium"\n'
    )
    view = Document(text).view()
    assert view == {
        "title": "T",
        "parts": {
            "v": {
                "kind": "main_stage", "ports": {"supply": "s"}, "line": 2,
                "fields": {"plate_area": "1 mm^2", "lower_spring.rate": 2, "upper_spring.rate": "3 N/m"},
            },
            "c": {"kind": "cylinder", "ports": {"body": "m"}, "fields": {"cap.volume": "1979-05-27"}, "line": 9},
            "x": {"kind": "", "ports": {}, "fields": {"anything": "inf"}, "line": 14},
        },
        "connections": {"v.p": "c.q"},
        "signals": {"v.stroke": {"kind": "steps"}},
        "drawing": {"v": {"x": 1, "y": 2}},
        "run": {"duration": 3},
        "ambient": {"pressure": "1 bar"},
        "gas": {"name": "helium"},
    }  # fmt: skip


@pytest.mark.parametrize(
    ("text", "line", "column"),
    [
        ("a = 1\nb = \n", 2, 5),
        ("a = 1\r\n\r\nb = [1,, 2]\r\n", 3, 8),
        ('title = "x\n', 1, 11),
        ("[parts.a]\nx = 1\nx = 2\n", 3, 1),
        ("[a]\n[a]\n", 2, 1),
    ],
)
def test_location_of_a_syntax_error(text, line, column):
    error = Document(text).view()["error"]
    assert error["line"] == line
    assert abs(error["column"] - column) <= 1
    with pytest.raises(InputError):
        Document(text).apply([])


@pytest.mark.parametrize(
    "text", ["", "parts = 3", "parts = [1]\nsignals = 2", "[[parts]]\na = 1", "[parts]\na = 1", "\ufeff"]
)
def test_odd_content_has_a_view(text):
    json.dumps(Document(text).view())


def test_byte_order_mark_is_kept():
    after = Document('\ufeff[parts.a]\nkind = "mass"\n').apply([{"op": "set", "address": "a.mass", "value": 1}])
    assert after.text == '\ufeff[parts.a]\nkind = "mass"\nmass = 1\n'


def test_history():
    history = History("")
    history.apply(0, [{"op": "add", "kind": "mass"}, {"op": "set", "address": "mass.mass", "value": 1}])
    history.apply(1, [])  # no change, no revision
    with refused("edit.stale", revision=0, present=1):
        history.apply(0, [])
    history.replace(1, "not = TOML =")
    assert history.document.error is not None
    assert history.undo(2).text.endswith("mass = 1\n")
    assert history.undo(3).text == ""
    with refused("edit.no_undo"):
        history.undo(4)
    assert history.redo(4).text.endswith("mass = 1\n")
    history.apply(5, [{"op": "add", "kind": "joint"}])
    with refused("edit.no_redo"):
        history.redo(6)
    assert history.revision == 6


def test_the_parser_for_syntax_errors_is_imported_on_demand():
    code = (
        "import sys; from poppet.edit.document import Document; Document('a = 1').apply([]).view();"
        "assert 'tomlkit' not in sys.modules; Document('a =').view(); assert 'tomlkit' in sys.modules;"
        "assert not {'matplotlib', 'pandas'} & {*sys.modules}"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def volume(value, part="tank"):
    return [{"op": "set", "address": f"{part}.volume", "value": value}]


def test_continued_changes_of_one_field_are_one_step():
    history = History(PAIR)
    for value in ("2 l", "3 l", "4 l"):
        history.apply(history.revision, volume(value), continues=True)
    for value in ("2 l", "3 l"):
        history.apply(history.revision, volume(value, "vessel"), continues=True)
    assert history.undo(history.revision).text == PAIR.replace("1 l", "4 l", 1)
    assert history.undo(history.revision).text == PAIR
    assert not history.can_undo


def test_other_changes_are_steps_of_their_own():
    history = History(PAIR)
    history.apply(history.revision, volume("2 l"), continues=True)
    history.apply(history.revision, volume("3 l"))
    history.apply(history.revision, volume("4 l"), continues=True)
    texts = [history.undo(history.revision).text for _ in range(3)]
    assert texts == [PAIR.replace("1 l", value, 1) for value in ("3 l", "2 l", "1 l")]


PAIR = """\
[parts.tank]
kind = "chamber"
volume = "1 l"

[parts.vessel]
kind = "chamber"
volume = "1 l"
"""


def test_the_oldest_texts_of_a_long_history_are_deleted(monkeypatch):
    monkeypatch.setattr(document_module, "MAX_HISTORY", 1000)
    history = History("#")
    for number in range(50):
        history.replace(number, f"{number:0100d}")
    while history.can_undo:
        text = history.undo(history.revision).text
    assert text == f"{40:0100d}"
    while history.can_redo:
        text = history.redo(history.revision).text
    assert text == f"{49:0100d}"
