"""Coverage of intervals in fits to simulated tests whose sensor has an offset."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
import pytest
from scipy.stats import binom

from poppet import Chamber, Circuit, Orifice
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.identify_fit import describe_optimum
from poppet.identify.fit.search import optimise
from poppet.identify.fit.statistics import covariance
from poppet.identify.free_parameter import FreeParameter
from poppet.timeseries.measurements import Channel, Measurement

SAMPLES, NOISE = 300, 500.0
FEW, ALL = 12, 60
CONDUCTANCE, RATIO = "valve.sonic_conductance", "valve.critical_ratio"
SMALL, LARGE = (0.3, 1.0), (1.0, 4.0)
"""Offsets of one gauge, in sigmas of its noise."""
SHARED = (
    FreeParameter(CONDUCTANCE, CONDUCTANCE, "m^3/(s Pa)", 1e-8, 0.0, 1e-5),
    FreeParameter(RATIO, RATIO, "1", 0.3, 0.0, 1.0),
)


class Trial(NamedTuple):
    """Coverage of the truth by the 95 % intervals of a result, and by intervals for white noise alone."""

    covered: tuple[bool, ...]
    by_noise: tuple[bool, ...]
    is_named: bool


def start_parameter(address: str) -> FreeParameter:
    return FreeParameter(address, address, "Pa", 4e5, 1e3, 1e8, "start", "run")


def pair(generator: np.random.Generator) -> tuple[Circuit, float, tuple[FreeParameter, ...]]:
    """Return a circuit of two tanks that equalise, with a sensor on each, its time scale and its free parameters."""
    volume, conductance = generator.uniform(2e-3, 6e-3), 10.0 ** generator.uniform(-8.6, -7.6)
    parts = {
        "left": Chamber(volume="7.5 l", initial_pressure=generator.uniform(4e5, 8e5), wall_conductance=4.0),
        "right": Chamber(volume=volume, initial_pressure="1 bar", wall_conductance=3.0),
        "valve": Orifice(
            from_="left", to="right", sonic_conductance=conductance, critical_ratio=generator.uniform(0.2, 0.5)
        ),
    }
    own = FreeParameter("right.volume", "right.volume", "m^3", 4e-3, 1e-5, 1.0)
    free = (own, *SHARED, start_parameter("left.initial_pressure"), start_parameter("right.initial_pressure"))
    return Circuit(parts), 8.0 * volume / conductance, free


def tank(generator: np.random.Generator) -> tuple[Circuit, float, tuple[FreeParameter, ...]]:
    """Return a circuit of a tank that empties to ambient, its time scale and its free parameters."""
    conductance = 10.0 ** generator.uniform(-8.6, -7.6)
    wall, pressure = generator.uniform(5.0, 30.0), generator.uniform(5e5, 8e5)
    parts = {
        "tank": Chamber(volume="20 l", initial_pressure=pressure, wall_conductance=wall),
        "valve": Orifice(
            from_="tank", to="ambient", sonic_conductance=conductance, critical_ratio=generator.uniform(0.2, 0.5)
        ),
    }
    own = FreeParameter("tank.wall_conductance", "tank.wall_conductance", "W/K", 10.0, 0.0, 1e4)
    return Circuit(parts), 3.5 * 20e-3 / conductance, (*SHARED, own, start_parameter("tank.initial_pressure"))


BENCHES = {"pair": (pair, ("left.pressure", "right.pressure")), "tank": (tank, ("tank.pressure",))}


@cache
def run_trial(bench: str, offsets: tuple[float, float], seed: int) -> Trial:
    """Return the coverage for one recording, with a random sensor that has an offset of random sign."""
    generator = np.random.default_rng([2012, seed])
    build, gauges = BENCHES[bench]
    circuit, scaled, free = build(generator)
    duration = scaled / (1.185 * 287.05 * 293.15)
    exact = circuit.simulate(duration, duration / (SAMPLES - 1), 1e-9)
    offset = NOISE * generator.uniform(*offsets) * generator.choice([-1.0, 1.0])
    wrong = gauges[generator.integers(len(gauges))]
    channels = tuple(
        Channel(name, exact.time, exact[name] + generator.normal(offset * (name == wrong), NOISE, SAMPLES), "Pa")
        for name in gauges
    )
    experiment = Experiment(circuit.instance, Measurement("run", channels, duration=duration), free)
    optimum = optimise([experiment], free)
    result = describe_optimum(FitPlan((experiment,), free), optimum, with_trials=False)
    truth = [float(circuit.numbers()[f.address]) for f in free]
    estimates = [result.parameters[f.name] for f in free]
    half_widths = 1.96 * np.sqrt(np.diag(covariance(optimum)))
    return Trial(
        tuple(e.low <= value <= e.high for e, value in zip(estimates, truth, strict=True)),
        tuple(abs(e.value - value) <= half for e, value, half in zip(estimates, truth, half_widths, strict=True)),
        any(n.code.startswith("finding.offset.") and n.address == f"run.{wrong}" for n in result.remarks),
    )


def count_covering_intervals(
    bench: str, offsets: tuple[float, float], count: int
) -> tuple[np.ndarray, np.ndarray, int]:
    """Return the numbers of covering intervals, of the result and for white noise, and of findings on the offset."""
    trials = [run_trial(bench, offsets, seed) for seed in range(count)]
    covered, by_noise = (np.array([getattr(t, kind) for t in trials]).sum(axis=0) for kind in ("covered", "by_noise"))
    return covered, by_noise, sum(t.is_named for t in trials)


def check_coverage(bench: str, offsets: tuple[float, float], count: int) -> None:
    covered, by_noise, named = count_covering_intervals(bench, offsets, count)
    print(f"{bench}, {offsets[0]} to {offsets[1]} sigma: covered {(covered / count).round(3)}, by noise alone "
          f"{(by_noise / count).round(3)}, named {named / count:.3f}")  # fmt: skip
    assert np.all(covered >= binom.ppf(0.001, count, 0.95))
    assert by_noise.min() < 0.9 * count
    assert named > 0.7 * count


@pytest.mark.slow
@pytest.mark.parametrize("bench", ["pair", "tank"])
def test_intervals_contain_the_effect_of_an_offset(bench: str) -> None:
    check_coverage(bench, LARGE, FEW)


@pytest.mark.slow
@pytest.mark.parametrize("offsets", [SMALL, LARGE], ids=["small", "large"])
@pytest.mark.parametrize("bench", BENCHES)
def test_intervals_contain_the_effect_of_small_and_large_offsets(bench: str, offsets: tuple[float, float]) -> None:
    """`pytest -m slow -rP` shows the coverage."""
    check_coverage(bench, offsets, ALL)


@pytest.mark.slow
@pytest.mark.parametrize("bench", BENCHES)
def test_recordings_without_offset_give_no_finding(bench: str) -> None:
    covered, _, named = count_covering_intervals(bench, (0.0, 0.0), ALL)
    print(f"{bench}, no offset: covered {(covered / ALL).round(3)}")
    assert named == 0
    assert np.all(covered >= binom.ppf(0.001, ALL, 0.95))
    assert covered.mean() <= 0.98 * ALL
