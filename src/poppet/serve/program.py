"""Program of `poppet serve`: one event loop with all adapters of a machine, until it is stopped."""

from __future__ import annotations

import asyncio
import contextlib
import signal
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.serve.adapters import Adapter
from poppet.serve.machine import Machine
from poppet.serve.machine_process import ENDING_SIGNALS
from poppet.serve.recorder import Recorder
from poppet.serve.snapshot import MachineState

INTERVAL = 0.05
"""Time between two checks of the state of the machine [s]."""


def run_program(machine: Machine, adapters: Sequence[Adapter], report: Callable[[Note], None]) -> None:
    """Serve a machine until it stops, or until Ctrl-C or the signals TERM and HUP.

    A machine that fails is served further. After the end, the last rows are recorded. An error of an adapter ends the
    program and is raised. If it is an error of its settings, such as a port in use, nothing is recorded.

    Parameters
    ----------
    machine : Machine
        Running machine, which is stopped.
    adapters : sequence of Adapter
        Adapters.
    report : callable
        Function that shows a note to the user.
    """
    try:
        asyncio.run(_serve(machine, adapters, report))
    finally:
        machine.stop()


async def _serve(machine: Machine, adapters: Sequence[Adapter], report: Callable[[Note], None]) -> None:
    end = asyncio.Event()
    with _signals_to(asyncio.get_running_loop(), end):
        tasks = [asyncio.create_task(adapter.run(machine, report)) for adapter in adapters]
        watch = asyncio.create_task(_watch(machine, report))
        stop = asyncio.create_task(end.wait())
        try:
            pending = {*tasks, watch, stop}
            while not (watch.done() or stop.done()):
                done, pending = await asyncio.wait(pending, return_when=asyncio.FIRST_COMPLETED)
                for task in done:
                    task.result()  # raises the error of an adapter
        except InputError:
            for adapter in adapters:
                if isinstance(adapter, Recorder):
                    adapter.discard()
            raise
        finally:
            # First the machine, so that a recorder gets all rows.
            machine.stop()
            for task in (*tasks, watch, stop):
                task.cancel()
            results = await asyncio.gather(*tasks, return_exceptions=True)
        for result in results:
            if isinstance(result, Exception):
                raise result


async def _watch(machine: Machine, report: Callable[[Note], None]) -> None:
    """Report the notes of the machine, and return when it has stopped."""
    is_failed = False
    while (state := machine.state) is not MachineState.STOPPED:
        if state is MachineState.FAILED and machine.is_stopping:
            return
        for note in machine.take_notes():
            report(note)
        if state is MachineState.FAILED and not is_failed and machine.note is not None:
            is_failed = True
            report(machine.note)
        await asyncio.sleep(INTERVAL)


@contextlib.contextmanager
def _signals_to(loop: asyncio.AbstractEventLoop, end: asyncio.Event) -> Iterator[None]:
    """Set an event at Ctrl-C and at the signals TERM and HUP; a second Ctrl-C interrupts as usual."""

    def handle(number: int, _frame: Any) -> None:
        signal.signal(number, previous[number])
        loop.call_soon_threadsafe(end.set)

    previous: dict[int, Any] = {}
    for number in (int(getattr(signal, name)) for name in ENDING_SIGNALS):
        if signal.getsignal(number) is signal.SIG_IGN:  # HUP of a command that `nohup` started
            continue
        # Another thread than the main one cannot receive signals.
        with contextlib.suppress(ValueError):
            previous[number] = signal.signal(number, handle)
    try:
        yield
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)
