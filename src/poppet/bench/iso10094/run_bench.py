"""Tests of a bench, with the same evaluation for models and recordings."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from poppet.bench.iso10094.bench_result import BenchResult
from poppet.bench.iso10094.bench_settings import BenchSettings, Specimen
from poppet.bench.iso10094.definitions import DEFINITIONS, TESTS
from poppet.bench.iso10094.evaluation import Evaluation
from poppet.bench.iso10094.measure import Bench, Say
from poppet.bench.iso10094.scale import Record, Scale
from poppet.core.codes import Note, notes_of
from poppet.core.errors import InputError, NameSuggestion, SimulationError

FIRST = ("step",)
"""Tests that come first: the others take their times from them."""


def run_bench(
    specimen: Specimen, settings: BenchSettings | None = None, tests: Sequence[str] = tuple(TESTS), *,
    source: str = "circuit", notes: Sequence[Note | str] = (), conditions: Mapping[str, Any] | None = None,
    say: Say | None = None,
) -> BenchResult:  # fmt: skip
    """Run the tests of a test valve."""
    settings = settings or BenchSettings()
    check_tests(tests)
    bench = Bench(specimen, settings, say or (lambda _: None))
    evaluations: dict[str, Evaluation] = {}
    outcome = "done"
    for name in sorted(tests, key=lambda test: (test not in FIRST, list(TESTS).index(test))):
        try:
            evaluations[name] = TESTS[name].evaluated(bench.records(name), specimen.scale, settings.rated_flow)
        except SimulationError as error:
            outcome = "failed"
            evaluations[name] = Evaluation(TESTS[name], specimen.scale)
            evaluations[name].note("failed", why=error.note.code, text=str(error))
            evaluations[name].note_absence("not_run", *TESTS[name].units)
        except KeyboardInterrupt:
            outcome = "interrupted"
            break
    all_conditions = {"supply_pressure": specimen.supply, "volumes": list(settings.volumes)} | dict(conditions or {})
    return _assembled(specimen.title, source, evaluations, specimen.scale, all_conditions, notes, outcome)


def run_recordings(
    title: str, records: Mapping[str, Sequence[Record]], scale: Scale, *, tests: Sequence[str] = tuple(TESTS),
    rated_flow: float = math.nan, notes: Sequence[Note | str] = (), conditions: Mapping[str, Any] | None = None,
) -> BenchResult:  # fmt: skip
    """Evaluate recordings of a real valve."""
    check_tests(tests)
    evaluations = {name: TESTS[name].evaluated(records[name], scale, rated_flow) for name in tests if records.get(name)}
    missing = [Note("bench.not_given", name) for name in tests if name not in evaluations]
    return _assembled(title, "recordings", evaluations, scale, conditions or {}, [*notes, *missing])


def check_tests(tests: Sequence[str]) -> None:
    """Reject unknown names of tests."""
    if not tests:
        raise InputError("bench.no_test", known=tuple(TESTS))
    for test in tests:
        if test not in TESTS:
            raise InputError("bench.unknown_test", given=test, near=NameSuggestion(test, TESTS))


def _assembled(
    title: str, source: str, evaluations: Mapping[str, Evaluation], scale: Scale, conditions: Mapping[str, Any],
    notes: Sequence[Note | str], outcome: str = "done",
) -> BenchResult:  # fmt: skip
    """Combine the evaluations of all tests in one result."""
    tests = {name: evaluations[name] for name in TESTS if name in evaluations}
    figures = {name: figure for evaluation in tests.values() for name, figure in evaluation.figures.items()}
    ranges = {
        "setpoint_range": [scale.setpoint_low, scale.setpoint_high],
        "setpoint_unit": scale.setpoint_unit,
        "full_scale": [scale.pressure_low, scale.pressure_high],
    }
    test_conditions = {name: evaluation.conditions for name, evaluation in tests.items() if evaluation.conditions}
    return BenchResult(
        title,
        source,
        {name: figures[name] for name in DEFINITIONS if name in figures},
        {name: evaluation.rows for name, evaluation in tests.items()},
        {name: evaluation.curves for name, evaluation in tests.items() if evaluation.curves},
        {"bench": notes_of(notes)} | {name: tuple(evaluation.notes) for name, evaluation in tests.items()},
        {**ranges, **conditions, **test_conditions},
        outcome=outcome,
    )
