"""Commands `poppet simulate`, `plot` and `linearise`: runs, curves of recordings, and linear models."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from poppet.cli.assignments import (
    OutputSelection,
    load_circuit,
    read_assignments,
    read_value,
)
from poppet.cli.commands import PICTURES
from poppet.cli.main import INTERRUPTED
from poppet.cli.parser import output_path
from poppet.cli.progress import RunProgress, Spinner
from poppet.cli.summary import (
    extent,
    in_usual_units,
    load_summary,
    print_notes,
    print_written,
    require_matplotlib,
    run_summary,
)
from poppet.core.errors import InputError, SimulationError
from poppet.core.note_groups import grouped
from poppet.core.number_format import aligned

ZERO = 1e-12
"""Magnitude up to which an eigenvalue of a sampled model counts as zero."""
_RUN_OPTIONS = {
    "duration": "run.duration",
    "output_step": "run.output_step",
    "tolerance": "run.relative_tolerance",
    "solver": "run.solver",
}


def execute(options: argparse.Namespace) -> int:
    """Run the command `simulate`, print or write the recording, and return the exit code."""
    import numpy as np

    from poppet.circuit.file import load
    from poppet.core.toml_file import TomlFile
    from poppet.identify.parameter_file import change_circuit
    from poppet.timeseries.recording import Recording

    selection = OutputSelection.read(options.select, options.units)
    require_matplotlib(options.plot, options.diagram, options.report)
    with Spinner("The model is prepared", is_quiet=options.quiet):
        circuit, values = load(options.file), read_assignments(options.values)
        for name, address in _RUN_OPTIONS.items():
            if getattr(options, name) is not None:
                values[address] = read_value(getattr(options, name))
        # Before `--set`, which may replace all conditions.
        if options.stop_when:
            circuit = circuit.with_values({"run.stop_when": [*circuit.run.stop_texts, *options.stop_when]})
        circuit, notes = change_circuit(circuit, values, options.result)
        if options.start_from:
            # The values are applied again: they override the state at the end of the recording.
            circuit = circuit.resumed(Recording.read(options.start_from)).with_values(values)
        try:
            problem = circuit.run_data(circuit.run)
        except InputError as error:
            if error.address in values or (options.stop_when and error.address == "run.stop_when"):
                raise
            raise TomlFile.read(options.file).located(error) from None
    if options.diagram:
        from poppet.report.step_diagram import draw_step_diagram, find_sequence

        find_sequence(circuit)
    # A selection or unit that matches no output is rejected before the run.
    names, units = zip(*circuit.model.outputs, strict=True)
    selection.apply(Recording(np.zeros(1), names, units, np.ones((len(names), 1))))
    failure = None
    with RunProgress(float(problem.grid[-1]), is_quiet=options.quiet) as progress:
        try:
            recording = circuit.simulate(progress=progress, allow_native=options.allow_native)
        except SimulationError as error:
            failure, recording = error, error.recording
    print_notes([*notes, *recording.remarks])
    selected = selection.apply(recording)
    if options.output and not selected.time.size:
        text = f"{options.output}: not written, there are no rows. {recording.outcome}"
    elif options.output:
        selected.save(options.output)
        text = f"{options.output}: {extent(selected)}. {recording.outcome}"
        text += f"\n\n{load_summary(recording)}\n" if recording.figures else ""
    else:
        text = run_summary(selection.apply(in_usual_units(recording)), is_complete=bool(options.select or options.all))
    plot_settings: dict[str, Any] = {"select": selection.patterns or None, "units": selection.plot_units([recording])}
    plot_settings["inner"] = options.all
    if options.plot and recording.time.size:
        recording.plot(options.plot, **plot_settings)
        text += f"\n{options.plot}: drawn."
    if options.diagram and recording.time.size:
        draw_step_diagram(circuit, recording, options.diagram)
        text += f"\n{options.diagram}: drawn."
    if options.report:
        from poppet.report.run_report import write_run

        write_run(circuit, recording, options.report, **plot_settings)
        text += f"\n{options.report}: written."
    print(text)
    if failure is not None:
        if failure.note.code == "run.ended.interrupted":
            failure.exit_code = INTERRUPTED  # as shells expect after Ctrl-C
        raise failure
    return 0


def plot_files(options: argparse.Namespace) -> None:
    """Run the command `plot`: plot the recordings of several files in common axes."""
    from poppet.parts import KINDS
    from poppet.timeseries.plotting.plots import plot_recordings
    from poppet.timeseries.recording import Recording

    paths = options.recordings
    output = options.output or output_path(f"{Path(paths[0]).stem}.png", PICTURES)
    selection = OutputSelection.read(options.select, options.units)

    # A CSV file has names only: the parts declare their internal outputs.
    internal = {name for kind in KINDS.values() for name in kind.internal_outputs}
    recordings = []
    for recording in map(Recording.read, paths):
        if not recording.inner:
            inner = frozenset(name for name in recording.names if name.rpartition(".")[2] in internal)
            recording = Recording(**(recording.fields() | {"inner": inner}))
        recordings.append(recording)
    # Labels are the file names without suffix, or the paths if these are not unique; a repeated path gets a number.
    stems = [Path(path).stem for path in paths]
    labels = stems if len(set(stems)) == len(stems) else list(paths)
    labels = [label if labels.count(label) == 1 else f"{label} ({k})" for k, label in enumerate(labels, 1)]
    plot_recordings(
        dict(zip(labels, recordings, strict=True)),
        output,
        select=selection.patterns or None,
        units=selection.plot_units(recordings),
        inner=options.all,
    )
    print(f"{output}: {len(labels)} {'recordings' if len(labels) > 1 else 'recording'} drawn.")


def linearise_file(options: argparse.Namespace) -> None:
    """Run the command `linearise`: print the linear model of a circuit, or also write it to a file."""
    from poppet.report.result_tables import mode_table
    from poppet.timeseries.recording import Recording

    circuit, _ = load_circuit(options)
    inputs = read_assignments(options.inputs, "--set-input")
    recording = Recording.read(options.at) if options.at else None
    with Spinner("The operating point is computed", is_quiet=options.quiet):
        linear = circuit.linearise(inputs or None, at=recording)
    # A sampled model lists the discrete states as well.
    units = {state.name: state.unit for state in circuit.model.states} | dict(circuit.model.memory)
    sample_time = getattr(linear, "sample_time", 0.0)
    names_by_kind = {"state": linear.states, "input": linear.inputs, "output": linear.outputs}
    counts = ", ".join(f"{len(names)} {kind}{'s' * (len(names) != 1)}" for kind, names in names_by_kind.items())
    point = [
        ["state or discrete state" if sample_time else "state", "unit", "value"],
        *([name, units.get(name, ""), f"{value:.6g}"] for name, value in zip(linear.states, linear.x, strict=True)),
    ]
    head = f"Linear model over samples of {sample_time:.6g} s: {counts}" if sample_time else f"Linear model: {counts}"
    texts = [head, aligned(point, [2]), mode_table(linear).text()]
    if sample_time:
        eigenvalues = [complex(z) for z in linear.eigenvalues()]
        nonzero = [z for z in eigenvalues if abs(z) > ZERO and z.imag >= 0.0]
        n_zero = sum(abs(z) <= ZERO for z in eigenvalues)
        parts = [f"{z.real:.6g}" if z.imag == 0.0 else f"{z.real:.6g} +- {z.imag:.6g}i" for z in nonzero]
        parts += [f"{n_zero} times 0 (recomputed in every sample)"] if n_zero else []
        texts += [
            f"Eigenvalues over a sample: {', '.join(parts)}",
            "\n".join(f"- {n}" for n in grouped(getattr(linear, "notes", ()))),
        ]
    print("\n\n".join(text for text in texts if text))
    if options.output:
        linear.save(options.output)
    print_written(options.output)
