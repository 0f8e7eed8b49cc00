"""Separation of faults against dense linear algebra."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.monitoring.separation import effect_angles, free_deviations, remaining_effects, separations, with_scatter

GENERATOR = np.random.default_rng(5)
FAULTS = GENERATOR.normal(size=(60, 4)) @ np.diag([3.0, 1.0, 0.2, 50.0])
NUISANCES = GENERATOR.normal(size=(60, 5)) @ np.diag([100.0, 1.0, 0.3, 2.0, 1e3])
INFORMATION = FAULTS.T @ np.linalg.solve(np.eye(60) + NUISANCES @ NUISANCES.T, FAULTS)


def test_remaining_effects_contain_the_information_with_marginalised_nuisances() -> None:
    columns = remaining_effects(FAULTS, NUISANCES).columns
    assert columns.T @ columns == pytest.approx(INFORMATION, rel=1e-7)


def test_nuisance_of_any_size_explains_the_same_effect_completely() -> None:
    effects = remaining_effects(FAULTS[:, :2], 1e8 * FAULTS[:, :1])
    assert np.linalg.norm(effects.columns, axis=0)[0] == 0.0
    assert np.isnan(effect_angles(effects, [0, 0])[0, 1])
    assert np.isinf(free_deviations(effects)[0])


def test_deviations_with_all_faults_free_are_those_of_the_inverse_information() -> None:
    deviations = free_deviations(remaining_effects(FAULTS, NUISANCES))
    assert deviations == pytest.approx(np.sqrt(np.diag(np.linalg.inv(INFORMATION))), rel=1e-8)


def test_equal_effects_have_infinite_deviations_and_no_angle() -> None:
    effects = remaining_effects(np.column_stack([FAULTS, 0.1 * FAULTS[:, 1]]), NUISANCES)
    deviations, angles = free_deviations(effects), effect_angles(effects, [0] * 5)
    assert np.isinf(deviations).tolist() == [False, True, False, False, True]
    assert angles[1, 4] == angles[4, 1] == 0.0
    assert separations(effects, angles)[1, 4] == 0.0


def test_angles_and_separations_agree_with_the_information() -> None:
    effects = remaining_effects(FAULTS, NUISANCES)
    angles, sizes = effect_angles(effects, [0] * 4), np.sqrt(np.diag(INFORMATION))
    cosines = INFORMATION / np.outer(sizes, sizes)
    assert angles == pytest.approx(np.degrees(np.arccos(np.minimum(np.abs(cosines), 1.0))), abs=1e-5)
    # The rest of fault 0 after the best size of fault 1.
    rest = INFORMATION[0, 0] - INFORMATION[0, 1] ** 2 / INFORMATION[1, 1]
    assert separations(effects, angles)[0, 1] == pytest.approx(np.sqrt(rest))


def test_opposite_effects_of_faults_with_known_directions_are_separate() -> None:
    effects = remaining_effects(np.column_stack([FAULTS[:, 0], -2.0 * FAULTS[:, 0]]), NUISANCES)
    size = np.linalg.norm(effects.columns[:, 0])
    for directions, angle, separation in (([1, 1], 180.0, size), ([1, -1], 0.0, 0.0), ([1, 0], 0.0, 0.0)):
        angles = effect_angles(effects, directions)
        assert angles[0, 1] == pytest.approx(angle)
        assert separations(effects, angles)[0, 1] == pytest.approx(separation)


def test_scatter_adds_to_the_inverse_information() -> None:
    effects = with_scatter(remaining_effects(FAULTS, NUISANCES), 0.3)
    expected = np.linalg.inv(np.linalg.inv(INFORMATION) + 0.09 * np.eye(4))
    assert effects.columns.T @ effects.columns == pytest.approx(expected, rel=1e-6)
    # Equal effects remain equal.
    pair = with_scatter(remaining_effects(np.column_stack([FAULTS[:, 0], 3.0 * FAULTS[:, 0]]), NUISANCES), 0.3)
    assert effect_angles(pair, [0, 0])[0, 1] == 0.0
