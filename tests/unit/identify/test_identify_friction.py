"""Tests of `identify friction`: known laws, parameters that are not determined, correlated residuals, invalid input.

The synthetic recordings use an independent integration of the LuGre model with SciPy. The motion of the body is
prescribed, and the result is the force that moves it.
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.signal import lfilter

from poppet import Circuit, Cylinder, Mass, load
from poppet.identify import FrictionRecord, Result, identify_friction, read_friction_file
from poppet.report.identification.identification_report import identification_page
from refusals import refused

COULOMB, STATIC, STRIBECK, VISCOUS = (
    f"friction.{name}" for name in ("coulomb_force", "static_force", "stribeck_velocity", "viscous_coefficient")
)
BRISTLES, DAMPING, SEAL = "friction.bristle_stiffness", "friction.bristle_damping", "seal_friction"
TRUTH = {COULOMB: 20.0, STATIC: 32.0, STRIBECK: 0.02, VISCOUS: 60.0}
SPEEDS = np.geomspace(0.001, 0.5, 24)


def sliding_friction(speed: np.ndarray, truth: dict[str, float], pressure: np.ndarray | float = 0.0) -> np.ndarray:
    """Return the friction of steady sliding [N]."""
    fc, fs, vs = truth[COULOMB], truth.get(STATIC, truth[COULOMB]), truth.get(STRIBECK, 1.0)
    dry = fc + (fs - fc) * np.exp(-((speed / vs) ** 2)) + truth.get(SEAL, 0.0) * pressure
    return dry * np.sign(speed) + truth.get(VISCOUS, 0.0) * speed


def steady_table(
    truth: dict[str, float], noise: float = 0.0, seed: int = 0, has_both_directions: bool = True
) -> FrictionRecord:
    speed = np.concatenate([SPEEDS, -SPEEDS] if has_both_directions else [SPEEDS])
    force = sliding_friction(speed, truth) + noise * np.random.default_rng(seed).standard_normal(speed.size)
    return FrictionRecord(force=force, velocity=speed)


def note_facts(result: Result, code: str) -> list[dict[str, Any]]:
    return [dict(n.facts) | {"address": n.address} for n in result.remarks if n.code == code]


def cover_truth(result: Result, truth: dict[str, float]) -> list[bool]:
    return [e.low <= truth[name] <= e.high for name, e in result.parameters.items() if name in truth]


# Tables -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("law", ["coulomb", "coulomb_viscous", "stribeck", "stribeck_viscous"])
def test_law_of_a_table_is_selected_with_its_parameters(law):
    names = [COULOMB, *[STATIC, STRIBECK] * ("stribeck" in law), *[VISCOUS] * ("viscous" in law)]
    truth = {name: TRUTH[name] for name in names}
    result = identify_friction(steady_table(truth))
    assert result.comparison["law"] == law
    assert {name: e.value for name, e in result.parameters.items()} == pytest.approx(truth, rel=1e-4)
    assert {e.verdict for e in result.parameters.values()} == {"determined"}
    assert note_facts(result, "friction.no_reversals")  # a table has no reversals
    assert BRISTLES not in result.parameters


def test_noise_does_not_select_a_richer_law():
    truth = {COULOMB: 20.0}
    laws = [identify_friction(steady_table(truth, 1.0, seed)).comparison["law"] for seed in range(5)]
    assert laws.count("coulomb") >= 4
    bounds = {
        bound["address"]: bound for bound in note_facts(identify_friction(steady_table(truth, 1.0)), "friction.bounded")
    }
    assert bounds[VISCOUS]["high"] < 5.0  # for speeds up to 0.5 m/s and a noise of 1 N


def test_possible_viscous_part_widens_the_interval_of_the_coulomb_force():
    speed = np.repeat([0.001, 0.003, 0.006, 0.01, 0.07, 0.09], 10)
    for seed in (0, 15):
        noise = np.random.default_rng(seed).standard_normal((2, 2 * speed.size))
        velocity = np.concatenate([speed, -speed]) * (1.0 + 0.002 * noise[0])
        result = identify_friction(
            FrictionRecord(force=sliding_friction(velocity, TRUTH) + 0.8 * noise[1], velocity=velocity)
        )
        estimate = result.parameters[COULOMB]
        assert estimate.low <= 21.0
        assert estimate.high >= 20.0
        assert estimate.verdict != "determined" or result.comparison["law"] == "stribeck_viscous"


@pytest.mark.parametrize("count", [3, pytest.param(120, marks=pytest.mark.slow)])
def test_intervals_of_tables_have_their_stated_coverage(count):
    tables = [steady_table(TRUTH, 0.8, seed) for seed in range(count)]
    coverage = np.mean([cover_truth(identify_friction(table, law="stribeck_viscous"), TRUTH) for table in tables])
    assert coverage > (0.7 if count < 50 else 0.92)


def test_pressure_in_a_table_gives_the_seal_friction():
    pressure = np.tile([1e5, 3e5, 6e5], 24)
    speed = np.repeat(np.geomspace(0.005, 0.3, 24), 3)
    truth = {COULOMB: 5.0, VISCOUS: 30.0, SEAL: 7e-6}
    force = sliding_friction(speed, truth, pressure) + 0.02 * np.random.default_rng(1).standard_normal(speed.size)
    result = identify_friction(FrictionRecord(force=force, velocity=speed, pressure=pressure))
    assert result.comparison["law"] == "coulomb_viscous"
    assert {name: e.value for name, e in result.parameters.items()} == pytest.approx(truth, rel=0.02)
    assert all(cover_truth(result, truth))


def test_estimates_set_body_and_cylinder_of_a_circuit():
    pressure = np.tile([1e5, 6e5], 24)
    speed = np.repeat(SPEEDS, 2)
    record = FrictionRecord(
        force=sliding_friction(speed, TRUTH | {SEAL: 7e-6}, pressure), velocity=speed, pressure=pressure
    )
    result = identify_friction(record, part="slide", cylinder="drive")
    slide = Mass(mass="1 kg", friction={"kind": "lugre", "coulomb_force": "1 N", "static_force": "1 N"})
    side = {"dead_volume": "5 cm^3"}
    drive = Cylinder(body="slide", bore="25 mm", stroke_length="0.1 m", cap=side, rod=side)
    numbers = Circuit({"slide": slide, "drive": drive}).with_values(result.values()).numbers()
    assert numbers["slide.friction.static_force"].value == pytest.approx(32.0, rel=1e-4)
    assert numbers["drive.seal_friction"].value == pytest.approx(7e-6, rel=1e-4)
    assert numbers["slide.friction.coulomb_force"].source.kind == "fitted"
    assert 'seal_friction = "0.7 N/bar"' in result.comparison["ready"]


# Joints -----------------------------------------------------------------------------------------------------------

TURNS = {COULOMB: 0.4, STATIC: 0.7, STRIBECK: 0.2, VISCOUS: 0.05}
JOINT = {name.replace("_force", "_torque"): value for name, value in TURNS.items()}


def joint_file(folder: Path, **noise: float) -> Path:
    """Write a table of torques versus speeds in bench units, and return the file that refers to it."""
    speed = np.concatenate([direction * np.geomspace(0.01, 8.0, 24) for direction in (1.0, -1.0)])
    torque = sliding_friction(speed, TURNS) + noise.get("torque", 0.0) * np.random.default_rng(3).standard_normal(
        speed.size
    )
    rows = [f"{math.degrees(v):.6f},{1e3 * m:.4f}\n" for v, m in zip(speed, torque, strict=True)]
    (folder / "turns.csv").write_text("w [deg/s],M [mNm]\n" + "".join(rows))
    file = folder / "joint.toml"
    file.write_text('file = "turns.csv"\npart = "elbow"\nvelocity = { column = "w" }\ntorque = { column = "M" }\n')
    return file


def test_torques_versus_speeds_give_the_friction_of_a_joint(tmp_path):
    result = identify_friction(joint_file(tmp_path))
    estimates = {name: (e.value, e.unit) for name, e in result.parameters.items()}
    units = dict(zip(JOINT, ("N m", "N m", "rad/s", "N m s/rad"), strict=True))
    assert estimates == {f"elbow.{n}": (pytest.approx(value, rel=1e-3), units[n]) for n, value in JOINT.items()}
    assert {note.facts.get("effort_unit", "N m") for note in result.remarks} == {"N m"}
    page = identification_page(result)
    assert "N m s/rad" in page
    assert "0 Pa" not in page
    assert "/m" not in result.comparison["ready"]


def test_report_has_the_unit_of_the_inertia(tmp_path):
    file = joint_file(tmp_path)
    file.write_text(file.read_text() + 'inertia = "0.004 kg m^2"\n')
    assert "0.004 kg m²" in identification_page(identify_friction(file))


def test_joint_simulates_with_estimates_and_with_lines(tmp_path):
    """At a constant torque, the simulated friction equals the true friction."""
    result = identify_friction(joint_file(tmp_path))
    text = """\
