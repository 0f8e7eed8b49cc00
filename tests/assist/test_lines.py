"""The functions as lines of JSON: a real process, invalid requests, limits, cancelled calls."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import time

import pytest

from assistant_client import codes, environment, lines
from poppet.assist.functions import FUNCTIONS

SLOW = {"file": "tank.toml", "duration": "1e8 s", "output_step": "1e6 s", "set": {"run.maximum_step": "1 ms"}}
"""Arguments of a simulation that takes far longer than the tests."""


def test_replies_have_the_order_and_identifiers_of_the_requests(folder):
    requests = [
        {"call": "check", "arguments": {"file": "tank.toml"}, "id": "a"},
        {"call": "simulate", "arguments": {"file": "tank.toml", "times": [10.0], "select": ["tank.pressure"]}, "id": 2},
        {"call": "list_files"},
        {"call": "functions"},
    ]
    first, second, third, fourth = lines(folder, requests)
    assert (first["id"], second["id"]) == ("a", 2)
    assert first["result"]["counts"]["parts"] == 3
    assert second["result"]["summary"]["tank.pressure"]["last"] == pytest.approx(7.0, rel=1e-4)
    assert len(second["result"]["values_at"]["tank.pressure"]["values"]) == 1
    assert [row["name"] for row in third["result"]["files"]] == ["tank.toml"]
    assert [row["name"] for row in fourth["result"]] == list(FUNCTIONS)


BIG = "".join(f'[parts.p{k}]\nkind = "chamber"\nvolume = "1 l"\n' for k in range(6000))
"""Circuit with more parts than permitted."""
INVALID = [
    (b"", None),
    (b"{", "assist.no_json"),
    (b"\xff\xfe", "assist.no_json"),
    (b"[" * 100_000, "assist.no_json"),
    (b"1" * 5000, "assist.no_json"),
    (b"x" * 10_000_000, "assist.long_line"),
    (b"[]", "assist.no_request"),
    (b'"call"', "assist.no_request"),
    ({}, "assist.no_request"),
    ({"call": "check", "cancel": 1}, "assist.no_request"),
    ({"call": "check", "id": [1]}, "assist.no_identifier"),
    ({"call": "check", "argument": {}}, "assist.unknown_key"),
    ({"call": 5}, "names.unknown"),
    ({"call": "chek"}, "names.unknown"),
    ({"call": "check"}, "assist.one_circuit"),
    ({"call": "check", "arguments": []}, "fields.no_table"),
    ({"call": "check", "arguments": {"file": "a.toml", "text": "x"}}, "assist.one_circuit"),
    ({"call": "check", "arguments": {"fil": "a.toml"}}, "fields.unknown"),
    ({"call": "check", "arguments": {"file": 5}}, "fields.other_type"),
    ({"call": "check", "arguments": {"file": "\ud800.toml"}}, "assist.no_text"),
    ({"call": "check", "arguments": {"text": "x" * (2**20 + 1)}}, "assist.too_long"),
    ({"call": "check", "arguments": {"file": "a.toml"}}, "names.unknown"),
    ({"call": "check", "arguments": {"text": "a = "}}, "toml.invalid"),
    ({"call": "check", "arguments": {"text": "a." * 1000}}, "toml.too_deep"),
    ({"call": "check", "arguments": {"text": "[parts]\na = 3"}}, "circuit.no_part"),
    ({"call": "check", "arguments": {"text": BIG}}, "wiring.too_many"),
    ({"call": "simulate", "arguments": {"file": "tank.toml", "duration": "1e30 s"}}, "quantity.too_large"),
    ({"call": "simulate", "arguments": {"file": "tank.toml", "rows": 10**6}}, "fields.out_of_range"),
    ({"call": "simulate", "arguments": {"file": "tank.toml", "rows": True}}, "fields.other_type"),
    ({"call": "simulate", "arguments": {"file": "tank.toml", "tolerance": 10**400}}, "fields.out_of_range"),
    ({"call": "simulate", "arguments": {"file": "tank.toml", "figure": "pdf"}}, "fields.not_an_option"),
    ({"call": "simulate", "arguments": {"file": "tank.toml", "select": "tank"}}, "fields.other_type"),
    ({"call": "simulate", "arguments": {"file": "tank.toml", "select": ["x"]}}, "names.unknown"),
    ({"call": "simulate", "arguments": {"file": "tank.toml", "set": {"tank.volume": [1]}}}, "fields.other_type"),
    ({"call": "simulate", "arguments": {"file": "tank.toml", "output_step": "1 us"}}, "assist.too_many_rows"),
    ({"call": "simulate", "arguments": {"file": "tank.toml", "output": "../x.csv"}}, "assist.file_name"),
    ({"call": "simulate", "arguments": {"file": "tank.toml", "with_result": "x.toml"}}, "names.unknown"),
    ({"call": "size", "arguments": {"file": "tank.toml"}}, "assist.one_subject"),
    ({"call": "size", "arguments": {"file": "tank.toml", "free": "x", "catalogue": "valve"}}, "assist.one_subject"),
    ({"call": "size", "arguments": {"file": "tank.toml", "catalogue": 5}}, "fields.other_type"),
    ({"call": "size", "arguments": {"file": "tank.toml", "catalogue": "x" * 201}}, "assist.too_long"),
    ({"call": "size", "arguments": {"file": "tank.toml", "catalogue": "valve", "find": "x" * 201}}, "assist.too_long"),
    ({"call": "size", "arguments": {"file": "tank.toml", "catalogue": "valv"}}, "names.unknown"),
    ({"call": "size", "arguments": {"file": "tank.toml", "catalogue": "supply"}}, "size.no_component"),
    ({"call": "size", "arguments": {"file": "tank.toml", "free": "x", "find": "C"}}, "assist.excluded"),
    ({"call": "explain", "arguments": {}}, "fields.missing"),
    ({"call": "find_components", "arguments": {"conditions": "nothing"}}, "components.no_word"),
    ({"call": "ensemble", "arguments": {"file": "tank.toml", "runs": 10**7}}, "fields.out_of_range"),
    ({"call": "identify", "arguments": {"method": "fit", "file": "tank.toml", "compare": "/x"}}, "assist.file_name"),
    ({"call": "identify", "arguments": {"method": "flow", "file": "tank.toml", "bootstrap": 5}}, "assist.no_option"),
    ({"call": "describe_kind", "arguments": {"kind": "orifce"}}, "fields.not_an_option"),
    ({"call": "explain", "arguments": {"name": "fields.mising"}}, "cli.code"),
]


LINE_ERRORS = ("assist.no_json", "assist.long_line", "assist.no_request", "assist.no_identifier")


def test_invalid_requests_have_code_address_and_hint(folder):
    expected = [code for _, code in INVALID if code is not None]
    replies = lines(folder, [request for request, _ in INVALID])
    assert [codes(reply)[0] for reply in replies] == expected
    for reply in replies:
        assert all(row["code"] and row["message"] and row["hint"] and "address" in row for row in reply["errors"])
        # Errors of the line itself have no address.
        assert [row["code"] for row in reply["errors"] if not row["address"] and row["code"] not in LINE_ERRORS] == []
        assert str(folder) not in json.dumps(reply)


def test_random_requests_do_no_harm(folder):
    chance = random.Random(5)
    words = [None, True, -1, 1e308, float("inf"), "", "tank.toml", "\x00", "💨", [], [[]], {}, {"a": {"b": 1}}, 10**40]

    def value(depth: int = 0):
        if depth < 3 and chance.random() < 0.3:
            return {str(chance.choice(words))[:5]: value(depth + 1)}
        return [value(depth + 1)] if depth < 3 and chance.random() < 0.2 else chance.choice(words)

    def request():
        name = chance.choice([*FUNCTIONS, "functions", "x", None])
        schema = FUNCTIONS[name].schema["properties"] if name in FUNCTIONS else {}
        names = chance.sample([*schema, "y"], k=chance.randint(0, min(3, len(schema) + 1)))
        return {"call": name, "arguments": {key: value() for key in names}}

    requests = [request() for _ in range(150)]
    requests += [bytes(chance.randrange(256) for _ in range(40)).replace(b"\n", b" ") + b"!" for _ in range(50)]
    replies = lines(folder, [*requests, {"call": "list_files", "id": "last"}])
    assert len(replies) == 201
    assert all(("result" in reply) != ("errors" in reply) for reply in replies)
    names = [row["name"] for row in replies[-1]["result"]["files"]]
    assert "tank.toml" in names


def test_a_slow_call_is_stopped(folder):
    begin = time.monotonic()
    (reply,) = lines(folder, [{"call": "simulate", "arguments": {**SLOW, "time_limit": 1000.0}}], "--time-limit", "1")
    assert time.monotonic() - begin < 30.0
    assert reply["result"]["is_stopped"]
    assert reply["result"]["notes"][0]["code"] == "assist.stopped"


class Process:
    """Running server, to which a test writes lines."""

    def __init__(self, folder) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", "poppet", "mcp", str(folder), "--lines"],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment(),
        )  # fmt: skip

    def send(self, request) -> None:
        self.process.stdin.write(json.dumps(request).encode() + b"\n")
        self.process.stdin.flush()

    def reply(self):
        return json.loads(self.process.stdout.readline())

    def workers(self) -> list[int]:
        """Identifiers of the processes of calls."""
        listed = subprocess.run(["ps", "-o", "pid=", "--ppid", str(self.process.pid)], capture_output=True, check=False)
        return [int(line) for line in listed.stdout.split()]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        self.process.wait(30)
        self.process.stdout.close()


def test_a_call_is_cancelled_and_the_next_one_works(folder):
    with Process(folder) as server:
        server.send({"call": "simulate", "arguments": SLOW, "id": 1})
        server.send({"call": "list_kinds", "id": 2})
        server.send({"cancel": 7, "id": 3})
        assert server.reply() == {"id": 3, "result": {"is_cancelled": False}}
        server.send({"cancel": 1, "id": 4})
        replies = [server.reply() for _ in range(3)]
        assert {"id": 4, "result": {"is_cancelled": True}} in replies
        by_id = {reply["id"]: reply for reply in replies}
        assert codes(by_id[1]) == ["assist.cancelled"]
        assert "reservoir" in by_id[2]["result"]["kinds"]


@pytest.mark.skipif(sys.platform != "linux", reason="ps has other options")
def test_a_killed_process_ends_its_call_only(folder):
    with Process(folder) as server:
        server.send({"call": "check", "arguments": {"file": "tank.toml"}})
        assert server.reply()["result"]["is_valid"]
        (worker,) = server.workers()
        server.send({"call": "simulate", "arguments": SLOW})
        server.send({"call": "check", "arguments": {"file": "tank.toml"}})
        time.sleep(0.5)
        os.kill(worker, signal.SIGKILL)
        assert codes(server.reply()) == ["assist.process_ended"]
        assert server.reply()["result"]["is_valid"]


@pytest.mark.skipif(sys.platform != "linux", reason="ps has other options")
def test_no_process_outlives_the_server(folder):
    with Process(folder) as server:
        server.send({"call": "check", "arguments": {"file": "tank.toml"}})
        server.reply()
        server.send({"call": "simulate", "arguments": SLOW})
        (worker,) = server.workers()
        temporary = os.readlink(f"/proc/{worker}/cwd")
        server.process.kill()
    deadline = time.monotonic() + 20.0
    while time.monotonic() < deadline and os.path.exists(f"/proc/{worker}"):
        time.sleep(0.1)
    assert not os.path.exists(f"/proc/{worker}")
    assert not os.path.exists(temporary)


def test_modules_of_the_folder_are_not_imported(folder):
    for name in ("numpy", "poppet", "mcp", "matplotlib"):
        (folder / f"{name}.py").write_text("raise SystemExit('imported from the folder')\n")
    (folder / "matplotlibrc").write_text("nonsense\n")
    data = json.dumps({"call": "simulate", "arguments": {"file": "tank.toml", "figure": "svg"}}).encode() + b"\n"
    environ = {key: value for key, value in environment().items() if key != "PYTHONPATH"}
    program = f"import sys; sys.path.insert(0, {environment()['PYTHONPATH']!r}); from poppet.cli.main import run; run()"
    command = [sys.executable, "-P", "-c", program, "mcp", "--lines"]
    done = subprocess.run(command, cwd=folder, input=data, capture_output=True, env=environ, check=False, timeout=60)
    reply = json.loads(done.stdout)
    assert reply["result"]["figure"]["media_type"] == "image/svg+xml"
