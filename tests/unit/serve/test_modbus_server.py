"""Modbus server: requests of pymodbus and of plain sockets, exceptions, and limits of clients."""

from __future__ import annotations

import contextlib
import math
import random
import socket
import struct
import time
from collections.abc import Iterator
from typing import Any

import pytest

pytest.importorskip("pymodbus", reason="the extra serve is not installed")
from pymodbus.client import ModbusTcpClient

from modbus_client import answer_of, connect, exchange, is_closed, leave_within_a_delay, send_random_frames
from modbus_stub import StubMachine, map_of, point, serving
from poppet.serve.modbus import ModbusLimits, ModbusServer
from poppet.serve.modbus_map import read_modbus_map
from poppet.serve.snapshot import MachineState

FLOAT = ModbusTcpClient.DATATYPE.FLOAT32
REGISTERS = {
    "tank.pressure": {"input": 0, "unit": "bar"},
    "slide.position": {"input": 4, "type": "int16", "unit": "mm"},
    "valve.opening": {"holding": 0},
    "valve.setpoint": {"holding": 2, "unit": "bar"},
    "valve.fault": {"holding": 9},
    "plc.run": {"coil": 3},
    "valve.stuck_open": {"coil": 4},
    "valve.stuck_closed": {"coil": 5},
    "end.state": {"discrete": 1},
}


@pytest.fixture
def machine() -> StubMachine:
    return StubMachine()


@pytest.fixture
def server(machine: StubMachine) -> Iterator[ModbusServer]:
    with serving(machine, map_of(REGISTERS)) as running:
        yield running


@pytest.fixture
def client(server: ModbusServer) -> Iterator[ModbusTcpClient]:
    connected = ModbusTcpClient("127.0.0.1", port=server.port, timeout=10)
    assert connected.connect()
    yield connected
    connected.close()


def floats(response: Any) -> float:
    assert not response.isError(), response
    return float(ModbusTcpClient.convert_from_registers(response.registers, FLOAT))


def words(value: float) -> list[int]:
    return list(struct.unpack(">HH", struct.pack(">f", value)))


def connected_to(server: ModbusServer) -> socket.socket:
    return connect(server.port)


def wait_for(condition: Any) -> bool:
    end = time.monotonic() + 60.0
    while not condition() and time.monotonic() < end:
        time.sleep(0.005)
    return bool(condition())


def test_values_are_read_in_their_units(client: ModbusTcpClient, machine: StubMachine) -> None:
    assert floats(client.read_input_registers(0, count=2)) == 3.5
    assert client.read_input_registers(4, count=1).registers == [100]
    assert client.read_discrete_inputs(1, count=1).bits[0]
    machine.values["end.state"] = 0.0
    assert not client.read_discrete_inputs(1, count=1).bits[0]


def test_a_part_of_a_value_can_be_read(client: ModbusTcpClient) -> None:
    whole = client.read_input_registers(0, count=2).registers
    assert client.read_input_registers(1, count=1).registers == whole[1:]


@pytest.mark.parametrize("unit", [0, 1, 17, 255])
def test_any_unit_identifier_is_answered(client: ModbusTcpClient, unit: int) -> None:
    assert floats(client.read_input_registers(0, count=2, device_id=unit)) == 3.5


def test_all_values_of_a_request_are_written_together(client: ModbusTcpClient, machine: StubMachine) -> None:
    assert not client.write_registers(0, [*words(0.25), *words(6.0)]).isError()
    assert machine.writes == [{"valve.opening": 0.25, "valve.setpoint": 600_000.0}]
    assert floats(client.read_holding_registers(2, count=2)) == 6.0


def test_an_invalid_value_writes_nothing(client: ModbusTcpClient, machine: StubMachine) -> None:
    for invalid in (12.0, 0.5, float("nan"), float("inf")):
        response = client.write_registers(0, [*words(0.25), *words(invalid)])
        assert response.exception_code == 3
    assert machine.writes == []


def test_a_limit_that_a_float_rounds_is_valid(machine: StubMachine, client: ModbusTcpClient) -> None:
    # 11 bar is exact; 1.1 in the unit of ten bar is not, and its float is larger.
    assert struct.unpack(">f", struct.pack(">f", 1.1))[0] > 1.1
    with serving(machine, map_of({"valve.setpoint": {"holding": 0, "unit": "MPa"}})) as other:
        second = ModbusTcpClient("127.0.0.1", port=other.port)
        assert second.connect()
        assert not second.write_registers(0, words(1.1)).isError()
        second.close()
    assert machine.writes == [{"valve.setpoint": 1.1e6}]


