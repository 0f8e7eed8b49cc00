"""The peer of `sampled_control.py`: a sampled pressure valve in SciPy, as a careful user would write it.

It imports nothing of poppet; its numbers come by their addresses. Everything inside a sample is plain floats in locals,
powers are Horner sums, the flow law is branched, what is closed is skipped. Of the pilot's gas it integrates the
pressure and not an energy, which is cheaper. It carries no integrals of the flows and writes no outputs but the state.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from scipy.integrate import ode, odeint, solve_ivp

Rates = Callable[[float, list[float], float, float], tuple[float, ...]]
SIZES = np.array([1e-4, 1e-2, 1e5, 1e-5, 1e5, 1e5, 1e5, 1.0])
"""Of stroke, velocity, pilot pressure and mass, two sensors, tank pressure and mass."""


def flow_law() -> Callable[[float, float, float, float, float, float], tuple[float, float]]:
    """Mass flow rate from 1 to 2 and the temperature that it carries."""
    sqrt, lam, zone = math.sqrt, 0.999, 1.0 - 0.999

    def flow(p1: float, p2: float, t1: float, t2: float, c: float, b: float) -> tuple[float, float]:
        if p1 >= p2:
            up, low, sign, temperature = p1, p2, 1.0, t1
        else:
            up, low, sign, temperature = p2, p1, -1.0, t2
        r = low / up
        if r <= lam:
            base = sign * c * up * 1.185 * sqrt(293.15 / temperature)
            if r <= b:
                return base, temperature
            u = (r - b) / (1.0 - b)
            return base * sqrt(1.0 - u * u), temperature
        u = (lam - b) / (1.0 - b)
        g = 1.0 - u * u
        s = zone * u / (g * (1.0 - b))
        z = (1.0 - r) / zone
        zs = sign * z
        w = 0.5 + 0.25 * (3.0 * zs - zs * zs * zs)
        temperature = w * t1 + (1.0 - w) * t2
        shape = z * (0.5 * (3.0 - s) + z * z * 0.5 * (s - 1.0))
        return sign * c * up * 1.185 * sqrt(293.15 / temperature) * sqrt(g) * shape, temperature

    return flow


def valve_rates(number: dict[str, float]) -> Rates:
    """Rates of the eight states for given openings of the solenoids."""
    stage, pilot = "valve.main_stage.", "valve.pilot."
    k = [number[f"{stage}characteristic.sonic_conductance.k{i}"] for i in range(1, 9)]
    q = [number[f"{stage}characteristic.critical_ratio.p{i}"] for i in range(1, 6)]
    k1c, k2c, k3c, k4c, k5c, k6c, k7c, k8c = k
    q1c, q2c, q3c, q4c, q5c = q
    area, mass, damping = (number[stage + n] for n in ("plate_area", "moving_mass", "damping"))
    k1, h1 = number[stage + "upper_spring.rate"], number[stage + "upper_spring.preload"]
    k2, h2 = number[stage + "lower_spring.rate"], number[stage + "lower_spring.preload"]
    width, contact = number[stage + "contact.width"], number[stage + "contact.dissipation"]
    up_x, up_k, up_d = (number[f"{stage}upper_stop.{n}"] for n in ("position", "stiffness", "dissipation"))
    low_x, low_k, low_d = (number[f"{stage}lower_stop.{n}"] for n in ("position", "stiffness", "dissipation"))
    c_ex, b_ex = number[stage + "exhaust_seat.sonic_conductance"], number[stage + "exhaust_seat.critical_ratio"]
    overlap, opening = number[stage + "overlap"], number[stage + "exhaust_seat.opening"]
    closing = number[stage + "characteristic.closing"]
    pilot_volume, pilot_wall = number[pilot + "volume"], number[pilot + "wall_conductance"]
    c_fill, b_fill = number[pilot + "fill.sonic_conductance"], number[pilot + "fill.critical_ratio"]
    c_vent, b_vent = number[pilot + "vent.sonic_conductance"], number[pilot + "vent.critical_ratio"]
    c_leak, b_leak = number[pilot + "exhaust_leak.sonic_conductance"], number[pilot + "exhaust_leak.critical_ratio"]
    lag1, lag2 = number["valve.electronics.outlet_sensor.lag"], number["valve.electronics.pilot_sensor.lag"]
    volume, h_a, t_wall = number["tank.volume"], number["tank.wall_conductance"], number["tank.wall_temperature"]
    gas, kappa, p_amb, p_sup, t_sup = 287.05, 1.4, 1e5, number["supply.pressure"], 293.15
    cp, flow, sqrt = kappa * gas / (kappa - 1.0), flow_law(), math.sqrt

    def rates(t: float, y: list[float], fill: float, vent: float) -> tuple[float, ...]:
        x, v, pp, mp, s1, s2, p, m = y
        temperature = p * volume / (m * gas)
        s = 1.0 + x / width
        lifted = 0.0 if s <= 0.0 else 1.0 if s >= 1.0 else s * s * (3.0 - 2.0 * s)
        force = area * (pp - p) - k1 * (h1 + x) - damping * v
        if lifted > 0.0:
            held = 4.0 * lifted * (1.0 - lifted)
            cv = contact * v
            force -= lifted * k2 * (h2 + (x if x > 0.0 else 0.0)) * (1.0 + held * cv / sqrt(1.0 + cv * cv))
        if x > up_x:
            d, cv = x - up_x, up_d * v
            force -= up_k * d * sqrt(d) * (1.0 + cv / sqrt(1.0 + cv * cv))
        elif x < low_x:
            d, cv = low_x - x, -low_d * v
            force += low_k * d * sqrt(d) * (1.0 + cv / sqrt(1.0 + cv * cv))
        q1 = q2 = h_in = h_out = 0.0
        if x > 0.0:
            mm = 1e3 * (x if x < 1e-3 else 1e-3)
            c = ((((((k1c * mm + k2c) * mm + k3c) * mm + k4c) * mm + k5c) * mm + k6c) * mm + k7c) * mm + k8c
            b = (((q1c * mm + q2c) * mm + q3c) * mm + q4c) * mm + q5c
            if x < closing:
                e = x / closing
                c *= e * e * (3.0 - 2.0 * e)
            q1, t1 = flow(p_sup, p, t_sup, temperature, c, b)
            h_in = cp * t1 * q1
        below = -x - overlap
        if below > 0.0:
            e = below / opening if below < opening else 1.0
            q2, t2 = flow(p, p_amb, temperature, t_sup, c_ex * e * e * (3.0 - 2.0 * e), b_ex)
            h_out = cp * t2 * q2
        heat = h_a * (t_wall - temperature)
        # The pilot: its volume grows with the stroke.
        v_pilot = pilot_volume + area * x
        t_pilot = pp * v_pilot / (mp * gas)
        qp, tp = flow(pp, p_amb, t_pilot, t_sup, c_leak + vent * c_vent, b_vent if vent else b_leak)
        q_pilot, h_pilot = -qp, -cp * tp * qp
        if fill:
            qp, tp = flow(p_sup, pp, t_sup, t_pilot, fill * c_fill, b_fill)
            q_pilot += qp
            h_pilot += cp * tp * qp
        h_pilot += pilot_wall * (t_sup - t_pilot)
        return (
            v, force / mass,
            ((kappa - 1.0) * h_pilot - kappa * pp * area * v) / v_pilot, q_pilot,
            (p - s1) / lag1, (pp - s2) / lag2,
            (kappa - 1.0) / volume * (h_in - h_out + heat), q1 - q2,
        )  # fmt: skip

    assert b_leak == b_vent, "one flow law serves vent and leak"
    return rates


def controller(number: dict[str, float]) -> Callable[[float, float, float], tuple[float, float]]:
    """The program of the electronics: what a sample of both sensors makes of the solenoids' openings."""
    outer = {name.rpartition(".")[2]: value for name, value in number.items() if ".electronics.outer." in name}
    inner = {name.rpartition(".")[2]: value for name, value in number.items() if ".electronics.inner." in name}
    gain, time, limit = outer["gain"], outer["sample_time"], outer["pilot_limit"]
    integral_time, lead, smoothing = outer["integral_time"], outer["derivative_time"], outer["derivative_filter"]
    dead, band, most = outer["dead_band"], outer["integral_band"], outer["integral_limit"]
    zone, most_added = outer["dead_zone"], outer["correction_limit"]
    forward, bias, ambient = outer["feed_forward"], outer["bias"], 1e5
    push, hold, least = inner["gain"], inner["hold_band"], inner["minimum_duty"]
    solenoid = "valve.pilot.fill."
    frequency = number[solenoid + "frequency"]
    late, longer = number[solenoid + "opening_delay"], number[solenoid + "closing_delay"]
    integral = derivative = 0.0
    before = math.nan

    def opening(duty: float) -> float:
        if duty <= late * frequency:
            return 0.0
        return 1.0 if duty >= 1.0 - longer * frequency else min(1.0, duty + (longer - late) * frequency)

    def control(target: float, outlet: float, pilot: float) -> tuple[float, float]:
        nonlocal integral, derivative, before
        error = target - outlet
        error = error - dead if error > dead else error + dead if error < -dead else 0.0
        change = before - outlet if before == before else 0.0
        derivative = (smoothing * derivative + gain * lead * change) / (smoothing + time)
        before = outlet
        wanted = gain * error + (zone * min(max(error / dead, -1.0), 1.0) if dead else 0.0) + integral
        straight = ambient + forward * (target - ambient) + bias + derivative
        added = min(max(wanted, -most_added), most_added) if most_added else wanted
        given = min(max(straight + added, ambient), limit)
        if abs(error) <= band:
            taken_back = given - straight - wanted
            integral = min(max(integral + time / integral_time * (gain * error + taken_back), -most), most)
        away = given - pilot
        if away > hold:
            return opening(min(push * away + least, 1.0)), 0.0
        return 0.0, opening(min(least - push * away, 1.0)) if away < -hold else 0.0

    return control


