"""Independent model of the template `drive-sizing` in SciPy, without poppet.

It has flows by ISO 6358, energy balances, and a slide with Coulomb and viscous friction. Each tube is one resistance:
half its volume is at the valve, the other half in the chamber. The template has four cells instead.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

R, CP, CV, T0, RHO0 = 287.05, 3.5 * 287.05, 2.5 * 287.05, 293.15, 1.185
AMBIENT, SUPPLY = 1e5, 7e5
STROKE, DEAD = 0.250, 20e-6
CAP_AREA, ROD_AREA = math.pi / 4.0 * 0.063**2, math.pi / 4.0 * (0.063**2 - 0.020**2)
TUBE_BORE, TUBE_LENGTH = 7.5e-3, 2.0
HALF_TUBE = math.pi / 8.0 * TUBE_BORE**2 * TUBE_LENGTH
TUBE_C = 0.029 * TUBE_BORE**2 / math.sqrt(TUBE_LENGTH / TUBE_BORE**1.25 + 510.0)
TUBE_B = 474.0 * TUBE_C / TUBE_BORE**2
WALLS = np.array([0.25, 1.25, 0.25, 1.25])  # [W/K]: tube, cap with tube, tube, rod side with tube
MASS, LOAD, COULOMB, VISCOUS = 25.0, 400.0, 60.0, 100.0
EXTEND, RETRACT, END = 0.1, 2.1, 4.1
SWITCHING, CLOSING = 15e-3, 25e-3


@dataclass(frozen=True)
class Valve:
    """C [m^3/(s Pa)] and b of the edges from the supply, and of those to the exhaust."""

    conductance: float
    ratio: float
    exhaust_conductance: float
    exhaust_ratio: float


@dataclass(frozen=True)
class Cycle:
    """Times from the command to 98 % of the stroke [s], and air of the double stroke [l ANR]."""

    extend: float
    retract: float
    air: float


def mass_flow(first, second, conductance: float, ratio: float) -> tuple[float, float]:
    """Mass flow rate from the first pair of pressure and temperature to the second, and its enthalpy flow."""
    (high, temperature), (low, _) = (first, second) if first[0] >= second[0] else (second, first)
    r = low / high
    if r > 0.999:  # linear near equal pressures
        psi = math.sqrt(1.0 - ((0.999 - ratio) / (1.0 - ratio)) ** 2) * (1.0 - r) / 0.001
    else:
        psi = math.sqrt(1.0 - max(0.0, (r - ratio) / (1.0 - ratio)) ** 2)
    flow = math.copysign(conductance * RHO0 * high * math.sqrt(T0 / temperature) * psi, first[0] - second[0])
    return flow, CP * temperature * flow


def openings(time: float) -> tuple[float, float]:
    """Openings of the edges that extend the cylinder and of those that retract it; the spool moves between them."""
    if time < RETRACT:
        travel = min(max((time - EXTEND) / SWITCHING, 0.0), 1.0)
    else:
        travel = 1.0 - min((time - RETRACT) / CLOSING, 1.0)
    position = 2.0 * travel - 1.0
    return max(position, 0.0), max(-position, 0.0)


def derivative(time: float, state: np.ndarray, valve: Valve, is_held: bool) -> np.ndarray:
    """Rates of masses and energies of four volumes, of position and velocity, and of the air from the supply."""
    masses, energies, (position, velocity) = state[:4], state[4:8], state[8:10]
    filled = DEAD + HALF_TUBE + CAP_AREA * position, DEAD + HALF_TUBE + ROD_AREA * (STROKE - position)
    volumes = np.array([HALF_TUBE, filled[0], HALF_TUBE, filled[1]])
    temperatures = energies / (masses * CV)
    pressures = masses * R * temperatures / volumes
    nodes = [*zip(pressures, temperatures, strict=True)]
    rates, powers, used = np.zeros(4), WALLS * (T0 - temperatures), 0.0
    extend, retract = openings(time)
    for tube, chamber, is_supplied, is_exhausted in ((0, 1, extend, retract), (2, 3, retract, extend)):
        inflow = mass_flow((SUPPLY, T0), nodes[tube], is_supplied * valve.conductance, valve.ratio)
        outflow = mass_flow(nodes[tube], (AMBIENT, T0), is_exhausted * valve.exhaust_conductance, valve.exhaust_ratio)
        along = mass_flow(nodes[tube], nodes[chamber], TUBE_C, TUBE_B)
        for index, sign, (flow, power) in (
            (tube, 1, inflow),
            (tube, -1, outflow),
            (tube, -1, along),
            (chamber, 1, along),
        ):
            rates[index] += sign * flow
            powers[index] += sign * power
        used += inflow[0]
    powers[1] -= pressures[1] * CAP_AREA * velocity
    powers[3] += pressures[3] * ROD_AREA * velocity
    force = pressures[1] * CAP_AREA - pressures[3] * ROD_AREA - AMBIENT * (CAP_AREA - ROD_AREA) - LOAD
    friction = COULOMB * math.tanh(velocity / 1e-3) + VISCOUS * velocity
    acceleration = 0.0 if is_held else (force - friction) / MASS
    return np.array([*rates, *powers, 0.0 if is_held else velocity, acceleration, used])


def reaches(level: float, direction: float):
    """Return an event of `solve_ivp`: the position passes a level in a direction."""

    def event(time: float, state: np.ndarray, *arguments: object) -> float:
        return state[8] - level

    event.direction = direction
    return event


def at_rest(position: float, direction: float):
    """Return an event at which a slide at an end stop begins to move away from it."""

    def event(time: float, state: np.ndarray, valve: Valve, is_held: bool) -> float:
        return direction * derivative(time, state, valve, False)[9]

    event.direction, event.terminal = 1.0, True
    return event


def simulate(valve: Valve) -> Cycle:
    """Simulate a double stroke from the retracted rest."""
    volumes = np.array([HALF_TUBE, DEAD + HALF_TUBE, HALF_TUBE, DEAD + HALF_TUBE + ROD_AREA * STROKE])
    pressures = np.array([AMBIENT, AMBIENT, SUPPLY, SUPPLY])
    masses = pressures * volumes / (R * T0)
    state, time = np.array([*masses, *masses * CV * T0, 0.0, 0.0, 0.0]), EXTEND
    arrivals, options = [], {"method": "LSODA", "rtol": 1e-7, "atol": 1e-10, "max_step": 2e-3}
    for direction, target, level, end in ((1.0, STROKE, 0.98, RETRACT), (-1.0, 0.0, 0.02, END)):
        wait = solve_ivp(
            derivative, (time, end), state, args=(valve, True), events=[at_rest(state[8], direction)], **options
        )
        stop = reaches(target, direction)
        stop.terminal = True
        move = solve_ivp(
            derivative, (wait.t[-1], end), wait.y[:, -1], args=(valve, False),
            events=[stop, reaches(level * STROKE, direction)], **options,
        )  # fmt: skip
        state = move.y[:, -1].copy()
        state[8:10] = target, 0.0
        rest = solve_ivp(derivative, (move.t[-1], end), state, args=(valve, True), **options)
        arrivals.append(float(move.t_events[1][0]))
        state, time = rest.y[:, -1], end
    return Cycle(arrivals[0] - EXTEND, arrivals[1] - RETRACT, 1e3 * float(state[10]) / RHO0)
