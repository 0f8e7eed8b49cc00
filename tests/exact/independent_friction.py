"""Independent friction tests, by NumPy and SciPy only: no code of `poppet`.

Tables and recordings with a Stribeck excess that grows with the pressure, the motion of a mass with the
elasto-plastic law, and that of a mass whose friction depends on direction and position.

The friction of steady sliding is F(v, p) = Fc + (Fs - Fc + ks p) exp(-(v/vs)^2) + k p + d v. With ks = 0, seals
add the same friction at each speed.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.integrate import solve_ivp


def simulate_elasto_plastic(law, mass, load, times):
    """Return position, velocity and friction of a mass from rest under `load(t)`, (3, n), at the given times.

    The equations are those of Dupont, Hayward, Armstrong & Altpeter, IEEE Trans. Automatic Control 47 (2002) 787-792,
    with a bristle damping that decreases with the speed. `law` has the parameters Fc, Fs, vs, s0, s1, s2
    and zba.
    """

    def friction(v, z):
        steady = (law["Fc"] + (law["Fs"] - law["Fc"]) * np.exp(-((v / law["vs"]) ** 2))) / law["s0"]
        if np.sign(v) != np.sign(z) or abs(z) <= law["zba"]:
            alpha = 0.0
        elif abs(z) >= steady:
            alpha = 1.0
        else:
            middle = 0.5 * (steady + law["zba"])
            alpha = 0.5 * np.sin(np.pi * (abs(z) - middle) / (steady - law["zba"])) + 0.5
        rate = v * (1.0 - alpha * z * np.sign(v) / steady)
        damping = law["s1"] * np.exp(-((v / law["vs"]) ** 2))
        return law["s0"] * z + damping * rate + law["s2"] * v, rate

    def rates(t, y):
        force, rate = friction(y[1], y[2])
        return [y[1], (load(t) - force) / mass, rate]

    solution = solve_ivp(
        rates, (0.0, times[-1]), [0.0, 0.0, 0.0], "LSODA", times, rtol=1e-9, atol=[1e-12, 1e-11, 1e-14], max_step=1e-2
    )
    x, v, z = solution.y
    return np.array([x, v, [friction(*pair)[0] for pair in zip(v, z, strict=True)]])


def simulate_directed(law, mass, load, times):
    """Return position, velocity and friction of a mass from rest under `load(t)`, (3, n), at the given times.

    The friction depends on direction and position. `law` has the kind, the parameters s0, s1 and vs, and pairs Fc, Fs,
    s2 and zba with the values at positive and at negative velocity. `law["factor"]` has positions and factors.
    """

    def friction(x, v, z):
        side = 1 if v < 0.0 else 0
        scale = np.interp(x, *law["factor"])
        coulomb, static, viscous = (scale * law[name][side] for name in ("Fc", "Fs", "s2"))
        fading = np.exp(-((v / law["vs"]) ** 2))
        level = coulomb + (static - coulomb) * fading
        if law["kind"] == "viscous":
            return viscous * v, 0.0
        if law["kind"] == "stribeck":
            return level * np.tanh(v / law["vt"]) + viscous * v, 0.0
        steady, elastic = level / law["s0"], scale * law["zba"][side]
        if law["kind"] == "lugre" or (v * z > 0.0 and abs(z) >= steady):
            alpha = 1.0
        elif v * z <= 0.0 or abs(z) <= elastic:
            alpha = 0.0
        else:
            alpha = 0.5 + 0.5 * np.sin(np.pi * (abs(z) - 0.5 * (steady + elastic)) / (steady - elastic))
        rate = v - alpha * abs(v) * z / steady
        return law["s0"] * z + law["s1"] * fading * rate + viscous * v, rate

    def rates(t, y):
        force, rate = friction(*y)
        return [y[1], (load(t) - force) / mass, rate]

    solution = solve_ivp(
        rates, (0.0, times[-1]), [0.0, 0.0, 0.0], "LSODA", times, rtol=1e-9, atol=[1e-12, 1e-11, 1e-14], max_step=1e-3
    )
    x, v, z = solution.y
    return np.array([x, v, [friction(*values)[0] for values in zip(x, v, z, strict=True)]])


def draw_truth(generator: np.random.Generator, growth: float) -> dict[str, float]:
    """Draw the parameters of a cylinder; the Stribeck excess at 6 bar is 1 + `growth` times that without pressure."""
    coulomb = generator.uniform(5.0, 30.0)
    excess = coulomb * generator.uniform(0.3, 0.8)
    return {
        "coulomb": coulomb,
        "excess": excess,
        "stribeck": np.exp(generator.uniform(np.log(0.01), np.log(0.05))),
        "viscous": generator.uniform(20.0, 80.0),
        "seal": coulomb * generator.uniform(0.3, 1.0) / 6e5,
        "seal_excess": growth * excess / 6e5,
    }


def steady_friction(speed: np.ndarray, pressure: np.ndarray | float, truth: dict[str, float]) -> np.ndarray:
    """Return the friction against the motion at positive speeds [N]."""
    excess = truth["excess"] + truth["seal_excess"] * pressure
    fading = np.exp(-((speed / truth["stribeck"]) ** 2))
    return truth["coulomb"] + truth["seal"] * pressure + excess * fading + truth["viscous"] * speed


def draw_table(seed: int, growth: float) -> tuple[dict[str, float], dict[str, np.ndarray]]:
    """Return the truth and a table of pulls at three to five pressures and 10 to 20 speeds in both directions."""
    generator = np.random.default_rng(seed)
    truth = draw_truth(generator, growth)
    pressures = np.linspace(generator.uniform(0.0, 1e5), generator.uniform(5e5, 8e5), generator.integers(3, 6))
    speeds = np.geomspace(0.1 * truth["stribeck"], 0.5, generator.integers(10, 21))
    speed, pressure = (grid.ravel() for grid in np.meshgrid(speeds, pressures))
    friction = steady_friction(speed, pressure, truth)
    speed, friction, pressure = np.r_[speed, -speed], np.r_[friction, -friction], np.r_[pressure, pressure]
    noise = generator.uniform(0.005, 0.03) * truth["coulomb"]
    force = friction + noise * generator.standard_normal(friction.size)
    return truth, {"force": force, "velocity": speed, "pressure": pressure}


def draw_recordings(seed: int, growth: float) -> tuple[dict[str, float], list[dict[str, Any]]]:
    """Return the truth and recordings of strokes at eight speeds, one recording for each of four or five pressures.

    The bristles bend over 20 um after each reversal. The friction of recordings varies by 1 % (standard deviation).
    """
    generator = np.random.default_rng(seed)
    truth = draw_truth(generator, growth)
    pressures = np.linspace(generator.uniform(0.0, 1e5), generator.uniform(5e5, 8e5), generator.integers(4, 6))
    speeds = np.geomspace(0.2 * truth["stribeck"], 0.4, 8)
    recordings, noise = [], generator.uniform(0.01, 0.03) * truth["coulomb"]
    for pressure in pressures:
        level = 1.0 + 0.01 * generator.standard_normal()
        time, position, force, now = [], [], [], 0.0
        for speed in speeds:
            for sign in (1.0, -1.0):
                travel = 0.02
                t = np.linspace(0.0, travel / speed, 200, endpoint=False)
                distance = speed * t
                friction = level * steady_friction(np.array([speed]), pressure, truth)[0]
                bent = friction * (1.0 - 2.0 * np.exp(-distance / 2e-5))
                time.append(now + t)
                position.append(distance if sign > 0.0 else travel - distance)
                force.append(sign * bent)
                now += travel / speed
        columns = [np.concatenate(parts) for parts in (time, position, force)]
        columns[1] = columns[1] + 2e-6 * generator.standard_normal(columns[1].size)
        columns[2] = columns[2] + noise * generator.standard_normal(columns[2].size) + generator.normal()
        recordings.append(
            dict(zip(("time", "position", "force"), columns, strict=True)) | {"pressure": float(pressure)}
        )
    return truth, recordings
