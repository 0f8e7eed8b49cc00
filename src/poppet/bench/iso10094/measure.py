"""Puts a specimen through the trials of a test; how long they last follows from how fast it answers."""

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
    """A record of steps or a sine, and its rows, which are found but once."""

    record: Record
    rows: list[Row]


@dataclass
class Bench:
    """A specimen on the bench: what has been measured of it."""

    specimen: Specimen
    settings: BenchSettings
    say: Say  # told what is being done
    holds: dict[float, float] = field(default_factory=dict)  # volume to the time to come to rest [s]
    steps: dict[tuple[float, float], EvaluatedRecord] = field(default_factory=dict)  # by volume and amplitude

    def records(self, test: str) -> list[Record]:
        """All records of a test."""
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
        """A step up and down, held as long as the outlet needs."""
        known = self.steps.get((volume, amplitude))
        if known is not None:
            return known
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
        """Time that the specimen needs to come to rest at the first volume [s]."""
        volume = self.settings.volumes[0]
        if volume not in self.holds:
            self.step(volume, max(self.settings.amplitudes))
        return self.holds[volume]

    def _response_times(self, steps: Iterable[EvaluatedRecord]) -> list[float]:
        """Response times of steps; a quarter of the hold where none can be judged [s]."""
        known = [row["response_time"] for step in steps for row in step.rows if "response_time" in row]
        return known or [self.hold() / 4.0]

    def _sweep(self) -> float:
        """Time for a sweep of the setpoint from end to end that is slow for the specimen [s]."""
        first = self.settings.volumes[0]
        response = max(self._response_times(step for (volume, _), step in self.steps.items() if volume == first))
        given = self.settings.sweep_time
        usual = float(np.clip(SWEEP_PER_RESPONSE * response, SHORTEST_SWEEP, LONGEST_SWEEP))
        if given < response:
            raise InputError("bench.sweep_time", given=given, response=response, usual=usual)
        return given if math.isfinite(given) else usual

    def _sines(self) -> list[Record]:
        """Sines from well below to beyond both bandwidths, close to each other where these are."""
        chosen = self.settings.frequencies
        if chosen:
            return [self._sine(f).record for f in sorted(chosen)]
        smallest = self.step(self.settings.volumes[0], min(self.settings.amplitudes))
        # A first order rises from 10 to 90 % in 0.35 periods of its corner frequency.
        corner = 0.35 / min(self._response_times([smallest]))
        ladder = [preferred(corner * 10.0 ** (place / 10.0)) for place in range(DECADE_BELOW, DECADE_ABOVE)]
        found: dict[float, EvaluatedRecord] = {}
        beyond = 0
        # Three to a decade tell where the bandwidths are; between them it is filled up.
        for frequency in ladder[::3]:
            found[frequency] = self._sine(frequency)
            beyond = beyond + 1 if _is_beyond(self._bode(found).rows) else 0
            if beyond >= AFTER:
                break
        for frequency in dict.fromkeys(ladder):
            if frequency not in found and frequency < max(found):
                found[frequency] = self._sine(frequency)
        for _ in range(REFINED):
            for name in ("bandwidth_gain", "bandwidth_phase"):
                figure = self._bode(found).figures.get(name)
                if figure is not None and not figure.bound and figure.value not in found:
                    found[figure.value] = self._sine(figure.value)
        return [found[frequency].record for frequency in sorted(found)]

    def _sine(self, frequency: float) -> EvaluatedRecord:
        choices, scale, hold = self.settings, self.specimen.scale, self.hold()
        mean, amplitude = choices.sine_mean, choices.sine_amplitude
        trial = frequency_trial(scale, choices.volumes[0], frequency, hold, mean=mean, amplitude=amplitude)
        record = self._respond(trial)
        return EvaluatedRecord(record, sine_rows(Evaluation(FREQUENCY, scale), record))

    def _bode(self, sines: Mapping[float, EvaluatedRecord]) -> Evaluation:
        found = Evaluation(FREQUENCY, self.specimen.scale)
        conclude(found, [row for frequency in sorted(sines) for row in sines[frequency].rows])
        return found


def _needed(rows: list[Row]) -> float:
    """Time for which levels must be held, from the steps seen so far [s]."""
    if any("hum_amplitude" in row for row in rows):
        # What swings never settles: enough of its periods to be measured, and time to have fallen to the swing.
        slowest = min(row["hum_frequency"] for row in rows if "hum_frequency" in row)
        settled = [row["settling_time"] for row in rows if "settling_time" in row]
        return float(max(HOLD_PER_HUM / slowest, *(HOLD_PER_SETTLING * time for time in settled), 0.0))
    if not rows or not all(row.get("is_settled") and "settling_time" in row for row in rows):
        return math.inf
    return HOLD_PER_SETTLING * float(max(row["settling_time"] for row in rows))


def _is_beyond(rows: list[Row]) -> bool:
    """True where the last frequency lies beyond both bandwidths."""
    return len(rows) > 1 and bool(rows[-1]["gain_db"] < GAIN_DB and rows[-1]["phase"] < PHASE_DEG)


def preferred(frequency: float) -> float:
    """The nearest of ten preferred frequencies per decade.

    Examples
    --------
    >>> preferred(0.33), preferred(12.0)
    (0.315, 12.5)
    """
    series = (1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0)
    place = round(10.0 * math.log10(frequency))
    return float(f"{series[place % 10] * 10.0 ** (place // 10):.6g}")
