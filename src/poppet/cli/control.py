"""`poppet control`: tune a controller on the linear model, compare controllers on one plant."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.cli.assignments import assignments, loaded, value
from poppet.cli.main import FAILED
from poppet.cli.parser import PICTURES, REPORT, SET, WITH, Option, output_path, tell_written
from poppet.cli.progress import Waiting
from poppet.cli.summary import ask_for_drawing
from poppet.core.errors import InputError
from poppet.core.files import write_whole
from poppet.core.note_groups import grouped

if TYPE_CHECKING:
    from poppet.control import Comparison, Tuning

EXAMPLES = (
    "poppet control tune pressure_control.toml --form pid --sensitivity 1.6",
    'poppet control tune pressure_control.toml --schedule --at "2 bar" --at "5 bar" -o gains.toml',
    'poppet control tune muscle_joint.toml --form pid --at "25 deg" --amplitude "20 N" --amplitude "100 N"',
    'poppet control compare pid.toml linearising.toml --vary tank.volume="20 %" --draws 100 --plot spread.png',
)
ACTIONS = {
    "tune": "gains of a pid on the linear model, or on answers to sines",
    "compare": "controllers on one plant with uncertain numbers, one circuit file each",
}
OPTIONS = (
    Option("ACTION", "", choices=ACTIONS),
    Option("FILE ...", "circuit file (.toml); compare: several"),
    Option("--controller NAME", "which controller, where a circuit has several"),
    WITH,
    SET,
    Option("--at VALUE ...", "operating point; default the steps of the setpoint", only=["tune"]),
    Option("--form FORM", "pi (default), pid or p", only=["tune"]),
    Option("--sensitivity M", "bound of Ms and Mt, default 1.4", only=["tune"], more={"type": float}),
    Option("--amplitude VALUE ...", "size of a sine of the command: tune on the answers to it", only=["tune"]),
    Option("--schedule", "gains for each operating point", only=["tune"]),
    Option("--vary ADDRESS=RANGE ...", 'uncertain number, tank.volume="20 %"', only=["compare"]),
    Option("--draws N", "drawn plants, default 50", only=["compare"], more={"type": int}),
    Option("--seed N", "of the draws, default 0", only=["compare"], more={"type": int}),
    Option("--plot FILE", "draw responses and spread", PICTURES, only=["compare"]),
    REPORT,
    Option("-o, --output FILE", "tune: gains, .toml; compare: all figures, .csv"),
)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    return _tune(options) if options.action == "tune" else _compare(options)


def _loaded(options: argparse.Namespace) -> dict[str, Any]:
    """Circuits by the names of their files."""
    circuits = {}
    for text in options.files:
        name = Path(text).stem
        if name in circuits:
            raise InputError("cli.same_name", path=text)
        circuits[name], _ = loaded(options, text)
    return circuits


def _tune(options: argparse.Namespace) -> int:
    if len(options.files) > 1:
        raise InputError("cli.one_circuit", path=options.files[1])
    # Here and not in the declaration: the two actions write different formats.
    output = output_path(options.output, (".toml",)) if options.output else None
    from poppet.control import schedule, tune

    (circuit,) = _loaded(options).values()
    given = {"form": options.form, "sensitivity": options.sensitivity, "at": [*map(value, options.at)] or None}
    # Defaults stand in the library, once.
    chosen = {name: number for name, number in given.items() if number is not None}
    ask_for_drawing(options.report)
    with Waiting("Gains are looked for") as told:
        chosen |= {"amplitudes": [*map(value, options.amplitude)], "progress": told}
        tuning = (schedule if options.schedule else tune)(circuit, options.controller, **chosen)
    for note in grouped(tuning.notes):
        print(f"note: {note}", file=sys.stderr)
    print(_tuning_text(tuning, Path(options.files[0]).name))
    if output is not None:
        write_whole(output, lambda stream: stream.write(tuning.text().encode()))
    if options.report is not None:
        from poppet.report.control_report import write_tuning

        write_tuning(tuning, circuit, options.report)
    tell_written(output, options.report)
    return 0


def _tuning_text(tuning: Tuning, file: str) -> str:
    from poppet.report.control_report import margin_table, verification_table

    bounded = f"Bounded: {tuning.bounded}, {tuning.held}"
    if tuning.is_verified:
        last = [f"{bounded}, {file} without {tuning.controller}.", "", verification_table(tuning).text()]
    else:
        overshoot = 100.0 * max(point.overshoot for point in tuning.points)
        last = [
            f"{bounded}, small steps of {file} without {tuning.controller}.",
            f"Overshoot of a small step {overshoot:.2g} %. Limits and dead zones of the valves are not in it.",
        ]
    return "\n".join([tuning.text(), margin_table(tuning).text(), "", *last])


def _compare(options: argparse.Namespace) -> int:
    output = output_path(options.output, (".csv",)) if options.output else None
    from poppet.control import compare
    from poppet.core.units import quantity

    circuits = _loaded(options)
    vary = {
        address: float(quantity(given, "1", name=f"--vary {address}").value)
        for address, given in assignments(options.vary, "--vary").items()
    }
    given = {"draws": options.draws, "seed": options.seed}
    ask_for_drawing(options.plot, options.report)
    with Waiting("Controllers are run"):
        chosen = {name: value for name, value in given.items() if value is not None}
        comparison = compare(circuits, options.controller, vary=vary, **chosen)
    print(_comparison_text(comparison))
    if output is not None:
        comparison.save(output)
    title = f"{len(circuits)} controllers on one plant"
    if options.plot is not None:
        from poppet.report.control_figures import plot_comparison

        plot_comparison(comparison, options.plot, title=title)
    if options.report is not None:
        from poppet.report.control_report import write_comparison

        write_comparison(comparison, options.report, title=title)
    tell_written(output, options.plot, options.report)
    # A script has to learn of runs that broke off, though the table is there.
    return FAILED if any(comparison.failed.values()) else 0


def _comparison_text(comparison: Comparison) -> str:
    from poppet.report.control_report import figure_table

    extent = "Nominal numbers only; --vary ADDRESS=RANGE makes them uncertain."
    if comparison.draws:
        extent = f"{comparison.draws} plants drawn, seed {comparison.seed}; each controller met the same ones."
    failures = [f"{name}: {n} runs did not reach their end." for name, n in comparison.failed.items() if n]
    return "\n".join([figure_table(comparison).text(), "", extent, *failures])