def test_half_of_a_number_is_not_written(client: ModbusTcpClient, machine: StubMachine) -> None:
    assert client.write_register(0, 1).exception_code == 3
    assert client.write_register(1, 1).exception_code == 3
    assert client.write_registers(0, [*words(0.25), 1]).exception_code == 3
    assert client.mask_write_register(address=0, and_mask=0, or_mask=1).exception_code == 3
    assert machine.writes == []


def test_addresses_without_an_entry_have_the_exception_2(client: ModbusTcpClient, machine: StubMachine) -> None:
    responses = [
        client.read_input_registers(0, count=3), client.read_input_registers(2, count=1), client.read_coils(0, count=8),
        client.read_discrete_inputs(0, count=2), client.read_holding_registers(65535, count=1),
        client.read_holding_registers(0, count=125), client.write_coil(0, True), client.write_register(4, 0),
        client.write_registers(2, [*words(6.0), 0]), client.write_coils(3, [True, False, False, True]),
        client.readwrite_registers(read_address=4, read_count=1, address=0, values=words(0.5)),
    ]  # fmt: skip
    assert [response.exception_code for response in responses] == [2] * len(responses)
    assert machine.writes == []
    assert machine.fault_commands == []


def test_a_request_can_write_and_read(client: ModbusTcpClient) -> None:
    response = client.readwrite_registers(read_address=0, read_count=2, address=0, values=words(0.5))
    assert floats(response) == 0.5


def test_a_coil_is_written_and_read_back(client: ModbusTcpClient, machine: StubMachine) -> None:
    assert not client.write_coil(3, True).isError()
    assert client.read_coils(3, count=1).bits[0]
    assert machine.values["plc.run"] == 1.0
    assert not client.write_coils(3, [False, False]).isError()
    assert machine.values["plc.run"] == 0.0


def test_faults_begin_and_end_by_code(client: ModbusTcpClient, machine: StubMachine) -> None:
    assert client.read_holding_registers(9, count=1).registers == [0]
    for code, word in enumerate(("none", "stuck_open", "stuck_closed", "stuck", "slow", "leak")):
        assert not client.write_register(9, code).isError()
        assert machine.present["valve"] == word
        assert client.read_holding_registers(9, count=1).registers == [code]
    assert client.write_register(9, 6).exception_code == 3
    assert machine.present["valve"] == "leak"


def test_a_fault_that_a_valve_cannot_have_is_rejected(machine: StubMachine) -> None:
    with serving(machine, map_of({"check.fault": {"holding": 0}})) as server, connected_to(server) as stream:
        assert exchange(stream, 6, struct.pack(">HH", 0, 4)) == b"\x86\x03"
        assert exchange(stream, 6, struct.pack(">HH", 0, 5)) == struct.pack(">BHH", 6, 0, 5)
    assert machine.fault_commands == [("check", "leak")]


def test_fault_bits_end_their_own_fault_only(client: ModbusTcpClient, machine: StubMachine) -> None:
    assert not client.write_coils(4, [True, False]).isError()
    assert client.read_coils(4, count=2).bits[:2] == [True, False]
    assert machine.fault_commands == [("valve", "stuck_open")]
    assert not client.write_coils(4, [False, True]).isError()
    assert machine.present["valve"] == "stuck_closed"
    assert not client.write_coil(4, False).isError()
    assert machine.present["valve"] == "stuck_closed"
    assert client.write_coils(4, [True, True]).exception_code == 3
    assert not client.write_coil(5, False).isError()
    assert machine.present["valve"] == "none"


def test_a_failed_machine_has_the_exception_4(client: ModbusTcpClient, machine: StubMachine) -> None:
    machine.state = MachineState.FAILED
    assert client.read_input_registers(0, count=2).exception_code == 4
    assert client.write_coil(3, True).exception_code == 4
    machine.state = MachineState.STARTING
    assert client.read_input_registers(0, count=2).exception_code == 6
    assert client.write_coil(3, True).exception_code == 6
    assert machine.writes == []


