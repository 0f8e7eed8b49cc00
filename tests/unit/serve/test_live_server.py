"""Page of a served circuit: checks of requests, messages of the WebSocket, floods and slow clients."""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import json
import struct
import threading
from collections.abc import AsyncIterator, Awaitable, Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("websockets", reason="the extra serve is not installed")

from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed, InvalidMessage, InvalidStatus
from websockets.sync.client import connect as connect_thread

import poppet
from poppet.core.errors import InputError
from poppet.serve.adapters import AdapterSettings
from poppet.serve.live_server import MOST_CLIENTS, LiveServer, RequestCheck, make_adapter
from poppet.serve.live_session import LARGEST_MESSAGE, MOST_ROWS, MOST_WAITING, RowEncoder
from poppet.serve.machine import Machine

EXAMPLES = Path(__file__).parents[3] / "examples"
TANK = EXAMPLES / "serve" / "watched_tank.toml"
TOKEN = "a token for the tests"


@pytest.fixture
def machine() -> Machine:
    """Machine without a clock."""
    machine = poppet.load(TANK).serve("10 ms", clock=False)
    machine.advance(0.1)
    return machine


class Served:
    """Running server of a machine."""

    def __init__(self, adapter: LiveServer, port: int) -> None:
        self.adapter, self.port = adapter, port

    def url(self, token: str | None = TOKEN) -> str:
        return f"ws://127.0.0.1:{self.port}/live" + (f"?token={token.replace(' ', '%20')}" if token else "")

    def connections(self) -> list[Any]:
        """Connections on the side of the server."""
        return [*self.adapter._server.connections]

    def get(self, path: str, **headers: str) -> tuple[int, str, Any]:
        """Status, body and headers of a reply to a browser; redirections are not followed."""
        from http.client import HTTPConnection

        connection = HTTPConnection("127.0.0.1", self.port, timeout=30)
        connection.request("GET", path, headers=headers)
        reply = connection.getresponse()
        return reply.status, reply.read().decode(), reply.headers


PAGE: list[str] = []
"""Page of the machine, which takes longer than most tests."""


