"""OPC UA server: nodes, values, status codes and writing, with the client of asyncua."""

from __future__ import annotations

import asyncio
import socket
import struct
from collections.abc import Callable, Coroutine, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("asyncua", reason="the extra opcua is not installed")

from asyncua import Client, ua

import poppet
from modbus_client import leave_within_a_delay
from poppet.core.errors import InputError
from poppet.parts.faults import FAULTS
from poppet.serve.adapters import HostPort
from poppet.serve.exchange import STATE
from poppet.serve.machine import Machine
from poppet.serve.opcua_nodes import MachineValues, OpcVariable
from poppet.serve.opcua_server import LARGEST_MESSAGE, MAX_CLIENTS, OpcServer
from poppet.serve.points import PointRole
from poppet.serve.snapshot import MachineState
from serve_opcua import client_of, serving, url_of

CIRCUIT = Path(__file__).parents[3] / "examples" / "serve" / "two_cylinders_machine.toml"
CODES = ua.StatusCodes


@pytest.fixture(scope="module")
def server() -> Iterator[OpcServer]:
    with poppet.load(CIRCUIT).serve(clock=False) as machine:
        machine.advance(0.5)
        with serving(machine) as running:
            yield running


def with_client(server: OpcServer, work: Callable[[Client], Coroutine[Any, Any, None]]) -> None:
    """Run a coroutine with a connected client."""

    async def run() -> None:
        async with client_of(url_of(server)) as client:
            await asyncio.wait_for(work(client), 60.0)

    asyncio.run(run())


def write_values(*items: tuple[str, Any]) -> Any:
    """Return a request that writes values."""
    request = ua.WriteParameters()
    for address, value in items:
        variant = value if isinstance(value, ua.Variant) else ua.Variant(value, ua.VariantType.Double)
        item = ua.WriteValue()
        item.NodeId, item.AttributeId = ua.NodeId(address, 2), ua.AttributeIds.Value
        item.Value = ua.DataValue(variant)
        request.NodesToWrite.append(item)
    return request


async def codes_of(client: Client, *items: tuple[str, Any]) -> list[int]:
    results = await client.uaclient.write(write_values(*items))
    return [result.value for result in results]


def test_every_point_has_value_unit_range_and_description(server: OpcServer) -> None:
    machine = server.machine
    snapshot = machine.snapshot()

    async def work(client: Client) -> None:
        assert (await client.get_namespace_array())[2] == "urn:poppet:circuit"
        for point in machine.points:
            node = client.get_node(f"ns=2;s={point.address}")
            data = await node.read_data_value()
            assert data.StatusCode.is_good()
            assert float(data.Value.Value) == snapshot[point.address], point.address
            assert isinstance(data.Value.Value, bool) == point.is_flag
            assert abs((ua.datetime.now(ua.timezone.utc) - data.SourceTimestamp).total_seconds()) < 60.0
            assert (await node.read_description()).Text == point.doc
            properties = {(await child.read_browse_name()).Name: child for child in await node.get_properties()}
            if not point.is_flag:
                unit = await properties["EngineeringUnits"].read_value()
                assert unit.DisplayName.Text == point.unit
            if np.isfinite([point.low, point.high]).any() and not point.is_flag:
                limits = await properties["EURange"].read_value()
                assert (limits.Low, limits.High) == (point.low, point.high)
            else:
                assert "EURange" not in properties
            levels = await node.get_access_level()
            assert (ua.AccessLevel.CurrentWrite in levels) == (point.role is PointRole.INPUT)

    with_client(server, work)


def test_units_have_the_codes_of_the_standard(server: OpcServer) -> None:
    """The bytes of the code, for example "PAL", are the identifier (OPC UA part 8)."""

    async def work(client: Client) -> None:
        for symbol, code in (("Pa", b"PAL"), ("K", b"KEL"), ("m", b"MTR"), ("N/m", b"4P"), ("m^3/(s Pa)", None)):
            address = next(point.address for point in server.machine.points if point.unit == symbol)
            unit = await client.get_node(f"ns=2;s={address}/EngineeringUnits").read_value()
            assert unit.UnitId == (-1 if code is None else int.from_bytes(code, "big"))
            assert (unit.DisplayName.Text, bool(unit.NamespaceUri)) == (symbol, code is not None)

    with_client(server, work)


