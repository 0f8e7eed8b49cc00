"""Speed of a fit against SciPy's `least_squares` around `solve_ivp(LSODA)`, side by side in one run.

Both fit six numbers - C, b, m, the wall's conductance and temperature, the initial pressure - to the same 1200 noisy
pressures of a tank of 20 litres that empties, from the same start, inside the same bounds, with the same weights. The
peer is written as a careful user would: right-hand side in plain floats, numbers scaled to 1, Jacobian of the states
left to LSODA, differences in the numbers large against the integrator's tolerance. Of several tolerances and steps the
peer keeps the fastest that ends in the same minimum: within 1e-4 of our cost and within 1 % of a standard error of
our numbers.
"""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

import poppet
from poppet import Chamber, Circuit, Orifice
from poppet.identify.experiment import Experiment
from poppet.identify.fit import Optimum, optimise
from poppet.identify.free import Free, read_free
from poppet.identify.statistics import covariance
from poppet.measured import Channel, Measurement

VOLUME, NOISE, SAMPLES, DURATION = 0.02, 700.0, 1200, 60.0
TRUTH = {
    "valve.sonic_conductance": 1e-8,
    "valve.critical_ratio": 0.35,
    "valve.subsonic_index": 0.5,
    "tank.wall_conductance": 6.0,
    "tank.wall_temperature": 293.15,
    "tank.initial_pressure": 7e5,
}
START = dict(zip(TRUTH, (1.15e-8, 0.3, 0.55, 5.0, 291.0, 6.9e5), strict=True))


def circuit(numbers: dict[str, float]) -> Circuit:
    """The tank and its valve."""
    parts = {"tank": Chamber(volume=VOLUME), "valve": Orifice(from_="tank", to="ambient", sonic_conductance=1e-8)}
    return Circuit(parts).with_values(numbers)


def peer_pressure(x: np.ndarray, grid: np.ndarray, tolerance: float) -> np.ndarray:
    """Tank pressure on a grid by LSODA; pressure and mass are the states, both over their initial values."""
    c, b, m, wall, t_wall, p0 = (float(v) for v in x)
    gas, kappa, outside, t0, lam = 287.05, 1.4, 1e5, 293.15, 0.999
    m0 = p0 * VOLUME / (gas * t0)
    cp, factor, slope = kappa * gas / (kappa - 1.0), 1.185 * c * math.sqrt(293.15), (kappa - 1.0) / (VOLUME * p0)
    u = (lam - b) / (1.0 - b)
    g, zone = 1.0 - u * u, 1.0 - lam
    s = 2.0 * m * zone * u / (g * (1.0 - b))
    edge = g**m

    def rates(t: float, y: list[float]) -> tuple[float, float]:
        p = y[0] * p0
        temperature = p * VOLUME / (y[1] * m0 * gas)
        r = outside / p
        if r <= b:
            shape = 1.0
        elif r <= lam:
            v = (r - b) / (1.0 - b)
            shape = (1.0 - v * v) ** m
        else:
            z = (1.0 - r) / zone
            shape = edge * z * (0.5 * (3.0 - s) + z * z * 0.5 * (s - 1.0))
        flow = factor * p / math.sqrt(temperature) * shape
        return slope * (wall * (t_wall - temperature) - cp * temperature * flow), -flow / m0

    run = solve_ivp(rates, (0.0, grid[-1]), [1.0, 1.0], method="LSODA", t_eval=grid, rtol=tolerance, atol=tolerance)
    return p0 * run.y[0]


def peer_fit(free: tuple[Free, ...], grid: np.ndarray, values: np.ndarray, tolerance: float, step: float) -> np.ndarray:
    """The numbers as the peer finds them."""
    scale = np.array([f.start for f in free])
    low, high = (np.array([getattr(f, end) for f in free]) / scale for end in ("low", "high"))
    found = least_squares(
        lambda z: (peer_pressure(z * scale, grid, tolerance) - values) / NOISE,
        np.ones(len(free)),
        bounds=(low, high),
        x_scale="jac",
        diff_step=step,
        ftol=1e-9,
        xtol=1e-9,
    )
    return found.x * scale


def median_time(run: Callable[[], object], rounds: int) -> float:
    """Median wall time [s]."""
    times = []
    for _ in range(rounds):
        begin = time.perf_counter()
        run()
        times.append(time.perf_counter() - begin)
    return statistics.median(times)


def main() -> None:
    grid = np.linspace(0.0, DURATION, SAMPLES)
    exact = circuit(TRUTH).simulate(DURATION, DURATION / (SAMPLES - 1), 1e-10)["tank.pressure"]
    values = exact + np.random.default_rng(7).normal(0.0, NOISE, SAMPLES)
    measurement = Measurement("test", (Channel("tank.pressure", grid, values, "Pa", NOISE),), duration=DURATION)
    model = circuit(START)
    free = tuple(read_free(name, {"start": value}, model) for name, value in START.items())

    def ours() -> Optimum:
        return optimise([Experiment(model, measurement, free)], free)

    def cost(x: np.ndarray) -> float:
        return 0.5 * float(np.sum(((peer_pressure(x, grid, 1e-10) - values) / NOISE) ** 2))

    best = ours()
    errors = np.sqrt(np.diag(covariance(best, 1.0)))
    print(f"poppet {poppet.__version__}; six numbers from {SAMPLES} pressures")
    print(f"poppet: cost {cost(best.x):.6f}, {best.evaluations} evaluations")
    fastest = math.inf
    for tolerance, step in ((1e-6, 1e-3), (1e-7, 1e-4), (1e-8, 1e-4), (1e-9, 1e-5), (1e-10, 1e-5)):
        begin = time.perf_counter()
        x = peer_fit(free, grid, values, tolerance, step)
        seconds = time.perf_counter() - begin
        apart = float(np.max(np.abs(x - best.x) / errors))
        same = abs(cost(x) / cost(best.x) - 1.0) < 1e-4 and apart < 0.01
        fastest = min(fastest, seconds) if same else fastest
        verdict = "the same minimum" if same else "not the same minimum"
        print(
            f"LSODA rtol {tolerance:.0e}, step {step:.0e}: cost {cost(x):.6f}, {apart:.1e} s.e. away, {verdict}, ",
            end="",
        )
        print(f"{1e3 * seconds:.0f} ms")
    seconds = median_time(ours, 11)
    print(f"poppet, warm: {1e3 * seconds:.1f} ms; {fastest / seconds:.0f} times faster than the fastest of these")


if __name__ == "__main__":
    main()