def test_messages_that_violate_the_specification_have_an_exception(server: ModbusServer, machine: StubMachine) -> None:
    cases = [
        (4, struct.pack(">HH", 0, 0), 3),  # no register
        (4, struct.pack(">HH", 0, 126), 3),
        (2, struct.pack(">HH", 0, 2001), 3),
        (4, b"\x00", 3),
        (4, struct.pack(">HHH", 0, 2, 0), 3),
        (5, struct.pack(">HH", 3, 1), 3),  # a coil is 0xFF00 or 0
        (16, struct.pack(">HHB", 0, 2, 3) + bytes(3), 3),
        (16, struct.pack(">HHB", 0, 0, 0), 3),
        (16, struct.pack(">HHB", 0, 2, 4) + bytes(2), 3),
        (15, struct.pack(">HHB", 3, 3, 2) + bytes(2), 3),
        (15, struct.pack(">HHB", 3, 0, 0), 3),
        (16, struct.pack(">HHB", 0, 1, 4) + bytes(4), 3),
        (16, b"", 3),
        (6, b"\x00", 3),
        (22, bytes(5), 3),
        (23, struct.pack(">HHHHB", 0, 0, 0, 2, 4) + bytes(4), 3),
        (23, struct.pack(">HHHHB", 0, 2, 0, 122, 244) + bytes(238), 3),
        (23, struct.pack(">HHHHB", 0, 2, 0, 2, 3) + bytes(4), 3),
        (23, b"", 3),
        (8, struct.pack(">HH", 0, 0), 1),
        (43, b"\x0e\x01\x00", 1),
        (0, b"", 1),
        (99, b"\x00\x01", 1),
        (0x84, struct.pack(">HH", 0, 2), 1),
    ]  # fmt: skip
    with connected_to(server) as stream:
        answers = [exchange(stream, function, body) for function, body, _ in cases]
    assert answers == [bytes((function | 0x80, code)) for function, _, code in cases]
    assert machine.writes == []
    assert server.statistics.exceptions == server.statistics.transactions == len(cases)


def test_requests_in_one_packet_and_in_single_bytes_are_answered_in_order(server: ModbusServer) -> None:
    requests = [struct.pack(">HHHBBHH", k, 0, 6, 1, 4, 0, 2) for k in range(200)]
    with connected_to(server) as stream:
        stream.sendall(b"".join(requests))
        answers = [answer_of(stream, 1, k) for k in range(200)]
        assert set(answers) == {b"\x04\x04" + struct.pack(">f", 3.5)}
        for byte in requests[0]:
            stream.sendall(bytes((byte,)))
        assert answer_of(stream, 1, 0) == answers[0]


@pytest.mark.parametrize("frame", [
    struct.pack(">HHHBBHH", 1, 1, 6, 1, 4, 0, 2), struct.pack(">HHHBBHH", 1, 0, 1, 1, 4, 0, 2),
    struct.pack(">HHHBBHH", 1, 0, 0, 1, 4, 0, 2), struct.pack(">HHHBBHH", 1, 0, 255, 1, 4, 0, 2),
    b"GET / HTTP/1.1\r\n\r\n",
])  # fmt: skip
def test_a_malformed_frame_ends_its_connection_only(server: ModbusServer, frame: bytes) -> None:
    with connected_to(server) as other, connected_to(server) as stream:
        valid = struct.pack(">HHHBBHH", 5, 0, 6, 1, 4, 0, 2)
        stream.sendall(valid + frame)
        # Requests before it are answered.
        assert answer_of(stream, 1, 5)[0] == 4
        assert is_closed(stream)
        assert exchange(other, 4, struct.pack(">HH", 0, 2))[0] == 4
    assert server.statistics.malformed == 1


def test_random_frames_do_no_harm(server: ModbusServer, machine: StubMachine) -> None:
    initial = dict(machine.values)
    send_random_frames(server.port, 1000, random.Random(7))
    assert server.statistics.transactions >= 500
    assert server.statistics.malformed > 400
    with connected_to(server) as after:
        assert exchange(after, 4, struct.pack(">HH", 0, 2))[0] == 4
    opening, setpoint = machine.values["valve.opening"], machine.values["valve.setpoint"]
    assert 0.0 <= opening <= 1.0
    assert 1e5 <= setpoint <= 1.1e6
    read_only = ("tank.pressure", "slide.position", "tank.volume", "end.state")
    assert all(machine.values[name] == initial[name] for name in read_only)
    assert wait_for(lambda: server.statistics.clients == 0)


def test_a_client_that_disconnects_within_a_frame_leaves_nothing(server: ModbusServer) -> None:
    request = struct.pack(">HHHBBHHB", 1, 0, 11, 1, 16, 0, 2, 4) + struct.pack(">f", 0.5)
    for length in range(1, len(request)):
        with connected_to(server) as stream:
            stream.sendall(request[:length])
    with connected_to(server) as stream:
        assert exchange(stream, 3, struct.pack(">HH", 0, 2)) == b"\x03\x04" + struct.pack(">f", 0.0)
    assert wait_for(lambda: server.statistics.clients == 0 and not server.connections)