def test_parts_are_folders(server: OpcServer) -> None:
    async def work(client: Client) -> None:
        root = await client.nodes.objects.get_child("2:Machine")
        node = await root.get_child(["2:valveA", "2:command"])
        assert node.nodeid == ua.NodeId("valveA.command", 2)
        names = [(await child.read_browse_name()).Name for child in await root.get_children()]
        assert {"valveA", "slideB", "time", "periods", "late_periods", "state", "note"} <= {*names}

    with_client(server, work)


def test_every_input_can_be_written(server: OpcServer) -> None:
    machine = server.machine
    inputs = [point for point in machine.points if point.role is PointRole.INPUT]

    async def work(client: Client) -> None:
        for point in inputs:
            low, high = max(point.low, -1e6), min(point.high, 1e6)
            for value in (low, 0.25 * low + 0.75 * high):
                assert await codes_of(client, (point.address, value)) == [CODES.Good]
                assert machine.snapshot()[point.address] == value
                assert await client.get_node(f"ns=2;s={point.address}").read_value() == value
        initial = [(point.address, point.initial) for point in inputs]
        assert await codes_of(client, *initial) == [CODES.Good] * len(inputs)
        for point in machine.points:
            if point.role is not PointRole.INPUT:
                assert await codes_of(client, (point.address, 1.0)) == [CODES.BadNotWritable]

    with_client(server, work)


def test_invalid_values_have_status_codes(server: OpcServer) -> None:
    address = "valveA.command"
    typed = ua.VariantType

    async def work(client: Client) -> None:
        before = server.machine.snapshot()[address]
        for value, code in (
            (7.0, CODES.BadOutOfRange), (-1e-9, CODES.BadOutOfRange), (float("nan"), CODES.BadOutOfRange),
            (float("inf"), CODES.BadOutOfRange), (ua.Variant(1, typed.Int32), CODES.BadTypeMismatch),
            (ua.Variant("1", typed.String), CODES.BadTypeMismatch), (ua.Variant(None), CODES.BadTypeMismatch),
            (ua.Variant([0.5, 0.5], typed.Double), CODES.BadTypeMismatch),
        ):  # fmt: skip
            assert await codes_of(client, (address, value)) == [code], value
        assert server.machine.snapshot()[address] == before
        assert await codes_of(client, ("nothing.here", 1.0)) == [CODES.BadNodeIdUnknown]
        assert await codes_of(client, ("$machine.time", 1.0)) == [CODES.BadNotWritable]
        for attribute in (ua.AttributeIds.DisplayName, ua.AttributeIds.AccessLevel):
            request = write_values((address, 1.0))
            request.NodesToWrite[0].AttributeId = attribute
            assert [each.value for each in await client.uaclient.write(request)] == [CODES.BadNotWritable]
        request = write_values((address, 1.0))
        request.NodesToWrite[0].IndexRange = "0"
        assert [each.value for each in await client.uaclient.write(request)] == [CODES.BadWriteNotSupported]
        node = client.get_node(ua.ObjectIds.Server_ServiceLevel)
        with pytest.raises(ua.uaerrors.BadNotWritable):
            await node.write_value(ua.Variant(0, typed.Byte))
        with pytest.raises(ua.UaStatusCodeError):
            await client.nodes.objects.add_folder(2, "intruder")

    with_client(server, work)


