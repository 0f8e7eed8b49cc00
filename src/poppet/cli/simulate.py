"""`poppet simulate`: run a circuit file."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.cli.assignments import Shape, assignments, changed, value
from poppet.cli.main import INTERRUPTED
from poppet.cli.output_files import PICTURES, RECORDINGS, output_path
from poppet.cli.progress import Progress, Waiting
from poppet.cli.summary import extent, readable, run_summary
from poppet.ground.errors import InputError, SimulationError

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit
    from poppet.series.recording import Recording

EXAMPLES = (
    "poppet simulate valve-fill.toml",
    'poppet simulate valve-fill.toml --set tank.volume="0.1 m^3" -o fill.csv --plot fill.png',
    'poppet simulate valve-fill.toml --stop-when "tank.pressure > 2 bar" --units "bar,degC,l/min ANR"',
)
UNTRUSTED = ("not determined", "at bound")
"""Verdicts of an identification that a user of its numbers is reminded of."""
_RUN_OPTIONS = {
    "duration": "run.duration",
    "output_step": "run.output_step",
    "tolerance": "run.relative_tolerance",
    "solver": "run.solver",
}


def add_options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("file", metavar="FILE", help="circuit file (.toml)")
    parser.add_argument(
        "--set", action="append", default=[], metavar="ADDRESS=VALUE", dest="values",
        help='change a number or option: tank.volume="0.1 m^3", tank.thermal=isothermal; a bare number is SI',
    )  # fmt: skip
    parser.add_argument("-o", "--output", metavar="FILE", help="write the recording: .csv, .parquet or .mat")
    parser.add_argument("--plot", metavar="FILE", help="draw the recording: .png, .svg or .pdf")
    parser.add_argument("--duration", metavar="TIME", help='length of the run, "60 s"')
    parser.add_argument("--output-step", metavar="TIME", help='time between rows, "10 ms"')
    parser.add_argument("--tolerance", metavar="NUMBER", help="relative tolerance, 1e-6 by default")
    parser.add_argument(
        "--stop-when", action="append", default=[], metavar="CONDITION",
        help='end early, "tank.pressure > 5 bar"; adds to the conditions of the file',
    )  # fmt: skip
    parser.add_argument("--solver", metavar="NAME", help="rosenbrock (default); for a check cvodes, lsoda, bdf, radau")
    parser.add_argument("--start-from", metavar="RECORDING", help="start where a recording ends; --set still prevails")
    parser.add_argument("--with", metavar="RESULT", dest="result", help="use the numbers of `poppet identify`")
    parser.add_argument("--units", metavar="LIST", help='units of the results: "bar,degC,l/min ANR" or ADDRESS=UNIT')
    parser.add_argument("--select", metavar="LIST", help='series of the results: "tank.*,valve.stroke"')
    parser.add_argument("--quiet", action="store_true", help="print notes and errors only")


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.engine.problem import Outcome
    from poppet.ground.codes import Note

    output, picture = output_path(options.output, RECORDINGS), output_path(options.plot, PICTURES)
    shape = Shape.read(options.select, options.units)
    with Waiting("The model is made ready", is_quiet=options.quiet):
        circuit, notes = _circuit(options)
    _refuse_misfits(circuit, shape)
    failure = ""
    try:
        with Progress(float(circuit.run.grid()[-1]), is_quiet=options.quiet) as progress:
            recording = circuit.simulate(progress=progress)
    except SimulationError as ended:
        recording, failure = ended.recording, str(ended)
    for note in (*notes, *recording.notes):
        print(f"note: {note}", file=sys.stderr)
    _hand_over(recording, shape, output, picture, options)
    if failure:
        error = SimulationError(failure, recording)
        if failure.startswith(str(Note(Outcome.INTERRUPTED.value))):
            error.exit_code = INTERRUPTED
        raise error
    return 0


def _circuit(options: argparse.Namespace) -> tuple[Circuit, list[str]]:
    """The circuit of the file with the changes of the command line, and notes about them."""
    from poppet.circuit.file import load
    from poppet.ground.toml_file import TomlFile

    circuit = load(options.file)
    if options.result:
        from poppet.identify.result import read_result

        result = read_result(options.result)
        circuit = circuit.with_values(result.values())
        doubtful = [f"{name} ({e.verdict})" for name, e in result.parameters.items() if e.verdict in UNTRUSTED]
        if doubtful:
            print(f"note: not to be trusted in {options.result}: {', '.join(doubtful)}.", file=sys.stderr)
    values = assignments(options.values)
    for name, address in _RUN_OPTIONS.items():
        if getattr(options, name) is not None:
            values[address] = value(getattr(options, name))
    if options.stop_when:
        circuit = circuit.with_values({"run.stop_when": [*circuit.run.stop_texts, *options.stop_when]})
    circuit, notes = changed(circuit, values)
    if options.start_from:
        from poppet.series.recording import Recording

        circuit = circuit.resumed(Recording.read(options.start_from)).with_values(values)
    given = {*values, *(["run.stop_when"] if options.stop_when else ())}
    try:
        circuit.problem(circuit.run)  # kept by the circuit for the run itself
    except InputError as error:
        raise (error if error.address in given else TomlFile.read(options.file).located(error)) from None
    return circuit, notes


def _refuse_misfits(circuit: Circuit, shape: Shape) -> None:
    """Refuse a selection or unit that fits no series before the run, not after it."""
    import numpy as np

    from poppet.series.recording import Recording

    outputs = circuit.model.outputs
    names, units = tuple(name for name, _ in outputs), tuple(unit for _, unit in outputs)
    shape.apply(Recording(np.zeros(1), names, units, np.ones((len(names), 1))))


def _hand_over(
    recording: Recording, shape: Shape, output: Path | None, picture: Path | None, options: argparse.Namespace
) -> None:
    """Write and print what was asked for."""
    shown = shape.apply(recording)
    lines = []
    if output is not None:
        shown.save(output)
        lines.append(f"{output}: {extent(shown)}. {recording.outcome}")
    else:
        lines.append(run_summary(shape.apply(readable(recording))))
    if picture is not None and recording.time.size:
        recording.plot(picture, select=shape.patterns or None, units=shape.plot_units([recording]))
        lines.append(f"{picture}: drawn.")
    if not options.quiet:
        print("\n".join(lines))
