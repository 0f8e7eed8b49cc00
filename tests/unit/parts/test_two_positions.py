"""Elements with two stable positions."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from poppet.parts.two_positions import gradual_switching_rate, switching_rate

LAWS = [switching_rate, gradual_switching_rate]


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("drive", [-0.999, -0.3, 0.0, 0.3, 0.999])
def test_element_keeps_both_ends_within_its_hysteresis(law: Callable[..., float], drive: float) -> None:
    assert law(0.0, drive, 2e-3) == 0.0
    assert law(1.0, drive, 2e-3) == 0.0


def test_element_leaves_an_end_outside_its_hysteresis_at_full_speed() -> None:
    assert switching_rate(0.0, 1.01, 2e-3) == pytest.approx(500.0)
    assert switching_rate(1.0, -1.01, 2e-3) == pytest.approx(-500.0)
    assert switching_rate(1.0, 5.0, 2e-3) == 0.0


def test_speed_of_a_gradual_element_is_proportional_to_the_excess_of_its_drive() -> None:
    assert gradual_switching_rate(0.0, 1.1, 2e-3) == pytest.approx(50.0)
    assert gradual_switching_rate(0.2, 1.1, 2e-3) == pytest.approx(90.0)
    assert gradual_switching_rate(1.0, -1.1, 2e-3) == pytest.approx(-50.0)
    for drive in (2.0, 9.0):
        assert gradual_switching_rate(0.0, drive, 2e-3) == pytest.approx(500.0)
        assert gradual_switching_rate(0.99, drive, 2e-3) == pytest.approx(250.0)
        assert gradual_switching_rate(1.0, drive, 2e-3) == 0.0


def test_friction_holds_a_gradual_element_between_its_seats() -> None:
    """Within the friction, only the detent moves it, slowly and away from the middle."""
    for drive in (-0.8, 0.0, 0.8):
        assert gradual_switching_rate(0.6, drive, 2e-3) == pytest.approx(20.0)
        assert gradual_switching_rate(0.5, drive, 2e-3) == pytest.approx(0.0, abs=1e-9)
    assert gradual_switching_rate(0.6, -1.0, 2e-3) == pytest.approx(-80.0)


@pytest.mark.parametrize("drive", [-0.9, 0.0, 0.7])
def test_position_between_the_ends_is_unstable(drive: float) -> None:
    balance = 0.5 * (1.0 - drive)
    assert switching_rate(balance + 0.01, drive, 1.0) > 0.0
    assert switching_rate(balance - 0.01, drive, 1.0) < 0.0
