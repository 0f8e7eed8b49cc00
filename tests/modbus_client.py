"""Plain Modbus TCP client for tests: single requests, and random frames."""

from __future__ import annotations

import asyncio
import random
import socket
import struct
import threading


def connect(port: int) -> socket.socket:
    """Connect to a server on this computer."""
    return socket.create_connection(("127.0.0.1", port), timeout=10)


def exchange(stream: socket.socket, function: int, body: bytes, unit: int = 7, transaction: int = 99) -> bytes:
    """Send a request, and return the function code and data of the answer."""
    stream.sendall(struct.pack(">HHHBB", transaction, 0, len(body) + 2, unit, function) + body)
    return answer_of(stream, unit, transaction)


def answer_of(stream: socket.socket, unit: int, transaction: int) -> bytes:
    """Return the function code and data of an answer, whose header must be that of the request."""
    header = received(stream, 7)
    number, protocol, length, unit_back = struct.unpack(">HHHB", header)
    assert (number, protocol, unit_back) == (transaction, 0, unit)
    return received(stream, length - 1)


def received(stream: socket.socket, count: int) -> bytes:
    """Return exactly this number of bytes."""
    data = b""
    while len(data) < count:
        piece = stream.recv(count - len(data))
        if not piece:
            raise ConnectionError(data)
        data += piece
    return data


def is_closed(stream: socket.socket) -> bool:
    """Wait until the server has closed a connection."""
    try:
        return stream.recv(1) == b""
    except ConnectionError:
        return True


def leave_within_a_delay(loop: asyncio.AbstractEventLoop, port: int, count: int) -> None:
    """Connect and leave many times while a delay of the server's event loop keeps it from noticing."""
    is_delayed, is_over = threading.Event(), threading.Event()

    def delay() -> None:
        is_delayed.set()
        is_over.wait(60.0)

    loop.call_soon_threadsafe(delay)
    assert is_delayed.wait(60.0)
    try:
        for _ in range(count):
            connect(port).close()
    finally:
        is_over.set()


def send_random_frames(port: int, count: int, chance: random.Random) -> None:
    """Send messages of random bytes with a valid header, and frames of random bytes, and wait for each reaction."""
    with connect(port) as stream:
        for k in range(count):
            if k % 2:
                body = chance.randbytes(chance.randint(1, 30))
                exchange(stream, body[0], body[1:], chance.randrange(256), k % 65536)
                continue
            with connect(port) as other:
                other.sendall(chance.randbytes(chance.randint(1, 300)))
                other.shutdown(socket.SHUT_WR)
                while not is_closed(other):
                    pass
