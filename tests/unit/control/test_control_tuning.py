"""Tests of margins with closed forms, of the bound of tunings, of operating points and errors."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from poppet import Chamber, Circuit, InputError, Orifice, OutOfRangeError, Reservoir, SimulationError
from poppet.control import Gains, SampledPlant, Tuning, margins, plant_of, schedule, tune
from poppet.control.loop import closed_loop, step_response
from poppet.laws.physics.pressure_rates import open_rates
from poppet.parts import PID, Electronics, PilotStage, PressureController
from poppet.signals import Steps

T = 2e-3
VALVE = {"sonic_conductance": 5e-9, "critical_ratio": 0.35}


def tank_loop(controller=None, chamber=None, more=None, vent=True, signals=None):
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "fill": Orifice(from_="supply", to="tank", **VALVE),
        "vent": Orifice(from_="tank", to="ambient", **VALVE, opening=0.0),
        "tank": Chamber(volume="1 l", **(chamber or {"thermal": "isothermal"})),
        "c": controller or PID(gain=1e-5, sample_time=T, sensor={"lag": "3 ms"}, acts="next_sample", setpoint="3 bar"),
    } | (more or {})
    joined = {"c.measurement": "tank.pressure", "fill.opening": "c.fill_command"}
    return Circuit(parts, signals or {}, connections=joined | ({"vent.opening": "c.vent_command"} if vent else {}))


ONE, TWO = ("3 bar",), ("2 bar", "5 bar")


@cache
def tuned(form, bound, at):
    """Return the point of a tuning; equal arguments reuse it."""
    (point,) = tune(tank_loop(), at=at, form=form, sensitivity=bound).points
    return point


def test_margins_of_an_integrator_have_closed_forms():
    """The loop L = a/(z - 1) has a real part of -a/2, with the minimum of |1 + L| at half the sampling frequency."""
    a = 0.3
    computed = margins(SampledPlant(np.eye(1), np.array([a]), np.ones(1), T), Gains(1.0))
    assert computed.is_stable
    assert computed.gain_margin == pytest.approx(2.0 / a, rel=1e-6)
    assert computed.sensitivity == pytest.approx(1.0 / (1.0 - a / 2.0), rel=1e-6)
    angle = 2.0 * np.arcsin(a / 2.0)
    assert computed.crossover == pytest.approx(angle / (2.0 * np.pi * T), rel=1e-5)
    assert computed.phase_margin == pytest.approx(90.0 - np.degrees(angle) / 2.0, rel=1e-5)
    assert computed.delay_margin == pytest.approx(np.radians(computed.phase_margin) / (angle / T), rel=1e-4)


@pytest.mark.parametrize("delay", [0, 1, 2, 3])
def test_the_gain_margin_is_the_limit_of_stability(delay):
    plant = SampledPlant(np.eye(1), np.array([0.1]), np.ones(1), T, delay)
    margin = margins(plant, Gains(1.0)).gain_margin
    # 2 sin(pi/(2 (2 d + 1))) is the greatest gain of an integrator behind d samples of delay.
    assert 0.1 * margin == pytest.approx(2.0 * np.sin(np.pi / (2.0 * (2 * delay + 1))), rel=1e-4)
    assert margins(plant, Gains(0.999 * margin)).is_stable
    assert not margins(plant, Gains(1.001 * margin)).is_stable


@pytest.mark.parametrize("delay", [0, 1, 2])
def test_closed_loop_has_the_response_of_plant_and_controller(delay):
    gains = Gains(0.7, 0.03, 4e-3, 1e-3)
    plant = SampledPlant(np.array([[0.98, 0.01], [0.0, 0.9]]), np.array([0.01, 0.1]), np.array([1.0, 0.5]), T, delay)
    z = plant.at(np.array([0.5, 5.0, 60.0, 200.0]))
    a, b, c = closed_loop(plant, gains)
    response = np.array([c @ np.linalg.solve(point * np.eye(len(b)) - a, b) for point in z])
    integral_and_gain = Gains(0.7, 0.03).response(z, T)  # the derivative sees no setpoint
    loop = plant.response(z) * gains.response(z, T)
    assert np.max(np.abs(response - plant.response(z) * integral_and_gain / (1.0 + loop))) < 1e-9


def test_unstable_loop_is_detected():
    circuit = plant_of(tank_loop())
    plant = circuit.sampled(circuit.operating_point("3 bar"), "fill")
    computed = margins(plant, Gains(5e-3, 0.01))
    assert not computed.is_stable
    assert np.max(np.abs(step_response(plant, Gains(5e-3, 0.01), 1.0, 400))) > 1e3


def test_plant_of_isothermal_tank_is_an_integrator():
    """The pressure slope per opening of an isothermal tank is the rate of the open valve."""
    plant = plant_of(tank_loop())
    assert plant.measurement == "tank.pressure"
    point = plant.operating_point("3 bar")
    assert point.command == 0.0
    assert set(point.models) == {"fill", "vent"}
    sizes = {"fill": tuple(VALVE.values()), "vent": tuple(VALVE.values())}
    vessel = {"volume": 1e-3, "exponent": 1.0, "gas_constant": 287.05}
    rates = open_rates(3e5, 7e5, 1e5, gas_temperature=293.15, supply_temperature=293.15, **sizes, **vessel)
    for branch, rate in zip(("fill", "vent"), rates, strict=True):
        model, ((address, weight),) = point.models[branch], point.weights[branch].items()
        row = model.outputs.index("tank.pressure")
        gain = weight * model.C[row] @ model.B[:, model.inputs.index(address)]
        assert gain == pytest.approx(rate, rel=1e-5)


@pytest.mark.parametrize(
    ("form", "bound", "at"), [("p", 1.4, TWO), ("pi", 1.4, TWO), ("pid", 1.4, ONE), ("pi", 2.0, TWO)]
)
def test_tuned_loops_keep_the_bound_and_use_it(form, bound, at):
    """The check uses the linear model with explicit hold and delays, not the responses of the tuner."""
    point = tuned(form, bound, at)
    assert point.is_stable
    gains, plant = point.gains, plant_of(tank_loop())
    frequencies = np.geomspace(1e-3, 0.4999 / T, 20001)
    s = 2j * np.pi * frequencies
    worst = 0.0
    for pressure in at:
        operating_point = plant.operating_point(pressure)
        for branch, model in operating_point.models.items():
            ((address, weight),) = operating_point.weights[branch].items()
            slope = weight * (model.C[model.outputs.index("tank.pressure")] @ model.B[:, model.inputs.index(address)])
            factor = point.vent_factor if branch == "vent" else 1.0
            # Step-invariant discretisation of k/(s (tau s + 1)), from tables of the z transform, and one sample more.
            z, tau = np.exp(s * T), 3e-3
            pole = np.exp(-T / tau)
            lag = (T - tau * (1.0 - pole)) * z + tau * (1.0 - pole) - T * pole
            response = factor * slope * lag / ((z - 1.0) * (z - pole)) / z
            loop = response * gains.response(z, T)
            worst = max(worst, np.max(1.0 / np.abs(1.0 + loop)), np.max(np.abs(loop / (1.0 + loop))))
    assert 0.97 * bound < worst <= bound * 1.001


def test_larger_bound_gives_larger_gains():
    cautious, bold = (tuned("pi", bound, TWO).gains for bound in (1.4, 2.0))
    assert bold.gain / bold.integral_time > 2.0 * cautious.gain / cautious.integral_time


def test_derivative_increases_the_integral_gain():
    pi, pid = (tuned(form, 1.4, ONE).gains for form in ("pi", "pid"))
    assert pid.gain / pid.integral_time > 1.05 * pi.gain / pi.integral_time


def test_vent_factor_equalises_both_sides():
    point = tuned("pi", 1.4, ONE)
    fill, vent = point.margins.values()
    assert fill.sensitivity == pytest.approx(vent.sensitivity, rel=1e-3)
    assert point.vent_factor > 1.5


def test_a_schedule_has_a_point_for_each_pressure():
    circuit = tank_loop(signals={"c.setpoint": Steps([0.0, 1.0, 2.0], [2e5, 5e5, 2e5])})
    tuning = schedule(circuit)
    assert [point.values[0] for point in tuning.points] == pytest.approx([2e5, 5e5])
    assert all(m.sensitivity <= 1.4 for point in tuning.points for m in point.margins.values())
    applied = tuning.applied(circuit)
    assert applied.parameters["c.schedule.gain_1"] == tuning.points[0].gains.gain
    assert applied.numbers()["c.schedule.gain_1"].source.kind == "fitted"
    recording = applied.simulate("9 s", "10 ms")
    assert abs(recording["tank.pressure"][-1] - 2e5) < 100.0
    # The gains that a controller has do not count when it is tuned.
    (point_at_5_bar,) = tune(applied, at=[5e5]).points
    assert point_at_5_bar.gains.gain == pytest.approx(tuning.points[1].gains.gain)


def test_leak_needs_a_steady_opening():
    leak = Orifice(from_="tank", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3)
    plant = plant_of(tank_loop(more={"leak": leak}, chamber={"wall_conductance": 1.0}))
    point = plant.operating_point("2 bar g")
    assert point.value == pytest.approx(3e5, rel=1e-4)
    assert 0.05 < point.command < 0.2
    assert set(point.models) == {"fill", "vent"}
    with pytest.raises(SimulationError) as caught:
        plant.operating_point("12 bar")
    note = caught.value.note
    assert (note.code, note.address, note.facts["wanted"]) == ("plant.not_held", "tank.pressure", 1.2e6)


def test_pilot_stage_is_tuned():
    pilot = PilotStage(
        supply="supply", exhaust="ambient", volume="20 cm^3",
        fill={"sonic_conductance": 1e-9}, vent={"sonic_conductance": 1e-9},
    )  # fmt: skip
    circuit = Circuit(
        {"supply": Reservoir(pressure="7 bar"), "pilot": pilot, "c": PID(gain=1e-5, setpoint="3 bar")},
        connections={
            "c.measurement": "pilot.pressure",
            "pilot.fill_duty": "c.fill_command",
            "pilot.vent_duty": "c.vent_command",
        },
    )
    tuning = tune(circuit)
    assert tuning.points[0].is_stable
    assert abs(tuning.applied(circuit).simulate("1 s", "1 ms")["pilot.pressure"][-1] - 3e5) < 10.0
    dead = circuit.with_values({"pilot.fill.opening_delay": "1 ms", "pilot.vent.opening_delay": "1 ms"})
    with pytest.raises(InputError) as caught:
        tune(dead)
    assert caught.value.code == "plant.dead_zone"


def test_the_text_is_a_table_of_a_circuit_file():
    import tomllib

    point = tuned("pi", 1.4, ONE)
    table = tomllib.loads(Tuning("c", (point,), 1.4, "pi").text())["parts"]["c"]
    assert PID(**table).numbers()["gain"].value == pytest.approx(point.gains.gain, rel=1e-5)


PLANT_MODEL = {"volume": "1 l", "fill": VALVE, "vent": VALVE, "supply_pressure": "7 bar", "time_constant": 0.05}


@pytest.mark.parametrize(
    ("circuit", "options", "error", "code"),
    [
        (tank_loop(), {"form": "pdf"}, InputError, "fields.not_an_option"),
        (tank_loop(), {"sensitivity": 0.9}, OutOfRangeError, "fields.out_of_range"),
        (tank_loop(), {"at": ["9 bar"]}, InputError, "plant.beyond_supply"),
        (tank_loop(), {"at": ["0.5 bar"]}, InputError, "plant.beyond_exhaust"),
        (tank_loop(), {"at": []}, InputError, "tuning.no_point"),
        (tank_loop(), {"controller": "b"}, InputError, "names.unknown"),
        (tank_loop(PressureController(**PLANT_MODEL)), {}, InputError, "tuning.no_pid"),
        (tank_loop(more={"d": PID(gain=1.0)}), {}, InputError, "plant.several_controllers"),
        (tank_loop(more={"e": Electronics(data="vppm_6l")}), {}, InputError, "plant.also_sampled"),
        (tank_loop(more={"d": PID(gain=1.0)}), {"controller": "d"}, InputError, "plant.measures_nothing"),
        (
            Circuit({"c": Chamber(volume=1e-3), "o": Orifice(from_="c", to="ambient", **VALVE)}),
            {},
            InputError,
            "plant.no_controller",
        ),
    ],
)
def test_errors_are_reported(circuit, options, error, code):
    with pytest.raises(error) as caught:
        tune(circuit, **options)
    assert caught.value.code == code
    assert str(caught.value)


@pytest.mark.parametrize(
    ("options", "code"),
    [({"form": "p", "at": [2e5, 3e5]}, "tuning.schedule_without_integral"), ({"at": [2e5]}, "tuning.schedule_of_one")],
)
def test_invalid_schedules_are_rejected(options, code):
    with pytest.raises(InputError) as caught:
        schedule(tank_loop(), **options)
    assert caught.value.code == code
