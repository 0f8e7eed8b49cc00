"""Machine for tests of the Modbus server, with the contract of a served circuit and no simulation."""

from __future__ import annotations

import asyncio
import contextlib
import threading
from collections.abc import Iterator, Mapping
from types import SimpleNamespace
from typing import Any

from poppet.core.errors import InputError
from poppet.serve.modbus import ModbusLimits, ModbusServer
from poppet.serve.modbus_map import ModbusMap, read_modbus_map
from poppet.serve.points import Point, PointRole
from poppet.serve.snapshot import MachineState

IN, OUT, PARAMETER = PointRole.INPUT, PointRole.OUTPUT, PointRole.PARAMETER


def point(
    address: str, unit: str = "1", role: PointRole = OUT, low: float = -1e99, high: float = 1e99, **more: Any
) -> Point:
    """Return a point with the least that a test needs."""
    return Point(address, unit, role, low, high, more.pop("initial", 0.0), more.pop("doc", ""), **more)


POINTS = (
    point("tank.pressure", "Pa", initial=350000.0, doc="pressure"),
    point("tank.temperature", "K", initial=293.15),
    point("slide.position", "m", initial=0.1),
    point("end.state", initial=1.0, is_flag=True),
    point("valve.opening", role=IN, low=0.0, high=1.0),
    point("valve.setpoint", "Pa", role=IN, low=1e5, high=1.1e6, initial=1e5),
    point("plc.run", role=IN, low=0.0, high=1.0, is_flag=True),
    point("tank.volume", "m^3", role=PARAMETER, initial=0.01),
)
FAULTS = {"valve": ("stuck_open", "stuck_closed", "stuck", "slow", "leak"), "check": ("stuck_open", "leak")}


class StubMachine:
    """Machine whose values change by writing only."""

    def __init__(self, points: tuple[Point, ...] = POINTS, faults: Mapping[str, tuple[str, ...]] = FAULTS) -> None:
        self.points, self.faults = points, faults
        self.by_address = {item.address: item for item in points}
        self.values = {item.address: item.initial for item in points}
        self.present = dict.fromkeys(faults, "none")
        self.state = MachineState.RUNNING
        self.writes: list[dict[str, float]] = []
        self.fault_commands: list[tuple[str, str]] = []

    def snapshot(self) -> Any:
        return SimpleNamespace(state=self.state, values=self.values, time=12.5)

    def command(self, values: Mapping[str, float], faults: Mapping[str, str]) -> None:
        for address, value in values.items():
            item = self.by_address[address]
            if not item.low <= value <= item.high:
                raise InputError("inputs.outside", address, given=value, low=item.low, high=item.high, unit=item.unit)
        self.values.update(values)
        self.writes += [dict(values)] if values else []

        self.present.update(faults)
        self.fault_commands.extend(faults.items())

    def fault_of(self, valve: str) -> str:
        return self.present[valve]


def map_of(registers: Any = None, **more: Any) -> ModbusMap:
    """Return the map of the points above, or the default one."""
    table = None if registers is None else {"registers": registers, **more}
    return read_modbus_map(table, POINTS, FAULTS, 1e5)


@contextlib.contextmanager
def serving(machine: Any, modbus_map: ModbusMap, limits: ModbusLimits | None = None) -> Iterator[ModbusServer]:
    """Run a server in a thread of its own."""
    loop = asyncio.new_event_loop()
    thread = threading.Thread(target=loop.run_forever, daemon=True)
    thread.start()
    server = ModbusServer(machine, modbus_map, limits)
    try:
        asyncio.run_coroutine_threadsafe(server.start("127.0.0.1", 0), loop).result(60)
        yield server
    finally:
        asyncio.run_coroutine_threadsafe(server.stop(), loop).result(60)
        loop.call_soon_threadsafe(loop.stop)
        thread.join(10)
        loop.close()
