"""Tests of the tuning for any quantity: closed forms, runs, cascades, stiction, units."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.signal import cont2discrete

from poppet import Chamber, Circuit, FlowSource, Joint, Muscle, Orifice, Reservoir
from poppet.control import compare, margins, plant_of, schedule, tune
from poppet.control.metrics import metrics_in, readable_metric_unit, step_metrics
from poppet.core.errors import SimulationError
from poppet.parts import PID, InverseMuscle
from poppet.signals import Steps
from position_drive import BORE, DEAD, DENSITY, GAS, LAG, LEVEL, LOAD, SONIC, SUPPLY, TIME, VISCOUS, drive
from refusals import refused


def closed_form():
    """Return the isothermal state space at mid stroke with choked flows, from opening to sensor."""
    area = np.pi / 4.0 * BORE**2
    volume = area * 0.1 + DEAD
    stiffness = 2.0 * LEVEL * area**2 / volume
    push = area * GAS / volume * SONIC * DENSITY * (SUPPLY + LEVEL)  # of the gas that an opening lets in and out
    a = np.array([[0, 1, 0, 0], [0, -VISCOUS / LOAD, 1 / LOAD, 0], [0, -stiffness, 0, 0], [1 / LAG, 0, 0, -1 / LAG]])
    return a, np.array([[0.0], [0.0], [push], [0.0]]), np.array([[0.0, 0.0, 0.0, 1.0]]), np.zeros((1, 1))


@cache
def plant_at(position):
    plant = plant_of(drive())
    return plant, plant.operating_point(position)


def sampled_closed_form(z):
    """Return the response of the closed form with a zero-order hold."""
    a, b, c, _, _ = cont2discrete(closed_form(), TIME)
    return np.array([(c @ np.linalg.solve(point * np.eye(4) - a, b))[0, 0] for point in z])


@pytest.mark.parametrize("branch", ["fill", "vent"])
def test_position_plant_equals_the_closed_form(branch):
    """The plant is an integrator with a gas spring; the pole at z = 1 remains exact."""
    plant, point = plant_at("100 mm")
    assert set(point.models) == {"fill", "vent"}
    assert (point.value, point.command) == (0.1, 0.0)
    ours = plant.sampled(point, branch)
    z = ours.at(np.geomspace(1e-3, 100.0, 40))
    assert np.max(np.abs(ours.response(z) / sampled_closed_form(z) - 1.0)) < 2e-3
    poles = np.linalg.eigvals(ours.A)
    assert np.min(np.abs(poles - 1.0)) < 1e-9
    assert margins(ours, tuned().points[0].gains).is_stable


@cache
def tuned():
    return tune(drive(), at=["80 mm", "100 mm"])


def test_position_gains_keep_the_bound_on_the_closed_form():
    (point,) = tuned().points
    z = np.exp(2j * np.pi * np.geomspace(1e-3, 0.5 / TIME, 4000) * TIME)
    loop = sampled_closed_form(z) * point.gains.gain * (1.0 + TIME / point.gains.integral_time / (z - 1.0))
    peaks = np.max(np.abs(1.0 / (1.0 + loop))), np.max(np.abs(loop / (1.0 + loop)))
    reported = point.margins["100 mm, fill"]
    assert peaks == pytest.approx((reported.sensitivity, reported.complementary), rel=5e-3)
    assert max(max(m.sensitivity, m.complementary) for m in point.margins.values()) == pytest.approx(1.4, rel=2e-3)
    assert tuned().bound_text == "Ms, Mt <= 1.4 filling and venting at 80, 100 mm"
    assert tuned().command_text == "at rest"
    fields = tuned().fields()
    assert (fields["gain"].unit, fields["vent_factor"].unit) == ("1/m", "1")
    last = tuned().applied(drive()).simulate("6 s", "10 ms")["slide.position"][-1]
    assert last == pytest.approx(0.13, abs=2e-4)


@pytest.mark.parametrize("by", ["measurement", "setpoint"])
def test_tuned_gains_do_not_depend_on_the_vent_factors_of_a_schedule(by):
    """The response of the vent valve is that without the vent factor of the circuit, also of a schedule."""
    table = {"position": [0.05, 0.15], "gain": [2.0, 3.0], "integral_time": [1.0, 1.0], "vent_factor": [1.0, 3.0]}
    scheduled = drive(gain=None, schedule=table, schedule_by=by)
    (found,), (expected,) = (tune(circuit, at=["120 mm"]).points for circuit in (scheduled, drive()))
    assert found.vent_factor == pytest.approx(expected.vent_factor, rel=1e-4)
    assert found.gains.gain == pytest.approx(expected.gains.gain, rel=1e-4)
    # At 120 mm, the schedule has 2.7 1/m and a vent factor of 2.4.
    gains = tune(drive(), at=["120 mm"]).gains_of(scheduled)
    assert gains["120 mm, fill"].gain == pytest.approx(2.7)
    assert gains["120 mm, vent"].gain == pytest.approx(2.7 * 2.4 / expected.vent_factor)


def test_position_schedule_contains_positions():
    tuning = schedule(drive(), at=["60 mm", "140 mm"])
    assert tuning.fields()["schedule"].numbers()["position_2"].value == pytest.approx(0.14)
    assert '[parts.c.schedule]\nposition = ["60 mm", "140 mm"]' in tuning.text()
    assert tuning.applied(drive()).parameters["c.schedule.position_1"] == pytest.approx(0.06)


def test_stiction_is_replaced_by_viscous_friction_with_a_note():
    stuck = {"kind": "lugre", "coulomb_force": 20.0, "static_force": 30.0, "viscous_coefficient": VISCOUS}
    tuning = tune(drive(stuck), at=["80 mm", "100 mm"])
    assert tuning.points[0].gains == tuned().points[0].gains
    # The linear model omits the stick-slip of the integral, which the step of working size shows.
    sliding, swings = tuning.notes
    assert (sliding.code, sliding.address, swings.code) == ("plant.sliding", "slide.friction", "tuning.swings")
    assert (tuning.notes[0].facts["value"], tuning.notes[0].facts["unit"]) == (VISCOUS, "N s/m")
    assert tuned().notes == ()


def test_single_command_has_a_model_on_both_sides():
    """A piston with a rod has different responses to commands of both signs."""
    ring = 1.0 - (16.0 / 25.0) ** 2
    fields = {"spool": {"lag": "4 ms"}, "rod": "16 mm", "mid": 0.09, "level": (LEVEL - 1e5 * (1.0 - ring)) / ring}
    plant = plant_of(drive(**fields))
    point = plant.operating_point("90 mm")
    assert set(point.models) == {"command", "back"}
    forth, back = (plant.sampled(point, branch) for branch in ("command", "back"))
    z = forth.at(np.array([0.05]))
    assert abs(forth.response(z)[0] / back.response(z)[0]) != pytest.approx(1.0, rel=0.05)
    # Both against runs that open by a thousandth either way: the way in 0.3 s.
    for plant_, sign in ((forth, 1.0), (back, -1.0)):
        by_hand = {"c.automatic": Steps([0.0], [0.0]), "c.manual_command": Steps([0.0], [sign * 1e-3])}
        position = replace(drive(**fields), signals=by_hand).simulate("0.3 s", "0.02 s", 1e-8)["slide.position"]
        x, positions = np.zeros(len(plant_.B)), [0.0]
        for _ in range(150):
            x = plant_.A @ x + plant_.B * sign * 1e-3
            positions.append(float(plant_.C @ x))
        assert position[-1] - position[0] == pytest.approx(positions[-1], rel=0.01)


def cascade(*, inner_first=False, **outer):
    """Return a cascade on an isothermal tank: the outer loop sets the pressure setpoint of the inner loop."""
    pressure = {"quantity": "pressure", "command_quantity": "pressure", "lower_limit": 0.0, "upper_limit": "9 bar"}
    loops = {
        "outer": PID(**pressure | {"gain": 0.5, "integral_time": 0.02, "sample_time": 5e-3} | outer),
        "inner": PID(command_quantity="mass_flow", gain=2e-6, sample_time=1e-3, lower_limit=-1.0, upper_limit=1.0),
    }
    if inner_first:
        loops = dict(reversed(loops.items()))
    parts = loops | {
        "source": FlowSource(to="tank"),
        "tank": Chamber(volume="1 l", thermal="isothermal", initial_pressure="3 bar"),
    }
    joined = {"outer.measurement": "tank.pressure", "inner.measurement": "tank.pressure",
              "inner.setpoint": "outer.command", "source.mass_flow_rate": "inner.command"}  # fmt: skip
    return Circuit(parts, {"outer.setpoint": Steps([0.0], [3e5])}, connections=joined)


@pytest.mark.parametrize("inner_first", [False, True])
def test_outer_loop_of_a_cascade_is_exact(inner_first):
    """The inner loop gives p+ = p + T b K (w - p) five times; a later outer command is delayed by a fifth."""
    plant = plant_of(cascade(inner_first=inner_first), "outer")
    point = plant.operating_point("4 bar")
    assert point.command == pytest.approx(4e5, rel=1e-9)
    ours = plant.sampled(point, "command")
    pole = 1.0 - 1e-3 * 2e-6 * GAS / 1e-3
    z = ours.at(np.geomspace(0.01, 100.0, 30))
    expected = (1.0 - pole**5) / (z - pole**5)
    if inner_first:
        expected = ((1.0 - pole**4) + pole**4 * (1.0 - pole) / z) / (z - pole**5)
    assert np.max(np.abs(ours.response(z) / expected - 1.0)) < 1e-9
    assert ours.sample_time == pytest.approx(5e-3)


def test_gains_of_an_outer_loop_keep_the_bound():
    tuning = tune(cascade(), "outer", at=["4 bar"], sensitivity=1.6)
    gains, pole = tuning.points[0].gains, 1.0 - 1e-3 * 2e-6 * GAS / 1e-3
    z = np.exp(1j * np.geomspace(1e-5, np.pi, 20_000))
    loop = (1.0 - pole**5) / (z - pole**5) * gains.gain * (1.0 + 5e-3 / gains.integral_time / (z - 1.0))
    peak = max(np.max(np.abs(1.0 / (1.0 + loop))), np.max(np.abs(loop / (1.0 + loop))))
    assert peak == pytest.approx(1.6, rel=2e-3)
    assert tuning.command_text == "held by a command of 4 bar"
    assert tuning.fields()["gain"].unit == "Pa/Pa"
    assert "vent_factor" not in tuning.fields()
    assert list(tuning.points[0].margins) == ["4 bar, command"]


def test_inner_loop_is_tuned_without_outer_loops():
    """The plant p+ = p + T b u has a closed form of the largest gain with Ms, Mt <= 1.4."""
    tuning = tune(cascade(), "inner", at=["4 bar"], form="p")
    # L = k / (z - 1): Ms is met at z = -1, 1 / (1 - k / 2); Mt there is (k / 2) / (1 - k / 2).
    expected = 2.0 * (1.0 - 1.0 / 1.4) / (1e-3 * GAS / 1e-3)
    assert tuning.points[0].gains.gain == pytest.approx(expected, rel=2e-3)
    assert tuning.quantity, tuning.command_quantity == ("pressure", "mass_flow")


def test_inner_loop_with_kink_has_a_model_on_both_sides():
    """Small steps of a run follow the model of their side if filling and venting differ."""
    orifice = {"sonic_conductance": SONIC, "critical_ratio": 0.3}
    loops = {"outer": PID(quantity="pressure", command_quantity="pressure", gain=1.0, sample_time=5e-3,
                          lower_limit=0.0, upper_limit=9e5, bias=2e5),
             "inner": PID(gain=2e-5, sample_time=1e-3)}  # fmt: skip
    parts = loops | {
        "supply": Reservoir(pressure="7 bar"),
        "fill": Orifice(from_="supply", to="tank", **orifice),
        "vent": Orifice(from_="tank", to="ambient", **orifice),
        "tank": Chamber(volume="1 l", thermal="isothermal", initial_pressure=2e5),
    }
    joined = {"outer.measurement": "tank.pressure", "inner.measurement": "tank.pressure",
              "inner.setpoint": "outer.command", "fill.opening": "inner.fill_command",
              "vent.opening": "inner.vent_command"}  # fmt: skip
    circuit = Circuit(parts, connections=joined)
    plant = plant_of(circuit, "outer")
    point = plant.operating_point(2e5)
    assert set(point.models) == {"command", "back"}
    for branch, sign in (("command", 1.0), ("back", -1.0)):
        by_hand = {
            "outer.automatic": Steps([0.0], [0.0]),
            "outer.manual_command": Steps([0.0, 0.1], [2e5, 2e5 + sign * 20.0]),
        }
        run = replace(circuit, signals=by_hand).simulate(0.2, 5e-3, 1e-10)
        model = plant.sampled(point, branch)
        x, expected = np.zeros(len(model.B)), []
        for _ in range(20):
            expected.append(float(model.C @ x))
            x = model.A @ x + model.B * sign * 20.0
        assert np.max(np.abs(run["tank.pressure"][20:40] - 2e5 - expected)) < 1e-3 * abs(expected[-1])
        assert abs(expected[-1]) > 1.0


@pytest.mark.parametrize(
    ("fields", "at", "code"),
    [
        ({"spool": {"overlap": 0.05}}, "100 mm", "plant.dead_zone"),
        ({"direction": -1.0}, "-50 mm", "plant.wrong_way"),
    ],
)
def test_plants_without_gains_are_rejected(fields, at, code):
    direction = fields.pop("direction", None)
    circuit = drive(**fields)
    if direction:
        slide = replace(circuit.parts["slide"], initial_position=-0.1)
        turned = {"cylinder": replace(circuit.parts["cylinder"], direction=-1.0), "slide": slide}
        circuit = replace(circuit, parts={**circuit.parts, **turned})
    with refused(code, "slide.position", kind=Exception):
        plant_of(circuit).operating_point(at)


def test_incompatible_sample_times_are_rejected():
    with refused("plant.other_period", "outer", period=pytest.approx(15e-3)):
        plant_of(cascade(sample_time=7.5e-3), "outer").operating_point("3 bar")


def test_metrics_have_the_units_of_the_loop():
    figures = metrics_in("rad", "N m")
    assert {name: figure.unit for name, figure in figures.items()} == {
        "IAE": "rad s", "ITAE": "rad s^2", "rise_time": "s", "settling_time": "s", "overshoot": "%", "travel": "N m",
    }  # fmt: skip
    assert [readable_metric_unit(figures[name], "rad", "N m") for name in ("IAE", "ITAE", "travel")] == [
        "deg s",
        "deg s^2",
        "N m",
    ]
    assert readable_metric_unit(metrics_in("m/s")["ITAE"], "m/s") == "(mm/s) s^2"
    assert [readable_metric_unit(metrics_in("K")["IAE"], "K"), readable_metric_unit(metrics_in("Pa")["IAE"], "Pa")] == [
        "K s",
        "bar s",
    ]
    time = np.linspace(0.0, 1.0, 1001)
    metrics = step_metrics(
        time, np.where(time < 0.1, 0.0, 1.0), np.where(time < 0.2, 0.0, 1.0), np.cos(7.0 * np.pi * time)
    )
    assert metrics["IAE"] == pytest.approx(0.1, abs=1e-3)
    assert metrics["travel"] == pytest.approx(14.0, abs=1e-3)
    assert "switches" not in metrics


def test_position_loops_are_compared_in_their_units():
    rough = {"kind": "lugre", "coulomb_force": 12.0, "static_force": 15.0, "viscous_coefficient": VISCOUS}
    contenders = {name: replace(drive(rough, wall=0.5, gain=gain), run=replace(drive().run, duration="1.5 s"))
                  for name, gain in (("slow", "1 1/m"), ("quick", "3 1/m"))}  # fmt: skip
    comparison = compare(contenders, vary={"slide.mass": 0.4, "slide.friction.coulomb_force": 0.3}, draws=2, seed=1)
    assert comparison.units == ("m", "1")
    assert (comparison.quantity, comparison.command_quantity) == ("position", "opening")
    assert comparison.responses["slow"].shape == (3, comparison.time.size)
    assert np.ptp(comparison.responses["quick"][0]) > 0.02
    assert comparison.summary()["quick"]["IAE"][0] < comparison.summary()["slow"]["IAE"][0] < 0.03 * 1.5
    with_sensor = replace(contenders["quick"].parts["c"], quantity="position", sensor={"lag": LAG, "offset": "1 mm"})
    uneven = replace(contenders["quick"], parts={**contenders["quick"].parts, "c": with_sensor})
    with refused("control.unfair", "c.sensor.offset"):
        compare({"slow": contenders["slow"], "quick": uneven})


def test_steady_state_outside_command_limits_is_rejected():
    with refused("plant.not_trimmed", "tank.pressure", kind=SimulationError):
        plant_of(cascade(), "outer").operating_point("9.5 bar")


def muscle_joint(outer, *, through_force=False, **muscle):
    """Return an arm on a muscle with a pressure loop and an outer loop, optionally with the inverse muscle law."""
    orifice = {"sonic_conductance": "0.4 dm^3/(s bar)", "critical_ratio": 0.3}
    parts = {
        "angle": outer,
        "inner": PID(gain="1 1/bar", sample_time="1 ms"),
        "supply": Reservoir(pressure="8 bar"),
        "fill": Orifice(from_="supply", to="muscle", **orifice),
        "vent": Orifice(from_="muscle", to="ambient", **orifice),
        "muscle": Muscle(data="dmsp_20_300", body="arm", dead_volume="20 cm^3", damping="200 N s/m",
                         initial_pressure="3 bar", wall_conductance=1.0, offset="-9 mm", **muscle),
        "arm": Joint(inertia="0.03 kg m^2", pulley_radius="25 mm", load_torque="5 N m", initial_position="10 deg",
                     friction={"viscous_coefficient": "0.1 N m s/rad"}),
    }  # fmt: skip
    joined = {"angle.measurement": "arm.position", "inner.measurement": "muscle.pressure",
              "inner.setpoint": "angle.command", "fill.opening": "inner.fill_command",
              "vent.opening": "inner.vent_command"}  # fmt: skip
    if through_force:
        parts["inverse"] = InverseMuscle(data="dmsp_20_300")
        joined |= {"inverse.force": "angle.command", "inverse.contraction": "muscle.contraction",
                   "inner.setpoint": "inverse.pressure"}  # fmt: skip
    return Circuit(parts, {"angle.setpoint": Steps([0.0], [np.radians(20.0)])}, connections=joined)


def test_muscle_joint_is_tuned_with_inner_pressure_loop():
    """The gains control the angle through a pressure loop; a note reports the omitted hysteresis."""
    outer = PID(quantity="angle", command_quantity="pressure", gain="0.5 bar/rad", integral_time="0.2 s",
                lower_limit="0.1 bar g", upper_limit="6 bar g", bias="2 bar g", sample_time="4 ms")  # fmt: skip
    circuit = muscle_joint(outer, hysteresis={"kind": "coulomb", "force": 3.0, "reach": "4 mm"})
    tuning = tune(circuit, "angle", at=["20 deg"])
    assert [note.code for note in tuning.notes] == ["plant.no_hysteresis"]
    assert list(tuning.points[0].margins) == ["20 deg, command", "20 deg, back"]
    assert tuning.fields()["gain"].unit == "Pa/rad"
    assert tuning.bound_text.endswith("at 20 deg")
    assert tuning.command_text.endswith("bar")
    run = tuning.applied(circuit).simulate("6 s", "20 ms")
    assert run["arm.position"][-1] == pytest.approx(np.radians(20.0), abs=np.radians(0.2))
    assert run["muscle.pressure"][-1] == pytest.approx(tuning.points[0].commands[0], rel=0.05)


def test_muscle_joint_is_tuned_with_inverse_muscle_law():
    """Force times radius equals the load at any angle, so the plant has a pole at one."""
    outer = PID(quantity="angle", command_quantity="force", gain="300 N/rad", derivative_time="50 ms",
                lower_limit="0 N", upper_limit="900 N", bias="150 N", sample_time="4 ms")  # fmt: skip
    plant = plant_of(muscle_joint(outer, through_force=True), "angle")
    for angle in ("15 deg", "25 deg"):
        point = plant.operating_point(angle)
        assert point.command == pytest.approx(5.0 / 25e-3, rel=1e-6)
        for branch in point.models:
            poles = np.linalg.eigvals(plant.sampled(point, branch).A)
            assert np.min(np.abs(poles - 1.0)) < 1e-6
