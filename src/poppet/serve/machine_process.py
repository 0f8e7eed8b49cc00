"""Machine in a process of its own, which integrates in real time.

The process does nothing but integrate, so neither slow nor many clients delay its periods.
"""

from __future__ import annotations

import contextlib
import gc
import multiprocessing
import signal
import threading
import traceback
import weakref
from collections.abc import Iterator
from multiprocessing.connection import Connection
from multiprocessing.shared_memory import SharedMemory
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError, PoppetError
from poppet.serve.clocked_periods import ClockedPeriods, MachineClock
from poppet.serve.coupled_plant import make_plant
from poppet.serve.exchange import RECORDED, STATE, STOP, Exchange
from poppet.serve.machine import Machine, PeriodLoop, check_period, layout_of
from poppet.serve.points import ServedCircuit
from poppet.serve.priority import NORMAL
from poppet.serve.snapshot import MachineState

PATIENCE = 5.0
"""Time in which a machine ends by itself [s]."""
ENDING_SIGNALS = tuple(name for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
"""Signals that a terminal or a service manager sends to all processes of a program: the main process decides."""


class _MachineMemory(SharedMemory):
    """Shared memory whose arrays can outlive the machine, for example at the end of the program."""

    def __del__(self) -> None:
        with contextlib.suppress(BufferError):
            super().__del__()


class ProcessMachine(Machine):
    """Machine whose periods run in another process, at absolute deadlines.

    Parameters
    ----------
    served : ServedCircuit
        Circuit.
    clock : MachineClock
        Clock of the machine.

    Raises
    ------
    PoppetError
        If the model cannot be started, with the error of the other process.

    Attributes
    ----------
    priority : str
        Priority of the process at its start, see `poppet.serve.priority`.
    """

    def __init__(self, served: ServedCircuit, clock: MachineClock) -> None:
        if not clock.speed > 0.0:
            raise InputError("serve.speed", "speed", value=clock.speed)
        if check_period(clock.period) < clock.shortest_period:
            raise InputError("serve.short_period", "period", value=clock.period, least=clock.shortest_period)
        self._memory = _MachineMemory(create=True, size=layout_of(served).size)
        try:
            super().__init__(served, clock.period, self._memory.buf)
            self.speed = clock.speed
            self.exchange.fields[RECORDED] = 0 if clock.is_recorded and not clock.is_real else -1
            # Spawned: a copy of a process with threads can stop at their locks.
            context = multiprocessing.get_context("spawn")
            self._reports, reports = context.Pipe(duplex=False)
            arguments = served, clock, self._memory.name, reports
            self._process = context.Process(target=run_machine, args=arguments, daemon=True, name="poppet-machine")
            with _signals_blocked():
                self._process.start()
            reports.close()
            self._notes = list[Note]()
            self._report_lock = threading.Lock()
            self._end = weakref.finalize(self, _end, self._process, self._memory)
            self._wait_for_start()
        except BaseException:
            _end(getattr(self, "_process", None), self._memory)
            raise

    def _wait_for_start(self) -> None:
        try:
            answer = self._reports.recv()
        except EOFError:
            self._process.join()
            raise PoppetError(str(Note("serve.lost", code=self._process.exitcode))) from None
        if isinstance(answer, BaseException):
            self._process.join()
            raise answer
        if isinstance(answer, Note):  # of a failure in the first period
            self._note = answer
        self.priority: str = NORMAL if isinstance(answer, Note) else answer

    def advance(self, duration: Any) -> Any:
        raise InputError("serve.clocked", "advance")

    @property
    def state(self) -> MachineState:
        self._receive()
        return super().state

    @property
    def note(self) -> Note | None:
        self._receive()
        return self._note

    def take_notes(self) -> list[Note]:
        """Return the notes on the clock since the last call."""
        self._receive()
        with self._report_lock:
            notes, self._notes = self._notes, []
        return notes

    def _receive(self) -> None:
        """Receive the notes of the process, and detect that it has ended."""
        # Under the lock to the end: two threads that close the same pipe would close a file that was opened meanwhile.
        with self._report_lock:
            with contextlib.suppress(EOFError, OSError):
                while not self._reports.closed and self._reports.poll():
                    note = self._reports.recv()
                    if note.code == "serve.failed":
                        self._note = note
                    else:
                        self._notes.append(note)
                return
            # The process has closed its end.
            self._reports.close()
            fields = self.exchange.fields
            if int(fields[STATE]) in (MachineState.STARTING.value, MachineState.RUNNING.value):
                self._process.join(PATIENCE)
                self._note = Note("serve.lost", code=self._process.exitcode)
                fields[STATE] = MachineState.FAILED.value

    def request_stop(self) -> None:
        self.exchange.fields[STOP] = 1

    def stop(self) -> None:
        if not self._end.alive:
            return
        self.request_stop()
        self._process.join(PATIENCE)
        super().stop()
        # The last values remain readable. Another thread can still read the shared memory, which then closes later.
        self.exchange = self.exchange.copy()
        self._end()
        with contextlib.suppress(BufferError):
            self._memory.close()

    def join(self, timeout: float | None = None) -> None:
        """Wait until the process of the machine has ended, at most for a time [s]."""
        self._process.join(timeout)


@contextlib.contextmanager
def _signals_blocked() -> Iterator[None]:
    """Start processes that these signals do not reach, even before their first line."""
    if not hasattr(signal, "pthread_sigmask"):  # on Windows
        yield
        return
    former = signal.pthread_sigmask(signal.SIG_BLOCK, [getattr(signal, name) for name in ENDING_SIGNALS])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, former)


def _end(process: Any, memory: SharedMemory) -> None:
    """End the process of a machine, and remove its shared memory."""
    if process is not None and process.is_alive():
        process.kill()
        process.join()
    with contextlib.suppress(FileNotFoundError):
        memory.unlink()


def run_machine(served: ServedCircuit, clock: MachineClock, memory_name: str, reports: Connection) -> None:
    """Run the periods of a machine until it is stopped; the target of its process."""
    for name in ENDING_SIGNALS:
        signal.signal(getattr(signal, name), signal.SIG_IGN)
    memory = _MachineMemory(memory_name)
    exchange = Exchange(layout_of(served), memory.buf)
    try:
        plant = make_plant(served, clock.period)
        loop = PeriodLoop(plant, exchange)
    except BaseException as error:
        reports.send(error if isinstance(error, PoppetError) else PoppetError(traceback.format_exc()))
        return
    gc.collect()
    gc.freeze()
    gc.disable()
    try:
        ClockedPeriods(loop, plant, exchange, clock, reports).run()
    finally:
        if plant.failure is not None:
            reports.send(Note("serve.failed", time=plant.t, reason=str(plant.failure)))
            # After the note, so that each reader of the state finds it.
            exchange.fields[STATE] = MachineState.FAILED.value
        elif int(exchange.fields[STATE]) == MachineState.RUNNING.value:
            exchange.fields[STATE] = MachineState.STOPPED.value
        for note in plant.notes():
            reports.send(note)
        plant.close()
        reports.close()
