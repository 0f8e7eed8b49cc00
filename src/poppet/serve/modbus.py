"""Modbus TCP server of a served circuit.

The messages are those of pymodbus. The connections are our own: they limit idle times and the length of the queue of a
client, and they answer each request that arrives complete.
"""

from __future__ import annotations

import asyncio
import contextlib
import dataclasses
import socket
import struct
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError, needed
from poppet.parts.faults import HEALTHY
from poppet.serve.adapters import AdapterSettings, HostPort, no_server, open_address_notes, read_host_port
from poppet.serve.connection_limit import ConnectionLimit
from poppet.serve.machine import Machine
from poppet.serve.modbus_map import BITS, CODES, TIME, FaultTarget, MapEntry, ModbusMap, map_of_circuit
from poppet.serve.points import Point
from poppet.serve.snapshot import MachineState, Snapshot

ILLEGAL_FUNCTION, ILLEGAL_ADDRESS, ILLEGAL_VALUE, DEVICE_FAILURE, DEVICE_BUSY = 1, 2, 3, 4, 6
"""Exception codes of the Modbus specification."""
AREAS = {1: "coil", 2: "discrete", 3: "holding", 4: "input", 5: "coil", 6: "holding", 15: "coil", 16: "holding",
         22: "holding", 23: "holding"}  # fmt: skip
"""Area of each function code of the server."""
_FIXED_LENGTHS = {5: 4, 6: 4, 22: 6}
"""Number of bytes after the function code, of functions with a fixed length."""
_MOST_READ = {1: 2000, 2: 2000, 3: 125, 4: 125, 23: 125}
"""Largest number of bits or registers that a function reads."""
_MOST_WRITTEN = {15: 1968, 16: 123, 23: 121}
"""Largest number of bits or registers that a function writes."""
_HEADER = struct.Struct(">HHHB")
"""Transaction, protocol (0), number of following bytes, unit."""
_COIL_VALUES = (b"\x00\x00", b"\xff\x00")
_STATES = {MachineState.STARTING: DEVICE_BUSY, MachineState.FAILED: DEVICE_FAILURE}
"""Exception codes of the states in which a machine has no valid values."""
DEFAULT_PORT = 5020
"""Port of an address without one. The standard port 502 requires the rights of an administrator."""
MAX_LENGTH = 254
"""Largest number of bytes after the length field: the unit and a message of 253 bytes."""
BATCH = 16
"""Requests of a client that are answered before those of other clients."""
_ROUNDING = 1e-6
"""Relative excess over a limit that is the rounding of a 32-bit float."""


@dataclass(frozen=True)
class ModbusLimits:
    """Limits of a Modbus server."""

    clients: int = 32
    idle_time: float = 60.0  # after which a silent connection is closed [s]
    frame_time: float = 5.0  # within which a client must complete a begun request, or read its answers [s]
    unsent: int = 65_536  # bytes of answers that a client has not read, above which its requests wait


@dataclass
class ModbusStatistics:
    """Counters of a Modbus server."""

    clients: int = 0  # connected at present
    connections: int = 0  # accepted since the start
    rejected: int = 0  # connections above the limit
    closed: int = 0  # connections closed because of time limits
    transactions: int = 0  # answered requests, including those with an exception
    exceptions: int = 0  # requests answered with an exception
    malformed: int = 0  # frames that are not Modbus; they end their connection


