"""A machine in real time whose Modbus server receives random frames, floods and broken connections."""

from __future__ import annotations

import contextlib
import random
import socket
import struct
import threading
import time
from collections.abc import Callable

import numpy as np
import pytest

pytest.importorskip("pymodbus", reason="the extra serve is not installed")

from modbus_client import connect, exchange, send_random_frames
from modbus_stub import serving
from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.serve.lateness import LATE
from poppet.serve.modbus_map import map_of_circuit

PERIOD = 0.01
READ = struct.pack(">HHHBBHH", 1, 0, 6, 1, 4, 0, 4)


def tank() -> Circuit:
    return Circuit({
        "supply": Reservoir(pressure="7 bar"),
        "hole": Orifice(from_="supply", to="tank", sonic_conductance=1e-9, critical_ratio=0.3),
        "tank": Chamber(volume="10 l"),
    })  # fmt: skip


def flood_without_reading(port: int) -> None:
    with connect(port) as stream:
        stream.setblocking(False)
        for _ in range(100):
            with contextlib.suppress(BlockingIOError):
                stream.send(READ * 1000)
            time.sleep(0.001)


def flood_and_read(port: int) -> None:
    with connect(port) as stream:
        for _ in range(20):
            stream.sendall(READ * 100)
            missing = 100 * 17
            while missing:
                missing -= len(stream.recv(missing))


def disconnect_within_frames(port: int) -> None:
    for k in range(200):
        with connect(port) as stream:
            stream.sendall(READ[: 1 + k % 11])
            if k % 2:  # with a reset instead of an orderly end
                stream.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))


def attack_at_the_same_time(attacks: dict[str, Callable[[], None]]) -> list[str]:
    """Run all attacks in threads, and return the names of those that failed."""
    failed: list[str] = []

    def run(name: str, attack: Callable[[], None]) -> None:
        try:
            attack()
        except Exception as error:
            failed.append(f"{name}: {error!r}")

    threads = [threading.Thread(target=run, args=item) for item in attacks.items()]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(120.0)
    assert not any(thread.is_alive() for thread in threads)
    return failed


def test_attacks_cost_no_period_and_leave_the_server_intact() -> None:
    answers: list[bytes] = []
    with tank().serve(PERIOD) as machine, serving(machine, map_of_circuit(machine.served)) as server:

        def poll() -> None:
            with connect(server.port) as stream:
                for _ in range(100):
                    answers.append(exchange(stream, 4, struct.pack(">HH", 0, 4)))
                    time.sleep(0.002)

        failed = attack_at_the_same_time({
            "random": lambda: send_random_frames(server.port, 10_000, random.Random(3)),
            "flood": lambda: flood_without_reading(server.port),
            "reading flood": lambda: flood_and_read(server.port),
            "broken": lambda: disconnect_within_frames(server.port),
            "poll": poll,
        })  # fmt: skip
        assert failed == []
        # The second client has received valid values all the time, and the server answers afterwards.
        times = [struct.unpack(">d", answer[2:])[0] for answer in answers]
        assert len(times) == 100
        assert all(np.diff(times) >= 0.0)
        with connect(server.port) as stream:
            assert exchange(stream, 4, struct.pack(">HH", 0, 4))[0] == 4
        assert server.statistics.transactions > 5_000 + 2_000
        machine.stop()
        # No period is missing in the rows, and each late one is counted.
        lateness, (number, rows) = machine.lateness(), machine.rows(0)
        np.testing.assert_allclose(rows[:, 0], PERIOD * (number + np.arange(len(rows))), atol=1e-9)
        assert sum(lateness.histogram) == number + len(rows)
        if not number:
            assert lateness.late == np.count_nonzero(rows[:, -1] > LATE)
