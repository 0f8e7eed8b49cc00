"""`poppet bench`: the figures of a pressure valve, of a model or of recordings, after ISO 10094."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.cli.assignments import assignments, changed, listed, with_result
from poppet.cli.main import FAILED, INTERRUPTED
from poppet.cli.parser import QUIET, REPORT, RESULT, SET, VALVE, WITH, Option
from poppet.cli.progress import Naming
from poppet.cli.summary import ask_for_drawing, hand_over
from poppet.core.errors import InputError, OutOfRangeError, collect
from poppet.core.note_groups import grouped

if TYPE_CHECKING:
    from poppet.bench.iso10094.bench_result import BenchResult

EXAMPLES = (
    "poppet bench iso10094 VALVE.toml --valve valve -o RESULT.toml --report REPORT.html",
    "poppet bench iso10094 VALVE.toml --valve valve --set valve.preset=fast --compare RESULT.toml",
    "poppet bench iso10094 --recording MAP.toml --tests step,frequency --report REPORT.html",
)
STANDARDS = {"iso10094": "electro-pneumatic pressure valves (ISO 10094-1, -2)"}
OPTIONS = (
    Option("STANDARD", "", choices=STANDARDS),
    Option("[FILE]", "circuit file with the valve, .toml; or a result to show again"),
    VALVE,
    Option("--recording FILE", "recordings of a real valve instead of a circuit (.toml)"),
    RESULT,
    REPORT,
    Option("--compare FILE", "a result, a circuit or recordings to stand beside it on page and in result"),
    Option("--tests LIST", "some of the tests, step,frequency; all by default"),
    Option("--full-scale RANGE", 'outlet pressure at full setpoint, "6 bar g", or both ends'),
    Option("--supply PRESSURE", "supply pressure; that of the circuit by default"),
    Option("--volume LIST", 'volumes at the outlet, "1 l, 5 l" by default'),
    Option("--rated-flow FLOW", 'flow at which droop and relief are read, "300 l/min ANR"'),
    Option("--sweep-time TIME", "of the setpoint from end to end; by the response by default"),
    Option("--frequencies LIST", 'of the sines, "1 Hz, 2 Hz"; by the response by default'),
    WITH,
    SET,
    QUIET,
)
OF_CIRCUIT = ("valve", "volume", "supply", "sweep_time", "frequencies", "values", "result")
"""Options that recordings have no use for."""


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from dataclasses import replace

    from poppet.bench.iso10094.bench_result import compared

    _refuse_misfits(options)
    ask_for_drawing(options.report)
    # Both are read before either is run: a mistake in the second must not cost a bench of the first.
    run = _prepared(options, Path(options.file or options.recording), options.values, is_other=False)
    run_other = _prepared(options, Path(options.compare), [], is_other=True) if options.compare else None
    with Naming(is_quiet=options.quiet) as naming:
        result = run(naming)
        other = run_other(naming) if run_other and result.outcome != "interrupted" else None
    if other is not None:
        result = replace(result, comparison=compared(result, other))

    def write_page(path: Path) -> None:
        from poppet.report.bench.bench_report import write_bench

        write_bench(result, path, other)

    hand_over(options, result, summary(result), write_page)
    return {"failed": FAILED, "interrupted": INTERRUPTED}.get(result.outcome, 0)


def _refuse_misfits(options: argparse.Namespace) -> None:
    if bool(options.file) == bool(options.recording):
        raise InputError("cli.bench.both" if options.file else "cli.bench.neither")
    if options.recording and not options.compare:  # what stands beside it may be a circuit
        declared = {option.name: option.names[-1] for option in OPTIONS if option.name in OF_CIRCUIT}
        given = [name for name in OF_CIRCUIT if getattr(options, name)]
        collect([InputError("cli.bench.of_circuit", option=declared[name]) for name in given])


def _prepared(
    options: argparse.Namespace, path: Path, values: list[str], *, is_other: bool
) -> Callable[[Any], BenchResult]:
    """What hands over the result of a file: one that was kept, of recordings, or of a circuit yet to be tested."""
    from poppet.bench.iso10094.bench_result import is_result, read_bench_result

    # A result is the only JSON that there can be.
    data = {} if path.suffix.lower() == ".json" else _tables(path)
    is_kept, is_recorded = not data or is_result(data), "recordings" in data or str(path) == options.recording
    if values and (is_kept or is_recorded):
        raise InputError("cli.bench.set_without_circuit", value=values[0], path=str(path))
    if is_kept:
        kept = read_bench_result(path)
        return lambda _: kept
    if is_recorded:
        found = _of_recordings(options, path)
        return lambda _: found
    return _of_circuit(options, path, values, is_other=is_other)


def _tables(path: Path) -> dict[str, Any]:
    """The tables of a TOML file."""
    from poppet.core.toml_file import TomlFile

    file = TomlFile.read(path)
    with file.errors():
        return file.tables


def _of_recordings(options: argparse.Namespace, path: Path) -> BenchResult:
    from poppet.bench.iso10094.run_bench import run_recordings
    from poppet.bench.iso10094.valve_recordings import recorded
    from poppet.core.toml_file import TomlFile

    file = TomlFile.read(path)
    with file.errors():
        found = recorded(file.content, path, full_scale=options.full_scale, rated_flow=_rated_flow(options))
    # Without a wish all that there are recordings of.
    tests = _tests(options) if options.tests else [test for test, records in found.records.items() if records]
    return run_recordings(
        found.title, found.records, found.scale,
        tests=tests, rated_flow=found.rated_flow, notes=found.notes, conditions=found.conditions,
    )  # fmt: skip


def _of_circuit(
    options: argparse.Namespace, path: Path, values: list[str], *, is_other: bool
) -> Callable[[Any], BenchResult]:
    from poppet.bench.iso10094.ranges import pressure, pressure_range
    from poppet.bench.iso10094.rig import rig_of, valve_of
    from poppet.bench.iso10094.run_bench import run_bench
    from poppet.circuit.file import load

    circuit, told = with_result(load(path), None if is_other else options.result)
    circuit, notes = changed(circuit, assignments(values))
    ambient = circuit.surroundings.pressure
    rig = rig_of(
        circuit,
        # What stands beside it may name its valve otherwise.
        valve_of(circuit, None if is_other and options.valve not in circuit.parts else options.valve),
        full_scale=pressure_range(options.full_scale, ambient, "--full-scale") if options.full_scale else None,
        supply=pressure(options.supply, ambient, "--supply") if options.supply else None,
    )
    conditions = {"circuit": str(path), "valve": rig.valve} | ({"changed": list(values)} if values else {})
    rig.title = f"{rig.title}, {', '.join(values)}" if values else rig.title
    given: dict[str, Any] = {"notes": [*told, *notes, *rig.notes], "conditions": conditions}
    settings, tests = _settings(options), _tests(options)
    return lambda say: run_bench(rig, settings, tests, say=say, **given)


def _settings(options: argparse.Namespace) -> Any:
    """Choices of the bench."""
    from poppet.bench.iso10094 import ranges
    from poppet.bench.iso10094.bench_settings import BenchSettings

    given: dict[str, Any] = {"rated_flow": _rated_flow(options)}
    if options.volume:
        given["volumes"] = ranges.listed(options.volume, "m^3", "--volume")
    if options.frequencies:
        given["frequencies"] = ranges.listed(options.frequencies, "Hz", "--frequencies")
    if options.sweep_time:
        # A comma within one number is no list here.
        (given["sweep_time"],) = ranges.listed(options.sweep_time.replace(",", ""), "s", "--sweep-time")
    return BenchSettings(**given)


def _rated_flow(options: argparse.Namespace) -> float:
    from poppet.core.units import quantity

    if not options.rated_flow:
        return math.nan
    value = quantity(options.rated_flow, "kg/s", kind="mass_flow", name="--rated-flow").value
    if not value > 0.0:
        raise OutOfRangeError("cli.bench.rated_flow", flow=options.rated_flow)
    return value


def _tests(options: argparse.Namespace) -> list[str]:
    from poppet.bench.iso10094.definitions import TESTS
    from poppet.bench.iso10094.run_bench import check_tests

    if options.tests is None:
        return list(TESTS)
    tests = listed(options.tests)
    check_tests(tests)
    return list(dict.fromkeys(tests))


def summary(result: BenchResult) -> str:
    """What a person reads in a terminal."""
    lines = [result.title]
    there = result.comparison.get("figures", {})
    # Figures that only the other one has are shown as well, with a dash.
    names = {**result.figures, **there}
    width = max((len(name) for name in names), default=0)
    for name in names:
        figure = result.figures.get(name)
        text = f"{figure.bound} {figure.value:.4g}".strip() if figure else "-"
        if figure is not None and figure.interval is not None:
            half = 0.5 * (figure.interval[1] - figure.interval[0])
            text += f" ± {half:.2g}" if half > 1e-4 * abs(figure.value) else ""
        unit = figure.unit if figure else there[name]["unit"]
        beside = ""
        if there:
            row = there.get(name, {})
            other = f"{row.get('other_bound', '')} {row['other']:.4g}".strip() if "other" in row else "-"
            beside = f"   {other:>16}"
        lines.append(f"  {name:<{width}}  {text:>20}{beside}  {'' if unit == '1' else unit}".rstrip())
    if there:
        lines.insert(1, f"  {'':<{width}}  {'this':>20}   {result.comparison['other'][:16]:>16}")
    lines += [f"- {test}: {sentence}" for test, notes in result.notes.items() for sentence in grouped(notes)]
    lines += [f"- {sentence}" for sentence in grouped(result.comparison.get("notes", []))]
    return "\n".join(lines)
