"""Limit of the connections of a server, without sockets."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest

from poppet.serve import connection_limit
from poppet.serve.connection_limit import CHECKS, MOST_BYTES, ConnectionLimit, LimitedConnection


class Transport(asyncio.Transport):
    """Transport that remembers what was requested."""

    def __init__(self) -> None:
        super().__init__()
        self.calls: list[str] = []

    def abort(self) -> None:
        self.calls.append("abort")

    def pause_reading(self) -> None:
        self.calls.append("pause")

    def resume_reading(self) -> None:
        self.calls.append("resume")


class Receiver(asyncio.Protocol):
    """Protocol that remembers its messages."""

    def __init__(self) -> None:
        self.messages: list[Any] = []

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self.messages.append("made")

    def data_received(self, data: bytes) -> None:
        self.messages.append(data)

    def connection_lost(self, exc: Exception | None) -> None:
        self.messages.append("lost")


class Connections:
    """Connections to a server that admits two."""

    def __init__(self) -> None:
        self.n_rejected = 0
        self.limit = ConnectionLimit(2, self.count)

    def count(self) -> None:
        self.n_rejected += 1

    def open(self) -> tuple[LimitedConnection, Transport, Receiver]:
        receiver, transport = Receiver(), Transport()
        connection = self.limit.limited(receiver)
        connection.connection_made(transport)
        return connection, transport, receiver


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(connection_limit, "CHECK_TIME", 1e-3)


def test_a_waiting_connection_takes_the_place_of_a_lost_one() -> None:
    async def run() -> None:
        server = Connections()
        (first, _, _), (_, _, second), (third, transport, receiver), (_, _, fourth) = (server.open() for _ in range(4))
        third.data_received(b"re")
        third.data_received(b"quest")
        assert (second.messages, receiver.messages, fourth.messages) == (["made"], [], [])
        first.connection_lost(None)
        assert (receiver.messages, fourth.messages) == (["made", b"request"], [])
        third.data_received(b"next")
        third.connection_lost(None)
        assert receiver.messages == ["made", b"request", b"next", "lost"]
        assert fourth.messages == ["made"]
        assert (server.n_rejected, transport.calls) == (0, ["resume"])

    asyncio.run(run())


def test_a_client_that_leaves_while_it_waits_takes_no_place() -> None:
    async def run() -> None:
        server = Connections()
        (first, _, _), _, (third, _, receiver), (_, _, fourth) = (server.open() for _ in range(4))
        third.data_received(b"request")
        assert not third.eof_received()
        third.connection_lost(None)
        first.connection_lost(None)
        assert (receiver.messages, fourth.messages) == ([], ["made"])

    asyncio.run(run())


@pytest.mark.usefixtures("quick")
def test_a_connection_is_rejected_after_its_checks() -> None:
    async def run() -> None:
        server = Connections()
        _, _, (third, transport, receiver) = (server.open() for _ in range(3))
        while not server.n_rejected:
            assert transport.calls == []
            await asyncio.sleep(1e-3)
        third.connection_lost(None)
        await asyncio.sleep(2 * CHECKS * 1e-3)
        assert (server.n_rejected, transport.calls, receiver.messages) == (1, ["abort"], [])

    asyncio.run(run())


def test_the_memory_of_waiting_connections_is_limited(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(connection_limit, "MOST_WAITING", 1)

    async def run() -> None:
        server = Connections()
        (first, _, _), _, (third, transport, receiver), (fourth, rejected, _) = (server.open() for _ in range(4))
        assert (server.n_rejected, rejected.calls) == (1, ["abort"])
        fourth.connection_lost(None)
        data = bytes(MOST_BYTES + 1)
        third.data_received(data)
        assert transport.calls == ["pause"]
        first.connection_lost(None)
        assert transport.calls == ["pause", "resume"]
        assert receiver.messages == ["made", data]

    asyncio.run(run())


def test_waiting_connections_are_closed_with_their_server() -> None:
    async def run() -> None:
        server = Connections()
        (_, admitted, _), _, (_, waiting, _) = (server.open() for _ in range(3))
        server.limit.abort_waiting()
        assert (admitted.calls, waiting.calls) == (["resume"], ["abort"])

    asyncio.run(run())
