"""Scenarios of the DAMADICS benchmark, watched through the public interface and scored with the benchmark's indices.

The baseline comes from a healthy recording with other noise. Nothing is fitted to a recording that is scored.
`python -m exact.damadics_watch` in the folder `tests` prints the table of `docs/watch_accuracy.md`.
"""

from __future__ import annotations

import sys
from functools import cache
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import least_squares

import poppet
from exact import independent_damadics as truth
from exact.damadics_indices import T_FROM, Indices, indices
from exact.damadics_twin import GRID, columns, line_frequency, twin
from exact.independent_damadics import Scenario, record
from poppet.signals import Points
from poppet.timeseries.recording import Recording

BEGIN = 100  # the twin starts behind the start-up of the benchmark [s]
HEALTHY_SEED, SEED = 1000, 7
MEASURED: dict[str, Any] = {
    "positioner.reading": {"column": "X", "unit": "1", "noise": 0.004},
    "positioner.discrepancy": {"column": "difference", "unit": "1", "noise": 0.002},
    "positioner.setpoint": {"column": "command", "unit": "1"},
    "stem.load_force": {"column": "force", "unit": "N"},
}
FAULTS: dict[str, Any] = {
    "chamber_leak": {"address": "leak.sonic_conductance", "direction": "up", "alarm": 2e-11},
    "diaphragm": {"address": "actuator.bore", "direction": "down", "alarm": "5 mm"},
    "spring": {"address": "actuator.spring.rate", "direction": "down", "alarm": "3000 N/m"},
    "transducer": {"address": "positioner.current_factor", "direction": "up", "alarm": 0.1},
    "position_sensor": {"address": "positioner.sensor_factor", "alarm": 0.02},
    "air_supply": {"address": "air.pressure", "direction": "down", "alarm": "0.5 bar"},
}
OTHER = "other"
"""The diagnosis "none of the hypotheses fits"."""
DIAGNOSES = {
    9: "chamber_leak",
    10: "diaphragm",
    11: "spring",
    12: "transducer",
    13: "position_sensor",
    16: "air_supply",
}
"""Elementary diagnosis of each fault; that of the others of the 27 scenarios is `OTHER`."""
N_OTHER = 5  # f1, f4, f8, f14 and f15
WITHOUT_EFFECT = (8, 14)
"""Faults that change no reading by more than its noise."""


class Result(NamedTuple):
    """Watched scenario."""

    scenario: Scenario
    indices: Indices
    verdicts: list[tuple[float, str]]  # changes of the verdict: time [s] and text
    sizes: dict[str, tuple[float, float]]  # fault numbers at the end and their standard deviations
    per_update: float  # computing time [s]


def lines(measured: dict[str, np.ndarray]) -> tuple[float, float]:
    """Return the frequencies of the lines of both water pressures in a healthy recording [Hz]."""
    return line_frequency(measured["P1"]), line_frequency(measured["P2"])


def table(measured: dict[str, np.ndarray], frequencies: tuple[float, float]) -> Recording:
    """Return the columns for the twin as a recording, without the start-up of the plant."""
    data = {name: series[BEGIN * GRID :] for name, series in columns(measured, frequencies).items()}
    names = ("command", "force", "X", "difference")
    units = ("1", "N", "1", "1")
    return Recording(data["time"], names, units, np.array([data[name] for name in names]))