class ModbusImage:
    """Registers and bits of a machine, as the messages of pymodbus read and write them.

    The methods have the names that these messages call. Each returns an exception code if the request is invalid.
    """

    def __init__(self, machine: Machine, modbus_map: ModbusMap) -> None:
        self.machine, self.cells = machine, modbus_map.cells

    async def async_getValues(self, unit: int, function: int, address: int, count: int = 1) -> Any:
        """Return the values of bits or registers, or an exception code."""
        cells = self.cells[AREAS[function]]
        try:
            selected = [cells[k] for k in range(address, address + count)]
        except KeyError:
            return _exception(ILLEGAL_ADDRESS)
        snapshot = self.machine.snapshot()
        if snapshot.state in _STATES:
            return _exception(_STATES[snapshot.state])
        if AREAS[function] in BITS:
            return [self._value(entry, snapshot) > 0.5 for entry, _ in selected]
        registers: list[int] = []
        encoded: dict[int, tuple[int, ...]] = {}
        for entry, k in selected:
            if entry.first not in encoded:
                assert entry.representation is not None
                data = entry.representation.encode(self._value(entry, snapshot))
                encoded[entry.first] = struct.unpack(f">{entry.count}H", data)
            registers.append(encoded[entry.first][k])
        return registers

    async def async_setValues(
        self, unit: int, function: int, address: int, values: Sequence[int] | Sequence[bool]
    ) -> Any:
        """Write all values of a request, or none; return an exception code if there is an error."""
        cells = self.cells[AREAS[function]]
        commands: dict[str, float] = {}
        faults: dict[str, dict[str, bool]] = defaultdict(dict)
        k = 0
        while k < len(values):
            entry, part = cells.get(address + k, (None, 0))
            if entry is None:
                return _exception(ILLEGAL_ADDRESS)
            # A half of a number is never written.
            if part or k + entry.count > len(values):
                return _exception(ILLEGAL_VALUE)
            value = _decoded(entry, values[k : k + entry.count])
            if value is None:
                return _exception(ILLEGAL_VALUE)
            if isinstance(entry.target, Point):
                commands[entry.target.address] = _within_rounding(value, entry.target)
            elif entry.target.is_bit:
                faults[entry.target.valve][entry.target.faults[0]] = value > 0.5
            elif value and value not in (CODES[fault] for fault in entry.target.faults):
                return _exception(ILLEGAL_VALUE)
            else:
                faults[entry.target.valve] = {fault: value == CODES[fault] for fault in entry.target.faults}
            k += entry.count
        if any(sum(states.values()) > 1 for states in faults.values()):
            return _exception(ILLEGAL_VALUE)
        if self.machine.state in _STATES:
            return _exception(_STATES[self.machine.state])
        try:
            self.machine.command(commands, self._changed_faults(faults))
        except InputError:
            return _exception(ILLEGAL_VALUE)
        return None

    def _changed_faults(self, faults: Mapping[str, Mapping[str, bool]]) -> dict[str, str]:
        """Return the faults that begin because their state is true, or end because it is false."""
        changes = {}
        for valve, states in faults.items():
            present = self.machine.fault_of(valve)
            new = next((fault for fault, is_on in states.items() if is_on), None)
            # A bit of 0 ends its own fault only.
            if new is not None or present in states:
                changes[valve] = new or HEALTHY
        return changes

    def _value(self, entry: MapEntry, snapshot: Snapshot) -> float:
        target = entry.target
        if isinstance(target, FaultTarget):
            present = self.machine.fault_of(target.valve)
            return float(present == target.faults[0]) if target.is_bit else CODES[present]
        return snapshot.time if target is TIME else snapshot.values[target.address]


def _decoded(entry: MapEntry, registers: Sequence[int] | Sequence[bool]) -> float | None:
    if entry.representation is None:
        return float(registers[0])
    return entry.representation.decode(struct.pack(f">{len(registers)}H", *registers))


def _within_rounding(value: float, point: Point) -> float:
    """Return a limit of a point for a value that exceeds it by the rounding of its registers only."""
    for limit, excess in ((point.low, point.low - value), (point.high, value - point.high)):
        if 0.0 < excess <= _ROUNDING * max(abs(limit), abs(value)):
            return limit
    return value


def _exception(code: int) -> Any:
    from pymodbus.constants import ExcCodes

    return ExcCodes(code)


