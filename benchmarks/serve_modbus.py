"""Modbus transactions per second of a served machine, and the lateness of its periods meanwhile.

The clients are processes of their own with plain sockets. Each one alternately reads eight registers and writes two
coils. Each late period is printed, with the lateness of a process that only waits.
"""

from __future__ import annotations

import asyncio
import multiprocessing
import socket
import struct
import time
from pathlib import Path
from typing import Any

import numpy as np

import poppet
from poppet.serve.modbus import ModbusServer
from poppet.serve.modbus_map import map_of_circuit
from wakeup_peer import LatePeriods, peer_running

MACHINE = Path(__file__).parents[1] / "examples" / "serve" / "two_cylinders_machine.toml"
PERIOD = 0.01
CASES = ((1, 1000.0), (1, 0.0), (4, 0.0))
"""Number of clients, and transactions per second of all together; 0 is the highest possible rate."""


def request_repeatedly(port: int, rate: float, duration: float, results: Any) -> None:
    """Send requests for a duration, and put their response times [s]."""
    requests = [
        struct.pack(">HHHBBHH", 1, 0, 6, 1, 4, 0, 8),  # read eight input registers
        struct.pack(">HHHBBHHBB", 2, 0, 8, 1, 15, 0, 2, 1, 1),  # write two coils
    ]
    times: list[float] = []
    with socket.create_connection(("127.0.0.1", port)) as stream:
        stream.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        begin = time.perf_counter()
        while (now := time.perf_counter()) < begin + duration:
            due = begin + len(times) / rate if rate else now
            if due > now:
                time.sleep(due - now)
            sent = time.perf_counter()
            stream.sendall(requests[len(times) % 2])
            assert not stream.recv(300)[7] & 0x80
            times.append(time.perf_counter() - sent)
    results.put(times)


async def measure(machine: Any, n_clients: int, rate: float, duration: float) -> list[float]:
    """Return the response times of all clients [s]."""
    server, context = ModbusServer(machine, map_of_circuit(machine.served)), multiprocessing.get_context("spawn")
    await server.start("127.0.0.1", 0)
    results = context.Queue()
    arguments = server.port, rate / n_clients, duration, results
    clients = [context.Process(target=request_repeatedly, args=arguments) for _ in range(n_clients)]
    for client in clients:
        client.start()
    times = [value for _ in clients for value in await asyncio.to_thread(results.get)]
    for client in clients:
        await asyncio.to_thread(client.join)
    await server.stop()
    return times


def main(size: float = 1.0) -> None:
    """Print one line per case."""
    duration = 20.0 * size
    print("clients  rate asked  transactions/s  median [us]  99.9 % [us]  periods  late  greatest lateness [ms]")
    for n_clients, rate in CASES:
        with peer_running() as peer, poppet.load(MACHINE).serve(PERIOD) as machine:
            late = LatePeriods(machine)
            times = np.array(asyncio.run(measure(machine, n_clients, rate, duration)))
            periods, lateness = machine.snapshot().period, machine.lateness()
            late.collect()
        median, slow = 1e6 * np.quantile(times, (0.5, 0.999))
        asked = f"{rate:.0f}" if rate else "highest"
        print(
            f"{n_clients:7d}  {asked:>10s}  {len(times) / duration:14.0f}  {median:11.0f}  {slow:11.0f}  {periods:7d}"
            f"  {lateness.late:4d}  {1e3 * lateness.maximum:22.2f}"
        )
        print(peer.explain(late.late), flush=True)


if __name__ == "__main__":
    main()
