"""`poppet bench limits`: which part limits a valve, by load volume, amplitude, spring and damping."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from poppet.cli.assignments import listed, loaded
from poppet.cli.main import INTERRUPTED
from poppet.cli.parser import QUIET, REPORT, RESULT, SET, VALVE, WITH, Option
from poppet.cli.progress import Points
from poppet.cli.summary import ask_for_drawing, hand_over
from poppet.core.errors import InputError
from poppet.core.number_format import aligned

EXAMPLES = (
    "poppet bench limits VALVE.toml --valve valve -o RESULT.toml --report REPORT.html",
    'poppet bench limits VALVE.toml --volumes "0.1 l, 1 l, 10 l" --amplitudes "5 kPa, 50 kPa" --report REPORT.html',
)
OPTIONS = (
    Option("FILE", "circuit file with a proportional_valve and its load (.toml)"),
    VALVE,
    RESULT,
    REPORT,
    Option("--mean PRESSURE", "pressure about which it works; middle of the span if absent"),
    Option("--volumes LIST", 'outlet volumes: "0.1 l, 1 l"; a tenth to ten times if absent'),
    Option("--amplitudes LIST", 'of the sine: "5 kPa, 50 kPa"; 0.5 to 25 % of the span'),
    Option("--springs LIST", 'factors on the spring rates: "0.5, 1, 2"'),
    Option("--dampings LIST", 'factors on the damping: "0.25, 0.5, 1, 2, 4"'),
    WITH,
    SET,
    QUIET,
)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.bench.limits.maps import DONE, find_limits, limits_plan

    circuit, _ = loaded(options)
    # Read and refused before anything runs: the maps take minutes.
    plan = limits_plan(
        circuit, options.valve, mean=options.mean, volumes=listed(options.volumes) or None,
        amplitudes=listed(options.amplitudes) or None, springs=_factors(options.springs, "--springs"),
        dampings=_factors(options.dampings, "--dampings"),
    )  # fmt: skip
    ask_for_drawing(options.report)
    with Points(is_quiet=options.quiet) as progress:
        result = find_limits(plan, progress)

    def write_page(path: Path) -> None:
        from poppet.report.bench.limits_report import write_limits

        write_limits(result, path)

    hand_over(options, result, summary(result), write_page)
    return 0 if result.outcome == DONE else INTERRUPTED


def summary(result: Any) -> str:
    """What a person reads in a terminal."""
    plan = result.plan
    head = ["-3 dB [Hz]", *(f"{a / 1e3:.3g} kPa" for a in plan.amplitudes)]
    values, parts = result.grid("gain_frequency"), result.grid("limiting")
    rows = [
        [f"{v * 1e3:.3g} l", *(f"{f:.3g} {part}" for f, part in zip(*row, strict=True))]
        for v, *row in zip(plan.volumes, values, parts, strict=True)
    ]
    table = aligned([head, *rows], range(1, len(head)))
    return "\n".join([table, "", *(f"- {finding}" for finding in result.findings)])


def _factors(text: str | None, option: str) -> list[float] | None:
    try:
        return [float(part) for part in listed(text)] or None
    except ValueError:
        raise InputError("cli.factors", option=option, text=text) from None
