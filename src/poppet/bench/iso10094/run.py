"""All tests of a bench, of a specimen that is driven or of recordings of a real valve: the same evaluation for both."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from poppet.bench.iso10094.characteristic import evaluate_characteristic
from poppet.bench.iso10094.definitions import DEFINITIONS, TESTS
from poppet.bench.iso10094.evaluation import Evaluation
from poppet.bench.iso10094.flow import evaluate_flow
from poppet.bench.iso10094.frequency import evaluate_frequency
from poppet.bench.iso10094.measure import Bench, Say
from poppet.bench.iso10094.plan import Settings, Specimen
from poppet.bench.iso10094.resolution import evaluate_resolution
from poppet.bench.iso10094.result import BenchResult
from poppet.bench.iso10094.scale import Record, Scale
from poppet.bench.iso10094.step import evaluate_step
from poppet.bench.iso10094.supply import evaluate_leakage, evaluate_supply
from poppet.ground.errors import InputError, PoppetError, SimulationError, suggestion

FIRST = ("step",)
"""Tests that come first: the others take their times from them."""


def evaluated(test: str, records: Sequence[Record], scale: Scale, rated_flow: float = math.nan) -> Evaluation:
    """Evaluate the records of one test."""
    evaluate: Mapping[str, Callable[[Sequence[Record], Scale], Evaluation]] = {
        "characteristic": evaluate_characteristic,
        "resolution": evaluate_resolution,
        "flow": partial(evaluate_flow, rated_flow=rated_flow),
        "supply": evaluate_supply,
        "leakage": evaluate_leakage,
        "step": evaluate_step,
        "frequency": evaluate_frequency,
    }
    return evaluate[test](records, scale)


def run_bench(
    specimen: Specimen,
    settings: Settings | None = None,
    tests: Sequence[str] = tuple(TESTS),
    *,
    source: str = "circuit",
    notes: Sequence[str] = (),
    conditions: Mapping[str, Any] | None = None,
    say: Say | None = None,
) -> BenchResult:
    """Put a specimen through tests."""
    settings = settings or Settings()
    check_tests(tests)
    bench = Bench(specimen, settings, say or (lambda _: None))
    found: dict[str, Evaluation] = {}
    outcome = "done"
    for test in sorted(tests, key=lambda each: (each not in FIRST, list(TESTS).index(each))):
        try:
            found[test] = evaluated(test, bench.records(test), specimen.scale, settings.rated_flow)
        except SimulationError as error:
            found[test] = _failed(test, error)
            outcome = "failed"
        except KeyboardInterrupt:
            outcome = "interrupted"
            break
    scale = specimen.scale
    known = {
        "setpoint_range": [scale.setpoint_low, scale.setpoint_high],
        "setpoint_unit": scale.setpoint_unit,
        "full_scale": [scale.pressure_low, scale.pressure_high],
        "supply_pressure": specimen.supply,
        "volumes": list(settings.volumes),
    }
    return assembled(specimen.title, source, found, known | dict(conditions or {}), notes, outcome)


def run_recordings(
    title: str,
    records: Mapping[str, Sequence[Record]],
    scale: Scale,
    *,
    tests: Sequence[str] = tuple(TESTS),
    rated_flow: float = math.nan,
    notes: Sequence[str] = (),
    conditions: Mapping[str, Any] | None = None,
) -> BenchResult:
    """Evaluate recordings of a real valve."""
    check_tests(tests)
    found = {test: evaluated(test, records[test], scale, rated_flow) for test in tests if records.get(test)}
    missing = [test for test in tests if not records.get(test)]
    sentences = [*notes, *(f"{test}: no recording of this test was given." for test in missing)]
    known = {
        "setpoint_range": [scale.setpoint_low, scale.setpoint_high],
        "setpoint_unit": scale.setpoint_unit,
        "full_scale": [scale.pressure_low, scale.pressure_high],
    }
    return assembled(title, "recordings", found, known | dict(conditions or {}), sentences)


def check_tests(tests: Sequence[str]) -> None:
    """Refuse names of tests that do not exist."""
    if not tests:
        raise InputError("tests", "name no test.", f"Use some of: {', '.join(TESTS)}.")
    for test in tests:
        if test not in TESTS:
            raise InputError(f"test = {test!r}", "is unknown.", suggestion(test, TESTS))


def _failed(test: str, error: PoppetError) -> Evaluation:
    """What stands for a test that could not be run."""
    found = Evaluation(test)
    found.note(f"The test could not be run: {error}")
    for definition in DEFINITIONS.values():
        if definition.test == test:
            found.add(definition.name, math.nan, reason="the test could not be run")
    return found


def assembled(
    title: str,
    source: str,
    found: Mapping[str, Evaluation],
    conditions: Mapping[str, Any],
    notes: Sequence[str],
    outcome: str = "done",
) -> BenchResult:
    """One result of all tests."""
    figures = {name: figure for each in found.values() for name, figure in each.figures.items()}
    order = [test for test in TESTS if test in found]
    return BenchResult(
        title,
        source,
        {name: figures[name] for name in DEFINITIONS if name in figures},
        {test: found[test].rows for test in order},
        {test: found[test].curves for test in order if found[test].curves},
        {"bench": tuple(notes)} | {test: tuple(found[test].notes) for test in order},
        dict(conditions) | {test: found[test].conditions for test in order if found[test].conditions},
        {},
        outcome,
    )
