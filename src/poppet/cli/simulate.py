"""Command `poppet simulate`: simulation of a circuit file."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from poppet.cli.assignments import OutputSelection, change_circuit, read_assignments, read_value, with_result
from poppet.cli.main import INTERRUPTED
from poppet.cli.progress import RunProgress, Spinner
from poppet.cli.summary import extent, in_usual_units, load_summary, print_notes, require_matplotlib, run_summary
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit
    from poppet.timeseries.recording import Recording

_RUN_OPTIONS = {
    "duration": "run.duration",
    "output_step": "run.output_step",
    "tolerance": "run.relative_tolerance",
    "solver": "run.solver",
}


def execute(options: argparse.Namespace) -> int:
    """Simulate a circuit file, and print or write the recording."""
    import numpy as np

    from poppet.core.toml_file import TomlFile
    from poppet.timeseries.recording import Recording

    selection = OutputSelection.read(options.select, options.units)
    require_matplotlib(options.plot, options.report)
    with Spinner("The model is prepared", is_quiet=options.quiet):
        circuit, changed_addresses, notes = _load_changed(options)
        try:
            problem = circuit.problem(circuit.run)
        except InputError as error:
            if error.address in changed_addresses:
                raise
            raise TomlFile.read(options.file).located(error) from None
    # A selection or unit that matches no output is rejected before the run.
    names, units = zip(*circuit.model.outputs, strict=True)
    selection.apply(Recording(np.zeros(1), names, units, np.ones((len(names), 1))))
    failure = None
    with RunProgress(float(problem.grid[-1]), is_quiet=options.quiet) as progress:
        try:
            recording = circuit.simulate(progress=progress)
        except SimulationError as error:
            failure, recording = error, error.recording
    print_notes([*notes, *recording.remarks])
    _write(recording, selection, options, circuit)
    if failure is not None:
        if failure.note.code == "run.ended.interrupted":
            failure.exit_code = INTERRUPTED  # as shells expect after Ctrl-C
        raise failure
    return 0


def _load_changed(options: argparse.Namespace) -> tuple[BaseCircuit, set[str], list[Note]]:
    """Load a circuit, and apply the changes of the command line.

    The results are the circuit, the addresses of the changed values, and notes.
    """
    from poppet.circuit.file import load

    circuit, result_notes = with_result(load(options.file), options.result)
    values = read_assignments(options.values)
    for name, address in _RUN_OPTIONS.items():
        if getattr(options, name) is not None:
            values[address] = read_value(getattr(options, name))
    # Before `--set`, which may replace all conditions.
    if options.stop_when:
        circuit = circuit.with_values({"run.stop_when": [*circuit.run.stop_texts, *options.stop_when]})
    circuit, change_notes = change_circuit(circuit, values)
    if options.start_from:
        from poppet.timeseries.recording import Recording

        # The values are applied again: they override the state at the end of the recording.
        circuit = circuit.resumed(Recording.read(options.start_from)).with_values(values)
    return circuit, {*values, *(["run.stop_when"] if options.stop_when else ())}, result_notes + change_notes


def _write(recording: Recording, selection: OutputSelection, options: argparse.Namespace, circuit: BaseCircuit) -> None:
    """Write the output files that the options specify, and print the summary of the run."""
    selected = selection.apply(recording)
    if options.output and not selected.time.size:
        text = f"{options.output}: not written, there are no rows. {recording.outcome}"
    elif options.output:
        selected.save(options.output)
        text = f"{options.output}: {extent(selected)}. {recording.outcome}"
        text += f"\n\n{load_summary(recording)}\n" if recording.figures else ""
    else:
        text = run_summary(selection.apply(in_usual_units(recording)))
    plot_settings: dict[str, Any] = {"select": selection.patterns or None, "units": selection.plot_units([recording])}
    plot_settings["inner"] = options.all
    if options.plot and recording.time.size:
        recording.plot(options.plot, **plot_settings)
        text += f"\n{options.plot}: drawn."
    if options.report:
        from poppet.report.run_report import write_run

        write_run(circuit, recording, options.report, **plot_settings)
        text += f"\n{options.report}: written."
    print(text)
