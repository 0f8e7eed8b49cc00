"""`poppet serve`: options, recording, JSON lines, Ctrl-C, and failures."""

from __future__ import annotations

import errno
import io
import json
import os
import signal
import socket
import subprocess
import sys
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import poppet as package
from served_tanks import EMPTIED_TANK, FILLED_TANK

RUN = """
[run]
duration = "1 s"
stop_when = "tank.pressure > 1.5 bar"
"""


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "tank.toml"
    path.write_text(f'title = "Tank"\n{FILLED_TANK}{RUN}', encoding="utf-8")
    return path


@pytest.fixture
def serve(poppet, file, monkeypatch):
    def run(*arguments, lines=b""):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(lines)))
        return poppet("serve", str(file), *arguments)

    return run


def process_of(file, *arguments):
    """Start the command in a process of its own."""
    command = [sys.executable, "-m", "poppet", "serve", str(file), *arguments]
    pipe = subprocess.PIPE
    # Tests that run under nohup ignore this signal, which their processes inherit.
    reset = None if sys.platform == "win32" else partial(signal.signal, signal.SIGHUP, signal.SIG_DFL)
    return subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=pipe, text=True, preexec_fn=reset)


def test_a_recording_equals_the_simulation(serve, file):
    answer = serve("--duration", "2 s", "--speed", "inf", "--period", "20 ms", "--record", "run.csv")
    assert answer.code == 0
    assert "stop conditions of the circuit are ignored" in answer.err
    assert "run.csv: 101 rows written." in answer.out
    recording = package.Recording.read("run.csv")
    circuit = package.load(file).with_values({"run.stop_when": None})
    expected = circuit.simulate("2 s", "20 ms")
    assert np.allclose(recording.time, expected.time, rtol=1e-15)
    assert np.allclose(recording["tank.pressure"], expected["tank.pressure"], rtol=1e-5)
    assert set(expected.names) < set(recording.names)


def test_a_machine_that_does_not_wait_for_time_waits_for_its_recorder(serve, file):
    # More rows than the machine keeps.
    count = 20_000
    answer = serve("--duration", f"{count * 0.01} s", "--speed", "inf", "--record", "run.csv")
    assert f"run.csv: {count + 1} rows written." in answer.out
    assert np.allclose(np.diff(package.Recording.read("run.csv").time), 0.01)


def test_lateness_is_printed(serve):
    answer = serve("--duration", "0.1 s")
    assert answer.code == 0
    assert "0.1 s in 11 periods." in answer.out
    assert "100.0000 %" in answer.out


def test_json_lines(file):
    process = process_of(file, "--lines", "0.05")
    periodic = json.loads(process.stdout.readline())
    assert periodic["state"] == "running"
    assert set(periodic["values"]) == set(package.load(file).model.columns[0])
    process.stdin.write('{"set": {"supply.pressure": "3 bar"}, "id": 1}\n{"stop": true, "id": 2}\n')
    process.stdin.flush()
    out, err = process.communicate(timeout=60)
    replies = [reply for reply in map(json.loads, out.splitlines()) if "ok" in reply]
    assert replies == [{"id": 1, "ok": True}, {"id": 2, "ok": True}]
    assert process.returncode == 0, err
    assert "2 lines, 0 with errors" in err


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
@pytest.mark.skipif(sys.platform == "win32", reason="signals of Windows reach the whole console")
def test_an_interrupt_ends_the_run_with_a_complete_recording(file, tmp_path, name):
    recording = tmp_path / "run.csv"
    process = process_of(file, "--record", str(recording), "--lines", "0.01")
    for _ in range(10):
        last = json.loads(process.stdout.readline())
    process.send_signal(getattr(signal, name))
    out, err = process.communicate(timeout=60)
    assert process.returncode == 0, err
    assert f"{recording}: " in err
    times = package.Recording.read(recording).time
    assert times[0] == 0.0
    for line in out.splitlines():
        last = json.loads(line)
    assert times[-1] >= last["time"]
    assert np.allclose(np.diff(times), 0.01)
    assert [path.name for path in tmp_path.iterdir() if path.suffix != ".toml"] == ["run.csv"]


def test_a_full_disk_ends_the_run_with_the_rows_until_then(serve, tmp_path, monkeypatch):
    limit = 100_000

    def write_until_full(file, content):
        space = limit - os.fstat(file).st_size
        if space <= 0:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return os.write(file, content[:space])

    system = SimpleNamespace(write=write_until_full, fstat=os.fstat, ftruncate=os.ftruncate)
    monkeypatch.setattr("poppet.serve.recorder.os", system)
    answer = serve("--speed", "inf", "--record", "run.csv")
    assert answer.code == 2
    times = package.Recording.read(tmp_path / "run.csv").time
    assert 0.9 * limit < (tmp_path / "run.csv").stat().st_size <= limit
    assert np.allclose(times, 0.01 * np.arange(times.size))
    assert f"The {times.size} rows until then are complete" in answer.err
    assert list(tmp_path.glob(".run.csv*")) == []


