"""`poppet simulate`: run a circuit file."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Any

from poppet.cli.assignments import Shape, assignments, changed, value, with_result
from poppet.cli.main import INTERRUPTED
from poppet.cli.parser import ALL, FILE, PICTURES, RECORDINGS, REPORT, SELECT, SET, UNITS, WITH, Option
from poppet.cli.progress import Progress, Waiting
from poppet.cli.summary import ask_for_drawing, extent, first_asked, readable, run_summary
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.core.note_groups import grouped

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit
    from poppet.engine.model import Model
    from poppet.timeseries.recording import Recording

EXAMPLES = (
    "poppet simulate valve-fill.toml",
    'poppet simulate valve-fill.toml --set tank.volume="0.1 m^3" -o fill.csv --plot fill.png',
    'poppet simulate valve-fill.toml --stop-when "tank.pressure > 2 bar" --units "bar,degC,l/min ANR"',
)
OPTIONS = (
    FILE,
    WITH,
    SET,
    Option("-o, --output FILE", "write the recording", RECORDINGS),
    Option("--plot FILE", "draw the recording", PICTURES),
    REPORT,
    Option("--duration TIME", 'length of the run, "60 s"'),
    Option("--output-step TIME", 'time between rows, "10 ms"'),
    Option("--tolerance NUMBER", "relative tolerance, 1e-6 by default"),
    Option("--stop-when CONDITION ...", 'end early, "tank.pressure > 5 bar"; adds to the conditions of the file'),
    Option("--solver NAME", "rosenbrock (default); for a check cvodes, lsoda, bdf, radau"),
    Option("--start-from RECORDING", "start where a recording ends; --set still prevails"),
    UNITS,
    SELECT,
    ALL,
    Option("--quiet", "print notes and errors only"),
)
_RUN_OPTIONS = {
    "duration": "run.duration",
    "output_step": "run.output_step",
    "tolerance": "run.relative_tolerance",
    "solver": "run.solver",
}


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    shape = Shape.read(options.select, options.units)
    ask_for_drawing(options.plot, options.report)
    with Waiting("The model is made ready", is_quiet=options.quiet):
        circuit, given, notes = _circuit(options)
        try:
            problem = circuit.problem(circuit.run)
        except InputError as error:
            raise _placed(error, given, options.file) from None
    _refuse_misfits(circuit.model, shape)
    failure = None
    with Progress(float(problem.grid[-1]), is_quiet=options.quiet) as progress:
        try:
            recording = circuit.simulate(progress=progress)
        except SimulationError as error:
            failure, recording = error, error.recording
    for note in grouped((*notes, *recording.remarks)):
        print(f"note: {note}", file=sys.stderr)
    _hand_over(recording, shape, options, circuit)
    if failure is not None:
        if failure.note.code == "run.ended.interrupted":
            failure.exit_code = INTERRUPTED
        raise failure
    return 0


def _circuit(options: argparse.Namespace) -> tuple[Circuit, set[str], list[Note]]:
    """The circuit with the changes of the command line, what these are, and notes about them."""
    from poppet.circuit.file import load

    circuit, notes = with_result(load(options.file), options.result)
    values = assignments(options.values)
    for name, address in _RUN_OPTIONS.items():
        if getattr(options, name) is not None:
            values[address] = value(getattr(options, name))
    # Added before `--set`, which may replace them all.
    if options.stop_when:
        circuit = circuit.with_values({"run.stop_when": [*circuit.run.stop_texts, *options.stop_when]})
    circuit, about = changed(circuit, values)
    if options.start_from:
        from poppet.timeseries.recording import Recording

        # The values once more: where the recording ends does not count for what is given here.
        circuit = circuit.resumed(Recording.read(options.start_from)).with_values(values)
    return circuit, {*values, *(["run.stop_when"] if options.stop_when else ())}, notes + about


def _placed(error: InputError, given: set[str], file: str) -> InputError:
    """A mistake with its line in the file, unless it was typed on the command line."""
    from poppet.core.toml_file import TomlFile

    return error if error.address in given else TomlFile.read(file).located(error)


def _refuse_misfits(model: Model, shape: Shape) -> None:
    """Refuse a selection or unit that fits no series before the run, not after it."""
    import numpy as np

    from poppet.timeseries.recording import Recording

    names, units = zip(*model.outputs, strict=True)
    shape.apply(Recording(np.zeros(1), names, units, np.ones((len(names), 1))))


def _hand_over(recording: Recording, shape: Shape, options: argparse.Namespace, circuit: Circuit) -> None:
    """Write and print what was asked for."""
    shown = shape.apply(recording)
    if options.output and not shown.time.size:
        text = f"{options.output}: not written, there are no rows. {recording.outcome}"
    elif options.output:
        shown.save(options.output)
        text = f"{options.output}: {extent(shown)}. {recording.outcome}"
        text += f"\n\n{first_asked(recording)}\n" if recording.figures else ""
    else:
        text = run_summary(shape.apply(readable(recording)))
    drawing: dict[str, Any] = {"select": shape.patterns or None, "units": shape.plot_units([recording])}
    drawing["inner"] = options.all
    if options.plot and recording.time.size:
        recording.plot(options.plot, **drawing)
        text += f"\n{options.plot}: drawn."
    if options.report:
        from poppet.report.run_report import write_run

        write_run(circuit, recording, options.report, **drawing)
        text += f"\n{options.report}: written."
    if not options.quiet:
        print(text)
