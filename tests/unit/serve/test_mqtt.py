"""MQTT adapter of `poppet serve`, with the broker mosquitto and its own clients."""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import json
import os
import socket
import ssl
import subprocess
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("paho.mqtt", reason="the extra serve is not installed")

import poppet
from mqtt_broker import IS_INSTALLED, PASSWORDS, Broker, Listener, until
from poppet.core.errors import InputError
from poppet.serve.adapters import AdapterSettings
from poppet.serve.machine import Machine
from poppet.serve.mqtt import PASSWORD, USER, MqttAdapter, make_adapter, read_broker
from poppet.serve.points import PointRole

CIRCUIT = Path(__file__).parents[3] / "examples" / "serve" / "two_cylinders_machine.toml"
TOPIC = "test/machine"


@pytest.fixture(scope="module")
def machine() -> Iterator[Machine]:
    with poppet.load(CIRCUIT).serve(clock=False) as running:
        running.advance(0.1)
        yield running


def made(machine: Machine, value: str, notes: list[Any] | None = None, **options: Any) -> MqttAdapter:
    names = {f"mqtt_{name}": option for name, option in {"topic": TOPIC, "interval": 0.05, **options}.items()}
    report = ([] if notes is None else notes).append
    return make_adapter(AdapterSettings(value, machine.served, argparse.Namespace(**names), report))


@contextlib.contextmanager
def running(adapter: MqttAdapter, machine: Machine, notes: list[Any]) -> Iterator[None]:
    """Run an adapter in a thread of its own."""
    loop = asyncio.new_event_loop()
    thread = threading.Thread(target=loop.run_forever, daemon=True)
    thread.start()
    future = asyncio.run_coroutine_threadsafe(adapter.run(machine, notes.append), loop)
    try:
        yield
        assert not future.done()
    finally:
        future.cancel()
        wait_for(lambda: not asyncio.run_coroutine_threadsafe(other_tasks(), loop).result(10))
        loop.call_soon_threadsafe(loop.stop)
        thread.join(10)
        loop.close()


