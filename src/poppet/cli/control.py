"""Command `poppet control`: controller tuning on the linear model, and comparison of controllers on one plant."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.cli.assignments import load_circuit, read_assignments
from poppet.cli.main import FAILED
from poppet.cli.parser import output_path
from poppet.cli.progress import Spinner
from poppet.cli.summary import print_notes, print_written, require_matplotlib
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.files import write_whole

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit


def execute(options: argparse.Namespace) -> int:
    """Run the command `control tune` or `control compare`, and return the exit code."""
    return _tune(options) if options.action == "tune" else _compare(options)


def _load_circuits(options: argparse.Namespace) -> dict[str, BaseCircuit]:
    """Load the circuits of all files, and return them by file name without suffix."""
    circuits: dict[str, BaseCircuit] = {}
    for path in options.files:
        name = Path(path).stem
        if name in circuits:
            raise InputError("cli.same_name", path=path)
        circuits[name], _ = load_circuit(options, path)
    return circuits


def _tune(options: argparse.Namespace) -> int:
    if len(options.files) > 1:
        raise InputError("cli.one_circuit", path=options.files[1])
    # Checked here and not by the parser: the two actions write different formats.
    output = output_path(options.output, (".toml",)) if options.output else None
    from poppet.control import schedule, tune
    from poppet.report.control_report import file_margin_table, margin_table, verification_table, write_tuning

    (circuit,) = _load_circuits(options).values()
    assigned = read_assignments(options.values)
    # Texts, not numbers: a value without a unit is rejected unless it is dimensionless.
    settings = {"form": options.form, "sensitivity": options.sensitivity, "at": options.at or None}
    # The library has the default values.
    settings = {name: value for name, value in settings.items() if value is not None}
    require_matplotlib(options.plot, options.report)
    with Spinner("The gains are computed", is_quiet=options.quiet) as progress:
        settings |= {"amplitudes": options.amplitude, "progress": progress}
        tuning = (schedule if options.schedule else tune)(circuit, options.controller, **settings)
    file_margins = file_margin_table(tuning, circuit)
    fields = {f"{tuning.controller}.{name}" for name in tuning.fields()}
    own = [address for address in assigned if ".".join(address.split(".")[:2]) in fields]
    # Sines are measured with the gains of the circuit.
    ignored = [Note("tuning.not_used", address) for address in own if file_margins and not tuning.is_verified]
    print_notes((*ignored, *tuning.notes, *tuning.margin_notes(circuit)))
    without = f"{Path(options.files[0]).name} without {tuning.controller}."
    if tuning.is_verified:
        verification = [
            f"Bounded: {tuning.bound_text}, {tuning.command_text}, {without}",
            "",
            verification_table(tuning).text(),
        ]
    else:
        overshoot = 100.0 * max(point.overshoot for point in tuning.points)
        verification = [
            f"Bounded: {tuning.bound_text}, {tuning.command_text}, small steps of {without}",
            f"Overshoot of a small step {overshoot:.2g} %. Limits and dead zones of the valves are not in it.",
        ]
    names = [Path(options.files[0]).name, *(["--with"] if options.result else []), *(["--set"] if own else [])]
    origin = " and ".join(names)
    present = ["", f"With the gains of {origin}:", file_margins.text()] if file_margins else []
    print("\n".join([tuning.text(), margin_table(tuning).text(), *present, "", *verification]))
    if output is not None:
        write_whole(output, lambda stream: stream.write(tuning.text().encode()))
    if options.plot is not None:
        tuning.plot(options.plot)
    if options.report is not None:
        write_tuning(tuning, circuit, options.report, origin=origin)
    print_written(output, options.plot, options.report)
    return 0


def _compare(options: argparse.Namespace) -> int:
    output = output_path(options.output, (".csv",)) if options.output else None
    from poppet.control import compare
    from poppet.core.units import quantity
    from poppet.report.control_report import figure_table, write_comparison

    circuits = _load_circuits(options)
    vary = {
        address: float(quantity(value, "1", name=f"--vary {address}").value)
        for address, value in read_assignments(options.vary, "--vary").items()
    }
    require_matplotlib(options.plot, options.report)
    with Spinner("The controllers are simulated", is_quiet=options.quiet):
        settings = {name: vars(options)[name] for name in ("draws", "seed") if vars(options)[name] is not None}
        comparison = compare(circuits, options.controller, vary=vary, **settings)
    sample = "Nominal parameters only; --vary ADDRESS=RANGE makes them uncertain."
    if comparison.draws:
        sample = f"{comparison.draws} sampled plants, seed {comparison.seed}; the same plants for each controller."
    failures = [f"{name}: {n} runs did not reach their end." for name, n in comparison.failed.items() if n]
    print("\n".join([figure_table(comparison).text(), "", sample, *failures]))
    if output is not None:
        comparison.save(output)
    title = f"{len(circuits)} controllers on one plant"
    if options.plot is not None:
        from poppet.report.control_report import plot_comparison

        plot_comparison(comparison, options.plot, title=title)
    if options.report is not None:
        write_comparison(comparison, options.report, title=title)
    print_written(output, options.plot, options.report)
    # Exit code 1 reports incomplete runs to a script, although the table was written.
    return FAILED if any(comparison.failed.values()) else 0
