"""Statistics of runs: coverage of intervals, Sobol indices of known functions, files of worst cases."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import sobol_indices as indices_of_scipy

from circuits_of_ensembles import METRICS, TABLES, TANK, tank
from poppet import load
from poppet.ensemble import plan_of
from poppet.ensemble.sampling import points
from poppet.ensemble.statistics import sobol_indices, wilson
from poppet.timeseries.tables.reading import arrow
from refusals import refused


def coverage(method: str, share: float, runs: int, repetitions: int, seed: int) -> float:
    """Return the coverage of the interval of a yield.

    The metric is the sum of two uniform parameters, so its distribution is triangular.
    """
    limit = math.sqrt(2.0 * share) if share <= 0.5 else 2.0 - math.sqrt(2.0 * (1.0 - share))
    hits = 0
    for k in range(repetitions):
        u = points(method, seed + k, runs, 2, 0, runs, ())
        low, high = wilson(int(np.count_nonzero(u.sum(axis=1) < limit)), runs)
        hits += low <= share <= high
    return hits / repetitions


@pytest.mark.parametrize(("share", "runs"), [(0.5, 300), (0.9, 500), (0.98, 2000)])
def test_yield_interval_has_nominal_coverage(share, runs):
    assert 0.93 <= coverage("random", share, runs, 1000, seed=100) <= 0.97


@pytest.mark.parametrize("method", ["latin", "sobol"])
def test_yield_interval_of_even_samples_has_larger_coverage(method):
    assert coverage(method, 0.9, 256, 200, seed=5) >= 0.97


def ishigami(u):
    x = math.pi * (2.0 * u - 1.0)
    return np.sin(x[:, 0]) + 7.0 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])


def saltelli(function, dimension, base, seed):
    """Return the values of A, of B, and of A with each column from B."""
    points_ab = points("sobol", seed, base, 2 * dimension, 0, base, ())
    a, b = points_ab[:, :dimension], points_ab[:, dimension:]
    points_mixed = []
    for k in range(dimension):
        mixed = a.copy()
        mixed[:, k] = b[:, k]
        points_mixed.append(mixed)
    return np.stack([function(item) for item in (a, b, *points_mixed)])


# Ishigami and Homma 1990, with a = 7 and b = 0.1.
_V = 49.0 / 8.0 + 0.1 * math.pi**4 / 5.0 + 0.01 * math.pi**8 / 18.0 + 0.5
FIRST = [0.5 * (1.0 + 0.1 * math.pi**4 / 5.0) ** 2 / _V, 49.0 / 8.0 / _V, 0.0]
_BOTH = 0.01 * math.pi**8 * (1.0 / 18.0 - 1.0 / 50.0) / _V
TOTAL = [FIRST[0] + _BOTH, FIRST[1], _BOTH]


def test_sobol_indices_of_ishigami():
    indices = sobol_indices(saltelli(ishigami, 3, 2048, seed=3), "abc")
    for index, first, total in zip(indices, FIRST, TOTAL, strict=True):
        assert index.first_low <= first <= index.first_high
        assert index.total_low <= total <= index.total_high
        assert index.first_high - index.first_low < 0.15
        assert index.first == pytest.approx(first, abs=0.02)


def test_sobol_indices_equal_those_of_scipy():
    values = saltelli(ishigami, 3, 512, seed=1)
    reference = indices_of_scipy(func={"f_A": values[:1], "f_B": values[1:2], "f_AB": values[2:, np.newaxis, :]}, n=512)
    indices = sobol_indices(values, "abc")
    assert [index.first for index in indices] == pytest.approx(reference.first_order, abs=1e-12)
    assert [index.total for index in indices] == pytest.approx(reference.total_order, abs=1e-12)


@pytest.mark.slow
def test_intervals_of_sobol_indices_have_nominal_coverage():
    """Coverage over 100 samples: intervals for independent rows are wide for a Sobol sequence."""
    hits = np.zeros((2, 3))
    for seed in range(100):
        for k, index in enumerate(sobol_indices(saltelli(ishigami, 3, 256, seed), "abc")):
            hits[0, k] += index.first_low <= FIRST[k] <= index.first_high
            hits[1, k] += index.total_low <= TOTAL[k] <= index.total_high
    assert hits.min() >= 90


# A tank at rest: its mass is p V / (R T), a product whose indices are known.
LINEAR = """
title = "A closed tank"
[parts.tank]
kind = "chamber"
volume = "2 l"
thermal = "isothermal"
[parts.other]
kind = "chamber"
volume = "1 l"
[parts.hole]
kind = "orifice"
from = "tank"
to = "other"
sonic_conductance = "1e-8 m^3/(s Pa)"
critical_ratio = 0.3
[run]
duration = "1 s"
output_step = "0.5 s"
[ensemble]
runs = 100
indices = 512
[ensemble.parameters]
"tank.volume" = { distribution = "uniform", relative_range = 0.01 }
"tank.initial_pressure" = { distribution = "uniform", relative_range = 0.02 }
"hole.critical_ratio" = { distribution = "uniform", relative_range = 0.5 }
[ensemble.metrics]
mass = { of = "tank.mass", metric = "final", until = "1 ms" }
"""


def test_sobol_indices_and_tornado_of_a_linear_circuit(tmp_path):
    """The initial mass is linear in two parameters and does not depend on the third."""
    path = tmp_path / "linear.toml"
    path.write_text(LINEAR, encoding="utf-8")
    ensemble = load(path).ensemble()
    by_name = {index.factor: index for index in ensemble.indices()["mass"]}
    for name, expected in (("tank.volume", 0.2), ("tank.initial_pressure", 0.8), ("hole.critical_ratio", 0.0)):
        index = by_name[name]
        assert index.first_low - 1e-4 <= expected <= index.first_high + 1e-4
        assert index.total_low - 1e-4 <= expected <= index.total_high + 1e-4
    ranges = ensemble.tornado()["mass"]
    assert [item.address for item in ranges] == ["tank.initial_pressure", "tank.volume", "hole.critical_ratio"]
    mass = 1e5 * 2e-3 / (287.05 * 293.15)
    # From the 5 to the 95 % quantile: 0.9 of the range of a uniform parameter.
    assert [item.high - item.low for item in ranges] == pytest.approx([0.036 * mass, 0.018 * mass, 0.0], abs=1e-12)


def test_parameters_of_a_fit_are_one_factor(tmp_path):
    from poppet.identify.result import Estimate, Result

    estimates = {
        "tank.volume": Estimate(2e-3, "m^3", 2e-5, 1.9e-3, 2.1e-3, "determined"),
        "hole.sonic_conductance": Estimate(2e-8, "m^3/(s Pa)", 4e-10, 1.9e-8, 2.1e-8, "determined"),
    }
    table = {"tank.volume": {"hole.sonic_conductance": 0.8}}
    fit = Result("fit", "bench", estimates, correlation=table)
    plan = plan_of(tank(""), runs=8, indices=8, metrics=METRICS, parameters={
        "from_fit": fit, "hole.critical_ratio": {"distribution": "uniform", "relative_range": 0.1}})  # fmt: skip
    assert plan.factors == {"hole.critical_ratio": (0,), "from_fit": (1, 2)}
    values = plan.sample(0, plan.counts("indices")[0], "indices").reshape(4, 8, 3)
    assert (values[3, :, 1:] == values[1, :, 1:]).all()
    assert (values[3, :, 0] == values[0, :, 0]).all()
    assert (plan.sample(5, 29, "indices") == values.reshape(32, 3)[5:29]).all()


def test_summaries_are_moments_and_quantiles():
    ensemble = tank().ensemble(runs=300)
    rows = ensemble.dataset.columns("runs")
    for index in ensemble.summaries():
        values = rows[index.name]
        assert (index.count, index.never, index.failed) == (300, 0, 0)
        assert (index.least, index.greatest) == (values.min(), values.max())
        assert (index.mean, index.sd) == pytest.approx((values.mean(), values.std(ddof=1)), rel=1e-12)
        assert index.quantiles[0.95] == pytest.approx(np.quantile(values, 0.95), rel=1e-12)


def test_last_yield_counts_runs_that_meet_all_requirements():
    ensemble = tank().ensemble()
    rows = ensemble.dataset.columns("runs")
    fast, low = rows["empty"] < 0.5, (rows["end"] >= 1.0) & (rows["end"] < 1.5)
    assert [item.good for item in ensemble.yields()] == [fast.sum(), low.sum(), (fast & low).sum()]


def test_worst_cases_are_circuit_files(tmp_path):
    path = tmp_path / "tank.toml"
    path.write_text(TANK + TABLES, encoding="utf-8")
    ensemble = load(path).ensemble(runs=200)
    rows = ensemble.dataset.columns("runs")
    cases = ensemble.worst(2)["fast"]
    order = np.argsort(-rows["empty"])[:2].tolist()
    assert [case.run for case in cases] == order
    written = ensemble.save_worst(tmp_path / "bad", 2)
    assert [file.name for file in written] == ["fast-1.toml", "fast-2.toml", "low-1.toml", "low-2.toml"]
    recording = load(written[0]).simulate()
    p, t = recording["tank.pressure"], recording.time
    k = int(np.argmax(p <= 1.5e5))
    assert t[k - 1] <= rows["empty"][order[0]] <= t[k]
    assert p[-1] / 1e5 == pytest.approx(rows["end"][order[0]], rel=1e-12)


def test_worst_cases_of_circuits_without_a_file_are_rejected(tmp_path):
    with refused("ensemble.not_its_file"):
        tank().with_values({"tank.thermal": "isothermal"}).ensemble(runs=5).save_worst(tmp_path)
    with refused("ensemble.no_requirements"):
        tank().ensemble(runs=5, requirements={}).save_worst(tmp_path)


def test_dataset_is_readable_by_other_programs(tmp_path):
    ensemble = tank().ensemble(tmp_path / "set")
    frame = ensemble.to_pandas()
    assert len(frame) == 300
    folder = tmp_path / "set" / "runs"
    duckdb = pytest.importorskip("duckdb")
    polars = pytest.importorskip("polars")
    pandas = pytest.importorskip("pandas")
    mean = frame["air"].mean()
    assert duckdb.sql(f"select avg(air), count(*) from '{folder}/*.parquet'").fetchall()[0] == pytest.approx(
        (mean, 300)
    )
    assert polars.read_parquet(f"{folder}/*.parquet")["air"].mean() == pytest.approx(mean)
    assert pandas.read_parquet(folder)["air"].mean() == pytest.approx(mean)
    assert arrow().parquet.read_table(folder).num_rows == 300


def test_worst_case_files_have_adapted_paths(tmp_path):
    """Relative paths are adapted to the new folder."""
    (tmp_path / "a").mkdir()
    text = TANK + '[signals."hole.opening"]\nkind = "file"\npath = "opening.csv"\ncolumn = "o"\n' + TABLES
    (tmp_path / "a" / "opening.csv").write_text("time [s],o [1]\n0,1\n1,0.5\n", encoding="utf-8")
    path = Path(tmp_path / "a" / "tank.toml")
    path.write_text(text, encoding="utf-8")
    (file, *_) = load(path).ensemble(runs=5).save_worst(tmp_path / "b" / "c", 1)
    assert "../../a/opening.csv" in file.read_text(encoding="utf-8")
    assert load(file).simulate().time[-1] == 1.0
