"""Elements with two stable positions."""

from __future__ import annotations

import pytest

from poppet.parts.two_positions import switching_rate


@pytest.mark.parametrize("drive", [-0.999, -0.3, 0.0, 0.3, 0.999])
def test_element_keeps_both_ends_within_its_hysteresis(drive: float) -> None:
    assert switching_rate(0.0, drive, 2e-3) == 0.0
    assert switching_rate(1.0, drive, 2e-3) == 0.0


def test_element_leaves_an_end_outside_its_hysteresis_at_full_speed() -> None:
    assert switching_rate(0.0, 1.021, 2e-3) == pytest.approx(500.0)
    assert switching_rate(1.0, -1.021, 2e-3) == pytest.approx(-500.0)
    assert switching_rate(1.0, 5.0, 2e-3) == 0.0


@pytest.mark.parametrize("drive", [-0.9, 0.0, 0.7])
def test_position_between_the_ends_is_unstable(drive: float) -> None:
    balance = 0.5 * (1.0 - drive)
    assert switching_rate(balance + 0.01, drive, 1.0) > 0.0
    assert switching_rate(balance - 0.01, drive, 1.0) < 0.0