class ModbusServer:
    """Modbus TCP server, which runs in the event loop of its caller.

    Parameters
    ----------
    machine : Machine
        Served circuit.
    modbus_map : ModbusMap
        Its addresses.
    limits : ModbusLimits, optional
        Limits of clients and times.
    """

    def __init__(self, machine: Machine, modbus_map: ModbusMap, limits: ModbusLimits | None = None) -> None:
        with needed("pymodbus", "a Modbus server", "serve"):
            from pymodbus.pdu import DecodePDU
        self.requests = {code: DecodePDU.pdu_table[code][0] for code in AREAS}
        self.image: Any = ModbusImage(machine, modbus_map)
        self.limits, self.statistics = limits or ModbusLimits(), ModbusStatistics()
        self.connections: set[_Connection] = set()
        self._limit = ConnectionLimit(self.limits.clients, self._count_rejected)
        self._server: asyncio.Server | None = None
        self._watch: asyncio.Task[None] | None = None

    @property
    def port(self) -> int:
        """Port on which the server listens."""
        assert self._server is not None
        port: int = self._server.sockets[0].getsockname()[1]
        return port

    async def start(self, host: str, port: int) -> None:
        """Listen for clients; the port 0 selects a free one."""
        loop = asyncio.get_running_loop()
        try:
            self._server = await loop.create_server(lambda: self._limit.limited(_Connection(self)), host, port)
        except (OSError, UnicodeError) as error:
            raise no_server(error, "modbus.no_server", "--modbus", HostPort(host, port)) from None
        self._watch = asyncio.create_task(self._close_idle_connections())

    async def stop(self) -> None:
        """Close all connections and the server."""
        if self._watch is not None:
            self._watch.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._watch
        if self._server is not None:
            self._server.close()
        self._limit.abort_waiting()
        for connection in [*self.connections]:
            connection.transport.abort()
        await asyncio.sleep(0)

    async def _close_idle_connections(self) -> None:
        loop = asyncio.get_running_loop()
        while True:
            await asyncio.sleep(min(1.0, self.limits.idle_time, self.limits.frame_time))
            for connection in [*self.connections]:
                if connection.is_overdue(loop.time()):
                    self.statistics.closed += 1
                    connection.transport.abort()

    def _count_rejected(self) -> None:
        self.statistics.rejected += 1

    def answer(self, function: int, body: bytes, unit: int) -> bytes:
        """Return the answer to a message: function code and data."""
        self.statistics.transactions += 1
        code = self._problem(function, body)
        if code:
            self.statistics.exceptions += 1
            return bytes((function | 0x80, code))
        request = self.requests[function]()
        request.decode(body)
        response = _result(request.datastore_update(self.image, unit))
        self.statistics.exceptions += response.isError()
        return bytes((response.function_code,)) + bytes(response.encode())

    def _problem(self, function: int, body: bytes) -> int:
        """Return the exception code of a message that is invalid on its own, or 0."""
        if function not in self.requests:
            return ILLEGAL_FUNCTION
        if not _is_complete(function, body):
            return ILLEGAL_VALUE
        if function == 23:
            # Before the write: an invalid read must write nothing.
            first, count = struct.unpack_from(">HH", body)
            if not all(k in self.image.cells["holding"] for k in range(first, first + count)):
                return ILLEGAL_ADDRESS
        return 0


def _is_complete(function: int, body: bytes) -> bool:
    """Return True if the data of a message have the form, the counts and the length of its function."""
    if function in _FIXED_LENGTHS:
        return len(body) == _FIXED_LENGTHS[function] and (function != 5 or body[2:] in _COIL_VALUES)
    remaining = body
    if function in _MOST_READ:
        if len(body) < 4 or not 1 <= int.from_bytes(body[2:4]) <= _MOST_READ[function]:
            return False
        remaining = body[4:]
    if function in _MOST_WRITTEN:
        if len(remaining) < 5:
            return False
        count = int.from_bytes(remaining[2:4])
        n_bytes = (count + 7) // 8 if function == 15 else 2 * count
        return 1 <= count <= _MOST_WRITTEN[function] and remaining[4] == n_bytes == len(remaining) - 5
    return not remaining


def _result(update: Any) -> Any:
    """Return the result of a coroutine that never waits."""
    try:
        update.send(None)
    except StopIteration as end:
        return end.value
    raise AssertionError("a message of the data model must not wait")


class ModbusAdapter:
    """Modbus server of `poppet serve`."""

    def __init__(self, address: HostPort, modbus_map: ModbusMap) -> None:
        self.address, self.modbus_map = address, modbus_map
        self.statistics = ModbusStatistics()

    async def run(self, machine: Machine, report: Callable[[Note], None]) -> None:
        """Serve a machine until the task is cancelled."""
        server = ModbusServer(machine, self.modbus_map)
        self.statistics = server.statistics
        await server.start(*self.address)
        try:
            host_port = HostPort(self.address.host, server.port)
            report(Note("modbus.listening", "--modbus", server=str(host_port), count=len(self.modbus_map.entries)))
            await asyncio.Event().wait()
        finally:
            await server.stop()

    def summary(self) -> Sequence[Note]:
        """Return a note on clients and requests."""
        counters = dataclasses.asdict(self.statistics)
        rare = {name: counters.pop(name) or None for name in ("malformed", "rejected", "closed")}
        return (Note("modbus.summary", "--modbus", **counters, **rare),)


