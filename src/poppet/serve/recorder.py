"""Recorder: writes the rows of a machine into a CSV file while it runs."""

from __future__ import annotations

import asyncio
import os
import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import IO

from poppet.core.codes import Note
from poppet.core.csv_cells import csv_text
from poppet.core.errors import InputError
from poppet.core.files import write_whole
from poppet.serve.adapters import AdapterSettings
from poppet.serve.exchange import RECORDED
from poppet.serve.machine import Machine

INTERVAL = 0.2
"""Time between two collections of rows [s]."""


class Recorder:
    """Adapter that writes all rows of a machine, one for each period, into a CSV file.

    The file has its name only when it is complete. The memory does not depend on the duration of the run.

    Parameters
    ----------
    path : Path
        File.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.n_rows, self.n_lost = 0, 0
        self._has_ended = threading.Event()
        self._is_discarded = False
        self._problem: OSError | None = None

    def discard(self) -> None:
        """Write no file at the end: a file of the same name from an earlier run stays."""
        self._is_discarded = True

    async def run(self, machine: Machine, report: Callable[[Note], None]) -> None:
        work = asyncio.create_task(
            asyncio.to_thread(write_whole, self.path, lambda stream: self._write(machine, stream))
        )
        try:
            # Shielded: the file is completed after the end of the machine.
            await asyncio.shield(work)
        except asyncio.CancelledError:
            self._has_ended.set()
            await work
            raise
        if self._problem is not None:
            why = self._problem.strerror or str(self._problem)
            raise InputError("serve.recording_ended", path=str(self.path), rows=self.n_rows, why=why)

    def _write(self, machine: Machine, stream: IO[bytes]) -> None:
        names = zip(machine.row_names, machine.row_units, strict=True)
        _, self._problem = _append(stream, [csv_text([[f"{name} [{unit}]" if unit else name for name, unit in names]])])
        line = ",".join(["%.17g"] * len(machine.row_names)) + "\n"
        index, is_last = 0, False
        while self._problem is None:
            first, rows = machine.rows(index)
            n_written, self._problem = _append(stream, [line % tuple(row) for row in rows.tolist()])
            self.n_lost += first - index
            self.n_rows += n_written
            if self._problem is not None:
                break
            index = first + len(rows)
            if is_last and self._is_discarded:
                raise asyncio.CancelledError  # the temporary file is deleted
            if is_last:
                return
            is_ahead = machine.exchange.fields[RECORDED] >= 0
            if is_ahead:
                machine.exchange.fields[RECORDED] = index
            # After the request to end, the rest is written once more.
            is_last = self._has_ended.wait(0.0 if is_ahead and len(rows) else INTERVAL)

    def summary(self) -> Sequence[Note]:
        """Return the file and the number of its rows."""
        return [Note("serve.recorded", path=str(self.path), rows=self.n_rows, lost=self.n_lost or None)]


def _append(stream: IO[bytes], rows: Sequence[str]) -> tuple[int, OSError | None]:
    """Append rows to a file; return the number of complete rows in it, and the error if there is no space for all."""
    file, content = stream.fileno(), "".join(rows).encode()
    begin, n_bytes = os.fstat(file).st_size, 0
    try:
        while n_bytes < len(content):
            n_bytes += os.write(file, content[n_bytes:])
    except OSError as problem:
        complete = content[: content.rfind(b"\n", 0, n_bytes) + 1]
        os.ftruncate(file, begin + len(complete))
        return complete.count(b"\n"), problem
    return len(rows), None


def make_adapter(settings: AdapterSettings) -> Recorder:
    """Return the recorder of the option --record."""
    return Recorder(Path(settings.value))
