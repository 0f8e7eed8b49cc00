"""Connection of one page to a machine: rows and states to the page, inputs and faults from it."""

from __future__ import annotations

import asyncio
import json
import struct
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.serve.lines import error_rows
from poppet.serve.live_content import encode, finite, machine_facts, watch_facts
from poppet.serve.machine import Machine
from poppet.serve.points import PointRole
from poppet.serve.served_watch import ServedWatch

if TYPE_CHECKING:
    from websockets.asyncio.server import ServerConnection

Array = NDArray[np.float64]
INTERVAL = 0.05
"""Time between two messages with rows [s]."""
STATUS = 5
"""Number of messages with rows for one message with the state of the machine."""
MOST_ROWS = 64
"""Rows of a message; of more rows, some are omitted."""
MOST_WAITING = 1000
"""Rows since the last message of which older ones are omitted: the client does not read, or the machine is fast."""
LARGEST_MESSAGE = 2**16
"""Largest message of a page [byte]."""
MESSAGE_TIME = 0.01
"""Shortest time between two messages of a page that are read; others wait in the buffers of the page [s]."""
_HEADER = struct.Struct("<IIII")


@dataclass
class PageStatistics:
    """Counts of the pages of a server."""

    clients: int = 0  # at present
    total: int = 0
    rejected: int = 0
    messages: int = 0
    omitted: int = 0  # rows


class RowEncoder:
    """Encoder of rows as messages, which contain the series that have changed since the last message.

    A message is little-endian: four integers of 32 bits (numbers of rows and series, omitted rows, 0), the columns of
    the series as integers of 32 bits, zeros up to a multiple of 8 bytes, the times as 64-bit floats, and the values of
    one series after the other as 32-bit floats.
    """

    def __init__(self, columns: NDArray[np.int64]) -> None:
        self.columns = columns
        self._last = np.full(columns.size, np.nan, dtype="<f4")
        self._is_known = False

    def encode(self, rows: Array, omitted: int) -> bytes:
        """Return the message of rows, (n, n_columns) with the time in the first column."""
        values = rows[:, self.columns].T.astype("<f4")
        is_equal = (values == self._last[:, None]) | (np.isnan(values) & np.isnan(self._last[:, None]))
        changed = ~is_equal.all(axis=1) if self._is_known else np.ones(self.columns.size, dtype=bool)
        self._last, self._is_known = values[:, -1].copy(), True
        numbers = self.columns[changed].astype("<u4").tobytes()
        numbers += bytes(-len(numbers) % 8)
        header = _HEADER.pack(len(rows), int(np.count_nonzero(changed)), min(omitted, 2**32 - 1), 0)
        message: bytes = header + numbers + rows[:, 0].astype("<f8").tobytes() + values[changed].tobytes()
        return message