def test_the_valid_values_of_a_request_act_together(server: OpcServer) -> None:
    async def work(client: Client) -> None:
        items = (("valveA.command", 1.0), ("valveB.command", 3.0), ("slideA.load_force", 5.0), ("valveA.fault", 2.0))
        expected = [CODES.Good, CODES.BadOutOfRange, CODES.Good, CODES.BadTypeMismatch]
        assert await codes_of(client, *items) == expected
        snapshot = server.machine.snapshot()
        assert (snapshot["valveA.command"], snapshot["valveB.command"], snapshot["slideA.load_force"]) == (1, 0, 5)
        zero = [("valveA.command", 0.0), ("slideA.load_force", 0.0)]
        assert await codes_of(client, *zero) == [CODES.Good, CODES.Good]

    with_client(server, work)


def test_faults_are_named_numbers(server: OpcServer) -> None:
    machine = server.machine

    async def work(client: Client) -> None:
        for valve, words in machine.faults.items():
            node = client.get_node(f"ns=2;s={valve}.fault")
            values = await client.get_node(f"ns=2;s={valve}.fault/EnumValues").read_value()
            assert [value.DisplayName.Text for value in values] == ["none", *words]
            text = client.get_node(f"ns=2;s={valve}.fault/ValueAsText")
            for value in reversed(values):
                await node.write_value(ua.Variant(value.Value, ua.VariantType.UInt32))
                assert machine.fault_of(valve) == value.DisplayName.Text == (await text.read_value()).Text
                assert await node.read_value() == value.Value
            impossible = [k for k, word in enumerate(FAULTS, 1) if word not in words]
            for code in (*impossible, 77, 2**32 - 1):
                with pytest.raises(ua.uaerrors.BadOutOfRange):
                    await node.write_value(ua.Variant(code, ua.VariantType.UInt32))
            assert machine.fault_of(valve) == "none"

    with_client(server, work)


def test_subscriptions_receive_changes_only(server: OpcServer) -> None:
    received: list[tuple[str, Any]] = []

    class Handler:
        def datachange_notification(self, node: Any, value: Any, data: Any) -> None:
            received.append((node.nodeid.Identifier, value))

    async def work(client: Client) -> None:
        subscription = await client.create_subscription(1.0, Handler())
        nodes = [client.get_node(f"ns=2;s={address}") for address in ("valveB.command", "tank.none", "$machine.time")]
        await subscription.subscribe_data_change([nodes[0], nodes[2]])
        with pytest.raises(ua.uaerrors.BadNodeIdUnknown):
            await subscription.subscribe_data_change(nodes[1])
        while len(received) < 2:
            await asyncio.sleep(0.01)
        server.machine.write({"valveB.command": 1.0})
        while ("valveB.command", 1.0) not in received:
            await asyncio.sleep(0.01)
        server.machine.write({"valveB.command": 0.0})
        while received[-1] != ("valveB.command", 0.0):
            await asyncio.sleep(0.01)
        assert [name for name, _ in received].count("$machine.time") == 1  # it does not advance

    with_client(server, work)


def test_the_shortest_publishing_interval(server: OpcServer) -> None:
    async def work(client: Client) -> None:
        for requested in (0.0, 1e-9, -5.0, 250.0, float("nan")):
            parameters = ua.CreateSubscriptionParameters()
            parameters.RequestedPublishingInterval = requested
            result = await client.uaclient.create_subscription(parameters, None)
            revised = result.RevisedPublishingInterval
            assert revised == (250.0 if requested == 250.0 else 100.0)
            await client.uaclient.delete_subscriptions([result.SubscriptionId])

    with_client(server, work)


def test_a_failure_makes_the_status_bad(server: OpcServer) -> None:
    fields = server.machine.exchange.fields

    async def work(client: Client) -> None:
        output, parameter = (
            client.get_node(f"ns=2;s={address}") for address in ("slideA.position", "gas.gas_constant")
        )
        data = await output.read_data_value(raise_on_bad_status=False)
        assert (data.StatusCode.value, data.Value.Value) == (CODES.BadDeviceFailure, None)
        assert await parameter.read_value() == pytest.approx(287.05)
        assert await client.get_node("ns=2;s=$machine.state").read_value() == MachineState.FAILED.value
        text = await client.get_node("ns=2;s=$machine.state/ValueAsText").read_value()
        assert text.Text == "failed"
        assert await codes_of(client, ("valveA.command", 1.0)) == [CODES.BadDeviceFailure]

    fields[STATE] = MachineState.FAILED.value
    try:
        with_client(server, work)
    finally:
        fields[STATE] = MachineState.RUNNING.value


