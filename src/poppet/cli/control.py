"""`poppet control`: tune a controller on the linear model, compare controllers on one plant."""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.cli.assignments import assignments, changed
from poppet.cli.output_files import PICTURES, output_path, write_text
from poppet.cli.progress import Waiting
from poppet.cli.summary import table
from poppet.ground.errors import InputError, collect

if TYPE_CHECKING:
    from poppet.control import Comparison, Tuning

EXAMPLES = (
    "poppet control tune pressure_control.toml --form pid --sensitivity 1.6",
    'poppet control tune pressure_control.toml --schedule --at "2 bar" --at "5 bar" -o gains.toml',
    'poppet control compare pid.toml linearising.toml --vary tank.volume="20 %" --draws 100 --plot spread.png',
)
ACTIONS = {
    "tune": "gains of a pid on the linear model",
    "compare": "controllers on one plant with uncertain numbers, one circuit file each",
}
OPTIONS_OF = {
    "tune": ("at", "form", "sensitivity", "schedule"),
    "compare": ("vary", "draws", "seed", "plot"),
}
"""Options that only one action has."""
READABLE = {"Pa s": (1e-5, "bar s"), "Pa s^2": (1e-5, "bar s^2"), "1": (1.0, "")}


def add_options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    actions = "; ".join(f"{name}: {what}" for name, what in ACTIONS.items())
    parser.add_argument("action", metavar="ACTION", choices=tuple(ACTIONS), help=actions)
    parser.add_argument("files", metavar="FILE", nargs="+", help="circuit file (.toml); compare: several")
    parser.add_argument("--controller", metavar="NAME", help="which controller, where a circuit has several")
    parser.add_argument(
        "--set", action="append", default=[], metavar="ADDRESS=VALUE", dest="values", help="change a number first"
    )
    parser.add_argument(
        "--at", action="append", metavar="PRESSURE", help="tune: operating point; default the steps of the setpoint"
    )
    parser.add_argument("--form", metavar="FORM", help="tune: pi (default), pid or p")
    parser.add_argument("--sensitivity", type=float, metavar="M", help="tune: bound of Ms and Mt, default 1.4")
    parser.add_argument("--schedule", action="store_true", help="tune: gains for each operating point")
    parser.add_argument(
        "--vary", action="append", metavar="ADDRESS=RANGE", help='compare: uncertain number, tank.volume="20 %%"'
    )
    parser.add_argument("--draws", type=int, metavar="N", help="compare: drawn plants, default 50")
    parser.add_argument("--seed", type=int, metavar="N", help="compare: of the draws, default 0")
    parser.add_argument("--plot", metavar="FILE", help="compare: draw responses and spread")
    parser.add_argument("-o", "--output", metavar="FILE", help="tune: gains, .toml; compare: all figures, .csv")


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    _refuse_unfit(options)
    return _tune(options) if options.action == "tune" else _compare(options)


def _refuse_unfit(options: argparse.Namespace) -> None:
    """Refuse options of the other action."""
    problems = [
        InputError(f"--{name}", f"has no meaning for `control {options.action}`.", f"It is for: {action}.")
        for action, names in OPTIONS_OF.items()
        for name in names
        if action != options.action and getattr(options, name) not in (None, False)
    ]
    if options.action == "tune" and len(options.files) > 1:
        problems.append(InputError(options.files[1], "is one file too many.", "Tune one circuit at a time."))
    collect(problems)


def _loaded(options: argparse.Namespace) -> dict[str, Any]:
    """Circuits by the names of their files."""
    from poppet.circuit.file import load

    values, circuits = assignments(options.values), {}
    for text in options.files:
        name = Path(text).stem
        if name in circuits:
            raise InputError(text, "has the name of another file.", "Rename one of them.")
        circuits[name], _ = changed(load(text), values)
    return circuits