@contextlib.contextmanager
def flooding(limits: ModbusLimits) -> Iterator[tuple[ModbusServer, socket.socket]]:
    """Run a server, and connect a client that does not wait, with a small buffer for answers."""
    points = tuple(point(f"tank{k}.pressure", "Pa") for k in range(60))
    modbus_map = read_modbus_map(None, points, {}, 1e5)
    with serving(StubMachine(points, {}), modbus_map, limits) as server, socket.socket() as flood:
        flood.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        flood.connect(("127.0.0.1", server.port))
        flood.setblocking(False)
        yield server, flood


FLOOD = struct.pack(">HHHBBHH", 1, 0, 6, 1, 4, 0, 120) * 5000


def test_a_flooding_client_that_reads_nothing_does_not_stop_others() -> None:
    with flooding(ModbusLimits(frame_time=60.0)) as (server, flood), connected_to(server) as other:
        sent = 0

        def is_blocked() -> bool:
            nonlocal sent
            with contextlib.suppress(BlockingIOError):
                sent += flood.send(FLOOD)
            assert exchange(other, 4, struct.pack(">HH", 0, 2))[0] == 4
            return any(connection.is_blocked for connection in server.connections)

        assert wait_for(is_blocked)
        # The server has stopped reading: the memory of the client is limited.
        (connection,) = (one for one in server.connections if one.is_blocked)
        assert connection.transport.get_write_buffer_size() < 2 * server.limits.unsent
        assert len(connection.buffer) < 2**19 < sent
        assert exchange(other, 4, struct.pack(">HH", 0, 2))[0] == 4


def test_a_client_that_does_not_read_is_disconnected() -> None:
    with flooding(ModbusLimits(frame_time=0.05)) as (server, flood):

        def is_disconnected() -> bool:
            with contextlib.suppress(BlockingIOError, ConnectionError):
                flood.send(FLOOD)
            return server.statistics.closed == 1

        assert wait_for(is_disconnected)


def test_a_value_that_is_not_a_number_costs_no_connection(machine: StubMachine, client: ModbusTcpClient) -> None:
    machine.values |= {"slide.position": math.nan, "end.state": math.nan, "tank.pressure": math.nan}
    assert client.read_input_registers(4, count=1).registers == [0x8000]
    assert not client.read_discrete_inputs(1, count=1).bits[0]
    assert math.isnan(floats(client.read_input_registers(0, count=2)))


def test_clients_beyond_the_limit_are_rejected(machine: StubMachine) -> None:
    with serving(machine, map_of(), ModbusLimits(clients=2)) as server:
        first, second, third = (connected_to(server) for _ in range(3))
        assert exchange(second, 3, struct.pack(">HH", 0, 2))[0] == 3
        assert is_closed(third)
        first.close()
        assert wait_for(lambda: server.statistics.clients == 1)
        with connected_to(server) as fourth:
            assert exchange(fourth, 3, struct.pack(">HH", 0, 2))[0] == 3
        statistics = server.statistics
        assert (statistics.rejected, statistics.connections) == (1, 3)
        second.close()
        third.close()


def test_clients_that_have_left_take_no_place(machine: StubMachine) -> None:
    with serving(machine, map_of()) as server:
        assert server._server is not None
        leave_within_a_delay(server._server.get_loop(), server.port, 2 * server.limits.clients)
        with connected_to(server) as stream:
            assert exchange(stream, 3, struct.pack(">HH", 0, 2))[0] == 3
        assert server.statistics.rejected == 0


def test_silent_and_slow_clients_are_disconnected(machine: StubMachine) -> None:
    with serving(machine, map_of(), ModbusLimits(idle_time=0.3, frame_time=0.1)) as server:
        with connected_to(server) as silent, connected_to(server) as slow:
            slow.sendall(b"\x00\x01\x00")
            assert is_closed(slow)
            assert is_closed(silent)
        assert server.statistics.closed == 2


def test_requests_that_wait_for_the_server_cost_no_connection(machine: StubMachine) -> None:
    """More requests at once than the server answers in the time for one of them."""
    count = 2000
    with serving(machine, map_of(), ModbusLimits(frame_time=0.02)) as server, connected_to(server) as stream:
        body = struct.pack(">BBHH", 7, 3, 0, 2)
        stream.sendall(b"".join(struct.pack(">HHH", k, 0, 6) + body for k in range(count)))
        for k in range(count):
            assert answer_of(stream, 7, k)[0] == 3
        assert server.statistics.closed == 0


def test_a_port_in_use_is_an_error(server: ModbusServer, machine: StubMachine) -> None:
    import asyncio

    from poppet.core.errors import InputError

    async def start() -> None:
        await ModbusServer(machine, map_of()).start("127.0.0.1", server.port)

    with pytest.raises(InputError) as caught:
        asyncio.run(start())
    assert caught.value.code == "modbus.no_server"
    assert caught.value.facts["port"] == server.port