def start(number: dict[str, float]) -> list[float]:
    """Everything at 1 bar and 20 degC."""
    density = 1e5 / (287.05 * 293.15)
    return [0.0, 0.0, 1e5, number["valve.pilot.volume"] * density, 1e5, 1e5, 1e5, number["tank.volume"] * density]


def with_odeint(rates: Rates, tolerance: float, step: float) -> Callable[..., list[float]]:
    """A call of `odeint` for every sample."""
    absolute = tolerance * SIZES

    def plain(t: float, y: np.ndarray, fill: float, vent: float) -> tuple[float, ...]:
        return rates(t, y.tolist(), fill, vent)

    def sample(t: float, y: list[float], fill: float, vent: float) -> list[float]:
        found = odeint(plain, y, (t, t + step), (fill, vent), rtol=tolerance, atol=absolute, tfirst=True)
        return [float(value) for value in found[1]]

    return sample


def with_ode(rates: Rates, tolerance: float, step: float) -> Callable[..., list[float]]:
    """One `ode("lsoda")`, begun anew at every sample."""
    solver = ode(lambda t, y, fill, vent: rates(t, y.tolist(), fill, vent))
    solver.set_integrator("lsoda", rtol=tolerance, atol=tolerance * SIZES)

    def sample(t: float, y: list[float], fill: float, vent: float) -> list[float]:
        solver.set_initial_value(y, t).set_f_params(fill, vent)
        return [float(value) for value in solver.integrate(t + step)]

    return sample


