"""Measurement of a test valve in the trials of a test; the response time sets the durations."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from poppet.bench.iso10094.bench_settings import BenchSettings, Pace, Specimen, Trial
from poppet.bench.iso10094.definitions import TESTS
from poppet.bench.iso10094.evaluation import Evaluation, Row
from poppet.bench.iso10094.frequency import FREQUENCY, GAIN_DB, PHASE_DEG, conclude, frequency_trial, sine_rows
from poppet.bench.iso10094.scale import Record
from poppet.bench.iso10094.step import step_trial
from poppet.core.errors import InputError

FIRST_HOLD, LONGER = 0.4, 4.0
"""Time for which a level is held at first [s], and the factor by which it grows until the outlet rests."""
HOLD_PER_SETTLING, HOLD_PER_HUM = 8.0, 40.0
SWEEP_PER_RESPONSE, SHORTEST_SWEEP, LONGEST_SWEEP = 200.0, 10.0, 60.0
"""Time of a sweep of the setpoint per response time, and its limits [s]."""
DECADE_BELOW, DECADE_ABOVE = -15, 31
"""Lowest and highest frequency that is tried, about 0.35 / response time, in tenths of a decade."""
AFTER = 2
"""Frequencies that are tried beyond both bandwidths."""
REFINED = 2
"""Frequencies that are added about each bandwidth."""
Say = Callable[[str], object]


class EvaluatedRecord(NamedTuple):
    """Record of steps or a sine with its rows."""

    record: Record
    rows: list[Row]


@dataclass
class Bench:
    """Test valve on the bench with its measurements."""

    specimen: Specimen
    settings: BenchSettings
    say: Say  # told what is being done
    holds: dict[float, float] = field(default_factory=dict)  # volume to the time to come to rest [s]
    steps: dict[tuple[float, float], EvaluatedRecord] = field(default_factory=dict)  # by volume and amplitude

    def records(self, test: str) -> list[Record]:
        """Return all records of a test."""
        trials = TESTS[test].trials
        if trials is not None:
            pace = Pace(self.specimen, self.settings, self.hold(), self._sweep)
            return [self._respond(trial) for trial in trials(pace)]
        if test == "frequency":
            return self._sines()
        return [self.step(v, a).record for v in self.settings.volumes for a in self.settings.amplitudes]

    def _respond(self, trial: Trial) -> Record:
        self.say(trial.name)
        return self.specimen.respond(trial)

    def step(self, volume: float, amplitude: float) -> EvaluatedRecord:
        """Measure a step up and down with a sufficient hold."""
        measured = self.steps.get((volume, amplitude))
        if measured is not None:
            return measured
        scale, hold = self.specimen.scale, FIRST_HOLD
        while True:
            record = self._respond(step_trial(scale, volume, amplitude, hold))
            rows = TESTS["step"].evaluated([record], scale).rows
            needed = _needed(rows)
            if needed <= hold or hold >= self.settings.longest_hold:
                break
            hold = min(LONGER * hold, self.settings.longest_hold)
        self.holds[volume] = max(self.holds.get(volume, 0.0), min(needed, hold))
        self.steps[volume, amplitude] = EvaluatedRecord(record, rows)
        return self.steps[volume, amplitude]

    def hold(self) -> float:
        """Return the settling time of the test valve with the first volume [s]."""
        volume = self.settings.volumes[0]
        if volume not in self.holds:
            self.step(volume, max(self.settings.amplitudes))
        return self.holds[volume]

    def _response_times(self, steps: Iterable[EvaluatedRecord]) -> list[float]:
        """Return the response times of steps; without any, a quarter of the hold [s]."""
        times = [row["response_time"] for step in steps for row in step.rows if "response_time" in row]
        return times or [self.hold() / 4.0]

    def _sweep(self) -> float:
        """Return the duration of a sweep that is slow for the test valve [s]."""
        first = self.settings.volumes[0]
        response = max(self._response_times(step for (volume, _), step in self.steps.items() if volume == first))
        sweep_time = self.settings.sweep_time
        usual = float(np.clip(SWEEP_PER_RESPONSE * response, SHORTEST_SWEEP, LONGEST_SWEEP))
        if sweep_time < response:
            raise InputError("bench.sweep_time", given=sweep_time, response=response, usual=usual)
        return sweep_time if math.isfinite(sweep_time) else usual

    def _sines(self) -> list[Record]:
        """Measure sines from far below to above both bandwidths, with a fine grid near them."""
        frequencies = self.settings.frequencies
        if frequencies:
            return [self._sine(f).record for f in sorted(frequencies)]
        smallest = self.step(self.settings.volumes[0], min(self.settings.amplitudes))
        # A first order rises from 10 to 90 % in 0.35 periods of its corner frequency.
        corner = 0.35 / min(self._response_times([smallest]))
        ladder = [preferred(corner * 10.0 ** (step / 10.0)) for step in range(DECADE_BELOW, DECADE_ABOVE)]
        sines: dict[float, EvaluatedRecord] = {}
        n_beyond = 0
        # Three to a decade tell where the bandwidths are; between them it is filled up.
        for frequency in ladder[::3]:
            sines[frequency] = self._sine(frequency)
            n_beyond = n_beyond + 1 if _is_beyond(self._bode(sines).rows) else 0
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

    def _sine(self, frequency: float) -> EvaluatedRecord:
        choices, scale, hold = self.settings, self.specimen.scale, self.hold()
        mean, amplitude = choices.sine_mean, choices.sine_amplitude
        trial = frequency_trial(scale, choices.volumes[0], frequency, hold, mean=mean, amplitude=amplitude)
        record = self._respond(trial)
        return EvaluatedRecord(record, sine_rows(Evaluation(FREQUENCY, scale), record))

    def _bode(self, sines: Mapping[float, EvaluatedRecord]) -> Evaluation:
        evaluation = Evaluation(FREQUENCY, self.specimen.scale)
        conclude(evaluation, [row for frequency in sorted(sines) for row in sines[frequency].rows])
        return evaluation


def _needed(rows: list[Row]) -> float:
    """Return the required hold time from the measured steps [s]."""
    if any("hum_amplitude" in row for row in rows):
        # What swings never settles: enough of its periods to be measured, and time to have fallen to the swing.
        slowest = min(row["hum_frequency"] for row in rows if "hum_frequency" in row)
        settled = [row["settling_time"] for row in rows if "settling_time" in row]
        return float(max(HOLD_PER_HUM / slowest, *(HOLD_PER_SETTLING * time for time in settled), 0.0))
    if not rows or not all(row.get("is_settled") and "settling_time" in row for row in rows):
        return math.inf
    return HOLD_PER_SETTLING * float(max(row["settling_time"] for row in rows))


def _is_beyond(rows: list[Row]) -> bool:
    """Return True if the last frequency is above both bandwidths."""
    return len(rows) > 1 and bool(rows[-1]["gain_db"] < GAIN_DB and rows[-1]["phase"] < PHASE_DEG)


def preferred(frequency: float) -> float:
    """Return the nearest of ten preferred frequencies per decade.

    Examples
    --------
    >>> preferred(0.33), preferred(12.0)
    (0.315, 12.5)
    """
    series = (1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0)
    index = round(10.0 * math.log10(frequency))
    return float(f"{series[index % 10] * 10.0 ** (index // 10):.6g}")
