"""Eqs (5)-(8) at rest with the assumed numbers of set A: the static map, the overlap and the resting place."""

from __future__ import annotations

import pytest

from poppet import Circuit
from poppet.library import main_stage
from poppet.parts import Chamber, MainStage, Reservoir

STATIC_MAP = {1.0: 0.138, 2.0: 0.310, 3.0: 0.482, 4.0: 0.655, 5.0: 0.827, 6.0: 0.999}
"""Pilot pressure [bar gauge] to stroke [mm]."""
NUMBERS = {name: float(number.value) for name, number in main_stage("varga2012", "paper").items()}


def stroke_at(pilot: float) -> tuple[float, float]:
    """Stroke [m] and contact code after the plate has come to rest; pilot pressure in bar gauge."""
    valve = MainStage(
        supply="supply",
        outlet="tank",
        exhaust="room",
        data="varga2012",
        mode="paper",
        pilot_pressure=1e5 * (1.0 + pilot),
    )
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "room": Reservoir(pressure="1 bar"),
        "valve": valve,
        "tank": Chamber(volume="0.2 m^3"),
    }
    recording = Circuit(parts).simulate("1 s", relative_tolerance=1e-8)
    return float(recording["valve.stroke"][-1]), float(recording["valve.contact"][-1])


def equation_5(pilot: float) -> float:
    """Stroke from k1 (h1 + x) + k2 (h2 + x) = S p_p [m]."""
    preload = sum(
        NUMBERS[f"{spring}_spring.rate"] * NUMBERS[f"{spring}_spring.preload"] for spring in ("upper", "lower")
    )
    rate = NUMBERS["upper_spring.rate"] + NUMBERS["lower_spring.rate"]
    return (NUMBERS["plate_area"] * 1e5 * pilot - preload) / rate


@pytest.mark.parametrize("pilot", STATIC_MAP)
def test_static_map(pilot):
    stroke, contact = stroke_at(pilot)
    assert stroke == pytest.approx(1e-3 * STATIC_MAP[pilot], abs=0.5e-6)
    assert stroke == pytest.approx(equation_5(pilot), rel=1e-9)
    assert contact == 1.0


@pytest.mark.parametrize("pilot", [0.105, 0.15, 0.199])
def test_a_pilot_pressure_in_the_dead_zone_holds_the_poppet_on_its_seat(pilot):
    stroke, contact = stroke_at(pilot)
    assert -NUMBERS["contact.width"] < stroke <= 0.0
    assert contact == 0.0


def test_the_dead_zone_ends_where_the_lower_spring_gives_way():
    lower = NUMBERS["lower_spring.rate"] * NUMBERS["lower_spring.preload"]
    upper = NUMBERS["upper_spring.rate"] * NUMBERS["upper_spring.preload"]
    ends = upper / NUMBERS["plate_area"] / 1e5, (upper + lower) / NUMBERS["plate_area"] / 1e5
    assert ends == pytest.approx((0.104, 0.200), abs=5e-4)
    below, above = stroke_at(ends[1] - 1e-3), stroke_at(ends[1] + 1e-3)
    assert below[0] < 0.0 < above[0]
    assert stroke_at(0.5 * ends[0])[0] < -NUMBERS["overlap"]


def test_without_pilot_pressure_the_upper_spring_opens_the_exhaust():
    stroke, contact = stroke_at(0.0)
    assert stroke == pytest.approx(-20e-6, rel=1e-9)
    assert stroke == pytest.approx(-NUMBERS["upper_spring.preload"], rel=1e-9)
    assert contact == -1.0


def test_beyond_the_range_the_upper_stop_holds():
    stroke, contact = stroke_at(7.0)
    assert 1e-3 < stroke < 1.01e-3
    assert contact == 2.0
