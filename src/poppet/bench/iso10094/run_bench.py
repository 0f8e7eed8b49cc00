"""Execution of the bench tests; models and recordings have the same evaluation."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from poppet.bench.iso10094.bench_result import DEFINITIONS, TESTS, BenchResult
from poppet.bench.iso10094.evaluation import BenchSettings, Evaluation, Pace, Row, Specimen, Trial
from poppet.bench.iso10094.frequency import (
    FREQUENCY,
    GAIN_DB,
    PHASE_DEG,
    add_frequency_results,
    frequency_trial,
    sine_rows,
)
from poppet.bench.iso10094.scale import Record, Scale
from poppet.bench.iso10094.step import step_trial
from poppet.core.codes import Note, notes_of
from poppet.core.errors import InputError, NameSuggestion, SimulationError

# First hold time of a step [s], and factor by which it increases until the outlet settles.
FIRST_HOLD, LONGER = 0.4, 4.0
HOLD_PER_SETTLING, HOLD_PER_HUM = 8.0, 40.0
# Time of a sweep of the setpoint per response time, and its limits [s].
SWEEP_PER_RESPONSE, SHORTEST_SWEEP, LONGEST_SWEEP = 200.0, 10.0, 60.0
# Range of frequencies below and above 0.35 / response time, in tenths of a decade.
DECADE_BELOW, DECADE_ABOVE = -15, 31
AFTER = 2  # number of coarse frequencies beyond both bandwidths
REFINED = 2  # number of frequencies that are added at each bandwidth
Say = Callable[[str], object]


class EvaluatedRecord(NamedTuple):
    """Record of a trial with steps or sines, and one result row for each of them."""

    record: Record
    rows: list[Row]


@dataclass
class BenchRun:
    """Test valve on the bench, with the settings and all step measurements so far."""

    specimen: Specimen
    settings: BenchSettings
    say: Say  # callback for progress messages
    holds: dict[float, float] = field(default_factory=dict)  # mapping from volume [m^3] to settling time [s]
    steps: dict[tuple[float, float], EvaluatedRecord] = field(default_factory=dict)  # by volume and amplitude

    def records(self, test: str) -> list[Record]:
        """Run all trials of a test and return their records.

        `test` is the name of the test.
        """
        trials = TESTS[test].trials
        if trials is not None:
            pace = Pace(self.specimen, self.settings, self.settling_hold(), self._sweep_time)
            return [self._respond(trial) for trial in trials(pace)]
        if test == "step":
            return [self.step(v, a).record for v in self.settings.volumes for a in self.settings.amplitudes]
        frequencies = self.settings.frequencies
        if frequencies:
            return [self._sine(f).record for f in sorted(frequencies)]
        # Sines at frequencies from far below to above both bandwidths, closer to each other near the bandwidths.
        smallest = self.step(self.settings.volumes[0], min(self.settings.amplitudes))
        # A first-order response rises from 10 to 90 % in 0.35 periods of the corner frequency.
        corner = 0.35 / min(self._response_times([smallest]))
        ladder = [preferred_frequency(corner * 10.0 ** (step / 10.0)) for step in range(DECADE_BELOW, DECADE_ABOVE)]
        sines: dict[float, EvaluatedRecord] = {}
        n_beyond = 0
        # Three frequencies per decade locate the bandwidths; the other frequencies of the range follow.
        for frequency in ladder[::3]:
            sines[frequency] = self._sine(frequency)
            rows = self._bode(sines).rows
            is_beyond = len(rows) > 1 and rows[-1]["gain_db"] < GAIN_DB and rows[-1]["phase"] < PHASE_DEG
            n_beyond = n_beyond + 1 if is_beyond else 0
            if n_beyond >= AFTER:
                break
        for frequency in dict.fromkeys(ladder):
            if frequency not in sines and frequency < max(sines):
                sines[frequency] = self._sine(frequency)
        for _ in range(REFINED):
            for name in ("bandwidth_gain", "bandwidth_phase"):
                figure = self._bode(sines).figures.get(name)
                if figure is not None and not figure.bound and figure.value not in sines:
                    sines[figure.value] = self._sine(figure.value)
        return [sines[frequency].record for frequency in sorted(sines)]

    def _respond(self, trial: Trial) -> Record:
        self.say(trial.name)
        return self.specimen.respond(trial)

    def step(self, volume: float, amplitude: float) -> EvaluatedRecord:
        """Measure a step up and a step down, with holds in which the outlet settles.

        `volume` is the outlet volume [m^3], and `amplitude` the height of the step [% FS]. A measurement with the same
        values is reused.
        """
        measured = self.steps.get((volume, amplitude))
        if measured is not None:
            return measured
        scale, hold = self.specimen.scale, FIRST_HOLD
        while True:
            record = self._respond(step_trial(scale, volume, amplitude, hold))
            rows = TESTS["step"].evaluate_records([record], scale).rows
            needed = _required_hold_time(rows)
            if needed <= hold or hold >= self.settings.longest_hold:
                break
            hold = min(LONGER * hold, self.settings.longest_hold)
        self.holds[volume] = max(self.holds.get(volume, 0.0), min(needed, hold))
        self.steps[volume, amplitude] = EvaluatedRecord(record, rows)
        return self.steps[volume, amplitude]

    def settling_hold(self) -> float:
        """Return the hold time in which the test valve settles with the first volume [s]."""
        volume = self.settings.volumes[0]
        if volume not in self.holds:
            self.step(volume, max(self.settings.amplitudes))
        return self.holds[volume]

    def _response_times(self, steps: Iterable[EvaluatedRecord]) -> list[float]:
        """Return the response times of measured steps [s].

        If no step has a response time, the result is a quarter of the hold time for settling.
        """
        times = [row["response_time"] for step in steps for row in step.rows if "response_time" in row]
        return times or [self.settling_hold() / 4.0]

    def _sweep_time(self) -> float:
        """Return the duration of a sweep over the full range [s].

        The duration is specified in the settings. By default, it is 200 times the response time, within limits. A
        specified duration below the response time raises an error.
        """
        first = self.settings.volumes[0]
        response = max(self._response_times(step for (volume, _), step in self.steps.items() if volume == first))
        sweep_time = self.settings.sweep_time
        usual = float(np.clip(SWEEP_PER_RESPONSE * response, SHORTEST_SWEEP, LONGEST_SWEEP))
        if sweep_time < response:
            raise InputError("bench.sweep_time", given=sweep_time, response=response, usual=usual)
        return sweep_time if math.isfinite(sweep_time) else usual

    def _sine(self, frequency: float) -> EvaluatedRecord:
        choices, scale, hold = self.settings, self.specimen.scale, self.settling_hold()
        mean, amplitude = choices.sine_mean, choices.sine_amplitude
        trial = frequency_trial(scale, choices.volumes[0], frequency, hold, mean=mean, amplitude=amplitude)
        record = self._respond(trial)
        return EvaluatedRecord(record, sine_rows(Evaluation(FREQUENCY, scale), record))

    def _bode(self, sines: Mapping[float, EvaluatedRecord]) -> Evaluation:
        evaluation = Evaluation(FREQUENCY, self.specimen.scale)
        add_frequency_results(evaluation, [row for frequency in sorted(sines) for row in sines[frequency].rows])
        return evaluation


def _required_hold_time(rows: list[Row]) -> float:
    """Return the hold time that the valve needs to settle after steps [s].

    `rows` are the table rows of measured steps. The result is infinite if a step did not settle.
    """
    if any("hum_amplitude" in row for row in rows):
        # A limit cycle never settles: the hold must contain several of its periods after the settling time.
        slowest = min(row["hum_frequency"] for row in rows if "hum_frequency" in row)
        settled = [row["settling_time"] for row in rows if "settling_time" in row]
        return float(max(HOLD_PER_HUM / slowest, *(HOLD_PER_SETTLING * time for time in settled), 0.0))
    if not rows or not all(row.get("is_settled") and "settling_time" in row for row in rows):
        return math.inf
    return HOLD_PER_SETTLING * float(max(row["settling_time"] for row in rows))


def preferred_frequency(frequency: float) -> float:
    """Return the preferred number that is nearest to a frequency [Hz].

    Each decade has ten preferred numbers: 1, 1.25, 1.6, ..., 8.

    Examples
    --------
    >>> preferred_frequency(0.33), preferred_frequency(12.0)
    (0.315, 12.5)
    """
    series = (1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0)
    index = round(10.0 * math.log10(frequency))
    return float(f"{series[index % 10] * 10.0 ** (index // 10):.6g}")


def run_bench(
    specimen: Specimen, settings: BenchSettings | None = None, tests: Sequence[str] = tuple(TESTS), *,
    source: str = "circuit", notes: Sequence[Note | str] = (), conditions: Mapping[str, Any] | None = None,
    say: Say | None = None,
) -> BenchResult:  # fmt: skip
    """Run the selected tests with a test valve, and return all results.

    If the simulation of a test fails, a note reports it and the other tests continue. The keyword `source` is the kind
    of test valve in the result, and the keyword `say` is a function that shows progress messages. Ctrl-C ends the
    tests; the result then contains the completed ones.
    """
    settings = settings or BenchSettings()
    check_tests(tests)
    bench = BenchRun(specimen, settings, say or (lambda _: None))
    evaluations: dict[str, Evaluation] = {}
    outcome = "done"
    # The steps come first, because the durations of the other tests depend on their response times.
    for name in sorted(tests, key=lambda test: (test != "step", list(TESTS).index(test))):
        try:
            evaluations[name] = TESTS[name].evaluate_records(bench.records(name), specimen.scale, settings.rated_flow)
        except SimulationError as error:
            outcome = "failed"
            evaluations[name] = Evaluation(TESTS[name], specimen.scale)
            evaluations[name].note("failed", why=error.note.code, text=str(error))
            evaluations[name].note_absence("not_run", *TESTS[name].units)
        except KeyboardInterrupt:
            outcome = "interrupted"
            break
    all_conditions = {"supply_pressure": specimen.supply, "volumes": list(settings.volumes)} | dict(conditions or {})
    return _combine_evaluations(specimen.title, source, evaluations, specimen.scale, all_conditions, notes, outcome)


def run_recordings(
    title: str, records: Mapping[str, Sequence[Record]], scale: Scale, *, tests: Sequence[str] = tuple(TESTS),
    rated_flow: float = math.nan, notes: Sequence[Note | str] = (), conditions: Mapping[str, Any] | None = None,
) -> BenchResult:  # fmt: skip
    """Evaluate the selected tests from recordings of a real valve.

    `records` maps the name of each test to its records. A note reports each selected test without records.
    """
    check_tests(tests)
    evaluations = {
        name: TESTS[name].evaluate_records(records[name], scale, rated_flow) for name in tests if records.get(name)
    }
    missing = [Note("bench.not_given", name) for name in tests if name not in evaluations]
    return _combine_evaluations(title, "recordings", evaluations, scale, conditions or {}, [*notes, *missing])


def check_tests(tests: Sequence[str]) -> None:
    """Raise an error if no test is selected or a test is unknown."""
    if not tests:
        raise InputError("bench.no_test", known=tuple(TESTS))
    for test in tests:
        if test not in TESTS:
            suggestion = NameSuggestion(test, TESTS)
            raise InputError("fields.not_an_option", "tests", value=test, meaning="test", suggestion=suggestion)


def _combine_evaluations(
    title: str, source: str, evaluations: Mapping[str, Evaluation], scale: Scale, conditions: Mapping[str, Any],
    notes: Sequence[Note | str], outcome: str = "done",
) -> BenchResult:  # fmt: skip
    """Combine the evaluations of all tests into one bench result.

    `source` is the kind of test valve, and `outcome` the reason why the tests ended.
    """
    tests = {name: evaluations[name] for name in TESTS if name in evaluations}
    figures = {name: figure for evaluation in tests.values() for name, figure in evaluation.figures.items()}
    ranges = {
        "setpoint_range": [scale.setpoint_low, scale.setpoint_high], "setpoint_unit": scale.setpoint_unit,
        "full_scale": [scale.pressure_low, scale.pressure_high],
    }  # fmt: skip
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