def test_a_deadband_refers_to_the_last_value_that_was_sent(server: OpcServer) -> None:
    received: list[Any] = []
    machine, fields = server.machine, server.machine.exchange.fields

    class Handler:
        def datachange_notification(self, node: Any, value: Any, data: Any) -> None:
            received.append(value)

    async def work(client: Client) -> None:
        subscription = await client.create_subscription(100.0, Handler())
        node = client.get_node("ns=2;s=slideA.load_force")
        await subscription.deadband_monitor(node, 1.0, ua.DeadbandType.Absolute)
        for force in (0.4, 0.8, 1.2):
            machine.write({"slideA.load_force": force})
            await asyncio.sleep(3.0 * server.interval)
        while len(received) < 2:
            await asyncio.sleep(0.01)
        assert received == [0.0, 1.2]
        fields[STATE] = MachineState.FAILED.value
        while len(received) < 3:
            await asyncio.sleep(0.01)
        assert received[-1] is None

    try:
        with_client(server, work)
    finally:
        fields[STATE] = MachineState.RUNNING.value
        machine.write({"slideA.load_force": 0.0})


def test_a_filter_that_fails_disturbs_no_other_subscription(server: OpcServer) -> None:
    """The difference to a value that is missing, because of a bad status, cannot be calculated."""
    received: list[Any] = []

    class Handler:
        def datachange_notification(self, node: Any, value: Any, data: Any) -> None:
            received.append((node.nodeid.Identifier, value))

    async def work(client: Client) -> None:
        subscription = await client.create_subscription(100.0, Handler())
        absolute = ua.DeadbandType.Absolute
        await subscription.deadband_monitor(client.get_node("ns=2;s=slideA.position"), 0.1, absolute)
        await subscription.subscribe_data_change(client.get_node("ns=2;s=valveB.command"))
        while len(received) < 2:
            await asyncio.sleep(0.01)
        for state, value in ((MachineState.FAILED, None), (MachineState.RUNNING, 0.0)):
            received.clear()
            server.machine.exchange.fields[STATE] = state.value
            while ("valveB.command", value) not in received:
                await asyncio.sleep(0.01)

    try:
        with_client(server, work)
    finally:
        server.machine.exchange.fields[STATE] = MachineState.RUNNING.value


def test_the_first_value_of_a_subscription_is_corrected(server: OpcServer, monkeypatch: pytest.MonkeyPatch) -> None:
    """No comparison of values has seen the first value."""
    fields, received = server.machine.exchange.fields, list[Any]()
    create = server._subscriptions.create_monitored_items

    async def create_during_a_failure(parameters: Any) -> Any:
        fields[STATE] = MachineState.FAILED.value
        result = await create(parameters)
        fields[STATE] = MachineState.RUNNING.value
        return result

    class Handler:
        def datachange_notification(self, node: Any, value: Any, data: Any) -> None:
            received.append(value)

    async def work(client: Client) -> None:
        subscription = await client.create_subscription(100.0, Handler())
        await subscription.subscribe_data_change(client.get_node("ns=2;s=valveB.command"))
        while len(received) < 2:
            await asyncio.sleep(0.01)
        assert received == [None, 0.0]

    monkeypatch.setattr(server._subscriptions, "create_monitored_items", create_during_a_failure)
    with_client(server, work)


