"""Points of the unit cube: independence of slices, and uniformity."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats
from scipy.stats import qmc

from poppet.ensemble.sampling import permute, points

METHODS = ("random", "latin", "sobol")


def sample(method, seed=3, total=4000, dimension=5, first=0, last=None):
    return points(method, seed, total, dimension, first, total if last is None else last, (4,) * dimension)


@pytest.mark.parametrize("method", METHODS)
def test_slices_equal_those_of_the_complete_sample(method):
    points_of_all_runs = sample(method)
    for first, last in ((0, 1), (1, 5), (1000, 1001), (1023, 1025), (777, 3111), (3999, 4000)):
        assert (sample(method, first=first, last=last) == points_of_all_runs[first:last]).all()


@pytest.mark.parametrize("method", METHODS)
def test_points_are_inside_the_cube_and_depend_on_the_seed(method):
    points_of_all_runs = sample(method)
    assert points_of_all_runs.shape == (4000, 5)
    assert ((points_of_all_runs > 0.0) & (points_of_all_runs < 1.0)).all()
    assert not (sample(method, seed=4) == points_of_all_runs).all(axis=1).any()


@pytest.mark.parametrize("method", METHODS)
def test_dimensions_pass_a_chi_square_test(method):
    """Counts of 50 cells: only random samples must not be more even than chance."""
    points_of_all_runs = sample(method, seed=11, total=20_000, dimension=3)
    for column in points_of_all_runs.T:
        chi = stats.chisquare(np.histogram(column, bins=50, range=(0.0, 1.0))[0])
        assert chi.pvalue > 1e-3
        if method == "random":
            assert chi.pvalue < 1.0 - 1e-3


@pytest.mark.parametrize("method", ["random", "latin"])
def test_dimensions_are_independent(method):
    points_of_all_runs = sample(method, seed=5, total=20_000, dimension=3)
    for a, b in ((0, 1), (1, 2), (0, 2)):
        counts = np.histogram2d(
            points_of_all_runs[:, a], points_of_all_runs[:, b], bins=12, range=((0.0, 1.0), (0.0, 1.0))
        )[0]
        assert 1e-3 < stats.chisquare(counts.ravel()).pvalue < 1.0 - 1e-3


def test_latin_hypercube_has_one_point_in_each_stratum():
    for total in (1, 2, 3, 10, 257, 1000):
        strata = np.sort((sample("latin", total=total) * total).astype(int), axis=0)
        assert (strata == np.arange(total)[:, np.newaxis]).all()


def test_permutations_depend_on_their_keys():
    runs = np.arange(1000, dtype=np.uint64)
    keys = np.random.default_rng(0).integers(0, 2**63, (4, 4), dtype=np.uint64)
    permutations = [permute(runs, 1000, key) for key in keys]
    assert all(sorted(permutation.tolist()) == list(range(1000)) for permutation in permutations)
    assert all(abs(np.corrcoef(permutations[k], permutations[k + 1])[0, 1]) < 0.1 for k in range(3))


def test_sobol_points_equal_those_of_scipy():
    engine = qmc.Sobol(5, scramble=True, seed=3)
    assert np.abs(sample("sobol", total=4096) - engine.random(4096)).max() < 2.0**-30


def test_late_sobol_points_equal_those_of_scipy():
    engine = qmc.Sobol(3, scramble=True, seed=7)
    engine.fast_forward(1_000_003)
    late_points = sample("sobol", seed=7, total=2_000_000, dimension=3, first=1_000_003, last=1_000_103)
    assert np.abs(late_points - engine.random(100)).max() < 2.0**-30


def test_grid_points_are_the_midpoints_of_cells():
    grid = sample("grid", total=4**2, dimension=2)
    assert sorted(map(tuple, grid.tolist())) == [(a, b) for a in (0.125, 0.375, 0.625, 0.875) for b in (
        0.125, 0.375, 0.625, 0.875)]  # fmt: skip
