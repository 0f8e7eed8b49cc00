"""Agreement of test design and fit: predicted errors, reported errors, and scatter of independently simulated tests."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from scipy.stats import binom, chi2

from exact.independent_tanks import AIR, ROOM, Array, Tank, course
from poppet import Recording, load
from poppet.identify import identify_design, identify_fit

NOISE, OFFSET = {"pressure": 300.0, "temperature": 0.3}, {"pressure": 1e3, "temperature": 0.5}
UNIT = {"pressure": "Pa", "temperature": "K"}
TIME = 0.1 * np.arange(301)
TRUTH = {"outlet.sonic_conductance": 1e-8, "outlet.critical_ratio": 0.3, "tank.wall_conductance": 5.0}
DISCHARGE = Tank(False, 3e-3, 1e-8, 0.3, 5.0, 8e5, AIR, closes=1e9, duration=30.0)
FEW, MANY = 12, 200
CIRCUIT = """
[parts.tank]
kind = "chamber"
volume = {volume}
initial_pressure = "8 bar"
initial_temperature = "{room} K"
wall_conductance = "5 W/K"
[parts.outlet]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = "1e-8 m^3/(s Pa)"
critical_ratio = 0.3
[ambient]
pressure = "{air} Pa"
temperature = "{room} K"
[run]
duration = "30 s"
"""
START = 'start = { "tank.initial_pressure" = "free" }\n'
FREE = "[free]\n" + "".join(f'"{name}" = {value}\n' for name, value in TRUTH.items())


class Agreement(NamedTuple):
    """Errors of one parameter: predicted, reported (median), and root mean square; number of covering intervals."""

    predicted: float
    reported: float
    scatter: float
    covered: int


def measure(tank: Tank, signals: tuple[str, ...], seed: int) -> dict[str, Array]:
    """Return a recording with noise and an offset of each sensor."""
    generator = np.random.default_rng([24, 10, seed])
    pressure, temperature, _ = course(tank, TIME)
    truth = {"pressure": pressure, "temperature": temperature}
    return {
        signal: truth[signal] + generator.normal(0.0, OFFSET[signal]) + generator.normal(0.0, NOISE[signal], TIME.size)
        for signal in signals
    }


def write_design(folder: Path, tank: Tank, signals: tuple[str, ...]) -> Path:
    (folder / "bench.toml").write_text(CIRCUIT.format(volume=tank.volume, air=AIR, room=ROOM))
    sensors = "".join(
        f'"tank.{s}" = {{ noise = "{NOISE[s]} {UNIT[s]}", offset = "{OFFSET[s]} {UNIT[s]}" }}\n' for s in signals
    )
    text = f'circuit = "bench.toml"\nduration = "30 s"\nsample_time = "0.1 s"\n{START}{FREE}[sensors]\n{sensors}'
    (folder / "design.toml").write_text(text)
    return folder / "design.toml"


def write_fit(folder: Path, recording: dict[str, Array]) -> Path:
    table = np.column_stack([TIME, *recording.values()])
    np.savetxt(folder / "a.csv", table, delimiter=",", header=",".join(["time", *recording]), comments="", fmt="%.6f")
    channels = "".join(
        f'"tank.{s}" = {{ column = "{s}", unit = "{UNIT[s]}", noise = "{NOISE[s]} {UNIT[s]}", '
        f'offset = "{OFFSET[s]} {UNIT[s]}" }}\n'
        for s in recording
    )
    text = f'circuit = "bench.toml"\n[recordings.a]\nfile = "a.csv"\n{START}{channels}{FREE}'
    (folder / "fit.toml").write_text(text)
    return folder / "fit.toml"


def compare(folder: Path, volume: float, signals: tuple[str, ...], count: int) -> dict[str, Agreement]:
    """Return the agreement of design, fit and scatter for each parameter, and print it."""
    tank = replace(DISCHARGE, volume=volume)
    predicted = identify_design(write_design(folder, tank, signals)).together
    results = [identify_fit(write_fit(folder, measure(tank, signals, seed))).parameters for seed in range(count)]
    agreements = {}
    for name, truth in TRUTH.items():
        estimates = [parameters[name] for parameters in results]
        scatter = float(np.sqrt(np.mean([(e.value - truth) ** 2 for e in estimates])))
        agreements[name] = Agreement(
            predicted[name].standard_error,
            float(np.median([e.standard_error for e in estimates])),
            scatter,
            sum(e.low <= truth <= e.high for e in estimates),
        )
        shown = ", ".join(f"{100.0 * x / truth:.3f} %" for x in agreements[name][:3])
        print(f"{1e3 * volume:g} l, {'+'.join(signals)}, {name}: predicted, reported, rms error {shown}", end="")
        print(f", covered {agreements[name].covered}/{count}")
    return agreements


def check(agreements: dict[str, Agreement], count: int) -> None:
    # The mean square of N errors is chi-square distributed; 1e-4 on each side.
    low, high = np.sqrt(chi2.ppf([1e-4, 1.0 - 1e-4], count) / count)
    for name, a in agreements.items():
        assert a.reported == pytest.approx(a.predicted, rel=0.1), name
        assert low * a.predicted < a.scatter < high * a.predicted, name
        assert a.covered >= binom.ppf(1e-4, count, 0.95), name


@pytest.mark.parametrize(("volume", "signals"), [(3e-3, ("pressure",)), (20e-3, ("pressure", "temperature"))])
def test_design_predicts_the_errors_of_fits_with_offsets(
    tmp_path: Path, volume: float, signals: tuple[str, ...]
) -> None:
    check(compare(tmp_path, volume, signals, FEW), FEW)


@pytest.mark.slow
@pytest.mark.parametrize("signals", [("pressure",), ("pressure", "temperature")])
@pytest.mark.parametrize("volume", [3e-3, 20e-3])
def test_design_predicts_the_errors_of_many_fits_with_offsets(
    tmp_path: Path, volume: float, signals: tuple[str, ...]
) -> None:
    check(compare(tmp_path, volume, signals, MANY), MANY)


def test_fit_file_and_python_have_the_same_offsets(tmp_path: Path) -> None:
    write_design(tmp_path, DISCHARGE, ("pressure",))
    recording = measure(DISCHARGE, ("pressure",), 1)
    from_file = identify_fit(write_fit(tmp_path, recording)).parameters
    measured = Recording.from_series(TIME, {"tank.pressure [Pa]": np.round(recording["pressure"], 6)})
    result = load(tmp_path / "bench.toml").fit(
        {"a": measured},
        TRUTH,
        start={"tank.initial_pressure": "free"},
        noise={"tank.pressure": "300 Pa"},
        offsets={"tank.pressure": "1 kPa"},
    )
    assert list(from_file) == list(result.parameters)
    for name, estimate in from_file.items():
        assert result[name].value == pytest.approx(estimate.value, rel=1e-6), name
        assert result[name].standard_error == pytest.approx(estimate.standard_error, rel=1e-5), name