def test_damaged_messages_end_their_connection_only(server: OpcServer) -> None:
    generator = np.random.default_rng(3)
    hello = b"HELF" + struct.pack("<I", 32) + struct.pack("<IIIII", 0, 65536, 65536, 0, 0) + struct.pack("<i", -1)
    messages = [
        hello[:13], hello, b"OPNF" + struct.pack("<I", 2**31) + b"x" * 100, b"MSGF" + struct.pack("<I", 0),
        *(generator.bytes(int(generator.integers(1, 400))) for _ in range(200)),
        *(b"MSGF" + struct.pack("<I", 8 + 40) + generator.bytes(40) for _ in range(50)),
    ]  # fmt: skip
    for message in messages:
        with socket.create_connection(("127.0.0.1", server.port), 10) as stream:
            stream.sendall(message)
    with socket.create_connection(("127.0.0.1", server.port), 10) as stream, pytest.raises(OSError, match=r"."):
        stream.sendall(b"OPNF" + struct.pack("<I", 2**31) + bytes(64 * LARGEST_MESSAGE))

    async def work(client: Client) -> None:
        assert await client.get_node("ns=2;s=$machine.time").read_value() == server.machine.snapshot().time

    with_client(server, work)


def test_clients_that_have_left_take_no_place(server: OpcServer) -> None:
    async def work(client: Client) -> None:
        assert await client.get_node("ns=2;s=$machine.time").read_value() == server.machine.snapshot().time

    leave_within_a_delay(server._server.bserver._server.get_loop(), server.port, 2 * MAX_CLIENTS)
    with_client(server, work)
    assert server._server.bserver.n_rejected == 0


def test_sessions_that_are_not_activated_have_no_rights_and_take_no_memory(server: OpcServer) -> None:
    async def flood() -> None:
        client = client_of(url_of(server))
        await client.connect_socket()
        await client.send_hello()
        await client.open_secure_channel()
        for _ in range(4 * MAX_CLIENTS):
            await client.create_session()
        for request in (
            client.get_node("ns=2;s=valveA.command").read_value(),
            codes_of(client, ("valveA.command", 1.0)),
        ):
            with pytest.raises(ua.uaerrors.BadUserAccessDenied):
                await request
        client.disconnect_socket()

    async def work(client: Client) -> None:
        assert await client.get_node("ns=2;s=$machine.time").read_value() == server.machine.snapshot().time

    asyncio.run(flood())
    assert len(server._server.iserver._external_sessions) <= 2 * MAX_CLIENTS + 1
    with_client(server, work)


def test_values_before_the_first_period_and_after_the_end() -> None:
    machine = poppet.load(CIRCUIT).serve(clock=False)
    values = MachineValues(machine)
    k = [point.address for point in machine.points].index("slideA.position")
    values.add("out", OpcVariable("slideA.position", ua.VariantType.Double, k, float, is_live=True))
    values.add("in", OpcVariable("valveA.command", ua.VariantType.Double, 2, float))
    assert values.data_value("out").StatusCode.value == CODES.BadWaitingForInitialData
    assert values.data_value("in").StatusCode.is_good()
    before, code = values.vector, values.code
    machine.advance(0.1)
    values.refresh()
    assert values.data_value("out").StatusCode.is_good()
    assert values.changed(before, code) == ["out", "in"]  # the status has changed
    before, stamp = values.vector, values.data_value("out").SourceTimestamp
    values.refresh()
    assert values.changed(before, values.code) == []
    assert values.data_value("out").SourceTimestamp == stamp  # no new period
    machine.write({"valveA.command": 1.0})
    values.refresh()
    assert values.changed(before, values.code) == ["in"]
    machine.stop()
    values.refresh()
    assert values.data_value("out").StatusCode.value == CODES.BadOutOfService


def test_an_address_in_use(server: OpcServer) -> None:
    class Inner:
        """Server of asyncua whose preparations take no time."""

        limits = iserver = _policies = None

        async def _setup_server_nodes(self) -> None: ...
        async def start(self) -> None: ...
        async def stop(self) -> None: ...

    inner: Any = Inner()
    inner.iserver = inner
    with pytest.raises(InputError) as caught:
        asyncio.run(OpcServer(Machine.__new__(Machine))._listen(inner, HostPort("127.0.0.1", server.port)))
    assert caught.value.code == "opcua.no_server"
    assert caught.value.facts["port"] == server.port
