"""`poppet bench limits`: which part limits a valve, by load volume, amplitude, spring and damping."""

from __future__ import annotations

import argparse
from typing import Any

from poppet.cli.assignments import assignments, changed
from poppet.cli.main import INTERRUPTED
from poppet.cli.output_files import output_path
from poppet.cli.progress import Points

EXAMPLES = (
    "poppet bench limits VALVE.toml --valve valve -o RESULT.toml --report REPORT.html",
    'poppet bench limits VALVE.toml --volumes "0.1 l, 1 l, 10 l" --amplitudes "5 kPa, 50 kPa" --report REPORT.html',
)
RESULTS, PAGES = (".toml", ".json"), (".html",)


def add_options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("file", metavar="FILE", help="circuit file with a proportional_valve and its load (.toml)")
    parser.add_argument("--valve", metavar="NAME", help="its name, where there are several")
    parser.add_argument("-o", "--output", metavar="FILE", help="write the result: .toml or .json")
    parser.add_argument("--report", metavar="FILE", help="write a page for people: .html")
    parser.add_argument(
        "--mean", metavar="PRESSURE", help="pressure about which it works; middle of the span if absent"
    )
    parser.add_argument(
        "--volumes", metavar="LIST", help='outlet volumes: "0.1 l, 1 l"; a tenth to ten times if absent'
    )
    parser.add_argument("--amplitudes", metavar="LIST", help='of the sine: "5 kPa, 50 kPa"; 0.5 to 25 %% of the span')
    parser.add_argument("--springs", metavar="LIST", help='factors on the spring rates: "0.5, 1, 2"')
    parser.add_argument("--dampings", metavar="LIST", help='factors on the damping: "0.25, 0.5, 1, 2, 4"')
    parser.add_argument(
        "--set", action="append", default=[], metavar="ADDRESS=VALUE", dest="values", help="change a number first"
    )
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    output, page = output_path(options.output, RESULTS), output_path(options.report, PAGES)
    from poppet.bench.limits.maps import DONE, find_limits, limits_plan
    from poppet.circuit.file import load

    circuit, _ = changed(load(options.file), assignments(options.values))
    plan = limits_plan(
        circuit, options.valve, mean=options.mean, volumes=_listed(options.volumes),
        amplitudes=_listed(options.amplitudes), springs=_factors(options.springs, "--springs"),
        dampings=_factors(options.dampings, "--dampings"),
    )  # fmt: skip
    with Points(is_quiet=options.quiet) as progress:
        result = find_limits(plan, progress)
    if output:
        result.save(output)
    if page:
        from poppet.report.bench.limits import write_limits

        write_limits(result, page)
    if not options.quiet:
        print(summary(result))
        for path in (output, page):
            if path:
                print(f"{path}: written.")
    return 0 if result.outcome == DONE else INTERRUPTED


def summary(result: Any) -> str:
    """What a person reads in a terminal."""
    from poppet.cli.summary import table

    plan = result.plan
    head = ["-3 dB [Hz]", *(f"{a / 1e3:.3g} kPa" for a in plan.amplitudes)]
    values, parts = result.grid("gain_frequency"), result.grid("limiting")
    rows = [
        [f"{v * 1e3:.3g} l", *(f"{f:.3g} {part}" for f, part in zip(*row, strict=True))]
        for v, *row in zip(plan.volumes, values, parts, strict=True)
    ]
    return "\n".join([table([head, *rows], 1), "", *(f"- {sentence}" for sentence in result.findings)])


def _listed(text: str | None) -> list[str] | None:
    return [part.strip() for part in text.split(",") if part.strip()] if text else None


def _factors(text: str | None, option: str) -> list[float] | None:
    from poppet.ground.errors import InputError

    try:
        return [float(part) for part in _listed(text) or ()] or None
    except ValueError:
        raise InputError(f"{option} {text}", "is no list of factors.", 'Write "0.5, 1, 2".') from None
