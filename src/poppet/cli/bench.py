"""Commands `poppet bench` and `poppet bench limits`.

They determine the characteristic values and the dynamic limits of a pressure valve.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.cli.assignments import load_circuit, read_assignments, split_list
from poppet.cli.commands import COMMANDS
from poppet.cli.main import FAILED, INTERRUPTED
from poppet.cli.progress import BenchProgress, PointProgress
from poppet.cli.summary import require_matplotlib, write_result
from poppet.core.errors import InputError, raise_errors
from poppet.core.note_groups import grouped
from poppet.core.number_format import aligned

if TYPE_CHECKING:
    from poppet.bench.iso10094.bench_result import BenchResult

CIRCUIT_OPTIONS = ("valve", "volume", "supply", "sweep_time", "frequencies", "values", "result")
"""Options that apply only to a circuit: they have no effect if recordings are evaluated."""


def run_bench_command(options: argparse.Namespace) -> int:
    """Run the command `bench`: determine the characteristic values of a valve.

    The input is a circuit file, a file of recordings or a result file. The result is the exit code.
    """
    from dataclasses import replace

    from poppet.bench.iso10094.bench_result import compare_bench_results

    if bool(options.file) == bool(options.recording):
        raise InputError("cli.bench.both" if options.file else "cli.bench.neither")
    if options.recording and not options.compare:  # the comparison may be a circuit
        declared = {option.name: option for option in COMMANDS["bench"].options if option.name in CIRCUIT_OPTIONS}
        unused = [option.names[-1] for name, option in declared.items() if getattr(options, name)]
        raise_errors([InputError("cli.bench.of_circuit", option=name) for name in unused])
    require_matplotlib(options.report)
    # Both files are read before the first run: an error in the second must not cost a bench of the first.
    run = _result_provider(options, Path(options.file or options.recording), options.values, is_comparison=False)
    run_comparison = (
        _result_provider(options, Path(options.compare), [], is_comparison=True) if options.compare else lambda _: None
    )
    with BenchProgress(is_quiet=options.quiet) as progress:
        result = run(progress)
        comparison = run_comparison(progress) if result.outcome != "interrupted" else None
    if comparison is not None:
        result = replace(result, comparison=compare_bench_results(result, comparison))

    def write_report(path: Path) -> None:
        from poppet.report.bench.bench_report import write_bench

        write_bench(result, path, comparison)

    write_result(options, result, bench_summary(result), write_report)
    return {"failed": FAILED, "interrupted": INTERRUPTED}.get(result.outcome, 0)


def _result_provider(
    options: argparse.Namespace, path: Path, values: list[str], *, is_comparison: bool
) -> Callable[[BenchProgress], BenchResult]:
    """Return a function that returns the bench result for a file; its argument shows the progress.

    The file at `path` can be a result file, a list of recordings, or a circuit, on which the function runs the tests.
    `values` are texts ADDRESS=VALUE with changed parameters of the circuit.
    """
    from poppet.bench.iso10094.bench_result import is_result, read_bench_result
    from poppet.bench.iso10094.run_bench import run_recordings
    from poppet.bench.iso10094.valve_recordings import read_valve_recordings
    from poppet.core.toml_file import TomlFile

    tables: dict[str, Any] = {}
    if path.suffix.lower() != ".json":  # a JSON file can only be a result
        file = TomlFile.read(path)
        with file.errors():
            tables = file.tables
    is_stored, is_recorded = not tables or is_result(tables), "recordings" in tables or str(path) == options.recording
    if values and (is_stored or is_recorded):
        raise InputError("cli.bench.set_without_circuit", value=values[0], path=str(path))
    if is_stored:
        result = read_bench_result(path)
    elif is_recorded:
        with file.errors():
            valve = read_valve_recordings(
                file.content, path, full_scale=options.full_scale, rated_flow=_rated_flow(options)
            )
        # Default: all tests with recordings.
        tests = _tests(options) if options.tests else [test for test, records in valve.records.items() if records]
        result = run_recordings(
            valve.title, valve.records, valve.scale, tests=tests, rated_flow=valve.rated_flow, notes=valve.notes,
            conditions=valve.conditions,
        )  # fmt: skip
    else:
        return _prepare_circuit(options, path, values, is_comparison=is_comparison)
    return lambda _: result


def _prepare_circuit(
    options: argparse.Namespace, path: Path, values: list[str], *, is_comparison: bool
) -> Callable[[BenchProgress], BenchResult]:
    from poppet.bench.iso10094.evaluation import BenchSettings
    from poppet.bench.iso10094.rig import build_rig, find_valve
    from poppet.bench.iso10094.run_bench import run_bench
    from poppet.bench.iso10094.scale import read_pressure, read_pressure_range, read_quantity_list
    from poppet.circuit.file import load
    from poppet.identify.parameter_file import change_circuit

    identified = None if is_comparison else options.result
    circuit, notes = change_circuit(load(path), read_assignments(values), identified)
    ambient = circuit.surroundings.pressure
    rig = build_rig(
        circuit,
        # The valve of a comparison may have another name.
        find_valve(circuit, None if is_comparison and options.valve not in circuit.parts else options.valve),
        full_scale=read_pressure_range(options.full_scale, ambient, "--full-scale") if options.full_scale else None,
        supply=read_pressure(options.supply, ambient, "--supply") if options.supply else None,
    )
    conditions = {"circuit": str(path), "valve": rig.valve} | ({"changed": list(values)} if values else {})
    rig.title = f"{rig.title}, {', '.join(values)}" if values else rig.title
    notes += rig.notes
    fields: dict[str, Any] = {"rated_flow": _rated_flow(options)}
    if options.volume:
        fields["volumes"] = read_quantity_list(options.volume, "m^3", "--volume")
    if options.frequencies:
        fields["frequencies"] = read_quantity_list(options.frequencies, "Hz", "--frequencies")
    if options.sweep_time:
        # One value: a comma does not separate values here.
        (fields["sweep_time"],) = read_quantity_list(options.sweep_time.replace(",", ""), "s", "--sweep-time")
    settings, tests = BenchSettings(**fields), _tests(options)
    return lambda progress: run_bench(rig, settings, tests, say=progress, notes=notes, conditions=conditions)


def _rated_flow(options: argparse.Namespace) -> float:
    from poppet.core.tables import Field

    if not options.rated_flow:
        return math.nan
    field = Field(unit="kg/s", kind="mass_flow", above=0.0, meaning="rated flow")
    return float(field.read(options.rated_flow, "--rated-flow"))


def _tests(options: argparse.Namespace) -> list[str]:
    from poppet.bench.iso10094.bench_result import TESTS
    from poppet.bench.iso10094.run_bench import check_tests

    if options.tests is None:
        return list(TESTS)
    tests = split_list(options.tests)
    check_tests(tests)
    return list(dict.fromkeys(tests))


def bench_summary(result: BenchResult) -> str:
    """Return a bench result as text for a terminal.

    The text contains the characteristic values and the notes. If `result` contains a comparison with another result, a
    second column contains the values of the other result.
    """
    lines = [result.title]
    compared_rows = result.comparison.get("figures", {})
    # A characteristic value of the comparison alone has a dash in the first column.
    names = {**result.figures, **compared_rows}
    width = max((len(name) for name in names), default=0)
    for name in names:
        figure = result.figures.get(name)
        text = f"{figure.bound} {figure.value:.4g}".strip() if figure else "-"
        if figure is not None and figure.interval is not None:
            half_width = 0.5 * (figure.interval[1] - figure.interval[0])
            text += f" ± {half_width:.2g}" if half_width > 1e-4 * abs(figure.value) else ""
        unit = figure.unit if figure else compared_rows[name]["unit"]
        second_column = ""
        if compared_rows:
            row = compared_rows.get(name, {})
            value = f"{row.get('other_bound', '')} {row['other']:.4g}".strip() if "other" in row else "-"
            second_column = f"   {value:>16}"
        lines.append(f"  {name:<{width}}  {text:>20}{second_column}  {'' if unit == '1' else unit}".rstrip())
    if compared_rows:
        lines.insert(1, f"  {'':<{width}}  {'this':>20}   {result.comparison['other'][:16]:>16}")
    lines += [f"- {test}: {sentence}" for test, notes in result.notes.items() for sentence in grouped(notes)]
    lines += [f"- {sentence}" for sentence in grouped(result.comparison.get("notes", []))]
    return "\n".join(lines)


def find_bench_limits(options: argparse.Namespace) -> int:
    """Run the command `bench limits`: determine which part of a valve limits its bandwidth.

    The analysis varies load volume, amplitude, spring rates and damping. The result is the exit code.
    """
    from poppet.bench.limits.maps import DONE, find_limits, limits_plan

    circuit, _ = load_circuit(options)
    # Invalid options are rejected before the run, which takes minutes.
    plan = limits_plan(
        circuit, options.valve, mean=options.mean, volumes=split_list(options.volumes) or None,
        amplitudes=split_list(options.amplitudes) or None, springs=_factors(options.springs, "--springs"),
        dampings=_factors(options.dampings, "--dampings"),
    )  # fmt: skip
    require_matplotlib(options.report)
    with PointProgress(is_quiet=options.quiet) as progress:
        result = find_limits(plan, progress)

    def write_report(path: Path) -> None:
        from poppet.report.bench.limits_report import write_limits

        write_limits(result, path)

    write_result(options, result, limits_summary(result), write_report)
    return 0 if result.outcome == DONE else INTERRUPTED


def limits_summary(result: Any) -> str:
    """Return the dynamic limits of a valve as text for a terminal.

    The text contains a table of bandwidths by volume and amplitude, each with the limiting part, and the findings.
    """
    plan = result.plan
    head = ["-3 dB [Hz]", *(f"{a / 1e3:.3g} kPa" for a in plan.amplitudes)]
    bandwidths, parts = result.bandwidth_map("gain_frequency"), result.bandwidth_map("limiting")
    rows = [
        [f"{v * 1e3:.3g} l", *(f"{f:.3g} {part}" for f, part in zip(*row, strict=True))]
        for v, *row in zip(plan.volumes, bandwidths, parts, strict=True)
    ]
    table = aligned([head, *rows], range(1, len(head)))
    return "\n".join([table, "", *(f"- {finding}" for finding in result.findings)])


def _factors(text: str | None, option: str) -> list[float] | None:
    try:
        return [float(factor) for factor in split_list(text)] or None
    except ValueError:
        raise InputError("cli.factors", option=option, text=text) from None