@cache
def commissioned() -> tuple[tuple[float, float], Any, Any]:
    """Return the frequencies, the circuit and the baseline of the healthy plant.

    Half an hour of healthy operation determines the passages of the positioner and the baseline.
    """
    healthy = record(truth.HEALTHY, 1900.0, seed=HEALTHY_SEED)
    frequencies = lines(healthy.measured)
    data = columns({name: series[:1801] for name, series in healthy.measured.items()}, frequencies)
    signals = {
        "positioner.setpoint": Points(data["time"], data["command"]),
        "stem.load_force": Points(data["time"], data["force"]),
    }

    def residuals(q: np.ndarray) -> np.ndarray:
        circuit = twin(sonic_conductance=q[0] * 1e-9, exhaust_conductance=q[1] * 1e-9, critical_ratio=q[2])
        run = circuit.with_signals(signals).simulate(1800.0, output_step=1.0)
        return np.asarray(run["positioner.reading"])[BEGIN:] - healthy.measured["X"][BEGIN:1801]

    q = least_squares(residuals, [2.0, 3.0, 0.4], bounds=([0.5, 0.5, 0.1], [10, 20, 0.7]), diff_step=1e-3).x
    circuit = twin(sonic_conductance=q[0] * 1e-9, exhaust_conductance=q[1] * 1e-9, critical_ratio=q[2])
    baseline = new_watch(circuit).commission(table(healthy.measured, frequencies))
    return frequencies, circuit, baseline


def new_watch(circuit: Any, baseline: Any = None) -> Any:
    """Return the watch of the actuator."""
    settings = {"window": "120 s", "alarm_delay": "5 s", "hold": False}
    return poppet.watch(circuit, measured=MEASURED, faults=FAULTS, baseline=baseline, **settings)


def evaluate(scenario: Scenario, seed: int = SEED) -> Result:
    """Watch a scenario, and return its indices."""
    frequencies, circuit, baseline = commissioned()
    recording = record(scenario, seed=seed)
    rows = table(recording.measured, frequencies)
    watch = new_watch(circuit, baseline)
    start = perf_counter()
    result = watch.run(rows)
    per_update = (perf_counter() - start) / rows.time.size
    sizes = {name: (estimate.value, estimate.sigma) for name, estimate in watch.faults.items()}
    verdicts = [(time, str(note)) for time, note in result.verdicts]
    return Result(scenario, _score(scenario, recording, result), verdicts, sizes, per_update)


def _score(scenario: Scenario, recording: truth.Recording, result: Any) -> Indices:
    """Return the indices for the decisions at the rows of the recording."""
    at = np.searchsorted(result.time, recording.time, side="right") - 1
    changes = np.array([time for time, _ in result.verdicts])
    codes = [note.code for _, note in result.verdicts]
    decisions: list[frozenset[str]] = []
    for time, k in zip(recording.time, at, strict=True):
        j = int(np.searchsorted(changes, time, side="right")) - 1
        names = {name for name in result.alarms[k].split(" or ") if name} if k >= 0 else set()
        if j >= 0 and codes[j] == "watch.none_fits":
            names.add(OTHER)
        decisions.append(frozenset(names))
    diagnosis = DIAGNOSES.get(scenario.fault, OTHER)
    detection = np.array([bool(d) for d in decisions])
    primary = np.array([diagnosis in d for d in decisions])
    other = np.array([len(d - {diagnosis}) for d in decisions])
    indicated = np.array([len(d - {OTHER}) + N_OTHER * (OTHER in d) for d in decisions])
    return indices(recording.time, recording.strength, detection, primary, other, indicated, scenario.horizon)


def row(result: Result) -> str:
    """Return a result as a row of the table in the documentation."""
    values = result.indices

    def text(value: float, digits: int) -> str:
        return "-" if np.isnan(value) else f"{value:.{digits}f}"

    cells = [
        result.scenario.name, text(values.t_dt, 0), text(values.r_fd, 3), text(values.r_td, 3), text(values.fs_d, 3),
        text(values.t_it, 0), text(values.r_fi, 3), text(values.r_ti, 3), text(values.r_mi, 3), text(values.fs_i, 3),
        text(values.d_acc, 2),
    ]  # fmt: skip
    return "| " + " | ".join(cells) + " |"


def main(names: list[str]) -> None:
    """Print the rows of the table, for all scenarios or for those whose names are given."""
    for scenario in truth.SCENARIOS:
        if names and scenario.name not in names:
            continue
        result = evaluate(scenario)
        print(row(result), flush=True)
        for time, text in result.verdicts:
            if time < T_FROM or names:
                print(f"    {time:7.0f} s  {text}")


if __name__ == "__main__":
    main(sys.argv[1:])
