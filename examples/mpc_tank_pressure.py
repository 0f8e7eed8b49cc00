"""Model predictive control of a tank pressure with CasADi, compared with the PID controller of the circuit.

The circuit of pressure_control.toml provides the prediction model and the plant of both controllers. The predictive
controller uses the exact pressure and mass of the gas at every sample.

Run: python examples/mpc_tank_pressure.py

The circuit of pressure_control.toml gives both: the functions with which the optimisation looks ahead, and the plant on
which the two controllers run. The predictive one knows pressure and mass of the gas at every sample, no sensor between.

Run: python examples/mpc_tank_pressure.py
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

import poppet
from poppet.signals import Steps

SAMPLE, HORIZON = 0.02, 12
VALVES = ("fill.opening", "vent.opening")


def look_ahead(model: Any, sample: float, horizon: int) -> Callable[[Any, float], Any]:
    """Return a function from state and setpoint [Pa] to the optimal openings of the first sample."""
    x, u = ca.SX.sym("x", len(model.states)), ca.SX.sym("u", len(VALVES))
    # One Runge-Kutta step per sample is accurate for pressure rates of some bar per second.
    k1 = model.f(x, u, [])
    k2 = model.f(x + 0.5 * sample * k1, u, [])
    k3 = model.f(x + 0.5 * sample * k2, u, [])
    k4 = model.f(x + sample * k3, u, [])
    step = ca.Function("step", [x, u], [x + sample / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)])
    # Multiple shooting with scaled states.
    opti, sizes = ca.Opti(), ca.DM(model.sizes)
    states, openings = opti.variable(len(model.states), horizon + 1), opti.variable(len(VALVES), horizon)
    now, setpoint = opti.parameter(len(model.states)), opti.parameter()
    opti.subject_to(states[:, 0] == now / sizes)
    cost: Any = 0.0
    for k in range(horizon):
        opti.subject_to(states[:, k + 1] == step(states[:, k] * sizes, openings[:, k]) / sizes)
        # Cost in bar squared; a small cost of the openings avoids simultaneous filling and venting.
        cost += (states[0, k + 1] - setpoint / sizes[0]) ** 2 + 1e-4 * ca.sum1(openings[:, k])
    opti.subject_to(opti.bounded(0.0, openings, 1.0))
    opti.minimize(cost)
    opti.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes", "max_iter": 200})
    opti.set_initial(states, ca.repmat(ca.DM(model.x0) / sizes, 1, horizon + 1))

    def best(state: Any, wanted: float) -> Any:
        opti.set_value(now, state)
        opti.set_value(setpoint, wanted)
        found = opti.solve()
        opti.set_initial(found.value_variables())
        return np.clip(np.atleast_2d(found.value(openings))[:, 0], 0.0, 1.0)

    return best


def predictive(circuit: poppet.Circuit, duration: float, sample: float, horizon: int) -> Any:
    """Return times [s] and pressures [Pa] of a run with model predictive control, shape (n_samples, 2)."""
    best = look_ahead(circuit.to_casadi(inputs=VALVES, without="regulator"), sample, horizon)
    parts = {name: part for name, part in circuit.parts.items() if name != "regulator"}
    setpoint = circuit.signals["regulator.setpoint"].table(duration)
    plant = poppet.Circuit(parts, signals={name: Steps([0.0], [0.0]) for name in VALVES})
    last, rows = plant.simulate(1e-6), []
    for k in range(round(duration / sample)):
        state = [last["tank.pressure"][-1], last["tank.mass"][-1]]
        rows.append([k * sample, state[0]])
        openings = best(state, float(setpoint.evaluate(k * sample)))
        held = {name: Steps([0.0], [float(opening)]) for name, opening in zip(VALVES, openings, strict=True)}
        last = poppet.Circuit(parts, signals=held).simulate(sample, start=last)
    return np.array(rows)


def outside(rows: Any, wanted: Any, band: float = 2e3) -> float:
    """Return the total time [s] with the pressure outside the band [Pa] about its setpoint."""
    return float(np.count_nonzero(np.abs(rows[:, 1] - wanted) > band) * (rows[1, 0] - rows[0, 0]))


def main(duration: float = 6.5, sample: float = SAMPLE, horizon: int = HORIZON) -> dict[str, tuple[float, float]]:
    """Run both controllers; return the rms error [bar] and the time outside of 20 mbar [s] for each."""
    circuit = poppet.load(Path(__file__).parent / "pressure_control.toml")
    setpoint = circuit.signals["regulator.setpoint"].table(duration)
    pid = circuit.simulate(duration, sample)
    runs = {"PID": np.array([pid.time, pid["tank.pressure"]]).T, "MPC": predictive(circuit, duration, sample, horizon)}
    errors = {}
    for name, rows in runs.items():
        wanted = np.array([float(setpoint.evaluate(t)) for t in rows[:, 0]])
        rms = float(np.sqrt(np.mean((rows[:, 1] - wanted) ** 2))) / 1e5
        errors[name] = rms, outside(rows, wanted)
        print(f"{name}: rms error {rms:.4f} bar, {errors[name][1]:.2f} s further than 20 mbar from the setpoint")
    return errors


if __name__ == "__main__":
    main()
