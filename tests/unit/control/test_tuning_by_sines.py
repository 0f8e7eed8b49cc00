"""Tests of tuning by sines: linear plants, a dead zone in closed form, limit cycles, verification steps."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from poppet import load
from poppet.control import Gains, SampledPlant, margins, tune
from poppet.control.describing_function import MeasuredPlant, make_measured_loop
from poppet.control.tuning import _GainSearch
from poppet.control.verification import Verification
from poppet.core.errors import SimulationError
from position_drive import TIME, drive
from refusals import refused
from source_files import ROOT

EXAMPLES = ROOT.parents[1] / "examples"
EVEN = 5.516e5
"""Pressure with equal inflow from 7 bar and outflow, so a sine does not change the mean [Pa]."""


def balanced_cylinder(**fields):
    """Return a controlled cylinder whose mean pressures do not change with a sine."""
    circuit = drive(**{"gain": "2 1/m", "integral_time": 0.5} | fields)
    return circuit.with_values({f"cylinder.{side}.initial_pressure": EVEN for side in ("cap", "rod")})


def measured_plant(plant, highest=0.25):
    """Return a plant from its responses at forty frequencies, up to a fraction of the sampling frequency."""
    frequencies = np.geomspace(2e-4, highest, 40) / plant.sample_time
    return MeasuredPlant(frequencies, plant.response(plant.at(frequencies)), plant.sample_time, Gains(0.01))


PLANTS = {
    "integrator and lag": SampledPlant(
        np.array([[1.0, 0.05], [0.0, 0.95]]), np.array([0.0, 0.05]), np.array([1.0, 0.0]), TIME, 1
    ),
    "lag and delay": SampledPlant(np.array([[0.98]]), np.array([0.02]), np.ones(1), TIME, 3),
}


@pytest.mark.parametrize("name", PLANTS)
def test_measured_responses_give_the_margins_of_the_plant(name):
    plant = PLANTS[name]
    for gains in (Gains(0.3), Gains(0.3, 0.2), Gains(0.5, 0.4, 0.02, 0.01)):
        exact, measured = margins(plant, gains), margins(measured_plant(plant), gains)
        assert exact.is_stable == measured.is_stable
        assert measured.sensitivity == pytest.approx(exact.sensitivity, rel=0.01)
        assert measured.complementary == pytest.approx(exact.complementary, rel=0.01)
        assert measured.crossover == pytest.approx(exact.crossover, rel=0.01)


@pytest.mark.parametrize("integral_time", [0.0, 0.05])
@pytest.mark.parametrize("name", PLANTS)
def test_measured_responses_give_the_stability_limit(name, integral_time):
    """The stability test agrees with the eigenvalues of the loop near its limit and far beyond it."""
    plant, answers = PLANTS[name], measured_plant(PLANTS[name])
    gains = np.geomspace(1e-3, 1e3, 100)
    stable = [plant.is_stable_with(Gains(gain, integral_time)) for gain in gains]
    is_stable = [answers.is_stable_with(Gains(gain, integral_time)) for gain in gains]
    assert any(stable) or integral_time
    assert not all(stable)
    assert np.count_nonzero(np.array(stable) != is_stable) <= 1


@pytest.mark.parametrize(("gain", "is_known"), [(0.02, False), (2.0, True), (300.0, False)])
def test_frequency_range_must_cover_the_loop(gain, is_known):
    """The integrator |P| = 1/(2 sin(w T/2)) is between 800 and 0.71 from 0.1 to 125 Hz."""
    plant = SampledPlant(np.eye(1), np.ones(1), np.ones(1), TIME)
    low, high = (0.5 / math.sin(math.pi * fraction) for fraction in (2e-4, 0.25))
    assert measured_plant(plant).keeps_bound_outside(Gains(0.01 * gain), 1.4) == is_known
    assert is_known == (0.01 * gain * low >= 3.5 and 0.01 * gain * high <= 1.0 - 1.0 / 1.4)


def test_unstable_plant_is_stabilised_by_the_weak_controller():
    """The loop x+ = 1.01 x + u is stable for gains from 0.01 to 2.01; it was measured with a gain of 0.1."""
    plant = SampledPlant(np.array([[1.01]]), np.ones(1), np.ones(1), TIME)
    answers = replace(measured_plant(plant, 0.5), stabilised_by=Gains(0.1))
    for gain, is_stable in ((0.005, False), (0.02, True), (1.9, True), (2.2, False)):
        assert plant.is_stable_with(Gains(gain)) == is_stable
        assert answers.is_stable_with(Gains(gain)) == is_stable


@cache
def by_sines(gain="2 1/m"):
    return tune(balanced_cylinder(gain=gain), at=["100 mm"], amplitudes=[0.02])


def test_linear_plant_has_the_gains_of_its_linear_model():
    (ours,), (linear,) = by_sines().points, tune(balanced_cylinder(), at=["100 mm"]).points
    assert ours.gains.gain == pytest.approx(linear.gains.gain, rel=0.03)
    assert ours.gains.integral_time == pytest.approx(linear.gains.integral_time, rel=0.05)
    (plant,) = ours.plants.values()
    exact = linear.plants["100 mm, fill"].response(plant.at(plant.known_frequencies))
    assert plant.known_frequencies[0] < 1.0 < 20.0 < plant.known_frequencies[-1]
    assert np.max(np.abs(plant.responses / exact - 1.0)) < 0.03


def test_margins_with_the_gains_of_the_circuit_are_those_of_the_linear_model():
    """The plant is linear, so python-control gives the margins from the matrices of its linear model."""
    control = pytest.importorskip("control", reason="python-control is not installed")
    (linear,) = tune(balanced_cylinder(), at=["100 mm"]).points
    matrices = linear.plants["100 mm, fill"]
    plant = control.ss(matrices.A, matrices.B[:, None], matrices.C[None, :], 0.0, TIME)
    delay = control.ss(control.tf([1.0], [1.0] + [0.0] * matrices.delay, TIME))
    schedule = {"position": [0.05, 0.15], "gain": [1.0, 5.0], "integral_time": [0.3, 0.9]}
    for fields, gain, integral_time in (
        ({}, 2.0, 0.5),
        ({"gain": "4 1/m", "integral_time": 0.8}, 4.0, 0.8),
        ({"gain": None, "integral_time": None, "schedule": schedule}, 3.0, 0.6),
    ):
        circuit = balanced_cylinder(**fields)
        (found,) = by_sines().margins_of(circuit).values()
        assert by_sines().margin_notes(circuit) == ()
        law = control.tf([gain, gain * (TIME / integral_time - 1.0)], [1.0, -1.0], TIME)
        omega = 2.0 * np.pi * np.geomspace(0.02, 249.0, 8000)
        loop = control.frequency_response(plant * delay * control.ss(law), omega).complex.ravel()
        gain_margin, phase_margin, *_, crossover, _ = control.stability_margins(control.frd(loop, omega))
        assert found.is_stable
        assert found.gain_margin == pytest.approx(gain_margin, rel=0.05)
        assert found.phase_margin == pytest.approx(phase_margin, rel=0.03)
        assert found.crossover == pytest.approx(crossover / (2.0 * np.pi), rel=0.03)
        assert found.sensitivity == pytest.approx(np.max(np.abs(1.0 / (1.0 + loop))), rel=0.03)


def test_loops_without_measured_responses_have_notes():
    """Sines do not give the response with another vent factor, and none below their lowest frequency."""
    other, slow = balanced_cylinder(vent_factor=2.0), balanced_cylinder(gain="0.05 1/m", integral_time=None)
    assert by_sines().margins_of(other) == {}
    (note,) = by_sines().margin_notes(other)
    assert (note.code, note.facts["measured"], note.facts["present"]) == ("tuning.other_vent_factor", 1.0, 2.0)
    (plant,) = by_sines().points[0].plants.values()
    (found,) = by_sines().margins_of(slow).values()
    assert found.crossover < plant.known_frequencies[0]
    assert [note.code for note in by_sines().margin_notes(slow)] == ["tuning.extrapolated"]


def test_measured_plant_is_independent_of_the_controller():
    first, second = (by_sines(gain).points[0] for gain in ("2 1/m", "0.7 1/m"))
    assert second.gains.gain == pytest.approx(first.gains.gain, rel=0.02)
    assert second.gains.integral_time == pytest.approx(first.gains.integral_time, rel=0.05)


def test_verification_equals_a_run_of_the_tuned_circuit():
    """A run from the steady state of the file gives the same metrics as the verification."""
    from poppet.control.metrics import step_metrics
    from poppet.signals import Steps

    tuning = by_sines()
    (run,) = tuning.points[0].verified
    assert run.step == pytest.approx(0.02 / tuning.points[0].gains.gain)
    assert not tuning.notes
    circuit = replace(
        tuning.applied(balanced_cylinder()), signals={"c.setpoint": Steps([0.0, 1.0], [0.1, 0.1 + run.step])}
    )
    recording = circuit.simulate(6.0, 2e-3)
    series = {name: recording[f"c.{name}"] for name in ("setpoint", "sensor_position", "command")}
    figures = step_metrics(recording.time, *series.values())
    assert figures["overshoot"] == pytest.approx(run.overshoot, abs=0.3)
    assert figures["settling_time"] == pytest.approx(run.settling_time, rel=0.05)


def dead_zone(size, zone):
    """Return the describing function of a dead zone for a sine of a given size."""
    ratio = zone / size
    return (1.0 - 2.0 / math.pi * (math.asin(ratio) + ratio * math.sqrt(1.0 - ratio**2))) / (1.0 - zone)


@pytest.mark.parametrize("size", [0.05, 0.15])
def test_a_dead_zone_has_its_describing_function(size):
    answers = []
    for overlap in (0.0, 0.03):
        circuit = balanced_cylinder(spool={"overlap": overlap})
        settled = make_measured_loop(circuit, None, [size], None).settle(0.1)
        answer, command = settled.respond_to_sine(250, size)
        answers.append(answer)
    ratio = answers[1] / answers[0]
    assert abs(ratio) == pytest.approx(dead_zone(abs(command), 0.03), rel=0.02)
    assert abs(np.angle(ratio, deg=True)) < 1.5


def test_a_compensated_dead_zone_has_the_response_of_a_valve_without_one():
    """The response is that to the command of the law, also with a command that acts one sample later."""
    for acts in ("at_once", "next_sample"):
        responses = []
        for overlap, fields in ((0.0, {}), (0.03, {"fill_dead_zone": 0.03, "dead_zone_smoothing": 1e-4})):
            circuit = balanced_cylinder(spool={"overlap": overlap, "lag": "0.2 ms"}, acts=acts, **fields)
            point = make_measured_loop(circuit, None, [0.05], None).operating_point(0.1)
            responses.append(next(iter(point.models.values())))
        without, compensated = responses
        z = without.at(without.known_frequencies)
        ratio = compensated.response(z) / without.response(z) * (1.0 - 0.03)
        is_slow = without.known_frequencies < 20.0
        assert np.max(np.abs(ratio[is_slow] - 1.0)) < 0.05


def test_acceleration_feedback_is_not_tuned():
    for amplitudes in ([], [0.02]):
        with refused("tuning.acceleration", "c.acceleration_time"):
            tune(balanced_cylinder(acceleration_time="5 ms"), at=["100 mm"], amplitudes=amplitudes)


def test_gains_for_a_dead_zone_are_those_of_its_response():
    """A third of the response permits three times the gain; the final error is within the dead zone."""
    without_zone, zoned = (
        tune(balanced_cylinder(spool={"overlap": overlap}), at=["100 mm"], form="p", amplitudes=[0.05])
        for overlap in (0.0, 0.03)
    )
    greater = zoned.points[0].gains.gain * dead_zone(0.05, 0.03)
    assert greater == pytest.approx(without_zone.points[0].gains.gain, rel=0.05)
    assert not without_zone.notes
    assert [(note.code, note.address) for note in zoned.notes] == [("tuning.unsettled", "c")]
    assert not math.isfinite(zoned.points[0].verified[0].settling_time)


def verification(**fields):
    usual = {"overshoot": 3.0, "settling_time": 0.5, "swing": 0.001, "growth": 0.5}
    none = np.zeros(0)
    return Verification("3 bar, sines of 0.1", 1.0, **usual | fields, time=none, setpoint=none, measured=none)


@pytest.mark.parametrize(
    ("fields", "code"),
    [
        ({}, None),
        ({"swing": 0.2, "growth": 1.5, "settling_time": math.inf}, "tuning.grows"),
        ({"swing": 0.2, "growth": 1.0, "settling_time": math.inf}, "tuning.swings"),
        ({"overshoot": 60.0}, "tuning.overshoots"),
        ({"settling_time": math.inf}, "tuning.unsettled"),
    ],
)
def test_deficiencies_of_a_step_have_notes(fields, code):
    assert [note.code for note in verification(**fields).notes("c")] == ([code] if code else [])


@pytest.mark.parametrize("size", [0.0, -0.1, 1.5])
def test_sizes_beyond_the_command_are_rejected(size):
    with refused("fields.out_of_range", "amplitude", value=size):
        tune(balanced_cylinder(), at=["100 mm"], amplitudes=[size])


def test_a_loop_without_a_steady_state_is_rejected():
    with refused("tuning.not_held", "slide.position", kind=SimulationError):
        tune(drive(gain="200 1/m", integral_time=0.02), at=["100 mm"], amplitudes=[0.02])


@pytest.mark.parametrize(
    ("friction", "amplitude", "frequency", "slides"),
    [
        # Bristles of 20 N at the default stiffness, 20 N / 10 um, deflect by 10 um.
        ({"kind": "lugre", "coulomb_force": "16 N", "static_force": "20 N"}, 190e-6, 1.0, False),
        ({"kind": "lugre", "coulomb_force": "16 N", "static_force": "20 N"}, 210e-6, 1.0, True),
        ({"kind": "lugre", "coulomb_force": "16 N", "bristle_stiffness": "1e5 N/m"}, 3.1e-3, 1.0, False),
        ({"kind": "stribeck", "coulomb_force": "16 N", "transition_velocity": "1 mm/s"}, 7e-4, 1.0, False),
        ({"kind": "stribeck", "coulomb_force": "16 N", "transition_velocity": "1 mm/s"}, 9e-4, 1.0, True),
        ({"viscous_coefficient": 60.0}, 1e-9, 1.0, True),
    ],
)
def test_a_motion_within_the_bristles_is_no_sliding(friction, amplitude, frequency, slides):
    loop = make_measured_loop(drive(friction), "c", [0.05], None)
    assert loop.sticking.slides(amplitude, 2.0 * math.pi * frequency) == slides


def test_the_loop_does_not_act_where_the_body_sticks():
    """Without a response above the measured range, the magnitude of the loop is bounded for any phase."""
    plant = PLANTS["integrator and lag"]
    measured = measured_plant(plant, highest=2e-3)
    bounded, free = (_GainSearch([replace(measured, sticks_above=sticks)], 1.4) for sticks in (True, False))
    gains = bounded.best("pi", None)
    z = plant.at(measured.known_frequencies[-1:])
    loop = abs(plant.response(z) * gains.response(z, plant.sample_time))[0]
    assert loop <= (1.0 - 1.0 / 1.4) * 1.02
    assert free.best("pi", None).gain > 1.5 * gains.gain


def dead_zone_drive(dead, leak):
    """Return a cylinder between orifices whose conductance is almost constant within a dead zone of the stroke."""
    strokes = [-1e-3, -dead, 0.0, dead, 1e-3]
    sizes = [0.1 * leak, 0.5 * leak, leak, 1.2 * leak, 1e-8]
    table = {"kind": "table", "critical_ratio": [0.45] * 5}
    positive = table | {"stroke": strokes, "sonic_conductance": sizes}
    negative = table | {"stroke": [-x for x in reversed(strokes)], "sonic_conductance": sizes[::-1]}
    circuit = drive(command_quantity="position", gain=0.005, lower_limit="-1 mm", upper_limit="1 mm")
    parts, connections = dict(circuit.parts), {"c.measurement": "slide.position"}
    names = {"cap_in": positive, "rod_out": positive, "rod_in": negative, "cap_out": negative}
    for name, characteristic in names.items():
        parts[name] = replace(parts[name], sonic_conductance=None, critical_ratio=None, characteristic=characteristic)
        connections[f"{name}.stroke"] = "c.command"
    return replace(circuit, parts=parts, connections=connections)


@pytest.mark.parametrize(("dead", "leak", "codes"), [(1e-4, 1e-11, ["tuning.swings"]), (1e-5, 1e-10, [])])
def test_a_dead_zone_that_misleads_the_linear_model_is_seen_in_a_working_step(dead, leak, codes):
    tuning = tune(dead_zone_drive(dead, leak), at=["100 mm"], form="p")
    assert [note.code for note in tuning.notes] == codes
    assert tuning.working_step.step == pytest.approx(0.03)
    assert (tuning.working_step.swing > 0.5) == bool(codes)


STRIBECK = {"kind": "stribeck", "transition_velocity": "1 mm/s"}


@pytest.mark.slow
@pytest.mark.parametrize("kind", [{"kind": "lugre"}, STRIBECK], ids=["lugre", "stribeck"])
@pytest.mark.parametrize("forces", [(4.0, 8.0), (8.0, 10.0), (16.0, 20.0)], ids=str)
def test_a_small_sine_does_not_tune_the_bristles(kind, forces):
    """Near the gain of larger sines. Responses of a body that sticks or creeps gave 145 to 10,102 1/m."""
    circuit = load(EXAMPLES / "cylinder_position.toml")
    friction = replace(circuit.parts["slide"].friction, **kind, coulomb_force=forces[0], static_force=forces[1])
    slide = replace(circuit.parts["slide"], friction=friction)
    tuning = tune(
        replace(circuit, parts={**circuit.parts, "slide": slide}), at=["100 mm"], form="pid", amplitudes=[0.05]
    )
    (point,) = tuning.points
    assert 2.0 < point.gains.gain < 8.0
    assert tuning.working_step.swing < 0.15
    assert abs(tuning.working_step.step) == pytest.approx(0.05, rel=1e-2)


@pytest.mark.slow
def test_the_muscle_joint_is_tuned_through_its_complete_valve():
    """At the bound of the example gains, which a search by runs gave, the integral gain is at least as large."""
    circuit = load(EXAMPLES / "muscle_joint.toml")
    (point,) = tune(circuit, at=["25 deg"], form="pid", amplitudes=["100 N"]).points
    (plant,) = point.plants.values()
    by_hand = Gains(960.0, 0.15, 0.05, 4e-3)
    bound = margins(plant, by_hand)
    assert bound.is_stable
    assert 2.0 < bound.sensitivity < 3.0
    (margin,) = point.margins.values()
    assert max(margin.sensitivity, margin.complementary) <= 1.4
    assert all(run.overshoot < 25.0 and run.settling_time < 4.0 for run in point.verified)
    (fast,) = tune(circuit, at=["25 deg"], form="pid", sensitivity=bound.sensitivity, amplitudes=["100 N"]).points
    assert fast.gains.gain / fast.gains.integral_time > 960.0 / 0.15


@pytest.mark.slow
def test_a_cylinder_is_tuned_with_the_overlap_of_its_valve():
    """Two sizes of sines have common gains; a note reports a step that does not settle."""
    tuning = tune(load(EXAMPLES / "cylinder_position.toml"), at=["100 mm"], form="pid", amplitudes=[0.05, 0.3])
    (point,) = tuning.points
    unsettled = [run for run in point.verified if not math.isfinite(run.settling_time)]
    assert [note.code for note in tuning.notes] == ["tuning.unsettled"] * len(unsettled)
    assert all(abs(run.measured[-1] - run.setpoint[-1]) < 0.03 * run.step for run in point.verified)
    assert max(max(m.sensitivity, m.complementary) for m in point.margins.values()) == pytest.approx(1.4, rel=5e-3)
    assert [run.step for run in point.verified] == pytest.approx([0.05 / point.gains.gain, 0.3 / point.gains.gain])
    assert all(run.overshoot < 6.0 for run in point.verified)
    assert point.verified[1].settling_time < 3.0