def with_solve_ivp(rates: Rates, tolerance: float, step: float) -> Callable[..., list[float]]:
    """A call of `solve_ivp(method="LSODA")` for every sample."""
    absolute = tolerance * SIZES

    def sample(t: float, y: list[float], fill: float, vent: float) -> list[float]:
        found = solve_ivp(
            lambda t, y: rates(t, y.tolist(), fill, vent), (t, t + step), y, "LSODA", rtol=tolerance, atol=absolute
        )
        return [float(value) for value in found.y[:, -1]]

    return sample


WAYS = {"odeint": with_odeint, 'ode("lsoda")': with_ode, "solve_ivp(LSODA)": with_solve_ivp}


def peer_run(number: dict[str, float], way: str, tolerance: float, samples: int, times: list[float],
             targets: list[float]) -> np.ndarray:  # fmt: skip
    """Tank pressure at every hundredth sample, which is every row of ours."""
    rates, control, y = valve_rates(number), controller(number), start(number)
    step = number["valve.electronics.outer.sample_time"]
    sample, place, pressures = WAYS[way](rates, tolerance, step), -1, []
    for k in range(samples):
        t = k * step
        while place + 1 < len(times) and times[place + 1] <= t + 1e-9:
            place += 1
        if k % 100 == 0:
            pressures.append(y[6])
        fill, vent = control(targets[place], y[4], y[5])
        y = sample(t, y, fill, vent)
    return np.array([*pressures, y[6]])
