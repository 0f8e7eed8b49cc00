"""Limit of the connections of a server.

A server learns that a client has left only when it reads the connection. If many clients come and go within a short
time, the connections of clients that have left must not cause the rejection of another client. A connection beyond the
limit therefore waits for a while.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

MOST_WAITING = 256
"""Largest number of connections that wait."""
CHECKS, CHECK_TIME = 4, 0.25
"""Number of checks after which a waiting connection is rejected, and the time between them [s]. Several short times
instead of a long one: a busy computer can delay the event loop, but not all checks."""
MOST_BYTES = 4096
"""Bytes of a waiting connection after which the server stops reading it."""


class ConnectionLimit:
    """Limit of the connections of a server.

    Parameters
    ----------
    most : int
        Largest number of connections at the same time.
    on_reject : callable
        Function that counts a rejected connection.
    """

    def __init__(self, most: int, on_reject: Callable[[], None]) -> None:
        self.most, self._on_reject = most, on_reject
        self._admitted: set[LimitedConnection] = set()
        self._waiting: dict[LimitedConnection, None] = {}  # in the order of their arrival

    def limited(self, protocol: asyncio.Protocol) -> LimitedConnection:
        """Return the protocol of a connection whose messages go to another one while it is admitted."""
        return LimitedConnection(self, protocol)

    def enter(self, connection: LimitedConnection) -> None:
        """Admit a new connection, let it wait, or reject it."""
        if len(self._waiting) >= MOST_WAITING:
            self._reject(connection)
            return
        self._waiting[connection] = None
        self._admit_waiting()
        if connection in self._waiting:
            self._check_later(connection, CHECKS)

    def leave(self, connection: LimitedConnection) -> None:
        """Remove a lost connection, and admit others."""
        self._admitted.discard(connection)
        self._waiting.pop(connection, None)
        self._admit_waiting()

    def abort_waiting(self) -> None:
        """Close the connections that wait."""
        for connection in [*self._waiting]:
            connection.transport.abort()

    def _admit_waiting(self) -> None:
        while self._waiting and len(self._admitted) < self.most:
            connection = next(iter(self._waiting))
            del self._waiting[connection]
            self._admitted.add(connection)
            connection.admit()

    def _check_later(self, connection: LimitedConnection, checks: int) -> None:
        asyncio.get_running_loop().call_later(CHECK_TIME, self._check, connection, checks)

    def _check(self, connection: LimitedConnection, checks: int) -> None:
        """Reject a connection that still waits after the last check."""
        if connection not in self._waiting:
            return
        if checks > 1:
            self._check_later(connection, checks - 1)
        else:
            del self._waiting[connection]
            self._reject(connection)

    def _reject(self, connection: LimitedConnection) -> None:
        self._on_reject()
        connection.transport.abort()


class LimitedConnection(asyncio.Protocol):
    """Connection that a limit admits.

    Parameters
    ----------
    limit : ConnectionLimit
        Limit.
    protocol : asyncio.Protocol
        Protocol that receives the messages.
    """

    transport: asyncio.Transport

    def __init__(self, limit: ConnectionLimit, protocol: asyncio.Protocol) -> None:
        self._limit, self._protocol = limit, protocol
        self._is_admitted, self._buffer = False, bytearray()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self.transport = transport
        self._limit.enter(self)

    def admit(self) -> None:
        """Pass the connection, and what it has received while it waited, to its protocol."""
        self._is_admitted = True
        self.transport.resume_reading()
        self._protocol.connection_made(self.transport)
        if self._buffer:
            self._protocol.data_received(bytes(self._buffer))
            self._buffer.clear()

    def connection_lost(self, exc: Exception | None) -> None:
        if self._is_admitted:
            self._protocol.connection_lost(exc)
        self._limit.leave(self)

    def data_received(self, data: bytes) -> None:
        if self._is_admitted:
            self._protocol.data_received(data)
            return
        self._buffer += data
        if len(self._buffer) > MOST_BYTES:
            self.transport.pause_reading()

    def eof_received(self) -> bool | None:
        return self._protocol.eof_received() if self._is_admitted else None

    def pause_writing(self) -> None:
        self._protocol.pause_writing()

    def resume_writing(self) -> None:
        self._protocol.resume_writing()
