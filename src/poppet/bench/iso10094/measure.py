"""Puts a specimen through the trials of a test; how long they last follows from how fast it answers."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from poppet.bench.iso10094.definitions import GAIN_DB, PHASE_DEG
from poppet.bench.iso10094.evaluation import Evaluation
from poppet.bench.iso10094.frequency import evaluate_frequency
from poppet.bench.iso10094.plan import (
    LONGEST_SWEEP,
    SHORTEST_SWEEP,
    STAIR,
    SWEEP_PER_RESPONSE,
    Settings,
    Specimen,
    Trial,
    characteristic_trial,
    flow_trial,
    frequency_trial,
    leakage_trial,
    preferred,
    resolution_trial,
    step_trial,
    supply_trial,
)
from poppet.bench.iso10094.scale import Record
from poppet.bench.iso10094.step import evaluate_step
from poppet.ground.errors import InputError

FIRST_HOLD, LONGER = 0.4, 4.0
"""Time for which a level is held at first [s], and the factor by which it grows until the outlet rests."""
HOLD_PER_SETTLING, HOLD_PER_HUM = 8.0, 40.0
DECADE_BELOW, DECADE_ABOVE = -15, 31
"""Lowest and highest frequency that is tried, about 0.35 / response time, in tenths of a decade."""
AFTER = 2
"""Frequencies that are tried beyond both bandwidths."""
REFINED = 2
"""Frequencies that are added about each bandwidth."""
SUPPLY_ABOVE, SUPPLY_SPAN = 0.15, 0.4
"""Lowest supply of the sweep above the outlet and its extent, in FS."""
Say = Callable[[str], object]


@dataclass
class Bench:
    """A specimen on the bench: what has been measured of it.

    Parameters
    ----------
    specimen : Specimen
        What is measured.
    settings : Settings
        Choices.
    say : callable
        Told what is being done.
    holds : dict
        Volume to the time that the specimen needs to come to rest [s].
    steps : dict
        Volume and amplitude to the record of its step.
    """

    specimen: Specimen
    settings: Settings
    say: Say
    holds: dict[float, float] = field(default_factory=dict)
    steps: dict[tuple[float, float], Record] = field(default_factory=dict)

    def records(self, test: str) -> list[Record]:
        """All records of a test."""
        if test == "step":
            return [self.step(v, a) for v in self.settings.volumes for a in self.settings.amplitudes]
        if test == "frequency":
            return self._frequency()
        return [self._respond(trial) for trial in self._static(test)]

    def step(self, volume: float, amplitude: float) -> Record:
        """The record of a step, held as long as the outlet needs."""
        known = self.steps.get((volume, amplitude))
        if known is not None:
            return known
        hold = FIRST_HOLD
        while True:
            record = self._respond(step_trial(self.specimen.scale, volume, amplitude, hold))
            rows = evaluate_step([record], self.specimen.scale).rows
            needed = _needed(rows, hold)
            if needed <= hold or hold >= self.settings.longest_hold:
                break
            hold = min(LONGER * hold, self.settings.longest_hold)
        self.steps[volume, amplitude] = record
        self.holds[volume] = max(self.holds.get(volume, 0.0), min(needed, hold))
        return record

    def hold(self) -> float:
        """Time that the specimen needs to come to rest at the first volume [s]."""
        volume = self.settings.volumes[0]
        if volume not in self.holds:
            self.step(volume, max(self.settings.amplitudes))
        return self.holds[volume]

    def response_time(self) -> float:
        """Longest response time at the first volume; of the hold where no step can be judged [s]."""
        self.hold()
        records = [record for (volume, _), record in self.steps.items() if volume == self.settings.volumes[0]]
        rows = evaluate_step(records, self.specimen.scale).rows
        return max((row["response_time"] for row in rows if "response_time" in row), default=self.hold() / 4.0)

    def _quickest(self) -> float:
        """Shortest response time of the smallest step at the first volume [s]."""
        record = self.step(self.settings.volumes[0], min(self.settings.amplitudes))
        rows = evaluate_step([record], self.specimen.scale).rows
        return min((row["response_time"] for row in rows if "response_time" in row), default=self.hold() / 4.0)

    def _respond(self, trial: Trial) -> Record:
        self.say(trial.name)
        return self.specimen.respond(trial)

    def _sweep(self) -> float:
        given, response = self.settings.sweep_time, self.response_time()
        usual = float(np.clip(SWEEP_PER_RESPONSE * response, SHORTEST_SWEEP, LONGEST_SWEEP))
        if given < response:
            raise InputError(
                f"sweep time = {given:g} s",
                f"is shorter than the response time of the valve, {response:.3g} s: no slow sweep.",
                f"Give some {usual:.3g} s, or leave it out.",
            )
        return given if math.isfinite(given) else usual

    def _static(self, test: str) -> list[Trial]:
        scale, volume, hold = self.specimen.scale, self.settings.volumes[0], self.hold()
        setpoints = self.settings.setpoints
        if test == "characteristic":
            return [characteristic_trial(scale, volume, self._sweep(), hold)]
        if test == "resolution":
            return [resolution_trial(scale, volume, STAIR, hold, 50.0)]
        if test == "flow":
            sweep = 0.5 * self._sweep()
            return [flow_trial(scale, volume, w, sweep, hold, load) for load in (1.0, -1.0) for w in setpoints]
        if test == "supply":
            sweep = 0.5 * self._sweep()
            return [supply_trial(scale, volume, w, sweep, hold, self._ends(w)) for w in setpoints]
        return [leakage_trial(scale, volume, w, hold) for w in (0.0, *setpoints)]

    def _ends(self, setpoint: float) -> tuple[float, float]:
        """Supply pressures of a sweep: from a little above the outlet to above the usual supply."""
        scale = self.specimen.scale
        low = float(scale.pressure(setpoint)) + SUPPLY_ABOVE * scale.span
        return low, max(self.specimen.supply, low + SUPPLY_SPAN * scale.span)

    def _frequency(self) -> list[Record]:
        chosen = self.settings.frequencies
        if chosen:
            return [self._sine(f) for f in sorted(chosen)]
        corner = 0.35 / self._quickest()
        # Three to a decade tell where the bandwidths are; between them it is filled up.
        found: dict[float, Record] = {}
        beyond = 0
        for place in range(DECADE_BELOW, DECADE_ABOVE, 3):
            frequency = preferred(corner * 10.0 ** (place / 10.0))
            found[frequency] = self._sine(frequency)
            beyond = beyond + 1 if _is_beyond(self._evaluated(found)) else 0
            if beyond >= AFTER:
                break
        ladder = [corner * 10.0 ** (place / 10.0) for place in range(DECADE_BELOW, DECADE_ABOVE)]
        for frequency in dict.fromkeys(preferred(f) for f in ladder):
            if frequency not in found and frequency < max(found):
                found[frequency] = self._sine(frequency)
        for _ in range(REFINED):
            for name in ("bandwidth_gain", "bandwidth_phase"):
                figure = self._evaluated(found).figures.get(name)
                if figure is not None and not figure.bound and figure.value not in found:
                    found[figure.value] = self._sine(figure.value)
        return [found[frequency] for frequency in sorted(found)]

    def _sine(self, frequency: float) -> Record:
        settings = self.settings
        return self._respond(
            frequency_trial(
                self.specimen.scale, settings.volumes[0], frequency, self.hold(),
                mean=settings.sine_mean, amplitude=settings.sine_amplitude,
            )
        )  # fmt: skip

    def _evaluated(self, records: dict[float, Record]) -> Evaluation:
        return evaluate_frequency([records[frequency] for frequency in sorted(records)], self.specimen.scale)


def _needed(rows: list[dict[str, float]], hold: float) -> float:
    """Time for which levels must be held, from the steps seen so far [s]."""
    if any("hum_amplitude" in row for row in rows):
        # What swings never settles: enough of its periods to be measured, and time to have fallen to the swing.
        slowest = min(row["hum_frequency"] for row in rows if "hum_frequency" in row)
        settled = [row["settling_time"] for row in rows if "settling_time" in row]
        return max(HOLD_PER_HUM / slowest, *(HOLD_PER_SETTLING * time for time in settled), 0.0)
    if not rows or not all(row.get("is_settled") and "settling_time" in row for row in rows):
        return math.inf
    return HOLD_PER_SETTLING * max(row["settling_time"] for row in rows)


def _is_beyond(found: Evaluation) -> bool:
    """True where the last frequency lies beyond both bandwidths."""
    if len(found.rows) < 2:
        return False
    last = found.rows[-1]
    return bool(last["gain_db"] < GAIN_DB and last["phase"] < PHASE_DEG)
