"""Three ways to control the muscle joint, on loads, frictions and muscles that the controller does not know.

- PID: the angle's controller asks for a pressure.
- cascade: it asks for a force, which a second controller makes of the measured force.
- linearised: it asks for a force, which the inverse law of the muscle turns into a pressure.

Each gets gains by the same search (Nelder-Mead on the logarithms) on the joint as it is in the example. Then load,
inertia, dry friction, hysteresis and the muscle's law are drawn anew for each case, the same for all three.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from scipy.optimize import minimize

from joint_bandwidth import EXAMPLE, changed, remade
from poppet import PID, Circuit, InputError, SimulationError, load
from poppet.control.metrics import step_metrics
from poppet.signals import Steps

TIMES, ANGLES = [0.0, 0.5, 2.0, 3.5], [10.0, 40.0, 20.0, 30.0]
DURATION, LATE = 5.0, 0.3
SHOWN = {"IAE": "deg s", "settling_time": "s", "overshoot": "%", "error": "deg", "swing": "deg"}
VARIED = {
    "arm.load_torque": (3.0, 7.0),
    "arm.inertia": (0.02, 0.045),
    "arm.friction.coulomb_torque": (0.0, 0.3),
    "muscle.hysteresis.force_per_pressure": (0.0, 4e-5),
    "muscle.sarosi.a5": (2.41e-3, 2.94e-3),
}
"""Address to the range from which it is drawn evenly, SI: the load 40 %, the law 10 % about what is reckoned with."""


def _angle(command: str, gains: Sequence[float], **limits: Any) -> Any:
    """The controller of the angle with gain, integral and derivative time."""
    gain, integral_time, derivative_time, *_ = gains
    return PID(
        quantity="angle", command_quantity=command, gain=gain, integral_time=integral_time,
        derivative_time=derivative_time, derivative_filter="4 ms", setpoint_weight=0.3, sample_time="2 ms", **limits,
    )  # fmt: skip


OF_FORCE = {"bias": "200 N", "lower_limit": "0 N", "upper_limit": "900 N"}
OF_PRESSURE = {"bias": "2.4 bar g", "lower_limit": "0 bar g", "upper_limit": "6 bar g"}


def plain(circuit: Circuit, gains: Sequence[float]) -> Circuit:
    """Gains in Pa/rad, s, s."""
    links = {"valve.setpoint": "position.command", "position.measurement": "arm.position"}
    return remade(circuit, "position", "inverse", links=links, position=_angle("pressure", gains, **OF_PRESSURE))


def cascade(circuit: Circuit, gains: Sequence[float]) -> Circuit:
    """Gains in N/rad, s, s, and of the loop of the force in Pa/N, s."""
    inner = PID(
        quantity="force", command_quantity="pressure", gain=gains[3], integral_time=gains[4], sample_time="1 ms",
        **OF_PRESSURE,
    )  # fmt: skip
    links = {
        "position.measurement": "arm.position", "force.setpoint": "position.command",
        "force.measurement": "muscle.force", "valve.setpoint": "force.command",
    }  # fmt: skip
    position = _angle("force", gains, **OF_FORCE)
    return remade(circuit, "position", "inverse", links=links, position=position, force=inner)


def linearised(circuit: Circuit, gains: Sequence[float]) -> Circuit:
    """Gains in N/rad, s, s."""
    return remade(
        circuit, "position", position=_angle("force", gains, **OF_FORCE),
        links={"position.measurement": "arm.position", "inverse.force": "position.command"},
    )  # fmt: skip


WAYS: dict[str, tuple[Callable[[Circuit, Sequence[float]], Circuit], tuple[float, ...]]] = {
    "PID": (plain, (2e5, 0.2, 0.08)),
    "cascade": (cascade, (600.0, 0.3, 0.06, 150.0, 0.05)),
    "linearised": (linearised, (960.0, 0.15, 0.05)),
}
"""How each is made, and the gains from which its search begins."""


def run_of(circuit: Circuit) -> dict[str, float]:
    """Figures of the staircase: what is left in the end and what swings then among them."""
    steps = Steps(TIMES, [math.radians(each) for each in ANGLES])
    run = replace(circuit, signals={"position.setpoint": steps}).simulate(DURATION, "5 ms")
    angle, wanted = np.degrees(run["arm.position"]), np.degrees(run["position.setpoint"])
    k, shut = run.time >= TIMES[1] - 0.01, np.zeros(run.time.size)
    found = step_metrics(run.time[k], wanted[k], angle[k], shut[k], shut[k])
    ends = [*TIMES[2:], DURATION]
    lasting = [np.mean((angle - wanted)[(run.time > end - LATE) & (run.time < end)]) for end in ends]
    swings = [np.ptp(angle[(run.time > end - LATE) & (run.time < end)]) / 2.0 for end in ends]
    own = {"error": float(np.max(np.abs(lasting))), "swing": float(max(swings))}
    return {name: (found | own)[name] for name in SHOWN}


def searched(way: str, circuit: Circuit, calls: int) -> list[float]:
    """Gains of the least cost on the joint as it is in the example: IAE, overshoot, what is left and what swings."""
    made, begin = WAYS[way]

    def cost(logs: np.ndarray) -> float:
        try:
            found = run_of(made(circuit, np.exp(logs).tolist()))
        except (InputError, SimulationError):  # beyond what a number may be, or a run that came to nothing
            return 1e3
        return found["IAE"] + 0.1 * found["overshoot"] + 10.0 * (found["error"] + found["swing"])

    start = np.log(begin)
    corners = np.vstack([start, start + 0.5 * np.eye(start.size)])
    options = {"maxfev": calls, "initial_simplex": corners}
    return np.exp(minimize(cost, start, method="Nelder-Mead", options=options).x).tolist()  # type: ignore[no-any-return]


def with_friction(circuit: Circuit) -> Circuit:
    """Dry friction, which may be next to none, so that all cases have one model."""
    friction = {"kind": "lugre", "coulomb_torque": 1e-6, "viscous_coefficient": 0.05, "stribeck_velocity": 0.3}
    return changed(circuit, "arm", friction={**friction, "bristle_stiffness": 100.0, "bristle_damping": 2.0})


def main(size: float = 1.0) -> None:
    """Print the table; `size` scales the number of ways, of cases and of calls in a search."""
    draw = np.random.default_rng(7)
    cases = [{at: float(draw.uniform(*span)) for at, span in VARIED.items()} for _ in range(max(1, round(30 * size)))]
    circuit = load(EXAMPLE)
    print(f"nominal, median and worst of {len(cases)} cases")
    print(f"{'':12s}" + "".join(f"{f'{name} {unit}':>22s}" for name, unit in SHOWN.items()) + "  gains")
    for name, (way, begin) in list(WAYS.items())[: max(1, round(3 * size))]:
        gains = searched(name, circuit, round(120 * size)) if size >= 0.1 else begin
        made = with_friction(way(circuit, gains))
        found = [run_of(each) for each in (made, *(made.with_values(case) for case in cases))]
        columns = [[each[figure] for each in found] for figure in SHOWN]
        shown = [f"{first:6.3g} {np.median(drawn):6.3g} {max(drawn):6.3g}" for first, *drawn in columns]
        print(f"{name:12s}" + "".join(f"{each:>22s}" for each in shown) + f"  {', '.join(f'{g:.3g}' for g in gains)}")


if __name__ == "__main__":
    main()