def test_a_port_in_use_keeps_an_earlier_recording(serve):
    Path("run.csv").write_text("earlier rows", encoding="utf-8")
    with socket.create_server(("127.0.0.1", 0)) as other:
        answer = serve("--modbus", str(other.getsockname()[1]), "--record", "run.csv")
    assert answer.code == 2
    assert "error: The Modbus server cannot listen on 127.0.0.1" in answer.err
    assert Path("run.csv").read_text(encoding="utf-8") == "earlier rows"
    assert [path.name for path in Path().iterdir() if path.name.startswith(".run.csv")] == []


def test_a_failed_machine_ends_with_its_reason(serve, file):
    file.write_text(EMPTIED_TANK, encoding="utf-8")
    # The machine is served until it is stopped, here by a line.
    process = process_of(file, "--lines", "0.05")
    while json.loads(process.stdout.readline())["state"] != "failed":
        pass
    out, err = process.communicate('{"get": ["tank.mass"]}\n{"stop": true}\n', timeout=60)
    reply = next(reply for reply in map(json.loads, out.splitlines()) if reply.get("ok"))
    assert (reply["state"], reply["code"]) == ("failed", "serve.failed")
    assert reply["values"]["tank.mass"] > 0.0
    assert process.returncode == 1
    assert "error: At" in err


def test_the_map_is_printed_and_written(serve):
    printed = serve("--map")
    assert printed.code == 0
    assert "| tank.pressure |" in printed.out
    for name in ("map.csv", "map.md"):
        answer = serve("--map", name)
        assert (answer.code, answer.out) == (0, f"{name}: written.\n")
    assert Path("map.md").read_text(encoding="utf-8").strip() == printed.out.strip()
    assert "tank.pressure" in Path("map.csv").read_text(encoding="utf-8")
    assert serve("--map", "map.txt").codes == ["files.suffix"]


@pytest.mark.parametrize(
    ("arguments", "address"),
    [
        (("--period", "0"), "--period"),
        (("--period", "0.05 ms"), "--period"),
        (("--duration", "-1 s"), "--duration"),
        (("--speed", "0"), "--speed"),
        (("--lines", "-1"), "--lines"),
    ],
)
def test_invalid_options(serve, arguments, address):
    answer = serve(*arguments)
    assert answer.code == 2
    assert [error.address for error in answer.errors] == [address]


def test_several_invalid_options_are_reported_together(serve):
    answer = serve("--period", "5 mm", "--duration", "0 s")
    assert [error.address for error in answer.errors] == ["--period", "--duration"]


def test_a_watch_needs_the_page(serve):
    answer = serve("--watch", "twin.toml")
    assert answer.code == 2
    assert "Add --live" in answer.err


def test_a_page_is_served_and_an_open_address_is_reported(serve):
    pytest.importorskip("websockets", reason="the extra serve is not installed")
    answer = serve("--live", "0.0.0.0:0", "--duration", "1 s")
    assert answer.code == 0
    assert "listens on 0.0.0.0" in answer.err
    assert "/?token=" in answer.err
    assert "Pages: 0 connections" in answer.out


def test_options_of_opcua_and_mqtt(serve, poppet, file):
    pytest.importorskip("asyncua", reason="the extra opcua is not installed")
    pytest.importorskip("paho.mqtt", reason="the extra serve is not installed")
    answer = serve("--opcua", "0.0.0.0")
    assert (answer.code, answer.out) == (2, "")
    assert "--opcua with the host 0.0.0.0 requires a certificate and users" in answer.err
    answer = serve("--opcua", "4840", "--opcua-key", "a.key", "--opcua-users", "a.toml")
    for text in (
        "--opcua-key requires --opcua-certificate",
        "--opcua-users requires a certificate",
        "a.toml does not exist",
    ):
        assert text in answer.err
    assert "--mqtt-interval" in serve("--mqtt", "127.0.0.1", "--mqtt-interval", "2 bar").err
    answer = serve("--duration", "0.1 s", "--mqtt", "127.0.0.1:1", "--mqtt-topic", "a/b", "--mqtt-interval", "20 ms")
    assert answer.code == 0
    assert "MQTT: 0 connections, 0 messages published" in answer.out
