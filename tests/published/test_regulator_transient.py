"""The regulator's assumed numbers (set B) fill a tank in the times worked out for them, and settle where they should.

Reference times are those of an independent integration of the same equations: supply 7 bar, pilot 4.4 bar gauge, a tank
of 0.2 m^3 filled polytropically with n = 1.04. None of these numbers is measured; the paper prints no mechanical one.
"""

from __future__ import annotations

import numpy as np
import pytest

from poppet import Circuit
from poppet.library import main_stage
from poppet.parts import Chamber, MainStage, Reservoir

SUPPLY, AMBIENT, PILOT = 7e5, 1e5, 5.4e5
TIMES = {2e5: 18.4, 3e5: 36.5, 4e5: 54.3, 5e5: 72.8}
NUMBERS = {name: float(number.value) for name, number in main_stage("varga2012", "regulator").items()}


def regulator(seat_balance: float) -> Circuit:
    valve = MainStage(
        supply="supply", outlet="tank", exhaust="room", data="varga2012", mode="regulator",
        seat_balance=seat_balance, pilot_pressure=PILOT,
    )  # fmt: skip
    return Circuit(
        {
            "supply": Reservoir(pressure=SUPPLY),
            "room": Reservoir(pressure=AMBIENT),
            "valve": valve,
            "tank": Chamber(volume="0.2 m^3", thermal="polytropic", polytropic_exponent=1.04),
        }
    )


def settled_pressure(seat_balance: float) -> float:
    """Where the plate returns to stroke zero: F_pre + phi A_seat (p1 - p2) = S (p_p - (p2 - p_atm))."""
    preload = sum(
        NUMBERS[f"{spring}_spring.rate"] * NUMBERS[f"{spring}_spring.preload"] for spring in ("upper", "lower")
    )
    plate, seat = NUMBERS["plate_area"], seat_balance * NUMBERS["seat_area"]
    return (plate * PILOT - preload - seat * SUPPLY) / (plate - seat)


@pytest.mark.parametrize("seat_balance", [0.0, 1.0])
def test_filling_times(seat_balance):
    recording = regulator(seat_balance).simulate("80 s", "0.02 s", 1e-8)
    for pressure, time in TIMES.items():
        reached = np.interp(pressure, recording["tank.pressure"], recording.time)
        assert reached == pytest.approx(time, abs=0.06)


@pytest.mark.parametrize(("seat_balance", "printed"), [(0.0, 5.20e5), (1.0, 5.11e5)])
def test_settles_at_the_balance_of_forces(seat_balance, printed):
    assert settled_pressure(seat_balance) == pytest.approx(printed, abs=0.005e5)
    recording = regulator(seat_balance).simulate("1 h", "10 s", 1e-8)
    assert recording["tank.pressure"][-1] == pytest.approx(settled_pressure(seat_balance), abs=20.0)
    assert recording["valve.stroke"][-1] == pytest.approx(0.0, abs=1e-8)


def test_steady_state_is_where_the_transient_goes():
    for seat_balance in (0.0, 1.0):
        rest = regulator(seat_balance).steady_state()
        assert rest.y["tank.pressure"] == pytest.approx(settled_pressure(seat_balance), abs=1.0)
