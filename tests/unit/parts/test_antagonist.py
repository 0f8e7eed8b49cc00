"""The way back through the law of a muscle, alone and in a pair."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from poppet import Antagonist, Circuit, Guide, InverseMuscle, Muscle, Orifice, Reservoir
from poppet.parts.part import Scope, Surroundings
from poppet.signals import Points
from refusals import refused

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
SIZE = {"nominal_length": "300 mm", "nominal_diameter": "20 mm"}
ROWS = {"contraction": [0.0, 0.2], "force_per_pressure": [2.8e-3, 8e-4], "passive_force": [100.0, -300.0]}
LAWS: dict[str, dict[str, Any]] = {
    "sarosi": {"data": "dmsp_20_300"},
    "chou_hannaford": {"law": "chou_hannaford", **SIZE, "braid_angle": "25 deg", "highest_pressure": "6 bar g"},
    "tondu_lopez": {"law": "tondu_lopez", **SIZE, "braid_angle": 0.4, "end_factor": 1.2, "highest_pressure": "7 bar"},
    "table": {"law": "table", **SIZE, "force_table": ROWS, "highest_pressure": "6 bar g"},
}  # fmt: skip
PAIR = {"data": "dmsp_20_300", "pulley_radius": 0.025, "lowest_pressure": "0.3 bar g"}


def outputs(part: Any, **inputs: float) -> dict[str, float]:
    """What the part gives, pressures as gauge pressures."""
    numbers = part.parameters(AIR)
    usual = {
        each.name: numbers[each.default] if isinstance(each.default, str) else each.default for each in part.inputs()
    }
    given = part.control(Scope(numbers, {}, usual | inputs, AIR)).outputs
    return {name: value - 1e5 if unit == "Pa" else value for name, (value, unit) in given.items()}


def law_of(part: Any) -> Any:
    return part.force_law(part.parameters(AIR))


@pytest.mark.parametrize("fields", LAWS.values(), ids=LAWS)
def test_the_pressure_gives_the_force(fields):
    part = InverseMuscle(**fields)
    for pressure, contraction in ((1e5, 0.02), (3e5, 0.1), (5.5e5, 0.18)):
        force = law_of(part).force(pressure, contraction)
        assert outputs(part, force=force, contraction=contraction)["pressure"] == pytest.approx(pressure, rel=1e-12)


@pytest.mark.parametrize("fields", LAWS.values(), ids=LAWS)
@pytest.mark.parametrize("contraction", [0.05, 0.6])  # within its way, and far beyond
def test_pressures_stay_within_their_limits(fields, contraction):
    part = InverseMuscle(**fields, lowest_pressure="0.2 bar g")
    assert outputs(part, force=-1e4, contraction=contraction)["pressure"] == pytest.approx(2e4)
    assert outputs(part, force=1e5, contraction=contraction)["pressure"] == pytest.approx(6e5)


def test_a_controller_may_reckon_with_other_numbers_than_its_muscle():
    wrong, right = InverseMuscle(data="dmsp_20_300", sarosi={"a5": 2.2e-3}), InverseMuscle(data="dmsp_20_300")
    force = law_of(wrong).force(3e5, 0.1)
    assert outputs(wrong, force=force, contraction=0.1)["pressure"] == pytest.approx(3e5)
    assert outputs(right, force=force, contraction=0.1)["pressure"] < 2.8e5


def test_a_muscle_pulls_with_the_wanted_force_while_it_is_moved():
    """Through the trace, with a valve that is ideal: a reservoir whose pressure is the wanted one."""
    parts = {
        "inverse": InverseMuscle(data="dmsp_20_300"),
        "air": Reservoir(pressure="1 bar"),
        "line": Orifice(from_="air", to="muscle", sonic_conductance="20 dm^3/(s bar)", critical_ratio=0.3),
        "muscle": Muscle(body="arm", data="dmsp_20_300", wall_conductance=1.0),
        "arm": Guide(position="20 mm"),
    }
    links = {"inverse.contraction": "muscle.contraction", "air.pressure": "inverse.pressure"}
    signals = {
        "inverse.force": Points([0.0, 0.5, 2.0], [100.0, 300.0, 300.0]),
        "arm.position": Points([0.0, 1.0, 2.0], [0.02, 0.02, 0.05]),
    }
    run = Circuit(parts, signals, connections=links).simulate("2 s", "10 ms")
    late = run.time > 0.1  # until then the muscle is filled
    assert np.abs(run["muscle.force"] - run["inverse.force"])[late].max() < 1.0
    assert np.ptp(run["inverse.pressure"][run.time > 1.0]) > 1e5  # which the motion asks for


@pytest.mark.parametrize("torque", [0.0, 3.0, -3.0])
@pytest.mark.parametrize("contractions", [(0.1, 0.1), (0.08, 0.12), (0.13, 0.07)])
def test_a_pair_gives_torque_and_mean_pressure(torque, contractions):
    part = Antagonist(**PAIR)
    flexed, extended = contractions
    given = outputs(part, torque=torque, mean_pressure=4e5, flexor_contraction=flexed, extensor_contraction=extended)
    first, second = given["flexor_pressure"], given["extensor_pressure"]
    law = law_of(part)
    assert 0.025 * (law.force(first, flexed) - law.force(second, extended)) == pytest.approx(torque, abs=1e-9)
    assert given["given_torque"] == pytest.approx(torque, abs=1e-9)
    assert (first + second) / 2.0 == pytest.approx(3e5, rel=1e-12)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_torque_counts_more_than_the_mean(sign):
    part, law = Antagonist(**PAIR), law_of(Antagonist(**PAIR))
    given = outputs(part, torque=sign * 10.0, mean_pressure=3e5, flexor_contraction=0.1, extensor_contraction=0.1)
    pulls, yields = (given[name] for name in ("flexor_pressure", "extensor_pressure")[:: int(sign)])
    # The one that yields stays just taut, which is more than the mean would ask for.
    assert law.force(yields, 0.1) == pytest.approx(0.0, abs=1e-9)
    assert 0.025 * law.force(pulls, 0.1) == pytest.approx(10.0)
    assert given["given_torque"] == pytest.approx(sign * 10.0)
    assert pulls + yields > 4.1e5


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_torque_beyond_both_limits_is_limited(sign):
    part, law = Antagonist(**PAIR), law_of(Antagonist(**PAIR))
    given = outputs(part, torque=sign * 500.0, mean_pressure=2.5e5, flexor_contraction=0.1, extensor_contraction=0.1)
    pulls, yields = (given[name] for name in ("flexor_pressure", "extensor_pressure")[:: int(sign)])
    assert pulls == pytest.approx(6e5)
    assert yields >= 3e4
    assert sign * given["given_torque"] == pytest.approx(0.025 * law.force(6e5, 0.1))


def test_one_muscle_alone_gives_the_torque_where_the_other_hangs_loose():
    inputs = {"mean_pressure": 2.5e5, "flexor_contraction": 0.3, "extensor_contraction": 0.02}
    given = outputs(Antagonist(**PAIR), torque=-5.0, **inputs)
    assert given["given_torque"] == pytest.approx(-5.0)


def test_a_pressure_at_its_limit_has_a_note():
    links = {"inverse.contraction": "muscle.contraction", "air.pressure": "inverse.pressure"}
    parts = {
        "inverse": InverseMuscle(data="dmsp_20_300", highest_pressure="5 bar g"),
        "air": Reservoir(pressure="1 bar"),
        "line": Orifice(from_="air", to="muscle", sonic_conductance="1 dm^3/(s bar)", critical_ratio=0.3),
        "muscle": Muscle(body="arm", data="dmsp_20_300"),
        "arm": Guide(position="30 mm"),
    }
    signals = {"inverse.force": Points([0.0, 0.1, 0.2], [0.0, 0.0, 2000.0])}
    run = Circuit(parts, signals, connections=links).simulate("0.2 s", "1 ms")
    (note,) = (each for each in run.remarks if each.code == "muscle.at_limit")
    first = int(np.flatnonzero(run["inverse.pressure"] >= 6e5)[0])
    assert (note.address, note.facts["time"]) == ("inverse.pressure", run.time[first])
    assert note.facts["limit_bar"] == pytest.approx(6.0)


@pytest.mark.parametrize(
    ("fields", "code"),
    [
        ({"lowest_pressure": "0.5 bar"}, "muscle.no_range"),  # below the ambient pressure: absolute was not meant
        ({"lowest_pressure": "6 bar g"}, "muscle.no_range"),
        ({"data": "vppm_6l"}, "library.unknown"),
        ({"law": "table"}, "muscle.law_needs"),
        ({"pulley_radius": "0 mm"}, "fields.out_of_range"),
    ],
)
def test_numbers_that_cannot_be(fields, code):
    with refused(code):
        Antagonist(**{**PAIR, **fields}).parameters(AIR)
