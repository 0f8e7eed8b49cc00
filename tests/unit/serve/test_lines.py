"""JSON lines: commands and replies."""

from __future__ import annotations

import io
import json

import numpy as np
import pytest

import poppet
from poppet.serve.lines import JsonLines
from served_tanks import SWITCHED_TANK


@pytest.fixture
def machine():
    with poppet.loads(SWITCHED_TANK).serve(clock=False) as machine:
        yield machine


@pytest.fixture
def ask(machine):
    lines = JsonLines(0.0, io.BytesIO(), io.StringIO())

    def reply(content) -> dict:
        line = content if isinstance(content, bytes) else json.dumps(content).encode()
        # As a client reads it: without numbers that JSON does not have.
        return json.loads(json.dumps(lines.reply(machine, line), allow_nan=False))

    return reply


def codes(reply) -> list[str]:
    assert reply["ok"] is False
    assert all(error["message"] and error["hint"] for error in reply["errors"])
    return [error["code"] for error in reply["errors"]]


def test_commands(machine, ask):
    assert ask({"set": {"valve.command": 1, "supply.pressure": "5 bar g"}, "id": 7}) == {"id": 7, "ok": True}
    assert ask({"fault": {"valve": "leak"}}) == {"ok": True}
    assert ask({"get": ["valve.fault"]})["values"] == {"valve.fault": "leak"}
    # There are no outputs before the first period.
    assert ask({"get": ["tank.pressure"]})["values"] == {"tank.pressure": None}
    machine.advance("0.1 s")
    reply = ask({"get": ["supply.pressure", "tank.volume", "tank.pressure"]})
    assert (reply["period"], reply["state"], reply["time"]) == (10, "running", pytest.approx(0.1))
    assert reply["values"]["supply.pressure"] == 6e5
    assert reply["values"]["tank.volume"] == 0.002
    assert reply["values"]["tank.pressure"] > 1.1e5
    assert ask({"stop": True}) == {"ok": True}
    assert ask({"get": []})["state"] == "stopped"


def test_list_of_points(machine, ask):
    reply = ask({"list": True})
    assert [row["address"] for row in reply["points"]] == [point.address for point in machine.points]
    (command,) = [row for row in reply["points"] if row["address"] == "valve.command"]
    assert command["role"] == "input"
    assert (command["low"], command["high"], command["initial"]) == (0.0, 1.0, 0.0)
    assert reply["faults"] == {"valve": [*machine.faults["valve"]]}


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        (b"[1, 2]", ["serve.no_command"]),
        (b"{}", ["serve.no_command"]),
        (b'{"id": 3}', ["serve.no_command"]),
        (b'{"set": ', ["stream.no_json"]),
        (b"\xff\xfe{}", ["stream.no_text"]),
        (b"{" * 100_000, ["stream.no_json"]),
        (b" " * (2**20 + 2), ["stream.long_line"]),
        ({"sett": {}}, ["names.unknown"]),
        ({"set": [1], "fault": "leak", "get": "tank.pressure"}, ["serve.command_type"] * 3),
        ({"get": ["tank.presure", 3]}, ["names.unknown"] * 2),
        ({"set": {"valve.command": None}}, ["quantity.not_a_number"]),
        ({"set": {"valve.command": {"a": [1]}}}, ["quantity.not_a_number"]),
        (b'{"set": {"valve.command": 1e999}}', ["quantity.not_finite"]),
        (b'{"set": {"valve.command": 1' + b"0" * 400 + b"}}", ["quantity.not_finite"]),
        (b'{"set": {"valve.command": 1' + b"0" * 5000 + b"}}", ["stream.no_json"]),
        ({"set": {"supply.pressure": "5 mm"}}, ["quantity.other_quantity"]),
        ({"fault": {"valve": ["leak"]}}, ["fields.not_an_option"]),
        ({"fault": {"tank": "leak"}}, ["names.unknown"]),
    ],
)
def test_invalid_lines(ask, line, expected):
    assert codes(ask(line)) == expected


def test_of_an_invalid_line_nothing_is_executed(machine, ask):
    reply = ask({"set": {"valve.command": 1}, "fault": {"valve": "stuk"}, "get": ["x"], "id": "a"})
    assert reply["id"] == "a"
    assert codes(reply) == ["names.unknown", "fields.not_an_option"]
    for further in {"get": ["x"]}, {"stop": "false"}, {"list": 1}:
        reply = ask({"set": {"valve.command": 1}, "fault": {"valve": "leak"}, **further})
        assert codes(reply) == ["names.unknown" if "get" in further else "serve.command_type"]
    assert machine.snapshot()["valve.command"] == 0.0
    assert machine.fault_of("valve") == "none"
    assert not machine.is_stopping


def test_summary(machine):
    lines = JsonLines(0.0, io.BytesIO(), io.StringIO())
    lines.reply(machine, b"{}")
    lines.reply(machine, b'{"list": true}')
    assert [str(note) for note in lines.summary()] == ["Standard input: 2 lines, 1 with errors."]


def test_random_lines_have_replies_and_write_only_valid_values(machine, ask):
    random = np.random.default_rng(4)
    keys = ["set", "fault", "get", "list", "id", "stop?", "valve.command", "tank.pressure", "valve", ""]
    values = [
        None,
        True,
        -1,
        0.5,
        2,
        10**400,
        1e308,
        "1",
        "5 bar g",
        "stuck",
        "none",
        [],
        {},
        ["tank.pressure"],
        "\ud800",
    ]

    def value(depth: int) -> object:
        kind = random.integers(4)
        if depth and kind == 0:
            return {keys[random.integers(len(keys))]: value(depth - 1) for _ in range(random.integers(4))}
        if depth and kind == 1:
            return [value(depth - 1) for _ in range(random.integers(4))]
        return values[random.integers(len(values))]

    for _ in range(400):
        line = json.dumps({keys[random.integers(len(keys))]: value(3) for _ in range(random.integers(1, 4))}).encode()
        if random.random() < 0.2:
            k = random.integers(len(line))
            line = line[:k] + bytes(random.integers(256, size=3).tolist()) + line[k + 1 :]
        reply = ask(line)
        assert isinstance(reply["ok"], bool)
        assert all(error["code"] for error in reply.get("errors", [])), (line, reply)
        for point in machine.points[:3]:
            assert point.low <= machine.snapshot()[point.address] <= point.high
