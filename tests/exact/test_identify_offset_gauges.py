"""Tests whose truth is known, recorded with a gauge that is off by a constant: intervals have to hold what it does."""

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
    """Which of the 95 % intervals held the truth: those of the result, and those of white noise alone."""

    covered: tuple[bool, ...]
    by_noise: tuple[bool, ...]
    is_named: bool


def start(address: str) -> FreeParameter:
    return FreeParameter(address, address, "Pa", 4e5, 1e3, 1e8, "start", "run")


def pair(generator: np.random.Generator) -> tuple[Circuit, float, tuple[FreeParameter, ...]]:
    """Two tanks that equalise, a gauge on each."""
    volume, conductance = generator.uniform(2e-3, 6e-3), 10.0 ** generator.uniform(-8.6, -7.6)
    parts = {
        "left": Chamber(volume="7.5 l", initial_pressure=generator.uniform(4e5, 8e5), wall_conductance=4.0),
        "right": Chamber(volume=volume, initial_pressure="1 bar", wall_conductance=3.0),
        "valve": Orifice(
            from_="left", to="right", sonic_conductance=conductance, critical_ratio=generator.uniform(0.2, 0.5)
        ),
    }
    own = FreeParameter("right.volume", "right.volume", "m^3", 4e-3, 1e-5, 1.0)
    free = (own, *SHARED, start("left.initial_pressure"), start("right.initial_pressure"))
    return Circuit(parts), 8.0 * volume / conductance, free


def tank(generator: np.random.Generator) -> tuple[Circuit, float, tuple[FreeParameter, ...]]:
    """A tank that empties into air of known pressure."""
    conductance = 10.0 ** generator.uniform(-8.6, -7.6)
    wall, pressure = generator.uniform(5.0, 30.0), generator.uniform(5e5, 8e5)
    parts = {
        "tank": Chamber(volume="20 l", initial_pressure=pressure, wall_conductance=wall),
        "valve": Orifice(
            from_="tank", to="ambient", sonic_conductance=conductance, critical_ratio=generator.uniform(0.2, 0.5)
        ),
    }
    own = FreeParameter("tank.wall_conductance", "tank.wall_conductance", "W/K", 10.0, 0.0, 1e4)
    return Circuit(parts), 3.5 * 20e-3 / conductance, (*SHARED, own, start("tank.initial_pressure"))


BENCHES = {"pair": (pair, ("left.pressure", "right.pressure")), "tank": (tank, ("tank.pressure",))}


@cache
def trial(bench: str, offsets: tuple[float, float], seed: int) -> Trial:
    """One recording, the gauge that is off and its sign drawn."""
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
    found = [result.parameters[f.name] for f in free]
    plain = 1.96 * np.sqrt(np.diag(covariance(optimum)))
    return Trial(
        tuple(e.low <= value <= e.high for e, value in zip(found, truth, strict=True)),
        tuple(abs(e.value - value) <= half for e, value, half in zip(found, truth, plain, strict=True)),
        any(n.code.startswith("finding.offset.") and n.address == f"run.{wrong}" for n in result.remarks),
    )


def hits(bench: str, offsets: tuple[float, float], count: int) -> tuple[np.ndarray, np.ndarray, int]:
    """Intervals that held the truth, with everything and by white noise alone, and how often the offset was named."""
    trials = [trial(bench, offsets, seed) for seed in range(count)]
    covered, by_noise = (np.array([getattr(t, kind) for t in trials]).sum(axis=0) for kind in ("covered", "by_noise"))
    return covered, by_noise, sum(t.is_named for t in trials)


def check(bench: str, offsets: tuple[float, float], count: int) -> None:
    covered, by_noise, named = hits(bench, offsets, count)
    print(f"{bench}, {offsets[0]} to {offsets[1]} sigma: covered {(covered / count).round(3)}, by noise alone "
          f"{(by_noise / count).round(3)}, named {named / count:.3f}")  # fmt: skip
    assert np.all(covered >= binom.ppf(0.001, count, 0.95))
    assert by_noise.min() < 0.9 * count
    assert named > 0.7 * count


@pytest.mark.slow
@pytest.mark.parametrize("bench", ["pair", "tank"])
def test_intervals_hold_the_offset_of_a_gauge(bench: str) -> None:
    check(bench, LARGE, FEW)


@pytest.mark.slow
@pytest.mark.parametrize("offsets", [SMALL, LARGE], ids=["small", "large"])
@pytest.mark.parametrize("bench", BENCHES)
def test_intervals_hold_small_and_large_offsets(bench: str, offsets: tuple[float, float]) -> None:
    """Prints the coverage: `pytest -m slow -rP` shows it."""
    check(bench, offsets, ALL)


@pytest.mark.slow
@pytest.mark.parametrize("bench", BENCHES)
def test_no_offset_is_named_or_added_where_there_is_none(bench: str) -> None:
    covered, _, named = hits(bench, (0.0, 0.0), ALL)
    print(f"{bench}, no offset: covered {(covered / ALL).round(3)}")
    assert named == 0
    assert np.all(covered >= binom.ppf(0.001, ALL, 0.95))
    assert covered.mean() <= 0.98 * ALL
