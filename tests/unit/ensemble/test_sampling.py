"""Points of the unit cube: what any slice of them is, and how they are spread."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats
from scipy.stats import qmc

from poppet.ensemble.sampling import permute, points

WAYS = ("random", "latin", "sobol")


def of(way, seed=3, total=4000, dimension=5, first=0, last=None):
    return points(way, seed, total, dimension, first, total if last is None else last, (4,) * dimension)


@pytest.mark.parametrize("way", WAYS)
def test_any_slice_is_a_slice_of_the_whole(way):
    whole = of(way)
    for first, last in ((0, 1), (1, 5), (1000, 1001), (1023, 1025), (777, 3111), (3999, 4000)):
        assert (of(way, first=first, last=last) == whole[first:last]).all()


@pytest.mark.parametrize("way", WAYS)
def test_points_lie_inside_the_cube_and_seeds_differ(way):
    whole = of(way)
    assert whole.shape == (4000, 5)
    assert ((whole > 0.0) & (whole < 1.0)).all()
    assert not (of(way, seed=4) == whole).all(axis=1).any()


@pytest.mark.parametrize("way", WAYS)
def test_chi_square_of_each_dimension(way):
    """Counts of 50 cells; more even than chance is allowed for samples that are made so."""
    whole = of(way, seed=11, total=20_000, dimension=3)
    for column in whole.T:
        chi = stats.chisquare(np.histogram(column, bins=50, range=(0.0, 1.0))[0])
        assert chi.pvalue > 1e-3
        if way == "random":
            assert chi.pvalue < 1.0 - 1e-3


@pytest.mark.parametrize("way", ["random", "latin"])
def test_dimensions_are_independent(way):
    whole = of(way, seed=5, total=20_000, dimension=3)
    for a, b in ((0, 1), (1, 2), (0, 2)):
        counts = np.histogram2d(whole[:, a], whole[:, b], bins=12, range=((0.0, 1.0), (0.0, 1.0)))[0]
        assert 1e-3 < stats.chisquare(counts.ravel()).pvalue < 1.0 - 1e-3


def test_latin_hypercube_has_one_point_in_each_stratum():
    for total in (1, 2, 3, 10, 257, 1000):
        strata = np.sort((of("latin", total=total) * total).astype(int), axis=0)
        assert (strata == np.arange(total)[:, np.newaxis]).all()


def test_permutations_differ_by_their_keys():
    runs = np.arange(1000, dtype=np.uint64)
    keys = np.random.default_rng(0).integers(0, 2**63, (4, 4), dtype=np.uint64)
    found = [permute(runs, 1000, key) for key in keys]
    assert all(sorted(each.tolist()) == list(range(1000)) for each in found)
    assert all(abs(np.corrcoef(found[k], found[k + 1])[0, 1]) < 0.1 for k in range(3))


def test_sobol_points_are_those_of_scipy():
    engine = qmc.Sobol(5, scramble=True, seed=3)
    assert np.abs(of("sobol", total=4096) - engine.random(4096)).max() < 2.0**-30


def test_sobol_points_far_out_are_those_of_scipy():
    engine = qmc.Sobol(3, scramble=True, seed=7)
    engine.fast_forward(1_000_003)
    far = of("sobol", seed=7, total=2_000_000, dimension=3, first=1_000_003, last=1_000_103)
    assert np.abs(far - engine.random(100)).max() < 2.0**-30


def test_a_grid_has_the_middles_of_its_cells():
    found = of("grid", total=4**2, dimension=2)
    assert sorted(map(tuple, found.tolist())) == [(a, b) for a in (0.125, 0.375, 0.625, 0.875) for b in (
        0.125, 0.375, 0.625, 0.875)]  # fmt: skip