[parts.elbow]
kind = "joint"
inertia = "0.02 kg m^2"
pulley_radius = "20 mm"
load_torque = "-0.5 N m"
initial_velocity = "1 rad/s"
FRICTION
[parts.drive]
kind = "cylinder"
bore = "12 mm"
stroke_length = "900 mm"
body = "elbow"
cap = { dead_volume = "1 l" }
rod = { dead_volume = "1 l" }
[parts.in]
kind = "orifice"
sonic_conductance = "40 dm^3/(s bar)"
from = "ambient"
to = "drive.cap"
[parts.out]
kind = "orifice"
sonic_conductance = "40 dm^3/(s bar)"
from = "drive.rod"
to = "ambient"
[run]
duration = "4 s"
"""
    (tmp_path / "lines.toml").write_text(text.replace("FRICTION", result.comparison["ready"]))
    assumed = 'friction = { kind = "lugre", coulomb_torque = 1, static_torque = 1 }'
    (tmp_path / "with.toml").write_text(text.replace("FRICTION", assumed))
    from_lines, from_estimates = (
        load(tmp_path / "lines.toml"),
        load(tmp_path / "with.toml").with_values(result.values()),
    )
    for circuit in (from_lines, from_estimates):
        run = circuit.simulate()
        speed = run["elbow.velocity"][-1]
        assert 0.5 < speed < 3.0
        assert run["elbow.friction_torque"][-1] == pytest.approx(sliding_friction(speed, TURNS), rel=1e-3)


def test_recording_of_a_joint_gives_levels_and_bristles():
    truth = TURNS | {BRISTLES: 40.0}
    record = reversed_pulls(truth, (0.05, 0.1, 0.2, 0.4, 0.8, 1.5) * 2, stroke=0.5, noise=(2e-4, 0.002))
    on_line = {"pressure": None, "pressure_force": None}
    result = identify_friction(replace(record, **on_line, body="joint"))
    assert (result.comparison["law"], result.comparison["levels"]) == ("lugre", "stribeck_viscous")
    expected = JOINT | {BRISTLES: 40.0}
    assert {name: e.value for name, e in result.parameters.items()} == pytest.approx(expected, rel=0.1)
    page = identification_page(result)
    assert "mm/s" not in page
    assert " mm<" not in page
    assert result.parameters[BRISTLES].unit == "N m/rad"


def test_seal_friction_of_a_joint_acts_at_its_pulley():
    pressure, radius = np.tile([1e5, 3e5, 6e5], 24), 0.025
    speed = np.repeat(np.geomspace(0.05, 3.0, 24), 3)
    truth = {COULOMB: 0.2, VISCOUS: 0.1, SEAL: 7e-6 * radius}
    table = FrictionRecord(
        force=sliding_friction(speed, truth, pressure), velocity=speed, pressure=pressure, body="joint"
    )
    result = identify_friction(table, pulley_radius=radius)
    assert result.parameters[SEAL].value == pytest.approx(7e-6, rel=1e-6)
    assert 'seal_friction = "0.7 N/bar"' in result.comparison["ready"]
    with refused("friction.no_radius", "pulley_radius"):
        identify_friction(table)


TURNED_FILE = """\
file = "turns.csv"
velocity = { column = "w", unit = "deg/s" }
torque = { column = "M", unit = "mNm" }
"""


@pytest.mark.parametrize(
    ("change", "codes"),
    [
        ('force = { column = "M", unit = "N" }', {("friction.force_and_torque", "torque")}),
        ('mass = "2 kg"', {("friction.of_other_body", "mass")}),
        ('pressure = { value = "3 bar g" }', {("friction.no_radius", "pulley_radius")}),
        ('offset = "3 N"\nwithin = ["1 mm", "2 mm"]', {("quantity.other_quantity", "offset"),
                                                        ("quantity.other_quantity", "within")}),
        (("deg/s", "mm/s"), {("friction.mixture", "velocity")}),
        (("mNm", "N"), {("friction.mixture", "torque")}),
        (("torque", "force"), {("friction.mixture", "velocity"), ("friction.mixture", "force")}),
        (('torque = { column = "M", unit = "mNm" }', 'inertia = 1\npulley_radius = "2 mm"'),
         {("fields.missing", "force"), ("friction.of_other_body", "inertia"),
          ("friction.of_other_body", "pulley_radius"), ("friction.mixture", "velocity")}),
        ((', unit = "deg/s"', ""), {("friction.mixture", "velocity")}),
    ],
)  # fmt: skip
def test_all_fields_of_the_wrong_body_are_rejected(tmp_path, change, codes):
    (tmp_path / "turns.csv").write_text("w [mm/s],M\n1,2\n2,3\n4,5\n")
    text = TURNED_FILE.replace(*change) if isinstance(change, tuple) else f"{TURNED_FILE}{change}\n"
    (tmp_path / "joint.toml").write_text(text)
    with pytest.raises(ValueError) as caught:
        read_friction_file(tmp_path / "joint.toml")
    problems = getattr(caught.value, "problems", (caught.value,))
    assert {(problem.code, problem.address) for problem in problems} == codes


def test_mass_and_joint_together_are_rejected():
    table = steady_table(TRUTH)
    with refused("friction.bodies"):
        identify_friction([table, replace(table, force=1.1 * table.force, body="joint")])
    with refused("friction.of_other_body", "inertia"):
        identify_friction(table, inertia=1.0)
    with refused("fields.not_an_option", "body"):
        replace(table, body="wheel")


def test_static_force_is_not_determined_by_fast_speeds():
    """All speeds are above the Stribeck velocity."""
    speed = np.linspace(0.1, 0.6, 40)
    noise = 0.2 * np.random.default_rng(2).standard_normal(40)
    result = identify_friction(FrictionRecord(force=sliding_friction(speed, TRUTH) + noise, velocity=speed))
    assert result.comparison["law"] == "coulomb_viscous"
    requested = identify_friction(
        FrictionRecord(force=sliding_friction(speed, TRUTH) + noise, velocity=speed), law="stribeck_viscous"
    )
    assert requested.parameters[STATIC].verdict == "not determined"
    assert requested.parameters[STATIC].high == math.inf
    assert requested.parameters[STRIBECK].verdict == "not determined"


def test_narrow_speeds_do_not_separate_stribeck_and_viscous_parameters():
    """In a narrow range of speeds, the effects of the parameters on the friction are similar."""
    speed = np.linspace(0.004, 0.012, 40)
    force = sliding_friction(speed, TRUTH) + 0.3 * np.random.default_rng(4).standard_normal(40)
    result = identify_friction(FrictionRecord(force=force, velocity=speed), law="stribeck_viscous")
    assert all(cover_truth(result, TRUTH))
    assert result.parameters[VISCOUS].verdict in ("not determined", "at bound")
    assert result.parameters[COULOMB].verdict in ("not determined", "at bound")


def test_difference_between_directions_is_reported_for_a_known_offset():
    record = steady_table({COULOMB: 20.0}, 0.1)
    lopsided = FrictionRecord(force=record.force + 1.5, velocity=record.velocity)
    (facts,) = note_facts(identify_friction(lopsided), "friction.lopsided")
    assert facts["value"] == pytest.approx(1.5, abs=0.1)
    assert note_facts(identify_friction(record), "friction.even")
    free = identify_friction(lopsided, offset="free")
    assert note_facts(free, "friction.sides_open")
    corrected = identify_friction(lopsided, offset=1.5)
    assert corrected.parameters[COULOMB].value == pytest.approx(20.0, abs=0.1)


def test_too_small_stated_uncertainty_is_reported():
    record = steady_table({COULOMB: 20.0}, 1.0)
    with_uncertainty = FrictionRecord(force=record.force, velocity=record.velocity, uncertainty=0.1)
    (facts,) = note_facts(identify_friction(with_uncertainty), "friction.misfit")
    assert facts["factor"] == pytest.approx(10.0, rel=0.3)


# Recordings -------------------------------------------------------------------------------------------------------

AREA = 0.25 * math.pi * 0.025**2


def reversed_pulls(
    truth: dict[str, float],
    speeds: tuple[float, ...],
    *,
    pressure: float = 0.0,
    stroke: float = 0.03,
    seed: int = 0,
    noise: tuple[float, float] = (2e-5, 0.05),
    offset: float = 0.0,
    extra: float = 0.0,
    name: str = "run",
) -> FrictionRecord:
    """Return a recording of a body that moves forward and backward once at each speed.

    `noise` is that of position and force. The position has 12 bits. `extra` is an additional Coulomb force.
    """
    rate, turn = 100.0, 0.02  # samples per second, and duration of a reversal [s]
    velocities = [s * v for v in speeds for s in (1.0, -1.0)]
    ends = np.cumsum([stroke / abs(v) for v in velocities])
    time = np.arange(0.0, ends[-1], 1.0 / rate)

    knots = [0.0, turn, *np.ravel([[end, end + turn] for end in ends[:-1]]), ends[-1]]
    knot_velocities = [0.0, *np.repeat(velocities, 2)]

    def velocity(t: np.ndarray) -> np.ndarray:
        return np.interp(t, knots, knot_velocities)

    stiffness = truth[BRISTLES]

    def rate_of(t: float, z: np.ndarray) -> np.ndarray:
        v = velocity(t)
        return v - stiffness * np.abs(v) * z / (
            abs(sliding_friction(1e-12 + np.abs(v), truth | {VISCOUS: 0.0}, pressure))
        )

    z = solve_ivp(rate_of, (0.0, time[-1]), [0.0], "LSODA", time, rtol=1e-8, atol=1e-12, max_step=0.5 * turn).y[0]
    v = velocity(time)
    fine = np.linspace(0.0, time[-1], 20 * time.size)
    steps = 0.5 * np.diff(fine) * (velocity(fine)[1:] + velocity(fine)[:-1])
    position = np.interp(time, fine, np.concatenate([[0.0], np.cumsum(steps)]))
    generator = np.random.default_rng(seed)
    friction = stiffness * z + truth.get(VISCOUS, 0.0) * v + extra * np.sign(v)
    measured_pressure = pressure + 200.0 * generator.standard_normal(time.size)
    force = friction + offset + pressure * AREA + noise[1] * generator.standard_normal(time.size)
    step = 0.1 / 4096.0
    measured_position = np.round((position + noise[0] * generator.standard_normal(time.size)) / step) * step
    return FrictionRecord(
        time=time,
        position=measured_position,
        force=force,
        name=name,
        pressure=measured_pressure,
        pressure_force=-measured_pressure * AREA,
    )


PULLED = {COULOMB: 8.0, STATIC: 12.0, STRIBECK: 0.01, VISCOUS: 25.0, BRISTLES: 4e4}


def test_recording_gives_levels_and_bristles():
    speeds = (0.002, 0.004, 0.008, 0.016, 0.03, 0.06, 0.1) * 2
    result = identify_friction(reversed_pulls(PULLED, speeds, offset=3.0))
    assert (result.comparison["law"], result.comparison["levels"]) == ("lugre", "stribeck_viscous")
    estimates = {name: e.value for name, e in result.parameters.items()}
    assert estimates == pytest.approx(PULLED, rel=0.1)
    assert all(cover_truth(result, {name: value for name, value in PULLED.items() if name != BRISTLES}))
    assert result.comparison["recordings"][0]["offset"] == pytest.approx(3.0, abs=0.05)
    assert result.comparison["held_out_by"] == "stroke"
    assert result.conditions["velocity_noise"][0] < 0.001


def test_one_slow_speed_determines_only_the_coulomb_force():
    result = identify_friction(reversed_pulls({COULOMB: 8.0, BRISTLES: 4e4}, (0.01,) * 8))
    assert result.comparison["levels"] == "coulomb"
    assert result.parameters[COULOMB].value == pytest.approx(8.0, rel=0.01)
    assert note_facts(result, "friction.narrow")
    assert note_facts(result, "friction.not_told")[0]["laws"] == ["coulomb_viscous", "stribeck", "stribeck_viscous"]


def slide_at_speeds(speeds, *, offset=0.0, seed=0, noise=(1e-6, 0.3)):
    """Return a recording of a body that slides 3 s at each speed, with friction of 20 N and 50 N s/m."""
    generator, speed = np.random.default_rng(seed), np.repeat(speeds, 3000)
    force = 20.0 * np.sign(speed) + 50.0 * speed + offset + noise[1] * generator.standard_normal(speed.size)
    position = np.cumsum(speed) * 1e-3 + noise[0] * generator.standard_normal(speed.size)
    return FrictionRecord(time=1e-3 * np.arange(speed.size), position=position, force=force)


def test_one_speed_does_not_separate_viscous_and_coulomb_friction():
    """The speeds differ only by their noise."""
    result = identify_friction(slide_at_speeds([0.05, -0.05, 0.05, -0.05]))
    estimate = result.parameters[COULOMB]
    assert estimate.value == pytest.approx(22.5, abs=0.1)
    assert estimate.verdict == "not determined"
    assert estimate.low < 20.0 < estimate.high
    assert not note_facts(result, "friction.bounded")


def test_two_similar_speeds_give_the_viscous_part():
    result = identify_friction(slide_at_speeds([0.05, -0.05, 0.1, -0.1]))
    estimates = {name: e.value for name, e in result.parameters.items()}
    assert estimates == pytest.approx({COULOMB: 20.0, VISCOUS: 50.0}, rel=0.01)


def test_two_speeds_do_not_determine_a_stribeck_law():
    """Two speeds cannot determine four parameters."""
    result = identify_friction(presliding_stage(speeds=(0.002, 0.004) * 2))
    assert result.comparison["levels"] == "coulomb"
    assert note_facts(result, "friction.not_told")[0]["laws"] == ["stribeck", "stribeck_viscous"]
    assert result.parameters[COULOMB].verdict == "not determined"
    assert result.parameters[COULOMB].low < PRESLID[COULOMB] < result.parameters[COULOMB].high


# Bristles ---------------------------------------------------------------------------------------------------------

PRESLID = {COULOMB: 8.0, STATIC: 12.0, STRIBECK: 0.01, VISCOUS: 30.0, BRISTLES: 5e4, DAMPING: 400.0}


def presliding_stage(
    truth: dict[str, float] = PRESLID,
    *,
    speeds: tuple[float, ...] = (0.002, 0.004, 0.01, 0.03, 0.06),
    rate: float = 1000.0,
    noise: tuple[float, float] = (1e-6, 0.05),
    delay: float = 0.0,
    seed: int = 0,
) -> FrictionRecord:
    """Return a recording of a body that moves forward and backward at each speed, and then oscillates by 0.3 mm.

    During the oscillation, the bristles deflect without sliding. The model is that of Canudas de Wit et al. 1995 with
    the damping of Olsson 1996: z' = v - sigma0 |v| z/g, F = sigma0 z + sigma1(v) z' + sigma2 v.
    """
    fc, fs, vs, viscous, stiffness, damping = truth.values()
    turn, stroke, swings, amplitude = 0.01, 0.006, 4, 1.5e-4
    velocities = [sign * speed for speed in speeds for sign in (1.0, -1.0)]
    knots = np.cumsum([0.0, *np.ravel([[turn, stroke / abs(v)] for v in velocities]), turn])
    knot_velocities = [0.0, *np.repeat(velocities, 2), 0.0]
    time = np.arange(0.0, knots[-1] + swings, 1.0 / rate)

    def velocity(t: Any) -> Any:
        swing = -amplitude * 2.0 * np.pi * np.sin(2.0 * np.pi * (t - knots[-1]))
        return np.where(t < knots[-1], np.interp(t, knots, knot_velocities), swing)

    def bend(t: float, z: Any) -> Any:
        v = velocity(t)
        return v - stiffness * abs(v) * z / (fc + (fs - fc) * np.exp(-((v / vs) ** 2)))

    z = solve_ivp(bend, (0.0, time[-1]), [0.0], "LSODA", time, rtol=1e-7, atol=1e-11, max_step=turn).y[0]
    v = velocity(time)
    force = stiffness * z + damping * np.exp(-((v / vs) ** 2)) * bend(time, z) + viscous * v
    fine = np.linspace(0.0, time[-1], 10 * time.size)
    steps = 0.5 * np.diff(fine) * (velocity(fine)[1:] + velocity(fine)[:-1])
    position = np.interp(time, fine, np.concatenate([[0.0], np.cumsum(steps)]))
    record = FrictionRecord(time=time, position=position, force=np.interp(time - delay, time, force))
    return add_noise(record, noise, seed)


def add_noise(record: FrictionRecord, noise: tuple[float, float], seed: int) -> FrictionRecord:
    generator = np.random.default_rng(seed)
    position, force = record.position, record.force
    assert position is not None
    return replace(
        record,
        position=position + noise[0] * generator.standard_normal(len(record)),
        force=force + noise[1] * generator.standard_normal(len(record)),
    )


@pytest.mark.parametrize(
    ("count", "noise"),
    [
        (1, (1e-6, 0.05)),
        pytest.param(30, (1e-6, 0.05), marks=pytest.mark.slow),
        pytest.param(30, (3e-6, 0.3), marks=pytest.mark.slow),
    ],
)
def test_intervals_of_stiffness_and_damping_cover_the_truth(count, noise):
    clean, coverage = presliding_stage(noise=(0.0, 0.0)), []
    for seed in range(count):
        result = identify_friction(add_noise(clean, noise, seed))
        assert {*PRESLID} - {DAMPING} <= result.parameters.keys()
        estimate = result.parameters.get(DAMPING)
        bounds = [n.facts["high"] for n in result.remarks if n.code.startswith("friction.damping_")]
        is_covered = estimate.low < PRESLID[DAMPING] < estimate.high if estimate else bounds[0] > PRESLID[DAMPING]
        coverage.append([*cover_truth(result, PRESLID | {DAMPING: math.nan})[:5], is_covered])
        if noise[1] < 0.1:
            assert estimate
            assert (estimate.unit, estimate.verdict) == ("N s/m", "weak")
            assert estimate.high < 2.0 * PRESLID[DAMPING]
    assert np.mean(coverage) > (0.8 if count == 1 else 0.92)
    assert np.mean(coverage, axis=0).min() > (-1.0 if count == 1 else 0.85)


def test_low_sample_rate_does_not_determine_the_damping():
    result = identify_friction(presliding_stage(rate=80.0))
    assert DAMPING not in result.parameters
    (facts,) = note_facts(result, "friction.damping_coarse")
    assert facts["step"] == pytest.approx(0.0125)
    assert facts["high"] > PRESLID[DAMPING]
    assert note_facts(
        identify_friction(reversed_pulls({COULOMB: 8.0, BRISTLES: 4e6}, (0.01,) * 4)), "friction.no_reversals"
    )


def test_damping_within_the_scatter_has_an_upper_bound():
    result = identify_friction(presliding_stage(PRESLID | {DAMPING: 0.0}))
    assert DAMPING not in result.parameters
    (facts,) = [*note_facts(result, "friction.damping_open"), *note_facts(result, "friction.damping_coarse")]
    assert 0.0 < facts["high"] < 0.5 * PRESLID[DAMPING]


def test_interval_of_the_damping_includes_a_delay_of_one_sample():
    """A delay of the force reduces the apparent damping by the delay times the stiffness."""
    estimate = identify_friction(presliding_stage(delay=1e-3)).parameters[DAMPING]
    assert estimate.low < PRESLID[DAMPING] < estimate.high


def test_delayed_force_is_reported_and_leaves_the_stiffness():
    """A delay of 20 ms exceeds the lead of 8 ms that the damping of 400 N s/m causes."""
    result = identify_friction(presliding_stage(delay=0.02))
    assert DAMPING not in result.parameters
    (facts,) = note_facts(result, "friction.force_late")
    assert facts["lag"] == pytest.approx(0.012, rel=0.3)
    assert cover_truth(result, {BRISTLES: PRESLID[BRISTLES]}) == [True]


def test_stiffness_and_damping_of_a_joint_are_lines_of_its_circuit():
    result = identify_friction(replace(presliding_stage(), body="joint"), part="elbow")
    assert result.parameters[f"elbow.{DAMPING}"].unit == "N m s/rad"
    assert "bristle_damping" in result.comparison["ready"]


def test_one_direction_does_not_separate_offset_and_friction():
    speed = np.geomspace(0.002, 0.5, 15)
    record = FrictionRecord(force=28.0 + 50.0 * speed, velocity=speed)  # 20 N, and a sensor offset of 8 N
    result = identify_friction(record)
    assert result.parameters[COULOMB].verdict == "weak"
    assert note_facts(result, "friction.one_side")[0]["assumed"]
    corrected = identify_friction(record, offset=8.0)
    assert corrected.parameters[COULOMB].value == pytest.approx(20.0, rel=1e-3)
    assert corrected.parameters[COULOMB].verdict == "determined"


def test_constant_force_and_repeated_recording_are_rejected():
    record = slide_at_speeds([0.05, -0.05, 0.1, -0.1])
    with refused("friction.still", "force", value=5.0):
        identify_friction(replace(record, force=np.full(len(record), 5.0)))
    with refused("friction.same_twice", "file"):
        identify_friction([record, record])


def test_bristles_below_the_resolution_are_not_determined():
    result = identify_friction(reversed_pulls({COULOMB: 8.0, BRISTLES: 4e6}, (0.01,) * 4, noise=(5e-5, 0.05)))
    assert BRISTLES not in result.parameters
    assert result.comparison["law"] == "coulomb"
    assert note_facts(result, "friction.no_reversals")
    with refused("friction.no_bristles", "law"):
        identify_friction(reversed_pulls({COULOMB: 8.0, BRISTLES: 4e6}, (0.01,) * 4, noise=(5e-5, 0.05)), law="lugre")


def sealed_pulls(seed: int, scatter: float, truth: dict[str, float]) -> list[FrictionRecord]:
    """Return recordings at four pressures, with a random additional friction of standard deviation `scatter`."""
    generator = np.random.default_rng(100 + seed)
    return [
        reversed_pulls(truth, (0.01,) * 3, pressure=p, seed=seed + k, offset=generator.normal(), name=f"p{k}",
               extra=scatter * generator.standard_normal())
        for k, p in enumerate((1e5, 3e5, 5e5, 7e5))
    ]  # fmt: skip


SEALED = {COULOMB: 3.5, SEAL: 7e-6, BRISTLES: 4e4}


def test_recordings_at_several_pressures_give_the_seal_friction():
    result = identify_friction(sealed_pulls(0, 0.0, SEALED), part="slide", cylinder="drive")
    assert result.parameters["drive.seal_friction"].value == pytest.approx(7e-6, rel=0.02)
    assert result.parameters["slide.friction.coulomb_force"].value == pytest.approx(3.5, rel=0.03)
    assert result.comparison["held_out_by"] == "recording"
    assert note_facts(result, "friction.between")[0]["count"] == 4


@pytest.mark.parametrize("count", [2, pytest.param(100, marks=pytest.mark.slow)])
def test_intervals_include_the_scatter_between_recordings(count):
    """The friction scatters by 0.3 N between recordings of a thousand samples."""
    results = [identify_friction(sealed_pulls(9 * seed, 0.3, SEALED), law="coulomb") for seed in range(count)]
    coverage = np.mean([cover_truth(r, {COULOMB: 3.5, SEAL: 7e-6}) for r in results])
    assert coverage > (0.4 if count < 50 else 0.91)
    assert [r.comparison["supported"] for r in results].count("coulomb") >= 0.9 * count
    halves = [0.5 * (r.parameters[COULOMB].high - r.parameters[COULOMB].low) for r in results]
    assert np.median(halves) > 0.4


def test_two_pressures_are_reported_as_an_exact_line():
    pair = sealed_pulls(0, 0.0, SEALED)[::3]
    result = identify_friction(pair)
    assert note_facts(result, "friction.two_pressures")
    assert result.comparison["held_out_by"] == "stroke"


def test_bristles_within_the_noise_of_the_position_are_not_determined():
    record = reversed_pulls({COULOMB: 8.0, BRISTLES: 1.2e5}, (0.002,) * 3, stroke=0.01, noise=(1e-4, 0.02))
    (facts,) = note_facts(identify_friction(record), "friction.bristles_unresolved")
    assert facts["low"] < 1.2e5


def test_motion_faster_than_the_smoothing_is_reported():
    """A window of 0.5 s smooths stick-slip at 5 Hz."""
    time = np.arange(0.0, 20.0, 0.01)
    direction = np.where(time < 10.0, 1.0, -1.0)
    position = 0.01 * np.minimum(time, 20.0 - time) + 4e-4 * np.sin(2.0 * np.pi * 5.0 * time)
    position += 1e-5 * np.random.default_rng(0).standard_normal(time.size)
    record = FrictionRecord(time=time, position=position, force=5.0 * direction)
    (facts,) = note_facts(identify_friction(record, smoothing=0.5), "friction.smeared")
    assert facts["factor"] > 3.0


def test_negative_estimate_is_set_to_zero_and_reported():
    record = steady_table({COULOMB: 20.0})
    falling = FrictionRecord(force=record.force - 8.0 * record.velocity, velocity=record.velocity)
    result = identify_friction(falling, law="coulomb_viscous")
    assert (result.parameters[VISCOUS].value, result.parameters[VISCOUS].verdict) == (0.0, "at bound")
    assert note_facts(result, "friction.at_zero")[0]["names"] == [VISCOUS]


def test_report_shows_laws_recordings_and_circuit_lines():
    page = identification_page(identify_friction(sealed_pulls(0, 0.0, SEALED), part="slide", cylinder="drive"))
    for text in ("Friction laws", "seal_friction = &quot;0.", "pressure.friction", "p3", "supported"):
        assert text in page


@pytest.mark.parametrize("count", [1, pytest.param(60, marks=pytest.mark.slow)])
def test_intervals_include_correlated_residuals(count):
    """The friction has random changes of 0.3 N with a correlation time of about 1 s."""
    coverage, speeds = [], (0.003, 0.008, 0.02, 0.05, 0.1) * 2
    record = reversed_pulls(PULLED, speeds)
    channels = {name: getattr(record, name) for name in ("time", "position", "pressure", "pressure_force")}
    for seed in range(count):
        generator = np.random.default_rng(seed)
        wander = lfilter(
            [0.3 * math.sqrt(1.0 - 0.99**2)], [1.0, -0.99], generator.standard_normal(record.time.size + 500)
        )
        wandering = FrictionRecord(force=record.force + wander[500:], **channels)
        result = identify_friction(wandering, law="stribeck_viscous")
        coverage.append(cover_truth(result, {name: value for name, value in PULLED.items() if name != BRISTLES}))
    assert np.mean(coverage) > (0.7 if count == 1 else 0.9)


def test_friction_that_depends_on_the_position_is_reported():
    record = reversed_pulls({COULOMB: 8.0, BRISTLES: 4e4}, (0.01,) * 6)
    additional_force = np.where(record.position > 0.025, 2.0, 0.0) * np.sign(np.gradient(record.position, 0.5))
    channels = {name: getattr(record, name) for name in ("time", "position", "pressure", "pressure_force")}
    uneven = FrictionRecord(force=record.force + additional_force, **channels)
    (facts,) = note_facts(identify_friction(uneven), "friction.places")
    assert facts["off"] > 0.5
    assert facts["place"][1] > 0.025
    assert not note_facts(identify_friction(uneven, within=(0.002, 0.024)), "friction.places")


def test_force_of_a_changing_pressure_is_not_friction():
    """The pressure is higher in one direction, so half the force difference exceeds the friction."""
    record = reversed_pulls({COULOMB: 8.0, BRISTLES: 4e4}, (0.01,) * 6, pressure=3e5)
    pressure_change = 4e3 * np.sign(np.gradient(record.position, 0.5))
    pressure = record.pressure + pressure_change
    changing = FrictionRecord(time=record.time, position=record.position, force=record.force + pressure_change * AREA,
                           pressure=pressure, pressure_force=-pressure * AREA)  # fmt: skip
    result = identify_friction(changing)
    assert result.parameters[COULOMB].value == pytest.approx(8.0, rel=0.02)
    (facts,) = note_facts(result, "friction.pressure_moves")
    assert facts["crude"][0] == pytest.approx(8.0 + 4e3 * AREA, rel=0.03)
    assert note_facts(result, "friction.one_pressure")


def test_inertia_force_is_subtracted():
    time, generator = np.arange(0.0, 6.0, 0.002), np.random.default_rng(7)
    position = 0.02 * np.sin(2.0 * np.pi * 1.5 * time)
    velocity = 0.02 * 2.0 * np.pi * 1.5 * np.cos(2.0 * np.pi * 1.5 * time)
    force = 5.0 * np.sign(velocity) + 20.0 * velocity - 3.0 * (2.0 * np.pi * 1.5) ** 2 * position
    force += 0.1 * generator.standard_normal(time.size)
    position = position + 1e-6 * generator.standard_normal(time.size)
    result = identify_friction(FrictionRecord(time=time, position=position, force=force), mass=3.0)
    assert result.comparison["levels"] == "coulomb_viscous"
    assert result.parameters[COULOMB].value == pytest.approx(5.0, rel=0.02)
    assert result.parameters[VISCOUS].value == pytest.approx(20.0, rel=0.05)


# Invalid input ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("columns", "code"),
    [
        ({"force": [1.0, 2.0, 3.0], "velocity": [0.1, 0.2]}, "friction.shape"),
        ({"force": [1.0, np.nan, 3.0], "velocity": [0.1, 0.2, 0.3]}, "friction.not_finite"),
        ({"force": [1.0, 2.0], "velocity": [0.1, 0.2]}, "friction.too_few"),
        ({"force": [1.0, 2.0, 3.0], "position": [0.1, 0.2, 0.3]}, "friction.no_velocity"),
        ({"force": [1.0, 2.0, 3.0], "velocity": [0.1, 0.2, 0.3], "uncertainty": 0.0}, "fields.out_of_range"),
        ({"force": [1.0, 2.0, 3.0], "position": [0.1, 0.2, 0.3], "time": [0, 1, 1]}, "series.time.not_increasing"),
        ({"force": [1.0, 2.0, 3.0], "position": [0.1, 0.1, 0.1], "time": [0, 1, 2]}, "friction.at_rest"),
    ],
)
def test_invalid_records_are_rejected(columns, code):
    with refused(code):
        FrictionRecord(**columns)


def test_unsuitable_tables_are_rejected():
    with refused("friction.one_way", "offset"):
        identify_friction(steady_table({COULOMB: 20.0}, has_both_directions=False), offset="free")
    with refused("fields.not_an_option", "law"):
        identify_friction(steady_table({COULOMB: 20.0}), law="karnopp")
    with refused("friction.no_law", "force"):
        identify_friction(FrictionRecord(force=[1.0, 2.0, 3.0], velocity=[0.1, 0.2, 0.3], pressure=[1e5, 1e5, 2e5]))
    with refused("friction.at_rest", "velocity"):
        identify_friction(FrictionRecord(force=np.ones(5), velocity=np.zeros(5)))
    with refused("friction.helps", "force"):
        identify_friction(
            FrictionRecord(force=-steady_table({COULOMB: 20.0}).force, velocity=steady_table({COULOMB: 20.0}).velocity)
        )
    at_one_speed = FrictionRecord(force=[1.0, 1.1, 1.0, 0.9], velocity=[0.1, 0.1, 0.1, 0.1])
    assert identify_friction(at_one_speed).comparison["law"] == "coulomb"
    with refused("friction.law_not_told", "law"):
        identify_friction(at_one_speed, law="stribeck")


FILE = """\
file = ["a.csv", "b.csv"]
time = { column = 0, unit = "ms" }
position = { column = 1, unit = "mm" }
force = { column = 2, unit = "N" }
pressure = { value = ["1 bar g", "3 bar g"] }
bore = "20 mm"
direction = -1
skip = "15 ms"
"""


@pytest.fixture
def write_file(tmp_path):
    """Return a function that writes a friction file for two recordings."""
    for name in "ab":
        (tmp_path / f"{name}.csv").write_text("0\t0.0\t5\n10\t0.1\t6\n20\t0.2\t6\n30\t0.3\t6\n40\t0.4\t7\n")

    def write(text: str) -> Path:
        (tmp_path / "rig.toml").write_text(text)
        return tmp_path / "rig.toml"

    return write


def test_file_gives_records_in_si_units(write_file):
    records, options = read_friction_file(write_file(FILE))
    assert [record.name for record in records] == ["a", "b"]
    assert records[1].time == pytest.approx([0.02, 0.03, 0.04])
    assert records[1].pressure == pytest.approx(3e5)
    assert records[1].pressure_force == pytest.approx(-3e5 * 0.25 * math.pi * 0.02**2)
    assert (options["title"], options["within"]) == ("rig", None)


@pytest.mark.parametrize(
    ("change", "code", "address"),
    [
        (('file = ["a.csv", "b.csv"]\n', ""), "fields.missing", "file"),
        (('force = { column = 2, unit = "N" }\n', ""), "fields.missing", "force"),
        (('position = { column = 1, unit = "mm" }\n', ""), "friction.no_velocity", "velocity"),
        (("direction = -1", "direction = 2"), "bodies.direction", "direction"),
        (("skip =", "skipp ="), "fields.unknown", "skipp"),
        (("column = 2", "columm = 2"), "fields.unknown", "force.columm"),
        (("column = 2, ", ""), "fields.missing", "force.column"),
        (('{ value = ["1 bar g", "3 bar g"] }', "{ }"), "friction.column_or_value", "pressure"),
        (('["1 bar g", "3 bar g"]', '["1 bar g"]'), "friction.values", "pressure.value"),
        (('["1 bar g", "3 bar g"]', '["1 bar g", "3 N"]'), "quantity.other_quantity", "pressure.value"),
        (('bore = "20 mm"', 'bore = "20 mm"\narea = "3 cm^2"'), "friction.bore_or_area", "area"),
        (('skip = "15 ms"', 'within = ["3 mm", "1 mm"]'), "friction.within", "within"),
        (('unit = "mm"', 'unit = "bar"'), None, "position"),
    ],
)
def test_each_error_of_a_file_has_its_address(write_file, change, code, address):
    file = write_file(FILE.replace(*change))
    if code is None:
        with pytest.raises(ValueError) as caught:
            read_friction_file(file)
        assert caught.value.address.startswith(address)
    else:
        with refused(code, address):
            read_friction_file(file)


def test_pressure_force_uses_both_chambers(tmp_path):
    (tmp_path / "run.csv").write_text("v,F,cap,rod\n10,5,2,1\n20,6,2,1\n40,7,2,1\n")
    (tmp_path / "rig.toml").write_text("""\
file = "run.csv"
velocity = { column = "v", unit = "mm/s" }
force = { column = "F", unit = "N", uncertainty = "0.1 N" }
pressure = { column = "cap", unit = "bar g" }
counter_pressure = { column = "rod", unit = "bar g" }
bore = "20 mm"
rod_diameter = "8 mm"
""")
    (record,), _ = read_friction_file(tmp_path / "rig.toml")
    piston, rod = (0.25 * math.pi * d**2 for d in (0.02, 0.008))
    assert record.pressure == pytest.approx(1e5)
    assert record.pressure_force == pytest.approx(2e5 * piston - 1e5 * (piston - rod))
    assert record.uncertainty == pytest.approx(0.1)


def test_all_errors_of_a_file_are_raised_together(write_file):
    text = FILE.replace("direction = -1", "direction = 2\nareaa = 1").replace("15 ms", "15 N")
    with pytest.raises(ValueError) as caught:
        read_friction_file(write_file(text.replace("column = 2", "columm = 2")))
    addresses = {problem.address for problem in caught.value.problems}
    assert addresses >= {"direction", "areaa", "skip", "force.columm"}