class LiveSession:
    """Connection of one page.

    Parameters
    ----------
    machine : Machine
        Machine.
    connection : ServerConnection
        Connection, whose headers have been checked.
    statistics : PageStatistics
        Counts of the server.
    start : str
        Text that differs for each start of the server.
    watch : ServedWatch, optional
        Condition monitoring of the machine.
    """

    def __init__(
        self,
        machine: Machine,
        connection: ServerConnection,
        statistics: PageStatistics,
        start: str,
        watch: ServedWatch | None = None,
    ) -> None:
        self.machine, self.connection, self.statistics = machine, connection, statistics
        self.start, self.watch = start, watch
        self._encoder = RowEncoder(np.empty(0, dtype=np.int64))
        self._n_inputs = len([point for point in machine.points if point.role is PointRole.INPUT])
        self._inputs: list[float] | None = None  # as last sent
        self._faults: dict[str, str] | None = None
        self._n_results = self._n_events = 0

    async def run(self) -> None:
        """Send and receive messages until the page closes the connection."""
        from websockets.exceptions import ConnectionClosed

        self.statistics.clients += 1
        self.statistics.total += 1
        sender = asyncio.create_task(self._send())
        try:
            async for message in self.connection:
                self.statistics.messages += 1
                await self.connection.send(encode(self.reply(message)))
                await asyncio.sleep(MESSAGE_TIME)
        except ConnectionClosed:
            pass
        finally:
            self.statistics.clients -= 1
            sender.cancel()
            with suppress(asyncio.CancelledError, ConnectionClosed):
                await sender

    # Values ----------------------------------------------------------------------------------------------------------

    async def _send(self) -> None:
        """Send rows and states. While the page does not read, this task waits, and rows are omitted."""
        await self.connection.send(encode({"hello": self._hello()}))
        index, count = self.machine.exchange.n_published - 1, 0
        while True:
            if not count % STATUS:
                await self.connection.send(encode({"status": self._status()}))
            count += 1
            index, message = self._rows_since(max(index, 0))
            if message:
                await self.connection.send(message)
            for content in self._watch_messages():
                await self.connection.send(encode(content))
            await asyncio.sleep(INTERVAL)

    def _rows_since(self, index: int) -> tuple[int, bytes]:
        """Return the number of the next row, and the message with the rows from a number on."""
        first, rows = self.machine.rows(max(index, self.machine.exchange.n_published - MOST_WAITING))
        if not len(rows):
            return index, b""
        following, omitted = first + len(rows), first - index
        if len(rows) > MOST_ROWS:
            omitted += len(rows) - MOST_ROWS
            # The last row is always sent.
            rows = rows[np.linspace(0, len(rows) - 1, MOST_ROWS).round().astype(np.int64)]
        self.statistics.omitted += omitted
        return following, self._encoder.encode(rows, omitted)

    def _hello(self) -> dict[str, Any]:
        machine = self.machine
        facts = machine_facts(machine.served, machine.row_names, machine.row_units)
        hello = {"start": self.start, "period": machine.period, "speed": finite(machine.speed), **facts}
        if self.watch is not None:
            twin = self.watch.twin
            note = Note("serve.watch_noise", interval=self.watch.interval)
            faults = watch_facts(twin.plan.faults, twin.plan.instance.surroundings.pressure)
            hello["watch"] = {"faults": faults, "note": str(note)}
        return hello

    def _status(self) -> dict[str, Any]:
        """Return time, state and lateness; also inputs and faults if they have changed."""
        machine, snapshot, lateness = self.machine, self.machine.snapshot(), self.machine.lateness()
        content: dict[str, Any] = {
            "state": snapshot.state.name.lower(), "time": snapshot.time, "periods": max(0, snapshot.period),
            "late": lateness.late, "latest": lateness.maximum, "clients": self.statistics.clients,
            "note": None if snapshot.note is None else str(snapshot.note),
        }  # fmt: skip
        inputs = snapshot.array[: self._n_inputs].tolist()
        faults = {valve: machine.fault_of(valve) for valve in machine.faults}
        if inputs != self._inputs:
            self._inputs = content["inputs"] = inputs
        if faults != self._faults:
            self._faults = content["faults"] = faults
        return content

    def _watch_messages(self) -> list[dict[str, Any]]:
        """Return the last result of the watch, with all events since the last message."""
        watch = self.watch
        if watch is None:
            return []
        result = watch.result
        if watch.error is not None and self._n_results >= 0:
            self._n_results = -1
            verdict = str(watch.error)
            return [
                {
                    "watch": {
                        "time": None,
                        "verdict": verdict,
                        "kind": "",
                        "alarm": "",
                        "faults": {},
                        "events": [verdict],
                    }
                }
            ]
        if result is None or watch.error is not None or watch.number == self._n_results:
            return []
        events = [text for number, text in watch.events if number > self._n_events]
        self._n_results, self._n_events = watch.number, watch.n_events
        values = {"time": result.time, "verdict": result.verdict, "kind": result.kind, "alarm": result.alarm}
        return [{"watch": {**values, "faults": result.faults, "events": events}}]

    # Commands --------------------------------------------------------------------------------------------------------

    def reply(self, message: str | bytes) -> dict[str, Any]:
        """Execute the commands of a message, and return the reply."""
        number: Any = None
        try:
            content = _read(message)
            number = content.get("id")
            self._execute(content)
        except InputError as error:
            return {"reply": number if isinstance(number, int) else None, "errors": error_rows(error)}
        return {"reply": number if isinstance(number, int) else None}

    def _execute(self, content: Mapping[str, Any]) -> None:
        values, faults, series = content.get("set", {}), content.get("fault", {}), content.get("series", [])
        if not (isinstance(values, dict) and isinstance(faults, dict) and isinstance(series, list)):
            raise InputError("serve.page_message", "message")
        n = len(self.machine.row_names)
        if not all(type(k) is int and 0 <= k < n for k in series):
            raise InputError("serve.page_message", "series")
        if values or faults:
            self.machine.command(values, faults)
        if "series" in content:
            self._encoder = RowEncoder(np.unique(np.array(series, dtype=np.int64)))


def _read(message: str | bytes) -> Mapping[str, Any]:
    try:
        content = json.loads(message)
    except (ValueError, RecursionError):
        content = None
    if not isinstance(content, dict):
        raise InputError("serve.page_message", "message")
    return content