@contextlib.contextmanager
def client_sockets() -> Iterator[list[socket.socket]]:
    """Collect the sockets of new clients, which send little at a time."""
    sockets: list[socket.socket] = []
    original = socket.create_connection

    def create_connection(*arguments: Any, **keywords: Any) -> socket.socket:
        sockets.append(original(*arguments, **keywords))
        sockets[-1].setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 4096)
        return sockets[-1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(socket, "create_connection", create_connection)
        yield sockets


async def other_tasks() -> int:
    return len(asyncio.all_tasks()) - 1


def wait_for(is_reached: Any) -> None:
    for _ in until(is_reached):
        time.sleep(0.01)


def codes(notes: list[Any]) -> list[str]:
    return [note.code for note in notes]


# With a broker -------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def broker(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Broker]:
    if not IS_INSTALLED:
        pytest.skip("the broker mosquitto is not installed")
    with Broker(tmp_path_factory.mktemp("broker")) as started:
        yield started


@pytest.fixture(scope="module")
def session(machine: Machine, broker: Broker) -> Iterator[MqttAdapter]:
    notes: list[Any] = []
    adapter = made(machine, f"127.0.0.1:{broker.port}")
    with running(adapter, machine, notes):
        wait_for(lambda: "mqtt.connected" in codes(notes))
        yield adapter


def test_every_value_has_a_retained_topic(machine: Machine, session: MqttAdapter, broker: Broker) -> None:
    wait_for(lambda: session.n_published > len(machine.row_names))
    live = [point.address for point in machine.points if point.role is not PointRole.PARAMETER]
    topics = {f"{TOPIC}/{address}" for address in live} | {f"{TOPIC}/{valve}.fault" for valve in machine.faults}
    found = broker.messages(*topics, f"{TOPIC}/status", f"{TOPIC}/points", count=len(topics) + 2)
    assert found.pop(f"{TOPIC}/status") == "online"
    points = {row["address"]: row for row in json.loads(found.pop(f"{TOPIC}/points"))["points"]}
    assert {point.address: point.unit for point in machine.points} == {
        name: row["unit"] for name, row in points.items()
    }
    assert found.keys() == topics
    snapshot = machine.snapshot()
    for address in live:
        assert json.loads(found[f"{TOPIC}/{address}"]) == snapshot[address]
    assert found[f"{TOPIC}/valveA.fault"] == "none"
    state = json.loads(broker.messages(f"{TOPIC}/state", count=1)[f"{TOPIC}/state"])
    assert state["values"] == {address: snapshot[address] for address in live}
    assert (state["time"], state["state"], state["late"], state["faults"]["valveB"]) == (
        snapshot.time,
        "running",
        0,
        "none",
    )


def test_every_input_can_be_written(machine: Machine, session: MqttAdapter, broker: Broker) -> None:
    inputs = [point for point in machine.points if point.role is PointRole.INPUT]
    for point in inputs:
        value = 0.5 * (max(point.low, 0.0) + min(point.high, 1000.0))
        broker.publish(f"{TOPIC}/{point.address}/set", repr(value))
        wait_for(lambda name=point.address, value=value: machine.snapshot()[name] == value)
    initial = {point.address: point.initial for point in inputs}
    broker.publish(f"{TOPIC}/set", json.dumps(initial))
    wait_for(lambda: all(machine.snapshot()[name] == value for name, value in initial.items()))
    broker.publish(f"{TOPIC}/supply.pressure/set", "5 bar")
    wait_for(lambda: machine.snapshot()["supply.pressure"] == 5e5)
    broker.publish(f"{TOPIC}/valveA.command/set", "true")
    wait_for(lambda: machine.snapshot()["valveA.command"] == 1.0)
    broker.publish(f"{TOPIC}/valveA.fault/set", "stuck")
    wait_for(lambda: machine.fault_of("valveA") == "stuck")
    broker.publish(f"{TOPIC}/set", json.dumps(initial | {"valveA.fault": "none"}))
    wait_for(lambda: machine.fault_of("valveA") == "none")


@pytest.mark.parametrize(
    ("topic", "text", "code", "address"),
    [
        ("valveA.command/set", "7", "inputs.outside", "valveA.command"),
        ("valveA.command/set", "NaN", "quantity.not_finite", "valveA.command"),
        ("valveA.command/set", "1" + 400 * "0", "", "valveA.command"),
        ("valveA.command/set", "3 bar", "", "valveA.command"),
        ("valveA.command/set", "[" * 5000, "", "valveA.command"),
        ("valveA.command/set", '"1"', "", "valveA.command"),
        ("slideA.position/set", "0.1", "serve.not_writable", "slideA.position"),
        ("valveC.command/set", "1", "names.unknown", "valveC.command"),
        ("valveA.fault/set", "stuck_opn", "fields.not_an_option", "valveA.fault"),
        ("set", "1", "mqtt.no_object", f"{TOPIC}/set"),
        ("set", '{"a": ', "stream.no_json", ""),
        ("set", '{"valveA.command": 1, "valveB.command": -1}', "inputs.outside", "valveB.command"),
        ("set", '{"valveA.command": {"a": [1]}}', "", "valveA.command"),
        ("set", '{"valveA.command": ' + 400 * "9" + "}", "", "valveA.command"),
    ],
)
def test_errors_are_published(
    machine: Machine, session: MqttAdapter, broker: Broker, topic: str, text: str, code: str, address: str
) -> None:
    before = machine.snapshot()
    with Listener(broker, f"{TOPIC}/+") as listener:
        listener.next()  # it is connected
        broker.publish(f"{TOPIC}/{topic}", text)
        while True:
            name, payload = listener.next()
            if name == f"{TOPIC}/errors":
                break
    content = json.loads(payload)
    assert content["topic"] == f"{TOPIC}/{topic}"
    (error,) = content["errors"]
    assert code in ("", error["code"])
    assert error["address"] == address
    assert error["message"]
    assert (machine.snapshot().array == before.array).sum() == len(machine.points)


def test_commands_that_are_no_short_text(machine: Machine) -> None:
    adapter = made(machine, "127.0.0.1")
    for payload, code in ((b"\xff", "mqtt.no_text"), (b"1" + bytes(2**20), "mqtt.long_message")):
        message = SimpleNamespace(topic=f"{TOPIC}/valveA.command/set", payload=payload, retain=False)
        with pytest.raises(InputError) as caught:
            adapter._command(machine, message)
        assert (caught.value.code, caught.value.address) == (code, message.topic)


def test_retained_commands_are_not_executed(machine: Machine, broker: Broker) -> None:
    broker.publish("other/valveA.command/set", "1", "-r")
    notes: list[Any] = []
    adapter = made(machine, f"127.0.0.1:{broker.port}", topic="other")
    with Listener(broker, "other/errors") as listener, running(adapter, machine, notes):
        assert json.loads(listener.next()[1])["errors"][0]["code"] == "mqtt.retained"
    assert machine.snapshot()["valveA.command"] == 0.0
    assert broker.messages("other/status", count=1) == {"other/status": "offline"}
    (summary,) = adapter.summary()
    assert (summary.facts["connections"], summary.facts["commands"], summary.facts["errors"]) == (1, 1, 1)


def test_a_restart_of_the_broker(machine: Machine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if not IS_INSTALLED:
        pytest.skip("the broker mosquitto is not installed")
    monkeypatch.setattr("poppet.serve.mqtt.RECONNECT", (1, 1))
    notes: list[Any] = []
    broker = Broker(tmp_path)
    adapter = made(machine, f"127.0.0.1:{broker.port}")
    with running(adapter, machine, notes):
        wait_for(lambda: codes(notes) == ["mqtt.absent"])
        with broker:
            wait_for(lambda: codes(notes)[-1] == "mqtt.connected")
        wait_for(lambda: "mqtt.lost" in codes(notes))
        with broker:
            wait_for(lambda: codes(notes)[-1] == "mqtt.connected")
            published = adapter.n_published
            wait_for(lambda: adapter.n_published > published + len(machine.served.columns))
            found = broker.messages(f"{TOPIC}/slideA.position", f"{TOPIC}/status", count=2)
            assert found[f"{TOPIC}/status"] == "online"
            assert float(found[f"{TOPIC}/slideA.position"]) == machine.snapshot()["slideA.position"]
            broker.publish(f"{TOPIC}/valveA.command/set", "1")
            wait_for(lambda: machine.snapshot()["valveA.command"] == 1.0)
            machine.write({"valveA.command": 0.0})
    assert codes(notes).count("mqtt.connected") == 2


def test_a_lost_connection_is_announced(machine: Machine, broker: Broker) -> None:
    """The broker publishes the will of a client that disappears without a word."""
    notes: list[Any] = []
    adapter = made(machine, f"127.0.0.1:{broker.port}", topic="will")
    with (
        client_sockets() as sockets,
        Listener(broker, "will/status") as listener,
        pytest.MonkeyPatch.context() as patch,
    ):
        patch.setattr("poppet.serve.mqtt.RECONNECT", (5, 5))
        with running(adapter, machine, notes):
            assert listener.next()[1] == "online"
            sockets[0].shutdown(socket.SHUT_RDWR)
            assert listener.next()[1] == "offline"


def test_credentials(machine: Machine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if not IS_INSTALLED:
        pytest.skip("the broker mosquitto is not installed")
    monkeypatch.setattr("poppet.serve.mqtt.RECONNECT", (1, 1))
    passwords = tmp_path / "passwords"
    subprocess.run([str(PASSWORDS), "-b", "-c", str(passwords), "plant", "word"], check=True, capture_output=True)
    with Broker(tmp_path, f"allow_anonymous false\npassword_file {passwords}") as broker:
        address = f"127.0.0.1:{broker.port}"
        notes: list[Any] = []
        with running(made(machine, address), machine, notes):
            wait_for(lambda: codes(notes) == ["mqtt.refused"])
        file = tmp_path / "credentials.toml"
        file.write_text('user = "plant"\npassword = "word"\n')
        file.chmod(0o600)
        notes.clear()
        with running(made(machine, address, notes, credentials=str(file)), machine, notes):
            wait_for(lambda: codes(notes) == ["mqtt.connected"])
        monkeypatch.setenv(USER, "plant")
        monkeypatch.setenv(PASSWORD, "word")
        notes.clear()
        with running(made(machine, address, notes), machine, notes):
            wait_for(lambda: codes(notes) == ["mqtt.connected"])


def test_encryption(machine: Machine, tmp_path: Path) -> None:
    pytest.importorskip("cryptography", reason="the extra opcua is not installed")
    if not IS_INSTALLED:
        pytest.skip("the broker mosquitto is not installed")
    from serve_opcua import write_pair

    certificate, key = write_pair(tmp_path, "broker")
    with Broker(tmp_path, f"allow_anonymous true\ncertfile {certificate}\nkeyfile {key}") as broker:
        for authority, code in ((str(certificate), "mqtt.connected"), (None, "mqtt.absent")):
            notes: list[Any] = []
            adapter = made(machine, f"mqtts://localhost:{broker.port}", notes, ca=authority)
            with running(adapter, machine, notes):
                wait_for(lambda notes=notes, code=code: codes(notes) == [code])


# Without a broker ----------------------------------------------------------------------------------------------------


def test_a_broker_that_does_not_read_delays_nothing(machine: Machine) -> None:
    """A server accepts the connection, answers once, and reads no more."""
    notes: list[Any] = []
    with socket.create_server(("127.0.0.1", 0)) as server, client_sockets():
        server.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        adapter = made(machine, f"127.0.0.1:{server.getsockname()[1]}", interval=0.01)
        with running(adapter, machine, notes):
            stream, _ = server.accept()
            stream.recv(1000)
            stream.sendall(b"\x20\x02\x00\x00")  # the connection is accepted
            end = time.monotonic() + 30.0
            k = 0
            while adapter.n_skipped < 5 and time.monotonic() < end:
                k += 1
                machine.write({"slideA.load_force": float(k % 7)})
                time.sleep(0.001)
            stream.close()
        assert adapter.n_skipped >= 5


@pytest.mark.parametrize(
    ("text", "address", "has_tls"),
    [
        ("broker", "broker:1883", False), ("broker:99", "broker:99", False), ("broker:8883", "broker:8883", True),
        ("mqtt://broker", "broker:1883", False), ("mqtts://broker", "broker:8883", True),
        ("mqtts://broker:99/", "broker:99", True), ("mqtt://broker:8883", "broker:8883", False),
        ("[::1]:1883", "[::1]:1883", False),
    ],
)  # fmt: skip
def test_addresses(text: str, address: str, has_tls: bool) -> None:
    assert (str(read_broker(text)[0]), read_broker(text)[1]) == (address, has_tls)


@pytest.mark.parametrize(
    ("text", "code"),
    [("user:word@broker", "mqtt.credentials_in_address"), ("mqtts://u:word@broker", "mqtt.credentials_in_address"),
     ("http://broker", "serve.address"), ("broker:x", "serve.address"), ("broker/topic", "serve.address")],
)  # fmt: skip
def test_invalid_addresses(text: str, code: str) -> None:
    with pytest.raises(InputError) as caught:
        read_broker(text)
    assert (caught.value.code, caught.value.address) == (code, "--mqtt")
    assert "word" not in str(caught.value).replace("PASSWORD", "").replace("password", "")


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ({"topic": "a/#"}, "mqtt.topic"), ({"topic": "/"}, "mqtt.topic"), ({"topic": "$SYS/x"}, "mqtt.topic"),
        ({"topic": "a//b"}, "mqtt.topic"), ({"interval": 0.0}, "mqtt.interval"), ({"ca": "x.pem"}, "mqtt.unused_ca"),
        ({"interval": float("inf")}, "mqtt.interval"), ({"credentials": "missing.toml"}, "toml.no_file"),
    ],
)  # fmt: skip
def test_invalid_options(machine: Machine, options: dict[str, Any], code: str) -> None:
    with pytest.raises(InputError) as caught:
        made(machine, "127.0.0.1", **options)
    assert caught.value.code == code


def test_invalid_files(machine: Machine, tmp_path: Path) -> None:
    file = tmp_path / "credentials.toml"
    cases = (
        ('password = "a"', "mqtt.no_user"),
        ('user = "a"\nword = "b"', "fields.unknown"),
        ("user = 3", "serve.secret"),
    )
    for text, code in cases:
        file.write_text(text)
        with pytest.raises(InputError) as caught:
            made(machine, "127.0.0.1", credentials=str(file))
        assert caught.value.code == code
    with pytest.raises(InputError) as caught:
        made(machine, "mqtts://127.0.0.1", ca=str(file))
    assert (caught.value.code, caught.value.address) == ("mqtt.authority", "--mqtt-ca")


def test_brokers_of_other_computers_cause_a_warning(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> None:
    notes: list[Any] = []
    made(machine, "broker.example", notes)
    assert codes(notes) == ["mqtt.remote"]
    monkeypatch.setenv(USER, "a")
    monkeypatch.setenv(PASSWORD, "b")
    notes.clear()
    made(machine, "broker.example", notes)
    assert codes(notes) == ["mqtt.remote", "mqtt.plain_password"]
    notes.clear()
    adapter = made(machine, "mqtts://broker.example", notes)
    assert codes(notes) == ["mqtt.remote"]
    assert adapter.settings.tls is not None
    assert adapter.settings.tls.verify_mode is ssl.CERT_REQUIRED


def test_the_topic_contains_the_title(machine: Machine) -> None:
    adapter = made(machine, "127.0.0.1", topic=None)
    assert adapter.settings.topic == "poppet/two_cylinders_without_their_controller"
    untitled = SimpleNamespace(circuit=SimpleNamespace(title="  "))
    settings: Any = SimpleNamespace(value="127.0.0.1", served=untitled, options=argparse.Namespace(), report=print)
    assert make_adapter(settings).settings.topic == "poppet/circuit"


@pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX systems")
def test_files_that_others_can_read_cause_a_warning(machine: Machine, tmp_path: Path) -> None:
    file = tmp_path / "credentials.toml"
    file.write_text('user = "a"\n')
    file.chmod(0o644)
    notes: list[Any] = []
    made(machine, "127.0.0.1", notes, credentials=str(file))
    assert codes(notes) == ["serve.readable_secret"]
