"""Standard deviations of all fault numbers of `poppet watch` after a fault, on the independent tank.

The slow version prints the numbers of `docs/watch_accuracy.md`.
"""

from __future__ import annotations

import numpy as np
import pytest

from exact.watch_batteries import BAND_FAULTS, bands

STEPS = [
    *(("leak", size) for size in (1.0, 3.0, 10.0)),
    *(("clogged", size) for size in (-5.0, -15.0, -30.0)),
    *(("supply_low", size) for size in (-0.3, -1.0, -2.0)),
]
GROWING = [("leak", 3.0), ("leak", 10.0), ("clogged", -30.0), ("supply_low", -1.0)]


@pytest.mark.parametrize(("fault", "size"), [("leak", 10.0), ("clogged", -15.0), ("supply_low", -1.0)])
def test_after_a_sudden_fault_all_sizes_agree_with_their_deviations(fault, size):
    (run,) = bands(fault, size, range(1), start=90.0, duration=170.0)
    assert run.outcome.alarms[-1].names == (fault,)
    assert np.abs(run.in_alarm).max() < 4.0
    # The deviations are small at the end: the fault is confirmed, and known to a tenth of its alarm size.
    sizes = np.array([entry["alarm"] for entry in BAND_FAULTS.values()])
    assert (run.outcome.sigmas[-1] < 0.2 * sizes).all()


@pytest.mark.parametrize(("fault", "size", "seed"), [("leak", 10.0, 0), ("clogged", -30.0, 2), ("supply_low", -1.0, 8)])
def test_a_growing_fault_is_followed(fault, size, seed):
    """At these seeds, constant faults explain the first readings by others than the true one."""
    (run,) = bands(fault, size, range(seed, seed + 1), start=120.0, growth=120.0, duration=240.0)
    assert run.outcome.names == (fault,)
    assert np.mean(np.abs(run.in_alarm) < 1.96) > 0.95
    assert np.abs(run.in_alarm).max() < 6.0
    alarms = np.array([entry["alarm"] for entry in BAND_FAULTS.values()])
    assert (run.outcome.sigmas[-1] < alarms).all()


def test_the_deviations_are_small_again_after_the_growth():
    (run,) = bands("clogged", -30.0, range(1), start=80.0, growth=60.0, duration=200.0)
    column = list(BAND_FAULTS).index("clogged")
    alarm = BAND_FAULTS["clogged"]["alarm"]
    assert run.outcome.sigmas[-1, column] < 0.1 * alarm
    assert abs(run.errors[-1, column]) < 4.0


@pytest.mark.slow
@pytest.mark.parametrize("growth", [0.0, 120.0])
def test_errors_of_all_sizes_agree_with_their_deviations(growth):
    cases = GROWING if growth else STEPS
    runs = [run for fault, size in cases for run in bands(fault, size, range(8), start=100.0, growth=growth)]
    for name, errors in (
        ("alarm", np.concatenate([run.in_alarm for run in runs])),
        ("end", np.array([run.errors[-1] for run in runs])),
    ):
        shares = [100.0 * float(np.mean(np.abs(errors) > limit)) for limit in (2.0, 3.0, 4.0)]
        rms = float(np.sqrt(np.mean(errors**2)))
        print(
            f"{name}, growth {growth:.0f} s: rms {rms:.2f}; above 2, 3, 4: {shares} %; max {np.abs(errors).max():.1f}"
        )
        assert shares[2] < 10.0
