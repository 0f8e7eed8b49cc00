"""Command `poppet serve`: run a circuit in real time as a virtual device."""

from __future__ import annotations

import argparse
import contextlib
import math
import sys
from collections import Counter
from collections.abc import Iterable
from typing import TYPE_CHECKING

from poppet.cli.assignments import load_circuit, read_value
from poppet.cli.parser import output_path
from poppet.cli.progress import Spinner
from poppet.cli.summary import print_notes, print_written
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, SimulationError
from poppet.core.number_format import printable

if TYPE_CHECKING:
    from poppet.serve.machine import Machine
    from poppet.serve.machine_process import ProcessMachine
    from poppet.serve.points import ServedCircuit


def execute(options: argparse.Namespace) -> int:
    """Run the command `serve` until the machine is stopped, and return the exit code."""
    from poppet.circuit.coupled_run import fmu_notes, one_pass_notes
    from poppet.core.units import quantity
    from poppet.serve.adapters import make_adapters
    from poppet.serve.clocked_periods import MachineClock
    from poppet.serve.coupled_plant import steps_per_period
    from poppet.serve.machine_process import ProcessMachine
    from poppet.serve.points import ServedCircuit
    from poppet.serve.program import run_program
    from poppet.serve.snapshot import MachineState

    times = {
        "--period": options.period, "--duration": options.duration, "--lines": options.lines,
        "--mqtt-interval": options.mqtt_interval,
    }  # fmt: skip
    with ErrorCollector() as errors:
        for name, text in times.items():
            with errors.collecting():
                times[name] = None if text is None else quantity(read_value(text), "s", name=name).value
        for name in ("--period", "--duration"):
            if isinstance(times[name], float) and not times[name] > 0.0:
                errors.add("serve.period", name, value=times[name])
        if not options.speed > 0.0:
            errors.add("serve.speed", "--speed", value=options.speed)
        least = MachineClock(period=0.0, speed=options.speed).shortest_period
        if isinstance(times["--period"], float) and 0.0 < times["--period"] < least:
            errors.add("serve.short_period", "--period", value=times["--period"], least=least)
    period, duration, options.lines, options.mqtt_interval = times.values()
    circuit, notes = load_circuit(options)
    if circuit.run.stop_texts:
        notes.append(Note("serve.stop_conditions", conditions=circuit.run.stop_texts))
    # The map needs the names of the points only.
    served = ServedCircuit.of(circuit, allow_native=options.allow_native or options.map is not None)
    if options.map is not None:
        _print_map(served, options)
        return 0
    if options.watch is not None and options.live is None:
        raise InputError("serve.watch_needs_page")
    adapters = make_adapters(served, options, _print_note)
    print_notes(notes)
    if circuit.fmus:
        step = period / steps_per_period(circuit, period)
        print_notes([*fmu_notes(circuit), *one_pass_notes(circuit, step)])
    n_periods = -1 if duration is None else max(1, round(duration / period))
    with Spinner("The model is prepared", is_quiet=options.quiet):
        machine = ProcessMachine(served, MachineClock(period, options.speed, n_periods, options.record is not None))
    try:
        if not options.quiet:
            _print_note(_started_note(served, machine))
        run_program(machine, adapters, _print_note)
    finally:
        machine.stop()
    for note in machine.take_notes():
        _print_note(note)
    _print_summary(options, machine, [note for adapter in adapters for note in adapter.summary()])
    if machine.state is MachineState.FAILED and machine.note is not None:
        raise SimulationError(machine.note)
    return 0


def _print_map(served: ServedCircuit, options: argparse.Namespace) -> None:
    """Print the map of the Modbus registers, or write it to a file."""
    from poppet.core.files import write_whole
    from poppet.serve.modbus_map import map_of_circuit

    path = output_path(options.map, (".csv", ".md")) if options.map else None
    modbus_map = map_of_circuit(served, options.file)
    if path is None:
        print(modbus_map.markdown())
        return
    text = modbus_map.csv() if path.suffix.lower() == ".csv" else modbus_map.markdown()
    write_whole(path, lambda stream: stream.write(text.encode()))
    print_written(path)


def _started_note(served: ServedCircuit, machine: ProcessMachine) -> Note:
    from poppet.serve.points import PointRole

    counts = Counter(point.role for point in served.points)
    return Note(
        "serve.started", title=served.circuit.title or "a circuit", inputs=counts[PointRole.INPUT],
        outputs=counts[PointRole.OUTPUT], parameters=counts[PointRole.PARAMETER], period=machine.period,
        priority=machine.priority, speed="" if machine.speed == 1.0 else f"{machine.speed:g}",
    )  # fmt: skip


def _print_summary(options: argparse.Namespace, machine: Machine, notes: Iterable[Note]) -> None:
    """Print the lateness of the periods and the summaries of the adapters, on the standard error beside JSON lines."""
    lateness, snapshot = machine.lateness(), machine.snapshot()
    ended = Note(
        "serve.ended", time=snapshot.time, periods=lateness.periods, late=lateness.late, longest=lateness.maximum
    )
    lines = [ended, *notes, lateness.table()] if math.isfinite(machine.speed) else [ended, *notes]
    target = sys.stderr if options.lines is not None else sys.stdout
    if not options.quiet:
        print("\n".join(map(str, lines)), file=target, flush=True)


def _print_note(note: Note) -> None:
    with contextlib.suppress(OSError):
        print(f"note: {printable(str(note))}", file=sys.stderr, flush=True)
