"""Reader of lines of limited length from the standard input, and writer to the standard output."""

from __future__ import annotations

import asyncio
import contextlib
import os
import sys
import threading
from collections.abc import AsyncIterator, Iterator

from poppet.assist.limits import LINE

AHEAD = 16
"""Number of lines that are read in advance."""


class Pipe:
    """Standard input and output of a protocol.

    The descriptors 0 and 1 lead to the null device and to the standard error afterwards, so that nothing else is
    written to the protocol.
    """

    def __init__(self) -> None:
        sys.stdout.flush()
        self._input, self._output = os.dup(0), os.dup(1)
        empty = os.open(os.devnull, os.O_RDONLY)
        os.dup2(empty, 0)
        os.close(empty)
        os.dup2(2, 1)
        self._lines: asyncio.Queue[bytes | None] = asyncio.Queue(AHEAD)
        self._lock = threading.Lock()

    def start(self) -> None:
        """Start to read; a daemon, because the program can end while the thread waits for input."""
        threading.Thread(target=self._read, args=(asyncio.get_running_loop(),), daemon=True).start()

    async def lines(self) -> AsyncIterator[bytes]:
        """Yield lines without line ends until the end of the input; a line that is too long is empty."""
        while (line := await self._lines.get()) is not None:
            yield line

    def write(self, text: str) -> None:
        """Write a line, unless the client has closed the pipe."""
        data = text.encode() + b"\n"
        with self._lock, contextlib.suppress(BrokenPipeError):
            while data:
                data = data[os.write(self._output, data) :]

    def _read(self, loop: asyncio.AbstractEventLoop) -> None:
        for line in read_lines(self._input):
            # Waits while the queue is full.
            asyncio.run_coroutine_threadsafe(self._lines.put(line), loop).result()
        asyncio.run_coroutine_threadsafe(self._lines.put(None), loop).result()


def read_lines(descriptor: int, longest: int = LINE) -> Iterator[bytes]:
    """Yield lines without line ends; of a line that is too long, the first `longest + 1` bytes are kept."""
    begin = b""
    while block := os.read(descriptor, 65536):
        *lines, block = block.split(b"\n")
        for line in lines:
            yield (begin + line)[: longest + 1]
            begin = b""
        begin = (begin + block)[: longest + 1]
    if begin:
        yield begin