def _tune(options: argparse.Namespace) -> int:
    output = output_path(options.output, (".toml",))
    from poppet.control import schedule, tune

    (circuit,) = _loaded(options).values()
    given = {"form": options.form, "sensitivity": options.sensitivity, "at": options.at}
    chosen = {name: value for name, value in given.items() if value is not None}
    if "at" in chosen:
        chosen["at"] = [assignments([f"at={text}"], "--at")["at"] for text in chosen["at"]]
    with Waiting("Gains are looked for"):
        tuning = (schedule if options.schedule else tune)(circuit, options.controller, **chosen)
    print(_tuning_text(tuning))
    if output is not None:
        write_text(output, tuning.text())
        print(f"{output}: written.")
    return 0


def _tuning_text(tuning: Tuning) -> str:
    rows = [["at", "Ms", "Mt", "gain margin", "phase margin [deg]", "delay margin [s]", "crossover [Hz]"]]
    for point in tuning.points:
        rows += [
            [name, *(f"{value:.4g}" for value in (
                m.sensitivity, m.complementary, m.gain_margin, m.phase_margin, m.delay_margin, m.crossover
            ))]
            for name, m in point.margins.items()
        ]  # fmt: skip
    overshoot = max(point.overshoot for point in tuning.points)
    return "\n".join(
        [
            tuning.text(),
            table(rows, 1),
            "",
            f"Bound of Ms and Mt {tuning.sensitivity:g}; overshoot of a small step {100.0 * overshoot:.2g} %.",
        ]
    )


def _compare(options: argparse.Namespace) -> int:
    output, picture = output_path(options.output, (".csv",)), output_path(options.plot, PICTURES)
    from poppet.control import compare

    circuits = _loaded(options)
    vary = {address: _range(address, text) for address, text in assignments(options.vary or [], "--vary").items()}
    given = {"draws": options.draws, "seed": options.seed}
    with Waiting("Controllers are run"):
        chosen = {name: value for name, value in given.items() if value is not None}
        comparison = compare(circuits, options.controller, vary=vary, **chosen)
    print(_comparison_text(comparison))
    if output is not None:
        comparison.save(output)
    if picture is not None:
        from poppet.report.control_figures import plot_comparison

        plot_comparison(comparison, picture, title=f"{len(circuits)} controllers on one plant")
    for path in (output, picture):
        if path is not None:
            print(f"{path}: written.")
    return 1 if any(comparison.failed.values()) else 0


def _range(address: str, given: float | str) -> float:
    """A relative range, `20 %` or 0.2."""
    from poppet.ground.units import quantity

    return float(quantity(given, "1", name=f"--vary {address}").value)


def _comparison_text(comparison: Comparison) -> str:
    from poppet.control import FIGURES

    heads, factors = [], {}
    for key, figure in FIGURES.items():
        factor, unit = READABLE.get(figure.unit, (1.0, figure.unit))
        heads.append(f"{key.replace('_', ' ')}{f' [{unit}]' if unit else ''}")
        factors[key] = factor
    rows = [["controller", "plant", *heads]]
    kinds = ("nominal", "median", "worst") if comparison.draws else ("nominal",)
    for name, own in comparison.summary().items():
        rows += [
            [name if k == 0 else "", kind, *(_shown(own[key][k] * factors[key]) for key in FIGURES)]
            for k, kind in enumerate(kinds)
        ]
    return "\n".join([table(rows, 2), "", _extent(comparison), *_failures(comparison.failed)])


def _shown(value: float) -> str:
    return "never" if value == float("inf") else f"{value:.4g}"


def _extent(comparison: Comparison) -> str:
    if not comparison.draws:
        return "Nominal numbers only; --vary ADDRESS=RANGE makes them uncertain."
    return f"{comparison.draws} plants drawn, seed {comparison.seed}; each controller met the same ones."


def _failures(failed: Mapping[str, int]) -> list[str]:
    return [f"{name}: {count} runs did not reach their end." for name, count in failed.items() if count]