def make_adapter(settings: AdapterSettings) -> ModbusAdapter:
    """Return the adapter for the value of the option `--modbus`."""
    with needed("pymodbus", "a Modbus server", "serve"):
        import pymodbus  # noqa: F401
    address = read_host_port(settings.value, "--modbus", DEFAULT_PORT)
    for note in open_address_notes(address, "--modbus"):
        settings.report(note)
    return ModbusAdapter(address, map_of_circuit(settings.served, getattr(settings.options, "file", None)))


class _Connection(asyncio.Protocol):
    """Connection of one client."""

    transport: asyncio.Transport

    def __init__(self, server: ModbusServer) -> None:
        self.server, self.statistics, self.limits = server, server.statistics, server.limits
        self.buffer = bytearray()
        self.is_blocked = self.is_pending = self.is_malformed = False
        self.loop = asyncio.get_running_loop()
        self.heard = self.begun = self.loop.time()  # last byte; start of the time for a request or an answer

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self.transport = transport
        transport.set_write_buffer_limits(high=self.limits.unsent)
        transport.get_extra_info("socket").setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.statistics.clients += 1
        self.statistics.connections += 1
        self.server.connections.add(self)

    def connection_lost(self, exc: Exception | None) -> None:
        self.statistics.clients -= 1
        self.server.connections.discard(self)

    def is_overdue(self, now: float) -> bool:
        """Return True if the client was silent for too long, or does not complete its request or read its answers."""
        # Complete requests in the buffer wait for the server.
        is_awaited = self.is_blocked or (bool(self.buffer) and not self.is_pending)
        is_late = is_awaited and now - self.begun > self.limits.frame_time
        return is_late or now - self.heard > self.limits.idle_time

    def pause_writing(self) -> None:
        # The client does not read its answers: its next requests wait in its own buffers.
        self.is_blocked = True
        self._read_if_ready()

    def resume_writing(self) -> None:
        self.is_blocked = False
        self._answer_requests()

    def data_received(self, data: bytes) -> None:
        self.heard = self.loop.time()
        if not self.buffer:
            self.begun = self.heard
        self.buffer += data
        self._answer_requests()

    def _answer_requests(self) -> None:
        """Answer the complete requests in the buffer, a few at a time, so that other clients are also served."""
        self.is_pending = False
        if self.transport.is_closing():
            return
        answers, k = bytearray(), 0
        for _ in range(BATCH):
            end = self._end_of_request(k)
            if end is None:
                break
            transaction, _, _, unit = _HEADER.unpack_from(self.buffer, k)
            answer = self.server.answer(self.buffer[k + 7], bytes(self.buffer[k + 8 : end]), unit)
            answers += _HEADER.pack(transaction, 0, len(answer) + 1, unit) + answer
            k = end
        else:
            self.is_pending = True
        if k:
            del self.buffer[:k]
            self.begun = self.loop.time()
            self.transport.write(bytes(answers))
        if self.is_malformed:
            self.statistics.malformed += 1
            self.buffer.clear()
            self.transport.close()
            return
        if self.is_pending and not self.is_blocked:
            self.loop.call_soon(self._answer_requests)
        self._read_if_ready()

    def _end_of_request(self, start: int) -> int | None:
        """Return the index after the request at an index of the buffer, or None if it is incomplete or malformed."""
        if len(self.buffer) - start < _HEADER.size:
            return None
        _, protocol, length, _ = _HEADER.unpack_from(self.buffer, start)
        # After a malformed frame, the start of the next request is unknown.
        self.is_malformed = protocol != 0 or not 2 <= length <= MAX_LENGTH
        end: int = start + 6 + length
        return None if self.is_malformed or len(self.buffer) < end else end

    def _read_if_ready(self) -> None:
        if self.is_blocked or self.is_pending:
            self.transport.pause_reading()
        else:
            self.transport.resume_reading()