@contextlib.asynccontextmanager
async def serving(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> AsyncIterator[Served]:
    monkeypatch.setenv("POPPET_LIVE_TOKEN", TOKEN)
    if PAGE:
        monkeypatch.setattr("poppet.serve.live_server.served_page", lambda served, faults: PAGE[0])
    notes: list[Any] = []
    adapter = make_adapter(AdapterSettings("127.0.0.1:0", machine.served, argparse.Namespace(), notes.append))
    PAGE[:] = [adapter.page]
    task = asyncio.create_task(adapter.run(machine, notes.append))
    while not notes:
        await asyncio.sleep(0.01)
        assert not task.done(), task.result()
    yield Served(adapter, int(notes[0].facts["server"].rpartition(":")[2]))
    task.cancel()
    with contextlib.suppress(asyncio.CancelledError):
        await task


@pytest.fixture
def run(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> Callable[[Callable[[Served], Awaitable[None]]], None]:
    """Function that runs a test with a server."""

    def run_test(test: Callable[[Served], Awaitable[None]]) -> None:
        async def body() -> None:
            async with serving(machine, monkeypatch) as served:
                await test(served)

        asyncio.run(asyncio.wait_for(body(), 60.0))

    return run_test


async def text_of(client: Any, key: str) -> Any:
    """Return the value of the next text message with a key."""
    while True:
        message = await client.recv()
        if isinstance(message, str) and key in (content := json.loads(message)):
            return content[key] if key != "reply" else content


async def asked(client: Any, **content: Any) -> Any:
    await client.send(json.dumps({"id": 7, **content}))
    return await text_of(client, "reply")


def decoded(message: bytes) -> tuple[np.ndarray, dict[int, np.ndarray], int]:
    """Times, values of each series, and number of omitted rows; written from the description of the format."""
    n_rows, n_series, omitted, zero = struct.unpack_from("<4I", message)
    assert zero == 0
    numbers = struct.unpack_from(f"<{n_series}I", message, 16)
    place = 16 + 4 * n_series
    place += -place % 8
    times = np.frombuffer(message, "<f8", n_rows, place)
    values = np.frombuffer(message, "<f4", n_rows * n_series, place + 8 * n_rows).reshape(n_series, n_rows)
    assert len(message) == place + 8 * n_rows + 4 * n_rows * n_series
    return times, dict(zip(numbers, values, strict=True)), omitted


async def rows_of(client: Any) -> tuple[np.ndarray, dict[int, np.ndarray], int]:
    while isinstance(message := await client.recv(), str):
        pass
    return decoded(message)


# Requests ------------------------------------------------------------------------------------------------------------


def test_hosts_origins_and_tokens() -> None:
    check = RequestCheck("127.0.0.1", 8030, TOKEN)
    host, cookie = "127.0.0.1:8030", f"{check.cookie_name}={check.cookie}"
    own = f"http://{host}"
    cases = [
        ((host, own, cookie, None), True),
        ((host, own, "", TOKEN), True),
        ((host, own, "", None), False),
        ((host, own, "poppet_live_8030=other", None), False),
        ((host, own, "", "other"), False),
        (("localhost:8030", "http://localhost:8030", cookie, None), True),
        # A page of another server of this computer has the cookie of the host, but another origin.
        ((host, "http://127.0.0.1:9000", cookie, TOKEN), False),
        ((host, "http://localhost:8030", cookie, TOKEN), False),
        ((host, "https://evil.example", cookie, TOKEN), False),
        ((host, "null", "", TOKEN), True),
        ((host, "null", cookie, None), False),
        ((host, "null", cookie, "other"), False),
        ((host, "file://", "", TOKEN), True),
        ((host, None, "", TOKEN), True),
        ((host, None, cookie, None), False),
        (("evil.example:8030", "http://evil.example:8030", cookie, TOKEN), False),
        (("127.0.0.1:80", None, "", TOKEN), False),
        (("127.0.0.1", None, "", TOKEN), False),
        (("192.168.0.5:8030", None, "", TOKEN), False),
    ]
    for arguments, is_accepted in cases:
        assert check.accepts_socket(*arguments) is is_accepted, arguments


def test_an_open_server_accepts_numeric_hosts_only() -> None:
    check = RequestCheck("0.0.0.0", 8030, TOKEN)
    assert check.accepts_host("192.168.0.5:8030")
    assert check.accepts_host("[fe80::1]:8030")
    assert not check.accepts_host("evil.example:8030")


def test_connections_without_a_request_are_limited(
    run: Callable[[Callable[[Served], Awaitable[None]]], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("poppet.serve.live_server.MOST_CONNECTIONS", 3)
    monkeypatch.setattr("poppet.serve.connection_limit.CHECK_TIME", 0.01)

    async def test(served: Served) -> None:
        async with contextlib.AsyncExitStack() as stack:
            for _ in range(3):
                _, writer = await asyncio.open_connection("127.0.0.1", served.port)
                stack.callback(writer.close)
            with pytest.raises((ConnectionError, InvalidMessage)):
                await connect(served.url())
        assert served.adapter.statistics.rejected == 1
        async with connect(served.url()) as client:
            await text_of(client, "hello")

    run(test)


def test_a_client_without_a_request_is_disconnected(
    run: Callable[[Callable[[Served], Awaitable[None]]], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("poppet.serve.live_server.REQUEST_TIME", 0.05)

    async def test(served: Served) -> None:
        reader, writer = await asyncio.open_connection("127.0.0.1", served.port)
        writer.write(b"GET / HTTP/1.1\r\nHost: ")
        with contextlib.suppress(ConnectionError):
            await reader.read()
        writer.close()

    run(test)


@pytest.mark.parametrize(
    ("token", "headers"),
    [
        (None, {}),
        ("other", {}),
        (TOKEN, {"Origin": "https://evil.example"}),
        (None, {"Origin": "null"}),
        (TOKEN, {"Host": "evil.example"}),
    ],
)
def test_a_websocket_is_rejected(run: Any, token: str | None, headers: dict[str, str]) -> None:
    async def test(served: Served) -> None:
        host = headers.get("Host")
        fields = {name: value for name, value in headers.items() if name != "Host"}
        url = served.url(token)
        options: dict[str, Any] = {"host": "127.0.0.1", "port": served.port} if host else {}
        with pytest.raises(InvalidStatus) as caught:
            await connect(url.replace("127.0.0.1", host) if host else url, additional_headers=fields, **options)
        assert caught.value.response.status_code == 403
        assert served.adapter.statistics.rejected == 1

    run(test)


def test_a_page_from_a_disk_connects_with_the_token(run: Any) -> None:
    async def test(served: Served) -> None:
        async with connect(served.url(), additional_headers={"Origin": "null"}) as client:
            hello = await text_of(client, "hello")
            assert hello["faults"] == {"drain": ["stuck_open", "stuck_closed", "stuck", "slow", "leak"]}

    run(test)


def test_the_token_becomes_a_cookie(run: Any) -> None:
    async def test(served: Served) -> None:
        get = served.get
        assert (await asyncio.to_thread(get, "/"))[0] == 403
        assert (await asyncio.to_thread(get, "/?token=other"))[0] == 403
        assert (await asyncio.to_thread(lambda: get("/", Host="evil.example")))[0] == 403
        status, _, headers = await asyncio.to_thread(get, f"/?token={TOKEN.replace(' ', '+')}")
        assert (status, headers["Location"]) == (303, "/")
        cookie, *properties = headers["Set-Cookie"].split("; ")
        assert TOKEN not in cookie
        assert set(properties) == {"HttpOnly", "SameSite=Strict", "Path=/"}
        status, page, headers = await asyncio.to_thread(lambda: get("/", Cookie=cookie))
        assert (status, headers["Content-Security-Policy"]) == (200, "frame-ancestors 'none'")
        assert "connect-src 'self'" in page
        assert TOKEN not in page
        assert (await asyncio.to_thread(lambda: get("/other", Cookie=cookie)))[0] == 404
        origin = {"Origin": f"http://127.0.0.1:{served.port}", "Cookie": cookie}
        async with connect(served.url(None), additional_headers=origin) as client:
            await text_of(client, "hello")

    run(test)


def test_a_short_token_is_rejected(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POPPET_LIVE_TOKEN", "short")
    with pytest.raises(InputError) as caught:
        make_adapter(AdapterSettings("8030", machine.served, argparse.Namespace(), print))
    assert caught.value.code == "serve.short_token"


def test_a_port_in_use_is_reported(machine: Machine, run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    async def test(served: Served) -> None:
        other = make_adapter(AdapterSettings(f"127.0.0.1:{served.port}", machine.served, argparse.Namespace(), print))
        with pytest.raises(InputError) as caught:
            await other.run(machine, print)
        assert caught.value.code == "serve.no_page"

    run(test)


# Messages ------------------------------------------------------------------------------------------------------------


def test_rows_and_states_are_those_of_the_machine(run: Any, machine: Machine) -> None:
    async def test(served: Served) -> None:
        async with connect(served.url()) as client:
            hello = await text_of(client, "hello")
            names = [name for name, _ in hello["columns"]]
            assert tuple(names) == machine.row_names
            wanted = [names.index(name) for name in ("tank.pressure", "valve.opening", "supply.pressure")]
            assert await asked(client, series=wanted) == {"reply": 7}
            machine.advance(2.0)
            times, values, omitted = await rows_of(client)
            while times[-1] < 2.1:
                times, more, omitted = await rows_of(client)
                values |= more
            first, rows = machine.rows(0)
            assert (first, omitted, len(times)) == (0, 200 - MOST_ROWS, MOST_ROWS)
            kept = np.round(times / machine.period).astype(int)
            assert times.tolist() == rows[kept, 0].tolist()
            for column in wanted:
                assert values[column].tolist() == rows[kept, column].astype(np.float32).tolist()[-len(values[column]) :]
            # Later messages contain only the series that have changed.
            machine.advance(0.01)
            times, values, omitted = await rows_of(client)
            assert (times.tolist(), list(values), omitted) == ([machine.snapshot().time], wanted[:1], 0)
            status = await text_of(client, "status")
            assert (status["state"], status["periods"], status["time"]) == ("running", 211, machine.snapshot().time)

    run(test)


def test_inputs_and_faults_are_written_together(run: Any, machine: Machine) -> None:
    async def test(served: Served) -> None:
        async with connect(served.url()) as client, connect(served.url()) as other:
            await text_of(client, "hello")
            first = await text_of(other, "status")
            assert first["faults"] == {"drain": "none"}
            assert await asked(client, set={"leak.opening": 0.5}, fault={"drain": "leak"}) == {"reply": 7}
            assert (machine.snapshot()["leak.opening"], machine.fault_of("drain")) == (0.5, "leak")
            # The other page shows the change.
            status = await text_of(other, "status")
            while "faults" not in status:
                status = await text_of(other, "status")
            assert status["faults"] == {"drain": "leak"}
            assert 0.5 in status["inputs"]

    run(test)


@pytest.mark.parametrize(
    ("message", "code"),
    [
        ('{"id": 7, "set": {"leak.opening": 2}}', "inputs.outside"),
        ('{"id": 7, "set": {"leak.opening": NaN}}', "quantity.not_finite"),
        ('{"id": 7, "set": {"leak.opening": 1e999}}', "quantity.not_finite"),
        ('{"id": 7, "set": {"leak.opening": 1' + 400 * "0" + "}}", "quantity.not_finite"),
        ('{"id": 7, "set": {"tank.pressure": 2e5}}', "serve.not_writable"),
        ('{"id": 7, "set": {"valve.opening": 1}}', "serve.driven"),
        ('{"id": 7, "set": {"leak.openin": 1}, "fault": {"drain": "leak"}}', "names.unknown"),
        ('{"id": 7, "fault": {"drain": "broken"}}', "fields.not_an_option"),
        ('{"id": 7, "set": [1]}', "serve.page_message"),
        ('{"id": 7, "series": [-1]}', "serve.page_message"),
        ('{"id": 7, "series": [1e9]}', "serve.page_message"),
        ('{"id": 7, "series": [true]}', "serve.page_message"),
        ('{"id": 7, "set": {"leak.opening": 1}, "series": [-1]}', "serve.page_message"),
        ("[]", "serve.page_message"),
        ("{", "serve.page_message"),
        ("[" * 30_000, "serve.page_message"),
        (b"\xff\xfe", "serve.page_message"),
    ],
)
def test_an_invalid_message_changes_nothing(run: Any, machine: Machine, message: str | bytes, code: str) -> None:
    async def test(served: Served) -> None:
        before = machine.snapshot().array.tolist()
        async with connect(served.url()) as client:
            await client.send(message)
            reply = await text_of(client, "reply")
            assert reply["errors"][0]["code"] == code
            assert (await asked(client))["reply"] == 7
        np.testing.assert_array_equal(machine.snapshot().array.tolist(), before)
        assert machine.fault_of("drain") == "none"

    run(test)


def test_a_long_message_closes_the_connection(run: Any) -> None:
    async def test(served: Served) -> None:
        async with connect(served.url()) as client:
            await client.send(b" " * (LARGEST_MESSAGE + 1))
            with pytest.raises(ConnectionClosed):
                await text_of(client, "nothing")
        async with connect(served.url()) as client:
            await text_of(client, "hello")

    run(test)


def flood(url: str, has_ended: threading.Event) -> int:
    """Send messages until the event, and return their number."""
    count = 0
    with connect_thread(url, close_timeout=0.1) as client:
        while not has_ended.is_set():
            try:
                client.socket.settimeout(0.1)
                client.send('{"set": {"leak.opening": 0.5}}')
                count += 1
            except TimeoutError:
                break
    return count


def test_a_flood_delays_only_its_own_client(run: Any) -> None:
    async def test(served: Served) -> None:
        has_ended, loop, statistics = threading.Event(), asyncio.get_running_loop(), served.adapter.statistics
        flooding = asyncio.create_task(asyncio.to_thread(flood, served.url(), has_ended))
        try:
            async with connect(served.url()) as other:
                await text_of(other, "hello")
                while statistics.messages < 10:
                    await asyncio.sleep(0.01)
                begin, start = statistics.messages, loop.time()
                for _ in range(10):
                    assert (await asked(other, set={"leak.opening": 0.25}))["reply"] == 7
                # One message in 10 ms is read from each client.
                assert statistics.messages - begin <= 2 * (2 + (loop.time() - start) / 0.01)
        finally:
            has_ended.set()
        assert await flooding > 10

    run(test)


def test_rows_are_omitted_for_a_client_that_does_not_read(run: Any, machine: Machine) -> None:
    async def test(served: Served) -> None:
        everything = list(range(1, len(machine.row_names)))
        async with connect(served.url(), max_queue=1) as slow, connect(served.url()) as other:
            await text_of(slow, "hello")
            await asked(slow, series=everything)
            slow.transport.pause_reading()
            (connection,) = (c for c in served.connections() if c.remote_address == slow.local_address)
            largest = 0
            for _ in range(400):
                machine.advance(0.64)
                await asyncio.sleep(0.005)
                largest = max(largest, connection.transport.get_write_buffer_size())
            assert largest < 2**18
            times, _, _ = await rows_of(other)
            while times[-1] < machine.snapshot().time:
                times, _, _ = await rows_of(other)
            slow.transport.resume_reading()
            omitted, times = 0, np.zeros(1)
            while times[-1] < machine.snapshot().time:
                times, _, more = await rows_of(slow)
                omitted += more
            assert omitted > 0

    run(test)


def test_the_number_of_clients_is_limited(run: Any) -> None:
    async def test(served: Served) -> None:
        async with contextlib.AsyncExitStack() as stack:
            for _ in range(MOST_CLIENTS):
                client = await stack.enter_async_context(connect(served.url()))
                await text_of(client, "hello")
            with pytest.raises(InvalidStatus) as caught:
                await connect(served.url())
            assert caught.value.response.status_code == 503
        while served.adapter.statistics.clients:
            await asyncio.sleep(0.01)
        async with connect(served.url()) as client:
            await text_of(client, "hello")

    run(test)


def test_a_client_that_ends_without_a_close_does_no_harm(run: Any) -> None:
    async def test(served: Served) -> None:
        client = await connect(served.url())
        await text_of(client, "hello")
        client.transport.abort()
        while served.adapter.statistics.clients:
            await asyncio.sleep(0.01)
        async with connect(served.url()) as client:
            await text_of(client, "hello")

    run(test)


def test_series_that_are_nan_count_as_unchanged() -> None:
    encoder = RowEncoder(np.array([1, 2, 3]))
    rows = np.array([[0.0, np.nan, 1.0, 5.0], [0.01, np.nan, 1.0, 5.0]])
    assert list(decoded(encoder.encode(rows, 0))[1]) == [1, 2, 3]
    assert list(decoded(encoder.encode(rows + np.array([0.02, 0.0, 0.0, 1.0]), 3))[1]) == [3]
    assert decoded(encoder.encode(rows, 2**40))[2] == 2**32 - 1
    assert MOST_ROWS <= MOST_WAITING


# Page ----------------------------------------------------------------------------------------------------------------


def test_a_summary_counts_connections(run: Any, machine: Machine) -> None:
    async def test(served: Served) -> None:
        async with connect(served.url()) as client:
            await text_of(client, "hello")
            await asked(client)
        with pytest.raises(InvalidStatus):
            await connect(served.url(None))
        (note,) = served.adapter.summary()
        assert (note.facts["pages"], note.facts["rejected"], note.facts["messages"]) == (1, 1, 1)

    run(test)
