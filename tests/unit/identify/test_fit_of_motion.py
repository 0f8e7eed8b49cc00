"""Numbers of friction and of a muscle as free numbers of `identify fit`, found from recorded motions.

The truth of the slide is an integrator of this file's own, with SciPy: mass, LuGre friction, a force that is recorded.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from poppet import load
from poppet.identify import Result, identify_fit

MASS, STIFFNESS, DAMPING = 2.0, 1e6, 2.0 * (1e6 * 2.0) ** 0.5
TRUTH = {
    "slide.friction.coulomb_force": 8.0,
    "slide.friction.static_force": 12.0,
    "slide.friction.stribeck_velocity": 0.03,
    "slide.friction.viscous_coefficient": 25.0,
    "drive.seal_friction": 8e-6,
}
AREA = 0.25 * np.pi * 1e-6
"""Of a cylinder of 1 mm, so thin that hardly anything but its seals is felt [m^2]."""
PRESSED = {"vented": 0.0, "pressed": 3e5}
"""Pressure difference across the seals in each recording [Pa]."""


TIME = np.arange(0.0, 4.0, 0.005)
FORCE = 26.0 * np.sin(2.0 * np.pi * 0.8 * TIME) + 9.0 * np.sin(2.0 * np.pi * 0.37 * TIME)
"""Two sines, so that the slide moves fast, slowly and not at all; straight between the samples, as an input is."""


def simulate_slide(difference: float) -> np.ndarray:
    """Return positions of the slide under a pressure difference."""
    fc, fs, vs, viscous, seal = TRUTH.values()
    fc, fs = fc + seal * difference, fs + seal * difference

    def rates(t: float, state: np.ndarray) -> list[float]:
        _, v, z = state
        fading = np.exp(-((v / vs) ** 2))
        bending = v - STIFFNESS * abs(v) * z / (fc + (fs - fc) * fading)
        friction = STIFFNESS * z + DAMPING * fading * bending + viscous * v
        return [v, (np.interp(t, TIME, FORCE) + AREA * difference - friction) / MASS, bending]

    found = solve_ivp(rates, (0.0, TIME[-1]), [0.0, 0.0, 0.0], "LSODA", TIME, rtol=1e-8, atol=1e-11, max_step=0.005)
    return np.asarray(found.y[0])


SLIDE = f"""
[parts.slide]
kind = "mass"
mass = "{MASS} kg"
[parts.slide.friction]
kind = "lugre"
coulomb_force = "5 N"
static_force = "8 N"
stribeck_velocity = "0.05 m/s"
viscous_coefficient = "10 N s/m"
bristle_stiffness = "{STIFFNESS} N/m"
bristle_damping = "{DAMPING} N s/m"
[parts.drive]
kind = "cylinder"
body = "slide"
bore = "1 mm"
stroke_length = "10 m"
offset = "5 m"
seal_friction = "1 N/bar"
cap = {{ dead_volume = "1 cm^3", initial_pressure = "1 bar" }}
rod = {{ dead_volume = "1 cm^3", initial_pressure = "1 bar" }}
[parts.supply]
kind = "reservoir"
pressure = "1 bar"
[parts.line]
kind = "orifice"
from = "supply"
to = "drive.cap"
sonic_conductance = "1e-8 m^3/(s Pa)"
critical_ratio = 0.3
[parts.vent]
kind = "orifice"
from = "drive.rod"
to = "ambient"
sonic_conductance = "1e-8 m^3/(s Pa)"
critical_ratio = 0.3
[run]
duration = "4 s"
"""
FIT = """
circuit = "slide.toml"
kicks = 0
[recordings.vented]
file = "vented.csv"
time = { column = "t", unit = "s" }
inputs = { "slide.load_force" = { column = "F", unit = "N" }, "supply.pressure" = { column = "p", unit = "bar" } }
"slide.position" = { column = "x", unit = "mm" }
[recordings.pressed]
file = "pressed.csv"
time = { column = "t", unit = "s" }
start = { "drive.cap.initial_pressure" = "4 bar" }
inputs = { "slide.load_force" = { column = "F", unit = "N" }, "supply.pressure" = { column = "p", unit = "bar" } }
"slide.position" = { column = "x", unit = "mm" }
[free]
"drive.seal_friction" = { min = 0, max = 1e-4 }
"slide.friction.coulomb_force" = { min = 0, max = 50 }
"slide.friction.static_force" = { min = 0, max = 50 }
"slide.friction.stribeck_velocity" = { min = 0.005, max = 0.5 }
"slide.friction.viscous_coefficient" = { min = 0, max = 200 }
"""


def fit_recordings(folder: Path, seed: int) -> Result:
    """Return a fit of both recordings, with a noise of 0.05 mm and steps of 0.01 mm."""
    random = np.random.default_rng(seed)
    for name, difference in PRESSED.items():
        seen = np.round((1e3 * simulate_slide(difference) + 0.05 * random.standard_normal(TIME.size)) / 0.01) * 0.01
        # The load acts towards smaller positions.
        columns = np.column_stack([TIME, -FORCE, np.full(TIME.size, 1.0 + difference / 1e5), seen])
        np.savetxt(folder / f"{name}.csv", columns, delimiter=",", header="t,F,p,x", comments="")
    (folder / "slide.toml").write_text(SLIDE)
    (folder / "fit.toml").write_text(FIT)
    return identify_fit(folder / "fit.toml")


@pytest.mark.parametrize("count", [1, pytest.param(20, marks=pytest.mark.slow)])
def test_fit_recovers_friction_from_a_recorded_motion(tmp_path, count):
    held = []
    for seed in range(count):
        found = fit_recordings(tmp_path, seed).parameters
        assert {name: found[name].value for name in TRUTH} == pytest.approx(TRUTH, rel=0.1)
        held += [found[name].low <= value <= found[name].high for name, value in TRUTH.items()]
    assert np.mean(held) > (0.7 if count == 1 else 0.9)


LIFT = {
    "muscle.sarosi.a5": 2.5e-3,
    "muscle.damping": 350.0,
    "muscle.hysteresis.force": 14.0,
    "fill.sonic_conductance": 1.6e-9,
}
"""What differs from the example that lifts a weight."""


def fit_lift(folder: Path, seed: int) -> Result:
    """Return a fit of a muscle that lifts a weight and lets it down, from position and pressure."""
    example = Path(__file__).parents[3] / "examples" / "muscle_lift.toml"
    run = load(example).with_values(LIFT).simulate()
    random = np.random.default_rng(seed)
    position = 1e3 * run["weight.position"] + 0.05 * random.standard_normal(run.time.size)
    pressure = run["muscle.pressure"] / 1e5 + 0.005 * random.standard_normal(run.time.size)
    columns = np.column_stack([run.time, position, pressure])
    np.savetxt(folder / "run.csv", columns, delimiter=",", header="t,x,p", comments="")
    (folder / "lift.toml").write_text(example.read_text(encoding="utf-8"), encoding="utf-8")
    free = "".join(f'"{name}" = {{ min = {0.2 * value}, max = {5.0 * value} }}\n' for name, value in LIFT.items())
    (folder / "fit.toml").write_text(
        'circuit = "lift.toml"\nkicks = 0\n[recordings.run]\nfile = "run.csv"\ntime = { column = "t", unit = "s" }\n'
        '"weight.position" = { column = "x", unit = "mm" }\n"muscle.pressure" = { column = "p", unit = "bar" }\n'
        f"[free]\n{free}"
    )
    return identify_fit(folder / "fit.toml")


@pytest.mark.parametrize("count", [1, pytest.param(20, marks=pytest.mark.slow)])
def test_fit_recovers_a_muscle_from_a_recorded_motion(tmp_path, count):
    held = []
    for seed in range(count):
        found = fit_lift(tmp_path, seed).parameters
        assert {name: found[name].value for name in LIFT} == pytest.approx(LIFT, rel=0.1)
        held += [found[name].low <= value <= found[name].high for name, value in LIFT.items()]
    assert np.mean(held) > (0.7 if count == 1 else 0.9)
