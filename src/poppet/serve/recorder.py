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
        _append(stream, csv_text([[f"{name} [{unit}]" if unit else name for name, unit in names]]).encode())
        line = ",".join(["%.17g"] * len(machine.row_names)) + "\n"
        index, is_last = 0, False
        while True:
            first, rows = machine.rows(index)
            try:
                _append(stream, "".join([line % tuple(row) for row in rows.tolist()]).encode())
            except OSError as problem:
                self._problem = problem
                return  # with the rows until now
            self.n_lost += first - index
            self.n_rows += len(rows)
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


def _append(stream: IO[bytes], rows: bytes) -> None:
    """Append complete rows to a file; if there is no space for them, the file ends before them."""
    file, remaining = stream.fileno(), memoryview(rows)
    end = os.fstat(file).st_size
    try:
        while remaining:
            remaining = remaining[os.write(file, remaining) :]
    except OSError:
        os.ftruncate(file, end)
        raise


def make_adapter(settings: AdapterSettings) -> Recorder:
    """Return the recorder of the option --record."""
    return Recorder(Path(settings.value))
